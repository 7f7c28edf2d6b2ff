//! What is drawn of a tool and of what carries it. Of a turning tool only the nose can touch, which is `tool::Nose`;
//! the insert and the shank behind it, the holder and the turret follow from the tool data and are out of the way.

mod milling;

use super::{Cut, Nose, Spindle, Tool, tool::in_plane};
use crate::control::Plane;
use crate::geometry::{Degrees, V3, figures};
use serde::{Deserialize, Serialize, Serializer};

/// Half of the angle of an insert at its nose, degree: one that cuts along both axes, and one that cuts to both sides.
const HALF_ANGLE: [f64; 2] = [40.0, 17.5];
/// How far the edges of an insert reach beyond its nose, and its thickness, mm.
const INSERT: [f64; 2] = [11.0, 4.8];
/// Width and thickness of a shank, mm.
const SHANK: f64 = 20.0;
/// How far the upper side of a shank lies below that of the insert, mm.
const SEAT: f64 = 1.2;
/// How far the nose stands out beyond the side of the shank, and the shank begins behind the nose, mm.
const STANDS_OUT: f64 = 5.0;
const BEHIND: f64 = 7.0;
/// Least length of a shank, mm.
const SHORTEST: f64 = 35.0;
/// Radius of what joins a probe with its holder, mm.
const ADAPTER: f64 = 8.0;
/// Half of the thickness of a holder, mm.
const WALL: f64 = 16.0;

/// A piece of what is drawn, machine axes, mm from the point to which the tool length refers.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ToolPiece"))]
pub enum Drawn {
    /// Half of a section through an axis, turned about it.
    Round {
        /// Distance from the axis and height over `at`.
        outline: Vec<[f64; 2]>,
        /// Direction of the axis.
        #[serde(serialize_with = "figures")]
        #[cfg_attr(test, ts(as = "[f64; 3]"))]
        axis: V3,
        /// Where it begins.
        #[serde(serialize_with = "figures")]
        #[cfg_attr(test, ts(as = "[f64; 3]"))]
        at: V3,
    },
    /// A flat piece.
    Plate {
        /// Corners in turn; convex.
        #[serde(serialize_with = "points")]
        #[cfg_attr(test, ts(as = "Vec<[f64; 3]>"))]
        corners: Vec<V3>,
        /// From there to the other face.
        #[serde(serialize_with = "figures")]
        #[cfg_attr(test, ts(as = "[f64; 3]"))]
        thick: V3,
        /// Whether it is an insert, which cuts.
        cuts: bool,
    },
}

fn points<S: Serializer>(points: &[V3], to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(points.iter().map(|point| <[f64; 3]>::from(*point)))
}

/// The disc of a turret, its axis parallel to that of the spindle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Turret {
    /// Diameter, mm; 0: none is drawn.
    pub diameter: f64,
    /// Width, mm.
    pub width: f64,
}

impl Default for Turret {
    fn default() -> Turret {
        Turret { diameter: 160.0, width: 40.0 }
    }
}

/// A tool from its end on, and where it leads; `carrier`: to where it is held, `spindle`: how teeth stand.
pub fn tool(tool: &Tool, carrier: V3, plane: Plane, spindle: Option<Spindle>) -> (Vec<Drawn>, V3) {
    match &tool.cut {
        Cut::Nose(nose) => turning_tool(nose, carrier, plane),
        Cut::Cutter(cutter) => milling::tool(cutter, carrier, plane, spindle),
    }
}

/// A turning tool: its insert and the shank, from the point P on.
fn turning_tool(nose: &Nose, carrier: V3, plane: Plane) -> (Vec<Drawn>, V3) {
    let axes = plane.axes();
    let carrier = [carrier[axes[0]], carrier[axes[1]]];
    let plate = |corners: Vec<[f64; 2]>, above: f64, thick: f64, cuts: bool| {
        let place = |[abscissa, ordinate]: [f64; 2]| {
            let [side, over] = nose.side.map(|side| side * nose.radius);
            in_plane(axes, [abscissa - side, ordinate - over, above])
        };
        let corners = corners.into_iter().map(place).collect();
        Drawn::Plate { corners, thick: in_plane(axes, [0.0, 0.0, -thick]), cuts }
    };
    let lies = lies(nose, carrier);
    let along = V3::ith(axes[lies.0], lies.1);
    let pieces =
        vec![plate(insert(nose), 0.0, INSERT[1], true), plate(shank(nose, carrier, lies), -SEAT, SHANK - SEAT, false)];
    (pieces, along)
}

