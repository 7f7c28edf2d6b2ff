//! Where a call begins, and the ways and places that it needs, from the points that were touched. All in the WCS of the
//! measurement, mm.

use super::Layout;
use super::corner::{self, Touched};
use super::value::rounded;
use super::{Point, Source, Told};
use crate::geometry::{Degrees, Dir, V3, Wcs};
use crate::jog::calculate::{self, corner_sides};
use crate::jog::evaluate::Flat;
use crate::jog::settings::Settings;

/// The cycle goes so much away from the edges of a corner, degree (B:7996).
const AWAY: f64 = 10.0;
/// Part of an edge that its points lie apart from the corner, at least: so that the first of them is still on it.
const PART: f64 = 3.0;

/// Where a call begins, and the numbers that follow from it.
#[derive(Clone, Debug, PartialEq)]
pub struct Laid {
    pub layout: Layout,
    pub start: Wcs,
    pub numbers: Vec<f64>,
}

impl Default for Laid {
    fn default() -> Laid {
        Laid { layout: Layout::Here, start: Wcs::default(), numbers: Vec::new() }
    }
}

/// A counterpart needs all points.
const POINTS: &str = "jog-program-points";

/// Lays a call out; an error is the key of why not.
pub fn lay(told: &Told, layout: Layout) -> Result<Laid, &'static str> {
    let laid = match layout {
        Layout::Here => Ok((told.from(), Vec::new())),
        Layout::Before => Ok(told.before()),
        Layout::Set => Ok((told.set(), Vec::new())),
        Layout::Around => told.around(),
        Layout::Along => told.along(),
        Layout::Level => told.level(),
        Layout::Opposite => told.opposite(),
        Layout::Points { inside } => told.places(inside),
        Layout::Middle { inside } => told.middle(inside),
    };
    let (start, numbers) = laid?;
    Ok(Laid { layout, start: Wcs(start.0.map(rounded_place)), numbers })
}

/// A place of the program: the set positions of a mask stay what they are.
fn rounded_place(value: f64) -> f64 {
    let near = rounded(value);
    if (near - value).abs() < 1e-9 { near } else { value }
}

type Place = Result<(Wcs, Vec<f64>), &'static str>;

