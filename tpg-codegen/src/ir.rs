//! The lowered graph that passes rewrite and emitters print.
//!
//! Programs become values: running a program's lines on symbols leaves in register 0 a [`Node`] that stands for the bid.
//! Lines that do not reach register 0 (introns, 80 % of an evolved program) leave no trace, and equal expressions are one
//! node, whichever program computes them. Nothing is folded or reassociated here: every node is an operation that the
//! interpreter does too, on the same operands.

use std::collections::{BTreeMap, BTreeSet};
use tpg_graph::dataflow::{depth_first, effective};
use tpg_graph::hash_cons::HashCons;
use tpg_graph::{Destination, Graph, Input, Operand, Program};
use tpg_runtime::ops::Instruction;
use tpg_runtime::policy::ActionId;

/// The place of a node in [`Module::nodes`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct NodeId(pub(crate) u32);

impl NodeId {
    /// The index in [`Module::nodes`].
    pub(crate) fn index(self) -> usize {
        self.0 as usize
    }
}

/// A value that programs compute.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) enum Node {
    /// A number, by the bits of its `f64`: 0 and −0 are different constants.
    Constant(u64),
    /// A value of the state.
    Input(Input),
    /// An operation on earlier nodes; the second operand of a one-operand instruction repeats the first.
    Operation(Instruction, [NodeId; 2]),
    /// Not below a logarithm or an exponential of an earlier node, and cheap: see [`passes::bound`](crate::passes::bound).
    Upper(Instruction, NodeId),
}

impl Node {
    /// The node of a number.
    pub(crate) fn constant(value: f64) -> Self {
        Self::Constant(value.to_bits())
    }

    /// The nodes that must be computed before.
    pub(crate) fn operands(&self) -> &[NodeId] {
        match self {
            Self::Constant(_) | Self::Input(_) => &[],
            Self::Operation(instruction, operands) => &operands[..instruction.arity()],
            Self::Upper(_, value) => std::slice::from_ref(value),
        }
    }

    /// Tests for a computed value: neither a constant nor an input.
    pub(crate) fn is_computed(&self) -> bool {
        matches!(self, Self::Operation(..) | Self::Upper(..))
    }

    /// Tests for a sine, cosine, tangent, logarithm or exponential.
    pub(crate) fn is_transcendental(&self) -> bool {
        matches!(self, Self::Operation(instruction, _) if instruction.is_transcendental())
    }

    /// The number of a constant.
    pub(crate) fn as_constant(self) -> Option<f64> {
        if let Self::Constant(bits) = self { Some(f64::from_bits(bits)) } else { None }
    }
}

/// A bidder of the lowered graph.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Bidder {
    /// The program's id in the source file.
    pub label: u32,
    /// The value of the bid.
    pub value: NodeId,
}

/// An edge of the lowered graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Edge {
    /// The place of the bidder in [`Module::bidders`].
    pub bidder: usize,
    /// The destination.
    pub to: Successor,
}

/// The destination of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) enum Successor {
    /// To the team at this place of [`Module::teams`].
    Team(usize),
    /// To an action, or to the leaf at this place of [`Module::leaves`].
    Action(ActionId),
}

/// A leaf of the lowered graph.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Leaf {
    /// Its id in the source file.
    pub label: u32,
    /// The value of each output before it is limited; a constant is within its output's range. Empty for a leaf that no
    /// walk ends at any more.
    pub values: Vec<NodeId>,
}

/// A team of the lowered graph.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Team {
    /// Its id in the source file.
    pub label: u32,
    /// Its edges, in the order that decides ties.
    pub edges: Vec<Edge>,
}

/// A lowered graph.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Module<'g> {
    /// The graph: its scalar type and maths, its sources and actions stay what they are.
    pub graph: &'g Graph,
    /// Every value once, operands before operations.
    pub nodes: Vec<Node>,
    /// The programs, in the order the teams first use them.
    pub bidders: Vec<Bidder>,
    /// The teams, breadth first from the root, which is the first.
    pub teams: Vec<Team>,
    /// The leaves, by the graph's numbers; empty for a policy without outputs.
    pub leaves: Vec<Leaf>,
    /// Teams on the longest walk: no walk decides more often.
    pub depth: usize,
}

impl<'g> Module<'g> {
    /// Lowers a graph.
    pub(crate) fn lower(graph: &'g Graph) -> Self {
        ModuleBuilder::new(graph).module()
    }

    #[cfg(test)]
    pub(crate) fn empty(graph: &'g Graph) -> Self {
        Self { graph, nodes: Vec::new(), bidders: Vec::new(), teams: Vec::new(), leaves: Vec::new(), depth: 0 }
    }

    /// A node.
    pub(crate) fn node(&self, id: NodeId) -> Node {
        self.nodes[id.index()]
    }

