//! A network's inputs as words.

/// Both halves of a word, the first one low.
#[inline(always)]
const fn pack(low: i32, high: i32) -> u32 {
    (low as u32 & 0xffff) | ((high as u32) << 16)
}

/// Writes inputs as words of two neighbours, the first in the low half; zeros behind them.
#[inline(never)] // its loop is not its caller's: a static bound multiplies nested ones
pub fn pair_inputs(inputs: &[i16], words: &mut [u32]) {
    let (fours, rest) = inputs.as_chunks::<4>();
    let mut outputs = words.as_chunks_mut::<2>().0.iter_mut();
    for (&[a, b, c, d], output) in fours.iter().zip(&mut outputs) {
        *output = pairs([a, b, c, d].map(i32::from));
    }
    if !rest.is_empty()
        && let Some(output) = outputs.next()
    {
        let mut four = [0; 4];
        for (slot, &value) in four.iter_mut().zip(rest) {
            *slot = i32::from(value);
        }
        *output = pairs(four);
    }
    outputs.for_each(|output| *output = [0; 2]);
}

#[inline(always)]
pub(crate) const fn pairs([a, b, c, d]: [i32; 4]) -> [u32; 2] {
    [pack(a, b), pack(c, d)]
}
