//! Targets of a correction, and what is written into the tool.

#![allow(clippy::unwrap_used)]
use super::*;
use crate::control::{Plane, delivery};
use crate::dialect::Dialect;

fn control() -> Control {
    let mut control = delivery(Dialect::Sinumerik);
    for name in ["$TC_DP6[20,1]", "$TC_DP3[5,2]", "$TC_DP3[7,2]"] {
        control.set_variable(name, 10.0);
    }
    control
}

const NAMES: Names = Names { code: 2001, tool: 20, tool_name: "", location: 0, environment: "", axis: Some(0) };

fn find(control: &Control, names: Names) -> Result<Target, u32> {
    target(control, &names).map(Option::unwrap)
}

#[test]
fn offsets_by_dl_number_need_their_memory() {
    let names = Names { code: 1_002_001, location: 2, ..NAMES };
    // oracle: manual A:15927-15928, B:2047-2060
    let case = |bits: &[&str], missing: &str| {
        let mut control = control();
        bits.iter().for_each(|bit| control.set(*bit, 1.0));
        control.set(missing, 0.0);
        find(&control, names).err()
    };
    assert_eq!(case(&[], "MD18080"), Some(61408));
    assert_eq!(case(&["_CHBIT[6]"], "MD18080"), Some(61408));
    assert_eq!(case(&["_CHBIT[8]"], "MD18080"), None);
    assert_eq!(case(&[], "MD18112"), None);
    assert_eq!(case(&["_CHBIT[6]"], "MD18112"), Some(61409));
    assert_eq!(case(&["_CHBIT[8]"], "MD18112"), Some(61409));
}

#[test]
fn a_radius_and_the_lengths_by_measuring_axis() {
    // oracle: manual B:1928, B:762-817
    let control = control();
    assert_eq!(find(&control, NAMES).unwrap().part, RADIUS);
    for (axis, part) in [(0, 2), (1, 1), (2, 0)] {
        let names = Names { code: 1, axis: Some(axis), ..NAMES };
        assert_eq!(find(&control, names).unwrap().part, part);
    }
    assert_eq!(target(&control, &Names { code: 0, ..NAMES }), Ok(None));
    assert_eq!(find(&control, Names { code: 1, axis: None, ..NAMES }), Err(61322));
}

#[test]
fn the_length_of_a_turning_tool_in_the_measuring_axis() {
    // oracle: manual B:974-985, B:10748 (L1 of a turning tool in the ordinate X of G18, L2 in the abscissa Z)
    let mut control = control();
    control.set_variable("$TC_DP1[7,2]", 500.0);
    for (axis, part) in [(0, 1), (1, 0), (2, 2)] {
        let names = Names { code: 2, tool: 7, axis: Some(axis), ..NAMES };
        assert_eq!(find(&control, names).unwrap().part, part);
    }
}

#[test]
fn names_and_their_alarms() {
    // oracle: manual A:15861, A:15886, A:15888, A:15924-15931
    let mut control = control();
    control.tools.get_mut(&7).unwrap().name = "MILL".into();
    let named = Names { code: 2002, tool: 0, tool_name: "MILL", ..NAMES };
    assert_eq!(find(&control, named).unwrap().tool, 7);
    assert_eq!(find(&control, Names { tool_name: "", ..named }), Err(61320));
    assert_eq!(find(&control, Names { tool_name: "DRILL", ..named }), Err(61343));
    assert_eq!(find(&control, Names { tool: 99, ..named }), Err(61320));
    assert_eq!(find(&control, Names { code: 2009, ..NAMES }), Err(61410));
    assert_eq!(find(&control, Names { code: 1_001_001, ..NAMES }), Err(61406));
    assert_eq!(find(&control, Names { code: 2_001_001, ..NAMES }), Err(61405));
    control.set("MD18105", 9.0);
    assert_eq!(find(&control, Names { code: 2010, ..NAMES }), Err(61345));
}

#[test]
fn an_environment_gives_tool_and_edge() {
    // oracle: manual B:2138-2146
    let mut control = control();
    (control.tool, control.edge, control.plane) = (5, 2, Plane::G17);
    control.store_environment("WZUMG1");
    (control.tool, control.edge) = (20, 1);
    let names = Names { code: 2_100_000, tool: 0, environment: "WZUMG1", ..NAMES };
    let found = find(&control, names).unwrap();
    assert_eq!((found.tool, found.edge, found.part), (5, 2, 0));
    let names = Names { code: 2_001_002, axis: Some(1), ..names };
    assert_eq!(find(&control, names).unwrap().part, 1);
    control.plane = Plane::G18; // the ordinate of G18 is X, the abscissa of the stored G17
    assert_eq!(find(&control, names).unwrap().part, 2);
}

#[test]
fn wear_or_geometry() {
    // oracle: manual B:2047-2060
    let mut control = control();
    let target = find(&control, NAMES).unwrap();
    control.set_variable("$TC_DP15[20,1]", 0.1);
    let only = |name: &str, value: f64| Write { name: name.into(), value };
    assert_eq!(writes(&control, &target, 0.025, control.bit(GEOMETRY)), [only("$TC_DP15[20,1]", 0.125)]);
    control.set("_CHBIT[6]", 1.0);
    assert_eq!(
        writes(&control, &target, 0.025, control.bit(GEOMETRY)),
        [only("$TC_DP6[20,1]", 10.125), only("$TC_DP15[20,1]", 0.0)]
    );
}

#[test]
fn setup_or_additive_offset() {
    // oracle: manual B:2047-2060
    let mut control = control();
    let names = Names { code: 1_100_002, tool: 5, location: 3, ..NAMES };
    let target = find(&control, names).unwrap();
    control.set_variable("$TC_SCP33[5,2]", 0.25);
    control.set_variable("$TC_ECP33[5,2]", 1.0);
    let only = |name: &str, value: f64| Write { name: name.into(), value };
    assert_eq!(writes(&control, &target, 0.5, control.bit(GEOMETRY)), [only("$TC_SCP33[5,2]", 0.75)]);
    control.set("_CHBIT[6]", 1.0);
    assert_eq!(
        writes(&control, &target, 0.5, control.bit(GEOMETRY)),
        [only("$TC_ECP33[5,2]", 1.75), only("$TC_SCP33[5,2]", 0.0)]
    );
    control.set("_CHBIT[8]", 1.0);
    assert_eq!(writes(&control, &target, 0.5, control.bit(GEOMETRY)), [only("$TC_ECP33[5,2]", 1.5)]);
}
