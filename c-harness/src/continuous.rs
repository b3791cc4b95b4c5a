//! Policies that answer with values, one of them with memory, in closed loop with a pendulum: graphs, all of them.
//!
//! The plant is a graph with memory, too. So a firmware computes the very steps that the interpreter does here, and every
//! torque and every observation must have the same bits.

use crate::Failure;
use crate::closed_loop::{Modules, compare_profiles, load, step};
use crate::line::Line;
use crate::record::Hash;
use std::fmt::Write as _;
use std::path::Path;
use tpg_codegen::emit::{File, Profile};
use tpg_engine::Environment;
use tpg_engine::random::{Purpose, Stream};
use tpg_graph::Graph;
use tpg_problems::Pendulum;
use tpg_runtime::ops::own;

/// Episodes of each policy in each profile.
const EPISODES: u64 = 4;
/// Actions of an episode.
const STEPS: u32 = 200;

/// The policies: `recall` sees no velocity and remembers.
const POLICIES: [&str; 2] = ["swing", "recall"];
/// The start of an episode: angle, velocity, and what is observed of them.
type Start = ([f32; 2], [f32; 3]);

fn graph(name: &str) -> Result<Graph, Failure> {
    load(&format!("c-harness/pendulum/{name}.json"))
}

fn starts() -> Vec<Start> {
    (0..EPISODES)
        .map(|index| {
            let task = Environment::<f32>::draw(&Pendulum, &mut Stream::new(1, 0, Purpose::Evaluation, index));
            let swing @ [angle, velocity] = task.map(|value| value as f32);
            (swing, [own::f32::cos(angle), own::f32::sin(angle), velocity])
        })
        .collect()
}

/// Runs the episodes of a policy here: a hash of every torque and observation, and the last observation of each episode.
fn run(policy: &Graph, plant: &Graph) -> (Hash, Vec<[f32; 3]>) {
    let mut hash = Hash::new();
    let first = policy.outputs().len() - policy.memory();
    let seen_by_policy = policy.state_length() - policy.memory();
    let ends = starts().into_iter().map(|(mut swing, mut seen)| {
        let mut memory: Vec<f32> = policy.outputs()[first..].iter().map(|value| value.nan as f32).collect();
        for _ in 0..STEPS {
            let torque = step(policy, &seen[..seen_by_policy], &mut memory);
            seen.copy_from_slice(&step(plant, &torque, &mut swing));
            torque.iter().chain(&seen).for_each(|value| hash.add(u64::from(value.to_bits())));
        }
        seen
    });
    let ends = ends.collect();
    (hash, ends)
}

/// The policies in every profile and the plant, in both languages, and the starts; all of it will be in `folder`.
pub(crate) fn files(folder: &Path) -> Result<Vec<File>, Failure> {
    let mut modules = Modules::default();
    for name in POLICIES {
        modules.add_profiles(folder, &graph(name)?, name)?;
    }
    modules.add(folder, &graph("plant")?, "plant", Profile::Fast)?;
    let Modules { mut files, text: modules } = modules;
    let starts = starts();
    let mut c = format!(
        "#ifndef STARTS_H\n#define STARTS_H\n\n#define EPISODES {EPISODES}U\n#define STEPS {STEPS}U\n\n\
         typedef struct start {{\n    float swing[2];\n    float seen[3];\n}} start_t;\n\n\
         static const start_t starts[EPISODES] = {{\n"
    );
    let mut rust =
        format!("const STEPS: u32 = {STEPS};\nstatic STARTS: [([f32; 2], [f32; 3]); {EPISODES}] = {starts:?};\n");
    for ([angle, velocity], [cos, sin, omega]) in starts {
        let _ = writeln!(c, "    {{ {{ {angle:?}F, {velocity:?}F }}, {{ {cos:?}F, {sin:?}F, {omega:?}F }} }},");
    }
    c.push_str("};\n\n#endif\n");
    rust.push_str(&modules);
    let texts = [("starts.h", c), ("starts.rs", rust)];
    files.extend(texts.map(|(name, text)| File { name: name.to_owned(), text }));
    Ok(files)
}

/// The names of the generated files that the firmware in C needs.
pub(crate) const C_FILES: [&str; 9] = [
    "plant",
    "swing_fast",
    "swing_balanced",
    "swing_small",
    "swing_constant",
    "recall_fast",
    "recall_balanced",
    "recall_small",
    "recall_constant",
];

/// Compares a firmware's torques and observations with this machine's.
pub(crate) fn compare(language: &str, image: &Path, lines: &[Line]) -> Result<(), Failure> {
    let plant = graph("plant")?;
    let actions = EPISODES * u64::from(STEPS);
    for name in POLICIES {
        let (hash, _) = run(&graph(name)?, &plant);
        compare_profiles(language, image, lines, name, hash, actions)?;
    }
    println!(
        "{language}: {actions} torques of a policy and of one with memory, in every profile, and what a pendulum does then: the \
         same bits as on the host"
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{POLICIES, STEPS, compare, graph, run, starts, step};
    use crate::closed_loop::PROFILES;
    use crate::line::Line;
    use tpg_engine::{Act, Environment, SourceSet, Training as _};
    use tpg_problems::Pendulum;

    #[test]
    fn the_plant_steps_as_the_problem_does() {
        let plant = graph("plant").expect("the committed plant");
        for (start, _) in starts() {
            let mut swing = Environment::<f32>::start(&Pendulum, &start.map(f64::from));
            for number in 0..STEPS {
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
    fn the_policies_bring_it_upright() {
        let plant = graph("plant").expect("the committed plant");
        for name in POLICIES {
            let (_, ends) = run(&graph(name).expect("a committed graph"), &plant);
            let upright = ends.iter().filter(|[cos, _, omega]| *cos > 0.95 && omega.abs() < 1.0).count();
            assert!(upright * 4 >= ends.len() * 3, "{name}: {ends:?}");
        }
    }

    #[test]
    fn one_other_bit_is_a_failure() {
        let plant = graph("plant").expect("the committed plant");
        let lines = |other: u64| -> Vec<Line> {
            let lines = POLICIES.into_iter().flat_map(|name| {
                let hash = run(&graph(name).expect("a committed graph"), &plant).0.0;
                PROFILES.map(|(_, profile)| {
                    let last = name == "recall" && profile == "constant";
                    let hash = hash ^ if last { other } else { 0 };
                    Line::parse(&format!("cost {name} {profile} actions=800 instructions=1 worst=1 hash={hash:016x}"))
                })
            });
            lines.collect()
        };
        assert!(compare("C", "image".as_ref(), &lines(0)).is_ok());
        assert!(compare("C", "image".as_ref(), &lines(1)).is_err());
        assert!(compare("C", "image".as_ref(), &lines(0)[1..]).is_err());
    }
}
