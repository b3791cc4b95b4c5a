//! The control step among balls: the first test scenes with the shipped graph, run here and written down for the firmwares,
//! which must come to the same motor positions.
//!
//! A firmware has no model of how balls fly: it gets where they were seen, step by step.

use crate::Failure;
use crate::line::Line;
use crate::record::Hash;
use std::fmt::Write as _;
use std::path::Path;
use tpg_arm::Pose;
use tpg_arm::dodge::{BALLS, Behaviour, Chooser, Control, GOALS, Source};
use tpg_arm::kinematics::Vector;
use tpg_arm::sensors::Watch;
use tpg_codegen::emit::{self, File, Language, Options};
use tpg_generated::dodge::Dodge;
use tpg_graph::Graph;
use tpg_problems::dodge::Config;
use tpg_problems::dodge::episode::{End, Episode};
use tpg_problems::dodge::file::read_csv;
use tpg_problems::dodge::scene::Scene;
use tpg_testing::library;

/// Scenes that are run.
const SCENES: usize = 100;

/// A scene as it went here.
struct Course {
    scene: Scene,
    end: End,
    steps: u32,
    /// The places where each ball was seen: before the first step, and in every step.
    centres: Vec<Vector<f32>>,
}

/// Runs the scenes here: each, and a hash of every pose.
fn run() -> Result<(Vec<Course>, Hash), Failure> {
    let config = Config::default();
    let (body, settings) = (config.body(), config.settings());
    let behaviours = Behaviour::ALL.map(|(behaviour, _)| behaviour);
    let chooser = Chooser { policy: Dodge, sources: &Source::ALL, behaviours: &behaviours };
    let choose = |values: &_| chooser.choose(values);
    let mut poses = Hash::new();
    let course = |scene: Scene| {
        let goals: Vec<Pose> = scene.goals.iter().copied().map(Pose).collect();
        let mut episode = Episode::new(&body, &scene);
        let mut centres: Vec<Vector<f32>> = scene.balls.iter().map(|path| path.at(-1.0)).collect();
        let begun = Control::new(&body, settings, Watch::DEFAULT, &goals, episode.pose(), episode.view(&body).balls);
        let mut control = begun.map_err(Failure::new)?;
        let end = loop {
            let view = episode.view(&body);
            centres.extend(view.balls.iter().map(|ball| ball.at));
            let step = control.step(&body, &choose, view.pose, view.balls).map_err(Failure::new)?;
            let end = episode.step(&body, step.wanted, config.tolerance);
            poses.add_pose(episode.pose());
            if let Some(end) = end {
                break end;
            }
        };
        Ok(Course { end, steps: episode.steps(), centres, scene })
    };
    let path = library::top().join("generated/test-targets/dodge.csv");
    let scenes = read_csv(&path).map_err(Failure::new)?.into_iter().take(SCENES).map(|certified| certified.scene);
    let courses = scenes.map(course).collect::<Result<Vec<Course>, Failure>>()?;
    Ok((courses, poses))
}

