//! Lines and blank lines, as a reader of the language expects them.

/// Templates leave blank lines where a block was left out: at most one in a row stays, and none at the
/// end or behind an opening brace.
pub(super) fn tidy(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut blank = false;
    for line in text.lines().map(str::trim_end) {
        if line.is_empty() {
            blank = !out.is_empty();
            continue;
        }
        if std::mem::take(&mut blank) && !out.ends_with("{\n") {
            out.push('\n');
        }
        out.push_str(line);
        out.push('\n');
    }
    out
}

/// Indents lines by the braces around them, and by the bracket of an array that ends a line; a line holds whole statements, and a
/// label begins its line.
pub(super) fn indent(text: &str) -> String {
    let mut out = String::with_capacity(text.len() * 2);
    let mut depth = 0_usize;
    for line in text.lines().map(str::trim) {
        let closes = line.starts_with(['}', ']']);
        if closes {
            depth -= 1;
        }
        if !line.is_empty() && !line.ends_with(':') {
            out.push_str(&"    ".repeat(depth));
        }
        out.push_str(line);
        out.push('\n');
        let opened = line.matches('{').count() + usize::from(line.ends_with('['));
        let closed = line.matches('}').count() - usize::from(line.starts_with('}'));
        depth = depth + opened - closed;
    }
    out
}

/// The widest array or list of arguments that rustfmt leaves on one line.
const ONE_LINE: usize = 60;

/// The arguments of a call, separated by commas, as rustfmt lays them out on a line indented by `indent`, of which `counted` characters
/// count with them.
pub(super) fn arguments(flat: &str, counted: usize, indent: usize) -> String {
    if counted + flat.len() <= ONE_LINE {
        return flat.to_owned();
    }
    let space = " ".repeat(indent);
    let lines: String = flat.split(", ").map(|argument| format!("{space}    {argument},\n")).collect();
    format!("\n{lines}{space}")
}

/// A Rust array as rustfmt lays it out on lines indented by `indent`: on one line where it is short, short elements
/// filled into lines, others, and what is more than a name or a number, a line each.
pub(super) fn array(elements: &[String], indent: usize) -> String {
    const SHORT: usize = 10;
    // rustfmt fills up to a column less than its line width.
    const WIDTH: usize = 99;
    let flat = elements.join(", ");
    // A single call has its arguments on lines of their own where it is long.
    if flat.len() <= ONE_LINE || elements.len() == 1 && flat.ends_with(')') {
        return format!("[{flat}]");
    }
    let inner = indent + 4;
    let fill = elements.iter().all(|element| element.len() <= SHORT && !element.contains([' ', '(']));
    let mut out = String::from("[");
    let mut column = usize::MAX;
    // All of them on a line of their own may take that, too.
    let width = if inner + flat.len() < WIDTH + 1 { WIDTH + 1 } else { WIDTH };
    for element in elements {
        // A space before it and a comma behind it.
        if fill && column.saturating_add(element.len() + 2) <= width {
            out.push(' ');
            column += 1;
        } else {
            out.push('\n');
            out.push_str(&" ".repeat(inner));
            column = inner;
        }
        out.push_str(element);
        out.push(',');
        column += element.len() + 1;
    }
    out.push('\n');
    out.push_str(&" ".repeat(indent));
    out.push(']');
    out
}

#[cfg(test)]
mod tests {
    use super::indent;

    #[test]
    fn lines_are_indented_by_the_braces_around_them() {
        let text = "f(void)\n{\nteam_1:\n{\nif (a) {\n  b;\n} else if (c) {\nd;\n} else {\n\n/* e */\n}\n}\n}\n";
        let expected = "f(void)\n{\nteam_1:\n    {\n        if (a) {\n            b;\n        } else if (c) {\n            d;\n        } else {\n\n            /* e */\n        }\n    }\n}\n";
        assert_eq!(indent(text), expected);
        assert_eq!(indent("const a[2] = { 1, 2 };\nb;\n"), "const a[2] = { 1, 2 };\nb;\n");
        assert_eq!(indent("fn f() {\n[\na[0],\nb,\n]\n}\n"), "fn f() {\n    [\n        a[0],\n        b,\n    ]\n}\n");
    }
}
