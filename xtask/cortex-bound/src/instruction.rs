//! Effects of Thumb-2, RISC-V and AVR instructions on control flow and stack, derived from mnemonics and operands in objdump's
//! notation. A mnemonic that several have means the same in all: `beq`, `blt`.

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
    /// Continues with the next instruction or the one after it.
    Skip,
}

const CONDITIONS: [&str; 16] =
    ["eq", "ne", "cs", "hs", "cc", "lo", "mi", "pl", "vs", "vc", "hi", "ls", "ge", "lt", "gt", "le"];

/// Instructions that may have a condition.
const CONDITIONAL: [&str; 3] = [
    "b bl blx bx pop ldm ldmia ldmfd ldmdb ldr mov",
    "push vpush stmdb stmfd vstmdb",
    "add addw sub subw subs cmp cmn tst",
];

/// Returns a mnemonic without its width and its condition, and tests for a condition.
fn base(line: &Line) -> (&str, bool) {
    let name = bare(&line.mnemonic);
    let names = || CONDITIONAL.iter().flat_map(|names| names.split(' '));
    let conditional = |base: &str| name.strip_prefix(base).is_some_and(|rest| CONDITIONS.contains(&rest));
    names().find(|base| conditional(base)).map_or((name, false), |base| (base, true))
}

/// Classifies an instruction.
pub fn kind(line: &Line) -> Kind {
    let ((name, conditional), operands) = (base(line), line.operands.as_str());
    match name {
        "tbb" | "tbh" | "jr" => JumpTable,
        "udf" | "unimp" | "ebreak" => Trap,
        "j" => Branch { conditional: false },
        "cbz" | "cbnz" | "beqz" | "bnez" | "bltz" | "bgez" | "blez" | "bgtz" | "bltu" | "bgeu" | "bleu" | "bgtu" => {
            Branch { conditional: true }
        }
        "rcall" if operands == PUSH => Plain,
        "jal" | "bl" | "call" | "rcall" => Call,
        "jalr" | "blx" | "icall" => Indirect { goes_on: true },
        "ijmp" => Indirect { goes_on: false },
        "ret" | "reti" => Return { conditional: false },
        "jmp" | "rjmp" => Branch { conditional: false },
        "sbrc" | "sbrs" | "sbic" | "sbis" | "cpse" => Skip,
        _ if name.starts_with("br") => Branch { conditional: true },
        "b" => Branch { conditional },
        "bx" if operands == "lr" => Return { conditional },
        "bx" => Indirect { goes_on: conditional },
        "pop" | "ldm" | "ldmia" | "ldmfd" | "ldmdb" if operands.contains("pc}") => Return { conditional },
        "ldr" if operands.starts_with("pc, [sp]") => Return { conditional },
        "mov" if operands == "pc, lr" => Return { conditional },
        _ if operands.starts_with("pc,") => JumpTable,
        _ => Plain,
    }
}

/// The distance of a call of an AVR that only pushes an address, to make room on the stack.
const PUSH: &str = ".+0";

/// Returns the cycles of an instruction of an AVR at most: branches are taken, and skips skip two words.
pub(crate) fn cycles(line: &Line) -> u64 {
    let name = line.mnemonic.as_str();
    match name {
        "call" | "ret" | "reti" => 4,
        "jmp" | "rcall" | "icall" | "lpm" | "elpm" => 3,
        "adiw" | "sbiw" | "mul" | "muls" | "mulsu" | "fmul" | "fmuls" | "fmulsu" | "ld" | "ldd" | "lds" | "st"
        | "std" | "sts" | "push" | "pop" | "rjmp" | "ijmp" | "sbi" | "cbi" => 2,
        _ => match kind(line) {
            Skip => 3,
            Branch { .. } => 2,
            _ => 1,
        },
    }
}

