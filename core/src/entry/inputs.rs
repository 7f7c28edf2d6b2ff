//! The values of a call: as typed, and as checked.

use super::{Cycle, Unit};
use crate::control::tools::REVERSED;
use crate::control::{Plane, Units};
use crate::geometry::Degrees;
use crate::name::Name;
use std::collections::{BTreeMap, BTreeSet};

/// What was typed, per parameter name, nothing decided. Decimal comma allowed.
pub type Typed = BTreeMap<String, String>;

/// What the call means: every used parameter has a value, lengths in mm, angles in degree, feeds in mm/min.
#[derive(Clone, Debug, PartialEq)]
pub struct Inputs {
    /// The cycle.
    pub cycle: &'static Cycle,
    /// Number of the measuring variant.
    pub variant: i64,
    /// Numbers by parameter name, defaults filled in.
    pub numbers: BTreeMap<Name, f64>,
    /// Parameters that the program or the form gives; the others have their defaults.
    pub written: BTreeSet<Name>,
    /// Texts by parameter name.
    pub texts: BTreeMap<Name, String>,
    /// Whether D numbers take five digits, so that all other digits of `_KNUM` move up by two (B:2009-2029).
    pub five_digit_edges: bool,
    /// Working plane of the control at the call.
    pub plane: Plane,
    /// Unit of lengths at the call, in which the cycle gives its results.
    pub units: Units,
    /// Whether positions of X are diameters at the call.
    pub diameters: bool,
    /// Data of the machine that the cycle's entry names, as the control has them.
    pub settings: BTreeMap<&'static str, f64>,
    /// Type of the tool in use (`$TC_DP1`); 0 without one.
    pub tool_type: i64,
    /// Where the body of a turning machine's probe lies from its ball, abscissa and ordinate; none of another tool, and
    /// where no tool is in use. See [`crate::control::Edge::body`].
    pub body: Option<[f64; 2]>,
    /// From the centre of the nose of the turning tool in use to its tip, abscissa and ordinate, in nose radii; none of
    /// another tool, of a button, and where no tool is in use. See [`crate::control::tools::side`].
    pub nose: Option<[f64; 2]>,
    /// Whether the call says that it measures in the minus direction: only lists of newer controls do.
    pub minus: bool,
}

impl Inputs {
    /// A call without values.
    pub fn new(cycle: &'static Cycle, variant: i64) -> Self {
        Self {
            cycle,
            variant,
            numbers: BTreeMap::new(),
            written: BTreeSet::new(),
            texts: BTreeMap::new(),
            five_digit_edges: false,
            plane: Plane::G17,
            units: Units::Metric,
            diameters: false,
            settings: BTreeMap::new(),
            tool_type: 0,
            body: None,
            nose: None,
            minus: false,
        }
    }

    /// Number of a parameter that the entry has and that is no angle; 0 as of [`Inputs::value`].
    #[track_caller]
    pub fn number(&self, name: Name) -> f64 {
        debug_assert!(!self.is_angle(name), "{} {name}", self.cycle.name);
        self.value(name)
    }

    /// Angle of a parameter whose unit is degree; 0 as of [`Inputs::value`].
    #[track_caller]
    pub fn degrees(&self, name: Name) -> Degrees {
        debug_assert!(self.is_angle(name), "{} {name}", self.cycle.name);
        Degrees(self.value(name))
    }

    /// Number of a parameter that the entry has, in whichever unit; 0 where it is left open, and where this variant
    /// does not use it.
    #[track_caller]
    pub fn value(&self, name: Name) -> f64 {
        self.given(name).unwrap_or(0.0)
    }

    /// Whether the entry has this parameter as an angle.
    pub fn is_angle(&self, name: Name) -> bool {
        self.cycle.param(&name).is_some_and(|param| param.unit == Unit::Degree)
    }

    /// Number of a parameter that the entry has; none where the call does not use it or leaves it open.
    #[track_caller]
    pub fn given(&self, name: Name) -> Option<f64> {
        self.has(name);
        self.numbers.get(&name).copied()
    }

    /// Number of a parameter that not each of the cycles has which share the code; none: open, or not used.
    pub fn any(&self, name: Name) -> Option<f64> {
        self.numbers.get(&name).copied()
    }

    /// Whether the call uses this parameter; one that the entry does not have, none does.
    pub fn uses(&self, name: Name) -> bool {
        self.cycle.param(&name).is_some_and(|param| param.need(self).is_some())
    }

    /// Number of a parameter where it is given and above 0, else another one: what a picture can draw.
    #[track_caller]
    pub fn positive(&self, name: Name, otherwise: f64) -> f64 {
        self.given(name).filter(|value| *value > 0.0).unwrap_or(otherwise)
    }

    /// Whether the cycle takes cutting edge positions the other way round in the ordinate: only the one whose entry
    /// names the switch does (B:13882).
    pub fn recodes(&self) -> bool {
        self.settings.get(REVERSED) == Some(&1.0)
    }

    /// Number of an integer parameter that the call uses; 0 as of [`Inputs::number`].
    #[track_caller]
    pub fn integer(&self, name: Name) -> i64 {
        self.number(name) as i64
    }

    /// Text of a parameter that the entry has; empty where not given.
    #[track_caller]
    pub fn text(&self, name: Name) -> &str {
        self.has(name);
        self.texts.get(&name).map_or("", String::as_str)
    }

    /// A slip that no test run overlooks: a cycle reads the parameters of its own entry.
    #[track_caller]
    fn has(&self, name: Name) {
        debug_assert!(self.cycle.param(&name).is_some(), "{} has no {name}", self.cycle.name);
    }
}
