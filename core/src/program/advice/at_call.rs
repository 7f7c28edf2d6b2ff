//! What has to be in force at a call.

use super::{Seen, at, inherited, unsaid, with_line};
use crate::catalogue::{MachineSort, ProbeUse, names};
use crate::check::error;
use crate::control::tools::is_milling_probe;
use crate::control::{Control, delivery_in};
use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::message::Message;
use crate::own;
use crate::program::tree::{Program, Word, WordKind};
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

/// What was said already and is said once only.
pub struct Asked {
    /// Nothing but assignments and calls: a piece of a program, whose surroundings are elsewhere.
    piece: bool,
    /// Doubts about what the text does not say.
    said: BTreeSet<Code>,
    /// Probes that a call of this program calibrated, or that were asked about.
    calibrated: BTreeSet<(bool, i64)>,
}

impl Asked {
    /// Nothing was said of this program yet.
    pub fn of(program: &Program) -> Asked {
        let whole = |word: &Word| {
            let kind = &word.kind;
            matches!(
                kind,
                WordKind::Address { .. } | WordKind::Header(_) | WordKind::Keyword { .. }
            )
        };
        Asked {
            piece: !program.words.iter().any(whole),
            said: BTreeSet::new(),
            calibrated: BTreeSet::new(),
        }
    }
}

/// Everything about one call.
pub fn look(seen: &Seen, asked: &mut Asked, found: &mut Vec<Diagnostic>) {
    if !seen.site.cycle.purpose.probe.measures() {
        return;
    }
    let mut say = |finding: Diagnostic| found.push(at(finding, seen.site.span));
    compensation(seen).map(&mut say);
    if !asked.piece {
        for finding in unsaid::doubts(seen) {
            if asked.said.insert(finding.code) {
                say(finding);
            }
        }
        calibration(seen, asked).map(&mut say);
    }
    edge(seen).map(&mut say);
    tool(seen).map(&mut say);
    spindle(seen).map(&mut say);
    inherited::look(seen, found);
}

/// Tool radius compensation has to be off (B:654).
fn compensation(seen: &Seen) -> Option<Diagnostic> {
    let on = seen.force.compensation.is().filter(|on| on.code != 40)?;
    let sentence = if seen.comes_back(on.at) {
        own::ADVICE_COMPENSATION_PASS
    } else {
        own::ADVICE_COMPENSATION
    };
    let finding = sentence
        .finding()
        .text("word", format!("G{}", on.code))
        .number("line", f64::from(seen.program.line_of(on.at.start) + 1));
    Some(with_line(finding, seen, "G40"))
}

/// Without a D number alarm 61311 comes.
fn edge(seen: &Seen) -> Option<Diagnostic> {
    let finding = if seen.force.edge.is() == Some(&0) {
        error(Code::Alarm(61311), Message::new("advice-edge-none"))
            .hint(Message::new("advice-edge-hint"))
    } else if seen.force.edge.unset() && !seen.force.tool.unset() {
        own::ADVICE_EDGE_OPEN.finding()
    } else {
        return None;
    };
    Some(with_line(finding, seen, "D1"))
}

/// The tool in use of a milling machine is no probe (B:4147-4152). What lathes and tool probes take, their own checks say.
fn tool(seen: &Seen) -> Option<Diagnostic> {
    let purpose = &seen.site.cycle.purpose;
    let probed = purpose.probe == ProbeUse::Workpiece && purpose.machine != MachineSort::Turning;
    let tool = seen.tool.filter(|_| probed)?;
    if is_milling_probe(tool.kind) {
        return None;
    }
    let message = Message::new("advice-tool")
        .number("tool", tool.number as f64)
        .number("type", tool.kind as f64);
    Some(error(Code::Alarm(61309), message).hint(Message::new("advice-tool-hint")))
}

/// A probe must not turn.
fn spindle(seen: &Seen) -> Option<Diagnostic> {
    let workpiece = seen.site.cycle.purpose.probe == ProbeUse::Workpiece;
    let milling = seen.site.cycle.purpose.machine == MachineSort::Milling;
    if !(workpiece && milling && seen.force.turning.is() == Some(&true)) {
        return None;
    }
    let finding = own::ADVICE_SPINDLE.finding();
    Some(with_line(finding, seen, "M5"))
}

/// Trigger values of a workpiece probe (B:13443-13448).
const TRIGGERS: RangeInclusive<usize> = 1..=6;

/// Whether the machine has trigger values of this workpiece probe that are not those of the delivery: it was calibrated.
/// Those of a tool probe say nothing, since approximate ones are entered before it is calibrated.
fn on_machine(control: &Control, number: i64) -> bool {
    let delivered = delivery_in(control.dialect, control.basic_units);
    TRIGGERS
        .map(|element| format!("_WP[{},{element}]", number - 1))
        .any(|name| control.number(&name) != delivered.number(&name))
}

/// Trigger values that no call of this program determined come from before (B:5010-5060).
fn calibration(seen: &Seen, asked: &mut Asked) -> Option<Diagnostic> {
    let purpose = &seen.site.cycle.purpose;
    let told = seen.site.diagnostics.iter();
    let mut instead = told
        .filter(|one| one.severity == Severity::Error || one.code == own::TOOL_PROBE_EMPTY.code());
    if instead.next().is_some() {
        return None; // the call does not measure like this; the next one is asked
    }
    let number = seen.inputs.given(names::PRNUM)? as i64 % 100;
    let probe = (purpose.probe == ProbeUse::Tool, number);
    let known = !asked.calibrated.insert(probe);
    if known || purpose.calibrates.holds(&seen.inputs) {
        return None;
    }
    if !probe.0 && on_machine(seen.control, number) {
        return None;
    }
    let array = if probe.0 { "_TP" } else { "_WP" };
    Some(
        own::ADVICE_CALIBRATION
            .finding()
            .number("number", number as f64)
            .text("data", format!("{array}[{},x]", number - 1)),
    )
}
