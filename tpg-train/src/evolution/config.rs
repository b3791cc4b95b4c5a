//! The settings of a run, strictly parsed. Each is described once, by the comment here: `tpg-train config`, the manual and editors
//! read it from the [schema](crate::configuration::schema).
//!
//! The sections `tpg`, `program` and `learning` contain GEGELATI's parameters with GEGELATI's meaning and names, in snake case.
//! The section `problem` belongs to the problem, which reads and checks it. Defaults are the preset `thorough`.

mod check;

use super::linear::{LinearWriter, ProgramKind};
use super::vocabulary::{ProgramInstruction, Vocabulary};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tpg_engine::Environment;
use tpg_graph::ScalarType;
use tpg_runtime::scalar::Scalar;

/// Everything that determines a run except its seed.
///
/// ```
/// use tpg_train::{Config as EvolutionConfig, Configuration as _};
///
/// let config = EvolutionConfig::from_toml("mine.toml", "[tpg]\nnb_roots = 100\n")?;
/// assert_eq!((config.tpg.nb_roots, config.tpg.max_outgoing_edges), (100, 8));
///
/// let error = EvolutionConfig::from_toml("mine.toml", "[tpg]\nnb_rots = 100\n").expect_err("a typing error");
/// assert!(error.to_string().contains("line 2: unknown field `nb_rots`"), "{error}");
/// # Ok::<(), tpg_graph::error::InputError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct EvolutionConfig {
    /// The problem's own settings, as written by the problem; empty if a program supplies its own environment.
    #[serde(skip_serializing_if = "toml::Table::is_empty")]
    #[schemars(with = "serde_json::Map<String, serde_json::Value>")]
    pub problem: toml::Table,
    /// Another action, by which a network decides the step.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ask: Option<AskConfig>,
    /// The language of programs.
    pub language: LanguageConfig,
    /// GEGELATI's parameters of teams.
    pub tpg: TpgParameters,
    /// GEGELATI's parameters of programs.
    pub program: ProgramParameters,
    /// GEGELATI's parameters of learning.
    pub learning: LearningParameters,
    /// Selection of survivors, and of the best policy.
    pub selection: SelectionConfig,
    /// Literal constants.
    pub literals: Literals,
    /// Episodes that a best root failed, played again.
    pub pool: PoolConfig,
    /// Coarser episodes in the first generations.
    pub curriculum: CurriculumConfig,
    /// The search for weights of sums of the inputs, before evolution.
    pub start: StartConfig,
    /// Small changes of children.
    pub refinement: RefinementConfig,
}

/// One more action, *ask*: a network decides the step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AskConfig {
    /// The network's policy.q.json.
    pub policy: String,
    /// Price of one ask, in the unit of the score; 0 or more.
    pub price: f64,
    /// Checksum of that file; a run writes it and refuses another file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sha256: Option<String>,
}

/// The language of programs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct LanguageConfig {
    /// Precision of all arithmetic; a Cortex-M4F has an FPU for `f32`.
    pub scalar: ScalarType,
    /// Instruction set; the order gives the numbers. Words, or formulas of `a` and `b`: `"a / (1 + abs(a))"`.
    pub instructions: Vec<String>,
    /// Operands may be literal numbers.
    pub literals: bool,
    /// Values that a policy keeps for its next decision; needs outputs.
    pub memory: u16,
}

impl Default for LanguageConfig {
    fn default() -> Self {
        let words = ["sub", "add", "mul", "div", "negate_if_less", "abs", "min", "max", "multiply_add"];
        Self { scalar: ScalarType::F32, instructions: words.map(str::to_owned).to_vec(), literals: true, memory: 0 }
    }
}

