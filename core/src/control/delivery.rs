//! The control as delivered: GUD data that measuring cycles read, with their initial values.
//! Which they are stands in `gud`, `machine_data` and `nct_data`. Lengths and feeds stand in the basic system of the
//! machine, as the manual says. Initial values of parameters (`_FA`, `_TSA`, …) are defaults of the catalogue and not
//! repeated here: an unset datum means "as delivered".

use super::gud::{Element, Initial, System};
use super::{BasicFrames, Control, Data, Frame, Limits, Plane, Transverse, Units, Value, gud, machine_data, nct_data};
use crate::dialect::Dialect;
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// Metres in a foot (feet/min on an inch machine, B:13498).
const FOOT: f64 = 0.3048;

/// Which system the machine was built for: 1 metric, 0 inch (B:13539, B:13883, MD10240 SCALING_SYSTEM_IS_METRIC).
const IS_METRIC: [&str; 3] = ["_CBIT[3]", "_CHBIT[24]", "MD10240"];

/// A metric control as it comes from the manufacturer: no tools, no offsets, G17.
pub fn delivery(dialect: Dialect) -> Control {
    delivery_in(dialect, Units::Metric)
}

/// The same with this basic system of units, which is also the active one.
pub fn delivery_in(dialect: Dialect, units: Units) -> Control {
    let mut control = bare(dialect, units);
    control.data = Data::delivered(dialect, units);
    control
}

/// The data of a control as delivered, made once.
pub(super) fn data(dialect: Dialect, units: Units) -> &'static BTreeMap<String, Value> {
    static MADE: [OnceLock<BTreeMap<String, Value>>; 4] = [const { OnceLock::new() }; 4];
    let index = usize::from(dialect == Dialect::Nct) * 2 + usize::from(units == Units::Inch);
    MADE[index].get_or_init(|| {
        let mut control = bare(dialect, units);
        match dialect {
            Dialect::Sinumerik => sinumerik(&mut control),
            Dialect::Nct => nct(&mut control),
        }
        control.data.all()
    })
}

/// A control without any data.
fn bare(dialect: Dialect, units: Units) -> Control {
    Control {
        dialect,
        basic_units: units,
        active_units: units,
        data_follow: dialect == Dialect::Nct,
        plane: Plane::G17,
        transverse: Transverse::Radius,
        settable: if dialect == Dialect::Nct { 1 } else { 0 },
        frames: BTreeMap::new(),
        channel_basic: BTreeMap::new(),
        global_basic: BTreeMap::new(),
        system: Frame::default(),
        basic: BasicFrames::default(),
        active: Frame::default(),
        program_frame: Frame::default(),
        part_frame: Frame::default(),
        tools: BTreeMap::new(),
        environments: BTreeMap::new(),
        tool: 0,
        edge: 0,
        location: 0,
        data: Data::default(),
        spindle: 0.0,
        spindle_speed: 0.0,
        spindle_positions: true,
        rotary: [0.0; 3],
        rotary_centre: [0.0; 3],
        limits: Limits::default(),
    }
}

fn nct(control: &mut Control) {
    for datum in nct_data::all() {
        if let Some(value) = datum.initial {
            control.set(datum.name, value / factor(datum.unit, control.basic_units));
        }
    }
}

/// What the tables of data say, except parameters of a call.
fn sinumerik(control: &mut Control) {
    for gud in gud::all().filter(|gud| gud.of_machine()) {
        let counted = !gud.counted.is_empty();
        let fields = control.number(gud.counted) as usize;
        for element in gud.elements {
            for at in gud.places(element, fields) {
                deliver(control, gud.spelled(&at), element, counted);
            }
        }
    }
    for datum in machine_data::MACHINE_DATA {
        for (name, value) in datum.names().into_iter().zip(datum.initial) {
            control.set(name, *value);
        }
        for (name, text) in datum.names().into_iter().zip(datum.initial_names) {
            control.data.insert(name, Value::Text((*text).to_owned()));
        }
    }
    let metric = control.basic_units == Units::Metric;
    for name in IS_METRIC {
        control.set(name, f64::from(u8::from(metric)));
    }
}

