//! Policies in closed loop with plants that are graphs with memory, too: a firmware computes the very steps that the interpreter
//! does here, and every action and every observation must have the same bits.

use crate::Failure;
use crate::data::Data;
use crate::line;
use crate::programs::Ran;
use crate::record::Hash;
use std::fmt::Write as _;
use std::path::Path;
use tpg_codegen::emit::{self, File, Language, Options, Prefix, Profile};
use tpg_engine::Environment;
use tpg_engine::random::{Purpose, Stream};
use tpg_graph::interpret::{Answer, Interpreter};
use tpg_graph::{Graph, import};
use tpg_problems::{CartPole, Pendulum};
use tpg_runtime::ops::{Own, own};
use tpg_testing::library;

/// The profiles, as prefixes and reports name them.
pub(crate) const PROFILES: [(Profile, &str); 4] = [
    (Profile::Fast, "fast"),
    (Profile::Balanced, "balanced"),
    (Profile::Small, "small"),
    (Profile::ConstantTime, "constant"),
];

/// Episodes of each policy in each profile.
const EPISODES: u64 = 4;

/// The observations of an episode.
type Observations = Vec<Vec<f32>>;

/// A graph's name in generated code and reports, and its file.
type NamedPolicy = (&'static str, &'static str);

/// Policies of one problem and its plant.
pub(crate) struct ClosedLoop {
    policies: &'static [NamedPolicy],
    plant: NamedPolicy,
    /// Actions of an episode.
    steps: usize,
    /// The name of the file with the starts.
    data: &'static str,
    /// The plant's memory at the start of each episode, and what is seen of it; nothing where it is the memory.
    starts: fn() -> Vec<Vec<f32>>,
}

/// The shipped policy of CartPole.
pub(crate) const CARTPOLE: ClosedLoop = ClosedLoop {
    policies: &[("pole", "generated/cartpole/graph.json")],
    plant: ("cart", "c-harness/cartpole/plant.json"),
    steps: 500,
    data: "poles",
    starts: || {
        let draw = |index| Environment::<f32>::draw(&CartPole, &mut stream(index)).map(|value| value as f32).to_vec();
        (0..EPISODES).map(draw).collect()
    },
};

/// Policies of a pendulum that answer with a torque; `recall` sees no velocity and remembers.
pub(crate) const PENDULUM: ClosedLoop = ClosedLoop {
    policies: &[("swing", "c-harness/pendulum/swing.json"), ("recall", "c-harness/pendulum/recall.json")],
    plant: ("plant", "c-harness/pendulum/plant.json"),
    steps: 200,
    data: "starts",
    starts: || {
        let draw = |index| {
            let [angle, velocity] = Environment::<f32>::draw(&Pendulum, &mut stream(index)).map(|value| value as f32);
            vec![angle, velocity, own::f32::cos(angle), own::f32::sin(angle), velocity]
        };
        (0..EPISODES).map(draw).collect()
    },
};

/// The random numbers of an evaluation episode.
pub(crate) fn stream(index: u64) -> Stream {
    Stream::new(1, 0, Purpose::Evaluation, index)
}

/// Reads a committed graph.
pub(crate) fn load(path: &str) -> Result<Graph, Failure> {
    import::load(&library::top().join(path), None, None).map_err(Failure::new)
}

/// A step of a graph in `f32` with own maths: its outputs or its action. It replaces the graph's memory.
fn step(graph: &Graph, seen: &[f32], memory: &mut [f32]) -> Vec<f32> {
    let state = [seen, &*memory].concat();
    match Interpreter::<f32, Own>::new(graph).answer(&state) {
        Answer::Values(values) => {
            let mut values: Vec<f32> = values.into_iter().map(|value| value as f32).collect();
            memory.copy_from_slice(&values.split_off(values.len() - memory.len()));
            values
        }
        Answer::Action(action) => vec![f32::from(action.0)],
    }
}

