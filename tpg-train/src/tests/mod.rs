//! Tests of several modules together.

mod engine;
mod import_actor;
mod manual;
mod ranks;
