//! The resources a graph's code needs, before it is flashed: bytes, stack, operations; and the parts of the graph that never
//! mattered.

mod text;

pub use crate::explain::{BidFormula, Bids, Destination, LeafFormulas, PolicyFormulas, TeamFormulas, Value, explain};

use crate::cost::Cost;
use crate::emit::Code;
use crate::ir::{Module, Node};
use crate::options::{Language, Options, Profile, Style};
use crate::program::{Program, compile};
use crate::size::{self, Linked, RustForCortexM4, Size, Target};
use askama::Template;
use cortex_bound::Bound;
use serde::Serialize;
use std::collections::BTreeSet;
use tpg_graph::conversion::Conversion;
use tpg_graph::dataflow::effective;
use tpg_graph::error::{self, InputError};
use tpg_graph::{Graph, Input, MathsProvider, ScalarType};

/// The report; for people, its text.
#[derive(Clone, Debug, PartialEq, Serialize, Template)]
#[template(path = "report.txt", escape = "none")]
pub struct Report {
    /// The version of this tool.
    pub version: &'static str,
    /// The graph's SHA-256.
    pub graph_sha256: String,
    /// The scalar type of the code.
    pub scalar: ScalarType,
    /// The provider of the transcendental functions.
    pub maths: MathsProvider,
    /// True if the code computes in integers.
    #[serde(skip)]
    is_integer: bool,
    /// The change of scalar type, if there was one.
    pub conversion: Option<Conversion>,
    /// The graph's size.
    pub graph: GraphCounts,
    /// Other policies that the graph asks, by name; left out of JSON where there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub asks: Vec<String>,
    /// Values of the state that no action depends on, by name.
    pub dead_inputs: Vec<String>,
    /// The cost of a decision in C.
    pub costs: Vec<ShapeCost>,
    /// The size of the C on each target.
    pub sizes: Vec<ShapeSize>,
    /// The size of the Rust on a Cortex-M4F.
    pub rust_sizes: Vec<RustSize>,
}

/// The size of a graph, counting only vertices reachable from the root.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct GraphCounts {
    /// Teams.
    pub teams: usize,
    /// Teams on the longest walk.
    pub depth: usize,
    /// Edges of the teams.
    pub edges: usize,
    /// Programs that bid on these edges.
    pub programs: usize,
    /// Actions that the graph declares; 0 for a policy with outputs.
    pub actions: usize,
    /// Values that the policy answers; 0 for a policy that answers with an action.
    pub outputs: usize,
    /// Values that leaves compute for the next decision.
    pub memory: usize,
    /// Leaves, where outputs are computed.
    pub leaves: usize,
    /// Values of a state.
    pub inputs: usize,
    /// Lines of the programs.
    pub lines: usize,
    /// Introns: lines that no bid depends on.
    pub introns: usize,
    /// Operations after value numbering.
    pub distinct_operations: usize,
    /// Operations after all passes.
    pub operations: usize,
}

/// The shapes of a graph's code, by name: profiles, and in C GEGELATI's style, which has no outputs.
fn shapes(graph: &Graph, options: &Options, language: Language) -> Vec<(&'static str, Options)> {
    let pure =
        |profile: Profile| (profile.name(), Options { style: Style::Pure, profile: Some(profile), ..options.clone() });
    let gegelati = ("gegelati", Options { style: Style::Gegelati, profile: None, ..options.clone() });
    let has_gegelati = language == Language::C && graph.outputs().is_empty();
    Profile::ALL.map(pure).into_iter().chain(has_gegelati.then_some(gegelati)).collect()
}

/// The cost of a decision in one shape.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ShapeCost {
    /// The shape.
    pub profile: &'static str,
    /// At most.
    pub worst: Cost,
}

/// The size of one shape on one target.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ShapeSize {
    /// The target.
    pub target: Target,
    /// The shape.
    pub profile: &'static str,
    /// Bytes of flash: code, constants and initialised variables.
    pub flash: Option<u64>,
    /// Bytes of flash with the library functions that it calls, if it could be linked.
    pub linked_flash: Option<u64>,
    /// Bytes of RAM, without the stack; of linked code with that of library functions.
    pub ram: Option<u64>,
    /// Instructions of a decision at most, library functions included, if there is a bound; on an AVR cycles.
    pub instructions: Option<u64>,
    /// As `instructions`, of reading an image.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub look: Option<u64>,
    /// Bytes of stack of a decision at most, library functions included, if there is a bound.
    pub stack: Option<u64>,
    /// The sections that the compiler made.
    pub sections: Option<Size>,
    /// The reason for having no compiler's numbers, or none of linked code.
    pub unavailable: Option<String>,
}

/// The size of one profile's Rust on a Cortex-M4F.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RustSize {
    /// The profile.
    pub profile: &'static str,
    /// Bytes of flash.
    pub flash: Option<u64>,
    /// The reason for having none.
    pub unavailable: Option<String>,
}

