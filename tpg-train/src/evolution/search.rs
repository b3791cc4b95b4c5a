//! Searches for the weights of [linear programs](super::linear). Mutations of single lines hardly ever find six weights that only help
//! together; these do.

use super::cma::Cma;
use super::linear::{LinearWriter, ProgramKind};
use super::normalise::unfolded;
use super::random_search::RandomSearch;
use super::record::{Record, Row};
use super::stage::{Candidate, Context, EpisodePlan, Moment, Results, Stage};
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;
use tpg_engine::random::Purpose;
use tpg_engine::{EpisodeResult, Moments, PolicyGraph, Summary};
use tpg_graph::error::Finding;

/// Number of generations whose median is a search's score.
const NEWEST: usize = 9;
/// The part of the samples that counts in a generation's score, the best ones: one that is unstable may lose a million.
const COUNTED: f64 = 0.75;
/// Standard deviation of a wide search's first samples: 1 is a whole output for a whole input.
const FIRST_DEVIATION: f64 = 0.5;
/// Number of weights from which on a local search for outputs adapts their variances where first policies fall although they earn:
/// small steps would learn to stand still. Its first outputs deviate so much that its policies move at once.
const MANY_WEIGHTS: usize = 30;
const FIRST_OUTPUTS: f64 = 0.8;
/// Price of an action, as a part of what policies earn by lasting.
const PRICE: f64 = 0.99;
/// Score of a policy that moves, as a multiple of the score of standing still.
const MOVING: f64 = 1.5;
/// Samples of a generation of a wide search, in Hansen's numbers of them.
const BREADTH: usize = 2;
/// Default length of a search: generations for each weight, and their minimum.
const GENERATIONS_PER_WEIGHT: u64 = 3;
const MIN_GENERATIONS: u64 = 20;
/// One search for weights.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Search {
    /// The form of the programs.
    pub kind: ProgramKind,
    /// The method.
    method: Method,
    /// For a local search, the mean and spread of the inputs that its samples have seen: its weights are of normalised inputs.
    seen: Option<Moments>,
    /// True if the last action of an episode costs its samples nothing: a fall that costs more than all else teaches to stand still.
    forgives: bool,
    /// The toll of its samples, and that of the next local search.
    toll: Option<Toll>,
    next_toll: Option<Toll>,
    /// Actions of its samples, and their best score.
    actions: f64,
    best: f64,
    /// The newest generations' scores.
    scores: VecDeque<f64>,
    /// The samples that are being evaluated.
    #[serde(skip)]
    samples: Vec<Vec<f64>>,
}

/// The price of lasting: where standing still until the time limit is rewarded, samples are ranked with it, so that only what moves is
/// better.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Toll {
    /// Price of an action.
    price: f64,
    /// Score of what stands still.
    score: f64,
    /// Actions after which a search begins again that has no sample of a higher score: those that found what stands still.
    actions: f64,
}

/// Method of a search for weights.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Method {
    /// Adaptation of variances.
    Cma(Cma),
    /// Random search.
    Random(RandomSearch),
}

impl Search {
    /// Begins the search that follows `before` others, the newest of which is `last`: a local one if there is one, then wide ones, of
    /// sums and, where programs can be that, products in turns. A run that is for local search alone has sums only.
    pub(super) fn begin(context: &Context<'_>, before: u64, last: Option<&Self>) -> Result<Self, Finding> {
        let random = context.config.start.random;
        let has_random = random > 0.0;
        let others = before.saturating_sub(has_random.into());
        let is_product =
            others % 2 == 1 && random < 1.0 && context.writer(ProgramKind::Product).is_ok_and(|it| context.fits(&it));
        let kind = if is_product { ProgramKind::Product } else { ProgramKind::Sum };
        let writer = context.writer(kind)?;
        let is_local = has_random && before == 0;
        let (rows, inputs) = (writer.rows(), writer.units().len());
        let last = last.filter(|last| is_local && (last.next_toll.is_some() || last.forgives));
        let toll = last.and_then(|last| last.next_toll);
        let method = match (is_local, last) {
            (false, _) => Method::Cma(Cma::new(writer.weights(), FIRST_DEVIATION)),
            (true, None) => Method::Random(RandomSearch::new(rows, inputs)),
            (true, Some(_)) => Self::moving(rows * inputs, inputs),
        };
        Ok(Self {
            kind,
            method,
            seen: last.map_or_else(|| is_local.then(|| Moments::new(inputs)), |last| last.seen.clone()),
            forgives: last.is_some_and(|last| last.forgives),
            toll,
            next_toll: toll,
            actions: 0.0,
            best: f64::MIN,
            scores: VecDeque::new(),
            samples: Vec::new(),
        })
    }

