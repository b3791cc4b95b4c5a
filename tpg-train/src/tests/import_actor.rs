//! Actors written by Stable-Baselines3 and CleanRL: after import they give the same outputs as PyTorch.

use crate::sac::foreign::from_tensors;
use crate::sac::import::{ImportArgs, import};
use crate::sac::tensors::{Tensor, Tensors};
use crate::sac::weights;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::PathBuf;
use tpg_arm::sac::FEATURES;
use tpg_engine::Output;
use tpg_nn::Tape;
use tpg_problems::ProblemName;

#[derive(Deserialize)]
struct Answers {
    observations: Vec<Vec<f32>>,
    sb3: Vec<Vec<f32>>,
    cleanrl: Vec<Vec<f32>>,
}

fn fixture(name: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "tests/fixtures/foreign-actors", name].iter().collect()
}

fn read(trainer: &str) -> Tensors {
    Tensors::read(&fixture(&format!("{trainer}.safetensors")), 1 << 20).expect("a fixture")
}

#[test]
fn imported_actors_answer_what_pytorch_did() {
    let text = std::fs::read_to_string(fixture("answers.json")).expect("a fixture");
    let answers: Answers = serde_json::from_str(&text).expect("answers");
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (trainer, wanted) in [("sb3", &answers.sb3), ("cleanrl", &answers.cleanrl)] {
        let out = folder.path().join(trainer);
        let (config, actor) = (folder.path().join("rs.toml"), fixture(&format!("{trainer}.safetensors")));
        std::fs::write(&config, "[problem]\nname = \"rs\"\nactions = \"fine\"\nmask = \"none\"\n").expect("a file");
        let args = ImportArgs { actor, out: out.clone(), problem: None, config: Some(config) };
        import(&args).expect("a good actor");
        let of_the_arm = ImportArgs { problem: Some(ProblemName::Rs), config: None, ..args };
        assert!(import(&of_the_arm).expect_err("no moves").to_string().contains("actions, fine or coarse"));
        let (network, contract) = weights::read(&out).expect("what was just written");
        assert_eq!(contract.actor.hidden, [7, 5]);
        let mut tape = Tape::new(network.shape(), 1);
        for (observation, wanted) in answers.observations.iter().zip(wanted) {
            tape.input_mut().copy_from_slice(observation);
            network.forward(&mut tape);
            for (answer, wanted) in tape.output().iter().zip(wanted) {
                assert!((answer - wanted).abs() < 1e-6, "{trainer}: {answer} {wanted}");
            }
        }
    }
}

fn outputs(count: usize, most: f64) -> Vec<Output> {
    vec![Output { name: "torque".to_owned(), unit: String::new(), min: -most, max: most }; count]
}

#[test]
fn a_stretch_of_the_actions_is_that_of_the_problem() {
    let stretched = |scale: f32, most: f64| {
        let mut file = read("cleanrl");
        file.tensors.insert("action_scale".to_owned(), Tensor::flat(vec![scale]));
        from_tensors(file, FEATURES, &outputs(4, most)).map(|_| ()).map_err(|finding| finding.key)
    };
    assert_eq!(stretched(2.0, 2.0), Ok(()));
    assert_eq!(stretched(2.0, 1.0), Err("action_scale".to_owned()));
}

#[test]
fn what_does_not_fit_is_refused_at_its_place() {
    let place = |trainer: &str, inputs: usize, change: &dyn Fn(&mut BTreeMap<String, Tensor>)| {
        let mut file = read(trainer);
        change(&mut file.tensors);
        from_tensors(file, inputs, &outputs(4, 1.0)).map(|(_, trainer)| trainer).map_err(|finding| finding.key)
    };
    fn tensor<'a>(tensors: &'a mut BTreeMap<String, Tensor>, name: &str) -> &'a mut Tensor {
        tensors.get_mut(name).expect("a tensor of the fixture")
    }
    let features = FEATURES;
    assert_eq!(place("sb3", features, &|_| ()), Ok("Stable-Baselines3"));
    assert_eq!(place("cleanrl", features, &|_| ()), Ok("CleanRL"));
    let refused = |place: &str| Err(place.to_owned());
    assert_eq!(place("sb3", 13, &|_| ()), refused("latent_pi.0.weight"));
    assert_eq!(place("sb3", features, &|t| drop(t.remove("mu.bias"))), refused("mu.bias"));
    assert_eq!(place("sb3", features, &|t| drop(t.remove("mu.weight"))), refused(""));
    assert_eq!(place("sb3", features, &|t| drop(t.remove("log_std.weight"))), refused("log_std.weight"));
    assert_eq!(place("sb3", features, &|t| tensor(t, "mu.weight").values[0] = f32::NAN), refused("mu.weight"));
    assert_eq!(place("cleanrl", features, &|t| tensor(t, "action_scale").values[0] = 2.0), refused("action_scale"));
    assert_eq!(place("cleanrl", features, &|t| drop(t.insert("q".into(), Tensor::flat(vec![]))),), refused("q"));
}
