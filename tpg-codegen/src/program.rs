//! A graph compiled for a language: all decisions are made before any text is printed.

use crate::integers::{self, Integers};
use crate::ir::Module;
use crate::options::{Language, Options, Profile, Style};
use crate::passes::{self, bytecode, cases, schedule};
use crate::shape::Shape;
use Shape::*;
use tpg_graph::Graph;
use tpg_graph::error::InputError;

/// A compiled graph, which is then printed, costed, measured, explained and proven.
#[derive(Clone, Debug, PartialEq)]
pub struct Program<'g> {
    /// The lowered graph, optimised but in GEGELATI's style.
    pub(crate) module: Module<'g>,
    /// The language it is for.
    pub(crate) language: Language,
    /// The options it was compiled with.
    pub(crate) options: Options,
    /// The shape of the code.
    pub(crate) shape: Shape,
}

/// Compiles a graph.
///
/// # Panics
/// If the graph has outputs and the style is GEGELATI's, which answers with an action.
///
/// ```
/// use tpg_codegen::emit::Language;
/// use tpg_codegen::{Options, compile};
/// use tpg_graph::sample::{self, Shape};
///
/// let graph = sample::graph(&Shape::default(), 7);
/// let program = compile(&graph, &Options::new("arm".parse()?), Language::C);
/// assert_eq!(program.name(), "C, fast");
/// assert_eq!(program.graph_sha256(), graph.sha256());
/// # Ok::<(), String>(())
/// ```
pub fn compile<'g>(graph: &'g Graph, options: &Options, language: Language) -> Program<'g> {
    let program = |module, shape| Program { module, language, options: options.clone(), shape };
    if language == Language::C && options.style == Style::Gegelati {
        assert!(graph.outputs().is_empty(), "GEGELATI's style has no outputs");
        return program(Module::lower(graph), Gegelati);
    }
    let module = passes::optimise(graph);
    // If no bid matters any more, tables and masks gain nothing: the plainest text is the best, and has no condition.
    let chooses = module.teams.iter().any(|team| team.edges.iter().any(|edge| edge.to != team.edges[0].to));
    if module.only_leaf().is_some() {
        return program(module, Formula);
    }
    let profile = if chooses { options.profile_in(language) } else { Profile::Fast };
    let shape = |profile| match profile {
        Profile::Fast => Fast(schedule::schedule(&module)),
        Profile::Balanced => Balanced(cases::tabulate(&module, schedule::schedule(&module))),
        Profile::Small => Small(bytecode::encode(&module)),
        Profile::ConstantTime => ConstantTime,
    };
    let shape = match profile {
        Profile::Small if module.edges() <= FEW_EDGES => match (shape(Profile::Fast), language) {
            (Fast(schedule), _) if schedule.is_lazy() => shape(Profile::Balanced),
            (_, Language::C) if module.edges() > NATIVE_EDGES_OF_C => shape(Profile::Balanced),
            (native, _) => native,
        },
        _ => shape(profile),
    };
    program(module, shape)
}

/// The most edges of a graph whose code is smaller without a small evaluator and its tables.
const FEW_EDGES: usize = 24;

/// The most edges of a graph whose C is smaller without tables of teams.
const NATIVE_EDGES_OF_C: usize = 8;

/// Compiles a graph of whole numbers to integers; `file` is its name in messages.
///
/// # Errors
/// The first value that is not known to be whole.
pub(crate) fn compile_integers<'g>(
    file: &str,
    graph: &'g Graph,
    options: &Options,
    language: Language,
) -> Result<Program<'g>, InputError> {
    let module = passes::optimise(graph);
    let tables = options.profile_in(language) == Profile::Small;
    let integers = Integers { values: integers::analyse(file, &module)?, forms: integers::forms(&module), tables };
    Ok(Program { module, language, options: options.clone(), shape: Shape::Integers(integers) })
}

impl<'g> Program<'g> {
    /// The graph.
    pub fn graph(&self) -> &'g Graph {
        self.module.graph
    }

    /// The SHA-256 of the graph as it was given, before any change of its scalar type.
    pub fn graph_sha256(&self) -> String {
        self.options.conversion.as_ref().map_or_else(|| self.graph().sha256(), |was| was.sha256.clone())
    }

    /// Tests for code in which no comparison may become a branch.
    pub(crate) fn is_branch_free(&self) -> bool {
        let is_meant = self.options.profile_in(self.language) == Profile::ConstantTime;
        is_meant && matches!(self.shape, ConstantTime | Formula)
    }

    /// The language, the shape, and the options that change what the code does.
    pub fn name(&self) -> String {
        let Self { language, options, .. } = self;
        let mut name = match self.shape {
            Gegelati => "C in GEGELATI's style".to_owned(),
            Shape::Integers(_) => format!("{}, integers, {}", language.name(), options.profile_in(*language).name()),
            _ => format!("{}, {}", language.name(), options.profile_in(*language).name()),
        };
        if options.conversion.is_some() {
            name = format!("{name}, --scalar {}", self.graph().scalar().name());
        }
        name
    }
}

#[cfg(test)]
mod tests {
    use super::{Shape, compile};
    use crate::options::{Language, Options, Profile, Style};
    use tpg_graph::sample;

    fn options(profile: Profile) -> Options {
        Options { profile: Some(profile), ..Options::new("arm".parse().expect("a prefix")) }
    }

    #[test]
    fn gegelati_is_a_style_of_c_and_optimises_nothing() {
        let graph = sample::graph(&sample::Shape::default(), 1);
        let gegelati = Options { style: Style::Gegelati, ..options(Profile::Small) };
        let c = compile(&graph, &gegelati, Language::C);
        assert_eq!(c.shape, Shape::Gegelati);
        assert_eq!((&c.module, &*c.name()), (&crate::ir::Module::lower(&graph), "C in GEGELATI's style"));
        assert!(!matches!(compile(&graph, &gegelati, Language::Rust).shape, Shape::Gegelati));
    }
}
