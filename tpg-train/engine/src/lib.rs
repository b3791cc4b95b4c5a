//! The engine: parallel episodes of many roots, millions of steps per second, with the same results as the interpreter.
//!
//! [`PolicyGraph`]s → [`Plan`] (distinct nodes, teams in topological order) → [`Lanes`] (parallel episodes) → [`EpisodeResult`]s;
//! [`LocalThreads`] distributes roots over threads behind the [`Evaluator`] trait. [`Single`] decides for one state at
//! a time. Problems implement [`Environment`].
//!
//! # Map
//!
//! | items | subject |
//! | --- | --- |
//! | [`Environment`], [`ActionSpace`], [`Act`], [`Step`], [`End`] | a problem |
//! | [`erase`], [`AnyEnvironment`] | environments whose type is only known at run time |
//! | [`Training`], [`Guarded`], [`tasks`] | what only some environments have |
//! | [`Rollout`], [`Decision`] | one episode, action by action |
//! | [`bind`] | binding of a graph to an environment's sources and actions |
//! | [`Choices`] | any action space as a list of named actions |
//! | [`Remembering`] | a memory for policies, and counts for graphs in integers |
//! | [`Units`] | counts in place of values |
//! | [`Episodes`], [`OneByOne`], [`Mapped`], [`View`], [`SourceSet`] | parallel episodes |
//! | [`EpisodeResult`], [`Summary`], [`Preference`] | results |
//! | [`PolicyGraph`], [`Plan`], [`Node`], [`Arena`] | a graph in the engine's own form |
//! | [`Lanes`], [`Single`] | execution |
//! | [`Evaluator`], [`LocalThreads`], [`Work`], [`Piece`], [`Play`], [`Moments`], [`Sample`], [`quantile`] | evaluation of many roots, on threads or elsewhere |
//! | [`forward`](crate::forward!) | environments that wrap another one |
//! | [`random`] | independent streams of random numbers, one for each purpose |

mod action;
mod binding;
mod choices;
mod columns;
mod decide;
mod environment;
mod episode_result;
mod episodes;
mod erased;
mod error;
mod evaluator;
mod extensions;
mod forward;
mod groups;
mod history;
#[cfg(all(debug_assertions, not(test)))]
mod instances;
mod lanes;
mod mapped;
mod moments;
mod nodes;
mod parts;
mod plan;
mod policy;
pub mod random;
mod remembering;
mod rollout;
mod single;
mod source_set;
mod tasks;
mod units;
mod view;
mod work;

pub use action::{Act, ActionSpace, Acts, Output};
pub use binding::{bind, places, reading};
pub use choices::Choices;
pub use environment::{Environment, OneByOne};
pub use episode_result::{End, EpisodeResult, Measure, Preference, Step, Summary, finite};
pub use episodes::Episodes;
pub use erased::{AnyEnvironment, AnyEpisode, AnyTask, erase};
pub use error::EvaluationError;
pub use evaluator::{Evaluator, LocalThreads};
pub use extensions::{Guarded, TaskSet, Training};
pub use lanes::{DEFAULT_LANES, Lanes};
pub use mapped::Mapped;
pub use moments::{Moments, Sample, confidence, quantile};
pub use nodes::{Arena, Node};
pub use plan::Plan;
pub use policy::{Destination, Edge, Limits, Line, Operand, PolicyGraph};
pub use remembering::{Remembering, remembered};
pub use rollout::{Decision, Rollout};
pub use single::Single;
pub use source_set::{SourceSet, state_length};
pub use tasks::{coarser, tasks};
pub use tpg_graph::SourceDocument;
pub use units::Units;
pub use view::{BLOCK, Block, View};
pub use work::{Piece, Play, Played, Work};
