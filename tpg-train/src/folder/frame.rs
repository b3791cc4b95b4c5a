//! The form of a checkpoint's file: its content, then a line with a checksum of all that is before the sum.
//!
//! ```text
//! …content…
//! tpg-train sac, checkpoint version 5, SHA-256 9f86d081…
//! ```
//!
//! The line stands at the end, so that a file that was cut has none.

use super::Trainer;
use sha2::{Digest as _, Sha256};

/// Digits of the checksum.
const DIGITS: usize = 64;
/// Longest last line, bytes.
const LONGEST: usize = 200;

/// Appends the line to a checkpoint's content.
pub fn seal(mut content: Vec<u8>, trainer: Trainer, version: u32) -> Vec<u8> {
    content.extend_from_slice(format!("\ntpg-train {trainer}, checkpoint version {version}, SHA-256 ").as_bytes());
    let sum = checksum(&content);
    content.extend_from_slice(sum.as_bytes());
    content.push(b'\n');
    content
}

/// The reason why a file is not the checkpoint that was asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Fault {
    /// The bytes are not those that were written.
    Damaged(&'static str),
    /// The bytes are whole, but of another trainer or version.
    Other(String),
}

/// Checks the line at the end and returns the content.
///
/// # Errors
/// The fault, if the file was damaged or is another one.
pub(crate) fn open(file: &[u8], trainer: Trainer, version: u32) -> Result<&[u8], Fault> {
    let cut = Fault::Damaged("no checksum at the end: the file was cut, or is none of this program");
    let Some((b'\n', rest)) = file.split_last().map(|(last, rest)| (*last, rest)) else { return Err(cut) };
    let tail = &rest[rest.len().saturating_sub(LONGEST)..];
    let Some(at) = tail.iter().rposition(|&byte| byte == b'\n').map(|at| rest.len() - tail.len() + at) else {
        return Err(cut);
    };
    let Ok(line) = std::str::from_utf8(&rest[at + 1..]) else { return Err(cut) };
    let Some((name, sum)) = line.len().checked_sub(DIGITS).and_then(|end| line.split_at_checked(end)) else {
        return Err(cut);
    };
    if checksum(&rest[..rest.len() - DIGITS]) != sum {
        return Err(Fault::Damaged("another checksum than its content has: the file was changed or damaged"));
    }
    if name != format!("tpg-train {trainer}, checkpoint version {version}, SHA-256 ") {
        return Err(Fault::Other(name.trim_end_matches(", SHA-256 ").to_owned()));
    }
    Ok(&rest[..at])
}

/// Returns the SHA-256 of bytes, in hexadecimal digits.
pub(crate) fn checksum(bytes: impl AsRef<[u8]>) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::{Fault, Trainer, open, seal};

    #[test]
    fn every_changed_bit_and_every_cut_is_found() {
        let content = b"{\"some\": \"content\"}\nof two lines".to_vec();
        let file = seal(content.clone(), Trainer::Sac, 7);
        assert_eq!(open(&file, Trainer::Sac, 7), Ok(&content[..]));
        for bit in 0..8 * file.len() {
            let mut changed = file.clone();
            changed[bit / 8] ^= 1 << (bit % 8);
            let fault = open(&changed, Trainer::Sac, 7);
            assert!(matches!(fault, Err(Fault::Damaged(_))), "bit {bit}: {fault:?}");
        }
        for length in 0..file.len() {
            assert!(matches!(open(&file[..length], Trainer::Sac, 7), Err(Fault::Damaged(_))), "{length} bytes");
        }
        let longer = [&file[..], b"x"].concat();
        assert!(matches!(open(&longer, Trainer::Sac, 7), Err(Fault::Damaged(_))));
    }

    #[test]
    fn another_trainer_or_version_is_named() {
        let file = seal(Vec::new(), Trainer::Sac, 7);
        for (trainer, version) in [(Trainer::Tpg, 7), (Trainer::Sac, 8)] {
            let named = "tpg-train sac, checkpoint version 7".to_owned();
            assert_eq!(open(&file, trainer, version), Err(Fault::Other(named)));
        }
    }
}
