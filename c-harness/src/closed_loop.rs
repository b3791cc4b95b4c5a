//! Policies and plants that are graphs, in closed loop: their generated code, and their steps here.

use crate::Failure;
use crate::line::Line;
use crate::record::Hash;
use std::fmt::Write as _;
use std::path::Path;
use tpg_codegen::emit::{self, File, Language, Options, Prefix, Profile};
use tpg_graph::interpret::{Answer, Interpreter};
use tpg_graph::{Graph, import};
use tpg_runtime::ops::Own;
use tpg_testing::library;

/// The profiles, as prefixes and reports name them.
pub(crate) const PROFILES: [(Profile, &str); 4] = [
    (Profile::Fast, "fast"),
    (Profile::Balanced, "balanced"),
    (Profile::Small, "small"),
    (Profile::ConstantTime, "constant"),
];

/// A committed graph.
pub(crate) fn load(path: &str) -> Result<Graph, Failure> {
    import::load(&library::top().join(path), None, None).map_err(Failure::new)
}

/// A step of a graph in `f32` with own maths; it replaces the graph's memory.
pub(crate) fn step(graph: &Graph, seen: &[f32], memory: &mut [f32]) -> Vec<f32> {
    let state = [seen, &*memory].concat();
    let mut answer: Vec<f32> = match Interpreter::<f32, Own>::new(graph).answer(&state) {
        Answer::Values(values) => values.into_iter().map(|value| value as f32).collect(),
        Answer::Action(_) => Vec::new(),
    };
    let next = answer.split_off(answer.len() - memory.len());
    memory.copy_from_slice(&next);
    answer
}

/// Generated code in both languages, and the Rust modules that it makes up.
#[derive(Default)]
pub(crate) struct Modules {
    pub(crate) files: Vec<File>,
    pub(crate) text: String,
}

impl Modules {
    /// Adds a graph; its files will be in `folder`.
    pub(crate) fn add(&mut self, folder: &Path, graph: &Graph, name: &str, profile: Profile) -> Result<(), Failure> {
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

/// Compares the lines of a policy in every profile with the hash and the number of actions of this machine's run.
pub(crate) fn compare_profiles(
    language: &str,
    image: &Path,
    lines: &[Line],
    name: &str,
    hash: Hash,
    actions: u64,
) -> Result<(), Failure> {
    for (_, profile) in PROFILES {
        let line = lines.iter().find(|line| line.words == ["cost", name, profile]);
        let line = line.ok_or_else(|| Failure::at(image, format!("no line of {name} {profile}")))?;
        if line.values.get("hash") != Some(&format!("{:016x}", hash.0)) || line.number("actions") != actions {
            let found = format!("{language}: {name} {profile}: other actions or observations than here: {line:?}");
            return Err(Failure::new(found));
        }
    }
    Ok(())
}
