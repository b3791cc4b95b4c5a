//! Renders `docs/results.md`.

use super::compiled::Costs;
use super::cortex_m4::{Count, Counts};
use super::learned::LearnedRow;
use super::paper::{self, Measured};
use super::rows::{Row, STRAIGHT};
use super::timing::Time;
use tpg_problems::arm::targets::Start;
use tpg_train::hybrid::choice::Spread;

/// All results of one problem.
#[derive(Debug)]
pub struct Problem {
    /// Start of the episodes.
    pub start: Start,
    /// Number of test episodes.
    pub episodes: usize,
    /// The table.
    pub rows: Vec<Row>,
    /// Times of compiled code.
    pub costs: Costs,
    /// Results of the ideas, on validation episodes.
    pub ideas: Vec<Row>,
    /// Policies of other learning problems.
    pub learned: Vec<LearnedRow>,
    /// The paper's policies, if available.
    pub paper: Option<Vec<Measured>>,
}

impl Problem {
    fn name(&self) -> &'static str {
        match self.start {
            Start::Fs => "fixed start",
            Start::Rs => "random start",
        }
    }
}

const LEAD: &str = "# Results

Made by `cargo run --release -p tpg-train -- table2` from the policies that `docs/results.toml` names; do not edit. Only the
times change from run to run.

**What is asked.** The paper's WidowX arm: bring the hand within 3 mm of a target, in at most 1,707 actions from the home
pose (fixed start) or 3,414 from anywhere (random start). Targets are uniform in the reachable space. An invalid action, one
that leaves a joint's range or collides, ends an episode as a failure and is what *collision* counts, as in the paper. The
1,000 test episodes of each problem are committed (`generated/test-targets`); no training and no choice read them.

**What the policies know.** The graphs read errors in the arm's own geometry and the network 38 features, computed from
the paper's 13 values by someone who knows the arm; the network's reward knew, in training only, poses that solve the task.
This is not the paper's learning problem. The network holds a joint that would leave its range (its mask), and the guard of a
hybrid hands over instead of executing such an action of the graph: both are part of the policy.
";

const COLUMNS: &str = "**Columns.** *By graph*: part of all actions. *ns an action*: from motor positions to a move, on this \
machine, kinematics included, the simulated arm excluded; code as it is compiled for users (the generated Rust, profile `fast`; the \
network in integers; no option for this machine's own instructions), of each episode the quickest of seven rounds; *worst* is the slowest single action. *Bytes*: the graph's C for a Cortex-M4F \
(`-Os`, code and constants, in the profiles `fast` and `small`) and the network's constants; the runtime that both share is not counted. *All seeds* and *all pairs*: mean ± standard deviation over \
trainings that differ in their seed alone, with the shipped settings: what to expect, where the shipped ones were chosen \
(on validation episodes).
";

/// Renders the file.
pub fn page(problems: &[Problem], counts: &Counts) -> String {
    let mut text = LEAD.to_owned();
    text += "\n## Table 2\n\n";
    text += COLUMNS;
    for problem in problems {
        text += &format!("\n### {}, {} test episodes\n\n", capital(problem.name()), problem.episodes);
        text += &table(&problem.rows);
    }
    text += "\n## What it costs\n\n";
    for problem in problems {
        text += &costs(problem);
    }
    text += &on_target(problems, counts);
    text += PLANNER;
    text += "\n## What each idea is worth\n\n";
    text += "The shipped graph and actor on 1,000 validation episodes that neither training nor any choice read.\n";
    for problem in problems {
        text += &format!("\n{}:\n\n", capital(problem.name()));
        text += &ideas(&problem.ideas);
    }
    text += FAILED;
    text += "\n## What was taught\n\n";
    text += TAUGHT;
    for problem in problems {
        text += &format!("\n{}:\n\n", capital(problem.name()));
        text += &learned(&problem.learned);
    }
    text += "\n## The paper\n\n";
    text += PAPER;
    for problem in problems {
        text += &format!("\n{}:\n\n", capital(problem.name()));
        text += &printed(problem);
        if let Some(measured) = &problem.paper {
            text += "\nThe paper's own policies, run by us in the paper's environment on 60 of its targets:\n\n";
            text += &of_paper(measured);
        }
    }
    text
}

