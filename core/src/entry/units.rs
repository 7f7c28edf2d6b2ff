//! The one place where typed values become mm, degree and mm/min, and where units get their names.

use crate::control::{Control, Units};
use crate::entry::Unit;

/// System in which a value of this rule counts; none: it has the same unit on every control. B:1787-1795; NCT has one
/// active system only.
fn system(unit: Unit, control: &Control) -> Option<Units> {
    match unit {
        Unit::ActiveLength => Some(control.active_units),
        Unit::BasicLength | Unit::BasicFeed if control.make().one_system => Some(control.active_units),
        Unit::BasicLength | Unit::BasicFeed => Some(control.basic_units),
        Unit::None | Unit::Millimetre | Unit::Degree => None,
    }
}

/// mm (mm/min, degree) per unit of a typed value.
pub fn factor(unit: Unit, control: &Control) -> f64 {
    system(unit, control).map_or(1.0, Units::factor)
}

/// What one unit of a delivered number is worth: as delivered, in mm (mm/min) on a metric machine, on an inch machine
/// converted once by the basic system, whatever is active (B:14061). NCT macros have no stored numbers: what they
/// take instead of a missing address is a length.
pub fn delivered_factor(unit: Unit, control: &Control) -> f64 {
    match system(unit, control) {
        None => 1.0,
        Some(active) if control.make().one_system => active.factor(),
        Some(_) => control.basic_factor(),
    }
}

/// Name of the unit in which a value of this rule is entered and shown on this control: `mm`, `inch`, `deg`, `mm/min`,
/// `inch/min` or nothing.
pub fn unit_name(unit: Unit, control: &Control) -> &'static str {
    let inch = system(unit, control) == Some(Units::Inch);
    match unit {
        Unit::None => "",
        Unit::Degree => "deg",
        Unit::BasicFeed if inch => "inch/min",
        Unit::BasicFeed => "mm/min",
        _ if inch => "inch",
        Unit::ActiveLength | Unit::BasicLength | Unit::Millimetre => "mm",
    }
}

/// Name of the unit in which a call leaves a result of this rule: `active` was the system at the call. What counts in
/// the basic system of the machine stays in it on every control, also on one that takes all in one active system
/// (NCT #500 to #510, C:92-94).
pub fn result_unit(unit: Unit, active: Units, basic: Units) -> &'static str {
    match unit {
        Unit::None => "",
        Unit::Degree => "deg",
        Unit::Millimetre => "mm",
        Unit::ActiveLength => active.name(),
        Unit::BasicLength => basic.name(),
        Unit::BasicFeed if basic == Units::Inch => "inch/min",
        Unit::BasicFeed => "mm/min",
    }
}

/// Name of the unit as it stands behind a number; empty where there is none.
pub fn unit_behind(unit: Unit, control: &Control) -> String {
    match unit_name(unit, control) {
        "" => String::new(),
        "deg" => "°".to_owned(),
        name => format!("\u{a0}{name}"), // not broken from its value
    }
}
