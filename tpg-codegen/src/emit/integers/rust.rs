//! `no_std` Rust in integers, without a way to panic.

use super::comment::{Comments, worth};
use super::lines::{Function, Lines, Spelling};
use crate::emit::file::{File, one_line};
use crate::emit::{banner, layout, names};
use crate::integers::{Integers, Whole, input_bits, output_bits};
use crate::ir::{NodeId, Target, reached, topological};
use crate::program::Program;
use askama::Template;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use tpg_graph::{Graph, Input};

#[derive(Template)]
#[template(path = "integers/policy.rs", escape = "none")]
struct Policy<'a> {
    banner: &'a [String],
    name: String,
    sources: Vec<String>,
    answers: Vec<String>,
    outputs: &'a [tpg_graph::Output],
    memory: usize,
    state_length: usize,
    /// The type of a value of the state.
    kind: String,
    /// The type of an answer.
    action: String,
    initial: String,
    seen: String,
    remembered: String,
    answered: String,
    body: String,
    called: BTreeSet<(Function, bool)>,
    widths: [bool; 2],
}

impl Policy<'_> {
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

/// The type of a value.
fn integer(wide: bool) -> &'static str {
    if wide { "i64" } else { "i32" }
}

/// The end of the name of a function of such values.
fn suffix(wide: bool) -> &'static str {
    if wide { "_64" } else { "" }
}

/// The spelling of Rust.
struct Rust<'a> {
    graph: &'a Graph,
}

impl Spelling for Rust<'_> {
    fn input(&self, input: Input, wide: bool) -> String {
        let place = format!("s[{}]", input.index());
        match (wide, state_bits(self.graph)) {
            (true, _) => format!("i64::from({place})"),
            (false, 32) => place,
            (false, _) => format!("i32::from({place})"),
        }
    }

    fn literal(&self, value: i64, wide: bool) -> String {
        if wide { format!("{value}_i64") } else { format!("{value}_i32") }
    }

    fn widened(&self, text: &str) -> String {
        format!("i64::from({text})")
    }

    fn narrowed(&self, text: &str) -> String {
        format!("{text} as i32")
    }

    fn call(&self, function: Function, wide: bool, arguments: &[String]) -> String {
        let method = |name: &str| format!("({}).{name}({})", arguments[0], arguments[1..].join(", "));
        let call = |name: &str| format!("{name}{}({})", suffix(wide), arguments.join(", "));
        match function {
            Function::Shift => format!("({} >> {})", arguments[0], arguments[1]),
            Function::Divide => call("divide"),
            Function::Quotient => call("quotient"),
            Function::Min => method("min"),
            Function::Max => method("max"),
            Function::Abs => method("abs"),
            Function::NegateIfLess => call("negate_if_less"),
            Function::Gate => call("gate"),
            Function::Clamp => method("clamp"),
        }
    }

    fn halved(&self, text: &str, bits: u32, _: bool) -> String {
        format!("({text} >> {bits})")
    }

    fn statement(&self, name: &str, wide: bool, value: &str) -> String {
        format!("let {name}: {} = {value};", integer(wide))
    }
}

/// Bits of the type of every value of a state: that of the widest.
fn state_bits(graph: &Graph) -> u32 {
    graph.inputs().map(|input| input_bits(graph, input)).max().unwrap_or(16)
}

fn answer_bits(graph: &Graph) -> u32 {
    graph.outputs().iter().map(output_bits).max().unwrap_or(16)
}

