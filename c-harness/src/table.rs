//! The table of sensor faults: as C, and what this machine's Rust does with it.

use crate::Failure;
use crate::data;
use crate::expected;
use crate::faults::{self, Log};
use crate::line::Line;
use crate::scenarios::{FAR_TARGET, GOOD_TARGET, Phase, SCENARIOS, Scenario};
use std::fmt::Write as _;
use tpg_arm::hybrid::Hybrid;
use tpg_arm::observation::Observation;
use tpg_arm::{Move, Pose};
use tpg_codegen::emit::File;
use tpg_runtime::policy::Policy;

/// `faults.h`: the table as values of the types in `scenarios.h`.
pub(crate) fn file() -> File {
    let mut text = String::from("#ifndef FAULTS_H\n#define FAULTS_H\n\n#include \"scenarios.h\"\n\n");
    for (name, target) in [("GOOD_TARGET", GOOD_TARGET), ("FAR_TARGET", FAR_TARGET)] {
        let _ = writeln!(text, "#define {name} {}", data::list(&target));
    }
    let _ = writeln!(text, "#define SCENARIOS {}U\n", SCENARIOS.len());
    for (index, scenario) in SCENARIOS.iter().enumerate() {
        let _ = writeln!(text, "static const phase_t phases_{index}[] = {{");
        for &Phase { steps, reading, joint, amount, target, resume, code, within } in scenario.phases {
            let _ = writeln!(
                text,
                "    {{ {steps}U, READING_{reading:?}, {joint}U, {amount}, TARGET_{target:?}, {resume}, {code}, {within}U }},"
            );
        }
        text.push_str("};\n");
    }
    text.push_str("\nstatic const scenario_t scenarios[SCENARIOS] = {\n");
    for (index, Scenario { name, watch: (threshold, patience), phases }) in SCENARIOS.iter().enumerate() {
        let count = phases.len();
        let _ = writeln!(text, "    {{ \"{name}\", {{ {threshold}U, {patience}U }}, phases_{index}, {count}U }},");
    }
    text.push_str("};\n\n#endif\n");
    File { name: "faults.h".to_owned(), text }
}

/// The lines of every scenario in Rust, on this machine.
pub(crate) fn lines<T, P>(hybrid: &Hybrid<'_, f32, T, P>) -> Vec<Line>
where
    T: Policy<State = Observation<f32>, Action = Move>,
    P: Policy<State = Observation<f32>, Action = Move>,
{
    let line = |scenario: &Scenario| {
        let Log { codes: [ok, target, sensor, stuck], broken, actions: [graph, network], motors, hash } =
            faults::run(hybrid, scenario);
        let Pose([base, shoulder, elbow, wrist]) = motors;
        Line::parse(&format!(
            "fault {} ok={ok} target={target} sensor={sensor} stuck={stuck} broken={broken} graph={graph} \
             network={network} base={base} shoulder={shoulder} elbow={elbow} wrist={wrist} log={:016x}",
            scenario.name, hash.0
        ))
    };
    SCENARIOS.iter().map(line).collect()
}

/// Every scenario keeps the contract, and does the same as in this machine's Rust.
pub(crate) fn check(place: &str, lines: &[Line]) -> Result<(), Failure> {
    let found: Vec<&Line> = lines.iter().filter(|line| line.starts_with("fault")).collect();
    let expected = expected::faults();
    if found.len() != expected.len() {
        return Err(Failure(format!("{place}: {} scenarios of faults, not {}", found.len(), expected.len())));
    }
    for (found, expected) in found.iter().zip(&expected) {
        if found.values.get("broken").is_none_or(|step| step != "0") {
            return Err(Failure(format!("{place} breaks the sensor contract: {found:?}")));
        }
        if *found != expected {
            return Err(Failure(format!("{place} is not the host: {found:?}, not {expected:?}")));
        }
    }
    let [ok, target, sensor, stuck] =
        ["ok", "target", "sensor", "stuck"].map(|name| found.iter().map(|line| line.number(name)).sum::<u64>());
    println!(
        "{place}: {} scenarios of sensor faults keep the contract: {ok} steps OK, {target} TPG_BAD_TARGET, {sensor} \
         TPG_BAD_SENSOR, {stuck} TPG_STUCK",
        found.len()
    );
    Ok(())
}
