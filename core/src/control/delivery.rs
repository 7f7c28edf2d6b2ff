//! The control as delivered: data that measuring cycles read, with the initial values of `gud`, `machine_data` and
//! `nct_data`. Lengths and feeds are in the basic system of the machine, as the manual says. Initial values of
//! parameters (`_FA`, `_TSA`, …) are defaults of the catalogue: an unset datum means "as delivered".

use super::gud::{Element, Initial, System};
use super::{
    BasicFrames, Control, Data, Frame, Limits, Make, Plane, Transverse, Units, Value, gud, machine_data, nct_data,
};
use crate::dialect::Dialect;
use crate::geometry::{Degrees, Mcs};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Metres in a foot (feet/min on an inch machine, B:13498).
const FOOT: f64 = 0.3048;

/// Which system the machine was built for: 1 metric, 0 inch (B:13539, B:13883, MD10240 SCALING_SYSTEM_IS_METRIC).
const IS_METRIC: [&str; 3] = [UNITS_OF_CONTROL, UNITS_OF_CHANNEL, BASIC_SYSTEM];
/// The machine datum of the basic system: 1 metric, 0 inch.
pub const BASIC_SYSTEM: &str = "MD10240";
/// In which system the data of the control stand.
pub const UNITS_OF_CONTROL: &str = "_CBIT[3]";
/// In which system the data of the channel stand.
pub const UNITS_OF_CHANNEL: &str = "_CHBIT[24]";

/// A metric control as it comes from the manufacturer: no tools, no offsets, G17.
pub fn delivery(dialect: Dialect) -> Control {
    delivery_in(dialect, Units::Metric)
}

/// A control as it comes from the manufacturer with this basic system of units, which is also the active one.
pub fn delivery_in(dialect: Dialect, units: Units) -> Control {
    let make = Make::of(dialect);
    Control {
        dialect,
        basic_units: units,
        active_units: units,
        data_follow: make.one_system,
        plane: Plane::G17,
        transverse: Transverse::Radius,
        incremental: false,
        settable: make.first,
        frames: BTreeMap::new(),
        stored: BasicFrames::default(),
        basic: BasicFrames::default(),
        active: Frame::default(),
        program_frame: Frame::default(),
        plane_frame: Frame::default(),
        part_frame: Frame::default(),
        tools: BTreeMap::new(),
        environments: BTreeMap::new(),
        tool: 0,
        edge: 0,
        location: 0,
        data: Data::delivered(dialect, units),
        definitions: Arc::default(),
        spindle: Degrees(0.0),
        spindle_speed: 0.0,
        spindle_positions: true,
        deflection: None,
        rotary: [Degrees(0.0); 3],
        rotary_centre: Mcs::default(),
        limits: Limits::default(),
    }
}

/// What the table of NCT data says; a switch is there when it is 0, too.
pub(super) fn nct(units: Units) -> BTreeMap<String, Value> {
    let value = |element: &Element| delivered(element, units, !element.choices.is_empty());
    nct_data::all().filter_map(|datum| Some((datum.name.to_owned(), value(&datum.element)?))).collect()
}

/// What the tables of SINUMERIK data say, except parameters of a call.
pub(super) fn sinumerik(units: Units) -> BTreeMap<String, Value> {
    let mut data = BTreeMap::new();
    for gud in gud::all().filter(|gud| gud.of_machine()) {
        let fields = match data.get(gud.counted) {
            Some(Value::Number(fields)) => *fields as usize,
            _ => 0,
        };
        for element in gud.elements {
            // fields that are counted exist by their entries (`state::fit`)
            let value = delivered(element, units, !gud.counted.is_empty());
            let places = gud.places(element, fields).into_iter();
            data.extend(places.filter_map(|at| Some((gud.spelled(&at), value.clone()?))));
        }
    }
    for datum in machine_data::MACHINE_DATA {
        let numbers = datum.initial.iter().map(|number| Value::Number(*number));
        let names = datum.initial_names.iter().map(|name| Value::Text((*name).to_owned()));
        data.extend(datum.names().into_iter().zip(numbers.chain(names)));
    }
    let metric = Value::Number(f64::from(u8::from(units == Units::Metric)));
    data.extend(IS_METRIC.map(|name| (name.to_owned(), metric.clone())));
    data
}

/// An element as delivered; none: it is 0, and `always` does not say that it has an entry all the same.
fn delivered(element: &Element, units: Units, always: bool) -> Option<Value> {
    match element.initial {
        Initial::Text(text) => Some(Value::Text(text.to_owned())),
        Initial::Number(value) => {
            (value != 0.0 || always).then(|| Value::Number(value / factor(element.unit, units) + 0.0))
        }
    }
}

/// What calibration writes. As its definition is delivered it is 0; the values of the core's own machine are for the
/// simulation (B:13442-13450, B:13281).
pub const CALIBRATED: &str = "_WP";

/// What the fields of a control have that are more than delivered: what each is delivered with (B:13279), but for what
/// calibration writes.
pub fn more_fields(control: &Control, units: Units) -> BTreeMap<String, Value> {
    let counted =
        |gud: &&gud::Gud| gud.of_machine() && gud.name != CALIBRATED && control.data.given(gud.counted).is_some();
    let mut more = BTreeMap::new();
    for gud in gud::all().filter(counted) {
        let fields = control.number(gud.counted).max(0.0) as usize;
        for element in gud.elements {
            let Some(value) = delivered(element, units, false) else { continue };
            more.extend(gud.places(element, fields).iter().map(|at| (gud.spelled(at), value.clone())));
        }
    }
    let delivered = Data::delivered(control.dialect, units);
    more.retain(|name, _| !delivered.contains_key(name));
    more
}

impl Control {
    /// Gives the fields that are more than delivered what they begin with.
    pub fn fill_fields(&mut self) {
        for (name, value) in more_fields(self, self.basic_units) {
            if !self.data.contains_key(&name) {
                self.data.insert(name, value);
            }
        }
    }

    /// The switches of units as the basic system wants them: with others, the next call would convert the data.
    pub fn settle_units(&mut self) {
        let metric = f64::from(u8::from(self.basic_units == Units::Metric));
        for name in IS_METRIC {
            self.set(name, metric);
        }
    }

    /// A control as delivered with as many fields as this one, in this system of units.
    pub fn delivered_alike(&self, units: Units) -> Control {
        let mut delivered = delivery_in(self.dialect, units);
        for (name, value) in more_fields(self, units) {
            delivered.data.insert(name, value);
        }
        delivered
    }
}

/// Metric units in one unit of a datum as it is in the control.
pub fn factor(unit: gud::Unit, basic: Units) -> f64 {
    match unit {
        gud::Unit::Length(System::Basic) | gud::Unit::Feed(System::Basic) => basic.factor(),
        gud::Unit::Speed(System::Basic) if basic == Units::Inch => FOOT,
        _ => 1.0,
    }
}

/// A machine rebuilt for the other basic system (MD10240, B:13594): everything keeps its size. What is as delivered is
/// as that system is delivered; what has no unit, such as R parameters, stays a number.
pub fn rebuilt(control: &Control, units: Units) -> Control {
    let before = control.delivered_alike(control.basic_units);
    let mut data = control.delivered_alike(units).data;
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
        return factor(datum.element.unit, basic);
    }
    let element = gud::place(name).and_then(|(gud, at)| gud.element(&at));
    element.map_or(1.0, |element| factor(element.unit, basic))
}

/// A number times a ratio, without what the last digits of a product lack: there and back gives the same number.
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
