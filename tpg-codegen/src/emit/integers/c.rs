//! C99 in integers: counts in, counts out.

use super::comment::Comments;
use super::dense::{Dense, Table};
use super::lines::{Function, Lines, Spelling};
use super::view::{self, FieldView, VectorView, actions, sources};
use crate::emit::c::field::field;
use crate::emit::file::{File, comment};
use crate::emit::vectors::vectors;
use crate::emit::{banner, layout, names};
use crate::integers::{Integers, Whole, input_bits, output_bits};
use crate::ir::{Node, NodeId, Target, reached, topological};
use crate::program::Program;
use askama::Template;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use tpg_graph::{Graph, Input};
use tpg_runtime::ops::Instruction;

#[derive(Template)]
#[template(path = "integers/header.h", escape = "none")]
struct Header<'a> {
    banner: &'a [String],
    prefix: &'a str,
    upper: &'a str,
    sources: Vec<FieldView>,
    /// The constant of each action, and its name where that says more.
    actions: Vec<(String, String)>,
    outputs: Vec<FieldView>,
    memory: Vec<FieldView>,
    /// The quality of the self-test.
    quality: Option<String>,
}

#[derive(Template)]
#[template(path = "integers/source.c", escape = "none")]
struct Source<'a> {
    banner: &'a [String],
    prefix: &'a str,
    upper: &'a str,
    called: BTreeSet<(Function, bool)>,
    /// 32 bits and 64.
    widths: [bool; 2],
    table: Option<Table>,
    outputs: Vec<FieldView>,
    memory: Vec<FieldView>,
    body: String,
    vectors: Vec<VectorView>,
}

impl Source<'_> {
    fn calls(&self, function: Function, wide: &bool) -> bool {
        self.called.contains(&(function, *wide))
    }

    fn int(&self, wide: &bool) -> &'static str {
        integer(*wide)
    }

    fn bits(&self, wide: &bool) -> &'static str {
        suffix(*wide)
    }
}

/// The spelling of C.
struct C<'a> {
    graph: &'a Graph,
    prefix: &'a str,
}

impl C<'_> {
    fn place(&self, input: Input) -> String {
        let (source, place) = self.graph.source_of(input);
        let name = field(self.graph, &source.name);
        match source.counts.len() {
            0 => format!("memory->{name}"),
            1 => format!("state->{name}"),
            _ => format!("state->{name}[{place}]"),
        }
    }
}

impl Spelling for C<'_> {
    fn input(&self, input: Input, wide: bool) -> String {
        let place = self.place(input);
        match (wide, input_bits(self.graph, input)) {
            (true, _) => format!("(int64_t){place}"),
            (false, 32) => place,
            (false, _) => format!("(int32_t){place}"),
        }
    }

    fn literal(&self, value: i64, wide: bool) -> String {
        let text = match (value, wide) {
            (-2_147_483_648, false) => return "INT32_MIN".to_owned(),
            (2_147_483_647, false) => return "INT32_MAX".to_owned(),
            (_, true) => format!("INT64_C({})", value.unsigned_abs()),
            (_, false) => value.unsigned_abs().to_string(),
        };
        if value < 0 { format!("(-{text})") } else { text }
    }

    fn widened(&self, text: &str) -> String {
        format!("(int64_t){text}")
    }

    fn narrowed(&self, text: &str) -> String {
        format!("(int32_t){text}")
    }

    fn call(&self, function: Function, wide: bool, arguments: &[String]) -> String {
        let name = match function {
            Function::Shift => "shift",
            Function::Divide => "divide",
            Function::Quotient => "quotient",
            Function::Min => "min",
            Function::Max => "max",
            Function::Abs => "abs",
            Function::NegateIfLess => "negate_if_less",
            Function::Gate => "gate",
            Function::Clamp => "clamp",
        };
        let unsigned = if function == Function::Shift { "U" } else { "" };
        format!("{}_{name}{}({}{unsigned})", self.prefix, suffix(wide), arguments.join(", "))
    }

    fn halved(&self, text: &str, bits: u32, wide: bool) -> String {
        let width = if wide { 64 } else { 32 };
        format!("(int{width}_t)((uint{width}_t){text} >> {bits}U)")
    }

    fn statement(&self, name: &str, wide: bool, value: &str) -> String {
        format!("const {} {name} = {value};", integer(wide))
    }
}

/// The type of a value.
fn integer(wide: bool) -> &'static str {
    if wide { "int64_t" } else { "int32_t" }
}

/// The end of the name of a function of such values.
fn suffix(wide: bool) -> &'static str {
    if wide { "64" } else { "" }
}

