//! A tool as it really is, not as the control believes, and what of it can touch: a milling cutter or drill about its
//! axis, or the nose of a turning tool.

use crate::control::{Control, Edge, Plane, tools::side};
use crate::geometry::{Convex, Degrees, Dir, Mcs, V3};
use serde::{Deserialize, Serialize};

/// Height of a drill's point per mm of its radius: the usual point of 118 degree.
const DRILL_POINT: f64 = 0.600_860_619;
/// Least height of a cutter, mm.
const HEIGHT: f64 = 50.0;

/// A tool.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "RealTool"))]
pub struct Tool {
    /// L1, L2 and L3 as they are, mm: to the lowest edge of a cutter in its axis; to the point P of a turning tool.
    pub length: [f64; 3],
    /// What cuts.
    pub cut: Cut,
}

/// What cuts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Cut {
    /// Milling cutter or drill.
    Cutter(Cutter),
    /// Turning tool.
    Nose(Nose),
}

/// A milling cutter or drill about its axis, with a flat end or one that ends in a point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Cutter {
    /// Radius to the cutting edge, mm.
    pub radius: f64,
    /// Radius between end and side, mm.
    #[serde(default)]
    pub corner: f64,
    /// How far the lowest place of an edge lies inside of the widest, and below it, mm; beside `corner`.
    #[serde(default)]
    pub chamfer: [f64; 2],
    /// Number of teeth, evenly spread; 0: smooth all round.
    #[serde(default)]
    pub teeth: u32,
    /// Where the first tooth stands with the spindle at 0, degree.
    #[serde(default)]
    pub angle: Degrees,
    /// How far the axis of the cutter stands beside that of the spindle, and how much lower than in the mean a tooth in
    /// that direction stands, mm. A smooth cutter has neither.
    #[serde(default)]
    pub runout: [f64; 2],
    /// Direction of the run-out with the spindle at 0.
    #[serde(default)]
    pub runout_angle: Degrees,
    /// Axis of the plane along which it stands, its end in minus direction: 0 abscissa, 1 ordinate, 2 applicate.
    #[serde(default = "applicate")]
    pub axis: usize,
    /// Width of a groove mill, mm, whose length goes to its upper edge, that at the shank; 0: another cutter, whose
    /// length goes to the lowest edge. What holds a groove mill is out of the way.
    #[serde(default)]
    pub disc: f64,
}

fn applicate() -> usize {
    2
}

/// The nose of a turning tool. It lies in the plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Nose {
    /// Radius, mm.
    pub radius: f64,
    /// From the centre S to the point P in abscissa and ordinate, in nose radii: -1, 0 or 1.
    pub side: [f64; 2],
}

/// Whether the spindle that holds a cutter is stopped, and at which angle, or rotates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spindle {
    /// It stands turned by this angle, positive from abscissa to ordinate of the cutter's own plane.
    Stands(Degrees),
    /// It turns: the highest edge comes by everywhere.
    Turns,
}

/// Abscissa, ordinate and applicate along these axes of the machine.
pub fn in_plane(axes: [usize; 3], parts: [f64; 3]) -> V3 {
    let mut point = V3::zeros();
    axes.into_iter().zip(parts).for_each(|(axis, part)| point[axis] += part);
    point
}

/// Direction across an axis of the machine: 0 is the next axis of X, Y, Z, 90 degree the one behind it.
pub fn across(axis: usize, angle: Degrees) -> V3 {
    let (sine, cosine) = angle.sin_cos();
    V3::ith((axis + 1) % 3, 1.0) * cosine + V3::ith((axis + 2) % 3, 1.0) * sine
}

