//! Layouts of weights and activations in words.

/// Rows of a block.
pub const ROWS: usize = 4;
/// Columns are padded to a multiple of this.
pub const COLUMNS: usize = 8;

/// The width of weights, and with it the layout of their words. Activations have 16 bits: two neighbours share a word, the first in its
/// low half.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// `i8` weights: the bytes of a word are columns 0, 2, 1, 3, so that SXTB16 unpacks two neighbours.
    W8A16,
    /// `i16` weights: a word is two neighbouring columns.
    W16A16,
}

impl Kind {
    /// Every kind.
    pub const ALL: [Self; 2] = [Self::W8A16, Self::W16A16];

    /// Its number in a model.
    pub const fn code(self) -> u32 {
        self as u32
    }

    /// Its name in files and on command lines: bits of a weight, bits of an activation.
    pub const fn name(self) -> &'static str {
        match self {
            Self::W8A16 => "w8a16",
            Self::W16A16 => "w16a16",
        }
    }

    /// The kind of that [`name`](Self::name).
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// Bits of a weight.
    pub const fn bits(self) -> usize {
        match self {
            Self::W8A16 => 8,
            Self::W16A16 => 16,
        }
    }

    /// The smallest and the greatest weight.
    pub const fn weights(self) -> (i16, i16) {
        match self {
            Self::W8A16 => (i8::MIN as i16, i8::MAX as i16),
            Self::W16A16 => (i16::MIN, i16::MAX),
        }
    }

    /// The kind of that [`code`](Self::code).
    pub const fn from_code(code: u32) -> Option<Self> {
        match code {
            0 => Some(Self::W8A16),
            1 => Some(Self::W16A16),
            _ => None,
        }
    }

    /// Words of a block whose inputs have `words` words (two columns each).
    pub const fn block(self, words: usize) -> usize {
        let of_weights = match self {
            Self::W8A16 => words.saturating_mul(2),
            Self::W16A16 => words.saturating_mul(4),
        };
        of_weights.saturating_add(2 * ROWS)
    }
}
