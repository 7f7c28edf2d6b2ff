//! A milling cycle on a turning machine: the same measurement of the same part gives the same results, corrections and
//! motions with a probe of type 710 in the spindle of a milling machine and with one of type 5xy that stands on the
//! plane of a turning machine, in every variant, after the same calibration with CYCLE976.
// oracle: manual B:4148-4152, B:5358, B:5480, B:5818, B:6400, B:6871, B:7528, B:7836: the cycles are used there as they
// are

use super::bench::at;
use probewright_core::catalogue::example::example;
use probewright_core::catalogue::find;
use probewright_core::check::check;
use probewright_core::control::{Edge, Frame, Plane, Transverse};
use probewright_core::diagnostic::Code;
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, Inputs, Typed, Variant, names};
use probewright_core::geometry::{Dir, Rpy};
use probewright_core::machine::trace::Step;
use probewright_core::machine::{Setup, Stop};
use probewright_core::run::{Outcome, predict};
use probewright_core::workpiece::tool::{Cut, Nose, Tool};
use probewright_core::workpiece::{PartErrors, Probe, ProbeBody};

const CYCLES: [&str; 6] = ["CYCLE976", "CYCLE977", "CYCLE978", "CYCLE979", "CYCLE998", "CYCLE961"];
/// What the probe is really long, mm; it is entered as 50.
const LENGTH: f64 = 50.04;
/// Lengths of the turning machine's probe across its body, mm: some, as they do not matter.
const ACROSS: [f64; 2] = [12.3, -4.5];

/// Plane and cutting edge position of a probe that stands on it from the plus side (B:4152).
const STANDS: [(Plane, i64); 2] = [(Plane::G17, 7), (Plane::G19, 8)];

fn spindle(plane: Plane) -> Setup {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, plane);
    setup.probe = Probe {
        radius: 2.96,
        skew: [0.05, -0.03],
        pre_travel: (0.02, 0.0),
        length: LENGTH,
        stylus: Some(1.0),
        body: Some(ProbeBody { radius: 6.0, distance: 49.0 }),
        ..setup.probe
    };
    setup.control.set("_CHBIT[4]", 1.0);
    setup.control.frames.insert(1, Frame::translation([30.0, 40.0, 50.0]));
    setup.control.settable = 1;
    setup.control.activate(1);
    setup
}

/// The same machine with the probe of a turning machine, as long along the applicate.
fn turret(plane: Plane, tip: i64) -> Setup {
    let mut setup = spindle(plane);
    let [one, other] = ACROSS;
    let edge = Edge { kind: 580, tip, length: [one, other, 50.0], radius: 3.0, ..Edge::default() };
    let control = &mut setup.control;
    control.set("SD42950", 2.0);
    control.transverse = Transverse::Diameter;
    let place = (control.tool, control.edge);
    let probe = control.tools.get_mut(&place.0).unwrap();
    probe.edges.insert(place.1, edge);
    let cut = Cut::Nose(Nose { radius: 3.0, side: [0.0; 2] });
    let length = [one, other, LENGTH];
    setup.real_tools.insert(place, Tool { length, cut });
    setup
}

/// The worked measurement of a variant, each correction that it offers chosen; none where the cycle refuses it.
fn inputs(setup: &Setup, cycle: &'static Cycle, variant: &Variant, more: &[(&str, &str)]) -> Option<Inputs> {
    let mut typed: Typed = example(cycle, variant);
    let more = more.iter();
    typed.extend(more.map(|(name, value)| ((*name).to_owned(), (*value).to_owned())));
    check(cycle, &typed, &setup.control).inputs
}

/// Carries a call out on the part that it proposes, made wrong; what it wrote stays.
fn measure(setup: &mut Setup, inputs: &Inputs) -> Outcome {
    let proposal = (inputs.cycle.work().unwrap().propose)(inputs, &setup.control);
    setup.workpiece = proposal.workpiece;
    let plane = setup.control.plane;
    let shift = setup.control.direction_to_machine(Dir::new(at(plane, [0.11, -0.07, 0.13]))).0;
    for solid in &mut setup.workpiece.solids {
        solid.errors = PartErrors { shift, size: 0.05, tilt: Rpy(at(plane, [0.0, 0.0, 0.1])), ..PartErrors::default() };
    }
    setup.workpiece.solids.extend(proposal.fixture);
    for proposed in proposal.tools {
        let tool = setup.control.tools.entry(proposed.tool).or_default();
        tool.edges.entry(proposed.edge).or_insert(proposed.data);
    }
    setup.position = setup.control.to_machine(proposal.start);
    let outcome = predict(inputs.cycle, inputs, setup);
    setup.control = outcome.control.clone();
    outcome
}

/// What the probe did and where.
fn steps(outcome: &Outcome) -> Vec<(String, [f64; 3])> {
    let entries = outcome.trace.entries.iter();
    let told = entries.filter_map(|entry| match &entry.step {
        Step::Motion { kind, to, .. } => Some((format!("{kind:?}"), to.0)),
        Step::Touch { latched, by, .. } => Some((format!("{by:?}"), latched.0)),
        Step::Orient { angle } => Some(("turn".to_owned(), [angle.0, 0.0, 0.0])),
        Step::Crash { point, by, .. } => Some((format!("crash {by:?}"), point.0)),
        _ => None,
    });
    told.collect()
}

