//! Software limit switches (MD36100, MD36110): positions of the machine axes that are never passed.

use super::Control;
use crate::geometry::{Mcs, TOLERANCE, Wcs};

/// Smallest and largest position of the machine axes X Y Z, mm; none: the axis has no limit there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// MD36100, minus side.
    pub minus: [Option<f64>; 3],
    /// MD36110, plus side.
    pub plus: [Option<f64>; 3],
}

impl Limits {
    /// Whether there are any.
    pub fn any(&self) -> bool {
        self.minus.iter().chain(&self.plus).any(Option::is_some)
    }

    /// Whether the spindle nose may stand there; the last bit of a sum does not take one over its limit.
    fn contain(&self, axes: Mcs) -> bool {
        (0..3).all(|i| {
            self.minus[i].is_none_or(|low| axes[i] >= low - TOLERANCE)
                && self.plus[i].is_none_or(|high| axes[i] <= high + TOLERANCE)
        })
    }

    /// Part of the straight way that stays inside, 0 to 1. A way that begins outside may only lead back.
    fn part(&self, from: Mcs, to: Mcs) -> f64 {
        let along = |i: usize| {
            let limit = if to[i] > from[i] {
                self.plus[i].filter(|high| to[i] > *high)
            } else {
                self.minus[i].filter(|low| to[i] < *low)
            };
            limit.map_or(1.0, |limit| (limit - from[i]) / (to[i] - from[i]))
        };
        (0..3).map(along).fold(1.0, f64::min).max(0.0)
    }
}

impl Control {
    /// Whether the point to which the tool length refers may stand there.
    pub fn within_limits(&self, position: Mcs) -> bool {
        self.limits.contain(position + self.active_length())
    }

    /// Where a straight way from one point of the WCS to another is ended by a limit switch; none: it is not.
    pub fn limited(&self, from: Wcs, to: Wcs) -> Option<Wcs> {
        if !self.limits.any() {
            return None;
        }
        let [start, end] = [from, to].map(|point| self.to_machine(point) + self.active_length());
        if self.limits.contain(end) {
            return None;
        }
        let part = self.limits.part(start, end);
        Some(Wcs(std::array::from_fn(|i| from[i] + part * (to[i] - from[i]))))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::control::{Frame, Plane};
    use crate::dialect::Dialect;
    use crate::machine::Setup;

    #[test]
    fn a_way_ends_at_the_first_limit() {
        let mut control = Setup::calibrated(Dialect::Sinumerik, Plane::G17).control;
        control.frames.insert(1, Frame::translation([100.0, 0.0, 0.0]));
        control.activate(1);
        control.limits.plus[0] = Some(150.0);
        control.limits.minus[2] = Some(40.0);
        // oracle: hand: X50 of the WCS is X150 of the machine; the nose is 50 mm above the ball, so Z-10 is the lowest
        assert_eq!(control.limited(Wcs([0.0; 3]), Wcs([50.0, 0.0, -10.0])), None);
        let cut = control.limited(Wcs([0.0; 3]), Wcs([100.0, 8.0, 0.0])).unwrap();
        assert_eq!(cut, [50.0, 4.0, 0.0]);
        let cut = control.limited(Wcs([0.0; 3]), Wcs([0.0, 0.0, -20.0])).unwrap();
        assert_eq!(cut, [0.0, 0.0, -10.0]);
        assert!(control.within_limits(Mcs([150.0, 0.0, -10.0])));
        assert!(!control.within_limits(Mcs([150.1, 0.0, 0.0])));
    }

    #[test]
    fn from_beyond_a_limit_it_goes_only_back() {
        let limits = Limits { plus: [Some(10.0), None, None], ..Limits::default() };
        // oracle: hand
        assert_eq!(limits.part(Mcs([12.0, 0.0, 0.0]), Mcs([14.0, 0.0, 0.0])), 0.0);
        assert_eq!(limits.part(Mcs([12.0, 0.0, 0.0]), Mcs([9.0, 0.0, 0.0])), 1.0);
    }
}
