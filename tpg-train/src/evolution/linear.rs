//! The linear start: one dense linear program for each output or action, found by [`Cma`], from which evolution goes on.
//!
//! A program is a weighted sum of the inputs, or the product of two: that one can change its sign where another input does, as a
//! swing-up must. Mutations of single lines hardly ever find six weights that only help together; two searches do: [`RandomSearch`] in
//! small steps from nothing, where the configuration gives it steps and as long as it gets anywhere, and after it covariance matrix
//! adaptation. Several of the latter run side by side for the first half, the best of them goes on for the second. Where that stalls
//! early, another one begins, for products where it was for sums and for sums where it was for products. Evolution goes on from the last
//! search and the best before it.

use super::cma::Cma;
use super::config::StartKind;
use super::generation::Evolution;
use super::genome::{Destination, Edge, Genome, GenomeLine, Leaf, Program, Team, TeamId};
use super::milestones::{Bounds, Point, StepBounds};
use super::random_search::RandomSearch;
use super::state::{Deme, Record, Row, State};
use super::vocabulary::{Gene, InstructionIndex, Kind, OPERANDS, Vocabulary};
use serde::{Deserialize, Serialize};
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{
    Ending, Environment, EvaluationError, Evaluator, Moments, Play, PolicyGraph, Summary, UnitKey, Work, WorkUnit,
};
use tpg_graph::Word;
use tpg_graph::error::Finding;
use tpg_runtime::ops::Instruction;
use tpg_runtime::scalar::Scalar;

/// Weight of the newest generation in a search's score.
const NEWEST: f64 = 0.2;
/// A random search ends after this part of its steps if it is no better than luck.
const TRIAL: f64 = 0.25;
/// The mean of samples that are better than luck, as a part of the way from the first generation's median score to its best.
const LUCK: f64 = 0.9;
/// Most weights of a linear start: beyond, a full covariance costs more than it finds.
pub(super) const MOST_WEIGHTS: usize = 400;

/// One search for weights.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Search {
    /// What the programs are that it looks for.
    pub kind: StartKind,
    /// How it looks.
    pub method: Method,
    /// Mean score of its samples, smoothed over generations.
    pub score: f64,
}

/// How a search looks for weights.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// Covariance matrix adaptation of the weights that are written.
    Cma(Cma),
    /// Random search of the weights of normalised inputs.
    Random(RandomSearch),
}

impl Search {
    /// Draws at least `count` samples.
    fn samples(&self, count: usize, stream: &mut Stream) -> Vec<Vec<f64>> {
        match &self.method {
            Method::Cma(cma) => cma.samples(count, stream),
            Method::Random(search) => search.samples(count, stream),
        }
    }

    /// Returns the centre of its samples.
    fn mean(&self) -> &[f64] {
        match &self.method {
            Method::Cma(cma) => cma.mean(),
            Method::Random(search) => search.mean(),
        }
    }

    /// Learns from the results of a generation's samples, which are equal if their scores differ by less than `tolerance`; `left` is
    /// the part of a random search that is still to come.
    fn update(&mut self, samples: &[Vec<f64>], results: &[Summary], tolerance: f64, left: f64) {
        let mean = results.iter().map(|result| result.score).sum::<f64>() / results.len() as f64;
        self.score = if self.score.is_finite() { self.score + NEWEST * (mean - self.score) } else { mean };
        match &mut self.method {
            Method::Cma(cma) => {
                let order = ranked(results);
                let scores: Vec<f64> = order.iter().map(|&place| results[place].score).collect();
                let ranked: Vec<Vec<f64>> = order.into_iter().map(|place| samples[place].clone()).collect();
                cma.update(&ranked, &groups(&scores, tolerance));
            }
            Method::Random(search) => {
                let scores: Vec<f64> = results.iter().map(|result| result.score).collect();
                search.update(samples, &scores, left);
            }
        }
    }
}

/// Returns the sizes of the groups of equals among falling scores: those that are less than `tolerance` below a group's first.
fn groups(scores: &[f64], tolerance: f64) -> Vec<usize> {
    let mut left = scores;
    let mut sizes = Vec::new();
    while let Some(first) = left.first() {
        let size = left.iter().take_while(|score| first - *score < tolerance).count().max(1);
        sizes.push(size);
        left = &left[size..];
    }
    sizes
}

