//! A tool probe of a machine: a cube or a disc that a tool touches, and when it switches.

use super::{Column, Columns, Form, Noise, Solid, tool::Piece};
use crate::geometry::{Convex, Mcs, Met, Path, Stretch, TOLERANCE, V3, convex};
use nalgebra::IsometryMatrix3;

/// Axes of the machine.
const AXES: [V3; 3] = [V3::new(1.0, 0.0, 0.0), V3::new(0.0, 1.0, 0.0), V3::new(0.0, 0.0, 1.0)];
/// How far a probe gives way without harm, mm: a tool that is deeper in it cannot be drawn out of it.
const GIVES_WAY: f64 = 5.0;

/// A tool probe as it is, not as the control believes.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolProbe {
    /// Cap: a [`super::Shape::Block`] (cube), or a [`super::Shape::Turned`] without bore (disc). Its errors say
    /// where it really is; shift, size, tilt and taper are used.
    pub solid: Solid,
    /// Travel after contact until the signal, mm.
    pub pre_travel: f64,
    /// Delay of the signal, s; multiplies the feed.
    pub delay: f64,
    /// Standard deviation of the switching point along the travel, mm, and seed of the pseudo-random sequence.
    pub repeatability: (f64, u64),
}

impl ToolProbe {
    /// A probe without errors.
    pub fn ideal(solid: Solid) -> ToolProbe {
        ToolProbe { solid, pre_travel: 0.0, delay: 0.0, repeatability: (0.0, 1) }
    }

    /// The cap as a convex body; none where it is none.
    fn cap(&self) -> Option<Cap> {
        let Form::Columns(Columns { stands: Some(column), plate: false, .. }) = self.solid.form() else { return None };
        Some(Cap { column, place: self.solid.place() })
    }
}

#[derive(Clone, Debug)]
struct Cap {
    column: Column,
    place: IsometryMatrix3<f64>,
}

impl Convex for Cap {
    fn farthest(&self, direction: &V3) -> V3 {
        let farthest = self.column.farthest(&(self.place.rotation.inverse() * direction));
        self.place.transform_point(&farthest.into()).coords
    }
}

/// What of which probe a tool meets, after which way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Index of the probe.
    pub probe: usize,
    /// Way until then (0 where it is in contact), what is touched, and the normal there.
    pub meeting: Met,
}

/// First contact of a tool with one of the probes; `from` and `to` are the ends of the way of any of its points.
pub fn first<T: Convex>(probes: &[ToolProbe], tool: &[T], from: Mcs, to: Mcs) -> Option<Contact> {
    let path = Path::new(from.into(), to.into());
    least(probes, tool, &path, &|piece, cap| convex::first(piece, cap, &path))
}

/// Whether a tool that stands at `from` may meet one of the probes on a stretch of its way: false is sure.
pub fn may_meet(probes: &[ToolProbe], tool: &[Piece], from: Mcs, way: &Stretch) -> bool {
    let way = way.moved(&-V3::from(from));
    let caps = probes.iter().filter_map(ToolProbe::cap);
    let mut pairs = caps.flat_map(|cap| tool.iter().map(move |piece| (piece, cap.clone())));
    pairs.any(|(piece, cap)| !passes(piece, &cap, &way))
}

/// Whether a plane parts a piece from a cap wherever it is moved: across an axis, or across their gap in the middle.
fn passes(piece: &Piece, cap: &Cap, moved: &Stretch) -> bool {
    let between = || convex::normal(piece, cap, &moved.at(0.5));
    let parts = |direction: &V3| parts(piece, cap, moved, direction, 0.0);
    AXES.iter().any(parts) || between().is_some_and(|normal| parts(&normal))
}

/// Whether a plane across a direction parts a piece from a cap wherever it is moved, by at least this gap, mm.
fn parts(piece: &impl Convex, cap: &Cap, moved: &Stretch, direction: &V3, gap: f64) -> bool {
    let [low, high] = moved.along(direction);
    let reach = |towards: V3| (piece.farthest(&towards) - cap.farthest(&-towards)).dot(direction);
    low + reach(-direction) >= gap || high + reach(*direction) <= -gap
}

/// What stops a tool that does not measure: one in contact may leave the probe that has given way under it.
pub fn obstacle(probes: &[ToolProbe], tool: &[Piece], from: Mcs, to: Mcs) -> Option<Contact> {
    let path = Path::new(from.into(), to.into());
    least(probes, tool, &path, &|piece, cap| {
        let met = convex::first(piece, cap, &path)?;
        // what a way leaves it does not meet again
        let leaves = || convex::normal(piece, cap, &(path.direction * path.length.min(GIVES_WAY))).is_some();
        (met.way > 0.0 || !leaves()).then_some(met)
    })
}

/// The earliest contact; what an axis of the machine parts from a cap on all of the way is not looked at.
fn least<T: Convex>(
    probes: &[ToolProbe],
    tool: &[T],
    path: &Path,
    meet: &dyn Fn(&T, &Cap) -> Option<Met>,
) -> Option<Contact> {
    let way = Stretch::straight(V3::zeros(), path.direction * path.length);
    let mut found: Option<Contact> = None;
    for (probe, solid) in probes.iter().enumerate() {
        let Some(cap) = solid.cap() else { continue };
        let far = |piece: &&T| AXES.iter().any(|axis| parts(*piece, &cap, &way, axis, TOLERANCE));
        for meeting in tool.iter().filter(|piece| !far(piece)).filter_map(|piece| meet(piece, &cap)) {
            if found.is_none_or(|before| meeting.way < before.meeting.way) {
                found = Some(Contact { probe, meeting });
            }
        }
    }
    found
}

/// Moves a tool until a probe switches: what is touched, and the way until the signal, mm. None where no signal comes
/// before `to`. A tool that is in contact gives its signal at once.
pub fn touch(
    probes: &[ToolProbe],
    tool: &[Piece],
    from: Mcs,
    to: Mcs,
    feed: f64,
    noise: &mut Noise,
) -> Option<(Contact, f64)> {
    let contact = first(probes, tool, from, to)?;
    if contact.meeting.way == 0.0 {
        return Some((contact, 0.0));
    }
    let probe = probes.get(contact.probe)?;
    let late = probe.pre_travel + probe.delay * feed / 60.0 + noise.scatter(probe.repeatability.0);
    let signal = (contact.meeting.way + late).max(0.0);
    let length = Path::new(from.into(), to.into()).length;
    (signal <= length).then_some((contact, signal))
}