/// GEGELATI's `MutationParameters::tpg` (`mutator/mutationParameters.h`).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct TpgParameters {
    /// Roots of a generation.
    pub nb_roots: usize,
    /// Roots of the first generation; at least the number of actions.
    pub init_nb_roots: usize,
    /// Maximum edges of a team at the start.
    pub max_init_outgoing_edges: usize,
    /// Maximum edges of a team; with a search for weights at least the number of actions.
    pub max_outgoing_edges: usize,
    /// Probability that a mutated edge gets another destination.
    pub p_edge_destination_change: f64,
    /// Probability that a new destination is an action.
    pub p_edge_destination_is_action: f64,
}

impl Default for TpgParameters {
    fn default() -> Self {
        Self {
            nb_roots: 500,
            init_nb_roots: 2000,
            max_init_outgoing_edges: 4,
            max_outgoing_edges: 8,
            p_edge_destination_change: 0.2,
            p_edge_destination_is_action: 0.7,
        }
    }
}

/// GEGELATI's `MutationParameters::prog` (`mutator/mutationParameters.h`).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ProgramParameters {
    /// Maximum lines of a program; at least 32 for outputs, and with a search for weights at least a sum of all inputs.
    pub max_program_size: usize,
    /// Probability of swapping two lines.
    pub p_swap: f64,
    /// Probability that a random program is a sum of products of two inputs, and that an inserted line is such a product.
    pub p_product: f64,
}

impl Default for ProgramParameters {
    fn default() -> Self {
        Self { max_program_size: 24, p_swap: 0.3, p_product: 0.0 }
    }
}

/// GEGELATI's `LearningParameters` (`learn/learningParameters.h`).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct LearningParameters {
    /// Episodes per root and generation.
    pub nb_iterations_per_policy_evaluation: usize,
    /// Fraction of `nb_roots` replaced in each generation.
    pub ratio_deleted_roots: f64,
    /// Generations; 0 for no limit, the default with `--max-steps`.
    pub nb_generations: u64,
    /// Episodes after which a root's score is final.
    pub max_nb_evaluation_per_policy: u64,
    /// Registers of a program; its result is register 0.
    pub nb_registers: u16,
}

impl Default for LearningParameters {
    fn default() -> Self {
        Self {
            nb_iterations_per_policy_evaluation: 10,
            ratio_deleted_roots: 0.84,
            nb_generations: 200,
            max_nb_evaluation_per_policy: 100_000,
            nb_registers: 4,
        }
    }
}

/// Selection of survivors, and of the best policy.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct SelectionConfig {
    /// Survivors selected by lexicase; the others are the best by running mean.
    pub lexicase_survivors: usize,
    /// Episodes after which only the best two fifths of the roots continue; 0 for all.
    pub racing_episodes: usize,
    /// Number of validation episodes, on which the best policy is chosen.
    pub validation_episodes: usize,
    /// Fraction of a run's steps for choosing the best policy.
    pub validation_share: f64,
    /// Price of a line, as a fraction of the way from the first generation's median score to the best.
    pub line_price: f64,
}

impl Default for SelectionConfig {
    fn default() -> Self {
        Self {
            lexicase_survivors: 0,
            racing_episodes: 3,
            validation_episodes: 500,
            validation_share: 0.1,
            line_price: 0.0003,
        }
    }
}

/// Literal constants of operands, if the language has them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Literals {
    /// Standard deviations, in half ranges of an input; each number draws one of them, and an input.
    pub deviations: Vec<f64>,
    /// The range of an input that gives numbers their unit.
    pub units: Units,
}

impl Default for Literals {
    fn default() -> Self {
        Self { deviations: vec![0.1, 0.5, 2.0], units: Units::Declared }
    }
}

/// The range of an input that gives numbers their unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Units {
    /// The declared range; unknown ends are those that random policies reach.
    #[default]
    Declared,
    /// Where random policies are most of the time, moved halfway to the mean of all inputs.
    Visited,
}

/// Episodes that a best root failed, played again.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct PoolConfig {
    /// Fraction of a generation's episodes drawn from the newest 300 of them.
    pub share: f64,
}

