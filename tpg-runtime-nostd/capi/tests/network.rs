//! Networks of random shapes: a C program that links the library answers with the same bits as Rust.

use crate::linked;
use std::fmt::Write as _;
use std::fs;
use tempfile::TempDir;
use tpg_codegen::emit::Prefix;
use tpg_codegen::policy::{FloatLayer, FloatNetwork, FloatOutput, FloatValue, Input, to_c, to_words};
use tpg_runtime::net::{Kind, Model, OutputKind, Squash};
use tpg_testing::numbers::Numbers;

/// A number from −1 to 1.
fn unit(numbers: &mut Numbers) -> f32 {
    numbers.within(1 << 23) as f32 / (1 << 23) as f32
}

fn network(sizes: &[usize], argmax: bool, numbers: &mut Numbers) -> FloatNetwork {
    let layers = sizes.windows(2).map(|pair| FloatLayer {
        inputs: pair[0],
        weights: (0..pair[0] * pair[1]).map(|_| unit(numbers)).collect(),
        bias: (0..pair[1]).map(|_| unit(numbers)).collect(),
    });
    let layers = layers.collect();
    let outputs = sizes[sizes.len() - 1];
    let names = (0..outputs).map(|number| format!("output {number}"));
    let value = |(number, name): (usize, String)| {
        let squash = if number % 2 == 0 { Squash::Tanh } else { Squash::Clamp };
        FloatValue { name, min: -2.0, max: 1.0 + number as f32, squash }
    };
    FloatNetwork {
        inputs: (0..sizes[0])
            .map(|number| Input { name: format!("input {number}"), offset: unit(numbers), scale: 0.5 + unit(numbers) })
            .collect(),
        layers,
        output: if argmax {
            FloatOutput::Argmax(names.collect())
        } else {
            FloatOutput::Values(names.enumerate().map(value).collect())
        },
    }
}

/// Every answer of a model, a line of hexadecimal words each.
fn by_rust(words: &[u32], states: &[Vec<f32>]) -> String {
    let model = Model::parse(words).expect("what was packed");
    let (mut scratch, mut values) = (vec![0; model.scratch()], vec![0.0f32; model.outputs()]);
    let mut lines = String::new();
    for state in states {
        if model.answer() == OutputKind::Argmax {
            let _ = writeln!(lines, "{}", model.choose(state, &mut scratch).expect("an action"));
        } else {
            assert!(model.values(state, &mut scratch, &mut values));
            values.iter().for_each(|value| {
                let _ = write!(lines, "{:08x} ", value.to_bits());
            });
            lines.push('\n');
        }
    }
    lines
}

#[test]
fn c_answers_with_the_same_bits_as_rust_for_any_shape() {
    let Some(archive) = linked::archive("networks of any shape in C") else { return };
    let mut numbers = Numbers(5);
    let shapes: [&[usize]; 6] =
        [&[1, 1], &[3, 5], &[7, 9, 2], &[4, 8, 8, 6], &[17, 20, 3, 11, 9], &[2, 33, 5, 40, 6, 13]];
    let prefix: Prefix = "network".parse().expect("a prefix");
    for (number, (sizes, kind)) in shapes.iter().flat_map(|sizes| Kind::ALL.map(|kind| (sizes, kind))).enumerate() {
        let float = network(sizes, number % 4 == 3, &mut numbers);
        let mut states: Vec<Vec<f32>> =
            (0..300).map(|_| (0..sizes[0]).map(|_| 4.0 * unit(&mut numbers)).collect()).collect();
        let policy = float.quantise(&states, kind, "0".repeat(64)).expect("it fits");
        states.push(vec![f32::NAN; sizes[0]]);
        states.push(vec![f32::INFINITY; sizes[0]]);
        let folder = TempDir::new().expect("a temporary folder");
        for file in to_c(&policy, &prefix).expect("it packs") {
            fs::write(folder.path().join(&file.name), file.text).expect("the folder can be written");
        }
        let mut text = String::from("static const uint32_t states[] = {\n");
        for value in states.iter().flatten() {
            let _ = writeln!(text, "    0x{:08x}U,", value.to_bits());
        }
        text.push_str("};\n");
        fs::write(folder.path().join("states.h"), text).expect("the folder can be written");
        let output = linked::output_of("network.c", folder.path(), &["network.c"], &archive);
        let words = to_words(&policy).expect("it packs");
        assert!(output == by_rust(&words, &states), "{sizes:?}, {kind:?}");
    }
}
