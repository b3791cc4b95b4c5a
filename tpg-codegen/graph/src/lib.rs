//! Tangled program graphs as data: the model, its file formats, and the interpreter that defines what a graph decides.
//!
//! A [`Graph`] is validated once, when it is read; all other crates of the workspace rely on that and never check
//! again.
//!
//! ```
//! use tpg_graph::sample::{self, Shape};
//! use tpg_graph::{Graph, interpret, states};
//!
//! let graph = sample::graph(&Shape::default(), 7);
//! let again = Graph::from_json("graph.json", &graph.to_json())?;
//! let states = states::sample(&graph, 100, 1);
//! assert_eq!(interpret::actions(&graph, &states), interpret::actions(&again, &states));
//! # Ok::<(), tpg_graph::error::InputError>(())
//! ```
//!
//! # Map
//!
//! | module | subject |
//! | --- | --- |
//! | (root) | [`Graph`], its parts, and [`Document`], its `graph.json` form; [`Word`], what a line of a program says |
//! | [`import`] | GEGELATI's `.dot` with its sidecar |
//! | [`interpret`] | the reference interpreter |
//! | [`in_arithmetic_of`] | calls a generic function with the arithmetic that a graph names |
//! | [`conversion`] | conversion to another scalar type, and how often the actions still agree |
//! | [`dataflow`] | liveness of lines, topological order of teams |
//! | [`image`] | values that are computed from an image |
//! | [`hash_cons`] | lists in which equal nodes exist once |
//! | [`engine`] | anything that decides like a graph |
//! | [`states`], [`trace`], [`sample`] | sampled states, recorded states, random graphs |
//! | [`command`] | exit statuses of command-line programs |
//! | [`settings`] | TOML files whose errors name the line |
//! | [`error`], [`output`] | errors with file, place, found and accepted; atomic file writes |

mod arithmetic;
pub mod command;
pub mod conversion;
pub mod dataflow;
pub mod engine;
pub mod error;
pub mod files;
pub mod hash_cons;
pub mod image;
pub mod import;
pub mod interpret;
mod model;
pub mod output;
pub mod progress;
pub mod sample;
pub mod settings;
pub mod states;
pub mod trace;
mod word;

pub use model::*;
pub use word::Word;
