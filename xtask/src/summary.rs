//! Summary of passed, failed and skipped tests.

use std::io;
use std::time::Duration;

/// Counts of tests in a command's output.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Count {
    passed: usize,
    failed: usize,
    ignored: usize,
}

impl Count {
    /// Counts a line of cargo test's output, `test result: ok. 3 passed; 0 failed; 1 ignored; …`, or of pytest's:
    /// `1 failed, 3 passed, 2 skipped in 0.12s`. Skips of pytest's tests are reported as those of all others.
    pub(crate) fn add(&mut self, line: &str) {
        let pytest = line.rsplit_once(" in ").filter(|(counts, _)| !counts.contains(';'));
        if let Some((counts, _)) = pytest.filter(|(_, time)| time.starts_with(|c: char| c.is_ascii_digit())) {
            for part in counts.split(", ") {
                let number = |name| part.strip_suffix(name).and_then(|number| number.trim().parse::<usize>().ok());
                self.passed += number(" passed").unwrap_or(0);
                self.failed +=
                    number(" failed").or_else(|| number(" errors")).or_else(|| number(" error")).unwrap_or(0);
            }
            return;
        }
        let Some(result) = line.strip_prefix("test result: ") else { return };
        let number = |name| {
            let mut parts = result.split([';', '.']).filter_map(|part| part.trim().strip_suffix(name));
            parts.next().and_then(|number: &str| number.trim().parse().ok()).unwrap_or(0)
        };
        self.passed += number("passed");
        self.failed += number("failed");
        self.ignored += number("ignored");
    }
}

/// Results of a run.
#[derive(Debug, Default)]
pub(crate) struct Summary {
    checks: Vec<String>,
    passed: usize,
    failed: usize,
    skipped: Vec<String>,
}

impl Summary {
    /// Records the result of a command and the time it took. A command without tests counts as one test; a command that
    /// failed counts as a failure even if no test failed.
    pub(crate) fn note(&mut self, name: &str, took: Duration, result: io::Result<(bool, Count)>) {
        let (good, count) = result.unwrap_or_else(|error| {
            eprintln!("{name}: {error}");
            (false, Count::default())
        });
        self.passed += if good { count.passed.max(1) } else { count.passed };
        self.failed += if good { 0 } else { count.failed.max(1) };
        if count.ignored > 0 {
            self.skipped.push(format!("{name}: {} tests marked #[ignore]", count.ignored));
        }
        let result = if good { "passed " } else { "FAILED " };
        self.checks.push(format!("{result} {name} ({} s)", took.as_secs()));
    }

    /// Records a check that cannot run: a failure if missing tools must fail.
    pub(crate) fn missing(&mut self, name: &str, remedy: &str) {
        if tpg_testing::required() {
            self.failed += 1;
            self.checks.push(format!("FAILED  {name}: not installed ({remedy})"));
        } else {
            self.checks.push(format!("SKIPPED {name}"));
            tpg_testing::skip(&format!("{name}: not installed ({remedy})"));
            self.skipped.push(format!("{name}: not installed ({remedy})"));
        }
    }

    /// Records skips reported by tests.
    pub(crate) fn skip(&mut self, what: Vec<String>) {
        self.skipped.extend(what);
    }

    /// Prints the summary; the last line is also meant for programs.
    pub(crate) fn print(&self) {
        println!("\n==== summary");
        self.checks.iter().for_each(|check| println!("{check}"));
        self.skipped.iter().for_each(|what| println!("SKIPPED {what}"));
        println!("{} passed, {} failed, {} skipped", self.passed, self.failed, self.skipped.len());
    }

    /// True if nothing failed.
    pub(crate) fn good(&self) -> bool {
        self.failed == 0
    }
}

#[cfg(test)]
mod tests {
    use super::{Count, Summary};
    use std::time::Duration;

    #[test]
    fn the_lines_of_cargo_test_are_counted() {
        let mut count = Count::default();
        count.add("test result: ok. 12 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out; finished in 1.25s");
        count.add("test result: FAILED. 3 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.00s");
        count.add("test tests::one ... ok");
        assert_eq!(count, Count { passed: 15, failed: 2, ignored: 1 });
    }

    #[test]
    fn the_last_line_of_pytest_is_counted() {
        let mut count = Count::default();
        count.add("2 failed, 40 passed, 1 skipped, 3 warnings in 18.68s");
        count.add("12 passed in 67.77s (0:01:07)");
        count.add("1 passed, 1 error in 0.50s");
        count.add("generation 2 in 3 steps passed");
        assert_eq!(count, Count { passed: 53, failed: 3, ignored: 0 });
    }

    #[test]
    fn a_command_that_fails_without_a_failed_test_is_a_failure() {
        let mut summary = Summary::default();
        summary.note("tests", Duration::ZERO, Ok((false, Count { passed: 3, ..Count::default() })));
        assert!(!summary.good());
        assert_eq!((summary.passed, summary.failed), (3, 1));
    }
}
