//! States for comparing implementations, the same for the same graph and seed.
//!
//! Most lie in the declared ranges and some on their ends; some hold values that no sensor should deliver: NaN,
//! infinities, denormals, arbitrary bits. Implementations must agree on every one. Counts are whole numbers that their integers hold.

use crate::error::InputError;
use crate::model::{Counts, Graph, Input, Range, ScalarType};
use crate::trace;
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use sha2::{Digest, Sha256};
use std::path::Path;

/// Samples flat states, concatenated, each of [`Graph::state_length`] values that are exact in the graph's scalar type.
pub fn sample(graph: &Graph, count: usize, seed: u64) -> Vec<f64> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let values = values_of(graph);
    let mut states = Vec::with_capacity(count * values.len());
    for _ in 0..count {
        let kind = SetKind::draw(&mut random);
        states.extend(values.iter().map(|value| value.draw(kind, &mut random)));
    }
    states
}

/// Replaces one state in 16 by one of special values, almost all of them: a graph may need so many before no bid of a team
/// is a number. The draws are the same for the same graph and seed.
pub fn replace_by_special(graph: &Graph, states: &mut [f64], seed: u64) {
    const EVERY: usize = 16;
    let mut random = ChaCha8Rng::seed_from_u64(!seed);
    let values = values_of(graph);
    for state in states.chunks_exact_mut(values.len()).skip(EVERY - 1).step_by(EVERY) {
        for (place, value) in state.iter_mut().zip(&values) {
            *place = value.draw(SetKind::AllSpecial, &mut random);
        }
    }
}

/// The values that an input can have.
#[derive(Clone, Copy, Debug, PartialEq)]
struct ValueRange {
    range: Range,
    scalar: ScalarType,
    /// Of counts, and of memory beside them: whole numbers in these limits.
    whole: Option<Range>,
}

impl ValueRange {
    fn new(graph: &Graph, input: Input, range: Range) -> Self {
        let counts = graph.counts_of(input).map(|_| {
            let [min, max] = graph.count_range(input, Counts::container_of(&graph.source_of(input).0.counts));
            Range { min, max }
        });
        Self { range, scalar: graph.scalar(), whole: counts.or_else(|| graph.has_counts().then_some(range)) }
    }

    fn draw(self, kind: SetKind, random: &mut impl Rng) -> f64 {
        let value = self.scalar.round(kind.value(self.range, random));
        match self.whole {
            None => value,
            Some(_) if value.is_nan() => self.range.min,
            Some(Range { min, max }) => value.round().clamp(min, max) + 0.0,
        }
    }
}

fn values_of(graph: &Graph) -> Vec<ValueRange> {
    graph.inputs().zip(graph.state_ranges()).map(|(input, range)| ValueRange::new(graph, input, range)).collect()
}

/// Samples flat states inside the declared ranges, as used by the embedded self-test.
pub fn sample_in_range(graph: &Graph, count: usize, seed: u64) -> Vec<f64> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let values = values_of(graph);
    let states = (0..count).flat_map(|_| &values);
    states.map(|value| value.draw(SetKind::InRange, &mut random)).collect()
}

/// Number of states of that length to hold at a time, at most `most`: 64 MiB of values, and at least one state.
pub fn batch(state_length: usize, most: usize) -> usize {
    ((8 << 20) / state_length.max(1)).clamp(1, most.max(1))
}

/// Distribution of the values of one state.
#[derive(Clone, Copy)]
enum SetKind {
    /// Uniform in the declared ranges.
    InRange,
    /// Whole numbers in the declared ranges, which make equal bids most likely.
    Whole,
    /// In range or on its ends, or zero.
    Boundary,
    /// In range; one in eight is special.
    Special,
    /// Special, half of them NaN; one in eight is in range.
    AllSpecial,
    /// Arbitrary bits.
    Anything,
}

