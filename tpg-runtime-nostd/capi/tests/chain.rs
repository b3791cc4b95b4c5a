//! The geometry of a chain in C: the same bits as in Rust, for chains of one to eight joints.

use crate::linked;
use crate::text::{braces, float, push_bits};
use std::fmt::Write as _;
use std::fs;
use tempfile::TempDir;
use tpg_arm::JointRange;
use tpg_arm::chain::{Axis, Chain, Kinematics as _, Link};
use tpg_testing::numbers::Numbers;

const POSES: usize = 100;
const RADII: [f32; 8] = [60.0, 40.0, 35.0, 35.0, 30.0, 30.0, 25.0, 20.0];

/// A chain whose axes and directions alternate; every third frame is turned by a third of a turn.
fn chain<const N: usize>(numbers: &mut Numbers) -> Chain<f32, N> {
    let third = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let links = std::array::from_fn(|joint| Link {
        origin: [0, 1, 2].map(|_: i32| numbers.within(2000) as f32 / 16.0),
        turned: if joint % 3 == 2 { third } else { Link::<f32>::STRAIGHT },
        axis: [Axis::Z, Axis::Y, Axis::X][joint % 3],
        reversed: joint % 2 == 1,
        zero: 2048 + numbers.within(300) as i16,
        range: JointRange { min: 0, max: 4095 },
    });
    Chain { links, tip: [93.575, 0.0, numbers.within(100) as f32] }
}

fn same_bits_in_c<const N: usize>(numbers: &mut Numbers, archive: &std::path::Path) {
    let chain = chain::<N>(numbers);
    let poses: Vec<[i16; N]> =
        (0..POSES).map(|_| std::array::from_fn(|_| (numbers.next_u32() % 4096) as i16)).collect();
    let balls: Vec<[f32; 4]> = (0..POSES)
        .map(|_| [0, 1, 2, 3].map(|of: usize| if of == 3 { 40.0 } else { numbers.within(400) as f32 }))
        .collect();
    let link = |link: &Link<f32>| {
        let axis = match link.axis {
            Axis::X => 0,
            Axis::Y => 1,
            Axis::Z => 2,
        };
        let turned = braces(link.turned.map(|row| braces(row.map(float))));
        let rest = [axis.to_string(), u8::from(link.reversed).to_string(), link.zero.to_string()];
        braces([braces(link.origin.map(float)), turned].into_iter().chain(rest))
    };
    let header = format!(
        "static const tpg_link_t links[] = {};\nstatic const float tip[] = {};\nstatic const float radii[] = {};\n\
         static const int16_t poses[][{N}] = {};\nstatic const float balls[][4] = {};\n",
        braces(chain.links.iter().map(link)),
        braces(chain.tip.map(float)),
        braces(RADII.map(float)),
        braces(poses.iter().map(|pose| braces(*pose))),
        braces(balls.iter().map(|ball| braces(ball.map(float)))),
    );
    let folder = TempDir::new().expect("a temporary folder");
    fs::write(folder.path().join("chain.h"), header).expect("the folder can be written");
    let mut by_rust = String::new();
    for (pose, [x, y, z, radius]) in poses.iter().zip(&balls) {
        let placed = chain.place(*pose);
        push_bits(&mut by_rust, &placed.tip);
        for ((point, axis), moved) in placed.points.iter().zip(&placed.axes).zip(placed.jacobian()) {
            [point, axis, &moved].into_iter().for_each(|values| push_bits(&mut by_rust, values));
        }
        let own = std::array::from_fn(|joint| RADII[joint]);
        let near = placed.near(&own, [*x, *y, *z], *radius);
        push_bits(&mut by_rust, &[near.clearance]);
        push_bits(&mut by_rust, &near.point);
        push_bits(&mut by_rust, &placed.gradient(&near));
        let _ = writeln!(by_rust, "{}", near.link);
    }
    let by_c = linked::output_of("chain.c", folder.path(), &[], archive);
    assert!(by_c == by_rust, "{N} joints");
    assert_eq!(by_c.lines().count(), POSES);
}

#[test]
fn c_places_chains_with_the_same_bits_as_rust() {
    let Some(archive) = linked::archive("chains in C") else { return };
    let numbers = &mut Numbers(3);
    same_bits_in_c::<1>(numbers, &archive);
    same_bits_in_c::<4>(numbers, &archive);
    same_bits_in_c::<6>(numbers, &archive);
    same_bits_in_c::<8>(numbers, &archive);
}
