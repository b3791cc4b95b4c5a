//! The interpreter as a program that times itself, with the same protocol as `templates/main.c`: `interpreter STATES
//! GRAPH` waits for requests, `interpreter STATES PASSES COUNT GRAPH` handles one and exits.

use std::io::{self, Write as _};
use std::path::Path;
use std::{env, fs};
use tpg_benches::cpu_seconds;
use tpg_benches::program::hash_of;
use tpg_graph::{Graph, ScalarType};
use tpg_graph::{import, interpret};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let words: Vec<String> = env::args().skip(1).collect();
    let (states, work, graph) = match &words[..] {
        [states, graph] => (states, None, graph),
        [states, passes, count, graph] => (states, Some((passes.parse::<u32>()?, count.parse::<usize>()?)), graph),
        _ => return Err("accepted: STATES GRAPH, or STATES PASSES COUNT GRAPH".into()),
    };
    let graph = import::load(Path::new(graph), None, None)?;
    let states = numbers(&graph, &fs::read(states)?);
    if let Some((passes, count)) = work {
        (0..passes).for_each(|_| println!("{}", pass(&graph, &states[..count * graph.state_length()])));
        return Ok(());
    }
    for line in io::stdin().lines() {
        let passes: u64 = line?.trim().parse()?;
        let start = cpu_seconds();
        let mut hash = 0;
        for _ in 0..passes {
            hash = pass(&graph, &states);
        }
        println!("{:.0} {hash}", (cpu_seconds() - start) * 1e9);
        io::stdout().flush()?;
    }
    Ok(())
}

fn pass(graph: &Graph, states: &[f64]) -> u32 {
    hash_of(interpret::actions(graph, states).iter().map(|action| action.0))
}

fn numbers(graph: &Graph, bytes: &[u8]) -> Vec<f64> {
    match graph.scalar() {
        ScalarType::F32 => bytes.as_chunks().0.iter().map(|&bytes| f64::from(f32::from_ne_bytes(bytes))).collect(),
        ScalarType::F64 => bytes.as_chunks().0.iter().map(|&bytes| f64::from_ne_bytes(bytes)).collect(),
    }
}
