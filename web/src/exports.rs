//! The functions that a page calls: plain C, no imports. Numbers out of range do nothing.
//!
//! Everything lies in one place for the one thread of a page. A pointer is valid for as long as the page lives; what lies
//! there changes with the next call.
#![allow(unsafe_code, reason = "an export has a name without mangling; nothing else here is unsafe")]

use crate::arm::{self, Scene};
use crate::balls::{self, Balls};
use crate::control::{self, Rig};
use crate::eye::{self, Camera};
use core::cell::RefCell;
use core::ptr;

thread_local! {
    static SCENE: RefCell<Option<Scene>> = RefCell::new(Scene::new());
    static BYTES: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static BALLS: RefCell<Balls> = RefCell::new(Balls::default());
    static CAMERA: RefCell<Camera> = RefCell::new(Camera::new(1));
    static RIGS: RefCell<[Box<dyn Rig>; 3]> = RefCell::new(control::rigs());
}

fn scene(act: impl FnOnce(&mut Scene)) {
    SCENE.with_borrow_mut(|scene| scene.as_mut().map(act));
}

fn rig(problem: u32, act: impl FnOnce(&mut dyn Rig)) {
    RIGS.with_borrow_mut(|rigs| {
        if let Some(rig) = rigs.get_mut(problem as usize) {
            act(rig.as_mut());
        }
    });
}

/// Moves the target of all arms, mm; each goes on from where it is.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_arm_aim(x: f64, y: f64, z: f64) {
    scene(|scene| scene.aim([x, y, z]));
}

/// Puts all arms in the pose at rest.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_arm_home() {
    scene(Scene::home);
}

/// Puts all arms where the first one is.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_arm_gather() {
    scene(Scene::gather);
}

/// Lets an arm (0 hybrid, 1 graph, 2 network, 3 planner) do up to `count` actions.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_arm_act(arm: u32, count: u32) {
    scene(|scene| scene.act(arm as usize, count));
}

/// Returns the place of an arm's [`arm::ArmView`]; null if the network in flash is damaged.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_arm_view(arm: u32) -> *const arm::ArmView {
    SCENE.with_borrow(|scene| scene.as_ref().map_or(ptr::null(), |scene| ptr::from_ref(scene.view(arm as usize))))
}

/// Returns the place for the bytes of a scene, which a page writes before it begins.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_balls_scene(length: u32) -> *mut u8 {
    BYTES.with_borrow_mut(|bytes| {
        bytes.resize(length as usize, 0);
        bytes.as_mut_ptr()
    })
}

/// Begins the scene that was written, for both arms (0 policy, 1 straight walk). Bytes that are not a scene change nothing.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_balls_begin() {
    if let Some(scene) = BYTES.with_borrow(|bytes| balls::scene(bytes)) {
        BALLS.with_borrow_mut(|balls| balls.begin(&scene));
    }
}

/// Lets an arm among balls take a step.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_balls_act(arm: u32) {
    BALLS.with_borrow_mut(|balls| balls.act(arm as usize));
}

/// Returns the place of an arm's [`balls::BallsView`].
#[unsafe(no_mangle)]
pub extern "C" fn tpg_balls_view(arm: u32) -> *const balls::BallsView {
    BALLS.with_borrow(|balls| ptr::from_ref(balls.view(arm as usize)))
}

/// Begins an episode of a problem (0 CartPole, 1 Pendulum, 2 MountainCar), drawn by a seed.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_control_restart(problem: u32, seed: u32) {
    rig(problem, |rig| rig.restart(seed));
}

/// Lets a problem's policy act once.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_control_act(problem: u32) {
    rig(problem, |rig| rig.act());
}

/// Adds to one value of a problem's state: a push from outside.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_control_push(problem: u32, value: u32, by: f64) {
    rig(problem, |rig| rig.push(value as usize, by));
}

/// Sets one of the constants of a problem that a page may change.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_control_set(problem: u32, constant: u32, to: f64) {
    rig(problem, |rig| rig.set(constant as usize, to));
}

/// Returns the place of a problem's [`control::ControlView`]; null for a problem that there is not.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_control_view(problem: u32) -> *const control::ControlView {
    RIGS.with_borrow(|rigs| rigs.get(problem as usize).map_or(ptr::null(), |rig| ptr::from_ref(rig.view())))
}

/// Begins a scene of the camera, drawn by a seed.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_eye_restart(seed: u32) {
    CAMERA.replace(Camera::new(seed));
}

/// Lets the camera's policy act once.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_eye_act() {
    CAMERA.with_borrow_mut(Camera::act);
}

/// Puts the ball at a distance from the middle of the camera's image, pixels.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_eye_drag(down: f32, right: f32) {
    CAMERA.with_borrow_mut(|camera| camera.drag(down, right));
}

/// Returns the place of the camera's [`eye::EyeView`].
#[unsafe(no_mangle)]
pub extern "C" fn tpg_eye_view() -> *const eye::EyeView {
    CAMERA.with_borrow(|camera| ptr::from_ref(camera.view()))
}
