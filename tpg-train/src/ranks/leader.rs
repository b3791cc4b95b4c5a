//! The side of rank 0: it hands out and takes answers as they come.

use super::dealer::{Dealer, needed, parts};
use super::link::{Link, Patience};
use super::message::{Order, PackedPlay, PackedVisit, Reply, decode, encode, pack_tasks};
use serde::Serialize;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError, mpsc};
use std::time::Instant;
use tpg_engine::{EvaluationError, Evaluator, Piece, Play, Played, UnitResult, Visit, Work, WorkUnit};

/// Bytes and questions of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Traffic {
    /// Questions that were answered by several ranks.
    pub questions: u64,
    /// Bytes sent by rank 0.
    pub out: u64,
    /// Bytes received by rank 0.
    pub back: u64,
}

/// The workers, as rank 0 sees them.
pub(super) struct Crew<'l, L> {
    link: &'l L,
    /// Threads of each rank.
    threads: Vec<usize>,
    traffic: Cell<Traffic>,
}

/// Tells workers that nothing more comes.
pub(super) fn dismiss(link: &impl Link, ranks: &[usize]) -> Result<(), EvaluationError> {
    let end = encode(&Order::End)?;
    ranks.iter().try_for_each(|&rank| link.send(rank, &end))
}

/// The order by which a rank does jobs.
type Ordered<'j> = dyn Fn(usize, &[usize]) -> Result<Vec<u8>, EvaluationError> + 'j;
/// Reads a rank's reply: one result for each job.
type Read<'j, T> = dyn Fn(usize, Reply) -> Result<Vec<T>, EvaluationError> + 'j;
/// Does jobs on this rank.
type Local<'j, T> = dyn Fn(&[usize]) -> Result<Vec<T>, EvaluationError> + Sync + 'j;
/// Takes the result of a job.
type Done<'j, T> = dyn FnMut(usize, T) -> Result<(), EvaluationError> + 'j;

/// Jobs of one kind.
pub(super) struct Jobs<'j, T> {
    /// The expected cost of each job, in any unit.
    pub(super) costs: &'j [u64],
    /// The order by which a rank does jobs.
    pub(super) order: &'j Ordered<'j>,
    /// Reads a rank's reply: one result for each job.
    pub(super) read: &'j Read<'j, T>,
    /// Does jobs on this rank.
    pub(super) local: &'j Local<'j, T>,
    /// Takes the result of a job.
    pub(super) done: &'j mut Done<'j, T>,
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
                    if theirs == identity {
                        continue;
                    }
                    problem = Some(format!("rank {rank} was started with another version, configuration or problem"));
                }
                Reply::Failed(text) => problem = Some(format!("rank {rank}: {text}")),
                _ => problem = Some(format!("rank {rank}: an answer without a question")),
            }
        }
        let crew = Self { link, threads, traffic: Cell::default() };
        match problem {
            Some(problem) => {
                dismiss(link, &ready)?;
                Err(EvaluationError::new(problem))
            }
            None => Ok(crew),
        }
    }

    /// Returns the traffic so far.
    pub(super) fn traffic(&self) -> Traffic {
        self.traffic.get()
    }

    /// Does jobs on all ranks.
    ///
    /// # Errors
    /// If one cannot be done. What is under way is still waited for, so that the workers are ready for the next order.
    pub(super) fn distribute<T: Send>(&self, jobs: Jobs<'_, T>) -> Result<(), EvaluationError> {
        let Jobs { costs, order, read, local, done } = jobs;
        let dealer = Mutex::new(Dealer::new(costs, self.threads.iter().sum()));
        let deal = |rank: usize| dealer.lock().unwrap_or_else(PoisonError::into_inner).deal(self.threads[rank]);
        // Rank 0's threads take their shares themselves; this thread alone talks to the other ranks.
        let own = self.threads[0];
        let own_share = || dealer.lock().unwrap_or_else(PoisonError::into_inner).deal(own);
        std::thread::scope(|scope| {
            let (sender, receiver) = mpsc::channel();
            scope.spawn(move || {
                loop {
                    let share = own_share();
                    if share.is_empty() {
                        break;
                    }
                    let results = local(&share);
                    if sender.send((share, results)).is_err() {
                        break;
                    }
                }
            });
            let mut talk =
                Talk { crew: self, order, read, under_way: vec![Vec::new(); self.threads.len()], waiting: 0 };
            let outcome = talk.until_done(&deal, &receiver, done, || close(&dealer));
            // Where a rank is lost, nothing more is begun.
            close(&dealer);
            outcome
        })
    }
}

