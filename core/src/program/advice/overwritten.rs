//! A value that a subprogram writes too, called between the assignment and the measuring call: what stands at the
//! assignment is not what counts at the call. Parameters are data of the channel: all programs share them.

use crate::diagnostic::Diagnostic;
use crate::message::Message;
use crate::own;
use crate::program::calls::CallSite;
use crate::program::change::line_at_begin;
use crate::syntax::Program;

/// Each assignment that does not reach its call.
pub fn look(program: &Program, sites: &[CallSite], found: &mut Vec<Diagnostic>) {
    for site in sites {
        for (name, place, call) in &site.overwritten {
            let line = f64::from(program.line_of(call.start) + 1);
            let finding = own::ADVICE_OVERWRITTEN.finding().text("name", *name).number("line", line);
            let value = program.written(*place);
            let edit = line_at_begin(program, site.line, &format!("{name}={value}"));
            let label = Message::new("advice-write").text("name", *name).text("value", value.trim());
            found.push(finding.hint_text("name", *name).cured(label, edit.into_iter().collect()).on(*place));
        }
    }
}