/// The shipped graph in C, and the scenes in both languages.
pub(crate) fn files() -> Result<Vec<File>, Failure> {
    let path = library::top().join("generated/dodge/graph.json");
    let text = std::fs::read_to_string(&path).map_err(|error| Failure::at(&path, error))?;
    let graph = Graph::from_json(&path.display().to_string(), &text).map_err(Failure::new)?;
    let mut files = emit::emit(&graph, Language::C, &Options::new("dodge".parse().map_err(Failure::new::<String>)?));
    let (courses, _) = run()?;
    let count: usize = courses.iter().map(|course| course.centres.len()).sum();
    // Apart from their declarations: linters read the header with the program, and take many minutes over so many numbers.
    let header = format!(
        "#ifndef BALLS_H\n#define BALLS_H\n\n#include \"tpg_runtime.h\"\n\n#define SCENES {}U\n\n\
         typedef struct scene {{\n    tpg_pose_t start;\n    tpg_pose_t goals[TPG_GOALS];\n    uint32_t goal_count;\n    \
         float radii[TPG_BALLS];\n    uint32_t balls;\n    /* Of the first ball before the first step, in centres. */\n    \
         uint32_t first;\n    uint32_t steps;\n}} scene_t;\n\nextern const float centres[{count}][3];\n\
         extern const scene_t scenes[SCENES];\n\n#endif\n",
        courses.len()
    );
    let mut c = format!("#include \"balls.h\"\n\nconst float centres[{count}][3] = {{\n");
    let mut rust = format!("static CENTRES: [[f32; 3]; {count}] = [\n");
    for [x, y, z] in courses.iter().flat_map(|course| &course.centres) {
        let _ = writeln!(c, "    {{ {x:?}F, {y:?}F, {z:?}F }},");
        let _ = writeln!(rust, "[{x:?}, {y:?}, {z:?}],");
    }
    let _ = write!(c, "}};\n\nconst scene_t scenes[SCENES] = {{\n");
    let _ = write!(
        rust,
        "];\nstruct Scene {{\n    start: [i16; 4],\n    goals: &'static [[i16; 4]],\n    radii: &'static [f32],\n    \
         first: usize,\n    steps: usize,\n}}\nstatic SCENES: [Scene; {}] = [\n",
        courses.len()
    );
    let mut first = 0;
    for Course { scene, steps, centres, .. } in &courses {
        let Scene { start, goals, balls, .. } = scene;
        let radii: Vec<f32> = balls.iter().map(|ball| ball.radius).collect();
        let pose = |ticks: &[i16; 4]| format!("{{ {{ {}, {}, {}, {} }} }}", ticks[0], ticks[1], ticks[2], ticks[3]);
        let all: Vec<String> = (0..GOALS).map(|place| pose(goals.get(place).unwrap_or(&[0; 4]))).collect();
        let widths: Vec<String> = (0..BALLS).map(|place| format!("{:?}F", radii.get(place).unwrap_or(&0.0))).collect();
        let _ = writeln!(
            c,
            "    {{ {}, {{ {} }}, {}U, {{ {} }}, {}U, {first}U, {steps}U }},",
            pose(start),
            all.join(", "),
            goals.len(),
            widths.join(", "),
            balls.len()
        );
        let _ = writeln!(
            rust,
            "    Scene {{ start: {start:?}, goals: &{goals:?}, radii: &{radii:?}, first: {first}, steps: {steps} }},"
        );
        first += centres.len();
    }
    c.push_str("};\n");
    rust.push_str("];\n");
    files.extend(
        [("balls.h", header), ("balls.c", c), ("balls.rs", rust)]
            .map(|(name, text)| File { name: name.to_owned(), text }),
    );
    Ok(files)
}

/// Compares a firmware's motor positions with this machine's.
pub(crate) fn compare(language: &str, image: &Path, lines: &[Line]) -> Result<(), Failure> {
    let (courses, poses) = run()?;
    let steps: u64 = courses.iter().map(|course| u64::from(course.steps)).sum();
    let line = lines.iter().find(|line| line.words == ["cost", "dodge", "scenes"]);
    let line = line.ok_or_else(|| Failure::at(image, "no scenes among balls"))?;
    if line.values.get("poses") != Some(&format!("{:016x}", poses.0)) || line.number("actions") != steps {
        return Err(Failure::new(format!("{language}: other motor positions among balls than here: {line:?}")));
    }
    let reached = courses.iter().filter(|course| course.end == End::Reached).count();
    println!(
        "{language}: {} scenes among balls, {reached} targets reached, {steps} steps: every position as on the host",
        courses.len()
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{compare, run};
    use crate::line::Line;

    #[test]
    fn one_other_bit_is_a_failure() {
        let (courses, poses) = run().expect("committed scenes");
        let steps: u32 = courses.iter().map(|course| course.steps).sum();
        let checked = |steps: u32, hash: u64| {
            let text = format!("cost dodge scenes actions={steps} instructions=1 worst=1 poses={hash:016x}");
            compare("C", "image".as_ref(), &[Line::parse(&text)])
        };
        assert!(checked(steps, poses.0).is_ok());
        assert!(checked(steps, poses.0 ^ 1).is_err());
        assert!(checked(steps - 1, poses.0).is_err());
        assert!(compare("C", "image".as_ref(), &[]).is_err());
    }
}
