//! Outputs that are sums of the same values: a table of weights and one loop.

use super::comment::LinearSum;
use super::work::Work;
use crate::emit::c::field::field;
use crate::integers::{Integers, output_bits};
use crate::ir::{Module, Node};
use tpg_graph::{Counts, Graph};
use tpg_runtime::ops::Instruction;

/// Sums of fewer products take less flash one by one.
const FEW: usize = 12;

/// Sums of all values of a state, which have one type, each divided by a power of two and limited.
pub(in crate::emit) struct Dense<'a> {
    graph: &'a Graph,
    rows: Vec<DenseRow>,
}

struct DenseRow {
    weights: Vec<i64>,
    bias: i64,
    shift: i64,
}

/// The counts of every value of a state.
fn counts(graph: &Graph) -> impl Iterator<Item = &Counts> {
    graph.sources().iter().flat_map(|source| &source.counts)
}

/// The tables' text.
pub(in crate::emit) struct DenseTable {
    /// The type of a weight.
    pub(in crate::emit) weight: &'static str,
    pub(in crate::emit) columns: usize,
    pub(in crate::emit) rows: Vec<String>,
    /// The other tables: one number for each row.
    pub(in crate::emit) numbers: Vec<(&'static str, String)>,
    /// What the rows are for.
    pub(in crate::emit) names: String,
}

impl<'a> Dense<'a> {
    /// The sums of the only leaf, if tables are asked for and take less.
    pub(in crate::emit) fn find(module: &'a Module<'a>, integers: &Integers) -> Option<Self> {
        let graph = module.graph;
        let mut kinds = counts(graph).map(Counts::container);
        let kind = kinds.next()?;
        let is_one_kind = kinds.all(|other| other == kind) && graph.memory() == 0;
        let outputs = graph.outputs();
        let same = outputs.iter().all(|output| output_bits(output) == output_bits(&outputs[0]));
        if !integers.tables || !is_one_kind || !same {
            return None;
        }
        let rows = module.only_leaf()?.values.iter().map(|&value| {
            let (sum, divisor) = match module.node(value) {
                Node::Operation(Instruction::Quotient, [a, b]) => (a, module.node(b).as_constant()? as i64),
                _ => (value, 1),
            };
            let linear = LinearSum::new(module, &integers.forms[sum.index()])?;
            let weight = |input| linear.weights.get(&input).map_or(0, |&weight| weight as i64);
            let weights: Vec<i64> = graph.inputs().map(weight).collect();
            let is_small = weights.iter().all(|weight| i16::try_from(*weight).is_ok());
            let is_power = divisor > 0 && divisor & (divisor - 1) == 0;
            // Partial sums are added in another order: their bound is that of all magnitudes.
            let bias = linear.constant as i64;
            let most = bias.abs() + weights.iter().map(|weight| weight.abs() << (kind - 1)).sum::<i64>();
            (is_small && is_power && most <= i64::from(i32::MAX)).then_some(DenseRow {
                weights,
                bias,
                shift: i64::from(divisor.trailing_zeros()),
            })
        });
        let rows: Vec<DenseRow> = rows.collect::<Option<_>>()?;
        let products: usize = rows.iter().map(|row| row.weights.iter().filter(|weight| **weight != 0).count()).sum();
        (products >= FEW && rows.len() > 1).then_some(Self { graph, rows })
    }

    /// The turns of the outer loop and of the inner one.
    pub(super) fn turns(&self) -> [u64; 2] {
        [self.rows.len(), self.graph.state_length()].map(|turns| turns as u64)
    }

    /// The number that all rows share, or none.
    fn common(&self, number: impl Fn(usize) -> i64) -> Option<i64> {
        (0..self.rows.len()).all(|row| number(row) == number(0)).then(|| number(0))
    }

    fn low(&self, row: usize) -> i64 {
        self.graph.outputs()[row].range.min as i64
    }

    fn high(&self, row: usize) -> i64 {
        self.graph.outputs()[row].range.max as i64
    }

