//! What can be written in a program of a control that is read and not run: its cycles, and of the call that goes on
//! here the parameters that it does not have yet.

use super::complete::Make;
use super::known::{Document, Known};
use lsp_types::{CompletionItem, CompletionItemKind, Position, Range};
use probewright_core::foreign::{self, Foreign, Page};
use probewright_core::words::Words;

/// What can be written at a position; none: the program is of no such control.
pub fn at(document: &Document, known: &Known, at: Position, words: &Words) -> Option<Vec<CompletionItem>> {
    let control = foreign::control_of(&known.program.source)?;
    let (before, byte) = document.text.before(at);
    if before.contains([';', '=']) {
        return Some(Vec::new());
    }
    let typed = begun(before);
    let range = Range::new(document.text.position(byte - typed.len()), at);
    let make = Make { range, words };
    Some(match goes_on(control, document.text.as_str(), byte) {
        Some(items) if !typed.starts_with(['T', 't', 'G', 'g']) => parameters(&items, &make),
        _ => control
            .cycles
            .iter()
            .filter(|cycle| cycle.page != Page::Nothing)
            .map(|cycle| {
                let text = format!("{} {}", cycle.name, cycle.text);
                make.item(cycle.name, &text, CompletionItemKind::FUNCTION, words.key(cycle.title()))
            })
            .collect(),
    })
}

/// What of a block is there, without its number.
fn begun(before: &str) -> &str {
    let line = before.trim_start();
    let rest = line.trim_start_matches(|one: char| one.is_ascii_digit());
    if rest.starts_with(' ') { rest.trim_start() } else { line }
}

/// Parameters that the call of the line before lacks.
fn goes_on(control: &Foreign, text: &str, byte: usize) -> Option<Vec<&'static foreign::Parameter>> {
    let before = text.get(..byte)?;
    let call = (control.calls)(before.as_bytes()).pop()?;
    let end = call.values.last().map_or(call.span.end, |value| value.span.end);
    let between = before.get(end as usize..)?;
    let given = |name: &str| call.values.iter().any(|value| value.name.eq_ignore_ascii_case(name));
    let lacks = call.cycle?.parameters.iter().filter(|one| !given(one.name)).collect();
    (between.matches('\n').count() == 1).then_some(lacks)
}

fn parameters(all: &[&foreign::Parameter], make: &Make) -> Vec<CompletionItem> {
    let item = |one: &&foreign::Parameter| {
        make.item(one.name, &format!("{}=", one.name), CompletionItemKind::FIELD, make.words.key(one.key))
    };
    all.iter().map(item).collect()
}
