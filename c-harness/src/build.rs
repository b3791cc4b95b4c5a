//! Compiles the firmwares.

use crate::Failure;
use crate::{cartpole, closed_loop, continuous, dodge, models, network, problems, size, table};
use std::env;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tpg_codegen::emit::{self, File, Language, Options, Prefix};
use tpg_codegen::policy::{QuantisedPolicy, to_c};
use tpg_graph::Graph;
use tpg_testing::library::{self, Missing};

/// The target of both boards.
pub(crate) const TARGET: &str = "thumbv7em-none-eabihf";

/// Options that tell gcc which core it is.
pub(crate) const CORE: [&str; 4] = ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"];

/// A board, as QEMU names it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Board {
    /// The board on which instructions are counted.
    Mps2An386,
    /// An STM32F405: does it fit?
    NetduinoPlus2,
}

impl Board {
    /// QEMU's name.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Mps2An386 => "mps2-an386",
            Self::NetduinoPlus2 => "netduinoplus2",
        }
    }
}

/// The folder in which everything is built.
pub(crate) fn room() -> Result<PathBuf, Failure> {
    let folder = library::target_folder().join("harness");
    fs::create_dir_all(&folder).map_err(|error| Failure::at(&folder, error))?;
    Ok(folder)
}

fn harness() -> PathBuf {
    library::top().join("c-harness")
}

/// A folder with what a board's images need: its memories as the linkers want them.
pub(crate) fn board_folder(board: Board) -> Result<PathBuf, Failure> {
    let folder = room()?.join(board.name());
    fs::create_dir_all(&folder).map_err(|error| Failure::at(&folder, error))?;
    let memories = harness().join("example/boards").join(format!("{}.ld", board.name()));
    for name in ["board.ld", "memory.x"] {
        let to = folder.join(name);
        // Unchanged, cargo need not link again.
        let (old, new) = (fs::read(&to).ok(), fs::read(&memories).map_err(|error| Failure::at(&memories, error))?);
        if old.as_ref() != Some(&new) {
            fs::write(&to, new).map_err(|error| Failure::at(&to, error))?;
        }
    }
    Ok(folder)
}

/// The policies in C: as committed, the network, and every profile under a name of its own.
pub(crate) fn generated_c() -> Result<PathBuf, Failure> {
    let folder = room()?.join("generated");
    fs::create_dir_all(&folder).map_err(|error| Failure::at(&folder, error))?;
    let mut files = Vec::from(problems::files()?);
    files.push(models::file()?);
    files.push(table::file());
    files.extend(network::files()?);
    files.extend(continuous::files(&folder)?);
    files.extend(cartpole::files(&folder)?);
    files.extend(dodge::files()?);
    let mut modules = String::new();
    for start in problems::STARTS.map(problems::name) {
        let path = library::top().join(format!("generated/widowx-{start}/graph.json"));
        let text = fs::read_to_string(&path).map_err(|error| Failure::at(&path, error))?;
        let graph = Graph::from_json(&path.display().to_string(), &text).map_err(Failure::new)?;
        let prefix = |name: String| name.parse::<Prefix>().map_err(Failure::new);
        files.extend(emit::emit(&graph, Language::C, &Options::new(prefix(format!("widowx_{start}"))?)));
        for (profile, short) in closed_loop::PROFILES {
            for (language, tag) in [(Language::C, "c"), (Language::Rust, "rust")] {
                let name = prefix(format!("{start}_{short}_{tag}"))?;
                if language == Language::Rust {
                    let path = folder.join(format!("{name}.rs"));
                    let _ = writeln!(modules, "#[path = {:?}]\nmod {name};", path.display().to_string());
                }
                files.extend(emit::emit(&graph, language, &Options { profile: Some(profile), ..Options::new(name) }));
            }
        }
    }
    let path = library::top().join("generated/widowx-sac/policy.q.json");
    let text = fs::read_to_string(&path).map_err(|error| Failure::at(&path, error))?;
    let policy = QuantisedPolicy::from_json(&path.display().to_string(), &text).map_err(Failure::new)?;
    files.extend(to_c(&policy, &"widowx_sac".parse().map_err(Failure::new::<String>)?, false).map_err(Failure::new)?);
    files.push(File { name: "profiles.rs".to_owned(), text: modules });
    for file in files {
        let path = folder.join(&file.name);
        // Unchanged, cargo need not compile again.
        if fs::read_to_string(&path).ok().as_ref() != Some(&file.text) {
            fs::write(&path, &file.text).map_err(|error| Failure::at(&path, error))?;
        }
    }
    Ok(folder)
}

/// `None` where a tool is missing, which has been said.
pub(crate) fn there<T>(result: Result<T, Missing>) -> Result<Option<T>, Failure> {
    match result {
        Ok(value) => Ok(Some(value)),
        Err(Missing::Tool) => Ok(None),
        Err(Missing::Failed(message)) => Err(Failure::new(message)),
    }
}

