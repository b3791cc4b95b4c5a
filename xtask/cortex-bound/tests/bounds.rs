//! Bounds of hand-written assembly: as a listing, and assembled if an assembler is available.

use cortex_bound::{Analyser, Bound, Calls, Listing, LoopBounds, Refusal, Turns, disassemble};
use std::fs;
use std::process::Command;
use tempfile::TempDir;

/// Creates a listing in objdump's format: `label:` begins a function, every other line is an instruction of two bytes.
fn listing(text: &str) -> Listing {
    let mut out = String::from("Disassembly of section .text:\n\n");
    for (address, line) in (0..).step_by(2).zip(text.lines().map(str::trim).filter(|line| !line.is_empty())) {
        match line.strip_suffix(':') {
            Some(name) => out.push_str(&format!("{address:08x} <{name}>:\n {address:3x}:\tnop\n")),
            None => out.push_str(&format!(" {address:3x}:\t{}\n", line.replacen(' ', "\t", 1))),
        }
    }
    Listing::parse(&out)
}

fn bound(text: &str, name: &str) -> Result<Bound, Refusal> {
    Analyser::new(&listing(text), &LoopBounds::new()).bound(name)
}

#[test]
fn the_longer_way_and_the_callees_count() {
    // Addresses: f 0, push 2, cbz 4, add 6, add 8, bl a, pop c; g e, sub 10, bx 12.
    let text = "
        f:
        push {r4, lr}
        cbz r0, a <f+0xa>
        add r0, r1
        add r0, r1
        bl e <g>
        pop {r4, pc}
        g:
        sub sp, #16
        bx lr";
    assert_eq!(bound(text, "g"), Ok(Bound { instructions: 3, stack: 16 }));
    assert_eq!(bound(text, "f"), Ok(Bound { instructions: 7 + 3, stack: 8 + 16 }));
}

#[test]
fn a_tail_call_is_a_call() {
    let text = "
        f:
        push {r4, lr}
        b.n 6 <g>
        g:
        bx lr";
    assert_eq!(bound(text, "f"), Ok(Bound { instructions: 3 + 2, stack: 8 }));
}

#[test]
fn a_conditional_return_may_go_on() {
    let text = "
        f:
        it eq
        bxeq lr
        add r0, r1
        bx lr";
    assert_eq!(bound(text, "f"), Ok(Bound { instructions: 5, stack: 0 }));
}

#[test]
fn loops_are_refused_without_a_bound() {
    let text = "
        f:
        subs r0, #1
        bne.n 2 <f+0x2>
        bx lr";
    let refusal = bound(text, "f").unwrap_err();
    assert!(matches!(refusal, Refusal::Loop(ref site) if site.function == "f" && site.address == 2));
    assert!(refusal.to_string().contains("--loop-bound f=N"), "{refusal}");
    let bounds = LoopBounds::from([("f".to_owned(), Turns::Every(10))]);
    let found = Analyser::new(&listing(text), &bounds).bound("f");
    assert_eq!(found, Ok(Bound { instructions: 1 + 10 * 2 + 1, stack: 0 }));
}

#[test]
fn recursion_names_its_circle() {
    let text = "
        f:
        bl 6 <g>
        bx lr
        g:
        bl 0 <f>
        bx lr";
    let refusal = bound(text, "f").unwrap_err();
    assert_eq!(refusal.to_string(), "recursion: f calls g calls f");
    let to_itself = "
        f:
        bl 0 <f>
        bx lr";
    assert_eq!(bound(to_itself, "f").unwrap_err().to_string(), "recursion: f calls f");
}

#[test]
fn what_is_not_known_is_refused() {
    for (instruction, expected) in [
        ("blx r3", "branches through a register"),
        ("bx r3", "branches through a register"),
        ("tbb [pc, r0]", "jumps through a table"),
        ("sub.w sp, sp, r3", "moves its stack pointer"),
        ("b.n 4000 <elsewhere+0x10>", "leads neither"),
        ("add r0, r1", "leads neither"), // and past the end
    ] {
        let text = format!("f:\n{instruction}");
        let refusal = bound(&text, "f").unwrap_err().to_string();
        assert!(refusal.contains(expected) && refusal.contains("0x2"), "{instruction}: {refusal}");
    }
    assert_eq!(bound("f:\nbx lr", "g").unwrap_err().to_string(), "no function \"g\" in the object");
}

