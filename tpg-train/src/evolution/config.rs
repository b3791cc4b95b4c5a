//! The configuration of a run: every parameter, strictly read.
//!
//! The sections `tpg`, `program` and `learning` have GEGELATI's parameters with GEGELATI's meaning, and its names in snake
//! case; the others are this project's. The section `problem` belongs to the problem, which reads and checks it.
//! `tpg-train config` prints the presets with a comment for every parameter.

mod check;

use super::vocabulary::Vocabulary;
use serde::{Deserialize, Serialize};
use std::path::Path;
use tpg_engine::Environment;
use tpg_graph::ScalarType;
use tpg_graph::error::InputError;
use tpg_graph::settings;
use tpg_runtime::ops::Instruction;
use tpg_runtime::scalar::Scalar;

/// The values that a configuration file may hold, for messages.
const ACCEPTED: &str = "the parameters that `tpg-train config` prints";

/// Everything that decides a run, but for its seed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Config {
    /// The problem's own settings, as the problem wrote them; empty where a program brings its own environment.
    #[serde(default, skip_serializing_if = "toml::Table::is_empty")]
    pub problem: toml::Table,
    /// What programs are written with.
    pub language: LanguageConfig,
    /// GEGELATI's parameters of teams.
    pub tpg: TpgParameters,
    /// GEGELATI's parameters of programs.
    pub program: ProgramParameters,
    /// GEGELATI's parameters of learning.
    pub learning: LearningParameters,
    /// Who survives.
    pub selection: SelectionConfig,
    /// Literal constants.
    pub literals: Literals,
    /// Demes.
    pub demes: DemeConfig,
    /// The pool of hard episodes.
    pub pool: PoolConfig,
    /// Rougher episodes to begin with.
    pub curriculum: CurriculumConfig,
}

/// What programs are written with.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LanguageConfig {
    /// `f32` or `f64`.
    pub scalar: ScalarType,
    /// The instruction set, by name; the order numbers it.
    pub instructions: Vec<String>,
    /// Whether an operand may be a number of its own.
    pub literals: bool,
}

/// GEGELATI's `MutationParameters::tpg` (`mutator/mutationParameters.h`).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TpgParameters {
    /// Roots after populating.
    pub nb_roots: usize,
    /// Roots of the first population.
    pub init_nb_roots: usize,
    /// Most edges of a team of the first population.
    pub max_init_outgoing_edges: usize,
    /// Most edges of a team.
    pub max_outgoing_edges: usize,
    /// Probability of deleting one more edge: the first is deleted for certain.
    pub p_edge_deletion: f64,
    /// Probability of adding one more edge: the first is added for certain.
    pub p_edge_addition: f64,
    /// Probability of mutating the program of an edge; rounds repeat until one was mutated.
    pub p_program_mutation: f64,
    /// Whether a mutated program must differ in its effective lines.
    pub force_program_behavior_change_on_mutation: bool,
    /// Probability that a mutated edge gets another destination.
    pub p_edge_destination_change: f64,
    /// Probability that it is an action.
    pub p_edge_destination_is_action: f64,
}

/// GEGELATI's `MutationParameters::prog` (`mutator/mutationParameters.h`).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ProgramParameters {
    /// Most lines.
    pub max_program_size: usize,
    /// Probability of deleting a line.
    pub p_delete: f64,
    /// Probability of inserting a line.
    pub p_add: f64,
    /// Probability of altering one field of a line.
    pub p_mutate: f64,
    /// Probability of swapping two lines.
    pub p_swap: f64,
    /// Probability of drawing one of the program's constants anew.
    pub p_constant_mutation: f64,
    /// Probability of drawing a whole new program instead.
    pub p_new_program: f64,
    /// Least program constant.
    pub min_const_value: i32,
    /// Greatest program constant.
    pub max_const_value: i32,
}

/// GEGELATI's `LearningParameters` (`learn/learningParameters.h`), but for `nbIterationsPerJob` (adversarial agents only),
/// `nbThreads` (`--threads`: no result depends on it) and `doValidation` (see `validationInterval`).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LearningParameters {
    /// Recordings of the archive; 0 for none.
    pub archive_size: usize,
    /// Probability of recording a drawn program execution.
    pub archiving_probability: f64,
    /// Episodes of a root in a generation.
    pub nb_iterations_per_policy_evaluation: usize,
    /// Part of `nbRoots` that is deleted in a generation.
    pub ratio_deleted_roots: f64,
    /// Whether a first population larger than `nbRoots` is cut to the survivors of `nbRoots` at once. In GEGELATI it only
    /// loses as many roots as any other, and has children when fewer than `nbRoots` are left.
    pub cut_first_population: bool,
    /// Generations.
    pub nb_generations: u64,
    /// After this many episodes a root's score is final.
    pub max_nb_evaluation_per_policy: u64,
    /// Registers of a program.
    pub nb_registers: u16,
    /// Constants of a program.
    pub nb_program_constant: u16,
}

/// How survivors are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SelectionMethod {
    /// The best by running mean, as GEGELATI (`learningAgent.cpp`, `decimateWorstRoots`).
    Truncation,
    /// The best of random groups.
    Tournament,
}

