//! Reasons why there is no bound.

use super::listing::Site;

/// The reason why a function has no bound, and the place: addresses are those of the listing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Refusal {
    /// The object has no such function.
    #[error("no function {name:?} in the object")]
    NoFunction {
        /// The requested name.
        name: String,
    },
    /// A called function that is not in the object: link it, or ignore the caller.
    #[error(
        "{function} at {address:#x} calls {callee}, which is not in the object: analyse a linked image{}",
        software(callee)
    )]
    NotHere {
        /// The caller.
        function: String,
        /// Address of the call.
        address: u64,
        /// The callee.
        callee: String,
    },
    /// A loop without a bound.
    #[error(
        "{name} has a loop at {address:#x}: without a bound it has no worst case; accepted: code without loops, or --loop-bound {name}=N if none of its loops iterates more than N times",
        name = .0.function,
        address = .0.address
    )]
    Loop(Site),
    /// The number of bounds differs from the number of loops.
    #[error(
        "{function} has loops at {}, and {given} bounds are given; accepted: one for each, in this order",
        places(found)
    )]
    OtherLoops {
        /// The function.
        function: String,
        /// Addresses of its loops.
        found: Vec<u64>,
        /// Number of bounds given.
        given: usize,
    },
    /// A loop with several entries, without a bound.
    #[error(
        "{name} has a loop with several entries at {address:#x}; accepted: --loop-bound {name}=N if none of its instructions is reached more than N times",
        name = .0.function,
        address = .0.address
    )]
    TangledLoop(Site),
    /// A function that calls itself, possibly through others.
    #[error("recursion: {}", functions.join(" calls "))]
    Recursion {
        /// The functions of the cycle, in the order of their calls.
        functions: Vec<String>,
    },
    /// A call or a jump to an address in a register.
    #[error(
        "{0} branches through a register to an unknown target; accepted: --calls {name}=CALLEE,… with every function that it may reach",
        name = .0.function
    )]
    Indirect(Site),
    /// A function with targets for calls through a register that it does not contain.
    #[error("{function} calls nothing through a register, so --calls {function}=… has no effect")]
    NotIndirect {
        /// The function.
        function: String,
    },
    /// A jump through a table that cannot be read.
    #[error("{0} jumps through a table that is not found: -fno-jump-tables avoids them")]
    JumpTable(Site),
    /// A stack pointer that changes by an amount known only at run time.
    #[error("{0} moves its stack pointer by an unknown amount")]
    DynamicStack(Site),
    /// A branch into the middle of another function, or to an address without an instruction; or a path past the end.
    #[error("{0} leads neither to one of its instructions nor to the start of a function")]
    Astray(Site),
}

/// Returns what makes a missing function slow.
fn software(callee: &str) -> &'static str {
    if callee.starts_with("__aeabi_d") {
        ". It computes doubles in software, which take as long as what they compute needs"
    } else {
        ""
    }
}

fn places(addresses: &[u64]) -> String {
    addresses.iter().map(|address| format!("{address:#x}")).collect::<Vec<_>>().join(", ")
}