    /// The node of a number, added if there is none.
    pub(crate) fn constant(&mut self, value: f64) -> NodeId {
        let mut values = Values::new(std::mem::take(&mut self.nodes));
        let id = values.intern(Node::constant(value));
        self.nodes = values.into_nodes();
        id
    }

    /// The vertex of a target: teams are numbered from 0, the root, and the actions or leaves follow them.
    pub(crate) fn vertex(&self, target: Successor) -> usize {
        match target {
            Successor::Team(team) => team,
            Successor::Action(action) => self.teams.len() + usize::from(action.0),
        }
    }

    /// The number of vertices.
    pub(crate) fn vertices(&self) -> usize {
        self.teams.len() + self.graph.ends()
    }

    /// The leaf that every walk ends at, if there is one and nothing to decide.
    pub(crate) fn only_leaf(&self) -> Option<&Leaf> {
        match &*reached(&self.leaves).collect::<Vec<_>>() {
            [(_, leaf)] if self.teams.len() == 1 => Some(leaf),
            _ => None,
        }
    }

    /// The bids of the teams that have something to decide.
    pub(crate) fn deciding_bids(&self) -> BTreeSet<NodeId> {
        let deciding = self.teams.iter().filter(|team| team.edges.len() > 1);
        deciding.flat_map(|team| &team.edges).map(|edge| self.bidders[edge.bidder].value).collect()
    }

    /// The values of bids and outputs.
    pub(crate) fn roots_mut(&mut self) -> impl Iterator<Item = &mut NodeId> {
        let bids = self.bidders.iter_mut().map(|bidder| &mut bidder.value);
        bids.chain(self.leaves.iter_mut().flat_map(|leaf| &mut leaf.values))
    }

    /// The number of edges of all teams.
    pub(crate) fn edges(&self) -> usize {
        self.teams.iter().map(|team| team.edges.len()).sum()
    }

    /// The operations that `value` needs, operands before operations.
    pub(crate) fn operations_of(&self, value: NodeId) -> Vec<NodeId> {
        needed(&self.nodes, value, |_| true)
    }
}

/// The leaves that walks end at, with their numbers.
pub(crate) fn reached(leaves: &[Leaf]) -> impl Iterator<Item = (usize, &Leaf)> {
    leaves.iter().enumerate().filter(|(_, leaf)| !leaf.values.is_empty())
}

/// The operations needed for `value`, operands before operations; nodes that are not `missing` are not visited.
pub(crate) fn needed(nodes: &[Node], value: NodeId, missing: impl Fn(NodeId) -> bool) -> Vec<NodeId> {
    let mut found = BTreeSet::new();
    let mut open = vec![value];
    while let Some(id) = open.pop() {
        let node = &nodes[id.index()];
        if node.is_computed() && missing(id) && found.insert(id) {
            open.extend(node.operands());
        }
    }
    found.into_iter().collect()
}

struct ModuleBuilder<'g> {
    graph: &'g Graph,
    values: Values,
}

impl<'g> ModuleBuilder<'g> {
    fn new(graph: &'g Graph) -> Self {
        Self { graph, values: Values::default() }
    }

    fn module(mut self) -> Module<'g> {
        let edge = |edge: &tpg_graph::Edge| {
            let to = match edge.to {
                Destination::Team(team) => Successor::Team(team.index()),
                Destination::Action(action) => Successor::Action(action),
            };
            Edge { bidder: edge.program.index(), to }
        };
        let team = |team: &tpg_graph::Team| Team { label: team.label, edges: team.edges.iter().map(edge).collect() };
        let teams: Vec<Team> = self.graph.teams().iter().map(team).collect();
        let (teams, programs) = breadth_first(&teams, self.graph.root().index());
        let bidder = |program: usize| {
            let program = &self.graph.programs()[program];
            Bidder { label: program.label, value: self.value(program) }
        };
        let bidders = programs.into_iter().map(bidder).collect();
        let depth = longest_walk(&teams);
        let leaves = (self.graph.leaves().iter())
            .map(|leaf| Leaf {
                label: leaf.label,
                values: leaf.programs.iter().map(|&id| self.value(self.graph.program(id))).collect(),
            })
            .collect();
        Module { graph: self.graph, nodes: self.values.into_nodes(), bidders, teams, leaves, depth }
    }

    /// Runs the lines that matter on symbols and returns what register 0 holds.
    fn value(&mut self, program: &Program) -> NodeId {
        let effective = effective(self.graph.registers().into(), &program.lines);
        let zero = Node::constant(0.0);
        let mut registers = vec![None; usize::from(self.graph.registers())];
        for (line, _) in program.lines.iter().zip(effective).filter(|(_, effective)| *effective) {
            let operands = line.operands.map(|operand| match operand {
                Operand::Register(register) => registers[register.index()].unwrap_or_else(|| self.intern(zero)),
                Operand::Input(input) => self.intern(Node::Input(input)),
                Operand::Constant(value) => self.intern(Node::constant(value)),
            });
            let to = match registers[line.to.index()] {
                Some(value) => value,
                None if line.instruction.reads_destination() => self.intern(zero),
                None => operands[0], // not read
            };
            let apply = |instruction, operands| self.intern(Node::Operation(instruction, operands));
            registers[line.to.index()] = Some(line.instruction.compose(to, operands, apply));
        }
        registers[0].unwrap_or_else(|| self.intern(zero))
    }

    fn intern(&mut self, node: Node) -> NodeId {
        self.values.intern(node)
    }
}

