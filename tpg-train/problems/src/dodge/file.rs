//! Lists of scenes as CSV files: a line for each, with the plan that solves it.

use super::draw::Certified;
use super::scene::{Path, Scene};
use super::walk::{GOALS, Leg};
use csv::{ReaderBuilder, StringRecord, Writer};
use std::fmt::Display;
use std::fs;
use std::path;
use std::str::FromStr;
use tpg_arm::dodge::BALLS;
use tpg_arm::{JOINTS, Pose, WIDOWX};
use tpg_graph::error::{InputError, Place};

/// Start, ticks; target, mm; goals, ticks; balls: both ends (mm), radius (mm), period (steps), phase, 1 for sinusoidal; the
/// plan: poses (ticks), each with the steps to wait there. Numbers are separated by spaces, items by semicolons.
const HEADER: [&str; 5] = ["start", "target_mm", "goals", "balls", "plan"];
/// Numbers of a ball.
const BALL: usize = 10;

/// Writes scenes as CSV, with the shortest digits that give the same numbers.
///
/// # Panics
/// Never: memory can be written.
pub fn to_csv(scenes: &[Certified]) -> String {
    let mut writer = Writer::from_writer(Vec::new());
    writer.write_record(HEADER).expect("memory can be written");
    for Certified { scene, plan } in scenes {
        let balls = scene.balls.iter().map(|ball| {
            let Path { from, to, radius, period, phase, sine } = *ball;
            let ends = [from, to].concat();
            numbers(ends.into_iter().chain([radius, period, phase, f32::from(u8::from(sine))]))
        });
        let plan = plan.iter().map(|leg| numbers(leg.to.0.map(i32::from).into_iter().chain([leg.wait.into()])));
        let fields = [
            numbers(scene.start),
            numbers(scene.target),
            items(scene.goals.iter().map(|goal| numbers(*goal))),
            items(balls),
            items(plan),
        ];
        writer.write_record(fields).expect("memory can be written");
    }
    String::from_utf8(writer.into_inner().expect("memory can be written")).expect("numbers are text")
}

fn numbers<T: Display>(values: impl IntoIterator<Item = T>) -> String {
    values.into_iter().map(|value| value.to_string()).collect::<Vec<_>>().join(" ")
}

fn items(items: impl Iterator<Item = String>) -> String {
    items.collect::<Vec<_>>().join(";")
}

/// Reads a file that [`to_csv`] wrote.
///
/// # Errors
/// If the file cannot be read, has another header, or a value that is not accepted, with its line.
pub fn read_csv(path: &path::Path) -> Result<Vec<Certified>, InputError> {
    let text = fs::read_to_string(path).map_err(|error| InputError::io(path, &error, "a file of scenes"))?;
    parse_csv(&path.display().to_string(), &text)
}

/// Reads the text of such a file.
///
/// # Errors
/// As [`read_csv`].
pub fn parse_csv(file: &str, text: &str) -> Result<Vec<Certified>, InputError> {
    let mut reader = ReaderBuilder::new().flexible(true).from_reader(text.as_bytes());
    let refuse =
        |line: usize, found: String, accepted: String| InputError::new(file, Place::Line(line), found, accepted);
    let unreadable = |error: csv::Error| {
        let line = error.position().map_or(1, |position| position.line() as usize);
        refuse(line, error.to_string(), "comma-separated text in UTF-8".to_owned())
    };
    let header = reader.headers().map_err(unreadable)?;
    if header != HEADER.as_slice() {
        let found = format!("{:?}", header.iter().collect::<Vec<_>>().join(","));
        return Err(refuse(1, found, format!("the header {}", HEADER.join(","))));
    }
    let mut scenes = Vec::new();
    for record in reader.records() {
        let record = record.map_err(unreadable)?;
        let line = record.position().map_or(0, csv::Position::line) as usize;
        scenes.push(certified(&record).map_err(|(found, accepted)| refuse(line, found, accepted))?);
    }
    Ok(scenes)
}

/// The thing found, and the things accepted instead.
type DodgeRefusal = (String, String);

fn certified(record: &StringRecord) -> Result<Certified, DodgeRefusal> {
    let fields: Vec<&str> = record.iter().collect();
    let Ok([start, target, goals, balls, plan]) = <[&str; HEADER.len()]>::try_from(fields) else {
        return Err((format!("{} fields", record.len()), format!("{} fields", HEADER.len())));
    };
    let pose = |text: &str| array::<i16, JOINTS>(text, "ticks").and_then(on_the_arm);
    let goals = goals.split(';').map(pose).collect::<Result<Vec<_>, _>>()?;
    let balls = balls.split(';').map(ball).collect::<Result<Vec<_>, _>>()?;
    let plan = plan.split(';').map(leg).collect::<Result<Vec<_>, _>>()?;
    if goals.len() > GOALS {
        return Err((format!("{} goals", goals.len()), format!("at most {GOALS}")));
    }
    if balls.len() > BALLS {
        return Err((format!("{} balls", balls.len()), format!("at most {BALLS}")));
    }
    let target = array::<f32, 3>(target, "mm").and_then(finite)?;
    Ok(Certified { scene: Scene { start: pose(start)?, target, goals, balls }, plan })
}

