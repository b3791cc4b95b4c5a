//! The decoder: an instruction with its condition.

use super::{Block, Condition, Instruction, Operation::*, PC, narrow, wide};

/// Decodes the instruction at the start of `code`; returns it with the state of conditional execution behind it.
/// `None` if it is cut short, unpredictable, or no part of what is covered here.
pub(crate) fn decode(code: &[u8], address: u32, block: Block) -> Option<(Instruction, Block)> {
    let half = |at: usize| Some(u32::from(u16::from_le_bytes(code.get(at..at + 2)?.try_into().ok()?)));
    let first = half(0)?;
    let is_wide = first >> 11 > 0b11100;
    let operation = match is_wide {
        false => narrow::decode(first, address, block.is_open())?,
        true => wide::decode(first, half(2)?, address)?,
    };
    let size = if is_wide { 4 } else { 2 };
    if first >> 8 == 0xbf && operation == If {
        let condition = first >> 4 & 15;
        let alone = first & 15 == 8;
        let valid = !block.is_open() && (condition < 14 || (condition == 14 && alone));
        let next = Block((first & 255) as u8);
        return valid.then_some((Instruction { address, size, condition: Condition::Always, operation }, next));
    }
    let mut condition = Condition::Always;
    if block.is_open() {
        condition = Condition::new(u32::from(block.0 >> 4))?;
        let last = block.0 & 7 == 0;
        let (may, only_last) = match &operation {
            BranchIf { .. } => (false, false),
            // A conditional branch of its own has no place in a block.
            Branch { .. } => (own_condition(first, half(2)).is_none(), true),
            Exchange { .. } | Call { .. } | Table { .. } => (true, true),
            Transfer { load: true, registers, .. } => (true, registers.contains(&PC)),
            _ => (true, false),
        };
        if !may || (only_last && !last) {
            return None;
        }
    } else if matches!(operation, Branch { .. })
        && let Some(bits) = own_condition(first, half(2))
    {
        condition = Condition::new(bits)?;
    }
    Some((Instruction { address, size, condition, operation }, block.advance()))
}

/// Returns the field of a branch's own condition.
const fn own_condition(first: u32, second: Option<u32>) -> Option<u32> {
    match second {
        _ if first >> 12 == 0b1101 => Some(first >> 8 & 15),
        Some(second) if first >> 11 == 0b11110 && second >> 12 & 0b1101 == 0b1000 => Some(first >> 6 & 15),
        _ => None,
    }
}
