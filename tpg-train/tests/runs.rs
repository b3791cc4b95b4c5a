//! Runs end with the same bytes, however often they are killed and on any number of threads; bad input is rejected.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};
use tpg_engine::random::{Purpose, Stream};
use tpg_problems::arm::arms::ARMS;
use tpg_problems::{Problem, ProblemName};
use tpg_train::parts::Units;
use tpg_train::{Config as EvolutionConfig, Configuration as _};

/// A run of seconds that uses every feature of evolution: pool, lexicase, racing, an instruction of its own.
fn small_config() -> EvolutionConfig {
    let mut config = EvolutionConfig::preset("best-rs").expect("a preset");
    config.problem = Problem::new(ProblemName::Pendulum).to_table();
    config.problem.insert("levels".to_owned(), 3.into());
    (config.tpg.nb_roots, config.tpg.init_nb_roots, config.tpg.max_init_outgoing_edges) = (48, 80, 3);
    config.pool.share = 0.3;
    (config.learning.nb_iterations_per_policy_evaluation, config.learning.nb_generations) = (12, 25);
    config.learning.ratio_deleted_roots = 0.7;
    (config.selection.lexicase_survivors, config.selection.racing_episodes) = (3, 4);
    (config.curriculum.generations, config.curriculum.roughness) = (6, 3);
    config.selection.validation_episodes = 30;
    config.language.instructions.push("div(a, add(1, abs(b)))".to_owned());
    config
}

fn train(folder: &Path, config: &Path, more: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tpg-train"));
    command.arg("tpg").arg("--config").arg(config).arg("--out").arg(folder).args(more);
    command.stdout(Stdio::null()).stderr(Stdio::null());
    command
}

fn refusal(mut command: Command) -> String {
    let output = command.stderr(Stdio::piped()).output().expect("the program starts");
    assert_eq!(output.status.code(), Some(2), "bad input is exit status 2");
    String::from_utf8(output.stderr).expect("text")
}

/// Returns all results except the times.
fn results(folder: &Path) -> Vec<(String, Vec<u8>)> {
    ["graph.json", "hall.jsonl", "generations.jsonl", "checkpoint", "config.toml"]
        .map(|name| (name.to_owned(), fs::read(folder.join(name)).unwrap_or_else(|_| panic!("{name} is missing"))))
        .to_vec()
}

#[test]
fn killed_resumed_or_on_other_threads_a_run_ends_in_the_same_bytes() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let config = place.path().join("config.toml");
    fs::write(&config, small_config().to_toml()).expect("it can be written");
    let undisturbed = place.path().join("undisturbed");
    let start = Instant::now();
    assert!(train(&undisturbed, &config, &["--threads", "1"]).status().expect("it runs").success());
    let whole = start.elapsed();
    let expected = results(&undisturbed);
    let graph = tpg_graph::files::read_graph(&undisturbed.join("graph.json")).expect("a graph");
    assert_eq!(
        graph.registers(),
        small_config().learning.nb_registers + 2,
        "two for what the instruction computes on the way"
    );
    for (name, more) in [("threads-2", ["--threads", "2"]), ("threads-5", ["--threads", "5"])] {
        let folder = place.path().join(name);
        assert!(train(&folder, &config, &more).status().expect("it runs").success());
        assert!(results(&folder) == expected, "{name} gives other bytes");
    }

    // Each process uses other threads. A run that finishes is compared, and another one started.
    let mut stream = Stream::new(1, 0, Purpose::Test, 0);
    let times = tpg_testing::amount(6, 20);
    let (mut kills, mut ends) = (0, 0);
    while kills < times {
        let killed = place.path().join(format!("killed-{ends}"));
        let arguments = ["--threads", *stream.pick(&["1", "2", "5"]), "--checkpoint-seconds", "0", "--resume"];
        let mut run: Child = train(&killed, &config, &arguments).spawn().expect("it starts");
        sleep(whole / 400 * stream.between(1, 100) as u32);
        // SIGKILL cannot be caught by the program.
        run.kill().expect("it can be killed");
        let end = run.wait().expect("it ends");
        if end.success() {
            assert!(results(&killed) == expected, "run {ends}, resumed, gives other bytes");
            ends += 1;
            assert!(ends < 100, "runs end before they are killed");
        } else {
            assert_eq!(end.code(), None, "it is killed, it does not fail");
            kills += 1;
        }
    }
    let last = place.path().join(format!("killed-{ends}"));
    assert!(train(&last, &config, &["--resume"]).status().expect("it runs").success());
    assert!(results(&last) == expected, "a resumed run gives other bytes");

    let rows = fs::read_to_string(undisturbed.join("generations.jsonl")).expect("the log");
    assert_eq!(rows.lines().count(), 25, "every generation");
    assert!(rows.starts_with("{\"generation\":0,"), "from 0 on");
}

