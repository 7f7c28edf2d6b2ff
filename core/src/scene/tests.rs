//! Parts, tools and paths as they are drawn.
#![allow(clippy::unwrap_used)]

use super::frames::{Frame, UNITS};
use super::labels::{Kind, Label};
use super::mesh::Mesh;
use super::paths::Way;
use super::solid::{CHORD, figure, turns};
use super::tool::Tool;
use super::turned::{Diameter, Drawing, Reading, Touched, dimensions};
use super::{LineKind, Matter, Scene, Source, fit, labels, paths, tool};
use crate::control::{Plane, Units};
use crate::dialect::Dialect;
use crate::entry::names::{SETVAL, TSA};
use crate::geometry::{Around, Degrees, Dir, Extent, Mcs, Rpy, V3};
use crate::machine::{Entries, Entry, InUse, MotionKind, Setup, Step, Trace};
use crate::message::Message;
use crate::run::outcome::Outcome;
use crate::workpiece::{Drawn, PartErrors, Shape, Solid, Touching};
use std::f64::consts::TAU;

fn solid(shape: Shape) -> Solid {
    Solid::new(shape, Mcs::default())
}

fn entry(step: Step) -> Entry {
    Entry { line: None, step, in_use: 0 }
}

fn motion(from: [f64; 3], to: [f64; 3]) -> Step {
    Step::Motion { kind: MotionKind::Positioning, from: Mcs(from), to: Mcs(to), around: None, feed: 100.0 }
}

fn touch(point: [f64; 3], by: Touching) -> Step {
    Step::Touch { latched: Mcs(point), ball: Mcs(point), point: Mcs(point), normal: Dir::new([0.0, 0.0, 1.0]), by }
}

fn near(found: [f64; 3], wanted: [f64; 3]) {
    assert!((V3::from(found) - V3::from(wanted)).norm() < 1e-9, "{found:?} is not {wanted:?}");
}

/// A milling machine with a ball of 3 mm on which this happened.
fn happened(solids: Vec<Solid>, steps: Vec<Step>) -> Source {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.workpiece.solids = solids;
    let mut outcome = Outcome::new(&setup);
    outcome.trace.entries = steps.into_iter().map(entry).collect();
    Source { setup, outcome, zones: Vec::new(), limits: Vec::new(), call: None, apart: false }
}

/// What a label says: keys, each with its arguments.
fn said(label: &Label) -> String {
    let text = |message: &Message| {
        let args = message.args.iter().filter_map(|(name, _)| message.word(name));
        std::iter::once(message.key.as_ref()).chain(args).collect::<Vec<_>>().join(" ")
    };
    label.text.iter().map(text).collect::<Vec<_>>().join(", ")
}

/// Sum of the areas as vectors, and volume.
fn measured(mesh: &[&Mesh]) -> (V3, f64) {
    let mut sum = (V3::zeros(), 0.0);
    for mesh in mesh {
        for corners in &mesh.corners {
            let [a, b, c] = corners.map(|corner| mesh.vertices[corner as usize][0]);
            let face = (b - a).cross(&(c - a));
            sum = (sum.0 + face / 2.0, sum.1 + a.dot(&face) / 6.0);
        }
    }
    sum
}

