//! Safetensors files: named `f32` tensors and one JSON text, checked as they are read.

use super::config::check_widths;
use crate::run_args::place;
use safetensors::tensor::{Dtype, SafeTensors, TensorView, serialize};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::Read as _;
use std::path::Path;
use tpg_graph::error::{Finding, InputError, Place};
use tpg_graph::files::write_atomically;
use tpg_nn::{Mlp, Shape};

/// The metadata key that holds the JSON text. One key alone: several would be written in no fixed order.
const KEY: &str = "tpg";

/// A tensor: its shape and its values, row-major.
#[derive(Clone, Debug, PartialEq)]
pub struct Tensor {
    /// The length of each axis.
    pub shape: Vec<usize>,
    /// The values.
    pub values: Vec<f32>,
}

/// A file's tensors and its JSON text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tensors {
    /// By name.
    pub tensors: BTreeMap<String, Tensor>,
    /// The JSON text; `None` in a file that others wrote.
    pub text: Option<String>,
}

impl Tensors {
    /// The bytes of a safetensors file: the same for the same content.
    pub fn to_bytes(&self) -> Vec<u8> {
        let bytes: Vec<(&str, &[usize], Vec<u8>)> = (self.tensors.iter())
            .map(|(name, tensor)| {
                let bytes = tensor.values.iter().flat_map(|value| value.to_le_bytes()).collect();
                (name.as_str(), tensor.shape.as_slice(), bytes)
            })
            .collect();
        let views = bytes.iter().map(|(name, shape, bytes)| {
            let view = TensorView::new(Dtype::F32, shape.to_vec(), bytes).expect("a shape that fits its values");
            (*name, view)
        });
        let metadata = self.text.as_ref().map(|text| [(KEY.to_owned(), text.clone())].into_iter().collect());
        serialize(views, metadata).expect("plain tensors")
    }

