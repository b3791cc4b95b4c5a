//! `tpg-codegen report` as a program.

use assert_cmd::Command;
use serde_json::Value;
use std::fs;
use tempfile::TempDir;
use tpg_codegen::emit::{Code, Language};
use tpg_codegen::size::{Target, build_c};
use tpg_codegen::{Options, compile};
use tpg_graph::Graph;
use tpg_graph::error::counted;

fn folder() -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("arm.json"), include_str!("fixtures/all_instructions.json")).expect("written");
    folder
}

fn report(folder: &TempDir, args: &[&str], code: i32) -> String {
    let mut tool = Command::cargo_bin("tpg-codegen").expect("the program is built");
    let output =
        tool.current_dir(folder).args(["report", "arm.json"]).args(args).assert().code(code).get_output().clone();
    String::from_utf8(output.stdout).expect("text")
}

fn json(folder: &TempDir, args: &[&str]) -> Value {
    serde_json::from_str(&report(folder, &[args, &["--json"]].concat(), 0)).expect("one JSON object")
}

#[test]
fn sizes_come_from_the_compiler() {
    let folder = folder();
    let host = json(&folder, &["--target", "host"]);
    let sizes = host["sizes"].as_array().expect("sizes");
    let profiles: Vec<&str> = sizes.iter().filter_map(|size| size["profile"].as_str()).collect();
    assert_eq!(profiles, ["fast", "balanced", "small", "constant-time", "gegelati"]);
    for size in sizes {
        assert_eq!(size["target"], "host");
        assert!(size["flash"].as_u64().is_some_and(|flash| flash > 300), "{size}");
        assert_eq!(size["ram"], 0, "{size}");
    }
    if tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", "the report's sizes on a Cortex-M4F") {
        for size in json(&folder, &["--target", "m4f"])["sizes"].as_array().expect("sizes") {
            assert!(size["flash"].as_u64().is_some_and(|flash| flash > 300), "{size}");
        }
    }
}

#[test]
fn the_rust_has_a_size_on_a_cortex_m4() {
    if !tpg_testing::library::rust_target("thumbv7em-none-eabihf", "the size of Rust on a Cortex-M4F") {
        return;
    }
    let folder = folder();
    let report = json(&folder, &["--target", "m4f"]);
    let sizes = report["rust_sizes"].as_array().expect("sizes");
    let profiles: Vec<&str> = sizes.iter().filter_map(|size| size["profile"].as_str()).collect();
    assert_eq!(profiles, ["fast", "balanced", "small", "constant-time"]);
    for size in sizes {
        assert!(size["flash"].as_u64().is_some_and(|flash| (300..20_000).contains(&flash)), "{size}");
    }
    assert_eq!(json(&folder, &["--target", "host"])["rust_sizes"], Value::Array(Vec::new()));
}

/// The counts by hand are in `cost`.
#[test]
fn costs_are_those_of_the_header() {
    let folder = folder();
    let report = json(&folder, &["--target", "host"]);
    for cost in report["costs"].as_array().expect("costs") {
        let mut tool = Command::cargo_bin("tpg-codegen").expect("the program is built");
        let shape = match cost["profile"].as_str().expect("a name") {
            "gegelati" => ["--style", "gegelati"],
            profile => ["--profile", profile],
        };
        let output = tool.current_dir(&folder).args(["arm.json", "--lang", "c", "-o", "-"]).args(shape);
        let text = String::from_utf8(output.assert().success().get_output().stdout.clone()).expect("text");
        let [bids, operations, maths] =
            ["bids", "operations", "maths_calls"].map(|key| cost["worst"][key].as_u64().expect("a number") as usize);
        let most =
            format!("at most {} and {}, {maths} of them", counted(bids, "bid"), counted(operations, "operation"));
        assert!(text.contains(&most), "{most}");
    }
}

#[test]
fn for_people() {
    let text = report(&folder(), &["--target", "host"], 0);
    // Sizes are the compiler's; everything before them is this tool's.
    let (ours, sizes) = text.split_once("\nbytes on ").expect("two parts");
    insta::assert_snapshot!(ours);
    assert!(sizes.starts_with("this machine, compiled with -Os"), "{sizes}");
}

#[test]
fn another_scalar_type_is_said() {
    let folder = folder();
    let report = json(&folder, &["--target", "host", "--scalar", "f32"]);
    assert_eq!((&report["scalar"], &report["maths"]), (&Value::from("f32"), &Value::from("own")));
    assert_eq!(report["conversion"]["from"], "f64");
    assert_eq!(report["conversion"]["agreement"]["states"], 20_000);
    assert_ne!(report["conversion"]["agreement"]["equal"], 0);
}

