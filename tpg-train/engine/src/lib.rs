//! The engine: many episodes of many roots, millions of steps a second, with the interpreter's answers.
//!
//! [`Policy`] → [`Plan`] (distinct nodes, teams in order) → [`Lanes`] (episodes side by side) → [`Ending`]s;
//! [`LocalThreads`] spreads roots over threads behind the [`Evaluator`] trait. [`Single`] decides for one state at a time.

mod columns;
mod decide;
mod environment;
mod episodes;
mod evaluator;
mod history;
mod lanes;
mod nodes;
mod plan;
mod policy;
pub mod random;
mod single;

pub use columns::{BLOCK, Block};
pub use environment::{Ending, Environment, SourceSet};
pub use episodes::{Episodes, OneByOne, View};
pub use evaluator::{Answer, EvaluationError, Evaluator, LocalThreads, UnitKey, Work, WorkUnit};
pub use history::{History, Repeat};
pub use lanes::{Lanes, Options};
pub use nodes::{Arena, Node, NodeId, effective};
pub use plan::Plan;
pub use policy::{Destination, Edge, Line, Operand, Policy, bounded};
pub use single::{Single, single};
