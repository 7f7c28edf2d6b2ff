//! Places of values in a text, as the page counts: UTF-16 units.

use crate::control::Control;
use crate::name::Name;
use crate::program::calls::{CallSite, calls_on};
use crate::program::places::places;
use crate::syntax::position::Positions;
use crate::syntax::{Program, read};
use std::collections::BTreeMap;

/// Where each value is written: the first unit, and one past its end.
pub type Places = BTreeMap<Name, [u32; 2]>;

/// The places of the values of a call.
pub fn of_call(program: &Program, site: &CallSite, positions: &Positions) -> Places {
    let units = |span: crate::diagnostic::Span| [span.start, span.end].map(|at| positions.utf16(at));
    places(program, site).into_iter().map(|(name, span)| (name, units(span))).collect()
}

/// The places of the values in the text of one call, as a control reads it.
pub fn in_snippet(text: &str, control: &Control) -> Places {
    let program = read(control.dialect, text.as_bytes());
    let sites = calls_on(&program, control.clone());
    let positions = Positions::new(&program.source);
    sites.last().map_or_else(Places::new, |site| of_call(&program, site, &positions))
}
