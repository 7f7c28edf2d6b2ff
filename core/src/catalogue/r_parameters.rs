//! Measuring cycles of the 840C: subprograms with their parameters in R parameters. The manual prints the R parameter
//! beside each parameter of each cycle (A:16128-16737). Where it prints one for several, the variant tells which is
//! meant: of these the catalogue knows which the variant asks for.

use super::find;
use crate::check;
use crate::control::delivery;
use crate::dialect::Dialect;
use crate::entry::{Cycle, Inputs, Param, Typed, names};
use crate::name::Name;

/// Cycles for which a column with R parameters is printed, but CYCLE997, which is newer than the 840C (B:4112).
const PRINTED: [&str; 12] = [
    "CYCLE961", "CYCLE971", "CYCLE972", "CYCLE973", "CYCLE974", "CYCLE976", "CYCLE977", "CYCLE978", "CYCLE979",
    "CYCLE982", "CYCLE994", "CYCLE998",
];

/// Cycles that came with measuring cycles SW 6.3, long after the 840C (B:2404, B:4112).
const NEW: [&str; 2] = ["CYCLE997", "CYCLE119"];

/// Cycles that print something else than the others.
enum Cycles {
    All,
    Only(&'static [&'static str]),
    Except(&'static [&'static str]),
}

/// The starting angle stands in another R parameter here (A:16398, A:16478).
const ANGLE: &[&str] = &["CYCLE974", "CYCLE977", "CYCLE994"];
/// Two are printed for one setpoint here (A:16313, A:16396, A:16476, A:16555); the row of CYCLE976 is torn off.
const SETPOINT: &[&str] = &["CYCLE973", "CYCLE974", "CYCLE976", "CYCLE977", "CYCLE979", "CYCLE994"];

/// The variant.
pub const VARIANT: u16 = 23;
/// R parameters that both are the setpoint.
pub const SETPOINTS: [u16; 2] = [32, 42];

static TABLE: [(u16, Name, Cycles); 31] = [
    (9, names::TNUM, Cycles::All),
    (10, names::KNUM, Cycles::All),
    (11, names::EVNUM, Cycles::All),
    (12, names::CALNUM, Cycles::All),
    (13, names::CORA, Cycles::All),
    (18, names::SZO, Cycles::All),
    (19, names::ID, Cycles::All),
    (19, names::SZA, Cycles::All),
    (20, names::CPA, Cycles::All),
    (21, names::CPO, Cycles::All),
    (22, names::PRNUM, Cycles::All),
    (VARIANT, names::MVAR, Cycles::All),
    (24, names::STA1, Cycles::Except(ANGLE)),
    (25, names::VMS, Cycles::All),
    (26, names::INCA, Cycles::All),
    (26, names::STA1, Cycles::Only(ANGLE)),
    (27, names::NMSP, Cycles::All),
    (28, names::FA, Cycles::All),
    (29, names::K, Cycles::All),
    (30, names::MA, Cycles::All),
    (31, names::MD, Cycles::All),
    (31, names::RA, Cycles::All),
    (31, names::RF, Cycles::All),
    (32, names::SETVAL, Cycles::All),
    (33, names::TZL, Cycles::All),
    (34, names::TMV, Cycles::All),
    (36, names::TSA, Cycles::All),
    (37, names::TDIF, Cycles::All),
    (40, names::TUL, Cycles::All),
    (41, names::TLL, Cycles::All),
    (42, names::SETVAL, Cycles::Only(SETPOINT)),
];

/// R parameters that count only in variants that ask for their name, by cycle: one corner, one direction or one angle
/// more (A:16138, A:16294, A:16358, A:16431, A:16452, A:16480, A:16553-16558, A:16587, A:16691, A:16701). All others
/// count in every variant: the data keep what a variant does not read, as R parameters did.
static BY_VARIANT: [(u16, &[&str]); 5] = [
    (18, &["CYCLE977"]),
    (19, &["CYCLE961", "CYCLE977", "CYCLE979"]),
    (24, &["CYCLE976"]),
    (26, &["CYCLE974", "CYCLE979", "CYCLE998"]),
    (31, &["CYCLE973", "CYCLE976", "CYCLE979", "CYCLE982", "CYCLE998"]),
];

/// R parameters in which an 840C shows results; the manual maps none of them to a result of today.
pub fn is_result(number: u16) -> bool {
    matches!(number, 40..=50 | 200..=219)
}

