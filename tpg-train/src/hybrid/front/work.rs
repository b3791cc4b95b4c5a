//! The work of a decision in operations on numbers: of the graph's compiled code at most, and of the network.

use crate::hybrid::trial::Acting;
use crate::sac::network::Network;
use serde::{Deserialize, Serialize};
use tpg_codegen::cost::Costs;
use tpg_codegen::options::{Language, Options};
use tpg_codegen::program::compile;
use tpg_graph::Graph;

/// Operations of a decision.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Work {
    /// The mean: the graph's most where it decides, the network's in the share of the actions that it decides.
    pub mean: f64,
    /// The most of any decision.
    pub worst: f64,
}

impl Work {
    /// Counts the work of policies, the network deciding a share of the actions, 0 to 1.
    pub fn of(acting: Acting<'_>, share: f64) -> Self {
        match acting {
            Acting::Graph((_, graph)) => Self::always(of_graph(graph)),
            Acting::Network((_, network)) => Self::always(of_network(network)),
            // A graph that asks has decided so; where rules or draws call the network, it has not been asked.
            Acting::Both((_, graph), (_, network), setting) if !setting.has_trigger() => {
                let (graph, network) = (of_graph(graph), of_network(network));
                Self { mean: graph + share * network, worst: graph + network }
            }
            Acting::Both((_, graph), (_, network), _) | Acting::Mixture((_, graph), (_, network), _) => {
                let (graph, network) = (of_graph(graph), of_network(network));
                Self { mean: (1.0 - share) * graph + share * network, worst: graph.max(network) }
            }
        }
    }

    fn always(operations: f64) -> Self {
        Self { mean: operations, worst: operations }
    }
}

/// Operations of a graph's C, profile `fast`, at most.
fn of_graph(graph: &Graph) -> f64 {
    let options = Options::new("work".parse().expect("an identifier"));
    Costs::of(&compile(graph, &options, Language::C)).worst().operations as f64
}

/// A multiplication and an addition for each weight.
fn of_network(network: &Network) -> f64 {
    let weights = match network {
        Network::Float(actor) => actor.0.parameters().len(),
        Network::Fixed(policy) => policy.multiplications(),
    };
    2.0 * weights as f64
}
