//! The side of rank 0: it hands out jobs and takes answers as they come.

use super::dealer::{Dealer, parts};
use super::link::{Link, Patience};
use super::worker::{Answer, Order, Reply, answers, decode, encode, pack_tasks};
use serde::Serialize;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError, mpsc};
use tpg_engine::{EvaluationError, Evaluator, Piece, Play, Played, UnitKey, UnitResult, Visit, Work, WorkUnit};

/// The workers, as rank 0 sees them.
pub(super) struct Crew<'l, L> {
    link: &'l L,
    /// Threads of each rank.
    threads: Vec<usize>,
    /// Steps of each rank.
    steps: RefCell<Vec<u64>>,
}

/// Tells workers that nothing more comes.
pub(super) fn dismiss(link: &impl Link, ranks: impl IntoIterator<Item = usize>) -> Result<(), EvaluationError> {
    let end = encode(&Order::End)?;
    ranks.into_iter().try_for_each(|rank| link.send(rank, &end))
}

/// The answers to some of the jobs.
type Answers = Result<Vec<Answer>, EvaluationError>;
/// Writes the order by which a rank does some of the jobs.
type Orders<'j> = dyn Fn(usize, &[usize]) -> Result<Order, EvaluationError> + 'j;
/// Does some of the jobs on this rank.
type LocalAnswers<'j> = dyn Fn(&[usize]) -> Answers + Sync + 'j;

/// Jobs for all ranks.
struct Jobs<'j> {
    /// The expected cost of each job, in any unit.
    costs: Vec<u64>,
    order: &'j Orders<'j>,
    local: &'j LocalAnswers<'j>,
}

impl<'l, L: Link> Crew<'l, L> {
    /// Waits until every worker is ready.
    ///
    /// # Errors
    /// If one could not begin, or was started with something else than this rank.
    pub(super) fn gather(link: &'l L, identity: &str, own_threads: usize) -> Result<Self, EvaluationError> {
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
                Reply::Done { .. } => problem = Some(format!("rank {rank}: an answer without a question")),
            }
        }
        let Some(problem) = problem else {
            return Ok(Self { link, steps: RefCell::new(vec![0; threads.len()]), threads });
        };
        dismiss(link, ready)?;
        Err(EvaluationError::new(problem))
    }

    /// Does jobs on all ranks; the answers are in the order of the jobs. Rank 0's threads take their shares themselves;
    /// this thread alone talks to the other ranks.
    ///
    /// # Errors
    /// If a job cannot be done. What is under way is still waited for, so that the workers are ready for the next order.
    fn distribute(&self, jobs: &Jobs<'_>) -> Answers {
        let dealer = Mutex::new(Dealer::new(&jobs.costs, self.threads.iter().sum()));
        let local = jobs.local;
        std::thread::scope(|scope| {
            let (sender, receiver) = mpsc::channel();
            let (dealer, own) = (&dealer, self.threads[0]);
            scope.spawn(move || {
                loop {
                    let share = deal(dealer, own);
                    if share.is_empty() {
                        break;
                    }
                    let answers = local(&share);
                    if sender.send((share, answers)).is_err() {
                        break;
                    }
                }
            });
            let result = self.talk(jobs, dealer, &receiver);
            // Where a rank is lost, nothing more is begun.
            close(dealer);
            result
        })
    }

    /// Hands out jobs and takes answers until nothing is under way on any rank, this one included. After a failure
    /// nothing more is handed out; the first failure is returned.
    fn talk(&self, jobs: &Jobs<'_>, dealer: &Mutex<Dealer>, own: &mpsc::Receiver<(Vec<usize>, Answers)>) -> Answers {
        // The jobs that each rank does at the moment.
        let mut under_way = vec![Vec::new(); self.threads.len()];
        let hand_out = |rank: usize| {
            let share = deal(dealer, self.threads[rank]);
            if !share.is_empty() {
                self.link.send(rank, &encode(&(jobs.order)(rank, &share)?)?)?;
            }
            Ok::<_, EvaluationError>(share)
        };
        for (rank, share) in under_way.iter_mut().enumerate().skip(1) {
            *share = hand_out(rank)?;
        }
        let mut all: Vec<Option<Answer>> = jobs.costs.iter().map(|_| None).collect();
        let (mut failure, mut own_busy, mut patience) = (None, true, Patience::default());
        while own_busy || under_way.iter().any(|share| !share.is_empty()) {
            let mut finished = Vec::new();
            match own.try_recv() {
                Ok(share) => finished.push(share),
                Err(mpsc::TryRecvError::Disconnected) => own_busy = false,
                Err(mpsc::TryRecvError::Empty) => {}
            }
            if let Some((rank, bytes)) = self.link.poll()? {
                // The worker goes on before its answer is looked at.
                let share = std::mem::replace(&mut under_way[rank], hand_out(rank)?);
                finished.push((share, self.answers(rank, &bytes)));
            }
            patience = if finished.is_empty() { patience.wait() } else { Patience::default() };
            for (share, answers) in finished {
                let stored = answers.and_then(|answers| {
                    if answers.len() != share.len() {
                        return Err(EvaluationError::new("a rank answered to another number of jobs"));
                    }
                    share.into_iter().zip(answers).for_each(|(job, answer)| all[job] = Some(answer));
                    Ok(())
                });
                if let Err(error) = stored {
                    close(dealer);
                    failure.get_or_insert(error);
                }
            }
        }
        if let Some(error) = failure {
            return Err(error);
        }
        all.into_iter().collect::<Option<_>>().ok_or_else(|| EvaluationError::new("a job was not handed out"))
    }

    /// Reads a worker's answers.
    fn answers(&self, rank: usize, bytes: &[u8]) -> Answers {
        match decode(bytes)? {
            Reply::Done { answers, steps } => {
                self.steps.borrow_mut()[rank] = steps;
                Ok(answers)
            }
            Reply::Failed(text) => Err(EvaluationError::new(format!("rank {rank}: {text}"))),
            Reply::Ready { .. } => Err(EvaluationError::new(format!("rank {rank}: ready for a second time"))),
        }
    }
}

