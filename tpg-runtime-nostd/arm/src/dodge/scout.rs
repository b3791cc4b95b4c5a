//! A search that never stops and never takes long: in every step it looks at a few poses of a few plans, and goes on in the
//! next step where it stopped.

use super::ball::Ball;
use super::behaviour::{BALLS, View};
use super::plan::{Plan, steps, towards};
use crate::arm::Pose;

/// Steps that the search looks ahead for balls that move.
pub const HORIZON: u32 = 160;
/// Steps of a plan that are looked at, at most.
const LIMIT: u32 = 4000;
/// Effort of one look at a pose of a plan: where the arm is, and the distance of nothing yet.
const LOOK: u16 = 410;
/// Effort of a ball that is far, and of one that is near.
const FAR_BALL: u16 = 85;
const NEAR_BALL: u16 = 270;
/// Effort of a pose near the table or the base, and of a face of the arm near the base.
const BASE: u16 = 240;
const FACE: u16 = 120;
/// Effort of a new plan, with the comparison that may refuse it.
const PROPOSE: u16 = 420;
/// Effort of beginning with a plan, and of judging it in the end.
const BEGIN: u16 = 300;
/// Clearance up to which it is computed exactly, mm.
const NEAR: f32 = 40.0;

/// The part of a step's effort that is kept for the plan itself: enough for a look at a pose near every ball and the base.
const WATCH: u16 = 2600;
/// Clearance below which a ball is met, mm.
const MARGIN: f32 = 4.0;
/// The same for a ball that stays: it is known where it will be.
const STILL: f32 = 0.6;
/// Speed of the arm's points that is reckoned with when the next look is placed, mm a step.
const PACE: f32 = 2.0;
/// Fewest steps between two looks.
const STRIDE: u16 = 16;
/// Steps by which another plan must be faster to be taken, where both are free.
const GAIN: u32 = 20;
/// Standard deviations of a detour's pose from the straight way, ticks; equally likely.
const SPREADS: [i16; 4] = [150, 250, 400, 700];

/// The end that a plan was found to have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Fate {
    /// A ball, the table or the base, and the number of steps until then.
    Meets(u16),
    /// Nothing: no ball that moves within the horizon, no ball that stays, nor table or base, until the goal.
    Free,
}

impl Fate {
    /// Returns the steps until something is met, at most the horizon.
    pub fn free_steps(self) -> u16 {
        match self {
            Self::Meets(steps) => steps.min(HORIZON as u16),
            Self::Free => HORIZON as u16,
        }
    }
}

/// What a look asks of a ball: found once a step.
#[derive(Clone, Copy)]
struct Watched {
    ball: Ball,
    /// True if it is known where it will be at any time.
    stays: bool,
    /// Clearance below which it is met, mm.
    margin: f32,
    /// The speed at which it and the arm come together at most, mm a step.
    closing: f32,
}

/// The balls as looks need them; places without one come last.
#[inline(always)]
fn watched(balls: &[Ball]) -> [Watched; BALLS] {
    const NOBODY: Ball = Ball { at: [0.0; 3], velocity: [0.0; 3], radius: 0.0 };
    let mut all = [Watched { ball: NOBODY, stays: true, margin: 0.0, closing: 1.0 }; BALLS];
    for (watched, &ball) in all.iter_mut().zip(balls) {
        let stays = ball.stays();
        let margin = if stays { STILL } else { MARGIN };
        *watched = Watched { ball, stays, margin, closing: PACE + ball.speed_bound() };
    }
    all
}

/// A plan under examination.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Probe {
    plan: Plan,
    from: Pose,
    /// Steps that have passed since it began.
    age: u16,
    /// Steps after its beginning at which it is looked at next.
    next: u16,
    /// Steps after its beginning at which it comes to the pose on the way, at which it leaves it, and at its end.
    stay: u16,
    turn: u16,
    last: u16,
}

impl Probe {
    fn new(plan: Plan, from: Pose) -> Self {
        let turn = plan.turn(from);
        let last = turn + steps(plan.last_corner(from), plan.goal);
        let stay = turn - plan.via.map_or(0, |(_, wait)| u32::from(wait));
        let [stay, turn, last] = [stay, turn, last].map(|time| time.min(LIMIT) as u16);
        Self { plan, from, age: 0, next: 1, stay, turn, last }
    }