/// Results, data of the probe, frame and tools, the lengths of each tool by the axis along which they count.
fn left(setup: &Setup) -> Vec<(String, f64)> {
    let control = &setup.control;
    let names = (0..32).map(|index| format!("_OVR[{index}]"));
    let names = names.chain((0..14).map(|index| format!("_OVI[{index}]")));
    let names = names.chain((0..10).map(|index| format!("_WP[0,{index}]")));
    let mut left: Vec<(String, f64)> = names.map(|name| (name.clone(), control.number(&name))).collect();
    for (number, tool) in &control.tools {
        for (edge, data) in &tool.edges {
            for (i, axis) in control.length_axes(data).into_iter().enumerate() {
                let across = *number == control.tool && axis != 2;
                let begin = if *number == control.tool { data.length[i] } else { 0.0 };
                let length = if across { 0.0 } else { begin + data.length_wear[i] };
                left.push((format!("T{number} D{edge} {axis}"), length));
            }
            left.push((format!("T{number} D{edge} radius"), data.radius + data.radius_wear));
        }
    }
    left.sort_by(|one, other| one.0.cmp(&other.0));
    for frame in control.frames.values() {
        let values = frame.coarse.into_iter().chain(frame.fine).chain(frame.rotation.0);
        left.extend(values.map(|value| ("frame".to_owned(), value)));
    }
    left
}

fn same(one: &[(String, f64)], other: &[(String, f64)], what: &str) {
    assert_eq!(one.len(), other.len(), "{what}");
    for (a, b) in one.iter().zip(other) {
        assert!(a.0 == b.0 && (a.1 - b.1).abs() < 1e-9, "{what}: {a:?} {b:?}");
    }
}

/// Measures on both machines and holds one against the other; whether the cycle came to its end.
fn both(machines: &mut [Setup; 2], cycle: &'static Cycle, variant: &Variant, more: &[(&str, &str)]) -> bool {
    let what = format!("{} {} {more:?} {:?}", cycle.name, variant.number, machines[0].control.plane);
    let [here, there] = machines.each_ref().map(|setup| inputs(setup, cycle, variant, more));
    assert_eq!(here.is_some(), there.is_some(), "{what}");
    let (Some(here), Some(there)) = (here, there) else {
        return false;
    };
    let [milled, turned] = machines;
    let (one, other) = (measure(milled, &here), measure(turned, &there));
    assert_eq!(one.stop, other.stop, "{what}");
    let (steps, others) = (steps(&one), steps(&other));
    assert_eq!(steps.len(), others.len(), "{what}");
    for (a, b) in steps.iter().zip(&others) {
        let apart = (0..3).map(|axis| (a.1[axis] - b.1[axis]).abs()).fold(0.0, f64::max);
        assert!(a.0 == b.0 && apart < 1e-9, "{what}: {a:?} {b:?}");
    }
    same(&left(milled), &left(turned), &what);
    one.stop.is_none()
}

/// Measuring axes: of CYCLE998 with the one across in front, two of the plane and one with the applicate.
fn axes(name: &str) -> [&'static str; 3] {
    match name {
        "CYCLE998" => ["102", "201", "301"],
        _ => ["1", "2", "3"],
    }
}

fn cycle(name: &str) -> &'static Cycle {
    find(Dialect::Sinumerik, name).unwrap()
}

/// Both machines, their probe calibrated with all that CYCLE976 can find.
fn calibrated(plane: Plane, tip: i64) -> [Setup; 2] {
    let mut machines = [spindle(plane), turret(plane, tip)];
    let cycle = cycle("CYCLE976");
    let variant = |number| cycle.variants.iter().find(|one| one.number == number).unwrap();
    assert!(both(&mut machines, cycle, variant(10_101), &[("_TSA", "3.5")]));
    let length = [("_SETVAL", "20"), ("_MA", "3"), ("_MD", "1"), ("_FA", "12"), ("_TSA", "25")];
    assert!(both(&mut machines, cycle, variant(10_000), &length));
    machines
}

#[test]
fn the_probe_of_a_turning_machine_measures_as_the_one_in_a_spindle() {
    for (plane, tip) in STANDS {
        let ready = calibrated(plane, tip);
        for name in CYCLES.into_iter().chain(["CYCLE997"]) {
            let cycle = cycle(name);
            let mut ended = 0;
            for variant in cycle.variants {
                let of_one_axis = inputs(&ready[0], cycle, variant, &[]);
                let of_one_axis = of_one_axis.is_none_or(|inputs| inputs.uses(names::MA));
                let [first, second, third] = axes(name);
                for (axis, probe) in [(first, "1"), (first, "101"), (second, "1"), (third, "1")] {
                    if axis != first && !of_one_axis {
                        continue;
                    }
                    let wide = [("_TSA", "2"), ("_TDIF", "2")];
                    let more = [[("_MA", axis), ("_PRNUM", probe)], wide].concat();
                    ended += usize::from(both(&mut ready.clone(), cycle, variant, &more));
                }
            }
            assert!(ended >= cycle.variants.len(), "{name} {plane:?}: {ended}");
        }
    }
}

