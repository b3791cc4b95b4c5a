//! Counts of many calls.

use crate::record::Hash;
use crate::report::Report;

/// Instructions of many actions, and a hash of what came of them.
#[derive(Clone, Copy)]
pub struct Tally {
    /// Number of actions.
    pub actions: u32,
    instructions: u32,
    worst: u32,
    /// Their results.
    pub hash: Hash,
}

impl Tally {
    /// Of nothing.
    pub const fn new() -> Self {
        Self { actions: 0, instructions: 0, worst: 0, hash: Hash::new() }
    }

    /// Counts an action.
    pub fn add(&mut self, instructions: u32) {
        self.actions += 1;
        self.instructions = self.instructions.wrapping_add(instructions);
        self.worst = self.worst.max(instructions);
    }

    /// Adds the instructions to a line.
    pub fn costs(&self, line: Report) -> Report {
        line.unsigned("instructions", self.instructions).unsigned("worst", self.worst)
    }

    /// A line of the counts that begins with `words`.
    pub fn line(&self, words: &str) -> Report {
        self.costs(Report::new(words).unsigned("actions", self.actions))
    }

    /// Prints the counts.
    pub fn print(&self, words: &str) {
        self.line(words).print();
    }

    /// Prints the counts and the hash.
    pub fn print_with_hash(&self, words: &str) {
        self.line(words).hexadecimal("hash", self.hash.0).print();
    }
}