/// True if the instruction's control flow depends on data: a conditional branch, a predicated block, a table.
pub fn is_decision(line: &Line) -> bool {
    let conditional = matches!(kind(line), Branch { conditional: true } | Return { conditional: true });
    let block =
        bare(&line.mnemonic).strip_prefix("it").is_some_and(|rest| rest.chars().all(|c| matches!(c, 't' | 'e')));
    conditional || block || matches!(kind(line), JumpTable | Indirect { .. } | Skip)
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

/// Returns the effect of an instruction, and of one before it, on the stack pointer. Releasing stack is not counted, which keeps the
/// bound safe.
pub fn stack(line: &Line, before: Option<&Line>) -> Stack {
    let ((name, _), operands) = (base(line), line.operands.as_str());
    let by_number = || number(operands.rsplit('#').next().filter(|_| operands.contains('#')));
    match name {
        "push" if operands.starts_with('r') => Down(1),
        "push" => Down(4 * registers(operands)),
        "rcall" if operands == PUSH => Down(2),
        // The frame of an AVR is below its pointer, r28 and r29: at once, or byte by byte if it is large.
        "sbiw" if operands.starts_with("r28,") => byte(operands).map_or(Unknown, Down),
        "sbci" | "sbc" if operands.starts_with("r29,") => {
            let low = before.filter(|before| before.mnemonic == "subi" && before.operands.starts_with("r28,"));
            // r1 is 0.
            let high = if operands == "r29, r1" { Some(0) } else { byte(operands) };
            let both = low.and_then(|low| Some((high? << 8) + byte(&low.operands)?));
            // Else these registers hold data.
            both.filter(|&bytes| bytes < 1 << 15).map_or(Same, Down)
        }
        "out" if operands.starts_with("0x3d,") && !operands.ends_with("r28") => Unknown,
        "vpush" => Down(floats(operands)),
        "stmdb" | "stmfd" if operands.starts_with("sp!") => Down(4 * registers(operands)),
        "vstmdb" if operands.starts_with("sp!") => Down(floats(operands)),
        _ if name.starts_with("str") && operands.contains("[sp, #-") && operands.ends_with("]!") => {
            number(operands.rsplit("#-").next()).map_or(Unknown, Down)
        }
        _ if !operands.starts_with("sp,") => Same,
        // RISC-V: a number without a mark.
        "add" | "addi" if operands.starts_with("sp,sp,") => match operands["sp,sp,".len()..].strip_prefix('-') {
            Some(bytes) => number(Some(bytes)).map_or(Unknown, Down),
            None => number(operands.rsplit(',').next()).map_or(Unknown, |_| Same),
        },
        "sub" | "subw" | "subs" => by_number().map_or(Unknown, Down),
        // Stores and loads at the stack pointer without changing it: `stmia sp, {r3, r5}`.
        _ if ["str", "stm", "vstm", "ldm", "vldm"].iter().any(|start| name.starts_with(start)) => Same,
        // Releases stack: by a constant, or from the frame pointer that saved the previous value.
        "add" | "addw" if by_number().is_some() => Same,
        "mov" if operands == "sp, r7" => Same,
        "cmp" | "cmn" | "tst" => Same,
        _ => Unknown,
    }
}

/// Removes the width from a mnemonic.
pub(super) fn bare(mnemonic: &str) -> &str {
    mnemonic.trim_end_matches(".n").trim_end_matches(".w")
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

/// Returns the byte that is the last operand of an instruction of an AVR.
fn byte(operands: &str) -> Option<u64> {
    u64::from_str_radix(operands.rsplit_once("0x")?.1, 16).ok()
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
            assert_eq!(stack(&line(text), None), expected, "{text}");
        }
    }

    #[test]
    fn avr() {
        let kinds = [
            ("brne 3e", Kind::Branch { conditional: true }),
            ("rjmp 10", Kind::Branch { conditional: false }),
            ("call 0x178", Kind::Call),
            ("rcall .+0", Kind::Plain),
            ("sbrs r27, 7", Kind::Skip),
            ("ijmp", Kind::Indirect { goes_on: false }),
            ("ret", Kind::Return { conditional: false }),
            ("bst r24, 7", Kind::Plain),
        ];
        for (text, expected) in kinds {
            assert_eq!(kind(&line(text)), expected, "{text}");
        }
        let cycles = ["add r0, r0", "muls r16, r17", "brne 3e", "sbrs r27, 7", "lpm r24, Z+", "call 0x178"];
        assert_eq!(cycles.map(|text| super::cycles(&line(text))), [1, 2, 2, 3, 3, 4]);
        let moves = ["push r28", "sbiw r28, 0x17", "rcall .+0"];
        assert_eq!(moves.map(|text| stack(&line(text), None)), [1, 23, 2].map(Stack::Down));
        let large = |low, high| stack(&line(high), Some(&line(low)));
        assert_eq!(large("subi r28, 0x50", "sbci r29, 0x01"), Stack::Down(336));
        assert_eq!(large("subi r28, 0x50", "sbc r29, r1"), Stack::Down(80));
        assert_eq!(large("subi r28, 0xB0", "sbci r29, 0xFE"), Stack::Same);
        assert_eq!(stack(&line("adiw r28, 0x17"), None), Stack::Same);
        assert_eq!(stack(&line("out 0x3d, r24"), None), Stack::Unknown);
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
            assert_eq!(stack(&line(text), None), Stack::Down(bytes), "{text}");
        }
        for text in [
            "add sp, #8",
            "mov sp, r7",
            "pop {r4, pc}",
            "str r0, [sp, #4]",
            "mov r7, sp",
            "ldmia.w sp, {r0, r1, r2, r3}",
        ] {
            assert_eq!(stack(&line(text), None), Stack::Same, "{text}");
        }
        for text in ["sub.w sp, sp, r3", "mov sp, r0", "bic.w sp, sp, #7", "ldr sp, [r0]"] {
            assert_eq!(stack(&line(text), None), Stack::Unknown, "{text}");
        }
    }
}
