//! Runs end with the same bytes, however often they are killed and on any number of threads; bad input is rejected.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};
use tpg_engine::random::{Purpose, Stream};
use tpg_problems::arm::arms::ARMS;
use tpg_problems::{Problem, ProblemName};
use tpg_train::evolution::config::{EpisodeFor, EvolutionConfig, StartKind, Units};
use tpg_train::evolution::presets::Preset;

/// A run of seconds that uses every feature: two demes with migration, pool, archive, lexicase, racing.
fn small_config() -> EvolutionConfig {
    let mut config = Preset::find("best-rs").expect("it comes with the trainer").config().expect("it is accepted");
    config.problem = Problem::usual(ProblemName::Pendulum).to_table();
    config.problem.insert("levels".to_owned(), 3.into());
    (config.tpg.nb_roots, config.tpg.init_nb_roots, config.tpg.max_init_outgoing_edges) = (24, 40, 3);
    (config.demes.count, config.demes.migration_interval, config.demes.migrants) = (2, 3, 1);
    (config.pool.size, config.pool.share) = (20, 0.3);
    (config.learning.archive_size, config.learning.archiving_probability) = (20, 0.5);
    (config.learning.nb_iterations_per_policy_evaluation, config.learning.nb_generations) = (12, 25);
    config.learning.ratio_deleted_roots = 0.7;
    (config.selection.lexicase_survivors, config.selection.racing_episodes) = (3, 4);
    (config.curriculum.generations, config.curriculum.roughness) = (6, 3);
    config.selection.validation_episodes = 30;
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
    ["graph.json", "hall.jsonl", "generations.csv", "generations.jsonl", "checkpoint", "config.toml"]
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
    for (name, more) in
        [("threads-2", ["--threads", "2", "--lanes", "3"]), ("threads-5", ["--threads", "5", "--lanes", "1"])]
    {
        let folder = place.path().join(name);
        assert!(train(&folder, &config, &more).status().expect("it runs").success());
        assert!(results(&folder) == expected, "{name} gives other bytes");
    }

    // Each session uses different threads and lanes. A run that finishes is compared, and another one started.
    let mut stream = Stream::new(1, 0, Purpose::Test, 0);
    let times = tpg_testing::amount(6, 20);
    let (mut kills, mut ends) = (0, 0);
    while kills < times {
        let killed = place.path().join(format!("killed-{ends}"));
        let [threads, lanes] = [*stream.pick(&["1", "2", "5"]), *stream.pick(&["1", "3", "112"])];
        let arguments = ["--threads", threads, "--lanes", lanes, "--checkpoint-seconds", "0", "--resume"];
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

    let rows = fs::read_to_string(undisturbed.join("generations.csv")).expect("the log");
    assert_eq!(rows.lines().count(), 26, "a header, and every generation from 0");
    assert!(rows.lines().nth(1).is_some_and(|row| row.starts_with("0,")));
}

#[test]
fn a_finished_run_is_not_overwritten_and_another_configuration_not_resumed() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let (config, folder) = (place.path().join("config.toml"), place.path().join("run"));
    fs::write(&config, small_config().to_toml()).expect("it can be written");
    assert!(train(&folder, &config, &["--generations", "2"]).status().expect("it runs").success());
    let before = results(&folder);
    assert!(refusal(train(&folder, &config, &["--generations", "2"])).contains("--resume"));
    let mut changed = small_config();
    changed.tpg.nb_roots = 25;
    let other = place.path().join("other.toml");
    fs::write(&other, changed.to_toml()).expect("it can be written");
    let refused = refusal(train(&folder, &other, &["--generations", "2", "--resume"]));
    assert!(refused.contains("- tpg.nb_roots = 24") && refused.contains("+ tpg.nb_roots = 25"), "{refused}");
    assert!(refusal(train(&folder, &config, &["--generations", "2", "--resume", "--seed", "9"])).contains("seed 1"));
    assert!(results(&folder) == before, "a refused run changes nothing");
}

