//! Runs end in the same bytes, however often they are killed and on however many threads; bad input is refused.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Instant;
use tpg_train::evolution::config::Config;
use tpg_train::evolution::presets::Preset;
use tpg_train::random::{Purpose, Stream};

/// A run of seconds that uses all there is: two demes with migration, pool, archive, lexicase, racing.
fn small_config() -> Config {
    let mut config = Preset::find("best-rs").expect("it comes with the trainer").config().expect("it is accepted");
    config.problem.environment =
        toml::from_str::<toml::Table>("e = \"pendulum\"").expect("TOML")["e"].clone().try_into().expect("a pendulum");
    config.problem.sources = vec!["pendulum".to_owned()];
    (config.tpg.nb_roots, config.tpg.init_nb_roots, config.tpg.max_init_outgoing_edges) = (24, 40, 3);
    (config.demes.count, config.demes.migration_interval, config.demes.migrants) = (2, 3, 1);
    (config.pool.size, config.pool.share) = (20, 0.3);
    (config.learning.archive_size, config.learning.archiving_probability) = (20, 0.5);
    (config.learning.nb_iterations_per_policy_evaluation, config.learning.nb_generations) = (12, 25);
    (config.learning.ratio_deleted_roots, config.learning.max_nb_actions_per_eval) = (0.7, 100);
    (config.selection.lexicase_survivors, config.selection.racing_episodes) = (3, 4);
    (config.curriculum.generations, config.curriculum.roughness) = (6, 3);
    (config.selection.validation_interval, config.selection.validation_episodes) = (5, 30);
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

/// Everything but the times.
fn results(folder: &Path) -> Vec<(String, Vec<u8>)> {
    ["graph.json", "generations.csv", "generations.jsonl", "checkpoint.json", "config.toml"]
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

    let killed = place.path().join("killed");
    let arguments = ["--threads", "1", "--checkpoint-seconds", "0", "--resume"];
    let mut stream = Stream::new(1, 0, Purpose::Test, 0);
    let mut kills = 0;
    for _ in 0..20 {
        let mut run: Child = train(&killed, &config, &arguments).spawn().expect("it starts");
        // At most a quarter of a whole run, so that the first one is killed on a fast machine too.
        sleep(whole / 400 * stream.between(1, 100) as u32);
        // SIGKILL: the program cannot do anything about it.
        run.kill().expect("it can be killed");
        kills += u32::from(!run.wait().expect("it ends").success());
    }
    assert!(kills > 0, "no run was killed before its end");
    assert!(train(&killed, &config, &arguments).status().expect("it runs").success());
    assert!(results(&killed) == expected, "a resumed run gives other bytes");

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
    let other = refusal(train(&folder, &config, &["--generations", "3", "--resume"]));
    assert!(
        other.contains("- learning.nbGenerations = 2") && other.contains("+ learning.nbGenerations = 3"),
        "{other}"
    );
    assert!(refusal(train(&folder, &config, &["--generations", "2", "--resume", "--seed", "9"])).contains("seed 1"));
    assert!(results(&folder) == before, "a refused run changes nothing");
}

#[test]
fn a_folder_that_cannot_be_written_is_an_error() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let config = place.path().join("config.toml");
    fs::write(&config, small_config().to_toml()).expect("it can be written");
    let file = place.path().join("file");
    fs::write(&file, "in the way").expect("it can be written");
    assert!(refusal(train(&file.join("run"), &config, &[])).contains("file/run"));
}

#[test]
fn a_bad_configuration_is_refused_with_its_line_and_what_is_accepted() {
    let text = Preset::find("best-fs").expect("it comes with the trainer").text;
    let line_of = |start: &str| text.lines().position(|line| line.starts_with(start)).expect("the key") + 1;
    let wrong = |from: &str, to: &str| {
        let changed: Vec<&str> = text.lines().map(|line| if line.starts_with(from) { to } else { line }).collect();
        Config::from_toml("c.toml", &changed.join("\n")).expect_err("it is wrong").to_string()
    };
    for (from, to, found, accepted) in [
        ("pSwap", "pSwop = 1.0", "unknown field `pSwop`", "pSwap"),
        ("pEdgeDeletion", "pEdgeDeletion = 1.5", "tpg.pEdgeDeletion = 1.5", "0 to 1"),
        ("nbRoots", "nbRoots = \"many\"", "invalid type", "tpg-train config"),
        ("sources", "sources = [\"polar\", \"smell\"]", "\"smell\"", "reach_excess"),
        ("instructions", "instructions = [\"add\", \"add\"]", "\"add\"", "each once"),
        ("pProgramMutation", "pProgramMutation = 0.0", "tpg.pProgramMutation = 0", "0.001 to 1"),
        ("maxOutgoingEdges", "maxOutgoingEdges = 2", "tpg.maxOutgoingEdges = 2", "3 to"),
        ("share", "share = 0.5", "pool.share = 0.5", "pool.size"),
        ("shield", "shield = \"walls\"", "unknown variant `walls`", "tpg-train config"),
        ("sources", "sources = [\"polar\", \"shield_limits\"]", "\"shield_limits\"", "one or more of"),
        ("generations", "generations = 100000", "curriculum.generations = 100000", "0 to"),
        ("roughness", "roughness = 43", "curriculum.roughness = 43", "1 to 42"),
    ] {
        let error = wrong(from, to);
        assert!(error.starts_with(&format!("c.toml: line {}: ", line_of(from))), "{error}");
        assert!(error.contains(found) && error.contains(accepted), "{error}");
    }
}
