//! Evolution: genome, mutation, selection, demes, archive, and the loop over generations.

pub mod archive;
mod check_state;
pub mod checkpoint;
pub mod cma;
pub mod command;
pub mod config;
pub mod export;
pub mod generation;
pub mod genome;
pub mod linear;
pub mod logs;
pub mod milestones;
pub mod mirror;
pub mod mutate_leaf;
pub mod mutate_program;
pub mod mutate_team;
pub mod presets;
mod products;
pub mod random_search;
pub mod refine;
pub mod run;
pub mod scales;
pub mod select;
pub mod state;
mod target;
mod validate;
pub mod vocabulary;
