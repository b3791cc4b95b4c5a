//! Built-in descriptions of what a `.dot` file leaves out.

use super::sidecar::Sidecar;
use clap::ValueEnum;

/// A family of `.dot` files whose sources, instructions and actions are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Profile {
    /// The graphs of the paper's artifact
    Ecta24,
}

impl Profile {
    /// The description. It is a sidecar like a user's own, so that it reads as an example of one.
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
    use tpg_runtime::arm::WIDOWX;
    use tpg_runtime::observation::Source;

    #[test]
    fn every_profile_is_valid() {
        for profile in Profile::value_variants() {
            profile.sidecar();
        }
    }

    #[test]
    fn ecta24_is_the_runtimes_arm() {
        let sidecar = Profile::Ecta24.sidecar();
        let document = sidecar.document();
        let sources: Vec<Source> = document
            .sources
            .iter()
            .map(|source| Source::from_name(&source.name).expect("a source of the arm"))
            .collect();
        assert_eq!(sources, [Source::Target, Source::Difference, Source::Hand, Source::Servos]);
        for (source, described) in sources.iter().zip(&document.sources) {
            assert_eq!((source.length(), source.unit()), (described.length as usize, described.unit.as_str()));
        }
        let [.., rotation, gripper] = document.sources[3].ranges[..] else { panic!("six servos") };
        assert_eq!([rotation, gripper], WIDOWX.fixed_servos.map(|ticks| [f64::from(ticks); 2]));
    }
}
