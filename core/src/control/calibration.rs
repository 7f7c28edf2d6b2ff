//! What a control believes of its workpiece probe.

use super::Control;

/// What a measurement with a workpiece probe depends on, mm. A trigger point is the spindle at switching minus surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Calibration {
    /// Trigger points of abscissa and ordinate, each in minus and in plus direction.
    pub triggers: [[f64; 2]; 2],
    /// Trigger point of the applicate in minus direction, from the point to which L1 refers.
    pub above: f64,
    /// Active ball diameter, and ball centre minus spindle axis; none: trigger points alone are used.
    pub ball: Option<(f64, [f64; 2])>,
}

impl Control {
    /// Data of a workpiece probe by the number of its data field, from 1; NCT has one field (B:13442-13450, C:304-307).
    pub fn calibration(&self, field: i64) -> Calibration {
        (self.make().calibration)(self, field)
    }
}

pub(super) fn sinumerik(control: &Control, field: i64) -> Calibration {
    let datum = |index: usize| control.basic_length(&format!("_WP[{},{index}]", field - 1));
    Calibration {
        triggers: [[datum(1), datum(2)], [datum(3), datum(4)]],
        above: datum(5),
        ball: Some((datum(0), [datum(7), datum(8)])),
    }
}

/// The radial offset is added to each position, then the radius of the direction (C:176-177); the length reaches to the
/// end of the ball.
pub(super) fn nct(control: &Control, _: i64) -> Calibration {
    let triggers = [["#504", "#501", "#500"], ["#505", "#503", "#502"]].map(|names| {
        let [offset, minus, plus] = names.map(|name| control.basic_length(name));
        [minus - offset, -plus - offset]
    });
    Calibration { triggers, above: 0.0, ball: None }
}