#[test]
fn a_run_can_go_further_than_it_was_asked_before() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let (config, folder) = (place.path().join("config.toml"), place.path().join("run"));
    fs::write(&config, small_config().to_toml()).expect("it can be written");
    let rows = || fs::read_to_string(folder.join("generations.csv")).expect("the log");
    assert!(train(&folder, &config, &["--generations", "3"]).status().expect("it runs").success());
    let before = rows();
    assert!(train(&folder, &config, &["--generations", "5", "--resume"]).status().expect("it runs").success());
    assert!(rows().starts_with(&before), "the first generations stay");
    assert_eq!(rows().lines().count(), 6, "a header and five generations");
}

/// Returns the state in a checkpoint: one line of JSON before the checksum.
fn state(folder: &Path) -> serde_json::Value {
    let checkpoint = fs::read_to_string(folder.join("checkpoint")).expect("a checkpoint");
    let mut content: serde_json::Value =
        serde_json::from_str(checkpoint.lines().next().expect("a line")).expect("JSON");
    content["state"].take()
}

#[test]
fn a_target_and_a_number_of_steps_end_a_run_early() {
    let place = tempfile::tempdir().expect("a temporary folder");
    for (goal, value) in [("--target", "400"), ("--max-steps", "200000")] {
        let folder = place.path().join(goal);
        let mut command = Command::new(env!("CARGO_BIN_EXE_tpg-train"));
        command.args(["tpg", "--problem", "cartpole", goal, value, "--out"]).arg(&folder);
        assert!(command.stderr(Stdio::null()).status().expect("it runs").success());
        let rows = fs::read_to_string(folder.join("generations.csv")).expect("the log").lines().count();
        assert!(rows < 60, "{goal}: {rows} rows of 101");
        let state = state(&folder);
        let number = |key: &str| state[key].as_u64().expect("a count");
        assert!(goal == "--target" || number("steps") >= 200_000, "{} steps", number("steps"));
    }
}

#[test]
fn a_target_that_the_search_for_weights_reaches_ends_it() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let mut config = Preset::find("frugal").expect("it comes with the trainer").config().expect("it is accepted");
    config.problem = Problem::usual(ProblemName::Cartpole).to_table();
    let file = place.path().join("config.toml");
    fs::write(&file, config.to_toml()).expect("it can be written");
    let run = |name: &str, threads: &str| {
        let folder = place.path().join(name);
        assert!(train(&folder, &file, &["--target", "475", "--threads", threads]).status().expect("it runs").success());
        results(&folder)
    };
    assert!(run("one", "1") == run("three", "3"));
    let state = state(&place.path().join("one"));
    let number = |key: &str| state[key].as_u64().expect(key);
    assert!(number("generation") < 20, "{} generations", number("generation"));
    assert_eq!(state["best"]["result"]["episodes"], 100, "it has played all selection episodes");
    assert!(state["best"]["result"]["score"].as_f64().expect("a score") >= 475.0);
    assert!(number("steps") < 150_000, "{} steps", number("steps"));
}

