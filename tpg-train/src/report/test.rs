//! Tests of runs: the trained policy on the test episodes.

use super::runs::Run;
use crate::hybrid::rollout::{Policies, moments};
use crate::hybrid::shared::{Episodes, Shared, opened};
use crate::sac::network::Network;
use tpg_engine::{EpisodeResult, Measure, Rollout, Summary, TaskSet};
use tpg_graph::error::InputError;
use tpg_graph::{Graph, in_arithmetic_of};
use tpg_picture::Figure;
use tpg_problems::{Number, Problem};
use tpg_runtime::ops::Maths;

/// Number of episodes to draw: the first successful and the first failed ones.
const KEPT: [usize; 2] = [3, 3];

/// Result of a run on the test episodes.
#[derive(Debug)]
pub(super) struct Tested {
    /// The episodes.
    pub(super) endings: Vec<EpisodeResult>,
    /// Quantity reported in addition to the score, if the problem has one.
    pub(super) measure: Option<Measure>,
    /// Some episodes as the problem draws them.
    pub(super) pictures: Vec<Figure>,
}

impl Tested {
    /// Returns the means.
    pub(super) fn summary(&self) -> Summary {
        Summary::new(&self.endings)
    }

    /// Returns the measure of each episode.
    pub(super) fn measures(&self) -> Vec<f64> {
        self.endings.iter().map(|ending| ending.measure).collect()
    }
}

/// Tests a run; `None` if its environment is not available, and the program that has it did not test the run.
pub(super) fn test(run: &Run, count: usize, seed: u64, own: Option<&dyn Shared>) -> Result<Option<Tested>, InputError> {
    let built_in = run.problem.as_ref();
    let Some(problem) = built_in.map(|problem| problem as &dyn Shared).or(own) else {
        let tested = |endings| Tested { endings, measure: None, pictures: Vec::new() };
        return Ok(run.tested.as_ref().map(|one| tested(one.episodes.clone())));
    };
    let episodes = Episodes { set: TaskSet::Test, count, seed, file: None };
    let endings = problem.play(run.policies.acting(), episodes)?.endings;
    let pictures = match (&run.policies, built_in) {
        (Policies::Graph(graph), Some(problem)) => {
            in_arithmetic_of!(graph.1, graph_shown(problem, graph, episodes, &endings))?
        }
        (Policies::Network((_, network)), Some(problem)) => network_shown(problem, network, episodes, &endings)?,
        _ => Vec::new(),
    };
    Ok(Some(Tested { endings, measure: problem.facts().measure, pictures }))
}

/// Shows some episodes of a graph, where the problem draws them.
fn graph_shown<S: Number, M: Maths<S>>(
    problem: &Problem,
    graph: &(String, Graph),
    episodes: Episodes<'_>,
    endings: &[EpisodeResult],
) -> Result<Vec<Figure>, InputError> {
    let tasks = episodes.in_problem(problem)?;
    opened::<S, _>(problem, &graph.1, |choices| {
        shown(problem, endings, |place| {
            let mut moments = moments::<S, M, _>(choices, graph, &tasks[place])?;
            // The engine detects a cycle late; the episode ended at its first repeat.
            moments.truncate(endings[place].actions as usize + 1);
            Ok(moments)
        })
    })
}

/// Shows some episodes of a network, where the problem draws them.
fn network_shown(
    problem: &Problem,
    network: &Network,
    episodes: Episodes<'_>,
    endings: &[EpisodeResult],
) -> Result<Vec<Figure>, InputError> {
    let environment = problem.network_environment(0);
    let tasks = tpg_engine::tasks(&*environment, episodes.set, episodes.seed, episodes.count);
    let decide = network.deciding();
    shown(problem, endings, |place| {
        let mut moments = Vec::new();
        let rollout = Rollout::new(&*environment, &tasks[place]);
        rollout.watch(&decide, |episode| moments.push(environment.moment(episode)));
        Ok(moments)
    })
}

/// Draws the first successful and the first failed episodes, where the problem draws them; `moments` returns those of an episode.
fn shown(
    problem: &Problem,
    endings: &[EpisodeResult],
    moments: impl Fn(usize) -> Result<Vec<Vec<f64>>, InputError>,
) -> Result<Vec<Figure>, InputError> {
    let mut figures = Vec::new();
    for place in chosen(endings) {
        figures.extend(problem.picture(&moments(place)?).map(|svg| figure(problem, place, &endings[place], svg)));
    }
    Ok(figures)
}

/// Returns the indices of the episodes to draw.
fn chosen(endings: &[EpisodeResult]) -> Vec<usize> {
    let kept = |success: bool, count: usize| {
        (0..endings.len()).filter(move |&place| endings[place].success == Some(success)).take(count)
    };
    kept(true, KEPT[0]).chain(kept(false, KEPT[1])).collect()
}

fn figure(problem: &dyn Shared, number: usize, ending: &EpisodeResult, svg: String) -> Figure {
    let facts = problem.facts();
    let outcome = facts.outcomes.get(usize::from(ending.outcome)).copied().unwrap_or("ended");
    let measure = facts
        .measure
        .map(|measured| format!(", {} {:.1} {}", measured.name, ending.measure, measured.unit))
        .unwrap_or_default();
    let caption = format!("Episode {number}: {outcome} after {} actions{measure}.", ending.actions);
    Figure { svg, caption, ..Figure::default() }
}
