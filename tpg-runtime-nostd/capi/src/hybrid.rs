//! A generated policy and a network that share an arm.

use crate::arm::{Ready, tpg_arm_t, tpg_move_t, tpg_pose_t};
use crate::code::{self, Refusal, TPG_ARGUMENT, TPG_LENGTH};
use crate::memory::{self, Opaque};
use crate::observation::tpg_observation_t;
use crate::policy::{Checked, tpg_policy_t};
use crate::sac::tpg_sac_t;
use crate::sensors::tpg_watch_t;
use tpg_arm::cycle::Brent;
use tpg_arm::hybrid::{CAUSES, Chosen, Control, Counts, Driver, Guard, Hybrid, Settings};
use tpg_arm::observation::{Observation, TargetMemo};
use tpg_arm::sac::packed::Model;
use tpg_arm::sensors::Limits;
use tpg_arm::{Arm, Move, Pose};
use tpg_runtime::policy::Policy;

/// The network keeps the arm until the episode ends.
pub const TPG_NEVER: u32 = 0xffff_ffff;

/// Every action of the graph is executed.
pub const TPG_GUARD_NONE: i32 = 0;
/// The network takes over instead of an action of the graph that leaves a joint's range.
pub const TPG_GUARD_JOINT_LIMITS: i32 = 1;
/// Nor one that collides.
pub const TPG_GUARD_COLLISIONS: i32 = 2;
/// And the network holds joints where that makes its action valid.
pub const TPG_GUARD_BOTH: i32 = 3;

/// The graph acts.
pub const TPG_DRIVER_GRAPH: i32 = 0;
/// The network acts.
pub const TPG_DRIVER_NETWORK: i32 = 1;

/// Causes of a hand-over: guard, drift, stop, cycle.
pub const TPG_CAUSES: usize = 4;

const _: () = assert!(TPG_CAUSES == CAUSES);

/// The times at which graph and network change, and the guard.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct tpg_settings_t {
    /// Actions of the network before the graph is asked again, from 1; with TPG_NEVER the network keeps the arm.
    pub hand_back_after: u32,
    /// The network takes over when the distance exceeds the best one so far by more than this, mm.
    pub separation: f32,
    /// A TPG_GUARD code.
    pub guard: i32,
}

impl tpg_settings_t {
    fn get(&self) -> Result<Settings<f32>, Refusal> {
        let guard = match self.guard {
            TPG_GUARD_NONE => Guard::None,
            TPG_GUARD_JOINT_LIMITS => Guard::JointLimits,
            TPG_GUARD_COLLISIONS => Guard::Collisions,
            TPG_GUARD_BOTH => Guard::Both,
            _ => return Err(Refusal(TPG_ARGUMENT)),
        };
        if self.hand_back_after == 0 || self.separation.is_nan() || self.separation < 0.0 {
            return Err(Refusal(TPG_ARGUMENT));
        }
        Ok(Settings { hand_back_after: self.hand_back_after, separation: self.separation, guard })
    }
}

/// An action, and the one that chose it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct tpg_chosen_t {
    /// The move that goes to the motors.
    pub wanted: tpg_move_t,
    /// A TPG_DRIVER code.
    pub driver: i32,
}

impl tpg_chosen_t {
    fn new(chosen: Chosen) -> Self {
        let driver = if chosen.driver == Driver::Tpg { TPG_DRIVER_GRAPH } else { TPG_DRIVER_NETWORK };
        Self { wanted: tpg_move_t { ticks: chosen.wanted.0 }, driver }
    }
}

/// Actions of each, and the reasons of their changes.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct tpg_counts_t {
    /// Actions of the graph.
    pub graph_actions: u32,
    /// Actions of the network.
    pub network_actions: u32,
    /// Hand-overs to the network: guard, drift, stop, cycle.
    pub hand_overs: [u32; TPG_CAUSES],
    /// Times that the network gave the arm back.
    pub hand_backs: u32,
}

