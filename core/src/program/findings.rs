//! What is wrong in a program, without running it.

use super::advice::advice;
use super::block_rules::block_rules;
use super::calls::macros::of_functions;
use super::calls::{CallSite, calls_on};
use super::lists::findings::{of_alone, of_places, unclosed};
use crate::catalogue::Functions;
use crate::control::{Control, delivery};
use crate::diagnostic::{Diagnostic, Edit, Severity, Span};
use crate::dialect::Dialect;
use crate::foreign;
use crate::message::Message;
use crate::own::{self, Own};
use crate::syntax::definitions;
use crate::syntax::macros::LONGEST;
use crate::syntax::programs::programs;
use crate::syntax::{DEPTH, LARGEST, Program, SyntaxError};

/// What reading and checking found on a metric control as delivered, in the order of the text, the worst first.
pub fn findings(program: &Program) -> Vec<Diagnostic> {
    findings_on(program, delivery(program.dialect))
}

/// What [`findings`] tells of a program that starts on a control in this state.
pub fn findings_on(program: &Program, control: Control) -> Vec<Diagnostic> {
    findings_of(program, &calls_on(program, control.clone()), &control)
}

/// What [`findings_on`] tells, where the calls of the program on this control are known already.
pub fn findings_of(program: &Program, sites: &[CallSite], control: &Control) -> Vec<Diagnostic> {
    if let Some(found) = foreign::findings::of_program(&program.source) {
        return found;
    }
    if let Some(control) = foreign::log_of(&program.source) {
        let log = own::FOREIGN_LOG.finding().text("control", control.name);
        return vec![log.on(foreign::first_line(&program.source))];
    }
    let syntax = program.errors.iter().map(|error| not_understood(program, error));
    let blocks = match program.dialect {
        Dialect::Sinumerik => block_rules(program),
        Dialect::Nct => of_functions(program, &Functions::of(control)),
    };
    let advice = advice(program, sites, control);
    let defined = definitions::of_text(program, &programs(program));
    let here = super::defined_here::finding(&defined, control);
    // of a name that is an axis the rules for blocks tell
    let defined = defined.findings().filter(|found| found.message.key != "run-axis-name");
    let calls = sites.iter().flat_map(|site| site.diagnostics.iter().cloned());
    let mut found: Vec<Diagnostic> = syntax
        .chain(blocks)
        .chain(defined)
        .chain(here)
        .chain(calls)
        .chain(advice)
        .chain(of_places(program))
        .chain(of_alone(program))
        .collect();
    for one in &mut found {
        place(program, one);
    }
    found.sort_by_key(|finding| (start(finding), finding.severity));
    once(found)
}

/// Places what lies in the text of a macro where that is named; nothing is cured there.
fn place(program: &Program, found: &mut Diagnostic) {
    let own = |span: &Span| program.placed(*span) == *span && !program.is_of_macro(*span);
    found.cure = found.cure.take().filter(|cure| cure.edits.iter().all(|edit| own(&edit.span)));
    found.span = found.span.map(|span| program.placed(span));
}

fn start(finding: &Diagnostic) -> u32 {
    finding.span.map_or(0, |span| span.start)
}

/// Each finding once a place: calls that share a value say the same about it, and so do two ways to a call.
fn once(found: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut kept: Vec<Diagnostic> = Vec::with_capacity(found.len());
    for finding in found {
        let mut same = kept.iter().rev().take_while(|other| start(other) == start(&finding));
        if !same.any(|other| *other == finding) {
            kept.push(finding);
        }
    }
    kept
}

/// What reading did not understand, with what to write instead where it is a number of another language.
pub fn not_understood(program: &Program, error: &SyntaxError) -> Diagnostic {
    if let Some(found) = foreign_character(program, error) {
        return found;
    }
    let found = error.sentence.finding().on(error.span);
    let found = match limit(error.sentence) {
        Some(most) => found.number("most", most),
        None => found,
    };
    if let Some(edit) = unclosed(program, error) {
        return found.cured(Message::new("newer-set-close"), vec![edit]);
    }
    let instead = match error.sentence.cause {
        cause if cause == own::SYNTAX_EXPONENT.cause => "EX",
        cause if cause == own::SYNTAX_COMMA.cause => ".",
        _ => return found,
    };
    let Some((number, edit)) = rewritten(program, error.span, instead) else { return found };
    let write = Message::new("syntax-write").text("value", number);
    found.hint(write.clone()).cured(write, vec![edit])
}

/// What a sentence says that reading takes at most: levels, or GB.
fn limit(sentence: &Own) -> Option<f64> {
    match sentence.cause {
        cause if cause == own::SYNTAX_DEPTH.cause => Some(f64::from(DEPTH)),
        cause if cause == own::SYNTAX_MACRO_LONG.cause => Some(LONGEST as f64),
        cause if cause == own::SYNTAX_TOO_LARGE.cause => Some((f64::from(LARGEST) / f64::from(1 << 30)).round()),
        _ => None,
    }
}

/// A character that the language does not have where reading failed: from a text processor, or one that nobody sees.
fn foreign_character(program: &Program, error: &SyntaxError) -> Option<Diagnostic> {
    if error.sentence.severity != Severity::Error {
        return None;
    }
    let rest = program.source.get(error.span.start as usize..)?;
    let text = rest.get(..rest.len().min(4))?;
    let known = text.utf8_chunks().next()?.valid().chars().next();
    let character = known.unwrap_or(char::from(*rest.first()?)); // of an older code page
    if character.is_ascii_graphic() || matches!(character, ' ' | '\t' | '\r' | '\n') {
        return None;
    }
    let length = known.map_or(1, char::len_utf8) as u32;
    let number = format!("U+{:04X}", u32::from(character));
    let found = own::SYNTAX_CHARACTER.finding().text("number", number).on(error.span);
    let instead = match character {
        '\u{2010}'..='\u{2015}' | '\u{2212}' => '-',
        '\u{201C}'..='\u{201F}' | '\u{AB}' | '\u{BB}' => '"',
        // full width, as a Chinese keyboard types them: each lies as far behind its ASCII character
        '\u{FF01}'..='\u{FF5E}' => char::from_u32(u32::from(character) - 0xFEE0)?,
        _ if character.is_alphanumeric() => return Some(found),
        _ => ' ',
    };
    let span = Span { start: error.span.start, end: error.span.start + length };
    let edit = Edit::replace(span, instead);
    let label = match instead {
        ' ' => Message::new("syntax-character-blank"),
        written => Message::new("syntax-write").text("value", written.to_string()),
    };
    Some(found.hint(label.clone()).cured(label, vec![edit]))
}

/// The number around the byte at which reading failed, with something else in its place; none: no number stands there.
fn rewritten(program: &Program, at: Span, instead: &str) -> Option<(String, Edit)> {
    let (before, behind) = program.source.split_at_checked(at.start as usize)?;
    let of_number = |byte: &&u8| byte.is_ascii_digit() || **byte == b'.';
    let digits = before.iter().rev().take_while(of_number).count();
    let (wrong, behind) = behind.split_first()?;
    let sign = if *wrong == b',' { 0 } else { behind.iter().take_while(|byte| b"+-".contains(byte)).count().min(1) };
    let power = behind.get(sign..)?.iter().take_while(of_number).count();
    if digits == 0 || power == 0 {
        return None;
    }
    let mantissa = String::from_utf8_lossy(before.get(before.len() - digits..)?);
    let power = String::from_utf8_lossy(behind.get(..sign + power)?);
    let edit = Edit::replace(Span { end: at.start + 1, ..at }, instead);
    Some((format!("{mantissa}{instead}{power}"), edit))
}
