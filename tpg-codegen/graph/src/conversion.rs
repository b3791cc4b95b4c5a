//! Conversion of a graph to another scalar type, and how often the result still takes the same action. Never done
//! silently.

use crate::error::InputError;
use crate::interpret::{self, Answer};
use crate::model::{Document, Graph, MathsProvider, ScalarType};
use crate::states::StateSet;
use serde::Serialize;
use std::fmt;

/// The greatest difference of values that counts as agreement, as a share of the output's range.
const TOLERANCE: f64 = 0.001;

/// Counts how often two policies take the same action, or answer the same values but for a tolerance.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Agreement {
    /// States compared.
    pub states: usize,
    /// States on which both take the same action, or answer values that differ by no more than the tolerance.
    pub equal: usize,
    /// The tolerance as a share of each output's range; `None` for a policy without outputs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// Origin of the states.
    pub origin: String,
}

/// Record of a graph before its scalar type was changed.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Conversion {
    /// Scalar type named in the graph.
    pub from: ScalarType,
    /// Maths provider named in the graph.
    pub maths: MathsProvider,
    /// SHA-256 of the original graph.
    pub sha256: String,
    /// Agreement of the converted graph with the original.
    pub agreement: Agreement,
}

/// Converts the graph to `scalar`, in `f32` with the project's own maths, unless it already computes in that type.
///
/// # Errors
/// A constant does not fit the type.
pub fn convert(
    graph: &Graph,
    scalar: ScalarType,
    file: &str,
    set: &StateSet,
) -> Result<(Graph, Conversion), InputError> {
    let maths = if scalar == ScalarType::F32 { MathsProvider::Own } else { graph.maths() };
    let converted = Graph::from_document(file, Document { scalar, maths, ..graph.to_document() })?;
    let [before, after] = [graph, &converted].map(|graph| interpret::answers(graph, &set.states));
    let equal = before.iter().zip(&after).filter(|(before, after)| agree(graph, before, after)).count();
    let tolerance = (!graph.outputs().is_empty()).then_some(TOLERANCE);
    let agreement = Agreement { states: before.len(), equal, tolerance, origin: set.origin.clone() };
    let conversion = Conversion { from: graph.scalar(), maths: graph.maths(), sha256: graph.sha256(), agreement };
    Ok((converted, conversion))
}

fn agree(graph: &Graph, before: &Answer, after: &Answer) -> bool {
    match (before, after) {
        (Answer::Values(before), Answer::Values(after)) => {
            (graph.outputs().iter().zip(before.iter().zip(after))).all(|(output, (before, after))| {
                (before - after).abs() <= TOLERANCE * (output.range.max - output.range.min)
            })
        }
        _ => before == after,
    }
}

impl fmt::Display for Agreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { states, equal, tolerance, origin } = self;
        let what = match tolerance {
            None => "actions equal".to_owned(),
            Some(share) => format!("answers equal within {} % of each output's range", share * 100.0),
        };
        // Rounded down: 100 % means every state.
        let thousandths = equal * 100_000 / (*states).max(1);
        write!(f, "{equal} of {states} {what} ({}.{:03} %): {origin}", thousandths / 1000, thousandths % 1000)
    }
}

#[cfg(test)]
mod tests {
    use super::{Agreement, convert};
    use crate::model::{MathsProvider, ScalarType};
    use crate::sample::{self, Shape};
    use crate::states::StateSet;

    #[test]
    fn a_per_cent_is_never_rounded_up() {
        let agreement = |equal| Agreement { states: 300_000, equal, tolerance: None, origin: "here".to_owned() };
        assert_eq!(agreement(300_000).to_string(), "300000 of 300000 actions equal (100.000 %): here");
        assert_eq!(agreement(299_999).to_string(), "299999 of 300000 actions equal (99.999 %): here");
    }

    #[test]
    fn f32_brings_its_own_maths_and_what_differs_is_counted() {
        let mut differences = 0;
        for seed in 0..20 {
            let shape = Shape { maths: MathsProvider::System, scalar: ScalarType::F64, ..Shape::default() };
            let graph = sample::graph(&shape, seed);
            let set = StateSet::sampled(&graph, 2000, 1);
            let (converted, conversion) = convert(&graph, ScalarType::F32, "x.json", &set).expect("f32 holds it");
            assert_eq!((converted.scalar(), converted.maths()), (ScalarType::F32, MathsProvider::Own));
            assert_eq!(conversion.agreement.states, 2000);
            assert_eq!(conversion.sha256, graph.sha256());
            differences += 2000 - conversion.agreement.equal;
        }
        assert!(differences > 0, "random graphs notice a change of arithmetic somewhere");
    }
}
