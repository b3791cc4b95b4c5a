//! How long a decision takes: every variant of every policy, side by side in one run, and how many instructions it is.
//!
//! `cargo bench -p tpg-benches --bench inference`; `-- NAME` measures the policies with that in their name. Times are CPU
//! times of single-threaded programs on states of real episodes, in their order; the table has the least of criterion's
//! samples, which a busy machine disturbs least.

use criterion::{BenchmarkId, Criterion};
use std::env;
use std::time::Duration;
use tpg_benches::callgrind;
use tpg_benches::program::Program;
use tpg_benches::subject::{self, Subject};
use tpg_benches::table::Table;
use tpg_benches::variant::Variant;

fn main() {
    // cargo test runs benchmarks, too, to see that they work: one subject is enough for that.
    let testing = !env::args().any(|word| word == "--bench");
    let name = env::args().skip(1).find(|word| !word.starts_with('-'));
    let wanted = |subject: &Subject| name.as_ref().is_none_or(|name| subject.name.contains(name.as_str()));
    let mut subjects = subject::own();
    if testing {
        subjects.truncate(1);
    } else {
        subjects.extend(subject::conformance(subject::STATES));
    }
    let mut criterion = Criterion::default().configure_from_args();
    let mut times = Table::new("Nanoseconds a decision, and how many times faster than the C of GEGELATI's shape");
    let mut counts = Table::new("Instructions a decision, and how many times fewer");
    let counting = !testing && callgrind::available();
    for subject in subjects.iter().filter(|subject| wanted(subject)) {
        for variant in Variant::ALL {
            let program = Program::build(subject, variant).unwrap_or_else(|error| panic!("{error}"));
            let least = time(&mut criterion, subject, variant, &program);
            times.note(&subject.name, variant, least);
            if counting {
                let count = callgrind::per_state(&program, subject).unwrap_or_else(|error| panic!("{error}"));
                counts.note(&subject.name, variant, count);
            }
        }
    }
    criterion.final_summary();
    println!("{}{}", times.render(), counts.render());
}

/// Nanoseconds of the fastest sample.
fn time(criterion: &mut Criterion, subject: &Subject, variant: Variant, program: &Program) -> f64 {
    let mut running = program.start(subject).unwrap_or_else(|error| panic!("{error}"));
    let mut least = f64::INFINITY;
    let mut group = criterion.benchmark_group(&subject.name);
    group.warm_up_time(Duration::from_millis(50)).measurement_time(Duration::from_millis(300)).sample_size(10);
    group.throughput(criterion::Throughput::Elements(subject.count() as u64));
    group.bench_function(BenchmarkId::from_parameter(variant.name()), |bencher| {
        bencher.iter_custom(|passes| {
            let time = running.time(passes).unwrap_or_else(|error| panic!("{}: {error}", variant.name()));
            least = least.min(time.as_nanos() as f64 / (passes * subject.count() as u64) as f64);
            time
        });
    });
    group.finish();
    least
}
