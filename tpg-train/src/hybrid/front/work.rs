//! The work of a decision in operations on numbers: of the graph's compiled code at most, and of the network.

use super::Kind;
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
    /// Joins the operations of a graph and of a network that decides a share of the actions, 0 to 1.
    pub fn of(kind: Kind, graph: f64, network: f64, share: f64) -> Self {
        match kind {
            Kind::Graph => Self { mean: graph, worst: graph },
            Kind::Network => Self { mean: network, worst: network },
            // The graph has decided to ask.
            Kind::Asking => Self { mean: graph + share * network, worst: graph + network },
            // The graph has not been asked where the network acts.
            Kind::Rules | Kind::Mixture => {
                Self { mean: (1.0 - share) * graph + share * network, worst: graph.max(network) }
            }
        }
    }
}

/// Returns the operations of a graph's C, profile `fast`, at most.
pub fn of_graph(graph: &Graph) -> f64 {
    let options = Options::new("work".parse().expect("an identifier"));
    Costs::of(&compile(graph, &options, Language::C)).worst().operations as f64
}

/// Returns a multiplication and an addition for each weight.
pub fn of_network(network: &Network) -> f64 {
    let weights = match network {
        Network::Float(actor) => actor.0.parameters().len(),
        Network::Fixed(policy) => policy.multiplications(),
    };
    2.0 * weights as f64
}

#[cfg(test)]
mod tests {
    use super::{Kind, Work};

    #[test]
    fn who_asks_has_decided_and_whom_rules_leave_out_has_not() {
        let of = |kind| Work::of(kind, 10.0, 100.0, 0.25);
        assert_eq!(of(Kind::Graph), Work { mean: 10.0, worst: 10.0 });
        assert_eq!(of(Kind::Asking), Work { mean: 35.0, worst: 110.0 });
        assert_eq!(of(Kind::Rules), Work { mean: 32.5, worst: 100.0 });
        assert_eq!(of(Kind::Mixture), of(Kind::Rules));
        assert_eq!(of(Kind::Network), Work { mean: 100.0, worst: 100.0 });
    }
}
