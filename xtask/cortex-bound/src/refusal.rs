//! Reasons why there is no bound.

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
        "{function} has a loop at {address:#x}: without a bound it has no worst case; accepted: code without loops, or --loop-bound {function}=N if none of its loops iterates more than N times"
    )]
    Loop {
        /// The function.
        function: String,
        /// Address of the loop's first instruction.
        address: u64,
    },
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
        "{function} has a loop with several entries at {address:#x}; accepted: --loop-bound {function}=N if none of its instructions is reached more than N times"
    )]
    TangledLoop {
        /// The function.
        function: String,
        /// An instruction in it.
        address: u64,
    },
    /// A function that calls itself, possibly through others.
    #[error("recursion: {}", functions.join(" calls "))]
    Recursion {
        /// The functions of the cycle, in the order of their calls.
        functions: Vec<String>,
    },
    /// A call or a jump to an address in a register.
    #[error(
        "{function} branches through a register at {address:#x} ({text}) to an unknown target; accepted: --calls {function}=CALLEE,… with every function that it may reach"
    )]
    Indirect {
        /// The function.
        function: String,
        /// Its address.
        address: u64,
        /// The instruction.
        text: String,
    },
    /// A function with targets for calls through a register that it does not contain.
    #[error("{function} calls nothing through a register, so --calls {function}=… has no effect")]
    NotIndirect {
        /// The function.
        function: String,
    },
    /// A jump through a table that cannot be read.
    #[error(
        "{function} jumps through a table at {address:#x} ({text}) that is not found: -fno-jump-tables avoids them"
    )]
    JumpTable {
        /// The function.
        function: String,
        /// Its address.
        address: u64,
        /// The instruction.
        text: String,
    },
    /// A stack pointer that changes by an amount known only at run time.
    #[error("{function} moves its stack pointer by an unknown amount at {address:#x} ({text})")]
    DynamicStack {
        /// The function.
        function: String,
        /// Its address.
        address: u64,
        /// The instruction.
        text: String,
    },
    /// A branch into the middle of another function, or to an address without an instruction; or a path past the end.
    #[error(
        "{function} at {address:#x} ({text}) leads neither to one of its instructions nor to the start of a function"
    )]
    Astray {
        /// The function.
        function: String,
        /// Its address.
        address: u64,
        /// The instruction.
        text: String,
    },
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
