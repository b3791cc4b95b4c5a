//! Validity of a state that was read from a checkpoint. Everything behind it relies on these conditions.

use super::config::{EvolutionConfig, StartKind};
use super::genome::{Destination, Edge, Genome, Program, TeamId};
use super::linear::{LinearWriter, Method, Search};
use super::milestones::Begin;
use super::state::{Best, Deme, State};
use super::vocabulary::Vocabulary;
use tpg_engine::{ActionSpace, Environment};
use tpg_graph::error::Finding;
use tpg_runtime::scalar::Scalar;

/// No run counts further: sums of two such counts do not overflow, and `f64` holds them exactly.
const MOST: u64 = 1 << 53;
/// Teams and programs of a deme are numbered below this: a root's number in its run has 40 bits for it.
const MOST_NUMBERS: u64 = 1 << 40;

impl<Task: std::fmt::Debug> State<Task> {
    /// Checks that a run with this configuration can be in this state.
    ///
    /// # Errors
    /// The first index without its object, or value out of range; keys begin with `state`.
    pub fn check<S: Scalar, E: Environment<S, Task = Task>>(
        &self,
        config: &EvolutionConfig,
        environment: &E,
    ) -> Result<(), Finding> {
        self.check_parts::<S, E>(config, environment).map_err(|finding| finding.within("state"))
    }

    fn check_parts<S: Scalar, E: Environment<S, Task = Task>>(
        &self,
        config: &EvolutionConfig,
        environment: &E,
    ) -> Result<(), Finding> {
        let sources = environment.sources();
        let lengths = |count: usize| sources[..count].iter().map(|source| source.length as usize).sum::<usize>();
        let inputs = lengths(sources.len());
        let space = environment.actions();
        let actions = space.count().unwrap_or(0);
        for (key, count) in [
            ("training_episodes", self.training_episodes),
            ("selection_episodes", self.selection_episodes),
            ("steps", self.steps),
            ("episode_steps", self.episode_steps),
        ] {
            Finding::range(key, count, 0, MOST)?;
        }
        Finding::range("selection_steps", self.selection_steps, 0, self.steps)?;
        Finding::range("generation", self.generation, 0, 1_000_000)?;
        equal("rows", self.rows.len() as u64, self.generation)?;
        for (place, row) in (0..).zip(&self.rows) {
            equal(&format!("rows[{place}].generation"), row.generation, place)?;
        }
        equal("scales", self.scales.len(), lengths(tpg_engine::bid_bounds(&sources).unwrap_or(sources.len())))?;
        let vocabulary = config.vocabulary(environment, self.scales.clone());
        let writer = LinearWriter::new(&vocabulary, actions as u16, config.start.kind);
        self.milestones.check(config, self.generation, self.steps)?;
        let usual = config.linear_generations(writer.map_or(0, |writer| writer.weights()));
        let linear = config.linear_end(usual, &self.milestones).unwrap_or(u64::MAX);
        equal("demes", self.demes.len(), config.demes_at(self.generation, linear))?;
        let limits = Limits { config, vocabulary: &vocabulary, actions };
        for (place, deme) in self.demes.iter().enumerate() {
            // During a linear start no deme needs to have teams; after it every one has.
            if self.generation > linear && deme.genome.teams().is_empty() {
                return Err(Finding::new(format!("demes[{place}].genome.teams"), "no team", "one or more"));
            }
            limits.deme(deme).map_err(|finding| finding.within(&format!("demes[{place}]")))?;
        }
        self.check_searches(config, &vocabulary, actions, usual)?;
        equal("archive.size", self.archive.size(), config.learning.archive_size)?;
        self.archive.check(self.demes.len(), inputs).map_err(|finding| finding.within("archive"))?;
        Finding::range("pool", self.pool.len(), 0, config.pool.size)?;
        if let Some(place) = self.pool.iter().position(|task| !environment.accepts(task)) {
            let key = format!("pool[{place}]");
            return Err(Finding::new(key, format!("{:?}", self.pool[place]), "a task of the problem"));
        }
        let best = |best| check_best(best, self.generation, config, inputs, &space);
        self.best.as_ref().map_or(Ok(()), best).map_err(|finding| finding.within("best"))?;
        (self.hall.iter().enumerate())
            .try_for_each(|(place, of)| best(of).map_err(|finding| finding.within(&format!("hall[{place}]"))))
    }
}

