//! Compares generated code with the interpreter: every profile in both languages, on all of the paper's policies and on
//! this project's, on random states and on every state of the recorded episodes.
//!
//! `cargo run --release -p tpg-benches --bin conformance -- [STATES] [NAME]`; a million states by default. Exit status
//! 1 if anything differs.

use std::env;
use std::process::ExitCode;
use tpg_benches::subject::{self, Subject};
use tpg_benches::variant::Variant;
use tpg_codegen::emit::Language;
use tpg_codegen::verify::{self, BuildError, Process, Workshop};
use tpg_graph::engine::Engine;
use tpg_graph::interpret;

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let words: Vec<String> = env::args().skip(1).collect();
    let states = words.iter().find_map(|word| word.parse().ok()).unwrap_or(1_000_000);
    let name = words.iter().find(|word| word.parse::<usize>().is_err());
    let mut total = Total::default();
    println!("| policy | code | random states | differences | states of episodes | differences |");
    println!("| --- | --- | --- | --- | --- | --- |");
    let subjects = subject::own().into_iter().chain(subject::conformance(usize::MAX));
    for subject in subjects.filter(|subject| name.is_none_or(|name| subject.name.contains(name.as_str()))) {
        total.policies += 1;
        compare(&subject, states, &mut total)?;
    }
    let Total { policies, engines, drawn, recorded, differences } = total;
    println!(
        "\n{policies} policies, {engines} compiled: {drawn} decisions on random states and {recorded} on states of episodes,"
    );
    println!("{differences} differences");
    Ok(if differences == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

#[derive(Default)]
struct Total {
    policies: usize,
    engines: usize,
    drawn: usize,
    recorded: usize,
    differences: usize,
}

fn compare(subject: &Subject, states: usize, total: &mut Total) -> Result<(), Box<dyn std::error::Error>> {
    let workshop = Workshop::new()?;
    let mut programs: Vec<Process> =
        Variant::ALL.iter().filter_map(|variant| build(&workshop, subject, *variant)).collect::<Result<_, _>>()?;
    let mut engines: Vec<&mut dyn Engine> = programs.iter_mut().map(|program| program as &mut dyn Engine).collect();
    let drawn = verify::compare(&subject.graph, &mut engines, states, 1)?;
    let expected = interpret::answers(&subject.graph, &subject.states);
    for (engine, drawn) in engines.iter_mut().zip(drawn) {
        let mut found = Vec::with_capacity(expected.len());
        engine.answer(&subject.states, &mut found)?;
        let differences = expected.iter().zip(&found).filter(|(expected, found)| expected != found).count();
        let name = engine.name();
        println!(
            "| {} | {name} | {} | {} | {} | {differences} |",
            subject.name,
            drawn.states,
            drawn.differences,
            found.len()
        );
        if let Some(first) = drawn.first {
            println!("{}, {name}: {first:?}", subject.name);
        }
        total.engines += 1;
        total.drawn += drawn.states;
        total.recorded += found.len();
        total.differences += differences + drawn.differences;
    }
    Ok(())
}

fn build(workshop: &Workshop, subject: &Subject, variant: Variant) -> Option<Result<Process, BuildError>> {
    let (language, options) = variant.emission()?;
    Some(match language {
        Language::C => workshop.c(&subject.graph, &options),
        Language::Rust => workshop.rust(&subject.graph, &options),
    })
}
