//! Effects of Thumb-2 and RISC-V instructions on control flow and stack, derived from mnemonics and operands in objdump's
//! notation. A mnemonic that both have means the same in both: `beq`, `blt`.

use super::listing::Line;
use Kind::*;
use Stack::*;

/// Kind of control flow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Continues with the next instruction.
    Plain,
    /// Branches to the target; may also continue if `conditional`.
    Branch {
        /// True if execution may continue with the next instruction.
        conditional: bool,
    },
    /// Calls a function and returns.
    Call,
    /// Returns to the caller; may also continue if `conditional`.
    Return {
        /// True if execution may continue with the next instruction.
        conditional: bool,
    },
    /// Ends the run: an undefined instruction.
    Trap,
    /// Goes to an address in a register; may also continue if `goes_on`: a call, or a conditional jump.
    Indirect {
        /// True if the next instruction may follow.
        goes_on: bool,
    },
    /// Jumps to an address from a table.
    JumpTable,
}

const CONDITIONS: [&str; 16] =
    ["eq", "ne", "cs", "hs", "cc", "lo", "mi", "pl", "vs", "vc", "hi", "ls", "ge", "lt", "gt", "le"];

/// Classifies an instruction.
pub fn kind(line: &Line) -> Kind {
    let (name, operands) = (bare(&line.mnemonic), line.operands.as_str());
    if matches!(name, "cbz" | "cbnz") {
        return Branch { conditional: true };
    }
    match name {
        "tbb" | "tbh" | "jr" => return JumpTable,
        "udf" | "unimp" | "ebreak" => return Trap,
        "j" => return Branch { conditional: false },
        "beqz" | "bnez" | "bltz" | "bgez" | "blez" | "bgtz" | "bltu" | "bgeu" | "bleu" | "bgtu" => {
            return Branch { conditional: true };
        }
        "jal" => return Call,
        "jalr" => return Indirect { goes_on: true },
        "ret" => return Return { conditional: false },
        _ => {}
    }
    if let Some(conditional) = is(name, "b") {
        return Branch { conditional };
    }
    if is(name, "bl").is_some() {
        return Call;
    }
    if is(name, "blx").is_some() {
        return Indirect { goes_on: true };
    }
    if let Some(conditional) = is(name, "bx") {
        return if operands == "lr" { Return { conditional } } else { Indirect { goes_on: conditional } };
    }
    if let Some(conditional) = loads_many(name)
        && operands.contains("pc}")
    {
        return Return { conditional };
    }
    if let Some(conditional) = is(name, "ldr")
        && operands.starts_with("pc,")
    {
        return if operands.starts_with("pc, [sp]") { Return { conditional } } else { JumpTable };
    }
    let writes_pc = operands.starts_with("pc,");
    match is(name, "mov") {
        Some(conditional) if operands == "pc, lr" => Return { conditional },
        _ if writes_pc => JumpTable,
        _ => Plain,
    }
}

/// True if the instruction's control flow depends on data: a conditional branch, a predicated block, a table.
pub fn is_decision(line: &Line) -> bool {
    let conditional = matches!(kind(line), Branch { conditional: true } | Return { conditional: true });
    let block =
        bare(&line.mnemonic).strip_prefix("it").is_some_and(|rest| rest.chars().all(|c| matches!(c, 't' | 'e')));
    conditional || block || matches!(kind(line), JumpTable | Indirect { .. })
}

/// Change of the stack pointer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stack {
    /// Not decreased.
    Same,
    /// Decreased by this number of bytes.
    Down(u64),
    /// Decreased by an amount known only at run time.
    Unknown,
}

