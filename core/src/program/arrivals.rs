//! What a form says beside the values that other programs of the text give to a call, or several ways to it; and
//! beside those that nothing gives.

use super::calls::{CallSite, Origin};
use crate::diagnostic::Diagnostic;
use crate::own;
use crate::syntax::Program;

/// Notes at the fields of a call. They say how the program works, and nothing against it.
pub fn arrivals(program: &Program, site: &CallSite) -> Vec<Diagnostic> {
    let line = |origin: &Origin| program.line_of(origin.place.start) + 1;
    let missing = site
        .missing
        .iter()
        .map(|(name, variable)| own::NO_VALUE.finding().text("name", variable).hint_text("name", variable).at(*name));
    let mut notes: Vec<_> = missing.collect();
    for (name, origins) in &site.origins {
        let many = site.is_of_many(name);
        let finding = if site.differs(name) {
            let values = origins.iter().map(|origin| format!("{} ({})", origin.text, line(origin)));
            own::ARRIVES_DIFFERING.finding().text("values", listed(values, many))
        } else {
            let mut lines: Vec<String> = origins.iter().map(|origin| line(origin).to_string()).collect();
            lines.dedup();
            let sentence = match origins.iter().all(|origin| origin.own) {
                _ if many => own::ARRIVES_MANY,
                true if lines.len() > 1 => own::ARRIVES_LINES,
                true => own::ARRIVES,
                false => own::ARRIVES_SHARED,
            };
            sentence.finding().text("lines", listed(lines.into_iter(), many))
        };
        notes.push(finding.at(*name));
    }
    notes
}

/// Each once, in the order of the text. `more`: there may be others.
fn listed(texts: impl Iterator<Item = String>, more: bool) -> String {
    let mut all: Vec<String> = Vec::new();
    for text in texts {
        if !all.contains(&text) {
            all.push(text);
        }
    }
    all.extend(more.then(|| "…".to_owned()));
    all.join(", ")
}