    /// The pose at which it is looked at next.
    #[inline(always)]
    fn pose(&self) -> Pose {
        match self.plan.via {
            Some((via, _)) if self.next <= self.turn => towards(self.from, via, self.next),
            Some((via, _)) => towards(via, self.plan.goal, self.next - self.turn),
            None => towards(self.from, self.plan.goal, self.next),
        }
    }

    /// Looks at a plan until its fate is known or too little effort is left for a look.
    #[inline(never)] // once in flash
    fn look(&mut self, view: &View<'_>, balls: &[Watched], effort: &mut u16) -> Option<Fate> {
        while *effort >= LOOK + NEAR_BALL * view.balls.len() as u16 {
            *effort -= LOOK;
            let posture = view.body.at(self.pose());
            let outline = posture.outline();
            let after = f32::from(self.next) - f32::from(self.age);
            let mut skip = HORIZON as f32;
            // Nobody knows where a ball that moves will be by then; one that stays is there.
            let beyond = after > HORIZON as f32;
            for &Watched { ref ball, stays, margin, closing } in balls {
                if beyond && !stays {
                    continue;
                }
                let centre = ball.after(after);
                let mut clearance = view.body.clearance_bound(&posture, &outline, centre, ball.radius);
                *effort -= FAR_BALL;
                if clearance < NEAR {
                    *effort -= NEAR_BALL - FAR_BALL;
                    clearance = view.body.clearance(&posture, centre, ball.radius);
                }
                let room = clearance - margin;
                if room < 0.0 {
                    return Some(self.met());
                }
                let pause = room / closing;
                if pause < skip {
                    skip = pause;
                }
            }
            if !view.body.is_clearly_free(&posture) {
                if *effort < BASE + 4 * FACE {
                    // It is looked at again in the next step.
                    *effort = 0;
                    return None;
                }
                let (free, faces) = view.body.is_free_after(&posture);
                *effort -= BASE + FACE * faces;
                if !free {
                    return Some(self.met());
                }
            }
            if self.next >= self.last {
                return Some(Fate::Free);
            }
            self.next = (self.next + (skip as u16).max(STRIDE)).min(self.last);
            if beyond && self.next > self.stay {
                // The arm waits there.
                self.next = self.next.max(self.turn);
            }
        }
        None
    }

    /// Something is met where the plan was just looked at.
    fn met(&self) -> Fate {
        Fate::Meets(self.next.saturating_sub(self.age))
    }
}

/// The search, with the best plan so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scout {
    /// The cost that a whole control step may have.
    effort: u16,
    plan: Plan,
    /// The plan's fate when it was examined last, and the steps since.
    fate: Fate,
    /// Steps until the straight walk meets something, when it was examined last.
    straight: Fate,
    watch: Probe,
    /// The last candidate, and true while it is under examination.
    candidate: Probe,
    examines: bool,
    /// Number of candidates so far.
    count: u16,
    random: u32,
}

impl Scout {
    /// Begins a search for a task. `effort` is the cost that a whole control step may have, in instructions of a Cortex-M4, about: the
    /// search takes what seeing, behaviour and guard leave.
    pub fn new(effort: u16, view: &View<'_>) -> Self {
        let plan = Plan::straight(view.goal());
        let probe = Probe::new(plan, view.pose);
        let (fate, random) = (Fate::Free, 0x9E37_79B9);
        Self { effort, plan, fate, straight: fate, watch: probe, candidate: probe, examines: false, count: 0, random }
    }

    /// Returns the plan.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Returns the plan, to be followed.
    pub(crate) fn plan_mut(&mut self) -> &mut Plan {
        &mut self.plan
    }

    /// Returns the plan's fate when it was looked at last.
    pub fn fate(&self) -> Fate {
        self.fate
    }

    /// Returns the fate of the straight walk when it was looked at last.
    pub fn straight(&self) -> Fate {
        self.straight
    }

