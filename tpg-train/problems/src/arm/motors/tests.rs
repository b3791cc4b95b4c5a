//! Tests of the arm by its motors.

use super::{Motors, MotorsConfig, MotorsTask, Reward, Rules};
use crate::arm::arms::NamedArm;
use crate::arm::targets::{Set, Start, tasks};
use tpg_arm::sac::{Actions, Mask};
use tpg_arm::{Pose, WIDOWX};
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Act, Environment, SourceSet, TaskSet, Training as _};

fn tasks_of(motors: &Motors, count: usize) -> Vec<MotorsTask> {
    tpg_engine::tasks(motors, TaskSet::Validation, 0, count)
}

fn coarse() -> MotorsConfig {
    MotorsConfig {
        actions: Actions::Coarse,
        mask: Mask::None,
        may_rest: true,
        repeat_most: 1,
        ..MotorsConfig::default()
    }
}

#[test]
fn training_and_tests_move_by_three() {
    let task = tasks(&WIDOWX, 1, Set::Training, Start::Fs, 1)[0];
    for rules in [Rules::Training, Rules::Test(Start::Fs)] {
        let motors = Motors::new(Start::Fs, coarse(), 1);
        let mut episode = motors.start(&MotorsTask { start: task.start.0, target: task.target, rules });
        // Under a third; above; zero; far above.
        motors.step(&mut episode, Act::Values(&[0.3, -0.4, 0.0, 0.999]));
        let moved: Vec<i16> = episode.pose().0.iter().zip(task.start.0).map(|(after, before)| after - before).collect();
        assert_eq!(moved, [0, -3, 0, 3], "{rules:?}");
    }
}

#[test]
fn a_cut_is_truncated_and_an_invalid_step_is_not() {
    let config = MotorsConfig { max_steps: 4, ..coarse() };
    let motors = Motors::new(Start::Fs, config, 1);
    let task = motors.draw(&mut Stream::new(1, 0, Purpose::Test, 0));
    let mut episode = motors.start(&task);
    let ends: Vec<_> = (0..4).map(|_| motors.step(&mut episode, Act::Values(&[0.0; 4])).end).collect();
    assert!(ends[..3].iter().all(Option::is_none));
    assert!(ends[3].is_some_and(|end| end.truncated && end.success == Some(false)));

    let motors = Motors::new(Start::Fs, coarse(), 1);
    let edge = MotorsTask { start: [WIDOWX.ranges[0].max, task.start[1], task.start[2], task.start[3]], ..task };
    let step = motors.step(&mut motors.start(&edge), Act::Values(&[0.9, 0.0, 0.0, 0.0]));
    assert!(step.end.is_some_and(|end| !end.truncated && end.success == Some(false)));
}

#[test]
fn azimuth_pays_for_the_way_of_the_base_that_its_range_allows() {
    // The base stands 9° left of straight back, the target 9° right of it: the short way leads through the limit.
    let start = [WIDOWX.ranges[0].max - 100, 2048, 2048, 2048];
    let (sin, cos) = (-171f64).to_radians().sin_cos();
    let task = MotorsTask { start, target: [-346.0 * sin, 346.0 * cos, 267.0], rules: Rules::Training };
    let only = |azimuth, distance| {
        let nothing = Reward {
            step: 0.0,
            log_distance: 0.0,
            distance: 0.0,
            steps_to_goal: 0.0,
            azimuth: 0.0,
            success: 0.0,
            invalid: 0.0,
        };
        Motors::new(Start::Rs, MotorsConfig { reward: Reward { azimuth, distance, ..nothing }, ..coarse() }, 1)
    };
    let earned =
        |motors: &Motors, base| motors.step(&mut motors.start(&task), Act::Values(&[base, 0.0, 0.0, 0.0])).reward;
    let (by_azimuth, by_distance) = (only(1.0, 0.0), only(0.0, 1.0));
    for (base, azimuth) in [(-0.9, 1.0), (0.9, -1.0)] {
        assert!((earned(&by_azimuth, base) - azimuth).abs() < 1e-3, "{base}");
        // The distance leads the other way.
        assert!(earned(&by_distance, base) * azimuth < 0.0, "{base}");
    }
}

#[test]
fn rest_ends_a_test() {
    let motors = Motors::new(Start::Fs, coarse(), 1);
    let mut episode = motors.start(&tasks_of(&motors, 1)[0]);
    let end = motors.step(&mut episode, Act::Values(&[0.0; 4])).end.expect("an end");
    assert_eq!(motors.outcomes()[usize::from(end.outcome)], "stop");
}

#[test]
fn evaluation_tasks_have_both_starts_and_training_goes_on_from_where_one_is() {
    let motors = Motors::new(Start::Rs, MotorsConfig::default(), 7);
    let tasks = motors.evaluation_tasks(&mut Stream::new(7, 1, Purpose::Test, 0), 8).expect("its own");
    let count = |start| tasks.iter().filter(|task| task.rules == Rules::Test(start)).count();
    assert_eq!((count(Start::Rs), count(Start::Fs)), (6, 2));
    let mut episode = motors.start(&tasks[0]);
    motors.step(&mut episode, Act::Values(&[0.5, -0.5, 0.9, 0.1]));
    let from = motors.task_from(&episode).expect("the hand is not at its target");
    assert_eq!((Pose(from.start), from.target, from.rules), (episode.pose(), tasks[0].target, Rules::Training));
    // Both kinds of rules show an actor the same.
    let (mut here, mut there) = (vec![0.0; 38], vec![0.0; 38]);
    motors.observe(&mut episode, SourceSet::ALL, &mut here);
    motors.observe(&mut motors.start(&from), SourceSet::ALL, &mut there);
    assert_eq!(here, there);
}

/// The SO-101's base does not turn as far as the WidowX's, and its play leads its hand astray.
#[test]
fn another_arm_brings_its_own_tasks_limits_and_rules() {
    let arm = NamedArm::find("so101").map(NamedArm::description);
    let config = MotorsConfig { arm, test_tolerance: Some(10.0), backlash: 6, ..coarse() };
    assert_eq!((config.check(), config.tests(Start::Rs).tolerance), (Ok(()), 10.0));
    let motors = Motors::new(Start::Rs, config, 1);
    let so101 = motors.config().arm();
    for task in tasks_of(&motors, 20) {
        assert!(task.start.iter().zip(&so101.ranges).all(|(&ticks, range)| range.contains(ticks)));
    }
    let task = tasks_of(&motors, 1)[0];
    for rules in [Rules::Training, Rules::Test(Start::Rs)] {
        let edge = MotorsTask { start: [so101.ranges[0].max, 2048, 2048, 2048], rules, ..task };
        let step = motors.step(&mut motors.start(&edge), Act::Values(&[0.9, 0.0, 0.0, 0.0]));
        assert!(step.end.is_some_and(|end| end.success == Some(false)), "{rules:?}");
    }
    // At rest ends at once, with the distance of a hand that its play moves.
    let motors_rest = |motors: &Motors| {
        motors.step(&mut motors.start(&task), Act::Values(&[0.0; 4])).end.expect("rest ends a test").measure
    };
    let rigid = Motors::new(Start::Rs, MotorsConfig { backlash: 0, ..motors.config().clone() }, 1);
    let apart = (motors_rest(&motors) - motors_rest(&rigid)).abs();
    assert!(apart > 0.0 && apart < 15.0, "{apart} mm");
}
