//! The probe is put in front of a face that somebody pointed at: up along the infeed axis, across, down. What it would
//! hit on the way stops it, as with any motion.

use super::mask::{Element, Task};
use super::session::Session;
use super::settings::Settings;
use crate::control::AXES;
use crate::geometry::{Dir, FARTHEST, Mcs, TOLERANCE, V3};
use crate::message::Message;

/// How much a face may look away from the tool: the part along the infeed axis of its normal.
const AWAY: f64 = -0.2;

/// The line of a script that puts the probe in front of a face at a point of it: half a measuring path away, where an
/// element is measured from inside in the middle of it, nowhere nearer to what is opposite than to the face. The way
/// leads as high above the part. None: it is there.
///
/// # Errors
/// Why it cannot get there.
pub fn to_face(session: &Session, at: Mcs, normal: Dir<Mcs>) -> Result<Option<String>, Message> {
    let sim = &session.sim;
    if !sim.has_probe() {
        return Err(Message::new("jog-face-no-probe"));
    }
    let [abscissa, ordinate, applicate] = super::settings::plane(&sim.control).axes();
    let normal = V3::from(normal).try_normalize(TOLERANCE).map(Dir::from);
    let there = at.iter().all(|coordinate| coordinate.abs() <= FARTHEST);
    let Some(normal) = normal.filter(|_| there) else { return Err(Message::new("jog-face-nothing")) };
    if normal[applicate] < AWAY {
        return Err(Message::new("jog-face-below"));
    }
    let inside = session.mask().is_some_and(|mask| {
        matches!(mask.task, Task::Element(Element { inside: true, .. }) | Task::Centres(Element { inside: true, .. }))
            || mask.task == Task::Ring
    });
    let half = Settings::of(&sim.control).path / 2.0;
    let to = sim.before(at, normal, half, inside).ok_or_else(|| Message::new("jog-face-nothing"))?;
    let from = sim.position;
    if (0..3).all(|axis| rounded(from[axis]) == rounded(to[axis])) {
        return Ok(None);
    }
    let above = sim.above(applicate, half).max(from[applicate]);
    let ways = [(applicate, from, above), (abscissa, from, to[abscissa]), (ordinate, from, to[ordinate])];
    let mut words: Vec<String> = ways.into_iter().filter_map(|(axis, from, to)| word(axis, from[axis], to)).collect();
    words.push(format!("{}{}", AXES[applicate], rounded(to[applicate])));
    Ok(Some(format!("move machine {}", words.join(" "))))
}

/// `X-20`; none: the axis is there.
fn word(axis: usize, from: f64, to: f64) -> Option<String> {
    (rounded(from) != rounded(to)).then(|| format!("{}{}", AXES[axis], rounded(to)))
}

/// To 0.001 mm.
fn rounded(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0 + 0.0
}
