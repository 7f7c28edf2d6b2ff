//! What an editor offers to change: cures of findings, one or all of a kind; a call, or all, in another call style. The
//! edits are those of the application; the client applies them when the user says so.

use super::diagnose::{self, Place};
use super::known::{Document, Known};
use super::settings::Settings;
use lsp_types::{CodeActionKind, Range, TextEdit};
use probewright_core::app::{self, Beside, ConvertRequest, CureRequest, Finding};
use probewright_core::diagnostic::{Diagnostic, Severity, Span};
use probewright_core::entry::{Cycle, Style};
use probewright_core::message::Message;
use probewright_core::words::Words;
use serde_json::{Value, json};

/// What is asked.
pub struct Asked<'a> {
    pub document: &'a Document,
    pub known: &'a Known,
    pub settings: &'a Settings,
    pub uri: &'a lsp_types::Uri,
    pub range: Range,
    /// Kinds that the client wants; none: all.
    pub only: Option<Vec<CodeActionKind>>,
    /// Whether edits name the version of the text.
    pub versioned: bool,
    /// Whether the client shows an action that is not possible, with the reason.
    pub disabled: bool,
    pub words: &'a Words,
}

/// What is offered.
pub fn actions(asked: &Asked) -> Vec<Value> {
    let mut all = Vec::new();
    if asked.wants(&CodeActionKind::QUICKFIX) {
        cures(asked, &mut all);
    }
    if asked.wants(&CodeActionKind::REFACTOR_REWRITE) {
        conversions(asked, &mut all);
    }
    all
}

impl Asked<'_> {
    fn wants(&self, kind: &CodeActionKind) -> bool {
        let under = |one: &CodeActionKind| {
            let rest = kind.as_str().strip_prefix(one.as_str());
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.') || one.as_str().is_empty())
        };
        self.only.as_ref().is_none_or(|only| only.iter().any(under))
    }

    fn action(&self, title: String, kind: &CodeActionKind, edits: &[TextEdit]) -> Value {
        let uri = self.uri.as_str();
        let edit = if self.versioned {
            let document = json!({ "uri": uri, "version": self.document.version });
            json!({ "documentChanges": [{ "textDocument": document, "edits": edits }] })
        } else {
            json!({ "changes": { uri: edits } })
        };
        json!({ "title": title, "kind": kind, "edit": edit })
    }

    fn placed(&self, edits: &[app::Edit]) -> Vec<TextEdit> {
        let text = &self.document.text;
        edits.iter().map(|edit| TextEdit::new(text.range_of_units(edit.from, edit.to), edit.insert.clone())).collect()
    }

    /// The definition files beside the program: what is written anew stands in the program itself.
    fn beside(&self) -> Option<Vec<Beside>> {
        let beside = self.known.joined.sources();
        let text = |source: &[u8]| String::from_utf8_lossy(source).into_owned();
        let with: Vec<Beside> = beside.map(|(name, source)| Beside { name, text: text(source) }).collect();
        (!with.is_empty()).then_some(with)
    }

    fn machine(&self) -> Option<app::Machine> {
        self.settings.described.as_ref().map(|described| described.machine.clone())
    }

    /// The lines of the range: in an editor a line is asked about, not the comma in it.
    fn lines(&self) -> Span {
        let text = &self.document.text;
        let lines = text.range_of_lines(self.range.start.line, self.range.end.line);
        Span { start: text.byte(lines.start) as u32, end: text.byte(lines.end) as u32 }
    }
}

/// The cures of the findings in the lines of the range.
fn cures(asked: &Asked, all: &mut Vec<Value>) {
    let lines = asked.lines();
    let known = asked.known;
    let here = |one: &&Diagnostic| {
        one.span.is_some_and(|place| place.start <= lines.end && lines.start <= place.end) && is_own(known, one)
    };
    let mut kinds: Vec<(String, String)> = Vec::new();
    for found in known.found.iter().filter(here) {
        let Some(cure) = &found.cure else { continue };
        let text = &asked.document.text;
        let edits: Vec<_> =
            cure.edits.iter().map(|edit| TextEdit::new(text.range(edit.span), edit.insert.clone())).collect();
        let label = asked.words.text(&cure.label);
        let mut action = asked.action(label.clone(), &CodeActionKind::QUICKFIX, &edits);
        let place = Place { text, uri: asked.uri };
        action["diagnostics"] = json!([diagnose::told(known, found, &place, asked.words)]);
        action["isPreferred"] = true.into();
        all.push(action);
        let kind = (found.code.to_string(), found.message.key.to_string());
        if !kinds.contains(&kind) {
            all.extend(cure_all(asked, &kind, label));
            kinds.push(kind);
        }
    }
}