/// Returns the indices of results, best first; of equals, the first.
fn ranked(results: &[Summary]) -> Vec<usize> {
    let mut places: Vec<usize> = (0..results.len()).collect();
    places.sort_by(|&a, &b| results[b].score.total_cmp(&results[a].score).then(a.cmp(&b)));
    places
}

/// Returns the row of a generation of samples.
fn row(generation: u64, results: &[Summary]) -> Row {
    let order = ranked(results);
    let best = &results[order[0]];
    Row {
        generation,
        best_score: best.score,
        median_score: results[order[order.len() / 2]].score,
        best_success: best.success,
        best_measure: best.measure,
        roots: results.len(),
        teams: 0,
        programs: 0,
        validation: None,
    }
}

/// Writes linear programs in the words of a vocabulary.
#[derive(Clone, Debug)]
pub(super) struct LinearWriter<'a> {
    vocabulary: &'a Vocabulary,
    /// The values that programs can read.
    inputs: Vec<Input>,
    add: InstructionIndex,
    multiply: Multiply,
    /// The word that multiplies two sums; none if a program is a single sum.
    product: Option<InstructionIndex>,
    /// Number of actions; 0 with outputs.
    actions: u16,
}

/// A value that programs can read.
#[derive(Clone, Copy, Debug)]
struct Input {
    source: u8,
    location: u16,
    /// Its place in the flat state.
    place: u16,
    unit: f64,
}

/// Words for a term of a sum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Multiply {
    /// One line: the sum grows by a product.
    Add(InstructionIndex),
    /// A line for the product, another one to add it.
    Alone(InstructionIndex),
}

impl<'a> LinearWriter<'a> {
    /// Creates a writer; `actions` is 0 where there are outputs.
    ///
    /// # Errors
    /// If the vocabulary cannot express such programs.
    pub(super) fn new(vocabulary: &'a Vocabulary, actions: u16, kind: StartKind) -> Result<Self, Finding> {
        let index = |word: Word| {
            let place = vocabulary.instructions().iter().position(|known| *known == word)?;
            Some(place as InstructionIndex)
        };
        let refuse = |key: &str, found: String, accepted: &str| Err(Finding::new(key, found, accepted));
        let names = || format!("{:?}", vocabulary.instructions().iter().map(|it| it.name()).collect::<Vec<_>>());
        let multiply =
            index(Word::MultiplyAdd).map(Multiply::Add).or_else(|| index(Instruction::Mul.into()).map(Multiply::Alone));
        let Some((add, multiply)) = index(Instruction::Add.into()).zip(multiply) else {
            return refuse("language.instructions", names(), "add, and multiply_add or mul, for a linear start");
        };
        let product = (kind == StartKind::Product).then(|| index(Instruction::Mul.into()));
        if product == Some(None) {
            return refuse("language.instructions", names(), "add and mul, for a start with products");
        }
        let product = product.flatten();
        if vocabulary.scales().is_empty() {
            return refuse("language.literals", "false".to_owned(), "true, for a linear start");
        }
        let (least, accepted) = match product {
            None => (2, "at least 2, for a linear start"),
            Some(_) => (3, "at least 3, for a start with products"),
        };
        if vocabulary.registers() < least {
            return refuse("learning.nb_registers", vocabulary.registers().to_string(), accepted);
        }
        let places = (0..vocabulary.sources()).filter_map(|source| match vocabulary.kind(source as u8) {
            Kind::Data(place, length) => Some((0..length).map(move |at| (source as u8, at, place + at))),
            Kind::Registers | Kind::Constants | Kind::Literal => None,
        });
        let unit = |place: u16| vocabulary.scales()[usize::from(place)];
        let input = |(source, location, place)| Input { source, location, place, unit: unit(place) };
        let inputs = places.flatten().map(input).collect();
        Ok(Self { vocabulary, inputs, add, multiply, product, actions })
    }

    /// Returns the number of programs that are searched for: the first action's bid stays 0.
    fn programs(&self) -> usize {
        match self.actions {
            0 => self.vocabulary.outputs().len(),
            actions => usize::from(actions) - 1,
        }
    }

