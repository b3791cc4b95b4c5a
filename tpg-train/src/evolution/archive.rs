//! The archive: recorded bids of earlier programs, used to check that a new program behaves differently (`archive.h`,
//! `archive.cpp`).
//!
//! GEGELATI records every program execution of the training with a small probability and keeps the newest; with
//! millions of executions per generation its archive then holds a few executions of the last roots. Here each
//! generation draws the same number of recordings from all of its roots, episodes and steps: the same use, independent
//! of the order of evaluation.

use super::genome::{Program, ProgramId};
use super::vocabulary::Vocabulary;
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;
use tpg_engine::{Line, Operand};
use tpg_graph::ScalarType;
use tpg_runtime::ops::{Instruction, Maths, Own};
use tpg_runtime::scalar::Scalar;

/// Bids closer than this are considered equal (`archive.h`, `areProgramResultsUnique`).
const TAU: f64 = 1e-4;

/// A recorded execution.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Recording {
    /// The bidder: deme and program.
    pub program: (u64, ProgramId),
    /// The whole flat state that it read.
    pub state: Vec<f64>,
    /// Its bid, as bits: a bid can be infinite or NaN, which JSON cannot represent.
    pub bid: u64,
}

/// The newest recordings.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Archive {
    size: usize,
    recordings: VecDeque<Recording>,
}

impl Archive {
    /// Creates an empty archive of at most `size` recordings (`archiveSize`); with size 0 every program counts as new.
    pub fn new(size: usize) -> Self {
        Self { size, recordings: VecDeque::new() }
    }

    /// Returns the capacity of the archive.
    pub fn size(&self) -> usize {
        self.size
    }

    /// True if the archive, read from a file, is one of so many demes and inputs.
    pub(super) fn is_valid(&self, demes: usize, inputs: usize) -> bool {
        let is_valid = |it: &Recording| it.program.0 < demes as u64 && it.state.len() == inputs;
        self.recordings.len() <= self.size && self.recordings.iter().all(is_valid)
    }

    /// Adds a recording and drops the oldest one if the archive is full.
    pub fn record(&mut self, recording: Recording) {
        self.recordings.push_back(recording);
        while self.recordings.len() > self.size {
            self.recordings.pop_front();
        }
    }

    /// Returns the recordings by program, to compare new programs with.
    pub fn known(&self) -> Known<'_> {
        let mut recordings: Vec<&Recording> = self.recordings.iter().collect();
        recordings.sort_by_key(|recording| recording.program);
        Known { recordings }
    }
}

/// The recordings of an archive, those of a program next to each other.
#[derive(Clone, Debug)]
pub struct Known<'a> {
    recordings: Vec<&'a Recording>,
}

impl Known<'_> {
    /// True if no archived program bid the same on all of its states (`areProgramResultsUnique`).
    pub fn is_new(&self, program: &Program, vocabulary: &Vocabulary) -> bool {
        if self.recordings.is_empty() {
            return true;
        }
        let lines = program.lines(vocabulary);
        let mut registers = Vec::new();
        let mut is_same = |recording: &&Recording| {
            let bid = bid_in(&mut registers, &lines, vocabulary, &recording.state);
            // Written so that NaN never equals anything, as in GEGELATI.
            (bid - f64::from_bits(recording.bid)).abs() <= TAU
        };
        !self.recordings.chunk_by(|a, b| a.program == b.program).any(|of_one| of_one.iter().all(&mut is_same))
    }
}

/// Returns a program's bid in a state, in its scalar type with the project's own maths; NaN is returned unchanged.
pub(super) fn bid(lines: &[Line], vocabulary: &Vocabulary, state: &[f64]) -> f64 {
    bid_in(&mut Vec::new(), lines, vocabulary, state)
}

/// Returns a program's bid: see [`bid`]. `registers` is space that several calls may share.
fn bid_in(registers: &mut Vec<f64>, lines: &[Line], vocabulary: &Vocabulary, state: &[f64]) -> f64 {
    registers.clear();
    registers.resize(usize::from(vocabulary.registers()), 0.0);
    match vocabulary.scalar() {
        ScalarType::F32 => run::<f32>(lines, registers, state),
        ScalarType::F64 => run::<f64>(lines, registers, state),
    }
}

/// Registers hold values of `S`, which an `f64` represents exactly.
fn run<S: Scalar>(lines: &[Line], register: &mut [f64], state: &[f64]) -> f64
where
    Own: Maths<S>,
{
    for line in lines {
        let read = |operand| match operand {
            Operand::Register(index) => S::from_f64(register[usize::from(index)]),
            Operand::Input(index) => S::from_f64(state[usize::from(index)]),
            Operand::Constant(value) => S::from_f64(value),
        };
        let [a, b] = line.operands;
        let to = usize::from(line.to);
        let apply = |instruction: Instruction, [a, b]: [S; 2]| instruction.apply::<S, Own>(a, b);
        register[to] = line.instruction.compose(S::from_f64(register[to]), [read(a), read(b)], apply).to_f64();
    }
    register[0]
}
