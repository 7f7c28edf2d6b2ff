//! Mean, standard deviation and quantiles of numbers, and how well each is known.

/// Numbers and how they are spread.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spread {
    /// The numbers, ordered.
    pub values: Vec<f64>,
    /// Mean.
    pub mean: f64,
    /// Standard deviation of a sample; 0 of a single number.
    pub deviation: f64,
    /// Standard error of the standard deviation: `s·√(m₄/s⁴ − 1)/(2√N)`.
    pub deviation_error: f64,
}

impl Spread {
    /// Of these numbers; what is no number is left out.
    pub fn of(mut values: Vec<f64>) -> Spread {
        values.retain(|value| value.is_finite());
        values.sort_by(f64::total_cmp);
        let count = values.len() as f64;
        // numbers that are all the same have exactly that mean
        let mean = values.iter().enumerate().fold(0.0, |mean, (at, value)| mean + (value - mean) / (at + 1) as f64);
        let moment = |power: i32| values.iter().map(|value| (value - mean).powi(power)).sum::<f64>();
        let square = moment(2);
        let deviation = if count > 1.0 { (square / (count - 1.0)).sqrt() } else { 0.0 };
        let variance = square / count;
        let peaked = if variance > 0.0 { moment(4) / count / (variance * variance) - 1.0 } else { 0.0 };
        let deviation_error = if count > 1.0 { deviation * peaked.max(0.0).sqrt() / (2.0 * count.sqrt()) } else { 0.0 };
        Spread { values, mean, deviation, deviation_error }
    }

    /// How many.
    pub fn count(&self) -> usize {
        self.values.len()
    }

    /// Standard error of the mean.
    pub fn mean_error(&self) -> f64 {
        self.deviation / (self.count().max(1) as f64).sqrt()
    }

    /// The value below which this share lies, between two neighbours in proportion; 0 without numbers.
    pub fn quantile(&self, share: f64) -> f64 {
        let Some(last) = self.values.len().checked_sub(1) else { return 0.0 };
        let place = share.clamp(0.0, 1.0) * last as f64;
        let at = place.floor() as usize;
        let (here, next) = (self.values[at], self.values[(at + 1).min(last)]);
        here + (next - here) * (place - at as f64)
    }

    /// How many lie in each of so many intervals of one width from the smallest to the largest.
    pub fn histogram(&self, intervals: usize) -> Vec<usize> {
        let mut counts = vec![0; intervals];
        let [Some(low), Some(high)] = [self.values.first(), self.values.last()] else { return counts };
        let width = (high - low) / intervals as f64;
        for value in &self.values {
            let at = if width > 0.0 { ((value - low) / width) as usize } else { 0 };
            if let Some(count) = counts.get_mut(at.min(intervals.saturating_sub(1))) {
                *count += 1;
            }
        }
        counts
    }
}

/// Standard error of a share that was counted in so many runs.
pub fn share_error(share: f64, runs: usize) -> f64 {
    (share * (1.0 - share) / runs.max(1) as f64).sqrt()
}

/// How uncertain a share is: its standard error; of what was always or never seen, how much it may be off with 95 %
/// confidence.
pub fn share_doubt(share: f64, runs: usize) -> f64 {
    if share > 0.0 && share < 1.0 { share_error(share, runs) } else { unseen(runs) }
}

/// The largest share, with 95 % confidence, of what was not seen once in so many runs: `1 − 0.05^(1/N)`.
pub fn unseen(runs: usize) -> f64 {
    1.0 - 0.05f64.powf(1.0 / runs.max(1) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand
    #[test]
    fn numbers_that_are_the_same_do_not_spread() {
        let same = Spread::of(vec![0.1; 1000]);
        assert_eq!((same.mean, same.deviation, same.deviation_error), (0.1, 0.0, 0.0));
        assert_eq!(same.histogram(4), [1000, 0, 0, 0]);
        let none = Spread::of(vec![f64::NAN]);
        assert_eq!((none.count(), none.mean, none.quantile(0.5), none.mean_error()), (0, 0.0, 0.0, 0.0));
    }

    // oracle: hand: mean 3, squares 4 + 1 + 0 + 1 + 4, divided by 4
    #[test]
    fn mean_deviation_and_quantiles() {
        let five = Spread::of(vec![5.0, 1.0, 4.0, 2.0, 3.0]);
        assert_eq!((five.mean, five.deviation), (3.0, 2.5f64.sqrt()));
        assert_eq!([0.0, 0.25, 0.375, 1.0].map(|share| five.quantile(share)), [1.0, 2.0, 2.5, 5.0]);
        assert_eq!(five.histogram(2), [2, 3]);
    }
}