    /// Returns the number of sums in a program.
    fn sums(&self) -> usize {
        1 + usize::from(self.product.is_some())
    }

    /// Returns the number of weights: for each sum of each program those of the inputs, and a constant.
    pub(super) fn weights(&self) -> usize {
        self.programs() * self.sums() * (self.inputs.len() + 1)
    }

    /// Returns the number of lines of a program.
    pub(super) fn lines(&self) -> usize {
        let sum = match self.multiply {
            Multiply::Add(_) => self.inputs.len() + 1,
            Multiply::Alone(_) => 2 * self.inputs.len(),
        };
        self.sums() * (sum + 1) - 1
    }

    /// Returns the number of rows of a random search: an output's, or an action's.
    pub(super) fn rows(&self) -> usize {
        match self.actions {
            0 => self.programs(),
            actions => actions.into(),
        }
    }

    /// Returns the number of inputs of a sum.
    pub(super) fn inputs(&self) -> usize {
        self.inputs.len()
    }

    /// Returns the moments of the inputs from those of flat states.
    fn inputs_of(&self, states: &Moments) -> Moments {
        states.select(self.inputs.iter().map(|input| input.place.into()))
    }

    /// Returns the weights that a sample of a search stands for.
    fn weights_of(&self, search: &Search, sample: &[f64]) -> Vec<f64> {
        let Method::Random(random) = &search.method else { return sample.to_vec() };
        let units: Vec<f64> = self.inputs.iter().map(|input| input.unit).collect();
        let rows = random.unfolded(sample, &units);
        match self.actions {
            0 => rows.concat(),
            // The greatest bid wins, so what counts is the distance from the first action's, which stays 0.
            _ => rows[1..]
                .iter()
                .flat_map(|row| row.iter().zip(&rows[0]).map(|(weight, first)| weight - first))
                .collect(),
        }
    }

    /// Adds the policy with the given weights to a genome. A weight of 1 is a whole output's half range for an input's.
    pub(super) fn add_root(&self, genome: &mut Genome, weights: &[f64]) -> TeamId {
        let outputs = self.vocabulary.outputs();
        let of_program = self.sums() * (self.inputs.len() + 1);
        let mut programs = weights.chunks_exact(of_program).enumerate().map(|(place, weights)| {
            let unit = outputs.get(place).map_or(1.0, |output| 0.5 * (output.max - output.min));
            self.program_of(weights, unit)
        });
        let edges = if self.actions == 0 {
            let programs = programs.map(|program| genome.add_program(program)).collect();
            let leaf = Destination::Leaf(genome.add_leaf(Leaf { programs }));
            vec![Edge { program: genome.add_program(self.zero()), to: leaf }]
        } else {
            let bids: Vec<_> = (0..self.actions)
                .map(|action| if action == 0 { self.zero() } else { programs.next().unwrap_or_else(|| self.zero()) })
                .collect();
            let edge =
                |(action, program)| Edge { program: genome.add_program(program), to: Destination::Action(action) };
            (0..).zip(bids).map(edge).collect()
        };
        genome.add_team(Team { edges })
    }

    /// Returns the program with the given weights, `unit` times its sum or product.
    fn program_of(&self, weights: &[f64], unit: f64) -> Program {
        let mut lines = Vec::new();
        let units = [unit, 1.0];
        for ((to, weights), unit) in (0..).zip(weights.chunks_exact(self.inputs.len() + 1)).zip(units) {
            self.write_sum(&mut lines, to, weights, unit);
        }
        if let Some(instruction) = self.product {
            lines.push(GenomeLine { instruction, to: 0, operands: [self.register(0), self.register(1)] });
        }
        self.program(lines)
    }

