//! A compiled policy in its own process, driven over a pipe.
//!
//! A batch goes in as a little-endian `u32` count and the states' values in the graph's scalar type, native byte order;
//! out come as many native `u16` actions.

use std::io::{self, BufReader, BufWriter, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use tpg_graph::engine::Engine;
use tpg_graph::{Graph, ScalarType};
use tpg_runtime::policy::ActionId;

/// States in one exchange: both sides hold a whole batch, so that neither waits for the other's full pipe.
const BATCH: usize = 1024;

/// The exit status of a C program whose self-test fails.
const SELF_TEST_DIFFERS: i32 = 3;

/// A running policy.
#[derive(Debug)]
pub struct Process {
    name: String,
    scalar: ScalarType,
    state_length: usize,
    child: Child,
    input: Option<BufWriter<ChildStdin>>,
    output: BufReader<ChildStdout>,
}

/// Starts `program` with arguments.
pub(super) fn start(program: &Path, arguments: &[String], name: &str, graph: &Graph) -> io::Result<Process> {
    let mut child = Command::new(program).args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
    let missing = || io::Error::other("the process has no pipe");
    let input = child.stdin.take().ok_or_else(missing)?;
    let output = child.stdout.take().ok_or_else(missing)?;
    Ok(Process {
        name: name.to_owned(),
        scalar: graph.scalar(),
        state_length: graph.state_length(),
        child,
        input: Some(BufWriter::new(input)),
        output: BufReader::new(output),
    })
}

impl Process {
    /// Starts `program`.
    ///
    /// # Errors
    /// When it cannot be started.
    pub fn start(program: &Path, name: &str, graph: &Graph) -> io::Result<Self> {
        start(program, &[], name, graph)
    }

    /// The reason that the program ended before its input did.
    fn ended(&mut self, error: &io::Error) -> io::Error {
        self.input = None;
        io::Error::other(match self.child.wait() {
            Ok(status) if status.code() == Some(SELF_TEST_DIFFERS) => {
                format!("{}: the self-test in the code differs from the interpreter", self.name)
            }
            Ok(status) => format!("{}: the program ended early, {status}: {error}", self.name),
            Err(_) => format!("{}: {error}", self.name),
        })
    }

    fn exchange(&mut self, states: &[f64], actions: &mut Vec<ActionId>) -> io::Result<()> {
        let count = states.len() / self.state_length;
        let input = self.input.as_mut().ok_or_else(|| io::Error::other("the process was closed"))?;
        input.write_all(&(count as u32).to_le_bytes())?;
        for &value in states {
            match self.scalar {
                ScalarType::F32 => input.write_all(&(value as f32).to_ne_bytes())?,
                ScalarType::F64 => input.write_all(&value.to_ne_bytes())?,
            }
        }
        input.flush()?;
        for _ in 0..count {
            let mut action = [0; 2];
            self.output.read_exact(&mut action)?;
            actions.push(ActionId(u16::from_ne_bytes(action)));
        }
        Ok(())
    }
}

impl Engine for Process {
    fn name(&self) -> &str {
        &self.name
    }

    fn decide(&mut self, states: &[f64], actions: &mut Vec<ActionId>) -> io::Result<()> {
        let mut batches = states.chunks(BATCH * self.state_length);
        batches.try_for_each(|batch| self.exchange(batch, actions)).map_err(|error| self.ended(&error))
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        // The end of its input ends the process.
        self.input = None;
        let _ = self.child.wait();
    }
}
