//! Boxes around triangles, halved again and again.

use crate::geometry::V3;

/// Triangles of a box that is not halved any more.
const LEAF: usize = 4;

/// The boxes, each before those within it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Tree {
    nodes: Vec<Node>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Node {
    low: V3,
    high: V3,
    /// First triangle of a leaf; else the second box within, the first being the next in the list.
    next: u32,
    /// How many triangles a leaf has; 0: it is none.
    count: u32,
}

impl Node {
    /// Square of the distance of a point, 0 inside.
    fn distance_squared(&self, p: &V3) -> f64 {
        (p - p.sup(&self.low).inf(&self.high)).norm_squared()
    }

    fn meets(&self, low: &V3, high: &V3) -> bool {
        (0..3).all(|axis| self.low[axis] <= high[axis] && self.high[axis] >= low[axis])
    }
}

impl Tree {
    /// Puts the triangles into the order of the tree.
    pub fn build(triangles: &mut [[u32; 3]], corners: impl Fn(&[u32; 3]) -> [V3; 3]) -> Tree {
        let mut tree = Tree::default();
        if !triangles.is_empty() {
            tree.split(triangles, 0, &corners);
        }
        tree
    }

    fn split(
        &mut self,
        triangles: &mut [[u32; 3]],
        first: usize,
        corners: &impl Fn(&[u32; 3]) -> [V3; 3],
    ) {
        let (mut low, mut high) = (V3::repeat(f64::INFINITY), V3::repeat(f64::NEG_INFINITY));
        for corner in triangles.iter().flat_map(corners) {
            (low, high) = (low.inf(&corner), high.sup(&corner));
        }
        let place = self.nodes.len();
        let leaf = triangles.len() <= LEAF;
        self.nodes.push(Node {
            low,
            high,
            next: first as u32,
            count: if leaf { triangles.len() as u32 } else { 0 },
        });
        if leaf {
            return;
        }
        let axis = (high - low).imax();
        let middle = triangles.len() / 2;
        let along = |triangle: &[u32; 3]| corners(triangle).iter().map(|c| c[axis]).sum::<f64>();
        triangles.select_nth_unstable_by(middle, |a, b| along(a).total_cmp(&along(b)));
        let (one, other) = triangles.split_at_mut(middle);
        self.split(one, first, corners);
        self.nodes[place].next = self.nodes.len() as u32;
        self.split(other, first + middle, corners);
    }

    /// Tells the triangles whose boxes lie within `limit` of a point, near ones first. What is answered is the new limit.
    pub fn near(&self, p: &V3, limit: f64, tell: impl FnMut(usize, f64) -> f64) {
        let (low, high) = (V3::repeat(f64::NEG_INFINITY), V3::repeat(f64::INFINITY));
        self.near_in(p, limit, &low, &high, tell);
    }

    /// The same of boxes that meet a box.
    pub fn near_in(
        &self,
        p: &V3,
        mut limit: f64,
        low: &V3,
        high: &V3,
        mut tell: impl FnMut(usize, f64) -> f64,
    ) {
        let mut waiting: Vec<(u32, f64)> = Vec::with_capacity(48);
        self.wait(&mut waiting, 0, p, low, high);
        while let Some((place, distance)) = waiting.pop() {
            let Some(node) = self.nodes.get(place as usize) else {
                continue;
            };
            if distance > limit * limit {
                continue;
            }
            if node.count > 0 {
                for index in node.next..node.next + node.count {
                    limit = tell(index as usize, limit);
                }
                continue;
            }
            let before = waiting.len();
            self.wait(&mut waiting, place + 1, p, low, high);
            self.wait(&mut waiting, node.next, p, low, high);
            if let [first, second] = &mut waiting[before..]
                && first.1 < second.1
            {
                std::mem::swap(first, second);
            }
        }
    }

    fn wait(&self, waiting: &mut Vec<(u32, f64)>, place: u32, p: &V3, low: &V3, high: &V3) {
        if let Some(node) = self.nodes.get(place as usize)
            && node.meets(low, high)
        {
            waiting.push((place, node.distance_squared(p)));
        }
    }

    /// Tells the triangles whose boxes a line from a point straight up meets.
    pub fn above(&self, p: &V3, mut tell: impl FnMut(usize)) {
        let top = V3::new(p.x, p.y, f64::INFINITY);
        self.near_in(p, f64::INFINITY, p, &top, |index, limit| {
            tell(index);
            limit
        });
    }
}
