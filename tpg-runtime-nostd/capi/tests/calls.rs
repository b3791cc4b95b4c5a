//! Every function of the C interface, called as C calls it: through raw pointers, into memory that was never written.
//!
//! `cargo xtask miri` runs this under Miri, which sees what no sanitizer does: references that overlap, memory that is read
//! before it is written, pointers beyond their provenance. `tests/c/calls.c` does many more calls.

use core::mem::MaybeUninit;
use core::ptr::{null, null_mut};
use tpg_runtime_capi::arm::*;
use tpg_runtime_capi::code::*;
use tpg_runtime_capi::hybrid::*;
use tpg_runtime_capi::memo::*;
use tpg_runtime_capi::network::*;
use tpg_runtime_capi::observation::*;
use tpg_runtime_capi::policy::*;
use tpg_runtime_capi::sac::*;
use tpg_runtime_capi::sensors::*;
use tpg_testing::numbers::Numbers;

/// Memory for a structure, as C has it: with whatever was there before.
fn raw<T>() -> Box<MaybeUninit<T>> {
    Box::new(MaybeUninit::uninit())
}

/// Memory for an opaque structure that may be used before it is initialised.
fn zeroed<T>() -> Box<MaybeUninit<T>> {
    Box::new(MaybeUninit::zeroed())
}

fn any_float(numbers: &mut Numbers) -> f32 {
    match numbers.next_u32() % 8 {
        0 => f32::NAN,
        1 => f32::NEG_INFINITY,
        2 => 3.4e38,
        3 => f32::from_bits(numbers.next_u32() << 1),
        _ => numbers.within(300) as f32,
    }
}

fn any_ticks(numbers: &mut Numbers) -> i16 {
    match numbers.next_u32() % 8 {
        0 => i16::MAX,
        1 => i16::MIN,
        _ => (2048 + numbers.within(900)) as i16,
    }
}

/// A generated policy: it reads its first value.
unsafe extern "C" fn infer(state: *const core::ffi::c_void) -> u16 {
    // SAFETY: the library hands in at least one float.
    u16::from(unsafe { *state.cast::<f32>() } > 0.0)
}

