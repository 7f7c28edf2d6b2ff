//! What has to be active at a call.

use super::{Seen, inherited, unsaid, with_line};
use crate::check::{error, warning};
use crate::control::{Control, MachineSort, TOOL_LENGTH_TYPE, delivery_in, probe::Unfit, tools::TURNING};
use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::entry::{Inputs, ProbeUse, names};
use crate::message::Message;
use crate::program::tools::ToolInUse;
use crate::syntax::{Program, Word, WordKind};
use crate::{check, own};
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

/// What was said already and is said once only.
pub struct Asked {
    /// Nothing but assignments and calls: a piece of a program, whose surroundings are elsewhere.
    piece: bool,
    /// Warnings about what the text does not say.
    said: BTreeSet<Code>,
    /// Probes that a call of this program calibrated, or that were asked about.
    calibrated: BTreeSet<(&'static str, i64)>,
}

impl Asked {
    /// Nothing was said of this program yet.
    pub fn of(program: &Program) -> Asked {
        let whole = |word: &Word| {
            let kind = &word.kind;
            matches!(kind, WordKind::Address { .. } | WordKind::Header | WordKind::Keyword { .. })
        };
        let piece = !program.blocks.iter().any(|block| block.plain) && !program.words.iter().any(whole);
        Asked { piece, said: BTreeSet::new(), calibrated: BTreeSet::new() }
    }
}

/// Everything about one call.
pub fn look(seen: &Seen, asked: &mut Asked, found: &mut Vec<Diagnostic>) {
    if !seen.site.cycle.purpose.probe.measures() {
        return;
    }
    let mut say = |finding: Diagnostic| found.push(finding.on(seen.site.span));
    compensation(seen).map(&mut say);
    if !asked.piece {
        unsaid::doubts(seen).filter(|doubt| asked.said.insert(doubt.code)).for_each(&mut say);
        calibration(seen, asked).map(&mut say);
    }
    edge(seen, asked).map(&mut say);
    tool(seen).map(&mut say);
    spindle(seen).map(&mut say);
    inherited::look(seen, found);
}

/// Tool radius compensation has to be off (B:654).
fn compensation(seen: &Seen) -> Option<Diagnostic> {
    let on = seen.force.compensation.is().filter(|on| on.code != 40)?;
    let sentence = if seen.comes_back(on.at) { own::ADVICE_COMPENSATION_PASS } else { own::ADVICE_COMPENSATION };
    let finding = sentence
        .finding()
        .text("word", format!("G{}", on.code))
        .number("line", f64::from(seen.program.line_of(on.at.start) + 1));
    Some(with_line(finding, seen, "G40"))
}

/// Without a D number alarm 61311 comes. Behind a tool change D1 counts, unless the machine is set otherwise.
fn edge(seen: &Seen, asked: &mut Asked) -> Option<Diagnostic> {
    let finding = if seen.force.edge.is() == Some(&0) {
        error(Code::Alarm(61311), Message::new("advice-edge-none")).hint(Message::new("advice-edge-hint"))
    } else if seen.force.edge.unset() && !seen.force.tool.unset() && asked.said.insert(own::ADVICE_EDGE_OPEN.code()) {
        own::ADVICE_EDGE_OPEN.finding()
    } else {
        return None;
    };
    Some(with_line(finding, seen, "D1"))
}

/// The tool in use is none for a milling cycle (B:4147-4152). What others take, their own checks say.
fn tool(seen: &Seen) -> Option<Diagnostic> {
    let tool = milling_probe(seen)?;
    // what the text does not tell the machine may have
    let (unfit, code) = (tool.unfit?, Code::Alarm(61309));
    let (key, hint, open) = match unfit {
        Unfit::Type => ("advice-tool", "advice-tool-hint", false),
        Unfit::Digit => ("advice-tool-digit", "advice-tool-digit-hint", true),
        Unfit::Assignment => {
            let told = seen.control.data.contains_key(TOOL_LENGTH_TYPE);
            ("advice-tool-assignment", "advice-tool-assignment-hint", !told)
        }
        Unfit::Tip => ("advice-tool-position", "advice-tool-position-hint", false),
        Unfit::Plane => ("advice-tool-plane", "advice-tool-plane-hint", seen.force.plane.is().is_none()),
    };
    let message = Message::new(key)
        .number("tool", tool.number as f64)
        .number("type", tool.kind as f64)
        .number("position", tool.tip as f64);
    let finding = if open { warning(code, message) } else { error(code, message) };
    if unfit != Unfit::Plane {
        return Some(finding.hint(Message::new(hint)));
    }
    let plane = plane_of(&tool);
    Some(with_line(finding.hint(Message::new(hint).text("plane", plane)), seen, plane))
}

/// The tool in use where a milling cycle measures a workpiece.
pub fn milling_probe(seen: &Seen) -> Option<ToolInUse> {
    let purpose = &seen.site.cycle.purpose;
    let probed = purpose.probe == ProbeUse::Workpiece && purpose.machine != MachineSort::Turning;
    let known = |tool: &ToolInUse| seen.site.newer_list().is_some() && NEWER_PROBES.contains(&tool.kind);
    seen.tool.filter(|tool| probed && !known(tool))
}

/// The plane on which a probe stands: that of a turning machine G17 or G19 by its position (B:4152).
pub fn plane_of(tool: &ToolInUse) -> &'static str {
    match (TURNING.contains(&tool.kind), tool.tip) {
        (true, 6 | 8) => "G19",
        _ => "G17",
    }
}

