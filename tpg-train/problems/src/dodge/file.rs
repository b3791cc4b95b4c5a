//! Lists of scenes as CSV files: a line for each, with the plan that solves it.

use super::draw::Certified;
use super::scene::{Path, Scene};
use super::walk::{GOALS, Leg};
use crate::rows::{self, RowRefusal, finite, numbers, pose};
use std::fmt::Display;
use std::path;
use tpg_arm::dodge::BALLS;
use tpg_arm::{JOINTS, Pose, WIDOWX};
use tpg_graph::error::InputError;
use tpg_graph::files::read_text;

/// Start, ticks; target, mm; goals, ticks; balls: both ends (mm), radius (mm), period (steps), phase, 1 for sinusoidal; the
/// plan: poses (ticks), each with the steps to wait there. Numbers are separated by spaces, items by semicolons.
const HEADER: [&str; 5] = ["start", "target_mm", "goals", "balls", "plan"];

/// Writes scenes as CSV, with the shortest digits that give the same numbers.
pub fn to_csv(scenes: &[Certified]) -> String {
    let ball = |ball: &Path| {
        let Path { from, to, radius, period, phase, sine } = *ball;
        let ends = [from, to].concat();
        spaced(ends.into_iter().chain([radius, period, phase, f32::from(u8::from(sine))]))
    };
    let leg = |leg: &Leg| spaced(leg.to.0.map(i32::from).into_iter().chain([leg.wait.into()]));
    let row = |Certified { scene, plan }: &Certified| {
        [
            spaced(scene.start),
            spaced(scene.target),
            items(scene.goals.iter().map(|goal| spaced(*goal))),
            items(scene.balls.iter().map(ball)),
            items(plan.iter().map(leg)),
        ]
    };
    rows::write(HEADER, scenes.iter().map(row))
}

fn spaced<T: Display>(values: impl IntoIterator<Item = T>) -> String {
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
    let text = read_text(path, "a file of scenes")?;
    parse_csv(&path.display().to_string(), &text)
}

/// Reads the text of such a file.
///
/// # Errors
/// As [`read_csv`].
pub fn parse_csv(file: &str, text: &str) -> Result<Vec<Certified>, InputError> {
    rows::read(file, text, HEADER, |[start, target, goals, balls, plan]| {
        let goals = goals.split(';').map(posture).collect::<Result<Vec<_>, _>>()?;
        let balls = balls.split(';').map(ball).collect::<Result<Vec<_>, _>>()?;
        let plan = plan.split(';').map(leg).collect::<Result<Vec<_>, _>>()?;
        for (count, what, most) in [(goals.len(), "goals", GOALS), (balls.len(), "balls", BALLS)] {
            if count > most {
                return Err((format!("{count} {what}"), format!("at most {most}")));
            }
        }
        let target = finite(numbers(target.split(' '), "mm")?)?;
        Ok(Certified { scene: Scene { start: posture(start)?, target, goals, balls }, plan })
    })
}

fn posture(text: &str) -> Result<[i16; JOINTS], RowRefusal> {
    pose(&WIDOWX.ranges, numbers(text.split(' '), "ticks")?).map(|Pose(ticks)| ticks)
}

fn ball(text: &str) -> Result<Path, RowRefusal> {
    let numbers = numbers(text.split(' '), "mm, steps")?;
    let [ax, ay, az, bx, by, bz, radius, period, phase, sine] = finite::<f32, 10>(numbers)?;
    if radius <= 0.0 || period < 0.0 || !(0.0..=1.0).contains(&phase) || (sine != 0.0 && sine != 1.0) {
        let accepted = "a radius above 0, a period of at least 0, a phase from 0 to 1, and 0 or 1 for sinusoidal";
        return Err((format!("{text:?}"), accepted.to_owned()));
    }
    Ok(Path { from: [ax, ay, az], to: [bx, by, bz], radius, period, phase, sine: sine == 1.0 })
}

fn leg(text: &str) -> Result<Leg, RowRefusal> {
    let [base, shoulder, elbow, wrist, wait] = numbers::<i16, { JOINTS + 1 }>(text.split(' '), "ticks and steps")?;
    let to = pose(&WIDOWX.ranges, [base, shoulder, elbow, wrist])?;
    let wait = u16::try_from(wait).map_err(|_| (wait.to_string(), "at least 0 steps to wait".to_owned()))?;
    Ok(Leg { to, wait })
}

#[cfg(test)]
mod tests {
    use super::{parse_csv, to_csv};
    use crate::arm::targets::Set;
    use crate::dodge::DodgeConfig;
    use crate::dodge::draw::scenes;
    use tpg_graph::error::Place;

    #[test]
    fn csv_gives_back_the_same_scenes() {
        let list = scenes(&DodgeConfig::default(), 7, Set::Training, 8, 1500);
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
