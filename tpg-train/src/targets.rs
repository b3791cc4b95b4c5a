//! Tasks: where the arm starts and where its hand shall go.
//!
//! Targets are uniform in the reachable space. The reachable space is sampled: motor positions drawn at the resolution
//! of one tick, those thrown away that collide or stand inside the base, the rest sorted into cubes of 20 mm by where
//! the hand is. A target is a uniformly chosen cube, then a uniformly chosen pose in it; so is a random start. (The
//! paper's own list of targets is not public; on a coarser grid than one tick a policy can exploit the grid.)
//!
//! Training, validation and test tasks never share a random stream, whatever the seed: [`Purpose`](Set) is a part of
//! the stream's key.

use crate::evolution::config::Config;
use crate::random::{Purpose, Stream};
use serde::{Deserialize, Serialize};
use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use tpg_arm::episode::Problem;
use tpg_arm::frame::Clearance;
use tpg_arm::kinematics::{self, Lattice, Plane};
use tpg_arm::{Arm, JOINTS, Pose, WIDOWX};
use tpg_graph::error::InputError;

/// The edge of a cube, mm.
const CUBE: f64 = 20.0;
/// A cube remembers this many poses, the first drawn.
const POSES_PER_CUBE: usize = 8;
/// Poses drawn to sample the reachable space: about 60 for each cube.
const DRAWS: u32 = 2_000_000;

/// What tasks are for. Sets of different kinds are independent for every seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Set {
    /// To learn from.
    Training = 1,
    /// To choose between policies.
    Validation = 2,
    /// To report; no training and no selection may read them.
    Test = 3,
}

/// Where episodes start.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
#[value(rename_all = "lowercase")]
pub enum Start {
    /// Fixed start: the arm's home.
    Fs,
    /// Random start.
    Rs,
}

impl Start {
    /// Actions after which an episode is over.
    pub fn max_actions(self) -> u32 {
        match self {
            Self::Fs => 1707,
            Self::Rs => 3414,
        }
    }
}

/// The tolerance of the paper's problems, mm.
pub const TOLERANCE: f64 = 3.0;

/// One task.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Task {
    /// Where the arm starts.
    pub start: Pose,
    /// Where the hand shall go, mm.
    pub target: [f64; 3],
}

impl Task {
    /// The task as a problem with the paper's tolerance.
    pub fn problem<S: Lattice>(&self, start: Start) -> Problem<S> {
        Problem {
            start: self.start,
            target: self.target.map(S::from_f64),
            tolerance: S::from_f64(TOLERANCE),
            max_actions: start.max_actions(),
        }
    }
}

/// A sample of the poses that an arm can take, evened out over where the hand is.
#[derive(Clone, Debug)]
pub struct Reach {
    home: Pose,
    arm: Arm<f64>,
    poses: Vec<Pose>,
    /// Where each cube's poses begin in `poses`; one more than there are cubes.
    cubes: Vec<usize>,
}

impl Reach {
    /// Samples the space that the arm reaches. Takes under a second.
    ///
    /// # Panics
    /// If the arm has no pose that is free.
    pub fn sample(arm: &Arm<f64>, seed: u64, set: Set) -> Self {
        let mut random = Stream::new(seed, set as u64, Purpose::Reach, 0);
        let links = &arm.links;
        let reach = links.upper_arm + links.elbow_offset + links.forearm + links.hand;
        let side = (2.0 * reach / CUBE) as usize + 2;
        let cube = |hand: [f64; 3]| {
            let index = |value: f64, low: f64| ((value - low) / CUBE) as usize;
            let [x, y, z] = hand;
            (index(x, -reach) * side + index(y, -reach)) * side + index(z, links.base - reach)
        };
        let mut found: Vec<(u32, u32, Pose)> = Vec::new();
        let mut counts = vec![0u8; side * side * side];
        for draw in 0..DRAWS {
            let pose = Pose(arm.ranges.map(|range| random.between(range.min.into(), range.max.into()) as i16));
            let plane = Plane::at(arm, pose);
            if !stands_free(arm, &plane) {
                continue;
            }
            let cube = cube(plane.hand_in_world(kinematics::base_direction(pose)));
            if usize::from(counts[cube]) < POSES_PER_CUBE {
                counts[cube] += 1;
                found.push((cube as u32, draw, pose));
            }
        }
        found.sort_unstable_by_key(|&(cube, draw, _)| (cube, draw));
        let starts = (0..found.len()).filter(|&i| i == 0 || found[i].0 != found[i - 1].0);
        let cubes: Vec<usize> = starts.chain([found.len()]).collect();
        assert!(cubes.len() > 1, "the arm has no free pose");
        Self { home: arm.home, arm: *arm, poses: found.into_iter().map(|(.., pose)| pose).collect(), cubes }
    }

    /// How many cubes the hand reaches.
    pub fn cubes(&self) -> usize {
        self.cubes.len() - 1
    }

