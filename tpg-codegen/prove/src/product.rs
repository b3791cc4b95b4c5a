//! The proof: pairs of a point in the code and a place in the graph, from the start on.
//!
//! For each pair all combinations are found in which the code and the graph can go on together. What held on the way is forgotten
//! where both have decided: a pair stands for every state that leads to it.

use crate::graph::meaning::Meaning;
use crate::graph::{Destination, Graph, circle};
use crate::input::{Missing, Result};
use crate::machine::{Answer, Machine, Point, Step, Ways};
use crate::order::together;
use crate::term::evaluate::Evaluator;
use crate::term::smt::Script;
use crate::term::{Bool, Float, Terms};
use Destination::*;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// A bound on the work of a proof.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Cases that are told apart, in all
    pub cases: u64,
    /// Pairs
    pub pairs: u64,
}

impl Default for Effort {
    fn default() -> Self {
        Self { cases: 4_000_000, pairs: 20_000 }
    }
}

/// What was done for a proof.
#[derive(Clone, Debug, Default)]
pub struct Work {
    /// Pairs of a point and a place
    pub pairs: u64,
    /// Cases that were told apart
    pub cases: u64,
    /// Pieces of the code that were executed
    pub pieces: u64,
}

/// The sides that follow from a point, each with its condition.
type Pieces = HashMap<Point, Ways>;

/// Conditions of both sides that can hold together, by their places.
type Combined = BTreeSet<(usize, usize)>;

/// Pairs of a side and a place of the graph, each with its condition.
type Pairs = Vec<(Step<Point>, Destination, Bool)>;

/// Compares code with a graph.
pub struct Comparison<'a> {
    /// The terms of both
    pub terms: Terms,
    graph: &'a Graph,
    meaning: Meaning<'a>,
    machine: &'a mut dyn Machine,
    /// Holds in every state of which something is claimed
    claimed: Bool,
    effort: Effort,
    evaluator: Evaluator,
    /// What was done
    pub work: Work,
    pieces: Pieces,
    combined: HashMap<(Bool, [Vec<Bool>; 2]), Combined>,
    /// Takes what is decided, as scripts that no state satisfies
    pub(crate) queries: Queries<'a>,
}

/// Takes scripts of SMT-LIB, if somebody wants them.
pub type Queries<'a> = Option<&'a dyn Fn(String)>;

