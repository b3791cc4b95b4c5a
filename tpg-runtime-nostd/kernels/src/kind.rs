//! Layouts of weights and activations in words.

/// Rows of a block.
pub const ROWS: usize = 4;
/// Columns are padded to a multiple of this.
pub const COLUMNS: usize = 8;

/// The widths of weights and activations, and with them the layout of the words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// `i8` weights, `i16` activations: the bytes of a weight word are columns 0, 2, 1, 3, so that SXTB16 unpacks two
    /// neighbours. Inputs in [`Form::Pairs`].
    W8A16,
    /// `i16` weights, `i16` activations: a weight word is two neighbouring columns. Inputs in [`Form::Pairs`].
    W16A16,
    /// `i8` weights, `i8` activations: the two halves of a weight word are 256·w₂ + w₀ and 256·w₃ + w₁ as signed 16-bit
    /// numbers, used as they are for columns 2 and 3, and by their low bytes for columns 0 and 1. Inputs in
    /// [`Form::Split`] cancel what the low bytes add to the first: (256·w₂ + w₀)·x₂ + w₀·(256·x₀ − x₂) =
    /// 256·(w₂·x₂ + w₀·x₀). Half as many unpackings, and exact. Weights and activations from −127 to 127.
    W8A8,
}

/// Layout of activations in words, two words for four of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Form {
    /// (x₀, x₁), (x₂, x₃): neighbours share a word, the first in its low half. Outputs clipped to 0..=32767.
    Pairs,
    /// (256·x₀ − x₂, 256·x₁ − x₃), (x₂, x₃). Outputs clipped to 0..=127.
    Split,
}

impl Kind {
    /// Every kind.
    pub const ALL: [Self; 3] = [Self::W8A16, Self::W16A16, Self::W8A8];

    /// Its number in a model.
    pub const fn code(self) -> u32 {
        match self {
            Self::W8A16 => 0,
            Self::W16A16 => 1,
            Self::W8A8 => 2,
        }
    }

    /// Its name in files and on command lines: bits of a weight, bits of an activation.
    pub const fn name(self) -> &'static str {
        match self {
            Self::W8A16 => "w8a16",
            Self::W16A16 => "w16a16",
            Self::W8A8 => "w8a8",
        }
    }

    /// The kind of that [`name`](Self::name).
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// The smallest and the greatest weight.
    pub const fn weights(self) -> (i16, i16) {
        match self {
            Self::W8A16 => (i8::MIN as i16, i8::MAX as i16),
            Self::W16A16 => (i16::MIN, i16::MAX),
            Self::W8A8 => (-i8::MAX as i16, i8::MAX as i16),
        }
    }

    /// The greatest activation, behind a ReLU.
    pub const fn activation(self) -> i16 {
        match self {
            Self::W8A16 | Self::W16A16 => i16::MAX,
            Self::W8A8 => i8::MAX as i16,
        }
    }

    /// The kind of that [`code`](Self::code).
    pub const fn from_code(code: u32) -> Option<Self> {
        match code {
            0 => Some(Self::W8A16),
            1 => Some(Self::W16A16),
            2 => Some(Self::W8A8),
            _ => None,
        }
    }

    /// Layout of its inputs in words.
    pub const fn form(self) -> Form {
        match self {
            Self::W8A16 | Self::W16A16 => Form::Pairs,
            Self::W8A8 => Form::Split,
        }
    }

    /// Words of a block whose inputs have `words` words (two columns each).
    pub const fn block(self, words: usize) -> usize {
        let of_weights = match self {
            Self::W8A16 | Self::W8A8 => words.saturating_mul(2),
            Self::W16A16 => words.saturating_mul(4),
        };
        of_weights.saturating_add(2 * ROWS)
    }

    /// Bits by which an accumulator is greater than the sum of products.
    pub(crate) const fn scale(self) -> u32 {
        match self {
            Self::W8A16 | Self::W16A16 => 0,
            Self::W8A8 => 8,
        }
    }
}
