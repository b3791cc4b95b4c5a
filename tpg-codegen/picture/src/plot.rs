//! Plots: lines, bands and points between two axes.

use super::axis::{Axis, Fitted};
use super::svg::{Point, Svg};

const SIZE: [f64; 2] = [620.0, 340.0];
/// Left, top, right and bottom margins for numbers and labels.
const MARGIN: [f64; 4] = [72.0, 12.0, 14.0, 44.0];
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

#[derive(Clone, Debug)]
enum Mark {
    Line(Vec<Point>),
    /// A band: x, lower and upper y.
    Band(Vec<[f64; 3]>),
    Points(Vec<(Point, String)>),
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

    /// Returns the plot as an element of a page.
    pub fn svg(&self, title: &str) -> String {
        let [width, height] = SIZE;
        let rows = self.legend.len().div_ceil(2) as f64;
        let mut svg = Svg::new(width, height + rows * LEGEND_ROW);
        let (xs, ys): (Vec<f64>, Vec<f64>) = self.extent().into_iter().map(|[x, y]| (x, y)).unzip();
        let mut frame = PlotFrame { x: self.x.fit(xs.into_iter()), y: self.y.fit(ys.into_iter()) };
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

    /// Returns points that span all marks.
    fn extent(&self) -> Vec<Point> {
        self.marks
            .iter()
            .flat_map(|(_, mark)| match mark {
                Mark::Line(points) => points.clone(),
                Mark::Band(band) => band.iter().flat_map(|&[x, low, high]| [[x, low], [x, high]]).collect(),
                Mark::Points(points) => points.iter().map(|(point, _)| *point).collect(),
            })
            .collect()
    }

    fn axes(&self, svg: &mut Svg, frame: &PlotFrame<'_>) {
        let [left, top, right, bottom] = MARGIN;
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
}

impl PlotFrame<'_> {
    fn at(&self, [x, y]: Point) -> Point {
        let [left, top, right, bottom] = MARGIN;
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
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, Colour, Plot};

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
