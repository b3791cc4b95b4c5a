//! A network's inputs as words.

/// A feature in multiples of 1/4096 as one in multiples of 1/32: rounded to nearest, halves upwards, clipped to ±127.
#[inline]
pub const fn clip_to_i8(value: i16) -> i16 {
    let rounded = (value as i32 + 64) >> 7;
    if rounded > 127 {
        127
    } else if rounded < -127 {
        -127
    } else {
        rounded as i16
    }
}

/// Both halves of a word, the first one low.
#[inline(always)]
pub(crate) const fn pack(low: i32, high: i32) -> u32 {
    (low as u32 & 0xffff) | ((high as u32) << 16)
}

/// Writes inputs as [`Form::Pairs`](crate::Form::Pairs); zeros behind them.
#[inline(never)] // its loop is not its caller's: a static bound multiplies nested ones
pub fn pair_inputs(inputs: &[i16], words: &mut [u32]) {
    let (fours, rest) = inputs.as_chunks::<4>();
    let mut outputs = words.as_chunks_mut::<2>().0.iter_mut();
    for (&[a, b, c, d], output) in fours.iter().zip(&mut outputs) {
        *output = pairs([a, b, c, d].map(i32::from));
    }
    finish(rest, outputs, pairs);
}

/// Writes inputs as [`Form::Split`](crate::Form::Split), [clipped](clip_to_i8); zeros behind them.
#[inline(never)]
pub fn split_inputs(inputs: &[i16], words: &mut [u32]) {
    let (fours, rest) = inputs.as_chunks::<4>();
    let mut outputs = words.as_chunks_mut::<2>().0.iter_mut();
    let clipped = |four: [i16; 4]| split(four.map(|value| i32::from(clip_to_i8(value))));
    for (&four, output) in fours.iter().zip(&mut outputs) {
        *output = clipped(four);
    }
    finish(rest, outputs, |four| clipped(four.map(|value| value as i16)));
}

fn finish<'a>(rest: &[i16], mut outputs: impl Iterator<Item = &'a mut [u32; 2]>, form: impl Fn([i32; 4]) -> [u32; 2]) {
    if !rest.is_empty()
        && let Some(output) = outputs.next()
    {
        let mut four = [0; 4];
        for (slot, &value) in four.iter_mut().zip(rest) {
            *slot = i32::from(value);
        }
        *output = form(four);
    }
    outputs.for_each(|output| *output = [0; 2]);
}

#[inline(always)]
pub(crate) const fn pairs([a, b, c, d]: [i32; 4]) -> [u32; 2] {
    [pack(a, b), pack(c, d)]
}

#[inline(always)]
pub(crate) const fn split([a, b, c, d]: [i32; 4]) -> [u32; 2] {
    [pack((a << 8) - c, (b << 8) - d), pack(c, d)]
}
