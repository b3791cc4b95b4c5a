//! The arm among balls: what the generator promises, the rules of a step, and the problem as an environment.

use tpg_arm::dodge::plan::{steps, straight};
use tpg_arm::frame::Clearance;
use tpg_arm::kinematics::distance;
use tpg_arm::{Move, Pose, WIDOWX};
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Act, Environment, SourceSet};
use tpg_problems::arm::targets::Set;
use tpg_problems::dodge::draw::{Certified, Generator, LIMIT, SEED, replay, scenes};
use tpg_problems::dodge::episode::{End, Episode};
use tpg_problems::dodge::scene::{Path, Scene};
use tpg_problems::dodge::walk::{Leg, follow, moved};
use tpg_problems::dodge::{BODY, Dodge, DodgeConfig};
use tpg_runtime::policy::ActionId;

fn hundred() -> Vec<Certified> {
    scenes(&DodgeConfig::default(), SEED, Set::Validation, 100, 1500)
}

#[test]
fn a_ball_goes_back_and_forth_at_its_speed() {
    for (sine, phase) in [(true, 0.1), (false, 0.7)] {
        let path = Path { from: [0.0, 0.0, 100.0], to: [300.0, 0.0, 100.0], radius: 40.0, period: 600.0, phase, sine };
        assert!(distance(path.at(17.0), path.at(617.0)) < 0.01, "a period later it is there again");
        let speeds = (0..600).map(|time| distance([0.0; 3], path.observed(time as f32).velocity));
        let fastest = speeds.fold(0.0, f32::max);
        assert!((fastest - path.speed()).abs() < 0.01 * path.speed(), "{fastest} {}", path.speed());
        let places: Vec<f32> = (0..600).map(|time| path.at(time as f32)[0]).collect();
        let (low, high) = places.iter().fold((300.0, 0.0), |(low, high), &x| (x.min(low), x.max(high)));
        assert!((-1e-3..1.0).contains(&low) && (299.0..300.001).contains(&high));
    }
    let still = Path { from: [1.0, 2.0, 3.0], to: [1.0, 2.0, 3.0], radius: 40.0, period: 0.0, phase: 0.0, sine: true };
    assert_eq!((still.at(5.0), still.speed()), ([1.0, 2.0, 3.0], 0.0));
}

#[test]
fn scenes_keep_the_generators_rules() {
    let list = hundred();
    let mut counts = [0; 3];
    for Certified { scene, plan } in &list {
        let start = Pose(scene.start);
        counts[scene.balls.len() - 1] += 1;
        for (index, goal) in scene.goals.iter().enumerate() {
            let posture = BODY.at(Pose(*goal));
            let Clearance { hand, forearm } = Clearance::new(&posture.plane(), &BODY.arm.shapes);
            assert!(BODY.is_free(&posture) && hand > 0.0 && forearm > 0.0);
            assert!(distance(posture.hand(), scene.target) < 2.7);
            assert!(scene.goals[..index].iter().all(|other| steps(Pose(*goal), Pose(*other)) > 20));
        }
        let first = Pose(scene.goals[0]);
        assert!((60..=600).contains(&steps(start, first)) && scene.goals.len() <= 4);
        // Without balls a straight walk arrives: the balls are the whole problem.
        let walk = follow(start, &[Leg { to: first, wait: 0 }], LIMIT, 0.0, |_, _| 1.0);
        assert_eq!(walk, Some(steps(start, first)));
        for ball in &scene.balls {
            assert!(
                (30.0..=60.0).contains(&ball.radius) && (ball.period == 0.0 || (0.29..=2.01).contains(&ball.speed()))
            );
            let rest = BODY.at(start);
            assert!(BODY.clearance(&rest, ball.at(0.0), ball.radius) >= 40.0);
            assert!((0..=40).all(|time| BODY.clearance(&rest, ball.at(time as f32), ball.radius) >= 5.0));
            for time in 0..1000 {
                let [x, y, z] = ball.at(time as f32);
                assert!(z > ball.radius - 0.01 && (x.hypot(y) > ball.radius + 60.0 || z > 400.0));
            }
        }
        assert!(replay(scene, plan, 1.0).is_some_and(|time| time <= LIMIT));
    }
    assert!(counts.iter().all(|&count| count > 15), "{counts:?}");
}

#[test]
fn sets_differ_and_a_longer_list_begins_with_the_shorter() {
    let list = |set, count| scenes(&DodgeConfig::default(), SEED, set, count, 1500);
    let longer = list(Set::Validation, 6);
    assert_eq!(longer[..3], list(Set::Validation, 3)[..]);
    for other in [Set::Training, Set::Test] {
        assert!(list(other, 6).iter().all(|scene| !longer.contains(scene)));
    }
}

