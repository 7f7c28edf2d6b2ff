//! What is drawn is what is touched: points of every drawn surface of every variant of every cycle lie on the surface
//! against which the probe is held, with every error slider at a random value.
#![cfg(feature = "json")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::entry::ProbeUse;
use probewright_core::geometry::V3;
use probewright_core::name::Name;
use probewright_core::picture::ShapeKind;
use probewright_core::scene::solid::CHORD;
use probewright_core::scene::{LineKind, Matter, Piece, Place, Scene};
use probewright_core::workpiece::contact::Boundary;
use probewright_core::workpiece::{Shape, Solid, Workpiece};
use probewright_core::{app, json};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngSeed, TestRunner};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};

/// Most vertices and triangles of a piece that are looked at.
const LOOKED_AT: usize = 24;

/// The sliders of part and probe, as far as they are moved.
fn sliders() -> impl Strategy<Value = Value> {
    let part = (prop::array::uniform3(-2.0..2.0_f64), -1.0..1.0_f64, -3.0..3.0_f64, -0.1..0.1_f64, 0.0..0.2_f64);
    let probe = (prop::array::uniform3(-0.2..0.2_f64), 0.0..0.2_f64, 0.0..0.02_f64);
    (part, probe).prop_map(|(([dx, dy, dz], size, tilt, taper, lobes), ([x, y, radius], travel, noise))| {
        json!({
            "part": { "dx": dx, "dy": dy, "dz": dz, "size": size, "tilt": tilt, "taper": taper, "outOfRound": lobes },
            "probe": { "skewX": x, "skewY": y, "radius": radius, "preTravel": travel, "repeatability": noise },
        })
    })
}

/// Every variant of every cycle that is simulated, carried out with random errors or with none: its name, and what its
/// form shows.
fn variants(spoilt: bool) -> Vec<(String, app::FormView)> {
    let seed = std::env::var("PROBEWRIGHT_SEED").ok().and_then(|seed| seed.parse().ok()).unwrap_or(1);
    let config = Config { rng_seed: RngSeed::Fixed(seed), failure_persistence: None, ..Config::default() };
    let mut runner = TestRunner::new(config);
    let mut found = Vec::new();
    let catalogue = json::document(&app::catalogue());
    for cycle in catalogue["cycles"].as_array().unwrap() {
        for variant in cycle["variants"].as_array().unwrap() {
            let plane = cycle["purpose"]["plane"].as_str().unwrap_or("G17");
            let own = variant["planes"].get(plane).unwrap_or(variant);
            let request = json!({
                "control": cycle["control"], "cycle": cycle["cycle"], "values": own["example"], "predict": true,
                "limits": spoilt && found.len() % 20 == 0,
                "errors": if spoilt { sliders().new_tree(&mut runner).unwrap().current() } else { json!({}) },
                "setup": { "own": { "plane": plane, "units": if cycle["control"] == "nct" { "G21" } else { "G71" } } },
            });
            let name = format!("{} {}", cycle["cycle"], variant["mvar"]);
            let asked = json::question(&request.to_string());
            let view = asked.and_then(app::form).unwrap_or_else(|why| panic!("{name}: {why:?}"));
            found.push((name, view));
        }
    }
    found
}

fn moved(place: &Place, [point, normal]: [V3; 2]) -> [V3; 2] {
    let turned = |one: V3| (0..3).map(|axis| V3::from(place.axes[axis]) * one[axis]).sum::<V3>();
    [V3::from(place.at) + turned(point), turned(normal)]
}

/// The triangles of a piece: places and normals of their corners, machine coordinates.
fn triangles(scene: &Scene, piece: &Piece, place: &Place) -> Vec<[[V3; 2]; 3]> {
    let vertex = |corner: u32| {
        let numbers: Vec<f64> =
            scene.vertices[6 * corner as usize..][..6].iter().map(|value| f64::from(*value)).collect();
        moved(place, [V3::from_column_slice(&numbers[..3]), V3::from_column_slice(&numbers[3..])])
    };
    let corners = scene.corners[piece.corners[0]..piece.corners[1]].chunks_exact(3);
    corners.map(|corners| [0, 1, 2].map(|i| vertex(corners[i]))).collect()
}