#[test]
fn selection_takes_no_more_than_a_tenth_of_the_episodes() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let generations = tpg_testing::amount("12", "30");
    for preset in ["kelly", "general"] {
        let folder = place.path().join(preset);
        let mut command = Command::new(env!("CARGO_BIN_EXE_tpg-train"));
        command
            .args(["tpg", "--problem", "cartpole", "--preset", preset, "--generations", generations, "--out"])
            .arg(&folder);
        assert!(command.stderr(Stdio::null()).status().expect("it runs").success());
        let state = state(&folder);
        let number = |key: &str| state[key].as_u64().expect("a count");
        let (training, selection) = (number("training_episodes"), number("selection_episodes"));
        assert!(10 * selection <= training + selection && selection > 0, "{preset}: {selection} beside {training}");
    }
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
    let text = Preset::find("polar-fs").expect("it comes with the trainer").text();
    let line_of = |start: &str| text.lines().position(|line| line.starts_with(start)).expect("the key") + 1;
    let wrong = |from: &str, to: &str| {
        let changed: Vec<&str> = text.lines().map(|line| if line.starts_with(from) { to } else { line }).collect();
        let text = changed.join("\n");
        let of_problem = || Problem::from_toml("c.toml", &text).err();
        EvolutionConfig::from_toml("c.toml", &text).err().or_else(of_problem).expect("it is wrong").to_string()
    };
    // Also checks the line of a key in a nested section.
    let arm = text.to_owned() + &ARMS[0].text.replace("elbow_offset = 49.0", "elbow_offset = -1.0");
    let line = arm.lines().position(|line| line.starts_with("elbow_offset")).expect("the key") + 1;
    let error = Problem::from_toml("c.toml", &arm).expect_err("it is wrong").to_string();
    assert_eq!(error, format!("c.toml: line {line}: problem.arm.links.elbow_offset = -1; accepted: 0 to 1000 mm"));
    for (from, to, found, accepted) in [
        ("p_swap", "p_swop = 1.0", "unknown field `p_swop`", "p_swap"),
        ("p_edge_deletion", "p_edge_deletion = 1.5", "tpg.p_edge_deletion = 1.5", "0 to 1"),
        ("nb_roots", "nb_roots = \"many\"", "invalid type", "tpg-train config"),
        ("sources", "sources = [\"polar\", \"smell\"]", "\"smell\"", "reach_excess"),
        ("instructions", "instructions = [\"add\", \"add\"]", "\"add\"", "each once"),
        ("p_program_mutation", "p_program_mutation = 0.0", "tpg.p_program_mutation = 0", "0.001 to 1"),
        ("max_outgoing_edges", "max_outgoing_edges = 2", "tpg.max_outgoing_edges = 2", "3 to"),
        ("share", "share = 0.5", "pool.share = 0.5", "pool.size"),
        ("shield", "shield = \"walls\"", "unknown variant `walls`", "tpg-train config"),
        ("sources", "sources = [\"polar\", \"shield_limits\"]", "\"shield_limits\"", "one or more of"),
        ("generations", "generations = 100000", "curriculum.generations = 100000", "0 to"),
        ("roughness", "roughness = 128", "curriculum.roughness = 128", "1 to 127"),
    ] {
        let error = wrong(from, to);
        assert!(error.starts_with(&format!("c.toml: line {}: ", line_of(from))), "{error}");
        assert!(error.contains(found) && error.contains(accepted), "{error}");
    }
    let frugal =
        Preset::find("frugal").expect("it comes with the trainer").text().replace("\nrandom = 0.0", "\nrandom = 0.5");
    let error = EvolutionConfig::from_toml("c.toml", &frugal).expect_err("above the share of all searches").to_string();
    assert!(error.contains("start.random = 0.5; accepted: 0 to 0.4"), "{error}");
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
        let more = ["--threads", "1", "--lanes", "1", "--checkpoint-seconds", "1000000"];
        // The configuration is written when training begins.
        let (code, stderr) = stopped(&folder, &config, &more, "config.toml", name);
        assert_eq!(code, Some(130), "{stderr}");
        assert!(stderr.contains("--resume"), "{stderr}");
        let rows = fs::read_to_string(folder.join("generations.csv")).expect("the log").lines().count();
        // The signal may come before the first generation ends.
        assert!((1..26).contains(&rows), "a header and some generations, not {rows} rows");
        assert!(train(&folder, &config, &["--resume"]).status().expect("it runs").success());
        assert!(results(&folder) == results(&undisturbed), "{name}: other bytes");
    }
}

/// A preset with two small demes, of which one begins with what four generations of search have found.
fn small(preset: &str) -> EvolutionConfig {
    let mut config = Preset::find(preset).expect("it comes with the trainer").config().expect("it is accepted");
    (config.tpg.nb_roots, config.tpg.init_nb_roots, config.demes.count) = (30, 60, 2);
    (config.start.generations, config.start.searches, config.start.demes) = (4, 2, 1);
    config
}

