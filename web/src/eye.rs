//! A camera that follows a ball: the shipped policy on images of the simulation that trained it.

use tpg_generated::eye::Eye;
use tpg_problems::eye::{COLUMNS, EyeScene, ROWS};
use tpg_runtime::policy::Policy;

/// A camera as a page reads it; the same layout in JavaScript.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EyeView {
    /// The image, row after row.
    pub pixels: [u8; ROWS * COLUMNS],
    /// Row, column and contrast of the brightest window of the image, then of the darkest.
    pub seen: [f32; 6],
    /// Tilt and pan, pixels, that the policy answers to the image.
    pub action: [f32; 2],
    /// The ball's distance from the middle, down and to the right, pixels.
    pub ball: [f32; 2],
    /// 1 where the ball has left the image.
    pub ended: u32,
}

/// A camera under way.
#[derive(Debug)]
pub struct Camera {
    scene: EyeScene,
    view: EyeView,
}

impl Camera {
    /// Begins the scene of a seed.
    pub fn new(seed: u32) -> Self {
        let view = EyeView { pixels: [0; ROWS * COLUMNS], seen: [0.0; 6], action: [0.0; 2], ball: [0.0; 2], ended: 0 };
        let mut camera = Self { scene: EyeScene::new(seed.into()), view };
        camera.look();
        camera
    }

    fn look(&mut self) {
        let view = &mut self.view;
        view.pixels.copy_from_slice(&self.scene.pixels());
        let is_seen = Eye.look(&view.pixels, COLUMNS, &mut view.seen);
        debug_assert!(is_seen, "the image is whole");
        view.action = Eye.decide(&view.seen);
        view.ball = self.scene.distance();
    }

    /// Does what the policy answers to the image; nothing once the ball is lost.
    pub fn act(&mut self) {
        if self.view.ended == 0 {
            self.view.ended = u32::from(self.scene.step(self.view.action).end.is_some());
            self.look();
        }
    }

    /// Puts the ball somewhere in the image, at rest.
    pub fn drag(&mut self, down: f32, right: f32) {
        let ends = [ROWS as f32 / 2.0, COLUMNS as f32 / 2.0];
        if down.abs() < ends[0] && right.abs() < ends[1] {
            self.scene.put_ball([down, right]);
            self.look();
        }
    }

    /// Shows it.
    pub fn view(&self) -> &EyeView {
        &self.view
    }
}
