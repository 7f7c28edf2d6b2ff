//! A turning machine: a corrected turning tool makes the next part right, whichever memory the correction went into; a
//! corrected zero offset leaves nothing to correct.
//!
//! A part becomes as the tool really is and as the control believes it to be: a length that is believed too large by
//! `w` keeps the tip `w` further out, outside and in a bore, at a face and at a diameter (B:8945-8947).

use super::bench::{Values, inputs_with, near, place, result, run, with};
use super::zero_offset::{Call, TARGETS, closed};
use probewright_core::control::{Edge, Environment, Frame, Plane, Tool, Transverse, Units};
use probewright_core::entry::Inputs;
use probewright_core::machine::Setup;
use probewright_core::workpiece::PartErrors;

/// L1 and L2 of the tool as it is, mm.
const TRUE: [f64; 2] = [60.0, 40.0];
/// The tool, and its DL number.
const TOOL: i64 = 7;
const LOCATION: i64 = 2;

/// A measurement that corrects a length.
#[derive(Clone, Debug)]
struct Job {
    cycle: &'static str,
    values: Values,
    /// L1 (0) or L2 (1).
    length: usize,
}

/// A face by L2; outside and bore by L1, at one point, at two places of the part, at two points.
fn jobs() -> Vec<Job> {
    let job = |cycle, length: usize, of: &[(&'static str, f64)]| {
        let values = [
            ("_MA", if length == 0 { 2.0 } else { 1.0 }),
            ("_SETVAL", 60.0),
            ("_TNUM", TOOL as f64),
            ("_FA", 5.0),
            ("_TSA", 3.0),
            ("_TDIF", 2.5),
            ("_TUL", 2.0),
            ("_TLL", -2.0),
            ("_TMV", 0.001),
            ("_TZL", 0.0),
        ];
        let values = with(&values, of);
        Job { cycle, values, length }
    };
    vec![
        job("CYCLE974", 1, &[("_MVAR", 0.0)]),
        job("CYCLE974", 0, &[("_MVAR", 0.0)]),
        job("CYCLE974", 0, &[("_MVAR", 1000.0), ("_STA1", 30.0)]),
        job("CYCLE994", 0, &[("_MVAR", 2.0), ("_SZA", 40.0), ("_SZO", 90.0)]),
        job("CYCLE994", 0, &[("_MVAR", 1.0), ("_SZA", 40.0), ("_SZO", 30.0)]),
    ]
}

/// Where a correction goes, and how the call says so.
#[derive(Clone, Copy, Debug)]
struct Memory {
    code: f64,
    /// Values and texts of the call that name it.
    values: &'static [(&'static str, f64)],
    texts: &'static [(&'static str, &'static str)],
    /// Bit of the machine that chooses it.
    bit: &'static str,
    /// Names of the data that change, for L1 and for L2.
    data: [&'static str; 2],
}

const WEAR: [&str; 2] = ["$TC_DP12[7,1]", "$TC_DP13[7,1]"];
const GEOMETRY: [&str; 2] = ["$TC_DP3[7,1]", "$TC_DP4[7,1]"];
const ADDITIVE: [&str; 2] = ["$TC_SCP23[7,1]", "$TC_SCP24[7,1]"];
const SETUP: [&str; 2] = ["$TC_ECP23[7,1]", "$TC_ECP24[7,1]"];
const AT_LOCATION: &[(&str, f64)] = &[("_DLNUM", 2.0)];
/// Tool and location are those of the environment (B:2062-2102).
const FROM_ENVIRONMENT: &[(&str, f64)] = &[("_TNUM", 0.0), ("_DLNUM", 0.0)];
const IN_ENVIRONMENT: &[(&str, &str)] = &[("_TENV", "TURNED")];

const fn memory(
    code: f64,
    values: &'static [(&'static str, f64)],
    texts: &'static [(&'static str, &'static str)],
    bit: &'static str,
    data: [&'static str; 2],
) -> Memory {
    Memory { code, values, texts, bit, data }
}

/// Wear and geometry, additive and setup offsets, the tool by number, by name and by environment (B:1906-1929,
/// B:2047-2102).
const MEMORIES: [Memory; 9] = [
    memory(1.0, &[], &[], "", WEAR),
    memory(1001.0, &[], &[], "", WEAR),
    memory(1.0, &[], &[], "_CHBIT[6]", GEOMETRY),
    memory(1.0, &[("_TNUM", 0.0)], &[("_TNAME", "TURNING")], "", WEAR),
    memory(1_000_001.0, AT_LOCATION, &[], "", ADDITIVE),
    memory(1_000_001.0, AT_LOCATION, &[], "_CHBIT[6]", SETUP),
    memory(1_000_001.0, AT_LOCATION, &[], "_CHBIT[8]", SETUP),
    memory(2_000_000.0, &[("_TNUM", 0.0)], IN_ENVIRONMENT, "", WEAR),
    memory(3_000_000.0, FROM_ENVIRONMENT, IN_ENVIRONMENT, "", ADDITIVE),
];

