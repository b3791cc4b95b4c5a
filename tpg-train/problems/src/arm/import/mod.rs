//! An arm's URDF as the section `[problem.arm]` of a configuration.
//!
//! | module | subject |
//! | --- | --- |
//! | `urdf` | the joints between a file's root and a link, or what is wrong with them |
//! | `planar` | a turning base and three parallel axes in them: lengths, zeros, signs |
//! | `section` | the section with its comments |

mod planar;
mod section;
mod urdf;

pub use section::Radii;
use tpg_graph::error::{Finding, InputError, Place};
use urdf::Requests;

/// Returns the section, with comments, for a URDF's text. `file` is its name in messages, `tip` the link whose origin must reach
/// targets, `fix` the joints that are held, each at an angle in rad, and `limit` those whose limits are narrowed, rad.
///
/// # Errors
/// A text that is no URDF, a link or joint that it does not have, a joint that does not turn within limits, an arm that is not
/// planar or cannot be.
pub fn import(
    file: &str,
    text: &str,
    tip: &str,
    fix: &[(String, f64)],
    limit: &[(String, [f64; 2])],
    radii: Radii,
) -> Result<String, InputError> {
    let joints = urdf::chain(file, text, tip, Requests { held: fix, limited: limit })?;
    let arm = planar::recognise(file, &joints)?;
    let description = section::describe(&arm, radii);
    description.check().map_err(|Finding { key, found, accepted }| {
        InputError::new(file, Place::Whole, format!("an arm whose {key} = {found}"), accepted)
    })?;
    let held = section::held(fix) + &section::limited(limit);
    Ok(section::text(file, tip, &held, &arm, &description))
}

#[cfg(test)]
mod tests;
