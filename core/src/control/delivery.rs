//! The control as delivered: GUD data that measuring cycles read, with their initial values.
//! Lengths and feeds stand in the basic system of the machine, as the manual says. Initial values of parameters (`_FA`, `_TSA`, …) are defaults of
//! the catalogue and not repeated here: an unset datum means "as delivered".

use super::{BasicFrames, Control, Frame, Limits, Plane, Units, Value};
use crate::catalogue::Dialect;
use std::collections::BTreeMap;

/// Probes, tool probes and calibration blocks (`_CVAL`, B:13345-13348).
const SETS: usize = 3;

/// Numbers without a unit that are not 0 as delivered, with their place.
const NUMBERS: &[(&str, f64)] = &[
    ("_CVAL[0]", 3.0),      // tool probes, B:13345
    ("_CVAL[1]", 3.0),      // workpiece probes, B:13346
    ("_CVAL[2]", 3.0),      // calibration blocks, B:13347
    ("_CVAL[3]", 3.0),      // tool probes of the workpiece, B:13348
    ("_EVMVNUM[0]", 20.0),  // empirical values, B:13717
    ("_EVMVNUM[1]", 20.0),  // mean values, B:13718
    ("_SPEED[0]", 50.0),    // % of rapid traverse, B:13726 (appendix A.1: 100, B:16387)
    ("_CBIT[8]", 1.0),      // mono probe corrected by _CORA, B:13549
    ("_CBIT[16]", 1.0),     // calibration monitoring, B:13565
    ("_CHBIT[1]", 1.0),     // tool probe on input 2, B:13836
    ("_CHBIT[2]", 1.0),     // collision monitoring, B:13838
    ("_CM[1]", 1000.0),     // rpm, B:13499
    ("_CM[5]", 4.0),        // M4, B:13503
    ("_CM[6]", 10.0),       // feed factor 1, B:13504
    ("_PROTFORM[0]", 60.0), // lines a page, B:11349
    ("_PROTFORM[1]", 80.0), // characters a line, B:11350
    ("_PROTFORM[2]", 1.0),  // first page, B:11351
    ("_PROTFORM[3]", 3.0),  // own header lines, B:11352
    ("_PROTFORM[4]", 1.0),  // value lines, B:11353
    ("_PROTFORM[5]", 12.0), // characters a column, B:11354
    ("_DIGIT", 3.0),        // decimals, B:13174
    ("_MC_SIMSIM", 1.0),    // run cycles in simulation, B:13245
    ("_MC_MTL[0]", 33.3),   // stylus length to ball radius, B:13240
    ("_MC_MTL[1]", 33.3),   // B:13240
    ("_MC_MTL[2]", 33.3),   // B:13240
    ("MD18600", 1.0),       // fine translation present; the cycles' preferred case, B:1990
    ("MD18080", 256.0), // bit 8: additive offsets present, A:15927; the manual prints no default
    ("MD18112", 16.0),  // bit 4: setup offsets present, A:15928; the manual prints no default
    ("MD20050[0]", 1.0), // channel axis of the first geometry axis, B:14084
    ("MD20050[1]", 2.0), // of the second
    ("MD20050[2]", 3.0), // of the third
    ("MD28082", 33.0),  // 21H: system frames for PRESET and for cycles present, B:12976
    ("MD18105", 9.0),   // largest D number; decides the digits of _KNUM, B:1899
    ("SD42950", 2.0),   // TOOL_LENGTH_TYPE, B:4147-4152
];

/// Lengths in mm and feeds in mm/min that are not 0 as delivered; on an inch machine converted (B:13596, B:14061).
const LENGTHS: &[(&str, f64)] = &[
    ("_SPEED[1]", 1000.0), // in the plane, monitored, B:13732
    ("_SPEED[2]", 1000.0), // in the applicate, monitored, B:13733
    ("_SPEED[3]", 900.0),  // first fast probing, B:13734
    ("_CM[2]", 1.0),       // B:13500
    ("_CM[3]", 0.005),     // B:13501
    ("_CM[4]", 20.0),      // B:13502
];

/// Largest peripheral speed, m/min (feet/min on an inch machine, B:13498).
const PERIPHERAL_SPEED: f64 = 100.0;
/// Metres in a foot.
const FOOT: f64 = 0.3048;

/// Which system the machine was built for: 1 metric, 0 inch (B:13539, B:13883, MD10240 SCALING_SYSTEM_IS_METRIC).
const IS_METRIC: [&str; 3] = ["_CBIT[3]", "_CHBIT[24]", "MD10240"];

/// Trigger values of a calibrated ideal probe with a ball of 6 mm, `_WP[k,0..6]`, mm (appendix A.1, B:16259-16265;
/// chapter 9.2.3 prints 0, with which nothing can be measured, B:13442).
const WORKPIECE_PROBE: [f64; 7] = [6.0, 3.0, -3.0, 3.0, -3.0, 3.0, -3.0];

/// NCT variables that are not 0 as delivered: mm, 1/min, mm/min (C:1196-1198).
const NCT_SPINDLE: (&str, f64) = ("#511", 1500.0);
/// See [`NCT_SPINDLE`].
const NCT_LENGTHS: &[(&str, f64)] = &[("#509", 40.0), ("#512", 750.0)];

/// A metric control as it comes from the manufacturer: no tools, no offsets, G17.
pub fn delivery(dialect: Dialect) -> Control {
    delivery_in(dialect, Units::Metric)
}