/// Spread over all.
fn some<T>(all: &[T]) -> impl Iterator<Item = &T> {
    all.iter().step_by(all.len().div_ceil(LOOKED_AT).max(1))
}

/// Holds a piece against the boundary of its solid; gives how many points were looked at.
fn hold(name: &str, scene: &Scene, piece: &Piece, place: &Place, solid: &Solid) -> usize {
    let part = Boundary::of(&Workpiece { solids: vec![solid.clone()] });
    let triangles = triangles(scene, piece, place);
    let distance = |point: V3| part.distance(point.into());
    let far = V3::from(place.at).norm();
    // a cut goes through the material, and jaws sweep what is touched of a chuck
    let within = matches!(piece.matter, Matter::Cut | Matter::Chuck);
    let check = |point: V3, most: f64, what: &str| {
        let off = distance(point);
        let fits = if within { off <= most } else { off.abs() <= most };
        assert!(fits, "{name}, {:?} {solid:?}: {what} {point:?} is {off} mm off", piece.matter);
    };
    let mut looked_at = 0;
    for corners in some(&triangles) {
        let exact =
            1e-6 + 2e-7 * corners.iter().map(|[at, _]| (at - V3::from(place.at)).norm()).fold(far * 1e-8, f64::max);
        // f32 may put it behind the rim in which two faces meet, where only the other one counts
        let normal = corners.iter().map(|[_, normal]| normal).sum::<V3>().normalize();
        let middle = corners.iter().map(|[at, _]| at).sum::<V3>() / 3.0;
        let out = |at: V3| at.lerp(&middle, 1e-5) + normal * exact;
        for [at, _] in corners {
            check(out(*at), 2.0 * exact, "a corner");
        }
        let [a, b, c] = corners.map(|[at, _]| at);
        for [u, v] in [[0.5, 0.5], [0.5, 0.0], [0.0, 0.5], [1.0 / 3.0, 1.0 / 3.0]] {
            check(out(a + (b - a) * u + (c - a) * v), CHORD + 2.0 * exact, "a point");
        }
        looked_at += 7;
        let across = (b - a).cross(&(c - a)).normalize();
        assert!(across.dot(&normal) > 0.9, "{name}: {corners:?} shows its back");
        if !within && !matches!(solid.shape, Shape::Free(_)) {
            let (step, foot) = (2e-4, middle - normal * distance(middle));
            let grown = distance(foot + normal * step) - distance(foot - normal * step);
            assert!(grown > 1.98 * step, "{name} {solid:?}: {normal:?} at {middle:?} does not lead out: {grown}");
        }
    }
    looked_at
}

// oracle: peer: the distance of a point from the boundary against which contact is computed
#[test]
fn every_drawn_point_is_on_the_surface_that_is_touched() {
    let mut looked_at: BTreeMap<&str, usize> = BTreeMap::new();
    for (name, view) in variants(true) {
        let Some(source) = view.outcome.map(|outcome| outcome.trace) else { continue };
        let scene = Scene::of(&source);
        let probes = source.setup.tool_probes.iter().map(|probe| &probe.solid);
        let solids: Vec<&Solid> = source.setup.workpiece.solids.iter().chain(probes).chain(&source.zones).collect();
        let mut touched = false;
        for piece in &scene.view.pieces {
            let Some(place) = piece.place else {
                continue;
            };
            let count = hold(&name, &scene, piece, &scene.view.standings[0].places[place], solids[place]);
            *looked_at.entry(word(piece.matter, &solids[place].shape)).or_default() += count;
            touched = true;
        }
        let something = !source.setup.workpiece.solids.is_empty() || !source.setup.tool_probes.is_empty();
        assert_eq!(touched, something, "{name}");
    }
    let wanted = ["block", "chuck", "cut", "hole", "groove", "island", "pocket", "shaft", "sphere", "turned", "web"];
    for shape in wanted {
        assert!(looked_at.get(shape).is_some_and(|count| *count > 50), "{shape}: {looked_at:?}");
    }
}

