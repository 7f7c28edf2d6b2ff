//! What differs between the makes of controls, chosen once by the language of their programs.

use super::units::UnitFunction::{self, G20, G21, G70, G71, G700, G710};
use super::{Calibration, Control, Units, Value, calibration, data, delivery};
use crate::diagnostic::Code;
use crate::dialect::Dialect;
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// The stylus hit something where it must not (C:125-132).
pub const PATH_OBSTRUCTED: Code = Code::Nct("PATH OBSTRUCTED");

/// A signal without contact: gone when the stylus stands (C:125-132).
pub const FALSE_TRIGGER: Code = Code::Nct("FALSE TRIGGER");

/// A make of controls.
pub struct Make {
    /// Whether it knows one system of units only, the active one, in which all lengths, feeds and data count.
    pub one_system: bool,
    /// G functions of metric and inch: where feeds and data do not follow, where they do ([`Control::data_follow`]).
    pub(super) units: [[UnitFunction; 2]; 2],
    /// Whether edges are registers of lengths (H) and radii (D), there as soon as they are asked for, whatever tool is
    /// in the spindle. They are kept as edges of tool 0, the length to the end of a ball.
    pub registers: bool,
    /// Names of the settable frames: the number of the G function of the first in a row, and their numbers.
    pub(super) settable: &'static [(usize, RangeInclusive<usize>)],
    /// The settable frame in effect as delivered.
    pub(super) first: usize,
    /// Whether the frame 0 is common to all settable ones, and counts before each.
    pub(super) common: bool,
    /// The data in which the ball of the workpiece probe is calibrated, each in radii of the ball.
    pub calibrated: &'static [(&'static str, f64)],
    /// Data of a workpiece probe by the number of its data field, from 1.
    pub(super) calibration: fn(&Control, i64) -> Calibration,
    /// The alarm of a probe signal where none may come: without and with a contact.
    pub unexpected: [Code; 2],
    /// The data with which it is delivered, in this basic system.
    pub(super) delivered: fn(Units) -> BTreeMap<String, Value>,
    /// Whether it has a datum of this name that holds a text, or a number.
    pub(super) knows: fn(&str, bool) -> bool,
}

static SINUMERIK: Make = Make {
    one_system: false,
    units: [[G71, G70], [G710, G700]],
    registers: false,
    settable: &[(54, 1..=4), (500, 0..=99), (0, 0..=0)],
    first: 0,
    common: false,
    // B:13442-13448
    calibrated: &[
        ("_WP[0,0]", 2.0),
        ("_WP[0,1]", 1.0),
        ("_WP[0,2]", -1.0),
        ("_WP[0,3]", 1.0),
        ("_WP[0,4]", -1.0),
        ("_WP[0,5]", 1.0),
        ("_WP[0,6]", -1.0),
    ],
    calibration: calibration::sinumerik,
    unexpected: [Code::Alarm(61302); 2], // B:13743-13763
    delivered: delivery::sinumerik,
    knows: data::sinumerik,
};

/// NCT milling controls.
pub static NCT: Make = Make {
    one_system: true,
    units: [[G21, G20]; 2],
    registers: true,
    settable: &[(54, 1..=6), (0, 0..=0)],
    first: 1,
    common: true,
    calibrated: &[("#500", 1.0), ("#501", 1.0), ("#502", 1.0), ("#503", 1.0)], // by axis and direction, C:304-307
    calibration: calibration::nct,
    unexpected: [FALSE_TRIGGER, PATH_OBSTRUCTED],
    delivered: delivery::nct,
    knows: data::nct,
};

impl Make {
    /// The make whose programs are written in this language.
    pub fn of(dialect: Dialect) -> &'static Make {
        match dialect {
            Dialect::Nct => &NCT,
            Dialect::Sinumerik => &SINUMERIK,
        }
    }

    /// Number of a settable frame by its name: G54..G57 1..4, G505..G599 5..99; NCT G54..G59 1..6 and `COMMON` 0.
    pub fn settable_named(&self, name: &str) -> Option<usize> {
        let written = || name.strip_prefix('G')?.parse().ok().filter(|code| *code > 0);
        let code: usize = if name == "COMMON" { 0 } else { written()? };
        let number = |first: usize, numbers: &RangeInclusive<usize>| Some(code.checked_sub(first)? + numbers.start());
        let mut rows = self.settable.iter();
        rows.find_map(|(first, numbers)| number(*first, numbers).filter(|number| numbers.contains(number)))
    }

    /// Name of a settable frame, see [`Make::settable_named`].
    pub fn settable_name(&self, number: usize) -> String {
        let row = self.settable.iter().find(|(_, numbers)| numbers.contains(&number));
        match row.map_or(number, |(first, numbers)| first + number - numbers.start()) {
            0 => "COMMON".to_owned(),
            code => format!("G{code}"),
        }
    }
}

impl Control {
    /// What is peculiar to its make.
    pub fn make(&self) -> &'static Make {
        Make::of(self.dialect)
    }

    /// Makes a ball of this radius, mm, known to the control: in an edge of a tool and in the trigger values.
    pub fn calibrate(&mut self, (tool, edge): (i64, i64), ball: f64) {
        let make = self.make();
        for (name, radii) in make.calibrated {
            self.set(*name, radii * ball / self.basic_factor());
        }
        if let Some(edge) = self.edge_of_mut(tool, edge) {
            if make.registers {
                edge.length[0] += ball - edge.radius; // G104 makes it so: no axial radius is kept
            }
            edge.radius = ball;
        }
    }
}
