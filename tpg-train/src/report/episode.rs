//! Episodes of a graph, action by action: what it sees and does, in the problem's units.

use tpg_engine::{ActionSpace, Decision, Environment, Rollout, SourceSet};
use tpg_graph::Graph;
use tpg_graph::interpret::{Answer, Interpreter};
use tpg_picture::{Axis, Colour, Figure, Plot};
use tpg_runtime::ops::Maths;
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// Number of episodes that are drawn.
pub(super) const EPISODES: usize = 3;
/// Number of values of the state that are drawn.
const VALUES: usize = 9;

/// Episodes of a graph.
#[derive(Debug)]
pub(super) struct Watched {
    /// Name and unit of each value that the graph sees.
    values: Vec<(String, String)>,
    answer: AnswerAxis,
    episodes: Vec<Shown>,
}

/// The axis of what a graph does.
#[derive(Debug)]
enum AnswerAxis {
    /// The names of the actions.
    Actions(Vec<String>),
    /// Name and unit of the first output.
    Output(String),
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

/// Watches a graph on tasks. `None` where it has a memory, or the environment has other names than the graph.
pub(super) fn watch<S: Scalar, M: Maths<S>, E: Environment<S>>(
    graph: &Graph,
    environment: &E,
    tasks: &[E::Task],
) -> Option<Watched> {
    let places = places(graph, &environment.sources()).filter(|_| graph.memory() == 0)?;
    let (answer, actions) = match environment.actions() {
        ActionSpace::Discrete(known) => {
            let place = |action: &tpg_graph::Action| known.iter().position(|other| other.name == action.name);
            let actions: Vec<usize> = graph.actions().iter().map(place).collect::<Option<_>>()?;
            (AnswerAxis::Actions(known.into_iter().map(|action| action.name).collect()), actions)
        }
        ActionSpace::Box(outputs) => {
            let output = outputs.first().filter(|_| outputs.len() == graph.outputs().len())?;
            (AnswerAxis::Output(labelled(&output.name, &output.unit)), Vec::new())
        }
    };
    let interpreter = Interpreter::<S, M>::new(graph);
    let episode = |task: &E::Task| {
        let mut rollout = Rollout::new(environment, task);
        let (mut states, mut answers) = (Vec::new(), Vec::new());
        loop {
            let seen = rollout.observe(SourceSet::ALL);
            let state: Vec<S> = places.iter().map(|&place| seen[place]).collect();
            let decision = match interpreter.answer(&state) {
                Answer::Action(ActionId(action)) => {
                    let action = actions.get(usize::from(action)).copied().unwrap_or_default();
                    answers.push(action as f64);
                    Decision::Choice(ActionId(action as u16))
                }
                Answer::Values(values) => {
                    answers.push(values.first().copied().unwrap_or_default());
                    Decision::Values(values.into_iter().map(S::from_f64).collect())
                }
            };
            states.push(state.into_iter().map(S::to_f64).collect());
            if let Some(ending) = rollout.act(decision.act()) {
                let outcome = environment.outcomes().get(usize::from(ending.outcome)).copied().unwrap_or("ended");
                return Shown { outcome, score: ending.score, states, answers };
            }
        }
    };
    let values = graph.inputs().map(|input| {
        let (source, place) = graph.source_of(input);
        let name = if source.ranges.len() == 1 { source.name.clone() } else { format!("{}[{place}]", source.name) };
        (name, source.unit.clone())
    });
    Some(Watched { values: values.collect(), answer, episodes: tasks.iter().map(episode).collect() })
}

/// The place of each value that a graph reads in the environment's flat state.
fn places(graph: &Graph, sources: &[tpg_graph::SourceDocument]) -> Option<Vec<usize>> {
    let mut places = Vec::new();
    for source in graph.sources() {
        let at = sources.iter().position(|other| other.name == source.name)?;
        let first: usize = sources[..at].iter().map(|source| source.length as usize).sum();
        places.extend((0..source.ranges.len()).map(|place| first + place));
    }
    Some(places)
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
    let axis = match &watched.answer {
        AnswerAxis::Actions(names) => Axis::names("action taken", names.clone()),
        AnswerAxis::Output(label) => Axis::linear(label),
    };
    figures.push(draw(axis, "The first test episodes: what the policy does.".to_owned(), &|episode: &Shown| {
        episode.answers.clone()
    }));
    figures
}