    /// Writes the lines of a sum, whose result is in register `to`.
    fn write_sum(&self, lines: &mut Vec<GenomeLine>, to: u16, weights: &[f64], unit: f64) {
        let literal = |value: f64| {
            let rounded = self.vocabulary.scalar().round(value);
            self.literal(if rounded.is_finite() { rounded } else { 0.0 })
        };
        let spare = self.sums() as u16;
        let sum = self.register(to);
        for (place, (input, weight)) in self.inputs.iter().zip(weights).enumerate() {
            let &Input { source, location, unit: of_input, .. } = input;
            let operands = [Gene { source, location, literal: 0.0 }, literal(unit * weight / of_input)];
            match self.multiply {
                Multiply::Add(instruction) => lines.push(GenomeLine { instruction, to, operands }),
                Multiply::Alone(instruction) if place == 0 => lines.push(GenomeLine { instruction, to, operands }),
                Multiply::Alone(instruction) => {
                    lines.push(GenomeLine { instruction, to: spare, operands });
                    let operands = [sum, self.register(spare)];
                    lines.push(GenomeLine { instruction: self.add, to, operands });
                }
            }
        }
        let constant = literal(unit * weights[self.inputs.len()]);
        lines.push(GenomeLine { instruction: self.add, to, operands: [sum, constant] });
    }

    /// Returns a program whose result is 0.
    fn zero(&self) -> Program {
        let operands = [self.literal(0.0); OPERANDS];
        self.program(vec![GenomeLine { instruction: self.add, to: 0, operands }])
    }

    fn program(&self, lines: Vec<GenomeLine>) -> Program {
        Program { constants: vec![0.0; self.vocabulary.constants().into()], lines }
    }

    fn register(&self, location: u16) -> Gene {
        Gene { source: 0, location, literal: 0.0 }
    }

    fn literal(&self, literal: f64) -> Gene {
        Gene { source: (self.vocabulary.sources() - 1) as u8, location: 0, literal }
    }
}

