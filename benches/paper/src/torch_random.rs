//! The random numbers of PyTorch's CPU generator, as far as the recorded actors need them: tensors of fewer than 16
//! standard normals in single precision.
//!
//! They are based on mt19937 and the Box–Muller method in double precision, whose second number is kept for the next
//! call (`aten/src/ATen/core/DistributionsHelper.h`).

const STATE: usize = 624;
const SHIFT: usize = 397;

/// The state of the generator after `torch.manual_seed`.
#[derive(Clone, Debug)]
pub struct TorchRandom {
    state: [u32; STATE],
    next: usize,
    waiting: Option<f64>,
}

impl TorchRandom {
    /// Creates a generator; only the low 32 bits of the seed count.
    pub fn new(seed: u64) -> Self {
        let mut state = [0; STATE];
        let mut last = seed as u32;
        for (index, word) in (0u32..).zip(&mut state) {
            if index > 0 {
                last = (last ^ (last >> 30)).wrapping_mul(1_812_433_253).wrapping_add(index);
            }
            *word = last;
        }
        Self { state, next: STATE, waiting: None }
    }

    fn twist(&mut self) {
        for index in 0..STATE {
            let joined = (self.state[index] & 0x8000_0000) | (self.state[(index + 1) % STATE] & 0x7fff_ffff);
            let odd = if joined & 1 == 1 { 0x9908_b0df } else { 0 };
            self.state[index] = self.state[(index + SHIFT) % STATE] ^ (joined >> 1) ^ odd;
        }
        self.next = 0;
    }

    fn word(&mut self) -> u32 {
        if self.next == STATE {
            self.twist();
        }
        let mut word = self.state[self.next];
        self.next += 1;
        word ^= word >> 11;
        word ^= (word << 7) & 0x9d2c_5680;
        word ^= (word << 15) & 0xefc6_0000;
        word ^ (word >> 18)
    }

    /// Returns a number in [0, 1), a multiple of 2⁻⁵³.
    fn unit(&mut self) -> f64 {
        let high = u64::from(self.word());
        let bits = (high << 32) | u64::from(self.word());
        (bits & ((1 << 53) - 1)) as f64 / (1u64 << 53) as f64
    }

    /// Returns a standard normal number.
    pub fn normal(&mut self) -> f32 {
        if let Some(waiting) = self.waiting.take() {
            return waiting as f32;
        }
        let (first, second) = (self.unit(), self.unit());
        let radius = (-2.0 * (-second).ln_1p()).sqrt();
        let angle = 2.0 * std::f64::consts::PI * first;
        self.waiting = Some(radius * angle.sin());
        (radius * angle.cos()) as f32
    }
}

#[cfg(test)]
mod tests {
    use super::TorchRandom;

    #[test]
    fn the_generator_is_the_standard_one() {
        // The 10,000th number of mt19937 seeded with 5489, by the C++ standard (rand.predef).
        let mut random = TorchRandom::new(5489);
        for _ in 0..9999 {
            random.word();
        }
        assert_eq!(random.word(), 4_123_659_995);
    }
}
