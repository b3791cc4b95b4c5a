//! The form of a checkpoint's file: its content, then a line with a checksum of all that is before the sum.
//!
//! ```text
//! …content…
//! tpg-train sac, checkpoint version 5, SHA-256 9f86d081…
//! ```
//!
//! The line stands at the end, so that a file that was cut has none.

use sha2::{Digest as _, Sha256};
use tpg_graph::error::Finding;

/// The words before the checksum.
const SUM: &str = ", SHA-256 ";

/// Appends the line to a checkpoint's content; `form` names trainer and version.
pub(crate) fn seal(mut content: Vec<u8>, form: &str) -> Vec<u8> {
    content.extend_from_slice(format!("\n{form}{SUM}").as_bytes());
    let sum = checksum(&content);
    content.extend_from_slice(sum.as_bytes());
    content.push(b'\n');
    content
}

/// Checks the line at the end and returns the content.
///
/// # Errors
/// If the file was damaged, or has another form.
pub(crate) fn open<'f>(file: &'f [u8], form: &str) -> Result<&'f [u8], Finding> {
    let damaged = |found| Finding::new("", found, "a whole checkpoint, or another --out");
    let cut = || damaged("no checksum at the end: the file was cut, or is none of this program");
    let sealed = file.strip_suffix(b"\n").ok_or_else(cut)?;
    let end = sealed.iter().rposition(|&byte| byte == b'\n').ok_or_else(cut)?;
    let line = std::str::from_utf8(&sealed[end + 1..]).map_err(|_| cut())?;
    let (found, sum) = line.rsplit_once(SUM).ok_or_else(cut)?;
    if checksum(&sealed[..sealed.len() - sum.len()]) != sum {
        return Err(damaged("another checksum than its content has: the file was changed or damaged"));
    }
    if found != form {
        return Err(Finding::new("", found, form));
    }
    Ok(&sealed[..end])
}

/// Returns the SHA-256 of bytes, in hexadecimal digits.
pub(crate) fn checksum(bytes: impl AsRef<[u8]>) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::{open, seal};

    const FORM: &str = "tpg-train sac, checkpoint version 7";

    #[test]
    fn every_changed_bit_and_every_cut_is_found() {
        let content = b"{\"some\": \"content\"}\nof two lines".to_vec();
        let file = seal(content.clone(), FORM);
        assert_eq!(open(&file, FORM), Ok(&content[..]));
        let check = |file: &[u8], what: String| {
            let finding = open(file, FORM).expect_err(&what);
            assert!(finding.accepted.contains("a whole checkpoint"), "{what}: {finding}");
        };
        for bit in 0..8 * file.len() {
            let mut changed = file.clone();
            changed[bit / 8] ^= 1 << (bit % 8);
            check(&changed, format!("bit {bit}"));
        }
        for length in 0..file.len() {
            check(&file[..length], format!("{length} bytes"));
        }
        check(&[&file[..], b"x"].concat(), "one byte more".to_owned());
    }

    #[test]
    fn another_trainer_or_version_is_named() {
        let finding = open(&seal(Vec::new(), FORM), "another").expect_err("another one");
        assert_eq!(finding.found, FORM);
    }
}
