//! Checks that the committed code is what the generator produces today and that it acts like the graph.

use std::fs;
use std::path::{Path, PathBuf};
use tpg_codegen::compile;
use tpg_codegen::emit::{self, Language, Options, Prefix, Profile};
use tpg_codegen::report;
use tpg_codegen::size::{Target, build_c, measure};
use tpg_generated::acrobot::Acrobot;
use tpg_generated::asterix::Asterix;
use tpg_generated::bipedal_walker::BipedalWalker;
use tpg_generated::breakout::Breakout;
use tpg_generated::cartpole::Cartpole;
use tpg_generated::dodge::Dodge;
use tpg_generated::eye::Eye;
use tpg_generated::half_cheetah::HalfCheetah;
use tpg_generated::hopper::Hopper;
use tpg_generated::inverted_double_pendulum::InvertedDoublePendulum;
use tpg_generated::lunar_lander::LunarLander;
use tpg_generated::lunar_lander_continuous::LunarLanderContinuous;
use tpg_generated::mountain_car::MountainCar;
use tpg_generated::mountain_car_continuous::MountainCarContinuous;
use tpg_generated::pendulum::Pendulum;
use tpg_generated::space_invaders::SpaceInvaders;
use tpg_generated::swimmer::Swimmer;
use tpg_generated::widowx_fs::WidowxFs;
use tpg_generated::widowx_fs_fast::WidowxFsFast;
use tpg_generated::widowx_rs::WidowxRs;
use tpg_generated::widowx_rs_fast::WidowxRsFast;
use tpg_graph::Graph;
use tpg_graph::interpret::{self, Answer};
use tpg_graph::states;
use tpg_runtime::policy::{ActionId, Policy};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// Returns the folders with a `graph.json` next to this crate's manifest.
fn policies() -> Vec<PathBuf> {
    let mut folders: Vec<PathBuf> = fs::read_dir(folder("."))
        .expect("the crate's folder")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.join("graph.json").is_file())
        .collect();
    folders.sort();
    assert!(!folders.is_empty());
    folders
}