#[test]
fn every_function_keeps_to_the_memory_that_it_was_given() {
    let rounds = if cfg!(miri) { 3 } else { 300 };
    let mut numbers = Numbers(1);
    let words = tpg_generated::widowx_sac::MODEL.to_vec();
    let [mut arm, mut own] = [zeroed::<tpg_arm_t>(), zeroed::<tpg_arm_t>()];
    let (mut sac, mut network) = (zeroed::<tpg_sac_t>(), zeroed::<tpg_network_t>());
    let (mut hybrid, mut turn) = (zeroed::<tpg_hybrid_t>(), zeroed::<tpg_switch_t>());
    let (mut memo, mut watchdog) = (zeroed::<tpg_memo_t>(), zeroed::<tpg_watchdog_t>());
    let (arm, own, sac, network) = (arm.as_mut_ptr(), own.as_mut_ptr(), sac.as_mut_ptr(), network.as_mut_ptr());
    let (hybrid, turn) = (hybrid.as_mut_ptr(), turn.as_mut_ptr());
    let (memo, watchdog) = (memo.as_mut_ptr(), watchdog.as_mut_ptr());
    // SAFETY: every pointer is NULL, misaligned, or points to its structure: the header's contract.
    unsafe {
        assert_eq!(tpg_arm_home(arm, raw::<tpg_pose_t>().as_mut_ptr()), TPG_STATE);
        assert_eq!(tpg_arm_init_widowx(arm), TPG_OK);
        assert_eq!(tpg_sac_init(sac, words.as_ptr(), words.len()), TPG_OK);
        assert_eq!(tpg_network_init(network, words.as_ptr(), words.len()), TPG_OK);
        let mut size = raw::<usize>();
        assert_eq!(tpg_sac_scratch(sac, size.as_mut_ptr()), TPG_OK);
        let needed = size.assume_init_read();
        for ask in [tpg_network_scratch, tpg_network_inputs, tpg_network_outputs] {
            assert_eq!(ask(network, size.as_mut_ptr()), TPG_OK);
        }
        let mut scratch = vec![0u32; needed];
        let scratch = scratch.as_mut_ptr();
        let sources = [TPG_SOURCE_STANCE, TPG_SOURCE_FLOOR];
        let moves = [tpg_move_t { ticks: [3, -3, 0, 0] }, tpg_move_t { ticks: [0, 3, -3, 3] }];
        let policy = tpg_policy_t {
            infer: Some(infer),
            sources: sources.as_ptr(),
            source_count: sources.len(),
            moves: moves.as_ptr(),
            move_count: moves.len(),
        };
        let settings = tpg_settings_t { hand_back_after: 3, separation: 5.0, guard: TPG_GUARD_BOTH };
        assert_eq!(tpg_hybrid_init(hybrid, arm, &policy, sac, &settings, scratch, needed), TPG_OK);
        assert_eq!(tpg_memo_init(memo), TPG_OK);
        for round in 0..rounds {
            let mut pose = tpg_pose_t { ticks: [0; 4].map(|_: i16| any_ticks(&mut numbers)) };
            if round % 2 == 0 {
                assert_eq!(tpg_arm_home(arm, &raw mut pose), TPG_OK);
            }
            let target = match round % 3 {
                0 => [0.0; 3].map(|_: f32| any_float(&mut numbers)),
                _ => [numbers.within(200) as f32, numbers.within(200) as f32, 150.0],
            };
            let (mut seen, mut chosen, mut wanted) = (raw(), raw::<tpg_chosen_t>(), raw::<tpg_move_t>());
            let (mut hand, mut answer) = (raw::<[f32; 3]>(), raw::<i32>());
            assert_eq!(tpg_observe(arm, &pose, target.as_ptr(), seen.as_mut_ptr()), TPG_OK);
            assert_eq!(tpg_observation_distance(seen.as_ptr(), hand.as_mut_ptr().cast()), TPG_OK);
            assert_eq!(tpg_arm_hand(arm, &pose, hand.as_mut_ptr().cast()), TPG_OK);
            assert_eq!(tpg_arm_collision(arm, &pose, answer.as_mut_ptr()), TPG_OK);
            for source in 0..=TPG_SOURCE_STANCE {
                let mut state = raw::<[f32; TPG_STATE_LENGTH]>();
                let (values, kept) = (state.as_mut_ptr().cast(), if source % 2 == 0 { memo } else { null_mut() });
                assert_eq!(
                    tpg_observation_state(arm, seen.as_ptr(), kept, &source, 1, values, TPG_STATE_LENGTH),
                    TPG_OK
                );
            }
            let good = |code| [TPG_OK, TPG_BAD_TARGET, TPG_BAD_SENSOR, TPG_STUCK].contains(&code);
            assert!(good(tpg_policy_decide(&policy, arm, seen.as_ptr(), memo, wanted.as_mut_ptr())));
            assert!(good(tpg_sac_decide(sac, arm, seen.as_ptr(), scratch, needed, wanted.as_mut_ptr())));
            let wanted = wanted.assume_init_read();
            // In place, as the header allows.
            let place = &raw mut pose;
            assert_eq!(tpg_arm_step(arm, place, &wanted, place, answer.as_mut_ptr()), TPG_OK);
            if tpg_switch_init(turn, hybrid, null(), seen.as_ptr()) == TPG_OK {
                let mut counts = raw::<tpg_counts_t>();
                for _ in 0..3 {
                    let (motors, target) = (&raw const pose, target.as_ptr());
                    assert!(good(tpg_hybrid_step(
                        hybrid,
                        turn,
                        motors,
                        target,
                        seen.as_mut_ptr(),
                        chosen.as_mut_ptr()
                    )));
                }
                assert_eq!(tpg_switch_counts(turn, counts.as_mut_ptr()), TPG_OK);
                assert!(good(tpg_switch_resume(turn, &pose)));
            }
            let watch = tpg_watch_t { threshold: 4, patience: 8 };
            if tpg_watchdog_init(watchdog, arm, &watch, &pose) == TPG_OK {
                assert!(good(tpg_watchdog_check(watchdog, &pose, target.as_ptr())));
                assert_eq!(tpg_watchdog_commanded(watchdog, &pose, &wanted), TPG_OK);
                assert!(good(tpg_watchdog_resume(watchdog, &pose)));
            }
            let values = hand.as_mut_ptr().cast();
            assert_eq!(tpg_network_values(network, target.as_ptr(), 3, scratch, needed, values, 3), TPG_ARGUMENT);
            let mut action = raw::<u16>();
            let choose = tpg_network_choose(network, target.as_ptr(), 3, scratch, needed, action.as_mut_ptr());
            assert_eq!(choose, TPG_ARGUMENT);
            // Pointers that can be noticed, and an arm that cannot be.
            assert_eq!(tpg_arm_hand(null(), &pose, values), TPG_NULL);
            let misaligned = (&raw const pose).cast::<u8>().wrapping_add(1).cast();
            assert_eq!(tpg_arm_hand(arm, misaligned, values), TPG_MISALIGNED);
            let mut description = MaybeUninit::<tpg_arm_description_t>::zeroed().assume_init();
            description.home = pose;
            assert_eq!(tpg_arm_init(own, &description), TPG_ARGUMENT);
        }
    }
}
