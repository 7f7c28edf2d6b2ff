//! Findings as they are shown, with their places in the text.

use super::supply::Offer;
use crate::diagnostic;
use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::message::Message;
use crate::name::Name;
use crate::program::touched::TouchedLine;
use crate::syntax::position::Positions;
use serde::Serialize;

/// What is wrong, where, and how to fix it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Diagnostic", optional_fields))]
pub struct Finding {
    /// How bad.
    pub severity: Severity,
    /// Name of the finding: `61307`, `FORMAT ERROR`, `PW012`.
    pub code: Code,
    /// Cause.
    pub message: Message,
    /// What helps.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hint: Option<Message>,
    /// Parameter to which it belongs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub param: Option<Name>,
    /// Where it begins in the text of the program, UTF-16 units.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub from: Option<u32>,
    /// One past its end, UTF-16 units.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub to: Option<u32>,
    /// Line in which it begins, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<u32>,
    /// Character of that line, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub column: Option<u32>,
    /// Fixes it at once.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cure: Option<Cure>,
    /// Lines that the cure changes elsewhere than where the finding is told.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub elsewhere: Option<Vec<TouchedLine>>,
    /// Files that are wanted, by the names that calls have for them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<String>>"))]
    pub wants: Vec<String>,
    /// What the machine lacks, each a fix.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<Offer>>"))]
    pub offers: Vec<Offer>,
}

/// Edits that fix a finding.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Cure {
    /// What they do.
    pub label: Message,
    /// The only places of the text that change.
    pub edits: Vec<Edit>,
}

/// Replaces a place of the text; places count in UTF-16 units.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Edit {
    /// First unit that goes.
    pub from: u32,
    /// One past the last; the same: nothing goes.
    pub to: u32,
    /// What comes.
    pub insert: String,
}

impl Finding {
    /// Without a place: at a form.
    pub fn of(found: &Diagnostic) -> Finding {
        Finding {
            severity: found.severity,
            code: found.code,
            message: found.message.clone(),
            hint: found.hint.clone(),
            param: found.param,
            from: None,
            to: None,
            line: None,
            column: None,
            cure: None,
            elsewhere: None,
            wants: wanted(&found.message),
            offers: Vec::new(),
        }
    }

    /// With its place in a text and the edits that fix it.
    pub fn placed(found: &Diagnostic, positions: &Positions) -> Finding {
        let at = found.span.map(|span| positions.line_column(span.start));
        let cure = |cure: &diagnostic::Cure| Cure { label: cure.label.clone(), edits: edits(&cure.edits, positions) };
        Finding {
            from: found.span.map(|span| positions.utf16(span.start)),
            to: found.span.map(|span| positions.utf16(span.end)),
            line: at.map(|(line, _)| line),
            column: at.map(|(_, column)| column),
            cure: found.cure.as_ref().map(cure),
            ..Finding::of(found)
        }
    }
}

/// The names of programs that are not there.
fn wanted(message: &Message) -> Vec<String> {
    let names = message.word("word").filter(|_| message.key == "run-subprogram").unwrap_or_default();
    names.split(", ").filter(|name| !name.is_empty() && *name != "…").map(str::to_owned).collect()
}

/// What is wrong with a program of this text.
pub fn findings(list: &[Diagnostic], source: &[u8]) -> Vec<Finding> {
    placed(list, &Positions::new(source))
}

pub(super) fn placed(list: &[Diagnostic], positions: &Positions) -> Vec<Finding> {
    list.iter().map(|found| Finding::placed(found, positions)).collect()
}

pub(super) fn edits(list: &[diagnostic::Edit], positions: &Positions) -> Vec<Edit> {
    let edit = |edit: &diagnostic::Edit| Edit {
        from: positions.utf16(edit.span.start),
        to: positions.utf16(edit.span.end),
        insert: edit.insert.clone(),
    };
    list.iter().map(edit).collect()
}
