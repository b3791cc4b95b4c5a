//! What a configuration may say.

use super::{Config, EnvironmentName, Shield};
use tpg_arm::observation::Source;
use tpg_arm::observation::shield::STEP;
use tpg_graph::error::InputError;
use tpg_runtime::ops::Instruction;

/// Makes an error of a key, what was found there and what is accepted.
type Refuse<'a> = &'a dyn Fn(&str, String, String) -> InputError;

impl Config {
    /// Ranges, names and contradictions.
    ///
    /// # Errors
    /// What `error` makes of the first key that is wrong, what was found there and what is accepted.
    pub(super) fn check(&self, error: Refuse<'_>) -> Result<(), InputError> {
        let number = |key: &str, value: f64, low: f64, high: f64| {
            let inside = value >= low && value <= high;
            if inside { Ok(()) } else { Err(error(key, value.to_string(), format!("{low} to {high}"))) }
        };
        let probability = |key: &str, value: f64| number(key, value, 0.0, 1.0);
        let count = |key: &str, value: usize, low: usize, high: usize| {
            let inside = (low..=high).contains(&value);
            if inside { Ok(()) } else { Err(error(key, value.to_string(), format!("{low} to {high}"))) }
        };
        const MANY: usize = 1_000_000;
        self.check_problem(error)?;
        if let Some(arm) = &self.arm {
            if self.problem.environment != EnvironmentName::Arm {
                let (found, accepted) = ("not the arm, beside a section [arm]", "\"arm\", or no section [arm]");
                return Err(error("problem.environment", found.to_owned(), accepted.to_owned()));
            }
            arm.check().map_err(|(key, found, accepted)| error(key, found, accepted))?;
        }
        number("problem.tolerance", self.problem.tolerance, 1e-3, 1e3)?;
        number("problem.step", self.problem.step.into(), 1.0, 127.0)?;
        number("problem.bonusSuccess", self.problem.bonus_success, 0.0, 1e9)?;
        number("problem.handOverPrice", self.problem.hand_over_price, 0.0, f64::INFINITY)?;
        number("problem.coefRewardMultiplication", self.problem.coef_reward_multiplication, 0.0, 1e3)?;

        let actions = match self.problem.environment {
            EnvironmentName::Arm if self.problem.may_stop => 9,
            EnvironmentName::Arm => 8,
            EnvironmentName::Pendulum => 5,
            EnvironmentName::Own => 2,
        };
        let tpg = &self.tpg;
        count("tpg.nbRoots", tpg.nb_roots, 2, MANY)?;
        count("tpg.initNbRoots", tpg.init_nb_roots, actions, MANY)?;
        count("tpg.maxInitOutgoingEdges", tpg.max_init_outgoing_edges, 2, actions)?;
        count("tpg.maxOutgoingEdges", tpg.max_outgoing_edges, tpg.max_init_outgoing_edges, 1000)?;
        probability("tpg.pEdgeDeletion", tpg.p_edge_deletion)?;
        probability("tpg.pEdgeAddition", tpg.p_edge_addition)?;
        // At 0 GEGELATI would mutate for ever: rounds repeat until a program was mutated.
        number("tpg.pProgramMutation", tpg.p_program_mutation, 1e-3, 1.0)?;
        probability("tpg.pEdgeDestinationChange", tpg.p_edge_destination_change)?;
        probability("tpg.pEdgeDestinationIsAction", tpg.p_edge_destination_is_action)?;

        let program = &self.program;
        count("program.maxProgramSize", program.max_program_size, 1, 1000)?;
        let chances = [
            ("program.pDelete", program.p_delete),
            ("program.pAdd", program.p_add),
            ("program.pMutate", program.p_mutate),
            ("program.pSwap", program.p_swap),
            ("program.pConstantMutation", program.p_constant_mutation),
            ("program.pNewProgram", program.p_new_program),
        ];
        chances.iter().try_for_each(|(key, value)| probability(key, *value))?;
        if program.p_mutate + program.p_new_program <= 0.0 {
            let accepted = "above 0, or program.pNewProgram above 0: a mutation must be able to change a program";
            return Err(error("program.pMutate", program.p_mutate.to_string(), accepted.to_owned()));
        }
        if program.min_const_value > program.max_const_value {
            let accepted = format!("at most program.maxConstValue, {}", program.max_const_value);
            return Err(error("program.minConstValue", program.min_const_value.to_string(), accepted));
        }

        let learning = &self.learning;
        count("learning.archiveSize", learning.archive_size, 0, MANY)?;
        probability("learning.archivingProbability", learning.archiving_probability)?;
        let episodes = learning.nb_iterations_per_policy_evaluation;
        count("learning.nbIterationsPerPolicyEvaluation", episodes, 1, MANY)?;
        count("learning.maxNbActionsPerEval", learning.max_nb_actions_per_eval as usize, 1, MANY)?;
        number("learning.ratioDeletedRoots", learning.ratio_deleted_roots, 0.0, 0.999)?;
        count("learning.nbGenerations", learning.nb_generations as usize, 1, MANY)?;
        count("learning.maxNbEvaluationPerPolicy", learning.max_nb_evaluation_per_policy as usize, 1, usize::MAX)?;
        count("learning.nbRegisters", learning.nb_registers.into(), 1, 256)?;
        count("learning.nbProgramConstant", learning.nb_program_constant.into(), 0, 256)?;

        let selection = &self.selection;
        count("selection.tournamentSize", selection.tournament_size, 1, tpg.nb_roots)?;
        count("selection.lexicaseSurvivors", selection.lexicase_survivors, 0, self.survivors())?;
        count("selection.lexicaseCandidates", selection.lexicase_candidates, 1, MANY)?;
        number("selection.lexicaseTolerance", selection.lexicase_tolerance, 0.0, 1e9)?;
        count("selection.racingEpisodes", selection.racing_episodes, 0, episodes - 1)?;
        number("selection.racingMargin", selection.racing_margin, 0.0, 1e9)?;
        count("selection.validationInterval", selection.validation_interval as usize, 1, MANY)?;
        count("selection.validationEpisodes", selection.validation_episodes, 1, MANY)?;

        if self.literals.deviations.is_empty() || self.literals.deviations.iter().any(|d| !(1e-9..=1e9).contains(d)) {
            let found = format!("{:?}", self.literals.deviations);
            return Err(error("literals.deviations", found, "at least one, each 1e-9 to 1e9".to_owned()));
        }
        probability("literals.change", self.literals.change)?;
        number("literals.scaling", self.literals.scaling, 0.0, 100.0)?;
        count("demes.count", self.demes.count, 1, 1000)?;
        count("demes.migrationInterval", self.demes.migration_interval as usize, 1, MANY)?;
        count("demes.migrants", self.demes.migrants, 0, self.survivors())?;
        count("pool.size", self.pool.size, 0, MANY)?;
        probability("pool.share", self.pool.share)?;
        let curriculum = &self.curriculum;
        let last = self.learning.nb_generations - 1;
        count("curriculum.generations", curriculum.generations as usize, 0, last as usize)?;
        count("curriculum.roughness", curriculum.roughness.into(), 1, 127 / self.problem.step.unsigned_abs() as usize)?;
        if self.pool.share > 0.0 && self.pool.size == 0 {
            let accepted = "0, or a pool.size above 0".to_owned();
            return Err(error("pool.share", self.pool.share.to_string(), accepted));
        }
        Ok(())
    }