/// Returns the effect of an instruction on the stack pointer. Releasing stack is not counted, which keeps the bound
/// safe.
pub fn stack(line: &Line) -> Stack {
    let (name, operands) = (bare(&line.mnemonic), line.operands.as_str());
    if is(name, "push").is_some() {
        return Down(4 * registers(operands));
    }
    if is(name, "vpush").is_some() {
        return Down(floats(operands));
    }
    if (is(name, "stmdb").is_some() || is(name, "stmfd").is_some()) && operands.starts_with("sp!") {
        return Down(4 * registers(operands));
    }
    if is(name, "vstmdb").is_some() && operands.starts_with("sp!") {
        return Down(floats(operands));
    }
    if name.starts_with("str") && operands.contains("[sp, #-") && operands.ends_with("]!") {
        return number(operands.rsplit("#-").next()).map_or(Unknown, Down);
    }
    if !operands.starts_with("sp,") {
        return Same;
    }
    // RISC-V: a number without a mark.
    if let Some(amount) = operands.strip_prefix("sp,sp,").filter(|_| matches!(name, "add" | "addi")) {
        return match amount.strip_prefix('-') {
            Some(bytes) => number(Some(bytes)).map_or(Unknown, Down),
            None => number(Some(amount)).map_or(Unknown, |_| Same),
        };
    }
    let by_number = || number(operands.rsplit('#').next().filter(|_| operands.contains('#')));
    if is(name, "sub").is_some() || is(name, "subw").is_some() || is(name, "subs").is_some() {
        return by_number().map_or(Unknown, Down);
    }
    // Stores and loads at the stack pointer without changing it: `stmia sp, {r3, r5}`.
    let many = ["stm", "vstm", "ldm", "vldm"].iter().any(|start| name.starts_with(start));
    if name.starts_with("str") || many {
        return Same;
    }
    // Releases stack: by a constant, or from the frame pointer that saved the previous value.
    let gives_back = (is(name, "add").is_some() || is(name, "addw").is_some()) && by_number().is_some();
    if gives_back || (is(name, "mov").is_some() && operands == "sp, r7") || is_compare(name) {
        return Same;
    }
    Unknown
}

fn is_compare(name: &str) -> bool {
    is(name, "cmp").is_some() || is(name, "cmn").is_some() || is(name, "tst").is_some()
}

/// Removes the width from a mnemonic.
fn bare(mnemonic: &str) -> &str {
    mnemonic.trim_end_matches(".n").trim_end_matches(".w")
}

/// Returns `Some` if a mnemonic is `base`: `Some(true)` if it has a condition.
fn is(name: &str, base: &str) -> Option<bool> {
    let condition = name.strip_prefix(base)?;
    if condition.is_empty() {
        return Some(false);
    }
    CONDITIONS.contains(&condition).then_some(true)
}

/// Matches `pop`, `ldmia` and similar instructions.
fn loads_many(name: &str) -> Option<bool> {
    ["pop", "ldmia", "ldmfd", "ldmdb", "ldm"].into_iter().find_map(|base| is(name, base))
}

/// Counts the registers in a list in braces.
fn registers(operands: &str) -> u64 {
    list(operands).map(|(first, last)| last - first + 1).sum()
}

/// Returns the bytes of a list of `s` or `d` registers.
fn floats(operands: &str) -> u64 {
    let width = if operands.contains('d') { 8 } else { 4 };
    width * registers(operands)
}

/// Returns the ranges of a list in braces; single registers are ranges of one.
fn list(operands: &str) -> impl Iterator<Item = (u64, u64)> + '_ {
    let inside = operands.split_once('{').map_or("", |(_, rest)| rest.trim_end_matches('}'));
    inside.split(',').map(str::trim).filter(|name| !name.is_empty()).map(|name| match name.split_once('-') {
        Some((first, last)) => (register(first), register(last)),
        None => (0, 0),
    })
}

/// Returns the number of a register in a range.
fn register(name: &str) -> u64 {
    match name.trim() {
        "sl" => 10,
        "fp" => 11,
        "ip" => 12,
        name => name[1..].parse().unwrap_or(0),
    }
}

