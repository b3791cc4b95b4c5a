//! Hash-consing: equal nodes exist once.

use std::collections::HashMap;
use std::hash::Hash;

/// A growing list of nodes in which equal ones are merged. A node is found by its key, by default the node itself; a type
/// whose equality is not an equivalence, such as a floating-point number, needs another key.
///
/// ```
/// use tpg_graph::hash_cons::HashCons;
///
/// let mut nodes = HashCons::<&str>::default();
/// assert_eq!([nodes.intern("a"), nodes.intern("b"), nodes.intern("a")], [0, 1, 0]);
/// assert_eq!(nodes.nodes(), ["a", "b"]);
/// ```
#[derive(Clone, Debug)]
pub struct HashCons<N, K = N> {
    nodes: Vec<N>,
    /// Used for look-ups only and never iterated, so its order has no effect.
    known: HashMap<K, u32>,
}

impl<N, K> Default for HashCons<N, K> {
    fn default() -> Self {
        Self { nodes: Vec::new(), known: HashMap::new() }
    }
}

impl<N: Clone + Eq + Hash> HashCons<N> {
    /// Returns the index of a node, which is added if it is new.
    pub fn intern(&mut self, node: N) -> u32 {
        self.intern_by(node.clone(), node)
    }
}

impl<N, K: Eq + Hash> HashCons<N, K> {
    /// Returns the index of the node with a key; `node` is added if there is none.
    pub fn intern_by(&mut self, key: K, node: N) -> u32 {
        let next = self.next();
        let index = *self.known.entry(key).or_insert(next);
        if index == next {
            self.nodes.push(node);
        }
        index
    }

    /// Adds a node that is never merged, and returns its index.
    pub fn push(&mut self, node: N) -> u32 {
        let next = self.next();
        self.nodes.push(node);
        next
    }

    /// Returns the nodes in the order in which they were added.
    pub fn nodes(&self) -> &[N] {
        &self.nodes
    }

    /// Returns the nodes in the order in which they were added.
    pub fn into_nodes(self) -> Vec<N> {
        self.nodes
    }

    fn next(&self) -> u32 {
        u32::try_from(self.nodes.len()).expect("fewer than 2³² nodes")
    }
}

impl<N: Clone + Eq + Hash> FromIterator<N> for HashCons<N> {
    fn from_iter<I: IntoIterator<Item = N>>(nodes: I) -> Self {
        let mut interned = Self::default();
        nodes.into_iter().for_each(|node| {
            interned.intern(node);
        });
        interned
    }
}
