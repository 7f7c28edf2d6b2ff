//! Every motion of every variant of CYCLE997: order, side, height, feed.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::super::VARIANTS;
use super::simulation::{CENTRES, inputs, ready};
use crate::catalogue::sinumerik::testing::run;
use crate::control::Plane;
use crate::machine::{MotionKind, Sim, Step};

const PLANE_FEED: f64 = 1200.0;
const DEPTH_FEED: f64 = 700.0;
/// `_RF` of the inputs.
const ARC_FEED: f64 = 900.0;
/// `_FA` = 5 is above 1 (B:2164-2170).
const MEASURING_FEED: f64 = 300.0;

/// A motion: kind, end as abscissa, ordinate, applicate, feed.
type Motion = (MotionKind, [f64; 3], f64);

/// Ways about the centre of a sphere of 50 with a ball of 3 and `_FA` = 5: it is touched at 28, a block begins at 33,
/// and there the ball crosses it. `x33` goes there; `!x28` measures and returns; `@` follows an arc to what stands
/// behind it.
fn ways(variant: i64) -> String {
    let paraxial = "x33 z0 !x28 z33 x-33 z0 !x-28 z33 x0 y33 z0 !y28 z33 y-33 z0 !y-28 z33 y0 !z28";
    let three = "x33 z0 !x28 @0,33 !y28 @-33,0 !x-28 z33 x0 !z28";
    let four = "x33 z0 !x28 @0,33 !y28 @-33,0 !x-28 @0,-33 !y-28 z33 y0 !z28";
    let digit = |place: i64| variant / place % 10 == 1;
    let ways = match (digit(1000), digit(100_000)) {
        (false, _) => paraxial,
        (true, false) => three,
        (true, true) => four,
    };
    let end = if digit(1_000_000) { "x-33 z0 !x-28 z60 x0" } else { "z60" };
    let once = format!("{ways} {end}");
    if digit(10) { format!("{once} {once}") } else { once }
}

/// Ways as motions about a centre, from where the probe stands.
fn expand(ways: &str, centre: [f64; 3], here: &mut [f64; 3]) -> Vec<Motion> {
    let mut motions = Vec::new();
    for word in ways.split(' ') {
        if let Some(end) = word.strip_prefix('@') {
            let (x, y) = end.split_once(',').unwrap();
            here[0] = centre[0] + x.parse::<f64>().unwrap();
            here[1] = centre[1] + y.parse::<f64>().unwrap();
            motions.push((MotionKind::Positioning, *here, ARC_FEED));
            continue;
        }
        let (way, touch) = match word.strip_prefix('!') {
            Some(way) => (way, true),
            None => (word, false),
        };
        let axis = "xyz".find(&way[..1]).unwrap();
        let feed = if axis == 2 { DEPTH_FEED } else { PLANE_FEED };
        let mut to = *here;
        to[axis] = centre[axis] + way[1..].parse::<f64>().unwrap();
        if touch {
            motions.push((MotionKind::Measuring, to, MEASURING_FEED));
            motions.push((MotionKind::Retract, *here, feed));
        } else {
            motions.push((MotionKind::Positioning, to, feed));
            *here = to;
        }
    }
    motions
}

/// All motions of a call: on spheres that stand where they should, in turn.
fn expected(variant: i64) -> Vec<Motion> {
    let spheres = if variant / 10_000 % 10 == 1 { 3 } else { 1 };
    let at_an_angle = variant / 1000 % 10 == 1;
    let mut here = [CENTRES[0][0], CENTRES[0][1], CENTRES[0][2] + 60.0];
    let mut motions = Vec::new();
    for centre in &CENTRES[..spheres] {
        let above = [centre[0], centre[1], here[2]];
        if above != here {
            let to = if at_an_angle { [above[0] + 33.0, above[1], above[2]] } else { above };
            here = to;
            motions.push((MotionKind::Positioning, to, PLANE_FEED));
        }
        let ways = ways(variant);
        let ways = match at_an_angle && here != above {
            true => ways.strip_prefix("x33 ").unwrap(), // the way from sphere to sphere leads there
            false => &ways,
        };
        motions.extend(expand(ways, *centre, &mut here));
    }
    motions
}

/// What moves, in abscissa, ordinate, applicate; arcs keep their distance.
fn found(plane: Plane, variant: i64) -> Vec<Motion> {
    let mut setup = ready(plane, variant);
    setup.control.set("_SPEED[1]", PLANE_FEED);
    setup.control.set("_SPEED[2]", DEPTH_FEED);
    let mut sim = Sim::new(&setup);
    assert_eq!(run(&mut sim, &inputs(variant)), Ok(()), "{variant}");
    let mut motions: Vec<Motion> = Vec::new();
    for entry in &sim.trace.entries {
        let Step::Motion { kind, from, to, around, feed } = entry.step else { continue };
        assert_eq!(around.is_some(), feed == ARC_FEED, "{variant}");
        for place in around.iter().flat_map(|arc| [0.4, 1.0].map(|part| arc.at(from, to, part))) {
            let [x, y, _] = plane.axes().map(|axis| place[axis]);
            let away = |[a, b, _]: &[f64; 3]| (x - a).hypot(y - b);
            let radius = CENTRES.iter().map(away).fold(f64::INFINITY, f64::min);
            assert!((radius - 33.0).abs() < 1e-9, "{variant}: {place:?}");
        }
        let to = plane.axes().map(|axis| to[axis]);
        motions.push((kind, to, feed));
    }
    motions
}

// oracle: manual B:8421-8475 (order, heights, ends), hand (figures)
#[test]
fn every_variant_moves_as_its_table_says() {
    for plane in [Plane::G17, Plane::G18, Plane::G19] {
        for variant in VARIANTS.iter().map(|variant| variant.number) {
            let (found, expected) = (found(plane, variant), expected(variant));
            assert_eq!(found.len(), expected.len(), "{variant}: {found:#?}");
            for (is, wanted) in found.iter().zip(&expected) {
                assert_eq!((is.0, is.2), (wanted.0, wanted.2), "{variant}: {is:?} {wanted:?}");
                let near = (0..3).all(|axis| (is.1[axis] - wanted.1[axis]).abs() < 1e-9);
                assert!(near, "{variant} {plane:?}: {is:?} {wanted:?}");
            }
        }
    }
}
