//! Upper bounds on expensive values, computed from cheap ones while the policy runs.
//!
//! `a − c·sin(b)` is at most `a + |c|`: one addition tells whether the sine can matter. A bound holds for every state:
//! rounding to nearest is monotone, so whatever is put in place of an operand that is not below it gives a result that is
//! not below; and bounds are written so that a NaN in them comes out of them. A bound that is NaN says nothing, and a
//! value that is NaN needs no bound, for it bids −∞.

use super::arithmetic::Arithmetic;
use super::estimate;
use super::fold;
use super::interval::Interval;
use crate::ir::{Node, NodeId, Values};
use Instruction::*;
use UpperBound::*;
use tpg_graph::ScalarType;
use tpg_runtime::ops::Instruction;

/// A bound on a value by cheap nodes, valid wherever these are not NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
enum UpperBound {
    /// The value itself is cheap.
    Exact(NodeId),
    /// Its magnitude is at most this.
    Magnitude(NodeId),
    /// The value is between these; `None` is unbounded.
    Between(Option<NodeId>, Option<NodeId>),
}

const UNKNOWN: UpperBound = Between(None, None);

/// Makes bounds of a module's values.
pub(super) struct Bounds<'a> {
    arithmetic: Arithmetic,
    /// The intervals of the module's nodes without any assumption about the inputs.
    intervals: &'a [Interval],
    /// Flags for the module's cheap nodes.
    cheap: &'a [bool],
    values: &'a mut Values,
    /// Logarithms and exponentials of what the policy computes are estimated.
    estimates: bool,
    /// The bounds of the module's nodes computed so far.
    known: Vec<Option<UpperBound>>,
}

impl<'a> Bounds<'a> {
    /// Bounds of the nodes in `values`; the bounds' own nodes are added to it.
    pub(super) fn new(
        arithmetic: Arithmetic,
        intervals: &'a [Interval],
        cheap: &'a [bool],
        values: &'a mut Values,
        estimates: bool,
    ) -> Self {
        let known = vec![None; values.nodes().len()];
        Self { arithmetic, intervals, cheap, values, estimates, known }
    }

    /// An upper bound of a node, if there is a finite one.
    pub(super) fn upper(&mut self, id: NodeId) -> Option<NodeId> {
        let bound = self.bound(id);
        self.high(bound).filter(|&high| self.values.node(high) != Node::constant(f64::INFINITY))
    }

    /// The bound of a node, operands first: expressions can be deeper than the stack.
    fn bound(&mut self, id: NodeId) -> UpperBound {
        let mut open = vec![id];
        while let Some(&id) = open.last() {
            if self.known[id.index()].is_some() {
                open.pop();
                continue;
            }
            let node = self.values.node(id);
            let cheap = self.cheap[id.index()];
            let missing = |operand: &&NodeId| self.known[operand.index()].is_none();
            if !cheap && let Some(&operand) = node.operands().iter().find(missing) {
                open.push(operand);
                continue;
            }
            let bound = if cheap { Exact(id) } else { self.operation(node) };
            self.known[id.index()] = Some(self.at_least_static(id, bound));
            open.pop();
        }
        self.known[id.index()].unwrap_or(UNKNOWN)
    }

    /// Falls back on what holds for every state.
    fn at_least_static(&mut self, id: NodeId, bound: UpperBound) -> UpperBound {
        let Interval { low, high, .. } = self.intervals[id.index()];
        let mut number = |end: f64| end.is_finite().then(|| self.values.intern(Node::constant(end)));
        match bound {
            Between(known_low, known_high) => {
                Between(known_low.or_else(|| number(low)), known_high.or_else(|| number(high)))
            }
            Exact(_) | Magnitude(_) => bound,
        }
    }