    /// True for a local search.
    pub(super) fn is_local(&self) -> bool {
        self.seen.is_some()
    }

    /// Returns the search for weights whose first policies move.
    fn moving(weights: usize, inputs: usize) -> Method {
        Method::Cma(Cma::new(weights, FIRST_OUTPUTS / (inputs as f64).sqrt()))
    }

    /// True if its samples are kept from learning to stand still: they pay a toll, or their falls cost nothing.
    pub(super) fn discourages_standing(&self) -> bool {
        self.toll.is_some() || self.forgives
    }

    /// True if another one should begin: it has learned to stand still, or has found nothing better.
    pub(super) fn should_restart(&self) -> bool {
        self.next_toll != self.toll
            || self.toll.is_some_and(|toll| self.actions >= toll.actions && self.best <= toll.score)
    }

    /// True if it should go on, although it stalled before the `last` one began: that one has found nothing better.
    pub(super) fn resumes(&self, last: Option<&Self>) -> bool {
        self.is_local() && !self.should_restart() && last.is_some_and(|last| self.score() > last.score())
    }

    /// Returns the default number of generations.
    pub(super) fn length(&self, context: &Context<'_>) -> Result<u64, Finding> {
        Ok((GENERATIONS_PER_WEIGHT * context.writer(self.kind)?.weights() as u64).max(MIN_GENERATIONS))
    }

    /// Returns the weights in the middle of the samples, which are better than these.
    pub(super) fn weights(&self, writer: &LinearWriter<'_>) -> Vec<f64> {
        let mean = match &self.method {
            Method::Cma(cma) => cma.mean(),
            Method::Random(search) => search.mean(),
        };
        self.written(mean, writer)
    }

    /// Returns a sample's weights as they are written.
    fn written(&self, sample: &[f64], writer: &LinearWriter<'_>) -> Vec<f64> {
        match &self.seen {
            Some(seen) => writer.weights_of_rows(&unfolded(sample, seen, &writer.units())),
            None => sample.to_vec(),
        }
    }

    /// Returns the policy in the middle of the samples.
    pub(super) fn best(&self, context: &Context<'_>) -> Option<PolicyGraph> {
        let writer = context.writer(self.kind).ok()?;
        Some(writer.policy(&self.weights(&writer)))
    }

    /// Moves the distribution of the samples.
    fn learn(&mut self, context: &Context<'_>, samples: &[Vec<f64>], results: &[Summary]) {
        let order = ranking(results, self.toll.map_or(0.0, |toll| toll.price));
        self.actions += results.iter().map(|result| result.actions * result.episodes as f64).sum::<f64>();
        self.best = results.iter().map(|result| result.score).fold(self.best, f64::max);
        match &mut self.method {
            Method::Random(search) => {
                let scores: Vec<f64> = results.iter().map(|result| result.score).collect();
                search.update(samples, &scores, context.left);
            }
            Method::Cma(cma) => cma.update(&order.iter().map(|&place| samples[place].clone()).collect::<Vec<_>>()),
        }
        let Some(seen) = &self.seen else { return };
        let limit = f64::from(context.time_limit);
        let (lasting, falling): (Vec<&Summary>, Vec<&Summary>) =
            results.iter().partition(|result| result.actions >= limit);
        match &self.method {
            Method::Random(search) => {
                let weights = search.mean().len();
                let earns = results[order[order.len() / 2]].score > 0.0 && !falling.is_empty();
                if self.scores.len() == 1 && (self.forgives || earns && self.has_many_weights(context)) {
                    self.method = Self::moving(weights, seen.length());
                }
            }
            Method::Cma(_) if lasting.len() >= falling.len() && !self.forgives => {
                self.charge(&lasting, &falling, limit);
            }
            Method::Cma(_) => {}
        }
    }

    /// True if small steps would learn to stand still.
    fn has_many_weights(&self, context: &Context<'_>) -> bool {
        context.actions == 0 && matches!(&self.method, Method::Random(search) if search.mean().len() >= MANY_WEIGHTS)
    }

