//! The arms among balls: what the page shows are the episodes of the problem, step by step.

use tpg_arm::dodge::Behaviour;
use tpg_engine::{Act, Environment};
use tpg_generated::dodge::Dodge as Policy;
use tpg_problems::dodge::scene::Scene;
use tpg_problems::dodge::{Dodge, DodgeConfig, file};
use tpg_runtime::policy::Policy as _;
use tpg_testing::library::top;
use tpg_web::balls::{Balls, scene};

fn bytes(scene: &Scene) -> Vec<u8> {
    postcard::to_stdvec(scene).expect("plain data")
}

#[test]
fn episodes_end_as_in_the_problem() {
    let scenes = file::read_csv(&top().join("generated/test-targets/dodge.csv")).expect("the test scenes");
    let problem = Dodge::new(&DodgeConfig::default());
    let mut ends = [[0; 4]; 2];
    for task in scenes.iter().take(60).map(|certified| &certified.scene) {
        let mut balls = Balls::default();
        balls.begin(&scene(&bytes(task)).expect("it is a scene"));
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
fn bytes_that_are_no_scene_change_nothing() {
    let scenes = file::read_csv(&top().join("generated/test-targets/dodge.csv")).expect("the test scenes");
    let good = &scenes[0].scene;
    assert_eq!(scene(&bytes(good)).as_ref(), Some(good));
    let outside = Scene { start: [5000; 4], ..good.clone() };
    let without = Scene { goals: Vec::new(), ..good.clone() };
    for bad in [bytes(&outside), bytes(&without), bytes(good)[..20].to_vec(), Vec::new()] {
        assert_eq!(scene(&bad), None);
    }
}
