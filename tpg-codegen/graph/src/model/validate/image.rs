//! Images of sources: all sources see the same one.

use super::Validator;
use crate::error::{InputError, counted};
use crate::image::MAX_CELLS;
use crate::model::document::SourceDocument;

impl Validator<'_> {
    pub(super) fn source_image(&self, path: &str, source: &SourceDocument) -> Result<(), InputError> {
        let Some(image) = &source.image else { return Ok(()) };
        let path = format!("{path}.image");
        if self.document.version < 2 {
            return self.refuse(path, "an image in version 1", "version 2");
        }
        let known = self.document.sources.iter().find_map(|source| source.image.as_ref()).map(|image| image.shape);
        let [rows, columns, channels] = image.shape;
        let cells = u64::from(rows) * u64::from(columns);
        if known != Some(image.shape) || cells == 0 || cells > MAX_CELLS.into() || !(1..=256).contains(&channels) {
            let accepted = format!(
                "[rows, columns, channels], the same in all sources, at most {MAX_CELLS} cells of 1 to 256 channels"
            );
            return self.refuse(format!("{path}.shape"), format!("{:?}", image.shape), accepted);
        }
        if image.features.len() != source.length as usize {
            let found = format!("{} for a length of {}", counted(image.features.len(), "feature"), source.length);
            return self.refuse(format!("{path}.features"), found, "one for each value");
        }
        for (place, (feature, counts)) in image.features.iter().zip(&source.counts).enumerate() {
            let [low, high] = feature.range(image.shape, u8::MAX);
            let [lowest, highest] = counts.limits();
            if (counts.scale, counts.offset) != (1.0, 0.0) || low < lowest || high > highest {
                let accepted = format!("a scale of 1, and bits for {low} to {high}");
                return self.refuse(format!("{path}.features[{place}]"), "counts that do not hold it", accepted);
            }
        }
        match (0..)
            .zip(&image.features)
            .find_map(|(place, feature): (usize, _)| Some((place, feature.refusal(image.shape)?)))
        {
            Some((place, (found, accepted))) => self.refuse(format!("{path}.features[{place}]"), found, accepted),
            None => Ok(()),
        }
    }
}
