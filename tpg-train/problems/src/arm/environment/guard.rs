//! A graph and a network that share the arm: what the network sees and does, and the guard.

use super::{ArmEnvironment, ArmEpisode};
use crate::arm::motors;
use crate::registry::Number;
use tpg_arm::Move;
use tpg_arm::frame::Frame;
use tpg_arm::hybrid::Guard;
use tpg_arm::sac::features;
use tpg_engine::{Act, Guarded, Output};
use tpg_graph::SourceDocument;

impl<S: Number> ArmEnvironment<S> {
    /// Returns the move that a network's values make: preferences of −1 to 1.
    pub(super) fn steered(&self, episode: &ArmEpisode<S>, values: &[S]) -> Move {
        let preferences = std::array::from_fn(|joint| libm::atanhf(values[joint].to_f64() as f32));
        self.decision.decide(preferences, episode.pose, &self.arm.ranges)
    }
}

impl<S: Number> Guarded<S, ArmEpisode<S>> for ArmEnvironment<S> {
    fn network_sources(&self) -> Vec<SourceDocument> {
        motors::sources()
    }

    fn network_outputs(&self) -> Vec<Output> {
        motors::outputs()
    }

    /// The target is rounded before a feature is computed of it.
    fn network_observe(&self, episode: &mut ArmEpisode<S>, state: &mut [f32]) {
        let target = episode.target.map(|value| value.to_f64() as f32);
        state.copy_from_slice(&features(&Frame::at(&self.narrow, episode.pose, target)));
    }

    fn guards(&self) -> &'static [&'static str] {
        &["none", "joint-limits", "collisions", "both"]
    }

    /// A graph that would rest is refused by every guard: the network goes on.
    fn refuses(&self, guard: &str, episode: &ArmEpisode<S>, act: Act<'_, S>) -> bool {
        let (Act::Choice(action), Some(guard)) = (act, Guard::from_name(guard)) else { return false };
        let wanted = self.moves.get(usize::from(action.0)).copied().unwrap_or(Move::STOP);
        let collision = |moved| self.plane(moved).collision(&self.arm.shapes);
        wanted == Move::STOP || guard.refuses(&self.arm, episode.pose, wanted, collision)
    }

    fn mend(&self, guard: &str, episode: &ArmEpisode<S>, values: &mut [S]) -> bool {
        let Some(guard) = Guard::from_name(guard) else { return true };
        let wanted = self.steered(episode, values);
        let part = guard.part(&self.arm, episode.pose, wanted);
        // A preference that is no number leaves its joint at rest.
        let held = part.unwrap_or(Move::STOP).0.into_iter().zip(wanted.0).map(|(part, wanted)| part != wanted);
        let all = part.is_none();
        for (value, held) in values.iter_mut().zip(held) {
            if held || all {
                *value = S::from_f64(f64::NAN);
            }
        }
        part.is_some()
    }
}