#[test]
fn a_finished_run_is_not_overwritten_and_another_configuration_not_resumed() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let (config, folder) = (place.path().join("config.toml"), place.path().join("run"));
    fs::write(&config, small_config().to_toml()).expect("it can be written");
    assert!(train(&folder, &config, &["--generations", "2"]).status().expect("it runs").success());
    let before = results(&folder);
    let log = fs::read_to_string(folder.join("generations.jsonl")).expect("the log");
    let row = |row: &str| serde_json::from_str::<serde_json::Value>(row).expect("JSON");
    let steps: Vec<u64> = log.lines().map(|line| row(line)["steps"].as_u64().expect("a count")).collect();
    assert!(steps[0] > 0 && steps.is_sorted_by(|a, b| a < b), "{steps:?}");
    assert_eq!(steps.last().copied(), state(&folder)["steps"].as_u64(), "those of the run");
    assert!(refusal(train(&folder, &config, &["--generations", "2"])).contains("--resume"));
    let mut changed = small_config();
    changed.tpg.nb_roots = 49;
    let other = place.path().join("other.toml");
    fs::write(&other, changed.to_toml()).expect("it can be written");
    let refused = refusal(train(&folder, &other, &["--generations", "2", "--resume"]));
    assert!(refused.contains("- tpg.nb_roots = 48") && refused.contains("+ tpg.nb_roots = 49"), "{refused}");
    assert!(refusal(train(&folder, &config, &["--generations", "2", "--resume", "--seed", "9"])).contains("seed 1"));
    assert!(results(&folder) == before, "a refused run changes nothing");
}

#[test]
fn a_run_can_go_further_than_it_was_asked_before() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let (config, folder) = (place.path().join("config.toml"), place.path().join("run"));
    fs::write(&config, small_config().to_toml()).expect("it can be written");
    let rows = || fs::read_to_string(folder.join("generations.jsonl")).expect("the log");
    assert!(train(&folder, &config, &["--generations", "3"]).status().expect("it runs").success());
    let before = rows();
    assert!(train(&folder, &config, &["--generations", "5", "--resume"]).status().expect("it runs").success());
    assert!(rows().starts_with(&before), "the first generations stay");
    assert_eq!(rows().lines().count(), 5);
}

/// Returns the state in a checkpoint: one line of JSON before the checksum.
fn state(folder: &Path) -> serde_json::Value {
    let checkpoint = fs::read_to_string(folder.join("checkpoint")).expect("a checkpoint");
    let mut content: serde_json::Value =
        serde_json::from_str(checkpoint.lines().next().expect("a line")).expect("JSON");
    content["state"].take()
}

/// Trains on a built-in problem with the given arguments.
fn train_on(problem: &str, folder: &Path, more: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tpg-train"));
    command.args(["tpg", "--problem", problem, "--out"]).arg(folder).args(more);
    command.stdout(Stdio::null()).stderr(Stdio::null());
    command
}