fn number(text: Option<&str>) -> Option<u64> {
    let digits: String = text?.chars().take_while(char::is_ascii_digit).collect();
    digits.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::{Kind, Stack, is_decision, kind, stack};
    use crate::listing::Line;

    fn line(text: &str) -> Line {
        let (mnemonic, operands) = text.split_once(' ').unwrap_or((text, ""));
        Line { address: 0, mnemonic: mnemonic.to_owned(), operands: operands.to_owned(), symbol: None, refers_to: None }
    }

    #[test]
    fn branches_calls_and_returns() {
        let conditional = |text| kind(&line(text)) == Kind::Branch { conditional: true };
        assert!(
            ["ble.n 10 <f>", "blt.w 10 <f>", "bls 10 <f>", "beq.n 4", "cbz r0, 8 <f>"].into_iter().all(conditional)
        );
        assert_eq!(kind(&line("b.n 10 <f>")), Kind::Branch { conditional: false });
        for call in ["bl 10 <f>", "bleq 10 <f>", "blle 10 <f>"] {
            assert_eq!(kind(&line(call)), Kind::Call, "{call}");
        }
        for plain in ["bic.w r0, r1, #3", "bfi r0, r1, #3, #4", "bkpt 0x00ab", "pop {r4, r5}", "ldr r0, [pc, #4]"] {
            assert_eq!(kind(&line(plain)), Kind::Plain, "{plain}");
        }
        for back in ["bx lr", "pop {r4, pc}", "ldmia.w sp!, {r4, r5, pc}", "ldr.w pc, [sp], #4", "mov pc, lr"] {
            assert_eq!(kind(&line(back)), Kind::Return { conditional: false }, "{back}");
        }
        assert_eq!(kind(&line("bxne lr")), Kind::Return { conditional: true });
        assert_eq!(kind(&line("popeq {r4, pc}")), Kind::Return { conditional: true });
        assert_eq!(kind(&line("udf #254")), Kind::Trap);
        for (indirect, goes_on) in [("blx r3", true), ("bx r3", false), ("bxne r3", true)] {
            assert_eq!(kind(&line(indirect)), Kind::Indirect { goes_on }, "{indirect}");
        }
        for table in ["tbb [pc, r0]", "tbh [pc, r0, lsl #1]", "ldr.w pc, [r1, r0, lsl #2]", "mov pc, r0", "add pc, r1"]
        {
            assert!(is_decision(&line(table)), "{table}");
        }
    }

    #[test]
    fn risc_v() {
        let kinds = [
            ("beqz a0,1000 <f>", Kind::Branch { conditional: true }),
            ("bgeu a0,a1,1000 <f>", Kind::Branch { conditional: true }),
            ("blt a0,a1,1000 <f>", Kind::Branch { conditional: true }),
            ("j 1000 <f>", Kind::Branch { conditional: false }),
            ("jal 1000 <f>", Kind::Call),
            ("jalr a5", Kind::Indirect { goes_on: true }),
            ("jr a5", Kind::JumpTable),
            ("ret", Kind::Return { conditional: false }),
            ("unimp", Kind::Trap),
            ("lw a1,-1956(a5)", Kind::Plain),
            ("mv a0,s1", Kind::Plain),
        ];
        for (text, expected) in kinds {
            assert_eq!(kind(&line(text)), expected, "{text}");
        }
        for (text, expected) in [
            ("add sp,sp,-16", Stack::Down(16)),
            ("add sp,sp,32", Stack::Same),
            ("add sp,sp,t0", Stack::Unknown),
            ("mv sp,s0", Stack::Unknown),
            ("sw ra,12(sp)", Stack::Same),
        ] {
            assert_eq!(stack(&line(text)), expected, "{text}");
        }
    }

    #[test]
    fn predicated_blocks_are_decisions() {
        assert!(["it eq", "ite ne", "itttt le"].into_iter().all(|text| is_decision(&line(text))));
        assert!(!is_decision(&line("ldr r0, [r1]")));
    }

    #[test]
    fn the_stack_goes_down_by() {
        let cases = [
            ("push {r4, r5, lr}", 12),
            ("push {r4, lr}", 8),
            ("stmdb sp!, {r4, r5, r6, r7, r8, r9, sl, fp, lr}", 36),
            ("stmdb sp!, {r4-r7, lr}", 20),
            ("vpush {d8-d10}", 24),
            ("vpush {s16}", 4),
            ("sub sp, #40", 40),
            ("sub.w sp, sp, #1024", 1024),
            ("str.w lr, [sp, #-4]!", 4),
        ];
        for (text, bytes) in cases {
            assert_eq!(stack(&line(text)), Stack::Down(bytes), "{text}");
        }
        for text in [
            "add sp, #8",
            "mov sp, r7",
            "pop {r4, pc}",
            "str r0, [sp, #4]",
            "mov r7, sp",
            "ldmia.w sp, {r0, r1, r2, r3}",
        ] {
            assert_eq!(stack(&line(text)), Stack::Same, "{text}");
        }
        for text in ["sub.w sp, sp, r3", "mov sp, r0", "bic.w sp, sp, #7", "ldr sp, [r0]"] {
            assert_eq!(stack(&line(text)), Stack::Unknown, "{text}");
        }
    }
}
