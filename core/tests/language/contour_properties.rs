//! Tool radius compensation along any contour: it keeps its distance, and frames and planes carry it with them.

use super::contour::{BEGIN, routes};
use super::running::clean_on;
use super::{near, setup};
use probewright_core::machine::route::Route;
use proptest::prelude::*;
use std::f64::consts::TAU;

/// A contour and the distances from it.
#[derive(Clone, Debug)]
struct Closed {
    /// Corners, each with the radius of the arc that leads to the next one: 0 straight, positive G3, negative G2.
    corners: Vec<([f64; 2], f64)>,
}

impl Closed {
    fn edge(&self, index: usize) -> ([f64; 2], [f64; 2], f64) {
        let (from, radius) = self.corners[index];
        let (to, _) = self.corners[(index + 1) % self.corners.len()];
        (from, to, radius)
    }

    /// Centre of the arc of an edge, which is less than a half circle: to the left of its chord with G3.
    fn centre(&self, index: usize) -> [f64; 2] {
        let (from, to, radius) = self.edge(index);
        let chord = [to[0] - from[0], to[1] - from[1]];
        let length = chord[0].hypot(chord[1]);
        let rise = (radius * radius - length * length / 4.0).sqrt() * radius.signum() / length;
        [(from[0] + to[0]) / 2.0 - rise * chord[1], (from[1] + to[1]) / 2.0 + rise * chord[0]]
    }

    /// Its blocks from the middle of the first edge, which is straight, round it.
    fn blocks(&self) -> String {
        let mut text = String::new();
        for index in 0..self.corners.len() {
            let (_, to, radius) = self.edge(index);
            let [x, y] = to;
            text += &match radius {
                0.0 => format!("G1 X{x:.17} Y{y:.17}\n"),
                radius if radius > 0.0 => format!("G3 X{x:.17} Y{y:.17} CR={radius:.17}\n"),
                radius => format!("G2 X{x:.17} Y{y:.17} CR={:.17}\n", -radius),
            };
        }
        let [x, y] = self.middle();
        text + &format!("G1 X{x:.17} Y{y:.17}\n")
    }

    fn middle(&self) -> [f64; 2] {
        let (from, to, _) = self.edge(0);
        [(from[0] + to[0]) / 2.0, (from[1] + to[1]) / 2.0]
    }

    /// Distance of a point from it.
    fn distance(&self, point: [f64; 2]) -> f64 {
        let edges = (0..self.corners.len()).map(|index| self.away(index, point));
        edges.fold(f64::INFINITY, f64::min)
    }

    fn away(&self, index: usize, [x, y]: [f64; 2]) -> f64 {
        let (from, to, radius) = self.edge(index);
        let ends = [from, to].map(|end| (x - end[0]).hypot(y - end[1]));
        let ends = ends[0].min(ends[1]);
        let chord = [to[0] - from[0], to[1] - from[1]];
        if radius == 0.0 {
            let length = chord[0].hypot(chord[1]);
            let along = ((x - from[0]) * chord[0] + (y - from[1]) * chord[1]) / length;
            let across = ((y - from[1]) * chord[0] - (x - from[0]) * chord[1]) / length;
            return if (0.0..=length).contains(&along) { across.abs() } else { ends };
        }
        // the arc is on the other side of its chord than its centre, in the sector of its ends
        let centre = self.centre(index);
        let seen = |end: [f64; 2]| [end[0] - centre[0], end[1] - centre[1]];
        let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
        let (a, b, p) = (seen(from), seen(to), seen([x, y]));
        let inside = cross(a, p) * radius >= 0.0 && cross(p, b) * radius >= 0.0;
        if inside { (p[0].hypot(p[1]) - radius.abs()).abs() } else { ends }
    }
}

/// Stars about the zero, convex and not, with straight and round edges; the first edge is straight. Arcs are so flat
/// that two of them do not cross before a pointed corner.
fn closed() -> impl Strategy<Value = Closed> {
    let corner = (0.0..0.5, 50.0..100.0, prop::sample::select(vec![0.0, 60.0, -60.0, 300.0]));
    prop::collection::vec(corner, 4..9).prop_map(|list| {
        let count = list.len() as f64;
        let corners = list.into_iter().enumerate().map(|(index, (shift, out, radius))| {
            let angle: f64 = (index as f64 + shift) / count * TAU;
            let radius = if index == 0 { 0.0 } else { radius };
            ([out * angle.cos(), out * angle.sin()], radius)
        });
        let mut closed = Closed { corners: corners.collect() };
        for index in 0..closed.corners.len() {
            let (from, to, radius) = closed.edge(index);
            let chord = (to[0] - from[0]).hypot(to[1] - from[1]);
            if radius != 0.0 {
                closed.corners[index].1 = radius.signum() * radius.abs().max(2.0 * chord);
            }
        }
        closed
    })
}

