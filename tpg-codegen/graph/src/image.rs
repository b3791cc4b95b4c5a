//! Values that a policy reads from an image: where something is, what is near it, how bright a window is.
//!
//! An image is bytes, row after row, the channels of a cell beside each other, as cameras and `numpy` give them. All values are
//! whole numbers, so every implementation computes the same.

use crate::{Graph, Input, Operand, SourceDocument};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The image that the values of a source come from.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ImageSource {
    /// Rows, columns and channels; each cell has a byte for each channel.
    pub shape: [u32; 3],
    /// The feature that each value is.
    pub features: Vec<Feature>,
}

/// A value that is computed from an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Feature {
    /// The sum of a window's bytes.
    Sum {
        /// Channel.
        channel: u32,
        /// First row.
        row: u32,
        /// First column.
        column: u32,
        /// Rows.
        height: u32,
        /// Columns.
        width: u32,
    },
    /// The row of a place; −1 where there is none.
    Row(Find),
    /// The column of a place; −1 where there is none.
    Column(Find),
    /// The distance of the brightest or darkest window's sum from the mean sum of such windows, rounded down.
    Contrast(Find),
    /// The byte of a cell so many rows and columns from a place; 0 outside the image, and where there is no such place.
    Cell {
        /// Channel.
        channel: u32,
        /// Rows down from the place.
        down: i32,
        /// Columns to the right of the place.
        right: i32,
        /// The place.
        from: Find,
    },
}

/// A place that is looked for, row after row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Find {
    /// The first cell of a channel that is not 0.
    First(u32),
    /// The last cell of a channel that is not 0.
    Last(u32),
    /// The middle of the square window with the greatest sum; the first of equal ones.
    Brightest {
        /// Channel.
        channel: u32,
        /// Rows and columns of the window, odd.
        size: u32,
    },
    /// The middle of the square window with the smallest sum; the first of equal ones.
    Darkest {
        /// Channel.
        channel: u32,
        /// Rows and columns of the window, odd.
        size: u32,
    },
}

/// The most cells of an image: sums stay exact in `f32`, and contrasts in 32 bits.
pub const MAX_CELLS: u32 = 1 << 16;
/// The largest square window.
pub const MAX_WINDOW: u32 = 9;

impl Find {
    /// Returns the channel that is searched.
    pub const fn channel(self) -> u32 {
        match self {
            Self::First(channel) | Self::Last(channel) => channel,
            Self::Brightest { channel, .. } | Self::Darkest { channel, .. } => channel,
        }
    }
}

impl Feature {
    /// Returns the place that is looked for.
    pub const fn find(self) -> Option<Find> {
        match self {
            Self::Sum { .. } => None,
            Self::Row(find) | Self::Column(find) | Self::Contrast(find) | Self::Cell { from: find, .. } => Some(find),
        }
    }

    /// Returns the lowest and highest value in an image whose bytes are at most `brightest`.
    pub fn range(self, [rows, columns, _]: [u32; 3], brightest: u8) -> [f64; 2] {
        let none = |find| if matches!(find, Find::First(_) | Find::Last(_)) { -1.0 } else { 0.0 };
        let full = |cells: u32| f64::from(u32::from(brightest) * cells);
        match self {
            Self::Sum { height, width, .. } => [0.0, full(height * width)],
            Self::Row(find) => [none(find), f64::from(rows - 1)],
            Self::Column(find) => [none(find), f64::from(columns - 1)],
            Self::Contrast(Find::Brightest { size, .. } | Find::Darkest { size, .. }) => [0.0, full(size * size)],
            Self::Contrast(_) => [0.0, 0.0],
            Self::Cell { .. } => [0.0, full(1)],
        }
    }

