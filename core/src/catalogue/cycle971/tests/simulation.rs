//! CYCLE971 finds how long and wide a tool is, whatever frames, units and pre-travel of the probe.

#![allow(clippy::unwrap_used)]

use super::bench::{PLANES, call, displace, measured, name, place, random, real, setup, setup_in, side};
use crate::catalogue::sinumerik::testing::{alarms, called, close, stopped, touches};
use crate::control::{Frame, Plane, Units};
use crate::geometry::{Dir, Rpy};
use crate::machine::Setup;
use crate::machine::sim::Sim;
use crate::workpiece::noise::Noise;
use crate::workpiece::tool::Cutter;

/// Length and radius of the tool in use.
fn tool(sim: &Sim) -> [f64; 4] {
    let edge = sim.control.active_edge().unwrap();
    [edge.length[0], edge.length_wear[0], edge.radius, edge.radius_wear]
}

/// Values and what was expected differ by less than 1e-9.
fn near(found: [f64; 4], expected: [f64; 4]) {
    let same = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9);
    assert!(same, "{found:?} {expected:?}");
}

#[test]
fn measuring_finds_a_tool_and_measuring_again_nothing() {
    // oracle: hand: the tool is as long and as wide as it is; first into the geometry, later into the wear
    // (B:4314-4322)
    let mut noise = Noise::new(5);
    for plane in PLANES {
        for variant in [1, 2, 11, 12] {
            for (number, length) in [(1.0, false), (2.0, false), (3.0, true), (103.0, true), (203.0, true)] {
                for remeasured in [false, true] {
                    let [longer, wider] = [(); 2].map(|()| random(&mut noise));
                    let inputs = call(variant, plane, &[("_MA", number), ("_ID", 0.0)]);
                    let mut setup = setup(&inputs);
                    setup.control.set("_CHBIT[3]", f64::from(u8::from(remeasured)));
                    let edge = setup.control.edge_of_mut(3, 1).unwrap();
                    (edge.length_wear[0], edge.radius_wear) = (0.1, -0.05);
                    real(&mut setup, 70.0 + longer, Cutter::smooth(5.0 + wider));
                    let sim = measured(&setup, &inputs);
                    let expected = match (length, remeasured) {
                        (true, false) => [70.0 + longer, 0.0, 5.0, -0.05],
                        (true, true) => [70.0, longer, 5.0, -0.05],
                        (false, false) => [70.0, 0.1, 5.0 + wider, 0.0],
                        (false, true) => [70.0, 0.1, 5.0, wider],
                    };
                    near(tool(&sim), expected);
                    close(
                        &sim,
                        if length { "_OVR[8]" } else { "_OVR[10]" },
                        if length { 70.0 + longer } else { 5.0 + wider },
                    );
                    let again = Setup { control: sim.control.clone(), ..setup.clone() };
                    let again = measured(&place(again, &inputs), &inputs);
                    close(&again, if length { "_OVR[9]" } else { "_OVR[11]" }, 0.0);
                    near(tool(&again), expected);
                }
            }
        }
    }
}

#[test]
fn calibrating_with_pre_travel_takes_it_out_of_every_measurement() {
    // oracle: hand: what the probe switches late is in its trigger points, so that a tool is found as it is
    for plane in PLANES {
        let calibrate = call(100_000, plane, &[]);
        let mut machine = setup(&calibrate);
        displace(&mut machine, [0.2, -0.1, 0.15], 0.08);
        machine.tool_probes[0].pre_travel = 0.02;
        let calibrated = measured(&machine, &calibrate);
        let probes = machine.tool_probes.clone();
        for (number, length) in [(1.0, false), (2.0, false), (3.0, true)] {
            let inputs = call(1, plane, &[("_MA", number), ("_ID", 0.0)]);
            let control = calibrated.control.clone();
            let mut machine = place(Setup { control, ..machine.clone() }, &inputs);
            machine.tool_probes = probes.clone();
            real(&mut machine, 70.4, Cutter::smooth(4.7));
            let sim = measured(&machine, &inputs);
            if length { near(tool(&sim), [70.4, 0.0, 5.0, 0.0]) } else { near(tool(&sim), [70.0, 0.0, 4.7, 0.0]) }
        }
    }
}

