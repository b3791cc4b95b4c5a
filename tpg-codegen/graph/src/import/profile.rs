//! Built-in descriptions for `.dot` files, which supply what the format leaves out.

use super::sidecar::Sidecar;
use clap::ValueEnum;

/// A family of `.dot` files whose sources, instructions and actions are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Profile {
    /// The graphs of the paper's artifact
    Ecta24,
}

impl Profile {
    /// Returns the description. It is a sidecar like a user's own and serves as an example of one.
    pub fn sidecar(self) -> Sidecar {
        let (name, text) = match self {
            Self::Ecta24 => ("<profile ecta24>", include_str!("profiles/ecta24.toml")),
        };
        Sidecar::from_toml(name, text).expect("built-in profiles are valid: a test reads each")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_profile_is_valid() {
        for profile in Profile::value_variants() {
            profile.sidecar();
        }
    }
}
