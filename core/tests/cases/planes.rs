//! The programs of the manual for NCT in the other planes: program, machine, part and expectation are turned together,
//! so that X becomes Z, Y becomes X, and Z becomes Y: from G17 to G18, from there to G19, from there to G17.

use super::{holds, scenarios};
use nalgebra::Rotation3;
use probewright_core::app::{Expected, Scenario, ScenarioCase, ScenarioText};
use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::geometry::{Mcs, rigid};
use probewright_core::machine::Setup;
use probewright_core::setup_file::SetupFile;
use std::collections::BTreeMap;

/// The letter of an axis, or the function of a plane, after a turn.
fn letter(one: char) -> char {
    match one {
        'X' => 'Z',
        'Y' => 'X',
        'Z' => 'Y',
        other => other,
    }
}

/// What stood along X, Y, Z.
fn along([x, y, z]: [f64; 3]) -> [f64; 3] {
    [y, z, x]
}

/// A program without its comments.
fn text(source: &str) -> String {
    let mut depth = 0;
    let bare = source.chars().filter(|one| {
        depth += i32::from(*one == '(');
        let outside = depth == 0;
        depth -= i32::from(*one == ')');
        outside
    });
    let turned: String = bare.map(letter).collect();
    let planes = turned.replace("G19", "G.7").replace("G18", "G.9");
    planes.replace("G17", "G18").replace("G.", "G1")
}

fn machine(setup: &Setup) -> Setup {
    let mut turned = setup.clone();
    let control = &mut turned.control;
    control.plane = match control.plane {
        Plane::G17 => Plane::G18,
        Plane::G18 => Plane::G19,
        Plane::G19 => Plane::G17,
    };
    for frame in control.frames.values_mut() {
        frame.coarse = along(frame.coarse);
        frame.fine = along(frame.fine);
    }
    let settable = control.settable;
    control.activate(settable);
    turned.position = Mcs(along(turned.position.0));
    let turn = nalgebra::Matrix3::new(0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0);
    for solid in &mut turned.workpiece.solids {
        solid.at = Mcs(along(solid.at.0));
        solid.errors.shift = along(solid.errors.shift);
        let whole = turn * rigid::rotation(solid.rotation).matrix();
        solid.rotation = rigid::angles(&Rotation3::from_matrix_unchecked(whole));
    }
    turned
}

/// An expectation: names of work offsets carry the letter of their axis.
fn expected(expected: &Expected) -> Expected {
    let name = |name: &String| match name.split_once(' ') {
        Some((system, axis)) => format!("{system} {}", axis.chars().map(letter).collect::<String>()),
        None => name.clone(),
    };
    let turned = |all: &BTreeMap<String, f64>| all.iter().map(|(key, one)| (name(key), *one)).collect();
    Expected { variables: expected.variables.as_ref().map(turned), ..expected.clone() }
}

// oracle: the cases themselves, which say where their truth comes from; the planes differ by their axes only (C:472)
#[test]
fn programs_of_nct_hold_in_all_planes() {
    let mut count = 0;
    for (name, scenario) in scenarios() {
        if scenario.setup.control() != Dialect::Nct {
            continue;
        }
        for case in &scenario.cases {
            let mut source = scenario.program.text.clone().unwrap();
            for (old, new) in &case.replace {
                source = source.replace(old, new);
            }
            let mut now = scenario.machine(case).unwrap();
            let mut expect = case.expect.clone();
            for turns in 1..=3 {
                (source, now, expect) = (text(&source), machine(&now), expected(&expect));
                let case = ScenarioCase { id: case.id.clone(), expect: expect.clone(), ..ScenarioCase::default() };
                let program = ScenarioText { text: Some(source.clone()), ..scenario.program.clone() };
                let setup = SetupFile::from(&now);
                let turned = Scenario { program, setup, cases: vec![case], ..scenario.clone() };
                count += holds(&format!("{name} {turns}"), turned);
            }
        }
    }
    assert!(count >= 111, "{count}");
}
