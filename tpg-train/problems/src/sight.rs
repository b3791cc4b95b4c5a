//! Images that problems show to policies: the features that policies read, and the random numbers of pictures and games.

use tpg_graph::SourceDocument;
use tpg_graph::image::{Image, Vision, features_of};
use tpg_runtime::scalar::Scalar;

/// The features of a problem's images.
#[derive(Clone, Debug)]
pub(crate) struct Sight {
    sources: Vec<SourceDocument>,
    vision: Vision,
}

impl Sight {
    /// Creates the features of images of some rows and columns, with the given channels, whose values are at most `brightest`.
    pub(crate) fn new([rows, columns]: [usize; 2], channels: &[&str], brightest: u8) -> Self {
        let shape = [rows, columns, channels.len()].map(|size| size as u32);
        let sources = features_of(shape, channels, brightest);
        let vision = Vision::new(&sources).expect("the sources are of an image");
        Self { sources, vision }
    }

    /// Returns the sources.
    pub(crate) fn sources(&self) -> Vec<SourceDocument> {
        self.sources.clone()
    }

    /// Writes some of the features of an image.
    pub(crate) fn look<S: Scalar>(&self, image: &impl Image, inputs: impl Iterator<Item = usize>, state: &mut [S]) {
        self.vision.look(image, inputs, |input, value| state[input] = S::from_f64(value));
    }
}

/// Mixes two numbers into random bits.
pub(crate) fn mixed(seed: u64, number: u64) -> u64 {
    let mixed = seed.wrapping_add(number.wrapping_mul(0x9E37_79B9_7F4A_7C15));
    let mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    mixed ^ (mixed >> 31)
}
