//! Images as observations: the features that a policy reads.

use crate::error;
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods};
use pyo3::intern;
use pyo3::prelude::*;
use tpg_graph::SourceDocument;
use tpg_graph::image::{MAX_CELLS, Vision, features_of};

/// The most channels of an image.
const MAX_CHANNELS: usize = 16;

/// The features of an image, which make a flat state.
#[pyclass(frozen, module = "tpg_train._tpg")]
#[derive(Clone, Debug)]
pub(crate) struct Eye {
    pub(crate) sources: Vec<SourceDocument>,
    vision: Vision,
    shape: Vec<usize>,
    brightest: u8,
}

#[pymethods]
impl Eye {
    /// Creates the features of an image of `shape`, rows and columns and perhaps channels, whose values are at most `brightest`.
    #[new]
    fn new(shape: Vec<usize>, brightest: u8) -> PyResult<Self> {
        let sizes = match shape[..] {
            [rows, columns] => [rows, columns, 1],
            [rows, columns, channels] => [rows, columns, channels],
            _ => [0, 0, 0],
        };
        let cells = sizes[0].saturating_mul(sizes[1]);
        if !(1..=MAX_CELLS as usize).contains(&cells) || !(1..=MAX_CHANNELS).contains(&sizes[2]) {
            return Err(error::input(format!(
                "images of shape {shape:?}; accepted: rows, columns and up to {MAX_CHANNELS} channels, at most {MAX_CELLS} cells"
            )));
        }
        let names: Vec<String> = match sizes[2] {
            1 => vec!["image".to_owned()],
            channels => (0..channels).map(|channel| format!("channel_{channel}")).collect(),
        };
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let sources = features_of(sizes.map(|size| size as u32), &names, brightest);
        let vision = Vision::new(&sources).ok_or_else(|| error::input("an image without features"))?;
        Ok(Self { sources, vision, shape, brightest })
    }

    /// Returns the sources: names, with the range of each value.
    fn parts(&self) -> Vec<(String, Vec<[f64; 2]>)> {
        self.sources.iter().map(|source| (source.name.clone(), source.ranges.clone())).collect()
    }

    fn __getnewargs__(&self) -> (Vec<usize>, u8) {
        (self.shape.clone(), self.brightest)
    }

    /// Returns the flat state of an image of bytes or flags.
    fn look<'py>(&self, image: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let numpy = image.py().import(intern!(image.py(), "numpy"))?;
        let array = numpy.call_method1(intern!(image.py(), "asarray"), (image,))?;
        let (found, kind): (Vec<usize>, String) =
            (array.getattr("shape")?.extract()?, array.getattr("dtype")?.str()?.extract()?);
        if found != self.shape || !["uint8", "bool"].contains(&kind.as_str()) {
            let Self { shape, .. } = self;
            return Err(error::input(format!("an image of {found:?} of {kind}; accepted: {shape:?} of uint8 or bool")));
        }
        let bytes = array.call_method1(intern!(image.py(), "astype"), ("uint8",))?;
        let bytes: Vec<u8> = bytes.cast::<PyArrayDyn<u8>>()?.readonly().as_array().iter().copied().collect();
        Ok(PyArray1::from_vec(image.py(), self.vision.state(&bytes)))
    }
}
