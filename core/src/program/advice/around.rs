//! Lines that stand around a call and belong to one with other values: a work offset, the axes of a plane.

use crate::control::Control;
use crate::diagnostic::Diagnostic;
use crate::message::Message;
use crate::own;
use crate::program::around::{inputs_at, strays};
use crate::program::calls::CallSite;
use crate::syntax::Program;

/// Says of each block around a call that it belongs to a call with other values.
pub fn look(program: &Program, control: &Control, sites: &[CallSite], found: &mut Vec<Diagnostic>) {
    for site in sites.iter().filter(|site| !program.is_of_macro(site.span)) {
        let strays = strays(program, site, &inputs_at(site, control));
        found.extend(strays.into_iter().map(|stray| {
            let finding = own::AROUND_STRAY.finding().text("name", site.cycle.name).on(stray.at);
            finding.cured(Message::new("around-stray-cure"), stray.edits)
        }));
    }
}
