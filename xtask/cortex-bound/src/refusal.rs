//! Why there is no bound.

/// Why a function has no bound, and where: addresses are those of the listing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The object has no such function.
    NoFunction {
        /// What was asked for.
        name: String,
    },
    /// A function that is called, but lies elsewhere: link it, or leave it out.
    NotHere {
        /// Who calls.
        function: String,
        /// Where.
        address: u64,
        /// What it calls.
        callee: String,
    },
    /// A loop that nobody has given a bound for.
    Loop {
        /// The function.
        function: String,
        /// Where the loop begins.
        address: u64,
    },
    /// Bounds for another number of loops than there are.
    OtherLoops {
        /// The function.
        function: String,
        /// Where its loops begin.
        found: Vec<u64>,
        /// How many bounds were given.
        given: usize,
    },
    /// A loop with several entries: no bound can be given for it.
    TangledLoop {
        /// The function.
        function: String,
        /// An instruction in it.
        address: u64,
    },
    /// A function that calls itself, perhaps by way of others.
    Recursion {
        /// The functions of the circle, in the order of their calls.
        functions: Vec<String>,
    },
    /// A call or a jump to where a register says.
    Indirect {
        /// The function.
        function: String,
        /// Where.
        address: u64,
        /// The instruction.
        text: String,
    },
    /// A function that was said to call through a register, but does not.
    NotIndirect {
        /// The function.
        function: String,
    },
    /// A jump through a table that cannot be read.
    JumpTable {
        /// The function.
        function: String,
        /// Where.
        address: u64,
        /// The instruction.
        text: String,
    },
    /// A stack pointer that moves by what only the run knows.
    DynamicStack {
        /// The function.
        function: String,
        /// Where.
        address: u64,
        /// The instruction.
        text: String,
    },
    /// A branch into the middle of another function, or to where there is no instruction; or a path past the end.
    Astray {
        /// The function.
        function: String,
        /// Where.
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
                )
            }
            Self::Loop { function, address } => write!(
                f,
                "{function} has a loop at {address:#x}: without a bound it has no worst case; accepted: straight code, or \
                 --loop-bound {function}=N where no loop of it turns more than N times"
            ),
            Self::OtherLoops { function, found, given } => {
                let places: Vec<String> = found.iter().map(|address| format!("{address:#x}")).collect();
                write!(
                    f,
                    "{function} has {} loops (at {}), bounds were given for {given}: one for each is accepted, in this \
                     order",
                    found.len(),
                    places.join(", ")
                )
            }
            Self::TangledLoop { function, address } => {
                write!(f, "{function} has a loop with several entries at {address:#x}: its turns cannot be bounded")
            }
            Self::Recursion { functions } => write!(f, "recursion: {}", functions.join(" calls ")),
            Self::Indirect { function, address, text } => {
                write!(
                    f,
                    "{function} goes where a register says at {address:#x} ({text}): where to is not known here; \
                     accepted: --calls {function}=CALLEE,… with every function that it may reach"
                )
            }
            Self::NotIndirect { function } => {
                write!(f, "{function} calls nothing through a register, so --calls {function}=… says nothing")
            }
            Self::JumpTable { function, address, text } => {
                write!(
                    f,
                    "{function} jumps through a table at {address:#x} ({text}) that does not lie behind it: \
                     -fno-jump-tables avoids them"
                )
            }
            Self::DynamicStack { function, address, text } => {
                write!(f, "{function} moves its stack pointer by what only the run knows at {address:#x} ({text})")
            }
            Self::Astray { function, address, text } => {
                write!(
                    f,
                    "{function} at {address:#x} ({text}) leads to no instruction of it and no function's beginning"
                )
            }
        }
    }
}

impl std::error::Error for Refusal {}
