//! The C kernels give the bits of the Rust ones, with every compiler at hand, and compile without a warning.

use crate::common::{fixture, shaped};
use std::io::{Read as _, Write as _};
use std::process::{Command, Stdio};
use tpg_codegen::emit::{self, Language, Profile, Style};
use tpg_graph::{MathsProvider, ScalarType};
use tpg_runtime::ops::own;

/// Compilers of C99 and C++11: program, package, arguments.
const COMPILERS: [(&str, &str, &[&str]); 4] = [
    ("cc", "gcc", &["-std=c99", "-Wstrict-prototypes"]),
    ("clang", "clang", &["-std=c99", "-Wstrict-prototypes"]),
    ("g++", "g++", &["-x", "c++", "-std=c++11"]),
    ("clang++", "clang", &["-x", "c++", "-std=c++11"]),
];

const FLAGS: [&str; 12] = [
    "-O2",
    "-ffp-contract=off",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wconversion",
    "-Wsign-conversion",
    "-Wdouble-promotion",
    "-Wshadow",
    "-Wcast-qual",
    "-Wfloat-equal",
    "-Werror",
];

/// Reads numbers and writes the results of each.
const MAIN: &str = "
int main(void)
{
    NUMBER x;
    while (fread(&x, sizeof x, 1, stdin) == 1) {
        const NUMBER y[7] = {tpg_sin(x), tpg_cos(x), tpg_tan(x), tpg_ln(x), tpg_exp(x), tpg_atan(x), tpg_tanh(x)};
        if (fwrite(y, sizeof y, 1, stdout) != 1) {
            return 1;
        }
    }
    return 0;
}
";

/// Generated code that calls every function, and a program around these.
fn program(scalar: ScalarType, number: &str) -> [(String, String); 2] {
    let shape = (Style::Pure, Some(Profile::Small));
    let files = emit::emit(&fixture(scalar, MathsProvider::Own), Language::C, &shaped("tpg", shape));
    let [header, source] = files.try_into().expect("two files");
    let main = MAIN.replace("NUMBER", number);
    let text = format!("#define TPG_NO_SELFTEST\n#include <stdio.h>\n\n{}\n{main}", source.text);
    [(header.name, header.text), ("own.c".to_owned(), text)]
}

/// The compiled program's answers.
fn run(compiler: &str, arguments: &[&str], program: &[(String, String)], input: Vec<u8>) -> Vec<u8> {
    let directory = tempfile::tempdir().unwrap();
    let (source, binary) = (directory.path().join("own.c"), directory.path().join("own"));
    for (name, text) in program {
        std::fs::write(directory.path().join(name), text).unwrap();
    }
    let mut command = Command::new(compiler);
    command.args(arguments).args(FLAGS).arg(&source).arg("-o").arg(&binary).arg("-lm");
    assert!(command.status().unwrap().success(), "{command:?}");

    let mut child = Command::new(&binary).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let writer = std::thread::spawn(move || stdin.write_all(&input).unwrap());
    let mut output = Vec::new();
    child.stdout.take().unwrap().read_to_end(&mut output).unwrap();
    writer.join().unwrap();
    assert!(child.wait().unwrap().success(), "{compiler}");
    output
}

/// Random bits (xorshift): the same ones in every run.
fn random_bits() -> impl Iterator<Item = u64> {
    std::iter::successors(Some(0x9e37_79b9_7f4a_7c15_u64), |&state| {
        let state = state ^ (state << 13);
        let state = state ^ (state >> 7);
        Some(state ^ (state << 17))
    })
}

macro_rules! same_bits {
    ($module:ident, $float:ident, $scalar:expr, $number:literal, $inputs:expr) => {{
        use own::$module::{atan, cos, exp, ln, sin, tan, tanh};
        let program = program($scalar, $number);
        let inputs: Vec<$float> = $inputs.map($float::from_bits).collect();
        let bytes: Vec<u8> = inputs.iter().flat_map(|x| x.to_ne_bytes()).collect();
        for (compiler, package, arguments) in COMPILERS {
            if !tpg_testing::tool(compiler, package, "own maths in C") {
                continue;
            }
            let output = run(compiler, arguments, &program, bytes.clone());
            let (results, rest) = output.as_chunks();
            assert_eq!((results.len(), rest.len()), (7 * inputs.len(), 0), "{compiler:?}");
            for (&x, results) in inputs.iter().zip(results.chunks_exact(7)) {
                let expected = [
                    ("sin", sin(x)),
                    ("cos", cos(x)),
                    ("tan", tan(x)),
                    ("ln", ln(x)),
                    ("exp", exp(x)),
                    ("atan", atan(x)),
                    ("tanh", tanh(x)),
                ];
                for ((function, expected), &got) in expected.into_iter().zip(results) {
                    let got = $float::from_ne_bytes(got);
                    let same = got.to_bits() == expected.to_bits() || (got.is_nan() && expected.is_nan());
                    assert!(same, "{compiler:?}: {function} {x:e} is {got:e}, in Rust {expected:e}");
                }
            }
        }
    }};
}

#[test]
fn f32_has_the_bits_of_rust() {
    let limits = (0x7f7f_ff00..0x7f80_0010).chain(0..0x100);
    let strided = (0..=u32::MAX).step_by(tpg_testing::amount(19_991, 1999));
    let random = random_bits().map(|bits| (bits >> 16) as u32).take(tpg_testing::amount(100_000, 500_000));
    // Between 2⁻¹² and 2¹², where everything is in use.
    let moderate = random_bits().map(|bits| (bits as u32 & 0x807f_ffff) | ((115 + (bits >> 40) as u32 % 24) << 23));
    same_bits!(
        f32,
        f32,
        ScalarType::F32,
        "float",
        limits.chain(strided).chain(random).chain(moderate.take(tpg_testing::amount(100_000, 500_000)))
    );
}

#[test]
fn f64_has_the_bits_of_rust() {
    let count = tpg_testing::amount(200_000, 700_000);
    let limits = [0, 1, 0x000f_ffff_ffff_ffff, 0x0010_0000_0000_0000, 0x7fef_ffff_ffff_ffff, 0x7ff0_0000_0000_0000];
    let limits = limits.into_iter().flat_map(|bits: u64| [bits, bits | (1 << 63)]);
    let moderate = random_bits().map(|bits| (bits & 0x800f_ffff_ffff_ffff) | ((1009 + (bits >> 52) % 28) << 52));
    same_bits!(
        f64,
        f64,
        ScalarType::F64,
        "double",
        limits.chain(random_bits().take(count)).chain(moderate.take(count))
    );
}