/// A turning machine whose tool has something in every memory, and is believed too long and too short by some tenths.
fn machine(units: Units, transverse: Transverse) -> Setup {
    let mut setup = Setup::turning_in(Plane::G18, units);
    let control = &mut setup.control;
    control.transverse = transverse;
    let edge = Edge {
        kind: 500,
        tip: 3,
        length: [60.2, 39.9, 0.0],
        length_wear: [0.03, -0.02, 0.0],
        radius: 0.8,
        additive: [(LOCATION, [0.04, 0.01, 0.0, 0.0])].into(),
        setup: [(LOCATION, [-0.02, 0.05, 0.0, 0.0])].into(),
        ..Edge::default()
    };
    let tool = Tool { name: "TURNING".into(), edges: [(1, edge)].into() };
    control.tools.insert(TOOL, tool);
    let stored = Environment { tool: TOOL, edge: 1, location: LOCATION, plane: Plane::G18 };
    control.environments.insert("TURNED".into(), stored);
    control.frames.insert(1, Frame::translation([0.0, 0.0, 250.0]));
    control.activate(1);
    setup
}

/// By how much the control believes L1 or L2 to be too large, the DL offset in use.
fn wrong(setup: &Setup, length: usize) -> f64 {
    let edge = setup.control.edge_of(TOOL, 1).unwrap();
    edge.total_length(length) + edge.location(LOCATION)[length] - TRUE[length]
}

/// A part made with the tool; gives the difference of its dimension.
fn made(setup: &mut Setup, inputs: &Inputs, job: &Job) -> f64 {
    let wrong = wrong(setup, job.length);
    let mut errors = PartErrors::default();
    let difference = if job.length == 0 {
        errors.size = 2.0 * wrong;
        wrong * setup.control.transverse.shown()
    } else {
        errors.shift[2] = wrong;
        wrong
    };
    place(setup, inputs, errors);
    difference
}

// oracle: hand (head of this file); which memory: manual B:1906-1929, B:2047-2102
#[test]
fn a_corrected_tool_makes_the_next_part_right() {
    for (index, memory) in MEMORIES.into_iter().enumerate() {
        for job in jobs() {
            let units = [Units::Metric, Units::Inch][index % 2];
            let transverse = [Transverse::Diameter, Transverse::Radius][index / 2 % 2];
            let mut setup = machine(units, transverse);
            if !memory.bit.is_empty() {
                setup.control.set(memory.bit, 1.0);
            }
            let mut values = with(&job.values, memory.values);
            values.push(("_KNUM", memory.code));
            if transverse == Transverse::Radius && job.length == 0 {
                let dimensions = ["_SETVAL", "_SZO"];
                let of_x = values.iter_mut().filter(|(name, _)| dimensions.contains(name));
                of_x.for_each(|(_, value)| *value /= 2.0);
            }
            let inputs = inputs_with(&setup, job.cycle, &values, memory.texts);
            let what = format!("{job:?} {memory:?}");
            let difference = made(&mut setup, &inputs, &job);
            let first = run(&mut setup, &inputs);
            near(result(&setup, 16), difference, 1e-9, &what);
            let grown = |name: &str| first.changes().iter().any(|change| change.name == name);
            assert!(grown(memory.data[job.length]), "{what}");
            assert!(!grown(memory.data[1 - job.length]), "{what}");
            near(wrong(&setup, job.length), 0.0, 1e-9, &what);
            made(&mut setup, &inputs, &job);
            run(&mut setup, &inputs);
            near(result(&setup, 16), 0.0, 1e-9, &what);
        }
    }
}

/// A turning machine with every sort of frame in its chain; none turns, as a turned probe would measure wrong (61330).
fn with_frames(units: Units, settable: usize) -> Setup {
    let mut setup = Setup::turning_in(Plane::G18, units);
    let control = &mut setup.control;
    let frame = |origin, mirror| Frame { fine: [0.01, 0.02, -0.01], mirror, ..Frame::translation(origin) };
    control.stored.system = frame([0.0, -2.0, 3.0], [false; 3]);
    let global = frame([0.0, 6.0, -7.0], [false; 3]);
    control.stored.global.insert(0, global);
    let first = frame([0.0, 0.0, 2.0], [false, false, true]);
    control.stored.channel.insert(0, first);
    let second = frame([0.0, 8.0, 1.0], [false; 3]);
    control.stored.channel.insert(1, second);
    control.frames.insert(1, frame([0.0, 3.0, 220.0], [false; 3]));
    control.frames.insert(5, frame([0.0, 1.0, 90.0], [false, true, true]));
    control.activate(settable);
    setup
}

// oracle: manual B:10525, B:1930-1969: afterwards the surface has the set coordinate, X as a diameter
#[test]
fn a_corrected_zero_offset_leaves_nothing_to_correct() {
    for (index, target) in TARGETS.into_iter().enumerate() {
        for axis in [1.0, 2.0, 3.0] {
            let values = vec![("_MVAR", 100.0), ("_MA", axis), ("_SETVAL", 60.0), ("_FA", 5.0), ("_TSA", 3.0)];
            let call: Call = ("CYCLE974", values, &[16]);
            let units = [Units::Metric, Units::Inch][index % 2];
            closed(with_frames(units, target.settable), target, &call);
        }
    }
}