/// Nodes under construction: each is made once (hash-consing), so that equal expressions have equal ids. That is value
/// numbering over the whole graph: a node names what is computed, not where.
#[derive(Clone, Debug, Default)]
pub(crate) struct Values {
    nodes: HashCons<Node>,
}

impl Values {
    /// The nodes of a module, to be added to.
    pub(crate) fn new(nodes: Vec<Node>) -> Self {
        Self { nodes: nodes.into_iter().collect() }
    }

    /// The id of a node, whose operands have been interned.
    pub(crate) fn intern(&mut self, node: Node) -> NodeId {
        NodeId(self.nodes.intern(node))
    }

    /// The node of an id.
    pub(crate) fn node(&self, id: NodeId) -> Node {
        self.nodes()[id.index()]
    }

    /// All nodes, operands before operations.
    pub(crate) fn nodes(&self) -> &[Node] {
        self.nodes.nodes()
    }

    /// All nodes, operands before operations.
    pub(crate) fn into_nodes(self) -> Vec<Node> {
        self.nodes.into_nodes()
    }
}

/// The teams that a root leads to, breadth first and numbered in this order, and the bidders that they use, by first use. Edges have
/// the new numbers of both.
pub(crate) fn breadth_first(teams: &[Team], root: usize) -> (Vec<Team>, Vec<usize>) {
    let mut order = vec![root];
    let mut place = BTreeMap::from([(root, 0)]);
    let (mut bidders, mut bidder_place) = (Vec::new(), BTreeMap::new());
    let mut reached = Vec::new();
    while let Some(&index) = order.get(reached.len()) {
        let mut team = teams[index].clone();
        for edge in &mut team.edges {
            if let Successor::Team(to) = &mut edge.to {
                *to = *place.entry(*to).or_insert_with_key(|to| {
                    order.push(*to);
                    order.len() - 1
                });
            }
            edge.bidder = *bidder_place.entry(edge.bidder).or_insert_with_key(|bidder| {
                bidders.push(*bidder);
                bidders.len() - 1
            });
        }
        reached.push(team);
    }
    (reached, bidders)
}

/// The teams that an edge at a place leads to, as [`depth_first`] asks for them.
fn target(teams: &[Team], team: usize, place: usize) -> Option<Option<usize>> {
    let target = |edge: &Edge| if let Successor::Team(to) = edge.to { Some(to) } else { None };
    teams[team].edges.get(place).map(target)
}

/// The teams in reverse topological order: successors first, otherwise as edges lead to them.
pub(crate) fn ends_first(teams: &[Team]) -> Vec<usize> {
    let order = depth_first(teams.len(), 0..teams.len(), |team, place| target(teams, team, place));
    order.expect("a graph without cycles").into_iter().rev().collect()
}

/// The teams, all reachable from the first, in the topological order in which their code stands. Of the teams whose predecessors
/// are all there, the one reached last comes next: a team stands close behind its last predecessor, which a
/// [depth-first order](depth_first) does not grant.
pub(crate) fn topological(teams: &[Team]) -> Vec<usize> {
    let targets = |team: usize| (0..).map_while(move |place| target(teams, team, place)).flatten();
    let mut entering = vec![0_usize; teams.len()];
    for to in (0..teams.len()).flat_map(targets) {
        entering[to] += 1;
    }
    let mut order = Vec::with_capacity(teams.len());
    let mut ready = vec![0];
    while let Some(team) = ready.pop() {
        order.push(team);
        for to in targets(team) {
            entering[to] -= 1;
            if entering[to] == 0 {
                ready.push(to);
            }
        }
    }
    order
}

/// Number of teams on the longest walk from the first.
pub(crate) fn longest_walk(teams: &[Team]) -> usize {
    heaviest_walk(teams, |_| 1) as usize
}

/// The greatest sum of weights of the teams on a walk from the first.
pub(crate) fn heaviest_walk(teams: &[Team], weight: impl Fn(usize) -> u64) -> u64 {
    let mut walk: Vec<u64> = (0..teams.len()).map(&weight).collect();
    for team in topological(teams) {
        for edge in &teams[team].edges {
            if let Successor::Team(to) = edge.to {
                walk[to] = walk[to].max(walk[team] + weight(to));
            }
        }
    }
    walk.into_iter().max().unwrap_or(0)
}
