//! Writing graphs in other formats than `graph.json`.

pub mod dot;
pub mod sidecar;
