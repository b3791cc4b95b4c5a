//! The table of sensor faults: as C, and what this machine's Rust does with it.

use crate::Failure;
use crate::faults::{self, Log};
use crate::line::Line;
use crate::scenarios::{FAR_TARGET, GOOD_TARGET, Phase, Reading, SCENARIOS, Scenario, Target};
use std::fmt::Write as _;
use tpg_arm::hybrid::Hybrid;
use tpg_arm::observation::Observation;
use tpg_arm::{Move, Pose};
use tpg_codegen::emit::File;
use tpg_runtime::policy::Policy;

/// Names of the readings in C, in order; joint and amount of one.
fn reading(reading: Reading) -> (&'static str, u8, i16) {
    match reading {
        Reading::Good => ("READING_GOOD", 0, 0),
        Reading::Stuck => ("READING_STUCK", 0, 0),
        Reading::JointStuck(joint) => ("READING_JOINT_STUCK", joint, 0),
        Reading::Late(late) => ("READING_LATE", 0, i16::from(late)),
        Reading::Jump(joint, by) => ("READING_JUMP", joint, by),
        Reading::Fixed(joint, value) => ("READING_FIXED", joint, value),
        Reading::Flicker(joint, value) => ("READING_FLICKER", joint, value),
        Reading::HandNan => ("READING_HAND_NAN", 0, 0),
        Reading::DifferenceInfinite => ("READING_DIFFERENCE_INFINITE", 0, 0),
        Reading::HandOff => ("READING_HAND_OFF", 0, 0),
        Reading::HandInfinite => ("READING_HAND_INFINITE", 0, 0),
    }
}

fn target(target: Target) -> &'static str {
    match target {
        Target::Good => "TARGET_GOOD",
        Target::Nan => "TARGET_NAN",
        Target::Infinite => "TARGET_INFINITE",
        Target::Huge => "TARGET_HUGE",
        Target::Far => "TARGET_FAR",
    }
}

/// `faults.h`.
pub(crate) fn file() -> File {
    let mut text = String::from(
        "#ifndef FAULTS_H\n#define FAULTS_H\n\n#include \"tpg_runtime.h\"\n\n#include <stdbool.h>\n\n\
         typedef enum reading {\n    READING_GOOD, READING_STUCK, READING_JOINT_STUCK, READING_LATE, READING_JUMP, \
         READING_FIXED, READING_FLICKER,\n    READING_HAND_NAN, READING_DIFFERENCE_INFINITE, READING_HAND_OFF, \
         READING_HAND_INFINITE\n} reading_t;\n\n\
         typedef enum aim { TARGET_GOOD, TARGET_NAN, TARGET_INFINITE, TARGET_HUGE, TARGET_FAR } aim_t;\n\n\
         typedef struct phase {\n    uint16_t steps;\n    reading_t reading;\n    uint8_t joint;\n    int16_t amount;\n    \
         aim_t target;\n    bool resume;\n    int32_t code;\n    uint16_t within;\n} phase_t;\n\n\
         typedef struct scenario {\n    const char *name;\n    tpg_watch_t watch;\n    const phase_t *phases;\n    \
         size_t count;\n} scenario_t;\n\n",
    );
    for (name, [x, y, z]) in [("GOOD_TARGET", GOOD_TARGET), ("FAR_TARGET", FAR_TARGET)] {
        let _ = writeln!(text, "#define {name} {{ {x:?}F, {y:?}F, {z:?}F }}");
    }
    let _ = writeln!(text, "#define SCENARIOS {}U\n", SCENARIOS.len());
    for (index, scenario) in SCENARIOS.iter().enumerate() {
        let _ = writeln!(text, "static const phase_t phases_{index}[] = {{");
        for &Phase { steps, reading: read, target: aim, resume, code, within } in scenario.phases {
            let (read, joint, amount) = reading(read);
            let _ = writeln!(
                text,
                "    {{ {steps}U, {read}, {joint}U, {amount}, {}, {resume}, {code}, {within}U }},",
                target(aim)
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
pub(crate) fn check(language: &str, expected: &[Line], lines: &[Line]) -> Result<(), Failure> {
    let found: Vec<&Line> =
        lines.iter().filter(|line| line.words.first().is_some_and(|word| word == "fault")).collect();
    if found.len() != SCENARIOS.len() || expected.len() != SCENARIOS.len() {
        return Err(Failure::new(format!("{language}: {} scenarios of faults, not {}", found.len(), SCENARIOS.len())));
    }
    for (found, expected) in found.iter().zip(expected) {
        if found.values.get("broken").is_none_or(|step| step != "0") {
            return Err(Failure::new(format!("{language} breaks the sensor contract: {found:?}")));
        }
        if *found != expected {
            return Err(Failure::new(format!("{language} is not the host: {found:?}, not {expected:?}")));
        }
    }
    let steps = |name: &str| found.iter().map(|line| line.number(name)).sum::<u64>();
    println!(
        "{language}: {} scenarios of sensor faults keep the contract: {} steps OK, {} TPG_BAD_TARGET, {} TPG_BAD_SENSOR, \
         {} TPG_STUCK",
        found.len(),
        steps("ok"),
        steps("target"),
        steps("sensor"),
        steps("stuck")
    );
    Ok(())
}
