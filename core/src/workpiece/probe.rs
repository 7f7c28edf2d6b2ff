//! When the probe switches, and where the control then believes the spindle to be.

use super::{Boundary, Contact, Feeler, Noise, Obstacle, Probe, Touching, tool::across};
use crate::geometry::{Degrees, Dir, Mcs, Path, V3};

/// Ball centre minus spindle axis, the probe turned from abscissa to ordinate; `axis`: index of the applicate.
pub fn ball_offset(probe: &Probe, turned: Degrees, axis: usize) -> Dir<Mcs> {
    let [x, y] = probe.skew;
    (across(axis, turned) * x + across(axis, turned + Degrees(90.0)) * y).into()
}

/// How the probe stands.
#[derive(Clone, Copy, Debug)]
pub struct Stand {
    /// How far it is turned from the abscissa to the ordinate.
    pub turned: Degrees,
    /// Index of the tool axis (the applicate of the plane).
    pub axis: usize,
    /// What of it can touch.
    pub feeler: Feeler,
}

/// Moves the probe until it switches. `from` and `to`: spindle axis at the height of the ball centre; feed in mm/min.
/// None where no signal comes before `to`, even if the ball already touches. A probe that reaches into the part at the
/// start gives its signal at once. A stylus that is deflected gives it as the ball does; its body gives none, so that
/// nothing is latched, and stands where it touches.
pub fn touch(
    part: &Boundary,
    probe: &Probe,
    stand: &Stand,
    from: Mcs,
    to: Mcs,
    feed: f64,
    noise: &mut Noise,
) -> Option<Obstacle> {
    let Stand { turned, axis, feeler } = stand;
    let offset = V3::from(ball_offset(probe, *turned, *axis));
    let (from, to) = (V3::from(from), V3::from(to));
    let way = Path::new(from, to);
    let ball = |gone: f64| -> Mcs { (way.at(gone) + offset).into() };
    let contact = part.first(feeler.radius, ball(0.0), (to + offset).into());
    if let Contact::Already(met, _) = contact {
        return Some(Obstacle { stop: from.into(), ..met });
    }
    let met = first_met(part, feeler, &contact, [ball(0.0), (to + offset).into()])?;
    let gone = met.part * way.length;
    let signal = match met.by {
        Touching::Body => gone,
        _ => {
            let late = pre_travel(probe, *turned, *axis, &way.direction);
            let (deviation, _) = probe.repeatability;
            (gone + late + probe.delay * feed / 60.0 + noise.scatter(deviation)).max(0.0)
        }
    };
    (signal <= way.length).then(|| Obstacle { stop: way.at(signal).into(), ball: ball(gone), ..met })
}

/// What of the probe touches first, where the ball meets this.
fn first_met(part: &Boundary, feeler: &Feeler, ball: &Contact, [from, to]: [Mcs; 2]) -> Option<Obstacle> {
    let Contact::Hit(hit) = *ball else { return feeler.caught(part, from, to) };
    let length = (V3::from(hit.ball) - V3::from(from)).norm();
    Some(hit.or_before(feeler.caught(part, from, hit.ball), length))
}

/// Pre-travel in this direction, mm, the probe turned so far: lobes by the part of the motion across the tool axis.
pub fn pre_travel(probe: &Probe, turned: Degrees, axis: usize, way: &V3) -> f64 {
    let (constant, lobes) = probe.pre_travel;
    let (abscissa, ordinate) = (way[(axis + 1) % 3], way[(axis + 2) % 3]);
    let across = abscissa.hypot(ordinate);
    let seen = ordinate.atan2(abscissa) - turned.radians();
    constant + lobes * across * (3.0 * seen).cos()
}