    /// Returns what is wrong with it for an image of that shape, and what is accepted.
    pub(crate) fn refusal(self, [rows, columns, channels]: [u32; 3]) -> Option<(String, String)> {
        let channel = match self {
            Self::Sum { channel, row, column, height, width } => {
                let fits =
                    |first: u32, length: u32, end| length > 0 && first.checked_add(length).is_some_and(|to| to <= end);
                if !(fits(row, height, rows) && fits(column, width, columns)) {
                    let found = format!("a window of {height} by {width} at row {row}, column {column}");
                    return Some((found, format!("one inside the image of {rows} by {columns}")));
                }
                channel
            }
            Self::Cell { channel, down, right, .. } => {
                if down.unsigned_abs() >= rows || right.unsigned_abs() >= columns {
                    let found = format!("{down} rows down and {right} columns to the right");
                    return Some((found, format!("less than the image's {rows} by {columns}")));
                }
                channel
            }
            Self::Row(find) | Self::Column(find) | Self::Contrast(find) => find.channel(),
        };
        if let (Self::Contrast(_), Some(Find::First(_) | Find::Last(_))) = (self, self.find()) {
            return Some(("the contrast of a cell".to_owned(), "that of brightest or darkest".to_owned()));
        }
        if let Some(Find::Brightest { size, .. } | Find::Darkest { size, .. }) = self.find()
            && (size % 2 == 0 || size > rows.min(columns).min(MAX_WINDOW))
        {
            return Some((format!("a window of size {size}"), format!("odd, at most {MAX_WINDOW}, inside the image")));
        }
        let last = self.find().map_or(channel, |find| find.channel().max(channel));
        (last >= channels).then(|| (format!("channel {last}"), format!("0 to {}", channels - 1)))
    }
}

/// A place that was found, and for a window its contrast.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Found {
    row: i32,
    column: i32,
    contrast: i32,
}

/// Anything whose cells can be asked for.
pub trait Image {
    /// Returns the byte of a channel of a cell.
    fn cell(&self, row: usize, column: usize, channel: usize) -> u8;

    /// Returns row and column of the first cell of a channel, row after row, that is not 0.
    fn first(&self, shape: [usize; 3], channel: usize) -> Option<[usize; 2]> {
        cells(shape).find(|&[row, column]| self.cell(row, column, channel) != 0)
    }

    /// As [`first`](Self::first), of the last such cell.
    fn last(&self, shape: [usize; 3], channel: usize) -> Option<[usize; 2]> {
        let [rows, columns, _] = shape;
        let mut cells = (0..rows).rev().flat_map(|row| (0..columns).rev().map(move |column| [row, column]));
        cells.find(|&[row, column]| self.cell(row, column, channel) != 0)
    }
}

fn cells([rows, columns, _]: [usize; 3]) -> impl Iterator<Item = [usize; 2]> {
    (0..rows).flat_map(move |row| (0..columns).map(move |column| [row, column]))
}

/// Bytes, row after row, the channels of a cell beside each other.
struct Bytes<'a> {
    bytes: &'a [u8],
    shape: [usize; 3],
}

impl Image for Bytes<'_> {
    fn cell(&self, row: usize, column: usize, channel: usize) -> u8 {
        let [_, columns, channels] = self.shape;
        self.bytes[(row * columns + column) * channels + channel]
    }
}

fn sum(image: &impl Image, channel: u32, [top, left]: [usize; 2], [height, width]: [usize; 2]) -> u32 {
    let window = cells([height, width, 1]);
    window.map(|[row, column]| u32::from(image.cell(top + row, left + column, channel as usize))).sum()
}

fn find(image: &impl Image, shape: [usize; 3], find: Find) -> Option<Found> {
    let [rows, columns, _] = shape;
    let place = |[row, column]: [usize; 2]| Found { row: row as i32, column: column as i32, contrast: 0 };
    match find {
        Find::First(channel) => image.first(shape, channel as usize).map(place),
        Find::Last(channel) => image.last(shape, channel as usize).map(place),
        Find::Brightest { channel, size } | Find::Darkest { channel, size } => {
            let is_dark = matches!(find, Find::Darkest { .. });
            let (window, middle) = (size as usize, (size / 2) as i32);
            let corners = [rows + 1 - window, columns + 1 - window, 1];
            let across: Vec<u32> =
                cells([rows, corners[1], 1]).map(|corner| sum(image, channel, corner, [1, window])).collect();
            let mut best: Option<(u32, Found)> = None;
            for corner in cells(corners) {
                let sum = (corner[0]..corner[0] + window).map(|row| across[row * corners[1] + corner[1]]).sum();
                if best.is_none_or(|(best, _)| if is_dark { sum < best } else { sum > best }) {
                    best = Some((sum, place(corner)));
                }
            }
            let (best, Found { row, column, .. }) = best?;
            let total = u64::from(sum(image, channel, [0, 0], [rows, columns]));
            let mean = (total * u64::from(size * size) / (rows * columns) as u64) as i32;
            let contrast = if is_dark { mean - best as i32 } else { best as i32 - mean };
            Some(Found { row: row + middle, column: column + middle, contrast })
        }
    }
}