#[test]
fn a_target_and_a_number_of_steps_end_a_run_early() {
    let place = tempfile::tempdir().expect("a temporary folder");
    for (goal, value) in [("--target", "400"), ("--max-steps", "200000")] {
        let folder = place.path().join(goal);
        assert!(train_on("cartpole", &folder, &[goal, value]).status().expect("it runs").success());
        let rows = fs::read_to_string(folder.join("generations.jsonl")).expect("the log").lines().count();
        assert!(rows < 60, "{goal}: {rows} rows");
        let steps = state(&folder)["steps"].as_u64().expect("a count");
        assert!(goal == "--target" || steps >= 200_000, "{steps} steps");
    }
}

#[test]
fn a_number_of_steps_replaces_the_default_number_of_generations() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let generations = |name: &str, more: &[&str]| {
        let folder = place.path().join(name);
        let few = ["--max-steps", "2000", "--set", "tpg.nb_roots=5"];
        assert!(train_on("cartpole", &folder, &[&few[..], more].concat()).status().expect("it runs").success());
        let config = fs::read_to_string(folder.join("config.toml")).expect("the configuration");
        config.lines().find_map(|line| line.strip_prefix("nb_generations = ").map(str::to_owned)).expect("a number")
    };
    assert_eq!(generations("steps", &[]), "0");
    assert_eq!(generations("argument", &["--generations", "3"]), "3");
    assert_eq!(generations("setting", &["--set", "learning.nb_generations=4"]), "4");
}

#[test]
fn a_target_that_the_search_for_weights_reaches_ends_it() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let run = |name: &str, threads: &str| {
        let folder = place.path().join(name);
        let more = ["--preset", "quick", "--set", "start.random=0", "--target", "475", "--threads", threads];
        assert!(train_on("cartpole", &folder, &more).status().expect("it runs").success());
        results(&folder)
    };
    assert!(run("one", "1") == run("three", "3"));
    let state = state(&place.path().join("one"));
    let number = |key: &str| state[key].as_u64().expect(key);
    assert!(number("generation") < 20, "{} generations", number("generation"));
    assert_eq!(state["best"]["result"]["episodes"], 100, "it has played all validation episodes");
    assert!(state["best"]["result"]["score"].as_f64().expect("a score") >= 475.0);
    assert!(number("steps") < 150_000, "{} steps", number("steps"));
}

#[test]
fn selection_takes_no_more_than_a_tenth_of_the_steps() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let generations = tpg_testing::amount("12", "30");
    for preset in ["gegelati", "thorough"] {
        let folder = place.path().join(preset);
        let more = ["--preset", preset, "--generations", generations];
        assert!(train_on("cartpole", &folder, &more).status().expect("it runs").success());
        let state = state(&folder);
        let number = |key: &str| state[key].as_u64().expect("a count");
        let (steps, selection) = (number("steps"), number("selection_steps"));
        assert!(9 * selection <= steps && selection > 0, "{preset}: {selection} of {steps}");
    }
}