fn deal(dealer: &Mutex<Dealer>, threads: usize) -> Vec<usize> {
    dealer.lock().unwrap_or_else(PoisonError::into_inner).deal(threads)
}

fn close(dealer: &Mutex<Dealer>) {
    dealer.lock().unwrap_or_else(PoisonError::into_inner).close();
}

/// Returns the units of some pieces, each once, and the pieces with the new indices of units.
fn selected<Task>(work: &Work<Task>, pieces: &[Piece], jobs: &[usize]) -> (Vec<WorkUnit>, Vec<Piece>) {
    let (mut known, mut units) = (BTreeMap::new(), Vec::new());
    let select = |&job: &usize| {
        let Piece { unit, tasks } = pieces[job].clone();
        let unit = *known.entry(unit).or_insert_with(|| {
            units.push(work.units[unit].clone());
            units.len() - 1
        });
        Piece { unit, tasks }
    };
    let pieces = jobs.iter().map(select).collect();
    (units, pieces)
}

/// The evaluator of a run on rank 0.
pub(super) struct Leader<'l, L, V> {
    crew: &'l Crew<'l, L>,
    local: &'l V,
    /// The bytes of the newest tasks, and the ranks that have them.
    tasks: RefCell<(Vec<u8>, Vec<bool>)>,
}

impl<'l, L: Link, V> Leader<'l, L, V> {
    pub(super) fn new(crew: &'l Crew<'l, L>, local: &'l V) -> Self {
        Self { crew, local, tasks: RefCell::new((Vec::new(), vec![false; crew.threads.len()])) }
    }

    /// Answers to pieces of work, in their order, by all ranks.
    fn answers<Task: Clone + Serialize + Sync>(&self, work: &Work<Task>, pieces: &[Piece], observed: bool) -> Answers
    where
        V: Evaluator<Task> + Sync,
    {
        let bytes = pack_tasks(&work.tasks)?;
        if self.tasks.borrow().0 != bytes {
            *self.tasks.borrow_mut() = (bytes, vec![false; self.crew.threads.len()]);
        }
        let order = |rank: usize, jobs: &[usize]| {
            let (tasks, known) = &mut *self.tasks.borrow_mut();
            let tasks = (!std::mem::replace(&mut known[rank], true)).then(|| tasks.clone());
            let (units, pieces) = selected(work, pieces, jobs);
            Ok(Order::Evaluate { tasks, units, pieces, observed })
        };
        let local = self.local;
        let evaluate = |jobs: &[usize]| {
            let pieces: Vec<Piece> = jobs.iter().map(|&job| pieces[job].clone()).collect();
            answers(local, work, &pieces, observed)
        };
        let cost = |piece: &Piece| (work.units[piece.unit].policy.size() * piece.tasks.len()) as u64;
        self.crew.distribute(&Jobs { costs: pieces.iter().map(cost).collect(), order: &order, local: &evaluate })
    }
}

impl<Task, L, V> Evaluator<Task> for Leader<'_, L, V>
where
    Task: Clone + Serialize + Sync,
    L: Link,
    V: Evaluator<Task> + Sync,
{
    fn evaluate(&self, work: &Work<Task>) -> Result<Vec<UnitResult>, EvaluationError> {
        let parts = parts(work.units.len(), self.crew.threads.iter().sum());
        let pieces = Piece::cut(work.units.len(), work.tasks.len(), parts);
        let mut endings = vec![Vec::new(); work.units.len()];
        for (piece, answer) in pieces.iter().zip(self.answers(work, &pieces, false)?) {
            endings[piece.unit].extend(answer.endings);
        }
        Ok(work.units.iter().zip(endings).map(|(unit, endings)| UnitResult { key: unit.key, endings }).collect())
    }

    /// Visits are few: this rank does them alone.
    fn visit(&self, visits: &[Visit<Task>]) -> Result<Vec<Vec<Vec<f64>>>, EvaluationError> {
        self.local.visit(visits)
    }

    fn play(&self, plays: &[Play<Task>]) -> Result<Vec<Played>, EvaluationError> {
        let unit = |(root, play): (u64, &Play<Task>)| {
            let key = UnitKey { seed: 0, generation: 0, root };
            (play.task.clone(), WorkUnit { key, policy: play.policy.clone() })
        };
        let (tasks, units) = (0..).zip(plays).map(unit).unzip();
        let pieces: Vec<Piece> = (0..plays.len()).map(|unit| Piece { unit, tasks: unit..unit + 1 }).collect();
        let answers = self.answers(&Work { tasks, units }, &pieces, true)?.into_iter();
        let played = answers.map(|Answer { endings, seen }| match (&endings[..], seen) {
            (&[ending], Some(seen)) => Ok(Played { ending, seen }),
            _ => Err(EvaluationError::new("another answer than that to an episode")),
        });
        played.collect()
    }

    fn steps(&self) -> u64 {
        self.local.steps() + self.crew.steps.borrow().iter().sum::<u64>()
    }
}
