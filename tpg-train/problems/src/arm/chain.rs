//! An arm that need not be planar as a file's section `[chain]`: the geometry of [`tpg_arm::chain`], for programs of your own.
//! Training is for planar arms.

use serde::{Deserialize, Serialize};
use tpg_arm::chain::{Axis, Chain, Link};
use tpg_arm::{JointRange, TICKS_PER_TURN};
use tpg_graph::error::{Finding, InputError};
use tpg_graph::settings;

/// A chain of joints that turn, as written in a file. Lengths in mm, positions in ticks of 1/4096 turn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ChainDescription {
    /// The tip in the frame of the last link.
    pub tip: [f64; 3],
    /// The joints, from the base outwards.
    pub links: Vec<LinkDescription>,
}

/// A joint and the link that it turns.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LinkDescription {
    /// The joint's name.
    pub name: String,
    /// The joint in the frame of the link before; the first in that of the world.
    pub origin: [f64; 3],
    /// The rotation of its frame there, row by row; nothing is turned if it is left out.
    #[serde(default = "straight", skip_serializing_if = "is_straight")]
    pub turned: [[f64; 3]; 3],
    /// The axis of its own frame about which rising positions turn, as the right hand's fingers about the thumb.
    pub axis: SignedAxis,
    /// The position at which it adds nothing to `turned`.
    #[serde(default = "middle", skip_serializing_if = "is_middle")]
    pub zero: i16,
    /// The first and last position.
    pub range: [i16; 2],
}

/// An axis of a frame, in either direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum SignedAxis {
    /// The first.
    #[serde(rename = "x")]
    X,
    /// The second.
    #[serde(rename = "y")]
    Y,
    /// The third.
    #[serde(rename = "z")]
    Z,
    /// Against the first.
    #[serde(rename = "-x")]
    MinusX,
    /// Against the second.
    #[serde(rename = "-y")]
    MinusY,
    /// Against the third.
    #[serde(rename = "-z")]
    MinusZ,
}

impl SignedAxis {
    fn parts(self) -> (Axis, bool) {
        match self {
            Self::X => (Axis::X, false),
            Self::Y => (Axis::Y, false),
            Self::Z => (Axis::Z, false),
            Self::MinusX => (Axis::X, true),
            Self::MinusY => (Axis::Y, true),
            Self::MinusZ => (Axis::Z, true),
        }
    }
}

fn straight() -> [[f64; 3]; 3] {
    Link::<f64>::STRAIGHT
}

fn is_straight(turned: &[[f64; 3]; 3]) -> bool {
    *turned == straight()
}

fn middle() -> i16 {
    (TICKS_PER_TURN / 2) as i16
}

fn is_middle(zero: &i16) -> bool {
    *zero == middle()
}

/// A chain that is known by name.
pub struct NamedChain {
    /// Its name.
    pub name: &'static str,
    /// One-line description.
    pub about: &'static str,
    /// Its section `[chain]`, with comments.
    pub text: &'static str,
}

/// Every chain that has a name.
pub const CHAINS: [NamedChain; 1] = [NamedChain {
    name: "wx250s",
    about: "the section [chain] of the WidowX 250 S: six joints, for programs with `tpg_arm::chain`",
    text: include_str!("arms/wx250s.toml"),
}];

impl ChainDescription {
    /// Reads the section `[chain]` of a file's text.
    ///
    /// # Errors
    /// An unknown key or a value that no chain has, with its line.
    pub fn from_toml(file: &str, text: &str) -> Result<Self, InputError> {
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        struct ChainFile {
            chain: ChainDescription,
        }
        let ChainFile { chain } =
            settings::from_toml(file, text, "a section [chain] as `tpg-train config wx250s` prints")?;
        chain.check().map_err(|finding| settings::place(file, text, finding))?;
        Ok(chain)
    }

