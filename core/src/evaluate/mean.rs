//! Mean value with a weighting factor (B:1239-1263).

/// The new mean value: the old one moves by 1/`weight` of the way to `difference`. None for the weight 0 (alarm 61318).
pub fn next(old: f64, difference: f64, weight: f64) -> Option<f64> {
    (weight != 0.0).then(|| old - (old - difference) / weight)
}

/// Numbers of the memories in `_EVNUM`, from 1; 0: none. Up to 9999 both are the same; above, the
/// upper four digits are the mean value's and the lower four the empirical value's (B:2303-2342).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Memories {
    /// Number of the empirical value: `_EV[number - 1]`.
    pub empirical: i64,
    /// Number of the mean value: `_MV[number - 1]`.
    pub mean: i64,
}

/// Takes `_EVNUM` apart.
pub fn memories(evnum: i64) -> Memories {
    if evnum > 9999 {
        Memories { empirical: evnum % 10_000, mean: evnum / 10_000 }
    } else {
        Memories { empirical: evnum.max(0), mean: evnum.max(0) }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// Mean values of a series of differences in µm; above 40 they correct and begin again.
    fn series(weight: f64) -> (Vec<f64>, Vec<usize>) {
        let mut old = 0.0;
        let mut means = Vec::new();
        let mut corrected = Vec::new();
        for (at, difference) in [30.0, 50.0, 60.0, 20.0, 40.0, 50.0, 50.0, 30.0, 70.0, 70.0].iter().enumerate() {
            let mean = next(old, *difference, weight).unwrap();
            means.push(mean);
            old = mean;
            if mean.abs() > 40.0 {
                corrected.push(at + 1);
                old = 0.0;
            }
        }
        (means, corrected)
    }

    #[test]
    fn weight_two_follows_the_printed_table() {
        // oracle: manual B:1265-1284 (46.25 is printed as 46.2)
        let (means, corrected) = series(2.0);
        let printed = [15.0, 32.5, 46.2, 10.0, 25.0, 37.5, 43.75, 15.0, 42.5, 35.0];
        assert!(means.iter().zip(printed).all(|(mean, print)| (mean - print).abs() <= 0.05 + 1e-9));
        assert_eq!(corrected, [3, 7, 9]);
    }

    #[test]
    fn weight_three_follows_the_printed_table_but_for_its_misprint() {
        // oracle: manual B:1265-1284; rows 5 to 7 carry a misprint on and are worked out by hand
        let (means, corrected) = series(3.0);
        let rows = [10.0, 23.3, 35.5, 30.3, 33.580, 39.053, 42.702, 10.0, 30.0, 43.3];
        assert!(means.iter().zip(rows).all(|(mean, row)| (mean - row).abs() < 0.1));
        assert_eq!(corrected, [7, 10]);
    }

    #[test]
    fn weight_zero_has_no_mean() {
        // oracle: manual A:15859
        assert_eq!(next(0.0, 1.0, 0.0), None);
    }

    #[test]
    fn memory_numbers_split_above_9999() {
        // oracle: manual B:2303-2342
        assert_eq!(memories(0), Memories { empirical: 0, mean: 0 });
        assert_eq!(memories(11), Memories { empirical: 11, mean: 11 });
        assert_eq!(memories(90_012), Memories { empirical: 12, mean: 9 });
    }
}
