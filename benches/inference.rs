//! How long a decision takes: every variant of every policy, side by side in one run, and how many instructions it is.
//!
//! `cargo bench -p tpg-benches --bench inference` measures with criterion, too, which keeps its reports and compares with
//! the run before; `-- summary` makes the tables alone, in minutes. A further word takes the policies with that in their
//! name.
//!
//! The tables' times are CPU times of single-threaded programs on states of real episodes, in their order. All variants of
//! a policy run at once, each a little in turn, and the least of all turns and several starts counts: what else a busy machine
//! does falls on all of them alike, and mostly out.

use criterion::{BenchmarkId, Criterion};
use std::env;
use std::time::Duration;
use tpg_benches::callgrind;
use tpg_benches::program::{Program, Running};
use tpg_benches::subject::{self, Subject};
use tpg_benches::table::Table;
use tpg_benches::variant::Variant;

/// How often the programs are started: where one's memory comes to lie can cost it half its speed, for as long as it runs.
const STARTS: usize = 5;
/// How often each program has its turn, where it needs no longer for a pass over the states than a turn.
const TURNS: usize = 20;
/// How long a turn is, or one pass: long beside the clock, short beside the slices that a scheduler gives.
const TURN: Duration = Duration::from_millis(2);

fn main() {
    // cargo test runs benchmarks, too, to see that they work: one subject is enough for that.
    let testing = !env::args().any(|word| word == "--bench");
    let mut words: Vec<String> = env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    let summary = words.first().is_some_and(|word| word == "summary");
    words.drain(..usize::from(summary));
    let wanted = |subject: &Subject| words.first().is_none_or(|name| subject.name.contains(name.as_str()));
    let mut subjects = subject::own();
    if testing {
        subjects.truncate(1);
    } else {
        subjects.extend(subject::conformance(subject::STATES));
    }
    let mut criterion = (!summary).then(|| Criterion::default().configure_from_args());
    let mut times = Table::new("Nanoseconds a decision");
    let mut counts = Table::new("Instructions a decision");
    let counting = !testing && callgrind::available();
    for subject in subjects.iter().filter(|subject| wanted(subject)) {
        let programs = Variant::ALL.map(|variant| Program::build(subject, variant).unwrap_or_else(|e| panic!("{e}")));
        let least = least(subject, &programs, if testing { 1 } else { STARTS });
        for ((variant, program), least) in Variant::ALL.into_iter().zip(&programs).zip(least) {
            times.note(subject, variant, least / subject.count() as f64);
            if let Some(criterion) = &mut criterion {
                sample(criterion, subject, variant, &mut start(program, subject));
            }
            if counting {
                let count = callgrind::per_state(program, subject).unwrap_or_else(|error| panic!("{error}"));
                counts.note(subject, variant, count);
            }
        }
        eprintln!("{}", subject.name);
    }
    if let Some(criterion) = criterion {
        criterion.final_summary();
    }
    for table in [Some(times), counting.then_some(counts)].into_iter().flatten() {
        println!("{}", table.render());
        println!("{}{}", table.summary(Variant::Gegelati), table.summary(Variant::Interpreter));
    }
}

/// Nanoseconds of the fastest pass over all states.
fn least<const N: usize>(subject: &Subject, programs: &[Program; N], starts: usize) -> [f64; N] {
    let mut least = [f64::INFINITY; N];
    for _ in 0..starts {
        let mut running = programs.each_ref().map(|program| start(program, subject));
        let once = running.each_mut().map(|running| time(running, 1).max(Duration::from_nanos(1)).as_nanos());
        for turn in 0..TURNS {
            for (place, running) in running.iter_mut().enumerate() {
                let passes = (TURN.as_nanos() / once[place]).max(1) as u64;
                let turns_of_a_pass = (once[place] / TURN.as_nanos()).max(1) as usize;
                if turn % turns_of_a_pass == 0 {
                    least[place] = least[place].min(time(running, passes).as_nanos() as f64 / passes as f64);
                }
            }
        }
    }
    least
}

fn start(program: &Program, subject: &Subject) -> Running {
    program.start(subject).unwrap_or_else(|error| panic!("{error}"))
}

fn time(running: &mut Running, passes: u64) -> Duration {
    running.time(passes).unwrap_or_else(|error| panic!("{error}"))
}

fn sample(criterion: &mut Criterion, subject: &Subject, variant: Variant, running: &mut Running) {
    let mut group = criterion.benchmark_group(&subject.name);
    group.warm_up_time(Duration::from_millis(50)).measurement_time(Duration::from_millis(300)).sample_size(10);
    group.throughput(criterion::Throughput::Elements(subject.count() as u64));
    group.bench_function(BenchmarkId::from_parameter(variant.name()), |bencher| {
        bencher.iter_custom(|passes| time(running, passes));
    });
    group.finish();
}
