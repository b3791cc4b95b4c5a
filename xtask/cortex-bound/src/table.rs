//! Tables of jumps: the addresses that a `switch` goes to.

use super::instruction::{Kind, bare, kind};
use super::listing::{Function, Line, Listing};
use std::collections::BTreeSet;

/// Returns the targets of a `tbb` or `tbh`, or of a call of the function that does the same on a Cortex-M0: every entry of the table that
/// follows it. Other data behind it ends the table, or adds paths.
pub(super) fn table(function: &Function, line: &Line, callee: &str) -> Option<Vec<u64>> {
    let (width, is_signed) = match (line.mnemonic.as_str(), callee) {
        ("tbb", _) | (_, "__gnu_thumb1_case_uqi") => (1, false),
        ("tbh", _) | (_, "__gnu_thumb1_case_uhi") => (2, false),
        (_, "__gnu_thumb1_case_sqi") => (1, true),
        (_, "__gnu_thumb1_case_shi") => (2, true),
        (_, "__gnu_thumb1_case_si") => (4, true),
        _ => return None,
    };
    if kind(line) != Kind::Call && !line.operands.starts_with("[pc,") {
        return None;
    }
    // Entries are in halfwords, but those of four bytes, which are aligned.
    let (base, unit) = if width == 4 { ((line.address + 4).next_multiple_of(4), 1) } else { (line.address + 4, 2) };
    let bytes: Vec<u8> = (base..).map_while(|address| function.data.get(&address).copied()).collect();
    let number = |entry: &[u8]| match *entry {
        [byte] if is_signed => i64::from(byte.cast_signed()),
        [byte] => i64::from(byte),
        [low, high] if is_signed => i64::from(i16::from_le_bytes([low, high])),
        [low, high] => i64::from(u16::from_le_bytes([low, high])),
        [a, b, c, d] => i64::from(i32::from_le_bytes([a, b, c, d]) & !1),
        _ => 0,
    };
    let addresses: BTreeSet<u64> = function.lines.iter().map(|line| line.address).collect();
    let targets = bytes.chunks_exact(width).map(|entry| base.wrapping_add_signed(unit * number(entry)));
    let targets: Vec<u64> = targets.take_while(|target| addresses.contains(target)).collect();
    (!targets.is_empty()).then_some(targets)
}

/// Returns the targets of a jump whose table lies elsewhere: the one whose address goes into the jump, or any whose address the function
/// computes. An entry is a target, or its distance from the table.
pub(super) fn table_elsewhere(listing: &Listing, function: &Function, index: usize) -> Option<Vec<u64>> {
    let addresses: BTreeSet<u64> = function.lines.iter().map(|line| line.address).collect();
    let starts: BTreeSet<u64> =
        listing.functions().iter().flat_map(|function| &function.lines).filter_map(|line| line.refers_to).collect();
    let target = |base: u64, word: u32| {
        let targets = [word & !1, word.wrapping_add(base as u32)].map(u64::from);
        targets.into_iter().find(|target| addresses.contains(target))
    };
    let table = |address: u64| -> Vec<u64> {
        // Thumb reads the table's address from beside the code.
        let bases = [Some(address), listing.words_from(address).next().map(u64::from)];
        // What the code refers to next is another table or a constant.
        let end = |base| starts.range(base + 1..).next().copied().unwrap_or(u64::MAX);
        let words = |base| (base..end(base)).step_by(4).zip(listing.words_from(base)).map(|(_, word)| word);
        let entries = |base| words(base).map_while(|word| target(base, word)).collect::<Vec<u64>>();
        bases.into_iter().flatten().map(entries).find(|entries| !entries.is_empty()).unwrap_or_default()
    };
    let found = |lines: &mut dyn Iterator<Item = &Line>| {
        lines.filter_map(|line| line.refers_to).flat_map(&table).collect::<Vec<u64>>()
    };
    // The registers that the address comes from, backwards to the last branch.
    let mut from: BTreeSet<&str> = registers(&function.lines[index].operands).collect();
    for line in function.lines[..index].iter().rev().take_while(|line| kind(line) == Kind::Plain) {
        if written(line).is_some_and(|register| from.remove(register)) {
            let nearest = found(&mut std::iter::once(line));
            if !nearest.is_empty() {
                return Some(nearest);
            }
            from.extend(registers(&line.operands).skip(1));
        }
    }
    let earlier = found(&mut function.lines.iter().filter(|line| written(line).is_some_and(|to| from.contains(to))));
    let all = || found(&mut function.lines.iter());
    let targets = if earlier.is_empty() { all() } else { earlier };
    (!targets.is_empty()).then_some(targets)
}

/// Returns the names among operands: registers, and the names of shifts.
fn registers(operands: &str) -> impl Iterator<Item = &str> {
    let names = operands.split(|c: char| !c.is_ascii_alphanumeric());
    names.filter(|name| name.starts_with(|c: char| c.is_ascii_lowercase()))
}

/// Returns the register that an instruction writes: its first operand, but for stores and comparisons.
fn written(line: &Line) -> Option<&str> {
    let reads = ["sw", "sh", "sb", "fsw", "cmp", "cmn", "tst", "teq", "push", "vcmp"];
    let name = bare(&line.mnemonic);
    let is_read = reads.contains(&name) || name.starts_with("st") || name.starts_with("vst");
    registers(&line.operands).next().filter(|_| !is_read)
}
