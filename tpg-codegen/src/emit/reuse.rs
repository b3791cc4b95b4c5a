//! Values that a team has computed, which its later bids reuse.

use crate::ir::{Node, NodeId, needed};
use std::collections::BTreeSet;

/// Prints a team's bids one after another.
pub(super) trait Reuse: Sized {
    /// The values that are computed so far.
    fn computed(&mut self) -> &mut BTreeSet<NodeId>;

    /// Prints code in braces: the values it computes cannot be reused behind them.
    fn in_braces<T>(&mut self, print: impl FnOnce(&mut Self) -> T) -> T {
        let outside = self.computed().clone();
        let printed = print(self);
        *self.computed() = outside;
        printed
    }

    /// The operations that are still needed for a value; later bids reuse them where they stay in scope.
    fn missing(&mut self, nodes: &[Node], value: NodeId, stays: bool) -> Vec<NodeId> {
        let computed = self.computed();
        let missing = needed(nodes, value, |id| !computed.contains(&id));
        if stays {
            computed.extend(&missing);
        }
        missing
    }
}