/// Coarser episodes in the first generations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct CurriculumConfig {
    /// Generations with coarser episodes.
    pub generations: u64,
    /// Initial factor of steps and tolerance; it falls linearly to 1.
    pub roughness: u8,
}

impl Default for CurriculumConfig {
    fn default() -> Self {
        Self { generations: 0, roughness: 1 }
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

/// The search for weights of sums of the inputs, before evolution. Evolution begins with its result.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct StartConfig {
    /// Fraction of the run for a random search; it ends after a quarter of that if no better than chance. At most `share`; 1 searches
    /// sums only, no products.
    pub random: f64,
    /// Fraction of the run after which the search ends; 0 for a random start. After the random search, the variances of weights
    /// are adapted.
    pub share: f64,
}

impl Default for StartConfig {
    fn default() -> Self {
        Self { random: 0.0, share: 0.4 }
    }
}

/// Small changes of children, which keep the structure of a policy.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct RefinementConfig {
    /// Probability that a child differs only in constants: all of them, or one.
    pub p_jitter: f64,
    /// Probability that a child only lacks a line.
    pub p_deletion: f64,
    /// Probability that another child has one mutated program only; needs named actions.
    pub p_mutation: f64,
    /// Probability that another child bids for an action the opposite of its bid for the action that undoes it; needs named
    /// actions with effects.
    pub p_mirror: f64,
}

impl Default for RefinementConfig {
    fn default() -> Self {
        Self { p_jitter: 0.2, p_deletion: 0.1, p_mutation: 0.0, p_mirror: 0.0 }
    }
}

impl EvolutionConfig {
    /// Creates the vocabulary of programs for an environment. `scales` are the units of literals, one for each value of
    /// the flat state.
    pub fn vocabulary<S: Scalar>(&self, environment: &impl Environment<S>, scales: Vec<f64>) -> Vocabulary {
        let sources = environment.sources();
        let (registers, scalar) = (self.learning.nb_registers, self.language.scalar);
        let scales = self.language.literals.then_some(scales);
        let outputs = environment.actions().outputs().iter().map(|output| output.limits(scalar)).collect();
        Vocabulary { outputs, ..Vocabulary::new(self.instructions(), registers, &sources, scales, scalar) }
    }

    /// Returns the configuration with the sizes that a problem needs: a root for each action, and room for sums of all inputs if
    /// their weights are searched for or given. Without room for that, the run starts at random.
    #[must_use]
    pub fn fitted<S: Scalar>(&self, environment: &impl Environment<S>) -> Self {
        let mut config = self.clone();
        let actions = environment.actions().count().unwrap_or(0);
        config.start.random = config.start.random.min(config.start.share);
        config.tpg.init_nb_roots = config.tpg.init_nb_roots.max(actions);
        let is_given = environment.training().is_some_and(|training| !training.linear().is_empty());
        if config.start.share > 0.0 || is_given {
            let values = tpg_engine::state_length(&environment.sources());
            let vocabulary = self.vocabulary(environment, vec![1.0; values]);
            let writer = LinearWriter::new(&vocabulary, actions as u16, ProgramKind::Sum);
            match writer {
                Ok(writer) if is_given || writer.is_small() => {
                    config.tpg.max_outgoing_edges = config.tpg.max_outgoing_edges.max(actions);
                    config.program.max_program_size = config.program.max_program_size.max(writer.lines());
                }
                _ => config.start = StartConfig { random: 0.0, share: 0.0 },
            }
        }
        config
    }

    /// Returns the instruction set.
    pub fn instructions(&self) -> Vec<ProgramInstruction> {
        self.language.instructions.iter().filter_map(|text| ProgramInstruction::parse(text).ok()).collect()
    }

    /// Returns the number of survivors, at least 1. A larger first population is cut to them at once.
    pub fn survivors(&self) -> usize {
        let deleted = (self.learning.ratio_deleted_roots * self.tpg.nb_roots as f64).floor() as usize;
        self.tpg.nb_roots.saturating_sub(deleted).max(1)
    }
}
