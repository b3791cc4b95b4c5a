//! Export of graphs to formats other than `graph.json`.

pub mod dot;
pub mod sidecar;
