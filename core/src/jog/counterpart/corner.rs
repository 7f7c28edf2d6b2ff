//! Four places before the edges of a corner, from where CYCLE961 finds what the hand found. The lines through both
//! pairs meet on the side of the corner, outside of both (61369), and each pair lies on that side of the other line
//! by which the cycle knows its direction (B:8046-8050).

use super::lay::unit;
use crate::jog::evaluate::Flat;

/// Points that make no such corner.
const CORNER: &str = "jog-program-corner";
/// How far the ball stands from the edges at most, as is tried one after the other, mm: inside, places that lie nearer
/// leave more room between the lines. The least is the last that would do.
const GAPS: [f64; 6] = [f64::INFINITY, 16.0, 8.0, 4.0, 2.0, LEAST];
const LEAST: f64 = 1.0;
/// Least way from a place to the line of the other pair, mm.
const ROOM: f64 = 0.5;
/// Sine of an angle between edges that do not meet.
const PARALLEL: f64 = 1e-6;

/// A corner as it was touched, in abscissa and ordinate, mm.
#[derive(Clone, Debug)]
pub struct Touched {
    /// Places on the first edge, then one or two on the second.
    pub at: Vec<Flat>,
    /// How far before each the probe stood, along the axis of its touch.
    pub clear: Vec<f64>,
    /// Directions of the touches: along the ordinate at the first edge, along the abscissa at the second.
    pub signs: [f64; 2],
    /// Radius of the ball: nearer the probe is not to stand.
    pub radius: f64,
    /// Whether the corner is that of a pocket.
    pub inside: bool,
}

/// P1 to P4. One that was not touched lies between the third and the corner; each pair stands alike before its edge, so
/// that its line is parallel to it.
pub fn places(touched: &Touched) -> Result<[Flat; 4], &'static str> {
    let [first, second, third, ref rest @ ..] = touched.at[..] else { return Err(CORNER) };
    let along = unit(minus(second, first)).ok_or("jog-same-place")?;
    let other = match rest.first() {
        Some(fourth) => unit(minus(*fourth, third)).ok_or("jog-same-place")?,
        None => [-along[1], along[0]],
    };
    // a place in parts of both edges from the corner
    let across = cross(along, other);
    if across.abs() < PARALLEL {
        return Err(CORNER);
    }
    let parts = |from: Flat| [cross(from, other) / across, cross(along, from) / across];
    let corner = plus(first, along, parts(minus(third, first))[0]);
    let seen = |at: Flat| parts(minus(at, corner));
    let lengths = [[seen(first)[0], seen(second)[0]], [seen(third)[1], rest.first().map_or(0.0, |at| seen(*at)[1])]];
    let senses = lengths.map(|[one, two]| (one + two).signum());
    let nearest = |edge: usize, [one, two]: [f64; 2]| (senses[edge] * one).min(senses[edge] * two);
    let (near, far) = (nearest(0, lengths[0]), senses[1] * lengths[1][0]);
    let given = (!rest.is_empty()).then(|| nearest(1, lengths[1]));
    for gap in GAPS {
        let stands = |clear: &[f64]| clear.iter().copied().fold(touched.radius + gap, f64::min);
        let (before, beside) = touched.clear.split_at(2);
        let shifts = [[0.0, -touched.signs[0] * stands(before)], [-touched.signs[1] * stands(beside), 0.0]];
        let [up, aside] = shifts.map(parts);
        // how much nearer to the corner than the places of a pair the line of the other pair passes
        let room = near + senses[0] * (up[0] - aside[0]);
        let line = senses[1] * (up[1] - aside[1]);
        // outside a place is no place before the edge beyond the corner
        let lowest = if touched.inside { line } else { line.max(0.0) };
        let fourth = given.unwrap_or((lowest + far) / 2.0);
        let wide = given.is_some() || far - lowest >= far / 2.0 || gap == LEAST;
        if room >= ROOM && fourth - line >= ROOM && (given.is_some() || far - fourth >= ROOM) && wide {
            let invented = plus(corner, other, senses[1] * fourth);
            let fourth = rest.first().copied().unwrap_or(invented);
            let before = |at: Flat, edge: usize| [at[0] + shifts[edge][0], at[1] + shifts[edge][1]];
            return Ok([before(first, 0), before(second, 0), before(third, 1), before(fourth, 1)]);
        }
    }
    Err(CORNER)
}

fn minus(a: Flat, b: Flat) -> Flat {
    [a[0] - b[0], a[1] - b[1]]
}

