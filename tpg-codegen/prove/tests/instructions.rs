//! Every form of an instruction, executed over terms and by QEMU on random and special operands.

use crate::emulator::{Forms, Operands, run, tools};
use std::fmt::Write as _;
use tpg_prove::execute::Object;
use tpg_prove::machine::{Answer, Interface, Machine as _, Point, Step};
use tpg_prove::term::evaluate::Evaluator;
use tpg_prove::term::{Float, Terms};

const CONDITIONS: [&str; 14] = ["eq", "ne", "cs", "cc", "mi", "pl", "vs", "vc", "hi", "ls", "ge", "lt", "gt", "le"];
/// The forms: each computes r4 and s4 from r1 to r3 and s1 to s3, which are the bits of three values of the state; r5 and r6
/// are free, and r4 and s4 begin with the fourth.
fn forms() -> Vec<String> {
    let mut forms: Vec<String> = Vec::new();
    let mut add = |text: &str| forms.push(text.to_owned());
    for name in ["add", "sub", "mul", "div", "nmul", "mla", "mls", "nmla", "nmls"] {
        add(&format!("v{name}.f32 s4, s1, s2"));
    }
    for name in ["vneg.f32", "vabs.f32", "vsqrt.f32", "vmov.f32", "vcvt.f32.s32", "vcvt.f32.u32"] {
        add(&format!("{name} s4, s1"));
    }
    for text in ["vmov r4, s1", "vmov s4, r1", "vmov.f32 s4, #1.5", "vmov.f32 s4, #-31.0", "vmov.f32 s4, #0.125"] {
        add(text);
    }
    for name in
        ["add", "adds", "sub", "subs", "rsb", "rsbs", "and", "ands", "orr", "orrs", "orn", "eor", "eors", "bic", "bics"]
    {
        add(&format!("{name} r4, r1, r2"));
        for (shift, amount) in [("lsl", 0), ("lsl", 1), ("lsl", 31), ("lsr", 1), ("lsr", 32), ("asr", 7), ("asr", 32)] {
            if amount > 0 {
                add(&format!("{name} r4, r1, r2, {shift} #{amount}"));
            }
        }
        for number in ["#7", "#255", "#0xff00", "#0xab00ab", "#0xcd00cd00", "#0x9d9d9d9d", "#0x80000000", "#0x1fe0"] {
            add(&format!("{name} r4, r1, {number}"));
        }
    }
    for text in
        ["addw r4, r1, #4095", "subw r4, r1, #2049", "movw r4, #0xfedc", "movt r4, #0x89ab", "mov r4, #0xff0000"]
    {
        add(text);
    }
    for text in ["mvn r4, r1", "mvns r4, r1", "mvn r4, #5", "movs r4, r1", "mov r4, r1", "negs r4, r1"] {
        add(text);
    }
    for text in ["uxtb r4, r1", "uxth r4, r1"] {
        add(text);
    }
    for text in ["ubfx r4, r1, #3, #9", "bfi r4, r1, #4, #8"] {
        add(text);
    }
    for text in ["bfc r4, #7, #12", "uxtb.w r4, r1", "adds r4, r4, #200", "subs r4, r4, #3", "add r4, r1"] {
        add(text);
    }
    for (shift, name) in [(0, "lsl"), (1, "lsr"), (2, "asr")]
        .into_iter()
        .flat_map(|(at, name)| [1, 13, 31].map(|amount| (at * 32 + amount, name)))
    {
        add(&format!("{name} r4, r1, #{}", shift % 32));
        for amount in [0, shift % 32, 32, 33, 255, 256] {
            add(&format!("mov r5, #{amount}; {name} r4, r1, r5; {name}s r1, r1, r5; add r4, r1"));
        }
    }
    // Conditions.
    let full = [
        "cmp r1, r2",
        "cmp r1, #31",
        "subs r5, r1, r2",
        "rsbs r5, r1, r2",
        "cmn r1, #5",
        "adds r5, r1, #7",
        "negs r5, r1",
        "cmp r1, r2, lsl #3",
        "cmp r1, #0x80000000",
    ];
    let floats = [
        "vcmp.f32 s1, s2; vmrs APSR_nzcv, fpscr",
        "vcmpe.f32 s1, s2; vmrs APSR_nzcv, fpscr",
        "vcmpe.f32 s1, #0.0; vmrs APSR_nzcv, fpscr",
    ];
    let signs = [
        "tst r1, r2",
        "ands r5, r1, r2",
        "movs r5, r1",
        "lsls r5, r1, #3",
        "lsrs r5, r1, #1",
        "eors r1, r2",
        "mvns r5, r1",
        "teq r1, r2",
        "bics r1, r2",
        "tst r1, #0x40",
        "adds r5, r1, r2",
        "cmn r1, r2",
    ];
    for condition in CONDITIONS {
        let overflow = matches!(condition, "vs" | "vc");
        for compare in full.iter().filter(|_| !overflow).chain(&floats) {
            add(&format!("{compare}; it {condition}; mov{condition} r4, r3"));
            add(&format!("{compare}; b{condition} 1f; mov r4, r3; 1:"));
            add(&format!("{compare}; b{condition}.w 1f; vmov s4, r3; 1:"));
        }
        for compare in signs.iter().filter(|_| matches!(condition, "eq" | "ne" | "mi" | "pl")) {
            add(&format!("{compare}; it {condition}; mov{condition} r4, r3"));
        }
        add(&format!("vcmp.f32 s1, s2; vmrs APSR_nzcv, fpscr; it {condition}; vadd{condition}.f32 s4, s1, s3"));
    }
    for text in [
        "cmp r1, r2; itete lt; addlt r4, r1, r3; subge r4, r1, r3; vneglt.f32 s4, s1; vabsge.f32 s4, s2",
        "cmp r1, r2; ittt le; cmple r2, r3; movle r4, r1; vmovle.f32 s4, s3",
        "cmp r1, #40; itt hi; vcmphi.f32 s1, s3; vmrshi APSR_nzcv, fpscr; it ls; movls r4, r2",
        "cbz r1, 1f; mov r4, r3; 1:",
        "cbnz r1, 1f; mov r4, r3; 1:",
        "b 1f; mov r4, r3; 1:",
        "b.w 1f; mov r4, r3; 1:",
        "nop; mov r4, r2",
        "push {r1, r2, r3}; pop {r4, r5, r6}",
        "stmdb sp!, {r1, r2, r3, r8}; ldmia sp!, {r4, r5, r6, r8}",
        "str r1, [sp, #-8]!; str r2, [sp, #4]; ldr r4, [sp, #4]; ldr r5, [sp], #8; adds r4, r5",
        "vpush {s1, s2, s3}; pop {r4, r5, r6}",
        "vpush {d1}; pop {r4, r5}; vpush {s1, s2}; vpop {s3, s4}",
        "strd r1, r2, [sp, #-16]!; ldrd r5, r4, [sp], #16",
        "sub sp, #16; mov r6, sp; vstr s1, [sp, #8]; vstmia r6!, {s2, s3}; vldr s4, [sp, #8]; ldr r4, [r6, #-4]; add sp, #16",
        "sub sp, #16; mov r6, sp; stmia r6!, {r1, r2}; vldmdb r6!, {s4}; ldr r4, [r6]; add sp, #16",
        "sub sp, sp, #32; add r6, sp, #8; str r1, [r6, #4]!; str r2, [r6], #4; sub r6, #4; ldr r4, [r6]; add sp, sp, #32",
        "sub sp, #8; str r1, [sp, #4]; strb r2, [sp, #1]; strh r3, [sp, #6]; ldrb r4, [sp, #1]; ldrh r5, [sp, #6]; add r4, r5; add sp, #8",
        "sub sp, #8; strh r1, [sp]; strb r2, [sp, #3]; ldrh r4, [sp]; ldrb r5, [sp, #3]; adds r4, r5; add sp, #8",
        "movs r5, #2; adr r6, 9f; ldrb r4, [r5, r6]; subs r5, r6, r6; adds r4, r5; b 8f; .balign 4; 9: .word 0xfedcba98; 8:",
        "mov r6, r7; adds r6, #4; vstr s1, [r6]; vldr s4, [r7, #4]",
        "vldr s4, 9f; ldr r4, 9f; b 8f; .balign 4; 9: .word 0x3fc00001; 8:",
        "adr r6, 9f; ldrb r4, [r6, #1]; ldrb r5, [r6, #3]; adds r4, r5; ldrh r5, [r6, #2]; \
         eors r4, r5; b 8f; .balign 4; 9: .word 0xfedcba98; 8:",
        "cmp r1, r2; ite lt; movlt r5, #1; movge r5, #3; adr r6, 9f; ldrb r4, [r6, r5]; ldrb r1, [r6, r5]; adds r4, r1; b 8f; \
         .balign 4; 9: .word 0xfedcba98; 8:",
        "cmp r1, r2; ite lt; movlt r5, #1; movge r5, #3; adr r6, 9f; ldr r4, [r6, r5, lsl #2]; b 8f; .balign 4; 9: .word 1, 2, 3, 4; 8:",
        "cmp r1, r2; ite lt; movlt r5, #0; movge r5, #1; adr r6, 9f; ldrh r4, [r6, r5, lsl #1]; \
         b 8f; .balign 4; 9: .word 0x8001fffe; 8:",
        "movs r5, #0; cmp r1, r2; it lt; movlt r5, #1; cmp r1, r3; it gt; addgt r5, #1; cmp r5, #2; bhi 8f; tbb [pc, r5]; \
         9: .byte (1f-9b)/2, (2f-9b)/2, (8f-9b)/2; .balign 2; 1: mov r4, r3; b 8f; 2: mov r4, r2; 8:",
        "movs r5, #0; cmp r1, r2; it lt; movlt r5, #1; cmp r1, r3; it gt; addgt r5, #1; cmp r5, #2; bhi 8f; tbh [pc, r5, lsl #1]; \
         9: .short (1f-9b)/2, (2f-9b)/2, (8f-9b)/2; 1: mov r4, r3; b 8f; 2: mov r4, r2; 8:",
        "movs r5, #0; cmp r1, r2; it lt; movlt r5, #1; cmp r5, #1; bhi 8f; adr r6, 9f; ldr pc, [r6, r5, lsl #2]; \
         .balign 4; 9: .word 1f + 1, 8f + 1; 1: mov r4, r3; 8:",
        "movw r6, #:lower16:table; movt r6, #:upper16:table; ldr r4, [r6, #4]; vldr s4, [r6]",
        "ldr r6, =table; ldr r4, [r6, #4]; vldmia r6, {s3, s4}; b 8f; .ltorg; 8:",
        "bl called; mov r4, r5",
        "movs r4, #0; movs r5, #5; 1: add r4, r1; subs r5, #1; bne 1b",
        "movs r4, #0; movs r5, #0; 1: vadd.f32 s4, s4, s1; movs r6, #3; 2: adds r4, r4, r2; subs r6, #1; bne 2b; adds r5, #1; \
         cmp r5, #4; blt 1b",
    ] {
        add(text);
    }
    forms
}

