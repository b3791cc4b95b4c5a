//! Shapes, written as SVG. CSS classes of the page define their appearance.

use std::fmt::{self, Write as _};

/// A position in the picture: x to the right, y downwards.
pub type Point = [f64; 2];

/// A picture under construction.
#[derive(Clone, Debug)]
pub struct Svg {
    size: [f64; 2],
    body: String,
}

impl Svg {
    /// Creates an empty picture.
    pub fn new(width: f64, height: f64) -> Self {
        Self { size: [width, height], body: String::new() }
    }

    /// Adds a straight line.
    pub fn line(&mut self, class: &str, from: Point, to: Point) {
        let ([x1, y1], [x2, y2]) = (from.map(SvgNumber), to.map(SvgNumber));
        self.put(format_args!("<line class=\"{class}\" x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\"/>"));
    }

    /// Adds straight lines from point to point.
    pub fn polyline(&mut self, class: &str, points: &[Point]) {
        self.put(format_args!("<polyline class=\"{class}\" points=\"{}\"/>", Points(points)));
    }

    /// Adds an area.
    pub(crate) fn polygon(&mut self, class: &str, points: &[Point]) {
        self.put(format_args!("<polygon class=\"{class}\" points=\"{}\"/>", Points(points)));
    }

    /// Adds a curve that starts and ends vertically.
    pub fn curve(&mut self, class: &str, [x, y]: Point, [to_x, to_y]: Point) {
        let middle = SvgNumber((y + to_y) / 2.0);
        let [x, y, to_x, to_y] = [x, y, to_x, to_y].map(SvgNumber);
        let path = format_args!("M{x} {y}C{x} {middle} {to_x} {middle} {to_x} {to_y}");
        self.put(format_args!("<path class=\"{class}\" d=\"{path}\"/>"));
    }

    /// Adds a rectangle, given by its upper left corner, width and height; `hint` is its tooltip.
    pub fn rect(&mut self, class: &str, corner: Point, size: [f64; 2], hint: &str) {
        let ([x, y], [width, height]) = (corner.map(SvgNumber), size.map(SvgNumber));
        let shape = format_args!("class=\"{class}\" x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"");
        self.put(format_args!("<rect {shape}>{}</rect>", Hint(hint)));
    }

    /// Adds a circle; `hint` is its tooltip.
    pub fn circle(&mut self, class: &str, centre: Point, radius: f64, hint: &str) {
        let ([x, y], radius) = (centre.map(SvgNumber), SvgNumber(radius));
        self.put(format_args!(
            "<circle class=\"{class}\" cx=\"{x}\" cy=\"{y}\" r=\"{radius}\">{}</circle>",
            Hint(hint)
        ));
    }

    /// Adds a short text. The classes `middle` and `end` select which part of it is placed at `at`.
    pub fn text(&mut self, class: &str, at: Point, text: &str) {
        let [x, y] = at.map(SvgNumber);
        self.put(format_args!("<text class=\"{class}\" x=\"{x}\" y=\"{y}\">{}</text>", Escaped(text)));
    }

    /// Adds a short text that reads upwards.
    pub(crate) fn upright_text(&mut self, class: &str, at: Point, text: &str) {
        let [x, y] = at.map(SvgNumber);
        let turn = format_args!("transform=\"translate({x} {y}) rotate(-90)\"");
        self.put(format_args!("<text class=\"{class}\" {turn}>{}</text>", Escaped(text)));
    }

    /// Returns the picture as an element of a page; `title` describes it to screen readers.
    pub fn finish(self, title: &str) -> String {
        let [width, height] = self.size.map(SvgNumber);
        let title = Escaped(title);
        format!(
            "<svg viewBox=\"0 0 {width} {height}\" width=\"{width}\" role=\"img\" aria-label=\"{title}\">\n{}</svg>",
            self.body
        )
    }

    fn put(&mut self, element: fmt::Arguments<'_>) {
        let _ = writeln!(self.body, "{element}");
    }
}

/// A coordinate with one decimal, which is enough even in print.
struct SvgNumber(f64);

impl fmt::Display for SvgNumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let tenths = (self.0 * 10.0).round();
        // −0 would make equal pictures differ, and NaN or infinities would make invalid text.
        let tenths = if tenths.is_finite() && tenths != 0.0 { tenths } else { 0.0 };
        write!(f, "{}", tenths / 10.0)
    }
}

struct Points<'a>(&'a [Point]);

impl fmt::Display for Points<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, [x, y]) in self.0.iter().map(|point| point.map(SvgNumber)).enumerate() {
            write!(f, "{}{x},{y}", if place > 0 { " " } else { "" })?;
        }
        Ok(())
    }
}

struct Hint<'a>(&'a str);

impl fmt::Display for Hint<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_empty() { Ok(()) } else { write!(f, "<title>{}</title>", Escaped(self.0)) }
    }
}

struct Escaped<'a>(&'a str);

impl fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.chars().try_for_each(|character| match character {
            '&' => f.write_str("&amp;"),
            '<' => f.write_str("&lt;"),
            '>' => f.write_str("&gt;"),
            '"' => f.write_str("&quot;"),
            _ => f.write_char(character),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Svg;

    #[test]
    fn shapes_are_written_with_short_numbers_and_harmless_text() {
        let mut svg = Svg::new(20.0, 10.0);
        svg.polyline("c0", &[[0.0, 1.26], [-0.01, f64::NAN]]);
        svg.text("end", [3.0, 4.5], "a < \"b\"");
        let text = svg.finish("x & y");
        assert_eq!(
            text,
            "<svg viewBox=\"0 0 20 10\" width=\"20\" role=\"img\" aria-label=\"x &amp; y\">\n\
             <polyline class=\"c0\" points=\"0,1.3 0,0\"/>\n\
             <text class=\"end\" x=\"3\" y=\"4.5\">a &lt; &quot;b&quot;</text>\n</svg>"
        );
    }
}