// oracle: hand (a closed surface has no net area in any direction; the divergence theorem gives its volume)
#[test]
fn every_part_is_closed_faces_outwards_and_has_its_volume() {
    // a regular polygon on the circle
    let circle = |r: f64| {
        let sides = turns(r, CHORD) as f64;
        sides / 2.0 * r * r * (TAU / sides).sin()
    };
    let within = |r: f64, widest: f64| {
        let sides = turns(widest, CHORD) as f64;
        sides / 2.0 * r * r * (TAU / sides).sin()
    };
    // slices of a ball, each a frustum over a polygon
    let ball = |r: f64| {
        let sides = turns(2.0 * r, CHORD);
        let slice = |i: usize| {
            let [a, b] = [i, i + 1].map(|row| TAU * row as f64 / sides as f64);
            let (height, [u, v]) = (r * (a.cos() - b.cos()), [r * a.sin(), r * b.sin()]);
            sides as f64 / 2.0 * (TAU / sides as f64).sin() * height / 3.0 * (u * u + u * v + v * v)
        };
        (0..sides / 2).map(slice).sum::<f64>()
    };
    let sine = |degree: f64| degree.to_radians().sin();
    // material 20 mm beside and 10 mm below an element, a plate as large and 10 mm thick
    let (square, floor) = (|side: f64| (side + 40.0) * (side + 40.0), 10.0);
    let inner = (34.0 + 40.0 / sine(110.0)) * (24.0 + 40.0 / sine(110.0)) * (12.0 + floor) - 34.0 * 24.0 * 12.0;
    for (shape, volume) in [
        (Shape::Hole { diameter: 30.0, depth: 18.0 }, square(30.0) * (18.0 + floor) - circle(15.0) * 18.0),
        (Shape::Shaft { diameter: 30.0, height: 18.0 }, circle(15.0) * 18.0 + square(30.0) * floor),
        (Shape::Groove { width: 20.0, depth: 14.0, length: 46.0 }, 46.0 * (60.0 * (14.0 + floor) - 20.0 * 14.0)),
        (Shape::Web { width: 16.0, height: 14.0, length: 46.0 }, 46.0 * 16.0 * 14.0 + 56.0 * 86.0 * floor),
        (Shape::Pocket { length: [34.0, 24.0], depth: 12.0 }, 74.0 * 64.0 * (12.0 + floor) - 34.0 * 24.0 * 12.0),
        (Shape::Island { length: [34.0, 24.0], height: 12.0 }, 34.0 * 24.0 * 12.0 + 74.0 * 64.0 * floor),
        (Shape::Block { size: [46.0, 46.0, 16.0] }, 46.0 * 46.0 * 16.0),
        // half section
        (
            Shape::Turned { diameter: 40.0, length: 50.0, bore: [20.0, 30.0] },
            (circle(20.0) * 50.0 - within(10.0, 20.0) * 30.0) / 2.0,
        ),
        // body, and three jaws over the first third
        (
            Shape::Chuck { diameter: 60.0, length: 24.0, grip: 30.0 },
            circle(30.0) * 16.0 + 3.0 * (0.94 * 30.0 - 15.0) * (0.56 * 30.0) * 8.0,
        ),
        (Shape::Sphere { diameter: 30.0 }, ball(15.0)),
        // askew by the sine of the angle between the edges
        (
            Shape::OuterCorner { angle: Degrees(60.0), length: [30.0, 24.0], height: 16.0 },
            30.0 * 24.0 * 16.0 * sine(60.0),
        ),
        (Shape::InnerCorner { angle: Degrees(110.0), length: [34.0, 24.0], depth: 12.0 }, inner * sine(110.0)),
    ] {
        let drawn = figure(&solid(shape.clone()));
        let (area, found) = measured(&[&drawn.mesh, &drawn.cut]);
        assert!(area.norm() < 1e-6, "{shape:?}: {area:?}");
        assert!((found - volume).abs() < 1e-6 * volume, "{shape:?}: {found} is not {volume}");
    }
}

// oracle: hand (diameter 40 + 0.2 + 0.01 × depth 10 = 40.3; lobe amplitude 0.5 at the angle 0; 20 + 0.2 wide)
#[test]
fn errors_of_a_part_are_where_they_belong() {
    let errors = PartErrors { size: 0.2, taper: 0.01, out_of_round: (0.5, 3), ..PartErrors::default() };
    let drawn = |shape: Shape| figure(&Solid { errors, ..solid(shape) });
    let hole = drawn(Shape::Hole { diameter: 40.0, depth: 10.0 });
    let has = |mesh: &Mesh, point: [f64; 3]| mesh.vertices.iter().any(|[at, _]| (at - V3::from(point)).norm() < 1e-9);
    assert!(has(&hole.mesh, [20.15 + 0.5, 0.0, -10.0]));
    let pocket = drawn(Shape::Pocket { length: [40.0, 20.0], depth: 10.0 });
    assert!(has(&pocket.mesh, [20.1, -10.1, 0.0]));
}

