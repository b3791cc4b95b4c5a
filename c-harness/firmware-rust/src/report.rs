//! One line of output, without a heap or `core::fmt`.

const LENGTH: usize = 240;

/// A line under way.
pub struct Report {
    text: [u8; LENGTH],
    length: usize,
}

impl Report {
    /// A line that begins with a word.
    pub fn new(word: &str) -> Self {
        Self { text: [0; LENGTH], length: 0 }.word(word)
    }

    fn put(mut self, byte: u8) -> Self {
        if let Some(slot) = self.text.get_mut(self.length) {
            *slot = byte;
            self.length += 1;
        }
        self
    }

    /// Text as it is.
    pub fn word(self, word: &str) -> Self {
        word.bytes().fold(self, Self::put)
    }

    /// ` name=value`.
    pub fn number(self, name: &str, value: i32) -> Self {
        let line = self.word(" ").word(name).word(if value < 0 { "=-" } else { "=" });
        line.digits(value.unsigned_abs())
    }

    /// ` name=value`.
    pub fn unsigned(self, name: &str, value: u32) -> Self {
        self.word(" ").word(name).word("=").digits(value)
    }

    fn digits(mut self, mut value: u32) -> Self {
        let mut digits = [0u8; 10];
        let mut first = digits.len();
        for (index, digit) in digits.iter_mut().enumerate().rev() {
            *digit = b'0' + (value % 10) as u8;
            value /= 10;
            first = index;
            if value == 0 {
                break;
            }
        }
        for &digit in digits.iter().skip(first) {
            self = self.put(digit);
        }
        self
    }

    /// ` name=value`, sixteen hexadecimal digits.
    pub fn hexadecimal(self, name: &str, value: u64) -> Self {
        let line = self.word(" ").word(name).word("=");
        (0..16).rev().fold(line, |line, place| {
            let digit = (value >> (4 * place)) as u8 & 15;
            line.put(if digit < 10 { b'0' + digit } else { b'a' + digit - 10 })
        })
    }

    /// Prints the line.
    pub fn print(self) {
        let line = self.word("\n");
        if let Some(text) = line.text.get(..line.length).and_then(|text| core::str::from_utf8(text).ok()) {
            crate::platform::print(text);
        }
    }
}
