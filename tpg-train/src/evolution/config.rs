//! The configuration of a run: every parameter, strictly read.
//!
//! The sections `tpg`, `program` and `learning` have GEGELATI's parameters with GEGELATI's names and meaning; the others
//! are this project's. `tpg-train config` prints the presets with a comment for every parameter.

mod check;

use super::vocabulary::Vocabulary;
use crate::environments::{ArmDescription, ArmProblem};
use crate::files::read_text;
use crate::targets::Start;
use serde::{Deserialize, Serialize};
use std::path::Path;
use tpg_arm::observation::Source;
use tpg_arm::{Arm, WIDOWX};
use tpg_graph::error::{InputError, Place};
use tpg_graph::{ScalarType, SourceDocument};
use tpg_runtime::ops::Instruction;

/// Everything that decides a run, but for its seed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Config {
    /// The problem.
    pub problem: ProblemConfig,
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
    /// The arm; the WidowX where it is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub arm: Option<ArmDescription>,
}

/// The problem.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
pub struct ProblemConfig {
    /// `arm`, `pendulum` or `own`. Of the parameters of this section the last two use none but `sources`.
    pub environment: EnvironmentName,
    /// Where the arm starts.
    pub start: Start,
    /// What programs read, in order.
    pub sources: Vec<String>,
    /// Which actions no policy can choose; needs actions of 3 ticks.
    pub shield: Shield,
    /// Success is nearer than this, mm.
    pub tolerance: f64,
    /// Ticks of one action.
    pub step: i8,
    /// Whether there is an action that does nothing and ends the episode.
    pub may_stop: bool,
    /// Score of a success.
    pub bonus_success: f64,
    /// Score of each action that a success did not need.
    pub coef_reward_multiplication: f64,
    /// The most that a failure costs, mm: what handing over to another policy counts like.
    #[serde(default = "unlimited")]
    pub hand_over_price: f64,
}

/// A failure costs its whole distance.
fn unlimited() -> f64 {
    f64::INFINITY
}

/// Which actions no policy can choose. A part of the graph: without it, it is another policy.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Shield {
    /// None is refused.
    #[default]
    None,
    /// Those that would bring a joint out of its range.
    Limits,
    /// Those, and those after which the arm would collide.
    LimitsAndCollision,
}

impl Shield {
    /// The source that holds the bounds of the bids.
    pub fn source(self) -> Option<Source> {
        match self {
            Self::None => None,
            Self::Limits => Some(Source::ShieldLimits),
            Self::LimitsAndCollision => Some(Source::ShieldCollision),
        }
    }

    /// The shield that a graph with those sources has.
    pub fn of<'a>(mut names: impl Iterator<Item = &'a str>) -> Self {
        let shields = [Self::Limits, Self::LimitsAndCollision];
        let named = |name: &str| shields.into_iter().find(|shield| shield.source().is_some_and(|s| s.name() == name));
        names.find_map(named).unwrap_or_default()
    }

    /// Its name in configurations and reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Limits => "limits",
            Self::LimitsAndCollision => "limits-and-collision",
        }
    }
}

/// The environments that come with the trainer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum EnvironmentName {
    /// The WidowX arm.
    Arm,
    /// The pendulum that is to be swung up.
    Pendulum,
    /// A user's own, in a program that uses this library.
    Own,
}