// oracle: hand
#[test]
fn a_part_stands_as_the_last_rotary_axis_before_left_it() {
    let part = solid(Shape::Hole { diameter: 30.0, depth: 18.0 });
    let turned = Solid { at: Mcs([1.0, 2.0, 3.0]), rotation: Rpy([0.0, 0.0, 90.0]), ..part.clone() };
    let table = Step::Table { axis: 2, from: Degrees(0.0), to: Degrees(9.0), solids: vec![turned] };
    let scene = Scene::of(&happened(vec![part], vec![Step::Orient { angle: Degrees(0.0) }, table, Step::CallEnd]));
    let [before, after] = &scene.view.standings[..] else { unreachable!() };
    assert_eq!((before.entry, after.entry), (0, 1));
    assert_eq!((before.places[0].at, before.places[0].axes), ([0.0; 3], UNITS));
    near(after.places[0].at, [1.0, 2.0, 3.0]);
    near(after.places[0].axes[0], [0.0, 1.0, 0.0]);
}

// oracle: hand (nothing is touched and nothing moves: both origins with 20 mm around them)
#[test]
fn coordinate_systems_alone_are_seen_whole() {
    let frame = |at| Frame { name: String::new(), at, axes: UNITS, moved: None };
    let nothing = Extent::default();
    let seen = fit::around(&nothing, &nothing, &[frame([0.0; 3]), frame([300.0, -40.0, 5.0])]).shown;
    near(seen.low.into(), [-20.0, -60.0, -20.0]);
    near(seen.high.into(), [320.0, 20.0, 25.0]);
    near(fit::around(&nothing, &nothing, &[]).shown.high.into(), [20.0; 3]);
}

// oracle: hand (a cube of 20 mm, 34.6 across: with a zero at 15 it is 40.6 across, with one at 40 it would be 57.4, and
// one at 90 has no dimensions)
#[test]
fn a_zero_far_beside_a_part_makes_it_no_smaller() {
    let cube = Extent::of([V3::repeat(-10.0), V3::repeat(10.0)]);
    for (x, shown, beside) in [(15.0, 15.0, 15.0), (40.0, 10.0, 40.0), (90.0, 10.0, 10.0)] {
        let zero = Frame { name: String::new(), at: [x, 0.0, 0.0], axes: UNITS, moved: None };
        let seen = fit::around(&cube, &Extent::default(), &[zero]);
        near(seen.shown.high.into(), [shown, 10.0, 10.0]);
        near(seen.near.high.into(), [beside, 10.0, 10.0]);
    }
}

// oracle: hand
#[test]
fn the_probe_is_on_its_motion_and_stays_where_the_last_motion_ended() {
    let steps = [motion([0.0; 3], [10.0, 0.0, 0.0]), Step::CallEnd, motion([10.0, 0.0, 0.0], [10.0, 8.0, 0.0])];
    let entries: Entries = steps.into_iter().map(entry).collect();
    let stands = paths::stands(&entries, &[]);
    assert_eq!(stands, [[10.0, 0.0, 0.0], [10.0, 0.0, 0.0], [10.0, 8.0, 0.0]]);
    let ways = paths::ways(&entries);
    assert_eq!(
        ways.map(|way| (way.entry, way.ends)).collect::<Vec<_>>(),
        [(0, [[0.0; 3], [10.0, 0.0, 0.0]]), (2, [[10.0, 0.0, 0.0], [10.0, 8.0, 0.0]]),]
    );
    let late: Entries = [Step::CallEnd, motion([5.0, 0.0, 0.0], [0.0; 3])].into_iter().map(entry).collect();
    assert_eq!(paths::stands(&late, &[])[0], [5.0, 0.0, 0.0], "before its first motion it stands where that begins");
    assert!(paths::stands(&Entries::default(), &[]).is_empty());
}

