//! Axes: mapping from values to positions, and tick labels.

use Scale::*;

/// Distribution of values along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Scale {
    Linear,
    /// Logarithmic.
    Log,
}

/// One axis of a plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Label with the unit.
    pub label: String,
    scale: Scale,
    low: Option<f64>,
    high: Option<f64>,
}

impl Axis {
    /// Creates a linear axis.
    pub fn linear(label: &str) -> Self {
        Self { label: label.to_owned(), scale: Linear, low: None, high: None }
    }

    /// Creates a logarithmic axis; values below `low` are shown at `low`.
    pub fn log(label: &str, low: f64) -> Self {
        Self { label: label.to_owned(), scale: Log, low: Some(low), high: None }
    }

    /// Returns the same axis with fixed ends that do not depend on the data.
    pub fn between(self, low: f64, high: f64) -> Self {
        Self { low: Some(low), high: Some(high), ..self }
    }

    /// Fits the ends of the axis to the data.
    pub(super) fn fit(&self, data: impl Iterator<Item = f64>) -> Fitted<'_> {
        let finite = data.filter(|value| value.is_finite());
        let (least, most) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        let low = self.low.unwrap_or(if least.is_finite() { least } else { 0.0 });
        let high = self.high.unwrap_or(if most.is_finite() { most } else { 1.0 });
        // A single value stands in the middle.
        let (low, high) =
            if high > low { (low, high) } else { (low - 0.1 * low.abs().max(1.0), low + 0.1 * low.abs().max(1.0)) };
        Fitted { axis: self, low, high }
    }
}

/// An axis with known ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fitted<'a> {
    axis: &'a Axis,
    low: f64,
    high: f64,
}

impl Fitted<'_> {
    /// Returns the axis with room at both ends that no one has fixed: points on an end would be cut.
    pub(super) fn roomy(self) -> Self {
        let Linear = self.axis.scale else { return self };
        let room = 0.05 * (self.high - self.low);
        let low = if self.axis.low.is_none() { self.low - room } else { self.low };
        let high = if self.axis.high.is_none() { self.high + room } else { self.high };
        Self { low, high, ..self }
    }

    /// Returns the position of a value: 0 at the low end, 1 at the high end.
    pub(super) fn place(&self, value: f64) -> f64 {
        let value = value.clamp(self.low, self.high);
        match self.axis.scale {
            // The crate libm instead of the system's: the same bytes on every machine.
            Log => {
                let low = libm::log10(self.low);
                (libm::log10(value) - low) / (libm::log10(self.high) - low)
            }
            Linear => (value - self.low) / (self.high - self.low),
        }
    }

    /// Returns the values to be labelled on the axis, with their text.
    pub(super) fn ticks(&self) -> Vec<(f64, String)> {
        match self.axis.scale {
            Linear => self.round_steps(),
            Log => {
                let (low, high) = (libm::log10(self.low), libm::log10(self.high));
                let powers = (libm::ceil(low - 1e-9) as i32)..=(libm::floor(high + 1e-9) as i32);
                powers.map(|power| (power_of_ten(power), number(power_of_ten(power), power))).collect()
            }
        }
    }

    /// Returns about five multiples of 1, 2 or 5 times a power of ten.
    fn round_steps(&self) -> Vec<(f64, String)> {
        let wanted = (self.high - self.low) / 5.0;
        let power = libm::floor(libm::log10(wanted)) as i32;
        let factor = [1.0, 2.0, 5.0, 10.0].into_iter().find(|factor| factor * power_of_ten(power) >= wanted * 0.999);
        let step = factor.unwrap_or(10.0) * power_of_ten(power);
        let first = libm::ceil(self.low / step - 1e-9) as i64;
        let last = libm::floor(self.high / step + 1e-9) as i64;
        (first..=last).map(|k| (k as f64 * step, number(k as f64 * step, power))).collect()
    }
}

fn power_of_ten(power: i32) -> f64 {
    if power < 0 { 1.0 / power_of_ten(-power) } else { (0..power).fold(1.0, |product, _| product * 10.0) }
}

/// Formats a number with the decimals needed for steps of that power of ten: `0.5`, `200 k`, `1.0 M`.
fn number(value: f64, power: i32) -> String {
    let (thousands, unit) = match value.abs() {
        1e6.. => (6, " M"),
        1e4.. => (3, " k"),
        _ => (0, ""),
    };
    let decimals = usize::try_from(thousands - power).unwrap_or(0);
    format!("{:.decimals$}{unit}", value / power_of_ten(thousands)).replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::Axis;

    fn texts(axis: &Axis, data: [f64; 2]) -> Vec<String> {
        axis.fit(data.into_iter()).ticks().into_iter().map(|(_, text)| text).collect()
    }

    #[test]
    fn ticks_are_round_and_inside() {
        assert_eq!(texts(&Axis::linear(""), [0.0, 1.0]), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(texts(&Axis::linear(""), [-431.0, 12.0]), ["−400", "−300", "−200", "−100", "0"]);
        assert_eq!(texts(&Axis::linear(""), [0.0, 1e6])[..3], ["0", "200 k", "400 k"]);
        assert_eq!(texts(&Axis::linear(""), [8e5, 1.2e6]), ["800 k", "900 k", "1.00 M", "1.10 M", "1.20 M"]);
        assert_eq!(texts(&Axis::log("", 0.1), [0.5, 300.0]), ["0.1", "1", "10", "100"]);
        assert_eq!(texts(&Axis::linear(""), [f64::NAN, f64::NAN]).len(), 6, "no data is no reason to fail");
    }

    #[test]
    fn room_is_left_at_ends_that_follow_the_data() {
        let ends = |axis: &Axis| {
            let fitted = axis.fit([0.0, 10.0].into_iter()).roomy();
            [fitted.low, fitted.high]
        };
        assert!(ends(&Axis::linear("")) == [-0.5, 10.5]);
        assert!(ends(&Axis::linear("").between(0.0, 20.0)) == [0.0, 20.0]);
        assert!(ends(&Axis::log("", 1.0)) == [1.0, 10.0]);
    }

    #[test]
    fn values_stand_between_the_ends() {
        let axis = Axis::log("", 1.0).between(1.0, 100.0);
        let fitted = axis.fit([].into_iter());
        assert!([0.0, 1.0, 10.0, 100.0, 1e9].map(|v| fitted.place(v)) == [0.0, 0.0, 0.5, 1.0, 1.0]);
    }
}