impl Tool {
    /// A tool that is as the control believes: turning tools by their cutting edge position as it is, drills with a
    /// point, anything else a smooth cutter with its corner radius (`$TC_DP7`). How a cutter lies no datum tells: along
    /// the applicate, and where it is as long as a turning tool along the abscissa.
    pub fn nominal(edge: &Edge, control: &Control) -> Tool {
        let radius = edge.total_radius().max(0.0);
        let [.., along_third] = control.length_axes(edge);
        let cut = if edge.is_turning() {
            Cut::Nose(Nose { radius, side: side(edge.tip, false) })
        } else {
            let drill = (200..300).contains(&edge.kind);
            let corner = edge.further.get(&7).copied().unwrap_or(0.0);
            Cut::Cutter(Cutter {
                chamfer: if drill { [radius, radius * DRILL_POINT] } else { [0.0; 2] },
                corner: if drill { 0.0 } else { corner.max(0.0).min(radius) },
                axis: if along_third == 2 { 0 } else { 2 },
                ..Cutter::smooth(radius)
            })
        };
        Tool { length: [0, 1, 2].map(|i| edge.total_length(i)), cut }
    }

    /// A tool whose nose with `mirrored` lies on the other side in the ordinate.
    pub fn recoded(mut self, mirrored: bool) -> Tool {
        if let Cut::Nose(nose) = &mut self.cut
            && mirrored
        {
            nose.side[1] = 0.0 - nose.side[1];
        }
        self
    }

    /// From the point to which the control's lengths in use refer to the one to which its own refer: X Y Z, mm.
    pub fn error(&self, control: &Control) -> Dir<Mcs> {
        let mut error = control.active_length();
        if let Some(edge) = control.active_edge() {
            let axes = control.plane.axes();
            for (real, axis) in self.length.into_iter().zip(control.length_axes(edge)) {
                error[axes[axis]] -= real;
            }
        }
        error
    }

    /// What of it can touch, the point to which its lengths refer standing at `point`, machine coordinates.
    pub fn pieces(&self, point: V3, plane: Plane, spindle: Spindle) -> Vec<Piece> {
        let axes = plane.axes();
        match &self.cut {
            Cut::Nose(nose) => {
                let side = in_plane(axes, [nose.side[0], nose.side[1], 0.0]);
                vec![Piece::Nose { centre: point - side * nose.radius, radius: nose.radius, across: axes[2] }]
            }
            Cut::Cutter(cutter) => cutter.pieces(point, axes, spindle),
        }
    }
}

impl Cutter {
    /// Smooth, with a flat end, along the applicate.
    pub fn smooth(radius: f64) -> Cutter {
        Cutter {
            radius,
            corner: 0.0,
            chamfer: [0.0; 2],
            teeth: 0,
            angle: Degrees(0.0),
            runout: [0.0; 2],
            runout_angle: Degrees(0.0),
            axis: 2,
            disc: 0.0,
        }
    }

    /// The teeth: distance from the spindle axis, mm, direction with the spindle at 0, how far below the mean, mm.
    pub fn edges(&self) -> Vec<(f64, Degrees, f64)> {
        let (away_sine, away_cosine) = self.runout_angle.sin_cos();
        let [aside, lower] = self.runout;
        let tooth = |number: u32| {
            let angle = self.angle + Degrees(360.0 * f64::from(number) / f64::from(self.teeth));
            let (sine, cosine) = angle.sin_cos();
            let x = self.radius * cosine + aside * away_cosine;
            let y = self.radius * sine + aside * away_sine;
            let direction = if aside == 0.0 { angle } else { Degrees::of(y.atan2(x)) };
            let drop = lower * (cosine * away_cosine + sine * away_sine);
            (x.hypot(y), direction, drop)
        };
        (0..self.teeth).map(tooth).collect()
    }

    /// Half of its section from the end in the axis outwards and up, mm: distance and height; `radius`: of the tooth.
    pub fn outline(&self, radius: f64) -> Vec<[f64; 2]> {
        let profile = self.profile(radius);
        let [.., top] = profile.points;
        let outside = (-6..=0).map(|step| {
            let (sine, cosine) = Degrees(15.0 * f64::from(step)).sin_cos();
            profile.farthest([cosine, sine])
        });
        let mut outline = vec![[0.0; 2]];
        outline.extend(outside);
        outline.push(top);
        outline.dedup();
        outline
    }