    /// Tests for weights of 8 bits.
    fn has_bytes(&self) -> bool {
        self.rows.iter().flat_map(|row| &row.weights).all(|weight| i8::try_from(*weight).is_ok())
    }

    /// Bits of the type of every value.
    fn container(&self) -> u32 {
        counts(self.graph).map(Counts::container).next().unwrap_or(16)
    }

    /// Tests for products of two bytes.
    fn is_narrow(&self) -> bool {
        self.has_bytes() && self.container() == 8
    }

    /// The tables.
    pub(in crate::emit) fn table(&self) -> DenseTable {
        let list =
            |numbers: &mut dyn Iterator<Item = i64>| numbers.map(|n| n.to_string()).collect::<Vec<_>>().join(", ");
        let all = 0..self.rows.len();
        let mut numbers = vec![("biases", list(&mut self.rows.iter().map(|row| row.bias)))];
        if self.common(|row| self.rows[row].shift).is_none() {
            numbers.push(("shifts", list(&mut self.rows.iter().map(|row| row.shift))));
        }
        if self.common(|row| self.low(row)).is_none() {
            numbers.push(("lows", list(&mut all.clone().map(|row| self.low(row)))));
        }
        if self.common(|row| self.high(row)).is_none() {
            numbers.push(("highs", list(&mut all.map(|row| self.high(row)))));
        }
        let names: Vec<&str> = self.graph.outputs().iter().map(|output| output.name.as_str()).collect();
        DenseTable {
            weight: if self.has_bytes() { "int8_t" } else { "int16_t" },
            columns: self.graph.state_length(),
            rows: self.rows.iter().map(|row| list(&mut row.weights.iter().copied())).collect(),
            numbers,
            names: names.join(", "),
        }
    }

    /// The statements of the loop over rows and columns.
    pub(in crate::emit) fn body(&self, work: &Work<'_>, prefix: &str) -> String {
        let upper = prefix.to_ascii_uppercase();
        let number = |common: Option<i64>, name: &str| match common {
            Some(number) if number < 0 => format!("({number})"),
            Some(number) => number.to_string(),
            None => format!("{upper}_NUMBER(&{prefix}_{name}[row])"),
        };
        let source = &self.graph.sources()[0];
        let values =
            format!("{}state->{}", if source.counts.len() > 1 { "" } else { "&" }, field(self.graph, &source.name));
        let first = field(self.graph, &self.graph.outputs()[0].name);
        let bits = output_bits(&self.graph.outputs()[0]);
        let shift = self.common(|row| self.rows[row].shift);
        let call = |function, arguments: &[String]| work.spelling.call(function, false, arguments);
        let shifted = match shift {
            Some(0) => "sum".to_owned(),
            Some(bits) => call("shift", &["sum".to_owned(), format!("{bits}U")]),
            None => {
                let bits = format!("(uint32_t){upper}_NUMBER(&{prefix}_shifts[row])");
                call("shift", &["sum".to_owned(), bits])
            }
        };
        let ([rows, columns], container) = (self.turns(), self.container());
        let [low, high] = [(self.common(|row| self.low(row)), "lows"), (self.common(|row| self.high(row)), "highs")]
            .map(|(common, name)| number(common, name));
        let weight = format!("{upper}_WEIGHT(&{prefix}_weights[row][column])");
        // Bytes are multiplied in int, which has at least 16 bits: a core of 8 bits has an instruction for it.
        let product = if self.is_narrow() {
            format!("(int32_t)(values[column] * {weight})")
        } else {
            format!("(int32_t)values[column] * {weight}")
        };
        let limited = call("clamp", &[shifted, low, high]);
        format!(
            "    /* Fields of one type lie as in an array. */
    const int{container}_t *const values = {values};
    int{bits}_t *const answers = &action->{first};
    uint_fast8_t row;
    uint_fast8_t column;

    for (row = 0U; row < {rows}U; row++) {{
        int32_t sum = {upper}_NUMBER(&{prefix}_biases[row]);

        for (column = 0U; column < {columns}U; column++) {{
            sum += {product};
        }}
        answers[row] = (int{bits}_t){limited};
    }}
"
        )
    }
}