#[test]
fn a_limit_is_a_verdict() {
    let folder = folder();
    assert!(report(&folder, &["--target", "host", "--max-flash", "10"], 1).contains("bytes on this machine"));
    report(&folder, &["--target", "host", "--max-flash", "1000000", "--profile", "small"], 0);
}

/// The path of a shipped policy.
fn shipped(name: &str) -> String {
    format!("{}/../generated/{name}/graph.json", env!("CARGO_MANIFEST_DIR"))
}

/// The report of a shipped policy on some targets, its sizes.
fn sizes_of(name: &str, targets: &str) -> Vec<Value> {
    let mut tool = Command::cargo_bin("tpg-codegen").expect("the program is built");
    let tool = tool.args(["report", &shipped(name), "--json", "--fixed", "16", "--target", targets]);
    let report: Value = serde_json::from_slice(&tool.assert().success().get_output().stdout).expect("one JSON object");
    report["sizes"].as_array().expect("sizes").clone()
}

fn has_cross_compilers(what: &str) -> bool {
    let tools = [
        ("arm-none-eabi-gcc", "gcc-arm-none-eabi"),
        ("riscv64-unknown-elf-gcc", "gcc-riscv64-unknown-elf"),
        ("avr-gcc", "gcc-avr"),
    ];
    tools.into_iter().all(|(tool, package)| tpg_testing::tool(tool, package, what))
}

#[test]
fn every_chip_has_figures_with_its_library_functions() {
    if !has_cross_compilers("reports on every chip") {
        return;
    }
    const ARM: &str = "m0,m3,m4,m4f,m7,m33,rp2040";
    for size in sizes_of("cartpole", &format!("{ARM},rv32imac,rv32imafc,esp32-c3,atmega328p")) {
        let (target, profile) = (size["target"].as_str().expect("a name"), size["profile"].as_str().expect("a name"));
        let number = |key: &str| size[key].as_u64();
        if profile == "gegelati" {
            assert_eq!(number("linked_flash"), None, "its inputs lie elsewhere: {size}");
            continue;
        }
        let (flash, linked) = (number("flash").expect("bytes"), number("linked_flash").expect("bytes"));
        let is_soft = matches!(target, "m0" | "m3" | "m4" | "rp2040" | "rv32imac" | "esp32-c3" | "atmega328p");
        let takes_library = is_soft && !profile.starts_with("integers");
        assert_eq!(linked > flash + 400, takes_library, "{size}");
        match number("instructions") {
            Some(instructions) => {
                // An AVR's are cycles: its products of 16 bits are calls.
                let most = if target == "atmega328p" { 300 } else { 100 };
                assert_eq!(instructions > most, takes_library, "{size}");
                assert!(number("stack").is_some(), "{size}");
            }
            None => assert!(target == "atmega328p" && takes_library, "{size}"),
        }
    }
    let sizes = sizes_of("widowx-fs", "atmega328p");
    let ram = |profile: &str| sizes.iter().find(|size| size["profile"] == profile).expect("a profile")["ram"].as_u64();
    assert_eq!(ram("fast"), Some(0));
    assert!(ram("small") > Some(500), "tables are copied to RAM");
}

/// `c-harness/cores.toml` has the instructions that QEMU counted of the same C.
#[test]
fn no_core_took_more_instructions_than_the_bound() {
    if !has_cross_compilers("bounds beside counted instructions") {
        return;
    }
    const CORES: [(&str, Target); 7] = [
        ("Cortex-M0", Target::M0),
        ("Cortex-M3", Target::M3),
        ("Cortex-M4F", Target::M4f),
        ("Cortex-M7", Target::M7),
        ("Cortex-M33", Target::M33),
        ("RISC-V rv32imac", Target::Rv32imac),
        ("RISC-V rv32imafc", Target::Rv32imafc),
    ];
    let counted = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../c-harness/cores.toml")).expect("a file");
    let counted: toml::Value = toml::from_str(&counted).expect("figures");
    let mut compared = 0;
    let few = ["cartpole", "dodge", "widowx_rs"];
    // Names of integers end in their bits, and the policy with memory is not shipped.
    let is_taken = |name: &str| {
        name != "recall"
            && !name.ends_with("_16")
            && !name.ends_with("_8")
            && tpg_testing::amount(few.contains(&name), true)
    };
    let of_a_core = counted["core"][CORES[0].0]["c"].as_table().expect("policies");
    for name in of_a_core.keys().filter(|name| is_taken(name.as_str())) {
        let file = shipped(&name.replace('_', "-"));
        let graph = Graph::from_json(&file, &fs::read_to_string(&file).expect("a graph")).expect("a graph");
        let code = Code::of(compile(&graph, &Options::new("policy".parse().expect("a prefix")), Language::C));
        for (core, target) in CORES {
            let worst = counted["core"][core]["c"][name.as_str()]["worst"].as_integer().expect("a number");
            let linked =
                build_c(&code, target).and_then(|built| built.link(&code)).expect("it links").expect("an image");
            let bound = linked.bound.expect("it is analysed").expect("a bound").instructions;
            assert!(i128::from(bound) >= i128::from(worst), "{name} on {core}: counted {worst}, at most {bound}");
            compared += 1;
        }
    }
    assert!(compared >= 3 * CORES.len(), "{compared}");
}