/// A policy that computes the torque: leaves, teams and refined numbers, two demes with migration.
#[test]
fn a_policy_with_outputs_has_the_same_bytes_on_other_threads_and_after_a_stop() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let path = place.path().join("config.toml");
    let mut config = small("continuous");
    (config.demes.migration_interval, config.learning.nb_generations) = (5, 25);
    (config.leaves.p_edge_addition, config.leaves.p_team) = (0.3, 0.3);
    config.selection.validation_episodes = 30;
    config.problem = Problem::usual(ProblemName::Pendulum).to_table();
    fs::write(&path, config.to_toml()).expect("it can be written");
    let [one, other, stopped] = ["one", "other", "stopped"].map(|name| place.path().join(name));
    assert!(train(&one, &path, &["--threads", "1"]).status().expect("it runs").success());
    assert!(train(&other, &path, &["--threads", "3", "--lanes", "5"]).status().expect("it runs").success());
    assert!(results(&one) == results(&other), "threads and lanes change nothing");
    let checkpoints = ["--checkpoint-seconds", "0", "--lanes", "1"];
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
    let mut config = small("continuous");
    (config.demes.migration_interval, config.learning.nb_generations) = (5, 8);
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
    assert!(train(&other, &path, &["--threads", "3", "--lanes", "5"]).status().expect("it runs").success());
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
    config.problem = Problem::usual(ProblemName::Acrobot).to_table();
    fs::write(&path, config.to_toml()).expect("it can be written");
    let said = refusal(train(&place.path().join("run"), &path, &[]));
    assert!(said.contains("language.memory") && said.contains("a problem without outputs"), "{said}");
}

/// A linear start in one of two demes, of which the worse one ends, for outputs, products and named actions; units from
/// visited states: searches, what stalled before them, and demes are part of the checkpoint.
#[test]
fn a_linear_start_has_the_same_bytes_on_other_threads_and_after_kills() {
    // With a share of the steps, milestones and the choice among policies within doubt are part of it, too.
    for (name, problem, kind, share, deviation) in [
        ("outputs", ProblemName::Pendulum, StartKind::Linear, 0.0, 0.5),
        ("products", ProblemName::Pendulum, StartKind::Product, 0.0, 0.5),
        ("actions", ProblemName::Acrobot, StartKind::Linear, 0.0, 0.5),
        ("steps", ProblemName::Pendulum, StartKind::Linear, 0.5, 0.5),
        ("new searches", ProblemName::Pendulum, StartKind::Linear, 1.0, 1e-6),
        ("random search", ProblemName::Pendulum, StartKind::Linear, 0.5, 0.5),
        ("random search of actions", ProblemName::Acrobot, StartKind::Linear, 0.5, 0.5),
    ] {
        let place = tempfile::tempdir().expect("a temporary folder");
        let path = place.path().join("config.toml");
        let mut config = Preset::find("linear").expect("it comes with the trainer").config().expect("it is accepted");
        (config.tpg.nb_roots, config.tpg.init_nb_roots, config.demes.count) = (20, 30, 2);
        (config.start.generations, config.start.demes, config.demes.migration_interval) = (12, 1, 5);
        (config.learning.nb_generations, config.selection.validation_episodes) = (24, 30);
        (config.demes.halving_interval, config.literals.units) = (6, Units::Visited);
        (config.refinement.p_mutation, config.start.kind) = (0.5, kind);
        config.start.share = [0.5 * share, share];
        config.start.deviation = deviation;
        config.selection.choice_errors = 2.0 * share;
        let is_random = name.starts_with("random");
        config.start.random = if is_random { 0.25 } else { 0.0 };
        config.start.episode_for = if name == "random search" { EpisodeFor::Pair } else { EpisodeFor::Sample };
        let steps = match (share == 0.5, is_random) {
            (true, true) => "100000",
            (true, false) => "200000",
            (false, _) => "1000000000000",
        };
        let begins_anew = share == 1.0 || is_random;
        if share == 1.0 {
            // Equal samples: some generation is the best of the ten after it.
            (config.start.generations, config.learning.nb_generations) = (2, 40);
        }
        let train = |folder: &Path, more: &[&str]| train(folder, &path, &[more, &["--max-steps", steps]].concat());
        config.problem = Problem::usual(problem).to_table();
        fs::write(&path, config.to_toml()).expect("it can be written");
        let [one, other] = ["one", "other"].map(|name| place.path().join(name));
        assert!(train(&one, &["--threads", "1"]).status().expect("it runs").success());
        assert!(train(&other, &["--threads", "3", "--lanes", "5"]).status().expect("it runs").success());
        assert!(results(&one) == results(&other), "{name}: threads and lanes change nothing");
        let checkpoint = fs::read(one.join("checkpoint")).expect("it is there");
        let has = |key: &str| String::from_utf8_lossy(&checkpoint).contains(key);
        assert_eq!((has("\"stalled\""), has("\"random\"")), (begins_anew, is_random), "{name}");
        // Stopped in the first half of the start, in the second half, at its end, and after it.
        let stopped = place.path().join("stopped");
        for generations in ["3", "9", "12", "15"] {
            let arguments = ["--checkpoint-seconds", "0", "--lanes", "1", "--resume"];
            let mut run = train(&stopped, &arguments).spawn().expect("it starts");
            let rows = stopped.join("generations.csv");
            let done = || fs::read_to_string(&rows).map_or(0, |text| text.lines().count().saturating_sub(1));
            while done() < generations.parse().expect("a number") && run.try_wait().expect("a child").is_none() {
                sleep(Duration::from_millis(1));
            }
            run.kill().expect("it can be killed");
            run.wait().expect("it ends");
        }
        assert!(train(&stopped, &["--resume"]).status().expect("it runs").success());
        assert!(results(&one) == results(&stopped), "{name}: kills change nothing");
    }
}

