//! The shipped policy of CartPole in every profile, in closed loop with the cart and its pole, which are a graph with memory: so a
//! firmware computes the very steps that the interpreter does here, and every push and every observation must have the same bits.

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
use tpg_graph::interpret::{self, Answer};
use tpg_problems::CartPole;

/// Episodes of each profile.
const EPISODES: u64 = 4;
/// Actions of an episode.
const STEPS: u32 = 500;

/// Position, velocity, angle and angular velocity.
type Seen = [f32; 4];

fn graphs() -> Result<[Graph; 2], Failure> {
    Ok([load("generated/cartpole/graph.json")?, load("c-harness/cartpole/plant.json")?])
}

fn starts() -> Vec<Seen> {
    let draw = |index| {
        Environment::<f32>::draw(&CartPole, &mut Stream::new(1, 0, Purpose::Evaluation, index)).map(|it| it as f32)
    };
    (0..EPISODES).map(draw).collect()
}

/// Runs the episodes here: a hash of every push and observation, and every observation.
fn run([policy, plant]: &[Graph; 2]) -> (Hash, Vec<Seen>) {
    let (mut hash, mut all) = (Hash::new(), Vec::new());
    for mut seen in starts() {
        for _ in 0..STEPS {
            let state = seen.map(f64::from);
            let Answer::Action(push) = interpret::answers(policy, &state).remove(0) else {
                unreachable!("the policy names an action")
            };
            // What is remembered is what is seen.
            step(plant, &[f32::from(push.0)], &mut seen);
            hash.add(u64::from(push.0));
            seen.iter().for_each(|value| hash.add(u64::from(value.to_bits())));
            all.push(seen);
        }
    }
    (hash, all)
}

/// The policy in every profile and the plant, in both languages, and the starts; all of it will be in `folder`.
pub(crate) fn files(folder: &Path) -> Result<Vec<File>, Failure> {
    let mut modules = Modules::default();
    let [policy, plant] = graphs()?;
    modules.add_profiles(folder, &policy, "pole")?;
    modules.add(folder, &plant, "cart", Profile::Fast)?;
    let Modules { mut files, text } = modules;
    let starts = starts();
    let mut c = format!(
        "#ifndef POLES_H\n#define POLES_H\n\n#define EPISODES {EPISODES}U\n#define STEPS {STEPS}U\n\n\
         static const float poles[EPISODES][4] = {{\n"
    );
    for [x, v, theta, omega] in &starts {
        let _ = writeln!(c, "    {{ {x:?}F, {v:?}F, {theta:?}F, {omega:?}F }},");
    }
    c.push_str("};\n\n#endif\n");
    let rust = format!("const STEPS: u32 = {STEPS};\nstatic STARTS: [[f32; 4]; {EPISODES}] = {starts:?};\n{text}");
    files.extend([("poles.h", c), ("poles.rs", rust)].map(|(name, text)| File { name: name.to_owned(), text }));
    Ok(files)
}

/// The names of the generated files that the firmware in C needs.
pub(crate) const C_FILES: [&str; 5] = ["cart", "pole_fast", "pole_balanced", "pole_small", "pole_constant"];

/// Compares a firmware's pushes and observations with this machine's.
pub(crate) fn compare(language: &str, image: &Path, lines: &[Line]) -> Result<(), Failure> {
    let (hash, all) = run(&graphs()?);
    compare_profiles(language, image, lines, "pole", hash, all.len() as u64)?;
    println!(
        "{language}: {} pushes of CartPole's policy in every profile, {STEPS} an episode, and what cart and pole do then: the same \
         bits as on the host",
        all.len()
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{STEPS, compare, graphs, run, starts, step};
    use crate::closed_loop::PROFILES;
    use crate::line::Line;
    use tpg_engine::{Act, Environment};
    use tpg_problems::CartPole;
    use tpg_runtime::policy::ActionId;

    #[test]
    fn the_plant_steps_as_the_problem_does() {
        let [_, plant] = graphs().expect("committed graphs");
        for mut seen in starts() {
            // So long that the pole falls over and turns around.
            for number in 0..STEPS / 5 {
                let push = (number / 7 % 2) as u16;
                let mut state = seen.map(f64::from);
                step(&plant, &[f32::from(push)], &mut seen);
                Environment::<f32>::step(&CartPole, &mut state, Act::Choice(ActionId(push)));
                // The problem computes in f64.
                let near = seen.iter().zip(state).all(|(found, expected)| (f64::from(*found) - expected).abs() < 1e-4);
                assert!(near, "{seen:?} {state:?}");
            }
        }
    }

    #[test]
    fn the_pole_stands_for_every_step() {
        let (_, all) = run(&graphs().expect("committed graphs"));
        assert_eq!(all.len(), starts().len() * STEPS as usize);
        assert!(all.iter().all(|[x, _, theta, _]| x.abs() <= 2.4 && theta.abs() <= 0.2094));
    }

    #[test]
    fn one_other_bit_is_a_failure() {
        let (hash, all) = run(&graphs().expect("committed graphs"));
        let lines = |other: u64| -> Vec<Line> {
            let line = |(_, profile): (_, &str)| {
                let hash = hash.0 ^ if profile == "constant" { other } else { 0 };
                let actions = all.len();
                Line::parse(&format!("cost pole {profile} actions={actions} instructions=1 worst=1 hash={hash:016x}"))
            };
            PROFILES.map(line).to_vec()
        };
        assert!(compare("C", "image".as_ref(), &lines(0)).is_ok());
        assert!(compare("C", "image".as_ref(), &lines(1)).is_err());
        assert!(compare("C", "image".as_ref(), &lines(0)[1..]).is_err());
    }
}