    /// True if a quarter of the samples or more lose by the last action of an episode more than by all others.
    fn loses_by_falling(&self, context: &Context<'_>, results: &Results) -> bool {
        let falls = |ending: &EpisodeResult| {
            ending.actions < context.time_limit && ending.score < 0.0 && ending.final_reward < 0.5 * ending.score
        };
        let falling = results.endings.iter().filter(|endings| endings.iter().all(falls)).count();
        self.has_many_weights(context) && 4 * falling >= results.endings.len()
    }

    /// Returns the result of a sample, without the price of its last action if that is forgiven.
    fn summary(&self, endings: &[EpisodeResult]) -> Summary {
        let price = |ending: &EpisodeResult| if self.forgives { ending.final_reward.min(0.0) } else { 0.0 };
        let paid = |ending: &EpisodeResult| EpisodeResult { score: ending.score - price(ending), ..*ending };
        Summary::new(&endings.iter().map(paid).collect::<Vec<_>>())
    }

    /// Finds the toll of the next search, if this one has learned to stand still.
    fn charge(&mut self, lasting: &[&Summary], falling: &[&Summary], limit: f64) {
        let score = lasting.iter().map(|result| result.score).sum::<f64>() / lasting.len() as f64;
        self.next_toll = match self.toll {
            Some(toll) if self.best >= MOVING * toll.score => self.next_toll,
            Some(toll) => Some(Toll { price: toll.price.max(score / limit), ..toll }),
            None => {
                let prices = falling.iter().map(|result| (score - result.score) / (limit - result.actions));
                let price = PRICE * prices.reduce(f64::min).unwrap_or(0.0);
                (price > 0.0).then_some(Toll { price, score, actions: self.actions })
            }
        };
    }

    /// Returns the score: a mean of samples, the median over some generations.
    pub(super) fn score(&self) -> Option<f64> {
        let mut scores: Vec<f64> = self.scores.iter().copied().collect();
        scores.sort_by(f64::total_cmp);
        scores.get(scores.len() / 2).copied()
    }

    /// Returns the better one of two searches; the first of equals.
    pub(super) fn better(self, other: Self) -> Self {
        if other.score() > self.score() { other } else { self }
    }
}

/// Returns the places of results, the best first, at a price of each action.
fn ranking(results: &[Summary], price: f64) -> Vec<usize> {
    let value = |place: usize| results[place].score - price * results[place].actions;
    let mut order: Vec<usize> = (0..results.len()).collect();
    order.sort_by(|&a, &b| value(b).total_cmp(&value(a)));
    order
}

impl Context<'_> {
    /// Returns the writer of sums or products.
    pub(super) fn writer(&self, kind: ProgramKind) -> Result<LinearWriter<'_>, Finding> {
        LinearWriter::new(self.vocabulary, self.actions, kind)
    }

    /// True if programs may be as long as those of a writer.
    fn fits(&self, writer: &LinearWriter<'_>) -> bool {
        let program = &self.config.program;
        let most = if self.actions == 0 { program.leaf_lines() } else { program.max_program_size };
        writer.is_small() && writer.lines() <= most
    }
}

impl Stage for Search {
    fn ask(&mut self, context: &Context<'_>, moment: Moment) -> Vec<Candidate> {
        let Ok(writer) = context.writer(self.kind) else { return Vec::new() };
        let mut stream = moment.stream(Purpose::Linear, 0);
        self.samples = match &self.method {
            Method::Cma(cma) if self.is_local() => cma.pairs(context.samples, &mut stream),
            Method::Cma(cma) => cma.samples(BREADTH * Cma::default_population(writer.weights()), &mut stream),
            Method::Random(search) => search.samples(context.samples, &mut stream),
        };
        let candidate = |sample: &Vec<f64>| {
            let policy = writer.policy(&self.written(sample, &writer));
            Candidate { policy, record: Record::default() }
        };
        self.samples.iter().map(candidate).collect()
    }

    fn episodes(&self) -> EpisodePlan {
        if self.is_local() { EpisodePlan::Pairs } else { EpisodePlan::Same }
    }