impl<Task> State<Task> {
    fn check_searches(
        &self,
        config: &EvolutionConfig,
        vocabulary: &Vocabulary,
        actions: usize,
        usual: u64,
    ) -> Result<(), Finding> {
        let accepted = match self.generation {
            0 => [0, 0],
            _ if usual == 0 => [0, 0],
            generation => match config.linear_choice(usual, &self.milestones) {
                Some(chosen) if generation > chosen => [1, 1],
                // The old ones stay until the next generation.
                _ if self.milestones.begun.is_some_and(|begun| begun.generation == generation) => [1, 1],
                // A random search is alone.
                _ if matches!(self.searches[..], [Search { method: Method::Random(_), .. }, ..]) => [1, 1],
                _ => [config.start.searches; 2],
            },
        };
        Finding::range("searches", self.searches.len(), accepted[0], accepted[1])?;
        let has_stalled = |begun: Begin| begun.searches > 1 || begun.generation < self.generation;
        if self.stalled.is_some() != self.milestones.begun.is_some_and(has_stalled) {
            let found = if self.stalled.is_some() { "a search" } else { "none" };
            return Err(Finding::new("stalled", found, "a search if, and only if, another one has begun since"));
        }
        if self.searches.is_empty() {
            return Ok(());
        }
        let searches = (self.searches.iter().enumerate()).map(|(place, search)| (format!("searches[{place}]"), search));
        for (key, search) in searches.chain(self.stalled.iter().map(|search| ("stalled".to_owned(), search))) {
            let weights = match (search.kind, &search.method) {
                // A random search looks for sums.
                (StartKind::Random, _) | (StartKind::Product, Method::Random(_)) => None,
                (kind, _) => config.check_programs(vocabulary, actions, kind).ok(),
            };
            let Some(weights) = weights else {
                let found = format!("{:?}", search.kind).to_lowercase();
                return Err(Finding::new(format!("{key}.kind"), found, "what programs can be"));
            };
            match &search.method {
                Method::Cma(cma) => (cma.check(weights, config.start.covariance))
                    .map_err(|finding| finding.within(&format!("{key}.method.cma")))?,
                Method::Random(random) => {
                    let writer = LinearWriter::new(vocabulary, actions as u16, search.kind)?;
                    (random.check(writer.rows(), writer.inputs()))
                        .map_err(|finding| finding.within(&format!("{key}.method.random")))?;
                }
            }
            Finding::range(&format!("{key}.score"), search.score, -1e30, 1e30)?;
        }
        Ok(())
    }
}

fn check_best(
    best: &Best,
    generation: u64,
    config: &EvolutionConfig,
    inputs: usize,
    space: &ActionSpace,
) -> Result<(), Finding> {
    if best.generation >= generation {
        return Err(Finding::new("generation", best.generation, format!("below {generation}")));
    }
    Finding::range("error", best.error, 0.0, 1e30)?;
    if let Some(ranges) = &best.ranges {
        equal("ranges", ranges.len(), inputs)?;
        if let Some(place) = ranges.iter().position(|[low, high]| low > high) {
            return Err(Finding::new(
                format!("ranges[{place}]"),
                format!("{:?}", ranges[place]),
                "a low and a high end",
            ));
        }
    }
    let policy = best.policy.check(config.learning.nb_registers, inputs, space);
    policy.map_err(|finding| finding.within("policy"))
}

fn equal<T: PartialEq + std::fmt::Display>(key: &str, found: T, accepted: T) -> Result<(), Finding> {
    if found == accepted { Ok(()) } else { Err(Finding::new(key, found, accepted.to_string())) }
}

