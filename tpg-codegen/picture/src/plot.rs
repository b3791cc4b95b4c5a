//! Plots: lines, bands, points, boxes and rules between two axes.

use super::axis::{Axis, Fitted};
use super::svg::{Point, Svg};

const SIZE: [f64; 2] = [620.0, 340.0];
/// Left, top, right and bottom margins for numbers and labels; names need more on the left.
const MARGIN: [f64; 4] = [72.0, 12.0, 14.0, 44.0];
/// Width of the label of the y axis with its gaps, and of a character of a name.
const LABEL: [f64; 2] = [30.0, 6.2];
const LEGEND_ROW: f64 = 18.0;
const LEGEND_COLUMN: f64 = 270.0;

/// One of eight colours that are distinguishable, including for colour-blind readers (Okabe and Ito).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour(pub usize);

impl Colour {
    fn class(self) -> String {
        format!("c{}", self.0 % 8)
    }
}

/// A five-number summary of a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FiveNumbers {
    /// The fifth percentile.
    pub low: f64,
    /// The first quartile.
    pub first: f64,
    /// The median.
    pub median: f64,
    /// The third quartile.
    pub third: f64,
    /// The 95th percentile.
    pub high: f64,
}

impl FiveNumbers {
    /// Summarises a sample; `None` if it is empty.
    pub fn new(sample: &[f64]) -> Option<Self> {
        let mut sorted = sample.to_vec();
        sorted.sort_by(f64::total_cmp);
        let last = sorted.len().checked_sub(1)?;
        let at = |part: f64| {
            let place = part * last as f64;
            let below = place as usize;
            let rest = place - below as f64;
            sorted[below] + rest * (sorted[(below + 1).min(last)] - sorted[below])
        };
        Some(Self { low: at(0.05), first: at(0.25), median: at(0.5), third: at(0.75), high: at(0.95) })
    }
}

#[derive(Clone, Debug)]
enum Mark {
    Line(Vec<Point>),
    /// A band: x, lower and upper y.
    Band(Vec<[f64; 3]>),
    Points(Vec<(Point, String)>),
    /// A box at x.
    Box(f64, FiveNumbers),
    /// A horizontal rule at y.
    Rule(f64, String),
}

/// A plot under construction.
#[derive(Clone, Debug)]
pub struct Plot {
    x: Axis,
    y: Axis,
    marks: Vec<(Colour, Mark)>,
    legend: Vec<(Colour, String)>,
}

impl Plot {
    /// Creates an empty plot.
    pub fn new(x: Axis, y: Axis) -> Self {
        Self { x, y, marks: Vec::new(), legend: Vec::new() }
    }

    /// Adds a colour to the legend below the plot.
    pub fn name(&mut self, colour: Colour, name: &str) {
        self.legend.push((colour, name.to_owned()));
    }

    /// Adds a line.
    pub fn line(&mut self, colour: Colour, points: Vec<Point>) {
        self.marks.push((colour, Mark::Line(points)));
    }

    /// Adds a band between two lines: x, lower and upper y.
    pub fn band(&mut self, colour: Colour, band: Vec<[f64; 3]>) {
        self.marks.push((colour, Mark::Band(band)));
    }

    /// Adds points, each with a tooltip.
    pub fn points(&mut self, colour: Colour, points: Vec<(Point, String)>) {
        self.marks.push((colour, Mark::Points(points)));
    }

    /// Adds a box from quartile to quartile, with whiskers, at x.
    pub fn five(&mut self, colour: Colour, x: f64, five: FiveNumbers) {
        self.marks.push((colour, Mark::Box(x, five)));
    }

    /// Adds a horizontal rule with a label at its end.
    pub fn rule(&mut self, y: f64, text: &str) {
        self.marks.push((Colour(0), Mark::Rule(y, text.to_owned())));
    }

    /// Returns the plot as an element of a page.
    pub fn svg(&self, title: &str) -> String {
        let [width, height] = SIZE;
        let rows = self.legend.len().div_ceil(2) as f64;
        let mut svg = Svg::new(width, height + rows * LEGEND_ROW);
        let (xs, ys): (Vec<f64>, Vec<f64>) = self.extent().into_iter().map(|[x, y]| (x, y)).unzip();
        let mut frame = PlotFrame { x: self.x.fit(xs.into_iter()), y: self.y.fit(ys.into_iter()), left: MARGIN[0] };
        let longest = frame.y.ticks().iter().map(|(_, text)| text.chars().count()).max().unwrap_or(0);
        frame.left = frame.left.max(LABEL[0] + LABEL[1] * longest as f64);
        if self.marks.iter().any(|(_, mark)| matches!(mark, Mark::Points(_))) {
            (frame.x, frame.y) = (frame.x.roomy(), frame.y.roomy());
        }
        self.axes(&mut svg, &frame);
        for (colour, mark) in &self.marks {
            mark.draw(&mut svg, &frame, &colour.class());
        }
        for (place, (colour, name)) in self.legend.iter().enumerate() {
            let x = MARGIN[0] + (place % 2) as f64 * LEGEND_COLUMN;
            let y = height + (place / 2) as f64 * LEGEND_ROW;
            svg.rect(&format!("fill {}", colour.class()), [x, y - 1.0], [12.0, 12.0], "");
            svg.text("", [x + 18.0, y + 9.0], name);
        }
        svg.finish(title)
    }