/// The two files.
pub(super) fn files(program: &Program<'_>, integers: &Integers) -> Vec<File> {
    let graph = program.graph();
    let (prefix, upper) = (program.options.prefix.lower(), program.options.prefix.upper());
    let lines = Lines::new(&program.module, integers, C { graph, prefix });
    let dense = Dense::find(&program.module, integers);
    let constants = actions(graph, &upper);
    let mut body = Body { program, integers, lines, constants, text: String::new() };
    match &dense {
        Some(dense) => body.text = dense.body(prefix, |function| body.lines.note(function)),
        None => {
            body.decide();
            // What no walk reads may still be a node.
            if !body.text.contains("state->") {
                body.text.insert_str(0, "    (void)state;\n");
            }
        }
    }
    let banner = banner::lines(program);
    let (outputs, memory) = (view::outputs(graph, false), view::outputs(graph, true));
    let chosen = vectors(graph);
    let header = Header {
        banner: &banner,
        prefix,
        upper: &upper,
        sources: sources(graph),
        actions: actions(graph, &upper),
        outputs,
        memory,
        quality: chosen.quality(),
    };
    let source = Source {
        banner: &banner,
        prefix,
        upper: &upper,
        called: body.lines.called(),
        widths: [false, true],
        table: dense.map(|dense| dense.table()),
        outputs: view::outputs(graph, false),
        memory: view::outputs(graph, true),
        body: body.text,
        vectors: view::views(graph, &upper, &chosen),
    };
    let text = |text: askama::Result<String>| layout::tidy(&text.expect("the template renders"));
    vec![
        File { name: format!("{prefix}.h"), text: text(header.render()) },
        File { name: format!("{prefix}.c"), text: text(source.render()) },
    ]
}

/// The body of the function.
struct Body<'a, 'g> {
    program: &'a Program<'g>,
    integers: &'a Integers,
    lines: Lines<'a, C<'a>>,
    /// Of the actions.
    constants: Vec<(String, String)>,
    text: String,
}

impl Body<'_, '_> {
    fn line(&mut self, depth: usize, text: &str) {
        let _ = writeln!(self.text, "{:1$}{text}", "", depth * 4);
    }

    fn decide(&mut self) {
        let module = &self.program.module;
        if let Some(leaf) = module.only_leaf() {
            return self.leaf(&leaf.values.clone(), 1);
        }
        let order = topological(&module.teams);
        let several = order.len() > 1 || !module.leaves.is_empty();
        for (place, &team) in order.iter().enumerate() {
            if place > 0 {
                let _ = writeln!(self.text, "team_{}:", module.teams[team].label);
            }
            let depth = if several { 2 } else { 1 };
            if several {
                self.line(1, "{");
            }
            self.team(team, depth);
            if several {
                self.line(1, "}");
            }
        }
        for (_, leaf) in reached(&module.leaves) {
            let _ = writeln!(self.text, "leaf_{}:", leaf.label);
            self.line(1, "{");
            self.leaf(&leaf.values.clone(), 2);
            self.line(2, "return;");
            self.line(1, "}");
        }
    }

    /// The name of a destination.
    fn name(&self, to: Target) -> String {
        let module = &self.program.module;
        match to {
            Target::Team(team) => format!("team {}", module.teams[team].label),
            Target::Action(end) => match module.leaves.get(usize::from(end.0)) {
                Some(leaf) => format!("leaf {}", leaf.label),
                None => comment(&self.program.graph().actions()[usize::from(end.0)].name),
            },
        }
    }

    /// The variable of a bid.
    fn variable(&self, to: Target) -> String {
        let module = &self.program.module;
        match to {
            Target::Team(team) => format!("to_team_{}", module.teams[team].label),
            Target::Action(end) => match module.leaves.get(usize::from(end.0)) {
                Some(leaf) => format!("to_leaf_{}", leaf.label),
                None => format!("to_{}", names::actions(self.program.graph())[usize::from(end.0)]),
            },
        }
    }

    /// The statement that goes to a destination.
    fn go(&self, to: Target) -> String {
        let module = &self.program.module;
        match to {
            Target::Team(team) => format!("goto team_{};", module.teams[team].label),
            Target::Action(end) => match module.leaves.get(usize::from(end.0)) {
                Some(leaf) => format!("goto leaf_{};", leaf.label),
                None => format!("return {};", self.constants[usize::from(end.0)].0),
            },
        }
    }