#[test]
fn decisions_are_found_in_callees_too() {
    let text = "
        f:
        bl 6 <g>
        bx lr
        g:
        ite eq
        moveq r0, r1
        bx lr
        h:
        cbz r0, 0";
    let listing = listing(text);
    let bounds = LoopBounds::new();
    let sites = Analyser::new(&listing, &bounds).decisions("f").expect("known control flow");
    assert_eq!(sites.len(), 1);
    assert_eq!((sites[0].function.as_str(), sites[0].text.as_str()), ("g", "ite eq"));
}

const ASSEMBLY: &str = "
    .syntax unified
    .cpu cortex-m4
    .fpu fpv4-sp-d16
    .thumb
    .section .text.leaf, \"ax\"
    .thumb_func
    .global leaf
leaf:                       @ 4 instructions, 16 bytes
    vpush {d8, d9}
    vadd.f32 s0, s0, s1
    vpop {d8, d9}
    bx lr
    .section .text.root, \"ax\"
    .thumb_func
    .global root
root:                       @ push, mov, cmp, then 3 of the longer arm with the call, ldr, pop
    stmdb sp!, {r4, r5, r6, lr}
    mov r4, r0
    cmp r4, #3
    bgt 1f
    bl leaf
    b 2f
1:  adds r4, #1
2:  ldr r0, =0x12345678
    pop {r4, r5, r6, pc}
    .ltorg
    .section .text.table, \"ax\"
    .thumb_func
    .global table
table:                      @ tbb, and the longest of three ways: 3, with the return
    tbb [pc, r0]
3:  .byte (1f - 3b) / 2
    .byte (2f - 3b) / 2
    .byte (4f - 3b) / 2
    .align 1
1:  adds r0, #1
2:  adds r0, #1
4:  bx lr
    .section .text.lost, \"ax\"
    .thumb_func
    .global lost
lost:
    push {r3, lr}
    bl sinf
    pop {r3, pc}
";

#[test]
fn assembled_code_is_read_with_its_relocations_and_data() {
    if !tpg_testing::tool("arm-none-eabi-as", "gcc-arm-none-eabi", "the worst case of assembled code")
        || !tpg_testing::tool("arm-none-eabi-objdump", "gcc-arm-none-eabi", "the worst case of assembled code")
    {
        return;
    }
    let folder = TempDir::new().expect("a temporary folder");
    let source = folder.path().join("code.s");
    let object = folder.path().join("code.o");
    fs::write(&source, ASSEMBLY).expect("the folder can be written");
    let status = Command::new("arm-none-eabi-as").arg(&source).arg("-o").arg(&object).status().expect("it starts");
    assert!(status.success());
    let listing = disassemble(&object).expect("a listing");
    let bounds = LoopBounds::new();
    let mut analyser = Analyser::new(&listing, &bounds);
    assert_eq!(analyser.bound("leaf"), Ok(Bound { instructions: 4, stack: 16 }));
    assert_eq!(analyser.bound("root"), Ok(Bound { instructions: 8 + 4, stack: 16 + 16 }));
    assert_eq!(analyser.bound("table"), Ok(Bound { instructions: 1 + 3, stack: 0 }));
    let refusal = analyser.bound("lost").unwrap_err().to_string();
    assert!(refusal.contains("calls sinf, which is not in the object"), "{refusal}");
}

/// Code of `f` with calls through a register. A label is also an instruction.
const INDIRECT: &str = "
    f:
    push {r4, lr}
    blx r3
    pop {r4, pc}
    g:
    bx lr
    h:
    sub sp, #24
    add r0, r1
    add sp, #24
    bx lr
    t:
    bx r3";

