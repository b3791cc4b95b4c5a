//! A tangled program graph, drawn: teams in layers below the root, actions at the bottom.

use super::{Figure, Point, Svg};
use DrawnNode::*;
use std::collections::BTreeMap;
use tpg_graph::error::counted;
use tpg_graph::{ActionId, Destination, Graph};

/// The width of a column of a page, in which labels are shown in their own size.
const COLUMN: f64 = 480.0;
/// The largest width, of a graph that takes the whole width of a page.
const BROAD: f64 = 960.0;
/// The minimum width of an action's box, and the gap beside it.
const ACTION: f64 = 96.0;
const GAP: f64 = 8.0;
const LAYER: f64 = 84.0;
const TOP: f64 = 24.0;
/// Number of passes that sort nodes by the positions of their neighbours above; more passes change little.
const SWEEPS: usize = 4;

/// A team or an action, by its index in the graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum DrawnNode {
    Team(usize),
    Action(usize),
}

/// Draws a graph for a page.
pub fn figure(graph: &Graph) -> Figure {
    let layers = layers(graph);
    let room = box_width(graph, &layers);
    let width = width(&layers, room);
    let places = places(&layers, room);
    let bottom = places.values().map(|at| at[1]).fold(0.0, f64::max);
    let mut svg = Svg::new(width, bottom + TOP);
    for (from, to, count) in edges(graph) {
        let class = match to {
            Action(action) => format!("thin c{}", action % 7),
            Team(_) => "thin c7".to_owned(),
        };
        // Two edges between the same nodes would hide each other, so a bundle is drawn once, and thicker.
        let class = if count > 1 { class.replace("thin", "line") } else { class };
        svg.curve(&class, places[&from], places[&to]);
    }
    for (&node, &at) in &places {
        match node {
            Team(team) => {
                let of_team = &graph.teams()[team];
                let hint = format!("team {}: {}", of_team.label, counted(of_team.edges.len(), "edge"));
                let root = team == graph.root().index();
                svg.circle(if root { "fill c0" } else { "body" }, at, 12.0, &hint);
                let class = if root { "middle on" } else { "middle" };
                svg.text(class, [at[0], at[1] + 4.0], &of_team.edges.len().to_string());
            }
            Action(action) => {
                let name = name(graph, action);
                svg.rect("body", [at[0] - room / 2.0, at[1] - 11.0], [room, 22.0], &name);
                svg.text("middle", [at[0], at[1] + 4.0], &shortened(&name, room));
            }
        }
    }
    let edges: usize = graph.teams().iter().map(|team| team.edges.len()).sum();
    let caption = format!(
        "The graph: {}, {}, {}, {}. A circle is a team with its number of edges, the root \
         is filled; several edges between the same two are one thick line.",
        counted(graph.teams().len(), "team"),
        counted(edges, "edge"),
        counted(graph.programs().len(), "program"),
        counted(graph.ends(), if graph.outputs().is_empty() { "action" } else { "leaf" }),
    );
    Figure { svg: svg.finish("the graph"), caption, is_broad: width > COLUMN }
}

/// Draws a graph as an SVG element that needs no page, for a notebook or a paper: in light colours and without variables, which
/// few programs but browsers know.
pub fn standalone(graph: &Graph) -> String {
    let light =
        super::COLOURS.lines().next().unwrap_or_default().split([';', '{']).filter_map(|pair| pair.split_once(": "));
    let style = light
        .fold(super::STYLE.to_owned(), |style, (name, colour)| style.replace(&format!("var({})", name.trim()), colour));
    let (space, paper) = ("xmlns=\"http://www.w3.org/2000/svg\"", "style=\"background: #fff\"");
    let head = format!(" {space} {paper}><style>{style}</style>");
    figure(graph).svg.replacen('>', &head, 1)
}

/// Merges edges with equal ends and counts them.
fn edges(graph: &Graph) -> Vec<(DrawnNode, DrawnNode, usize)> {
    let mut counts: BTreeMap<(DrawnNode, DrawnNode), usize> = BTreeMap::new();
    for (from, team) in graph.teams().iter().enumerate() {
        for edge in &team.edges {
            let to = match edge.to {
                Destination::Team(team) => Team(team.index()),
                Destination::Action(action) => Action(usize::from(action.0)),
            };
            *counts.entry((Team(from), to)).or_default() += 1;
        }
    }
    counts.into_iter().map(|((from, to), count)| (from, to, count)).collect()
}

