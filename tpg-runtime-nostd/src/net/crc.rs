//! CRC-32 of IEEE 802.3, four bits at a time: sixteen words of table.

const TABLE: [u32; 16] = {
    let mut table = [0; 16];
    let mut index = 0;
    while index < 16 {
        let mut value = index as u32;
        let mut bit = 0;
        while bit < 4 {
            value = (value >> 1) ^ (0xedb8_8320 & 0u32.wrapping_sub(value & 1));
            bit += 1;
        }
        table[index] = value;
        index += 1;
    }
    table
};

/// Adds one byte.
#[inline(never)] // it runs at the start only, where flash matters more than time
const fn byte(crc: u32, byte: u8) -> u32 {
    let crc = crc ^ byte as u32;
    let crc = (crc >> 4) ^ TABLE[(crc & 15) as usize];
    (crc >> 4) ^ TABLE[(crc & 15) as usize]
}

/// Adds the four bytes of a word, low byte first.
#[inline(never)]
const fn add(crc: u32, word: u32) -> u32 {
    let [a, b, c, d] = word.to_le_bytes();
    byte(byte(byte(byte(crc, a), b), c), d)
}

/// The CRC-32 of a model's words without its first and its fourth, which holds the checksum.
pub(super) const fn of_model(words: &[u32]) -> u32 {
    let mut crc = u32::MAX;
    let mut index = 1;
    while index < words.len() {
        if index != 3 {
            crc = add(crc, words[index]);
        }
        index += 1;
    }
    !crc
}

/// The CRC-32 of names, each with a line feed behind it.
pub const fn of_names(names: &[&str]) -> u32 {
    let mut crc = u32::MAX;
    let mut index = 0;
    while index < names.len() {
        let name = names[index].as_bytes();
        let mut at = 0;
        while at < name.len() {
            crc = byte(crc, name[at]);
            at += 1;
        }
        crc = byte(crc, b'\n');
        index += 1;
    }
    !crc
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_check_value_of_the_standard() {
        // CRC-32 of "123456789" is 0xcbf43926; here of its first eight bytes, as two words: 0x9ae0daaf.
        let [first, second] = [*b"1234", *b"5678"].map(u32::from_le_bytes);
        assert_eq!(!super::add(super::add(u32::MAX, first), second), 0x9ae0_daaf);
    }
}