// oracle: hand (a half turn and up by 4 about the axis X10, then a turn about an axis along X)
#[test]
fn an_arc_is_drawn_and_travelled_round_its_axis() {
    let arc = |from, to, around| {
        let (from, to) = (Mcs(from), Mcs(to));
        entry(Step::Motion { kind: MotionKind::Positioning, from, to, around: Some(around), feed: 900.0 })
    };
    let half = Around { centre: Mcs([10.0, 0.0, 0.0]), axis: Dir::new([0.0, 0.0, 1.0]), degrees: Degrees(-180.0) };
    let turn = Around { centre: Mcs([20.0, 0.0, 0.0]), axis: Dir::new([1.0, 0.0, 0.0]), degrees: Degrees(360.0) };
    let up = [20.0, 0.0, 4.0];
    let ways: Vec<Way> = paths::ways(&[arc([0.0; 3], up, half), arc(up, up, turn)].into_iter().collect()).collect();
    let at = |entry: usize, part: f64| {
        let done = |way: &&Way| way.entry == entry && (way.during[1] - part).abs() < 1e-12;
        ways.iter().find(done).unwrap().ends[1]
    };
    near(at(0, 0.5), [10.0, 10.0, 2.0]);
    near(at(1, 0.25), [20.0, -4.0, 0.0]);
    near(at(1, 1.0), up);
    let half: Vec<_> = ways.iter().filter(|way| way.entry == 0).collect();
    assert_eq!(half.len(), 60);
    for way in &half {
        let [x, y, _] = way.ends[1];
        assert!(((x - 10.0).hypot(y) - 10.0).abs() < 1e-9);
        assert!((way.during[1] - way.during[0] - 1.0 / 60.0).abs() < 1e-9);
    }
    near(half.last().unwrap().ends[1], up);
}

// oracle: hand
#[test]
fn grid_lines_are_one_two_or_five_times_a_power_of_ten_apart() {
    for (length, wanted) in [(0.9, 0.1), (18.0, 2.0), (58.0, 10.0), (430.0, 50.0), (1000.0, 100.0)] {
        assert!((fit::grid_spacing(length) - wanted).abs() < 1e-12, "{length}");
    }
}

/// Box around what is drawn of a tool.
fn reach_of(tool: &Tool, source: &Source) -> Extent {
    let meshes = tool::meshes(tool, &source.setup.probe, 30.0);
    Extent::of(meshes.iter().flat_map(|(_, mesh)| mesh.vertices.iter().map(|[at, _]| *at)))
}

// oracle: hand (in G18 the spindle stands along Y: above the ball there is nothing of the probe but along +Y)
#[test]
fn the_stylus_stands_along_the_axis_of_the_tool() {
    let source = happened(Vec::new(), Vec::new());
    for (axis, along) in [(V3::z(), 2), (V3::y(), 1), (V3::x(), 0), (-V3::z(), 5)] {
        let probe = Tool { ball: Some(axis), ..holding(Vec::new()) };
        let Extent { low, high } = reach_of(&probe, &source);
        for other in 0..3 {
            assert!(low[other].abs() < 16.0 || along == 5 && other == 2, "{axis}: {low}");
            assert_eq!(high[other] > 20.0, other == along, "{axis}: {high}");
        }
    }
}

fn holding(pieces: Vec<Drawn>) -> Tool {
    Tool { length: Dir::default(), ball: None, pieces, carrier: Vec::new(), tip: V3::zeros() }
}

