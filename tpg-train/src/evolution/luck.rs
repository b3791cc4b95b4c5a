//! The luck of a generation: its episodes can be easier or harder than those of others.
//!
//! A child that met ten easy episodes would stand above a parent that met hundreds of all kinds. So the champion, the best root on
//! the selection set, plays every generation's episodes, too: its mean is known from other episodes, and the difference tells
//! how easy each episode is. It counts in proportion to what the champion's scores say about other roots' scores (a control
//! variate, with a coefficient learned from the run): nearly whole where the start decides, hardly where chance does.

use serde::{Deserialize, Serialize};
use tpg_graph::error::Finding;

/// Weight of earlier generations, for each one that followed.
const MEMORY: f64 = 0.9;

/// What the champion's scores say about those of other roots.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Luck {
    /// Sum of products of deviations, the champion's and a root's, from their means over a generation.
    products: f64,
    /// Sum of squares of the champion's.
    squares: f64,
}

impl Luck {
    /// Learns from a generation: the champion's scores, and those of the roots that played all of its episodes.
    pub fn learn<'a>(&mut self, champion: &[f64], roots: impl Iterator<Item = &'a [f64]>) {
        let mean = |scores: &[f64]| scores.iter().sum::<f64>() / scores.len().max(1) as f64;
        let middle = mean(champion);
        let mut roots_seen = 0.0;
        let mut products = 0.0;
        for scores in roots.filter(|scores| scores.len() == champion.len()) {
            let own = mean(scores);
            products += champion.iter().zip(scores).map(|(a, b)| (a - middle) * (b - own)).sum::<f64>();
            roots_seen += 1.0;
        }
        if roots_seen > 0.0 {
            self.products = MEMORY * self.products + products / roots_seen;
            self.squares = MEMORY * self.squares + champion.iter().map(|a| (a - middle) * (a - middle)).sum::<f64>();
        }
    }

    /// Returns what is to be added to every root's score of each episode, with the champion's scores and its known mean.
    pub fn corrections(&self, champion: &[f64], known: f64) -> Vec<f64> {
        let share = if self.squares > 0.0 { (self.products / self.squares).clamp(0.0, 1.0) } else { 0.0 };
        champion.iter().map(|score| share * (known - score)).collect()
    }

    /// Checks what was read from a file.
    ///
    /// # Errors
    /// Numbers that are not finite, or a negative sum of squares.
    pub(super) fn check(&self) -> Result<(), Finding> {
        Finding::range("products", self.products, f64::MIN, f64::MAX)?;
        Finding::range("squares", self.squares, 0.0, f64::MAX)
    }
}

#[cfg(test)]
mod tests {
    use super::Luck;

    #[test]
    fn an_easy_episode_costs_what_it_gave_the_champion_where_it_gives_all_the_same() {
        let mut luck = Luck::default();
        let champion = [-100.0, -200.0, -150.0];
        assert_eq!(luck.corrections(&champion, -140.0), [0.0; 3], "nothing is known yet");
        let (like, short) = ([-110.0, -210.0, -160.0], [5.0]);
        luck.learn(&champion, [&like[..], &short[..]].into_iter());
        assert_eq!(luck.corrections(&champion, -140.0), [-40.0, 60.0, 10.0]);
    }

    #[test]
    fn where_chance_decides_nothing_is_corrected() {
        let mut luck = Luck::default();
        // One half as much, one the other way round, and so on: together nothing.
        let roots = [[1.0, 0.0, 2.0], [0.0, 1.0, -1.0]];
        luck.learn(&[1.0, 2.0, 3.0], roots.iter().map(|scores| &scores[..]));
        assert_eq!(luck.corrections(&[5.0], 0.0), [0.0]);
        let half = [[0.0, 1.0, 2.0], [0.0, 0.0, 0.0]];
        let mut luck = Luck::default();
        luck.learn(&[1.0, 3.0, 5.0], half.iter().map(|scores| &scores[..]));
        assert_eq!(luck.corrections(&[4.0], 0.0), [-1.0], "a quarter");
        assert_eq!(luck.check(), Ok(()));
    }
}