#[test]
fn a_preset_a_file_and_single_settings_change_each_other_in_this_order() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let (file, folder) = (place.path().join("mine.toml"), place.path().join("run"));
    fs::write(&file, "tpg.nb_roots = 20\nselection.line_price = 0.5\n").expect("it can be written");
    let all = ["--preset", "quick", "--config", file.to_str().expect("a path"), "--set", "selection.line_price=0"];
    let more = ["--set", "language.scalar=f64", "--generations", "1"];
    assert!(train_on("cartpole", &folder, &[&all[..], &more].concat()).status().expect("it runs").success());
    let text = fs::read_to_string(folder.join("config.toml")).expect("the whole configuration");
    let config = EvolutionConfig::from_toml("config.toml", &text).expect("a good one");
    let quick = EvolutionConfig::preset("quick").expect("a preset");
    assert_eq!((config.tpg.nb_roots, config.selection.line_price), (20, 0.0));
    assert_eq!((config.language.scalar, config.refinement), (tpg_graph::ScalarType::F64, quick.refinement));

    let other = place.path().join("other");
    let refused = |more: &[&str]| refusal(train_on("cartpole", &other, &[&all[..], more].concat()));
    let said = refused(&["--set", "tpg.nb_rots=3"]);
    assert!(
        said.contains("the setting tpg.nb_rots: unknown field `nb_rots`") && said.contains("tpg-train config"),
        "{said}"
    );
    let said = refused(&["--set", "selection.validation_share=2"]);
    assert!(said.contains("the setting selection.validation_share: ") && said.contains("0.001 to 0.9"), "{said}");
    assert!(refused(&["--set", "tpg.nb_roots"]).contains("--set KEY=VALUE"));
    let said = refusal(train_on("cartpole", &other, &["--preset", "slow"]));
    assert!(said.contains("thorough, quick, gegelati"), "{said}");
    fs::write(&file, "\n[tpg]\nnb_roots = 1\n").expect("it can be written");
    let said = refused(&[]);
    assert!(said.contains("mine.toml: line 3: tpg.nb_roots = 1; accepted: 2 to"), "{said}");
    assert!(!other.exists());
}

#[test]
fn a_folder_that_cannot_be_written_is_an_error() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let config = place.path().join("config.toml");
    fs::write(&config, small_config().to_toml()).expect("it can be written");
    let file = place.path().join("file");
    fs::write(&file, "in the way").expect("it can be written");
    assert!(refusal(train(&file.join("run"), &config, &[])).contains("file/run"));
    // Nobody can write here, not even root.
    if Path::new("/proc/self").exists() {
        assert!(refusal(train(Path::new("/proc/run"), &config, &[])).contains("/proc/run"));
    } else {
        tpg_testing::skip("a run in a folder that nobody can write: there is no /proc");
    }
}

#[test]
fn a_bad_configuration_is_refused_with_its_line_and_what_is_accepted() {
    for (text, line, found, accepted) in [
        ("[program]\np_swop = 1.0", 2, "unknown field `p_swop`", "tpg-train config"),
        ("[tpg]\nnb_roots = \"many\"", 2, "invalid type", "tpg-train config"),
        ("\nstart.share = 1.5", 2, "start.share = 1.5", "0 to 1"),
        ("[language]\ninstructions = [\"add\", \"add\"]", 2, "\"add\"", "each once"),
        ("[language]\ninstructions = [\"pi\"]", 2, "\"pi\", which is neither", "or calls of them on a and b"),
        ("[language]\ninstructions = [\"sub\"]", 1, "start.share = 0.4", "the words add and multiply_add or mul"),
        ("tpg.max_outgoing_edges = 2", 1, "tpg.max_outgoing_edges = 2", "4 to"),
        ("[curriculum]\nroughness = 128", 2, "curriculum.roughness = 128", "1 to 127"),
        ("curriculum.generations = 100000", 1, "curriculum.generations = 100000", "0 to"),
    ] {
        let error = EvolutionConfig::from_toml("c.toml", text).expect_err(text).to_string();
        let place = if found.starts_with("start.share = 0.4") { String::new() } else { format!("line {line}: ") };
        assert!(error.starts_with(&format!("c.toml: {place}")), "{error}");
        assert!(error.contains(found) && error.contains(accepted), "{error}");
    }
    let text = "[problem]\nname = \"fs\"\nsources = [\"polar\", \"smell\"]\n";
    let error = Problem::from_toml("c.toml", text).expect_err("it is wrong").to_string();
    assert!(
        error.starts_with("c.toml: line 3: ") && error.contains("\"smell\"") && error.contains("stance"),
        "{error}"
    );
    // Also the line of a key in a nested section.
    let arm =
        "[problem]\nname = \"fs\"\n".to_owned() + &ARMS[0].text.replace("elbow_offset = 49.0", "elbow_offset = -1.0");
    let line = arm.lines().position(|line| line.starts_with("elbow_offset")).expect("the key") + 1;
    let error = Problem::from_toml("c.toml", &arm).expect_err("it is wrong").to_string();
    assert_eq!(error, format!("c.toml: line {line}: problem.arm.links.elbow_offset = -1; accepted: 0 to 1000 mm"));
}