    fn operation(&mut self, node: Node) -> UpperBound {
        let Node::Operation(instruction, ids) = node else {
            return UNKNOWN;
        };
        let [a, b] = ids.map(|id| self.known[id.index()].unwrap_or(UNKNOWN));
        if let (Add | Sub, Magnitude(a), Magnitude(b)) = (instruction, a, b) {
            return Magnitude(self.make(Add, a, b));
        }
        match instruction {
            Add => {
                let high = self.both(Add, Self::high, a, Self::high, b);
                let low = match (a, b) {
                    (a, Magnitude(b)) => self.low(a).map(|a| self.make(Sub, a, b)),
                    (Magnitude(a), b) => self.low(b).map(|b| self.make(Sub, b, a)),
                    (a, b) => self.both(Add, Self::low, a, Self::low, b),
                };
                Between(low, high)
            }
            Sub => match (a, b) {
                (a, Magnitude(b)) => {
                    let high = self.high(a).map(|a| self.make(Add, a, b));
                    let low = self.low(a).map(|a| self.make(Sub, a, b));
                    Between(low, high)
                }
                (a, b) => {
                    let high = self.both(Sub, Self::high, a, Self::low, b);
                    // The lower end of a magnitude is its negative, which has no node: leave it.
                    let low =
                        if matches!(a, Magnitude(_)) { None } else { self.both(Sub, Self::low, a, Self::high, b) };
                    Between(low, high)
                }
            },
            Mul => match (self.magnitude(a), self.magnitude(b)) {
                (Some(a), Some(b)) => Magnitude(self.make(Mul, a, b)),
                _ => UNKNOWN,
            },
            Div => {
                let divisor = match b {
                    Exact(b) => Some(self.abs(b)),
                    Magnitude(_) | Between(..) => self.least_magnitude(ids[1]),
                };
                match (self.magnitude(a), divisor) {
                    (Some(a), Some(b)) => Magnitude(self.make(Div, a, b)),
                    _ => UNKNOWN,
                }
            }
            Tan | Quotient | Sqrt | Atan | Tanh => UNKNOWN,
            // Not farther from 0 than the first operand.
            NegateIfLess | Abs | Fmod | Gate => self.magnitude(a).map_or(UNKNOWN, Magnitude),
            Cos | Sin => Magnitude(self.values.intern(Node::constant(1.0))),
            Ln => {
                let high = self.function(Ln, a);
                // The estimate is near only where its argument is the logarithm's own.
                let low = high.filter(|_| matches!(a, Exact(_))).map(|high| {
                    let less = self.values.intern(Node::constant(estimate::LN_LESS));
                    self.make(Sub, high, less)
                });
                Between(low, high)
            }
            Exp => {
                let zero = self.values.intern(Node::constant(0.0));
                Between(Some(zero), self.function(Exp, a))
            }
            // Never above the second operand, NaN or not.
            Min => Between(None, self.high(b)),
            // Of a NaN, it is the second; of numbers, one of both: the sum of their magnitudes is not below either, and NaN
            // where one of them is.
            Max => match (self.magnitude(a), self.magnitude(b)) {
                (Some(a), Some(b)) => Magnitude(self.make(Add, a, b)),
                _ => UNKNOWN,
            },
        }
    }

    /// An estimate at the argument's bound. `None` if that is constant: interval analysis has a tighter result.
    fn function(&mut self, instruction: Instruction, argument: UpperBound) -> Option<NodeId> {
        let argument = self.high(argument)?;
        let known = self.values.node(argument).as_constant().is_some();
        (!known && self.estimates).then(|| self.values.intern(Node::Upper(instruction, argument)))
    }

    fn both(
        &mut self,
        instruction: Instruction,
        end_of_a: fn(&mut Self, UpperBound) -> Option<NodeId>,
        a: UpperBound,
        end_of_b: fn(&mut Self, UpperBound) -> Option<NodeId>,
        b: UpperBound,
    ) -> Option<NodeId> {
        let a = end_of_a(self, a)?;
        let b = end_of_b(self, b)?;
        Some(self.make(instruction, a, b))
    }

    fn high(&mut self, bound: UpperBound) -> Option<NodeId> {
        match bound {
            Exact(id) | Magnitude(id) => Some(id),
            Between(_, high) => high,
        }
    }

    /// The lower end, where it has a node: −m has none unless m is a number.
    fn low(&mut self, bound: UpperBound) -> Option<NodeId> {
        match bound {
            Exact(id) => Some(id),
            Magnitude(id) => {
                let number = self.values.node(id).as_constant()?;
                Some(self.values.intern(Node::constant(-number)))
            }
            Between(low, _) => low,
        }
    }

    /// A node that the magnitude is not above.
    fn magnitude(&mut self, bound: UpperBound) -> Option<NodeId> {
        match bound {
            Exact(id) => Some(self.abs(id)),
            Magnitude(id) => Some(id),
            Between(low, high) => {
                let (low, high) = (low?, high?);
                if self.values.node(low).as_constant().is_some_and(|low| low >= 0.0) {
                    return Some(high);
                }
                // Not the greater of both, which could swallow a NaN.
                let (low, high) = (self.abs(low), self.abs(high));
                Some(self.make(Add, low, high))
            }
        }
    }

    /// A positive number that the magnitude of a node is never below.
    fn least_magnitude(&mut self, id: NodeId) -> Option<NodeId> {
        let Interval { low, high, .. } = self.intervals[id.index()];
        let least = if low > 0.0 { low } else { -high };
        (least > 0.0).then(|| self.values.intern(Node::constant(least)))
    }

    fn abs(&mut self, id: NodeId) -> NodeId {
        self.make(Abs, id, id)
    }

    fn make(&mut self, instruction: Instruction, a: NodeId, b: NodeId) -> NodeId {
        fold::operation(self.values, self.arithmetic, instruction, [a, b])
    }
}

/// Above the first number, every libm's exponential is infinite; below the second, 0. Many are slow there.
pub(crate) fn beyond_exponentials(scalar: ScalarType) -> (f64, f64) {
    match scalar {
        ScalarType::F32 => (90.0, -105.0),
        ScalarType::F64 => (710.0, -750.0),
    }
}