/// The assembly of all forms.
fn assembly(forms: &[String]) -> String {
    let mut text = ".syntax unified\n.cpu cortex-m4\n.fpu fpv4-sp-d16\n.thumb\n.text\n.balign 4\n.thumb_func\n\
        .type called, %function\ncalled: push {r4, lr}\nadds r5, r1, r2\npop {r4, pc}\n.size called, .-called\n"
        .to_owned();
    for (number, form) in forms.iter().enumerate() {
        let _ = write!(
            text,
            ".balign 4\n.global form_{number}\n.thumb_func\n.type form_{number}, %function\nform_{number}:\n\
             push {{r4, r5, r6, r7, lr}}\nmov r7, r1\nvldr s1, [r0]\nvldr s2, [r0, #4]\nvldr s3, [r0, #8]\n\
             vldr s4, [r0, #12]\nldm r0, {{r1, r2, r3, r4}}\n{form}\nstr r4, [r7]\nvstr s4, [r7, #4]\n\
             pop {{r4, r5, r6, r7, pc}}\n.ltorg\n.size form_{number}, .-form_{number}\n"
        );
    }
    text += ".section .rodata\n.balign 4\ntable: .word 0x40490fdb, 0x12345678\n";
    text
}

/// The results of a form as terms.
fn executed(file: &[u8], number: usize, terms: &Terms) -> Result<Vec<Float>, String> {
    let names = ["r4", "s4"].map(str::to_owned).to_vec();
    let interface = Interface { sources: vec![("operand".to_owned(), 4)], outputs: names, ..Interface::default() };
    let mut object = Object::new(file, &format!("form_{number}"), interface).map_err(|error| error.to_string())?;
    let point = object.entry(terms).map_err(|error| error.to_string())?;
    followed(&mut object, terms, point)
}

