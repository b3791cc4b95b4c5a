//! The configuration of a run: all parameters, strictly parsed.
//!
//! The sections `tpg`, `program` and `learning` contain GEGELATI's parameters with GEGELATI's meaning, and its names in
//! snake case; the others are this project's. The section `problem` belongs to the problem, which reads and checks it.
//! `tpg-train config` prints the presets with a comment for every parameter.

mod check;

use super::milestones::Milestones;
use super::vocabulary::Vocabulary;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;
use tpg_engine::Environment;
use tpg_graph::ScalarType;
use tpg_graph::Word;
use tpg_graph::error::InputError;
use tpg_graph::settings;
use tpg_runtime::scalar::Scalar;

/// The accepted content of a configuration file, for messages.
const ACCEPTED: &str = "the parameters that `tpg-train config` prints";

/// Generations of a linear start of usual length.
const GENERATIONS_FOR_A_WEIGHT: u64 = 3;
const LEAST_GENERATIONS: u64 = 20;

/// Everything that determines a run except its seed.
///
/// ```
/// use tpg_train::evolution::config::EvolutionConfig;
/// use tpg_train::evolution::presets::Preset;
///
/// let text = Preset::find("general").expect("a built-in preset").text();
/// let config = EvolutionConfig::from_toml("mine.toml", &text.replace("\nnb_roots = 200", "\nnb_roots = 100"))?;
/// assert_eq!(config.tpg.nb_roots, 100);
///
/// let error = EvolutionConfig::from_toml("mine.toml", &text.replace("\np_swap", "\np_swop")).expect_err("a typing error");
/// assert!(error.to_string().contains("unknown field `p_swop`"), "{error}");
/// # Ok::<(), tpg_graph::error::InputError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EvolutionConfig {
    /// The problem's own settings, as written by the problem; empty if a program supplies its own environment.
    #[serde(default, skip_serializing_if = "toml::Table::is_empty")]
    #[schemars(with = "serde_json::Map<String, serde_json::Value>")]
    pub problem: toml::Table,
    /// One more action: a network decides the step.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ask: Option<AskConfig>,
    /// The language of programs.
    pub language: LanguageConfig,
    /// GEGELATI's parameters of teams.
    pub tpg: TpgParameters,
    /// GEGELATI's parameters of programs.
    pub program: ProgramParameters,
    /// GEGELATI's parameters of learning.
    pub learning: LearningParameters,
    /// Selection of survivors.
    pub selection: SelectionConfig,
    /// Leaves, where a problem has outputs in place of actions.
    #[serde(default)]
    pub leaves: LeafConfig,
    /// Literal constants.
    pub literals: Literals,
    /// Demes.
    pub demes: DemeConfig,
    /// Pool of hard episodes.
    pub pool: PoolConfig,
    /// Coarser episodes in the first generations.
    pub curriculum: CurriculumConfig,
    /// The first generations.
    #[serde(default)]
    pub start: StartConfig,
    /// Small changes of children.
    #[serde(default)]
    pub refinement: RefinementConfig,
}

/// One more action, *ask*: a network decides the step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AskConfig {
    /// The network's policy.q.json, from the folder where the command runs.
    pub policy: String,
    /// The price of one ask, in the unit of the problem's score; 0 or more.
    pub price: f64,
    /// Checksum of the network's file, in hexadecimal digits; a run writes it, and another file is refused.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sha256: Option<String>,
}

/// The language of programs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LanguageConfig {
    /// `f32` or `f64`.
    pub scalar: ScalarType,
    /// Instruction set, by name; the order gives the numbers.
    pub instructions: Vec<String>,
    /// True if operands may be literal numbers.
    pub literals: bool,
    /// Number of values that a policy computes for its next decision; only for problems with outputs.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub memory: u16,
}

fn is_zero(memory: &u16) -> bool {
    *memory == 0
}

fn is_nothing(probability: &f64) -> bool {
    *probability == 0.0
}

fn is_one(factor: &usize) -> bool {
    *factor == 1
}

/// GEGELATI's `MutationParameters::tpg` (`mutator/mutationParameters.h`).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TpgParameters {
    /// Number of roots after populating.
    pub nb_roots: usize,
    /// Number of roots of the first population.
    pub init_nb_roots: usize,
    /// Maximum number of edges of a team of the first population.
    pub max_init_outgoing_edges: usize,
    /// Maximum number of edges of a team.
    pub max_outgoing_edges: usize,
    /// Probability of deleting one more edge; the first deletion is certain.
    pub p_edge_deletion: f64,
    /// Probability of adding one more edge; the first addition is certain.
    pub p_edge_addition: f64,
    /// Probability of mutating the program of an edge; rounds repeat until at least one program is mutated.
    pub p_program_mutation: f64,
    /// True if a mutated program must differ in its effective lines.
    pub force_program_behavior_change_on_mutation: bool,
    /// Probability that a mutated edge gets another destination.
    pub p_edge_destination_change: f64,
    /// Probability that the new destination is an action.
    pub p_edge_destination_is_action: f64,
}

