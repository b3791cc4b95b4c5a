//! Lines and blank lines, as a reader of the language expects them.

/// Templates leave blank lines where a block was left out: at most one in a row stays, and none at the
/// end, behind an opening brace or before a closing one.
pub(crate) fn tidy(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut blank = false;
    for line in text.lines().map(str::trim_end) {
        if line.is_empty() {
            blank = !out.is_empty();
            continue;
        }
        if std::mem::take(&mut blank) && !out.ends_with("{\n") && !line.trim_start().starts_with('}') {
            out.push('\n');
        }
        out.push_str(line);
        out.push('\n');
    }
    out
}

/// The width of a line.
const WIDTH: usize = 100;

/// Breaks assignments that are wider than a line: behind the sign, or else before operators that bind least: all of them, or as rustfmt
/// does only the last ones that are the same, where what is before them fits into the line.
pub(super) fn wrap(text: &str, as_rustfmt: bool) -> String {
    let broken = |line: &str| if line.len() > WIDTH { broken(line, as_rustfmt) } else { line.to_owned() };
    text.lines().map(|line| broken(line) + "\n").collect()
}

fn broken(line: &str, as_rustfmt: bool) -> String {
    let Some((to, expression)) = line.split_once(" = ").filter(|(_, value)| value.ends_with(';')) else {
        return line.to_owned();
    };
    let space = " ".repeat(line.len() - line.trim_start().len() + 4);
    if space.len() + expression.len() <= WIDTH {
        return format!("{to} =\n{space}{expression}");
    }
    let terms = ["+-", "*/"].map(|operators| split(expression, operators)).into_iter().find(|terms| terms.len() > 1);
    let terms = terms.unwrap_or_else(|| vec![expression]);
    let mut first = 1;
    let width = |count: usize| to.len() + " = ".len() + terms[..count].join(" ").len();
    if as_rustfmt {
        // The longest beginning that ends where the operator changes and fits.
        let changes = (1..terms.len()).filter(|&place| place == 1 || terms[place][..1] != terms[place - 1][..1]);
        first = changes.rev().find(|&count| width(count) <= WIDTH).unwrap_or(1);
    }
    let lines: Vec<String> =
        [terms[..first].join(" ")].into_iter().chain(terms[first..].iter().map(|&term| term.to_owned())).collect();
    format!("{to} = {}", lines.join(&format!("\n{space}")))
}

/// The parts of an expression between the operators outside of parentheses, each with the operator before it.
fn split<'a>(expression: &'a str, operators: &str) -> Vec<&'a str> {
    let mut depth = 0_usize;
    let (mut parts, mut start) = (Vec::new(), 0);
    for (place, c) in expression.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ if depth == 0
                && operators.contains(c)
                && expression[..place].ends_with(' ')
                && expression[place + 1..].starts_with(' ') =>
            {
                parts.push(expression[start..place].trim_end());
                start = place;
            }
            _ => {}
        }
    }
    parts.push(&expression[start..]);
    parts
}

/// Indents lines by the braces around them, and by the bracket of an array that ends a line; a line holds whole statements, and a
/// label begins its line.
pub(crate) fn indent(text: &str) -> String {
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
        if line.starts_with("* ") {
            out.push(' '); // the stars of a comment stand below each other
        }
        out.push_str(line);
        out.push('\n');
        let opened = line.matches('{').count() + usize::from(line.ends_with('['));
        let closed = line.matches('}').count() - usize::from(line.starts_with('}'));
        depth = depth + opened - closed;
    }
    out
}

/// A choice of two values in Rust, on one line where it is short.
pub(super) fn either(condition: &str, first: &str, second: &str) -> String {
    const SHORT: usize = 50;
    let flat = format!("if {condition} {{ {first} }} else {{ {second} }}");
    if flat.len() <= SHORT { flat } else { format!("if {condition} {{\n{first}\n}} else {{\n{second}\n}}") }
}

/// The widest array or list of arguments that rustfmt leaves on one line.
const ONE_LINE: usize = 60;

/// The arguments of a call, separated by commas, as rustfmt lays them out on a line indented by `indent`, of which `counted` characters
/// count with them.
pub(crate) fn arguments(flat: &str, counted: usize, indent: usize) -> String {
    if counted + flat.len() <= ONE_LINE {
        return flat.to_owned();
    }
    let space = " ".repeat(indent);
    let lines: String = flat.split(", ").map(|argument| format!("{space}    {argument},\n")).collect();
    format!("\n{lines}{space}")
}

/// A Rust array as rustfmt lays it out on lines indented by `indent`: on one line where it is short, short elements
/// filled into lines, others, and what is more than a name or a number, a line each.
pub(crate) fn array(elements: &[String], indent: usize) -> String {
    const SHORT: usize = 10;
    let flat = elements.join(", ");
    // A single call has its arguments on lines of their own where it is long.
    if flat.len() <= ONE_LINE || elements.len() == 1 && flat.ends_with(')') {
        return format!("[{flat}]");
    }
    let inner = indent + 4;
    let fill = elements.iter().all(|element| element.len() <= SHORT && !element.contains([' ', '(']));
    let mut out = String::from("[");
    let mut column = usize::MAX;
    // rustfmt fills up to a column less than a line, but all of them on a line of their own may take that, too.
    let width = if inner + flat.len() < WIDTH { WIDTH } else { WIDTH - 1 };
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
    fn long_sums_take_lines_of_their_own() {
        let term = format!("{}(a + b)", "x".repeat(40));
        let wrap = |text: &str| super::wrap(text, true);
        assert_eq!(wrap("    a = b + c;\n"), "    a = b + c;\n");
        let [once, thrice] = [1, 3].map(|count| vec![&*term; count]);
        let flat = format!("    const float long_name_of_a_value_0123456789012345678901 = {} - c;\n", once.join(" + "));
        assert_eq!(wrap(&flat), flat.replace(" = ", " =\n        "));
        let sum = format!("    a = {};\n", thrice.join(" + "));
        assert_eq!(wrap(&sum), sum.replace(" + x", "\n        + x"));
        let product = format!("    a = {};\n", thrice.join(" * "));
        assert_eq!(wrap(&product), product.replace(" * x", "\n        * x"));
        // rustfmt breaks before the last operators that are the same.
        let mixed = format!("    a = b - c + {term} - {term};\n");
        assert_eq!(wrap(&mixed), mixed.replace(" - x", "\n        - x"));
    }

    #[test]
    fn lines_are_indented_by_the_braces_around_them() {
        let text = "f(void)\n{\nteam_1:\n{\nif (a) {\n  b;\n} else if (c) {\nd;\n} else {\n\n/* e */\n}\n}\n}\n";
        let expected = "f(void)\n{\nteam_1:\n    {\n        if (a) {\n            b;\n        } else if (c) {\n            d;\n        } else {\n\n            /* e */\n        }\n    }\n}\n";
        assert_eq!(indent(text), expected);
        assert_eq!(indent("const a[2] = { 1, 2 };\nb;\n"), "const a[2] = { 1, 2 };\nb;\n");
        assert_eq!(indent("fn f() {\n[\na[0],\nb,\n]\n}\n"), "fn f() {\n    [\n        a[0],\n        b,\n    ]\n}\n");
    }
}
