//! The counts.

use super::CheckedRun;
use super::subject::Subject;
use std::path::Path;

/// One kind of disturbance of one subject.
#[derive(Debug)]
pub(super) struct Row {
    subject: &'static str,
    kind: &'static str,
    /// Conditions looked at.
    checks: u32,
    /// Runs that were finished and compared.
    compared: u32,
    failures: u32,
    /// More about the disturbances.
    pub(super) remark: String,
}

impl Row {
    pub(super) fn new(subject: &'static str, kind: &'static str) -> Self {
        Self { subject, kind, checks: 0, compared: 0, failures: 0, remark: String::new() }
    }

    /// Counts a condition, and prints what is wrong if it is false.
    pub(super) fn note(&mut self, good: bool, wrong: impl FnOnce() -> String) {
        self.checks += 1;
        if !good {
            self.failures += 1;
            eprintln!("FAILED  {}, {}: {}", self.subject, self.kind, wrong());
        }
    }

    /// Finishes a run and compares its bytes with those of the undisturbed one.
    pub(super) fn finish(&mut self, subject: &Subject, folder: &Path) {
        let output = subject.finish(folder);
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        self.note(output.status.success(), || format!("{}: cannot be finished: {error}", folder.display()));
        self.note(subject.is_whole(folder), || format!("{}: other bytes, or something left", folder.display()));
        self.compared += 1;
    }
}

/// All rows.
#[derive(Debug, Default)]
pub(super) struct Table {
    rows: Vec<Row>,
    skipped: bool,
}

impl Table {
    /// Adds a row; a check that could not be made is skipped loudly.
    pub(super) fn add(&mut self, checked: CheckedRun) {
        match checked {
            Ok(row) => self.rows.push(row),
            Err(reason) => {
                self.skipped = true;
                tpg_testing::skip(&format!("torture: {reason}"));
            }
        }
    }

    pub(super) fn print(&self) {
        println!(
            "\n| run | disturbance | checks | runs compared | failures | |\n| --- | --- | --- | --- | --- | --- |"
        );
        for Row { subject, kind, checks, compared, failures, remark } in &self.rows {
            println!("| {subject} | {kind} | {checks} | {compared} | {failures} | {remark} |");
        }
        let sum = |count: fn(&Row) -> u32| self.rows.iter().map(count).sum::<u32>();
        let (compared, failures) = (sum(|row| row.compared), sum(|row| row.failures));
        println!("{compared} runs ended and were compared, {failures} failures");
    }

    /// True if nothing failed; with [`tpg_testing::REQUIRE`], a skipped check is a failure.
    pub(super) fn good(&self) -> bool {
        self.rows.iter().all(|row| row.failures == 0) && !(self.skipped && tpg_testing::required())
    }
}