/// The results from a point on, chosen by the conditions of the steps.
fn followed(object: &mut Object, terms: &Terms, point: Point) -> Result<Vec<Float>, String> {
    let mut chosen: Option<Vec<Float>> = None;
    for (guard, step) in object.run(terms, &point).map_err(|error| error.to_string())? {
        let values = match step {
            Step::Return(Answer::Values(values)) => values,
            Step::Return(answer) => return Err(format!("{answer:?}")),
            Step::To(next) => followed(object, terms, next)?,
        };
        chosen = Some(match chosen {
            None => values,
            Some(others) => values.iter().zip(others).map(|(&a, b)| terms.choose_float(guard, a, b)).collect(),
        });
    }
    chosen.ok_or_else(|| "no answer".to_owned())
}

#[test]
fn forms_compute_what_the_processor_does() {
    compare(tpg_testing::amount(200, 2_000));
}

#[test]
#[ignore = "minutes: cargo xtask lemmas runs it"]
fn forms_compute_what_the_processor_does_on_a_million_operands() {
    compare(1_000_000);
}

/// Compares all forms on so many operands each.
fn compare(states: usize) {
    if !tools("the meaning of instructions against QEMU") {
        return;
    }
    let forms = forms();
    let folder = tempfile::TempDir::new().expect("a temporary folder");
    std::fs::write(folder.path().join("forms.s"), assembly(&forms)).expect("the folder can be written");
    run(folder.path(), "arm-none-eabi-gcc", &["-c", "forms.s", "-o", "forms.o"]);
    let file = std::fs::read(folder.path().join("forms.o")).expect("it was written");
    let all = Forms { objects: &["forms.o"], count: forms.len(), operands: 4, results: 2, states };
    let expected = all.emulated(folder.path(), None);
    assert_eq!(expected.len(), forms.len());
    let mut operands = Operands(1);
    let mut failures = Vec::new();
    for (number, form) in forms.iter().enumerate() {
        let terms = Terms::new();
        let results = executed(&file, number, &terms);
        let (mut hash, mut first) = (2_166_136_261_u32, Vec::new());
        let mut evaluator = Evaluator::default();
        for _ in 0..states {
            let state = [(); 4].map(|()| operands.next());
            evaluator.set(&state);
            let Ok(results) = &results else { continue };
            for &result in results {
                let bits = evaluator.bits(&terms, result);
                hash = (hash ^ bits).wrapping_mul(16_777_619);
                if states < 1000 {
                    first.push((state, bits));
                }
            }
            hash = hash.wrapping_mul(16_777_619);
        }
        if let Err(refusal) = results {
            failures.push(format!("{form}: refused: {refusal}"));
        } else if hash != expected[number] {
            // Each state gives two results and an answer.
            let printed: Vec<u32> = all.emulated(folder.path(), Some(number));
            let printed = printed.chunks_exact(3).flat_map(|three| [three[0], three[1]]);
            let found = first.iter().zip(printed).enumerate().find(|(_, ((_, own), other))| own != other);
            failures.push(format!("{form}: {found:x?}"));
        }
    }
    assert!(failures.is_empty(), "{} of {} forms:\n{}", failures.len(), forms.len(), failures.join("\n"));
}