#[test]
fn the_most_instructions_are_a_limit_too() {
    if !tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", "a limit on instructions") {
        return;
    }
    let run = |args: &[&str], code: i32| {
        let mut tool = Command::cargo_bin("tpg-codegen").expect("the program is built");
        let tool = tool.args(["report", &shipped("cartpole")]).args(args);
        String::from_utf8(tool.assert().code(code).get_output().stderr.clone()).expect("text")
    };
    run(&["--target", "m0,m4f", "--max-instructions", "1000", "--max-flash", "4000"], 0);
    let refused = run(&["--target", "m4f,m0", "--max-instructions", "100"], 1);
    assert!(refused.contains("instructions of a decision at most on Cortex-M0"), "{refused}");
    run(&["--target", "m4f,m0", "--max-instructions", "100", "--fixed", "16"], 0);
    let refused = run(&["--target", "atmega328p", "--max-instructions", "100", "--fixed", "16"], 1);
    assert!(refused.contains("cycles of a decision at most on ATmega328P"), "{refused}");
    let refused = run(&["--target", "atmega328p", "--max-instructions", "100"], 1);
    assert!(refused.contains("cannot be checked on ATmega328P"), "{refused}");
    let refused = run(&["--target", "m0", "--max-flash", "500"], 1);
    assert!(refused.contains("bytes of flash on Cortex-M0"), "with soft floats: {refused}");
    let refused = run(&["--target", "host", "--max-instructions", "100"], 1);
    assert!(refused.contains("accepted are Cortex-M and RISC-V"), "{refused}");
}

#[test]
fn without_a_cross_compiler_no_size_is_known_and_it_says_so() {
    let folder = folder();
    let run = |args: &[&str]| {
        let mut tool = Command::cargo_bin("tpg-codegen").expect("the program is built");
        let tool = tool.current_dir(&folder).args(["report", "arm.json", "--target", "m4f"]).args(args);
        String::from_utf8(tool.env("PATH", "").assert().success().get_output().stdout.clone()).expect("text")
    };
    let text = run(&[]);
    assert!(text.contains("\nbytes on Cortex-M4F: not known: arm-none-eabi-gcc: "), "{text}");
    let report: Value = serde_json::from_str(&run(&["--json"])).expect("one JSON object");
    for size in report["sizes"].as_array().expect("sizes") {
        assert_eq!((&size["flash"], &size["stack"]), (&Value::Null, &Value::Null));
    }
}

/// All states of the sample at once would take 2.6 GB.
#[cfg(target_os = "linux")]
#[test]
fn a_wide_graph_takes_little_memory() {
    use tpg_graph::sample::{self, Shape};
    let shape = Shape { sources: vec![tpg_testing::amount(8_192, 16_384)], teams: 2, edges: 1..=2, ..Shape::default() };
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("wide.json"), sample::graph(&shape, 1).to_json()).expect("written");
    let tool = assert_cmd::cargo::cargo_bin("tpg-codegen");
    let mut limited = Command::new("sh");
    limited
        .current_dir(&folder)
        .args(["-c", "ulimit -v 1000000 && exec \"$0\" report wide.json --target host"])
        .arg(tool);
    let output = limited.assert().code(0).get_output().clone();
    assert!(String::from_utf8_lossy(&output.stdout).contains("constant-time"));
}

#[test]
fn a_table_of_sums_has_a_bound() {
    if !has_cross_compilers("reports of tables in integers") {
        return;
    }
    // Compilers keep the loop over three rows, and write two one by one.
    for name in ["hopper", "swimmer"] {
        let sizes = sizes_of(name, "m0,m4f,rv32imac");
        for target in ["m0", "m4f", "rv32imac"] {
            let of = |profile: &str, key: &str| {
                let is = |size: &&Value| size["target"] == target && size["profile"] == profile;
                sizes
                    .iter()
                    .find(is)
                    .and_then(|size| size[key].as_u64())
                    .unwrap_or_else(|| panic!("{name}, {target}, {profile}"))
            };
            let [sums, table] = ["integers", "integers, small"];
            assert!(of(table, "flash") < of(sums, "flash"), "{name} on {target}");
            assert!(of(table, "instructions") > of(sums, "instructions"), "{name} on {target}");
        }
    }
}