/// Puts a report together. `whole` is the policy in integers, whose sizes are reported, too; a graph that is
/// in integers itself is.
///
/// # Errors
/// A value of the policy in integers that is not known to be whole; `file` is its name.
pub fn report(
    file: &str,
    graph: &Graph,
    options: &Options,
    targets: &[Target],
    whole: Option<&Graph>,
) -> Result<Report, InputError> {
    let whole = whole.or_else(|| graph.has_counts().then_some(graph));
    let in_integers = |(name, profile): (&'static str, Profile)| {
        let options = Options { profile: Some(profile), style: Style::Pure, conversion: None, ..options.clone() };
        Ok((name, Code::of_graph(file, whole.unwrap_or(graph), &options, Language::C)?))
    };
    let names = [("integers", Profile::Fast), ("integers, small", Profile::Small)];
    let integers: Vec<(&str, Code<'_>)> =
        names.into_iter().filter(|_| whole.is_some()).map(in_integers).collect::<Result<_, InputError>>()?;
    let codes: Vec<(&str, Code<'_>)> = (shapes(graph, options, Language::C).into_iter())
        .map(|(shape, options)| (shape, Code::of(compile(graph, &options, Language::C))))
        .collect();
    let costs = codes.iter().map(|(shape, code)| ShapeCost { profile: shape, worst: Cost::worst(&code.program) });
    // A graph in integers is compiled to floats only to be interpreted.
    let floats = if graph.has_counts() { &[][..] } else { &codes };
    let sizes = targets.iter().flat_map(|&target| {
        floats.iter().chain(&integers).map(move |(shape, code)| size_of(code, target, shape)).collect::<Vec<_>>()
    });
    let Program { module: optimised, .. } = &codes[0].1.program;
    Ok(Report {
        version: env!("CARGO_PKG_VERSION"),
        graph_sha256: codes[0].1.program.graph_sha256(),
        scalar: graph.scalar(),
        maths: graph.maths(),
        is_integer: graph.has_counts(),
        conversion: options.conversion.clone(),
        graph: counts(optimised),
        asks: graph.asks().map(str::to_owned).collect(),
        dead_inputs: dead_inputs(optimised),
        costs: costs.collect(),
        sizes: sizes.collect(),
        rust_sizes: if targets.contains(&Target::M4f) { rust_sizes(graph, options) } else { Vec::new() },
    })
}

fn counts(optimised: &Module<'_>) -> GraphCounts {
    let graph = optimised.graph;
    let lowered = Module::lower(graph);
    let labels: BTreeSet<u32> = lowered.bidders.iter().map(|bidder| bidder.label).collect();
    let computing: BTreeSet<_> = graph.leaves().iter().flat_map(|leaf| &leaf.programs).collect();
    let is_reached = |label: &u32, id: usize| labels.contains(label) || computing.iter().any(|it| it.index() == id);
    let programs = || {
        graph.programs().iter().enumerate().filter(|(id, it)| is_reached(&it.label, *id)).map(|(_, program)| program)
    };
    let effective: usize = programs()
        .map(|program| effective(graph.registers().into(), &program.lines))
        .map(|lines| lines.into_iter().filter(|&effective| effective).count())
        .sum();
    let lines: usize = programs().map(|program| program.lines.len()).sum();
    GraphCounts {
        teams: lowered.teams.len(),
        depth: lowered.depth,
        edges: lowered.teams.iter().map(|team| team.edges.len()).sum(),
        programs: lowered.bidders.len(),
        actions: graph.actions().len(),
        outputs: graph.split_outputs().0.len(),
        memory: graph.memory(),
        leaves: graph.leaves().len(),
        inputs: graph.observed_length(),
        lines,
        introns: lines - effective,
        distinct_operations: operations(&lowered),
        operations: operations(optimised),
    }
}

fn operations(module: &Module<'_>) -> usize {
    module.nodes.iter().filter(|node| node.is_computed()).count()
}

fn dead_inputs(optimised: &Module<'_>) -> Vec<String> {
    let graph = optimised.graph;
    let read: BTreeSet<Input> = optimised
        .nodes
        .iter()
        .filter_map(|node| if let Node::Input(input) = *node { Some(input) } else { None })
        .collect();
    let inputs = graph.inputs();
    inputs.filter(|input| !read.contains(input)).map(|input| graph.input_label(input)).collect()
}

/// Returns the size of a shape's code on a target.
pub(crate) fn size_of(code: &Code<'_>, target: Target, profile: &'static str) -> ShapeSize {
    let mut found = ShapeSize { target, profile, ..ShapeSize::default() };
    found.unavailable = found.measure(code).err();
    found
}

impl ShapeSize {
    /// Fills in what can be measured.
    fn measure(&mut self, code: &Code<'_>) -> Result<(), String> {
        let built = size::build_c(code, self.target).map_err(|error| error.to_string())?;
        let size = size::measure(&built.object).map_err(|error| error.to_string())?;
        (self.flash, self.ram, self.sections) = (Some(size.flash()), Some(size.ram()), Some(size));
        let Some(Linked { size, bound, look }) = built.link(code).map_err(|error| error.to_string())? else {
            return Ok(());
        };
        (self.linked_flash, self.ram) = (Some(size.flash()), Some(size.ram()));
        self.look = look.map(|look| look.instructions);
        if let Some(Bound { instructions, stack }) = bound.transpose()? {
            (self.instructions, self.stack) = (Some(instructions), Some(stack));
        }
        Ok(())
    }
}

fn rust_sizes(graph: &Graph, options: &Options) -> Vec<RustSize> {
    // As the C: for the smallest flash.
    let compiler = RustForCortexM4::new("s").map_err(|error| error.to_string());
    let size = |options: &Options| {
        let compiler = compiler.as_ref().map_err(Clone::clone)?;
        let code = Code::of(compile(graph, options, Language::Rust));
        compiler.size(&code, "s").map_err(|error| error.to_string())
    };
    (shapes(graph, options, Language::Rust).into_iter())
        .map(|(profile, options)| match size(&options) {
            Ok(size) => RustSize { profile, flash: Some(size.flash()), unavailable: None },
            Err(error) => RustSize { profile, flash: None, unavailable: Some(error) },
        })
        .collect()
}