/// The call for a probe that comes from the minus side of the applicate: it goes down and up the other way.
fn from_below(
    variant: &Variant,
    cycle: &'static Cycle,
    more: &[(&'static str, String)],
) -> Vec<(&'static str, String)> {
    let mut values = more.to_vec();
    let typed = example(cycle, variant);
    if let Some(infeed) = typed.get("_ID").filter(|_| cycle.name != "CYCLE998") {
        let infeed: f64 = infeed.parse().unwrap();
        values.push(("_ID", (-infeed).to_string()));
    }
    values
}

// oracle: manual B:4150-4152 (positions 5 and 6 are permitted as well), hand: what is measured in the plane does not
// depend on the side from which the probe comes, and its body is in the way from no other side
#[test]
fn a_probe_from_the_minus_side_measures_the_same_in_the_plane() {
    for (plane, [above, below]) in [(Plane::G17, [7, 5]), (Plane::G19, [8, 6])] {
        for name in CYCLES {
            let cycle = cycle(name);
            let mut ended = 0;
            // two angles at once are measured along the applicate
            let plane_angle = |one: &&Variant| name != "CYCLE998" || one.number < 100_000;
            for variant in cycle.variants.iter().filter(plane_angle) {
                let measured = inputs(&turret(plane, above), cycle, variant, &[]);
                let [first, second, _] = axes(name);
                for axis in [first, second] {
                    if axis != first && measured.as_ref().is_some_and(|inputs| !inputs.uses(names::MA)) {
                        continue;
                    }
                    let what = format!("{name} {} {axis} {plane:?}", variant.number);
                    let wide = [("_MA", axis), ("_TSA", "2"), ("_TDIF", "2")];
                    let wide = wide.map(|(name, value)| (name, value.to_owned()));
                    let mut other = wide.to_vec();
                    let found = [above, below].map(|tip| {
                        let mut setup = turret(plane, tip);
                        setup.control.set("_WP[0,0]", 5.88);
                        if tip == below {
                            other = from_below(variant, cycle, &wide);
                        }
                        let values: Vec<(&str, &str)> =
                            other.iter().map(|(name, value)| (*name, value.as_str())).collect();
                        let inputs = inputs(&setup, cycle, variant, &values)?;
                        let outcome = measure(&mut setup, &inputs);
                        assert_eq!(outcome.stop, None, "{what} {tip}");
                        let told = left(&setup).into_iter();
                        Some(told.filter(|(name, _)| name.starts_with("_OVR")).collect::<Vec<_>>())
                    });
                    assert_eq!(found[0].is_some(), found[1].is_some(), "{what}");
                    if let [Some(one), Some(other)] = found {
                        same(&one, &other, &what);
                        ended += 1;
                    }
                }
            }
            assert!(ended >= cycle.variants.len() / 2, "{name} {plane:?}: {ended}");
        }
    }
}

// oracle: hand: the face stands 0.13 mm further in plus direction, from whichever side it is touched
#[test]
fn along_the_applicate_the_probe_touches_in_the_direction_in_which_it_points() {
    for (plane, tip) in [(Plane::G17, 7), (Plane::G17, 5), (Plane::G19, 8), (Plane::G19, 6)] {
        let mut setup = turret(plane, tip);
        setup.real_tools.clear(); // as long as its data say
        setup.probe.pre_travel.0 = 0.0;
        setup.probe.radius = 3.0;
        let cycle = cycle("CYCLE978");
        let variant = &cycle.variants[0];
        let inputs = inputs(&setup, cycle, variant, &[("_MA", "3"), ("_TSA", "2"), ("_TDIF", "2")]).unwrap();
        let outcome = measure(&mut setup, &inputs);
        assert_eq!(outcome.stop, None, "{plane:?} {tip}");
        let difference = setup.control.number("_OVR[19]");
        assert!((difference - 0.13).abs() < 1e-9, "{plane:?} {tip}: {difference}");
    }
}

// oracle: manual B:4148-4152, A:15848
#[test]
fn what_does_not_stand_on_the_plane_is_refused() {
    for plane in [Plane::G17, Plane::G18, Plane::G19] {
        for tip in 0..10 {
            for assignment in [0.0, 2.0] {
                let mut setup = turret(plane, tip);
                setup.control.set("SD42950", assignment);
                let taken = matches!((plane, tip), (Plane::G17, 5 | 7) | (Plane::G19, 6 | 8));
                let taken = taken && assignment == 2.0;
                let cycle = cycle("CYCLE978");
                let more = [("_MA", "1"), ("_TSA", "2"), ("_TDIF", "2")];
                let inputs = inputs(&setup, cycle, &cycle.variants[0], &more).unwrap();
                let stop = measure(&mut setup, &inputs).stop;
                let expected = (!taken).then_some(Stop::Alarm(Code::Alarm(61309)));
                assert_eq!(stop, expected, "{plane:?} {tip} {assignment}");
            }
        }
    }
}
