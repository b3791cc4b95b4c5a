//! Counts of sources and outputs: all of them have some, or none.

use super::Validator;
use crate::error::{InputError, counted};
use crate::model::counts::Counts;
use crate::model::document::{OutputDocument, SourceDocument};

impl Validator<'_> {
    /// Tests for a graph of counts.
    fn is_counted(&self) -> bool {
        self.document.sources.iter().any(|source| !source.counts.is_empty())
    }

    pub(super) fn source_counts(&self, path: &str, source: &SourceDocument) -> Result<(), InputError> {
        if !self.is_counted() {
            return Ok(());
        }
        let path = format!("{path}.counts");
        if source.counts.len() != source.length as usize {
            let found = format!("{} for a length of {}", counted(source.counts.len(), "count"), source.length);
            return self.refuse(path, found, "one for each value of every source, or none at all");
        }
        if self.document.version < 2 {
            return self.refuse(path, "counts in version 1", "version 2");
        }
        for (place, (counts, range)) in source.counts.iter().zip(&source.ranges).enumerate() {
            self.counts(&format!("{path}[{place}]"), *counts, *range)?;
        }
        Ok(())
    }

    pub(super) fn output_counts(&self, path: &str, output: &OutputDocument) -> Result<(), InputError> {
        let path = format!("{path}.counts");
        match output.counts {
            Some(_) if !self.is_counted() => {
                self.refuse(path, "counts beside sources without", "counts of all or of none")
            }
            Some(counts) => self.counts(&path, counts, [output.min, output.max]),
            None => Ok(()),
        }
    }

    fn counts(&self, path: &str, counts: Counts, range: [f64; 2]) -> Result<(), InputError> {
        let Counts { bits, scale, offset } = counts;
        if !Counts::BITS.contains(&bits) {
            let (low, high) = Counts::BITS.into_inner();
            return self.refuse(format!("{path}.bits"), bits.to_string(), format!("{low} to {high}"));
        }
        if !(scale > 0.0 && scale.is_finite()) {
            return self.refuse(format!("{path}.scale"), scale.to_string(), "a finite number above 0");
        }
        if !offset.is_finite() {
            return self.refuse(format!("{path}.offset"), offset.to_string(), "a finite number");
        }
        let [low, high] = counts.limits();
        if range.iter().any(|end| end.fract() != 0.0 || !(low..=high).contains(end)) {
            let found = format!("a range of {} to {}", range[0], range[1]);
            return self.refuse(path, found, format!("whole numbers from {low} to {high}, as {bits} bits have"));
        }
        Ok(())
    }
}
