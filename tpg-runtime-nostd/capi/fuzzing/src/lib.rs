//! The C interface as a fuzzer calls it: a sequence of functions with readings, models, descriptions and lengths of its
//! choice. Every pointer is NULL, misaligned or points to its structure, as the header's contract asks.

use core::ptr::null;
use tpg_runtime_capi::arm::*;
use tpg_runtime_capi::code::*;
use tpg_runtime_capi::dodge::*;
use tpg_runtime_capi::episode::*;
use tpg_runtime_capi::hybrid::*;
use tpg_runtime_capi::memo::*;
use tpg_runtime_capi::network::*;
use tpg_runtime_capi::observation::*;
use tpg_runtime_capi::policy::*;
use tpg_runtime_capi::sac::*;
use tpg_runtime_capi::sensors::*;

/// The most that a motor is asked to move in one step, ticks.
const STEP: u8 = 3;
/// Takes what a fuzzer wrote, and 0 behind its end.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        first
    }

    fn array<const N: usize>(&mut self) -> [u8; N] {
        [0; N].map(|_: u8| self.byte())
    }

    fn float(&mut self) -> f32 {
        match self.byte() % 4 {
            0 => f32::from_le_bytes(self.array()),
            1 => f32::from(i16::from_le_bytes(self.array())),
            2 => f32::from(self.byte() as i8),
            _ => [f32::NAN, f32::INFINITY, -f32::INFINITY, 3.4e38, 1e-40, 0.0][usize::from(self.byte() % 6)],
        }
    }

    fn vector(&mut self) -> [f32; 3] {
        [0; 3].map(|_: u8| self.float())
    }

    fn ticks(&mut self) -> i16 {
        match self.byte() % 4 {
            0 => i16::from_le_bytes(self.array()),
            1 => 2048,
            _ => 2048 + 4 * i16::from(self.byte() as i8),
        }
    }

    fn pose(&mut self) -> tpg_pose_t {
        tpg_pose_t { ticks: [0; 4].map(|_: u8| self.ticks()) }
    }

    fn ball(&mut self) -> tpg_ball_t {
        tpg_ball_t { at: self.vector(), velocity: self.vector(), radius: self.float() }
    }

    fn motion(&mut self) -> tpg_move_t {
        tpg_move_t { ticks: [0; 4].map(|_: u8| self.byte() as i8) }
    }
}

/// A generated policy: it reads its first value, and answers with an action that there may not be.
unsafe extern "C" fn infer(state: *const core::ffi::c_void) -> u16 {
    // SAFETY: the library hands in at least one float.
    let value = unsafe { *state.cast::<f32>() };
    if value > 1000.0 { 9 } else { u16::from(value > 0.0) }
}

fn known(code: i32) -> i32 {
    assert!((TPG_OK..=TPG_STUCK).contains(&code), "code {code}");
    code
}

