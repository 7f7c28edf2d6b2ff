//! What of the probe can touch: its ball, the stylus above it, and the body that holds the stylus.

use super::tool::in_plane;
use super::{Body, Boundary, Contact, Cut, Probe, Tool};
use crate::geometry::rod::around;
use crate::geometry::{Dir, Mcs, Met, Path, Rod, Stretch, Swept, TOLERANCE, V3, earliest, rod};
use std::f64::consts::TAU;

/// Rounding of the lower edge of a body, mm.
const ROUNDED: f64 = 0.5;
/// How deep the foot of a rod that stands on the part may seem to reach into it, mm: so exactly a contact is found.
const STANDS: f64 = 1e-6;
/// Pieces of a round edge that are looked at before the directions in them.
const SECTORS: usize = 12;

/// What touches.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Touching {
    /// The ball.
    #[default]
    Ball,
    /// The stylus between ball and body: it is deflected like the ball, and the probe switches.
    Stylus,
    /// The body: nothing is deflected.
    Body,
    /// A tool, at a tool probe.
    Tool,
    /// A tool, at the part: nothing is deflected.
    Cutter,
}

impl Touching {
    /// Whether it is what measures: the ball, or a tool.
    pub fn measures(&self) -> bool {
        matches!(self, Touching::Ball | Touching::Tool)
    }

    /// Whether a probe switches by it.
    pub fn switches(self) -> bool {
        !matches!(self, Touching::Body | Touching::Cutter)
    }
}

/// The probe as it stands: stylus and body seen from the centre of the ball, machine axes, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Feeler {
    /// Radius of the ball.
    pub radius: f64,
    stylus: Option<Rod>,
    body: Option<Rod>,
}

/// Where part or tool probe stops a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Obstacle {
    /// Part of the way that is done, 0 to 1.
    pub part: f64,
    /// Position then: of a measuring motion where the signal comes, after pre-travel and delay.
    pub stop: Mcs,
    /// Centre of the ball then, or of a tool the point to which its lengths refer.
    pub ball: Mcs,
    /// Point touched.
    pub point: Mcs,
    /// Outward unit normal there.
    pub normal: Dir<Mcs>,
    /// What of the probe touches; of a tool always what stands for its ball.
    pub by: Touching,
}

impl Obstacle {
    /// Of what is met on a way of the centre of the ball, which is the position.
    pub(super) fn on(way: &Path, met: &Met, by: Touching) -> Obstacle {
        let part = if way.length > 0.0 { met.way / way.length } else { 0.0 };
        let ball = way.at(met.way).into();
        Obstacle { part, stop: ball, ball, point: met.point.into(), normal: met.normal.into(), by }
    }

    /// What the ball meets, or what stylus or body meet on its way there, of this length, mm.
    pub fn or_before(self, caught: Option<Obstacle>, length: f64) -> Obstacle {
        let before = caught.filter(|met| (1.0 - met.part) * length > TOLERANCE);
        before.map_or(self, |met| Obstacle { part: met.part * self.part, ..met })
    }
}

impl Feeler {
    /// A ball alone.
    pub fn ball(radius: f64) -> Feeler {
        Feeler { radius, stylus: None, body: None }
    }

    /// Ball, stylus and body of a probe; `up`: unit vector from the ball to what holds it.
    pub fn new(probe: &Probe, up: Dir<Mcs>) -> Feeler {
        let up = V3::from(up);
        let rod = |from: f64, to: f64, radius: f64| {
            (to > from && radius > 0.0).then(|| Rod { foot: up * from, up, length: to - from, radius })
        };
        let (held, thick) = (probe.held(), probe.stylus_radius());
        // one that is thicker than the ball ends round at the height of its centre
        let lowest = if thick > probe.radius { thick } else { 0.0 };
        let body = probe.body.and_then(|body| {
            let end = probe.length.max(held + body.radius);
            rod(held, end, body.radius)
        });
        Feeler { radius: probe.radius, stylus: rod(lowest, held, thick), body }
    }

    /// A tool, and the way from where its lengths end to what stands for the centre of the ball. It is looked at as a
    /// cylinder of its widest edge as far as the spindle, with the round end or the point that it has; `axes`: of the
    /// plane.
    pub fn tool(tool: &Tool, axes: [usize; 3]) -> (Feeler, Dir<Mcs>) {
        let cutter = match &tool.cut {
            Cut::Nose(nose) => {
                let [first, second] = nose.side.map(|side| -side * nose.radius);
                return (Feeler::ball(nose.radius), in_plane(axes, [first, second, 0.0]).into());
            }
            Cut::Cutter(cutter) => cutter,
        };
        let up = V3::ith(axes[cutter.axis.min(2)], 1.0);
        let radius = cutter.edges().into_iter().map(|(radius, ..)| radius).fold(cutter.radius, f64::max);
        let [_, point] = cutter.chamfer;
        let long = tool.length.into_iter().fold(radius, f64::max) + radius;
        let rod = |foot: f64| Rod { foot: up * foot, up, length: long, radius };
        match cutter.corner >= radius {
            true => (Feeler { radius, stylus: Some(rod(0.0)), body: None }, (up * radius).into()),
            false => {
                let flat = Feeler { radius: 0.0, stylus: None, body: (radius > 0.0).then(|| rod(point)) };
                (flat, (up * -cutter.disc).into())
            }
        }
    }

    /// Stylus and body, if there are any.
    pub fn rods(&self) -> impl Iterator<Item = (Touching, Rod)> {
        let rods = [(Touching::Stylus, self.stylus), (Touching::Body, self.body)];
        rods.into_iter().filter_map(|(by, rod)| rod.map(|rod| (by, rod)))
    }

