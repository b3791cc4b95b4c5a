//! Pictures for reports: SVG as text, plots, and the HTML page that contains them. No scripts, no network, no clock:
//! the same data gives the same bytes.
//!
//! [`Svg`] draws shapes, [`Plot`] draws data, [`graph`] draws graphs, [`Page`] is the HTML around them; colours and fonts are the page's.

mod axis;
pub mod graph;
mod page;
mod plot;
mod svg;

/// The colours by name, as CSS.
const COLOURS: &str = include_str!("../templates/colours.css");
/// Colours and lines of pictures, as CSS.
const STYLE: &str = include_str!("../templates/picture.css");

pub use axis::Axis;
pub use page::{Figure, Formulas, Headline, Page, Section, Table};
pub use plot::{Colour, Plot};
pub use svg::{Point, Svg};