fn close(dealer: &Mutex<Dealer>) {
    dealer.lock().unwrap_or_else(PoisonError::into_inner).close();
}

/// Shares and their results, as this rank's threads give them.
type Own<T> = (Vec<usize>, Result<Vec<T>, EvaluationError>);

/// The exchange of rank 0 with the workers over some jobs.
struct Talk<'t, 'l, L, T> {
    crew: &'t Crew<'l, L>,
    order: &'t Ordered<'t>,
    read: &'t Read<'t, T>,
    /// The jobs that each rank is at.
    under_way: Vec<Vec<usize>>,
    /// Number of answers that are still to come.
    waiting: usize,
}

impl<L: Link, T> Talk<'_, '_, L, T> {
    /// Hands out and takes answers until nothing is under way on any rank, this one included. After a failure `close` is
    /// called, so that nothing more is handed out; the first failure is returned.
    fn until_done(
        &mut self,
        deal: &dyn Fn(usize) -> Vec<usize>,
        own: &mpsc::Receiver<Own<T>>,
        done: &mut Done<'_, T>,
        close: impl Fn(),
    ) -> Result<(), EvaluationError> {
        let mut traffic = self.crew.traffic.get();
        traffic.questions += 1;
        self.crew.traffic.set(traffic);
        for rank in 1..self.crew.threads.len() {
            self.send(rank, deal(rank))?;
        }
        let mut failure = None;
        let mut own_busy = true;
        let mut patience = Patience::default();
        while own_busy || self.waiting > 0 {
            let mut finished = Vec::new();
            match own.try_recv() {
                Ok(share) => finished.push(share),
                Err(mpsc::TryRecvError::Disconnected) => own_busy = false,
                Err(mpsc::TryRecvError::Empty) => {}
            }
            if let Some((rank, bytes)) = self.crew.link.poll()? {
                let share = std::mem::take(&mut self.under_way[rank]);
                self.waiting -= 1;
                // The worker goes on before its answer is looked at.
                self.send(rank, deal(rank))?;
                finished.push((share, self.results(rank, &bytes)));
            }
            if finished.is_empty() {
                patience.wait();
            } else {
                patience = Patience::default();
            }
            for (share, results) in finished {
                if let Err(error) = take(share, results, done) {
                    close();
                    failure.get_or_insert(error);
                }
            }
        }
        failure.map_or(Ok(()), Err)
    }

    /// Sends a worker its share, unless it is empty.
    fn send(&mut self, rank: usize, share: Vec<usize>) -> Result<(), EvaluationError> {
        if share.is_empty() {
            return Ok(());
        }
        let bytes = (self.order)(rank, &share)?;
        self.crew.link.send(rank, &bytes)?;
        let mut traffic = self.crew.traffic.get();
        traffic.out += bytes.len() as u64;
        self.crew.traffic.set(traffic);
        self.waiting += 1;
        self.under_way[rank] = share;
        Ok(())
    }

    /// Reads a worker's answer.
    fn results(&self, rank: usize, bytes: &[u8]) -> Result<Vec<T>, EvaluationError> {
        let mut traffic = self.crew.traffic.get();
        traffic.back += bytes.len() as u64;
        self.crew.traffic.set(traffic);
        match decode(bytes)? {
            Reply::Failed(text) => Err(EvaluationError::new(format!("rank {rank}: {text}"))),
            reply => (self.read)(rank, reply),
        }
    }
}

/// Passes the results of a share on.
fn take<T>(
    share: Vec<usize>,
    results: Result<Vec<T>, EvaluationError>,
    done: &mut Done<'_, T>,
) -> Result<(), EvaluationError> {
    let results = results?;
    if results.len() != share.len() {
        return Err(EvaluationError::new("a rank answered to another number of jobs"));
    }
    share.into_iter().zip(results).try_for_each(|(job, result)| done(job, result))
}