/// The same with this basic system of units, which is also the active one.
pub fn delivery_in(dialect: Dialect, units: Units) -> Control {
    let mut control = Control {
        dialect,
        basic_units: units,
        active_units: units,
        data_follow: dialect == Dialect::Nct,
        plane: Plane::G17,
        settable: if dialect == Dialect::Nct { 1 } else { 0 },
        frames: BTreeMap::new(),
        channel_basic: BTreeMap::new(),
        global_basic: BTreeMap::new(),
        system: Frame::default(),
        basic: BasicFrames::default(),
        active: Frame::default(),
        program_frame: Frame::default(),
        tools: BTreeMap::new(),
        environments: BTreeMap::new(),
        tool: 0,
        edge: 0,
        data: BTreeMap::new(),
        spindle: 0.0,
        spindle_positions: true,
        limits: Limits::default(),
    };
    match dialect {
        Dialect::Sinumerik => sinumerik(&mut control),
        Dialect::Nct => nct(&mut control),
    }
    control
}

fn nct(control: &mut Control) {
    let (name, value) = NCT_SPINDLE;
    control.set(name, value);
    lengths(control, NCT_LENGTHS);
}

/// Writes lengths (mm) and feeds (mm/min) in the basic system.
fn lengths(control: &mut Control, list: &[(&str, f64)]) {
    let per = control.basic_factor();
    for (name, value) in list {
        control.set(*name, value / per);
    }
}

fn sinumerik(control: &mut Control) {
    zeros(control);
    for (name, value) in NUMBERS {
        control.set(*name, *value);
    }
    lengths(control, LENGTHS);
    let metric = control.basic_units == Units::Metric;
    for name in IS_METRIC {
        control.set(name, f64::from(u8::from(metric)));
    }
    let speed = if metric { 1.0 } else { FOOT };
    control.set("_CM[0]", PERIPHERAL_SPEED / speed);
    let per = control.basic_factor();
    for k in 0..SETS {
        for (i, value) in WORKPIECE_PROBE.iter().enumerate() {
            control.set(format!("_WP[{k},{i}]"), *value / per);
        }
        for array in ["_TP", "_TPW"] {
            control.set(format!("{array}[{k},7]"), 133.0); // axes and directions, B:13365
            control.set(format!("{array}[{k},9]"), 2.0 / per); // upper to lower edge, B:13369
        }
    }
    // B:11355 prints a comma, B:13165 and B:16309 a semicolon.
    control
        .data
        .insert("_PROTSYM[0]".into(), Value::Text(";".into()));
    control
        .data
        .insert("_PROTSYM[1]".into(), Value::Text("#".into()));
    control
        .data
        .insert("_SI[1]".into(), Value::Text("6".into())); // B:13682
}

/// Arrays that exist, all elements 0 (sizes: column `size` of the tables, B:13097-13236).
fn zeros(control: &mut Control) {
    let lists: [(&str, usize); 8] = [
        ("_CBIT", 17),
        ("_CHBIT", 30),
        ("_EV", 20),
        ("_MV", 20),
        ("_OVR", 32),
        ("_OVI", 20),
        ("_CM", 8),
        ("_SPEED", 4),
    ];
    for (name, size) in lists {
        (0..size).for_each(|i| control.set(format!("{name}[{i}]"), 0.0));
    }
    for (name, size) in [("_WP", 11), ("_TP", 10), ("_TPW", 10), ("_KB", 7)] {
        for k in 0..SETS {
            (0..size).for_each(|i| control.set(format!("{name}[{k},{i}]"), 0.0));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_probe_is_delivered_calibrated() {
        let control = delivery(Dialect::Sinumerik);
        // oracle: manual B:16259-16265
        assert_eq!(control.number("_WP[2,0]"), 6.0);
        assert_eq!(control.number("_WP[0,1]"), 3.0);
        assert_eq!(control.number("_WP[1,6]"), -3.0);
        // oracle: manual B:13838, B:13850
        assert!(control.bit("_CHBIT[2]"));
        assert!(!control.bit("_CHBIT[4]"));
        // oracle: manual B:13732
        assert_eq!(control.number("_SPEED[1]"), 1000.0);
    }

    #[test]
    fn parameters_are_left_to_the_catalogue() {
        let control = delivery(Dialect::Sinumerik);
        assert!(!control.data.contains_key("_FA"));
        assert!(!control.data.contains_key("_TSA"));
    }

    #[test]
    fn an_inch_machine_has_the_same_things_in_inch() {
        let control = delivery_in(Dialect::Sinumerik, Units::Inch);
        // oracle: manual B:13596, B:14061 (converted, not other values)
        assert_eq!(control.basic_length("_WP[0,0]"), 6.0);
        assert!((control.number("_SPEED[1]") - 39.370_078_74).abs() < 1e-8);
        // oracle: hand (100 m/min in feet/min)
        assert!((control.number("_CM[0]") - 328.083_99).abs() < 1e-5);
        assert!(!control.bit("_CBIT[3]") && !control.bit("_CHBIT[24]") && !control.bit("MD10240"));
        assert_eq!(control.number("_SPEED[0]"), 50.0);
        let control = delivery_in(Dialect::Nct, Units::Inch);
        assert_eq!(
            (control.basic_length("#509"), control.number("#511")),
            (40.0, 1500.0)
        );
    }

    #[test]
    fn the_other_control_has_its_variables() {
        // oracle: manual C:1196-1198
        assert_eq!(delivery(Dialect::Nct).number("#509"), 40.0);
        assert_eq!(delivery(Dialect::Nct).number("_SPEED[1]"), 0.0);
    }
}
