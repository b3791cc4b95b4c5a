//! Random numbers: an independent stream for every purpose, so that no result depends on where or when it is computed.
//!
//! A stream's ChaCha8 key *is* its address: seed, generation, purpose and index, eight bytes each. The distributions
//! are implemented here instead of taken from a crate, because checkpoints must keep their meaning after an update.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// Purpose of a stream of random numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Purpose {
    /// The first population.
    Initial = 1,
    /// The shape of one child: its parent, edges and destinations.
    Child = 2,
    /// One program of a child.
    Program = 3,
    /// One training episode of a generation.
    Episode = 4,
    /// The choice of episodes of a generation from the pool of hard ones.
    Pool = 5,
    /// The lexicase selection of a generation.
    Lexicase = 6,
    /// One selection episode: used to choose the final root, never to train.
    Selection = 9,
    /// Property tests and benchmarks.
    Test = 11,
    /// One episode of `eval --episodes`.
    Evaluation = 12,
    /// Sampling of the arm's reachable space.
    Reach = 20,
    /// One task of a set of tasks.
    Task = 21,
    /// Initial weights of a network.
    Weights = 22,
    /// The start of one training episode in a lane.
    Reset = 23,
    /// The noise of a lane's actions.
    Exploration = 24,
    /// The choice of transitions that one update replays.
    Replay = 25,
    /// The noise of the actions inside one update.
    Update = 26,
    /// The constants and the noise of an episode of a problem that varies.
    Variation = 14,
    /// Samples and choices of a linear start.
    Linear = 15,
    /// The tasks on which failures of an actor under training are looked for.
    Retry = 28,
    /// The play of an arm's joints in one episode.
    Play = 30,
}

/// A stream of random numbers.
#[derive(Clone, Debug)]
pub struct Stream(ChaCha8Rng);

impl Stream {
    /// Creates the stream of the given address.
    pub fn new(seed: u64, generation: u64, purpose: Purpose, index: u64) -> Self {
        let mut key = [0; 32];
        let words = [seed, generation, purpose as u64, index];
        for (bytes, word) in key.chunks_exact_mut(8).zip(words) {
            bytes.copy_from_slice(&word.to_le_bytes());
        }
        Self(ChaCha8Rng::from_seed(key))
    }

    /// Returns 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0.next_u64()
    }

    /// Returns a whole number below `bound`, uniformly distributed (Lemire's method with rejection).
    ///
    /// # Panics
    /// If `bound` is 0.
    pub fn below(&mut self, bound: usize) -> usize {
        assert!(bound > 0, "there is no number below 0");
        let bound = bound as u64;
        loop {
            let wide = u128::from(self.bits()) * u128::from(bound);
            let low = wide as u64;
            // Numbers below 2⁶⁴ mod `bound` are rejected; as that is below `bound`, the division is rarely needed.
            if low >= bound || low >= bound.wrapping_neg() % bound {
                return (wide >> 64) as usize;
            }
        }
    }

    /// Returns a whole number from `low` to `high`, both included.
    ///
    /// # Panics
    /// If `low` is above `high`.
    pub fn between(&mut self, low: i64, high: i64) -> i64 {
        assert!(low <= high, "an empty range");
        low + self.below((high - low) as usize + 1) as i64
    }

    /// Returns a number in [0, 1), a multiple of 2⁻⁵³.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Returns true with the given probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }

    /// Returns a standard normal number (Box–Muller method, one of the pair).
    pub fn normal(&mut self) -> f64 {
        let radius = (-2.0 * libm::log(1.0 - self.unit())).sqrt();
        radius * libm::cos(core::f64::consts::TAU * self.unit())
    }

    /// Fills `numbers` with standard normal numbers in single precision (Box–Muller method, both of each pair).
    pub fn normals(&mut self, numbers: &mut [f32]) {
        for pair in numbers.chunks_mut(2) {
            let bits = self.bits();
            // 24 bits each: the radius from a number in (0, 1], the angle from one in [0, 1).
            let [low, high] = [bits as u32, (bits >> 32) as u32].map(|bits| (bits >> 8) as f32);
            let radius = libm::sqrtf(-2.0 * libm::logf((low + 1.0) * (1.0 / 16_777_216.0)));
            let (sine, cosine) = libm::sincosf(high * (core::f32::consts::TAU / 16_777_216.0));
            pair.iter_mut().zip([cosine, sine]).for_each(|(number, direction)| *number = radius * direction);
        }
    }

    /// Picks one of `items`.
    ///
    /// # Panics
    /// If `items` is empty.
    pub fn pick<'a, T>(&mut self, items: &'a [T]) -> &'a T {
        &items[self.below(items.len())]
    }

    /// Shuffles `items` (Fisher–Yates method).
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            items.swap(last, self.below(last + 1));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Purpose, Stream};

    fn stream(index: u64) -> Stream {
        Stream::new(7, 3, Purpose::Test, index)
    }

    #[test]
    fn an_address_is_one_stream_and_its_neighbours_are_others() {
        let first = |mut stream: Stream| stream.bits();
        assert_eq!(first(stream(0)), first(stream(0)));
        let neighbours = [
            stream(1),
            Stream::new(8, 3, Purpose::Test, 0),
            Stream::new(7, 4, Purpose::Test, 0),
            Stream::new(7, 3, Purpose::Child, 0),
        ];
        for neighbour in neighbours {
            assert_ne!(first(stream(0)), first(neighbour));
        }
    }

    #[test]
    fn whole_numbers_are_uniform() {
        let mut stream = stream(2);
        let mut counts = [0u32; 6];
        for _ in 0..60_000 {
            counts[stream.below(6)] += 1;
        }
        // Standard deviation of one count: 91.
        assert!(counts.iter().all(|&count| count.abs_diff(10_000) < 500), "{counts:?}");
    }

    #[test]
    fn normal_numbers_have_mean_0_and_deviation_1() {
        let mut stream = stream(3);
        let draws: Vec<f64> = (0..100_000).map(|_| stream.normal()).collect();
        let mean = draws.iter().sum::<f64>() / draws.len() as f64;
        let variance = draws.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / draws.len() as f64;
        assert!(mean.abs() < 0.015, "mean {mean}");
        assert!((variance - 1.0).abs() < 0.02, "variance {variance}");
    }

    #[test]
    fn normal_numbers_in_bulk_have_mean_0_deviation_1_and_no_correlation() {
        let mut draws = vec![0.0; 100_001];
        stream(5).normals(&mut draws);
        let count = draws.len() as f32;
        let mean = draws.iter().sum::<f32>() / count;
        let variance = draws.iter().map(|x| (x - mean) * (x - mean)).sum::<f32>() / count;
        let correlation = draws.windows(2).map(|pair| pair[0] * pair[1]).sum::<f32>() / count;
        assert!(mean.abs() < 0.015 && (variance - 1.0).abs() < 0.02 && correlation.abs() < 0.015);
        let far = draws.iter().filter(|x| x.abs() > 2.0).count() as f32 / count;
        assert!((far - 0.0455).abs() < 0.003, "{far} beyond two deviations");
    }

    #[test]
    fn a_shuffle_keeps_every_item() {
        let mut items: Vec<u32> = (0..100).collect();
        stream(4).shuffle(&mut items);
        assert_ne!(items, (0..100).collect::<Vec<_>>());
        items.sort_unstable();
        assert_eq!(items, (0..100).collect::<Vec<_>>());
    }
}
