//! Findings as an editor shows them.

use super::known::Known;
use super::paths;
use super::text::{Text, Units};
use crate::check;
use lsp_types::{Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity, Location, NumberOrString};
use probewright_core::diagnostic::{self, Severity};
use probewright_core::message::Message;
use probewright_core::program::calls::CallSite;
use probewright_core::words::Words;
use std::collections::BTreeMap;

/// Findings that are sent of a file: with more of them it is another sort of file, not a program with mistakes.
const MOST: usize = 1000;

/// What an address leads to.
pub struct Place<'a> {
    pub text: &'a Text,
    pub uri: &'a lsp_types::Uri,
}

/// The findings of the program itself.
pub fn own(known: &Known, at: &Place, words: &Words) -> Vec<Diagnostic> {
    let own = known.found.iter().filter(|one| known.joined.of_program(one.span.unwrap_or_default()));
    let mut all: Vec<Diagnostic> = own.clone().take(MOST).map(|one| told(known, one, at, words)).collect();
    let more = own.count().saturating_sub(MOST);
    if let Some(last) = all.last().filter(|_| more > 0) {
        let message = words.text(&Message::new("terminal-more").number("count", more as f64));
        let severity = Some(DiagnosticSeverity::INFORMATION);
        all.push(Diagnostic { range: last.range, message, severity, ..Diagnostic::default() });
    }
    all
}

/// The findings in the files beside it, by their addresses.
pub fn beside(known: &Known, units: Units, words: &Words) -> BTreeMap<String, Vec<Diagnostic>> {
    let mut all = BTreeMap::new();
    for (path, source, found) in known.joined.files(&known.found).into_iter().skip(1) {
        let Some(uri) = paths::uri(path) else { continue };
        let text = Text::new(String::from_utf8_lossy(source).into_owned(), units);
        let list = found.iter().take(MOST).map(|one| plain(one, &text, words)).collect();
        all.insert(uri.as_str().to_owned(), list);
    }
    all
}

fn plain(found: &diagnostic::Diagnostic, text: &Text, words: &Words) -> Diagnostic {
    let severity = match found.severity {
        Severity::Error => DiagnosticSeverity::ERROR,
        Severity::Warning => DiagnosticSeverity::WARNING,
        Severity::Note => DiagnosticSeverity::INFORMATION,
    };
    Diagnostic {
        range: text.range(found.span.unwrap_or_default()),
        severity: Some(severity),
        code: Some(NumberOrString::String(found.code.to_string())),
        source: Some("probewright".to_owned()),
        message: check::told(found, words),
        ..Diagnostic::default()
    }
}

/// A finding, with the call that it is about where it stands elsewhere.
pub fn told(known: &Known, found: &diagnostic::Diagnostic, at: &Place, words: &Words) -> Diagnostic {
    let place = found.span.unwrap_or_default();
    let about = |site: &&CallSite| {
        let same = |one: &diagnostic::Diagnostic| one.span == found.span && one.message == found.message;
        !site.span.holds(place) && known.joined.of_program(site.span) && site.diagnostics.iter().any(same)
    };
    let related = |site: &CallSite| DiagnosticRelatedInformation {
        location: Location::new(at.uri.clone(), at.text.range(site.span)),
        message: words.text(&Message::new("server-call").text("cycle", site.cycle.name)),
    };
    let related: Vec<_> = known.sites.iter().filter(about).map(related).collect();
    let related_information = (!related.is_empty()).then_some(related);
    Diagnostic { related_information, ..plain(found, at.text, words) }
}
