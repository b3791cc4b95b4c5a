//! The arms among balls: what the page shows are the episodes of the problem, step by step.

use tpg_arm::dodge::Behaviour;
use tpg_engine::{Act, Environment};
use tpg_generated::dodge::Dodge as Policy;
use tpg_problems::dodge::{Config, Dodge, file};
use tpg_runtime::policy::Policy as _;
use tpg_testing::library::top;
use tpg_web::balls::{Balls, NUMBERS, numbers, scene};

#[test]
fn episodes_end_as_in_the_problem() {
    let scenes = file::read_csv(&top().join("generated/test-targets/dodge.csv")).expect("the test scenes");
    let problem = Dodge::new(&Config::default());
    let mut ends = [[0; 4]; 2];
    for task in scenes.iter().take(60).map(|certified| &certified.scene) {
        let mut balls = Balls::default();
        balls.begin(&scene(&numbers(task).expect("it fits")).expect("it is a scene"));
        let mut trial = Environment::<f32>::start(&problem, task);
        let (mut state, mut steps) = ([0.0f32; Policy::STATE], 0);
        let end = loop {
            problem.observe(&mut trial, tpg_engine::SourceSet::ALL, &mut state);
            let action = Policy.decide(&state);
            let step = Environment::<f32>::step(&problem, &mut trial, Act::Choice(action));
            balls.act(0);
            steps += 1;
            assert_eq!(balls.view(0).behaviour, u32::from(action.0), "step {steps}");
            if let Some(end) = step.end {
                break end;
            }
            assert_eq!(balls.view(0).state, 0, "step {steps}");
        };
        assert_eq!((balls.view(0).state, balls.view(0).steps), (u32::from(end.outcome) + 1, steps));
        while balls.view(1).state == 0 {
            balls.act(1);
            assert_eq!(Behaviour::ALL[balls.view(1).behaviour as usize].name(), "straight");
        }
        for (arm, ends) in ends.iter_mut().enumerate() {
            ends[balls.view(arm).state as usize] += 1;
        }
    }
    assert!(ends[0][1] > 45 && ends[1][1] < ends[0][1], "the policy is better than the straight walk: {ends:?}");
}

#[test]
fn numbers_that_are_no_scene_change_nothing() {
    let scenes = file::read_csv(&top().join("generated/test-targets/dodge.csv")).expect("the test scenes");
    let good = numbers(&scenes[0].scene).expect("it fits");
    assert_eq!(scene(&good).as_ref(), Some(&scenes[0].scene));
    // A pose outside the joints' ranges; no goal, a half, too many; no ball; a place that is no number.
    let goals = 7;
    for (place, value) in [(0, 5000.0), (goals, 0.0), (goals, 1.5), (goals, 9.0), (24, 0.0), (NUMBERS - 10, f32::NAN)] {
        let mut bad = good;
        bad[place] = value;
        assert_eq!(scene(&bad), None, "{place}: {value}");
    }
    assert_eq!(scene(&[0.0; NUMBERS]), None);
}
