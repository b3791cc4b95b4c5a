//! The side of rank 0: it hands out jobs and takes answers as they come.

use super::dealer::{Dealer, parts};
use super::link::{Backoff, Link};
use super::worker::{Order, Reply, decode, encode, pack_tasks};
use serde::Serialize;
use std::cell::RefCell;
use std::sync::{Mutex, PoisonError, mpsc};
use tpg_engine::{EpisodeResult, EvaluationError, Evaluator, Piece, Play, Played, Work};

/// Tells workers that nothing more comes.
pub(super) fn dismiss(link: &impl Link, ranks: impl IntoIterator<Item = usize>) -> Result<(), EvaluationError> {
    let end = encode(&Order::End)?;
    ranks.into_iter().try_for_each(|rank| link.send(rank, &end))
}

/// Waits until every worker is ready; returns the number of threads of each rank.
///
/// # Errors
/// If one could not begin, or was started with something else than this rank.
pub(super) fn gather(link: &impl Link, identity: &str, own_threads: usize) -> Result<Vec<usize>, EvaluationError> {
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

/// Pieces of work for all ranks, and the places of those that are left.
struct Question<'w, Task> {
    work: &'w Work<Task>,
    pieces: &'w [Piece],
    left: Mutex<Dealer>,
}

impl<Task> Question<'_, Task> {
    fn deal(&self, threads: usize) -> Option<Vec<usize>> {
        let share = self.left.lock().unwrap_or_else(PoisonError::into_inner).deal(threads);
        (!share.is_empty()).then_some(share)
    }

    fn close(&self) {
        self.left.lock().unwrap_or_else(PoisonError::into_inner).close();
    }
}

/// The evaluator of a run on rank 0.
pub(super) struct Leader<'l, L, Task> {
    link: &'l L,
    local: &'l (dyn Evaluator<Task> + Sync),
    /// Threads of each rank.
    threads: Vec<usize>,
    /// The bytes of the newest tasks, and the ranks that have them.
    tasks: RefCell<(Vec<u8>, Vec<bool>)>,
}

impl<'l, L: Link, Task: Clone + Serialize + Sync> Leader<'l, L, Task> {
    pub(super) fn new(link: &'l L, local: &'l (dyn Evaluator<Task> + Sync), threads: Vec<usize>) -> Self {
        let known = vec![false; threads.len()];
        Self { link, local, threads, tasks: RefCell::new((Vec::new(), known)) }
    }

    /// Answers to pieces of work, in their order, by all ranks. Rank 0's threads take their shares themselves; this thread alone
    /// talks to the other ranks.
    ///
    /// # Errors
    /// If a job cannot be done. What is under way is still waited for, so that the workers are ready for the next order.
    fn answers(&self, work: &Work<Task>, pieces: &[Piece]) -> Answers {
        let bytes = pack_tasks(&work.tasks)?;
        if self.tasks.borrow().0 != bytes {
            *self.tasks.borrow_mut() = (bytes, vec![false; self.threads.len()]);
        }
        let cost = |piece: &Piece| (work.policies[piece.policy].size() * piece.tasks.len()) as u64;
        let costs: Vec<u64> = pieces.iter().map(cost).collect();
        let left = Mutex::new(Dealer::new(&costs, self.threads.iter().sum()));
        let question = &Question { work, pieces, left };
        std::thread::scope(|scope| {
            let (sender, receiver) = mpsc::channel();
            let (local, own) = (self.local, self.threads[0]);
            scope.spawn(move || {
                while let Some(share) = question.deal(own) {
                    let pieces: Vec<Piece> = share.iter().map(|&job| pieces[job].clone()).collect();
                    if sender.send((share, local.pieces(work, &pieces))).is_err() {
                        break;
                    }
                }
            });
            let result = self.talk(question, &receiver);
            // Where a rank is lost, nothing more is begun.
            question.close();
            result
        })
    }

    /// Orders a rank to do a share of what is left.
    fn hand_out(&self, question: &Question<'_, Task>, rank: usize) -> Result<Option<Vec<usize>>, EvaluationError> {
        let Some(share) = question.deal(self.threads[rank]) else { return Ok(None) };
        let (tasks, known) = &mut *self.tasks.borrow_mut();
        let tasks = (!std::mem::replace(&mut known[rank], true)).then(|| tasks.clone());
        let job = |&job: &usize| {
            let Piece { policy, tasks } = question.pieces[job].clone();
            (question.work.policies[policy].clone(), tasks)
        };
        let jobs = share.iter().map(job).collect();
        self.link.send(rank, &encode(&Order::Evaluate { tasks, jobs })?)?;
        Ok(Some(share))
    }

    /// Hands out jobs and takes answers until nothing is under way on any rank, this one included. After a failure
    /// nothing more is handed out; the first failure is returned.
    fn talk(&self, question: &Question<'_, Task>, own: &mpsc::Receiver<(Vec<usize>, Answers)>) -> Answers {
        // The jobs that each rank does at the moment.
        let mut under_way = vec![None; self.threads.len()];
        for (rank, share) in under_way.iter_mut().enumerate().skip(1) {
            *share = self.hand_out(question, rank)?;
        }
        let mut all: Vec<Option<Vec<EpisodeResult>>> = vec![None; question.pieces.len()];
        let (mut failure, mut own_busy, mut patience) = (None, true, Backoff::default());
        while own_busy || under_way.iter().any(Option::is_some) {
            let mut finished = Vec::new();
            match own.try_recv() {
                Ok(share) => finished.push(share),
                Err(mpsc::TryRecvError::Disconnected) => own_busy = false,
                Err(mpsc::TryRecvError::Empty) => {}
            }
            if let Some((rank, bytes)) = self.link.poll()? {
                // The worker goes on before its answer is looked at.
                let share = std::mem::replace(&mut under_way[rank], self.hand_out(question, rank)?);
                finished.push((share.unwrap_or_default(), Self::read(rank, &bytes)));
            }
            patience = if finished.is_empty() { patience.wait() } else { Backoff::default() };
            for (share, answers) in finished {
                match answers {
                    Ok(answers) if answers.len() == share.len() => {
                        share.into_iter().zip(answers).for_each(|(job, answer)| all[job] = Some(answer));
                    }
                    answers => {
                        let other = || EvaluationError::new("a rank answered to another number of jobs");
                        question.close();
                        failure.get_or_insert(answers.err().unwrap_or_else(other));
                    }
                }
            }
        }
        if let Some(error) = failure {
            return Err(error);
        }
        all.into_iter().collect::<Option<_>>().ok_or_else(|| EvaluationError::new("a job was not handed out"))
    }

    /// Reads a worker's answers.
    fn read(rank: usize, bytes: &[u8]) -> Answers {
        match decode(bytes)? {
            Reply::Done(answers) => Ok(answers),
            Reply::Failed(text) => Err(EvaluationError::new(format!("rank {rank}: {text}"))),
            Reply::Ready { .. } => Err(EvaluationError::new(format!("rank {rank}: ready for a second time"))),
        }
    }
}

impl<Task: Clone + Serialize + Sync, L: Link> Evaluator<Task> for Leader<'_, L, Task> {
    fn evaluate(&self, work: &Work<Task>) -> Result<Vec<Vec<EpisodeResult>>, EvaluationError> {
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
