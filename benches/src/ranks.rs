//! A simulation of runs over many ranks: a recorded trace, a network with latency and bandwidth, and one of two ways to hand
//! units out.

use crate::trace::{Question, Trace};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};
use tpg_engine::Piece;
use tpg_train::ranks::dealer::{Dealer, needed, parts};

/// A network and the cost of a message on rank 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Network {
    /// Time from rank to rank, seconds.
    pub latency: f64,
    /// Bytes a second.
    pub bandwidth: f64,
    /// Rank 0's time for a message: look, pack or unpack; seconds.
    pub message: f64,
    /// The same for each byte; seconds.
    pub byte: f64,
}

/// The way in which units are handed out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dealing {
    /// As the program does: units cut into pieces where they are few, the most expensive first, in shares that become
    /// smaller, to whoever is free.
    Dynamic,
    /// The same with whole units.
    Whole,
    /// Unit i belongs to rank i modulo the number of ranks.
    Static,
}

/// Returns the time of a run on one thread without messages, seconds. `factor` multiplies the time of every unit.
pub fn alone(trace: &Trace, factor: f64) -> f64 {
    let one =
        |question: &Question| question.alone + factor * question.units.iter().map(|unit| unit.seconds).sum::<f64>();
    trace.questions.iter().map(one).sum()
}

/// Returns the time of a run on `ranks` ranks of one thread each, seconds.
///
/// Rank 0's thread for messages takes turns with nobody: as in the program, its evaluation is a thread of its own.
///
/// # Panics
/// If there are no ranks.
pub fn simulate(trace: &Trace, ranks: usize, network: Network, dealing: Dealing, factor: f64) -> f64 {
    assert!(ranks > 0, "ranks");
    trace.questions.iter().map(|question| question.alone + asked(question, ranks, network, dealing, factor)).sum()
}

/// An answer on its way to rank 0: its arrival in nanoseconds, for a total order; then rank, units.
type Arrival = Reverse<(u64, usize, Vec<usize>)>;

fn nanoseconds(seconds: f64) -> u64 {
    (seconds * 1e9).round() as u64
}

/// A piece as the simulation needs it.
struct Part {
    /// Its unit and tasks, which are sent once with several pieces of them.
    piece: Piece,
    expected: u64,
    seconds: f64,
    out: u64,
    back: f64,
}

fn episodes(question: &Question) -> usize {
    question.units.iter().map(|unit| unit.steps.len()).max().unwrap_or(0)
}

/// Cuts a question's units as the program does. A unit's time is spread over its episodes by their steps.
fn cut(question: &Question, ranks: usize, dealing: Dealing, factor: f64) -> Vec<Part> {
    let seconds = factor * question.units.iter().map(|unit| unit.seconds).sum::<f64>();
    let parts = match dealing {
        Dealing::Dynamic => parts(question.units.len(), ranks, Some(seconds)),
        Dealing::Whole | Dealing::Static => 1,
    };
    let pieces = Piece::cut(question.units.len(), episodes(question), parts);
    let part = |piece: Piece| {
        let (of, tasks) = (&question.units[piece.unit], &piece.tasks);
        let sum = |steps: &[u32]| steps.iter().map(|&steps| f64::from(steps)).sum::<f64>();
        let own = of.steps.get(tasks.clone()).unwrap_or_default();
        let share = if sum(&of.steps) > 0.0 { sum(own) / sum(&of.steps) } else { 0.0 };
        let length = own.len() as f64 / of.steps.len().max(1) as f64;
        Part {
            expected: of.expected * tasks.len() as u64,
            seconds: factor * of.seconds * share,
            out: of.out,
            back: of.back as f64 * length,
            piece,
        }
    };
    pieces.into_iter().map(part).collect()
}