/// The cycle of today that a subprogram was, by its number (`L977`): an assumption, since neither manual prints how the
/// 840C called them.
pub fn called(name: &str) -> Option<&'static Cycle> {
    numbered(name).filter(|cycle| is_printed(cycle))
}

/// The cycle with the number of a subprogram that cannot be that cycle, because no 840C had it.
pub fn newer(name: &str) -> Option<&'static Cycle> {
    numbered(name).filter(|cycle| NEW.contains(&cycle.name))
}

fn numbered(name: &str) -> Option<&'static Cycle> {
    let digits = name.strip_prefix('L').filter(|digits| digits.len() == 3)?;
    find(Dialect::Sinumerik, &format!("CYCLE{digits}"))
}

/// Whether the manual prints R parameters beside those of a cycle.
pub fn is_printed(cycle: &Cycle) -> bool {
    PRINTED.contains(&cycle.name)
}

/// The number of an R parameter in the table, by its name (`R23`).
pub fn number(name: &str) -> Option<u16> {
    let number = name.strip_prefix('R')?.parse().ok()?;
    TABLE.iter().any(|(known, ..)| *known == number).then_some(number)
}

/// Numbers of the table, each once.
pub fn numbers() -> impl Iterator<Item = u16> {
    let mut last = 0;
    TABLE.iter().map(|(number, ..)| *number).filter(move |number| std::mem::replace(&mut last, *number) != *number)
}

/// The names that the table of a cycle prints for an R parameter.
pub fn printed(cycle: &Cycle, number: u16) -> impl Iterator<Item = Name> {
    let of = |cycles: &Cycles| match cycles {
        Cycles::All => true,
        Cycles::Only(only) => only.contains(&cycle.name),
        Cycles::Except(others) => !others.contains(&cycle.name),
    };
    TABLE.iter().filter(move |(known, _, cycles)| *known == number && of(cycles)).map(|(_, name, _)| *name)
}

/// The measuring path, which earlier versions call the factor of the measuring path; its unit was 1 mm, so that the
/// number stays (B:2247-2251, B:16629).
pub const FACTOR: u16 = 28;

/// A cycle in a variant.
pub struct Called {
    cycle: &'static Cycle,
    /// None: the variant is not known.
    inputs: Option<Inputs>,
}

impl Called {
    /// A cycle with the number of its variant, where that is known.
    pub fn of(cycle: &'static Cycle, variant: Option<f64>) -> Called {
        let known = variant.filter(|number| cycle.variants.iter().any(|one| one.number as f64 == *number));
        let typed: Option<Typed> = known.map(|number| [(names::MVAR.to_string(), number.to_string())].into());
        let inputs = typed.map(|typed| check::read(cycle, &typed, &delivery(Dialect::Sinumerik), &mut Vec::new()));
        Called { cycle, inputs }
    }

    /// R parameters of the variant to which nothing gives a value, with their names and the values on delivery; those
    /// that a call has to give are none of them.
    pub fn left_out(&self, given: impl Fn(u16) -> bool) -> Vec<(u16, Name, f64)> {
        let Some(inputs) = &self.inputs else { return Vec::new() };
        let missing = |param: &Param| {
            let number = numbers().find(|number| self.meant(*number) == [param.name])?;
            let of_name = numbers().filter(|number| printed(self.cycle, *number).any(|name| name == param.name));
            let delivered = param.default.filter(|_| param.need(inputs).is_some())?;
            of_name.into_iter().all(|number| !given(number)).then_some((number, param.name, delivered))
        };
        self.cycle.params.iter().filter_map(missing).collect()
    }

    /// What an R parameter is here: none of its names, one, or several, of which the manual does not say which.
    pub fn meant(&self, number: u16) -> Vec<Name> {
        let by_variant = BY_VARIANT.iter().any(|(known, cycles)| *known == number && cycles.contains(&self.cycle.name));
        let counts = |name: &Name| if by_variant { self.reads(name) } else { self.cycle.param(name).is_some() };
        printed(self.cycle, number).filter(counts).collect()
    }

    /// The parameters that an R parameter can be and that the call reads: all of the cycle where the variant is not
    /// known.
    pub fn read(&self) -> impl Iterator<Item = Name> {
        let printed = |name: &Name| numbers().any(|number| self::printed(self.cycle, number).any(|one| one == *name));
        self.cycle.params.iter().map(|param| param.name).filter(move |name| printed(name) && self.reads(name))
    }

    fn reads(&self, name: &Name) -> bool {
        let known = |param: &Param| self.inputs.as_ref().is_none_or(|inputs| param.is_known(inputs));
        self.cycle.param(name).is_some_and(known)
    }
}
