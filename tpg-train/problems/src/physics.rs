//! The constants of a problem's rules: each with its standard value and the values that are accepted.

use crate::amount::Amount;
use std::fmt::Debug;
use tpg_engine::random::Stream;
use tpg_graph::error::Finding;

/// The section `[problem.physics]`: an [`Amount`] for each constant of a problem's rules.
pub trait Constants: Clone + Debug + Default + PartialEq + Sync {
    /// The values of one episode.
    type Physics: Clone + Copy + Debug + PartialEq + Send + Sync;

    /// Draws the values of an episode.
    fn draw(&self, stream: &mut Stream) -> Self::Physics;

    /// Checks every constant.
    ///
    /// # Errors
    /// The first that is out of its range.
    fn check(&self) -> Result<(), Finding>;
}

/// Checks one constant of the section `[problem.physics]`.
pub(crate) fn check(name: &str, amount: Amount, [least, most]: [f64; 2]) -> Result<(), Finding> {
    amount.check(&format!("problem.physics.{name}"), least, most)
}

/// Defines the constants of a problem's rules: `/// meaning` `name = standard value, [least, most];`. Makes the types `Physics`, with its
/// standard values, and `Amounts`, the section of a configuration.
macro_rules! physics {
    ($($(#[doc = $doc:literal])+ $name:ident = $standard:expr, $accepted:expr;)+) => {
        /// The constants of the rules.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Physics {
            $($(#[doc = $doc])+ pub $name: f64,)+
        }

        impl Physics {
            /// Gymnasium's values.
            pub const STANDARD: Self = Self { $($name: $standard,)+ };
        }

        /// The section `[problem.physics]` of a configuration: each is a number, or a range from which every episode draws.
        #[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
        #[serde(deny_unknown_fields, default)]
        pub struct Amounts {
            $($(#[doc = $doc])+ pub $name: $crate::amount::Amount,)+
        }

        impl Default for Amounts {
            fn default() -> Self {
                Self { $($name: Physics::STANDARD.$name.into(),)+ }
            }
        }

        impl $crate::physics::Constants for Amounts {
            type Physics = Physics;

            fn draw(&self, stream: &mut tpg_engine::random::Stream) -> Physics {
                Physics { $($name: self.$name.draw(stream),)+ }
            }

            fn check(&self) -> Result<(), tpg_graph::error::Finding> {
                $($crate::physics::check(stringify!($name), self.$name, $accepted)?;)+
                Ok(())
            }
        }
    };
}
pub(crate) use physics;
