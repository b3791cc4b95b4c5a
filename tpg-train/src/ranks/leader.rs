//! The side of rank 0: it hands out jobs and takes answers as they come.

use super::dealer::{Dealer, parts};
use super::link::Link;
use super::worker::{Order, Reply, decode, encode};
use serde::Serialize;
use std::sync::{Mutex, MutexGuard, PoisonError};
use tpg_engine::{EpisodeResult, EvaluationError, Evaluator, Piece, Play, Played, Work};

/// Tells workers that nothing more comes.
pub(super) fn dismiss(link: &dyn Link, ranks: impl IntoIterator<Item = usize>) -> Result<(), EvaluationError> {
    let end = encode(&Order::End)?;
    ranks.into_iter().try_for_each(|rank| link.send(rank, &end))
}

/// Waits until every worker is ready; returns the number of threads of each rank.
///
/// # Errors
/// If one could not begin, or was started with something else than this rank.
pub(super) fn gather(link: &dyn Link, identity: &str, own_threads: usize) -> Result<Vec<usize>, EvaluationError> {
    let mut threads = vec![own_threads; link.ranks()];
    let (mut problem, mut ready) = (None, Vec::new());
    for _ in 1..link.ranks() {
        let (rank, bytes) = link.receive()?;
        match decode(&bytes)? {
            Reply::Ready { identity: theirs, threads: count } => {
                threads[rank] = count as usize;
                ready.push(rank);
                if theirs != identity {
                    let text = format!("rank {rank} was started with another version, configuration or problem");
                    problem = Some(text);
                }
            }
            Reply::Failed(text) => problem = Some(format!("rank {rank}: {text}")),
            Reply::Done(_) => problem = Some(format!("rank {rank}: an answer without a question")),
        }
    }
    let Some(problem) = problem else { return Ok(threads) };
    dismiss(link, ready)?;
    Err(EvaluationError::new(problem))
}

/// The endings of some of the pieces.
type Answers = Result<Vec<Vec<EpisodeResult>>, EvaluationError>;

/// Pieces of work for all ranks: what is left, the answers so far, and the first failure, after which nothing more is handed out.
struct Question {
    left: Dealer,
    answers: Vec<Option<Vec<EpisodeResult>>>,
    failure: Option<EvaluationError>,
}

impl Question {
    fn deal(&mut self, threads: usize) -> Option<Vec<usize>> {
        let share = if self.failure.is_none() { self.left.deal(threads) } else { Vec::new() };
        (!share.is_empty()).then_some(share)
    }

    fn take(&mut self, share: Vec<usize>, answers: Answers) {
        match answers {
            Ok(answers) if answers.len() == share.len() => {
                share.into_iter().zip(answers).for_each(|(job, answer)| self.answers[job] = Some(answer));
            }
            answers => {
                let other = || EvaluationError::new("a rank answered to another number of jobs");
                self.failure.get_or_insert(answers.err().unwrap_or_else(other));
            }
        }
    }
}

fn open(question: &Mutex<Question>) -> MutexGuard<'_, Question> {
    question.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The evaluator of a run on rank 0.
pub(super) struct Leader<'l, Task> {
    pub(super) link: &'l dyn Link,
    pub(super) local: &'l (dyn Evaluator<Task> + Sync),
    /// Threads of each rank.
    pub(super) threads: Vec<usize>,
}

impl<Task: Clone + Serialize + Sync> Leader<'_, Task> {
    /// Answers to pieces of work, in their order, by all ranks. Rank 0's threads take their shares themselves; this thread alone
    /// talks to the other ranks.
    ///
    /// # Errors
    /// If a job cannot be done. What is under way is still waited for, so that the workers are ready for the next order.
    fn answers(&self, work: &Work<Task>, pieces: &[Piece]) -> Answers {
        let cost = |piece: &Piece| (work.policies[piece.policy].size() * piece.tasks.len()) as u64;
        let costs: Vec<u64> = pieces.iter().map(cost).collect();
        let left = Dealer::new(&costs, self.threads.iter().sum());
        let question = Mutex::new(Question { left, answers: vec![None; pieces.len()], failure: None });
        std::thread::scope(|scope| {
            let (question, local, threads) = (&question, self.local, self.threads[0]);
            scope.spawn(move || {
                loop {
                    let Some(share) = open(question).deal(threads) else { break };
                    let own: Vec<Piece> = share.iter().map(|&job| pieces[job].clone()).collect();
                    let answers = local.pieces(work, &own);
                    open(question).take(share, answers);
                }
            });
            if let Err(lost) = self.talk(work, pieces, question) {
                open(question).failure.get_or_insert(lost);
            }
        });
        let Question { answers, failure, .. } = question.into_inner().unwrap_or_else(PoisonError::into_inner);
        let unanswered = || EvaluationError::new("a job was not handed out");
        failure.map_or_else(|| answers.into_iter().collect::<Option<_>>().ok_or_else(unanswered), Err)
    }

    /// Hands out jobs and takes answers until nothing is under way on any other rank.
    fn talk(&self, work: &Work<Task>, pieces: &[Piece], question: &Mutex<Question>) -> Result<(), EvaluationError> {
        let tasks = serde_json::to_vec(&work.tasks).map_err(EvaluationError::new)?;
        let hand_out = |rank: usize| -> Result<Option<Vec<usize>>, EvaluationError> {
            let Some(share) = open(question).deal(self.threads[rank]) else { return Ok(None) };
            let job = |&job: &usize| (work.policies[pieces[job].policy].clone(), pieces[job].tasks.clone());
            let order = Order::Evaluate { tasks: tasks.clone(), jobs: share.iter().map(job).collect() };
            self.link.send(rank, &encode(&order)?)?;
            Ok(Some(share))
        };
        // The jobs that each rank does at the moment.
        let mut under_way = vec![None; self.threads.len()];
        for (rank, share) in under_way.iter_mut().enumerate().skip(1) {
            *share = hand_out(rank)?;
        }
        while under_way.iter().any(Option::is_some) {
            let (rank, bytes) = self.link.receive()?;
            // The worker goes on before its answer is looked at.
            let share = std::mem::replace(&mut under_way[rank], hand_out(rank)?);
            let failed = |text: &str| Err(EvaluationError::new(format!("rank {rank}: {text}")));
            let answers = match decode(&bytes)? {
                Reply::Done(answers) => Ok(answers),
                Reply::Failed(text) => failed(&text),
                Reply::Ready { .. } => failed("ready for a second time"),
            };
            open(question).take(share.unwrap_or_default(), answers);
        }
        Ok(())
    }
}

impl<Task: Clone + Serialize + Sync> Evaluator<Task> for Leader<'_, Task> {
    fn evaluate(&self, work: &Work<Task>) -> Answers {
        let parts = parts(work.policies.len(), self.threads.iter().sum());
        let pieces = Piece::cut(work.policies.len(), work.tasks.len(), parts);
        let mut endings = vec![Vec::new(); work.policies.len()];
        for (piece, answer) in pieces.iter().zip(self.answers(work, &pieces)?) {
            endings[piece.policy].extend(answer);
        }
        Ok(endings)
    }

    /// This rank alone plays what is observed.
    fn play(&self, plays: &[Play<Task>]) -> Result<Vec<Played>, EvaluationError> {
        self.local.play(plays)
    }
}
