//! Scanned points in lines, and the surface under the ball.
//!
//! A ball that touches a surface has its centre one radius beside it, along the normal. The centres lie on a surface of
//! their own with the same normals; these are calculated from neighbours. Of three points the circle through them gives
//! the direction at one of them; two such directions, along the line and across it, span the tangential plane. On a
//! plane and on a sphere that is exact, elsewhere the error falls with the square of the distances. What is nearer than
//! the accuracy of the points times `FAR` says nothing about directions and is passed over.

use super::{Layout, Scanned};
use crate::geometry::V3;
use std::ops::Range;

/// Distance of a neighbour over the accuracy, less than the ball radius: a direction is wrong by less than a hundredth.
const FAR: f64 = 200.0;
/// Points that are nearer than this are the same one, mm.
const SAME: f64 = 1e-6;

/// Points in the order in which they were scanned.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cloud {
    points: Vec<[f64; 3]>,
    /// First point of each line that has any.
    lines: Vec<usize>,
    /// Number of the line of the last point.
    last: usize,
}

impl Cloud {
    /// Adds a point.
    pub fn push(&mut self, scanned: Scanned) {
        if self.points.is_empty() || scanned.line != self.last {
            self.lines.push(self.points.len());
            self.last = scanned.line;
        }
        self.points.push(scanned.at);
    }

    /// All points as they are sent.
    pub fn points(&self) -> &[[f64; 3]] {
        &self.points
    }

    /// How many lines have points.
    pub fn lines(&self) -> usize {
        self.lines.len()
    }

    /// Lowest and highest coordinate along an axis.
    pub fn extent(&self, axis: usize) -> [f64; 2] {
        let ends = [f64::INFINITY, f64::NEG_INFINITY];
        self.points.iter().map(|point| point[axis]).fold(ends, |[low, high], value| [low.min(value), high.max(value)])
    }

    /// Point of the surface that the ball touched.
    pub fn surface(&self, layout: &Layout, index: usize) -> V3 {
        let mut point = self.at(index);
        point[layout.axes[2]] += layout.radius;
        point - self.normal(layout, index) * layout.radius
    }

    /// Direction out of the surface at a point, of length 1. Where neighbours are missing the surface counts as level.
    pub fn normal(&self, layout: &Layout, index: usize) -> V3 {
        let [ahead, beside, up] = layout.axes.map(|axis| V3::ith(axis, 1.0));
        let line = self.lines.partition_point(|first| *first <= index).saturating_sub(1);
        let along = self.direction(index, &self.along_line(layout, index, &self.points_of(line)));
        let across = self.direction(index, &self.across_lines(layout, index, line));
        let normal = along.unwrap_or(ahead).cross(&across.unwrap_or(beside)).try_normalize(1e-9).unwrap_or(up);
        if normal.dot(&up) < 0.0 { -normal } else { normal }
    }

    fn at(&self, index: usize) -> V3 {
        self.points.get(index).copied().unwrap_or_default().into()
    }

    fn points_of(&self, line: usize) -> Range<usize> {
        let end = self.points.len();
        let first = |line: usize| self.lines.get(line).copied().unwrap_or(end);
        first(line)..first(line + 1)
    }

    /// Direction at a point of the circle through it and two neighbours, of length 1: seen from the point, every other
    /// one is moved to the reciprocal of its distance, which makes a straight line of the circle.
    fn direction(&self, index: usize, neighbours: &[usize]) -> Option<V3> {
        let here = self.at(index);
        let inverted = |other: &usize| {
            let away = self.at(*other) - here;
            away / away.norm_squared()
        };
        match neighbours {
            [one] => (self.at(*one) - here).try_normalize(1e-12),
            [one, other] => (inverted(other) - inverted(one)).try_normalize(1e-12),
            _ => None,
        }
    }

    /// Neighbours on the same line, before and behind; near its ends two on the same side, else whatever there is.
    fn along_line(&self, layout: &Layout, index: usize, line: &Range<usize>) -> Vec<usize> {
        let reach = reach(layout);
        let here = self.at(index);
        let far = |other: &usize, times: f64| (self.at(*other) - here).norm() >= (times * reach).max(SAME);
        let before = |times| (line.start..index).rev().find(|other| far(other, times));
        let behind = |times| (index + 1..line.end).find(|other| far(other, times));
        let beyond = |one: usize| if one > index { Some(one + 1) } else { one.checked_sub(1) };
        match (before(1.0), behind(1.0)) {
            (Some(one), Some(other)) => vec![one, other],
            (Some(one), None) | (None, Some(one)) => {
                let second = before(2.0).or(behind(2.0)).filter(|two| *two != one);
                let second = second.or_else(|| beyond(one).filter(|two| line.contains(two)));
                [Some(one), second].into_iter().flatten().collect()
            }
            (None, None) => self.farthest(index, line).into_iter().collect(),
        }
    }

    /// The point of a line that is farthest from one of its points.
    fn farthest(&self, index: usize, line: &Range<usize>) -> Option<usize> {
        let here = self.at(index);
        let away = |other: &usize| (self.at(*other) - here).norm_squared();
        let farthest = line.clone().max_by(|a, b| away(a).total_cmp(&away(b)))?;
        (away(&farthest) > SAME * SAME).then_some(farthest)
    }

    /// A point on each of two lines beside that of a point; near the border both on the same side.
    fn across_lines(&self, layout: &Layout, index: usize, line: usize) -> Vec<usize> {
        let here = self.at(index);
        let last = self.lines().saturating_sub(1);
        let apart = self.apart(layout, line);
        let far = (reach(layout) / apart).ceil().clamp(1.0, (last / 2).max(1) as f64) as usize;
        let (before, behind) = (line.checked_sub(far), line + far);
        let lines = match before {
            Some(before) if behind <= last => [before, behind],
            None => [behind.min(last), (line + 2 * far).min(last)],
            Some(before) => [before, line.saturating_sub(2 * far)],
        };
        let mut found: Vec<usize> = lines
            .into_iter()
            .filter(|other| *other != line)
            .filter_map(|other| self.nearest_on(layout, other, &here))
            .collect();
        found.dedup();
        found
    }

    /// Distance of a line from the next one, or from the one before.
    fn apart(&self, layout: &Layout, line: usize) -> f64 {
        let [_, across, _] = layout.axes;
        let at = |line: usize| Some(self.points.get(*self.lines.get(line)?)?[across]);
        let here = at(line).unwrap_or(0.0);
        let other = at(line + 1).or_else(|| at(line.checked_sub(1)?));
        other.map_or(f64::INFINITY, |other| (other - here).abs()).max(SAME)
    }

    /// The point of a line that is nearest to another point. Its points never go back along the axis of the lines.
    fn nearest_on(&self, layout: &Layout, line: usize, p: &V3) -> Option<usize> {
        const AROUND: usize = 3;
        let axis = layout.axes[0];
        let range = self.points_of(line);
        let points = self.points.get(range.clone())?;
        let back = points.first()?[axis] > points.last()?[axis];
        let place = points.partition_point(|point| (point[axis] < p[axis]) != back);
        let from = place.saturating_sub(AROUND);
        let around = points.get(from..(place + AROUND).min(points.len()))?;
        let away = |point: &[f64; 3]| (V3::from(*point) - p).norm_squared();
        let nearest = (0..around.len()).min_by(|a, b| away(&around[*a]).total_cmp(&away(&around[*b])));
        Some(range.start + from + nearest?)
    }
}

/// How far away a neighbour has to be, mm.
fn reach(layout: &Layout) -> f64 {
    (FAR * layout.accuracy).min(layout.radius)
}
