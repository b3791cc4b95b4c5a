//! The bids of the shipped policies as tables; written by `tpg-page bids`, do not edit.

use crate::decision::To::{End, Team};
use crate::decision::Value::{Constant, Input, Operation};
use crate::decision::{Bids, Edge};
use tpg_runtime::ops::Instruction::*;
use tpg_runtime::ops::Own;

/// Of `generated/cartpole`.
pub static CARTPOLE: Bids = Bids {
    values: &[
        Input(2),
        Input(3),
        Operation(|a, b| Add.apply::<f32, Own>(a, b), 0, 1),
        Input(1),
        Constant(-3.2907495),
        Operation(|a, b| Div.apply::<f32, Own>(a, b), 3, 4),
    ],
    teams: &[&[Edge { bid: 5, to: End(0) }, Edge { bid: 2, to: End(1) }]],
};

/// Of `generated/pendulum`.
pub static PENDULUM: Bids = Bids {
    values: &[
        Input(0),
        Input(1),
        Operation(|a, b| Min.apply::<f32, Own>(a, b), 0, 1),
        Constant(4.407756),
        Operation(|a, b| Mul.apply::<f32, Own>(a, b), 0, 3),
    ],
    teams: &[&[Edge { bid: 2, to: End(0) }, Edge { bid: 4, to: End(1) }]],
};

/// Of `generated/mountain-car`.
pub static MOUNTAIN_CAR: Bids = Bids {
    values: &[
        Constant(0.0),
        Input(0),
        Constant(-2.5000443),
        Operation(|a, b| Mul.apply::<f32, Own>(a, b), 1, 2),
        Constant(-1.089072),
        Operation(|a, b| Add.apply::<f32, Own>(a, b), 3, 4),
        Constant(2.3253112),
        Operation(|a, b| Mul.apply::<f32, Own>(a, b), 1, 6),
        Input(1),
        Constant(96.694336),
        Operation(|a, b| Mul.apply::<f32, Own>(a, b), 8, 9),
        Operation(|a, b| Add.apply::<f32, Own>(a, b), 7, 10),
        Constant(-1.0729886),
        Operation(|a, b| Add.apply::<f32, Own>(a, b), 11, 12),
        Constant(-1.0512869),
        Operation(|a, b| Add.apply::<f32, Own>(a, b), 8, 14),
        Constant(-2.1966188),
        Operation(|a, b| Mul.apply::<f32, Own>(a, b), 1, 16),
        Constant(99.67122),
        Operation(|a, b| Mul.apply::<f32, Own>(a, b), 8, 18),
        Operation(|a, b| Add.apply::<f32, Own>(a, b), 17, 19),
        Constant(-1.033289),
        Operation(|a, b| Add.apply::<f32, Own>(a, b), 20, 21),
    ],
    teams: &[
        &[
            Edge { bid: 5, to: Team(1) },
            Edge { bid: 13, to: End(2) },
            Edge { bid: 15, to: Team(1) },
            Edge { bid: 0, to: End(0) },
        ],
        &[Edge { bid: 13, to: End(2) }, Edge { bid: 22, to: End(2) }, Edge { bid: 0, to: End(0) }],
    ],
};
