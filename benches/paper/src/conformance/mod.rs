//! `tpg-paper conformance`: makes the folder of recorded data that tests compare with from a clone of the paper's public
//! artifact, `gegelati/ECTA24`.
//!
//! The artifact carries no licence, so neither its files nor what is made of them can be part of a repository. All files
//! are the artifact's own numbers in one form. Reference values that only other programs can make are not in the folder;
//! tests that need them are skipped.

mod actor_file;
mod artifact;

use artifact::Recording;
use clap::Args;
use flate2::Compression;
use flate2::write::GzEncoder;
use serde_json::json;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use tpg_graph::command::{CommandError, Verdict};
use tpg_graph::error::{InputError, Place};

/// Rows of every recording that are kept.
pub(crate) const ROWS: usize = 60;
/// Seeds of the actors.
const ACTORS: u32 = 3;
/// Seeds of the graphs.
const GRAPHS: u32 = 5;

/// Cells of the hybrids whose episodes are kept: separation in mm, actions before handing back; the last for random starts
/// alone.
const CELLS: [(u32, u32); 7] = [(20, 100), (1, 1), (10, 10), (3, 1000), (20, 1000), (10_000, 1000), (10, 100)];

/// The graphs whose steps the authors recorded: their name here, and their place in the artifact.
const TRACED: [(&str, &str); 6] = [
    ("fs_init7200_150gen_s0", "expeStudy2/multiTraining_3/seed_0"),
    ("fs_init7200_150gen_s1", "expeStudy2/multiTraining_3/seed_1"),
    ("fs_init7200_150gen_s2", "expeStudy2/multiTraining_3/seed_2"),
    ("fs_init180_150gen_s1", "expeStudy2/multiTraining_0/seed_1"),
    ("fs_360R180S_range0.03_s0", "expeStudy1/multiTraining_0/seed_0"),
    ("fs_5000R20S_range0.03_s0", "expeStudy1/multiTraining_14/seed_0"),
];

/// A problem, and its places in the artifact.
pub(crate) struct ArtifactProblem {
    name: &'static str,
    graphs: &'static str,
    actors: &'static str,
    /// The order of the actors' inputs.
    inputs: &'static str,
    /// Recordings of actors where an invalid action ends an episode, and where it does not.
    episodes: [(&'static str, &'static str); 2],
    /// The name of these files: some are text despite their ending.
    file: &'static str,
    hybrids: &'static str,
    cells: usize,
}

const PROBLEMS: [ArtifactProblem; 2] = [
    ArtifactProblem {
        name: "fs",
        graphs: "expeStudy2/multiTraining_6",
        actors: "multiSAC_0save",
        inputs: "target/100,diff/100,hand/100,motors",
        episodes: [("kill", "multiSAC_1"), ("nokill", "multiSAC_0")],
        file: "outputSAC.csv",
        hybrids: "multiHybride_0",
        cells: 6,
    },
    ArtifactProblem {
        name: "rs",
        graphs: "expeStudy2/multiTraining_5",
        actors: "multiSAC_2",
        inputs: "target/100,hand/100,diff/100,motors",
        episodes: [("kill", "multiSAC_3"), ("nokill", "multiSAC_2")],
        file: "outputSAC.ods",
        hybrids: "multiHybride_1",
        cells: 7,
    },
];

/// Make the folder of recorded data from a clone of the paper's artifact, gegelati/ECTA24
#[derive(Clone, Debug, Args)]
pub struct ConformanceArgs {
    /// The clone
    #[arg(value_name = "CLONE")]
    clone: PathBuf,
    /// The folder to make; tests look for it at ../shared/conformance, or where TPG_CONFORMANCE says
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
}

/// The files to write, by their path in the folder.
pub(crate) type Files = BTreeMap<String, Vec<u8>>;

impl ConformanceArgs {
    /// Runs the command.
    ///
    /// # Errors
    /// If the clone lacks a file or one is not what it should be, or the folder cannot be written. Nothing is written then.
    pub fn run(&self) -> Result<Verdict, CommandError> {
        if fs::read_dir(&self.output).is_ok_and(|mut entries| entries.next().is_some()) {
            let file = self.output.display().to_string();
            return Err(InputError::new(file, Place::Whole, "a folder with files", "a new or an empty folder").into());
        }
        let files = files(&self.clone.join("Data"))?;
        for (name, content) in &files {
            let path = self.output.join(name);
            let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
            folder
                .and_then(|()| fs::write(&path, content))
                .map_err(|error| InputError::io(&path, &error, "a folder that can be written"))?;
        }
        let bytes: usize = files.values().map(Vec::len).sum();
        println!("{}: {} files, {bytes} bytes", self.output.display(), files.len());
        Ok(Verdict::Good)
    }
}