/// The way round a contour on a side with a radius, from approach to departure.
fn round(closed: &Closed, side: &str, radius: f64, before: &str, style: &str) -> Vec<Route> {
    let [x, y] = closed.middle();
    let text = format!(
        "$TC_DP6[20,1]={radius}\n{BEGIN}{before}\n{style} {side} G1 X{x:.17} Y{y:.17}\n{}G40 X200 Y0\nM30",
        closed.blocks()
    );
    let outcome = clean_on(&setup(), &text);
    near(outcome.position[2], -30.0, &text);
    routes(&outcome).into_iter().map(|(_, route)| route).collect()
}

/// Places on all ways but the first and the last.
fn places(routes: &[Route]) -> Vec<[f64; 2]> {
    let inner = &routes[1..routes.len() - 1];
    let parts = |route: &Route| -> Vec<[f64; 2]> {
        (0..=20)
            .map(|part| {
                let [x, y, _] = route.at(f64::from(part) / 20.0).0;
                [x, y]
            })
            .collect()
    };
    inner.iter().flat_map(parts).collect()
}

/// Whether two ways go through the same places.
fn same(one: &[Route], other: &[Route], map: impl Fn([f64; 3]) -> [f64; 3]) -> bool {
    one.len() == other.len()
        && one.iter().zip(other).all(|(one, other)| {
            [0.0, 0.3, 0.8, 1.0].into_iter().all(|part| {
                let (a, b) = (map(one.at(part).0), other.at(part));
                (0..3).all(|i| (a[i] - b[i]).abs() < 1e-9)
            })
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    // oracle: hand: distances from the programmed lines and arcs, calculated without the offset
    #[test]
    fn the_path_keeps_the_radius_from_the_contour(
        closed in closed(), radius in 0.5..4.0, left in any::<bool>(), met in any::<bool>(),
    ) {
        let side = if left { "G41" } else { "G42" };
        let style = if met { "G451" } else { "G450" };
        let routes = round(&closed, side, radius, "", style);
        for place in places(&routes) {
            let distance = closed.distance(place);
            prop_assert!(distance > radius - 1e-9, "{distance} {radius} {place:?} {closed:?}");
            prop_assert!(met || distance < radius + 1e-9, "{distance} {radius} {place:?} {closed:?}");
        }
        let end = routes.last().unwrap().to;
        prop_assert!((end[0] - 200.0).abs() < 1e-9 && end[1].abs() < 1e-9);
    }

    // oracle: self: the frames carry the path with them, whatever side lies where
    #[test]
    fn frames_carry_the_path_with_them(
        closed in closed(), radius in 0.0..4.0, left in any::<bool>(), angle in -180.0..180.0,
    ) {
        let side = if left { "G41" } else { "G42" };
        let plain = round(&closed, side, radius, "", "");
        let mirrored = round(&closed, side, radius, "MIRROR X0", "");
        prop_assert!(same(&plain, &mirrored, |[x, y, z]| [-x, y, z]));
        let upside = round(&closed, side, radius, "MIRROR X0 Y0", "");
        prop_assert!(same(&plain, &upside, |[x, y, z]| [-x, -y, z]));
        let turned = round(&closed, side, radius, &format!("TRANS X5 Y7\nAROT Z{angle}"), "");
        let (sine, cosine) = f64::to_radians(angle).sin_cos();
        let turn = |[x, y, z]: [f64; 3]| {
            [5.0 + cosine * x - sine * y, 7.0 + sine * x + cosine * y, z]
        };
        prop_assert!(same(&plain[1..], &turned[1..], turn));
    }

    // oracle: the run without compensation
    #[test]
    fn a_tool_without_radius_goes_as_programmed(closed in closed(), left in any::<bool>()) {
        let side = if left { "G41" } else { "G42" };
        let plain = round(&closed, "G40", 0.0, "", "");
        let beside = round(&closed, side, 0.0, "", "");
        prop_assert!(same(&plain, &beside, |point| point));
    }
}

// oracle: self: the same contour in the other planes
#[test]
fn every_plane_is_like_the_first() {
    let blocks = "G41 G1 A0 B50\nA0 B100\nA60 B100\nG3 A100 B100 I20 J0\nG1 A100 B0\nA0 B0\nA0 B50\nG40 A-50 B50\nM30";
    let path = |plane: &str, axes: [usize; 3]| {
        let names = ["X", "Y", "Z"];
        let centres = ["I", "J", "K"];
        let text = blocks
            .replace('I', "#")
            .replace('J', "%")
            .replace('#', centres[axes[0]])
            .replace('%', centres[axes[1]])
            .replace('A', names[axes[0]])
            .replace('B', names[axes[1]]);
        let text = format!("{BEGIN}{plane} G0 X0 Y0 Z0\n{text}");
        let found = routes(&clean_on(&setup(), &text));
        let ends = found.into_iter().map(|(_, route)| axes.map(|axis| route.at(0.5)[axis]));
        ends.skip(1).collect::<Vec<_>>()
    };
    let first = path("G17", [0, 1, 2]);
    assert_eq!(first.len(), 13);
    for (plane, axes) in [("G18", [2, 0, 1]), ("G19", [1, 2, 0])] {
        for (a, b) in first.iter().zip(path(plane, axes)) {
            for i in 0..3 {
                near(b[i], a[i], plane);
            }
        }
    }
}
