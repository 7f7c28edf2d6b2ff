//! What is wrong in a program, without running it.

use super::advice::advice;
use super::block_rules::block_rules;
use super::calls::{CallSite, calls_on};
use super::tree::{Program, SyntaxError};
use crate::catalogue::Dialect;
use crate::control::{Control, delivery};
use crate::diagnostic::Diagnostic;

/// Everything that reading and checking found, in the order of the text, the worst of a place first. The
/// control is a metric one as delivered.
pub fn findings(program: &Program) -> Vec<Diagnostic> {
    findings_on(program, delivery(program.dialect))
}

/// The same for a program that starts on a control in this state.
pub fn findings_on(program: &Program, control: Control) -> Vec<Diagnostic> {
    let sites = calls_on(program, control.clone());
    findings_of(program, &sites, &control)
}

/// The same where the calls of the program on this control are known already.
pub fn findings_of(program: &Program, sites: &[CallSite], control: &Control) -> Vec<Diagnostic> {
    let syntax = program.errors.iter().map(not_understood);
    let blocks = match program.dialect {
        Dialect::Sinumerik => block_rules(program),
        Dialect::Nct => Vec::new(),
    };
    let advice = advice(program, sites, control);
    let calls = sites
        .iter()
        .flat_map(|site| site.diagnostics.iter().cloned());
    let mut found: Vec<Diagnostic> = syntax.chain(blocks).chain(calls).chain(advice).collect();
    found.sort_by_key(|finding| (start(finding), finding.severity));
    once(found)
}

fn start(finding: &Diagnostic) -> u32 {
    finding.span.map_or(0, |span| span.start)
}

/// Each finding once a place: calls that share a value say the same about it, and so do two ways to a call.
fn once(found: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut kept: Vec<Diagnostic> = Vec::with_capacity(found.len());
    for finding in found {
        let place = start(&finding);
        let mut same = kept.iter().rev().take_while(|other| start(other) == place);
        if !same.any(|other| *other == finding) {
            kept.push(finding);
        }
    }
    kept
}

fn not_understood(error: &SyntaxError) -> Diagnostic {
    Diagnostic {
        span: Some(error.span),
        ..error.sentence.finding()
    }
}