fn ball(text: &str) -> Result<Path, DodgeRefusal> {
    let [ax, ay, az, bx, by, bz, radius, period, phase, sine] =
        array::<f32, BALL>(text, "mm, steps").and_then(finite)?;
    if radius <= 0.0 || period < 0.0 || !(0.0..=1.0).contains(&phase) || (sine != 0.0 && sine != 1.0) {
        let accepted = "a radius above 0, a period of at least 0, a phase from 0 to 1, and 0 or 1 for sinusoidal";
        return Err((format!("{text:?}"), accepted.to_owned()));
    }
    Ok(Path { from: [ax, ay, az], to: [bx, by, bz], radius, period, phase, sine: sine == 1.0 })
}

fn leg(text: &str) -> Result<Leg, DodgeRefusal> {
    let [base, shoulder, elbow, wrist, wait] = array::<i16, { JOINTS + 1 }>(text, "ticks and steps")?;
    let to = on_the_arm([base, shoulder, elbow, wrist])?;
    let wait = u16::try_from(wait).map_err(|_| (wait.to_string(), "at least 0 steps to wait".to_owned()))?;
    Ok(Leg { to: Pose(to), wait })
}

fn array<T: FromStr, const N: usize>(text: &str, unit: &str) -> Result<[T; N], DodgeRefusal> {
    let values: Option<Vec<T>> = text.split(' ').map(|value| value.parse().ok()).collect();
    let values = values.and_then(|values| values.try_into().ok());
    values.ok_or_else(|| (format!("{text:?}"), format!("{N} numbers ({unit}), separated by single spaces")))
}

fn finite<const N: usize>(values: [f32; N]) -> Result<[f32; N], DodgeRefusal> {
    match values.iter().find(|value| !value.is_finite()) {
        Some(value) => Err((value.to_string(), "finite numbers".to_owned())),
        None => Ok(values),
    }
}

fn on_the_arm(pose: [i16; JOINTS]) -> Result<[i16; JOINTS], DodgeRefusal> {
    match pose.iter().zip(&WIDOWX.ranges).find(|&(&ticks, range)| !range.contains(ticks)) {
        Some((ticks, range)) => Err((ticks.to_string(), format!("ticks from {} to {}", range.min, range.max))),
        None => Ok(pose),
    }
}

#[cfg(test)]
mod tests {
    use super::{parse_csv, to_csv};
    use crate::arm::targets::Set;
    use crate::dodge::Config;
    use crate::dodge::draw::scenes;
    use tpg_graph::error::Place;

    #[test]
    fn csv_gives_back_the_same_scenes() {
        let list = scenes(&Config::default(), 7, Set::Training, 8, 1500);
        assert_eq!(parse_csv("scenes.csv", &to_csv(&list)), Ok(list));
    }

    #[test]
    fn a_wrong_file_is_refused_with_its_place() {
        let ball = "100 100 100 200 200 200 30 100 0.5 1";
        let row = |ball: &str, plan: &str| format!("2048 2048 2048 2048,1 2 3,2048 2048 2048 2048,{ball},{plan}\n");
        let good = format!("start,target_mm,goals,balls,plan\n{}", row(ball, "2048 2048 2048 2048 7"));
        assert!(parse_csv("scenes.csv", &good).is_ok());
        for (wrong, line) in [
            (good.replace("plan", "certificate"), 1),
            (String::new(), 1),
            (format!("{good}1,2,3\n"), 3),
            (format!("{good}{}", row(ball, "1 2048 2048 2048 7")), 3),
            (format!("{good}{}", row(ball, "2048 2048 2048 2048 -7")), 3),
            (format!("{good}{}", row("100 100 100 200 200 200 0 100 0.5 1", "2048 2048 2048 2048 7")), 3),
            (format!("{good}{}", row("100 100 inf 200 200 200 30 100 0.5 1", "2048 2048 2048 2048 7")), 3),
            (format!("{good}{}", row(&[ball; 4].join(";"), "2048 2048 2048 2048 7")), 3),
        ] {
            let error = parse_csv("scenes.csv", &wrong).expect_err("refused");
            assert_eq!((error.file.as_str(), error.place), ("scenes.csv", Place::Line(line)), "{wrong}");
        }
    }
}
