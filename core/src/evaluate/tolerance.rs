//! The chain of decisions of a workpiece measurement with automatic tool offset (B:1286-1390, B:6123-6137).

use super::mean;

/// The bands, mm, each measured from 0. All comparisons are "more than": a difference on the limit is inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bands {
    /// `_TSA`: beyond it something is wrong with the measurement itself.
    pub safe_area: f64,
    /// `_TDIF`: beyond it nothing is corrected.
    pub difference: f64,
    /// Upper tolerance, symmetric.
    pub upper: f64,
    /// Lower tolerance, symmetric, negative.
    pub lower: f64,
    /// `_TMV`: beyond it the whole difference is corrected, within it the mean value decides.
    pub mean: f64,
    /// `_TZL`: a mean value within it corrects nothing.
    pub zero_offset: f64,
    /// `_K`, not 0.
    pub weight: f64,
}

/// Where in the chain a difference ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    /// More than `_TSA`: alarm 61303, the program stops, nothing is corrected.
    SafeArea,
    /// More than `_TDIF`: 62306, nothing is corrected.
    Difference,
    /// Above the upper tolerance: 62304, whole difference.
    Oversize,
    /// Below the lower tolerance: 62305, whole difference.
    Undersize,
    /// More than `_TMV`: whole difference.
    Whole,
    /// The mean value exceeds `_TZL`: it is corrected and begins again.
    Mean,
    /// The mean value stays within `_TZL`: nothing is corrected.
    Small,
}

impl Branch {
    /// Number of the alarm that belongs to it.
    pub const fn alarm(self) -> Option<u32> {
        match self {
            Branch::SafeArea => Some(61303),
            Branch::Difference => Some(62306),
            Branch::Oversize => Some(62304),
            Branch::Undersize => Some(62305),
            Branch::Whole | Branch::Mean | Branch::Small => None,
        }
    }

    /// Key of the sentence that says what follows.
    pub const fn key(self) -> &'static str {
        match self {
            Branch::SafeArea => "evaluate-safe-area",
            Branch::Difference => "evaluate-difference",
            Branch::Oversize => "evaluate-oversize",
            Branch::Undersize => "evaluate-undersize",
            Branch::Whole => "evaluate-whole",
            Branch::Mean => "evaluate-mean",
            Branch::Small => "evaluate-small",
        }
    }

    /// Whether a target is corrected and the mean value begins again.
    pub const fn corrects(self) -> bool {
        !matches!(self, Branch::SafeArea | Branch::Difference | Branch::Small)
    }
}

/// What follows from a difference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decision {
    /// Branch taken.
    pub branch: Branch,
    /// Difference to correct, mm, not yet halved for a radius; 0: none.
    pub correction: f64,
    /// Mean value worked out, mm; the old one where the chain ends before the mean value.
    pub mean: f64,
    /// New content of the mean value memory, mm.
    pub memory: f64,
}

/// What a sum of measured values may be off by, mm: the contact is computed to this. Without it a part that is
/// exactly on the limit would be over it or not by the last bit.
pub const RESOLUTION: f64 = 1e-9;

/// Whether a value is more than its limit; on the limit it is not.
pub fn exceeds(value: f64, limit: f64) -> bool {
    value > limit + RESOLUTION
}

/// Decides over one difference, or over the two of a rectangle: the worst one decides the branch, their
/// mean is corrected. Differences are actual minus setpoint, empirical value included.
pub fn chain(differences: &[f64], bands: &Bands, old_mean: f64) -> Decision {
    let count = differences.len().max(1) as f64;
    let difference = differences.iter().sum::<f64>() / count;
    let worst = differences.iter().copied().fold(0.0_f64, |worst, d| if d.abs() > worst.abs() { d } else { worst });
    let over = |limit: f64| exceeds(worst.abs(), limit);
    let unchanged = |branch| Decision { branch, correction: 0.0, mean: old_mean, memory: old_mean };
    let whole = |branch| Decision { branch, correction: difference, mean: 0.0, memory: 0.0 };
    if over(bands.safe_area) {
        unchanged(Branch::SafeArea)
    } else if over(bands.difference) {
        unchanged(Branch::Difference)
    } else if exceeds(worst, bands.upper) {
        whole(Branch::Oversize)
    } else if exceeds(-worst, -bands.lower) {
        whole(Branch::Undersize)
    } else if over(bands.mean) {
        whole(Branch::Whole)
    } else {
        by_mean(difference, bands, old_mean)
    }
}