/// Returns the time of a question.
fn asked(question: &Question, ranks: usize, network: Network, dealing: Dealing, factor: f64) -> f64 {
    if ranks == 1 {
        return factor * question.units.iter().map(|unit| unit.seconds).sum::<f64>();
    }
    let parts = cut(question, ranks, dealing, factor);
    let seconds = |share: &[usize]| share.iter().map(|&part| parts[part].seconds).sum::<f64>();
    let back = |share: &[usize]| share.iter().map(|&part| parts[part].back).sum::<f64>();
    let mut hand = Hand::new(&parts, ranks, dealing);
    // The time at which rank 0's message thread is free, and at which its evaluating thread is done.
    let mut free = 0.0_f64;
    let mut arrivals: BinaryHeap<Arrival> = BinaryHeap::new();
    let mut known = vec![question.tasks == 0; ranks];
    let mut send = |rank: usize, share: Vec<usize>, free: &mut f64, arrivals: &mut BinaryHeap<Arrival>| {
        if share.is_empty() {
            return;
        }
        let units: BTreeMap<usize, u64> = share.iter().map(|&part| (parts[part].piece.unit, parts[part].out)).collect();
        let pieces: Vec<&Piece> = share.iter().map(|&part| &parts[part].piece).collect();
        let tasks = match needed(&pieces, episodes(question)) {
            _ if known[rank] => 0,
            Some(tasks) => question.tasks * tasks.len() as u64 / episodes(question) as u64,
            None => {
                known[rank] = true;
                question.tasks
            }
        };
        let out = units.values().sum::<u64>() + tasks;
        *free += network.message + out as f64 * network.byte;
        let there = *free + network.latency + out as f64 / network.bandwidth;
        let answered = there + seconds(&share) + network.latency + back(&share) / network.bandwidth;
        arrivals.push(Reverse((nanoseconds(answered), rank, share)));
    };
    for rank in 1..ranks {
        let share = hand.next(rank);
        send(rank, share, &mut free, &mut arrivals);
    }
    // Rank 0's evaluation is a thread of its own: it takes its first share at once.
    let mut own = 0.0;
    let mut own_done = false;
    loop {
        let next = arrivals.peek().map(|Reverse((at, ..))| *at as f64 / 1e9);
        if !own_done && next.is_none_or(|at| own <= at) {
            let share = hand.next(0);
            own_done = share.is_empty();
            own += seconds(&share);
            continue;
        }
        let Some(Reverse((at, rank, share))) = arrivals.pop() else { break };
        free = free.max(at as f64 / 1e9) + network.message + back(&share) * network.byte;
        let share = hand.next(rank);
        send(rank, share, &mut free, &mut arrivals);
    }
    free.max(own)
}

/// The pieces that are left, in one way of handing out.
enum Hand {
    Dynamic(Dealer),
    Static(Vec<Vec<usize>>),
}

impl Hand {
    fn new(parts: &[Part], ranks: usize, dealing: Dealing) -> Self {
        match dealing {
            Dealing::Dynamic | Dealing::Whole => {
                let costs: Vec<u64> = parts.iter().map(|part| part.expected).collect();
                Self::Dynamic(Dealer::new(&costs, ranks))
            }
            Dealing::Static => {
                let part = |rank: usize| (rank..parts.len()).step_by(ranks).collect();
                Self::Static((0..ranks).map(part).collect())
            }
        }
    }

    fn next(&mut self, rank: usize) -> Vec<usize> {
        match self {
            Self::Dynamic(dealer) => dealer.deal(1),
            Self::Static(parts) => std::mem::take(&mut parts[rank]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Dealing, Network, alone, simulate};
    use crate::trace::{Question, Trace, Unit};

    const NO_COST: Network = Network { latency: 0.0, bandwidth: f64::INFINITY, message: 0.0, byte: 0.0 };

    fn trace(seconds: &[f64]) -> Trace {
        let unit = |&seconds: &f64| Unit {
            expected: (1000.0 * seconds) as u64,
            seconds,
            steps: vec![1; 4],
            out: 100,
            back: 10,
        };
        let questions = vec![Question { alone: 0.5, tasks: 1000, units: seconds.iter().map(unit).collect() }; 2];
        Trace { name: "test".to_owned(), questions }
    }

    #[test]
    fn times_are_those_of_a_calculation_by_hand() {
        let trace = trace(&[1.0, 1.0, 1.0, 5.0]);
        assert_eq!(alone(&trace, 1.0), 17.0);
        assert_eq!(simulate(&trace, 1, NO_COST, Dealing::Dynamic, 1.0), 17.0);
        // The long unit first, on a rank of its own: 0.5 + 5 each; the other rank does the three short ones.
        assert_eq!(simulate(&trace, 2, NO_COST, Dealing::Whole, 1.0), 11.0);
        // In pieces of an episode each, both ranks are busy to the end.
        assert_eq!(simulate(&trace, 2, NO_COST, Dealing::Dynamic, 1.0), 9.0);
        // Ranks 0 and 1 have every other unit: 1 + 1 and 1 + 5.
        assert_eq!(simulate(&trace, 2, NO_COST, Dealing::Static, 1.0), 13.0);
        assert_eq!(simulate(&trace, 9, NO_COST, Dealing::Whole, 2.0), 21.0);
        assert_eq!(simulate(&trace, 16, NO_COST, Dealing::Dynamic, 2.0), 6.0);
    }

    #[test]
    fn messages_cost_latency_and_bandwidth() {
        let one = trace(&[4.0, 4.0]);
        // Rank 1 gets its unit (100 bytes and 1,000 of tasks) and answers 10 bytes: 1 + 1.1 + 4 + 1 + 0.01, twice; rank 0
        // begins at once and is done earlier.
        let slow = Network { latency: 1.0, bandwidth: 1000.0, ..NO_COST };
        let expected = 2.0 * (0.5 + 1.0 + 1.1 + 4.0 + 1.0 + 0.01);
        assert!((simulate(&one, 2, slow, Dealing::Static, 1.0) - expected).abs() < 1e-6);
        let busy = Network { message: 0.25, ..NO_COST };
        assert!((simulate(&one, 2, busy, Dealing::Static, 1.0) - 2.0 * (0.5 + 0.25 + 4.0 + 0.25)).abs() < 1e-6);
    }
}