    fn tell(&mut self, context: &Context<'_>, moment: Moment, results: &Results) -> (Row, usize) {
        if self.scores.is_empty() && self.loses_by_falling(context, results) {
            self.forgives = true;
        }
        let summaries: Vec<Summary> = results.endings.iter().map(|endings| self.summary(endings)).collect();
        let order = ranking(&summaries, 0.0);
        let counted = &order[..(COUNTED * order.len() as f64).ceil() as usize];
        let sum: f64 = counted.iter().map(|&place| summaries[place].score).sum();
        self.scores.push_back((sum / counted.len() as f64).clamp(-1e30, 1e30));
        self.scores.drain(..self.scores.len().saturating_sub(NEWEST));
        let samples = std::mem::take(&mut self.samples);
        self.learn(context, &samples, &summaries);
        if let Some((seen, writer)) = self.seen.as_mut().zip(context.writer(self.kind).ok()) {
            seen.merge(&results.seen.select(writer.places()));
        }
        let best = &summaries[order[0]];
        let row = Row {
            generation: moment.generation,
            best_score: best.score,
            median_score: summaries[order[order.len() / 2]].score,
            best_success: best.success,
            best_measure: best.measure,
            roots: summaries.len(),
            ..Row::default()
        };
        (row, order[0])
    }
}

#[cfg(test)]
mod tests {
    use super::{Method, PRICE, Search, Toll};
    use crate::evolution::config::EvolutionConfig;
    use crate::evolution::stage::{Context, Moment, Results, Stage};
    use crate::evolution::vocabulary::Vocabulary;
    use tpg_engine::{EpisodeResult, Moments, Output};
    use tpg_graph::{ScalarType, SourceDocument};

    const LIMIT: u32 = 1000;

    fn vocabulary(config: &EvolutionConfig, outputs: usize) -> Vocabulary {
        let sources = [SourceDocument::new("state", "", vec![[-1.0, 1.0]; 10])];
        let output = |place| Output { name: format!("motor_{place}"), unit: String::new(), min: -1.0, max: 1.0 };
        let limits = (0..outputs).map(|place| output(place).limits(ScalarType::F32)).collect();
        let scales = Some(vec![1.0; 10]);
        let bare = Vocabulary::new(config.instructions(), 8, &sources, scales, ScalarType::F32);
        Vocabulary { outputs: limits, ..bare }
    }

    fn context<'a>(config: &'a EvolutionConfig, vocabulary: &'a Vocabulary) -> Context<'a> {
        Context { samples: 8, time_limit: LIMIT, ..crate::evolution::tests::context(config, vocabulary, 0, &[]) }
    }

    /// Plays a generation: `ending` gives score and number of actions of each sample.
    fn play(search: &mut Search, context: &Context<'_>, generation: u64, ending: impl Fn(usize) -> (f64, u32)) {
        play_to_the_end(search, context, generation, 0.0, ending);
    }

    /// Plays a generation whose episodes end with a reward; returns the best score.
    fn play_to_the_end(
        search: &mut Search,
        context: &Context<'_>,
        generation: u64,
        final_reward: f64,
        ending: impl Fn(usize) -> (f64, u32),
    ) -> f64 {
        let moment = Moment { seed: 1, generation };
        let candidates = search.ask(context, moment);
        let ending = |place| {
            let (score, actions) = ending(place);
            vec![EpisodeResult { outcome: 0, success: None, score, final_reward, measure: 0.0, actions }]
        };
        let results = Results { endings: (0..candidates.len()).map(ending).collect(), seen: Moments::new(10) };
        search.tell(context, moment, &results).0.best_score
    }

    fn local() -> EvolutionConfig {
        let mut config = EvolutionConfig::default();
        (config.start.random, config.start.share) = (0.5, 0.5);
        config
    }

    #[test]
    fn variances_of_many_weights_are_adapted_where_first_samples_fall_and_earn() {
        let config = local();
        for (what, outputs, score, actions, adapts) in [
            ("they fall and earn", 3, 20.0, 20, true),
            ("they fall and lose", 3, -100.0, 20, false),
            ("they last", 3, 20.0, LIMIT, false),
            ("few weights", 2, 20.0, 20, false),
        ] {
            let vocabulary = vocabulary(&config, outputs);
            let context = context(&config, &vocabulary);
            let mut search = Search::begin(&context, 0, None).expect("sums");
            play(&mut search, &context, 0, |_| (score, actions));
            assert_eq!(matches!(search.method, Method::Cma(_)), adapts, "{what}");
        }
    }

