//! The graph: a policy with everything that determines its behaviour.
//!
//! A [`Graph`] is validated once, when it is built from a [`Document`]. After that every id is a valid index, every
//! register and input is in range, and the teams form an acyclic graph with one root. Passes and emitters never check
//! again.

mod asking;
mod counts;
mod document;
mod effect;
pub(crate) mod graph;
mod name;
mod parts;
mod read;
mod schema;
mod text;
mod validate;
mod write;

pub use counts::Counts;
pub use document::{
    ActionDocument, Document, EdgeDocument, FORMAT, LeafDocument, LineDocument, MathsProvider, MemoryDocument,
    OperandDocument, OutputDocument, ProgramDocument, Provenance, ScalarType, SourceDocument, TeamDocument, VERSIONS,
};

/// Their short names in a [`Graph`].
pub use document::{ActionDocument as Action, SourceDocument as Source};
pub use effect::Effect;
pub use graph::{
    Destination, Edge, Graph, Input, Leaf, Line, Operand, Output, Program, ProgramId, Range, Reg, Team, TeamId,
};
pub use schema::schema;
pub use validate::MAX_NUMBERED;

pub use tpg_runtime::policy::ActionId;
