//! Checks that the committed test tasks are those that their seed draws.

use tpg_arm::WIDOWX;
use tpg_problems::arm::targets::{Set, Start, TEST_SEED, tasks, to_csv};

#[test]
fn the_committed_test_tasks_are_those_of_the_command() {
    let committed = [
        (Start::Fs, include_str!("../test-targets/fs.csv")),
        (Start::Rs, include_str!("../test-targets/rs.csv")),
    ];
    for (start, text) in committed {
        assert!(
            to_csv(&tasks(&WIDOWX, TEST_SEED, Set::Test, start, 1000)) == text,
            "{start:?}"
        );
    }
}
