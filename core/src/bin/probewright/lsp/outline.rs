//! The outline of a program: its programs, labels, measuring calls and calls of subprograms.

use super::known::{Document, Known};
use lsp_types::{Range, SymbolKind};
use probewright_core::diagnostic::Span;
use probewright_core::program::others::{Other, others};
use probewright_core::syntax::Word;
use probewright_core::syntax::programs::{Programs, Unit, bare, programs};
use probewright_core::words::Words;
use serde_json::{Value, json};

/// A line of the outline.
pub struct Symbol {
    name: String,
    detail: String,
    kind: SymbolKind,
    range: Range,
    selection: Range,
    children: Vec<Symbol>,
}

/// The outline of the program itself; what it has several programs of are those.
pub fn outline(document: &Document, known: &Known, words: &Words) -> Vec<Symbol> {
    let all = programs(&known.program);
    let own = |unit: &&Unit| {
        let first = known.program.blocks.get(unit.blocks.start);
        first.is_some_and(|block| known.joined.of_program(block.span))
    };
    let units: Vec<&Unit> = all.units.iter().filter(own).collect();
    match units[..] {
        [only] if only.file.is_none() => lines(document, known, &all, only, words),
        _ => units.into_iter().map(|unit| program(document, known, &all, unit, words)).collect(),
    }
}

fn program(document: &Document, known: &Known, all: &Programs, unit: &Unit, words: &Words) -> Symbol {
    let declared =
        || known.program.signature(unit).iter().find_map(Word::declared).map(|name| known.program.name(name));
    let title = words.key("server-program");
    let last = unit.blocks.end.saturating_sub(1).max(unit.blocks.start);
    let first = unit.blocks.start as u32;
    Symbol {
        name: unit.file.as_deref().map(|file| bare(file).to_owned()).or_else(declared).unwrap_or_else(|| title.clone()),
        detail: title,
        kind: SymbolKind::MODULE,
        range: document.text.range_of_lines(first, last as u32),
        selection: document.text.range_of_lines(first, first),
        children: lines(document, known, all, unit, words),
    }
}

/// What stands in a program, in the order of the text.
fn lines(document: &Document, known: &Known, all: &Programs, unit: &Unit, words: &Words) -> Vec<Symbol> {
    let plain = |name: String, detail: String, kind: SymbolKind, place: Span| {
        let range = document.text.range(place);
        Symbol { name, detail, kind, range, selection: range, children: Vec::new() }
    };
    let mut found: Vec<Symbol> = Vec::new();
    for word in known.program.blocks_of(unit).iter().flat_map(|block| known.program.words_of(block)) {
        if let Some(label) = word.label() {
            found.push(plain(known.program.written(label), words.key("server-label"), SymbolKind::KEY, word.span));
        } else if let Some(called) = word.called().filter(|name| all.named(&known.program.name(*name)).is_some()) {
            let detail = words.key("server-subprogram");
            found.push(plain(known.program.written(called), detail, SymbolKind::FUNCTION, word.span));
        }
    }
    for (_, site) in known.own().filter(|(_, site)| unit.blocks.contains(&(site.line as usize))) {
        let title = words.text(&known.title(site));
        let lines = document.text.range_of_lines(site.first_line, site.line);
        let call = plain(site.cycle.name.to_owned(), title, SymbolKind::EVENT, site.span);
        found.push(Symbol { range: lines, ..call });
    }
    let own = |one: &Other| known.joined.of_program(one.span);
    let within = |one: &Other| unit.blocks.contains(&(known.program.line_of(one.span.start) as usize));
    for Other { name, title, span, .. } in others(&known.program).filter(|one| own(one) && within(one)) {
        found.push(plain(name, words.text(&title), SymbolKind::EVENT, span));
    }
    found.sort_by_key(|symbol| symbol.selection.start);
    found
}

/// The outline as the client takes it: nested, or each line with its place alone.
pub fn told(symbols: &[Symbol], nested: bool, uri: &str) -> Vec<Value> {
    let mut all = Vec::new();
    for one in symbols {
        let Symbol { name, detail, kind, range, selection, children } = one;
        if nested {
            let children = told(children, nested, uri);
            all.push(json!({ "name": name, "detail": detail, "kind": kind, "range": range,
                "selectionRange": selection, "children": children }));
        } else {
            let location = json!({ "uri": uri, "range": range });
            all.push(json!({ "name": format!("{name}: {detail}"), "kind": kind, "location": location }));
            all.extend(told(children, nested, uri));
        }
    }
    all
}