fn value(image: &impl Image, [rows, columns, _]: [usize; 3], feature: Feature, found: Option<Found>) -> i32 {
    match feature {
        Feature::Sum { channel, row, column, height, width } => {
            sum(image, channel, [row as usize, column as usize], [height as usize, width as usize]) as i32
        }
        Feature::Row(_) => found.map_or(-1, |found| found.row),
        Feature::Column(_) => found.map_or(-1, |found| found.column),
        Feature::Contrast(_) => found.map_or(0, |found| found.contrast),
        Feature::Cell { channel, down, right, .. } => {
            let at = |place: i32, offset: i32, end: usize| usize::try_from(place + offset).ok().filter(|at| *at < end);
            let cell = found.and_then(|found| Some((at(found.row, down, rows)?, at(found.column, right, columns)?)));
            cell.map_or(0, |(row, column)| i32::from(image.cell(row, column, channel as usize)))
        }
    }
}

/// A feature, and the number of the place that it looks for.
type Wanted = (Feature, Option<usize>);

/// The features of a state.
///
/// ```
/// use tpg_graph::SourceDocument;
/// use tpg_graph::image::{Feature, Find, Vision};
///
/// let features = vec![Feature::Row(Find::First(0)), Feature::Column(Find::First(0))];
/// let ball = SourceDocument::seen("ball", [2, 3, 1], features, 1);
/// let vision = Vision::new(&[ball]).expect("a source of an image");
/// assert_eq!(vision.state(&[0, 0, 0, 0, 0, 1]), [1.0, 2.0]);
/// ```
#[derive(Clone, Debug)]
pub struct Vision {
    shape: [usize; 3],
    finds: Vec<Find>,
    /// By the place in the state; `None` for a value that does not come from the image.
    features: Vec<Option<Wanted>>,
}

impl Vision {
    /// Collects the features of a state's sources; `None` if none of the sources is of an image.
    pub fn new(sources: &[SourceDocument]) -> Option<Self> {
        let shape = sources.iter().find_map(|source| source.image.as_ref())?.shape.map(|size| size as usize);
        let (mut finds, mut features) = (Vec::new(), Vec::new());
        let mut number = |find| {
            finds.iter().position(|other| *other == find).unwrap_or_else(|| {
                finds.push(find);
                finds.len() - 1
            })
        };
        for source in sources {
            match &source.image {
                Some(image) => {
                    features
                        .extend(image.features.iter().map(|&feature| Some((feature, feature.find().map(&mut number)))));
                }
                None => features.extend((0..source.length).map(|_| None)),
            }
        }
        Some(Self { shape, finds, features })
    }

    /// Returns the number of bytes of an image.
    pub fn bytes(&self) -> usize {
        self.shape.iter().product()
    }

    /// Returns the rows, columns and channels of an image.
    pub fn shape(&self) -> [usize; 3] {
        self.shape
    }

    /// Returns the places that are looked for.
    pub fn finds(&self) -> &[Find] {
        &self.finds
    }

    /// Returns the features, each with its place in the state and the number of the place that it looks for.
    pub fn features(&self) -> impl Iterator<Item = (usize, Feature, Option<usize>)> {
        let features = self.features.iter().enumerate();
        features.filter_map(|(input, wanted)| wanted.map(|(feature, find)| (input, feature, find)))
    }