/// Puts an element there. What is 0 or empty needs no entry, except in fields that are counted: these exist by their
/// entries (`state::refusal`).
fn deliver(control: &mut Control, name: String, element: &Element, counted: bool) {
    match element.initial {
        Initial::Text(text) => {
            control.data.insert(name, Value::Text(text.to_owned()));
        }
        Initial::Number(value) if value != 0.0 || counted => {
            let value = value / factor(element.unit, control.basic_units);
            control.set(name, value);
        }
        Initial::Number(_) => {}
    }
}

/// Metric units in one unit of a datum as it stands in the control.
pub fn factor(unit: gud::Unit, basic: Units) -> f64 {
    match unit {
        gud::Unit::Length(System::Basic) | gud::Unit::Feed(System::Basic) => basic.factor(),
        gud::Unit::Speed(System::Basic) if basic == Units::Inch => FOOT,
        _ => 1.0,
    }
}

/// The same machine built for the other basic system (MD10240, B:13594): everything keeps its size. What is as
/// delivered is what that system is delivered with; what has no unit, such as R parameters, stays a number.
pub fn rebuilt(control: &Control, units: Units) -> Control {
    let before = delivery_in(control.dialect, control.basic_units);
    let mut data = delivery_in(control.dialect, units).data;
    for (name, value) in control.data.iter() {
        let follows = IS_METRIC.contains(&name.as_str()) || before.data.get(name) == Some(value);
        if !follows {
            let ratio = unit_of(name, control.basic_units) / unit_of(name, units);
            data.insert(name.clone(), scaled(value, ratio));
        }
    }
    Control { basic_units: units, data, ..control.clone() }
}

/// Metric units in one unit of the datum with this name.
fn unit_of(name: &str, basic: Units) -> f64 {
    if let Some(datum) = nct_data::find(name) {
        return factor(datum.unit, basic);
    }
    let element = gud::place(name).and_then(|(gud, at)| gud.element(&at));
    element.map_or(1.0, |element| factor(element.unit, basic))
}

/// A number times a ratio, without what the last digits of a product lack, so that there and back gives the same
/// number.
pub fn scaled(value: &Value, ratio: f64) -> Value {
    match value {
        Value::Number(number) if ratio != 1.0 => {
            let product = number * ratio;
            Value::Number(format!("{product:.14e}").parse().unwrap_or(product))
        }
        _ => value.clone(),
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
        assert_eq!((control.basic_length("#509"), control.number("#511")), (40.0, 1500.0));
    }

    // oracle: manual B:13596 (lengths and speeds are converted), hand (the rest has no unit)
    #[test]
    fn a_machine_that_is_rebuilt_keeps_its_sizes() {
        let mut metric = delivery(Dialect::Sinumerik);
        for (name, value) in [("_WP[0,0]", 5.995), ("_CM[0]", 90.0), ("R10", 4.0)] {
            metric.set(name, value);
        }
        let inch = rebuilt(&metric, Units::Inch);
        assert!((inch.number("_WP[0,0]") - 5.995 / 25.4).abs() < 1e-12);
        assert!((inch.number("_CM[0]") - 90.0 / 0.3048).abs() < 1e-9);
        assert_eq!((inch.number("R10"), inch.bit("MD10240")), (4.0, false));
        let delivered = delivery_in(Dialect::Sinumerik, Units::Inch);
        assert_eq!(inch.number("_WP[1,0]"), delivered.number("_WP[1,0]"));
        assert_eq!(rebuilt(&inch, Units::Metric).data, metric.data);
        let mut nct = delivery(Dialect::Nct);
        nct.set("#509", 38.1);
        assert_eq!(rebuilt(&nct, Units::Inch).number("#509"), 1.5);
    }

    #[test]
    fn the_other_control_has_its_variables() {
        // oracle: manual C:1196-1198
        assert_eq!(delivery(Dialect::Nct).number("#509"), 40.0);
        assert_eq!(delivery(Dialect::Nct).number("_SPEED[1]"), 0.0);
    }
}