/// Bounds of a deme's indices.
struct Limits<'a> {
    config: &'a EvolutionConfig,
    vocabulary: &'a Vocabulary,
    actions: usize,
}

impl Limits<'_> {
    fn deme(&self, deme: &Deme) -> Result<(), Finding> {
        self.genome(&deme.genome).map_err(|finding| finding.within("genome"))?;
        for (&team, record) in &deme.records {
            let key = format!("records.{}", team.0);
            if !deme.genome.teams().contains_key(&team) {
                return Err(Finding::new(key, "a record of no team", "records of the deme's teams"));
            }
            Finding::range(&format!("{key}.evaluations"), record.evaluations, 0, MOST)?;
        }
        Ok(())
    }

    fn genome(&self, genome: &Genome) -> Result<(), Finding> {
        let next = genome.newest();
        Finding::range("next", next, 0, MOST_NUMBERS)?;
        for (&id, team) in genome.teams() {
            let key = format!("teams.{}", id.0);
            Finding::range(&key, id.0, 1, next)?;
            let most = self.config.tpg.max_outgoing_edges;
            Finding::range(&format!("{key}.edges"), team.edges.len(), 1, most)?;
            for (place, edge) in team.edges.iter().enumerate() {
                self.edge(genome, id, edge).map_err(|finding| finding.within(&format!("{key}.edges[{place}]")))?;
            }
        }
        for (id, leaf) in genome.leaves() {
            let key = format!("leaves.{}", id.0);
            Finding::range(&key, id.0, 1, next)?;
            equal(&format!("{key}.programs"), leaf.programs.len(), self.vocabulary.outputs().len())?;
            if let Some(program) = leaf.programs.iter().find(|program| !genome.programs().contains_key(program)) {
                return Err(Finding::new(format!("{key}.programs"), program.0, "the numbers of programs"));
            }
        }
        for (id, program) in genome.programs() {
            let key = format!("programs.{}", id.0);
            Finding::range(&key, id.0, 1, next)?;
            self.program(program).map_err(|finding| finding.within(&key))?;
        }
        Ok(())
    }

    /// Edges lead to older teams only: new teams are made of edges to those that exist.
    fn edge(&self, genome: &Genome, from: TeamId, edge: &Edge) -> Result<(), Finding> {
        if !genome.programs().contains_key(&edge.program) {
            return Err(Finding::new("program", edge.program.0, "the number of a program"));
        }
        match edge.to {
            Destination::Action(action) => Finding::below("to.Action", action.into(), self.actions),
            Destination::Leaf(leaf) if genome.leaves().contains_key(&leaf) => Ok(()),
            Destination::Leaf(leaf) => Err(Finding::new("to.Leaf", leaf.0, "the number of a leaf")),
            Destination::Team(to) if to < from && genome.teams().contains_key(&to) => Ok(()),
            Destination::Team(to) => Err(Finding::new("to.Team", to.0, format!("a team before {}", from.0))),
        }
    }

    fn program(&self, program: &Program) -> Result<(), Finding> {
        let Self { config, vocabulary, .. } = *self;
        equal("constants", program.constants.len(), usize::from(vocabulary.constants()))?;
        let most = match vocabulary.outputs() {
            [] => config.program.max_program_size,
            _ => config.program.max_program_size.max(config.leaves.max_program_size),
        };
        Finding::range("lines", program.lines.len(), 1, most)?;
        for (place, line) in program.lines.iter().enumerate() {
            let key = |name: &str| format!("lines[{place}].{name}");
            Finding::below(&key("instruction"), line.instruction.into(), vocabulary.instructions().len())?;
            Finding::below(&key("to"), line.to.into(), vocabulary.registers().into())?;
            for (operand, gene) in line.operands.iter().enumerate() {
                let key = |name: &str| key(&format!("operands[{operand}].{name}"));
                Finding::below(&key("source"), gene.source.into(), vocabulary.sources())?;
                let space = vocabulary.largest_address_space();
                Finding::below(&key("location"), gene.location.into(), space.into())?;
            }
        }
        Ok(())
    }
}