impl<S: Scalar, E: Environment<S>, V: Evaluator<E::Task>> Evolution<'_, S, E, V> {
    /// True if the next generation belongs to the linear start.
    pub(super) fn is_linear(&self, state: &State<E::Task>) -> bool {
        self.config.linear_end(self.linear, &state.milestones).is_none_or(|end| state.generation < end)
    }

    /// Runs one generation of the linear start.
    pub(super) fn advance_linear(&self, state: &mut State<E::Task>) -> Result<(), EvaluationError> {
        let config = &self.config.start;
        self.begin_searches(state)?;
        let writer = self.writer(state.searches[0].kind)?;
        let count = match config.samples {
            0 => config.breadth * Cma::usual_samples(writer.weights()),
            samples => samples,
        };
        let draw = |(place, search): (u64, &Search)| {
            search.samples(count, &mut Stream::new(state.seed, state.generation, Purpose::Linear, place))
        };
        let samples: Vec<Vec<Vec<f64>>> = (0..).zip(&state.searches).map(draw).collect();
        let of_search = |(search, samples): (&Search, &Vec<Vec<f64>>)| -> Vec<PolicyGraph> {
            samples.iter().map(|sample| self.linear_policy(&writer, &writer.weights_of(search, sample))).collect()
        };
        let policies = state.searches.iter().zip(&samples).flat_map(of_search).collect();
        let (endings, seen) = if is_random(state) {
            self.single_episodes(state, &writer, policies)?
        } else {
            (self.same_episodes(state, policies)?, Moments::default())
        };
        state.count_training(endings.iter().flatten());

        let results: Vec<Summary> = endings.iter().map(|endings| Summary::of(endings)).collect();
        let best = ranked(&results)[0];
        let tolerance =
            state.rows.first().map_or(0.0, |first| config.tie * (results[best].score - first.median_score).max(0.0));
        let left = self.random_left(state);
        let (mut place, mut of_best) = (0, 0);
        for (number, (search, samples)) in state.searches.iter_mut().zip(&samples).enumerate() {
            let its = place..place + samples.len();
            if its.contains(&best) {
                of_best = number;
            }
            place = its.end;
            search.update(samples, &results[its], tolerance, left);
            if let Method::Random(search) = &mut search.method {
                search.observe(&seen);
            }
        }
        let mut row = row(state.generation, &results);
        if self.ends_linear(state, &writer) || self.is_last(state) {
            self.populate_from_linear(state)?;
            row.validation = self.validate(state)?;
        } else {
            // The mean of a search is better than its samples.
            let search = &state.searches[of_best];
            let weights = writer.weights_of(search, search.mean());
            row.validation = self.try_for_target(state, row.best_score, || self.linear_policy(&writer, &weights))?;
        }
        row.teams = state.demes.iter().map(|deme| deme.genome.teams().len()).sum();
        row.programs = state.demes.iter().map(|deme| deme.genome.program_count()).sum();
        state.rows.push(row);
        state.generation += 1;
        Ok(())
    }

    /// Returns the number of searches by covariance matrix adaptation before the one that begins; `None` if that is a random one.
    fn others_before(&self, state: &State<E::Task>) -> Option<u64> {
        let before = state.milestones.begun.map_or(0, |begun| begun.searches);
        let random = self.config.start.random > 0.0 && self.goal.max_steps.is_some();
        before.checked_sub(random.into())
    }

    /// Returns the part of a random search's steps that is left; all of it in a run without a limit of steps.
    fn random_left(&self, state: &State<E::Task>) -> f64 {
        let part = |most: u64| state.steps as f64 / (self.config.start.random * most as f64);
        self.goal.max_steps.map_or(1.0, |most| (1.0 - part(most)).max(0.0))
    }

    /// Returns the endings of policies on the same few episodes.
    fn same_episodes(
        &self,
        state: &State<E::Task>,
        policies: Vec<PolicyGraph>,
    ) -> Result<Vec<Vec<Ending>>, EvaluationError> {
        let unit =
            |(root, policy)| WorkUnit { key: UnitKey { seed: state.seed, generation: state.generation, root }, policy };
        let units = (0..).zip(policies).map(unit).collect();
        let answers = self.evaluator.evaluate(&Work { tasks: self.tasks(state, self.config.start.episodes), units })?;
        Ok(answers.into_iter().map(|answer| answer.endings).collect())
    }

    /// Returns the ending of one episode for each policy, which it shares with as many as the configuration says, and what they saw:
    /// a random search makes more of more steps than of surer ones.
    fn single_episodes(
        &self,
        state: &State<E::Task>,
        writer: &LinearWriter<'_>,
        policies: Vec<PolicyGraph>,
    ) -> Result<(Vec<Vec<Ending>>, Moments), EvaluationError> {
        let sharing = self.config.start.episode_for.sharing(policies.len());
        let tasks = self.tasks(state, policies.len().div_ceil(sharing));
        let play = |(place, policy): (usize, _)| Play { policy, task: tasks[place / sharing].clone() };
        let plays: Vec<_> = policies.into_iter().enumerate().map(play).collect();
        let mut seen = Moments::new(writer.inputs());
        let endings = self.evaluator.play(&plays)?.into_iter().map(|played| {
            seen.merge(&writer.inputs_of(&played.seen));
            vec![played.ending]
        });
        let endings = endings.collect();
        Ok((endings, seen))
    }

    /// Records how far the linear start has come; returns true if the current generation is its last one.
    fn ends_linear(&self, state: &mut State<E::Task>, writer: &LinearWriter<'_>) -> bool {
        let start = &self.config.start;
        if start.is_by_steps() {
            let score = state.searches.iter().map(|search| search.score).fold(f64::NEG_INFINITY, f64::max);
            let is_random = is_random(state);
            let steps = self.goal.max_steps.map(|most| {
                let part = |share: f64| (share * most as f64) as u64;
                let [least, most] =
                    if is_random { [start.random * random_part(score, state.rows.first()); 2] } else { start.share };
                StepBounds { least: part(least), most: part(most) }
            });
            let point = Point { generations: state.generation + 1, steps: state.steps, score };
            let generations = match steps {
                Some(_) if is_random => u64::MAX,
                _ => self.config.linear_generations(writer.weights()),
            };
            state.milestones.reach(point, Bounds { generations, steps, is_last: !is_random });
        }
        self.config.linear_end(self.linear, &state.milestones) == Some(state.generation + 1)
    }

    /// Returns the policy with the given weights.
    fn linear_policy(&self, writer: &LinearWriter<'_>, weights: &[f64]) -> PolicyGraph {
        let mut genome = Genome::default();
        let team = writer.add_root(&mut genome, weights);
        genome.policy(team, &self.vocabulary)
    }

    /// Starts the searches in their first generation, and keeps the best of them after half of the generations.
    fn begin_searches(&self, state: &mut State<E::Task>) -> Result<(), EvaluationError> {
        let config = &self.config.start;
        if state.milestones.begun.is_some_and(|begun| begun.generation == state.generation) {
            state.stalled = best_of(state.stalled.take().into_iter().chain(state.searches.drain(..)));
        }
        if state.searches.is_empty() {
            let before = self.others_before(state);
            let kind = self.config.search_kind(&self.vocabulary, self.actions, before);
            let (writer, score) = (self.writer(kind)?, f64::NEG_INFINITY);
            state.searches = if before.is_none() {
                let method = Method::Random(RandomSearch::new(writer.rows(), writer.inputs()));
                vec![Search { kind, method, score }]
            } else {
                let method = Method::Cma(Cma::new(writer.weights(), config.deviation, config.covariance));
                vec![Search { kind, method, score }; config.searches]
            };
        }
        if self.config.linear_choice(self.linear, &state.milestones) == Some(state.generation) {
            state.searches = best_of(state.searches.drain(..)).into_iter().collect();
        }
        Ok(())
    }

    /// Puts what was found into the demes that begin with it: a root for each search, the best first.
    fn populate_from_linear(&self, state: &mut State<E::Task>) -> Result<(), EvaluationError> {
        let mut searches: Vec<&Search> = state.searches.iter().chain(&state.stalled).collect();
        searches.sort_by(|a, b| b.score.total_cmp(&a.score));
        for deme in state.demes.iter_mut().take(self.config.start.demes) {
            *deme = Deme::default();
            for search in &searches {
                let writer = self.writer(search.kind)?;
                let root = writer.add_root(&mut deme.genome, &writer.weights_of(search, search.mean()));
                deme.records.insert(root, Record { mean: search.score, evaluations: 0 });
            }
        }
        Ok(())
    }

    /// Returns the writer of sums or products.
    fn writer(&self, kind: StartKind) -> Result<LinearWriter<'_>, EvaluationError> {
        LinearWriter::new(&self.vocabulary, self.actions, kind).map_err(EvaluationError::new)
    }
}