    /// Checks what the types cannot express.
    ///
    /// # Errors
    /// No joint, a range that is empty or beyond a turn, a length that is not finite, a matrix that is no rotation.
    pub fn check(&self) -> Result<(), Finding> {
        let place = |place: [f64; 3]| place.iter().all(|length| length.abs() <= LONGEST);
        if self.links.is_empty() {
            return Err(Finding::new("chain.links", "no joint", "one or more"));
        }
        if !place(self.tip) {
            return Err(Finding::new("chain.tip", format!("{:?}", self.tip), ACCEPTED_PLACE));
        }
        for LinkDescription { name, origin, turned, range, .. } in &self.links {
            let refuse = |key: &str, found: String, accepted: &str| {
                Err(Finding::new("chain.links", format!("{name:?} with {key} = {found}"), accepted))
            };
            let [first, last] = *range;
            if first >= last || first < 0 || i32::from(last) >= TICKS_PER_TURN {
                return refuse("range", format!("{range:?}"), "two positions, 0 to 4095, the first below the second");
            }
            if !place(*origin) {
                return refuse("origin", format!("{origin:?}"), ACCEPTED_PLACE);
            }
            if !is_rotation(turned) {
                return refuse("turned", format!("{turned:?}"), "a rotation: rows of length 1, at right angles");
            }
        }
        Ok(())
    }

    /// Returns the chain; `None` if it has another number of joints.
    ///
    /// ```
    /// use tpg_arm::chain::Kinematics as _;
    /// use tpg_problems::arm::chain::{CHAINS, ChainDescription};
    ///
    /// let described = ChainDescription::from_toml("wx250s.toml", CHAINS[0].text)?;
    /// let arm = described.chain::<6>().expect("six joints");
    /// assert_eq!(arm.place([2048; 6]).tip, [458.325, 0.0, 360.65]);
    /// # Ok::<(), tpg_graph::error::InputError>(())
    /// ```
    pub fn chain<const N: usize>(&self) -> Option<Chain<f64, N>> {
        let links = self.links.iter().map(|link| {
            let ((axis, reversed), [min, max]) = (link.axis.parts(), link.range);
            let LinkDescription { origin, turned, zero, .. } = *link;
            Link { origin, turned, axis, reversed, zero, range: JointRange { min, max } }
        });
        Some(Chain { links: links.collect::<Vec<_>>().try_into().ok()?, tip: self.tip })
    }
}

/// Maximum length, mm.
const LONGEST: f64 = 100_000.0;
const ACCEPTED_PLACE: &str = "three lengths of at most 100 m";

/// True if the rows are of length 1, at right angles, and keep the hand.
fn is_rotation([x, y, z]: &[[f64; 3]; 3]) -> bool {
    let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let cross = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
    let near = |value: f64, wanted: f64| (value - wanted).abs() < 1e-6;
    near(dot(x, x), 1.0)
        && near(dot(y, y), 1.0)
        && near(dot(x, y), 0.0)
        && near(dot(&cross, z), 1.0)
        && near(dot(z, z), 1.0)
}

#[cfg(test)]
mod tests {
    use super::{CHAINS, ChainDescription};

    #[test]
    fn a_wrong_chain_is_refused_with_its_line_and_joint() {
        let good = CHAINS[0].text;
        assert_eq!(ChainDescription::from_toml("x.toml", good).map(|chain| chain.links.len()), Ok(6));
        for (from, to, found) in [
            ("axis = \"y\"", "axis = \"w\"", "unknown variant `w`"),
            ("[820, 3345]", "[3345, 820]", "chain.links = \"shoulder\" with range = [3345, 820]"),
            ("[820, 3345]", "[820, 4096]", "chain.links = \"shoulder\" with range = [820, 4096]"),
            ("38.65]", "nan]", "chain.links = \"shoulder\" with origin = [0.0, 0.0, NaN]"),
            ("[93.575,", "[1e9,", "chain.tip = [1000000000.0, 0.0, 0.0]"),
            (
                "axis = \"y\"",
                "axis = \"y\"\nturned = [[1, 0, 0], [0, 1, 0], [0, 0, -1]]",
                "chain.links = \"shoulder\" with turned",
            ),
            ("[chain]", "[chain]\nhome = 3", "unknown field `home`"),
        ] {
            let text = good.replacen(from, to, 1);
            assert_ne!(text, good, "{from} is in the text");
            let error = ChainDescription::from_toml("x.toml", &text).expect_err(to);
            assert!(error.found.starts_with(found) && error.to_string().starts_with("x.toml: line"), "{error}");
        }
        assert!(ChainDescription::from_toml("x.toml", "[chain]\ntip = [0, 0, 0]\nlinks = []\n").is_err());
    }
}
