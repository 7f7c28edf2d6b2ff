//! Targets by an angle: from a pole in the working plane with a distance (G110 to G112, AP, RP), or of a line (ANG).

use super::{Coordinate, Interpreter, Path, Pole, path::Polar};
use crate::geometry::Degrees;

/// G110, G111, G112: the pole that the block tells, cartesian or polar itself; `from` is where the axes stand.
pub fn set_pole(run: &mut Interpreter, path: &Path, kind: Pole, from: [f64; 3]) {
    let [a, o, _] = run.sim.control.plane.axes();
    let origin = match kind {
        Pole::Position => [from[a], from[o]],
        Pole::Zero => [0.0; 2],
        Pole::Before => run.modal.pole,
    };
    let written = |axis: usize| path.axes[axis].map_or(0.0, |coordinate| coordinate.value);
    let offset = match path.polar {
        Polar { angle: None, radius: None } => [written(a), written(o)],
        polar => away(polar, [0.0; 2]),
    };
    run.modal.pole = [origin[0] + offset[0], origin[1] + offset[1]];
}

/// The target of a block, which polar coordinates may tell in the plane.
pub fn target(run: &Interpreter, path: &Path, from: [f64; 3], to: [f64; 3]) -> [f64; 3] {
    if !path.polar.is_written() {
        return to;
    }
    let [a, o, _] = run.sim.control.plane.axes();
    let [x, y] = run.modal.pole;
    let [dx, dy] = away(path.polar, [from[a] - x, from[o] - y]);
    let mut to = to;
    (to[a], to[o]) = (x + dx, y + dy);
    to
}

/// ANG: where a line at this angle comes to the one coordinate of the plane that the block writes; none: nowhere.
pub fn along(run: &Interpreter, path: &Path, from: [f64; 3], to: [f64; 3]) -> Option<[f64; 3]> {
    let Some(angle) = path.slope else { return Some(to) };
    let [a, o, _] = run.sim.control.plane.axes();
    let (sine, cosine) = Degrees(angle).sin_cos();
    let (written, other, ratio) = match (path.axes[a], path.axes[o]) {
        (Some(_), None) => (a, o, sine / cosine),
        (None, Some(_)) => (o, a, cosine / sine),
        _ => return None,
    };
    let mut end = to;
    end[other] = from[other] + (to[written] - from[written]) * ratio;
    end[other].is_finite().then_some(end)
}

/// From the pole to the place; what is not written, and what increments count from, is as the axes stand.
fn away(polar: Polar, stands: [f64; 2]) -> [f64; 2] {
    let value = |written: Option<Coordinate>, now: f64| match written {
        None => now,
        Some(Coordinate { value, absolute: Some(false), .. }) => now + value,
        Some(Coordinate { value, .. }) => value,
    };
    let [x, y] = stands;
    let radius = value(polar.radius, x.hypot(y));
    let (sine, cosine) = Degrees(value(polar.angle, y.atan2(x).to_degrees())).sin_cos();
    [radius * cosine, radius * sine]
}
