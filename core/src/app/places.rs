//! Places of values in a text, as the page counts: UTF-16 units.

use crate::diagnostic::Span;
use crate::name::Name;
use crate::program::calls::CallSite;
use crate::program::places::places;
use crate::program::write::Written;
use crate::syntax::Program;
use crate::syntax::position::Positions;
use std::collections::BTreeMap;

/// Where each value is written: the first unit, and one past its end.
pub type Places = BTreeMap<Name, [u32; 2]>;

/// The places of the values of a call.
pub fn of_call(program: &Program, site: &CallSite, positions: &Positions) -> Places {
    units(places(program, site), positions)
}

/// The places of the values in the text of one call.
pub fn in_snippet(written: &Written) -> Places {
    units(written.places.clone(), &Positions::new(written.text.as_bytes()))
}

fn units(places: BTreeMap<Name, Span>, positions: &Positions) -> Places {
    places.into_iter().map(|(name, span)| (name, [span.start, span.end].map(|at| positions.utf16(at)))).collect()
}