fn word(matter: Matter, shape: &Shape) -> &'static str {
    match (matter, shape) {
        (Matter::Cut, _) => "cut",
        (Matter::Zone, _) => "zone",
        (_, Shape::Hole { .. }) => "hole",
        (_, Shape::Shaft { .. }) => "shaft",
        (_, Shape::Groove { .. }) => "groove",
        (_, Shape::Web { .. }) => "web",
        (_, Shape::Pocket { .. }) => "pocket",
        (_, Shape::Island { .. }) => "island",
        (_, Shape::OuterCorner { .. }) => "outer corner",
        (_, Shape::InnerCorner { .. }) => "inner corner",
        (_, Shape::Block { .. }) => "block",
        (_, Shape::Turned { .. }) => "turned",
        (_, Shape::Chuck { .. }) => "chuck",
        (_, Shape::Sphere { .. }) => "sphere",
        (_, Shape::Free(_)) => "free",
    }
}

// oracle: self (what the entry declares, and what is to be seen whole), and hand: every dimension has a name and lines
#[test]
fn every_anchor_explains_a_parameter_of_its_entry_and_lies_within_the_scene() {
    let mut carried: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    let mut lost = Vec::new();
    for (name, view) in variants(false) {
        let Some(source) = view.outcome.map(|outcome| outcome.trace) else { continue };
        let scene = Scene::of(&source);
        let cycle = source.call.as_ref().expect("a form asked").cycle;
        let shown = scene.view.standings[0].whole.map(V3::from);
        let zeros = scene.view.frames.iter().map(|frame| V3::from(frame.at));
        let [low, high] = zeros.fold(shown, |[low, high], zero| [low.inf(&zero), high.sup(&zero)]);
        let room = 0.25 * (high - low).norm(); // a dimension stands beside the part
        for group in scene.view.groups.iter().filter(|group| group.field.is_some()) {
            let field = group.field.unwrap();
            assert!(cycle.param(&field).is_some(), "{name} has no {field}");
            assert!(matches!(group.kind, LineKind::Size | LineKind::Anchor), "{name} {group:?}");
            assert!(scene.view.labels.iter().any(|label| label.field == Some(field)), "{name} {field} has no name");
            for point in scene.lines[6 * group.lines[0]..6 * group.lines[1]].chunks_exact(3) {
                let beyond = (0..3).map(|axis| (low[axis] - point[axis]).max(point[axis] - high[axis]));
                let off = beyond.fold(0.0, f64::max);
                assert!(off <= room, "{name}: {field} at {point:?} is {off} mm beside {low:?} {high:?}");
            }
            carried.entry(cycle.name).or_default().insert(field.as_str());
        }
        if cycle.purpose.probe == ProbeUse::Log {
            continue; // its picture is of lines on paper
        }
        let drawn = view.picture.iter().flat_map(|picture| &picture.shapes);
        let lengths = drawn.filter(|shape| shape.kind == ShapeKind::Dimension).filter_map(|shape| {
            let named = |field: &Name| shape.text.as_deref() == Some(field.as_str()); // else it stands for no parameter
            shape.field.filter(named)
        });
        let there = |field: &Name| scene.view.groups.iter().any(|group| group.field == Some(*field));
        lost.extend(lengths.filter(|field| !there(field)).map(|field| format!("{} {field}", cycle.name)));
    }
    assert_eq!(carried["CYCLE977"], BTreeSet::from(["_FA", "_ID", "_SETVAL", "_SETV[0]", "_SETV[1]", "_SZA", "_SZO"]));
    // a way from far above the part, which is shown as large as it can be; and nothing is touched by the others
    let from_above = ["G104 Z", "G106 Z", "P9920 Z"];
    let untouched = ["CYCLE116", "G101"];
    lost.retain(|one| {
        !from_above.iter().any(|way| one.ends_with(way)) && !untouched.iter().any(|name| one.starts_with(name))
    });
    assert!(lost.is_empty(), "{lost:?}");
}
