//! A canvas on which the nearest face wins, and the outlines of what is to be seen on it.

use crate::geometry::V3;
use std::collections::BTreeMap;

/// Size of a pictogram, dots: a quarter of a dot of the screen each.
pub const SIZE: [usize; 2] = [768, 480];
/// How far a simplified outline may lie from the dots, dots.
const TOLERANCE: f64 = 1.3;
/// Least area that is drawn, dots.
const LEAST: f64 = 60.0;

/// What is nearest at each dot: its number, 0 for nothing.
pub struct Canvas {
    depth: Vec<f64>,
    shown: Vec<u16>,
}

impl Canvas {
    pub fn new() -> Canvas {
        let dots = SIZE[0] * SIZE[1];
        Canvas { depth: vec![f64::NEG_INFINITY; dots], shown: vec![0; dots] }
    }

    /// A triangle; of each corner the dot, from the upper left, and how near it is.
    pub fn triangle(&mut self, [a, b, c]: [V3; 3], number: u16) {
        let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if area.abs() < 1e-9 {
            return;
        }
        let range = |axis: usize| {
            let all = [a[axis], b[axis], c[axis]];
            let low = all.into_iter().fold(f64::INFINITY, f64::min).floor().max(0.0) as usize;
            let high = all.into_iter().fold(f64::NEG_INFINITY, f64::max).ceil().max(0.0) as usize;
            low..high.min(SIZE[axis])
        };
        for y in range(1) {
            for x in range(0) {
                let (px, py) = (x as f64 + 0.5, y as f64 + 0.5);
                let share = |p: V3, q: V3| ((p.x - px) * (q.y - py) - (p.y - py) * (q.x - px)) / area;
                let (u, v, w) = (share(b, c), share(c, a), share(a, b));
                if u < -1e-9 || v < -1e-9 || w < -1e-9 {
                    continue;
                }
                let depth = u * a.z + v * b.z + w * c.z;
                let dot = y * SIZE[0] + x;
                if depth > self.depth[dot] {
                    (self.depth[dot], self.shown[dot]) = (depth, number);
                }
            }
        }
    }

    /// Outline of each number that is seen, as the path of an SVG.
    pub fn outlines(&self) -> BTreeMap<u16, String> {
        let mut sides: BTreeMap<u16, Sides> = BTreeMap::new();
        for y in 0..SIZE[1] as i32 {
            for x in 0..SIZE[0] as i32 {
                let number = self.at(x, y);
                if number == 0 {
                    continue;
                }
                let around = [([0, -1], [x, y], [1, 0]), ([1, 0], [x + 1, y], [0, 1])];
                let back = [([0, 1], [x + 1, y + 1], [-1, 0]), ([-1, 0], [x, y + 1], [0, -1])];
                for ([dx, dy], from, way) in around.into_iter().chain(back) {
                    if self.at(x + dx, y + dy) != number {
                        sides.entry(number).or_default().entry(from).or_default().push(way);
                    }
                }
            }
        }
        let paths = sides.into_iter().map(|(number, sides)| (number, path(sides)));
        paths.filter(|(_, path)| !path.is_empty()).collect()
    }

    fn at(&self, x: i32, y: i32) -> u16 {
        let inside = (0..SIZE[0] as i32).contains(&x) && (0..SIZE[1] as i32).contains(&y);
        if inside { self.shown[y as usize * SIZE[0] + x as usize] } else { 0 }
    }
}

/// Sides of dots, by where they begin.
type Sides = BTreeMap<[i32; 2], Vec<[i32; 2]>>;

fn path(mut sides: Sides) -> String {
    let mut path = String::new();
    while let Some(start) = sides.keys().next().copied() {
        let ring = ring(&mut sides, start);
        if area(&ring) >= LEAST {
            path += &drawn(&simple(&ring));
        }
    }
    path
}

/// Takes a closed line of sides out; where two lines meet, it turns to the left.
fn ring(sides: &mut Sides, start: [i32; 2]) -> Vec<[i32; 2]> {
    let (mut ring, mut here, mut before) = (Vec::new(), start, [0, 0]);
    while let Some(ways) = sides.get_mut(&here) {
        let left = ways.iter().position(|way| before[0] * way[1] - before[1] * way[0] < 0).unwrap_or(0);
        let way = ways.remove(left);
        if ways.is_empty() {
            sides.remove(&here);
        }
        ring.push(here);
        here = [here[0] + way[0], here[1] + way[1]];
        before = way;
        if here == start {
            break;
        }
    }
    ring
}

fn area(ring: &[[i32; 2]]) -> f64 {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).map(|([x, y], [u, v])| f64::from(x * v - y * u)).sum::<f64>().abs() / 2.0
}

/// The ring with as few corners as the tolerance allows, from its two farthest ones on.
fn simple(ring: &[[i32; 2]]) -> Vec<[i32; 2]> {
    let points: Vec<[f64; 2]> = ring.iter().map(|point| point.map(f64::from)).collect();
    let away = |from: usize| {
        let far = |index: &usize| (points[*index][0] - points[from][0]).hypot(points[*index][1] - points[from][1]);
        (0..points.len()).max_by(|one, other| far(one).total_cmp(&far(other))).unwrap_or(0)
    };
    let first = away(0);
    let second = away(first);
    let (low, high) = (first.min(second), first.max(second));
    let mut kept = vec![low, high];
    keep(&points, low, high, &mut kept);
    keep(&points, high, low + points.len(), &mut kept);
    kept.sort_unstable();
    kept.dedup();
    kept.into_iter().map(|index| ring[index]).collect()
}

/// Keeps, between two corners, those that lie farther from the line between their neighbours.
fn keep(points: &[[f64; 2]], from: usize, to: usize, kept: &mut Vec<usize>) {
    let at = |index: usize| points[index % points.len()];
    let ([ax, ay], [bx, by]) = (at(from), at(to));
    let length = (bx - ax).hypot(by - ay).max(1e-9);
    let away = |index: usize| {
        let [x, y] = at(index);
        ((bx - ax) * (y - ay) - (by - ay) * (x - ax)).abs() / length
    };
    let farthest = (from + 1..to).max_by(|one, other| away(*one).total_cmp(&away(*other)));
    if let Some(index) = farthest.filter(|index| away(*index) > TOLERANCE) {
        kept.push(index % points.len());
        keep(points, from, index, kept);
        keep(points, index, to, kept);
    }
}

fn drawn(corners: &[[i32; 2]]) -> String {
    let Some(([x, y], rest)) = corners.split_first() else { return String::new() };
    let mut path = format!("M{x} {y}l");
    let mut before = [*x, *y];
    for (index, corner) in rest.iter().enumerate() {
        let [dx, dy] = [corner[0] - before[0], corner[1] - before[1]];
        let gap = if index > 0 && dx >= 0 { " " } else { "" };
        let between = if dy >= 0 { " " } else { "" };
        path += &format!("{gap}{dx}{between}{dy}");
        before = *corner;
    }
    path + "z"
}
