//! The side of a rank that evaluates for rank 0.

use super::link::Link;
use super::message::{Order, PackedPlay, PackedVisit, Reply, decode, encode, unpack_tasks};
use serde::de::DeserializeOwned;
use tpg_engine::{EvaluationError, Evaluator, Work};

/// Answers to rank 0's orders until there are no more.
pub(super) fn serve(
    link: &impl Link,
    ready: &Reply,
    mut answer: impl FnMut(Order) -> Result<Reply, EvaluationError>,
) -> Result<(), EvaluationError> {
    link.send(0, &encode(ready)?)?;
    loop {
        let reply = match decode(&link.receive()?.1) {
            Ok(Order::End) => return Ok(()),
            Ok(order) => answer(order),
            Err(error) => Err(error),
        };
        let reply = reply.unwrap_or_else(|error| Reply::Failed(error.into_inner().to_string()));
        link.send(0, &encode(&reply)?)?;
    }
}

/// The roots' evaluator on a worker: it keeps the tasks between orders.
pub(super) struct Roots<'a, Task, V> {
    local: &'a V,
    work: Work<Task>,
}

impl<'a, Task: Clone + DeserializeOwned, V: Evaluator<Task>> Roots<'a, Task, V> {
    pub(super) fn new(local: &'a V) -> Self {
        Self { local, work: Work { tasks: Vec::new(), units: Vec::new() } }
    }

    /// Answers an order.
    pub(super) fn answer(&mut self, order: Order) -> Result<Reply, EvaluationError> {
        match order {
            Order::Evaluate { tasks, units, pieces } => {
                if let Some(tasks) = tasks {
                    self.work.tasks = unpack_tasks(&tasks)?;
                }
                self.work.units = units;
                let endings = self.local.pieces(&self.work, &pieces)?;
                Ok(Reply::Evaluated { endings, steps: self.local.steps() })
            }
            Order::Visit(visits) => {
                let visits: Result<Vec<_>, _> = visits.into_iter().map(PackedVisit::unpack).collect();
                Ok(Reply::Visited(self.local.visit(&visits?)?))
            }
            Order::Play(plays) => {
                let plays: Result<Vec<_>, _> = plays.into_iter().map(PackedPlay::unpack).collect();
                let played = self.local.play(&plays?)?;
                Ok(Reply::Played { played, steps: self.local.steps() })
            }
            Order::Cells(_) | Order::End => Err(EvaluationError::new("an order of a study")),
        }
    }
}