    /// Names: each known, each once.
    fn check_problem(&self, error: Refuse<'_>) -> Result<(), InputError> {
        let shield = self.problem.shield;
        let possible = self.problem.environment == EnvironmentName::Arm && self.problem.step == STEP;
        if shield != Shield::None && !possible {
            let accepted = format!("\"none\": a shield knows the arm's actions of {STEP} ticks only");
            return Err(error("problem.shield", format!("{:?}", shield.name()), accepted));
        }
        let readable = |source: &&str| !source.starts_with("shield_");
        let known: Vec<&str> = Source::ALL.iter().map(|source| source.name()).filter(readable).collect();
        let sources = match self.problem.environment {
            EnvironmentName::Arm => &known[..],
            EnvironmentName::Pendulum => &["pendulum"][..],
            EnvironmentName::Own => &[][..],
        };
        if self.problem.environment != EnvironmentName::Own {
            check_names("problem.sources", &self.problem.sources, sources, error)?;
        }
        let instructions = Instruction::ALL.map(Instruction::name);
        check_names("language.instructions", &self.language.instructions, &instructions, error)
    }
}

fn check_names(key: &str, names: &[String], known: &[&str], error: Refuse<'_>) -> Result<(), InputError> {
    let accepted = || format!("one or more of {}, each once", known.join(", "));
    if names.is_empty() {
        return Err(error(key, "an empty list".to_owned(), accepted()));
    }
    for (place, name) in names.iter().enumerate() {
        if !known.contains(&name.as_str()) || names[..place].contains(name) {
            return Err(error(key, format!("{name:?}"), accepted()));
        }
    }
    Ok(())
}