fn mill() -> Drawn {
    Drawn::Round { outline: vec![[0.0, 0.0], [5.0, 0.0], [5.0, 50.0], [0.0, 50.0]], axis: V3::z(), at: V3::zeros() }
}

// oracle: hand (a plate of 10 × 10 × 4 mm, and a cylinder over a regular polygon)
#[test]
fn an_insert_and_a_mill_are_closed_and_face_outwards() {
    let corners = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]].map(|[x, z]| V3::new(x, 0.0, z));
    let insert = Drawn::Plate { corners: corners.to_vec(), thick: V3::y() * -4.0, cuts: true };
    let source = happened(Vec::new(), Vec::new());
    let sides = turns(5.0, CHORD) as f64;
    for (piece, volume) in [(insert, 400.0), (mill(), sides / 2.0 * 25.0 * (TAU / sides).sin() * 50.0)] {
        let meshes = tool::meshes(&holding(vec![piece]), &source.setup.probe, 30.0);
        let [(_, mesh)] = &meshes[..] else { unreachable!() };
        let (area, found) = measured(&[mesh]);
        assert!(area.norm() < 1e-9 && (found - volume).abs() < 1e-6 * volume, "{area} {found}");
    }
}

// oracle: hand (the axes stand still: a tool that is 10 mm longer in Z ends 10 mm lower, where the last motion led)
#[test]
fn another_length_in_effect_is_another_position() {
    let mut entries: Vec<Entry> = [motion([0.0; 3], [1.0, 0.0, 50.0]), Step::Tool { tool: 3, edge: 1 }, Step::CallEnd]
        .into_iter()
        .map(entry)
        .collect();
    entries[1].in_use = 1;
    entries[2].in_use = 1;
    let tools = [holding(Vec::new()), Tool { length: Dir::new([0.0, 0.0, 10.0]), ..holding(Vec::new()) }];
    let entries = entries.into_iter().collect();
    assert_eq!(paths::stands(&entries, &tools), [[1.0, 0.0, 50.0], [1.0, 0.0, 40.0], [1.0, 0.0, 40.0]]);
}

// oracle: hand (the probe until T3 is called at entry 1, then another tool, then the probe again)
#[test]
fn what_is_in_use_follows_the_tool_changes() {
    let steps =
        vec![motion([0.0; 3], [1.0, 0.0, 0.0]), Step::Tool { tool: 3, edge: 1 }, motion([1.0, 0.0, 0.0], [0.0; 3])];
    let mut source = happened(Vec::new(), [steps, vec![Step::Tool { tool: 9, edge: 1 }]].concat());
    let control = source.setup.control.clone();
    let probe = InUse {
        place: control.active_place(),
        plane: control.plane,
        length: Dir::default(),
        edge: None,
        tool: None,
        tip: Dir::default(),
        spindle: None,
        turns: false,
        recoded: false,
    };
    let Trace { entries, in_use, .. } = &mut source.outcome.trace;
    *in_use = vec![probe.clone(), InUse { place: (3, 1), ..probe }];
    let mut all = entries.to_vec();
    (all[1].in_use, all[2].in_use) = (1, 1);
    *entries = all.into_iter().collect();
    let scene = Scene::of(&source);
    assert_eq!(scene.view.in_use, [[0, 0], [1, 1], [3, 0]]);
    assert_eq!(scene.view.tools.len(), 2);
    let of_tools = scene.view.pieces.iter().filter(|piece| piece.place.is_none());
    assert!(of_tools.clone().any(|piece| piece.tool == Some(0)) && of_tools.clone().any(|piece| piece.tool == Some(1)));
}