/// Returns teams by their longest path from the root, then the actions; each layer is sorted to reduce crossings.
fn layers(graph: &Graph) -> Vec<Vec<DrawnNode>> {
    let edges = edges(graph);
    let mut depth = vec![0usize; graph.teams().len()];
    // Graphs are acyclic, so this ends after at most as many rounds as there are layers.
    let mut changed = true;
    while changed {
        changed = false;
        for &(from, to, _) in &edges {
            if let (Team(from), Team(to)) = (from, to)
                && depth[to] <= depth[from]
            {
                depth[to] = depth[from] + 1;
                changed = true;
            }
        }
    }
    let deepest = depth.iter().copied().max().unwrap_or(0);
    let of_depth = |layer| (0..depth.len()).filter(|&team| depth[team] == layer).map(Team).collect();
    let mut layers: Vec<Vec<DrawnNode>> = (0..=deepest).map(of_depth).collect();
    let used = |action: &DrawnNode| edges.iter().any(|(_, to, _)| to == action);
    layers.push((0..graph.ends()).map(Action).filter(used).collect());
    for _ in 0..SWEEPS {
        for layer in 1..layers.len() - 1 {
            let places = places(&layers, ACTION);
            let middle = |node: &DrawnNode| {
                let above = edges.iter().filter(|(_, to, _)| to == node).map(|(from, ..)| places[from][0]);
                let (sum, count) = above.fold((0.0, 0.0), |(sum, count), x| (sum + x, count + 1.0));
                if count > 0.0 { sum / count } else { width(&layers, ACTION) / 2.0 }
            };
            let mut sorted: Vec<(f64, DrawnNode)> = layers[layer].iter().map(|node| (middle(node), *node)).collect();
            sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            layers[layer] = sorted.into_iter().map(|(_, node)| node).collect();
        }
    }
    layers
}

fn name(graph: &Graph, action: usize) -> String {
    match graph.actions().get(action) {
        Some(action) => action.to_string(),
        None => graph.end_name(ActionId(action as u16)),
    }
}

/// Estimates the width of a letter of a label.
fn letter_width(letter: char) -> f64 {
    match letter {
        '\u{2e80}'.. => 13.0,
        'm' | 'w' => 10.5,
        _ if letter.is_uppercase() => 9.5,
        _ => 7.0,
    }
}

/// Returns the width of the actions' boxes: that of the longest name, as far as two rows of boxes have room on a page.
fn box_width(graph: &Graph, layers: &[Vec<DrawnNode>]) -> f64 {
    let count = layers.last().map_or(1, Vec::len).max(1);
    let longest = (0..graph.ends()).map(|action| name(graph, action).chars().map(letter_width).sum::<f64>() + GAP);
    longest.fold(ACTION, f64::max).min((2.0 * BROAD / count as f64 - GAP).max(ACTION))
}

/// Shortens a name that is wider than its box.
fn shortened(name: &str, room: f64) -> String {
    let mut left = room - GAP;
    let fits = |letter: &char| {
        left -= letter_width(*letter);
        left >= 0.0
    };
    let kept: String = name.chars().take_while(fits).collect();
    if kept == name { kept } else { kept + "…" }
}

/// Returns the width of a picture in which the actions have room, as far as a page has it.
fn width(layers: &[Vec<DrawnNode>], room: f64) -> f64 {
    let widest = layers.iter().map(Vec::len).max().unwrap_or(0);
    ((room + GAP) * widest as f64).clamp(COLUMN, BROAD)
}

fn places(layers: &[Vec<DrawnNode>], room: f64) -> BTreeMap<DrawnNode, Point> {
    let width = width(layers, room);
    let layer = |(row, nodes): (usize, &Vec<DrawnNode>)| {
        let step = width / nodes.len().max(1) as f64;
        // Neighbours alternate between two heights to make room.
        let dodge = |k: usize| if step < room + GAP && k % 2 == 1 { LAYER / 3.0 } else { 0.0 };
        let place = move |(k, node): (usize, &DrawnNode)| {
            (*node, [(k as f64 + 0.5) * step, TOP + row as f64 * LAYER + dodge(k)])
        };
        nodes.iter().enumerate().map(place).collect::<Vec<_>>()
    };
    layers.iter().enumerate().flat_map(layer).collect()
}

#[cfg(test)]
mod tests {
    use super::{ACTION, figure, shortened, standalone};
    use tpg_graph::sample::{self, Shape};

    #[test]
    fn a_small_graph_fits_a_column_in_its_own_size_and_a_wide_one_takes_the_page() {
        let widths = [(2, 3), (20, 9)].map(|(teams, actions)| {
            let drawn = figure(&sample::graph(&Shape { teams, actions, ..Shape::random(1) }, 1));
            let width = drawn.svg.split("width=\"").nth(1).and_then(|rest| rest.split('"').next()?.parse::<f64>().ok());
            (drawn.is_broad, width.expect("a width"))
        });
        assert_eq!(widths[0], (false, 480.0));
        assert!(widths[1].0 && widths[1].1 > 480.0, "{widths:?}");
    }

    #[test]
    fn a_name_that_is_too_long_for_its_box_is_shortened() {
        for (name, expected) in [
            ("gripper_open", "gripper_open"),
            ("field_wrist_down", "field_wrist_…"),
            ("开阀门全开阀门", "开阀门全开阀…"),
        ] {
            assert_eq!(shortened(name, ACTION), expected);
        }
    }

    #[test]
    fn a_standalone_picture_brings_its_colours() {
        for shape in [Shape::random(1), Shape::random_with_outputs(1)] {
            let svg = standalone(&sample::graph(&shape, 1));
            assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"), "{svg}");
            assert!(svg.contains("<style>") && svg.contains(".c0 {"), "{svg}");
            assert!(svg.contains(".body { fill: #f3f5f7; stroke: #5b6670; }") && !svg.contains("var("), "{svg}");
        }
    }
}