#[test]
fn calls_through_registers_reach_what_was_said() {
    let listing = listing(INDIRECT);
    let bounds = LoopBounds::new();
    let names = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect::<Vec<_>>();
    let calls = Calls::from([("f".to_owned(), names(&["g", "h"])), ("t".to_owned(), names(&["g"]))]);
    let mut analyser = Analyser::new(&listing, &bounds).calling(&calls);
    assert_eq!(analyser.bound("f"), Ok(Bound { instructions: 4 + 5, stack: 8 + 24 }), "the more expensive one");
    assert_eq!(analyser.bound("t"), Ok(Bound { instructions: 2 + 2, stack: 0 }), "a jump does not come back");

    let refusal = Analyser::new(&listing, &bounds).bound("f").unwrap_err().to_string();
    assert!(refusal.contains("--calls f=CALLEE"), "{refusal}");
    let unknown = Calls::from([("f".to_owned(), names(&["elsewhere"]))]);
    let refusal = Analyser::new(&listing, &bounds).calling(&unknown).bound("f").unwrap_err();
    assert_eq!(refusal, Refusal::NoFunction { name: "elsewhere".to_owned() });
    let needless = Calls::from([("g".to_owned(), names(&["h"]))]);
    let refusal = Analyser::new(&listing, &bounds).calling(&needless).bound("g").unwrap_err();
    assert_eq!(refusal, Refusal::NotIndirect { function: "g".to_owned() });
    // A function that calls itself through a register.
    let circle = Calls::from([("f".to_owned(), names(&["f"]))]);
    let refusal = Analyser::new(&listing, &bounds).calling(&circle).bound("f").unwrap_err();
    assert_eq!(refusal.to_string(), "recursion: f calls f");
}

/// Two loops of three and two instructions.
const LOOPS: &str = "
    f:
    add r0, r1
    subs r0, #1
    bne.n 2 <f+0x2>
    subs r2, #1
    bne.n 8 <f+0x8>
    bx lr";

#[test]
fn each_loop_is_bounded_for_itself() {
    let listing = listing(LOOPS);
    let of = |turns: &[u64]| {
        let bounds = LoopBounds::from([("f".to_owned(), Turns::Each(turns.to_vec()))]);
        Analyser::new(&listing, &bounds).bound("f").map(|bound| bound.instructions)
    };
    assert_eq!(of(&[10, 4]), Ok(1 + 10 * 3 + 4 * 2 + 1));
    assert_eq!(of(&[10]), Err(Refusal::OtherLoops { function: "f".to_owned(), found: vec![2, 8], given: 1 }));
}

#[test]
fn loops_are_bounded_by_their_depth() {
    // The outer loop begins at 4, the inner one at 6.
    let listing = listing(
        "
        f:
        movs r0, #9
        movs r1, #9
        subs r1, #1
        bne.n 6 <f+0x6>
        subs r0, #1
        bne.n 4 <f+0x4>
        bx lr",
    );
    let of = |turns: &[u64]| {
        let bounds = LoopBounds::from([("f".to_owned(), Turns::Nested(turns.to_vec()))]);
        Analyser::new(&listing, &bounds).bound("f").map(|bound| bound.instructions)
    };
    assert_eq!(of(&[10, 4]), Ok(2 + 10 * (1 + 4 * 2 + 2) + 1));
    for other in [&[10][..], &[10, 4, 3]] {
        let refusal = Refusal::OtherLoops { function: "f".to_owned(), found: vec![4, 6], given: other.len() };
        assert_eq!(of(other), Err(refusal));
    }
}

#[test]
fn a_cortex_m0_jumps_by_the_return_of_a_call() {
    // The table after the call at 4 has the entries 12 and 18; the data behind them are none.
    let text = "Disassembly of section .text:

00000000 <f>:
   0:\tpush\t{r4, lr}
   2:\tmovs\tr0, r0
   4:\tbl\t20 <__gnu_thumb1_case_uqi>
   8:\t.byte\t0x05
   9:\t.byte\t0x08
   a:\t.short\t0xffff
  12:\tadds\tr0, r0, r1
  14:\tadds\tr0, r0, r1
  16:\tpop\t{r4, pc}
  18:\tpop\t{r4, pc}

00000020 <__gnu_thumb1_case_uqi>:
  20:\tpush\t{r1}
  22:\tpop\t{r1}
  24:\tbx\tlr
";
    let listing = Listing::parse(text);
    let found = Analyser::new(&listing, &LoopBounds::new()).bound("f");
    assert_eq!(found, Ok(Bound { instructions: 3 + 3 + 3, stack: 8 + 4 }));
}