// oracle: hand (a step of 40 mm that is 0.1 mm larger, its front at Z 10)
#[test]
fn a_drawing_has_its_diameters_before_the_front_and_those_at_touched_points() {
    let ends = [[-20.05, 0.0, 10.0], [20.05, 0.0, 10.0]];
    let diameter = Diameter { ends, out: [0.0, 0.0, 1.0], set: 40.0, real: 40.1 };
    let found = dimensions(&[diameter], 100.0);
    let [(_, [_, upper], lines)] = &found[..] else { unreachable!() };
    near(lines[2][0].into(), [-20.05, 0.0, 24.0]);
    near(lines[2][1].into(), [20.05, 0.0, 24.0]);
    near((*upper).into(), [20.05, 0.0, 24.0]);
    let point = [20.0, 0.0, 0.0];
    let mut scene = Scene::of(&happened(Vec::new(), vec![touch(point, Touching::Ball), touch(point, Touching::Ball)]));
    let reading = Reading { at: [0.0; 3], axes: UNITS, diameter: true, inch: false };
    let touched = [(0, 40.0), (1, 40.1)].map(|(entry, diameter)| Touched { entry, diameter }).to_vec();
    scene.add_drawing(&Drawing { diameters: vec![diameter], touched, reading }, &[SETVAL]);
    let of = |kind| scene.view.labels.iter().filter(move |label| label.kind == kind);
    let told: Vec<_> = of(Kind::Touched).map(|one| (one.at, said(one), one.from, one.to)).collect();
    assert_eq!(
        told,
        [
            (point, "diameter-real 40.000".to_owned(), Some(0), Some(1)),
            (point, "diameter-real 40.100".to_owned(), Some(1), None)
        ]
    );
    for (kind, words) in [(Kind::Diameter, "diameter-real 40.100"), (Kind::Nominal, "diameter-off +0.100 40.000")] {
        let [label] = of(kind).collect::<Vec<_>>()[..] else { unreachable!() };
        near(label.at, (*upper - V3::z() * (24.0 - 10.0) + V3::z() * 0.14 * scene.view.size).into());
        assert!(label.upper);
        assert_eq!((said(label).as_str(), label.field), (words, Some(SETVAL)));
    }
    assert!(scene.view.groups.iter().any(|group| group.kind == LineKind::Dimension));
}

// oracle: hand (a zone is seen through, comes behind all that hides lines, and is its walls alone)
#[test]
fn a_protection_zone_is_drawn_through() {
    let mut source = happened(Vec::new(), Vec::new());
    source.zones.push(solid(Shape::Shaft { diameter: 40.0, height: 20.0 }));
    let scene = Scene::of(&source);
    let [piece] = &scene.view.pieces[..] else { unreachable!() };
    assert_eq!((piece.matter, piece.place), (Matter::Zone, Some(0)));
    let vertices = scene.vertices.chunks_exact(6).map(|one| V3::new(one[0].into(), one[1].into(), one[2].into()));
    let Extent { low, high } = Extent::of(vertices);
    near(low.into(), [-20.0, -20.0, -20.0]);
    near(high.into(), [20.0, 20.0, 0.0]);
}

// oracle: hand: a touch of the ball in a measurement is none; a crash, a touch of the stylus and one that ends in an
// alarm are
#[test]
fn what_must_not_touch_and_did_is_told() {
    let told = || Step::Decision { message: Message::new("run-stylus") };
    let point = [1.0, 2.0, 3.0];
    let steps = [
        touch(point, Touching::Ball),
        motion([0.0; 3], point),
        touch(point, Touching::Stylus),
        told(),
        motion(point, [0.0; 3]),
        touch(point, Touching::Ball),
        told(),
        Step::Alarm(crate::diagnostic::Code::Alarm(61302)),
        Step::Crash { point: Mcs([4.0, 5.0, 6.0]), normal: Dir::new([1.0, 0.0, 0.0]), by: Touching::Body },
    ];
    let entries: Entries = steps.into_iter().map(entry).collect();
    let found = labels::collisions(&entries);
    let found: Vec<_> = found.iter().map(|one| (one.from, one.at, said(one))).collect();
    let told = |words: &str| words.to_owned();
    assert_eq!(
        found,
        [
            (Some(2), point, told("collision-first collision-stylus")),
            (Some(5), point, told("collision-alarm 61302 collision-ball")),
            (Some(8), [4.0, 5.0, 6.0], told("collision-crash collision-body")),
        ]
    );
}