/// Waits until a file exists.
fn wait_for(path: &Path) {
    while !path.exists() {
        sleep(Duration::from_millis(1));
    }
}

/// Starts a run, sends it a signal when the given file exists, and returns its exit code and its stderr. A run that
/// finishes before the signal is repeated.
fn stopped(folder: &Path, config: &Path, more: &[&str], file: &str, signal: &str) -> (Option<i32>, String) {
    for _ in 0..100 {
        let mut run = train(folder, config, more).stderr(Stdio::piped()).spawn().expect("it starts");
        wait_for(&folder.join(file));
        let sent = Command::new("kill").args(["-s", signal, &run.id().to_string()]).stderr(Stdio::null()).status();
        sent.expect("kill is a command");
        let end = run.wait().expect("it ends");
        if !end.success() {
            let mut stderr = String::new();
            std::io::Read::read_to_string(&mut run.stderr.take().expect("it is piped"), &mut stderr).expect("text");
            return (end.code(), stderr);
        }
        fs::remove_dir_all(folder).expect("it can be removed");
    }
    panic!("every run finished before the signal");
}

#[test]
fn ctrl_c_leaves_a_checkpoint_that_ends_in_the_same_bytes() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let config = place.path().join("config.toml");
    fs::write(&config, small_config().to_toml()).expect("it can be written");
    let undisturbed = place.path().join("undisturbed");
    assert!(train(&undisturbed, &config, &[]).status().expect("it runs").success());
    for name in ["INT", "TERM"] {
        let folder = place.path().join(name);
        // No checkpoint is written in between, so the one found was written because of the signal.
        let more = ["--threads", "1", "--checkpoint-seconds", "1000000"];
        // The configuration is written when training begins.
        let (code, stderr) = stopped(&folder, &config, &more, "config.toml", name);
        assert_eq!(code, Some(130), "{stderr}");
        assert!(stderr.contains("--resume"), "{stderr}");
        let rows = fs::read_to_string(folder.join("generations.jsonl")).expect("the log").lines().count();
        // The signal may come before the first generation ends.
        assert!((0..25).contains(&rows), "some generations, not {rows} rows");
        assert!(train(&folder, &config, &["--resume"]).status().expect("it runs").success());
        assert!(results(&folder) == results(&undisturbed), "{name}: other bytes");
    }
}

/// A small population that begins with what a short search has found.
fn small() -> EvolutionConfig {
    let mut config = EvolutionConfig::default();
    (config.tpg.nb_roots, config.tpg.init_nb_roots) = (60, 120);
    config.start.share = 0.2;
    config
}

/// A policy that computes the torque: leaves, teams and refined numbers.
#[test]
fn a_policy_with_outputs_has_the_same_bytes_on_other_threads_and_after_a_stop() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let path = place.path().join("config.toml");
    let mut config = small();
    config.learning.nb_generations = 25;
    config.selection.validation_episodes = 30;
    config.problem = Problem::new(ProblemName::Pendulum).to_table();
    fs::write(&path, config.to_toml()).expect("it can be written");
    let [one, other, stopped] = ["one", "other", "stopped"].map(|name| place.path().join(name));
    assert!(train(&one, &path, &["--threads", "1"]).status().expect("it runs").success());
    assert!(train(&other, &path, &["--threads", "3"]).status().expect("it runs").success());
    assert!(results(&one) == results(&other), "threads and lanes change nothing");
    let checkpoints = ["--checkpoint-seconds", "0"];
    let mut run = train(&stopped, &path, &checkpoints).spawn().expect("it starts");
    wait_for(&stopped.join("checkpoint"));
    run.kill().expect("it can be killed");
    run.wait().expect("it ends");
    assert!(train(&stopped, &path, &["--resume"]).status().expect("it runs").success());
    assert!(results(&one) == results(&stopped), "a kill changes nothing");

    let text = fs::read_to_string(one.join("graph.json")).expect("a graph");
    let graph = tpg_graph::Graph::from_json("graph.json", &text).expect("a valid graph");
    assert_eq!(graph.outputs().len(), 1);
    assert!(graph.actions().is_empty() && !graph.leaves().is_empty());
}

