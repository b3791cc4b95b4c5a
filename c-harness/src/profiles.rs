//! Flash and instructions of every profile of any graphs with actions on a Cortex-M4F, in C at `-Os`, beside those of `small`.
//!
//! Instructions are counted under QEMU on states drawn uniformly in the declared ranges, calls of libm and of doubles in software included;
//! flash is without them.

use crate::Failure;
use crate::build::{self, Board, CORE, there};
use crate::closed_loop::PROFILES;
use crate::emulate;
use crate::line::Line;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tpg_codegen::compile;
use tpg_codegen::emit::{Code, Language, Options};
use tpg_codegen::size::{Target, build_c, measure};
use tpg_graph::{Graph, ScalarType, import, states};
use tpg_testing::library;

/// States of each policy.
const STATES: usize = 64;

/// The profile that the others are beside.
const SMALL: usize = 2;

/// Bytes of flash, and instructions a decision in the mean.
type Cost = [f64; 2];

/// Prints a table of some graphs, and the geometric means of what each profile takes beside `small`.
pub(crate) fn table(graphs: &[PathBuf], profile_of: Option<import::Profile>) -> Result<(), Failure> {
    if !tpg_testing::tool("qemu-system-arm", "qemu-system-arm", "profiles under QEMU") {
        return Ok(());
    }
    println!("{:<34} {:>12} {:>16} {:>12}", "", "bytes", "instructions", "");
    let mut all = Vec::new();
    for path in graphs {
        let graph = import::load(path, profile_of, None).map_err(Failure::new)?;
        if !graph.outputs().is_empty() {
            return Err(Failure::at(path, "a policy with outputs; accepted: policies with actions"));
        }
        let Some(costs) = costs(&graph)? else { return Ok(()) };
        println!("{}", path.file_name().unwrap_or_default().to_string_lossy());
        for ((_, name), [flash, instructions]) in PROFILES.iter().zip(costs) {
            println!("{name:>34} {flash:>12} {instructions:>16.0}");
        }
        all.push(costs);
    }
    println!("\ntimes small: geometric mean (least to most)");
    for (place, (_, name)) in PROFILES.iter().enumerate().filter(|&(place, _)| place != SMALL) {
        let ratios =
            [0, 1].map(|what| all.iter().map(|costs| costs[place][what] / costs[SMALL][what]).collect::<Vec<_>>());
        let [flash, instructions] = ratios.map(|ratios| {
            let mean = (ratios.iter().map(|ratio| ratio.ln()).sum::<f64>() / ratios.len() as f64).exp();
            let [least, most] = [f64::min, f64::max].map(|of| ratios.iter().copied().reduce(of).unwrap_or(mean));
            format!("{mean:.2} ({least:.2} to {most:.2})")
        });
        println!("{name}: {flash} of its flash, {instructions} of its instructions");
    }
    Ok(())
}

/// Measures each profile; `None` if a tool is missing.
fn costs(graph: &Graph) -> Result<Option<[Cost; PROFILES.len()]>, Failure> {
    let folder = build::room()?.join("profiles");
    fs::create_dir_all(&folder).map_err(|error| Failure::at(&folder, error))?;
    let write = |name: &str, text: &str| {
        let path = folder.join(name);
        fs::write(&path, text).map_err(|error| Failure::at(&path, error))
    };
    let mut costs = [[0.0; 2]; PROFILES.len()];
    for ((profile, name), cost) in PROFILES.into_iter().zip(&mut costs) {
        let prefix = format!("p_{name}").parse().map_err(Failure::new::<String>)?;
        let code = Code::of(compile(graph, &Options { profile: Some(profile), ..Options::new(prefix) }, Language::C));
        code.files.iter().try_for_each(|file| write(&file.name, &file.text))?;
        let built = build_c(&code, Target::CortexM4).map_err(Failure::new)?;
        cost[0] = measure(&built.object).map_err(Failure::new)?.flash() as f64;
    }
    write("under_test.h", &under_test(graph))?;
    let Some(image) = image(&folder)? else { return Ok(None) };
    let lines = emulate::run(Board::Mps2An386, &image)?;
    for ((_, name), cost) in PROFILES.iter().zip(&mut costs) {
        let line = lines.iter().find(|line: &&Line| line.words == ["cost", name]);
        let line = line.ok_or_else(|| Failure::at(&image, format!("no line of {name}")))?;
        cost[1] = line.number("instructions") as f64 / line.number("actions") as f64;
    }
    Ok(Some(costs))
}

/// The states, and the names of the profiles.
fn under_test(graph: &Graph) -> String {
    let (scalar, suffix) = if graph.scalar() == ScalarType::F32 { ("float", "F") } else { ("double", "") };
    let mut text = String::from("#ifndef UNDER_TEST_H\n#define UNDER_TEST_H\n\n");
    for (_, name) in PROFILES {
        let _ = writeln!(text, "#include \"p_{name}.h\"");
    }
    let length = graph.state_length();
    let _ = writeln!(text, "\n#define STATES {STATES}U\n\nstatic const {scalar} states[STATES][{length}] = {{");
    for state in states::sample_in_range(graph, STATES, 1).chunks_exact(length) {
        let values: Vec<String> = state.iter().map(|value| format!("{value:?}{suffix}")).collect();
        let _ = writeln!(text, "    {{ {} }},", values.join(", "));
    }
    text.push_str("};\n\n#endif\n");
    text
}

/// Compiles the program with every profile; `None` where a tool is missing.
fn image(folder: &Path) -> Result<Option<PathBuf>, Failure> {
    if !tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", "profiles under QEMU") {
        return Ok(None);
    }
    let harness = library::top().join("c-harness");
    let image = folder.join("profiles.elf");
    let mut gcc = Command::new("arm-none-eabi-gcc");
    gcc.args(CORE).args(["-std=gnu11", "-Os", "-ffunction-sections", "-fdata-sections", "-nostdlib", "-nostartfiles"]);
    gcc.arg(format!("-I{}", harness.join("example").display())).arg(format!("-I{}", folder.display()));
    gcc.arg(harness.join("firmware-c/profiles.c"));
    gcc.args(["startup.c", "qemu.c", "report.c"].map(|name| harness.join("example").join(name)));
    gcc.args(PROFILES.map(|(_, name)| folder.join(format!("p_{name}.c"))));
    gcc.arg(format!("-L{}", build::board_folder(Board::Mps2An386)?.display()));
    gcc.arg("-T").arg(harness.join("example/sections.ld"));
    gcc.args(["-Wl,--gc-sections", "-Wl,--no-warn-rwx-segments", "-lm", "-lc", "-lgcc", "-o"]).arg(&image);
    there(library::output(&mut gcc)).map(|output| output.map(|_| image))
}
