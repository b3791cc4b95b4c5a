//! The data sources of a graph: their values, and the ranges that `graph.json` declares for them.

use tpg_arm::kinematics::{self, Lattice, Plane};
use tpg_arm::observation::{Observation, Source, TargetMemo};
use tpg_arm::{Arm, JOINTS, Pose, WIDOWX};

const ARM_F32: Arm<f32> = WIDOWX.to_f32();

/// Poses inside the limits, from a linear congruential generator: a test must not change with a crate.
struct Poses(u64);

impl Poses {
    fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % bound
    }

    fn any(&mut self) -> Pose {
        let mut pose = Pose([0; JOINTS]);
        for (ticks, range) in pose.0.iter_mut().zip(WIDOWX.ranges) {
            *ticks = range.min + self.below((range.max - range.min) as u64 + 1) as i16;
        }
        // Ends of the ranges are where bounds break.
        if self.below(8) == 0 {
            let joint = self.below(4) as usize;
            let range = WIDOWX.ranges[joint];
            pose.0[joint] = if self.below(2) == 0 { range.min } else { range.max };
        }
        pose
    }

    fn free(&mut self) -> Pose {
        loop {
            let pose = self.any();
            if Plane::at(&WIDOWX, pose).collision(&WIDOWX.shapes).is_none() {
                return pose;
            }
        }
    }
}

fn values<S: Lattice>(source: Source, arm: &Arm<S>, pose: Pose, target: [S; 3]) -> Vec<f64> {
    let mut values = vec![S::ZERO; source.length()];
    Source::fill(&[source], arm, &Observation::at(arm, pose, target), &TargetMemo::new(), &mut values);
    values.iter().map(|value| value.to_f64()).collect()
}

#[test]
fn every_value_lies_in_its_declared_range() {
    let mut poses = Poses(1);
    let mut widest = [[0.0f64; 8]; Source::ALL.len()];
    for _ in 0..300_000 {
        let (pose, goal) = (poses.free(), poses.free());
        let target = kinematics::hand(&WIDOWX, goal);
        let target_f32 = kinematics::hand(&ARM_F32, goal);
        for (place, source) in Source::ALL.into_iter().enumerate() {
            let both = [values(source, &WIDOWX, pose, target), values(source, &ARM_F32, pose, target_f32)];
            for (index, value) in both.iter().flat_map(|values| values.iter().copied().enumerate()) {
                let [min, max] = source.range(&WIDOWX, index);
                assert!(min.is_finite() && max.is_finite() && min <= max);
                assert!(
                    min <= value && value <= max,
                    "{}[{index}] is {value} at {pose:?} for the target {target:?}, declared {min} to {max}",
                    source.name()
                );
                let used = if max > min { (value - min).max(max - value) / (max - min) } else { 1.0 };
                widest[place][index] = widest[place][index].max(used);
            }
        }
    }
    // A range that nothing comes near would make interval analysis weak.
    for (source, widest) in Source::ALL.into_iter().zip(widest) {
        for (index, used) in widest.iter().enumerate().take(source.length()) {
            assert!(*used > 0.55, "{}[{index}] uses only {used} of its range from one end", source.name());
        }
    }
}

#[test]
fn f32_and_f64_see_the_same_errors() {
    let mut poses = Poses(2);
    for _ in 0..20_000 {
        let (pose, goal) = (poses.free(), poses.free());
        let target = kinematics::hand(&WIDOWX, goal);
        let polar = |index: usize| {
            let wide = values(Source::Polar, &WIDOWX, pose, target)[index];
            let narrow = values(Source::Polar, &ARM_F32, pose, target.map(|x| x as f32))[index];
            (wide - narrow).abs()
        };
        assert!((0..3).all(|index| polar(index) < 1e-2), "{pose:?} {target:?}");
    }
}

#[test]
fn the_stance_is_free_and_solves_nearly_every_task() {
    let mut poses = Poses(5);
    let (mut solved, mut straight) = (0, 0);
    for _ in 0..5000 {
        let (pose, goal) = (poses.free(), poses.free());
        let target = kinematics::hand(&WIDOWX, goal);
        let errors = values(Source::Stance, &WIDOWX, pose, target);
        let there = Pose([0, 1, 2, 3].map(|joint| (f64::from(pose.0[joint]) + errors[joint] + 0.5).floor() as i16));
        let inside = there.0.iter().zip(WIDOWX.ranges).all(|(&ticks, range)| range.contains(ticks));
        let free = Plane::at(&WIDOWX, there).collision(&WIDOWX.shapes).is_none();
        // Rounding to ticks moves the hand by up to about 1 mm.
        if inside && free && kinematics::distance(kinematics::hand(&WIDOWX, there), target) < 1.2 {
            solved += 1;
            straight += u32::from(there.0[3] == 2048);
        }
    }
    // Poses are uniform here, not targets: more of them are folded than the arm's tasks ask for.
    assert!(solved > 4700 && straight > 3500 && straight < solved, "{solved} solved, {straight} with a straight wrist");
}

#[test]
fn fill_puts_sources_one_after_another() {
    let target = kinematics::hand(&WIDOWX, Pose([2100, 2200, 1900, 2000]));
    let seen = Observation::at(&WIDOWX, WIDOWX.home, target);
    let sources = [Source::Polar, Source::Motors, Source::Floor];
    let mut state = [f64::NAN; 9];
    Source::fill(&sources, &WIDOWX, &seen, &TargetMemo::new(), &mut state);
    let expected: Vec<f64> = sources.iter().flat_map(|&source| values(source, &WIDOWX, WIDOWX.home, target)).collect();
    assert_eq!(state[..8], expected[..]);
    assert!(state[8].is_nan(), "nothing is written past the last source");
}

#[test]
fn what_a_memo_keeps_changes_no_value() {
    let memo = TargetMemo::new();
    let mut poses = Poses(7);
    // Targets that stay, change, come back, and differ in a sign of zero or a NaN only.
    let near = kinematics::hand(&ARM_F32, poses.free());
    let targets =
        [near, near, kinematics::hand(&ARM_F32, poses.free()), near, [0.0, -200.0, 100.0], [-0.0, -200.0, 100.0]];
    for target in targets.into_iter().chain([[f32::NAN, 1.0, 2.0]; 2]).cycle().take(400) {
        let seen = Observation::at(&ARM_F32, poses.free(), target);
        let mut state = [[0f32; 64]; 2];
        let [kept, anew] = &mut state;
        Source::fill(&Source::ALL, &ARM_F32, &seen, &memo, kept);
        for (place, &source) in Source::ALL.iter().enumerate() {
            let start = Source::ALL[..place].iter().map(|source| source.length()).sum::<usize>();
            Source::fill(&[source], &ARM_F32, &seen, &TargetMemo::new(), &mut anew[start..]);
        }
        assert_eq!(kept.map(f32::to_bits), anew.map(f32::to_bits), "{seen:?}");
    }
}