/// Calls the functions that `data` chooses.
///
/// # Panics
/// If a function answers with an unknown code, or commands more than a step.
pub fn call(data: &[u8]) {
    let mut bytes = Bytes(data);
    // What nobody initialised is zero, as the header asks of memory that is used early.
    // SAFETY: all of these are plain data.
    let (mut arm, mut sac, mut network): (tpg_arm_t, tpg_sac_t, tpg_network_t) = unsafe { core::mem::zeroed() };
    // SAFETY: as above.
    let (mut hybrid, mut turn, mut memo): (tpg_hybrid_t, tpg_switch_t, tpg_memo_t) = unsafe { core::mem::zeroed() };
    // SAFETY: as above.
    let (mut episode, mut simulated): (tpg_episode_t, tpg_hybrid_episode_t) = unsafe { core::mem::zeroed() };
    // SAFETY: as above.
    let (mut watchdog, mut seen): (tpg_watchdog_t, tpg_observation_t) = unsafe { core::mem::zeroed() };
    // SAFETY: as above.
    let (mut chosen, mut counts): (tpg_chosen_t, tpg_counts_t) = unsafe { core::mem::zeroed() };
    // SAFETY: as above.
    let (mut body, mut dodger, mut dodge): (tpg_body_t, tpg_dodger_t, tpg_dodge_t) = unsafe { core::mem::zeroed() };
    // SAFETY: as above.
    let mut balls: [tpg_ball_t; TPG_BALLS + 1] = unsafe { core::mem::zeroed() };
    let behaviours: [u8; TPG_BEHAVIOURS as usize] = core::array::from_fn(|place| place as u8);
    let of_balls = [TPG_SOURCE_PROGRESS, TPG_SOURCE_NEAR];
    let among = tpg_dodge_policy_t {
        infer: Some(infer),
        sources: of_balls.as_ptr(),
        source_count: of_balls.len(),
        behaviours: behaviours.as_ptr(),
        behaviour_count: behaviours.len(),
    };
    let mut words = tpg_generated::widowx_sac::MODEL.to_vec();
    let mut scratch = vec![0_u32; 4096];
    let (mut wanted, mut pose) = (tpg_move_t { ticks: [0; 4] }, tpg_pose_t { ticks: [2048; 4] });
    let (mut target, mut answer, mut size, mut action) = ([100.0, 0.0, 200.0], 0_i32, 0_usize, 0_u16);
    let mut values = [0.0_f32; TPG_STATE_LENGTH];
    let sources = [TPG_SOURCE_STANCE, TPG_SOURCE_FLOOR];
    let moves = [tpg_move_t { ticks: [3, -3, 0, 0] }, tpg_move_t { ticks: [0, 3, -3, 3] }];
    let policy = tpg_policy_t {
        infer: Some(infer),
        sources: sources.as_ptr(),
        source_count: sources.len(),
        moves: moves.as_ptr(),
        move_count: moves.len(),
    };
    // SAFETY: every pointer below points to its structure, is NULL or is misaligned; lengths are those of the memory.
    unsafe {
        known(tpg_arm_init_widowx(&mut arm));
        known(tpg_sac_init(&mut sac, words.as_ptr(), words.len()));
        for _ in 0..64 {
            if bytes.0.is_empty() {
                return;
            }
            match bytes.byte() % 28 {
                0 => {
                    let mut description: tpg_arm_description_t = core::mem::zeroed();
                    let memory = (&raw mut description).cast::<u8>();
                    for place in 0..size_of_val(&description) {
                        *memory.add(place) = bytes.byte();
                    }
                    known(tpg_arm_init(&mut arm, &description));
                }
                1 => {
                    known(tpg_arm_init_widowx(&mut arm));
                }
                2 => pose = bytes.pose(),
                3 => target = bytes.vector(),
                4 => {
                    known(tpg_observe(&arm, &pose, target.as_ptr(), &mut seen));
                }
                5 => {
                    for _ in 0..4 {
                        let place = usize::from(u16::from_le_bytes(bytes.array())) % words.len();
                        words[place] = u32::from_le_bytes(bytes.array());
                    }
                    let length = usize::from(u16::from_le_bytes(bytes.array())).min(words.len());
                    known(tpg_sac_init(&mut sac, words.as_ptr(), length));
                    known(tpg_network_init(&mut network, words.as_ptr(), length));
                }
                6 => {
                    words = tpg_generated::widowx_sac::MODEL.to_vec();
                    known(tpg_sac_init(&mut sac, words.as_ptr(), words.len()));
                    known(tpg_network_init(&mut network, words.as_ptr(), words.len()));
                }
                7 => {
                    let separation = bytes.float();
                    let settings = tpg_settings_t {
                        hand_back_after: u32::from_le_bytes(bytes.array()),
                        separation,
                        guard: i32::from(bytes.byte() % 6) - 1,
                    };
                    let length = usize::from(u16::from_le_bytes(bytes.array())).min(scratch.len());
                    let memory = scratch.as_mut_ptr();
                    known(tpg_hybrid_init(&mut hybrid, &arm, &policy, &sac, &settings, memory, length));
                }
                8 => {
                    let watch = tpg_watch_t {
                        threshold: u16::from_le_bytes(bytes.array()),
                        patience: u16::from_le_bytes(bytes.array()),
                    };
                    known(tpg_watchdog_init(&mut watchdog, &arm, &watch, &pose));
                    known(tpg_switch_init(&mut turn, &hybrid, &watch, &seen));
                }
                9 => {
                    known(tpg_switch_init(&mut turn, &hybrid, null(), &seen));
                }
                10 => {
                    let code =
                        known(tpg_hybrid_step(&mut hybrid, &mut turn, &pose, target.as_ptr(), &mut seen, &mut chosen));
                    moves_at_most(&chosen.wanted, code);
                }
                11 => {
                    let code = known(tpg_hybrid_decide(&mut hybrid, &mut turn, &seen, &mut chosen));
                    moves_at_most(&chosen.wanted, code);
                }
                12 => {
                    known(tpg_switch_acted(&mut turn, &chosen, &seen, &mut answer));
                }
                13 => {
                    known(tpg_switch_resume(&mut turn, &pose));
                    known(tpg_switch_counts(&turn, &mut counts));
                }
                14 => {
                    let code = known(tpg_policy_decide(&policy, &arm, &seen, &mut memo, &mut wanted));
                    moves_at_most(&wanted, code);
                }
                15 => {
                    let length = usize::from(u16::from_le_bytes(bytes.array())).min(scratch.len());
                    let code = known(tpg_sac_decide(&sac, &arm, &seen, scratch.as_mut_ptr(), length, &mut wanted));
                    moves_at_most(&wanted, code);
                }
                16 => {
                    wanted = bytes.motion();
                    let place = &raw mut pose;
                    known(tpg_arm_step(&arm, place, &wanted, place, &mut answer));
                }
                17 => {
                    known(tpg_watchdog_check(&watchdog, &pose, target.as_ptr()));
                    known(tpg_watchdog_commanded(&mut watchdog, &pose, &wanted));
                    known(tpg_watchdog_resume(&mut watchdog, &pose));
                }
                18 => {
                    let max_actions = u32::from(bytes.byte());
                    let problem = tpg_problem_t { start: pose, target, tolerance: bytes.float(), max_actions };
                    known(tpg_episode_init(&mut episode, &arm, &problem));
                    known(tpg_hybrid_episode_init(&mut simulated, &mut hybrid, &problem));
                }
                19 => {
                    known(tpg_episode_advance(&mut episode, &wanted, &mut answer));
                    known(tpg_episode_observation(&episode, &mut seen));
                }
                20 => {
                    let code = known(tpg_hybrid_episode_decide(&mut simulated, &mut chosen));
                    moves_at_most(&chosen.wanted, code);
                    known(tpg_hybrid_episode_act(&mut simulated, &chosen, &mut answer));
                    known(tpg_hybrid_episode_counts(&simulated, &mut counts));
                }
                21 => {
                    let (length, source) = (usize::from(bytes.byte()).min(values.len()), bytes.byte());
                    let (state, seen) = (values.as_mut_ptr(), &raw const seen);
                    known(tpg_memo_init(&mut memo));
                    known(tpg_observation_state(&arm, seen, &mut memo, &source, 1, state, length));
                }
                22 => {
                    let (from, count) = (values.as_ptr(), usize::from(bytes.byte()).min(values.len()));
                    let (memory, needed) = (scratch.as_mut_ptr(), scratch.len());
                    let mut outputs = [0.0_f32; 16];
                    known(tpg_network_scratch(&network, &mut size));
                    known(tpg_network_values(&network, from, count, memory, needed, outputs.as_mut_ptr(), 16));
                    known(tpg_network_choose(&network, from, count, memory, needed, &mut action));
                }
                23 => balls = [0; TPG_BALLS + 1].map(|_: u8| bytes.ball()),
                24 => {
                    let radii = [0; TPG_CAPSULES].map(|_: u8| bytes.float());
                    known(tpg_body_init(
                        &mut body,
                        &arm,
                        if bytes.byte().is_multiple_of(2) { null() } else { radii.as_ptr() },
                    ));
                }
                25 => {
                    let goals = [0; TPG_GOALS].map(|_: u8| bytes.pose());
                    let (count, seen) =
                        (usize::from(bytes.byte()) % (TPG_GOALS + 1), usize::from(bytes.byte()) % balls.len());
                    let settings =
                        tpg_dodger_settings_t { effort: u16::from_le_bytes(bytes.array()), guard: bytes.byte() % 3 };
                    let settings = if bytes.byte().is_multiple_of(2) { null() } else { &raw const settings };
                    let (goals, seen_from) = (goals.as_ptr(), balls.as_ptr());
                    let (loop_, body) = (&raw mut dodger, &raw const body);
                    known(tpg_dodger_init(loop_, body, &among, settings, null(), goals, count, &pose, seen_from, seen));
                }
                26 => {
                    let count = usize::from(bytes.byte()) % (balls.len() + 1);
                    let code = known(tpg_dodger_step(&mut dodger, &pose, balls.as_ptr(), count, &mut dodge));
                    moves_at_most(&dodge.wanted, code);
                    if bytes.byte().is_multiple_of(4) {
                        known(tpg_dodger_resume(&mut dodger, &pose));
                    }
                }
                _ => {
                    known(tpg_arm_hand(&arm, null(), values.as_mut_ptr()));
                    let misaligned = (&raw const pose).cast::<u8>().wrapping_add(1).cast();
                    assert_eq!(tpg_arm_hand(&arm, misaligned, values.as_mut_ptr()), TPG_MISALIGNED);
                    known(tpg_arm_collision(&arm, &pose, &mut answer));
                    known(tpg_arm_home(&arm, &mut pose));
                }
            }
        }
    }
}

/// A decision that is refused moves nothing, one that is made moves each motor by a step at most.
fn moves_at_most(wanted: &tpg_move_t, code: i32) {
    if code == TPG_OK {
        assert!(wanted.ticks.iter().all(|ticks| ticks.unsigned_abs() <= STEP), "{:?}", wanted.ticks);
    }
}