    /// A pose: uniform over the cubes, then over the cube's poses.
    pub fn pose(&self, random: &mut Stream) -> Pose {
        let cube = random.below(self.cubes());
        let poses = &self.poses[self.cubes[cube]..self.cubes[cube + 1]];
        *random.pick(poses)
    }

    /// A task.
    pub fn task(&self, start: Start, random: &mut Stream) -> Task {
        let target = kinematics::hand(&self.arm, self.pose(random));
        let start = match start {
            Start::Fs => self.home,
            Start::Rs => self.pose(random),
        };
        Task { start, target }
    }
}

/// Whether nothing collides and neither hand nor forearm stands inside the base (which the collision test, made of
/// edges alone, does not see).
pub fn stands_free(arm: &Arm<f64>, plane: &Plane<f64>) -> bool {
    let outside = || {
        let Clearance { hand, forearm } = Clearance::of(plane, &arm.shapes);
        hand > 0.0 && forearm > 0.0
    };
    plane.collision(&arm.shapes).is_none() && outside()
}

/// That many tasks of a set. The first tasks of a longer list are the shorter list.
pub fn tasks(arm: &Arm<f64>, seed: u64, set: Set, start: Start, count: usize) -> Vec<Task> {
    let reach = Reach::sample(arm, seed, set);
    let stream = |index| Stream::new(seed, (set as u64) << 8 | start as u64, Purpose::Task, index);
    (0..count as u64).map(|index| reach.task(start, &mut stream(index))).collect()
}

/// The seed of the project's committed test tasks, `generated/test-targets/`.
pub const TEST_SEED: u64 = 2024;

/// Print a set of test tasks as CSV.
///
/// `tpg-train targets --problem fs > generated/test-targets/fs.csv` makes the committed file again.
#[derive(Clone, Debug, clap::Args)]
pub struct TargetsArgs {
    /// The problem: fixed or random start
    #[arg(long, value_enum)]
    pub problem: Start,
    /// The arm of this configuration, instead of the WidowX
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// How many
    #[arg(long, value_name = "N", default_value_t = 1000)]
    pub episodes: usize,
    /// The seed
    #[arg(long, value_name = "S", default_value_t = TEST_SEED)]
    pub seed: u64,
}

/// Prints test tasks.
///
/// # Errors
/// If the configuration cannot be read, or stdout is closed.
pub fn print_targets(args: &TargetsArgs) -> Result<(), InputError> {
    let arm = args.config.as_deref().map(Config::read).transpose()?.map_or(WIDOWX, |config| config.arm());
    let text = to_csv(&tasks(&arm, args.seed, Set::Test, args.problem, args.episodes));
    let written = io::stdout().lock().write_all(text.as_bytes());
    written.map_err(|error| InputError::io("<stdout>".as_ref(), &error, "an open pipe"))
}

const HEADER: [&str; JOINTS + 3] =
    ["start_base", "start_shoulder", "start_elbow", "start_wrist", "target_x_mm", "target_y_mm", "target_z_mm"];

/// How the paper's recorded targets are headed: the same columns, after a number.
const RECORDED_HEADER: &str = "row,m0,m1,m2,m3,tx,ty,tz";

/// Why a file of tasks cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The file system refused.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// The text is no list of tasks.
    #[error("{}: line {line}: {found}; accepted: {accepted}", path.display())]
    Content {
        /// The file.
        path: PathBuf,
        /// Counted from 1.
        line: u64,
        /// What stands there.
        found: String,
        /// What may stand there.
        accepted: String,
    },
}

/// Tasks as CSV: a header, then start (ticks) and target (mm, the shortest digits that give the same number).
pub fn to_csv(tasks: &[Task]) -> String {
    let row = |task: &Task| {
        let ([base, shoulder, elbow, wrist], [x, y, z]) = (task.start.0, task.target);
        format!("{base},{shoulder},{elbow},{wrist},{x},{y},{z}\n")
    };
    [HEADER.join(",") + "\n"].into_iter().chain(tasks.iter().map(row)).collect()
}

/// Reads what [`to_csv`] wrote, or the paper's recorded targets.
///
/// # Errors
/// If the file cannot be read, has another header, or a value that is no number of the arm's range.
pub fn read_csv(arm: &Arm<f64>, path: &Path) -> Result<Vec<Task>, Error> {
    let text = fs::read_to_string(path).map_err(|source| Error::Io { path: path.into(), source })?;
    parse_csv(arm, &text).map_err(|(line, found, accepted)| Error::Content { path: path.into(), line, found, accepted })
}

fn parse_csv(arm: &Arm<f64>, text: &str) -> Result<Vec<Task>, (u64, String, String)> {
    let mut lines = (1u64..).zip(text.lines());
    let header = HEADER.join(",");
    let recorded = match lines.next() {
        Some((_, line)) if line.trim_end() == header => false,
        Some((_, line)) if line.trim_end() == RECORDED_HEADER => true,
        found => {
            return Err((
                1,
                format!("{:?}", found.map_or("", |(_, line)| line)),
                format!("the header {header}, or {RECORDED_HEADER}"),
            ));
        }
    };
    let columns = |line: &str| {
        let line = line.trim_end();
        let from = if recorded { line.find(',').map_or(0, |comma| comma + 1) } else { 0 };
        line[from..].to_owned()
    };
    lines.map(|(number, line)| task(arm, &columns(line)).map_err(|(found, want)| (number, found, want))).collect()
}