    #[test]
    fn a_fall_that_costs_more_than_all_else_is_forgiven() {
        let config = local();
        let vocabulary = vocabulary(&config, 3);
        let context = context(&config, &vocabulary);
        let begin = |last| Search::begin(&context, 0, last).expect("sums");
        for (final_reward, best, forgives) in [(-100.0, -4.0, true), (-50.0, -104.0, false), (100.0, -104.0, false)] {
            let mut search = begin(None);
            let found = play_to_the_end(&mut search, &context, 0, final_reward, |place| (-104.0 - place as f64, 60));
            assert_eq!((found, search.discourages_standing()), (best, forgives), "{final_reward}");
            assert_eq!(matches!(search.method, Method::Cma(_)), forgives, "{final_reward}");
        }
        let mut search = begin(None);
        play_to_the_end(&mut search, &context, 0, -100.0, |_| (-104.0, 60));
        play(&mut search, &context, 1, |place| if place < 6 { (0.0, LIMIT) } else { (-8.0, 900) });
        assert!(!search.should_restart(), "there is no reward for standing still");
        assert!(begin(Some(&search)).discourages_standing(), "nor does a later search pay for falls");
    }

    #[test]
    fn a_search_that_stalled_goes_on_where_the_next_one_is_no_better() {
        let config = local();
        let vocabulary = vocabulary(&config, 2);
        let context = context(&config, &vocabulary);
        let [better, worse] = [5.0, 3.0].map(|score| {
            let mut search = Search::begin(&context, 0, None).expect("sums");
            play(&mut search, &context, 0, |_| (score, 20));
            search
        });
        assert!(better.resumes(Some(&worse)) && !better.resumes(None));
        assert!(!worse.resumes(Some(&better)) && !better.resumes(Some(&better)));
        let still = Search { next_toll: Some(Toll { price: 1.0, score: 5.0, actions: 0.0 }), ..better };
        assert!(!still.resumes(Some(&worse)), "it has learned to stand still");
    }

    #[test]
    fn where_standing_still_is_rewarded_the_next_search_pays_for_it() {
        let config = local();
        let vocabulary = vocabulary(&config, 3);
        let context = context(&config, &vocabulary);
        let mut search = Search::begin(&context, 0, None).expect("sums");
        play(&mut search, &context, 0, |_| (20.0, 20));
        assert!(!search.should_restart() && !search.discourages_standing());
        // Half of them stand still, and the others earn a little more for each action until they fall.
        let stands = |place: usize| if place < 4 { (1000.0, LIMIT) } else { (120.0, 100) };
        play(&mut search, &context, 1, stands);
        assert!(search.should_restart() && !search.discourages_standing());

        let begin = |last: &Search| Search::begin(&context, 0, Some(last)).expect("sums");
        let mut next = begin(&search);
        let toll = next.toll.expect("a toll");
        assert!((toll.price - PRICE * 880.0 / 900.0).abs() < 1e-12 && toll.score == 1000.0, "{toll:?}");
        assert!(next.discourages_standing() && !next.should_restart());
        // Those that earn clearly more for each action are the best now, although they fall.
        let runs = |place: usize| if place < 2 { (1000.0, LIMIT) } else { (200.0, 100) };
        let mut plain = Search { toll: None, ..next.clone() };
        play(&mut plain, &context, 2, runs);
        play(&mut next, &context, 2, runs);
        assert_ne!(next.method, plain.method);

        assert!(!next.should_restart(), "it has as many actions as the first had");
        play(&mut next, &context, 3, runs);
        assert!(
            next.should_restart() && begin(&next).discourages_standing(),
            "nothing better than standing still: another one"
        );
        play(&mut next, &context, 4, |_| (1001.0, 900));
        assert!(!next.should_restart(), "something better goes on");
        play(&mut next, &context, 5, |_| (1100.0, LIMIT));
        assert!(next.should_restart(), "it stands still again");
        assert_eq!(begin(&next).toll.map(|toll| toll.price), Some(1.1), "which is worth nothing in the next");
        let mut moving = begin(&next);
        play(&mut moving, &context, 6, |_| (1500.0, LIMIT));
        assert!(!moving.should_restart(), "it lasts and moves");
    }
}