    fn team(&mut self, team: usize, depth: usize) {
        let module = &self.program.module;
        let edges = &module.teams[team].edges;
        let mut ends: Vec<Target> = Vec::new();
        for edge in edges {
            if !ends.contains(&edge.to) {
                ends.push(edge.to);
            }
        }
        if ends.len() == 1 {
            let go = self.go(ends[0]);
            return self.line(depth, &go);
        }
        let is_action = |to: &Target| matches!(to, Target::Action(_)) && module.leaves.is_empty();
        let answers = ends.iter().all(is_action);
        let action = format!("{}_action_t", self.program.options.prefix.lower());
        let (kind, way) = if answers { (action.as_str(), "action") } else { ("uint_fast8_t", "way") };
        let constants = self.constants.clone();
        let number = |to: Target| match to {
            Target::Action(action) if answers => constants[usize::from(action.0)].0.clone(),
            _ => format!("{}U", ends.iter().position(|&end| end == to).unwrap_or(0)),
        };
        let bids: Vec<NodeId> = edges.iter().map(|edge| module.bidders[edge.bidder].value).collect();
        let named_bids: Vec<(NodeId, String)> =
            bids.iter().zip(edges).map(|(&bid, edge)| (bid, self.name(edge.to))).collect();
        let comments = Comments::of_bids(module, &named_bids);
        let wide = bids.iter().any(|&bid| self.lines.is_wide(bid));
        let mut open: BTreeSet<NodeId> = self.lines.choose(&bids).into_iter().collect();
        self.lines.name(bids.iter().zip(edges).map(|(&bid, edge)| (bid, self.variable(edge.to))).collect());
        for (place, (&bid, edge)) in bids.iter().zip(edges).enumerate() {
            for id in self.program.module.operations_of(bid) {
                if open.remove(&id) {
                    self.statement(id, &comments, depth);
                }
            }
            let value = self.lines.operand(bid, wide);
            let to = number(edge.to);
            if place == 0 {
                self.line(depth, &format!("{} best = {value};", integer(wide)));
                self.line(depth, &format!("{kind} {way} = {to};"));
                continue;
            }
            self.line(depth, &format!("if ({value} >= best) {{"));
            if place + 1 < bids.len() {
                self.line(depth + 1, &format!("best = {value};"));
            }
            self.line(depth + 1, &format!("{way} = {to};"));
            self.line(depth, "}");
        }
        if answers {
            return self.line(depth, "return action;");
        }
        self.line(depth, "switch (way) {");
        for (place, &end) in ends.iter().enumerate() {
            let go = self.go(end);
            let case = if place + 1 == ends.len() { "default:".to_owned() } else { format!("case {place}U:") };
            self.line(depth, &case);
            self.line(depth + 1, &go);
        }
        self.line(depth, "}");
    }

    fn statement(&mut self, id: NodeId, comments: &Comments<'_>, depth: usize) {
        if let Some(said) = comments.of(id, self.integers.of(id)) {
            for line in wrapped(&format!("/* {said} */"), 110 - depth * 4) {
                self.line(depth, &line);
            }
        }
        let statement = self.lines.statement(id).replace('\n', &format!("\n{:1$}", "", depth * 4));
        self.line(depth, &statement);
    }

    fn leaf(&mut self, values: &[NodeId], depth: usize) {
        let graph = self.program.graph();
        let comments = Comments::of_outputs(&self.program.module, values);
        let named = self.lines.choose(values);
        let names = graph.outputs().iter().zip(values).flat_map(|(output, &value)| {
            let name = field(graph, &output.name);
            let inner = match self.program.module.node(value) {
                Node::Operation(Instruction::Quotient, [sum, _]) => Some((sum, format!("{name}_sum"))),
                _ => None,
            };
            inner.into_iter().chain([(value, name)])
        });
        self.lines.name(names.collect());
        for id in named {
            self.statement(id, &comments, depth);
        }
        // What is remembered is read before it is written.
        let mut assigned = Vec::new();
        for (place, (output, &value)) in graph.outputs().iter().zip(values).enumerate() {
            let range = Whole { low: output.range.min as i64, high: output.range.max as i64 };
            let limited = self.lines.limited(value, range);
            let to = if output.counts.is_some() { "action" } else { "memory" };
            let name = field(graph, &output.name);
            if graph.memory() > 0 {
                self.line(depth, &format!("const int32_t next_{place} = {limited};"));
                assigned.push((to, name, output_bits(output), format!("next_{place}")));
            } else {
                assigned.push((to, name, output_bits(output), limited));
            }
        }
        for (to, name, bits, value) in assigned {
            let cast = if bits == 32 { String::new() } else { format!("(int{bits}_t)") };
            self.line(depth, &format!("{to}->{name} = {cast}{value};"));
        }
    }
}

/// A comment on as many lines as it takes.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    // The end of the comment stays with the last word.
    for word in text.replace(" */", "\u{a0}*/").split(' ') {
        let last = lines.len() - 1;
        if !lines[last].is_empty() && lines[last].len() + 1 + word.len() > width {
            lines.push(format!(" * {word}"));
        } else {
            let line = &mut lines[last];
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(word);
        }
    }
    lines.into_iter().map(|line| line.replace('\u{a0}', " ")).collect()
}