/// A pendulum without a sensor of its velocity, and policies that remember two values.
fn memory_config() -> EvolutionConfig {
    let mut config = small();
    config.learning.nb_generations = 8;
    config.selection.validation_episodes = 30;
    config.language.memory = 2;
    config.language.instructions.push("copy".to_owned());
    let hidden = "[problem]\nname = \"pendulum\"\ndisturbance = { hidden = [\"omega\"] }\n";
    config.problem = Problem::from_toml("pendulum", hidden).expect("a pendulum").to_table();
    config
}

#[test]
fn a_policy_with_memory_has_the_same_bytes_on_other_threads_and_is_evaluated_with_it() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let path = place.path().join("config.toml");
    fs::write(&path, memory_config().to_toml()).expect("it can be written");
    let [one, other] = ["one", "other"].map(|name| place.path().join(name));
    assert!(train(&one, &path, &["--threads", "1"]).status().expect("it runs").success());
    assert!(train(&other, &path, &["--threads", "3"]).status().expect("it runs").success());
    assert!(results(&one) == results(&other), "threads and lanes change nothing");

    let text = fs::read_to_string(one.join("graph.json")).expect("a graph");
    let graph = tpg_graph::Graph::from_json("graph.json", &text).expect("a valid graph");
    assert_eq!((graph.memory(), graph.outputs().len(), graph.state_length()), (2, 3, 4));
    let mut eval = Command::new(env!("CARGO_BIN_EXE_tpg-train"));
    eval.args(["eval", "--problem", "pendulum"]).arg("--config").arg(&path).arg("--tpg").arg(one.join("graph.json"));
    let output = eval.args(["--episodes", "20", "--json"]).output().expect("it runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let figures: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert!(figures["mean_score"].as_f64().is_some_and(|score| (-1700.0..0.0).contains(&score)), "{figures}");
}

#[test]
fn memory_needs_outputs() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let path = place.path().join("config.toml");
    let mut config = memory_config();
    config.problem = Problem::new(ProblemName::Acrobot).to_table();
    fs::write(&path, config.to_toml()).expect("it can be written");
    let said = refusal(train(&place.path().join("run"), &path, &[]));
    assert!(said.contains("language.memory") && said.contains("a problem without outputs"), "{said}");
}

