//! Validity of configurations.

use super::{EvolutionConfig, StartKind};
use crate::evolution::linear::{LinearWriter, MOST_WEIGHTS};
use crate::evolution::vocabulary::Vocabulary;
use crate::hybrid::trial::NETWORK;
use tpg_engine::{ActionSpace, Environment};
use tpg_graph::Word;
use tpg_graph::error::Finding;
use tpg_runtime::ops::Instruction;
use tpg_runtime::scalar::Scalar;

impl EvolutionConfig {
    /// Checks ranges, names and consistency.
    ///
    /// # Errors
    /// The first invalid parameter.
    pub(super) fn check(&self) -> Result<(), Finding> {
        let number = Finding::range::<f64>;
        let probability = |key: &str, value: f64| number(key, value, 0.0, 1.0);
        let count = Finding::range::<usize>;
        const MANY: usize = 1_000_000;
        self.check_instructions()?;
        if let Some(ask) = &self.ask {
            number("ask.price", ask.price, 0.0, 1e9)?;
        }
        let tpg = &self.tpg;
        count("tpg.nb_roots", tpg.nb_roots, 2, MANY)?;
        count("tpg.init_nb_roots", tpg.init_nb_roots, 2, MANY)?;
        count("tpg.max_init_outgoing_edges", tpg.max_init_outgoing_edges, 2, 1000)?;
        count("tpg.max_outgoing_edges", tpg.max_outgoing_edges, tpg.max_init_outgoing_edges, 1000)?;
        probability("tpg.p_edge_deletion", tpg.p_edge_deletion)?;
        probability("tpg.p_edge_addition", tpg.p_edge_addition)?;
        // With 0, GEGELATI would never stop: rounds repeat until a program is mutated.
        number("tpg.p_program_mutation", tpg.p_program_mutation, 1e-3, 1.0)?;
        probability("tpg.p_edge_destination_change", tpg.p_edge_destination_change)?;
        probability("tpg.p_edge_destination_is_action", tpg.p_edge_destination_is_action)?;

        let program = &self.program;
        count("program.max_program_size", program.max_program_size, 1, 1000)?;
        let chances = [
            ("program.p_delete", program.p_delete),
            ("program.p_add", program.p_add),
            ("program.p_mutate", program.p_mutate),
            ("program.p_swap", program.p_swap),
            ("program.p_constant_mutation", program.p_constant_mutation),
            ("program.p_new_program", program.p_new_program),
            ("program.p_product", program.p_product),
        ];
        chances.iter().try_for_each(|(key, value)| probability(key, *value))?;
        if program.p_mutate + program.p_new_program <= 0.0 {
            let accepted = "above 0, or program.p_new_program above 0: a mutation must be able to change a program";
            return Err(Finding::new("program.p_mutate", program.p_mutate.to_string(), accepted.to_owned()));
        }
        if program.min_const_value > program.max_const_value {
            let accepted = format!("at most program.max_const_value, {}", program.max_const_value);
            return Err(Finding::new("program.min_const_value", program.min_const_value.to_string(), accepted));
        }

        self.check_products()?;
        let learning = &self.learning;
        count("learning.archive_size", learning.archive_size, 0, MANY)?;
        probability("learning.archiving_probability", learning.archiving_probability)?;
        let episodes = learning.nb_iterations_per_policy_evaluation;
        count("learning.nb_iterations_per_policy_evaluation", episodes, 1, MANY)?;
        number("learning.ratio_deleted_roots", learning.ratio_deleted_roots, 0.0, 0.999)?;
        count("learning.nb_generations", learning.nb_generations as usize, 1, MANY)?;
        count("learning.max_nb_evaluation_per_policy", learning.max_nb_evaluation_per_policy as usize, 1, usize::MAX)?;
        count("learning.nb_registers", learning.nb_registers.into(), 1, 256)?;
        count("learning.nb_program_constant", learning.nb_program_constant.into(), 0, 256)?;

        let selection = &self.selection;
        count("selection.tournament_size", selection.tournament_size, 1, tpg.nb_roots)?;
        count("selection.lexicase_survivors", selection.lexicase_survivors, 0, self.survivors())?;
        count("selection.lexicase_candidates", selection.lexicase_candidates, 1, MANY)?;
        number("selection.lexicase_tolerance", selection.lexicase_tolerance, 0.0, 1e9)?;
        count("selection.racing_episodes", selection.racing_episodes, 0, episodes - 1)?;
        probability("selection.racing_share", selection.racing_share)?;
        count("selection.validation_roots", selection.validation_roots, 1, tpg.nb_roots)?;
        count("selection.validation_episodes", selection.validation_episodes, 1, MANY)?;
        number("selection.validation_share", selection.validation_share, 0.001, 0.9)?;

        number("selection.line_price", selection.line_price, 0.0, 1.0)?;
        number("selection.choice_errors", selection.choice_errors, 0.0, 100.0)?;
        count("selection.flat_after", selection.flat_after, 0, MANY)?;
        self.check_start()?;
        if self.literals.deviations.is_empty() || self.literals.deviations.iter().any(|d| !(1e-9..=1e9).contains(d)) {
            let found = format!("{:?}", self.literals.deviations);
            return Err(Finding::new("literals.deviations", found, "at least one, each 1e-9 to 1e9".to_owned()));
        }
        let leaves = &self.leaves;
        count("leaves.max_program_size", leaves.max_program_size, 1, 1000)?;
        count("leaves.rounds", leaves.rounds, 1, 100)?;
        for (key, value) in [
            ("leaves.p_literals", leaves.p_literals),
            ("leaves.p_bid", leaves.p_bid),
            ("leaves.p_edge_deletion", leaves.p_edge_deletion),
            ("leaves.p_edge_addition", leaves.p_edge_addition),
            ("leaves.p_team", leaves.p_team),
        ] {
            probability(key, value)?;
        }
        if leaves.refinements.is_empty() || leaves.refinements.iter().any(|it| !(0.0..=10.0).contains(it)) {
            let found = format!("{:?}", leaves.refinements);
            return Err(Finding::new("leaves.refinements", found, "at least one, each 0 to 10"));
        }
        probability("literals.change", self.literals.change)?;
        number("literals.scaling", self.literals.scaling, 0.0, 100.0)?;
        count("demes.count", self.demes.count, 1, 1000)?;
        count("demes.migration_interval", self.demes.migration_interval as usize, 1, MANY)?;
        count("demes.migrants", self.demes.migrants, 0, self.survivors())?;
        count("demes.halving_interval", self.demes.halving_interval as usize, 0, MANY)?;
        if self.demes.halving_interval > 0 && learning.archive_size > 0 {
            let accepted = "0, with an archive: its recordings belong to demes";
            return Err(Finding::new("demes.halving_interval", self.demes.halving_interval, accepted));
        }
        count("pool.size", self.pool.size, 0, MANY)?;
        probability("pool.share", self.pool.share)?;
        let curriculum = &self.curriculum;
        let last = self.learning.nb_generations - 1;
        count("curriculum.generations", curriculum.generations as usize, 0, last as usize)?;
        count("curriculum.roughness", curriculum.roughness.into(), 1, 127)?;
        if self.pool.share > 0.0 && self.pool.size == 0 {
            let accepted = "0, or a pool.size above 0".to_owned();
            return Err(Finding::new("pool.share", self.pool.share.to_string(), accepted));
        }
        Ok(())
    }