/// Returns the units of some pieces, each once, and the pieces with the new indices of units, and of tasks where only some of
/// these are sent.
fn selected<Task>(work: &Work<Task>, share: &[&Piece], tasks: Option<&[usize]>) -> (Vec<WorkUnit>, Vec<Piece>) {
    let (mut known, mut units) = (BTreeMap::new(), Vec::new());
    let pieces = share.iter().map(|piece| {
        let unit = *known.entry(piece.unit).or_insert_with(|| {
            units.push(work.units[piece.unit].clone());
            units.len() - 1
        });
        let from = tasks.map_or(piece.tasks.start, |tasks| tasks.partition_point(|&task| task < piece.tasks.start));
        Piece { unit, tasks: from..from + piece.tasks.len() }
    });
    let pieces = pieces.collect();
    (units, pieces)
}

/// The evaluator of a run on rank 0.
pub(super) struct Leader<'l, L, V> {
    crew: &'l Crew<'l, L>,
    local: &'l V,
    /// The bytes of the newest tasks, and their number.
    tasks: RefCell<(Vec<u8>, u64)>,
    /// The number of the tasks that each rank has; 0 for none.
    known: RefCell<Vec<u64>>,
    /// Steps of each worker.
    steps: RefCell<Vec<u64>>,
    /// Seconds that a thread of this rank has lately taken for a unit of expected cost.
    pace: Mutex<Option<f64>>,
}

impl<'l, L: Link, V> Leader<'l, L, V> {
    pub(super) fn new(crew: &'l Crew<'l, L>, local: &'l V) -> Self {
        let ranks = crew.threads.len();
        let (known, steps) = (RefCell::new(vec![0; ranks]), RefCell::new(vec![0; ranks]));
        Self { crew, local, tasks: RefCell::new((Vec::new(), 0)), known, steps, pace: Mutex::new(None) }
    }