/// A firmware's program in C, for this machine; `None` where a tool is missing.
pub(crate) fn host(program: &str) -> Result<Option<PathBuf>, Failure> {
    if !tpg_testing::tool("gcc", "gcc", &format!("the {program} program in C on this machine")) {
        return Ok(None);
    }
    let Some(archive) = there(library::make(library::host(), &library::dist()))? else { return Ok(None) };
    let generated = generated_c()?;
    let image = room()?.join(format!("{program}-host"));
    let mut gcc = Command::new("gcc");
    gcc.args(["-std=c99", "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]);
    gcc.arg(format!("-I{}", harness().join("example").display())).arg(format!("-I{}", generated.display()));
    gcc.arg(format!("-I{}", library::dist().join("include").display()));
    gcc.arg(harness().join(format!("firmware-c/{program}.c")));
    gcc.args(["firmware-c/host.c", "example/report.c"].map(|name| harness().join(name)));
    gcc.args(["widowx_fs.c", "widowx_rs.c", "widowx_sac.c"].map(|name| generated.join(name)));
    there(library::output(gcc.arg(archive).arg("-o").arg(&image)))?;
    Ok(Some(image))
}

/// The C firmware `program` for a board; `None` where a tool is missing.
pub(crate) fn c(program: &str, board: Board) -> Result<Option<PathBuf>, Failure> {
    let names: &[&str] = match program {
        "costs" => &[
            "fs_fast_c",
            "fs_balanced_c",
            "fs_small_c",
            "fs_constant_c",
            "rs_fast_c",
            "rs_balanced_c",
            "rs_small_c",
            "rs_constant_c",
        ],
        "network" => &["pendulum"],
        "continuous" => &continuous::C_FILES,
        "cartpole" => &cartpole::C_FILES,
        "dodge" => &["dodge", "balls"],
        _ => &["widowx_fs", "widowx_rs", "widowx_sac"],
    };
    gcc(program, &harness().join(format!("firmware-c/{program}.c")), names, board)
}

/// The control loop that a user copies, for a board; `None` where a tool is missing.
pub(crate) fn example(board: Board) -> Result<Option<PathBuf>, Failure> {
    gcc("example", &harness().join("example/main.c"), &["widowx_fs", "widowx_sac"], board)
}

/// Compiles `main` with generated C for a board.
fn gcc(program: &str, main: &Path, names: &[&str], board: Board) -> Result<Option<PathBuf>, Failure> {
    if !tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", "the firmware in C") {
        return Ok(None);
    }
    let Some(archive) = there(library::make(TARGET, &library::dist()))? else { return Ok(None) };
    let (generated, board_folder) = (generated_c()?, board_folder(board)?);
    let source = harness().join("example");
    let image = board_folder.join(format!("{program}-c.elf"));
    let mut sources: Vec<PathBuf> = ["startup.c", "qemu.c", "report.c"].map(|name| source.join(name)).into();
    sources.push(main.to_owned());
    sources.extend(names.iter().map(|name| generated.join(format!("{name}.c"))));
    let mut gcc = Command::new("arm-none-eabi-gcc");
    gcc.args(CORE).args(["-std=gnu11", "-O2", "-ffp-contract=off", "-ffunction-sections"]);
    // Tables of addresses, unlike the Thumb instruction's own tables, are not read by `cortex_bound`.
    gcc.arg("-fno-jump-tables");
    gcc.args(["-fdata-sections", "-fstack-usage", "-Wall", "-Wextra", "-Werror", "-nostdlib", "-nostartfiles"]);
    gcc.arg(format!("-I{}", source.display())).arg(format!("-I{}", generated.display()));
    gcc.arg(format!("-I{}", library::dist().join("include").display()));
    gcc.args(&sources).arg(archive);
    gcc.arg(format!("-L{}", board_folder.display())).arg("-T").arg(source.join("sections.ld"));
    gcc.args(size::own_stack(program).map(|bytes| format!("-Wl,--defsym=_stack_size={bytes}")));
    gcc.args(["-Wl,--gc-sections", "-Wl,--no-warn-rwx-segments", "-Wl,-z,noexecstack", "-lc", "-lgcc", "-o"])
        .arg(&image);
    gcc.current_dir(&board_folder);
    there(library::output(&mut gcc))?;
    Ok(Some(image))
}

/// The Rust firmware `program` for a board; `None` where a target is missing.
pub(crate) fn rust(program: &str, board: Board) -> Result<Option<PathBuf>, Failure> {
    if !library::rust_target(TARGET, "the firmware in Rust") {
        return Ok(None);
    }
    let (generated, board_folder) = (generated_c()?, board_folder(board)?);
    let made = library::target_folder().join("firmware-rust").join(board.name());
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.current_dir(harness().join("firmware-rust")).args(["build", "--quiet", "--release", "--locked"]);
    cargo.args(["--target", TARGET, "--bin", program]);
    cargo.env("TPG_BOARD", &board_folder).env("TPG_PROBLEMS", generated.join("problems.rs"));
    cargo.env("TPG_GENERATED", &generated).env("CARGO_TARGET_DIR", &made).env_remove("CARGO_ENCODED_RUSTFLAGS");
    if there(library::output(&mut cargo))?.is_none() {
        return Ok(None);
    }
    Ok(Some(made.join(TARGET).join("release").join(program)))
}

/// A program's version, its last word of the first line.
pub(crate) fn version(program: &str) -> String {
    let output = Command::new(program).arg("--version").current_dir(library::top()).output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned()).unwrap_or_default();
    text.lines().next().unwrap_or_default().to_owned()
}

/// Text of a file beside this crate.
pub(crate) fn committed(name: &str) -> Result<String, Failure> {
    let path: &Path = &harness().join(name);
    fs::read_to_string(path).map_err(|error| Failure::at(path, error))
}

/// Replaces a file beside this crate.
pub(crate) fn commit(name: &str, text: &str) -> Result<(), Failure> {
    let path: &Path = &harness().join(name);
    fs::write(path, text).map_err(|error| Failure::at(path, error))
}
