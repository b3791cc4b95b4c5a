//! Reasons why there is no bound.

/// The reason why a function has no bound, and the place: addresses are those of the listing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The object has no such function.
    NoFunction {
        /// The requested name.
        name: String,
    },
    /// A called function that is not in the object: link it, or ignore the caller.
    NotHere {
        /// The caller.
        function: String,
        /// Address of the call.
        address: u64,
        /// The callee.
        callee: String,
    },
    /// A loop without a bound.
    Loop {
        /// The function.
        function: String,
        /// Address of the loop's first instruction.
        address: u64,
    },
    /// The number of bounds differs from the number of loops.
    OtherLoops {
        /// The function.
        function: String,
        /// Addresses of its loops.
        found: Vec<u64>,
        /// Number of bounds given.
        given: usize,
    },
    /// A loop with several entries, without a bound.
    TangledLoop {
        /// The function.
        function: String,
        /// An instruction in it.
        address: u64,
    },
    /// A function that calls itself, possibly through others.
    Recursion {
        /// The functions of the cycle, in the order of their calls.
        functions: Vec<String>,
    },
    /// A call or a jump to an address in a register.
    Indirect {
        /// The function.
        function: String,
        /// Its address.
        address: u64,
        /// The instruction.
        text: String,
    },
    /// A function with targets for calls through a register that it does not contain.
    NotIndirect {
        /// The function.
        function: String,
    },
    /// A jump through a table that cannot be read.
    JumpTable {
        /// The function.
        function: String,
        /// Its address.
        address: u64,
        /// The instruction.
        text: String,
    },
    /// A stack pointer that changes by an amount known only at run time.
    DynamicStack {
        /// The function.
        function: String,
        /// Its address.
        address: u64,
        /// The instruction.
        text: String,
    },
    /// A branch into the middle of another function, or to an address without an instruction; or a path past the end.
    Astray {
        /// The function.
        function: String,
        /// Its address.
        address: u64,
        /// The instruction.
        text: String,
    },
}

impl std::fmt::Display for Refusal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::NoFunction { name } => write!(f, "no function {name:?} in the object"),
            Self::NotHere { function, address, callee } => {
                write!(
                    f,
                    "{function} at {address:#x} calls {callee}, which is not in the object: analyse a linked image"
                )?;
                if callee.starts_with("__aeabi_d") {
                    write!(f, ". It computes doubles in software, which take as long as what they compute needs")?;
                }
                Ok(())
            }
            Self::Loop { function, address } => write!(
                f,
                "{function} has a loop at {address:#x}: without a bound it has no worst case; accepted: code without \
                 loops, or --loop-bound {function}=N if none of its loops iterates more than N times"
            ),
            Self::OtherLoops { function, found, given } => {
                let places: Vec<String> = found.iter().map(|address| format!("{address:#x}")).collect();
                write!(
                    f,
                    "{function} has {} loops (at {}), but {given} bounds were given: accepted is one for each, in this \
                     order",
                    found.len(),
                    places.join(", ")
                )
            }
            Self::TangledLoop { function, address } => {
                write!(
                    f,
                    "{function} has a loop with several entries at {address:#x}; accepted: --loop-bound {function}=N if \
                     none of its instructions is reached more than N times"
                )
            }
            Self::Recursion { functions } => write!(f, "recursion: {}", functions.join(" calls ")),
            Self::Indirect { function, address, text } => {
                write!(
                    f,
                    "{function} branches through a register at {address:#x} ({text}) to an unknown target; \
                     accepted: --calls {function}=CALLEE,… with every function that it may reach"
                )
            }
            Self::NotIndirect { function } => {
                write!(f, "{function} calls nothing through a register, so --calls {function}=… has no effect")
            }
            Self::JumpTable { function, address, text } => {
                write!(
                    f,
                    "{function} jumps through a table at {address:#x} ({text}) that is not found: -fno-jump-tables avoids them"
                )
            }
            Self::DynamicStack { function, address, text } => {
                write!(f, "{function} moves its stack pointer by an unknown amount at {address:#x} ({text})")
            }
            Self::Astray { function, address, text } => {
                write!(
                    f,
                    "{function} at {address:#x} ({text}) leads neither to one of its instructions nor to the start of \
                     a function"
                )
            }
        }
    }
}

impl std::error::Error for Refusal {}
