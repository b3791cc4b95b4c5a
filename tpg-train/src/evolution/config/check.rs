//! Presets, and the validity of configurations.

use super::EvolutionConfig;
use crate::configuration::{Configuration, Preset};
use crate::evolution::vocabulary::ProgramInstruction;
use crate::evolution::{params, presets};
use tpg_engine::Environment;
use tpg_graph::Word;
use tpg_graph::error::{Finding, InputError};
use tpg_problems::{PolicyKind, ProblemName};
use tpg_runtime::ops::Instruction;
use tpg_runtime::scalar::Scalar;

impl Configuration for EvolutionConfig {
    const PRESETS: &'static [Preset] = &presets::PRESETS;
    const KIND: PolicyKind = PolicyKind::Graph;
    const PRINTED_BY: &'static str = "tpg-train config";

    fn default_preset(problem: ProblemName) -> &'static str {
        match problem {
            ProblemName::Fs => "best-fs",
            ProblemName::Rs => "best-rs",
            ProblemName::Dodge => "dodge",
            ProblemName::Breakout | ProblemName::Asterix | ProblemName::Freeway | ProblemName::Eye => "images",
            _ => "thorough",
        }
    }

    fn from_other(file: &str, text: &str) -> Option<Result<(toml::Table, &'static str), InputError>> {
        params::is_json(text).then(|| Ok((params::settings(file, text)?, params::PRESET)))
    }

    fn check(&self) -> Result<(), Finding> {
        const MANY: usize = 1_000_000;
        let Self { tpg, program, learning, selection, start, refinement, .. } = self;
        self.check_instructions()?;
        let episodes = learning.nb_iterations_per_policy_evaluation;
        let last = if learning.nb_generations == 0 { u64::MAX } else { learning.nb_generations - 1 };
        for (key, value, low, high) in [
            ("tpg.nb_roots", tpg.nb_roots, 2, MANY),
            ("tpg.init_nb_roots", tpg.init_nb_roots, 2, MANY),
            ("tpg.max_init_outgoing_edges", tpg.max_init_outgoing_edges, 2, 1000),
            ("tpg.max_outgoing_edges", tpg.max_outgoing_edges, tpg.max_init_outgoing_edges, 1000),
            ("program.max_program_size", program.max_program_size, 1, 1000),
            ("learning.nb_iterations_per_policy_evaluation", episodes, 1, MANY),
            ("learning.nb_generations", learning.nb_generations as usize, 0, MANY),
            ("learning.max_nb_evaluation_per_policy", learning.max_nb_evaluation_per_policy as usize, 1, usize::MAX),
            ("learning.nb_registers", learning.nb_registers.into(), 1, 256),
            ("selection.lexicase_survivors", selection.lexicase_survivors, 0, self.survivors()),
            ("selection.racing_episodes", selection.racing_episodes, 0, episodes - 1),
            ("selection.validation_episodes", selection.validation_episodes, 1, MANY),
            ("curriculum.generations", self.curriculum.generations as usize, 0, last as usize),
            ("curriculum.roughness", self.curriculum.roughness.into(), 1, 127),
        ] {
            Finding::range(key, value, low, high)?;
        }
        for (key, value, low, high) in [
            ("ask.price", self.ask.as_ref().map_or(0.0, |ask| ask.price), 0.0, 1e9),
            ("tpg.p_edge_destination_change", tpg.p_edge_destination_change, 0.0, 1.0),
            ("tpg.p_edge_destination_is_action", tpg.p_edge_destination_is_action, 0.0, 1.0),
            ("program.p_swap", program.p_swap, 0.0, 1.0),
            ("program.p_product", program.p_product, 0.0, 1.0),
            ("learning.ratio_deleted_roots", learning.ratio_deleted_roots, 0.0, 0.999),
            ("selection.validation_share", selection.validation_share, 0.001, 0.9),
            ("selection.line_price", selection.line_price, 0.0, 1.0),
            ("pool.share", self.pool.share, 0.0, 1.0),
            ("start.share", start.share, 0.0, 1.0),
            ("start.random", start.random, 0.0, 1.0),
            ("refinement.p_jitter", refinement.p_jitter, 0.0, 1.0),
            ("refinement.p_deletion", refinement.p_deletion, 0.0, 1.0 - refinement.p_jitter),
            ("refinement.p_mutation", refinement.p_mutation, 0.0, 1.0),
            ("refinement.p_mirror", refinement.p_mirror, 0.0, 1.0),
        ] {
            Finding::range(key, value, low, high)?;
        }
        if self.literals.deviations.is_empty() || self.literals.deviations.iter().any(|d| !(1e-9..=1e9).contains(d)) {
            let found = format!("{:?}", self.literals.deviations);
            return Err(Finding::new("literals.deviations", found, "at least one, each 1e-9 to 1e9"));
        }
        self.check_words()
    }

    fn problem(&mut self) -> &mut toml::Table {
        &mut self.problem
    }
}