/// Who survives.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SelectionConfig {
    /// How survivors are chosen.
    pub method: SelectionMethod,
    /// Roots of a tournament.
    pub tournament_size: usize,
    /// Survivors chosen by lexicase instead.
    pub lexicase_survivors: usize,
    /// Lexicase chooses among the best so many by running mean.
    pub lexicase_candidates: usize,
    /// Scores are equal for lexicase within this many median absolute deviations of an episode's scores.
    pub lexicase_tolerance: f64,
    /// The number of episodes after which only the best roots go on; 0 for no racing.
    pub racing_episodes: usize,
    /// The fraction of the roots that go on, 0 to 1; never fewer than survive.
    pub racing_share: f64,
    /// The number of roots that a validation compares: the best by running mean.
    pub validation_roots: usize,
    /// The number of episodes of the selection set, which the best of them does to the end.
    pub validation_episodes: usize,
    /// The fraction of a run's episodes that validations may take, 0 to 1.
    pub validation_share: f64,
}

/// Literal constants of operands, where the language has them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Literals {
    /// Standard deviations in units of an input's half range; one is drawn for each number, and an input for its unit.
    pub deviations: Vec<f64>,
    /// Probability that altering a literal operand alters its number.
    pub change: f64,
    /// Standard deviation of the factor's distance from 1 when a number is scaled.
    pub scaling: f64,
}

/// Demes: populations that seldom exchange roots.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DemeConfig {
    /// How many; each has `nbRoots` roots.
    pub count: usize,
    /// Generations between migrations.
    pub migration_interval: u64,
    /// Roots that a deme gives to the next.
    pub migrants: usize,
}

/// The pool of hard episodes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PoolConfig {
    /// Most episodes it holds.
    pub size: usize,
    /// Part of a generation's episodes that come from it.
    pub share: f64,
}

/// Rougher episodes to begin with.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CurriculumConfig {
    /// Generations with rougher episodes; 0 for none.
    pub generations: u64,
    /// So many times larger are steps and tolerance at first; from there they fall evenly.
    pub roughness: u8,
}

impl CurriculumConfig {
    /// How rough a generation's episodes are; 1 after the curriculum.
    pub fn at(&self, generation: u64) -> u8 {
        let rough = u64::from(self.roughness);
        let fallen = (rough * generation).checked_div(self.generations).unwrap_or(rough);
        rough.saturating_sub(fallen).max(1) as u8
    }
}

impl Config {
    /// Reads a configuration from a file.
    ///
    /// # Errors
    /// As [`from_toml`](Self::from_toml), or if there is no such file.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let text = crate::files::read_text(path, "a configuration as `tpg-train config` prints")?;
        Self::from_toml(&path.display().to_string(), &text)
    }

    /// Reads a configuration. Its section `problem` is taken as it is.
    ///
    /// # Errors
    /// An unknown key, a value out of range or a contradiction, with its line and the accepted values.
    pub fn from_toml(file: &str, text: &str) -> Result<Self, InputError> {
        let config = Self::of_run(file, text)?;
        config.check().map_err(|finding| settings::place(file, text, finding))?;
        Ok(config)
    }

    /// Reads a run's own configuration: with `--generations` it can be one that no file may have, such as a run that ends
    /// before its curriculum.
    ///
    /// # Errors
    /// An unknown key or a value of another type, with its line.
    pub fn of_run(file: &str, text: &str) -> Result<Self, InputError> {
        settings::from_toml(file, text, ACCEPTED)
    }

    /// The configuration as TOML, without comments: what a run's folder and a checkpoint keep.
    ///
    /// # Panics
    /// Never: every part can be written.
    pub fn to_toml(&self) -> String {
        toml::to_string(self).expect("a configuration is plain data")
    }

    /// The vocabulary of programs for an environment. `scales` are the units of literals, one for each value of the flat
    /// state.
    pub fn vocabulary<S: Scalar>(&self, environment: &impl Environment<S>, scales: Vec<f64>) -> Vocabulary {
        let sources = environment.sources();
        let bounds = environment.bid_bounds();
        let vocabulary = Vocabulary::new(
            self.instructions(),
            self.learning.nb_registers,
            self.learning.nb_program_constant,
            &sources[..bounds.unwrap_or(sources.len())],
            self.language.literals.then_some(scales),
            self.language.scalar,
        );
        match bounds {
            Some(place) => vocabulary.with_bounds(&sources[place]),
            None => vocabulary,
        }
    }

    /// The instruction set, by name.
    pub fn instructions(&self) -> Vec<Instruction> {
        self.language.instructions.iter().filter_map(|name| Instruction::from_name(name)).collect()
    }

    /// Roots that survive a generation that begins with that many, at least 1.
    pub fn survivors_of(&self, roots: usize) -> usize {
        let deleted = (self.learning.ratio_deleted_roots * self.tpg.nb_roots as f64).floor() as usize;
        let roots = if self.learning.cut_first_population { roots.min(self.tpg.nb_roots) } else { roots };
        roots.saturating_sub(deleted).max(1)
    }

    /// Roots that survive a generation of `nbRoots`.
    pub fn survivors(&self) -> usize {
        self.survivors_of(self.tpg.nb_roots)
    }
}
