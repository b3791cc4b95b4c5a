//! Changes of seeds, the same for the same random numbers: bits, numbers, words of a dictionary, pieces of other seeds.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Longest mutant, bytes.
const LONGEST: usize = 200_000;
/// Numbers at which programs go wrong.
const NUMBERS: [&str; 24] = [
    "0",
    "-0",
    "-1",
    "1",
    "127",
    "128",
    "255",
    "256",
    "511",
    "513",
    "1000",
    "4095",
    "4096",
    "32768",
    "65535",
    "65536",
    "2147483648",
    "-2147483649",
    "4294967296",
    "9223372036854775808",
    "18446744073709551615",
    "1e308",
    "1e-320",
    "1e400",
];

/// Changes a seed one to six times. `words` are the entries of a dictionary, `others` seeds of the same kind.
pub(super) fn mutate(random: &mut ChaCha8Rng, seed: &[u8], words: &[Vec<u8>], others: &[Vec<u8>]) -> Vec<u8> {
    let mut data = seed.to_vec();
    for _ in 0..random.random_range(1..=6) {
        change(random, &mut data, words, others);
        data.truncate(LONGEST);
    }
    data
}

fn change(random: &mut ChaCha8Rng, data: &mut Vec<u8>, words: &[Vec<u8>], others: &[Vec<u8>]) {
    if data.is_empty() {
        data.push(random.random());
        return;
    }
    let place = random.random_range(0..data.len());
    let end = (place + random.random_range(1..=16)).min(data.len());
    match random.random_range(0..9) {
        0 => data[place] ^= 1 << random.random_range(0..8),
        1 => data[place] = random.random(),
        2 => drop(data.drain(place..end)),
        3 => {
            let bytes: Vec<u8> = (place..end).map(|_| random.random()).collect();
            data.splice(place..place, bytes);
        }
        4 => {
            let piece = data[place..end].to_vec();
            let to = random.random_range(0..=data.len());
            data.splice(to..to, piece);
        }
        5 => data.truncate(place),
        6 if !words.is_empty() => {
            let word = words[random.random_range(0..words.len())].clone();
            data.splice(place..if random.random() { place } else { end }, word);
        }
        7 if !others.is_empty() => {
            let other = &others[random.random_range(0..others.len())];
            let from = random.random_range(0..=other.len());
            let to = (from + random.random_range(0..200)).min(other.len());
            data.splice(place..end, other[from..to].iter().copied());
        }
        _ => number(random, data, place),
    }
}

/// Replaces the number at or after a place.
fn number(random: &mut ChaCha8Rng, data: &mut Vec<u8>, place: usize) {
    let part = |byte: &u8| byte.is_ascii_digit() || b"+-.eE".contains(byte);
    let Some(digit) = data[place..].iter().position(u8::is_ascii_digit).map(|offset| place + offset) else { return };
    let begin = data[..digit].iter().rposition(|byte| !part(byte)).map_or(0, |before| before + 1);
    let end = data[digit..].iter().position(|byte| !part(byte)).map_or(data.len(), |length| digit + length);
    let by = match random.random_range(0..3) {
        0 => (random.random::<i64>() >> random.random_range(0..64)).to_string(),
        _ => NUMBERS[random.random_range(0..NUMBERS.len())].to_owned(),
    };
    data.splice(begin..end, by.into_bytes());
}