/// True if a random search runs.
fn is_random<Task>(state: &State<Task>) -> bool {
    matches!(state.searches[..], [Search { method: Method::Random(_), .. }])
}

/// Returns the part of its steps that a random search has with such a score, beside its first generation: all of them, however
/// slowly it gets better, for at first it hardly does; [`TRIAL`] while it is no better than luck.
fn random_part(score: f64, first: Option<&Row>) -> f64 {
    let luck = first.map(|first| first.median_score + LUCK * (first.best_score - first.median_score));
    if luck.is_none_or(|luck| score > luck) { 1.0 } else { TRIAL }
}

/// Returns the search with the best score; the first of equals.
fn best_of(searches: impl Iterator<Item = Search>) -> Option<Search> {
    searches.reduce(|best, other| if other.score > best.score { other } else { best })
}

#[cfg(test)]
mod tests {
    use super::{LinearWriter, groups};
    use crate::evolution::archive::bid;
    use crate::evolution::config::StartKind;
    use crate::evolution::genome::{Destination, Genome};
    use crate::evolution::vocabulary::Vocabulary;
    use tpg_engine::Limits;
    use tpg_graph::{ScalarType, SourceDocument, Word};
    use tpg_runtime::ops::Instruction;

    fn vocabulary(words: &[Word], outputs: usize) -> Vocabulary {
        let source = SourceDocument { name: "s".into(), length: 2, unit: "1".into(), ranges: vec![[-1.0, 1.0]; 2] };
        let limits = Limits { min: -2.0, max: 2.0, nan: 0.0 };
        Vocabulary::new(words.to_vec(), 4, 0, &[source], Some(vec![1.0, 4.0]), ScalarType::F64)
            .with_outputs(vec![limits; outputs])
    }