    /// Axis of the machine along which it stands (0 X), and direction from its end to the rest; `axes`: of the plane.
    pub fn stands(&self, axes: [usize; 3]) -> (usize, V3) {
        let along = axes[self.axis.min(2)];
        let up = V3::ith(along, 1.0);
        (along, if self.disc > 0.0 { -up } else { up })
    }

    fn pieces(&self, point: V3, axes: [usize; 3], spindle: Spindle) -> Vec<Piece> {
        let (along, body) = self.stands(axes);
        let piece = |(radius, direction, drop), round: bool| Piece::Turned {
            end: point - V3::ith(along, 1.0) * drop,
            up: body,
            out: (!round).then(|| across(along, direction)),
            profile: self.profile(radius),
        };
        match spindle {
            _ if self.teeth == 0 => vec![piece((self.radius, Degrees(0.0), 0.0), true)],
            Spindle::Turns => self.edges().into_iter().map(|edge| piece(edge, true)).collect(),
            Spindle::Stands(angle) => {
                let turned = |(radius, direction, drop)| (radius, direction + angle, drop);
                self.edges().into_iter().map(turned).map(|edge| piece(edge, false)).collect()
            }
        }
    }

    fn profile(&self, radius: f64) -> Profile {
        let [inside, above] = self.chamfer;
        let corner = self.corner.min(radius);
        let top = if self.disc > 0.0 { self.disc } else { HEIGHT.max(2.0 * (corner + above)) };
        Profile {
            corner,
            points: [
                [0.0, corner],
                [(radius - corner - inside).max(0.0), corner],
                [radius - corner, corner + above],
                [radius - corner, top],
                [0.0, top],
            ],
        }
    }
}

/// A convex piece of a tool.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// A profile turned about its axis, or one tooth that stands.
    Turned {
        /// End of the piece in the axis.
        end: V3,
        /// Along the axis, away from the end.
        up: V3,
        /// Direction of a tooth that stands; none: turned all round.
        out: Option<V3>,
        /// What is turned.
        profile: Profile,
    },
    /// Round nose of a turning tool; what holds it is out of the way.
    Nose {
        /// S.
        centre: V3,
        /// Radius, mm.
        radius: f64,
        /// Index of the axis across the plane.
        across: usize,
    },
}

/// Half of the section of a cutter: distance from its axis and height, mm, a polygon within a border of `corner`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Profile {
    corner: f64,
    points: [[f64; 2]; 5],
}

impl Convex for Piece {
    fn farthest(&self, direction: &V3) -> V3 {
        match self {
            Piece::Turned { end, up, out, profile } => {
                let high = direction.dot(up);
                let aside = direction - up * high;
                let all_round = || aside.try_normalize(0.0).unwrap_or_else(V3::zeros);
                let (out, wide) = out.map_or_else(|| (all_round(), aside.norm()), |out| (out, direction.dot(&out)));
                let [away, height] = profile.farthest([wide, high]);
                end + out * away + up * height
            }
            Piece::Nose { centre, radius, across } => {
                let mut inside = *direction;
                inside[*across] = 0.0;
                centre + inside.try_normalize(0.0).unwrap_or_else(V3::zeros) * *radius
            }
        }
    }
}

impl Profile {
    /// The point that lies farthest in a direction; towards the axis the profile ends there.
    fn farthest(&self, [wide, high]: [f64; 2]) -> [f64; 2] {
        let reach = |[x, y]: &[f64; 2]| x * wide + y * high;
        let [x, y] = self.points.iter().max_by(|a, b| reach(a).total_cmp(&reach(b))).copied().unwrap_or_default();
        let size = wide.hypot(high);
        if wide < 0.0 {
            return [0.0, if high < 0.0 { 0.0 } else { self.points[4][1] }];
        }
        if size == 0.0 {
            return [x, y];
        }
        [x + self.corner * wide / size, y + self.corner * high / size]
    }
}