/// Writes a configuration that gives half of its steps to a random search, and none to other searches.
fn write_random_search(path: &Path, problem: ProblemName, generations: u64) {
    let mut config = small("frugal");
    config.problem = Problem::usual(problem).to_table();
    (config.start.random, config.start.share, config.learning.nb_generations) = (0.5, [0.5, 0.5], generations);
    fs::write(path, config.to_toml()).expect("it can be written");
}

#[test]
fn a_random_search_that_is_resumed_without_a_number_of_steps_ends_after_its_generations() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let (path, folder) = (place.path().join("config.toml"), place.path().join("run"));
    write_random_search(&path, ProblemName::Pendulum, 30);
    let mut run = train(&folder, &path, &["--max-steps", "1000000000000", "--checkpoint-seconds", "0"])
        .spawn()
        .expect("it starts");
    let rows = || fs::read_to_string(folder.join("generations.csv")).map_or(0, |text| text.lines().count());
    while rows() < 4 && run.try_wait().expect("a child").is_none() {
        sleep(Duration::from_millis(1));
    }
    run.kill().expect("it can be killed");
    run.wait().expect("it ends");
    assert!(train(&folder, &path, &["--resume"]).status().expect("it runs").success());
    let text = fs::read_to_string(folder.join("checkpoint")).expect("it is there");
    assert!(text.contains("\"stalled\"") && text.contains("\"random\""), "what it has found is kept");
    let text = fs::read_to_string(folder.join("graph.json")).expect("a graph");
    tpg_graph::Graph::from_json("graph.json", &text).expect("a valid graph");
}

#[test]
fn samples_of_a_random_search_share_episodes_as_the_configuration_says() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let path = place.path().join("config.toml");
    write_random_search(&path, ProblemName::Pendulum, 6);
    let text = fs::read_to_string(&path).expect("it was written");
    let rows = |who: &str| {
        let folder = place.path().join(who);
        fs::write(&path, text.replace("[start]\n", &format!("[start]\nepisode_for = \"{who}\"\n"))).expect("written");
        assert!(train(&folder, &path, &["--max-steps", "1000000"]).status().expect("it runs").success());
        fs::read_to_string(folder.join("generations.csv")).expect("the log")
    };
    let [sample, pair, generation] = ["sample", "pair", "generation"].map(rows);
    assert!(sample != pair && pair != generation && sample != generation, "{sample}{pair}{generation}");
    fs::write(&path, text.replace("[start]\n", "[start]\nepisode_for = \"deme\"\n")).expect("written");
    let said = refusal(train(&place.path().join("deme"), &path, &[]));
    assert!(said.contains("deme") && said.contains("`pair`"), "{said}");
}