// oracle: hand: four times against the same place, once against another
#[test]
fn a_place_that_is_hit_again_is_named_once() {
    let crash =
        |x: f64| Step::Crash { point: Mcs([x, 2.0, 3.0]), normal: Dir::new([1.0, 0.0, 0.0]), by: Touching::Ball };
    let entries: Entries = [1.0, 1.0, 1.2, 1.0, 9.0].map(crash).into_iter().map(entry).collect();
    let found: Vec<_> = labels::collisions(&entries).iter().map(|one| (one.from, one.at[0])).collect();
    assert_eq!(found, [(Some(0), 1.0), (Some(4), 9.0)]);
}

// oracle: hand: names of systems at one place stand together, those of others alone
#[test]
fn names_of_coordinate_systems_at_one_place_stand_together() {
    let frame = |name: &str, at, moved| Frame { name: name.to_owned(), at, axes: UNITS, moved };
    let frames = [frame("", [0.0; 3], None), frame("G54", [1.0; 3], Some("before")), frame("G55", [0.0; 3], None)];
    let labels = labels::frames(&frames);
    let told: Vec<_> = labels.iter().map(|label| (label.at, said(label))).collect();
    assert_eq!(
        told,
        [([0.0; 3], "frame-machine, frame-now G55".to_owned()), ([1.0; 3], "frame-before G54".to_owned())]
    );
}

// oracle: hand
#[test]
fn a_diameter_that_is_right_says_so() {
    let words =
        |real: f64| labels::dimension([0.0; 3], false, [40.0, real], None, Units::Metric).map(|label| said(&label));
    assert_eq!(words(40.000_4), ["diameter-real 40.000", "diameter-exact 40.000"]);
    assert_eq!(words(39.98), ["diameter-real 39.980", "diameter-off −0.020 40.000"]);
    let inches = labels::dimension([0.0; 3], false, [50.8, 50.83048], None, Units::Inch).map(|label| said(&label));
    assert_eq!(inches, ["diameter-real 2.0012", "diameter-off +0.0012 2.0000"]);
}

// oracle: hand: the second touch is on the larger diameter, and the last parameter counts for the rest
#[test]
fn a_dimension_carries_the_parameter_of_its_touch() {
    let touches = [[10.0, 0.0, -5.0], [20.0, 0.0, -9.0], [25.0, 0.0, -9.0]];
    let of = |diameter| labels::explained(&[SETVAL, TSA], &touches, V3::zeros(), V3::z(), diameter);
    assert_eq!([20.1, 40.0, 50.0, 60.0].map(of), [Some(SETVAL), Some(TSA), Some(TSA), None]);
    assert_eq!(labels::explained(&[], &touches, V3::zeros(), V3::z(), 20.0), None);
}

/// A hole of 40 mm whose diameter is off by so much, measured towards +X by a ball that meets it.
fn measured_hole(off: f64) -> Source {
    let mut hole = solid(Shape::Hole { diameter: 40.0, depth: 25.0 });
    hole.errors.size = off;
    let mut source = happened(vec![hole], Vec::new());
    let wall = 20.0 + off / 2.0;
    let ball = wall - source.setup.probe.radius;
    let at = |x: f64| [x, 0.0, -8.0];
    let measuring = |from: f64, to: f64, kind| Step::Motion {
        kind,
        from: Mcs(at(from)),
        to: Mcs(at(to)),
        around: None,
        feed: 300.0,
    };
    let touched = Step::Touch {
        latched: Mcs(at(ball)),
        ball: Mcs(at(ball)),
        point: Mcs(at(wall)),
        normal: Dir::new([-1.0, 0.0, 0.0]),
        by: Touching::Ball,
    };
    let steps = [measuring(0.0, ball, MotionKind::Measuring), touched, measuring(ball, 0.0, MotionKind::Retract)];
    source.outcome.trace.entries = steps.into_iter().map(entry).collect();
    source
}

