//! The normal distribution. The functions of `libm` are the same in every build: those of a platform differ in the last
//! digit.

use libm::{erfc, exp, log, sqrt};
use std::f64::consts::{SQRT_2, TAU};

/// Share of all values below this one.
pub fn below(value: f64) -> f64 {
    0.5 * erfc(-value / SQRT_2)
}

/// The value below which this share lies; −∞ and ∞ at the ends.
///
/// The approximation of P. J. Acklam, right to 1e-9, and one step of Halley's method.
pub fn quantile(share: f64) -> f64 {
    if share > 0.5 {
        return -quantile(1.0 - share); // a share near 1 has lost the digits that one near 0 has
    }
    if share <= 0.0 {
        return f64::NEG_INFINITY;
    }
    let guess = approximation(share);
    let error = (below(guess) - share) * sqrt(TAU) * exp(0.5 * guess * guess);
    guess - error / (1.0 + 0.5 * guess * error)
}

/// Share below which the approximation has another formula.
const TAIL: f64 = 0.02425;

fn approximation(share: f64) -> f64 {
    let polynomial = |of: f64, factors: &[f64]| factors.iter().fold(0.0, |sum, factor| sum * of + factor);
    if share < TAIL {
        let tail = sqrt(-2.0 * log(share));
        return polynomial(tail, &TAIL_ABOVE) / polynomial(tail, &TAIL_BELOW);
    }
    let middle = share - 0.5;
    let square = middle * middle;
    middle * polynomial(square, &MIDDLE_ABOVE) / polynomial(square, &MIDDLE_BELOW)
}

const MIDDLE_ABOVE: [f64; 6] = [
    -3.969_683_028_665_376e1, 2.209_460_984_245_205e2, -2.759_285_104_469_687e2, 1.383_577_518_672_69e2,
    -3.066_479_806_614_716e1, 2.506_628_277_459_239,
];
const MIDDLE_BELOW: [f64; 6] = [
    -5.447_609_879_822_406e1, 1.615_858_368_580_409e2, -1.556_989_798_598_866e2, 6.680_131_188_771_972e1,
    -1.328_068_155_288_572e1, 1.0,
];
const TAIL_ABOVE: [f64; 6] = [
    -7.784_894_002_430_293e-3, -3.223_964_580_411_365e-1, -2.400_758_277_161_838, -2.549_732_539_343_734,
    4.374_664_141_464_968, 2.938_163_982_698_783,
];
const TAIL_BELOW: [f64; 5] =
    [7.784_695_709_041_462e-3, 3.224_671_290_700_398e-1, 2.445_134_137_142_996, 3.754_408_661_907_416, 1.0];

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: peer: tables of the normal distribution
    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (share, value) in [
            (0.5, 0.0),
            (0.95, 1.644_853_626_951_472_2),
            (0.975, 1.959_963_984_540_054),
            (0.00135, -2.999_976_992_703_4),
        ] {
            assert!((quantile(share) - value).abs() < 1e-12, "{share} {}", quantile(share));
        }
        assert_eq!([quantile(0.0), quantile(1.0)], [f64::NEG_INFINITY, f64::INFINITY]);
    }

    // oracle: definition
    #[test]
    fn a_quantile_has_its_share_below() {
        for step in 1..2000 {
            let share = f64::from(step) / 2000.0;
            for share in [share, share * 1e-9] {
                assert!((below(quantile(share)) / share - 1.0).abs() < 1e-12, "{share}");
            }
        }
    }
}