    /// Returns the values of a root's programs in a state: its bids, or its outputs.
    fn values(kind: StartKind, words: &[Word], outputs: usize, actions: u16, weights: &[f64]) -> Vec<f64> {
        let vocabulary = vocabulary(words, outputs);
        let writer = LinearWriter::new(&vocabulary, actions, kind).expect("sums can be written");
        assert_eq!(writer.weights(), weights.len());
        let mut genome = Genome::default();
        let root = writer.add_root(&mut genome, weights);
        let edges = &genome.team(root).edges;
        let programs: Vec<_> = match edges[0].to {
            Destination::Leaf(leaf) => genome.leaves()[&leaf].programs.clone(),
            _ => {
                assert!((0..).zip(edges).all(|(action, edge)| edge.to == Destination::Action(action)));
                edges.iter().map(|edge| edge.program).collect()
            }
        };
        let state = [0.5, 8.0];
        let programs = programs.into_iter().map(|id| genome.program(id));
        programs
            .map(|program| {
                assert!(program.lines.len() <= writer.lines());
                bid(&program.lines(&vocabulary), &vocabulary, &state)
            })
            .collect()
    }

    #[test]
    fn a_weight_is_an_outputs_half_range_for_an_inputs() {
        let [add, mul] = [Instruction::Add, Instruction::Mul].map(Word::from);
        for words in [&[add, mul][..], &[add, Word::MultiplyAdd]] {
            // Inputs 0.5 of 1 and 8 of 4, outputs of ±2: 2 (3 · 0.5 + 1 · 2 − 1) = 5, and 2 · 2 = 4.
            let weights = [3.0, 1.0, -1.0, 0.0, 1.0, 0.0];
            assert_eq!(values(StartKind::Linear, words, 2, 0, &weights), [5.0, 4.0]);
            assert_eq!(values(StartKind::Linear, words, 0, 3, &weights), [0.0, 2.5, 2.0], "the first bid stays 0");
        }
    }

    #[test]
    fn a_product_multiplies_two_sums() {
        let [add, mul] = [Instruction::Add, Instruction::Mul].map(Word::from);
        for words in [&[add, mul][..], &[add, mul, Word::MultiplyAdd]] {
            // Outputs of ±2, and a bid without a unit: (3 · 0.5 + 1 · 2 − 1) (0 · 0.5 + 1 · 2 + 1).
            let weights = [3.0, 1.0, -1.0, 0.0, 1.0, 1.0];
            assert_eq!(values(StartKind::Product, words, 1, 0, &weights), [15.0]);
            assert_eq!(values(StartKind::Product, words, 0, 2, &weights), [0.0, 7.5]);
        }
    }

    #[test]
    fn scores_within_the_tolerance_of_the_best_are_one_group() {
        assert_eq!(groups(&[9.0, 8.9, 8.6, 8.4, 1.0], 0.5), [3, 1, 1]);
        assert_eq!(groups(&[9.0, 9.0, 8.0], 0.0), [1, 1, 1], "no tolerance: ranks alone");
        assert_eq!(groups(&[f64::INFINITY, 1.0, f64::NEG_INFINITY, f64::NAN], 0.5), [1; 4]);
    }

    #[test]
    fn what_cannot_be_written_is_refused_with_its_key() {
        let refused = |vocabulary: &Vocabulary, kind| LinearWriter::new(vocabulary, 0, kind).expect_err("no sums").key;
        let key = |vocabulary: &Vocabulary| refused(vocabulary, StartKind::Linear);
        assert_eq!(key(&vocabulary(&[Instruction::Mul.into()], 1)), "language.instructions");
        let source = SourceDocument { name: "s".into(), length: 1, unit: "1".into(), ranges: vec![[-1.0, 1.0]] };
        let words = vec![Instruction::Add.into(), Word::MultiplyAdd];
        let without = Vocabulary::new(words.clone(), 4, 0, std::slice::from_ref(&source), None, ScalarType::F64);
        assert_eq!(key(&without), "language.literals");
        let registers = |count, words: &[Word]| {
            Vocabulary::new(words.to_vec(), count, 0, std::slice::from_ref(&source), Some(vec![1.0]), ScalarType::F64)
        };
        assert_eq!(key(&registers(1, &words)), "learning.nb_registers");
        assert_eq!(refused(&registers(4, &words), StartKind::Product), "language.instructions");
        let words = [Instruction::Add.into(), Instruction::Mul.into()];
        assert_eq!(refused(&registers(2, &words), StartKind::Product), "learning.nb_registers");
    }
}
