//! The tools and the probe by the steps in which they are in use.

use super::crease::CREASE;
use super::mesh::{Mesh, Vertex};
use super::solid::CHORD;
use super::{Matter, solid};
use crate::catalogue::find;
use crate::control::{Edge, LATHE_PROBE, probe::PROBE, upright};
use crate::entry::ProbeUse;
use crate::geometry::{Dir, Mcs, V3, figures};
use crate::machine::{InUse, Setup, Step};
use crate::run::outcome::Outcome;
use crate::workpiece::{Drawn, Probe, seen};
use nalgebra::{Matrix3, Rotation3};
use serde::{Serialize, Serializer};
use std::collections::BTreeSet;
use std::f64::consts::TAU;

/// What is drawn of what is in use, from the position of the machine on: the ball of the probe or the pieces of a tool;
/// on a turning machine also what carries it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ToolView", optional_fields))]
pub struct Tool {
    /// Length in effect along X Y Z, mm: where it changes, the axes stand still.
    pub length: Dir<Mcs>,
    /// Direction from the ball to what holds it; none: no probe.
    #[serde(skip_serializing_if = "Option::is_none", serialize_with = "direction")]
    #[cfg_attr(test, ts(as = "Option<[f64; 3]>"))]
    pub ball: Option<V3>,
    /// Pieces of the tool.
    pub pieces: Vec<Drawn>,
    /// What holds it on a turning machine.
    pub carrier: Vec<Drawn>,
    /// End of the tool.
    #[serde(serialize_with = "figures")]
    #[cfg_attr(test, ts(as = "[f64; 3]"))]
    pub tip: V3,
}

fn direction<S: Serializer>(direction: &Option<V3>, to: S) -> Result<S::Ok, S::Error> {
    figures(&direction.unwrap_or_default(), to)
}

/// Whatever was in use, each once, and from which entry on which of them.
pub fn tools(setup: &Setup, outcome: &Outcome) -> (Vec<Tool>, Vec<[usize; 2]>) {
    let measuring = called(outcome, ProbeUse::Workpiece);
    let measured = called(outcome, ProbeUse::Tool);
    let trace = &outcome.trace;
    let view = |used: &InUse| {
        let measures = |tool: &InUse| measured.iter().any(|(number, _)| *number == tool.place.0);
        let lent = uncorrected(used, &trace.in_use).filter(|tool| measures(tool) && !measuring.contains(&used.place));
        let used = lent.as_ref().unwrap_or(used);
        tool(setup, used, measuring.contains(&used.place))
    };
    (trace.in_use.iter().map(view).collect(), trace.entries.in_use())
}

/// T and D at the calls of cycles with this probe: with what a part was measured was the probe, whatever its data say.
fn called(outcome: &Outcome, probe: ProbeUse) -> BTreeSet<(i64, i64)> {
    let trace = &outcome.trace;
    let calls = trace.entries.others().filter(|entry| match entry.step {
        Step::CallBegin { cycle, .. } => {
            find(outcome.before.dialect, cycle).is_some_and(|cycle| cycle.purpose.probe == probe)
        }
        _ => false,
    });
    let used = calls.filter_map(|entry| trace.in_use.get(entry.in_use));
    used.map(|used| used.place).collect()
}

/// A tool whose correction is not in effect, before and after a macro of NCT that measures it: it hangs from the
/// spindle nose as while its register counted. None where a correction is in effect, or nothing tells of the tool.
fn uncorrected(used: &InUse, all: &[InUse]) -> Option<InUse> {
    let same = |one: &&InUse| one.place.0 == used.place.0 && one.tool.is_some();
    let known = all.iter().find(same).filter(|_| used.edge.is_none())?;
    let place = V3::from(known.tip) - V3::from(known.length) + V3::from(used.length);
    Some(InUse { length: used.length, tip: place.into(), ..known.clone() })
}

fn tool(setup: &Setup, used: &InUse, measured: bool) -> Tool {
    let is_probe = |edge: &Edge| measured || [PROBE, LATHE_PROBE].contains(&edge.kind);
    let probe = used.edge.as_ref().is_none_or(is_probe);
    let Some(tool) = used.tool.as_ref().filter(|_| !probe) else { return ball(setup, used) };
    let tip = V3::from(used.tip);
    let carrier = V3::from(used.length) - tip;
    let (pieces, along) = seen::tool(tool, carrier, used.plane, used.spindle);
    let holder = held(setup, used, carrier, along);
    Tool { length: used.length, ball: None, tip, pieces: moved(pieces, tip), carrier: moved(holder, tip) }
}