impl ClosedLoop {
    /// Runs the episodes of a policy here: a hash of every action and observation, and the observations of each episode.
    fn run(&self, policy: &Graph) -> Result<(Hash, Vec<Observations>), Failure> {
        let plant = load(self.plant.1)?;
        let mut hash = Hash::new();
        let first = policy.outputs().len() - policy.memory();
        let sources = policy.state_length() - policy.memory();
        let episode = |mut start: Vec<f32>| {
            let mut seen = start.split_off(plant.memory());
            let mut inside = start;
            if seen.is_empty() {
                seen = inside.clone();
            }
            let mut memory: Vec<f32> = policy.outputs()[first..].iter().map(|value| value.nan as f32).collect();
            let step = |_| {
                let action = step(policy, &seen[..sources], &mut memory);
                seen = step(&plant, &action, &mut inside);
                let bits = |value: &f32| if first == 0 { *value as u64 } else { u64::from(value.to_bits()) };
                action.iter().for_each(|value| hash.add(bits(value)));
                seen.iter().for_each(|value| hash.add(u64::from(value.to_bits())));
                seen.clone()
            };
            (0..self.steps).map(step).collect()
        };
        let episodes = (self.starts)().into_iter().map(episode).collect();
        Ok((hash, episodes))
    }

    /// The policies in every profile and the plant, in both languages, and the starts; all of it will be in `folder`.
    pub(crate) fn files(&self, folder: &Path) -> Result<Vec<File>, Failure> {
        let mut modules = Modules::default();
        for (name, path) in self.policies {
            modules.add_profiles(folder, &load(path)?, name)?;
        }
        modules.add(folder, &load(self.plant.1)?, self.plant.0, Profile::Fast)?;
        let Modules { mut files, text } = modules;
        let mut data = Data::new(self.data, "");
        data.number("STEPS", self.steps);
        data.floats("starts", &(self.starts)());
        data.rust(&text);
        files.extend(data.files());
        Ok(files)
    }

    /// Compares a firmware's actions and observations with this machine's.
    pub(crate) fn check(&self, ran: &Ran<'_>) -> Result<(), Failure> {
        let actions = EPISODES * self.steps as u64;
        for (name, path) in self.policies {
            let (hash, _) = self.run(&load(path)?)?;
            for (_, profile) in PROFILES {
                line::check(ran.language, ran.lines, &format!("cost {name} {profile}"), actions, &hash)?;
            }
            println!("{}: {actions} actions of {name} in every profile: the same bits as on the host", ran.language);
        }
        Ok(())
    }
}

/// Generated code in both languages, and the Rust modules that it makes up.
#[derive(Default)]
pub(crate) struct Modules {
    pub(crate) files: Vec<File>,
    pub(crate) text: String,
}

impl Modules {
    /// Adds a graph; its files will be in `folder`.
    fn add(&mut self, folder: &Path, graph: &Graph, name: &str, profile: Profile) -> Result<(), Failure> {
        let prefix = name.parse::<Prefix>().map_err(Failure::new)?;
        let path = folder.join(format!("{name}.rs")).display().to_string();
        let _ = writeln!(self.text, "#[path = {path:?}]\nmod {name};");
        for language in [Language::C, Language::Rust] {
            let options = Options { profile: Some(profile), ..Options::new(prefix.clone()) };
            self.files.extend(emit::emit(graph, language, &options));
        }
        Ok(())
    }

    /// Adds a graph in every profile.
    pub(crate) fn add_profiles(&mut self, folder: &Path, graph: &Graph, name: &str) -> Result<(), Failure> {
        PROFILES.iter().try_for_each(|&(profile, short)| self.add(folder, graph, &format!("{name}_{short}"), profile))
    }
}

#[cfg(test)]
mod tests {
    use super::{CARTPOLE, ClosedLoop, PENDULUM, PROFILES, load, step};
    use crate::line::Line;
    use crate::programs::Ran;
    use tpg_engine::{Act, Environment, SourceSet, Training as _};
    use tpg_problems::{CartPole, Pendulum};
    use tpg_runtime::policy::ActionId;

