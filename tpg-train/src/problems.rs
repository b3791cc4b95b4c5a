//! `tpg-train problems`: the built-in problems, with what they observe and do.

use clap::ValueEnum;
use std::fmt::Write as _;
use tpg_engine::ActionSpace;
use tpg_graph::SourceDocument;
use tpg_graph::command::print;
use tpg_graph::error::InputError;
use tpg_problems::{Problem, ProblemName};

/// Prints the problems.
///
/// # Errors
/// If stdout is closed.
pub(crate) fn print_problems() -> Result<(), InputError> {
    let text = ProblemName::ALL.map(description).concat();
    print(&text)
}

/// Describes a problem.
fn description(name: ProblemName) -> String {
    let problem = Problem::new(name);
    let environment = problem.environment::<f32>();
    let about = name.to_possible_value().and_then(|value| value.get_help().map(ToString::to_string));
    let mut text = format!("{}: {}\n", name.name(), about.unwrap_or_default());
    let sources = environment.sources().iter().map(source).collect::<Vec<_>>().join("; ");
    let _ = writeln!(text, "  observes {sources}");
    let _ = writeln!(text, "  actions  {}", actions(&environment.actions()));
    let _ = writeln!(text, "  at most  {} steps per episode", environment.time_limit());
    if !problem.controllers().is_empty() {
        let _ = writeln!(text, "  brings   {}, for `eval --policy` and `--against`", problem.controllers().join(", "));
    }
    text.push('\n');
    text
}

fn source(source: &SourceDocument) -> String {
    let values = if source.length == 1 { String::new() } else { format!(" ({} values)", source.length) };
    let unit = if source.unit.is_empty() { String::new() } else { format!(", {}", source.unit) };
    format!("{}{values}{unit}", source.name)
}

fn actions(space: &ActionSpace) -> String {
    match space {
        ActionSpace::Discrete(_) => {
            format!("one of {}", space.names().collect::<Vec<_>>().join(", "))
        }
        ActionSpace::Box(outputs) => {
            let output = |output: &tpg_engine::Output| {
                format!("{} from {} to {} {}", output.name, output.min, output.max, output.unit).trim_end().to_owned()
            };
            outputs.iter().map(output).collect::<Vec<_>>().join("; ")
        }
    }
}
