//! The learning curve of a run: one result for each validation.

use tpg_engine::Summary;

/// True if the last `window` points are no better than the `window` before them, neither in success nor in score.
pub(super) fn flat(curve: &[Summary], window: usize) -> bool {
    let Some(first) = curve.len().checked_sub(2 * window) else { return false };
    let mean = |points: &[Summary], value: fn(&Summary) -> f64| points.iter().map(value).sum::<f64>() / window as f64;
    let (before, last) = curve[first..].split_at(window);
    let risen = |value: fn(&Summary) -> f64| mean(last, value) > mean(before, value);
    window > 0 && !risen(|point| point.success.unwrap_or(0.0)) && !risen(|point| point.score)
}

#[cfg(test)]
mod tests {
    use super::flat;
    use tpg_engine::Summary;

    fn curve(points: &[(f64, f64)]) -> Vec<Summary> {
        let point = |&(success, score): &(f64, f64)| Summary {
            episodes: 10,
            score,
            success: Some(success),
            measure: 0.0,
            actions: 1.0,
        };
        points.iter().map(point).collect()
    }

    #[test]
    fn a_curve_is_flat_when_neither_success_nor_score_gets_better() {
        let rising = curve(&[(0.1, -90.0), (0.2, -80.0), (0.3, -80.0), (0.3, -80.0)]);
        assert!(!flat(&rising, 2) && !flat(&rising[..3], 2) && !flat(&[], 2));
        let nearer = curve(&[(0.0, -90.0), (0.0, -80.0), (0.0, -80.0), (0.0, -70.0)]);
        assert!(!flat(&nearer, 2), "no success yet, but a better score");
        let still = curve(&[(0.1, -9.0), (0.4, -40.0), (0.3, -30.0), (0.2, -40.0), (0.4, -31.0)]);
        assert!(flat(&still, 2));
        assert!(!flat(&still, 0), "never, when it is turned off");
    }
}
