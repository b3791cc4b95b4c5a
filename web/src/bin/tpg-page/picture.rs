//! The README's picture: CartPole's policy as a formula, as C, and the pole that it drives.

use crate::policies::{POLICIES, Policy};
use std::fmt::Write as _;
use std::io;
use tpg_codegen::report::{BidFormula, PolicyFormulas};
use tpg_web::control;

const WIDTH: usize = 1000;
const HEIGHT: usize = 312;
/// Height of a line of text.
const LINE: usize = 18;
/// The panels: left edge and width.
const FORMULA: (usize, usize) = (8, 236);
const CODE: (usize, usize) = (284, 366);
const POLE: (usize, usize) = (690, 302);
/// Top and height of the panels.
const TOP: (usize, usize) = (40, 232);

const STYLE: &str = "svg { font: 14px system-ui, 'DejaVu Sans', sans-serif; --text: #1d2329; --soft: #5b6670; --card: #f4f6f8; --edge: #d5dbe0; \
     --lit: #00805c; --warm: #b84a00; } \
     @media (prefers-color-scheme: dark) { svg { --text: #e6e9ec; --soft: #9aa5af; --card: #1b2126; --edge: #343c43; --lit: #35c79b; \
     --warm: #f08a4b; } } \
     text { fill: var(--text); white-space: pre; } .soft { fill: var(--soft); } .head { font-weight: 600; font-size: 15px; } \
     .code { font: 11px ui-monospace, 'DejaVu Sans Mono', monospace; } .big { font: 17px ui-monospace, 'DejaVu Sans Mono', monospace; } \
     .lit { fill: var(--lit); } .warm { fill: var(--warm); } .card { fill: var(--card); stroke: var(--edge); } \
     .pole { stroke: var(--lit); stroke-width: 6; stroke-linecap: round; } .cart { fill: var(--soft); } \
     .rail, .arrow { stroke: var(--soft); stroke-width: 2; fill: none; }";

type DrawnPage = Result<(), Box<dyn std::error::Error + Send + Sync>>;

/// The text of the file.
pub(crate) fn text() -> io::Result<String> {
    let policy = &POLICIES[0];
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" height=\"{HEIGHT}\" role=\"img\">\n\
         <title>A policy for CartPole as a formula, as C, and the pole that it drives</title>\n<style>{STYLE}</style>\n"
    );
    let drawn = formula(&mut svg, policy).and_then(|()| code(&mut svg, policy)).and_then(|()| pole(&mut svg));
    drawn.map_err(io::Error::other)?;
    for (left, width) in [FORMULA, CODE] {
        let (x, y) = (left + width + 6, TOP.0 + TOP.1 / 2);
        let arrow = writeln!(svg, "<path class=\"arrow\" d=\"M{x} {y}h27m-8 -6l8 6l-8 6\"/>");
        arrow.map_err(io::Error::other)?;
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}

/// A panel with its heading.
fn panel(svg: &mut String, (left, width): (usize, usize), heading: &str) -> DrawnPage {
    let (top, height) = TOP;
    writeln!(svg, "<text class=\"head\" x=\"{left}\" y=\"{}\">{heading}</text>", top - 12)?;
    writeln!(svg, "<rect class=\"card\" x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" rx=\"10\"/>")?;
    Ok(())
}

fn formula(svg: &mut String, policy: &Policy) -> DrawnPage {
    panel(svg, FORMULA, "A policy is a few formulas")?;
    let formulas = PolicyFormulas::of(&policy.graph()?, &policy.options()?);
    let [team] = &formulas.teams[..] else { return Err("CartPole's policy has not one team any more".into()) };
    let left = FORMULA.0 + 18;
    let mut y = TOP.0 + 34;
    for (BidFormula { to, formula, .. }, class) in team.bids.iter().zip(["warm", "lit"]) {
        writeln!(svg, "<text class=\"head {class}\" x=\"{left}\" y=\"{y}\">{to} bids</text>")?;
        writeln!(svg, "<text class=\"big\" x=\"{left}\" y=\"{}\">{}</text>", y + 26, readable(formula))?;
        y += 64;
    }
    for line in ["The higher bid acts.", "θ, ω: angle of the pole and its velocity; v: velocity of the cart"] {
        for part in wrapped(line, 31) {
            writeln!(svg, "<text class=\"soft\" x=\"{left}\" y=\"{y}\">{part}</text>")?;
            y += LINE + 2;
        }
    }
    Ok(())
}