    /// What stylus and body meet first, the ball going straight; its centre is the position. What goes through their
    /// axis at the start is met at once; not where the ball is pressed into the part: the stylus leans, and where to,
    /// nobody knows.
    pub fn caught(&self, part: &Boundary, from: Mcs, to: Mcs) -> Option<Obstacle> {
        let path = Path::new(from.into(), to.into());
        let way = Stretch::straight(from.into(), to.into());
        let met = self.rods().filter_map(|(by, rod)| {
            let placed = Rod { foot: path.from + rod.foot, ..rod };
            let end = self.end(by);
            if !part.may_meet(&self.swept(&rod, by, &way)) {
                return None;
            }
            let pressed = || matches!(part.first(self.radius, from, from), Contact::Already(..));
            let met = match part.pierced(&placed) {
                Some(_) if pressed() => None,
                Some(met) => Some(met),
                None => part.first_of_rod(&placed, &path, end),
            };
            Some((by, met?))
        });
        let (by, met) = met.min_by(|(_, a), (_, b)| a.way.total_cmp(&b.way))?;
        Some(Obstacle::on(&path, &met, by))
    }

    /// Whether the ball may meet the part on a stretch of its way.
    pub fn ball_may_meet(&self, part: &Boundary, way: &Stretch) -> bool {
        part.may_meet(&Swept { way: *way, rise: V3::zeros(), radius: self.radius, flat: false })
    }

    /// Whether stylus or body may, the ball being on that stretch.
    pub fn rods_may_meet(&self, part: &Boundary, way: &Stretch) -> bool {
        self.rods().any(|(by, rod)| part.may_meet(&self.swept(&rod, by, way)))
    }

    /// Stylus or body while the ball is on a stretch of its way.
    fn swept(&self, rod: &Rod, by: Touching, ball: &Stretch) -> Swept {
        Swept {
            way: ball.moved(&rod.foot),
            rise: rod.up * rod.length,
            radius: rod.radius,
            flat: self.end(by) == End::Flat,
        }
    }

    /// How the lower end of stylus or body looks.
    fn end(&self, by: Touching) -> End {
        match self.stylus {
            _ if by == Touching::Body => End::Flat,
            Some(stylus) if stylus.radius > self.radius => End::Round,
            _ => End::Covered,
        }
    }
}

/// How the lower end of a rod looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Within a ball that is thicker.
    Covered,
    /// Half a ball.
    Round,
    /// Flat, with an edge that is a little rounded.
    Flat,
}

impl Boundary {
    /// First contact of a rod with the part; of the path direction and length count.
    fn first_of_rod(&self, rod: &Rod, path: &Path, end: End) -> Option<Met> {
        let sides = self.bodies.iter().filter_map(|body| {
            Some(side(body, &rod.seen(&body.place), &path.seen(&body.place), end)?.placed(&body.place))
        });
        let ends = [
            self.end(rod.top(), rod.radius, path),
            match end {
                End::Covered => None,
                End::Round => self.end(rod.foot, rod.radius, path),
                End::Flat => self.edge(rod, path),
            },
        ];
        earliest(sides.chain(ends.into_iter().flatten()))
    }

    /// What goes through the axis of a rod; what its foot stands on does not.
    fn pierced(&self, rod: &Rod) -> Option<Met> {
        let foot = rod.foot + rod.up * STANDS.min(rod.length);
        let met = self.first(0.0, rod.top().into(), foot.into()).met(rod.length)?;
        Some(Met { way: 0.0, ..met })
    }

    /// A round end, which may leave what it reaches into.
    fn end(&self, from: V3, radius: f64, path: &Path) -> Option<Met> {
        let to = from + path.direction * path.length;
        let met = self.first(radius, from.into(), to.into()).met(path.length)?;
        let leaves = met.way == 0.0 && path.direction.dot(&met.normal) > 0.0;
        (!leaves).then_some(met)
    }

    fn edge(&self, rod: &Rod, path: &Path) -> Option<Met> {
        let rounded = ROUNDED.min(rod.radius);
        let first = rod.up.cross(&if rod.up.x.abs() < 0.9 { V3::x() } else { V3::y() }).normalize();
        let second = rod.up.cross(&first);
        let (middle, away) = (rod.foot + rod.up * rounded, rod.radius - rounded);
        let at = |angle: f64| middle + (first * angle.cos() + second * angle.sin()) * away;
        let near = |from: V3, radius: f64, length: f64| {
            let way = Stretch::straight(from, from + path.direction * length);
            self.may_meet(&Swept { way, rise: V3::zeros(), radius, flat: false })
        };
        let width = TAU / SECTORS as f64;
        let sectors: [bool; SECTORS] = std::array::from_fn(|sector| {
            let half = 2.0 * away * (width / 4.0).sin(); // from its middle to its ends
            near(at((sector as f64 + 0.5) * width), rounded + half, path.length + rod::overrun(rod.radius))
        });
        around(path, rod.radius, |angle, path| {
            let sector = (angle.rem_euclid(TAU) / width) as usize % SECTORS;
            let from = at(angle);
            (sectors[sector] && near(from, rounded, path.length)).then(|| self.end(from, rounded, path))?
        })
    }
}

/// First contact of the side of a rod, and of a flat end with what stands out below it.
fn side(body: &Body, rod: &Rod, path: &Path, end: End) -> Option<Met> {
    if let Some(free) = &body.free {
        return free.mesh.first_of_rod(rod, path);
    }
    let reach = rod.swept(path);
    let near = body.features.iter().zip(&body.extents).filter(|(_, extent)| extent.meets(&reach));
    earliest(near.filter_map(|(feature, _)| {
        let side = rod::first(feature, rod, path);
        let below = match end {
            End::Flat => rod::first_below(feature, rod, path),
            _ => None,
        };
        earliest([side, below].into_iter().flatten())
    }))
}