    #[test]
    fn the_cart_steps_as_the_problem_does() {
        let plant = load(CARTPOLE.plant.1).expect("the committed plant");
        for mut seen in (CARTPOLE.starts)() {
            // So long that the pole falls over and turns around.
            for number in 0..CARTPOLE.steps / 5 {
                let push = (number / 7 % 2) as u16;
                let mut state = [0, 1, 2, 3].map(|place| f64::from(seen[place]));
                step(&plant, &[f32::from(push)], &mut seen);
                Environment::<f32>::step(&CartPole, &mut state, Act::Choice(ActionId(push)));
                // The problem computes in f64.
                let near = seen.iter().zip(state).all(|(found, expected)| (f64::from(*found) - expected).abs() < 1e-4);
                assert!(near, "{seen:?} {state:?}");
            }
        }
    }

    #[test]
    fn the_pendulum_steps_as_the_problem_does() {
        let plant = load(PENDULUM.plant.1).expect("the committed plant");
        for start in (PENDULUM.starts)() {
            let mut swing = Environment::<f32>::start(&Pendulum, &[f64::from(start[0]), f64::from(start[1])]);
            for number in 0..PENDULUM.steps {
                let torque = (number as f32 * 0.7).sin() * 2.0;
                let before = Pendulum.task_from(&swing).expect("an angle and a velocity");
                let found = step(&plant, &[torque], &mut before.map(|value| value as f32));
                Environment::<f32>::step(&Pendulum, &mut swing, Act::Values(&[torque]));
                let mut expected = [0.0_f32; 3];
                Pendulum.observe(&mut swing, SourceSet::ALL, &mut expected);
                // The problem computes in f64, where the angle is not wrapped.
                let near = found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-5);
                assert!(near, "{found:?} {expected:?}");
            }
        }
    }

    #[test]
    fn the_pole_stands_for_every_step() {
        let (_, episodes) = CARTPOLE.run(&load(CARTPOLE.policies[0].1).expect("a committed graph")).expect("a plant");
        assert_eq!(episodes.concat().len(), 4 * 500);
        assert!(episodes.concat().iter().all(|seen| seen[0].abs() <= 2.4 && seen[2].abs() <= 0.2094));
    }

    #[test]
    fn the_policies_bring_the_pendulum_upright() {
        for (name, path) in PENDULUM.policies {
            let (_, episodes) = PENDULUM.run(&load(path).expect("a committed graph")).expect("a plant");
            let ends = episodes.iter().map(|episode| &episode[episode.len() - 1]);
            let upright = ends.filter(|seen| seen[0] > 0.95 && seen[2].abs() < 1.0).count();
            assert!(upright * 4 >= episodes.len() * 3, "{name}");
        }
    }

    fn checked(problem: &ClosedLoop, other: u64, skip: usize) -> bool {
        let last = problem.policies.len() - 1;
        let lines = problem.policies.iter().enumerate().flat_map(|(place, (name, path))| {
            let (hash, episodes) = problem.run(&load(path).expect("a committed graph")).expect("a plant");
            let actions = episodes.concat().len();
            PROFILES.map(move |(_, profile)| {
                let hash = hash.0 ^ if place == last && profile == "constant" { other } else { 0 };
                Line::parse(&format!("cost {name} {profile} actions={actions} instructions=1 worst=1 hash={hash:016x}"))
            })
        });
        let lines: Vec<Line> = lines.collect();
        problem.check(&Ran { language: "C", image: "image".as_ref(), lines: &lines[skip..] }).is_ok()
    }

    #[test]
    fn one_other_bit_is_a_failure() {
        for problem in [CARTPOLE, PENDULUM] {
            assert!(checked(&problem, 0, 0));
            assert!(!checked(&problem, 1, 0));
            assert!(!checked(&problem, 0, 1));
        }
    }
}