    /// Returns points that span all marks; NaN where a mark imposes no limit.
    fn extent(&self) -> Vec<Point> {
        self.marks
            .iter()
            .flat_map(|(_, mark)| match mark {
                Mark::Line(points) => points.clone(),
                Mark::Band(band) => band.iter().flat_map(|&[x, low, high]| [[x, low], [x, high]]).collect(),
                Mark::Points(points) => points.iter().map(|(point, _)| *point).collect(),
                Mark::Box(x, five) => vec![[*x, five.low], [*x, five.high]],
                Mark::Rule(y, _) => vec![[f64::NAN, *y]],
            })
            .collect()
    }

    fn axes(&self, svg: &mut Svg, frame: &PlotFrame<'_>) {
        let ([_, top, right, bottom], left) = (MARGIN, frame.left);
        let [width, height] = SIZE;
        for (value, text) in frame.y.ticks() {
            let y = frame.at([f64::NAN, value])[1];
            svg.line("grid", [left, y], [width - right, y]);
            svg.text("end", [left - 6.0, y + 4.0], &text);
        }
        for (value, text) in frame.x.ticks() {
            let x = frame.at([value, f64::NAN])[0];
            svg.line("grid", [x, top], [x, height - bottom]);
            svg.text("middle", [x, height - bottom + 16.0], &text);
        }
        svg.text("middle label", [(left + width - right) / 2.0, height - 8.0], &self.x.label);
        svg.upright_text("middle label", [13.0, (top + height - bottom) / 2.0], &self.y.label);
    }
}

/// Both axes: maps values to positions in the picture.
struct PlotFrame<'a> {
    x: Fitted<'a>,
    y: Fitted<'a>,
    left: f64,
}

impl PlotFrame<'_> {
    fn at(&self, [x, y]: Point) -> Point {
        let ([_, top, right, bottom], left) = (MARGIN, self.left);
        let [width, height] = SIZE;
        [left + self.x.place(x) * (width - left - right), height - bottom - self.y.place(y) * (height - top - bottom)]
    }
}

impl Mark {
    fn draw(&self, svg: &mut Svg, frame: &PlotFrame<'_>, colour: &str) {
        match self {
            Self::Line(points) => {
                let points: Vec<Point> = points.iter().map(|&point| frame.at(point)).collect();
                // A line needs two points; a single one is shown all the same.
                if let [point] = points[..] {
                    svg.circle(&format!("fill {colour}"), point, 3.5, "");
                }
                svg.polyline(&format!("line {colour}"), &points);
            }
            Self::Band(band) => {
                let upper = band.iter().map(|&[x, _, high]| frame.at([x, high]));
                let lower = band.iter().rev().map(|&[x, low, _]| frame.at([x, low]));
                svg.polygon(&format!("band {colour}"), &upper.chain(lower).collect::<Vec<_>>());
            }
            Self::Points(points) => {
                for (point, hint) in points {
                    svg.circle(&format!("fill {colour}"), frame.at(*point), 3.5, hint);
                }
            }
            Self::Box(x, five) => {
                let [low, first, median, third, high] =
                    [five.low, five.first, five.median, five.third, five.high].map(|y| frame.at([*x, y]));
                let line = format!("line {colour}");
                svg.line(&line, low, high);
                let hint = format!("median {:.1}, quartiles {:.1} and {:.1}", five.median, five.first, five.third);
                let half = 9.0;
                svg.rect(
                    &format!("box {colour}"),
                    [third[0] - half, third[1]],
                    [2.0 * half, first[1] - third[1]],
                    &hint,
                );
                svg.line(&line, [median[0] - half, median[1]], [median[0] + half, median[1]]);
            }
            Self::Rule(y, text) => {
                let y = frame.at([f64::NAN, *y])[1];
                svg.line("rule", [frame.left, y], [SIZE[0] - MARGIN[2], y]);
                svg.text("end note", [SIZE[0] - MARGIN[2] - 3.0, y - 4.0], text);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, Colour, FiveNumbers, Plot};

    #[test]
    fn five_numbers_of_a_hundred_and_one() {
        let sample: Vec<f64> = (0..=100).rev().map(f64::from).collect();
        let expected = FiveNumbers { low: 5.0, first: 25.0, median: 50.0, third: 75.0, high: 95.0 };
        assert_eq!(FiveNumbers::new(&sample), Some(expected));
        assert_eq!(FiveNumbers::new(&[]), None);
    }

    #[test]
    fn a_single_value_is_shown() {
        let mut plot = Plot::new(Axis::linear("x").between(0.0, 10.0), Axis::linear("y"));
        plot.line(Colour(1), vec![[5.0, 2.0]]);
        assert!(plot.svg("t").contains("<circle class=\"fill c1\" cx=\"339\""), "{}", plot.svg("t"));
    }

    #[test]
    fn a_line_reaches_from_corner_to_corner() {
        let mut plot = Plot::new(Axis::linear("x"), Axis::linear("y"));
        plot.line(Colour(2), vec![[0.0, 0.0], [5.0, 2.0]]);
        plot.name(Colour(2), "two");
        let text = plot.svg("t");
        assert!(text.contains("<polyline class=\"line c2\" points=\"72,296 606,12\"/>"), "{text}");
        assert!(text.contains(">two</text>"));
    }
}