/// Returns all files, made from the artifact's `Data`.
fn files(data: &Path) -> Result<Files, InputError> {
    let mut files = Files::new();
    for problem in &PROBLEMS {
        let targets = artifact::targets(&data.join(problem.graphs).join("params/ValidationTrajectories.txt"))?;
        files.insert(format!("targets_{}.csv", problem.name), targets.into_bytes());
        graphs(data, problem, &mut files)?;
        actors(data, problem, &mut files)?;
        hybrids(data, problem, &mut files)?;
    }
    for (name, place) in TRACED {
        let recording = Recording::read(&data.join(place).join("outputGegelati.csv"))?;
        files.insert(format!("tpg_traced/{name}.dot"), artifact::read(&data.join(place).join("out_best.dot"))?);
        files.insert(format!("tpg_traced/{name}.ends.csv"), recording.ends().into_bytes());
        files.insert(format!("tpg_traced/{name}.trace.csv.gz"), zipped(&recording.trace()?));
    }
    Ok(files)
}

fn graphs(data: &Path, problem: &ArtifactProblem, files: &mut Files) -> Result<(), InputError> {
    for seed in 0..GRAPHS {
        let (place, name) = (format!("{}/seed_{seed}", problem.graphs), format!("tpg/{}_final_s{seed}", problem.name));
        let recording = Recording::read(&data.join(&place).join("outputGegelati.csv"))?;
        let cleaned = artifact::read(&data.join(&place).join("out_best_cleaned.dot"))?;
        files.insert(format!("{name}.dot"), artifact::read(&data.join(&place).join("out_best.dot"))?);
        files.insert(format!("{name}.cleaned.dot"), cleaned);
        files.insert(format!("{name}.ends.csv"), recording.ends().into_bytes());
    }
    Ok(())
}

fn actors(data: &Path, problem: &ArtifactProblem, files: &mut Files) -> Result<(), InputError> {
    for seed in 0..ACTORS {
        let name = format!("sac/{}_s{seed}", problem.name);
        let weights =
            actor_file::weights(&data.join(format!("{}/seed_{seed}/model/best_model/actor.pt", problem.actors)))?;
        let description = json!({
            "dtype": "f32 little endian",
            "activation": "fc1->relu->ln1->fc2->relu->ln2->{mu,sigma}; LayerNorm eps 1e-5, sigma=clamp(raw,1e-6,1)",
            "state_order": problem.inputs,
        });
        files.insert(format!("{name}.json"), description.to_string().into_bytes());
        files.insert(format!("{name}.actor.f32"), weights);
        for (mode, place) in problem.episodes {
            let recording = Recording::read(&data.join(format!("{place}/seed_{seed}/{}", problem.file)))?;
            files.insert(format!("{name}.{mode}.ends.csv"), recording.ends().into_bytes());
            files.insert(format!("{name}.{mode}.trace.csv.gz"), zipped(&recording.trace()?));
        }
    }
    Ok(())
}

/// Makes the table of the hybrids' episodes: pairs of the first graphs and actors.
fn hybrids(data: &Path, problem: &ArtifactProblem, files: &mut Files) -> Result<(), InputError> {
    let mut text = format!("tpg_seed,sac_seed,sep_mm,nb_it,{}", artifact::ENDS_HEADER);
    text.push_str(",nb_tpg_actions\n");
    for graph in 0..GRAPHS {
        for actor in 0..ACTORS {
            for &(separation, actions) in &CELLS[..problem.cells] {
                let (hybrids, seed) = (problem.hybrids, GRAPHS * graph + actor);
                let place = format!("{hybrids}/seed_{seed}/nbMili_{separation}_nbIt_{actions}/outputGegelati.csv");
                for (row, run) in Recording::read(&data.join(place))?.runs.iter().take(ROWS).enumerate() {
                    let _ = writeln!(text, "{graph},{actor},{separation},{actions},{}", run.end(row));
                }
            }
        }
    }
    files.insert(format!("hybrid_{}.ends.csv.gz", problem.name), zipped(&text));
    Ok(())
}

fn zipped(text: &str) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(text.as_bytes()).expect("memory can be written");
    encoder.finish().expect("memory can be written")
}
