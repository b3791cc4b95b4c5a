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
        states.chunks(BATCH * self.state_length).try_for_each(|batch| self.exchange(batch, actions))
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        // The end of its input ends the process.
        self.input = None;
        let _ = self.child.wait();
    }
}
