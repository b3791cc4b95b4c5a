//! Validity of a state that was read from a checkpoint: the indices and lengths that everything behind it relies on. Damage is noticed
//! by the checkpoint's checksum; this keeps a crafted file from ending in a panic.

use super::config::EvolutionConfig;
use super::genome::{Destination, Edge, GenomeLine, Leaf, LeafId, Program, Team, TeamId};
use super::population::Deme;
use super::record::Record;
use super::stage::Context;
use super::state::{Best, State};
use super::vocabulary::Gene;
use tpg_engine::Environment;
use tpg_graph::error::Finding;
use tpg_runtime::scalar::Scalar;

/// No run counts further: sums of two such counts do not overflow, and `f64` holds them exactly.
const MAX_COUNT: u64 = 1 << 53;
/// Teams and programs of a deme are numbered below this: a root's number in its run has 40 bits for it.
const MAX_NUMBER: u64 = 1 << 40;

impl<Task: std::fmt::Debug> State<Task> {
    /// Checks that a run with this configuration can go on from this state.
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
        let inputs = environment.sources().iter().map(|source| source.length as usize).sum();
        let space = environment.actions();
        Finding::range("steps", self.steps, 0, MAX_COUNT)?;
        Finding::range("selection_steps", self.selection_steps, 0, self.steps)?;
        Finding::range("episode_steps", self.episode_steps, 0, MAX_COUNT)?;
        Finding::range("generation", self.generation, 0, 1_000_000_000)?;
        equal("rows", self.rows.len() as u64, self.generation)?;
        equal("scales", self.scales.len(), inputs)?;
        let vocabulary = config.vocabulary(environment, self.scales.clone());
        let actions = space.count().unwrap_or(0);
        let context = Context {
            config,
            vocabulary: &vocabulary,
            actions: actions as u16,
            opposites: &[],
            preference: environment.preference(),
            line_price: 0.0,
            left: 1.0,
            samples: 8,
        };
        if !self.budget.is_valid(self.generation) {
            return Err(Finding::new("budget", format!("{:?}", self.budget), "generations of the run"));
        }
        for search in self.search.iter().chain(&self.stalled) {
            search.check(&context)?;
        }
        let demes = &self.population.demes;
        Finding::range("population.demes", demes.len(), 1, config.demes.count)?;
        if let Some(place) = demes.iter().position(|deme| !is_valid(deme, &context)) {
            let key = format!("population.demes[{place}]");
            return Err(Finding::new(key, "an index of nothing", "teams and programs of the configuration"));
        }
        if let Some(place) = self.pool.iter().position(|task| !environment.accepts(task)) {
            let key = format!("pool[{place}]");
            return Err(Finding::new(key, format!("{:?}", self.pool[place]), "a task of the problem"));
        }
        let best = |best: &Best| {
            if best.ranges.as_ref().is_some_and(|all| all.len() != inputs || all.iter().any(|[low, high]| low > high)) {
                return Err(Finding::new("ranges", "other ranges", format!("{inputs} of a low and a high end")));
            }
            let policy = best.policy.check(vocabulary.policy_registers(), inputs, &space);
            policy.map_err(|finding| finding.within("policy"))
        };
        self.best.as_ref().map_or(Ok(()), best).map_err(|finding| finding.within("best"))?;
        (self.hall.iter().enumerate()).try_for_each(|(place, candidate)| {
            best(candidate).map_err(|finding| finding.within(&format!("hall[{place}]")))
        })
    }
}

fn equal<T: PartialEq + std::fmt::Display>(key: &str, found: T, accepted: T) -> Result<(), Finding> {
    if found == accepted { Ok(()) } else { Err(Finding::new(key, found, accepted.to_string())) }
}

/// True if every number of a team, program or leaf is one of the deme's, and every index of a line is one of the language's.
fn is_valid(Deme { genome, records }: &Deme, context: &Context<'_>) -> bool {
    let (next, programs) = (genome.newest(), genome.programs());
    let is_number = |id: u64| (1..=next).contains(&id);
    let is_edge = |from: TeamId, edge: &Edge| {
        programs.contains_key(&edge.program)
            && match edge.to {
                Destination::Action(action) => action < context.actions,
                Destination::Leaf(leaf) => genome.leaves().contains_key(&leaf),
                // Edges lead to older teams only: there is no cycle.
                Destination::Team(to) => to < from && genome.teams().contains_key(&to),
            }
    };
    let is_team = |(&id, team): (&TeamId, &Team)| {
        is_number(id.0)
            && (1..=context.config.tpg.max_outgoing_edges).contains(&team.edges.len())
            && team.edges.iter().all(|edge| is_edge(id, edge))
    };
    let is_leaf = |(id, leaf): (&LeafId, &Leaf)| {
        is_number(id.0)
            && leaf.programs.len() == context.vocabulary.outputs().len()
            && leaf.programs.iter().all(|program| programs.contains_key(program))
    };
    let is_record =
        |(team, record): (&TeamId, &Record)| genome.teams().contains_key(team) && record.evaluations <= MAX_COUNT;
    next <= MAX_NUMBER
        && genome.teams().iter().all(is_team)
        && genome.leaves().iter().all(is_leaf)
        && programs.iter().all(|(id, program)| is_number(id.0) && is_program(program, context))
        && records.iter().all(is_record)
}

fn is_program(program: &Program, context: &Context<'_>) -> bool {
    let vocabulary = context.vocabulary;
    let is_gene = |gene: &Gene| {
        usize::from(gene.source) < vocabulary.sources() && gene.location < vocabulary.largest_address_space()
    };
    let is_line = |line: &GenomeLine| {
        usize::from(line.instruction) < vocabulary.instructions().len()
            && line.to < vocabulary.registers()
            && line.operands.iter().all(is_gene)
    };
    (1..=context.config.program.leaf_lines()).contains(&program.lines.len()) && program.lines.iter().all(is_line)
}