#[test]
fn a_plan_that_is_followed_by_the_rules_does_what_its_replay_says() {
    let config = DodgeConfig::default();
    for Certified { scene, plan } in hundred().iter().take(30) {
        let mut episode = Episode::new(scene);
        let mut legs = plan.clone();
        let end = loop {
            let at = episode.pose();
            while legs.len() > 1 && legs[0] == (Leg { to: at, wait: 0 }) {
                legs.remove(0);
            }
            let leg = &mut legs[0];
            let step = if leg.to == at { Move::STOP } else { straight(at, leg.to) };
            leg.wait -= u16::from(leg.to == at);
            if let Some(end) = episode.step(step, config.tolerance) {
                break end;
            }
        };
        // The hand is within the tolerance a few steps before the last pose.
        assert_eq!(end, End::Reached);
        assert!(replay(scene, plan, 1.0).is_some_and(|time| time >= episode.steps()));
    }
}

#[test]
fn a_step_against_limits_table_or_base_is_refused_and_no_failure() {
    let ball =
        Path { from: [0.0, 0.0, 2000.0], to: [0.0, 0.0, 2000.0], radius: 30.0, period: 0.0, phase: 0.0, sine: false };
    let scene = |start| Scene { start, target: [0.0, -300.0, 300.0], goals: vec![[2048; 4]], balls: vec![ball] };
    let at_limit = [WIDOWX.ranges[0].max, 2048, 2048, 2048];
    let mut episode = Episode::new(&scene(at_limit));
    assert_eq!(episode.step(Move([3, 0, 0, 0]), 3.0), None);
    assert_eq!(episode.pose(), Pose(at_limit));
    // The others still move.
    assert_eq!(episode.step(Move([3, 3, 0, 0]), 3.0), None);
    assert_eq!(episode.pose(), moved(Pose(at_limit), Move([0, 3, 0, 0])));
    // Down to the table, and not through it.
    let mut low = Episode::new(&scene([2048, 2048, 2048, 2048]));
    let mut ended = None;
    for _ in 0..LIMIT {
        ended = ended.or(low.step(Move([0, -3, 0, 0]), 3.0));
        assert!(BODY.is_free(&BODY.at(low.pose())));
    }
    assert_eq!(ended, Some(End::Timeout));
}

#[test]
fn the_environment_scores_its_ends_and_repeats_itself() {
    let problem = Dodge::new(&DodgeConfig::default());
    let run = |scene: &Scene, action: u16| {
        let mut trial = Environment::<f32>::start(&problem, scene);
        let mut state = [0f32; 17];
        let mut seen = Vec::new();
        loop {
            problem.observe(&mut trial, SourceSet::ALL, &mut state);
            seen.extend(state.map(f32::to_bits));
            assert!(state.iter().all(|value| value.is_finite()));
            let step = Environment::<f32>::step(&problem, &mut trial, Act::Choice(ActionId(action)));
            if let Some(end) = step.end {
                return (seen, step.reward, end);
            }
        }
    };
    let mut random = Stream::new(5, 0, Purpose::Test, 0);
    let (mut reached, mut failed) = (0, 0);
    for _ in 0..12 {
        let scene = Environment::<f32>::draw(&problem, &mut random);
        assert!(Environment::<f32>::accepts(&problem, &scene));
        for action in [0, 1, 4] {
            let first = run(&scene, action);
            assert_eq!(first, run(&scene, action));
            let (_, reward, end) = first;
            match end.success {
                Some(true) => {
                    reached += 1;
                    assert!(reward >= 10.0 && end.outcome == 0 && end.measure < 3.0);
                }
                _ => {
                    failed += 1;
                    assert!(reward <= -15.0 && end.outcome > 0);
                }
            }
        }
    }
    assert!(reached > 5 && failed > 3, "{reached} {failed}");
    let mut wrong = Environment::<f32>::draw(&problem, &mut random);
    wrong.start[0] = 0;
    assert!(!Environment::<f32>::accepts(&problem, &wrong));
}

#[test]
fn validation_scenes_are_those_of_their_set() {
    let problem = Dodge::new(&DodgeConfig::default());
    let expected: Vec<Scene> = scenes(&DodgeConfig::default(), SEED, Set::Validation, 3, 1500)
        .into_iter()
        .map(|certified| certified.scene)
        .collect();
    assert_eq!(tpg_engine::tasks::<f32, _>(&problem, tpg_engine::TaskSet::Validation, 0, 3), expected);
    // Training scenes come from another sample of the space.
    let training = Generator::new(&DodgeConfig::default(), SEED, Set::Training);
    assert!(!expected.contains(&training.draw(&mut Stream::new(1, 2, Purpose::Test, 3), 1500).scene));
}
