//! Whether the control's calibration data of the workpiece probe agree with the probe as it is.

use super::Setup;
use crate::control::probe::PROBE;
use crate::control::{Calibration, Edge};
use crate::geometry::{Degrees, Dir, V3};
use crate::workpiece::probe::{ball_offset, pre_travel};

/// Difference that does not count, mm.
const NEGLIGIBLE: f64 = 0.001;
/// Default measuring feed, mm/min, up to which the travel of a late signal can be in the data (B:2164-2170).
const FEED: f64 = 300.0;

/// How a call uses the workpiece probe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProbeInCall {
    /// Number of its data field, from 1.
    pub field: i64,
    /// Whether the spindle turns it into each direction of probing (A:1966).
    pub mono: bool,
    /// Whether the call measures with it: only then the length of a probe in use is compared.
    pub measures: bool,
}

impl Setup {
    /// Whether a measurement along the axes with this probe is right, scatter aside: trigger points, active ball and
    /// skew in the data are those of the probe, and so is the length in use.
    pub fn calibration_fits(&self, probe: ProbeInCall) -> bool {
        let edge = self.control.active_edge();
        let turret = edge.is_some_and(Edge::is_turning);
        let length_known = edge.is_some_and(|edge| edge.kind == PROBE || self.control.make().registers);
        let (believed, real) = (self.control.calibration(probe.field), self.calibration_found(probe));
        let allowed = NEGLIGIBLE + self.probe.delay.abs() * FEED / 60.0;
        let near = |one: &f64, other: &f64| (one - other).abs() <= allowed;
        let all_near = |one: &[f64], other: &[f64]| one.iter().zip(other).all(|(one, other)| near(one, other));
        let ball_fits = || match (believed.ball, real.ball) {
            (Some((ball, skew)), Some((real_ball, real_skew))) => {
                near(&ball, &real_ball) && (probe.mono || all_near(&skew, &real_skew))
            }
            _ => true,
        };
        all_near(believed.triggers.as_flattened(), real.triggers.as_flattened())
            && (!probe.measures || !length_known || near(&believed.above, &real.above))
            && (turret || ball_fits()) // turning cycles need trigger points only
    }

    /// What a calibration of this probe along the axes, without scatter and delay, would find.
    fn calibration_found(&self, probe: ProbeInCall) -> Calibration {
        let triggers = [0, 1].map(|axis| [-1.0, 1.0].map(|sign| self.switches(probe.mono, axis, sign)));
        let [first, second] = triggers.map(|[minus, plus]| minus - plus);
        let skew = triggers.map(|[minus, plus]| -(minus + plus) / 2.0);
        Calibration { triggers, above: self.switches(false, 2, -1.0), ball: Some(((first + second) / 2.0, skew)) }
    }

    /// Position of the spindle at switching minus that of the surface, mm, when it moves along an axis of the plane,
    /// 0 to 2, in this direction.
    fn switches(&self, mono: bool, axis: usize, sign: f64) -> f64 {
        let axes = self.control.plane.axes();
        let (along, applicate) = (axes[axis], axes[2]);
        let turned = match (mono, sign > 0.0) {
            (true, true) => Degrees(90.0 * axis as f64),
            (true, false) => Degrees(90.0 * axis as f64 + 180.0),
            (false, _) => Degrees(0.0),
        };
        let way = V3::ith(along, sign);
        let late = pre_travel(&self.probe, turned, applicate, &way);
        let mut ball: Dir<_> = ball_offset(&self.probe, turned, applicate);
        ball[applicate] += self.control.active_length()[applicate] - self.probe.length;
        sign * (late - self.probe.radius) - ball[along]
    }
}
