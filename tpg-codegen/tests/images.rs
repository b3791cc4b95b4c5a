//! Policies that see an image: the function that reads it.

use std::fs;
use tpg_codegen::compile;
use tpg_codegen::emit::{self, Code, Language, Options, Profile};
use tpg_codegen::quantise::{Request, quantise};
use tpg_codegen::report::report;
use tpg_codegen::size::Target;
use tpg_codegen::verify::Proof;
use tpg_graph::states::StateSet;
use tpg_graph::{Graph, interpret};

/// A graph with each feature of an image once, and a value that comes from elsewhere.
const EYE: &str = include_str!("fixtures/eye.json");

fn graph() -> Graph {
    Graph::from_json("eye.json", EYE).expect("a graph")
}

fn options(profile: Profile) -> Options {
    Options { profile: Some(profile), ..Options::new("eye".parse().expect("a prefix")) }
}

#[test]
fn the_code_reads_the_image_where_it_is() {
    let graph = graph();
    let text = |language| -> String {
        let files = emit::emit(&graph, language, &options(Profile::Fast));
        files.into_iter().map(|file| format!("{}\n{}\n", file.name, file.text)).collect()
    };
    insta::assert_snapshot!("eye.c", text(Language::C));
    insta::assert_snapshot!("eye.rs", text(Language::Rust));
}

#[test]
fn every_profile_sees_what_the_features_mean() {
    let graph = graph();
    let profiles = Profile::ALL.iter().flat_map(|&profile| [(Language::C, profile), (Language::Rust, profile)]);
    let codes: Vec<Code<'_>> =
        profiles.map(|(language, profile)| Code::of(compile(&graph, &options(profile), language))).collect();
    let proof = Proof::of(&codes, 1000, 3).expect("compilers run");
    assert!(proof.holds(), "{proof:?}");
    assert_eq!(proof.comparisons.len(), 2 * codes.len(), "states, and images");
}

#[test]
fn a_report_bounds_what_reads_the_image() {
    if !tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", "a bound of what reads an image") {
        return;
    }
    // Three searches through all 100 cells, two through 64 windows of 9 with the mean of the image, and a window.
    const READS: u64 = 3 * 100 + 2 * (64 * 9 + 100) + 12;
    let report = report("eye.json", &graph(), &options(Profile::Fast), &[Target::M0, Target::M4f], None);
    let sizes = report.expect("floats").sizes;
    let looks: Vec<u64> = sizes.iter().filter_map(|size| size.look).collect();
    assert!(
        looks.len() >= 2 * Profile::ALL.len() && looks.iter().all(|look| (3 * READS..20 * READS).contains(look)),
        "{looks:?}"
    );
}

#[test]
fn a_wrong_function_is_noticed() {
    let graph = graph();
    let mut code = Code::of(compile(&graph, &options(Profile::Fast), Language::C));
    let source = &mut code.files[1].text;
    assert_eq!(source.matches("place_2, -3, 2").count(), 1);
    *source = source.replace("place_2, -3, 2", "place_2, -3, 1");
    let proof = Proof::of(&[code], 1000, 3).expect("the compiler runs");
    assert!(!proof.holds() && proof.comparisons[0].differences == 0 && proof.comparisons[1].differences > 0);
}

#[test]
fn features_that_no_program_reads_are_dropped() {
    let text = EYE
        .replace("\"ball[0]\",\"ball[1]\"", "\"ball[1]\",\"ball[1]\"")
        .replace("\"bright[3]\",\"bright[2]\"", "\"r0\",\"r0\"");
    let whole = Graph::from_json("eye.json", &text).expect("a graph");
    let lean = whole.clone().without_unread_features();
    let names = |graph: &Graph| graph.inputs().map(|input| graph.input_name(input)).collect::<Vec<_>>();
    assert_eq!(names(&lean), ["ball[0]", "ball[1]", "bright[0]", "bright[1]", "speed[0]"]);
    assert_eq!(Graph::from_json("lean.json", &lean.to_json()).expect("a valid graph"), lean);
    let state = [9.0, 1.0, 2.0, 3.0, 4.0, 9.0, 9.0, 5.0];
    assert_eq!(interpret::answers(&whole, &state), interpret::answers(&lean, &[1.0, 2.0, 3.0, 4.0, 5.0]));
}

#[test]
fn integers_read_the_image_in_place() {
    let graph = graph();
    let states = StateSet::sampled(&graph, 1000, 1);
    let (whole, report) = quantise("eye.json", &graph, &Request::of_bits(16, &states)).expect("integers");
    assert!(report.comparison.same == 1000 && report.comparison.saturated == 0.0, "{report}");
    assert!(report.comparison.outputs.iter().all(|output| output.mean < 0.001), "{report}");
    let of = |(language, profile)| Code::of_graph("eye.json", &whole, &options(profile), language).expect("integers");
    let codes = [(Language::C, Profile::Fast), (Language::C, Profile::Small), (Language::Rust, Profile::Fast)].map(of);
    assert!(codes.iter().flat_map(|code| &code.files).all(|file| !file.text.contains("float")));
    let proof = Proof::of(&codes, 1000, 3).expect("compilers run");
    assert!(proof.holds() && proof.comparisons.len() == 2 * codes.len(), "{proof:?}");
    let folder = tempfile::TempDir::new().expect("a temporary folder");
    fs::write(folder.path().join("eye.json"), whole.to_json()).expect("a file");
    let mut tool = assert_cmd::Command::cargo_bin("tpg-codegen").expect("the program");
    let said = tool.current_dir(folder.path()).args(["prove", "eye.json"]).assert().success();
    let said = String::from_utf8_lossy(&said.get_output().stdout).into_owned();
    assert_eq!(said.matches("proven equal to the graph for all inputs").count(), 4, "{said}");
    // Counts of an image's values are these values.
    let text = whole.to_json().replacen("\"scale\":1.0", "\"scale\":2.0", 1);
    let error = Graph::from_json("eye.json", &text).expect_err("no such counts").to_string();
    assert!(error.contains("accepted: a scale of 1, and bits for"), "{error}");
}
