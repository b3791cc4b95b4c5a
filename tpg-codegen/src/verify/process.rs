//! A compiled policy in its own process, driven over a pipe.
//!
//! A batch goes in as a little-endian `u32` count and the states' values as `f64`, native byte order; out come as many native `u16`
//! actions, or for a policy with outputs the values of each as `f64`.

use std::io::{self, BufReader, BufWriter, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use tpg_graph::Graph;
use tpg_graph::engine::Engine;
use tpg_graph::image::Vision;
use tpg_graph::interpret::Answer;
use tpg_runtime::policy::ActionId;

/// States in one exchange: both sides hold a whole batch, so that neither waits for the other's full pipe.
const BATCH: usize = 1024;

/// The exit status of a C program whose self-test fails.
const SELF_TEST_DIFFERS: i32 = 3;

/// A running policy.
#[derive(Debug)]
pub struct Process {
    name: String,
    state_length: usize,
    /// Values of an answer; 0 for a policy that answers with an action.
    outputs: usize,
    /// States in one exchange.
    batch: usize,
    child: Child,
    input: Option<BufWriter<ChildStdin>>,
    output: BufReader<ChildStdout>,
}

impl Process {
    /// Starts `program` as one of its policies.
    pub(super) fn start(program: &Path, policy: usize, name: String, graph: &Graph) -> io::Result<Self> {
        let mut command = Command::new(program);
        let mut child = command.arg(policy.to_string()).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
        let missing = || io::Error::other("the process has no pipe");
        let input = child.stdin.take().ok_or_else(missing)?;
        let output = child.stdout.take().ok_or_else(missing)?;
        Ok(Self {
            name,
            state_length: graph.state_length(),
            outputs: graph.outputs().len(),
            batch: BATCH,
            child,
            input: Some(BufWriter::new(input)),
            output: BufReader::new(output),
        })
    }

    /// Sends images, one at a time, and takes the values of states.
    pub(super) fn looking(mut self, vision: &Vision, values: usize) -> Self {
        self.name += ", states of images";
        (self.state_length, self.outputs, self.batch) = (vision.bytes(), values, 1);
        self
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

    fn exchange(&mut self, states: &[f64], answers: &mut Vec<Answer>) -> io::Result<()> {
        let count = states.len() / self.state_length;
        let input = self.input.as_mut().ok_or_else(|| io::Error::other("the process was closed"))?;
        input.write_all(&(count as u32).to_le_bytes())?;
        for &value in states {
            input.write_all(&value.to_ne_bytes())?;
        }
        input.flush()?;
        for _ in 0..count {
            let answer = if self.outputs == 0 {
                Answer::Action(ActionId(u16::from_ne_bytes(self.read()?)))
            } else {
                Answer::Values(
                    (0..self.outputs).map(|_| self.read().map(f64::from_ne_bytes)).collect::<io::Result<_>>()?,
                )
            };
            answers.push(answer);
        }
        Ok(())
    }

    fn read<const N: usize>(&mut self) -> io::Result<[u8; N]> {
        let mut bytes = [0; N];
        self.output.read_exact(&mut bytes)?;
        Ok(bytes)
    }
}

impl Engine for Process {
    fn name(&self) -> &str {
        &self.name
    }

    fn answer(&mut self, states: &[f64], answers: &mut Vec<Answer>) -> io::Result<()> {
        let mut batches = states.chunks(self.batch * self.state_length);
        batches.try_for_each(|batch| self.exchange(batch, answers)).map_err(|error| self.ended(&error))
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        // The end of its input ends the process.
        self.input = None;
        let _ = self.child.wait();
    }
}