/// Ball and stylus. The axis points from the ball to what holds it, in machine coordinates: along the applicate of the
/// plane in which was measured, on a turning machine as the cutting edge position says.
fn ball(setup: &Setup, used: &InUse) -> Tool {
    let carrier = V3::from(used.length);
    let turning = used.edge.as_ref().and_then(Edge::stands);
    let axis = V3::from(turning.unwrap_or_else(|| upright(used.plane)));
    let adapter = used.turns.then_some(setup.probe.length).and_then(|length| seen::adapter(length, carrier, axis));
    Tool {
        length: used.length,
        ball: Some(axis),
        tip: V3::zeros(),
        pieces: adapter.into_iter().collect(),
        carrier: held(setup, used, carrier, axis),
    }
}

fn held(setup: &Setup, used: &InUse, carrier: V3, along: V3) -> Vec<Drawn> {
    if used.turns { seen::turret(&setup.turret, carrier, along) } else { Vec::new() }
}

/// Pieces that begin at the end of a tool, from the position of the machine on.
fn moved(pieces: Vec<Drawn>, tip: V3) -> Vec<Drawn> {
    let piece = |piece| match piece {
        Drawn::Round { outline, axis, at } => Drawn::Round { outline, axis, at: at + tip },
        Drawn::Plate { corners, thick, cuts } => {
            Drawn::Plate { corners: corners.into_iter().map(|at| at + tip).collect(), thick, cuts }
        }
    };
    pieces.into_iter().map(piece).collect()
}

/// Radius of the body of a probe where nothing is told of it, and of a stylus, in radii of the ball.
const BODY: f64 = 4.4;
const USUAL: f64 = 0.45;
/// Where the signal ring of a body lies, share of its length.
const RING: [f64; 2] = [0.1, 0.24];
/// Outline of what holds a body in a spindle, in radii of the body: distance from the axis and height above the body.
const NOSE: [[f64; 2]; 10] = [
    [0.7, 0.0],
    [0.95, 0.25],
    [1.2, 0.25],
    [1.2, 0.5],
    [1.04, 0.62],
    [1.2, 0.74],
    [1.2, 1.0],
    [0.86, 1.0],
    [0.98, 2.6],
    [0.0, 2.6],
];

/// Of the stylus as it is drawn, mm.
pub fn stylus_radius(probe: &Probe) -> f64 {
    match probe.stylus_radius() {
        0.0 => USUAL * probe.radius,
        radius => radius,
    }
}

/// From the centre of the ball to where the stylus is drawn to end, mm. `longest`: where nothing is told of the body.
pub fn stylus_reach(probe: &Probe, longest: f64) -> f64 {
    let usual = || probe.length.min(longest.max(10.0 * probe.radius));
    probe.body.map_or_else(usual, |body| body.distance)
}

/// What is drawn of a tool, solid pieces first: of what each is, and its triangles.
pub fn meshes(tool: &Tool, probe: &Probe, reach: f64) -> Vec<(Matter, Mesh)> {
    let pieces = tool.pieces.iter().map(|piece| {
        let cuts = matches!(piece, Drawn::Plate { cuts: true, .. });
        (if cuts { Matter::Ball } else { Matter::Stylus }, drawn(piece))
    });
    let free = tool.carrier.is_empty() && tool.pieces.is_empty();
    let stylus = tool.ball.iter().flat_map(|axis| stylus(probe, *axis, reach, free));
    let carrier = tool.carrier.iter().map(|piece| (Matter::Carrier, drawn(piece)));
    pieces.chain(stylus).chain(carrier).collect()
}

/// Ball, stylus and body of a probe. Where nothing is told of the body, a usual one is drawn, which nothing touches.
fn stylus(probe: &Probe, axis: V3, reach: f64, free: bool) -> Vec<(Matter, Mesh)> {
    let (r, thin) = (probe.radius, stylus_radius(probe));
    let round = |outline: &[[f64; 2]]| revolved(outline, axis, V3::zeros());
    let mut ball = Mesh::default();
    let own = along(axis);
    let mut rows = solid::ball(r, solid::turns(2.0 * r, CHORD));
    rows.iter_mut().flatten().for_each(|vertex| *vertex = vertex.map(|one| own * one));
    ball.sheet(&rows, true);
    let begin = reach.min(0.8 * r);
    let stem = round(&[[thin, begin], [thin, reach]]);
    let body = body(probe, thin, reach);
    let mut drawn = vec![(Matter::Ball, ball), (Matter::Stem, stem)];
    drawn.extend(body.outlines().map(|(matter, outline)| (matter, round(&outline))));
    if free {
        drawn.push((Matter::Carrier, round(&body.nose())));
    }
    drawn
}

/// A probe body about its axis: where its lower face is, how wide that is there, where the cylinder begins, how wide
/// that is, and where it ends, mm from the centre of the ball.
struct BodyShape {
    face: [f64; 2],
    begins: f64,
    radius: f64,
    ends: f64,
}