/// Whether a finding and what its cure changes are in the program itself.
fn is_own(known: &Known, found: &Diagnostic) -> bool {
    let own = |place: Span| known.joined.of_program(place);
    own(found.span.unwrap_or_default()) && found.cure.iter().flat_map(|cure| &cure.edits).all(|edit| own(edit.span))
}

/// All findings of a kind at once, where there are several.
fn cure_all(asked: &Asked, (code, key): &(String, String), label: String) -> Option<Value> {
    let same = |one: &&Diagnostic| one.code.to_string() == *code && one.message.key == *key && is_own(asked.known, one);
    let count = asked.known.found.iter().filter(same).filter(|one| one.cure.is_some()).count();
    if count < 2 {
        return None;
    }
    let done = app::cure(CureRequest {
        control: asked.known.program.dialect,
        text: asked.document.text.as_str().into(),
        code: code.clone(),
        key: key.clone(),
        setup: asked.machine(),
        with: asked.beside(),
    });
    let edits = asked.placed(&done.ok()?.edits);
    let title = Message::new("server-all").text("label", label).number("count", count as f64);
    (!edits.is_empty()).then(|| asked.action(asked.words.text(&title), &CodeActionKind::QUICKFIX, &edits))
}

/// The calls in the range in another style, and all calls of the program so.
fn conversions(asked: &Asked, all: &mut Vec<Value>) {
    let lines = asked.range.start.line..=asked.range.end.line;
    let calls = asked.known.own();
    let near = calls.filter(|(_, site)| *lines.start() <= site.line && site.first_line <= *lines.end());
    let calls: Vec<_> = near.collect();
    let [(number, site)] = calls[..] else { return };
    let own = site.list.map_or(Style::Direct, |list| list.style);
    for style in styles(site.cycle).filter(|style| *style != own) {
        all.extend(converted(asked, style, Some(number)));
        if asked.known.own().nth(1).is_some() {
            all.extend(converted(asked, style, None));
        }
    }
}

fn styles(cycle: &Cycle) -> impl Iterator<Item = Style> {
    let has = |style: Style| style == Style::Direct || cycle.lists.iter().any(|list| list.style == style);
    [Style::Direct, Style::Indirect, Style::Operate].into_iter().filter(move |style| has(*style))
}

fn converted(asked: &Asked, style: Style, call: Option<usize>) -> Option<Value> {
    let done = app::convert(ConvertRequest {
        control: asked.known.program.dialect,
        text: asked.document.text.as_str().into(),
        call,
        style,
        setup: asked.machine(),
        with: asked.beside(),
    });
    let done = done.ok()?;
    let key = match (style, call) {
        (Style::Direct, Some(_)) => "server-direct",
        (Style::Indirect, Some(_)) => "server-indirect",
        (Style::Operate, Some(_)) => "server-operate",
        (Style::Direct, None) => "server-every-direct",
        (Style::Indirect, None) => "server-every-indirect",
        (Style::Operate, None) => "server-every-operate",
    };
    let told = remarks(&done.findings, asked.words);
    let edits = asked.placed(&done.edits);
    if edits.is_empty() {
        let why = done.findings.iter().any(|one| one.severity == Severity::Error).then_some(told)?;
        return Some(refused(asked, asked.words.key(key), &why));
    }
    let told = if told.is_empty() { told } else { format!(" – {told}") };
    Some(asked.action(asked.words.key(key) + &told, &CodeActionKind::REFACTOR_REWRITE, &edits))
}

/// What is said of a conversion, each sentence once.
fn remarks(findings: &[Finding], words: &Words) -> String {
    let mut told: Vec<String> = Vec::new();
    for one in findings.iter().map(|one| words.text(&one.message)) {
        if !told.contains(&one) {
            told.push(one);
        }
    }
    told.join(" ")
}

/// An action that is not possible, with the reason; a client that has no such actions gets one that tells it.
fn refused(asked: &Asked, title: String, why: &str) -> Value {
    let kind = CodeActionKind::REFACTOR_REWRITE;
    if asked.disabled {
        return json!({ "title": title, "kind": kind, "disabled": { "reason": why } });
    }
    let title = format!("{title} – {why}");
    let command = json!({ "title": title, "command": TELL, "arguments": [why] });
    json!({ "title": title, "kind": kind, "command": command })
}

/// The command that shows why an action is not possible.
pub const TELL: &str = "probewright.tell";
