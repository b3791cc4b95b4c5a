//! Episodes of a graph, action by action: what it sees and does, in the problem's units.

use tpg_engine::{ActionSpace, Decision, EngineOptions, Environment, Plan, Rollout, Single, SourceSet, bind};
use tpg_graph::Graph;
use tpg_picture::{Axis, Colour, Figure, Plot};
use tpg_runtime::ops::Maths;
use tpg_runtime::scalar::Scalar;

/// Number of episodes that are drawn.
pub(super) const EPISODES: usize = 3;
/// Number of values of the state that are drawn.
const VALUES: usize = 9;

/// Episodes of a graph.
#[derive(Debug)]
pub(super) struct Watched {
    /// Each value that the graph can see, with its unit.
    values: Vec<(String, String)>,
    /// The axis of what it does: the names of the actions, or the first output.
    answer: Axis,
    episodes: Vec<Shown>,
}

/// An episode.
#[derive(Debug)]
struct Shown {
    outcome: &'static str,
    score: f64,
    /// The state before each action.
    states: Vec<Vec<f64>>,
    /// The number of each action, or the first output.
    answers: Vec<f64>,
}

/// Watches a graph on tasks. `None` where it has a memory, or the environment is none for it.
pub(super) fn watch<S: Scalar, M: Maths<S>, E: Environment<S>>(
    (file, graph): &(String, Graph),
    environment: &E,
    tasks: &[E::Task],
) -> Option<Watched> {
    let policy = bind(file, graph, environment).ok().filter(|_| graph.memory() == 0)?;
    let sources = environment.sources();
    let answer = match environment.actions() {
        ActionSpace::Discrete(known) => {
            Axis::names("action taken", known.into_iter().map(|action| action.name).collect())
        }
        ActionSpace::Box(outputs) => outputs.first().map(|it| Axis::linear(&labelled(&it.name, &it.unit)))?,
    };
    let single = Single::<S, M>::new(Plan::new::<M>(&policy, &sources, EngineOptions::default()));
    let episode = |task: &E::Task| {
        let mut rollout = Rollout::new(environment, task);
        let (mut states, mut answers) = (Vec::new(), Vec::new());
        loop {
            let state = rollout.observe(SourceSet::ALL);
            let decision: Decision<S> = single.answer(state).into();
            states.push(state.iter().map(|value| value.to_f64()).collect());
            answers.push(match &decision {
                Decision::Choice(action) => action.0.into(),
                Decision::Values(values) => values[0].to_f64(),
            });
            if let Some(ending) = rollout.act(decision.act()) {
                let outcome = environment.outcomes().get(usize::from(ending.outcome)).copied().unwrap_or("ended");
                return Shown { outcome, score: ending.score, states, answers };
            }
        }
    };
    let values = sources.iter().flat_map(|source| {
        let name = |place| if source.length == 1 { source.name.clone() } else { format!("{}[{place}]", source.name) };
        (0..source.length).map(move |place| (name(place), source.unit.clone()))
    });
    Some(Watched { values: values.collect(), answer, episodes: tasks.iter().map(episode).collect() })
}

fn labelled(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name}, {unit}") }
}

/// Draws each value that the graph sees, and what it does, over the actions of the first episodes.
pub(super) fn figures(watched: &Watched) -> Vec<Figure> {
    let longest = watched.episodes.iter().map(|episode| episode.answers.len()).max().unwrap_or(1);
    let x = || Axis::linear("action").between(0.0, longest as f64);
    let draw = |y: Axis, caption: String, values: &dyn Fn(&Shown) -> Vec<f64>| {
        let mut plot = Plot::new(x(), y);
        for (place, episode) in watched.episodes.iter().enumerate() {
            let points: Vec<[f64; 2]> = (0..).map(f64::from).zip(values(episode)).map(|(x, y)| [x, y]).collect();
            plot.line(Colour(place), points);
            plot.name(Colour(place), &format!("episode {place}: {}, return {:.1}", episode.outcome, episode.score));
        }
        Figure { svg: plot.svg(&caption), caption, ..Figure::default() }
    };
    let values = watched.values.iter().enumerate().take(VALUES).map(|(place, (name, unit))| {
        let caption = format!("The first test episodes: {name} before each action.");
        draw(Axis::linear(&labelled(name, unit)), caption, &move |episode: &Shown| {
            episode.states.iter().map(|state| state[place]).collect()
        })
    });
    let mut figures: Vec<Figure> = values.collect();
    figures.push(draw(
        watched.answer.clone(),
        "The first test episodes: what the policy does.".to_owned(),
        &|episode: &Shown| episode.answers.clone(),
    ));
    figures
}
