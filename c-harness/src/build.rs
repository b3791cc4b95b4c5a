//! Compiles the firmwares.

use crate::Failure;
use crate::programs::Program;
use crate::{dodge, problems};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tpg_codegen::emit::{self, File, Language, Options, Prefix};
use tpg_codegen::policy::{QuantisedPolicy, to_c};
use tpg_graph::files::{make_folder, read_text};
use tpg_graph::import;
use tpg_testing::library;

/// The target of both boards.
pub(crate) const TARGET: &str = "thumbv7em-none-eabihf";

/// The files beside a program's own on a board.
pub(crate) const BOARD: [&str; 3] = ["example/startup.c", "example/qemu.c", "example/report.c"];
/// The files beside a program's own on a machine with an operating system.
pub(crate) const HOST: [&str; 2] = ["firmware-c/host.c", "example/report.c"];

/// The board on which instructions are counted, as QEMU names it.
pub(crate) const COUNTED: &str = "mps2-an386";
/// A board with little memory, an STM32F405: does it fit?
pub(crate) const SMALL: &str = "netduinoplus2";

/// The folder in which everything is built.
pub(crate) fn room() -> Result<PathBuf, Failure> {
    let folder = library::target_folder().join("harness");
    make_folder(&folder)?;
    Ok(folder)
}

fn harness() -> PathBuf {
    library::top().join("c-harness")
}

/// A folder with what a board's images need: its memories as the linker wants them.
fn board_folder(board: &str) -> Result<PathBuf, Failure> {
    let folder = room()?.join(board);
    make_folder(&folder)?;
    let memories = harness().join("example/boards").join(format!("{board}.ld"));
    let memories = read(&memories)?;
    let script = folder.join("board.ld");
    write(&script, memories)?;
    Ok(folder)
}

/// Writes what is generated for the firmwares: policies, and what they run.
pub(crate) fn generated_c() -> Result<PathBuf, Failure> {
    let folder = room()?.join("generated");
    make_folder(&folder)?;
    let mut files = vec![problems::file()?];
    files.extend(dodge::files()?);
    for start in problems::STARTS.map(problems::name) {
        files.extend(graph_in_c(&format!("generated/widowx-{start}/graph.json"))?);
    }
    let network = load_network("generated/widowx-sac/policy.q.json")?;
    files.extend(to_c(&network, &Prefix::of_file(Path::new("widowx_sac")))?);
    for File { name, text } in files {
        let path = folder.join(name);
        write(&path, text)?;
    }
    Ok(folder)
}

/// Reads a file.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    fs::read(path).map_err(|error| Failure::at(path, error))
}

/// Writes a file.
pub(crate) fn write(path: &Path, content: impl AsRef<[u8]>) -> Result<(), Failure> {
    fs::write(path, content).map_err(|error| Failure::at(path, error))
}

/// A committed graph in C, by the name of its folder.
pub(crate) fn graph_in_c(path: &str) -> Result<Vec<File>, Failure> {
    let path = library::top().join(path);
    Ok(emit::emit(&import::load(&path, None, None)?, Language::C, &Options::new(Prefix::of_file(&path))))
}

/// Reads a committed network in integers.
fn load_network(path: &str) -> Result<QuantisedPolicy, Failure> {
    let path = library::top().join(path);
    let text = read_text(&path, "a network in integers")?;
    Ok(QuantisedPolicy::from_json(&path.display().to_string(), &text)?)
}

/// The programs' sources, the folders of their headers, and the library.
fn add_sources(gcc: &mut Command, program: &Program, platform: &[&str], archive: &Path) -> Result<(), Failure> {
    let generated = generated_c()?;
    for folder in
        [harness().join("example"), harness().join("firmware-c"), generated.clone(), library::dist().join("include")]
    {
        gcc.arg(format!("-I{}", folder.display()));
    }
    gcc.arg(harness().join(program.main)).args(platform.iter().map(|name| harness().join(name)));
    gcc.args(program.generated.iter().map(|name| generated.join(format!("{name}.c")))).arg(archive);
    Ok(())
}

/// A program for this machine; `None` where a tool is missing.
pub(crate) fn host(program: &Program) -> Result<Option<PathBuf>, Failure> {
    if !tpg_testing::tool("gcc", "gcc", &format!("the {} program in C on this machine", program.name)) {
        return Ok(None);
    }
    let Some(archive) = library::make(library::host(), &library::dist())? else { return Ok(None) };
    let image = room()?.join(format!("{}-host", program.name));
    let mut gcc = Command::new("gcc");
    gcc.args(["-std=c99", "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-o"]).arg(&image);
    add_sources(&mut gcc, program, &HOST, &archive)?;
    library::output(&mut gcc)?;
    Ok(Some(image))
}

/// A program for a board; `None` where a tool is missing.
pub(crate) fn board(program: &Program, board: &str) -> Result<Option<PathBuf>, Failure> {
    if !tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", "the firmware") {
        return Ok(None);
    }
    let Some(archive) = library::make(TARGET, &library::dist())? else { return Ok(None) };
    let board_folder = board_folder(board)?;
    let image = board_folder.join(format!("{}-c.elf", program.name));
    let mut gcc = Command::new("arm-none-eabi-gcc");
    gcc.current_dir(&board_folder).args(tpg_codegen::size::Target::M4f.flags());
    gcc.args(["-std=gnu11", "-O2", "-ffp-contract=off", "-ffunction-sections", "-fdata-sections", "-fstack-usage"]);
    gcc.args(["-Wall", "-Wextra", "-Werror", "-nostdlib", "-nostartfiles"]);
    add_sources(&mut gcc, program, &BOARD, &archive)?;
    gcc.arg(format!("-L{}", board_folder.display())).arg("-T").arg(harness().join("example/sections.ld"));
    gcc.arg(format!("-Wl,--defsym=_stack_size={}", program.stack));
    gcc.args(["-Wl,--gc-sections", "-Wl,--no-warn-rwx-segments", "-Wl,-z,noexecstack", "-lc", "-lgcc", "-o"]);
    library::output(gcc.arg(&image))?;
    Ok(Some(image))
}

/// A program's version, its last word of the first line.
pub(crate) fn version(program: &str) -> String {
    let output = Command::new(program).arg("--version").current_dir(library::top()).output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned()).unwrap_or_default();
    text.lines().next().unwrap_or_default().to_owned()
}

/// The committed figures of a file beside this crate.
pub(crate) fn committed<T: DeserializeOwned>(name: &str) -> Result<T, Failure> {
    Ok(toml::from_str(&read_text(&harness().join(name), "committed figures")?)?)
}

/// Replaces a file beside this crate by figures, with a comment in front of them.
pub(crate) fn commit(name: &str, comment: &str, figures: &impl Serialize) -> Result<(), Failure> {
    write(&harness().join(name), format!("# {comment}\n\n{}", toml::to_string(figures)?))
}