    /// Checks that products of inputs can be written, if they are wanted.
    fn check_products(&self) -> Result<(), Finding> {
        let needed = [Word::from(Instruction::Mul), Word::MultiplyAdd];
        let has = |word: &Word| self.language.instructions.iter().any(|name| name == word.name());
        let room = self.learning.nb_registers >= 2 && self.program.max_program_size >= 2;
        if self.program.p_product <= 0.0 || (self.language.literals && needed.iter().all(has) && room) {
            return Ok(());
        }
        let accepted = "0, or the words mul and multiply_add, literals, two registers and two lines";
        Err(Finding::new("program.p_product", self.program.p_product, accepted))
    }

    /// Checks the settings of the first population and of small changes.
    fn check_start(&self) -> Result<(), Finding> {
        let count = Finding::range::<usize>;
        let start = &self.start;
        let last = self.learning.nb_generations.saturating_sub(1);
        if start.kind != StartKind::Random && start.generations > 0 {
            Finding::range("start.generations", start.generations, 2, last)?;
        }
        let [first, second] = start.share;
        if !(0.0 <= first && first <= second && second <= 1.0) {
            return Err(Finding::new("start.share", format!("{:?}", start.share), "two numbers of 0 to 1, ascending"));
        }
        Finding::range("start.random", start.random, 0.0, first)?;
        count("start.searches", start.searches, 1, 100)?;
        if start.samples != 0 {
            count("start.samples", start.samples, 4, 10_000)?;
        }
        count("start.breadth", start.breadth, 1, 100)?;
        count("start.episodes", start.episodes, 1, 1_000_000)?;
        Finding::range("start.deviation", start.deviation, 1e-6, 1e3)?;
        Finding::range("start.tie", start.tie, 0.0, 0.5)?;
        count("start.demes", start.demes, 1, self.demes.count)?;
        let refinement = &self.refinement;
        Finding::range("refinement.p_jitter", refinement.p_jitter, 0.0, 1.0)?;
        Finding::range("refinement.p_deletion", refinement.p_deletion, 0.0, 1.0 - refinement.p_jitter)?;
        Finding::range("refinement.p_mutation", refinement.p_mutation, 0.0, 1.0)?;
        Finding::range("refinement.p_mirror", refinement.p_mirror, 0.0, 1.0)?;
        let sub = Word::from(Instruction::Sub).name();
        let negates = self.language.literals && self.language.instructions.iter().any(|word| word == sub);
        if refinement.p_mirror > 0.0 && !negates {
            let accepted = "0, or the word sub in language.instructions and language.literals = true";
            return Err(Finding::new("refinement.p_mirror", refinement.p_mirror, accepted));
        }
        let [low, high] = refinement.deviations;
        if !(1e-6 <= low && low <= high && high <= 10.0) {
            let found = format!("{:?}", refinement.deviations);
            return Err(Finding::new("refinement.deviations", found, "two numbers of 0.000001 to 10, ascending"));
        }
        count("refinement.elite", refinement.elite, 0, self.tpg.nb_roots / 2)
    }