/// The last step: the mean value decides.
fn by_mean(difference: f64, bands: &Bands, old_mean: f64) -> Decision {
    let mean = mean::next(old_mean, difference, bands.weight).unwrap_or(old_mean);
    if exceeds(mean.abs(), bands.zero_offset) {
        Decision { branch: Branch::Mean, correction: mean, mean, memory: 0.0 }
    } else {
        Decision { branch: Branch::Small, correction: 0.0, mean, memory: mean }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BANDS: Bands = Bands {
        safe_area: 1.0,
        difference: 0.06,
        upper: 0.03,
        lower: -0.03,
        mean: 0.02,
        zero_offset: 0.01,
        weight: 3.0,
    };

    fn decide(difference: f64, old: f64) -> (Branch, f64, f64) {
        let decision = chain(&[difference], &BANDS, old);
        (decision.branch, decision.correction, decision.memory)
    }

    #[test]
    fn on_the_limit_is_inside_up_to_the_resolution() {
        // oracle: hand
        assert_eq!(decide(0.03 + 1e-12, 0.0).0, Branch::Whole);
        assert_eq!(decide(-0.03 - 1e-12, 0.0).0, Branch::Whole);
        assert_eq!(decide(0.03 + 1e-8, 0.0).0, Branch::Oversize);
    }

    #[test]
    fn every_branch_of_the_worked_example() {
        // oracle: manual B:6103-6137, numbers by hand
        assert_eq!(decide(1.2, 0.0), (Branch::SafeArea, 0.0, 0.0));
        assert_eq!(decide(0.07, 0.0), (Branch::Difference, 0.0, 0.0));
        assert_eq!(decide(-0.07, 0.0), (Branch::Difference, 0.0, 0.0));
        assert_eq!(decide(0.04, 0.005), (Branch::Oversize, 0.04, 0.0));
        assert_eq!(decide(-0.04, 0.005), (Branch::Undersize, -0.04, 0.0));
        assert_eq!(decide(0.025, 0.005), (Branch::Whole, 0.025, 0.0));
        let (branch, correction, memory) = decide(0.018, 0.009);
        assert_eq!((branch, memory), (Branch::Mean, 0.0));
        assert!((correction - 0.012).abs() < 1e-12);
        let (branch, correction, memory) = decide(0.018, 0.0);
        assert_eq!((branch, correction), (Branch::Small, 0.0));
        assert!((memory - 0.006).abs() < 1e-12);
    }

    #[test]
    fn a_difference_on_a_limit_is_inside() {
        // oracle: hand, from the manual's "more than" (B:6123-6137)
        assert_eq!(decide(1.0, 0.0).0, Branch::Difference);
        assert_eq!(decide(0.06, 0.0).0, Branch::Oversize);
        assert_eq!(decide(0.03, 0.0).0, Branch::Whole);
        assert_eq!(decide(0.02, 0.02).0, Branch::Mean);
        assert_eq!(decide(0.01, 0.01).0, Branch::Small);
    }

    #[test]
    fn the_worse_length_of_a_rectangle_decides_and_the_mean_is_corrected() {
        // oracle: hand
        let decision = chain(&[0.04, -0.01], &BANDS, 0.0);
        assert_eq!(decision.branch, Branch::Oversize);
        assert!((decision.correction - 0.015).abs() < 1e-12);
        assert_eq!(chain(&[0.0, -1.1], &BANDS, 0.0).branch, Branch::SafeArea);
    }
}