/// GEGELATI's `MutationParameters::prog` (`mutator/mutationParameters.h`).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ProgramParameters {
    /// Maximum number of lines.
    pub max_program_size: usize,
    /// Probability of deleting a line.
    pub p_delete: f64,
    /// Probability of inserting a line.
    pub p_add: f64,
    /// Probability of altering one field of a line.
    pub p_mutate: f64,
    /// Probability of swapping two lines.
    pub p_swap: f64,
    /// Probability of redrawing one of the program's constants.
    pub p_constant_mutation: f64,
    /// Probability of drawing an entirely new program instead.
    pub p_new_program: f64,
    /// Probability that a random program is a sum of products of two inputs, and that such a product is inserted in place of a
    /// line.
    #[serde(default, skip_serializing_if = "is_nothing")]
    pub p_product: f64,
    /// Minimum program constant.
    pub min_const_value: i32,
    /// Maximum program constant.
    pub max_const_value: i32,
}

/// GEGELATI's `LearningParameters` (`learn/learningParameters.h`), except `nbIterationsPerJob` (adversarial agents
/// only), `nbThreads` (`--threads`: results do not depend on it) and `doValidation` (`validation_share`).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LearningParameters {
    /// Capacity of the archive; 0 disables it.
    pub archive_size: usize,
    /// Probability of recording a sampled program execution.
    pub archiving_probability: f64,
    /// Number of episodes per root and generation.
    pub nb_iterations_per_policy_evaluation: usize,
    /// Fraction of `nb_roots` that is deleted in each generation.
    pub ratio_deleted_roots: f64,
    /// True if a first population larger than `nb_roots` is cut to the survivors of `nb_roots` at once. GEGELATI removes
    /// only as many roots as in any other generation, and breeds children only when fewer than `nb_roots` are left.
    pub cut_first_population: bool,
    /// Number of generations.
    pub nb_generations: u64,
    /// Number of episodes after which a root's score is final.
    pub max_nb_evaluation_per_policy: u64,
    /// Number of registers of a program.
    pub nb_registers: u16,
    /// Number of constants of a program.
    pub nb_program_constant: u16,
}

/// Method of selecting survivors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum SelectionMethod {
    /// The best by running mean, as in GEGELATI (`learningAgent.cpp`, `decimateWorstRoots`).
    Truncation,
    /// The best of random groups.
    Tournament,
}

/// The choice of a child's parent among the survivors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ParentChoice {
    /// Each survivor is equally likely, as in GEGELATI.
    #[default]
    Uniform,
    /// The better one of two that are drawn.
    Better,
}

/// The scores by which racing compares.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum RacingBy {
    /// This generation's alone; a root that is dropped ranks below every other.
    #[default]
    Generation,
    /// Running means; a root that is dropped only gets no more episodes. For few episodes: a good root survives a bad one.
    Record,
}

/// The unit of a run's effort.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Effort {
    /// Episodes.
    #[default]
    Episodes,
    /// Steps: where episodes grow long as policies get better, those of validation are the longest.
    Steps,
}

impl Effort {
    fn is_usual(&self) -> bool {
        *self == Self::default()
    }
}

/// Selection of survivors.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SelectionConfig {
    /// Method of selecting survivors.
    pub method: SelectionMethod,
    /// Number of roots in a tournament.
    pub tournament_size: usize,
    /// Number of survivors selected by lexicase instead.
    pub lexicase_survivors: usize,
    /// Number of candidates for lexicase: the best by running mean.
    pub lexicase_candidates: usize,
    /// Lexicase treats scores as equal within this many median absolute deviations of an episode's scores.
    pub lexicase_tolerance: f64,
    /// Number of episodes after which only the best roots continue; 0 disables racing.
    pub racing_episodes: usize,
    /// Fraction of the roots that continue, 0 to 1; never fewer than survive.
    pub racing_share: f64,
    /// The parents of children.
    #[serde(default)]
    pub parents: ParentChoice,
    /// The scores by which racing compares.
    #[serde(default)]
    pub racing_by: RacingBy,
    /// Number of roots compared in a validation: the best by running mean.
    pub validation_roots: usize,
    /// Number of episodes in the selection set, all of which only the winner completes.
    pub validation_episodes: usize,
    /// Fraction of a run's effort available for validation, 0 to 1.
    pub validation_share: f64,
    /// The unit of that effort.
    #[serde(default, skip_serializing_if = "Effort::is_usual")]
    pub validation_by: Effort,
    /// Price of a line of a policy, as a fraction of the way from the first generation's median score to the best.
    #[serde(default)]
    pub line_price: f64,
    /// Number of standard errors of the best result on the selection set within which the smallest policy is chosen; 0: the best
    /// result less the price of its lines.
    #[serde(default)]
    pub choice_errors: f64,
    /// Number of validations in a row without a better root after which the run ends; 0 for none.
    #[serde(default)]
    pub flat_after: usize,
}

