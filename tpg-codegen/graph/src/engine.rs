//! Anything that decides like a graph: the interpreter, or a program built from generated code.

use crate::interpret::{self, Answer};
use crate::model::Graph;
use std::io;

/// Answers batches of states.
pub trait Engine {
    /// Returns the name used in reports.
    fn name(&self) -> &str;

    /// Appends one answer for each of the flat `states`, whose values are exact in the graph's scalar type.
    ///
    /// # Errors
    /// If the engine is a process and has died.
    fn answer(&mut self, states: &[f64], answers: &mut Vec<Answer>) -> io::Result<()>;
}

/// The [interpreter](crate::interpret) as an engine.
#[derive(Clone, Copy, Debug)]
pub struct Reference<'g> {
    graph: &'g Graph,
}

impl<'g> Reference<'g> {
    /// Creates an engine that interprets `graph` in its own scalar type and maths.
    pub fn new(graph: &'g Graph) -> Self {
        Self { graph }
    }
}

impl Engine for Reference<'_> {
    fn name(&self) -> &str {
        "interpreter"
    }

    fn answer(&mut self, states: &[f64], answers: &mut Vec<Answer>) -> io::Result<()> {
        answers.extend(interpret::answers(self.graph, states));
        Ok(())
    }
}
