//! Binding of a graph's names and numbers to the arm: the one place where the two meet.
//!
//! Generated code carries plain data, which [`sources`] and [`moves`] turn into the arm's own types when it is compiled. A
//! graph that is read at run time goes through [`source`] and [`moved`], one declaration after another.
//!
//! ```
//! use tpg_arm::Move;
//! use tpg_arm::binding;
//! use tpg_arm::observation::Source;
//!
//! const SOURCES: [Source; 2] = binding::sources(["polar", "motors"]);
//! const MOVES: [Move; 2] = binding::moves([[3, 0, 0, 0], [-3, 0, 0, 0]]);
//!
//! assert_eq!(binding::source("polar", 3), Some(SOURCES[0]));
//! assert_eq!(binding::source("polar", 4), None, "another length");
//! assert_eq!(binding::moved("move", &[-3.0, 0.0, 0.0, 0.0]), Some(MOVES[1]));
//! assert_eq!(binding::moved("torque", &[-3.0, 0.0, 0.0, 0.0]), None, "not the arm's effect");
//! ```

use crate::arm::{JOINTS, Move};
use crate::observation::Source;

/// The name of the effect by which an action moves the arm: ticks for each joint.
pub const MOVE: &str = "move";

/// The arm's sources of those names.
///
/// # Panics
/// If the arm has no source of a name: at compile time, where the result is a constant.
pub const fn sources<const N: usize>(names: [&str; N]) -> [Source; N] {
    let mut sources = [Source::Target; N];
    let mut place = 0;
    while place < N {
        match Source::from_name(names[place]) {
            Some(source) => sources[place] = source,
            None => panic!("the arm has no source of that name"),
        }
        place += 1;
    }
    sources
}

/// Ticks as moves of the arm.
pub const fn moves<const N: usize>(ticks: [[i8; JOINTS]; N]) -> [Move; N] {
    let mut moves = [Move::STOP; N];
    let mut place = 0;
    while place < N {
        moves[place] = Move(ticks[place]);
        place += 1;
    }
    moves
}

/// The arm's source of a name, if it has `length` values.
pub fn source(name: &str, length: usize) -> Option<Source> {
    Source::from_name(name).filter(|source| source.length() == length)
}

/// The move that an effect is: one named [`MOVE`], with a whole number of ticks for each joint that a [`Move`] has room for.
pub fn moved(effect: &str, values: &[f64]) -> Option<Move> {
    let values = <&[f64; JOINTS]>::try_from(values).ok().filter(|_| effect == MOVE)?;
    let ticks = values.map(|value| value as i8);
    let exact = values.iter().zip(ticks).all(|(&value, ticks)| value == f64::from(ticks));
    exact.then_some(Move(ticks))
}