/// Literal constants of operands, if the language has them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Literals {
    /// Standard deviations in units of an input's half range; each number draws one of them, and an input for the unit.
    pub deviations: Vec<f64>,
    /// Probability that altering a literal operand changes its number.
    pub change: f64,
    /// Standard deviation of the factor's distance from 1 when a number is scaled.
    pub scaling: f64,
    /// The range of an input that gives numbers their unit.
    #[serde(default)]
    pub units: Units,
}

/// The range of an input that gives numbers their unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Units {
    /// The declared one; its ends that the problem does not know are those that random policies reach.
    #[default]
    Declared,
    /// The one where random policies usually are, half of the way to the mean of all inputs: declared ranges are often never
    /// reached.
    Visited,
}

/// Evolution of policies with outputs: they start as single leaves, and structure is added rarely.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct LeafConfig {
    /// Maximum number of lines of a leaf's program.
    pub max_program_size: usize,
    /// Maximum number of rounds of mutation of a leaf's program in a child.
    pub rounds: usize,
    /// Probability that a child changes only the literals of a leaf.
    pub p_literals: f64,
    /// Standard deviations of the change of a literal, relative to it; each child draws one of them.
    pub refinements: Vec<f64>,
    /// Probability that a child with several edges changes a bid.
    pub p_bid: f64,
    /// Probability that a child with several edges loses one.
    pub p_edge_deletion: f64,
    /// Probability that a child gets another edge.
    pub p_edge_addition: f64,
    /// Probability that an added edge leads to a team, not to a leaf.
    pub p_team: f64,
}

impl Default for LeafConfig {
    fn default() -> Self {
        Self {
            max_program_size: 32,
            rounds: 3,
            p_literals: 0.3,
            refinements: vec![0.3, 0.1, 0.03],
            p_bid: 0.5,
            p_edge_deletion: 0.15,
            p_edge_addition: 0.1,
            p_team: 0.1,
        }
    }
}

/// Demes: populations that rarely exchange roots.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DemeConfig {
    /// Number of demes; each has `nb_roots` roots.
    pub count: usize,
    /// Generations between migrations.
    pub migration_interval: u64,
    /// Number of roots that a deme passes on to the next one.
    pub migrants: usize,
    /// Number of generations after which the worse half of the demes ends, again and again; 0 for never.
    #[serde(default)]
    pub halving_interval: u64,
}

/// Pool of hard episodes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PoolConfig {
    /// Capacity of the pool.
    pub size: usize,
    /// Fraction of a generation's episodes that come from the pool.
    pub share: f64,
}

/// Coarser episodes in the first generations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CurriculumConfig {
    /// Number of generations with coarser episodes; 0 disables the curriculum.
    pub generations: u64,
    /// Initial factor of steps and tolerance; it decreases evenly to 1.
    pub roughness: u8,
}

/// The first population.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum StartKind {
    /// Random policies.
    #[default]
    Random,
    /// In some demes, weighted sums of the inputs that covariance matrix adaptation has found.
    Linear,
    /// In some demes, products of two weighted sums of the inputs.
    Product,
}

/// What a search learns of how its numbers belong together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Covariance {
    /// The variance of each number and the covariance of each pair.
    #[default]
    Full,
    /// The variances alone, which needs fewer generations.
    Diagonal,
}

impl Covariance {
    /// True for the default.
    fn is_full(&self) -> bool {
        *self == Self::Full
    }
}

/// The samples of a random search that play the same episode.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum EpisodeFor {
    /// Each sample plays its own: most is seen.
    #[default]
    Sample,
    /// Two opposite samples play the same, so that their scores differ by the weights alone.
    Pair,
    /// All samples of a generation play the same.
    Generation,
}