// oracle: hand (0.02 mm a hundred times is 2 mm: the wall lies 1 mm farther out than in a hole without errors)
#[test]
fn exaggerated_errors_move_the_touch_and_its_motion_and_leave_its_value() {
    let source = measured_hole(0.02);
    let scene = Scene::exaggerated(&source, 100.0);
    let radius = source.setup.probe.radius;
    assert_eq!(scene.view.exaggerated, Some(100.0));
    near([scene.touches[0], scene.touches[1], scene.touches[2]], [21.0, 0.0, -8.0]);
    assert!((scene.ways[3] - (21.0 - radius)).abs() < 1e-6 && (scene.ways[8] - (21.0 - radius)).abs() < 1e-6);
    let told = scene.view.labels.iter().find(|label| label.kind == Kind::Touch).unwrap();
    assert_eq!((said(told).as_str(), told.number), ("touch-value X+ 20.010", Some(1)));
    near(told.at, [21.0, 0.0, -8.0]);
    let nominal = scene.view.groups.iter().filter(|group| group.kind == LineKind::Nominal).count();
    assert_eq!(nominal, 1);
    assert_eq!(Scene::exaggerated(&source, 1.0), Scene::of(&source));
}

// oracle: hand (1 mm a thousand times would leave nothing of a part of 80 × 80 × 25 mm)
#[test]
fn errors_are_no_more_exaggerated_than_still_draws_the_part() {
    let times = Scene::exaggerated(&measured_hole(1.0), 1000.0).view.exaggerated.unwrap();
    assert!((10.0..40.0).contains(&times), "{times}");
    assert_eq!(Scene::exaggerated(&measured_hole(0.0), 1000.0).view.exaggerated, Some(1000.0));
}

// oracle: hand (50 mm at 100 mm/min are half a minute; rapid traverse of 100 mm at 10 m/min is 0.6 s)
#[test]
fn motions_take_their_time_at_their_feed() {
    let rapid = Step::Motion {
        kind: MotionKind::Rapid,
        from: Mcs([50.0, 0.0, 0.0]),
        to: Mcs([150.0, 0.0, 0.0]),
        around: None,
        feed: 0.0,
    };
    let steps = [motion([0.0; 3], [50.0, 0.0, 0.0]), touch([50.0, 0.0, 0.0], Touching::Ball), rapid].map(entry);
    let begins = paths::begins(&steps.into_iter().collect());
    let wanted = [0.0, 30.0, 30.0, 30.6];
    assert!(begins.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-9), "{begins:?}");
}

// oracle: hand (the second touch is at the place of the first; a cycle begins its own count)
#[test]
fn touches_are_numbered_in_their_call_and_shown_until_the_next_one() {
    let call = || Step::CallBegin { cycle: "CYCLE977", variant: 1 };
    let at = |x: f64| touch([x, 0.0, 5.0], Touching::Ball);
    let entries = [call(), at(1.0), at(1.2), at(9.0), call(), at(3.0)].map(entry);
    let setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    let found = labels::touches(&setup.control, Units::Metric, &entries.into_iter().collect());
    let told: Vec<_> = found.iter().map(|label| (label.number, label.from, label.to)).collect();
    let wanted = [(1, 1, Some(2)), (2, 2, Some(4)), (3, 3, Some(4)), (1, 5, None)];
    assert_eq!(told, wanted.map(|(number, from, to)| (Some(number), Some(from), to)));
    assert_eq!(said(&found[0]), "touch-value Z− 5.000");
    let entries = [call(), at(1.0)].map(entry).into_iter().collect();
    assert_eq!(said(&labels::touches(&setup.control, Units::Inch, &entries)[0]), "touch-value Z− 0.1969");
}
