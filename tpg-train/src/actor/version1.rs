//! Actors that earlier versions wrote: version 1 of `policy.safetensors`, which was the arm's alone.

use crate::sac::config::{Actor, Decides};
use crate::sac::contract::{Contract, FORMAT, Provenance};
use crate::sac::interface::{Input, Interface};
use crate::sac::tensors::Tensors;
use serde::Deserialize;
use tpg_engine::Output;
use tpg_graph::error::Finding;
use tpg_nn::Spread;
use tpg_problems::ContinuousProblem;
use tpg_problems::arm::motors::{Config, Inputs, MOTORS};
use tpg_problems::arm::targets::Start;

#[derive(Deserialize)]
struct Header {
    format: String,
    version: u32,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Version1 {
    #[serde(rename = "format")]
    _format: String,
    #[serde(rename = "version")]
    _version: u32,
    observation: Vec<String>,
    output: Vec<String>,
    actor: Actor1,
    provenance: Provenance1,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Actor1 {
    inputs: Inputs,
    hidden: Vec<usize>,
    layer_norm: bool,
    spread: Spread,
    actions: String,
    mask: String,
    may_rest: bool,
    #[serde(default)]
    decides: Decides,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Provenance1 {
    tool: String,
    config: String,
    problem: String,
    seed: u64,
    decisions: u64,
    #[serde(rename = "validation_success")]
    _validation_success: f64,
}

/// The same file with a contract of today's version; files of other versions stay as they are.
///
/// # Errors
/// If a contract of version 1 says what the arm does not have.
pub fn upgraded(file: Tensors) -> Result<Tensors, Finding> {
    let Some(text) = &file.text else { return Ok(file) };
    let header: Option<Header> = serde_json::from_str(text).ok();
    if !header.is_some_and(|header| header.format == FORMAT && header.version == 1) {
        return Ok(file);
    }
    let old: Version1 = serde_json::from_str(text)
        .map_err(|error| Finding::new("metadata.tpg", error, "the contract of a version 1 policy"))?;
    let contract = old.contract()?;
    Ok(Tensors { text: Some(serde_json::to_string(&contract).expect("plain data")), ..file })
}

impl Version1 {
    fn contract(self) -> Result<Contract, Finding> {
        let Self { observation, output, actor, provenance, .. } = self;
        let names = actor.inputs.names();
        if observation != names {
            let found = format!("{} inputs: {}", observation.len(), observation.join(" "));
            let accepted = format!("{} inputs in this order: {}", names.len(), names.join(" "));
            return Err(Finding::new("metadata.tpg.observation", found, accepted));
        }
        if output != MOTORS {
            return Err(Finding::new("metadata.tpg.output", output.join(" "), MOTORS.join(" ")));
        }
        let start = if provenance.problem == "fs" { Start::Fs } else { Start::Rs };
        let motors = motors(&actor)?;
        let network = Actor {
            scaled_inputs: false,
            hidden: actor.hidden,
            layer_norm: actor.layer_norm,
            spread: actor.spread,
            decides: actor.decides,
        };
        let Provenance1 { tool, config, problem, seed, decisions, .. } = provenance;
        // Only the success of the validation was kept, not its score.
        let provenance = Provenance { tool, config, problem, seed, decisions, validation: None };
        let interface = interface(motors.inputs);
        let problem = ContinuousProblem::Motors(start, motors).to_table();
        Ok(Contract::new(problem, &interface, network, provenance))
    }
}

fn motors(actor: &Actor1) -> Result<Config, Finding> {
    let unknown = |key: &str, found: &str, accepted: &str| {
        Finding::new(format!("metadata.tpg.actor.{key}"), format!("{found:?}"), accepted)
    };
    Ok(Config {
        inputs: actor.inputs,
        actions: tpg_arm::sac::Actions::from_name(&actor.actions)
            .ok_or_else(|| unknown("actions", &actor.actions, "fine or coarse"))?,
        mask: tpg_arm::sac::Mask::from_name(&actor.mask)
            .ok_or_else(|| unknown("mask", &actor.mask, "none or joint-limits"))?,
        may_rest: actor.may_rest,
        stuck_ends: actor.decides == Decides::ByMean,
        ..Config::default()
    })
}

/// The interface of the arm's motors.
pub(super) fn interface(inputs: Inputs) -> Interface {
    let input = |name: String| Input { name, unit: String::new(), offset: 0.0, scale: 1.0 };
    let output = |name: &str| Output { name: name.to_owned(), unit: String::new(), min: -1.0, max: 1.0 };
    Interface {
        inputs: inputs.names().into_iter().map(input).collect(),
        outputs: MOTORS.map(output).into(),
        chooses: false,
    }
}

#[cfg(test)]
mod tests {
    use super::upgraded;
    use crate::actor::file::FloatActor;
    use crate::sac::tensors::Tensors;
    use crate::sac::weights::from_tensors;
    use std::path::PathBuf;
    use tpg_problems::arm::motors::Inputs;

    fn committed() -> Tensors {
        let path: PathBuf = [env!("CARGO_MANIFEST_DIR"), "../generated/widowx-sac/policy.safetensors"].iter().collect();
        Tensors::read(&path, 1 << 20).expect("a committed file")
    }

    #[test]
    fn the_committed_actor_is_read() {
        let (network, contract) = from_tensors(upgraded(committed()).expect("version 1")).expect("a good file");
        let actor = FloatActor::of_contract(network, &contract).expect("an actor of the arm");
        assert_eq!((actor.motors.inputs, actor.motors.may_rest), (Inputs::Features, false));
        assert_eq!(upgraded(Tensors::default()), Ok(Tensors::default()));
    }

    #[test]
    fn a_contract_that_the_arm_does_not_have_is_refused_at_its_place() {
        for (from, to, key) in [
            ("\"shoulder\"", "\"knee\"", "metadata.tpg.observation"),
            ("\"fine\"", "\"medium\"", "metadata.tpg.actor.actions"),
            ("\"may_rest\"", "\"rests\"", "metadata.tpg"),
        ] {
            let mut file = committed();
            let text = file.text.take().expect("a contract");
            assert!(text.contains(from), "{from} in {text}");
            file.text = Some(text.replacen(from, to, 1));
            assert_eq!(upgraded(file).map(|_| ()).map_err(|finding| finding.key), Err(key.to_owned()));
        }
    }
}