impl EpisodeFor {
    /// True for the default.
    fn is_sample(&self) -> bool {
        *self == Self::Sample
    }

    /// Returns how many of a generation's samples, opposite ones side by side, play the same episode.
    pub(super) fn sharing(self, samples: usize) -> usize {
        match self {
            Self::Sample => 1,
            Self::Pair => 2,
            Self::Generation => samples,
        }
    }
}

/// The first population, and the search for it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct StartConfig {
    /// Its kind; the other settings do not matter for a random one.
    pub kind: StartKind,
    /// Number of generations of the search for weights; 0 for 3 for each weight, at least 20.
    pub generations: u64,
    /// Two fractions of a run's steps (`--max-steps`): a search whose generations have taken less than the first goes on while it
    /// gets better; once it has stalled, another one begins, in turns for products and for sums. Every search ends at the second.
    /// `[0, 0]`, or a run without that limit: its generations alone decide.
    pub share: [f64; 2],
    /// Fraction of a run's steps that a random search takes, one episode a sample, before those by covariance matrix adaptation;
    /// after a quarter of them it ends as soon as its samples are no better than luck on average, that is, than nine tenths of the
    /// way from the first generation's median to its best. 0, or a run without that limit: none. Not above the first of `share`.
    #[serde(skip_serializing_if = "is_nothing")]
    pub random: f64,
    /// The samples of a random search that play the same episode.
    #[serde(skip_serializing_if = "EpisodeFor::is_sample")]
    pub episode_for: EpisodeFor,
    /// Number of searches, of which the best goes on after half of the generations.
    pub searches: usize,
    /// Number of samples of a search in a generation; 0 for `breadth` times 4 + 3 ln n with n weights.
    pub samples: usize,
    /// Factor of the usual number of samples.
    #[serde(skip_serializing_if = "is_one")]
    pub breadth: usize,
    /// What a search learns of how weights belong together.
    #[serde(skip_serializing_if = "Covariance::is_full")]
    pub covariance: Covariance,
    /// Number of episodes of a sample.
    pub episodes: usize,
    /// Samples whose scores differ by less than this fraction of the way from the first generation's median score to the best count
    /// as equal; 0 for none.
    #[serde(skip_serializing_if = "is_nothing")]
    pub tie: f64,
    /// Standard deviation of the first samples: 1 is a whole output for a whole input.
    pub deviation: f64,
    /// Number of demes that begin with the result; the others begin at random.
    pub demes: usize,
}

impl StartConfig {
    /// True if the search for weights is limited by the steps of the run.
    pub fn is_by_steps(&self) -> bool {
        self.kind != StartKind::Random && self.share[1] > 0.0
    }
}

impl Default for StartConfig {
    fn default() -> Self {
        let kind = StartKind::Random;
        Self {
            kind,
            generations: 60,
            share: [0.0, 0.0],
            random: 0.0,
            episode_for: EpisodeFor::Sample,
            searches: 3,
            samples: 0,
            breadth: 1,
            covariance: Covariance::Full,
            episodes: 2,
            tie: 0.0,
            deviation: 0.5,
            demes: 1,
        }
    }
}

/// Small changes of children, which keep the structure of a policy.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct RefinementConfig {
    /// Probability that a child only has other constants: all of them, or one.
    pub p_jitter: f64,
    /// Lowest and highest standard deviation of that change, relative to the constant; each child draws one.
    pub deviations: [f64; 2],
    /// Probability that a child only lacks a line.
    pub p_deletion: f64,
    /// Probability that another child of a policy with named actions only has one program mutated.
    pub p_mutation: f64,
    /// Probability that another child of a policy with named actions bids for one action the opposite of what it bids for the
    /// action that undoes it, by the actions' effects.
    #[serde(skip_serializing_if = "is_nothing")]
    pub p_mirror: f64,
    /// Number of children of the best root of a deme that only have other constants.
    pub elite: usize,
}

impl Default for RefinementConfig {
    fn default() -> Self {
        Self { p_jitter: 0.0, deviations: [0.02, 0.6], p_deletion: 0.0, p_mutation: 0.0, p_mirror: 0.0, elite: 0 }
    }
}

impl CurriculumConfig {
    /// Returns the roughness of a generation's episodes; 1 after the curriculum.
    pub fn at(&self, generation: u64) -> u8 {
        let rough = u64::from(self.roughness);
        let fallen = (rough * generation).checked_div(self.generations).unwrap_or(rough);
        rough.saturating_sub(fallen).max(1) as u8
    }
}

