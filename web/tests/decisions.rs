//! Lit bids are those by which the generated code decides; the page's tables and texts are current.

use std::process::Command;
use tpg_generated::{cartpole::Cartpole, mountain_car::MountainCar, pendulum::Pendulum};
use tpg_runtime::policy::{ActionId, Policy};
use tpg_testing::library::top;
use tpg_testing::numbers::Numbers;
use tpg_web::bids;
use tpg_web::decision::{Bids, Decision, MOST};

const STATES: usize = 20_000;

/// A state between −3 and 3, now and then with a value that has no number.
fn state<const N: usize>(numbers: &mut Numbers) -> [f32; N] {
    std::array::from_fn(|_| match numbers.next_u32() % 200 {
        0 => f32::NAN,
        1 => f32::INFINITY,
        2 => 0.0,
        _ => numbers.within(3_000_000) as f32 / 1e6,
    })
}

fn decide(bids: &Bids, state: &[f32]) -> Decision {
    bids.decide(state)
}

#[test]
fn the_way_that_is_lit_ends_at_the_action_of_the_generated_code() {
    let mut numbers = Numbers(1);
    let mut ends = [0; 3];
    for _ in 0..STATES {
        let seen = state::<4>(&mut numbers);
        assert_eq!(ActionId(decide(&bids::CARTPOLE, &seen).end.into()), Cartpole.decide(&seen), "{seen:?}");
        let seen = state::<2>(&mut numbers);
        let decision = decide(&bids::MOUNTAIN_CAR, &seen);
        assert_eq!(ActionId(decision.end.into()), MountainCar.decide(&seen), "{seen:?}");
        ends[usize::from(decision.end)] += 1;
    }
    assert!(ends[0] > 100 && ends[2] > 100, "a test that sees both pushes: {ends:?}");
}

/// The generated code of the pendulum answers with a torque: its two leaves are told apart by their formulas.
#[test]
fn the_leaf_that_is_lit_computes_the_torque_of_the_generated_code() {
    let mut numbers = Numbers(2);
    let mut ends = [0; 2];
    for _ in 0..STATES {
        let seen = state::<3>(&mut numbers);
        let [cosine, sine, omega] = seen;
        let torque = match decide(&bids::PENDULUM, &seen).end {
            0 => (-0.382_782_64 + cosine * -22.268_024) * (0.0 + sine * 6.633_134_4 + omega * 2.601_869_8),
            _ => -1.600_740_9 * (0.0 + sine * 9.448_936 + omega * 1.775_059_1),
        };
        ends[usize::from(decide(&bids::PENDULUM, &seen).end)] += 1;
        let limited = if torque.is_nan() { 0.0 } else { torque.clamp(-2.0, 2.0) };
        assert_eq!(Pendulum.decide(&seen)[0].to_bits(), limited.to_bits(), "{seen:?}");
    }
    assert!(ends.iter().all(|&count| count > 1000), "a test that sees both leaves: {ends:?}");
}

#[test]
fn a_way_goes_from_the_root_to_its_end_and_the_bids_fit() {
    for bids in [&bids::CARTPOLE, &bids::PENDULUM, &bids::MOUNTAIN_CAR] {
        let edges: usize = bids.teams.iter().map(|team| team.len()).sum();
        assert!(bids.values.len() <= MOST && edges <= MOST);
        let decision = bids.decide(&[0.1; 4]);
        assert!((0..bids.teams[0].len() as i32).contains(&decision.way[0]), "the first edge is the root's");
        assert!(decision.bids[edges..].iter().all(|&bid| bid == 0.0));
    }
}

#[test]
fn the_tables_are_made_of_the_shipped_graphs() {
    let out = std::env::temp_dir().join(format!("tpg-page-bids-{}", std::process::id()));
    let page = Command::new(env!("CARGO_BIN_EXE_tpg-page")).args(["bids", "--out"]).arg(&out).status();
    assert!(page.is_ok_and(|status| status.success()));
    let before = top().join("web/src/bids.rs");
    let [now, before] = [&out, &before].map(|path| std::fs::read_to_string(path).expect("a text"));
    let _ = std::fs::remove_file(&out);
    let plain = |text: &str| text.split_whitespace().collect::<String>().replace(",]", "]").replace(",}", "}");
    assert!(plain(&now) == plain(&before), "web/src/bids.rs is old: tpg-page bids, then cargo fmt");
}