    /// Searches for one step; `spent` of its effort has gone elsewhere.
    pub fn step(&mut self, view: &View<'_>, spent: u16) {
        self.watch.age = self.watch.age.saturating_add(1);
        self.candidate.age = self.candidate.age.saturating_add(1);
        let mut effort = self.effort.saturating_sub(spent);
        let mut kept = WATCH.min(effort);
        effort -= kept;
        let watched = watched(view.balls);
        let balls = watched.get(..view.balls.len()).unwrap_or(&watched);
        if let Some(fate) = self.watch.look(view, balls, &mut kept) {
            self.fate = fate;
            self.watch = Probe::new(self.plan, view.pose);
            kept = kept.saturating_sub(BEGIN);
        }
        effort += kept;
        let mut arrival = None;
        loop {
            if !self.examines {
                if effort < PROPOSE + BEGIN {
                    return;
                }
                effort -= PROPOSE;
                let plan = self.propose(view);
                // A detour that would not be taken though it were free. The straight walk's fate is looked at all the same.
                if plan.via.is_some() && self.fate == Fate::Free {
                    let arrival = *arrival.get_or_insert_with(|| self.plan.arrival(view.pose));
                    if !self.is_faster(&plan, view.pose, arrival) {
                        continue;
                    }
                }
                effort -= BEGIN;
                self.candidate = Probe::new(plan, view.pose);
                self.examines = true;
            }
            let Some(fate) = self.candidate.look(view, balls, &mut effort) else { return };
            self.examines = false;
            self.judge(view, fate);
            arrival = None;
        }
    }

    /// Compares a candidate with the plan.
    fn judge(&mut self, view: &View<'_>, fate: Fate) {
        let plan = self.candidate.plan;
        if plan == Plan::straight(view.goal()) {
            self.straight = fate;
        }
        let better = match (fate, self.fate) {
            (Fate::Free, Fate::Meets(_)) => true,
            (Fate::Free, Fate::Free) => self.is_faster(&plan, view.pose, self.plan.arrival(view.pose)),
            (Fate::Meets(_), Fate::Meets(_)) => fate.free_steps() > self.fate.free_steps() + 10,
            (Fate::Meets(_), Fate::Free) => false,
        };
        if better {
            (self.plan, self.fate) = (plan, fate);
            self.watch = Probe::new(plan, view.pose);
        }
    }

    /// True if a free plan arrives earlier than a free one that takes `arrival` steps, by at least the gain.
    fn is_faster(&self, plan: &Plan, from: Pose, arrival: u32) -> bool {
        plan.arrival(from) + GAIN < arrival
    }

    /// The next candidate: a straight walk, a wait, or a detour.
    fn propose(&mut self, view: &View<'_>) -> Plan {
        const WAITS: [u16; 8] = [0, 30, 0, 60, 0, 120, 0, 200];
        self.count = self.count.wrapping_add(1);
        let goals = view.goals.len().max(1);
        if self.count % 8 == 1 {
            return Plan::straight(view.goal());
        }
        let pick = self.draw() as usize;
        let place = if pick & 1 == 0 { 0 } else { (pick >> 1) % goals };
        let goal = view.goals.get(place).copied().unwrap_or(view.pose);
        if self.count % 8 == 5 {
            let wait = WAITS[usize::from(self.count / 8 % 8)];
            return Plan { via: (wait > 0).then_some((view.pose, wait)), goal };
        }
        // A pose beside the straight way, near or far: the sum of four uniform numbers is nearly normal.
        let bits = self.draw();
        let along = (bits & 0xFF) as i32 * 5 / 4 - 32; // −0.125 to 1.125 in units of 1/256
        let spread = i32::from(SPREADS[(bits >> 8 & 3) as usize]);
        let wait = if bits & 0x400 == 0 { 0 } else { (bits >> 16 & 0xFF) as u16 * 3 / 4 };
        let mut via = view.pose;
        for ((position, &to), range) in via.0.iter_mut().zip(&goal.0).zip(&view.body.arm.ranges) {
            let way = (i32::from(to) - i32::from(*position)) * along / 256;
            let bits = self.draw();
            // Each byte has a standard deviation of 73.9; the sum of four has 147.8.
            let sum = bits.to_le_bytes().iter().map(|&byte| i32::from(byte)).sum::<i32>() - 510;
            let aside = spread * sum / 148;
            let aim = i32::from(*position) + way + aside;
            *position = aim.max(range.min.into()).min(range.max.into()) as i16;
        }
        Plan { via: Some((via, wait)), goal }
    }

    /// Random bits: Marsaglia's xorshift.
    fn draw(&mut self) -> u32 {
        let mut bits = self.random;
        bits ^= bits << 13;
        bits ^= bits >> 17;
        bits ^= bits << 5;
        self.random = bits;
        bits
    }
}