/// What programs are written with.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
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
#[serde(deny_unknown_fields, rename_all = "camelCase")]
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
#[serde(deny_unknown_fields, rename_all = "camelCase")]
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
#[serde(deny_unknown_fields, rename_all = "camelCase")]
pub struct LearningParameters {
    /// Recordings of the archive; 0 for none.
    pub archive_size: usize,
    /// Probability of recording a drawn program execution.
    pub archiving_probability: f64,
    /// Episodes of a root in a generation.
    pub nb_iterations_per_policy_evaluation: usize,
    /// After this many actions an episode is over.
    pub max_nb_actions_per_eval: u32,
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
#[serde(deny_unknown_fields, rename_all = "camelCase")]
pub struct SelectionConfig {
    /// How survivors are chosen.
    pub method: SelectionMethod,
    /// Roots of a tournament.
    pub tournament_size: usize,
    /// Survivors chosen by lexicase instead.
    pub lexicase_survivors: usize,
    /// Lexicase chooses among the best so many by running mean.
    pub lexicase_candidates: usize,
    /// Scores within this are equal for lexicase.
    pub lexicase_tolerance: f64,
    /// Episodes of racing: after so many, roots far behind are dropped; 0 for no racing.
    pub racing_episodes: usize,
    /// How far behind the worst survivor's mean a root must be to be dropped.
    pub racing_margin: f64,
    /// Generations between validations; the best root on the selection set so far is kept.
    pub validation_interval: u64,
    /// Episodes of the selection set.
    pub validation_episodes: usize,
}

/// Literal constants of operands, where the language has them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
pub struct Literals {
    /// Standard deviations; one is drawn for each number.
    pub deviations: Vec<f64>,
    /// Probability that altering a literal operand alters its number.
    pub change: f64,
    /// Standard deviation of the factor's distance from 1 when a number is scaled.
    pub scaling: f64,
}

/// Demes: populations that seldom exchange roots.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
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
#[serde(deny_unknown_fields, rename_all = "camelCase")]
pub struct PoolConfig {
    /// Most episodes it holds.
    pub size: usize,
    /// Part of a generation's episodes that come from it.
    pub share: f64,
}

/// Rougher episodes to begin with.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
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
        let text = read_text(path, "a configuration as `tpg-train config` prints")?;
        Self::from_toml(&path.display().to_string(), &text)
    }

    /// Reads a configuration.
    ///
    /// # Errors
    /// An unknown key, a value out of range or a contradiction, with its line and what is accepted.
    pub fn from_toml(file: &str, text: &str) -> Result<Self, InputError> {
        let config = Self::of_run(file, text)?;
        config.check(&|key, found, accepted| {
            let place = line_of_key(text, key).map_or(Place::Path(key.to_owned()), Place::Line);
            InputError::new(file, place, format!("{key} = {found}"), accepted)
        })?;
        Ok(config)
    }

    /// Reads a run's own configuration: with `--generations` it can be one that no file may have, such as a run that ends
    /// before its curriculum.
    ///
    /// # Errors
    /// An unknown key or a value of another type, with its line.
    pub fn of_run(file: &str, text: &str) -> Result<Self, InputError> {
        toml::from_str(text).map_err(|error| {
            let place = error.span().map_or(Place::Whole, |span| Place::Line(line_of(text, span.start)));
            InputError::new(file, place, error.message().trim(), "what `tpg-train config` prints")
        })
    }

    /// The configuration as TOML, without comments: what a run directory and a checkpoint keep.
    ///
    /// # Panics
    /// Never: every part can be written.
    pub fn to_toml(&self) -> String {
        toml::to_string(self).expect("a configuration is plain data")
    }

    /// The arm.
    pub fn arm(&self) -> Arm<f64> {
        self.arm.as_ref().map_or(WIDOWX, Arm::from)
    }

    /// What is asked of the arm, and how it is scored.
    pub fn arm_problem(&self) -> ArmProblem {
        ArmProblem {
            start: self.problem.start,
            tolerance: self.problem.tolerance,
            max_actions: self.learning.max_nb_actions_per_eval,
            step: self.problem.step,
            may_stop: self.problem.may_stop,
            sources: self.sources().into_iter().chain(self.problem.shield.source()).collect(),
            bonus: self.problem.bonus_success,
            hand_over_price: self.problem.hand_over_price,
            per_unused_action: self.problem.coef_reward_multiplication,
        }
    }

    /// What programs are written with, where the environment has those sources: with a shield, it is the last.
    pub fn vocabulary(&self, sources: &[SourceDocument]) -> Vocabulary {
        let readable = sources.len() - usize::from(self.problem.shield != Shield::None);
        let vocabulary = Vocabulary::new(
            self.instructions(),
            self.learning.nb_registers,
            self.learning.nb_program_constant,
            &sources[..readable],
            self.language.literals,
            self.language.scalar,
        );
        if readable == sources.len() {
            return vocabulary;
        }
        vocabulary.with_shield(sources[..readable].iter().map(|source| source.length as u16).sum())
    }

    /// The sources that programs read, by name.
    pub fn sources(&self) -> Vec<Source> {
        self.problem.sources.iter().filter_map(|name| Source::from_name(name)).collect()
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

/// The line, from 1, of a byte of the text.
fn line_of(text: &str, byte: usize) -> usize {
    1 + text.bytes().take(byte).filter(|&b| b == b'\n').count()
}

/// The line, from 1, where `section.key` is set.
fn line_of_key(text: &str, key: &str) -> Option<usize> {
    let (section, key) = key.rsplit_once('.')?;
    let header = format!("[{section}]");
    let mut inside = false;
    for (line, number) in text.lines().map(str::trim).zip(1..) {
        if line.starts_with('[') {
            inside = line.starts_with(&header);
        } else if inside && line.split('=').next().map(str::trim) == Some(key) && line.contains('=') {
            return Some(number);
        }
    }
    None
}