/// The script of an assumption and of what never holds with it.
fn never(terms: &Terms, assumed: Bool, formula: impl FnOnce(&mut Script<'_>) -> String) -> String {
    let mut script = Script::new(terms);
    let assumed = script.truth(assumed);
    script.assert(&assumed);
    let formula = formula(&mut script);
    script.assert(&formula);
    script.finish()
}

/// The script of pairs of conditions that were not found to hold together; some condition of each side always holds.
pub(crate) fn excluded(terms: &Terms, assumed: Bool, sides: [&[Bool]; 2], found: &Combined) -> String {
    never(terms, assumed, |script| {
        let [left, right] = sides.map(|side| side.iter().map(|&condition| script.truth(condition)).collect::<Vec<_>>());
        let pairs = (0..left.len()).flat_map(|x| (0..right.len()).map(move |y| (x, y)));
        let excluded: String = pairs
            .filter(|pair| !found.contains(pair))
            .map(|(x, y)| format!(" (and {} {})", left[x], right[y]))
            .collect();
        let [left, right] = [left, right].map(|side| side.join(" "));
        format!("(or (not (or false {left})) (not (or false {right})){excluded})")
    })
}

/// The condition that the values of the state are in ranges.
pub(crate) fn in_ranges(graph: &Graph, terms: &Terms, ranges: &[[f64; 2]]) -> Bool {
    let inside = (0..).zip(ranges).flat_map(|(index, range)| {
        let value = graph.interface().value(terms, index);
        let [low, high] = range.map(|end| graph.constant(terms, end));
        [terms.less_or_equal(low, value), terms.less_or_equal(value, high)]
    });
    terms.all(inside.collect::<Vec<_>>())
}

impl<'a> Comparison<'a> {
    /// A comparison in an empty table, for all states or for those in ranges.
    pub fn new(
        graph: &'a Graph,
        machine: &'a mut dyn Machine,
        terms: Terms,
        ranges: &[[f64; 2]],
        effort: Effort,
    ) -> Self {
        let claimed = in_ranges(graph, &terms, ranges);
        Self {
            terms,
            graph,
            meaning: Meaning::new(graph),
            machine,
            claimed,
            effort,
            evaluator: Evaluator::default(),
            work: Work::default(),
            pieces: HashMap::new(),
            combined: HashMap::new(),
            queries: None,
        }
    }

    /// Proves that the code answers what the graph does.
    ///
    /// # Errors
    /// What no rule decides.
    pub fn prove(&mut self) -> Result<()> {
        self.meaning.functions(&self.terms);
        match self.walk(true) {
            Ok(()) => Ok(()),
            // once more with all that held on the way
            Err(_) => self.walk(false),
        }
    }

    fn walk(&mut self, forgetful: bool) -> Result<()> {
        let start = Step::To(self.machine.entry(&self.terms)?);
        let mut pairs = vec![(start, self.graph.start, self.claimed)];
        let mut numbers = HashMap::from([(pairs[0].clone(), 0)]);
        // Of each pair those that come after it.
        let mut after: Vec<Vec<usize>> = Vec::new();
        let mut open = vec![0];
        while let Some(number) = open.pop() {
            let (side, place, assumed) = pairs[number].clone();
            self.work.pairs += 1;
            if self.work.pairs > self.effort.pairs {
                return Err(Missing::new(
                    self.name(&side, place),
                    format!("a proof of at most {} pairs", self.effort.pairs),
                ));
            }
            let mut next = Vec::new();
            for pair in self.follow(side, place, assumed, forgetful)? {
                let to = *numbers.entry(pair.clone()).or_insert_with(|| {
                    open.push(pairs.len());
                    pairs.push(pair);
                    pairs.len() - 1
                });
                next.push(to);
            }
            after.resize(pairs.len(), Vec::new());
            after[number] = next;
        }
        // Where pairs form a circle, the code might never answer.
        match circle(&after) {
            None => self.terms.complete(|| "the graph".to_owned()),
            Some(pair) => Err(Missing::new(self.name(&pairs[pair].0, pairs[pair].1), "a proof that the code ends")),
        }
    }

    fn name(&self, side: &Step<Point>, place: Destination) -> String {
        let code = match side {
            Step::To(point) => self.machine.place(point.at),
            Step::Return(_) => "the answer".to_owned(),
        };
        format!("{code} and {}", self.graph.name(place))
    }

    /// The pairs after a pair.
    fn follow(&mut self, side: Step<Point>, place: Destination, assumed: Bool, forgetful: bool) -> Result<Pairs> {
        let (ends, answered) = match self.ends(&side)? {
            Some(ends) => (ends, false),
            None => (vec![(Terms::TRUE, side.clone())], true),
        };
        let graph_is_done = !matches!(place, Team(_));
        if answered && graph_is_done {
            self.answers(&side, place, assumed)?;
            return Ok(Vec::new());
        }
        if !answered && ends.len() == 1 && ends[0].0 == Terms::TRUE {
            return Ok(ends.into_iter().map(|(_, end)| (end, place, assumed)).collect());
        }
        let team = match place {
            Team(team) => self.meaning.winners(&self.terms, team)?,
            _ => vec![(Terms::TRUE, place)],
        };
        let conditions: Vec<_> = ends.iter().map(|&(condition, _)| condition).collect();
        let wins: Vec<_> = team.iter().map(|&(condition, _)| condition).collect();
        let pairs = self.together((&side, place), assumed, [&conditions, &wins])?;
        let all: BTreeSet<_> = pairs.iter().map(|&(_, edge)| team[edge].1).collect();
        if !graph_is_done && all.len() == 1 {
            // whatever the bids are, the team leads there
            return Ok(all.into_iter().map(|to| (side.clone(), to, assumed)).collect());
        }
        let mut next = Vec::new();
        for (of, (condition, end)) in ends.into_iter().enumerate() {
            let mut targets: BTreeMap<Destination, Vec<Bool>> = BTreeMap::new();
            for &(_, edge) in pairs.iter().filter(|&&(end, _)| end == of) {
                targets.entry(team[edge].1).or_default().push(team[edge].0);
            }
            let held = self.terms.and(assumed, condition);
            if targets.is_empty() {
                continue;
            }
            if answered {
                // the graph goes on alone
                next.extend(targets.into_iter().map(|(to, wins)| {
                    let won = self.terms.any(wins);
                    (end.clone(), to, self.terms.and(held, won))
                }));
            } else if targets.len() == 1 && !graph_is_done {
                let held = if forgetful { self.claimed } else { held };
                next.extend(targets.into_keys().map(|to| (end.clone(), to, held)));
            } else {
                // the code has decided something, but not yet what the graph decides here
                next.push((end, place, held));
            }
        }
        Ok(next)
    }

    /// Finds which conditions of both sides can hold together, within the work that is left.
    fn together(
        &mut self,
        (side, place): (&Step<Point>, Destination),
        assumed: Bool,
        sides: [&[Bool]; 2],
    ) -> Result<Combined> {
        // places that are reached in several ways ask for the same
        let key = (assumed, sides.map(<[Bool]>::to_vec));
        if let Some(known) = self.combined.get(&key) {
            return Ok(known.clone());
        }
        let left = self.effort.cases.saturating_sub(self.work.cases);
        let found = together(&self.terms, assumed, sides, left);
        self.work.cases += found.as_ref().map_or(left, |found| found.cases);
        match found {
            Some(found) if !found.incomplete => {
                if let Some(take) = self.queries {
                    take(excluded(&self.terms, assumed, sides, &found.pairs));
                }
                self.combined.insert(key, found.pairs.clone());
                Ok(found.pairs)
            }
            Some(_) => Err(Missing::new(self.name(side, place), "a way on in every state")),
            None => {
                let what = format!("a proof of at most {} cases", self.effort.cases);
                Err(Missing::new(self.name(side, place), what))
            }
        }
    }

    /// Compares answers. They are compared where the assumption can hold, which was found before.
    fn answers(&mut self, side: &Step<Point>, place: Destination, assumed: Bool) -> Result<()> {
        let different = |what: String| Missing::new(what, "a proof that the answers are equal");
        match (side, place) {
            (Step::Return(Answer::Action(word)), Action(action))
                if self.terms.number_of(*word) == Some(u64::from(action)) =>
            {
                Ok(())
            }
            (Step::Return(Answer::Values(values)), Leaf(leaf)) => {
                let expected = self.meaning.values(&self.terms, leaf)?;
                self.terms.complete(|| self.graph.name(place))?;
                if values.len() != expected.len() {
                    return Err(different(self.name(side, place)));
                }
                for (number, (&value, &expected)) in (1..).zip(values.iter().zip(&expected)) {
                    if !self.equal(value, expected, assumed, (side, place))? {
                        return Err(different(format!("{}, value {number}", self.name(side, place))));
                    }
                }
                Ok(())
            }
            _ => Err(different(self.name(side, place))),
        }
    }

    /// Tests whether two floats are the same wherever the assumption holds.
    fn equal(&mut self, a: Float, b: Float, assumed: Bool, (side, place): (&Step<Point>, Destination)) -> Result<bool> {
        if a == b {
            return Ok(true);
        }
        let (first, second) = (self.terms.float_cases(a), self.terms.float_cases(b));
        let conditions = |cases: &[(Bool, Float)]| cases.iter().map(|&(condition, _)| condition).collect::<Vec<_>>();
        let sides = [&conditions(&first)[..], &conditions(&second)];
        let pairs = self.together((side, place), assumed, sides)?;
        let same = |x: usize, y: usize| {
            let ((p, a), (q, b)) = (first[x], second[y]);
            a == b || self.terms.same_under(a, b, [p, q])
        };
        let same = pairs.iter().all(|&(x, y)| same(x, y));
        if let Some(take) = self.queries.filter(|_| same) {
            take(never(&self.terms, assumed, |script| format!("(distinct {} {})", script.number(a), script.number(b))));
        }
        Ok(same)
    }

    /// Where the code can go on from a side; none where it has answered.
    fn ends(&mut self, side: &Step<Point>) -> Result<Option<Ways>> {
        let point = match side {
            Step::To(point) => point,
            Step::Return(Answer::Action(word)) if self.terms.number_of(*word).is_none() => {
                let cases = self.terms.one_choice(*word).into_iter();
                return Ok(Some(cases.map(|(held, word)| (held, Step::Return(Answer::Action(word)))).collect()));
            }
            Step::Return(_) => return Ok(None),
        };
        if let Some(known) = self.pieces.get(point) {
            return Ok(Some(known.clone()));
        }
        self.work.pieces += 1;
        let ways = self.machine.run(&self.terms, point)?;
        self.terms.complete(|| self.machine.place(point.at))?;
        let mut sides: Ways = Vec::new();
        for (condition, side) in ways.into_iter().filter(|(condition, _)| *condition != Terms::FALSE) {
            match sides.iter_mut().find(|(_, other)| *other == side) {
                Some((known, _)) => *known = self.terms.or(*known, condition),
                None => sides.push((condition, side)),
            }
        }
        self.pieces.insert(point.clone(), sides.clone());
        Ok(Some(sides))
    }

    /// The answers of the graph and of the code in one state, for people; they differ where the answers do.
    ///
    /// # Errors
    /// The part that cannot be executed.
    pub(crate) fn answers_for(&mut self, state: &[u32]) -> Result<[String; 2]> {
        self.evaluator.set(state);
        let mut place = self.graph.start;
        let expected = loop {
            let team = match place {
                Team(team) => team,
                Leaf(leaf) => break Answer::Values(self.meaning.values(&self.terms, leaf)?),
                Action(action) => break Answer::Action(self.terms.number(action.into())),
            };
            let winners = self.meaning.winners(&self.terms, team)?;
            let won = winners.iter().find(|(condition, _)| self.evaluator.truth(&self.terms, *condition));
            place = won.ok_or_else(|| Missing::new(self.graph.name(place), "a winner"))?.1;
        };
        let mut side = Step::To(self.machine.entry(&self.terms)?);
        let mut steps = 0;
        let found = loop {
            if let Step::Return(answer) = side {
                break answer;
            }
            steps += 1;
            if steps > self.effort.pairs {
                return Err(Missing::new(self.name(&side, place), "code that ends soon"));
            }
            let ends = self.ends(&side)?.unwrap_or_default();
            let taken = ends.into_iter().find(|(condition, _)| self.evaluator.truth(&self.terms, *condition));
            side = taken.ok_or_else(|| Missing::new(self.name(&side, place), "a way on in every state"))?.1;
        };
        let answers = [expected, found].map(|answer| match answer {
            Answer::Action(word) => format!("action {}", self.evaluator.word(&self.terms, word)),
            Answer::Values(values) => {
                let values: Vec<_> = values.into_iter().map(|value| self.evaluator.text(&self.terms, value)).collect();
                format!("[{}]", values.join(", "))
            }
        });
        self.terms.complete(|| "the code".to_owned())?;
        if self.evaluator.has_guessed() {
            return Err(Missing::new("the code", "all values that the answer depends on"));
        }
        Ok(answers)
    }
}
