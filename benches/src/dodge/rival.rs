//! Controllers for the arm among balls that are not trained.

use tpg_arm::dodge::plan::{steps, straight};
use tpg_arm::dodge::{Behaviour, Body, Dodger, DodgerSettings, FIELD, Posture, View};
use tpg_arm::{Move, Pose};
use tpg_engine::random::{Purpose, Stream};
use tpg_problems::dodge::scene::Scene;
use tpg_problems::dodge::walk::{Leg, Outcome, candidate, follow, solutions};

/// A controller: one step of the arm after another.
pub(crate) trait Rival {
    /// Begins a scene.
    fn begin(&mut self, _body: &Body, _scene: &Scene, _view: &View<'_>) {}
    /// Returns the next step.
    fn step(&mut self, view: &View<'_>) -> Move;
}

/// Walks straight to its goal.
pub(crate) struct Straight;

impl Rival for Straight {
    fn step(&mut self, view: &View<'_>) -> Move {
        straight(view.pose, view.goal())
    }
}

/// Walks straight, and holds while a ball is predicted to come within 5 mm of that walk.
pub(crate) struct StopAndWait {
    /// Steps that it looks ahead; every eighth is looked at.
    pub horizon: u16,
}

impl Rival for StopAndWait {
    fn step(&mut self, view: &View<'_>) -> Move {
        let met = (8..=self.horizon).step_by(8).any(|time| {
            let posture = view.body.at(walked(view.pose, view.goal(), time));
            view.body.clearance_of_all(&posture, view.balls, f32::from(time)) < 5.0
        });
        if met { Move::STOP } else { straight(view.pose, view.goal()) }
    }
}

/// The pose after a number of steps of a straight walk.
fn walked(from: Pose, to: Pose, steps: u16) -> Pose {
    let most = i32::from(3 * steps);
    Pose(std::array::from_fn(|joint| {
        let (from, to) = (i32::from(from.0[joint]), i32::from(to.0[joint]));
        (from + (to - from).clamp(-most, most)) as i16
    }))
}

/// Walks in the potential field; with a script it goes upright for a while when there is no progress.
#[derive(Default)]
pub(crate) struct PotentialField {
    /// Steps without progress after which the script begins, and steps that it lasts; `None` without one.
    pub script: Option<(u32, u32)>,
    least: u32,
    since: u32,
    left: u32,
}

impl PotentialField {
    /// Creates it with a script.
    pub(crate) fn escaping(patience: u32, lasting: u32) -> Self {
        Self { script: Some((patience, lasting)), ..Self::default() }
    }
}

impl Rival for PotentialField {
    fn begin(&mut self, _: &Body, _: &Scene, _: &View<'_>) {
        (self.least, self.since, self.left) = (u32::MAX, 0, 0);
    }

    fn step(&mut self, view: &View<'_>) -> Move {
        let Some((patience, lasting)) = self.script else { return FIELD.step(view, view.goal()) };
        let away = steps(view.pose, view.goal());
        if self.left > 0 {
            self.left -= 1;
            (self.least, self.since) = (away, 0);
            return Self::upright(view);
        }
        if away < self.least {
            (self.least, self.since) = (away, 0);
        } else {
            self.since += 1;
        }
        if self.since >= patience {
            self.left = lasting;
        }
        FIELD.step(view, view.goal())
    }
}

impl PotentialField {
    /// Stretches upwards, in the field.
    fn upright(view: &View<'_>) -> Move {
        let [base, ..] = view.pose.0;
        FIELD.step(view, Pose([base, 2048, 2048, 2048]))
    }
}

/// Judges 82 moves, each held for up to 40 steps: what Fox, Burgard and Thrun's dynamic window is to a mobile robot.
pub(crate) struct OneStepSearch;

impl Rival for OneStepSearch {
    fn step(&mut self, view: &View<'_>) -> Move {
        let walk = straight(view.pose, view.goal());
        let moves = (0..81).map(|code: i32| {
            let digit = |place: u32| (code / 3_i32.pow(place) % 3 - 1) as i8 * 3;
            (Move([digit(0), digit(1), digit(2), digit(3)]), false)
        });
        let mut best = (f32::INFINITY, walk);
        for (step, walks) in moves.chain([(walk, true)]) {
            let cost = self.cost(view, step, walks);
            if cost < best.0 {
                best = (cost, step);
            }
        }
        best.1
    }
}

impl OneStepSearch {
    fn cost(&self, view: &View<'_>, step: Move, walks: bool) -> f32 {
        let (mut cost, mut pose) = (0.0, view.pose);
        for time in [4_u16, 16, 40] {
            pose = if walks { walked(view.pose, view.goal(), time) } else { held(view, step, time) };
            let posture = view.body.at(pose);
            cost += if view.body.is_free(&posture) { 0.0 } else { 1e4 };
            for ball in view.balls {
                let clearance = view.body.clearance(&posture, ball.after(time.into()), ball.radius);
                cost += if clearance < 0.0 { 100.0 * (50.0 - clearance) } else { 0.0 };
                cost += if clearance < 15.0 { 100.0 * (15.0 - clearance) / 15.0 } else { 0.0 };
            }
        }
        let ticks = pose.0.iter().zip(view.goal().0).map(|(at, goal)| at.abs_diff(goal));
        let (most, sum) = ticks.fold((0, 0.0), |(most, sum), ticks| (ticks.max(most), sum + f32::from(ticks)));
        cost + f32::from(most) / 3.0 + 0.02 * sum - if walks { 0.01 } else { 0.0 }
    }
}

/// The pose after a move was held for a number of steps, within the joints' ranges.
fn held(view: &View<'_>, step: Move, time: u16) -> Pose {
    Pose(std::array::from_fn(|joint| {
        let range = view.body.arm.ranges[joint];
        let ticks = i32::from(view.pose.0[joint]) + i32::from(step.0[joint]) * i32::from(time);
        ticks.clamp(range.min.into(), range.max.into()) as i16
    }))
}

/// Keeps a plan, checks every step of it for 160 steps by constant velocities, and samples others when it fails.
pub(crate) struct Replanner {
    samples: usize,
    goals: Vec<Pose>,
    plan: Vec<Leg>,
    random: Stream,
}

impl Replanner {
    /// Steps that it looks ahead.
    const HORIZON: u32 = 160;
    /// Clearance that it keeps, mm.
    const MARGIN: f32 = 5.0;

    /// Creates it with a number of samples each time.
    pub(crate) fn new(samples: usize) -> Self {
        Self { samples, goals: Vec::new(), plan: Vec::new(), random: Stream::new(9, 9, Purpose::Test, 9) }
    }

    /// The steps of a plan; more than 10,000 where it fails.
    fn cost(view: &View<'_>, plan: &[Leg]) -> f32 {
        let clearance = |posture: &Posture, time: u32| view.body.clearance_of_all(posture, view.balls, time as f32);
        match follow(view.body, view.pose, plan, Self::HORIZON, Self::MARGIN, clearance) {
            Outcome::Arrives(time) => time as f32,
            Outcome::Open(left) => (Self::HORIZON + left) as f32,
            Outcome::Hits(time) => 1e5 - time as f32,
            Outcome::Blocked => 1e6,
        }
    }
}

impl Rival for Replanner {
    fn begin(&mut self, body: &Body, scene: &Scene, view: &View<'_>) {
        self.goals = vec![view.goal()];
        self.goals.extend(solutions(body, scene.target, scene.start));
        self.plan = vec![Leg { to: view.goal(), wait: 0 }];
    }

    fn step(&mut self, view: &View<'_>) -> Move {
        let mut cost = Self::cost(view, &self.plan);
        if cost >= 9e4 {
            for index in 0..self.samples {
                let other = candidate(index, view.pose, &self.goals, &mut self.random);
                let of_other = Self::cost(view, &other);
                if of_other < cost {
                    (self.plan, cost) = (other, of_other);
                }
            }
        } else if self.plan.len() > 1 {
            let walk = vec![Leg { to: self.goals[0], wait: 0 }];
            if Self::cost(view, &walk) < cost {
                self.plan = walk;
            }
        }
        while self.plan.len() > 1 && self.plan[0] == (Leg { to: view.pose, wait: 0 }) {
            self.plan.remove(0);
        }
        let Some(leg) = self.plan.first_mut() else { return Move::STOP };
        if leg.to == view.pose {
            leg.wait = leg.wait.saturating_sub(1);
            return Move::STOP;
        }
        straight(view.pose, leg.to)
    }
}

/// Chooses a behaviour by hand, with the search and the guard that a graph has.
pub(crate) struct ByHand {
    settings: DodgerSettings,
    choose: fn(&Dodger) -> Behaviour,
    dodger: Option<Dodger>,
}

impl ByHand {
    /// Creates it.
    pub(crate) fn new(settings: DodgerSettings, choose: fn(&Dodger) -> Behaviour) -> Self {
        Self { settings, choose, dodger: None }
    }
}

impl Rival for ByHand {
    fn begin(&mut self, _: &Body, _: &Scene, view: &View<'_>) {
        self.dodger = Some(Dodger::new(self.settings, view));
    }

    fn step(&mut self, view: &View<'_>) -> Move {
        let Some(dodger) = &mut self.dodger else { return Move::STOP };
        let choice = (self.choose)(dodger);
        dodger.act(view, choice)
    }
}

/// Knows every ball's future: the certificate, step by step.
pub(crate) struct Clairvoyant {
    plan: Vec<Leg>,
    next: Box<dyn Iterator<Item = Vec<Leg>>>,
}

impl Clairvoyant {
    /// Creates it with the plans of the scenes, in their order.
    pub(crate) fn new(plans: Vec<Vec<Leg>>) -> Self {
        Self { plan: Vec::new(), next: Box::new(plans.into_iter()) }
    }
}

impl Rival for Clairvoyant {
    fn begin(&mut self, _: &Body, _: &Scene, _: &View<'_>) {
        self.plan = self.next.next().unwrap_or_default();
    }

    fn step(&mut self, view: &View<'_>) -> Move {
        while self.plan.len() > 1 && self.plan[0] == (Leg { to: view.pose, wait: 0 }) {
            self.plan.remove(0);
        }
        match self.plan.first_mut() {
            Some(leg) if leg.to == view.pose => {
                leg.wait = leg.wait.saturating_sub(1);
                Move::STOP
            }
            Some(leg) => straight(view.pose, leg.to),
            None => Move::STOP,
        }
    }
}
