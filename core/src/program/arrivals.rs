//! What a form says beside the values that other programs of the text give to a call, or several ways to it.

use super::calls::{CallSite, Origin};
use super::tree::Program;
use crate::check::{Finding, note};
use crate::diagnostic::{Code, Diagnostic};
use crate::message::Message;

/// Notes at the fields of a call. They say how the program works, and nothing against it.
pub fn arrivals(program: &Program, site: &CallSite) -> Vec<Diagnostic> {
    let line = |origin: &Origin| program.line_of(origin.place.start) + 1;
    let mut notes = Vec::new();
    for (name, origins) in &site.origins {
        let (message, hint) = if site.differs(name) {
            let each = origins.iter();
            let values = each.map(|origin| format!("{} ({})", origin.text, line(origin)));
            let values = listed(values, site.is_of_many(name));
            let message = Message::new("arrives-differing").text("values", values);
            (message, "arrives-differing-hint")
        } else {
            let lines = origins.iter().map(|origin| line(origin).to_string());
            let own = origins.iter().all(|origin| origin.own);
            let many = site.is_of_many(name);
            let hint = match (many, own) {
                (true, _) => "arrives-many-hint",
                (_, true) => "arrives-hint",
                _ => "arrives-shared-hint",
            };
            (
                Message::new("arrives").text("lines", listed(lines, many)),
                hint,
            )
        };
        let finding = note(Code::Own(151), message).hint(Message::new(hint));
        notes.push(finding.at(name));
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