fn plus(a: Flat, way: Flat, part: f64) -> Flat {
    [a[0] + part * way[0], a[1] + part * way[1]]
}

fn cross(a: Flat, b: Flat) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

#[cfg(test)]
mod tests {
    #![allow(clippy::panic)]
    use super::*;
    use crate::workpiece::Noise;

    /// A corner in one of four positions, leaning, touched wherever there is room for the ball.
    fn drawn(noise: &mut Noise, position: usize, inside: bool, fourth: bool) -> Touched {
        let [x, y] = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]][position];
        let mut between = |low: f64, high: f64| low + (high - low) * noise.uniform();
        let lean = between(-0.3, 0.3);
        let (along, other) = ([x * lean.cos(), x * lean.sin()], [-y * lean.sin(), y * lean.cos()]);
        let corner = [between(-100.0, 100.0), between(-100.0, 100.0)];
        let on = |edge: Flat, far: f64| [corner[0] + far * edge[0], corner[1] + far * edge[1]];
        let near = between(10.0, 40.0);
        let mut at = vec![on(along, near + between(5.0, 60.0)), on(along, near), on(other, between(10.0, 80.0))];
        if fourth {
            at.push(on(other, between(81.0, 99.0)));
        }
        if between(0.0, 1.0) < 0.5 {
            at.swap(0, 1);
        }
        let clear = at.iter().map(|_| between(3.5, 60.0)).collect();
        let turn = if inside { -1.0 } else { 1.0 };
        Touched { at, clear, signs: [turn * y, turn * x], radius: 3.0, inside }
    }

    // oracle: manual A:15913, B:8046-8050: the lines of both pairs meet outside of both, and towards the edge is
    // towards the other pair outside, away from it inside; hand: no place is nearer than the ball, or farther than was
    // free
    #[test]
    fn four_places_are_a_corner_wherever_it_was_touched() {
        let mut noise = Noise::new(5);
        for number in 0..4000 {
            let (position, inside, given) = (number % 4, number / 4 % 2 == 1, number / 8 % 2 == 1);
            let touched = drawn(&mut noise, position, inside, given);
            let found = places(&touched);
            let [p1, p2, p3, p4] = found.unwrap_or_else(|why| panic!("{number} {why}: {touched:?}"));
            let (one, two) = (minus(p2, p1), minus(p4, p3));
            let across = cross(one, two);
            let shares = [cross(minus(p3, p1), two) / across, cross(minus(p3, p1), one) / across];
            assert!(shares.iter().all(|share| !(0.0..=1.0).contains(share)), "{number} {shares:?}: {touched:?}");
            let sense = if inside { -1.0 } else { 1.0 };
            for (line, from, others, axis) in [(one, p1, [p3, p4], 1), (two, p3, [p1, p2], 0)] {
                let middle = [0, 1].map(|i| (others[0][i] + others[1][i]) / 2.0);
                let side = cross(line, minus(middle, from)).signum() * sense;
                let towards = [-line[1] * side, line[0] * side];
                assert!(towards[axis] * touched.signs[1 - axis] > 0.0, "{number} {axis}: {touched:?}");
                assert!(towards[axis].abs() > towards[1 - axis].abs(), "{number} {axis}: {touched:?}");
            }
            for (index, place) in [p1, p2, p3, p4].into_iter().enumerate().take(touched.at.len()) {
                let axis = usize::from(index < 2);
                let (at, clear) = (touched.at[index], touched.clear[index]);
                assert_eq!(place[1 - axis], at[1 - axis], "the place of the touch stays");
                let stands = (at[axis] - place[axis]) * touched.signs[1 - axis];
                assert!(stands > touched.radius && stands <= clear + 1e-9, "{number} {stands} {clear}");
            }
        }
    }

    // oracle: hand: P1 and P2 on both sides of the corner, and a third point on the edge of the first two
    #[test]
    fn what_is_no_corner_is_none() {
        let touched = |at: [Flat; 3]| Touched {
            at: at.to_vec(),
            clear: vec![20.0; 3],
            signs: [1.0; 2],
            radius: 3.0,
            inside: false,
        };
        assert_eq!(places(&touched([[-30.0, 0.0], [30.0, 0.0], [0.0, 40.0]])), Err(CORNER));
        assert_eq!(places(&touched([[10.0, 0.0], [30.0, 0.0], [0.0, 0.0]])), Err(CORNER));
        assert_eq!(places(&touched([[10.0, 0.0], [10.0, 0.0], [0.0, 30.0]])), Err("jog-same-place"));
    }
}