fn code(svg: &mut String, policy: &Policy) -> DrawnPage {
    panel(svg, CODE, "compiled to C, proven equal")?;
    let text = policy.code()?;
    let body =
        text.split("_infer(const cartpole_state_t *state)\n{\n").nth(1).and_then(|rest| rest.split("\n}").next());
    let body = body.ok_or("CartPole's C has another shape now")?;
    // A line of C may be wider than the panel.
    let body = body.replace(" && ", "\n        && ").replace(" ? ", "\n        ? ").replace(" : ", "\n        : ");
    let lines = body.lines().map(|line| line.strip_prefix("    ").unwrap_or(line)).filter(|line| !line.is_empty());
    for (line, place) in lines.zip(0..) {
        let y = TOP.0 + 28 + LINE * place;
        writeln!(svg, "<text class=\"code\" x=\"{}\" y=\"{y}\">{}</text>", CODE.0 + 14, escaped(line))?;
    }
    let size = policy.provenance("| C, profile `fast` |")?;
    writeln!(svg, "<text class=\"soft\" x=\"{}\" y=\"{}\">{size}</text>", CODE.0 - 20, TOP.0 + TOP.1 + 26)?;
    Ok(())
}

fn pole(svg: &mut String) -> DrawnPage {
    panel(svg, POLE, "and drives the pole")?;
    let [mut rig, ..] = control::rigs();
    rig.restart(1);
    // A push, and the first seconds after it.
    rig.push(3, 1.1);
    let (middle, rail, metre) = (POLE.0 as f64 + 0.2 * POLE.1 as f64, (TOP.0 + TOP.1 - 46) as f64, 165.0);
    writeln!(svg, "<path class=\"rail\" d=\"M{} {rail}h{}\"/>", POLE.0 + 14, POLE.1 - 28)?;
    const SHOWN: u32 = 12;
    const APART: u32 = 5;
    for place in 0..SHOWN {
        let [x, _, theta, _] = rig.view().state;
        let (cart, long) = (middle + metre * x, 126.0);
        let opacity = if place + 1 == SHOWN { 1.0 } else { 0.14 + 0.05 * f64::from(place) };
        let (hinge, dx, dy) = (rail - 22.0, long * theta.sin(), -long * theta.cos());
        writeln!(
            svg,
            "<g opacity=\"{opacity:.2}\"><path class=\"pole\" d=\"M{cart:.1} {hinge:.1}l{dx:.1} {dy:.1}\"/>"
        )?;
        writeln!(
            svg,
            "<rect class=\"cart\" x=\"{:.1}\" y=\"{:.1}\" width=\"44\" height=\"16\" rx=\"4\"/></g>",
            cart - 22.0,
            rail - 20.0
        )?;
        (0..APART).for_each(|_| rig.act());
    }
    if rig.view().ended != 0 {
        return Err("the pole fell".into());
    }
    let seconds = f64::from((SHOWN - 1) * APART) * 0.02;
    let left = POLE.0 + 16;
    writeln!(
        svg,
        "<text class=\"soft\" x=\"{left}\" y=\"{}\">{seconds:.1} seconds after a push</text>",
        TOP.0 + TOP.1 - 14
    )?;
    Ok(())
}

/// Writes a formula as people do.
fn readable(formula: &str) -> String {
    formula
        .replace("theta", "θ")
        .replace("omega", "ω")
        .replace("(-", "(−")
        .replace("3.2907495", "3.29")
        .replace("(−3.29)", "−3.29")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// Breaks a text into lines of so many letters.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    text.split(' ').fold(Vec::new(), |mut lines: Vec<String>, word| {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
        lines
    })
}