/// Types of probes that newer controls know beside these.
const NEWER_PROBES: RangeInclusive<i64> = 712..=714;

/// A probe must not turn.
fn spindle(seen: &Seen) -> Option<Diagnostic> {
    let workpiece = seen.site.cycle.purpose.probe == ProbeUse::Workpiece;
    let milling = seen.site.cycle.purpose.machine == MachineSort::Milling;
    let turns = workpiece && milling && seen.force.turning.is() == Some(&true);
    turns.then(|| with_line(own::ADVICE_SPINDLE.finding(), seen, "M5"))
}

/// Trigger values of a workpiece probe (B:13443-13448).
const TRIGGERS: RangeInclusive<usize> = 1..=6;

/// Workpiece probes of which the machine has trigger values that are not those of the delivery: they were calibrated.
/// Data of a tool probe say nothing, since approximate ones are entered before it is calibrated.
fn on_machine(control: &Control, number: i64) -> bool {
    let delivered = delivery_in(control.dialect, control.basic_units);
    TRIGGERS
        .map(|element| format!("_WP[{},{element}]", number - 1))
        .any(|name| control.number(&name) != delivered.number(&name))
}

/// Whether some workpiece probe of the machine is calibrated: then its data are known, and another one is not.
fn known_machine(control: &Control) -> bool {
    (1..=control.fields("_CVAL[1]").clamp(0.0, 99.0) as i64).any(|number| on_machine(control, number))
}

/// The array and the number of the data in which the probe of a call is calibrated.
fn probe_data(inputs: &Inputs) -> Option<(&'static str, i64)> {
    Some((inputs.cycle.purpose.probe_array(inputs), inputs.any(names::PRNUM)? as i64 % 100))
}

/// Whether the program calibrates this probe anywhere.
fn calibrates(seen: &Seen, probe: (&'static str, i64)) -> bool {
    seen.sites.iter().any(|site| {
        let inputs = check::read(site.cycle, &site.values, seen.control, &mut Vec::new());
        probe_data(&inputs) == Some(probe) && site.cycle.purpose.calibrates.holds(&inputs)
    })
}

/// Trigger values that no call of this program determined come from before (B:5010-5060). Nothing speaks against them
/// unless the program calibrates this probe later, or the machine has other probes calibrated and not this one.
fn calibration(seen: &Seen, asked: &mut Asked) -> Option<Diagnostic> {
    let purpose = &seen.site.cycle.purpose;
    if seen.site.newer_list().is_some() {
        return None; // its probes are calibrated in data that are not here
    }
    let instead = |one: &Diagnostic| one.severity == Severity::Error || one.code == own::TOOL_PROBE_EMPTY.code();
    if seen.site.diagnostics.iter().any(instead) {
        return None; // the call does not measure like this; the next one is asked
    }
    let probe @ (array, number) = probe_data(&seen.inputs)?;
    if !asked.calibrated.insert(probe) || purpose.calibrates.holds(&seen.inputs) {
        return None;
    }
    let machine = seen.control;
    let workpiece = purpose.probe != ProbeUse::Tool;
    let missing = workpiece && known_machine(machine) && !on_machine(machine, number);
    if !missing && (!calibrates(seen, probe) || workpiece && on_machine(machine, number)) {
        return None;
    }
    let finding = own::ADVICE_CALIBRATION.finding().number("number", number as f64);
    Some(finding.text("data", format!("{array}[{},x]", number - 1)))
}
