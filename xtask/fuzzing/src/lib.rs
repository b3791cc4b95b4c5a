//! Targets of fuzzers: every loader and the compiler, each as a function of bytes.
//!
//! `fuzz/` hands each [target](TARGETS) to libFuzzer; a test of this crate runs the same functions on a stable compiler,
//! from the seeds in `fuzz/corpus` and fixed random numbers. A target panics where something is wrong: a panic of the
//! code under test, an accepted input that is not what it says, a difference from the definition.
//!
//! | module | subject |
//! | --- | --- |
//! | [`graphs`] | `graph.json`, `.dot` with its sidecar, traces, recordings; graphs compiled and compared |
//! | [`networks`] | `policy.q.json`, packed words, safetensors |
//! | [`settings`] | tasks, configurations, hybrids, arms |
//! | [`checkpoints`] | checkpoints of both trainers |

pub mod checkpoints;
pub mod graphs;
pub mod networks;
pub mod settings;

/// A function that a fuzzer calls.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// Name of the target, of its program in `fuzz/fuzz_targets` and of its folder in `fuzz/corpus`.
    pub name: &'static str,
    /// The function.
    pub run: fn(&[u8]),
}

/// Every target.
pub const TARGETS: [Target; 15] = [
    Target { name: "graph_json", run: graphs::json },
    Target { name: "dot", run: graphs::dot },
    Target { name: "trace", run: graphs::trace },
    Target { name: "recording", run: graphs::recording },
    Target { name: "compiled", run: graphs::compiled },
    Target { name: "policy", run: networks::policy },
    Target { name: "packed_words", run: networks::words },
    Target { name: "safetensors", run: networks::safetensors },
    Target { name: "targets", run: settings::targets },
    Target { name: "scenes", run: settings::scenes },
    Target { name: "urdf", run: settings::urdf },
    Target { name: "hybrid", run: settings::hybrid },
    Target { name: "tpg_config", run: settings::tpg_config },
    Target { name: "sac_config", run: settings::sac_config },
    Target { name: "checkpoint_file", run: checkpoints::file },
];

/// Returns what is accepted; a refusal must have a text.
pub(crate) fn accepted<T>(result: Result<T, impl std::fmt::Display>) -> Option<T> {
    result.map_err(|error| error.to_string()).ok()
}

/// Takes numbers from what a fuzzer wrote, and 0 behind its end.
#[derive(Clone, Debug)]
pub(crate) struct Bytes<'a>(pub(crate) &'a [u8]);

impl Bytes<'_> {
    pub(crate) fn array<const N: usize>(&mut self) -> [u8; N] {
        [0; N].map(|_: u8| {
            let Some((&first, rest)) = self.0.split_first() else { return 0 };
            self.0 = rest;
            first
        })
    }

    pub(crate) fn u64(&mut self) -> u64 {
        u64::from_le_bytes(self.array())
    }

    pub(crate) fn below(&mut self, bound: usize) -> usize {
        usize::from(u16::from_le_bytes(self.array())) % bound
    }
}
