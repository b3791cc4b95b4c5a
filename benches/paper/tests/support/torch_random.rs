//! The random numbers of PyTorch's CPU generator, as far as the recorded actors need them: tensors of fewer than 16
//! standard normals in single precision.
//!
//! They are based on mt19937 and the Box–Muller method in double precision, whose second number is kept for the next
//! call (`aten/src/ATen/core/DistributionsHelper.h`).

use rand_mt::Mt;

/// The state of the generator after `torch.manual_seed`.
#[derive(Clone, Debug)]
pub(crate) struct TorchRandom {
    words: Mt,
    waiting: Option<f64>,
}

impl TorchRandom {
    /// Creates a generator; only the low 32 bits of the seed count.
    pub(crate) fn new(seed: u64) -> Self {
        Self { words: Mt::new(seed as u32), waiting: None }
    }

    /// Returns a number in [0, 1), a multiple of 2⁻⁵³.
    fn unit(&mut self) -> f64 {
        let [high, low] = [self.words.next_u32(), self.words.next_u32()];
        let bits = u64::from(high) << 32 | u64::from(low);
        (bits & ((1 << 53) - 1)) as f64 / (1u64 << 53) as f64
    }

    /// Returns a standard normal number.
    pub(crate) fn normal(&mut self) -> f32 {
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