    /// Draws images: a few set cells, noise, and noise over a brightness that grows to one side; the same for the same seed.
    pub fn sample(&self, count: usize, seed: u64) -> impl Iterator<Item = Vec<u8>> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let bytes = self.bytes();
        (0..count).map(move |_| {
            let kind = random.random_range(0..3);
            let shares: Vec<f64> = (0..self.shape[2]).map(|_| random.random::<f64>().powi(3)).collect();
            let byte = |place: usize| match kind {
                0 => u8::from(random.random_bool(shares[place % shares.len()])),
                1 => random.random(),
                _ => ((place * 200 / bytes) as u8) + random.random_range(0..50),
            };
            (0..bytes).map(byte).collect()
        })
    }

    /// Calls `set` with the place in the state and the value of each of the inputs that comes from the image.
    pub fn look(&self, image: &impl Image, inputs: impl Iterator<Item = usize>, mut set: impl FnMut(usize, f64)) {
        let mut found = vec![None; self.finds.len()];
        for input in inputs {
            let Some((feature, wanted)) = self.features[input] else { continue };
            let place = wanted
                .and_then(|number| *found[number].get_or_insert_with(|| find(image, self.shape, self.finds[number])));
            set(input, f64::from(value(image, self.shape, feature, place)));
        }
    }

    /// Returns the state that an image gives; 0 for values that do not come from it.
    ///
    /// # Panics
    /// If the image has another number of [`bytes`](Self::bytes).
    pub fn state(&self, bytes: &[u8]) -> Vec<f64> {
        assert_eq!(bytes.len(), self.bytes(), "an image of another shape");
        let mut state = vec![0.0; self.features.len()];
        self.look(&Bytes { bytes, shape: self.shape }, 0..self.features.len(), |input, value| state[input] = value);
        state
    }
}

impl SourceDocument {
    /// Creates a source of features of an image whose bytes are at most `brightest`.
    pub fn seen(name: impl Into<String>, shape: [u32; 3], features: Vec<Feature>, brightest: u8) -> Self {
        let ranges = features.iter().map(|feature| feature.range(shape, brightest)).collect();
        Self { image: Some(ImageSource { shape, features }), ..Self::new(name, "", ranges) }
    }
}

/// Columns, and rows, of the grid of sums in [`features_of`].
const GRID: [u32; 2] = [8, 6];
/// Cells to each side of the first channel's place, in [`features_of`].
const NEAR: i32 = 4;

/// Returns sources for a policy that sees an image with these channels. In one of cells that are set or not, the first and last
/// set cell of each channel, and the cells near the first one of the first channel. In one of brightnesses, the brightest and
/// the darkest window of three by three, and the sums of a grid.
pub fn features_of(shape: [u32; 3], channels: &[&str], brightest: u8) -> Vec<SourceDocument> {
    let [rows, columns, _] = shape;
    let places = |find| [Feature::Row(find), Feature::Column(find)];
    let near = |end: u32| -NEAR.min(end as i32 - 1)..=NEAR.min(end as i32 - 1);
    let mut sources = Vec::new();
    for (channel, name) in (0..).zip(channels) {
        if brightest == 1 {
            let at = [Find::First(channel), Find::Last(channel)].map(places).concat();
            sources.push(SourceDocument::seen(format!("{name}_at"), shape, at, 1));
            let cells = near(rows).flat_map(|down| near(columns).map(move |right| (down, right)));
            let cell = |(down, right)| Feature::Cell { channel, down, right, from: Find::First(0) };
            if channel > 0 {
                sources.push(SourceDocument::seen(format!("{name}_near"), shape, cells.map(cell).collect(), 1));
            }
            continue;
        }
        if rows.min(columns) >= 3 {
            let (bright, dark) = (Find::Brightest { channel, size: 3 }, Find::Darkest { channel, size: 3 });
            let ends = [bright, dark].map(|find| [&places(find)[..], &[Feature::Contrast(find)]].concat());
            for (end, features) in ["bright", "dark"].into_iter().zip(ends) {
                sources.push(SourceDocument::seen(format!("{name}_{end}"), shape, features, brightest));
            }
        }
        let [across, down] = [GRID[0].min(columns), GRID[1].min(rows)];
        let cell = |(row, column): (u32, u32)| {
            let part = |place: u32, of: u32, all: u32| (place * all / of, (place + 1) * all / of - place * all / of);
            let ((row, height), (column, width)) = (part(row, down, rows), part(column, across, columns));
            Feature::Sum { channel, row, column, height, width }
        };
        let grid = (0..down).flat_map(|row| (0..across).map(move |column| (row, column))).map(cell).collect();
        sources.push(SourceDocument::seen(format!("{name}_grid"), shape, grid, brightest));
    }
    sources
}

