//! Proof by comparison: generated text compiled, run, and compared with the interpreter.

use super::build::{BuildError, Workshop};
use super::compare::{Comparison, compare, compare_looks};
use super::process::Process;
use crate::emit::Code;
use crate::shape::Shape;
use serde::Serialize;
use std::{io, ptr};
use tpg_graph::engine::Engine;
use tpg_graph::image::Vision;

/// The most images that are compared.
const IMAGES: usize = 1000;

/// The outcome for several pieces of generated code.
#[derive(Debug, Serialize)]
pub struct Proof {
    /// The comparisons of code that was compiled and run.
    pub comparisons: Vec<Comparison>,
    /// Code that could not be compiled.
    pub unproven: Vec<Unproven>,
}

/// Code that could not be compiled.
#[derive(Debug, Serialize)]
pub struct Unproven {
    /// Its [name](crate::Program::name).
    pub engine: String,
    /// The reason.
    pub error: String,
}

impl Proof {
    /// Compiles code, the very text that it is given, and compares it with the interpreter on `count` states drawn with
    /// `seed`.
    ///
    /// # Errors
    /// When no temporary folder can be made or a compiled program dies.
    pub fn of(codes: &[Code<'_>], count: usize, seed: u64) -> io::Result<Self> {
        Self::of_watched(codes, count, seed, &|_, _| ())
    }

    /// [`of`](Self::of), which tells how many pieces of code are compiled, and what it does next.
    ///
    /// # Errors
    /// As [`of`](Self::of).
    pub fn of_watched(codes: &[Code<'_>], count: usize, seed: u64, watch: &dyn Fn(usize, String)) -> io::Result<Self> {
        let workshop = Workshop::new()?;
        let mut proof = Self { comparisons: Vec::new(), unproven: Vec::new() };
        let mut done = 0;
        for codes in codes.chunk_by(|a, b| ptr::eq(a.program.graph(), b.program.graph())) {
            let mut programs: Vec<Process> = (codes.iter())
                .filter_map(|code| {
                    watch(done, format!("compiling {}", code.program.name()));
                    done += 1;
                    proof.keep(code, workshop.start(code))
                })
                .collect();
            watch(done, format!("comparing on {count} states"));
            let mut engines: Vec<&mut dyn Engine> =
                programs.iter_mut().map(|program| program as &mut dyn Engine).collect();
            let graph = codes[0].program.graph();
            proof.comparisons.extend(compare(graph, &mut engines, count, seed)?);
            let observed = graph.to_document().sources;
            if let Some(vision) = Vision::new(&observed) {
                for code in codes.iter().filter(|code| code.program.shape != Shape::Gegelati) {
                    if let Some(mut process) = proof.keep(code, workshop.start_looking(code, &vision)) {
                        proof.comparisons.push(compare_looks(&vision, &mut process, count.min(IMAGES), seed)?);
                    }
                }
            }
        }
        Ok(proof)
    }

    fn keep(&mut self, code: &Code<'_>, started: Result<Process, BuildError>) -> Option<Process> {
        match started {
            Ok(process) => Some(process),
            Err(error) => {
                self.unproven.push(Unproven { engine: code.program.name(), error: error.to_string() });
                None
            }
        }
    }

    /// Tests that all code was compared and never differed.
    pub fn holds(&self) -> bool {
        self.unproven.is_empty() && self.comparisons.iter().all(|comparison| comparison.differences == 0)
    }
}
