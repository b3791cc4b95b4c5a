//! The conversation between a run, which has a thread of its own, and Python, which runs the episodes.

use crate::evolution::Report;
use std::sync::Mutex;
use std::sync::mpsc::{Receiver, SyncSender};
use tpg_engine::{EpisodeResult, EvaluationError, Evaluator, Play, Played, Work};

/// A message of the run.
pub(crate) enum Event {
    /// It wants roots evaluated.
    Evaluate(Work<u64>),
    /// It wants episodes run, and what was seen.
    Play(Vec<Play<u64>>),
    /// A generation is over.
    Progress(Box<Report>),
}

/// A reply of Python.
pub(crate) enum Reply {
    /// Endings of each unit on each task.
    Endings(Vec<Vec<EpisodeResult>>),
    /// Results of each episode.
    Played(Vec<Played>),
    /// True if the run shall go on.
    GoOn(bool),
}

/// The run's end of the conversation.
pub(crate) struct Mailbox {
    events: SyncSender<Event>,
    replies: Mutex<Receiver<Reply>>,
}

impl Mailbox {
    /// Creates the run's end.
    pub(crate) fn new(events: SyncSender<Event>, replies: Receiver<Reply>) -> Self {
        Self { events, replies: Mutex::new(replies) }
    }

    /// Says something and waits for the reply; `None` if nobody listens any more.
    fn ask(&self, event: Event) -> Option<Reply> {
        self.events.send(event).ok()?;
        self.replies.lock().ok()?.recv().ok()
    }

    /// Reports progress; false if the run shall stop.
    pub(crate) fn report(&self, report: Report) -> bool {
        matches!(self.ask(Event::Progress(Box::new(report))), Some(Reply::GoOn(true)))
    }
}

fn stopped() -> EvaluationError {
    EvaluationError::new("the run was stopped")
}

impl Evaluator<u64> for Mailbox {
    fn evaluate(&self, work: &Work<u64>) -> Result<Vec<Vec<EpisodeResult>>, EvaluationError> {
        if work.policies.is_empty() || work.tasks.is_empty() {
            return Ok(vec![Vec::new(); work.policies.len()]);
        }
        let Some(Reply::Endings(endings)) = self.ask(Event::Evaluate(work.clone())) else { return Err(stopped()) };
        Ok(endings)
    }

    fn play(&self, plays: &[Play<u64>]) -> Result<Vec<Played>, EvaluationError> {
        if plays.is_empty() {
            return Ok(Vec::new());
        }
        let Some(Reply::Played(played)) = self.ask(Event::Play(plays.to_vec())) else { return Err(stopped()) };
        Ok(played)
    }
}