/// A search for weights before evolution, for outputs and named actions; units from visited states: searches, and what stalled before
/// them, are part of the checkpoint.
#[test]
fn stages_have_the_same_bytes_on_other_threads_and_after_kills() {
    for (name, problem, random) in [
        ("outputs", ProblemName::Pendulum, 0.0),
        ("actions", ProblemName::Acrobot, 0.0),
        ("random search", ProblemName::Pendulum, 0.3),
        ("random search of actions", ProblemName::Acrobot, 0.3),
        ("random search with a toll", ProblemName::Cartpole, 0.3),
    ] {
        let place = tempfile::tempdir().expect("a temporary folder");
        let path = place.path().join("config.toml");
        let mut config = small();
        (config.tpg.nb_roots, config.tpg.init_nb_roots) = (40, 60);
        (config.learning.nb_generations, config.selection.validation_episodes) = (100, 30);
        config.learning.nb_iterations_per_policy_evaluation = 4;
        config.literals.units = Units::Visited;
        (config.refinement.p_mutation, config.start.share, config.start.random) = (0.5, 0.8, random);
        config.problem = Problem::new(problem).to_table();
        fs::write(&path, config.to_toml()).expect("it can be written");
        let [one, other, stopped] = ["one", "other", "stopped"].map(|name| place.path().join(name));
        assert!(train(&one, &path, &["--threads", "1"]).status().expect("it runs").success());
        assert!(train(&other, &path, &["--threads", "3"]).status().expect("it runs").success());
        assert!(results(&one) == results(&other), "{name}: threads and lanes change nothing");
        // Stopped in the first search, in a later one, and after all of them.
        let mut seen = String::new();
        for generations in ["3", "55", "90"] {
            let arguments = ["--checkpoint-seconds", "0", "--resume"];
            let mut run = train(&stopped, &path, &arguments).spawn().expect("it starts");
            let rows = stopped.join("generations.jsonl");
            let done = || fs::read_to_string(&rows).map_or(0, |text| text.lines().count());
            while done() < generations.parse().expect("a number") && run.try_wait().expect("a child").is_none() {
                sleep(Duration::from_millis(1));
            }
            run.kill().expect("it can be killed");
            run.wait().expect("it ends");
            seen += &state(&stopped).to_string();
        }
        assert!(seen.contains("\"cma\""), "{name}");
        assert!(random == 0.0 || seen.contains("\"random\"") && seen.contains("\"stalled\""), "{name}");
        assert!(train(&stopped, &path, &["--resume"]).status().expect("it runs").success());
        assert!(results(&one) == results(&stopped), "{name}: kills change nothing");
    }
}

/// Sums of the inputs balance a pole on a cart, and cannot swing a pendulum up.
#[test]
fn a_random_search_that_gets_nowhere_ends_early() {
    let place = tempfile::tempdir().expect("a temporary folder");
    for (problem, is_good) in [("pendulum", false), ("cartpole", true)] {
        let folder = place.path().join(problem);
        let more = ["--preset", "quick", "--set", "start.random=0.5", "--set", "start.share=0.5"];
        assert!(
            train_on(problem, &folder, &[&more[..], &["--max-steps", "1000000"]].concat())
                .status()
                .expect("it runs")
                .success()
        );
        let budget = &state(&folder)["budget"];
        // It had more than a quarter of its part, or left the rest to another search.
        let (part, searches) = (budget["part"].as_f64().expect("a part"), budget["searches"].as_u64());
        assert_eq!(part > 0.2 && searches <= Some(1), is_good, "{problem}: {budget}");
    }
}

#[test]
fn lines_have_their_price() {
    let place = tempfile::tempdir().expect("a temporary folder");
    // With the price of 1 a line costs the whole way to the best score.
    let sizes = ["0", "1"].map(|price| {
        let folder = place.path().join(price);
        let price = format!("selection.line_price={price}");
        let more = ["--set", &price, "--generations", "60"];
        assert!(train_on("pendulum", &folder, &more).status().expect("it runs").success());
        let text = fs::read_to_string(folder.join("graph.json")).expect("a graph");
        let graph = tpg_graph::Graph::from_json("graph.json", &text).expect("a valid graph");
        graph.programs().iter().map(|program| program.lines.len()).sum::<usize>()
    });
    assert!(sizes[1] <= 1 && sizes[1] < sizes[0], "{sizes:?}");
}

