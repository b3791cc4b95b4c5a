//! The committed scenes of the arm among balls: every one is solved by its plan, and they are those of the command.

use tpg_problems::arm::targets::Set;
use tpg_problems::dodge::DodgeConfig;
use tpg_problems::dodge::draw::{LIMIT, SEED, TEST_TRIES, replay, scenes};
use tpg_problems::dodge::file::{parse_csv, to_csv};

const COMMITTED: &str = include_str!("../test-targets/dodge.csv");

#[test]
fn every_certificate_solves_its_scene_with_a_millimetre_to_spare() {
    let list = parse_csv("dodge.csv", COMMITTED).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(list.len(), 1000);
    for (index, certified) in list.iter().enumerate() {
        let arrival = replay(&certified.scene, &certified.plan, 1.0);
        assert!(
            arrival.is_some_and(|steps| steps <= LIMIT),
            "scene {index}: {arrival:?}"
        );
    }
}

#[test]
fn the_committed_scenes_are_those_of_the_command() {
    let drawn = scenes(&DodgeConfig::default(), SEED, Set::Test, 1000, TEST_TRIES);
    assert!(to_csv(&drawn) == COMMITTED);
}
