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
    /// The numbers that matter most, each with its meaning.
    pub headlines: Vec<Headline>,
    /// Its sections; with more than two a table of contents leads to them.
    pub sections: Vec<Section>,
}

/// A number at the head of a page.
#[derive(Clone, Debug, Default)]
pub struct Headline {
    /// The subject: a run, a profile.
    pub name: String,
    /// The number, with its interval and unit.
    pub value: String,
    /// The conditions: episodes, bytes, time.
    pub note: String,
}

/// A section of a page.
#[derive(Clone, Debug, Default)]
pub struct Section {
    /// Its title.
    pub title: String,
    /// Text before its tables and pictures.
    pub text: String,
    /// Formulas.
    pub formulas: Vec<Formulas>,
    /// Tables.
    pub tables: Vec<Table>,
    /// Pictures.
    pub figures: Vec<Figure>,
}

/// Formulas under a heading: a team's bids, a leaf's outputs.
#[derive(Clone, Debug, Default)]
pub struct Formulas {
    /// Their heading.
    pub heading: String,
    /// Names and formulas.
    pub rows: Vec<(String, String)>,
}

/// A table.
#[derive(Clone, Debug, Default)]
pub struct Table {
    /// One text per column.
    pub header: Vec<String>,
    /// Rows of as many texts; the first column and columns of words are aligned left, columns of numbers right.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// Tests for a column of words behind the first one: its first text has letters.
    fn is_words(&self, column: &usize) -> bool {
        if *column == 0 {
            return false;
        }
        let texts = self.rows.iter().filter_map(|row| row.get(*column)).find(|text| !text.is_empty());
        texts.is_some_and(|text| text.contains(char::is_alphabetic))
    }
}

/// A picture with its caption.
#[derive(Clone, Debug, Default)]
pub struct Figure {
    /// An SVG element, created with [`Svg`](super::Svg) or [`Plot`](super::Plot).
    pub svg: String,
    /// Caption.
    pub caption: String,
    /// The picture takes the whole width of the page.
    pub is_broad: bool,
}

/// A section with more rows of formulas than this shows them on demand.
const OPEN: usize = 24;

impl Section {
    /// Tests for formulas that are shown on demand only.
    fn is_long(&self) -> bool {
        self.formulas.iter().map(|formulas| formulas.rows.len()).sum::<usize>() > OPEN
    }
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
    use super::{Figure, Formulas, Headline, Page, Section, Table};

    #[test]
    fn text_is_escaped_and_pictures_are_not() {
        let table = Table { header: vec!["<h>".into()], rows: vec![vec!["a&b".into()]] };
        let figure = Figure { svg: "<svg></svg>".into(), caption: "1 < 2".into(), ..Figure::default() };
        let formulas = Formulas { heading: "team 0".into(), rows: vec![("left".into(), "min(x, y) < 1".into())] };
        let section = Section {
            title: "s".into(),
            formulas: vec![formulas],
            tables: vec![table],
            figures: vec![figure],
            ..Section::default()
        };
        let headlines = vec![Headline { name: "n".into(), value: "<5>".into(), note: "of 7".into() }];
        let html = Page { title: "<t>".into(), headlines, sections: vec![section], ..Page::default() }.html();
        for part in [
            "<title>&#60;t&#62;</title>",
            "<th>&#60;h&#62;</th>",
            "<td>a&#38;b</td>",
            "<svg></svg>",
            "1 &#60; 2",
            "min(x, y) &#60; 1",
            "&#60;5&#62;",
        ] {
            assert!(html.contains(part), "{part} in\n{html}");
        }
        assert!(!html.contains("<script") && !html.contains("http"));
    }

    #[test]
    fn columns_of_words_are_aligned_as_the_first_one() {
        let row = |cells: [&str; 4]| cells.map(str::to_owned).to_vec();
        let table = Table {
            header: row(["", "", "", ""]),
            rows: vec![row(["a", "", "-1", "2 teams"]), row(["b", "rad", "", ""])],
        };
        assert_eq!([0, 1, 2, 3].map(|column| table.is_words(&column)), [false, true, false, true]);
        let section = Section { tables: vec![table], ..Section::default() };
        assert!(Page { sections: vec![section], ..Page::default() }.html().contains("<td class=\"words\">rad</td>"));
    }

    #[test]
    fn contents_lead_to_every_section_of_a_long_page() {
        let page = |count: usize| {
            let section = |place| Section { title: format!("part {place}"), ..Section::default() };
            Page { sections: (0..count).map(section).collect(), ..Page::default() }.html()
        };
        let html = page(3);
        for place in 1..=3 {
            assert!(html.contains(&format!("href=\"#section-{place}\"")));
            assert!(html.contains(&format!("id=\"section-{place}\"")));
        }
        assert!(!page(2).contains("<nav"));
    }

    #[test]
    fn many_formulas_are_shown_on_demand() {
        let rows = |count| vec![Formulas { heading: String::new(), rows: vec![Default::default(); count] }];
        let html = |count| {
            let section = Section { formulas: rows(count), ..Section::default() };
            Page { sections: vec![section], ..Page::default() }.html()
        };
        assert!(html(25).contains("<details>") && !html(24).contains("<details>"));
    }
}