#[test]
fn functions_that_share_their_ends_are_joined() {
    // g runs on into h, and f branches into the middle of it.
    let text = "
        f:
        add r0, r1
        b.n a <h+0x2>
        g:
        add r0, r1
        h:
        add r0, r1
        add r0, r1
        bx lr";
    // Labels are instructions, too: f 0, g 6, h a.
    assert_eq!(bound(text, "f").map(|bound| bound.instructions), Ok(3 + 4));
    assert_eq!(bound(text, "g").map(|bound| bound.instructions), Ok(2 + 4));
    // Padding leads to g only in appearance: the branch to it is a call, whose loop has the bound of g.
    let listing = listing(
        "
        f:
        b.n 6 <g>
        nop
        g:
        subs r0, #1
        bne.n 8 <g+0x2>
        bx lr",
    );
    let bounds = LoopBounds::from([("g".to_owned(), Turns::Every(5))]);
    let found = Analyser::new(&listing, &bounds).bound("f").map(|bound| bound.instructions);
    assert_eq!(found, Ok(2 + 1 + 5 * 2 + 1));
}

#[test]
fn a_far_jump_within_a_function_is_no_call() {
    let text = "
        f:
        push {r4, lr}
        bl 8 <f+0x8>
        add r0, r1
        pop {r4, pc}";
    let refused = bound(text, "f").unwrap_err();
    assert!(matches!(refused, Refusal::Astray(_)), "nothing is pushed first: {refused}");
    let text = "Disassembly of section .text:

00000000 <f>:
   0:\tpush\t{r4, lr}
   2:\tbl\t8 <f+0x8>
   6:\tadds\tr0, r0, r1
   8:\tpop\t{r4, pc}
";
    let listing = Listing::parse(text);
    let found = Analyser::new(&listing, &LoopBounds::new()).bound("f");
    assert_eq!(found, Ok(Bound { instructions: 3, stack: 8 }));
}

#[test]
fn a_risc_v_is_compiled_and_linked() {
    if !tpg_testing::tool("riscv64-unknown-elf-gcc", "gcc-riscv64-unknown-elf", "bounds of a RISC-V") {
        return;
    }
    let folder = TempDir::new().expect("a folder");
    // A switch becomes a table of distances; the loop needs a bound, and so does the division of floats not.
    let source = "
        float divide(float a, float b) { return a / b; }
        int choose(int n, int a) {
            switch (n) {
            case 0: return a * 3; case 1: return a ^ 77; case 2: return a - 9; case 3: return a / 5;
            case 4: return a << 7; case 5: return -a; case 6: return a % 11; case 7: return a | 5; default: return 1;
            }
        }
        int sum(const int *a, int n) { int s = 0; for (int i = 0; i < n; i++) { s += a[i]; } return s; }
        int entry(int n, int a, const int *b) { return choose(n, a) + sum(b, 8) + (int)divide(n, a); }
    ";
    fs::write(folder.path().join("a.c"), source).expect("written");
    let compile = |args: &[&str]| {
        let flags = ["-march=rv32imac", "-mabi=ilp32", "-O1", "-fno-inline", "a.c"];
        let gcc = Command::new("riscv64-unknown-elf-gcc").current_dir(&folder).args(flags).args(args).status();
        assert!(gcc.expect("a compiler").success());
    };
    compile(&["-c", "-o", "a.o"]);
    let refused = disassemble(&folder.path().join("a.o")).unwrap_err();
    assert!(refused.to_string().contains("accepted: a linked image"), "{refused}");
    compile(&["-nostdlib", "-Wl,-e,entry", "-o", "image", "-lgcc"]);
    let listing = disassemble(&folder.path().join("image")).expect("a listing");
    let bounds = LoopBounds::from([("sum".to_owned(), Turns::Every(9))]);
    let of = |name: &str| Analyser::new(&listing, &bounds).bound(name);
    let [choose, sum, divide, entry] = ["choose", "sum", "divide", "entry"].map(|name| of(name).expect("a bound"));
    assert!((6..20).contains(&choose.instructions), "{choose:?}");
    assert!((9 * 4..9 * 8).contains(&sum.instructions), "{sum:?}");
    assert!((60..400).contains(&divide.instructions) && divide.stack > 0, "{divide:?}");
    let parts = choose.instructions + sum.instructions + divide.instructions;
    assert!(entry.instructions > parts && entry.stack > divide.stack, "{entry:?}");
    let refused = Analyser::new(&listing, &LoopBounds::new()).bound("entry").unwrap_err();
    assert!(matches!(refused, Refusal::Loop(_)), "{refused}");
}

