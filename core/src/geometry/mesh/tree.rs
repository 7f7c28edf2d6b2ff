//! Boxes around triangles, halved again and again.

use crate::geometry::{Extent, Path, V3};
use std::ops::Range;

/// Triangles of a box that is not halved any more.
const LEAF: usize = 4;
/// Most boxes that wait while one is looked into: one a level, and no tree of numbers of 32 bits has more levels.
const LEVELS: usize = 33;

/// Boxes, each before those within it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Tree {
    nodes: Vec<Node>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Node {
    extent: Extent,
    /// First triangle of a leaf; else the second box within, the first being the next in the list.
    next: u32,
    /// How many triangles a leaf has; 0: it is none.
    count: u32,
}

impl Node {
    /// Whether a part of it lies before the start of a path, in its direction.
    fn ahead(&self, path: &Path) -> bool {
        let part = |axis: usize| {
            let direction = path.direction[axis];
            let end = if direction > 0.0 { self.extent.high } else { self.extent.low };
            direction * (end[axis] - path.from[axis])
        };
        part(0) + part(1) + part(2) > 0.0
    }

    /// Whether it lies above or below a point.
    fn spans(&self, p: &V3) -> bool {
        (0..2).all(|axis| self.extent.low[axis] <= p[axis] && self.extent.high[axis] >= p[axis])
    }

    fn triangles(&self) -> Range<usize> {
        self.next as usize..(self.next + self.count) as usize
    }
}

/// A triangle with its middle, times three: that decides into which half it comes.
struct Part {
    triangle: [u32; 3],
    middle: V3,
}

impl Tree {
    /// Puts the triangles into the order of the tree.
    pub fn build(triangles: &mut [[u32; 3]], corners: impl Fn(&[u32; 3]) -> [V3; 3]) -> Tree {
        let mut tree = Tree { nodes: Vec::with_capacity(triangles.len()) };
        let part = |triangle: &[u32; 3]| Part { triangle: *triangle, middle: corners(triangle).iter().sum() };
        let mut parts: Vec<Part> = triangles.iter().map(part).collect();
        if !parts.is_empty() {
            tree.split(&mut parts, 0, &corners);
        }
        for (place, part) in triangles.iter_mut().zip(parts) {
            *place = part.triangle;
        }
        tree
    }

    /// Puts a box around the parts, before those within it.
    fn split(&mut self, parts: &mut [Part], first: usize, corners: &impl Fn(&[u32; 3]) -> [V3; 3]) -> Extent {
        let place = self.nodes.len();
        if parts.len() <= LEAF {
            let extent = Extent::of(parts.iter().flat_map(|part| corners(&part.triangle)));
            self.nodes.push(Node { extent, next: first as u32, count: parts.len() as u32 });
            return extent;
        }
        let Extent { low, high } = Extent::of(parts.iter().map(|part| part.middle));
        self.nodes.push(Node { extent: Extent::default(), next: 0, count: 0 });
        let axis = (high - low).imax();
        let half = parts.len() / 2;
        let by_middle = |a: &Part, b: &Part| a.middle[axis].total_cmp(&b.middle[axis]);
        parts.select_nth_unstable_by(half, by_middle);
        let (one, other) = parts.split_at_mut(half);
        let extent = self.split(one, first, corners);
        let next = self.nodes.len() as u32;
        let extent = extent.with(&self.split(other, first + half, corners));
        self.nodes[place] = Node { extent, next, count: 0 };
        extent
    }

    /// Tells the leaves whose boxes lie within `limit` of a point, near ones first. What is answered is the new limit.
    pub fn near(&self, p: &V3, limit: f64, tell: impl FnMut(Range<usize>, f64) -> f64) {
        self.walk(limit, |node| node.extent.distance(p), tell);
    }

    /// Tells the leaves as [`Tree::near`] does, of boxes within `room` of a path along each axis, not behind its start.
    pub fn near_ahead(&self, path: &Path, room: f64, limit: f64, tell: impl FnMut(Range<usize>, f64) -> f64) {
        let swept = Extent::of([path.from, path.at(path.length)]).wider(room);
        let away = |node: &Node| match node.extent.meets(&swept) && node.ahead(path) {
            true => node.extent.distance(&path.from),
            false => f64::INFINITY,
        };
        self.walk(limit, away, tell);
    }

    /// Tells the leaves whose boxes meet a box.
    pub fn within(&self, extent: &Extent, mut tell: impl FnMut(Range<usize>)) {
        let away = |node: &Node| if node.extent.meets(extent) { 0.0 } else { f64::INFINITY };
        self.walk(0.0, away, |leaf, limit| {
            tell(leaf);
            limit
        });
    }

    /// Tells the leaves whose boxes a line straight up from a point meets, low ones first, up to the height answered.
    pub fn above(&self, p: &V3, tell: impl FnMut(Range<usize>, f64) -> f64) {
        let height = |node: &Node| match node.spans(p) && node.extent.high.z >= p.z {
            true => node.extent.low.z,
            false => f64::INFINITY,
        };
        self.walk(f64::MAX, height, tell);
    }

    /// Tells the leaves by a measure, which no inner box has smaller, up to a limit; what is answered is the new limit.
    fn walk(&self, mut limit: f64, measure: impl Fn(&Node) -> f64, mut tell: impl FnMut(Range<usize>, f64) -> f64) {
        let mut waiting = Waiting::default();
        let mut next = self.nodes.first().map(|root| (0, measure(root)));
        while let Some((place, at)) = next.take().or_else(|| waiting.pop()) {
            let Some(node) = self.nodes.get(place as usize).filter(|_| at <= limit) else { continue };
            if node.count > 0 {
                limit = tell(node.triangles(), limit);
                continue;
            }
            let inside = [place + 1, node.next].map(|place| {
                let measured = self.nodes.get(place as usize).map(&measure);
                (place, measured.unwrap_or(f64::INFINITY))
            });
            let [near, far] = match inside {
                [one, other] if other.1 < one.1 => [other, one],
                both => both,
            };
            if far.1 <= limit {
                waiting.push(far);
            }
            next = Some(near);
        }
    }
}

/// Boxes that wait, with their measure; no heap, since each touch of a probe walks many times.
struct Waiting {
    boxes: [(u32, f64); LEVELS],
    count: usize,
}

impl Default for Waiting {
    fn default() -> Waiting {
        Waiting { boxes: [(0, 0.0); LEVELS], count: 0 }
    }
}

impl Waiting {
    fn push(&mut self, one: (u32, f64)) {
        if let Some(free) = self.boxes.get_mut(self.count) {
            *free = one;
            self.count += 1;
        }
    }

    fn pop(&mut self) -> Option<(u32, f64)> {
        self.count = self.count.checked_sub(1)?;
        self.boxes.get(self.count).copied()
    }
}
