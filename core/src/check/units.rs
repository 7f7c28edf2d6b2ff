//! The one place where typed values become mm, degree and mm/min.

use crate::catalogue::{Dialect, Unit};
use crate::control::{Control, Units};

/// mm (mm/min, degree) per unit of a typed value. Units by B:1787-1795; NCT has one active system only.
pub fn factor(unit: Unit, control: &Control) -> f64 {
    let system = match unit {
        Unit::ActiveLength => control.active_units,
        Unit::BasicLength | Unit::BasicFeed if control.dialect == Dialect::Nct => {
            control.active_units
        }
        Unit::BasicLength | Unit::BasicFeed => control.basic_units,
        Unit::None | Unit::Millimetre | Unit::Degree => Units::Metric,
    };
    match system {
        Units::Metric => 1.0,
        Units::Inch => 25.4,
    }
}