impl Told<'_> {
    /// Where the probe stood at the first NC start; before it where it stands.
    fn from(&self) -> Wcs {
        let first = self.points.as_ref().and_then(|points| points.first());
        Wcs(first.map_or(self.here, |point| point.from).0.map(rounded))
    }

    fn all(&self) -> Result<&[Point], &'static str> {
        self.points.as_deref().ok_or(POINTS)
    }

    fn field(&self, name: &str) -> f64 {
        self.values.number(name)
    }

    /// Abscissa and ordinate.
    fn flat(&self, at: Wcs) -> Flat {
        let [abscissa, ordinate, _] = self.control.plane.axes();
        [at[abscissa], at[ordinate]]
    }

    /// A position with this place of the plane.
    fn placed(&self, at: Wcs, [first, second]: Flat) -> Wcs {
        let [abscissa, ordinate, _] = self.control.plane.axes();
        let mut to = at;
        (to[abscissa], to[ordinate]) = (first, second);
        to
    }

    /// A position so much higher.
    fn higher(&self, at: Wcs, by: f64) -> Wcs {
        let mut to = at;
        to[self.control.plane.axes()[2]] += by;
        to
    }

    fn before(&self) -> (Wcs, Vec<f64>) {
        let axis = calculate::axis(self.values, "axis");
        let way = match self.points.as_deref() {
            Some([Point { from, at }, ..]) => rounded((from[axis] - at[axis]).abs()),
            _ => Settings::of(&self.control).path,
        };
        let mut start = self.from();
        start[axis] = self.field("x0") - self.values.sign("direction") * way;
        (start, vec![way])
    }

    fn set(&self) -> Wcs {
        self.placed(self.from(), [self.field("x0"), self.field("y0")])
    }

    /// At the start of the first block: inside at the set centre, from which it is free.
    fn around(&self) -> Place {
        let centre = [self.field("x0"), self.field("y0")];
        if self.values.get("dz").is_none() {
            return Ok((self.placed(self.from(), centre), Vec::new()));
        }
        let settings = Settings::of(&self.control);
        let ball = self.stylus().radius;
        let reach = self.field("diameter") / 2.0 + ball + settings.path;
        let (sine, cosine) = Degrees(self.field("contact_angle")).sin_cos();
        let at = [centre[0] + reach * cosine, centre[1] + reach * sine];
        Ok((self.higher(self.placed(self.from(), at.map(rounded)), -self.field("dz")), Vec::new()))
    }

    /// From the point with the lower coordinate of the reference axis, as far from the edge as the farther of both.
    fn along(&self) -> Place {
        let [first, second] = self.all()? else { return Err(POINTS) };
        let (measuring, reference) = (calculate::axis(self.values, "axis"), calculate::axis(self.values, "ref_axis"));
        let [first, second] = [first.from, second.from];
        let (low, high) = if first[reference] <= second[reference] { (first, second) } else { (second, first) };
        let way = rounded(high[reference] - low[reference]);
        if way <= 0.0 {
            return Err("jog-same-place");
        }
        let mut start = Wcs(low.0.map(rounded));
        let sign = self.values.sign("direction");
        start[measuring] = rounded(sign * (sign * low[measuring]).min(sign * high[measuring]));
        Ok((start, vec![way]))
    }

    /// Three points along the axes within the triangle of those that were touched, as large as there is room: with the
    /// edges of the triangle n·x ≤ c, whose normals add up to nothing, the room is the sum of c by the sum of what the
    /// legs take of each.
    fn level(&self) -> Place {
        let points = self.all()?;
        let flat: Vec<Flat> = points.iter().map(|point| self.flat(point.from)).collect();
        let [a, b, c] = flat[..] else { return Err(POINTS) };
        let turned = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let corners = if turned > 0.0 { [a, b, c] } else { [a, c, b] };
        let span = |axis: usize| {
            let all = corners.map(|corner| corner[axis]);
            all.into_iter().fold(f64::MIN, f64::max) - all.into_iter().fold(f64::MAX, f64::min)
        };
        let legs = [span(0), span(1)];
        let edge = |number: usize| {
            let (from, to) = (corners[number], corners[(number + 1) % 3]);
            let normal = [to[1] - from[1], from[0] - to[0]];
            let takes = (normal[0] * legs[0]).max(normal[1] * legs[1]).max(0.0);
            (normal, normal[0] * from[0] + normal[1] * from[1], takes)
        };
        let edges = [edge(0), edge(1), edge(2)];
        let room: f64 = edges.iter().map(|edge| edge.1).sum();
        let taken: f64 = edges.iter().map(|edge| edge.2).sum();
        let share = room / taken;
        let [(n, c, takes), (m, d, leaves), _] = edges;
        let (c, d) = (c - share * takes, d - share * leaves);
        let across = n[0] * m[1] - n[1] * m[0];
        let at = [(c * m[1] - d * n[1]) / across, (n[0] * d - m[0] * c) / across].map(rounded);
        let ways = legs.map(|leg| rounded(leg * share));
        if !ways.iter().all(|way| *way > 0.0) || !at.iter().all(|value| value.is_finite()) {
            return Err("jog-in-line");
        }
        let [.., applicate] = self.control.plane.axes();
        let height = points.iter().map(|point| point.from[applicate]).fold(f64::MIN, f64::max);
        let mut start = self.placed(self.from(), at);
        start[applicate] = rounded(height);
        Ok((start, ways.to_vec()))
    }

    /// Opposite the corner, as far from its edges as the probe stood; the ways lead to the points that were touched.
    fn opposite(&self) -> Place {
        let points = self.all()?;
        let [first, second, third] = points else { return Err(POINTS) };
        let sides = corner_sides(self.values);
        let [a, b, c] = [first, second, third].map(|point| self.flat(point.at));
        let along = unit([b[0] - a[0], b[1] - a[1]]).ok_or("jog-same-place")?;
        let reached = (c[0] - a[0]) * along[0] + (c[1] - a[1]) * along[1];
        let corner = [a[0] + reached * along[0], a[1] + reached * along[1]];
        let inside = self.values.word("corner") == "inside";
        // towards the free side of both edges, and along them away from the corner
        let lean = if along[0] < 0.0 { along.map(|part| -part) } else { along };
        let up = [-lean[1], lean[0]];
        let free = [up.map(|part| -part * sides[0].sign), lean.map(|part| -part * sides[1].sign)];
        let sense = if inside { 1.0 } else { -1.0 };
        let edges = [free[1].map(|part| part * sense), free[0].map(|part| part * sense)];
        let from = |point: Flat, edge: Flat| (point[0] - corner[0]) * edge[0] + (point[1] - corner[1]) * edge[1];
        let far = [from(a, edges[0]).max(from(b, edges[0])), from(c, edges[1])];
        let clear = |point: &Point, axis: usize| {
            let [from, at] = [point.from, point.at].map(|place| self.flat(place)[axis]);
            (from - at).abs()
        };
        let clear = [clear(first, 1).min(clear(second, 1)), clear(third, 0)];
        if !far.iter().all(|far| *far > 0.0) {
            return Err("jog-program-corner");
        }
        let beside = [clear[0].min(far[1] / PART), clear[1].min(far[0] / PART)];
        let start: Flat =
            std::array::from_fn(|axis| rounded(corner[axis] + beside[0] * free[0][axis] + beside[1] * free[1][axis]));
        let reach = |far: f64, beside: f64| (far - sense * beside) / Degrees(AWAY).sin_cos().1;
        let ways = [reach(far[0], beside[1]), 2.0 * reach(far[1], beside[0])].map(rounded);
        let [reference, between] = self.angles(edges);
        Ok((self.placed(self.from(), start), vec![ways[0], ways[1], reference, between]))
    }

    /// Angle of the reference edge in the machine, in which it counts, and from it to the other (B:7992).
    fn angles(&self, [reference, other]: [Flat; 2]) -> [f64; 2] {
        let [abscissa, ordinate, applicate] = self.control.plane.axes();
        let mut direction = V3::zeros();
        (direction[abscissa], direction[ordinate]) = (reference[0], reference[1]);
        let seen = self.control.direction_to_machine(Dir::new(direction.into()));
        let sense = self.control.turn_axis(abscissa, ordinate)[applicate].signum();
        let across = reference[0] * other[1] - reference[1] * other[0];
        let whole = |angle: f64| (angle * 100.0).round() / 100.0;
        [whole(Degrees::of(seen[ordinate].atan2(seen[abscissa])).0), 90.0 * across.signum() * sense]
    }

    /// The points as places; P1 before P2 along the abscissa (B:8140). Outside they are reached over the part.
    fn places(&self, inside: bool) -> Place {
        let points = self.all()?;
        let clear = |(number, point): (usize, &Point)| {
            let axis = usize::from(number < 2);
            (self.flat(point.from)[axis] - self.flat(point.at)[axis]).abs()
        };
        let touched = Touched {
            at: points.iter().map(|point| self.flat(point.at)).collect(),
            clear: points.iter().enumerate().map(clear).collect(),
            signs: corner_sides(self.values).map(|side| side.sign),
            radius: self.stylus().radius,
            inside,
        };
        let [mut one, mut two, three, four] = corner::places(&touched)?;
        if one[0] > two[0] {
            (one, two) = (two, one);
        }
        let up = if inside { 0.0 } else { Settings::of(&self.control).path };
        let start = self.higher(self.placed(self.from(), two), up);
        let places = [one, two, three, four].concat().into_iter().map(rounded);
        Ok((Wcs(start.0.map(rounded)), places.chain([-up]).collect()))
    }

    /// At the set middle, beside where the first edge was touched; over a web.
    fn middle(&self, inside: bool) -> Place {
        let [first, second] = self.all()? else { return Err(POINTS) };
        let signs = ["direction", "direction_2"].map(|name| self.values.sign(name));
        if signs[0] == signs[1] {
            return Err("jog-program-step");
        }
        let axis = calculate::axis(self.values, "axis");
        if axis == self.control.plane.axes()[2] {
            return Err("jog-program-heights");
        }
        let between = signs[0] * (first.at[axis] - second.at[axis]);
        if (between > 0.0) != inside {
            return Err("jog-program-step");
        }
        let up = if inside { 0.0 } else { self.value(Source::Path, &Laid::default()).unwrap_or_default() };
        let mut start = self.higher(self.from(), up);
        start[axis] = self.field("x0");
        Ok((start, vec![rounded(between.abs()), -up]))
    }
}

/// A way as long as 1.
pub fn unit([x, y]: Flat) -> Option<Flat> {
    let length = x.hypot(y);
    (length > 0.0).then(|| [x / length, y / length])
}
