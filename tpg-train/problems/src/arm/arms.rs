//! Arms that are known by name: `arm = "px100"` in `[problem]` stands for the section that `tpg-train config px100` prints.

use super::description::ArmDescription;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};
use std::fmt;

/// An arm that is known by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NamedArm {
    /// Its name.
    pub name: &'static str,
    /// One-line description.
    pub about: &'static str,
    /// Its section `[problem.arm]`, with comments.
    pub text: &'static str,
}

/// Every arm that has a name.
pub const ARMS: [NamedArm; 4] = [
    NamedArm {
        name: "widowx",
        about: "the section [problem.arm] of the WidowX, to append and to change: links, limits, collision shapes",
        text: include_str!("arms/widowx.toml"),
    },
    NamedArm {
        name: "px100",
        about: "the section [problem.arm] of the PincherX 100",
        text: include_str!("arms/px100.toml"),
    },
    NamedArm {
        name: "open-manipulator-x",
        about: "the section [problem.arm] of the OpenManipulator-X",
        text: include_str!("arms/open-manipulator-x.toml"),
    },
    NamedArm {
        name: "so101",
        about: "the section [problem.arm] of the SO-101, its wrist's roll held at 0",
        text: include_str!("arms/so101.toml"),
    },
];

impl NamedArm {
    /// Finds an arm by its name.
    pub fn find(name: &str) -> Option<&'static Self> {
        ARMS.iter().find(|arm| arm.name == name)
    }

    /// Returns the arm.
    ///
    /// # Panics
    /// Never: a test reads every section.
    pub fn description(&self) -> ArmDescription {
        let file: toml::Table = self.text.parse().expect("TOML");
        file["problem"]["arm"].clone().try_into().expect("a section that a test has read")
    }
}

/// Reads an arm: its name, or a section of its own.
///
/// # Errors
/// A name that is not known, or a section that is not an arm's.
pub(super) fn named_or_own<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<ArmDescription>, D::Error> {
    deserializer.deserialize_any(NameOrSection).map(Some)
}

struct NameOrSection;

impl<'de> Visitor<'de> for NameOrSection {
    type Value = ArmDescription;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = ARMS.map(|arm| format!("{:?}", arm.name)).join(", ");
        write!(f, "one of {names}, or a section [problem.arm]")
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<ArmDescription, E> {
        let known = NamedArm::find(name).map(NamedArm::description);
        known.ok_or_else(|| E::invalid_value(serde::de::Unexpected::Str(name), &self))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<ArmDescription, A::Error> {
        ArmDescription::deserialize(MapAccessDeserializer::new(map))
    }
}

#[cfg(test)]
mod tests {
    use super::ARMS;
    use crate::{Problem, ProblemSettings};
    use tpg_arm::Arm;
    use tpg_graph::error::Place;

    #[test]
    fn a_name_stands_for_the_section_of_that_arm() {
        for known in ARMS {
            let named = format!("[problem]\nname = \"fs\"\narm = {:?}\n", known.name);
            let own = format!("[problem]\nname = \"fs\"\n{}", known.text);
            let read = |text: &str| Problem::from_toml("x.toml", text).unwrap_or_else(|error| panic!("{error}"));
            let problem = read(&named);
            let ProblemSettings::Arm(config) = problem.settings.clone() else { panic!("an arm's problem") };
            assert_eq!(problem, read(&own), "{}", known.name);
            assert_eq!(config.arm(), Arm::from(&known.description()));
            assert_eq!(config.arm().check(), Ok(()));
        }
    }

    #[test]
    fn an_unknown_name_is_refused_with_its_line_and_the_names() {
        let text = "[problem]\nname = \"fs\"\nstep = 3\narm = \"px99\"\n";
        let error = Problem::from_toml("x.toml", text).expect_err("no such arm");
        assert_eq!(error.place, Place::Line(4));
        assert!(error.found.contains("px99") && error.found.contains("\"px100\""), "{error}");
    }
}