/// Sums of the inputs balance a pole on a cart, and cannot swing a pendulum up.
#[test]
fn a_random_search_that_gets_nowhere_ends_early() {
    for (problem, is_good) in [(ProblemName::Pendulum, false), (ProblemName::Cartpole, true)] {
        let place = tempfile::tempdir().expect("a temporary folder");
        let (path, folder) = (place.path().join("config.toml"), place.path().join("run"));
        write_random_search(&path, problem, 1000);
        assert!(train(&folder, &path, &["--max-steps", "1000000"]).status().expect("it runs").success());
        let steps = state(&folder)["milestones"]["begun"]["steps"].as_u64().expect("where another search began");
        assert_eq!(steps >= 500_000, is_good, "{problem:?}: another search began after {steps} steps");
    }
}

#[test]
fn a_run_without_progress_ends_and_lines_have_their_price() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let mut config = small("continuous");
    config.demes.count = 1;
    (config.learning.nb_generations, config.selection.validation_episodes) = (400, 30);
    config.problem = Problem::usual(ProblemName::Pendulum).to_table();
    config.selection.flat_after = 3;
    let mut sizes = Vec::new();
    // With the price of 1 a line costs the whole way to the best score.
    for price in [0.0, 1.0] {
        config.selection.line_price = price;
        let (path, folder) = (place.path().join("config.toml"), place.path().join(format!("price-{price}")));
        fs::write(&path, config.to_toml()).expect("it can be written");
        assert!(train(&folder, &path, &[]).status().expect("it runs").success());
        let text = fs::read_to_string(folder.join("generations.csv")).expect("the log");
        let is_number = |row: &str| row.split(',').nth(8).is_some_and(|field| field.parse::<f64>().is_ok());
        let validated: Vec<bool> = text.lines().skip(1).map(is_number).collect();
        assert!(validated.len() < 400, "it ends by itself");
        assert!(validated.last() == Some(&true), "after a validation");
        let text = fs::read_to_string(folder.join("graph.json")).expect("a graph");
        let graph = tpg_graph::Graph::from_json("graph.json", &text).expect("a valid graph");
        sizes.push(graph.programs().iter().map(|program| program.lines.len()).sum::<usize>());
    }
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

    let text = fs::read_to_string(all.join("restarts.csv")).expect("the table of restarts");
    let rows: Vec<Vec<f64>> = text.lines().skip(1).map(numbers).collect();
    assert_eq!(rows.iter().map(|row| row[0]).collect::<Vec<_>>(), [1.0, 2.0, 3.0]);
    // Ranked by mean score, as on a pendulum; ties go to the first.
    let best = rows.iter().rev().max_by(|a, b| a[2].total_cmp(&b[2])).expect("three rows")[0];
    let graph = |path: &Path| fs::read(path.join("graph.json")).expect("a graph");
    assert!(graph(&all) == graph(&all.join(format!("seed-{best}"))), "the best restart is seed {best}");

    let arguments = ["--seeds", "1..4", "--checkpoint-seconds", "0", "--resume"];
    let mut run = train(&stopped, &config, &arguments).spawn().expect("it starts");
    wait_for(&stopped.join("seed-2/checkpoint"));
    run.kill().expect("it can be killed");
    run.wait().expect("it ends");
    assert!(train(&stopped, &config, &arguments).status().expect("it runs").success());
    for seed in 1..4 {
        let of = |folder: &Path| results(&folder.join(format!("seed-{seed}")));
        assert!(of(&stopped) == of(&all), "seed {seed}, resumed, gives other bytes");
    }
    assert!(graph(&stopped) == graph(&all) && fs::read_to_string(stopped.join("restarts.csv")).ok() == Some(text));
}

/// Parses the numbers of a row; a pendulum defines no success, so that field is empty.
fn numbers(row: &str) -> Vec<f64> {
    row.split(',').filter(|field| !field.is_empty()).map(|number| number.parse().expect("a number")).collect()
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

    stopped(&folder, &config, &["--checkpoint-seconds", "0", "--lanes", "1"], "checkpoint", "KILL");
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