impl EvolutionConfig {
    /// Reads a configuration from a file.
    ///
    /// # Errors
    /// As [`from_toml`](Self::from_toml), or if the file does not exist.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let text = crate::files::read_text(path, "a configuration as `tpg-train config` prints")?;
        Self::from_toml(&path.display().to_string(), &text)
    }

    /// Reads a configuration. Its section `problem` is not checked.
    ///
    /// # Errors
    /// An unknown key, a value out of range or a contradiction, with its line and the accepted values.
    pub fn from_toml(file: &str, text: &str) -> Result<Self, InputError> {
        let config = Self::of_run(file, text)?;
        config.check().map_err(|finding| settings::place(file, text, finding))?;
        Ok(config)
    }

    /// Reads the configuration stored with a run. With `--generations` it may be one that is not accepted in a file,
    /// such as a run that ends before its curriculum.
    ///
    /// # Errors
    /// An unknown key or a value of another type, with its line.
    pub fn of_run(file: &str, text: &str) -> Result<Self, InputError> {
        settings::from_toml(file, text, ACCEPTED)
    }

    /// Returns the configuration as TOML without comments, as stored in a run's folder and in checkpoints.
    ///
    /// # Panics
    /// Never: every part can be serialised.
    pub fn to_toml(&self) -> String {
        toml::to_string(self).expect("a configuration is plain data")
    }

    /// Creates the vocabulary of programs for an environment. `scales` are the units of literals, one for each value of
    /// the flat state.
    pub fn vocabulary<S: Scalar>(&self, environment: &impl Environment<S>, scales: Vec<f64>) -> Vocabulary {
        let sources = environment.sources();
        let bounds = tpg_engine::bid_bounds(&sources);
        let vocabulary = Vocabulary::new(
            self.instructions(),
            self.learning.nb_registers,
            self.learning.nb_program_constant,
            &sources[..bounds.unwrap_or(sources.len())],
            self.language.literals.then_some(scales),
            self.language.scalar,
        );
        let limits = environment.actions().outputs().iter().map(|output| output.limits(self.language.scalar)).collect();
        let vocabulary = vocabulary.with_outputs(limits);
        match bounds {
            Some(place) => vocabulary.with_bounds(&sources[place]),
            None => vocabulary,
        }
    }

    /// Returns the number of demes before a generation, with `linear` generations of a linear start.
    pub fn demes_at(&self, generation: u64, linear: u64) -> usize {
        let halvings = generation.saturating_sub(linear).checked_div(self.demes.halving_interval).unwrap_or(0);
        (0..halvings.min(64)).fold(self.demes.count, |demes, _| demes.div_ceil(2))
    }

    /// Returns the number of generations of a linear start that searches for so many weights; 0 without one.
    pub fn linear_generations(&self, weights: usize) -> u64 {
        match (self.start.kind, self.start.generations) {
            (StartKind::Random, _) => 0,
            (StartKind::Linear | StartKind::Product, 0) => {
                (GENERATIONS_FOR_A_WEIGHT * weights as u64).max(LEAST_GENERATIONS)
            }
            (StartKind::Linear | StartKind::Product, generations) => generations,
        }
    }

    /// Returns the generation with which a linear start ends that usually has so many; `None` if that is not known yet.
    pub(super) fn linear_end(&self, usual: u64, milestones: &Milestones) -> Option<u64> {
        if self.start.is_by_steps() { milestones.ended } else { Some(usual) }
    }

    /// Returns the generation from which only the best search of a linear start goes on; `None` if that is not known yet.
    pub(super) fn linear_choice(&self, usual: u64, milestones: &Milestones) -> Option<u64> {
        if self.start.is_by_steps() { milestones.chosen } else { Some(usual.div_ceil(2)) }
    }

    /// Returns the instruction set, looked up by name.
    pub fn instructions(&self) -> Vec<Word> {
        self.language.instructions.iter().filter_map(|name| Word::from_name(name)).collect()
    }

    /// Returns the number of survivors of a generation that begins with `roots` roots, at least 1.
    pub fn survivors_of(&self, roots: usize) -> usize {
        let deleted = (self.learning.ratio_deleted_roots * self.tpg.nb_roots as f64).floor() as usize;
        let roots = if self.learning.cut_first_population { roots.min(self.tpg.nb_roots) } else { roots };
        roots.saturating_sub(deleted).max(1)
    }

    /// Returns the number of survivors of a generation of `nb_roots`.
    pub fn survivors(&self) -> usize {
        self.survivors_of(self.tpg.nb_roots)
    }
}