    /// Checks that an environment keeps the memory that policies have.
    ///
    /// # Errors
    /// If it does not.
    pub fn check_memory<S: Scalar>(&self, environment: &impl Environment<S>) -> Result<(), Finding> {
        let found = self.language.memory;
        if found > 0 && environment.actions().outputs().is_empty() {
            return Err(Finding::new("language.memory", found.to_string(), "0, for a problem without outputs"));
        }
        let kept = tpg_engine::remembered(&environment.sources(), &environment.actions());
        if usize::from(found) == kept {
            return Ok(());
        }
        let accepted = format!("{kept}, which the environment keeps: see tpg_engine::Remembering");
        Err(Finding::new("language.memory", found.to_string(), accepted))
    }

    /// Checks that a linear start can be written for an environment: its weights, lines and edges.
    ///
    /// # Errors
    /// The first parameter that does not fit.
    pub fn check_linear<S: Scalar>(&self, environment: &impl Environment<S>) -> Result<(), Finding> {
        if self.start.kind == StartKind::Random {
            return Ok(());
        }
        let values: usize = environment.sources().iter().map(|source| source.length as usize).sum();
        let vocabulary = self.vocabulary(environment, vec![1.0; values]);
        self.check_programs(&vocabulary, environment.actions().count().unwrap_or(0), self.start.kind).map(|_| ())
    }

    /// Checks that programs can be the sums or products that a search finds for `actions` actions, 0 with outputs; returns the
    /// number of its weights.
    pub(in crate::evolution) fn check_programs(
        &self,
        vocabulary: &Vocabulary,
        actions: usize,
        kind: StartKind,
    ) -> Result<usize, Finding> {
        let writer = LinearWriter::new(vocabulary, actions as u16, kind)?;
        let weights = writer.weights();
        if weights > MOST_WEIGHTS {
            let found = format!("a start with {weights} weights");
            return Err(Finding::new("start.kind", found, format!("random, or at most {MOST_WEIGHTS} weights")));
        }
        let lines = writer.lines();
        if actions == 0 {
            Finding::range("leaves.max_program_size", self.leaves.max_program_size, lines, 1000)?;
            return Ok(weights);
        }
        Finding::range("program.max_program_size", self.program.max_program_size, lines, 1000)?;
        Finding::range("tpg.max_outgoing_edges", self.tpg.max_outgoing_edges, actions, 1000)?;
        Ok(weights)
    }

    /// Returns what a search looks for that begins after so many others by covariance matrix adaptation: in turns sums and, where
    /// programs can be that, products; `None` is a random search, for sums.
    pub(in crate::evolution) fn search_kind(
        &self,
        vocabulary: &Vocabulary,
        actions: u16,
        before: Option<u64>,
    ) -> StartKind {
        let can_be = |kind| self.check_programs(vocabulary, actions.into(), kind).is_ok();
        match before {
            None => StartKind::Linear,
            Some(before) if before % 2 == 1 && can_be(StartKind::Product) => StartKind::Product,
            Some(_) => self.start.kind,
        }
    }

    /// Checks the environment-dependent conditions: there are outputs, or actions are named and there are enough roots and
    /// edges for them.
    ///
    /// # Errors
    /// The first parameter that does not fit these actions.
    pub fn check_actions(&self, actions: &ActionSpace) -> Result<(), Finding> {
        if self.ask.is_some() && actions.asking(NETWORK).is_none() {
            let accepted = "none, or an environment with that action: tpg_train::hybrid::asking::Asking";
            return Err(Finding::new("ask", "a section [ask] for an environment that nobody can ask", accepted));
        }
        if !actions.outputs().is_empty() {
            let accepted = "0: programs of leaves are not compared with an archive";
            let size = self.learning.archive_size;
            return if size == 0 { Ok(()) } else { Err(Finding::new("learning.archive_size", size, accepted)) };
        }
        let Some(count) = actions.count() else {
            let accepted = "named actions: tpg_engine::Choices converts any action space";
            return Err(Finding::new("problem", "actions that are not a list of names", accepted));
        };
        Finding::range("problem.actions", count, 2, 1 << 16)?;
        Finding::range("tpg.init_nb_roots", self.tpg.init_nb_roots, count, usize::MAX)
    }

    /// Checks that each instruction exists and occurs once.
    fn check_instructions(&self) -> Result<(), Finding> {
        let names = &self.language.instructions;
        let accepted = || format!("one or more of {}, each once", Word::ALL.map(Word::name).join(", "));
        if names.is_empty() {
            return Err(Finding::new("language.instructions", "an empty list", accepted()));
        }
        let wrong =
            |&(place, name): &(usize, &String)| Word::from_name(name).is_none() || names[..place].contains(name);
        match names.iter().enumerate().find(wrong) {
            Some((_, name)) => Err(Finding::new("language.instructions", format!("{name:?}"), accepted())),
            None => Ok(()),
        }
    }
}