impl Graph {
    /// Removes the features of an image that no program reads.
    #[must_use]
    pub fn without_unread_features(mut self) -> Self {
        let mut is_read = vec![false; self.state_length()];
        let lines = self.programs.iter().flat_map(|program| &program.lines);
        for operand in lines.flat_map(|line| &line.operands) {
            if let Operand::Input(input) = operand {
                is_read[input.index()] = true;
            }
        }
        // A graph has a source, even if it reads nothing.
        if !is_read.contains(&true) {
            is_read[0] = true;
        }
        let (mut first, mut places, mut kept) = (0, Vec::new(), 0);
        for source in &mut self.sources {
            let length = source.ranges.len();
            let keeps: Vec<bool> =
                (first..first + length).map(|input| source.image.is_none() || is_read[input]).collect();
            first += length;
            for &keeps in &keeps {
                places.push(Input(kept));
                kept += u16::from(keeps);
            }
            if let Some(image) = &mut source.image {
                let mut keep = keeps.iter();
                source.ranges.retain(|_| keep.next() == Some(&true));
                let mut keep = keeps.iter();
                image.features.retain(|_| keep.next() == Some(&true));
                source.length = source.ranges.len() as u32;
            }
        }
        self.sources.retain(|source| !source.ranges.is_empty());
        for operand in
            self.programs.iter_mut().flat_map(|program| &mut program.lines).flat_map(|line| &mut line.operands)
        {
            if let Operand::Input(input) = operand {
                *input = places[input.index()];
            }
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::{Feature, Find, Vision};
    use crate::SourceDocument;

    fn look(shape: [u32; 3], image: &[u8], features: &[Feature]) -> Vec<f64> {
        let source = SourceDocument::seen("seen", shape, features.to_vec(), 255);
        Vision::new(&[source]).expect("an image").state(image)
    }

    #[test]
    fn places_are_found_row_after_row_in_their_channel() {
        let image = [0, 9, 1, 0, 0, 9, 0, 9, 0, 0, 5, 0];
        let [first, last, none] = [Find::First(0), Find::Last(0), Find::First(1)];
        let features = [first, last].map(|find| [Feature::Row(find), Feature::Column(find)]).concat();
        assert_eq!(look([2, 3, 2], &image, &features), [0.0, 1.0, 1.0, 2.0]);
        let cell = |channel, down, right, from| Feature::Cell { channel, down, right, from };
        let cells = [cell(1, 0, -1, first), cell(0, 1, 1, first), cell(1, -1, 0, first), cell(0, 0, 2, first)];
        assert_eq!(look([2, 3, 2], &image, &cells), [9.0, 5.0, 0.0, 0.0]);
        let empty = [Feature::Row(none), Feature::Column(none), cell(0, 0, 0, none)];
        assert_eq!(look([2, 3, 2], &[1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0], &empty), [-1.0, -1.0, 0.0]);
    }

    #[test]
    fn windows_are_compared_by_their_sums_and_the_first_of_equal_ones_wins() {
        let mut image = [100; 25];
        image[5 + 3] = 200;
        image[20] = 0;
        let (bright, dark) = (Find::Brightest { channel: 0, size: 3 }, Find::Darkest { channel: 0, size: 1 });
        let features = [
            Feature::Row(bright),
            Feature::Column(bright),
            Feature::Contrast(bright),
            Feature::Row(dark),
            Feature::Column(dark),
            Feature::Contrast(dark),
            Feature::Sum { channel: 0, row: 1, column: 2, height: 2, width: 2 },
        ];
        assert_eq!(look([5, 5, 1], &image, &features), [1.0, 2.0, 100.0, 4.0, 0.0, 100.0, 500.0]);
    }
}