/// The file.
pub(super) fn files(program: &Program<'_>, integers: &Integers) -> Vec<File> {
    let (graph, prefix) = (program.graph(), &program.options.prefix);
    let lines = Lines::new(&program.module, integers, Rust { graph });
    let mut body = Body { program, integers, lines, text: String::new() };
    body.decide();
    let memory = graph.memory();
    let (observed, answers) = (graph.state_length() - memory, graph.outputs().len() - memory);
    let list = |name: &str, places: std::ops::Range<usize>| -> Vec<String> {
        places.map(|place| format!("{name}[{place}]")).collect()
    };
    let action = match graph.outputs() {
        [] => "ActionId".to_owned(),
        outputs => format!("[i{}; {}]", answer_bits(graph), outputs.len()),
    };
    let policy = Policy {
        banner: &banner::lines(program),
        name: prefix.camel(),
        sources: sources(graph),
        answers: self::answers(graph),
        outputs: graph.outputs(),
        memory,
        state_length: graph.state_length(),
        kind: format!("i{}", state_bits(graph)),
        action,
        initial: layout::array(
            &graph.outputs()[answers..].iter().map(|value| (value.nan as i64).to_string()).collect::<Vec<_>>(),
            4,
        ),
        seen: layout::array(&[list("state", 0..observed), list("memory", 0..memory)].concat(), 8),
        remembered: layout::array(&list("out", answers..answers + memory), 8),
        answered: layout::array(&list("out", 0..answers), 8),
        body: body.text.trim_end().to_owned(),
        called: body.lines.called(),
        widths: [false, true],
    };
    let text = layout::tidy(&policy.render().expect("the template renders"));
    vec![File { name: format!("{prefix}.rs"), text }]
}

fn sources(graph: &Graph) -> Vec<String> {
    let input = |input: Input| {
        let (source, place) = graph.source_of(input);
        let range = source.ranges[place];
        let worth = match graph.counts_of(input) {
            Some(counts) => {
                let offset = if counts.offset == 0.0 { String::new() } else { format!(" from {} on", counts.offset) };
                format!("{}{offset}, {range}", worth(counts.scale, &one_line(&source.unit)))
            }
            None => range.to_string(),
        };
        format!("`s[{}]`: {}, {worth}", input.index(), graph.input_name(input))
    };
    graph.inputs().map(input).collect()
}

fn answers(graph: &Graph) -> Vec<String> {
    let actions =
        graph.actions().iter().enumerate().map(|(id, action)| format!("{id}: {}", one_line(&action.to_string())));
    let output = |(place, output): (usize, &tpg_graph::Output)| {
        let worth =
            output.counts.map_or_else(String::new, |counts| worth(counts.scale, &one_line(&output.unit)) + ", ");
        format!("`[{place}]`: {}, {worth}{}", output.name, output.range)
    };
    actions.chain(graph.outputs().iter().enumerate().map(output)).collect()
}

/// The body of the decision.
struct Body<'a, 'g> {
    program: &'a Program<'g>,
    integers: &'a Integers,
    lines: Lines<'a, Rust<'a>>,
    text: String,
}

impl Body<'_, '_> {
    fn line(&mut self, depth: usize, text: &str) {
        let _ = writeln!(self.text, "{:1$}{text}", "", depth * 4);
    }

    fn decide(&mut self) {
        let module = &self.program.module;
        if let Some(leaf) = module.only_leaf() {
            return self.leaf(&leaf.values.clone(), 2);
        }
        let order = topological(&module.teams);
        if let ([team], true) = (&order[..], module.leaves.is_empty()) {
            return self.team(*team, 2);
        }
        // Vertices are numbered as the module does: teams from 0, the root, then leaves.
        self.line(2, "let mut vertex = 0_u32;");
        self.line(2, "loop {");
        self.line(3, "match vertex {");
        let ends = reached(&module.leaves).count();
        for (place, &team) in order.iter().enumerate() {
            let is_last = ends == 0 && place + 1 == order.len();
            self.line(4, &if is_last { "_ => {".to_owned() } else { format!("{team} => {{") });
            self.team(team, 5);
            self.line(4, "}");
        }
        for (place, (number, leaf)) in reached(&module.leaves).enumerate() {
            let vertex = module.teams.len() + number;
            self.line(4, &if place + 1 == ends { "_ => {".to_owned() } else { format!("{vertex} => {{") });
            self.text.push_str("");
            self.leaf_returned(&leaf.values.clone());
            self.line(4, "}");
        }
        self.line(3, "}");
        self.line(2, "}");
    }

