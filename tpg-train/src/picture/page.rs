//! The page: one self-contained HTML file.

use askama::Template;

/// A page.
#[derive(Clone, Debug, Default, Template)]
#[template(path = "page.html")]
pub struct Page {
    /// Its title.
    pub title: String,
    /// One or two sentences below the title.
    pub lead: String,
    /// Its sections.
    pub sections: Vec<Section>,
}

/// A section of a page.
#[derive(Clone, Debug, Default)]
pub struct Section {
    /// Its title.
    pub title: String,
    /// Text before its tables and pictures.
    pub text: String,
    /// Tables.
    pub tables: Vec<Table>,
    /// Pictures.
    pub figures: Vec<Figure>,
}

/// A table.
#[derive(Clone, Debug, Default)]
pub struct Table {
    /// One text per column.
    pub header: Vec<String>,
    /// Rows of as many texts; the first column is aligned left, the others right.
    pub rows: Vec<Vec<String>>,
}

/// A picture with its caption.
#[derive(Clone, Debug, Default)]
pub struct Figure {
    /// An SVG element, created with [`Svg`](super::Svg) or [`Plot`](super::Plot).
    pub svg: String,
    /// Caption.
    pub caption: String,
}

impl Page {
    /// Renders the page.
    ///
    /// # Panics
    /// Never: a template fails only if a value cannot be formatted.
    pub fn html(&self) -> String {
        self.render().expect("texts can be shown")
    }
}

#[cfg(test)]
mod tests {
    use super::{Figure, Page, Section, Table};

    #[test]
    fn text_is_escaped_and_pictures_are_not() {
        let table = Table { header: vec!["<h>".into()], rows: vec![vec!["a&b".into()]] };
        let figure = Figure { svg: "<svg></svg>".into(), caption: "1 < 2".into() };
        let section = Section { title: "s".into(), tables: vec![table], figures: vec![figure], ..Section::default() };
        let html = Page { title: "<t>".into(), sections: vec![section], ..Page::default() }.html();
        for part in
            ["<title>&#60;t&#62;</title>", "<th>&#60;h&#62;</th>", "<td>a&#38;b</td>", "<svg></svg>", "1 &#60; 2"]
        {
            assert!(html.contains(part), "{part} in\n{html}");
        }
        assert!(!html.contains("<script") && !html.contains("http"));
    }
}