fn graph(folder: &Path) -> Graph {
    let path = folder.join("graph.json");
    let text = fs::read_to_string(&path).expect("readable");
    Graph::from_json(&path.display().to_string(), &text).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn graphs_are_in_canonical_form() {
    for folder in policies() {
        let text = fs::read_to_string(folder.join("graph.json")).expect("readable");
        assert!(
            graph(&folder).to_json() == text,
            "{}: `tpg-codegen convert` it",
            folder.display()
        );
    }
}

#[test]
fn generated_code_is_fresh() {
    for folder in policies() {
        let prefix = Prefix::of_file(&folder.join("graph.json"));
        let file = format!("{}_fast.rs", prefix.lower());
        let fast: Prefix = format!("{}_fast", prefix.lower()).parse().expect("a name");
        let fast = Options {
            profile: Some(Profile::Fast),
            ..Options::new(fast)
        };
        let options = Options::new(prefix);
        let mut made = vec![(Language::C, &options), (Language::Rust, &options)];
        // The profile fast is worth a second file where there is more than a formula to choose.
        if folder.join(file).exists() {
            made.push((Language::Rust, &fast));
        }
        for (language, options) in made {
            for file in emit::emit(&graph(&folder), language, options) {
                let path = folder.join(&file.name);
                let found = fs::read_to_string(&path).unwrap_or_default();
                assert!(
                    found == file.text,
                    "{}: regenerate as PROVENANCE.md says",
                    path.display()
                );
            }
        }
    }
}

/// Returns the folders of the policies whose PROVENANCE.md explains them, with its text.
fn explained() -> Vec<(PathBuf, String)> {
    let text =
        |folder: &PathBuf| fs::read_to_string(folder.join("PROVENANCE.md")).expect("readable");
    let all = policies()
        .into_iter()
        .map(|folder| (folder.clone(), text(&folder)));
    let explained: Vec<_> = all
        .filter(|(_, text)| text.contains("```text\nWhat the "))
        .collect();
    assert!(explained.len() >= 11);
    explained
}

#[test]
fn provenance_has_the_formulas_of_todays_code() {
    for (folder, text) in explained() {
        let options = Options::new(Prefix::of_file(&folder.join("graph.json")));
        let formulas = report::explain(&graph(&folder), &options);
        assert!(
            text.contains(&format!("```text\n{}\n```", formulas.trim())),
            "{}/PROVENANCE.md: `tpg-codegen generate graph.json --explain` says\n{formulas}",
            folder.display()
        );
    }
}

#[test]
fn provenance_has_the_flash_of_todays_code() {
    if !tpg_testing::tool(
        "arm-none-eabi-gcc",
        "gcc-arm-none-eabi",
        "flash that PROVENANCE.md says",
    ) {
        return;
    }
    for (folder, text) in explained() {
        let options = Options {
            profile: Some(Profile::Fast),
            ..Options::new(Prefix::of_file(&folder.join("graph.json")))
        };
        let graph = graph(&folder);
        let code = emit::Code::of(compile(&graph, &options, Language::C));
        let built = build_c(&code, Target::M4f).expect("it compiles");
        let flash = measure(&built.object).expect("an object file").flash();
        let (_, said) = text
            .split_once("| C, profile `fast` | ")
            .expect("a row of the code");
        let (said, _) = said
            .split_once(" bytes on a Cortex-M4F (`-Os`)")
            .expect("its flash");
        assert_eq!(
            said.replace(',', ""),
            flash.to_string(),
            "{}/PROVENANCE.md",
            folder.display()
        );
    }
}

/// An answer of a policy of this crate, as the interpreter says it.
trait Told {
    fn told(self) -> Answer;
}

impl Told for ActionId {
    fn told(self) -> Answer {
        Answer::Action(self)
    }
}

/// Outputs, and behind them the next memory where there is one.
impl<const N: usize> Told for [f32; N] {
    fn told(self) -> Answer {
        Answer::Values(self.map(f64::from).to_vec())
    }
}

/// Compares the Rust code of this crate, built by cargo like any other, with the interpreter. A memory stands behind the inputs.
fn acts_like<P, const N: usize>(policy: P, name: &str)
where
    P: Policy<State = [f32; N], Action: Told>,
{
    let graph = graph(&folder(name));
    assert_eq!(graph.state_length(), N, "{name}");
    let states = states::sample(&graph, 20_000, 7);
    let expected = interpret::answers(&graph, &states);
    for (state, expected) in states.chunks_exact(N).zip(expected) {
        let state: [f32; N] = std::array::from_fn(|index| state[index] as f32);
        let found = policy.decide(&state).told();
        assert!(
            found.same_bits(&expected),
            "{name}, {state:?}: {found}, not {expected}"
        );
    }
}

#[test]
fn compiled_policies_act_like_their_graphs() {
    acts_like(WidowxFs, "widowx-fs");
    acts_like(WidowxFsFast, "widowx-fs");
    acts_like(WidowxRs, "widowx-rs");
    acts_like(WidowxRsFast, "widowx-rs");
    acts_like(Cartpole, "cartpole");
    acts_like(Dodge, "dodge");
    acts_like(Acrobot, "acrobot");
    acts_like(Asterix, "asterix");
    acts_like(BipedalWalker, "bipedal-walker");
    acts_like(Breakout, "breakout");
    acts_like(Eye, "eye");
    acts_like(HalfCheetah, "half-cheetah");
    acts_like(Hopper, "hopper");
    acts_like(InvertedDoublePendulum, "inverted-double-pendulum");
    acts_like(LunarLander, "lunar-lander");
    acts_like(LunarLanderContinuous, "lunar-lander-continuous");
    acts_like(MountainCar, "mountain-car");
    acts_like(MountainCarContinuous, "mountain-car-continuous");
    acts_like(Pendulum, "pendulum");
    acts_like(SpaceInvaders, "space-invaders");
    acts_like(Swimmer, "swimmer");
}