#[test]
fn restarts_keep_the_best_and_go_on_where_they_stopped() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let config = place.path().join("config.toml");
    let mut short = small_config();
    (short.learning.nb_generations, short.curriculum.generations) = (6, 3);
    fs::write(&config, short.to_toml()).expect("it can be written");
    let (all, stopped) = (place.path().join("all"), place.path().join("stopped"));
    assert!(train(&all, &config, &["--seeds", "1..4"]).status().expect("it runs").success());

    let graph = |path: &Path| fs::read(path.join("graph.json")).expect("a graph");
    let score = |seed: u64| {
        let graph = tpg_graph::files::read_graph(&all.join(format!("seed-{seed}/graph.json"))).expect("a graph");
        graph.provenance().scores["validation_score"]
    };
    // Ranked by mean score, as on a pendulum; ties go to the first.
    let best = (1..4).rev().max_by(|&a, &b| score(a).total_cmp(&score(b))).expect("three seeds");
    assert!(graph(&all) == graph(&all.join(format!("seed-{best}"))), "the best restart is seed {best}");

    let arguments = ["--seeds", "1..4", "--checkpoint-seconds", "0", "--resume"];
    let mut run = train(&stopped, &config, &arguments).spawn().expect("it starts");
    wait_for(&stopped.join("seed-2/checkpoint"));
    run.kill().expect("it can be killed");
    run.wait().expect("it ends");
    assert!(train(&stopped, &config, &arguments).status().expect("it runs").success());
    for seed in 1..4 {
        let bytes = |folder: &Path| results(&folder.join(format!("seed-{seed}")));
        assert!(bytes(&stopped) == bytes(&all), "seed {seed}, resumed, gives other bytes");
    }
    assert!(graph(&stopped) == graph(&all));
}

/// Simulates a full disk: files are limited to the given number of blocks of 512 bytes.
fn train_on_a_full_disk(folder: &Path, config: &Path, blocks: u64) -> Command {
    let mut command = Command::new("sh");
    // Without the trap the system would kill the program instead of returning an error.
    command.args(["-c", &format!("trap '' XFSZ; ulimit -f {blocks}; exec \"$@\""), "sh"]);
    command.arg(env!("CARGO_BIN_EXE_tpg-train")).arg("tpg").arg("--resume");
    command.args(["--checkpoint-seconds", "0", "--config"]).arg(config).arg("--out").arg(folder);
    command.stdout(Stdio::null());
    command
}

#[test]
fn a_full_disk_is_an_error_and_keeps_the_last_good_checkpoint() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let (config, folder) = (place.path().join("config.toml"), place.path().join("run"));
    let undisturbed = place.path().join("undisturbed");
    fs::write(&config, small_config().to_toml()).expect("it can be written");
    assert!(train(&undisturbed, &config, &[]).status().expect("it runs").success());

    stopped(&folder, &config, &["--checkpoint-seconds", "0"], "checkpoint", "KILL");
    let checkpoint = fs::read(folder.join("checkpoint")).expect("a checkpoint");
    let blocks = fs::metadata(folder.join("config.toml")).expect("a configuration").len() / 512 + 1;
    assert!((checkpoint.len() as u64) > 512 * blocks, "the checkpoint is what does not fit");

    let error = refusal(train_on_a_full_disk(&folder, &config, blocks));
    assert!(error.contains("checkpoint") && error.contains("space"), "{error}");
    assert!(fs::read(folder.join("checkpoint")).expect("a checkpoint") == checkpoint, "it is as it was");
    let left: Vec<_> = fs::read_dir(&folder).expect("a folder").map(|e| e.expect("an entry").file_name()).collect();
    assert!(left.iter().all(|name| !name.to_string_lossy().starts_with('.')), "no half file is left: {left:?}");
    assert!(train(&folder, &config, &["--resume"]).status().expect("it runs").success());
    assert!(results(&folder) == results(&undisturbed), "with space again it ends in the same bytes");
}

#[test]
fn the_papers_language_without_literals_trains_on_the_arm() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let sizes = ["tpg.nb_roots=20", "tpg.init_nb_roots=20", "learning.nb_iterations_per_policy_evaluation=2"];
    let sizes = sizes.iter().flat_map(|size| ["--set", size]);
    let few = ["--preset", "paper-fs", "--generations", "1", "--set", "selection.validation_episodes=2"];
    let all: Vec<&str> = few.into_iter().chain(sizes).collect();
    let trained = train_on("fs", &place.path().join("run"), &all).status().expect("it runs");
    assert!(trained.success());
}