impl EvolutionConfig {
    /// Checks that the language has the words that other settings need.
    fn check_words(&self) -> Result<(), Finding> {
        let has = |word: Word| self.language.literals && self.language.instructions.iter().any(|it| it == word.name());
        let [add, sub, mul] = [Instruction::Add, Instruction::Sub, Instruction::Mul].map(Word::from);
        let registers = self.learning.nb_registers;
        let needs = [
            (
                "start.share",
                self.start.share,
                has(add) && (has(Word::MultiplyAdd) || has(mul)) && registers >= 2,
                "0, or the words add and multiply_add or mul, language.literals = true and two registers",
            ),
            (
                "program.p_product",
                self.program.p_product,
                has(mul) && has(Word::MultiplyAdd) && registers >= 2 && self.program.max_program_size >= 2,
                "0, or the words mul and multiply_add, language.literals = true, two registers and two lines",
            ),
            (
                "refinement.p_mirror",
                self.refinement.p_mirror,
                has(sub),
                "0, or the word sub in language.instructions and language.literals = true",
            ),
        ];
        match needs.into_iter().find(|(_, value, met, _)| *value > 0.0 && !met) {
            Some((key, value, _, accepted)) => Err(Finding::new(key, value, accepted)),
            None => Ok(()),
        }
    }

    /// Checks what depends on the environment: there are outputs, or actions are named and there are enough roots for them; the
    /// environment keeps the memory of policies.
    ///
    /// # Errors
    /// The first parameter that does not fit.
    pub fn check_environment<S: Scalar>(&self, environment: &impl Environment<S>) -> Result<(), Finding> {
        let actions = environment.actions();
        if self.ask.is_some() && actions.asking().is_none() {
            let accepted = "none, or an environment with that action: tpg_train::Asking";
            return Err(Finding::new("ask", "a section [ask] for an environment that nobody can ask", accepted));
        }
        let (memory, has_outputs) = (self.language.memory, !actions.outputs().is_empty());
        if memory > 0 && !has_outputs {
            return Err(Finding::new("language.memory", memory, "0, for a problem without outputs"));
        }
        let kept = tpg_engine::remembered(&environment.sources(), &actions);
        if usize::from(memory) != kept {
            let accepted = format!("{kept}, which the environment keeps: see tpg_engine::Remembering");
            return Err(Finding::new("language.memory", memory, accepted));
        }
        if has_outputs {
            return Ok(());
        }
        let Some(count) = actions.count() else {
            let accepted = "named actions: tpg_engine::Choices converts any action space";
            return Err(Finding::new("problem", "actions that are not a list of names", accepted));
        };
        Finding::range("problem.actions", count, 2, 1 << 16)
    }

    /// Checks that each instruction exists and occurs once.
    fn check_instructions(&self) -> Result<(), Finding> {
        let texts = &self.language.instructions;
        let refused = |found: String| {
            let words = Word::ALL.map(Word::name).join(", ");
            let accepted =
                format!("one or more of {words}, or calls of them on a and b, such as mul(a, div(b, 10)), each once");
            Err(Finding::new("language.instructions", found, accepted))
        };
        if !(1..=256).contains(&texts.len()) {
            return refused(format!("{} instructions", texts.len()));
        }
        for (place, text) in texts.iter().enumerate() {
            match ProgramInstruction::parse(text) {
                Err(found) => return refused(found),
                Ok(_) if texts[..place].contains(text) => return refused(format!("{text:?} twice")),
                Ok(_) => {}
            }
        }
        Ok(())
    }
}
