//! What is to be seen whole, and the grid below it.

use super::frames::Frame;
use crate::geometry::{Extent, V3};

/// In which paths are shown whole around parts: share of their size, and at least so many mm.
const ROOM: f64 = 0.4;
const LEAST_ROOM: f64 = 50.0;
/// Distance of a zero to which dimensions are drawn, share of the size of what is there.
const NEAR: f64 = 1.4;
/// How much larger what is shown at first may become by zeros, share of the size of what is there.
const GROWTH: f64 = 1.35;
/// Room around coordinate systems where there is nothing else, mm.
const ALONE: f64 = 20.0;

/// Whether there is anything in it.
pub fn is_some(extent: &Extent) -> bool {
    extent.low.x <= extent.high.x
}

/// Diagonal, mm.
pub fn size(extent: &Extent) -> f64 {
    (extent.high - extent.low).norm()
}

/// All ways of a ball of this radius, each as [`Scene::ways`](super::Scene::ways) has it.
pub fn ways(ways: &[f64], radius: f64) -> Extent {
    let ends = ways.chunks_exact(8).flat_map(|way| [V3::new(way[0], way[1], way[2]), V3::new(way[3], way[4], way[5])]);
    let ends = Extent::of(ends);
    if is_some(&ends) { ends.wider(radius) } else { ends }
}

/// What there is to see, in two sizes.
pub struct Seen {
    /// Parts, with paths and zeros near them: dimensions may lie in it.
    pub near: Extent,
    /// The same, without zeros beside which the parts would be small: what is shown at first.
    pub shown: Extent,
}

/// Beside a way from far above a part would be small, so of ways only what is near counts; without a part all.
pub fn around(solids: &Extent, ways: &Extent, frames: &[Frame]) -> Seen {
    let things = if is_some(ways) && is_some(solids) {
        let room = solids.wider(LEAST_ROOM.max(ROOM * size(solids)));
        let inside = |point: V3| point.sup(&room.low).inf(&room.high);
        solids.with(&Extent::of([ways.low, ways.high].map(inside)))
    } else {
        solids.with(ways)
    };
    let zeros = || frames.iter().map(|frame| Extent::of([V3::from(frame.at)]));
    if !is_some(&things) {
        let all = zeros().fold(Extent::default(), |all, zero| all.with(&zero));
        let alone = if is_some(&all) { all } else { Extent::of([V3::zeros()]) }.wider(ALONE);
        return Seen { near: alone, shown: alone };
    }
    let away = |seen: &Extent, zero: &Extent| (zero.low - (seen.low + seen.high) / 2.0).norm();
    let near = zeros().fold(things, |seen, zero| {
        let wider = seen.with(&zero);
        if away(&seen, &zero) < NEAR * size(&seen) { wider } else { seen }
    });
    let shown = zeros().fold(things, |seen, zero| {
        let wider = seen.with(&zero);
        if size(&wider) < GROWTH * size(&things) { wider } else { seen }
    });
    Seen { near, shown }
}

/// Spacing of a grid for a length, mm: 1, 2 or 5 times a power of ten.
pub fn grid_spacing(length: f64) -> f64 {
    let rough = length.max(1e-6) / 10.0;
    let power = 10_f64.powf(rough.log10().floor());
    power * [1.0, 2.0, 5.0].into_iter().find(|step| step * power >= rough).unwrap_or(10.0)
}

/// Axes of the ground: two in it, and the upright one. On a turning machine X is upright.
fn axes(turning: bool) -> (usize, usize, usize) {
    if turning { (2, 1, 0) } else { (0, 1, 2) }
}

/// Height of the ground below what is there, and the spacing of its grid, mm.
pub fn ground(below: &Extent, turning: bool) -> [f64; 2] {
    let (across, along, up) = axes(turning);
    let size = (below.high - below.low)[across].max((below.high - below.low)[along]);
    [below.low[up], grid_spacing(size)]
}

/// Grid below what is there, lines on round coordinates, in X-Y of the machine, of a turning machine in Z-Y.
pub fn grid(below: &Extent, turning: bool) -> Vec<[V3; 2]> {
    let (across, along, up) = axes(turning);
    let [height, spacing] = ground(below, turning);
    let range = |axis: usize| {
        let low = (below.low[axis] / spacing).floor() - 2.0;
        let high = (below.high[axis] / spacing).ceil() + 2.0;
        (low * spacing, high * spacing, (high - low) as usize)
    };
    let (first, second) = (range(across), range(along));
    let at = |x: f64, y: f64| {
        let mut point = V3::zeros();
        (point[across], point[along], point[up]) = (x, y, height);
        point
    };
    let columns = (0..=first.2).map(|i| first.0 + i as f64 * spacing).map(|x| [at(x, second.0), at(x, second.1)]);
    let rows = (0..=second.2).map(|i| second.0 + i as f64 * spacing).map(|y| [at(first.0, y), at(first.1, y)]);
    columns.chain(rows).collect()
}