    /// Writes the file as a whole or not at all.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), InputError> {
        write_atomically(path, &self.to_bytes())
    }

    /// Reads a file of at most `limit` bytes: never more memory than a few times that.
    ///
    /// # Errors
    /// If the file cannot be read, is larger, is no safetensors file, or holds other numbers than `f32`.
    pub fn read(path: &Path, limit: u64) -> Result<Self, InputError> {
        let accepted = "a safetensors file";
        let file = File::open(path).map_err(|error| InputError::io(path, &error, accepted))?;
        let mut bytes = Vec::new();
        // Reads instead of trusting the file's size: it may be a pipe.
        file.take(limit + 1).read_to_end(&mut bytes).map_err(|error| InputError::io(path, &error, accepted))?;
        let refuse = |found: String, accepted: String| {
            InputError::new(path.display().to_string(), Place::Whole, found, accepted)
        };
        if bytes.len() as u64 > limit {
            return Err(refuse(format!("more than {limit} bytes"), format!("up to {limit} bytes")));
        }
        Self::from_bytes(&bytes).map_err(|finding| place(path, finding))
    }

    /// Reads the bytes of a file.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Finding> {
        let no_file = |error: safetensors::SafeTensorError| {
            Finding::new("", format!("no safetensors: {error}"), "a whole safetensors file")
        };
        let (_, metadata) = SafeTensors::read_metadata(bytes).map_err(no_file)?;
        let text = metadata.metadata().as_ref().and_then(|all| all.get(KEY)).cloned();
        let mut tensors = BTreeMap::new();
        for (name, view) in SafeTensors::deserialize(bytes).map_err(no_file)?.iter() {
            if view.dtype() != Dtype::F32 {
                return Err(Finding::new(name, format!("numbers of type {:?}", view.dtype()), "F32"));
            }
            let numbers =
                view.data().chunks_exact(4).map(|bytes| f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]));
            tensors.insert(name.to_owned(), Tensor { shape: view.shape().to_vec(), values: numbers.collect() });
        }
        Ok(Self { tensors, text })
    }

    /// Takes a tensor of finite numbers.
    fn take(&mut self, name: String, shape: &[usize]) -> Result<Vec<f32>, Finding> {
        let Some(tensor) = self.tensors.remove(&name) else {
            return Err(Finding::new(name, "nothing", format!("a tensor of shape {shape:?}")));
        };
        if tensor.shape != shape {
            return Err(Finding::new(name, format!("shape {:?}", tensor.shape), format!("shape {shape:?}")));
        }
        match tensor.values.iter().position(|value| !value.is_finite()) {
            Some(at) => Err(Finding::new(name, format!("{} at place {at}", tensor.values[at]), "finite numbers")),
            None => Ok(tensor.values),
        }
    }

    /// Takes the network of some inputs and outputs: hidden layers by their names and units, as many as the bias has where that is
    /// not known, and the two layers behind them, whose outputs are one behind the other.
    ///
    /// # Errors
    /// If a tensor is missing, has another shape, or a number that is not finite.
    pub(super) fn take_network(
        &mut self,
        (inputs, outputs): (usize, usize),
        hidden: Vec<(String, Option<usize>)>,
        heads: [&str; 2],
    ) -> Result<Mlp, Finding> {
        let mut shape = Shape { inputs, hidden: Vec::new(), outputs: 2 * outputs };
        let (mut width, mut flat) = (inputs, Vec::new());
        let mut append = |weights: &[f32], bias: &[f32], width: usize| {
            // Column-major.
            (0..width).for_each(|column| flat.extend(weights.iter().skip(column).step_by(width)));
            flat.extend(bias);
        };
        for (name, units) in hidden {
            let of_bias = || self.tensors.get(&format!("{name}.bias")).map_or(0, |bias| bias.values.len());
            let units = units.unwrap_or_else(of_bias);
            check_widths(&format!("{name}.bias"), &[units])?;
            let weights = self.take(format!("{name}.weight"), &[units, width])?;
            append(&weights, &self.take(format!("{name}.bias"), &[units])?, width);
            shape.hidden.push(units);
            width = units;
        }
        let mut both = |part: &str, shape: &[usize]| {
            let [first, second] = heads.map(|head| self.take(format!("{head}.{part}"), shape));
            Ok::<_, Finding>([first?, second?].concat())
        };
        append(&both("weight", &[outputs, width])?, &both("bias", &[outputs])?, width);
        Ok(Mlp::from_parameters(shape, flat).expect("every tensor has its shape"))
    }

    /// Refuses tensors that were not taken.
    pub(super) fn refuse_rest(&self, accepted: &str) -> Result<(), Finding> {
        let rest = self.tensors.keys().next();
        rest.map_or(Ok(()), |name| Err(Finding::new(name, "a tensor of that name", accepted)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn example() -> Tensors {
        let matrix = Tensor { shape: vec![2, 3], values: vec![1.0, 2.0, 3.0, 4.0, -5.5, 0.0] };
        let tensors = [("weight".to_owned(), matrix), ("bias".to_owned(), Tensor::flat(vec![0.25; 7]))].into();
        Tensors { tensors, text: Some(r#"{"a":1}"#.to_owned()) }
    }

    impl Tensor {
        /// A vector.
        pub(crate) fn flat(values: Vec<f32>) -> Self {
            Self { shape: vec![values.len()], values }
        }
    }

    #[test]
    fn what_is_written_is_read_and_always_the_same() {
        assert_eq!(Tensors::from_bytes(&example().to_bytes()), Ok(example()));
        assert_eq!(example().to_bytes(), example().to_bytes());
    }

    #[test]
    fn damaged_files_are_refused() {
        let whole = example().to_bytes();
        for length in 0..whole.len() {
            assert!(Tensors::from_bytes(&whole[..length]).is_err(), "cut to {length} bytes");
        }
        let mut huge_header = whole.clone();
        huge_header[..8].copy_from_slice(&u64::MAX.to_le_bytes());
        assert!(Tensors::from_bytes(&huge_header).is_err());
        let text = String::from_utf8_lossy(&whole).into_owned();
        let huge_shape = text.replace("[2,3]", "[2,3000000000]");
        assert_ne!(huge_shape, text);
        assert!(Tensors::from_bytes(huge_shape.as_bytes()).is_err());
    }

    #[test]
    fn other_numbers_and_too_many_are_refused() {
        let bytes = [0u8; 8];
        let view = TensorView::new(Dtype::F64, vec![1], &bytes).expect("one double");
        let file = serialize([("weight", view)], None).expect("a file");
        assert_eq!(Tensors::from_bytes(&file).map_err(|finding| finding.key), Err("weight".to_owned()));
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("large");
        std::fs::write(&path, example().to_bytes()).expect("the folder can be written");
        assert!(Tensors::read(&path, 1000).is_ok());
        assert!(Tensors::read(&path, 50).is_err());
    }
}