const SPECIAL: [f64; 12] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -0.0,
    f64::MIN_POSITIVE / 4.0,
    -f64::MIN_POSITIVE / 4.0,
    1e-40, // a denormal of f32
    f64::MAX,
    f64::MIN,
    1.0,
    1e30,
];

impl SetKind {
    fn draw(random: &mut impl Rng) -> Self {
        match random.random_range(0..10) {
            0..4 => Self::InRange,
            4..6 => Self::Whole,
            6..8 => Self::Boundary,
            8 => Self::Special,
            _ => Self::Anything,
        }
    }

    fn value(self, Range { min, max }: Range, random: &mut impl Rng) -> f64 {
        // 53 bits give every multiple of 2⁻⁵³ in [0, 1).
        let unit = (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
        let inside = (min + unit * (max - min)).clamp(min, max);
        match self {
            Self::InRange => inside,
            Self::Whole => inside.round().clamp(min, max),
            Self::Boundary => match random.random_range(0..6) {
                0 => min,
                1 => max,
                2 => 0.0,
                _ => inside,
            },
            Self::Special if random.random_range(0..8) == 0 => SPECIAL[random.random_range(0..SPECIAL.len())],
            Self::AllSpecial if random.random_range(0..8) != 0 => match random.random_bool(0.5) {
                true => f64::NAN,
                false => SPECIAL[random.random_range(0..SPECIAL.len())],
            },
            Self::Special | Self::AllSpecial => inside,
            // Half of all doubles exceed the range of f32, so draw the bits of both types.
            Self::Anything if random.random_bool(0.5) => f64::from(f32::from_bits(random.next_u32())),
            Self::Anything => f64::from_bits(random.next_u64()),
        }
    }
}

/// States for a measurement, and their origin.
///
/// ```
/// use tpg_graph::sample::{self, Shape};
/// use tpg_graph::states::{self, StateSet};
///
/// let graph = sample::graph(&Shape::default(), 7);
/// let set = StateSet::sampled(&graph, 100, 1);
/// assert_eq!(set.states, states::sample_in_range(&graph, 100, 1));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct StateSet {
    /// Flat states, concatenated.
    pub states: Vec<f64>,
    /// They occurred, so that their values say more than the declared ranges.
    pub is_visited: bool,
    /// Origin of the states, for human readers, without a path or a time.
    pub origin: String,
}

impl StateSet {
    /// Samples states inside the declared ranges; fewer if they are long.
    pub fn sampled(graph: &Graph, count: usize, seed: u64) -> Self {
        let count = batch(graph.state_length(), count);
        let origin = format!("{count} states sampled uniformly in the declared ranges, seed {seed}");
        Self { states: sample_in_range(graph, count, seed), is_visited: false, origin }
    }

    /// Takes states that were visited, in the order of the graph's sources.
    pub fn given(graph: &Graph, states: Vec<f64>) -> Self {
        let origin = format!("{} given states", states.len() / graph.state_length());
        Self { states, is_visited: true, origin }
    }

    /// Reads recorded states: see [`trace`].
    ///
    /// # Errors
    /// Any error in the file.
    pub fn recorded(graph: &Graph, path: &Path) -> Result<Self, InputError> {
        let (states, text) = trace::load(path, graph)?;
        let count = states.len() / graph.state_length();
        let hash = Sha256::digest(text).iter().take(8).fold(String::new(), |hex, byte| format!("{hex}{byte:02x}"));
        Ok(Self { states, is_visited: true, origin: format!("{count} recorded states, SHA-256 {hash}...") })
    }
}

#[cfg(test)]
mod tests {
    use super::{StateSet, sample_in_range};
    use crate::sample::{self, Shape};

    #[test]
    fn of_long_states_there_are_fewer() {
        let graph = sample::graph(&Shape { sources: vec![60_000], ..Shape::default() }, 1);
        let StateSet { states, origin, .. } = StateSet::sampled(&graph, 300, 1);
        assert!(origin.starts_with("139 states sampled"), "{origin}");
        assert!(states == sample_in_range(&graph, 139, 1));
    }
}
