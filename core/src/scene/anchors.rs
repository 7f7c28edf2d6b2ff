//! Dimensions of a call in space: those that its picture puts between touches, edges and the zero point, put there on
//! the part that was measured.

use super::Source;
use super::plan::{Performed, laid};
use super::turned::dimension_line;
use crate::entry::stage::{SIZE, Seen, Staging};
use crate::entry::{Inputs, Staged};
use crate::geometry::V3;
use crate::name::Name;
use crate::picture::{PictureShape, ShapeKind};

/// Free paper between two views, mm: so much that each mark is next to its own.
const GAP: f64 = 100.0 * SIZE;
/// What is shorter, mm, is no dimension.
const LEAST: f64 = 0.05;
/// How far beside all that is to be seen a dimension may stand, share of its size.
const ROOM: f64 = 0.2;
/// Where the name of a length stands, share of it: not in the middle, where the zero of a centred part is.
const NAME: f64 = 0.75;
/// An arc is drawn with every sixth of its points.
const EACH: usize = 6;

/// A dimension with the parameter that it explains, machine coordinates, mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Anchor {
    /// Parameter.
    pub field: Name,
    /// Both ends of a length; points of the arc of an angle.
    pub points: Vec<V3>,
    /// Direction out of the plane in which it lies.
    pub out: V3,
    /// Where the name of the parameter stands.
    pub at: V3,
}

impl Anchor {
    /// The anchor beside what is to be seen, within its room: a mark may stand at a place of the paper, which is
    /// anywhere in space. None where its ends are farther, as those of a way from far above.
    pub fn within(mut self, [low, high]: [V3; 2]) -> Option<Anchor> {
        let room = V3::repeat(ROOM * (high - low).norm());
        let (low, high) = (low - room, high + room);
        let inside = |point: V3| point.sup(&low).inf(&high);
        let along = self.points[self.points.len() - 1] - self.points[0];
        let off = inside(self.at) - self.at;
        let aside = off - along * (along.dot(&off) / along.norm_squared());
        self.points.iter_mut().chain([&mut self.at]).for_each(|point| *point += aside);
        let is_seen = self.points.iter().all(|point| (inside(*point) - point).norm() < LEAST);
        is_seen.then_some(self)
    }

    /// What is drawn of it; `arrow`: length of its arrows, mm.
    pub fn lines(&self, arrow: f64) -> Vec<[V3; 2]> {
        let [low, high] = self.points[..] else {
            return self.points.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        };
        let along = high - low;
        let aside = along.cross(&self.out).try_normalize(0.0).unwrap_or_else(V3::y);
        dimension_line([low, high], aside, arrow.min(along.norm() / 3.0)).to_vec()
    }
}

/// The dimensions of a call that was carried out. Bands of tolerances and safe areas are none: a picture draws them
/// wider than they are. A picture that shows another call besides has dimensions of the first one alone.
pub fn anchors(source: &Source, inputs: &Inputs, staged: &Staged, staging: Staging) -> Vec<Anchor> {
    let performed = Performed::done(inputs, staging, source);
    let laid = laid(std::slice::from_ref(&performed), GAP);
    let marks = (staged.marks)(inputs, &laid.seen);
    let mut found = Vec::new();
    for (index, mark) in marks.iter().enumerate() {
        let Some((field, points, at)) = dimension(mark, marks.get(index + 1)) else { continue };
        let Some(view) = next_to(&laid.seen, at) else { continue };
        let (look, [x, y]) = (&performed.staging.looks[view], laid.moved[view]);
        let place = |[right, up]: [f64; 2]| performed.at(look, [right - x, up - y]);
        let (Some(points), Some(at)) = (points.into_iter().map(place).collect::<Option<Vec<V3>>>(), place(at)) else {
            continue;
        };
        let length: f64 = points.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
        if length > LEAST && length.is_finite() {
            found.push(Anchor { field, points, out: performed.sight(look), at });
        }
    }
    found
}

/// Parameter, points and place of the name of a mark that is a length between two points, or the arc of an angle, which
/// has its name behind it. One with other words stands for no parameter of its own.
fn dimension(mark: &PictureShape, next: Option<&PictureShape>) -> Option<(Name, Vec<[f64; 2]>, [f64; 2])> {
    let field = mark.field?;
    let named = |shape: &PictureShape| shape.field == mark.field && shape.text.as_deref() == Some(field.as_str());
    match (mark.kind, &mark.points[..]) {
        (ShapeKind::Dimension, [from, to]) if named(mark) => {
            Some((field, vec![*from, *to], [0, 1].map(|axis| from[axis] + NAME * (to[axis] - from[axis]))))
        }
        (ShapeKind::Path, points) => {
            let name = next.filter(|next| next.kind == ShapeKind::Label && named(next))?;
            Some((field, points.iter().copied().step_by(EACH).collect(), *name.points.first()?))
        }
        _ => None,
    }
}

/// The view that is next to a place on the paper.
fn next_to(seen: &[Seen], at: [f64; 2]) -> Option<usize> {
    let away = |view: &Seen| {
        let [low, high] = view.extent;
        [0, 1].map(|axis| (low[axis] - at[axis]).max(at[axis] - high[axis]).max(0.0)).into_iter().fold(0.0, f64::hypot)
    };
    (0..seen.len()).min_by(|one, other| away(&seen[*one]).total_cmp(&away(&seen[*other])))
}
