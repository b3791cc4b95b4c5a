//! Time and instruction count of a decision: every variant of every policy, compared in one run; of the interpreter the time.
//!
//! `cargo bench -p tpg-benches --bench inference` prints the tables, in minutes. A word selects the policies whose names
//! contain it.
//!
//! The times in the tables are CPU times of single-threaded programs on states of real episodes, in their order. All
//! variants of a policy run at the same time, taking short turns, and the minimum over all turns and several starts
//! counts: the other load of a busy machine affects all of them alike, and the minimum mostly excludes it.

use std::env;
use std::time::Duration;
use tpg_benches::callgrind;
use tpg_benches::program::{Decider, Program};
use tpg_benches::subject::{self, Subject};
use tpg_benches::table::BenchTable;
use tpg_benches::variant::Variant;

/// Number of starts of each program: an unlucky memory layout can halve a program's speed for as long as it runs.
const STARTS: usize = 5;
/// Number of turns of each program, if a pass over the states takes no longer than a turn.
const TURNS: usize = 20;
/// Duration of a turn, or one pass: long compared with the clock's resolution, short compared with a scheduler's time
/// slices.
const TURN: Duration = Duration::from_millis(2);

fn main() {
    // cargo test runs benchmarks as well, to check that they work: one subject is enough for that.
    let testing = !env::args().any(|word| word == "--bench");
    let word = env::args().skip(1).find(|word| !word.starts_with('-'));
    let wanted = |subject: &Subject| word.as_ref().is_none_or(|name| subject.name.contains(name.as_str()));
    let mut subjects = subject::own();
    if testing {
        subjects.truncate(1);
    } else {
        subjects.extend(subject::conformance());
    }
    let mut times = BenchTable::new("Nanoseconds per decision");
    let mut counts = BenchTable::new("Instructions per decision");
    let counting = !testing && callgrind::available();
    for subject in subjects.iter().filter(|subject| wanted(subject)) {
        let programs = Variant::ALL.map(|variant| Program::build(subject, variant).unwrap_or_else(|e| panic!("{e}")));
        let least = least(subject, &programs, if testing { 1 } else { STARTS });
        for ((variant, program), least) in Variant::ALL.into_iter().zip(&programs).zip(least) {
            times.note(&subject.name, subject.kind, variant, least / subject.count() as f64);
            if let Some(program) = program.as_ref().filter(|_| counting) {
                let count = callgrind::per_state(program, subject).unwrap_or_else(|error| panic!("{error}"));
                counts.note(&subject.name, subject.kind, variant, count);
            }
        }
        eprintln!("{}", subject.name);
    }
    println!("{}{}{}", times.render(), times.summary(Variant::Gegelati), times.summary(Variant::Interpreter));
    if counting {
        println!("{}{}", counts.render(), counts.summary(Variant::Gegelati));
    }
}

/// Returns the time of the fastest pass over all states, in nanoseconds.
fn least<const N: usize>(subject: &Subject, programs: &[Option<Program>; N], starts: usize) -> [f64; N] {
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

fn start<'a>(program: &Option<Program>, subject: &'a Subject) -> Decider<'a> {
    match program {
        Some(program) => Decider::Program(program.start(subject).unwrap_or_else(|error| panic!("{error}"))),
        None => Decider::Interpreter(subject),
    }
}

fn time(running: &mut Decider<'_>, passes: u64) -> Duration {
    running.time(passes).unwrap_or_else(|error| panic!("{error}"))
}
