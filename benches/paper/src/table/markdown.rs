//! Renders `docs/results.md`.

use super::compiled::Costs;
use super::cortex_m4::{Count, Counts};
use super::learned::LearnedRow;
use super::paper::{self, Measured};
use super::rows::{Row, STRAIGHT};
use super::timing::Time;
use tpg_problems::arm::targets::Start;
use tpg_train::hybrid::spread::Spread;

/// All results of one problem.
#[derive(Debug)]
pub struct ProblemResults {
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

impl ProblemResults {
    fn name(&self) -> &'static str {
        match self.start {
            Start::Fs => "fixed start",
            Start::Rs => "random start",
        }
    }
}

const LEAD: &str = "# Results

Made by `cargo run --release -p tpg-paper -- table2` from the policies listed in `docs/results.toml`; do not edit. Only the
times differ between runs.

**Task.** The paper's WidowX arm must bring its hand within 3 mm of a target, in at most 1,707 actions from the home pose
(fixed start) or 3,414 actions from any pose (random start). Targets are distributed uniformly over the reachable space. An
action is invalid if it leaves a joint's range or causes a collision. An invalid action ends the episode as a failure and is
counted as a *collision*, as in the paper. The 1,000 test episodes of each problem are committed
(`generated/test-targets`). They were not used for training or for choosing policies.

**Prior knowledge.** The graphs read errors in the arm's own geometry, and the network reads 38 features. Both are computed
from the paper's 13 values with knowledge of the arm. The network's reward also used poses that solve the task, during
training only. This is therefore not the paper's learning problem. The network's mask holds a joint that would leave its
range. The hybrid's guard hands over to the network instead of executing such an action of the graph. Both are part of the
policy.
";

const COLUMNS: &str = "**Columns.** *By graph*: fraction of all actions that the graph chose. *ns per action*: time from motor positions to a move \
on this machine, including kinematics but not the simulated arm. The code is compiled as for users: the generated Rust in \
profile `fast` and the network in integers, with no option for this machine's own instructions. The fastest of seven rounds \
counts for each episode. *Worst ns* is the slowest single action. *Bytes*: the graph's C for a Cortex-M4F (`-Os`, code and \
constants, in the profiles `fast` and `small`) plus the network's constants; the runtime that both share is not counted. \
*All seeds* and *all pairs*: mean ± standard deviation over trainings that differ only in their seed, with the shipped \
settings. They show what to expect from another training; the shipped policies were chosen, on validation episodes.
";

