//! An arm's URDF as the section `[problem.arm]` of a configuration, or as a section `[chain]`.
//!
//! | module | subject |
//! | --- | --- |
//! | `urdf` | the joints between a file's root and a link, or what is wrong with them |
//! | `planar` | a turning base and three parallel axes in them: lengths, zeros, signs |
//! | `section` | the section with its comments |
//! | `chain` | the section of joints that are no planar arm |
//! | `space` | vectors and rotations |

mod chain;
mod planar;
mod section;
mod space;
mod urdf;

pub use section::Radii;
use tpg_graph::error::{Finding, InputError, Place};
use urdf::Requests;

/// An imported arm.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// Its section, with comments.
    pub text: String,
    /// The reason why that is a `[chain]`; none for a `[problem.arm]`.
    pub not_planar: Option<String>,
}

/// Returns the section for a URDF's text. `file` is its name in messages, `tip` the link whose origin must reach
/// targets, `fix` the joints that are held, each at an angle in rad, and `limit` those whose limits are narrowed, rad.
///
/// # Errors
/// A text that is no URDF, a link or joint that it does not have, a joint that does not turn within limits, an arm that cannot be.
pub fn import(
    file: &str,
    text: &str,
    tip: &str,
    fix: &[(String, f64)],
    limit: &[(String, [f64; 2])],
    radii: Radii,
) -> Result<Imported, InputError> {
    let joints = urdf::chain(file, text, tip, Requests { held: fix, limited: limit })?;
    let held = section::held(fix) + &section::limited(limit);
    let refuse = |Finding { key, found, accepted }: Finding| {
        InputError::new(file, Place::Whole, format!("an arm whose {key} = {found}"), accepted)
    };
    match planar::recognise(file, &joints) {
        Ok(arm) => {
            let description = section::describe(&arm, radii);
            description.check().map_err(refuse)?;
            Ok(Imported { text: section::text(file, tip, &held, &arm, &description), not_planar: None })
        }
        Err(error) => {
            let description = chain::describe(file, &joints)?;
            description.check().map_err(refuse)?;
            let reason = format!("{}{}", error.place, error.found);
            let text = chain::text(file, tip, &held, &description, &reason);
            Ok(Imported { text, not_planar: Some(reason) })
        }
    }
}

#[cfg(test)]
mod tests;