/// The insert about S: the round of the nose, and the other corners of a rhombus; a button where there is no corner.
fn insert(nose: &Nose) -> Vec<[f64; 2]> {
    let [abscissa, ordinate] = nose.side;
    let round = |from: f64, to: f64, pieces: u32| {
        let point = move |piece: u32| {
            let (sine, cosine) = Degrees(from + (to - from) * f64::from(piece) / f64::from(pieces)).sin_cos();
            [nose.radius * cosine, nose.radius * sine]
        };
        (0..=pieces).map(point)
    };
    if nose.side == [0.0; 2] {
        return round(0.0, 345.0, 23).collect();
    }
    let half = HALF_ANGLE[usize::from(abscissa == 0.0 || ordinate == 0.0)];
    let tip = ordinate.atan2(abscissa).to_degrees();
    let (sine, cosine) = Degrees(half).sin_cos();
    let edge = INSERT[0] + nose.radius * cosine / sine;
    let from_corner = |ways: &[f64]| {
        let (sine_tip, cosine_tip) = Degrees(tip).sin_cos();
        let corner = nose.radius / sine;
        ways.iter().fold([corner * cosine_tip, corner * sine_tip], |[x, y], direction| {
            let (sine, cosine) = Degrees(*direction).sin_cos();
            [x + edge * cosine, y + edge * sine]
        })
    };
    let [left, right] = [tip + 180.0 - half, tip + 180.0 + half];
    let mut corners: Vec<_> = round(tip - 90.0 + half, tip + 90.0 - half, 12).collect();
    corners.extend([&[left][..], &[left, right], &[right]].map(from_corner));
    corners
}

/// Axis and direction in the plane in which the shank leads to where it is held: away from the nose, the longer way.
fn lies(nose: &Nose, carrier: [f64; 2]) -> (usize, f64) {
    let way = |axis: usize| match nose.side[axis] {
        0.0 if nose.side[1 - axis] == 0.0 => (carrier[axis].abs(), 1.0_f64.copysign(carrier[axis])),
        0.0 => (f64::NEG_INFINITY, 1.0),
        side => (-side * carrier[axis], -side),
    };
    let [abscissa, ordinate] = [0, 1].map(way);
    if abscissa.0 > ordinate.0 { (0, abscissa.1) } else { (1, ordinate.1) }
}

/// The shank about S.
fn shank(nose: &Nose, carrier: [f64; 2], (axis, direction): (usize, f64)) -> Vec<[f64; 2]> {
    let end = (direction * carrier[axis]).max(SHORTEST + nose.radius);
    let side = nose.side[1 - axis];
    // across and along the shank, both away from S
    let outline = if side == 0.0 {
        let narrow = (nose.radius * 0.6).max(3.0);
        let begin = if nose.side == [0.0; 2] { 0.0 } else { BEHIND };
        let wide = begin + SHANK;
        let half = (SHANK / 2.0).max(narrow);
        [[-narrow, begin], [narrow, begin], [half, wide], [half, end.max(wide)], [-half, end.max(wide)], [-half, wide]]
            .to_vec()
    } else {
        let outside = side * (nose.radius - STANDS_OUT);
        let across = |inwards: f64| outside - side * inwards;
        vec![
            [across(0.0), BEHIND],
            [across(SHANK / 2.0), BEHIND],
            [across(SHANK), BEHIND + SHANK / 2.0],
            [across(SHANK), end],
            [across(0.0), end],
        ]
    };
    let place = |[across, along]: [f64; 2]| {
        let mut point = [0.0; 2];
        (point[axis], point[1 - axis]) = (direction * along, across);
        point
    };
    outline.into_iter().map(place).collect()
}

/// What joins a probe, so long from the ball in this direction, with where it is held; none: it is long enough.
pub fn adapter(length: f64, carrier: V3, along: V3) -> Option<Drawn> {
    let end = carrier.dot(&along);
    let outline = || cylinder(ADAPTER, 0.9 * length, end);
    (end > length).then(|| Drawn::Round { outline: outline(), axis: along, at: V3::zeros() })
}

/// Half of the section of a cylinder from one height to another, mm.
fn cylinder(radius: f64, begin: f64, end: f64) -> Vec<[f64; 2]> {
    vec![[0.0, begin], [radius, begin], [radius, end], [0.0, end]]
}

/// The disc of a turret and the holder on it. `carrier`: from the point to which the tool length refers to where the
/// tool is held, `along`: the direction in which the tool leads there. Nothing where the tool has no length.
pub fn turret(turret: &Turret, carrier: V3, along: V3) -> Vec<Drawn> {
    let (transverse, spindle) = (0, 2); // X and Z of the machine
    if turret.diameter <= 0.0 || carrier.norm() <= WALL {
        return Vec::new();
    }
    let held = along * carrier.dot(&along).max(0.0);
    let away = |axis: usize| 1.0_f64.copysign(carrier[axis]);
    let low = held.inf(&carrier) - V3::repeat(WALL);
    let high = held.sup(&carrier) + V3::repeat(WALL);
    let corner = |x: f64, z: f64| V3::new(x, -WALL, z);
    let holder = Drawn::Plate {
        corners: vec![corner(low.x, low.z), corner(high.x, low.z), corner(high.x, high.z), corner(low.x, high.z)],
        thick: V3::y() * (2.0 * WALL),
        cuts: false,
    };
    let radius = turret.diameter / 2.0;
    let mut at = carrier;
    at[transverse] += away(transverse) * (radius - WALL);
    at[spindle] += away(spindle) * WALL;
    let outline = cylinder(radius, 0.0, turret.width);
    vec![holder, Drawn::Round { outline, axis: V3::ith(spindle, away(spindle)), at }]
}

#[cfg(test)]
mod tests;