/// Products that need the library, shifts by a constant, a division, and a frame on the stack; the cycles of each decision are written
/// to the serial port.
const AVR: &str = r#"
    #include <avr/interrupt.h>
    #include <avr/io.h>
    #include <stdint.h>

    __attribute__((noinline)) int32_t nothing(const int16_t *s) { return s != 0; }
    __attribute__((noinline)) int32_t decide(const int16_t *s)
    {
        volatile int32_t sums[20];
        sums[s[2] & 15] = (int32_t)s[0] * -21354 + (int32_t)s[1] * 13726;
        const int32_t product = (sums[s[2] & 15] >> 12) * s[1];
        return (product < 0) ? product / s[2] : (product >> (s[2] & 31));
    }
    static void put(char letter)
    {
        while (!(UCSR0A & (1 << UDRE0))) { }
        UDR0 = letter;
    }
    static volatile int32_t result;
    static uint16_t time(int32_t (*of)(const int16_t *), const int16_t *s)
    {
        TCNT1 = 0;
        result = of(s);
        return TCNT1;
    }
    int main(void)
    {
        static int16_t states[4][3] = { { 1000, -7, 30 }, { -32000, 30000, -123 }, { 0, 0, 1 }, { 32767, -32768, 7 } };
        UCSR0B = 1 << TXEN0;
        TCCR1B = 1;
        for (uint8_t at = 0; at < 4; at++) {
            uint16_t cycles = time(decide, states[at]) - time(nothing, states[at]);
            for (uint16_t power = 10000; power > 0; power /= 10) { put('0' + cycles / power % 10); }
            put('\n');
        }
        cli();
        __asm__("sleep");
    }
"#;

#[test]
fn an_avr_takes_no_more_cycles_than_its_bound() {
    if !tpg_testing::tool("avr-gcc", "gcc-avr, avr-libc", "bounds of an AVR") {
        return;
    }
    let folder = TempDir::new().expect("a folder");
    fs::write(folder.path().join("a.c"), AVR).expect("written");
    let compile = |args: &[&str]| {
        let gcc =
            Command::new("avr-gcc").current_dir(&folder).args(["-mmcu=atmega328p", "-Os", "a.c"]).args(args).status();
        assert!(gcc.expect("a compiler").success());
    };
    compile(&["-c", "-o", "a.o"]);
    let refused = disassemble(&folder.path().join("a.o")).unwrap_err().to_string();
    assert_eq!(refused, "an object for an AVR; accepted: a linked image");
    compile(&["-o", "a.elf"]);
    let listing = disassemble(&folder.path().join("a.elf")).expect("a listing");
    let bounds = LoopBounds::new();
    let mut analyser = Analyser::new(&listing, &bounds);
    let [decide, nothing] = ["decide", "nothing"].map(|name| analyser.bound(name).expect("a bound"));
    assert!((80..110).contains(&decide.stack) && nothing.stack == 0, "{decide:?}");
    assert_eq!(listing.unit(), "cycles");
    if !tpg_testing::tool("simavr", "simavr", "cycles of an AVR") {
        return;
    }
    let mut simavr = Command::new("simavr");
    let output =
        simavr.current_dir(&folder).args(["-m", "atmega328p", "-f", "16000000", "a.elf"]).output().expect("it runs");
    let said = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
    // Colours come before a line, and a dot after it.
    let lines = said.lines().filter_map(|line| line.rsplit('m').next()?.strip_suffix('.')?.parse::<u64>().ok());
    let most = lines.inspect(|cycles| assert!(*cycles > 100, "{said}")).max().expect("cycles of each state");
    let bound = decide.instructions - nothing.instructions;
    assert!((most..2 * most).contains(&bound), "{bound}: {said}");
}
