//! The document that a file declares.

use super::declared::Declared;
use super::leaves;
use super::lines::Lines;
use super::resolve::Resolver;
use crate::error::InputError;
use crate::import::sidecar::Sidecar;
use crate::model::{Document, Provenance};

/// Builds a document from what a whole file declares and records where its elements are located.
pub(super) fn document(file: &str, declared: Declared, sidecar: &Sidecar) -> Result<(Document, Lines), InputError> {
    let resolver = Resolver { file, document: sidecar.document(), sidecar, declared };
    resolver.is_something()?;
    resolver.links()?;
    let mut lines = Lines::default();
    let mut teams = resolver.teams(&mut lines)?;
    let mut programs = resolver.programs(&mut lines)?;
    let root = resolver.root(&teams, &mut lines)?;
    let leaves = if resolver.has_values() {
        leaves::resolve(&resolver, &mut teams, &mut programs, &mut lines)?
    } else {
        Vec::new()
    };
    let mut provenance = Provenance::default();
    if let Some((tool, version)) = &resolver.declared.exporter {
        provenance.tool = Some(tool.clone());
        provenance.version = Some(version.clone());
    }
    Ok((Document { root, teams, leaves, programs, provenance, ..resolver.document.clone() }, lines))
}