    fn pace(&self) -> Option<f64> {
        *self.pace.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Does jobs on all ranks; the results are in the order of the jobs.
    fn all<T: Send>(
        &self,
        costs: &[u64],
        order: &Ordered<'_>,
        read: &Read<'_, T>,
        local: &Local<'_, T>,
    ) -> Result<Vec<T>, EvaluationError> {
        let mut results: Vec<Option<T>> = costs.iter().map(|_| None).collect();
        let mut done = |job: usize, result: T| {
            results[job] = Some(result);
            Ok(())
        };
        self.crew.distribute(Jobs { costs, order, read, local, done: &mut done })?;
        let all: Option<Vec<T>> = results.into_iter().collect();
        all.ok_or_else(|| EvaluationError::new("a job was not handed out"))
    }
}

impl<Task, L, V> Evaluator<Task> for Leader<'_, L, V>
where
    Task: Clone + Serialize + Sync,
    L: Link,
    V: Evaluator<Task> + Sync,
{
    fn evaluate(&self, work: &Work<Task>) -> Result<Vec<UnitResult>, EvaluationError> {
        if self.crew.threads.len() == 1 {
            return self.local.evaluate(work);
        }
        let bytes = pack_tasks(&work.tasks)?;
        let number = {
            let mut tasks = self.tasks.borrow_mut();
            if tasks.1 == 0 || tasks.0 != bytes {
                *tasks = (bytes, tasks.1 + 1);
            }
            tasks.1
        };
        let cost = |piece: &Piece| (work.units[piece.unit].policy.size() * piece.tasks.len()) as u64;
        let pieces = {
            let whole = Piece::cut(work.units.len(), work.tasks.len(), 1);
            let seconds = self.pace().map(|pace| pace * whole.iter().map(cost).sum::<u64>() as f64);
            let threads = self.crew.threads.iter().sum();
            Piece::cut(work.units.len(), work.tasks.len(), parts(work.units.len(), threads, seconds))
        };
        let order = |rank: usize, jobs: &[usize]| {
            let share: Vec<&Piece> = jobs.iter().map(|&job| &pieces[job]).collect();
            let known = &mut self.known.borrow_mut()[rank];
            let wanted = if *known == number { None } else { needed(&share, work.tasks.len()) };
            let tasks = match &wanted {
                Some(wanted) => {
                    *known = 0;
                    Some(pack_tasks(&wanted.iter().map(|&task| &work.tasks[task]).collect::<Vec<_>>())?)
                }
                None => (std::mem::replace(known, number) != number).then(|| self.tasks.borrow().0.clone()),
            };
            let (units, pieces) = selected(work, &share, wanted.as_deref());
            encode(&Order::Evaluate { tasks, units, pieces })
        };
        let read = |rank: usize, reply: Reply| match reply {
            Reply::Evaluated { endings, steps } => {
                self.steps.borrow_mut()[rank] = steps;
                Ok(endings)
            }
            _ => Err(EvaluationError::new(format!("rank {rank}: another answer than endings"))),
        };
        let (local, pace, threads) = (self.local, &self.pace, self.crew.threads[0]);
        let evaluate = |jobs: &[usize]| {
            let pieces: Vec<Piece> = jobs.iter().map(|&job| pieces[job].clone()).collect();
            let began = Instant::now();
            let endings = local.pieces(work, &pieces)?;
            let busy = began.elapsed().as_secs_f64() * threads.min(pieces.len()) as f64;
            let seconds = busy / pieces.iter().map(cost).sum::<u64>().max(1) as f64;
            *pace.lock().unwrap_or_else(PoisonError::into_inner) = Some(seconds);
            Ok(endings)
        };
        let costs: Vec<u64> = pieces.iter().map(cost).collect();
        let mut endings = vec![Vec::new(); work.units.len()];
        for (piece, part) in pieces.iter().zip(self.all(&costs, &order, &read, &evaluate)?) {
            endings[piece.unit].extend(part);
        }
        Ok(work.units.iter().zip(endings).map(|(unit, endings)| UnitResult { key: unit.key, endings }).collect())
    }

    fn visit(&self, visits: &[Visit<Task>]) -> Result<Vec<Vec<Vec<f64>>>, EvaluationError> {
        if self.crew.threads.len() == 1 {
            return self.local.visit(visits);
        }
        let part = |jobs: &[usize]| jobs.iter().map(|&job| visits[job].clone()).collect::<Vec<_>>();
        let order = |_: usize, jobs: &[usize]| {
            let packed: Result<Vec<_>, _> = jobs.iter().map(|&job| PackedVisit::of(&visits[job])).collect();
            encode(&Order::Visit(packed?))
        };
        let read = |rank: usize, reply: Reply| match reply {
            Reply::Visited(states) => Ok(states),
            _ => Err(EvaluationError::new(format!("rank {rank}: another answer than states"))),
        };
        let local = self.local;
        let visit = |jobs: &[usize]| local.visit(&part(jobs));
        self.all(&vec![1; visits.len()], &order, &read, &visit)
    }

    fn play(&self, plays: &[Play<Task>]) -> Result<Vec<Played>, EvaluationError> {
        if self.crew.threads.len() == 1 {
            return self.local.play(plays);
        }
        let part = |jobs: &[usize]| jobs.iter().map(|&job| plays[job].clone()).collect::<Vec<_>>();
        let order = |_: usize, jobs: &[usize]| {
            let packed: Result<Vec<_>, _> = jobs.iter().map(|&job| PackedPlay::of(&plays[job])).collect();
            encode(&Order::Play(packed?))
        };
        let read = |rank: usize, reply: Reply| match reply {
            Reply::Played { played, steps } => {
                self.steps.borrow_mut()[rank] = steps;
                Ok(played)
            }
            _ => Err(EvaluationError::new(format!("rank {rank}: another answer than results of episodes"))),
        };
        let local = self.local;
        let play = |jobs: &[usize]| local.play(&part(jobs));
        let costs: Vec<u64> = plays.iter().map(|play| play.policy.size() as u64).collect();
        self.all(&costs, &order, &read, &play)
    }

    fn steps(&self) -> u64 {
        self.local.steps() + self.steps.borrow().iter().sum::<u64>()
    }
}
