//! Inch and millimetre. Inside the core everything is metric; data of the control keep the unit the manual gives them.

use super::{Control, Units};

/// Millimetres in an inch.
pub const INCH: f64 = 25.4;

impl Units {
    /// Millimetres in one unit of length.
    pub const fn factor(self) -> f64 {
        match self {
            Units::Metric => 1.0,
            Units::Inch => INCH,
        }
    }

    /// Unit of length.
    pub const fn name(self) -> &'static str {
        match self {
            Units::Metric => "mm",
            Units::Inch => "inch",
        }
    }
}

/// G function that chooses the system of units; those below 70 are of NCT.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[allow(missing_docs)]
pub enum UnitFunction {
    G20 = 20,
    G21 = 21,
    G70 = 70,
    G71 = 71,
    G700 = 700,
    G710 = 710,
}

impl Control {
    /// Millimetres in one unit of the active system (G70/G71/G700/G710, G20/G21).
    pub fn active_factor(&self) -> f64 {
        self.active_units.factor()
    }

    /// Millimetres in one unit of the basic system (`_EV[]`, `_WP[]`, `_SPEED[]`, B:1787-1795).
    pub fn basic_factor(&self) -> f64 {
        self.basic_units.factor()
    }

    /// Millimetres in one unit of feeds and of the lengths that the control keeps: tool and frame data, positions.
    pub fn data_factor(&self) -> f64 {
        if self.data_follow { self.active_factor() } else { self.basic_factor() }
    }

    /// A datum whose unit is that of the basic system, in mm or mm/min.
    pub fn basic_length(&self, name: &str) -> f64 {
        self.number(name) * self.basic_factor()
    }

    /// Makes the choice of the G function with this number; false: it is none of units.
    pub fn choose_units(&mut self, number: u16) -> bool {
        let choices = [true, false].into_iter().flat_map(|follow| [(Units::Metric, follow), (Units::Inch, follow)]);
        let chosen = choices.into_iter().find(|(units, follow)| self.function(*units, *follow) as u16 == number);
        (self.active_units, self.data_follow) = chosen.unwrap_or((self.active_units, self.data_follow));
        chosen.is_some()
    }

    /// The G function whose choice is active.
    pub fn unit_function(&self) -> UnitFunction {
        self.function(self.active_units, self.data_follow)
    }

    fn function(&self, units: Units, data_follow: bool) -> UnitFunction {
        self.make().units[usize::from(data_follow)][units as usize]
    }
}

#[cfg(test)]
mod tests {
    use crate::control::delivery;
    use crate::dialect::Dialect;

    // oracle: self (a choice made is the active one)
    #[test]
    fn every_function_chooses_itself() {
        for (dialect, numbers) in [(Dialect::Sinumerik, &[70, 71, 700, 710][..]), (Dialect::Nct, &[20, 21][..])] {
            let mut control = delivery(dialect);
            for number in numbers {
                assert!(control.choose_units(*number));
                assert_eq!(control.unit_function() as u16, *number);
            }
            assert!(!control.choose_units(17));
        }
    }

    // oracle: hand
    #[test]
    fn feeds_and_data_follow_g700_only() {
        let mut control = delivery(Dialect::Sinumerik);
        assert!(control.choose_units(70));
        assert_eq!((control.active_factor(), control.data_factor()), (25.4, 1.0));
        assert!(control.choose_units(700));
        assert_eq!((control.active_factor(), control.data_factor()), (25.4, 25.4));
    }
}