fn capital(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// Renders a table: the first column is text, the others are numbers.
fn grid<const N: usize>(names: [&str; N], rows: impl IntoIterator<Item = [String; N]>) -> String {
    let line = |cells: [String; N]| format!("| {} |\n", cells.join(" | "));
    let rule = std::array::from_fn(|place| if place == 0 { "---" } else { "--:" }.to_owned());
    let head = [names.map(str::to_owned), rule];
    head.into_iter().chain(rows).map(line).collect()
}

fn number(spread: Spread, factor: f64, digits: usize, many: bool) -> String {
    let mean = factor * spread.mean;
    if many { format!("{mean:.digits$} ± {:.digits$}", factor * spread.sd) } else { format!("{mean:.digits$}") }
}

fn thousands(value: f64) -> String {
    let digits = format!("{value:.0}");
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place) % 3 == 0 {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

fn table(rows: &[Row]) -> String {
    let names = [
        "policy",
        "success %",
        "collision %",
        "distance mm",
        "actions",
        "by graph %",
        "ns an action",
        "worst ns",
        "bytes, fast · small",
    ];
    let cells = |row: &Row| {
        let many = row.policies > 1;
        let name = if many { format!("{} ({})", row.name, row.policies) } else { row.name.clone() };
        let time = |part: fn(&Time) -> f64| row.time.as_ref().map_or("–".to_owned(), |time| thousands(part(time)));
        let bytes = row.bytes.map_or("–".to_owned(), |[fast, small]| {
            let fast_text = thousands(fast as f64);
            if fast == small { fast_text } else { format!("{fast_text} · {}", thousands(small as f64)) }
        });
        let [success, collision, distance, actions] = outcome(row, 2);
        [
            name,
            success,
            collision,
            distance,
            actions,
            by_graph(row),
            time(|time| time.mean),
            time(|time| time.worst),
            bytes,
        ]
    };
    grid(names, rows.iter().map(cells))
}

/// Formats success and collisions in %, distance in mm with the given number of digits, and actions.
fn outcome(row: &Row, digits: usize) -> [String; 4] {
    let many = row.policies > 1;
    [
        number(row.success, 100.0, 1, many),
        number(row.collision, 100.0, 1, many),
        number(row.distance, 1.0, digits, many),
        number(row.actions, 1.0, 0, many),
    ]
}

fn by_graph(row: &Row) -> String {
    row.by_graph.map_or("–".to_owned(), |ratio| number(ratio, 100.0, 0, row.policies > 1))
}

fn costs(problem: &Problem) -> String {
    let Costs { shipped, guards: [none, limits, collisions, both], detectors: [exact, brent], reference, wide } =
        problem.costs;
    let planner = problem.rows.first().and_then(|row| row.time);
    let times = |of: f64, by: f64| {
        let factor = of / by;
        if factor >= 10.0 { format!("{factor:.0}") } else { format!("{factor:.1}") }
    };
    let mut text = format!(
        "**{}.** In one run on this machine, a mean action takes {} ns with the hybrid, {} ns with its graph alone ({} ns in constant time), {} ns with \
         its network alone, and {} ns with the network that the paper measures against, 13-256-256-4 in `f32` (all of it compiled \
         without options for this machine; that network on the widest vectors it has: {} ns). The hybrid is \
         **{} times quicker than that network** (the paper, its halving undone: {}) and {} times as quick as the small \
         network alone. ",
        capital(problem.name()),
        thousands(shipped.hybrid.mean),
        thousands(shipped.tpg.mean),
        thousands(shipped.tpg_constant_time.mean),
        thousands(shipped.sac.mean),
        thousands(reference.mean),
        thousands(wide.mean),
        times(reference.mean, shipped.hybrid.mean),
        if problem.start == Start::Fs { "11" } else { "2.8" },
        times(shipped.sac.mean, shipped.hybrid.mean),
    );
    if let Some(planner) = planner {
        text += &format!(
            "The classical planner takes {} ns a mean action, {} times the hybrid's, and {} µs in its worst one; the \
             hybrid's worst takes {} µs. ",
            thousands(planner.mean),
            times(planner.mean, shipped.hybrid.mean),
            thousands(planner.worst / 1000.0),
            format_args!("{:.1}", shipped.hybrid.worst / 1000.0),
        );
    }
    let episode = |name: &str, time: Time| {
        let row = problem.rows.iter().find(|row| row.name == name);
        thousands(row.map_or(0.0, |row| row.actions.mean) * time.mean / 1000.0)
    };
    text += &format!(
        "A whole episode costs the hybrid {} µs and the small network alone, which moves all four motors at once and needs \
         fewer actions, {} µs. ",
        episode("**hybrid, shipped**", shipped.hybrid),
        episode("SAC, shipped", shipped.sac),
    );
    text += &format!(
        "Of the hybrid's time the guards take {} ns (joint limits), {} ns (collisions too) and {} ns (the network's too); the exact set of visited \
         poses (48 KB) takes {} ns more than Brent's detector (16 bytes).\n\n",
        signed(limits.mean - none.mean),
        signed(collisions.mean - none.mean),
        signed(both.mean - none.mean),
        signed(exact.mean - brent.mean),
    );
    text
}

/// Describes the cost of the hybrids' parts on a Cortex-M4.
fn on_target(problems: &[Problem], counts: &Counts) -> String {
    let mut text =
        "**On a Cortex-M4** (`cargo xtask qemu`: both firmwares, 100 to 200 test targets, every instruction counted; \
                    kinematics are in *network* and *graph*, the simulated arm is not):\n\n"
            .to_owned();
    let parts = problems.iter().flat_map(|problem| {
        [
            ("hybrid", "**hybrid, shipped**"),
            ("graph", "TPG, shipped"),
            ("network", "SAC, shipped"),
            ("straight", STRAIGHT),
        ]
        .map(|(part, row)| (problem, part, row))
    });
    let cells = parts.map(|(problem, part, row)| {
        let [c, rust] = ["C", "Rust"].map(|language| counts.part(language, problem.start, part));
        let cell =
            |count: Option<Count>, of: fn(&Count) -> f64| count.map_or("–".to_owned(), |count| thousands(of(&count)));
        let actions = problem.rows.iter().find(|known| known.name == row).map_or(0.0, |row| row.actions.mean);
        [
            format!("{}, {part}", problem.name()),
            cell(c, Count::mean),
            cell(c, |count| count.worst as f64),
            cell(rust, Count::mean),
            cell(rust, |count| count.worst as f64),
            c.map_or("–".to_owned(), |count| thousands(count.mean() * actions)),
        ]
    });
    text += &grid(
        ["instructions", "C, mean action", "C, worst", "Rust, mean action", "Rust, worst", "C, an episode"],
        cells,
    );
    let layers = ["f32", "i8"].map(|kind| counts.named(&format!("Rust layers 13-256-256-4 {kind}")));
    if let [Some(single), Some(integers)] = layers {
        text += &format!(
            "\nThe layers alone of the paper's network, 13-256-256-4, take {} instructions in `f32` and {} in 8-bit integers \
             with this project's kernels.\n\n",
            thousands(single.mean()),
            thousands(integers.mean()),
        );
    }
    text
}

fn signed(ns: f64) -> String {
    if ns >= 0.5 { format!("+{ns:.0}") } else { format!("{ns:.0}") }
}

fn ideas(rows: &[Row]) -> String {
    let cells = |row: &Row| {
        let [success, collision, distance, actions] = outcome(row, 2);
        [row.name.clone(), success, collision, distance, actions, by_graph(row)]
    };
    grid(["policy", "success %", "collision %", "distance mm", "actions", "by graph %"], rows.iter().map(cells))
}

fn printed(problem: &Problem) -> String {
    let names = [
        "policy",
        "distance mm, printed",
        "from its files",
        "success %, printed",
        "from its files",
        "collision %, printed",
        "from its files",
    ];
    let cells = |row: &paper::Printed| {
        let [distance, success, collision] = row.printed.map(|value| value.to_string());
        let [d, s, c] = row.recomputed.map(str::to_owned);
        [row.name.to_owned(), distance, d, success, s, collision, c]
    };
    grid(names, paper::printed(problem.start).iter().map(cells))
}

fn of_paper(rows: &[Measured]) -> String {
    let cells = |row: &Measured| {
        [
            format!("{} ({})", row.name, row.policies),
            number(row.success, 100.0, 1, true),
            number(row.collision, 100.0, 1, true),
            number(row.distance, 1.0, 1, true),
            number(row.actions, 1.0, 0, true),
        ]
    };
    grid(["policies", "success %", "collision %", "distance mm", "actions"], rows.iter().map(cells))
}

fn learned(rows: &[LearnedRow]) -> String {
    let names = [
        "policy (trainings)",
        "success %",
        "collision %",
        "distance mm",
        "actions",
        "success %, paper's targets",
        "distance mm, paper's targets",
    ];
    let cells = |LearnedRow { test, paper }: &LearnedRow| {
        let of_paper = |of: fn(&Row) -> Spread, factor: f64| {
            paper.as_ref().map_or("–".to_owned(), |row| number(of(row), factor, 1, test.policies > 1))
        };
        let [success, collision, distance, actions] = outcome(test, 1);
        let name = format!("{} ({})", test.name, test.policies);
        let [by_success, by_distance] = [of_paper(|row| row.success, 100.0), of_paper(|row| row.distance, 1.0)];
        [name, success, collision, distance, actions, by_success, by_distance]
    };
    grid(names, rows.iter().map(cells))
}

const PLANNER: &str = "**Beside the classical planner.** It solves nearly everything, and no learned policy here is better at \
that. Its simple form, straight to the nearest goal, does as well as the network at fixed start and collides more often at \
random start; the form that looks ahead costs many times the hybrid, a list of goal poses in memory, and a worst action far \
above the mean. Simpler still, *one goal, straight* goes to the first of four poses in closed form, the one that the graph of \
random start reads as `stance`. It is the cheapest policy here, on a microcontroller too, and it moves all joints at once: \
fewer actions than any graph. What the graph has learned beside it is in which order to move the joints, around table and base; \
what the hybrid adds is that hardly any target is missed, and that nothing invalid is executed. All but the network need a \
model of the arm (the guard's, for the hybrid). Anyone whose arm and surroundings are known and fixed may be best served by \
the classical policies; the learned ones decide in constant memory with a worst case that is known at compile time, and can \
be trained where no closed form is at hand. An obstacle that moves, or one that was not there when the model was made, costs \
a planner a new plan at every step; nothing here measures how well a policy trained with such obstacles would do.
";

const FAILED: &str = "
What did not help, or not enough:

- *Handing over because of the distance*: no more success than without it, and nearly every action is the graph's without it.
  Not so with a weaker graph: the one before this at random start, 85 % alone, did best when it handed over 1 mm off its way.
- *Handing over for good*: the fewer actions of the graph for no more success, as long as the guard holds for the network too.
- *The exact set of visited poses*: Brent's detector hands over a few actions later, at the same success.
- *Other seeds of graph and network*: *all pairs* in table 2.
- *The hand-over priced in*: a graph that was evolved as the shipped one was, but for failures that cost 20 mm at most
  (`handOverPrice`): it has no reason to come near where it fails.
- *A guard on the paper's own hybrids*: little, since its network collides as often as its graphs. With our network the same
  guard is worth 14 points at random start, and handing over for good four more (below).

Not tried: a network trained on the states where graphs give up. These graphs fail in one or two episodes of a hundred, and the
hybrid in none or one of a thousand.
";

const TAUGHT: &str = "Rows of several trainings are means ± standard deviations over seeds. *The \
paper's targets* are 60 of the recorded ones. A policy alone, no guard; networks with 38 features hold a joint that would leave \
its range (their mask), graphs do so where *shielded*. The paper's learning problem: its 13 values, its score or reward, its \
action set, its budget; its networks draw their actions, as in its tests. `paper-*` differs from its tools where \
`tpg-train/README.md` says, which also has the paper's figures beside these. The planner, the memoryless inverse kinematics and the closed form learned nothing.
";

const PAPER: &str = "As printed, and what the artifact's own files give (population standard deviation over seeds). Its rows \
*SAC, collisions allowed* are extrema of training curves. Its hybrid's times are halved: undone, 5.5 µs (fixed start) and \
21.9 µs (random start) an action, beside 0.64 µs for a TPG and 61.5 µs for SAC; model sizes 13 KB and 292 KB.
";
