//! Scanned points in lines, and the surface under the ball.
//!
//! A ball that touches a surface has its centre one radius beside it, along the normal. The centres lie on a surface of
//! their own with the same normals; these are reckoned from neighbours. Of three points the circle through them gives
//! the direction at one of them; two such directions, along the line and across it, span the tangential plane. On a
//! plane and on a sphere that is exact, elsewhere the error falls with the square of the distances.

use super::{Layout, Scanned};
use crate::geometry::V3;
use std::ops::Range;

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
        let values = self.points.iter().map(|point| point[axis]);
        values.fold(ends, |[low, high], value| [low.min(value), high.max(value)])
    }

    /// Point of the surface that the ball touched.
    pub fn surface(&self, layout: &Layout, index: usize) -> V3 {
        let mut point = self.at(index);
        point[layout.axes[2]] += layout.radius;
        point - self.normal(layout, index) * layout.radius
    }

    /// Direction out of the surface at a point, of length 1. Where neighbours are missing the surface counts as level.
    pub fn normal(&self, layout: &Layout, index: usize) -> V3 {
        let mut up = V3::zeros();
        up[layout.axes[2]] = 1.0;
        let mut beside = V3::zeros();
        beside[layout.axes[1]] = 1.0;
        let (line, range) = self.line_of(index);
        let along = self.direction(index, &along_line(index, &range));
        let across = self.direction(index, &self.across_lines(layout, index, line));
        let mut ahead = V3::zeros();
        ahead[layout.axes[0]] = 1.0;
        let normal = along
            .unwrap_or(ahead)
            .cross(&across.unwrap_or(beside))
            .try_normalize(1e-9)
            .unwrap_or(up);
        if normal.dot(&up) < 0.0 {
            -normal
        } else {
            normal
        }
    }

    fn at(&self, index: usize) -> V3 {
        self.points.get(index).copied().unwrap_or_default().into()
    }

    /// Number of the line of a point among those that have any, and its points.
    fn line_of(&self, index: usize) -> (usize, Range<usize>) {
        let line = self
            .lines
            .partition_point(|first| *first <= index)
            .saturating_sub(1);
        (line, self.points_of(line))
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

    /// A point on each of the lines beside that of a point; at the border two on the same side.
    fn across_lines(&self, layout: &Layout, index: usize, line: usize) -> Vec<usize> {
        let here = self.at(index);
        let on = |line: Option<usize>| self.nearest_on(layout, line?, &here);
        let found = match (line.checked_sub(1), line + 1 < self.lines()) {
            (Some(before), true) => [on(Some(before)), on(Some(line + 1))],
            (None, true) => [on(Some(line + 1)), on(Some(line + 2))],
            (Some(before), false) => [on(Some(before)), on(before.checked_sub(1))],
            (None, false) => [None, None],
        };
        found.into_iter().flatten().collect()
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
        let nearest =
            (0..around.len()).min_by(|a, b| away(&around[*a]).total_cmp(&away(&around[*b])));
        Some(range.start + from + nearest?)
    }
}

/// Neighbours on the same line: before and behind; at its ends the next two, in a line of two the other one.
fn along_line(index: usize, line: &Range<usize>) -> Vec<usize> {
    let before = line.contains(&index.wrapping_sub(1));
    let behind = line.contains(&(index + 1));
    match (before, behind) {
        (true, true) => vec![index - 1, index + 1],
        (false, true) if line.contains(&(index + 2)) => vec![index + 1, index + 2],
        (true, false) if line.contains(&index.wrapping_sub(2)) => vec![index - 1, index - 2],
        (false, true) => vec![index + 1],
        (true, false) => vec![index - 1],
        (false, false) => Vec::new(),
    }
}
