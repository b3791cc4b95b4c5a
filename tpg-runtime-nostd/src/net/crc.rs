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

const fn byte(crc: u32, byte: u8) -> u32 {
    let crc = crc ^ byte as u32;
    let crc = (crc >> 4) ^ TABLE[(crc & 15) as usize];
    (crc >> 4) ^ TABLE[(crc & 15) as usize]
}

/// Of words, low byte first, behind others.
const fn add(mut crc: u32, words: &[u32]) -> u32 {
    let mut index = 0;
    while index < words.len() {
        let [a, b, c, d] = words[index].to_le_bytes();
        crc = byte(byte(byte(byte(crc, a), b), c), d);
        index += 1;
    }
    crc
}

/// Of a model's words but its first and its fourth, which holds the checksum.
pub(super) const fn of_model(words: &[u32]) -> u32 {
    match words {
        [_, kinds, length, _, body @ ..] => !add(add(u32::MAX, &[*kinds, *length]), body),
        _ => 0,
    }
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
        let words = [u32::from_le_bytes(*b"1234"), u32::from_le_bytes(*b"5678")];
        assert_eq!(!super::add(u32::MAX, &words), 0x9ae0_daaf);
    }
}