/// Renders the file.
pub fn page(problems: &[ProblemResults], counts: &Counts) -> String {
    let mut text = LEAD.to_owned();
    text += "\n## Table 2\n\n";
    text += COLUMNS;
    for problem in problems {
        text += &format!("\n### {}, {} test episodes\n\n", capital(problem.name()), problem.episodes);
        text += &table(&problem.rows);
    }
    text += "\n## Cost\n\n";
    for problem in problems {
        text += &costs(problem);
    }
    text += &on_target(problems, counts);
    text += PLANNER;
    text += "\n## Effect of each idea\n\n";
    text += "The shipped graph and actor on 1,000 validation episodes that were not used for training or for choosing policies.\n";
    for problem in problems {
        text += &format!("\n{}:\n\n", capital(problem.name()));
        text += &ideas(&problem.ideas);
    }
    text += FAILED;
    text += "\n## Other learning problems\n\n";
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
            text +=
                "\nThe paper's own policies, run by this project in the paper's environment on 60 of its targets:\n\n";
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
        "ns per action",
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

fn costs(problem: &ProblemResults) -> String {
    let Costs { shipped, guards: [none, limits, collisions, both], detectors: [exact, brent], reference, wide } =
        problem.costs;
    let planner = problem.rows.first().and_then(|row| row.time);
    let times = |of: f64, by: f64| {
        let factor = of / by;
        if factor >= 10.0 { format!("{factor:.0}") } else { format!("{factor:.1}") }
    };
    let mut text = format!(
        "**{}.** In one run on this machine, a mean action takes {} ns with the hybrid, {} ns with its graph alone ({} ns in \
         constant time) and {} ns with its network alone. The network that the paper compares with, 13-256-256-4 in `f32`, \
         takes {} ns. All of this code is compiled without options for this machine; with the widest vectors it has, the \
         paper's network takes {} ns. The hybrid is **{} times as fast as the paper's network** (the paper reports a factor \
         of {} once its halved times are corrected) and {} times as fast as the small network alone. ",
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
            "A mean action of the classical planner takes {} ns, {} times as long as the hybrid's. Its slowest action takes \
             {} µs, the hybrid's {} µs. ",
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
        "A whole episode takes {} µs with the hybrid and {} µs with the small network alone, which moves all four motors at \
         once and so needs fewer actions. ",
        episode("**hybrid, shipped**", shipped.hybrid),
        episode("SAC, shipped", shipped.sac),
    );
    text += &format!(
        "The guards add {} ns to the hybrid's time (joint limits), {} ns (collisions too) and {} ns (the network's actions \
         too). The exact set of visited poses (48 KB) takes {} ns more than Brent's detector (16 bytes).\n\n",
        signed(limits.mean - none.mean),
        signed(collisions.mean - none.mean),
        signed(both.mean - none.mean),
        signed(exact.mean - brent.mean),
    );
    text
}

/// Describes the cost of the hybrids' parts on a Cortex-M4.
fn on_target(problems: &[ProblemResults], counts: &Counts) -> String {
    let mut text =
        "**On a Cortex-M4** (`cargo xtask qemu`: both firmwares on 100 to 200 test targets, every instruction counted). The \
         counts of *network* and *graph* include kinematics, but not the simulated arm:\n\n"
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
        ["instructions", "C, mean action", "C, worst", "Rust, mean action", "Rust, worst", "C, per episode"],
        cells,
    );
    let layers = ["f32", "i8"].map(|kind| counts.named(&format!("Rust layers 13-256-256-4 {kind}")));
    if let [Some(single), Some(integers)] = layers {
        text += &format!(
            "\nThe layers of the paper's network alone, 13-256-256-4, take {} instructions in `f32` and {} in 8-bit integers \
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

fn printed(problem: &ProblemResults) -> String {
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

const PLANNER: &str = "**Comparison with the classical planner.** The planner solves nearly every episode, and no learned policy here has a \
higher success rate. Its simple form, straight to the nearest goal, does as well as the network at fixed start and collides \
more often at random start. The form that looks ahead costs many times as much as the hybrid, needs a list of goal poses in \
memory, and its slowest action takes far longer than its mean one. *One goal, straight* is simpler still: it goes to the \
first of four poses in closed form, the one that the graph of random start reads as `stance`. It is the cheapest policy \
here, also on a microcontroller, and it moves all joints at once, so it needs fewer actions than any graph. What the graph \
has learned in addition is the order in which to move the joints around table and base. With the hybrid, hardly any target \
is missed and no invalid action is executed. All policies but the network need a model of the arm; the hybrid needs it for its \
guard. If the arm and its surroundings are known and fixed, a classical policy may be the best choice. The learned policies decide in \
constant memory, with a worst case that is known at compile time, and can be trained where there is no closed form. A moving \
obstacle, or one that was not in the model, forces a planner to plan anew at every step. How well a policy trained with such \
obstacles would do is not measured here.
";

const FAILED: &str = "
Ideas that did not help, or not enough:

- *Handing over because of the distance*: no more success than without it. Without it, nearly every action is the graph's. A
  weaker graph did benefit: the previous one at random start, with 85 % alone, did best when it handed over 1 mm off its way.
- *Not handing back*: fewer actions of the graph and no more success, as long as the guard also applies to the network.
- *The exact set of visited poses*: Brent's detector hands over a few actions later, with the same success.
- *Other seeds of graph and network*: see *all pairs* in table 2.
- *A price for handing over*: a graph that was evolved like the shipped one, except that a failure cost 20 mm at most
  (`hand_over_price`). It has no reason to come near a target that it cannot reach.
- *A guard on the paper's own hybrids*: little effect, because the paper's network collides as often as its graphs. With our
  network, the same guard is worth 14 points at random start, and never handing back four more (see below).

Not tried: training a network on the states in which graphs fail. These graphs fail in one or two episodes of a hundred, and
the hybrid in none or one of a thousand.
";

const TAUGHT: &str = "Rows of several trainings are means ± standard deviations over seeds. *The paper's targets* are 60 of the recorded \
ones. Each policy acts alone, without a guard. Networks with 38 features have a mask that holds a joint that would leave \
its range; graphs have the same protection where the row says *shielded*. The paper's learning problem has its 13 values, \
its score or reward, its action set and its budget; its networks draw their actions at random, as in the paper's tests. \
`tpg-train/README.md` lists the differences between `paper-*` and the paper's tools, and gives the paper's figures beside \
these. The planner, the memoryless inverse kinematics and the closed form were not trained.
";

const PAPER: &str = "The figures as printed, and recomputed from the artifact's own files (population standard deviation over seeds). The \
rows *SAC, collisions allowed* are extrema of training curves. The paper halved its hybrid's times. Without that, an action \
takes 5.5 µs (fixed start) and 21.9 µs (random start), compared with 0.64 µs for a TPG and 61.5 µs for SAC. The models have \
13 KB and 292 KB.
";