fn task(arm: &Arm<f64>, line: &str) -> Result<Task, (String, String)> {
    let fields: Vec<&str> = line.split(',').collect();
    let Ok([base, shoulder, elbow, wrist, x, y, z]) = <[&str; 7]>::try_from(fields) else {
        return Err((format!("{line:?}"), format!("{} fields", HEADER.len())));
    };
    let mut start = Pose([0; JOINTS]);
    for ((ticks, field), range) in start.0.iter_mut().zip([base, shoulder, elbow, wrist]).zip(&arm.ranges) {
        let accepted = || format!("a whole number of ticks from {} to {}", range.min, range.max);
        *ticks = field.parse().ok().filter(|&t| range.contains(t)).ok_or_else(|| (format!("{field:?}"), accepted()))?;
    }
    let mut target = [0.0; 3];
    for (value, field) in target.iter_mut().zip([x, y, z]) {
        let finite = field.parse().ok().filter(|v: &f64| v.is_finite());
        *value = finite.ok_or_else(|| (format!("{field:?}"), "a finite number of mm".to_owned()))?;
    }
    Ok(Task { start, target })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn tasks_are_free_reachable_and_spread() {
        let reach = Reach::sample(&WIDOWX, 1, Set::Training);
        assert!((30_000..40_000).contains(&reach.cubes()), "{} cubes", reach.cubes());
        let mut random = Stream::new(1, 0, Purpose::Test, 0);
        let mut off_grid = 0;
        for _ in 0..2000 {
            let pose = reach.pose(&mut random);
            assert!(stands_free(&WIDOWX, &Plane::at(&WIDOWX, pose)), "{pose:?}");
            off_grid += u32::from(pose.0.iter().any(|&ticks| ticks % 3 != 2048 % 3));
        }
        assert!(off_grid > 1900, "targets on the action grid can be exploited");
        // Uniform over cubes: about as many targets right as left, and few low ones twice.
        let targets: Vec<_> = (0..2000).map(|_| reach.task(Start::Fs, &mut random).target).collect();
        let right = targets.iter().filter(|target| target[0] > 0.0).count();
        assert!((880..1120).contains(&right), "{right} of 2000 on the right");
        let distinct: BTreeSet<_> = targets.iter().map(|target| target.map(f64::to_bits)).collect();
        assert!(distinct.len() > 1950);
    }

    #[test]
    fn sets_differ_and_a_longer_list_begins_with_the_shorter() {
        let list = |set, count| tasks(&WIDOWX, 7, set, Start::Rs, count);
        let longer = list(Set::Validation, 20);
        assert_eq!(longer[..10], list(Set::Validation, 10)[..]);
        for other in [Set::Training, Set::Test] {
            assert!(list(other, 20).iter().all(|task| !longer.contains(task)));
        }
    }

    #[test]
    fn the_committed_test_tasks_are_those_of_the_command() {
        let committed = [
            (Start::Fs, include_str!("../../generated/test-targets/fs.csv")),
            (Start::Rs, include_str!("../../generated/test-targets/rs.csv")),
        ];
        for (start, text) in committed {
            assert!(to_csv(&tasks(&WIDOWX, TEST_SEED, Set::Test, start, 1000)) == text, "{start:?}");
        }
    }

    #[test]
    fn csv_gives_back_the_same_tasks() {
        let list = tasks(&WIDOWX, 7, Set::Validation, Start::Rs, 50);
        assert_eq!(parse_csv(&WIDOWX, &to_csv(&list)), Ok(list));
    }

    #[test]
    fn the_papers_recorded_targets_are_read() {
        let text = "row,m0,m1,m2,m3,tx,ty,tz\n0,2048,2048,2048,2048,1.5,-250.25,30\n";
        let task = Task { start: WIDOWX.home, target: [1.5, -250.25, 30.0] };
        assert_eq!(parse_csv(&WIDOWX, text), Ok(vec![task]));
    }

    #[test]
    fn a_wrong_file_is_refused_with_its_place() {
        let good = to_csv(&tasks(&WIDOWX, 7, Set::Validation, Start::Rs, 2));
        for (wrong, line) in [
            (good.replace("start_base", "base"), 1),
            (String::new(), 1),
            (format!("{good}1,2,3\n"), 4),
            (format!("{good}1,2048,2048,2048,0,0,0\n"), 4),
            (format!("{good}2048,2048,2048,2048,0,NaN,0\n"), 4),
        ] {
            assert_eq!(parse_csv(&WIDOWX, &wrong).map_err(|(line, ..)| line), Err(line), "{wrong}");
        }
    }
}