impl tpg_counts_t {
    fn new(counts: &Counts) -> Self {
        let Counts { tpg_actions, sac_actions, hand_overs, hand_backs } = *counts;
        Self { graph_actions: tpg_actions, network_actions: sac_actions, hand_overs, hand_backs }
    }
}

/// A generated policy, checked.
struct Graph {
    arm: &'static Arm<f32>,
    policy: Checked<'static>,
    memo: TargetMemo<f32>,
}

impl Policy for Graph {
    type State = Observation<f32>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f32>) -> Move {
        self.policy.decide(self.arm, seen, &self.memo)
    }
}

/// A network with memory to compute in.
struct Network {
    arm: &'static Arm<f32>,
    model: &'static Model<'static>,
    scratch: *mut u32,
    words: usize,
}

impl Policy for Network {
    type State = Observation<f32>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f32>) -> Move {
        // SAFETY: tpg_hybrid_init has checked pointer and length, and the header asks that nothing else uses this memory.
        let scratch = unsafe { core::slice::from_raw_parts_mut(self.scratch, self.words) };
        self.model.decide(self.arm, seen, scratch)
    }
}

/// Words of a tpg_hybrid_t.
pub const TPG_HYBRID_WORDS: usize = 28;

/// A policy and a network with their settings. Opaque; initialised by tpg_hybrid_init.
///
/// It belongs to one task: it keeps what it has computed about the target. Two tasks need two hybrids with a scratch memory
/// each; they may share arm, policy and network.
#[repr(C)]
pub struct tpg_hybrid_t {
    /// The library's.
    pub opaque: [u64; TPG_HYBRID_WORDS],
}

/// The content of a tpg_hybrid_t.
pub struct Both {
    hybrid: Hybrid<'static, f32, Graph, Network>,
    limits: &'static Limits<f32>,
}

// SAFETY: any bytes are an array of integers; `initialise` proves that the content fits.
unsafe impl Opaque for tpg_hybrid_t {
    type Content = Both;
    const TAG: u32 = 0x4859_4202;
}

/// Words of a tpg_switch_t.
pub const TPG_SWITCH_WORDS: usize = 17;

/// The state of a control loop towards one target: the one whose turn it is, the last move that was commanded, the places
/// where the motors should be, and poses at which the hybrid's arm is free. So it goes with no other hybrid.
/// Opaque; initialised by tpg_switch_init for every target.
#[repr(C)]
pub struct tpg_switch_t {
    /// The library's.
    pub opaque: [u64; TPG_SWITCH_WORDS],
}

// SAFETY: any bytes are an array of integers; `initialise` proves that the content fits.
unsafe impl Opaque for tpg_switch_t {
    type Content = Control<f32, Brent>;
    const TAG: u32 = 0x5357_4902;
}

/// Joins a generated policy and a network. `arm`, `policy`, `sac` and `scratch` must stay where they are for as long as
/// the hybrid is used; `scratch`, of as many words as tpg_sac_scratch says, is the hybrid's alone.
///
/// TPG_ARGUMENT for settings that are not accepted: hand_back_after from 1, separation from 0 mm.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_hybrid_init(
    hybrid: *mut tpg_hybrid_t,
    arm: *const tpg_arm_t,
    policy: *const tpg_policy_t,
    sac: *const tpg_sac_t,
    settings: *const tpg_settings_t,
    scratch: *mut u32,
    words: usize,
) -> i32 {
    // SAFETY: the header's contract; the caller keeps all of it for as long as the hybrid lives.
    let (arm, policy, model, settings) = unsafe {
        (
            memory::content::<'static, tpg_arm_t>(arm),
            memory::read(policy),
            memory::content::<'static, tpg_sac_t>(sac),
            memory::read(settings),
        )
    };
    code::from_result(arm.and_then(|Ready { arm, limits }| {
        // SAFETY: as above.
        let policy = unsafe { Checked::new(policy?) }?;
        let (model, settings) = (model?, settings?.get()?);
        // SAFETY: as above. Only checked: the network makes a slice of it for each decision.
        unsafe { memory::array_mut(scratch, words) }?;
        if words < model.scratch() {
            return Err(Refusal(TPG_LENGTH));
        }
        let tpg = Graph { arm, policy, memo: TargetMemo::new() };
        let both = Both { hybrid: Hybrid { arm, tpg, sac: Network { arm, model, scratch, words }, settings }, limits };
        // SAFETY: the header's contract.
        unsafe { memory::initialise(hybrid, both) }
    }))
}

