//! Programs in conversational text and in DIN/ISO. A call goes on over the lines that begin with a Q parameter, with or
//! without `~`; in DIN/ISO `*` ends it (TNC 410 ISO programming, p. 283), and its word is `G` with the number of the
//! cycle (TNC 320 9/2016, p. 396: cycle 423, DIN/ISO: G423).

use super::super::{ForeignCall, ForeignCycle, ForeignValue, line_end};
use super::table::CYCLES;
use crate::diagnostic::Span;

/// Lines in which a program is looked for.
const HEAD: usize = 200;
/// How a probe cycle begins.
const CALL: &[u8] = b"TCH PROBE ";

/// Digits of a touch probe cycle, as a function of DIN/ISO: G400 to G499.
const DIGITS: usize = 3;

/// Whether a text begins as such a program, or calls a probe cycle at its head.
pub fn is_program(source: &[u8]) -> bool {
    let lines = lines(source).map(|(_, line)| code(line)).filter(|line| !line.is_empty());
    let begins = |(at, line): (usize, &[u8])| at == 0 && begins_with(line, b"BEGIN PGM ") || called(line).is_some();
    lines.take(HEAD).enumerate().any(begins)
}

/// The cycle that a program calls so.
pub fn named(name: &str) -> Option<&'static ForeignCycle> {
    let number = function(name.as_bytes()).map(|digits| format!("{}{digits}", String::from_utf8_lossy(CALL)));
    let name = number.as_deref().unwrap_or(name);
    CYCLES.iter().find(|cycle| cycle.name.eq_ignore_ascii_case(name))
}

/// The probe cycles of a program.
pub fn calls(source: &[u8]) -> Vec<ForeignCall> {
    let mut found: Vec<ForeignCall> = Vec::new();
    let mut goes_on = false;
    for ((start, line), number) in lines(source).zip(0..) {
        let code = code(line);
        // where the code begins in the text
        let at = start + (code.as_ptr() as usize - line.as_ptr() as usize);
        if let Some((name, length)) = called(code) {
            let rest = code.get(length..).unwrap_or_default();
            let (span, values) = (span(at, length), values(rest, at + length));
            found.push(ForeignCall { cycle: named(&name), name, line: number, span, values });
            goes_on = true;
        } else if goes_on && is_value(code) {
            if let Some(last) = found.last_mut() {
                last.values.extend(values(code, at));
            }
        } else {
            goes_on = false;
        }
    }
    found
}

/// The values that a line gives which makes a call, or goes on with one.
pub fn values_of_line(line: &[u8]) -> Vec<ForeignValue> {
    let code = code(line);
    let at = code.as_ptr() as usize - line.as_ptr() as usize;
    match called(code) {
        Some((_, length)) => values(code.get(length..).unwrap_or_default(), at + length),
        None if is_value(code) => values(code, at),
        None => Vec::new(),
    }
}

/// Lines with where they begin, without what ends them.
fn lines(source: &[u8]) -> impl Iterator<Item = (usize, &[u8])> {
    let mut next = 0;
    let line_end = line_end(source);
    source.split(move |byte| *byte == line_end).map(move |line| {
        let start = next;
        next += line.len() + 1;
        (start, line)
    })
}

/// A line without the number of its block and what stands behind a semicolon.
fn code(line: &[u8]) -> &[u8] {
    let line = line.strip_prefix(b"\xef\xbb\xbf").unwrap_or(line).trim_ascii_start();
    let line = line.strip_prefix(b"/").unwrap_or(line);
    let line = match line {
        [b'N' | b'n', rest @ ..] if rest.first().is_some_and(u8::is_ascii_digit) => rest, // of DIN/ISO
        line => line,
    };
    let digits = line.iter().take_while(|byte| byte.is_ascii_digit()).count();
    let behind = line.get(digits..).unwrap_or_default();
    let line = if digits > 0 && behind.first().is_some_and(u8::is_ascii_whitespace) { behind } else { line };
    let end = line.iter().position(|byte| *byte == b';').unwrap_or(line.len());
    line.get(..end).unwrap_or_default().trim_ascii()
}

fn begins_with(line: &[u8], word: &[u8]) -> bool {
    line.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word))
}

/// Whether a line gives a Q parameter a value.
fn is_value(code: &[u8]) -> bool {
    let [b'Q' | b'q', rest @ ..] = code else { return false };
    let rest = rest.strip_prefix(b"S").unwrap_or(rest); // a text
    let digits = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
    digits > 0 && rest.get(digits..).unwrap_or_default().trim_ascii_start().starts_with(b"=")
}

/// The name of the cycle that a line calls, and its length there.
fn called(code: &[u8]) -> Option<(String, usize)> {
    if let Some(digits) = function(code) {
        let rest = code.get(1 + DIGITS..).unwrap_or_default();
        // a function of this number with a parameter behind it: no other control writes that
        return is_value(rest.trim_ascii_start()).then(|| (format!("G{digits}"), 1 + DIGITS));
    }
    let behind = code.get(CALL.len()..).filter(|_| begins_with(code, CALL))?;
    let blanks = behind.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
    let number = behind.get(blanks..).unwrap_or_default();
    let length = number.iter().take_while(|byte| byte.is_ascii_digit() || **byte == b'.').count();
    let number = String::from_utf8_lossy(number.get(..length).unwrap_or_default());
    Some((format!("TCH PROBE {number}"), CALL.len() + blanks + length))
}

/// Digits of the function of DIN/ISO with which a line begins, where probe cycles have such numbers.
fn function(code: &[u8]) -> Option<&str> {
    let [b'G' | b'g', b'4', rest @ ..] = code else { return None };
    let ends = !rest.get(DIGITS - 1).is_some_and(u8::is_ascii_alphanumeric);
    let digits = std::str::from_utf8(code.get(1..1 + DIGITS)?).ok()?;
    (ends && digits.bytes().all(|byte| byte.is_ascii_digit())).then_some(digits)
}

/// The parameters in a piece of a line that begins there.
fn values(code: &[u8], at: usize) -> Vec<ForeignValue> {
    let mut found = Vec::new();
    let words = code.split(u8::is_ascii_whitespace).scan(0, |next, word| {
        let start = *next;
        *next += word.len() + 1;
        Some((start, word))
    });
    for (start, word) in words.filter(|(_, word)| is_value(word)) {
        let Some(equals) = word.iter().position(|byte| *byte == b'=') else { continue };
        let value = word.get(equals + 1..).unwrap_or_default();
        let value = value.strip_suffix(b"~").or_else(|| value.strip_suffix(b"*")).unwrap_or(value);
        found.push(ForeignValue {
            name: String::from_utf8_lossy(word.get(..equals).unwrap_or_default()).to_ascii_uppercase(),
            name_span: span(at + start, equals),
            text: String::from_utf8_lossy(value).into_owned(),
            span: span(at + start, equals + 1 + value.len()),
        });
    }
    found
}

fn span(start: usize, length: usize) -> Span {
    let place = |at: usize| u32::try_from(at).unwrap_or(u32::MAX);
    Span { start: place(start), end: place(start + length) }
}
