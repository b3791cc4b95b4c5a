//! Facts supplied by the user that the code alone does not show. A bound holds only if these hold.

use std::collections::BTreeMap;

/// Maximum iterations of a function's loops: how often control reaches a loop's first instruction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Turns {
    /// Every loop.
    Every(u64),
    /// One bound for each loop, in the order of their first instructions. If the function has a different number of
    /// loops there is no bound: the code has changed since the bounds were determined.
    Each(Vec<u64>),
    /// One bound for each loop of a chain, from the outermost to the innermost. If there are loops, but others, there is no
    /// bound.
    Nested(Vec<u64>),
    /// One bound for all loops of each depth, from the outermost ones.
    Depths(Vec<u64>),
}

/// Returns the maximum iterations of the loops of GCC's own arithmetic: each decides a bit of a number or more, of 24 or 53 and three that
/// round.
pub(super) fn in_libgcc(function: &str, is_tangled: bool) -> Option<u64> {
    let is = |of_arm: &str, of_all: &str| function.starts_with(of_arm) || function.ends_with(of_all);
    match function {
        // A Cortex-M0 divides 8 bits a turn, the first time 4 or 8.
        "__udivsi3" | "__divsi3" | "__aeabi_uidiv" | "__aeabi_idiv" | "__aeabi_uidivmod" | "__aeabi_idivmod"
            if is_tangled =>
        {
            Some(4)
        }
        "__mulsi3" | "__udivsi3" | "__umodsi3" | "__divsi3" | "__modsi3" | "sqrtf" | "__ieee754_sqrtf" => Some(32),
        "__muldi3" | "__udivdi3" | "__umoddi3" | "__udivmoddi4" | "sqrt" | "__ieee754_sqrt" => Some(64),
        // An AVR's, with one turn more.
        "__udivmodhi4" => Some(17),
        "__udivmodsi4" => Some(33),
        _ if is("__aeabi_f", "sf3") => Some(27),
        _ if is("__aeabi_d", "df3") => Some(56),
        _ => None,
    }
}

/// Iterations of loops, by function.
pub type LoopBounds = BTreeMap<String, Turns>;

/// The possible targets of a function's calls through a register, by the caller.
pub type Calls = BTreeMap<String, Vec<String>>;
