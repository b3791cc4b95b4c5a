//! Conditions of the preprocessor. Where a compiler's own macros choose a branch, all branches must mean the same.

use crate::input::{Missing, Result};

/// An open condition.
pub(super) struct Condition {
    /// The text is active
    pub(super) active: bool,
    /// Some branch was
    pub(super) taken: bool,
    /// The place of its beginning, if it depends on a macro that the text does not define
    pub(super) foreign: Option<String>,
    pub(super) has_else: bool,
    /// The lines of its branches
    pub(super) branches: Vec<Vec<String>>,
}

/// Pragmas that ask for what C defines: no fused operations.
pub(super) const PRAGMAS: [&str; 4] =
    [UNFUSED[0], UNFUSED[1], "#pragma fp_contract(off)", "#pragma clang fp reassociate(off)"];

/// Those that forbid GCC and other compilers to fuse.
pub(super) const UNFUSED: [&str; 2] = ["#pragma GCC optimize(\"fp-contract=off\")", "#pragma STDC FP_CONTRACT OFF"];

/// Branches that mean the same.
const ALIKE: [[&str; 2]; 4] = [
    ["extern \"C\" {", ""],
    ["}", ""],
    ["uint32_t hidden = mask;\n__asm__(\"\" : \"+r\"(hidden));\nreturn hidden;", "return mask;"],
    ["float root;\n__asm__(\"vsqrt.f32 %0, %1\" : \"=t\"(root) : \"t\"(x));\nreturn root;", "return sqrtf(x);"],
];

/// What a macro may stand for that not every compiler defines: attributes, and the tables of an AVR.
const ATTRIBUTES: [&str; 9] = [
    "",
    "static inline",
    "static inline __attribute__((always_inline))",
    "static __attribute__((noinline))",
    "PROGMEM",
    "(*(place))",
    "((int8_t)pgm_read_byte(place))",
    "((int16_t)pgm_read_word(place))",
    "((int32_t)pgm_read_dword(place))",
];

impl Condition {
    /// Checks that all branches mean the same, if the text does not say which one a compiler takes.
    pub(super) fn check(mut self) -> Result<()> {
        let Some(place) = self.foreign else { return Ok(()) };
        if !self.has_else {
            self.branches.push(Vec::new());
        }
        let quiet = |line: &String| match line.strip_prefix("#define ").map(|define| define.split_once(' ')) {
            Some(define) => ATTRIBUTES.contains(&define.map_or("", |(_, value)| value.trim())),
            None => {
                line.starts_with("#error") || line == "#include <avr/pgmspace.h>" || PRAGMAS.contains(&line.as_str())
            }
        };
        let texts: Vec<String> = self.branches.iter().map(|lines| lines.join("\n")).collect();
        if self.branches.iter().flatten().all(quiet) || ALIKE.iter().any(|alike| texts == *alike) {
            return Ok(());
        }
        Err(Missing::new(place, "a condition that depends on this text alone"))
    }
}
