//! A run for each price of an ask, and one without asking: a configuration whose `ask.price` is a list.
//!
//! The folder contains `sweep.toml` (the request), `alone` and `price-P` (the folders of runs, or of restarts), and what
//! [`front`](crate::hybrid::front) makes of them: the same bytes for equal runs.

use super::command::{Training, of_seed};
use super::config::{AskConfig, EvolutionConfig, Price};
use super::run::RunError;
use crate::files::{read_graph, read_text, write_atomically};
use crate::folder::{RunFolder, Trainer};
use crate::hybrid::front::{Trained, conclude};
use crate::hybrid::study;
use crate::ranks::workplace::Workplace;
use crate::run_args::command_line;
use crate::sac::network::Network;
use std::path::Path;
use tpg_graph::command::Verdict;
use tpg_graph::error::{InputError, Place};

/// The name of the request's file.
const REQUEST: &str = "sweep.toml";
/// The name of the folder of graphs that ask nobody.
pub(crate) const ALONE: &str = "alone";

/// Trains at every price, and compares.
///
/// # Errors
/// As of a single run; a folder with another sweep; several ranks.
pub(super) fn run<W: Workplace>(training: &Training<'_, W>, prices: &[f64], out: &Path) -> Result<Verdict, RunError> {
    let &Training { args, config, problem, network, place, .. } = training;
    if place.ranks() > 1 {
        let accepted = "one price, or a single process";
        return Err(command_line(format!("{} prices for {} ranks", prices.len(), place.ranks()), accepted).into());
    }
    let (Some(ask), Some(network)) = (&config.ask, network) else { return Ok(Verdict::Good) };
    let _folder = RunFolder::open(out, Trainer::Sweep, args.run.resume)?;
    request(&out.join(REQUEST), config)?;
    let mut runs = vec![(ALONE.to_owned(), EvolutionConfig { ask: None, ..config.clone() })];
    runs.extend(prices.iter().map(|&price| {
        let ask = Some(AskConfig { price: Price::One(price), ..ask.clone() });
        (at_price(price), EvolutionConfig { ask, ..config.clone() })
    }));
    for (name, config) in &runs {
        tpg_graph::command::note(format_args!("{name}:"));
        let verdict = Training { config, ..*training }.run(&out.join(name))?;
        if verdict != Verdict::Good {
            return Ok(verdict);
        }
    }
    let seeds: Vec<u64> = args.seeds.map_or_else(|| vec![args.seed], |seeds| seeds.all().collect());
    let of_run = |name: &str, seed: u64| {
        let folder = if args.seeds.is_some() { Path::new(name).join(of_seed(seed)) } else { name.into() };
        let file = folder.join("graph.json");
        Ok((file.display().to_string(), read_graph(&out.join(&file))?))
    };
    let graphs = |name: &str| seeds.iter().map(|&seed| of_run(name, seed)).collect::<Result<Vec<_>, InputError>>();
    let at = |price: &f64| Ok((*price, graphs(&at_price(*price))?));
    let trained = Trained {
        problem,
        network: (ask.policy.clone(), Network::Fixed(Box::new(network.clone()))),
        episodes: config.selection.validation_episodes,
        alone: graphs(ALONE)?,
        asking: prices.iter().map(at).collect::<Result<_, InputError>>()?,
        seeds: seeds.clone(),
    };
    conclude(&trained, &study::threads(args.threads)?, out)?;
    Ok(Verdict::Good)
}

/// Returns the name of a price's folder.
pub(crate) fn at_price(price: f64) -> String {
    format!("price-{price}")
}

/// Writes the request, or compares it with the one of the sweep that goes on. Its runs may have more generations.
fn request(path: &Path, config: &EvolutionConfig) -> Result<(), InputError> {
    let text = config.to_toml();
    if path.exists() {
        let name = path.display().to_string();
        let mut before = EvolutionConfig::of_run(&name, &read_text(path, "a sweep.toml")?)?;
        before.learning.nb_generations = config.learning.nb_generations;
        if before.to_toml() != text {
            let accepted = "the configuration that the sweep began with, or another --out";
            return Err(InputError::new(name, Place::Whole, "another sweep", accepted));
        }
    }
    write_atomically(path, text.as_bytes())
}