/// Begins a control loop towards a target: the graph drives, by the settings of the hybrid. `watch` may be NULL: the
/// defaults. TPG_BAD_TARGET or TPG_BAD_SENSOR for an observation that cannot be.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_switch_init(
    switch_: *mut tpg_switch_t,
    hybrid: *const tpg_hybrid_t,
    watch: *const tpg_watch_t,
    observation: *const tpg_observation_t,
) -> i32 {
    // SAFETY: the header's contract.
    let (hybrid, watch, seen) =
        unsafe { (memory::content(hybrid), tpg_watch_t::get(watch), memory::read(observation)) };
    code::from_result(hybrid.and_then(|Both { hybrid, limits }| {
        let control = Control::new(**limits, hybrid.settings, watch?, Brent::new(), seen?.get());
        // SAFETY: the header's contract.
        unsafe { memory::initialise(switch_, control.map_err(code::fault)?) }
    }))
}

/// One step of a control loop: takes a reading of the motors and the target (x, y, z in mm), answers what is seen and the
/// action that goes to the motors before the next step.
///
/// TPG_BAD_TARGET, TPG_BAD_SENSOR or TPG_STUCK where nothing may move; docs/sensors.md has the contract. The chosen move is
/// zero then, the observation is not written, and the switch is as before: the next step with a good reading goes on. After
/// TPG_STUCK it does once the motors are where the commands led them, or after tpg_switch_resume.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_hybrid_step(
    hybrid: *mut tpg_hybrid_t,
    switch_: *mut tpg_switch_t,
    motors: *const tpg_pose_t,
    target: *const f32,
    observation: *mut tpg_observation_t,
    chosen: *mut tpg_chosen_t,
) -> i32 {
    // Each check returns at once: six results side by side cost forty instructions a step.
    let step = || {
        // SAFETY: the header's contract.
        let (Both { hybrid, .. }, control, motors, target, seen, chosen) = unsafe {
            (
                memory::content(hybrid)?,
                memory::content_mut(switch_)?,
                memory::read(motors)?,
                memory::read(target.cast::<[f32; 3]>())?,
                memory::write(observation)?,
                memory::write(chosen)?,
            )
        };
        let decided = hybrid.step_into(control, Pose(motors.ticks), target, seen.get_mut());
        *chosen = tpg_chosen_t::new(decided.unwrap_or(Chosen { driver: Driver::Tpg, wanted: Move::STOP }));
        decided.map(|_| ()).map_err(code::fault)
    };
    code::from_result(step())
}

/// Starts to compare commanded with observed motion anew, from where the motors are: the way out of TPG_STUCK once its cause
/// is removed. The switch goes on as it is. TPG_BAD_SENSOR for a motor outside its joint's range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_switch_resume(switch_: *mut tpg_switch_t, motors: *const tpg_pose_t) -> i32 {
    // SAFETY: the header's contract.
    let (control, motors) = unsafe { (memory::content_mut(switch_), memory::read(motors)) };
    code::from_result(control.and_then(|control| control.resume(Pose(motors?.ticks)).map_err(code::fault)))
}

/// Gives the counts so far.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_switch_counts(switch_: *const tpg_switch_t, counts: *mut tpg_counts_t) -> i32 {
    // SAFETY: the header's contract.
    let (control, counts) = unsafe { (memory::content(switch_), memory::write(counts)) };
    code::answer(control.map(|control| tpg_counts_t::new(control.switch().counts())), counts)
}