    /// The expression that goes to a destination.
    fn go(&self, to: Target) -> String {
        let module = &self.program.module;
        match to {
            Target::Action(action) if module.leaves.is_empty() => format!("return ActionId({});", action.0),
            to => format!("vertex = {};", module.vertex(to)),
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
            let only = module.teams.len() == 1 && module.leaves.is_empty();
            return self.line(depth, if only { go.trim_start_matches("return ").trim_end_matches(';') } else { &go });
        }
        let is_action = |to: &Target| matches!(to, Target::Action(_)) && module.leaves.is_empty();
        let answers = ends.iter().all(is_action);
        let number = |to: Target| match to {
            Target::Action(action) if answers => format!("{}", action.0),
            to if answers || !ends.iter().any(is_action) => format!("{}", module.vertex(to)),
            to => format!("{}", ends.iter().position(|&end| end == to).unwrap_or(0)),
        };
        let bids: Vec<NodeId> = edges.iter().map(|edge| module.bidders[edge.bidder].value).collect();
        let name = |to: Target| match to {
            Target::Team(team) => format!("team {}", module.teams[team].label),
            Target::Action(end) => self.program.graph().end_name(end),
        };
        let named: Vec<(NodeId, String)> =
            bids.iter().zip(edges).map(|(&bid, edge)| (bid, one_line(&name(edge.to)))).collect();
        let comments = Comments::of_bids(module, &named);
        let wide = bids.iter().any(|&bid| self.lines.is_wide(bid));
        let mut open: BTreeSet<NodeId> = self.lines.choose(&bids).into_iter().collect();
        let actions = names::actions(self.program.graph());
        let variable = |to: Target| match to {
            Target::Team(team) => format!("to_team_{}", module.teams[team].label),
            Target::Action(end) => match module.leaves.get(usize::from(end.0)) {
                Some(leaf) => format!("to_leaf_{}", leaf.label),
                None => format!("to_{}", actions[usize::from(end.0)]),
            },
        };
        self.lines.name(bids.iter().zip(edges).map(|(&bid, edge)| (bid, variable(edge.to))).collect());
        for (place, (&bid, edge)) in bids.iter().zip(edges).enumerate() {
            for id in self.program.module.operations_of(bid) {
                if open.remove(&id) {
                    self.statement(id, &comments, depth);
                }
            }
            let value = self.lines.operand(bid, wide);
            let to = number(edge.to);
            if place == 0 {
                self.line(depth, &format!("let mut best: {} = {value};", integer(wide)));
                self.line(depth, &format!("let mut to = {to};"));
                continue;
            }
            self.line(depth, &format!("if {value} >= best {{"));
            if place + 1 < bids.len() {
                self.line(depth + 1, &format!("best = {value};"));
            }
            self.line(depth + 1, &format!("to = {to};"));
            self.line(depth, "}");
        }
        if answers {
            let only = module.teams.len() == 1;
            self.line(depth, if only { "ActionId(to)" } else { "return ActionId(to);" });
        } else if !ends.iter().any(is_action) {
            self.line(depth, "vertex = to;");
        } else {
            self.line(depth, "match to {");
            for (place, &end) in ends.iter().enumerate() {
                let case = if place + 1 == ends.len() { "_".to_owned() } else { place.to_string() };
                let go = self.go(end);
                self.line(depth + 1, &format!("{case} => {},", go.trim_end_matches(';')));
            }
            self.line(depth, "}");
        }
    }

    fn statement(&mut self, id: NodeId, comments: &Comments<'_>, depth: usize) {
        if let Some(said) = comments.of(id, self.integers.of(id)) {
            self.line(depth, &format!("// {said}"));
        }
        let statement = self.lines.statement(id).replace('\n', &format!("\n{:1$}", "", depth * 4));
        self.line(depth, &statement);
    }

    fn leaf(&mut self, values: &[NodeId], depth: usize) {
        let answer = self.outputs(values, depth);
        self.line(depth, &answer);
    }

    fn leaf_returned(&mut self, values: &[NodeId]) {
        let answer = self.outputs(values, 5);
        self.line(5, &format!("return {answer};"));
    }

    /// Writes the statements of a leaf, and returns its answer.
    fn outputs(&mut self, values: &[NodeId], depth: usize) -> String {
        let graph = self.program.graph();
        let comments = Comments::of_outputs(&self.program.module, values);
        for id in self.lines.choose(values) {
            self.statement(id, &comments, depth);
        }
        let bits = answer_bits(graph);
        let limited = graph.outputs().iter().zip(values).map(|(output, &value)| {
            let range = Whole { low: output.range.min as i64, high: output.range.max as i64 };
            let text = self.lines.limited(value, range);
            if bits == 32 { text } else { format!("({text}) as i{bits}") }
        });
        format!("[{}]", limited.collect::<Vec<_>>().join(", "))
    }
}