#[test]
fn the_frame_changes_nothing() {
    // oracle: hand: the same tool before the same probe in a frame that is moved and turned about the tool
    let frames = [
        Frame::default(),
        Frame::translation([60.0, 15.0, 30.0]),
        Frame { rotation: Rpy([0.0, 0.0, 18.0]), ..Frame::translation([60.0, 15.0, 30.0]) },
    ];
    for frame in frames {
        for variant in [1, 2, 11, 12] {
            for (number, length) in [(1.0, false), (2.0, false), (3.0, true)] {
                let inputs = call(variant, Plane::G17, &[("_MA", number), ("_ID", 0.0)]);
                let mut setup = setup(&inputs);
                setup.control.frames.insert(1, frame);
                setup.control.settable = 1;
                setup.control.activate(1);
                let mut setup = place(setup, &inputs);
                real(&mut setup, 70.3, Cutter::smooth(5.2));
                let sim = measured(&setup, &inputs);
                let expected = if length { [70.3, 0.0, 5.0, 0.0] } else { [70.0, 0.0, 5.2, 0.0] };
                near(tool(&sim), expected);
                assert_eq!(sim.control.active, setup.control.active);
            }
        }
        let inputs = call(100_010, Plane::G17, &[]);
        let mut setup = setup(&inputs);
        setup.control.frames.insert(1, frame);
        setup.control.settable = 1;
        setup.control.activate(1);
        let mut setup = place(setup, &inputs);
        let shift = [0.2, -0.3, 0.1];
        let moved = setup.control.direction_to_machine(Dir::new(shift)).0;
        displace(&mut setup, moved, 0.0);
        let sim = measured(&setup, &inputs);
        for (axis, plus) in [(0, false), (0, true), (1, false), (1, true), (2, false)] {
            let found = side(&setup, "_TPW", axis, plus, shift, 0.0);
            close(&sim, &name("_TPW", axis, plus), found);
        }
    }
}

#[test]
fn an_inch_machine_finds_the_same() {
    // oracle: hand: data and results count in inch there, 25.4 mm each
    let shift = [0.2, -0.3, 0.1];
    for plane in PLANES {
        let inputs = call(100_000, plane, &[]);
        let machines = [Units::Metric, Units::Inch].map(|units| {
            let mut setup = setup_in(&inputs, units);
            displace(&mut setup, shift, 0.0);
            measured(&setup, &inputs)
        });
        for (axis, plus) in [(0, false), (1, true), (2, false)] {
            for name in [name("_TP", axis, plus), format!("_OVR[{}]", 8 + 4 * axis)] {
                close(&machines[1], &name, machines[0].control.number(&name) / 25.4);
            }
        }
        for (variant, number, result) in [(1, 1.0, 10), (2, 1.0, 10), (2, 3.0, 8)] {
            let inputs = call(variant, plane, &[("_MA", number), ("_ID", 0.0)]);
            let tools = [Units::Metric, Units::Inch].map(|units| {
                let mut setup = setup_in(&inputs, units);
                real(&mut setup, 70.3, Cutter::smooth(5.2));
                measured(&setup, &inputs)
            });
            near(tool(&tools[0]), tool(&tools[1]));
            let name = format!("_OVR[{result}]");
            close(&tools[1], &name, tools[0].control.number(&name) / 25.4);
        }
    }
}

/// How a mill that is so much longer is measured with these data of the control.
fn judged(
    longer: f64,
    values: &[(&'static str, f64)],
    data: &[(&str, f64)],
) -> (Sim, Result<(), crate::machine::Stop>) {
    let mut all = vec![("_MA", 3.0), ("_ID", 0.0), ("_TZL", 0.04), ("_TDIF", 1.6), ("_TSA", 2.0)];
    all.extend(values);
    let inputs = call(1, Plane::G17, &all);
    let mut setup = setup(&inputs);
    for (name, value) in data {
        setup.control.set(*name, *value);
    }
    real(&mut setup, 70.0 + longer, Cutter::smooth(5.0));
    called(&setup, &inputs)
}

#[test]
fn limits_decide_what_is_corrected() {
    // oracle: manual B:4932-4937, B:5006-5011 (more than _TZL, less than _TDIF; _TSA and more is 61303), B:13534-13586
    for (longer, corrected, shown) in
        [(0.04, 0.0, vec![]), (0.041, 0.041, vec![]), (1.599, 1.599, vec![]), (1.6, 0.0, vec![62306])]
    {
        let (sim, outcome) = judged(longer, &[], &[]);
        assert_eq!(outcome, Ok(()));
        near(tool(&sim), [70.0 + corrected, 0.0, 5.0, 0.0]);
        assert_eq!(alarms(&sim), shown);
        close(&sim, "_OVR[9]", longer);
    }
    let (sim, outcome) = judged(2.0, &[], &[]);
    assert_eq!(stopped(outcome), 61303);
    near(tool(&sim), [70.0, 0.0, 5.0, 0.0]);
    close(&sim, "_OVI[9]", 61303.0);
    let (sim, outcome) = judged(2.0, &[], &[("_CBIT[0]", 1.0), ("_CBIT[1]", 1.0)]);
    assert_eq!(stopped(outcome), 61303);
    assert_eq!(alarms(&sim), [62303; 4]);
    assert_eq!(touches(&sim).len(), 5);
}

#[test]
fn an_empirical_value_is_taken_off_or_added() {
    // oracle: manual B:1302, B:13924-13925; there is no mean value (B:4322)
    for (bit, used) in [(0.0, 70.25), (1.0, 70.35)] {
        let data = [("_EV[2]", 0.05), ("_CHBIT[5]", bit), ("_CHBIT[4]", 1.0), ("_MV[2]", 0.7)];
        let (sim, outcome) = judged(0.3, &[("_EVNUM", 3.0)], &data);
        assert_eq!(outcome, Ok(()));
        near(tool(&sim), [used, 0.0, 5.0, 0.0]);
        close(&sim, "_OVR[30]", 0.05);
        close(&sim, "_OVI[7]", 3.0);
        close(&sim, "_MV[2]", 0.7);
    }
}