fn body(probe: &Probe, thin: f64, reach: f64) -> BodyShape {
    let r = probe.radius;
    match probe.body {
        Some(body) => {
            let ends = probe.length.max(body.distance + body.radius);
            BodyShape { face: [thin, body.distance], begins: body.distance, radius: body.radius, ends }
        }
        None => {
            let ends = (reach + 9.0 * r).max((reach + 14.0 * r).min(probe.length));
            BodyShape { face: [thin, reach], begins: reach + 3.0 * r, radius: BODY * r, ends }
        }
    }
}

impl BodyShape {
    /// The body below, its signal ring, and the body above.
    fn outlines(&self) -> impl Iterator<Item = (Matter, Vec<[f64; 2]>)> {
        let BodyShape { face, begins, radius, ends } = *self;
        let along = |part: f64| begins + part * (ends - begins);
        let [low, high] = RING.map(along);
        let lower = vec![face, [radius, begins], [radius, low]];
        let upper = vec![[radius, high], [radius, ends], [0.0, ends]];
        [(Matter::Body, lower), (Matter::Ring, vec![[radius, low], [radius, high]]), (Matter::Body, upper)].into_iter()
    }

    /// What holds the body in the spindle: a flange with its groove, and the nose above.
    fn nose(&self) -> Vec<[f64; 2]> {
        let (radius, ends) = (self.radius, self.ends);
        NOSE.map(|[out, up]| [out * radius, ends + up * radius]).to_vec()
    }
}

fn drawn(piece: &Drawn) -> Mesh {
    match piece {
        Drawn::Round { outline, axis, at } => revolved(outline, axis.normalize(), *at),
        Drawn::Plate { corners, thick, .. } => plate(corners, *thick),
    }
}

/// The rotation that takes +Z to a unit vector.
fn along(axis: V3) -> Rotation3<f64> {
    let aside = if axis.x.abs() < 0.9 { V3::x() } else { V3::y() };
    let side = aside.cross(&axis).normalize();
    Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[side.cross(&axis), side, axis]))
}

/// Half of a section turned about an axis: distance from it and height over `at`.
fn revolved(outline: &[[f64; 2]], axis: V3, at: V3) -> Mesh {
    let own = along(axis);
    let widest = outline.iter().fold(0.0_f64, |most, [r, _]| most.max(*r));
    let count = solid::turns(widest, CHORD);
    let around: Vec<(f64, f64)> = (0..count).map(|i| (TAU * i as f64 / count as f64).sin_cos()).collect();
    let row = |[r, z]: [f64; 2], [out, up]: [f64; 2]| -> Vec<Vertex> {
        let vertex = |(sine, cosine): &(f64, f64)| {
            let normal = V3::new(out * cosine, out * sine, up);
            [at + own * V3::new(r * cosine, r * sine, z), own * normal]
        };
        around.iter().map(vertex).collect()
    };
    let mut mesh = Mesh::default();
    for (place, ends) in outline.windows(2).enumerate() {
        let [begin, end] = [place, place + 1].map(|corner| slope_at(outline, place, corner));
        mesh.sheet(&[row(ends[0], begin), row(ends[1], end)], true);
    }
    mesh
}

/// Normal of a piece of an outline at one of its corners, out and up: that of both pieces there where they bend little.
fn slope_at(outline: &[[f64; 2]], piece: usize, corner: usize) -> [f64; 2] {
    let slope = |piece: usize| {
        let [[r0, z0], [r1, z1]] = [*outline.get(piece)?, *outline.get(piece + 1)?];
        let length = (z1 - z0).hypot(r0 - r1);
        (length > 0.0).then(|| [(z1 - z0) / length, (r0 - r1) / length])
    };
    let Some([out, up]) = slope(piece) else { return [0.0, 1.0] };
    let other = if corner == piece { piece.checked_sub(1).and_then(slope) } else { slope(corner) };
    let Some([o, u]) = other.filter(|[o, u]| out * o + up * u > CREASE) else { return [out, up] };
    let length = (out + o).hypot(up + u);
    [(out + o) / length, (up + u) / length]
}

/// Both faces of a flat piece, and its border.
fn plate(corners: &[V3], thick: V3) -> Mesh {
    let mut mesh = Mesh::default();
    let out = thick.try_normalize(0.0).unwrap_or_else(V3::z);
    let middle = corners.iter().sum::<V3>() / corners.len().max(1) as f64;
    let far: Vec<V3> = corners.iter().map(|corner| corner + thick).collect();
    mesh.flat(corners, -out);
    mesh.flat(&far, out);
    for (i, corner) in corners.iter().enumerate() {
        let next = corners[(i + 1) % corners.len()];
        let border = (next - corner).cross(&thick);
        let Some(normal) = border.try_normalize(0.0) else { continue };
        let side = if normal.dot(&(corner - middle)) < 0.0 { -normal } else { normal };
        mesh.flat(&[*corner, next, next + thick, corner + thick], side);
    }
    mesh
}
