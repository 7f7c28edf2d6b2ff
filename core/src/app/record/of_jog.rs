//! What a session of measuring in JOG measured, as calls of the record: one each time results come to the screen or an
//! alarm does.

use super::{Probes, amid};
use crate::app::answer::{Answer, Correction, Figure, Verdict, corrected};
use crate::app::jog::JogLine;
use crate::app::run::{OfCall, RunAnswer};
use crate::jog::Session;
use crate::jog::mask::Task;
use crate::jog::settings::{Settings, TOOL_PROBE};
use crate::machine::Setup;
use crate::machine::calibrated::ProbeInCall;
use crate::message::Message;

/// Follows a session line by line.
pub struct Recorder<'a> {
    probes: Probes<'a>,
    /// Index of the entry of the trace behind the last measurement.
    since: usize,
    /// What was measured so far.
    pub calls: Vec<RunAnswer>,
}

impl<'a> Recorder<'a> {
    /// Before the first line.
    pub fn new(setup: &'a Setup) -> Recorder<'a> {
        Recorder { probes: Probes::new(setup), since: 0, calls: Vec::new() }
    }

    /// Notes what a line did. `from`: index of its first entry of the trace.
    pub fn follow(&mut self, session: &Session, line: &JogLine, from: usize) {
        let entries = &session.sim.trace.entries;
        let written = corrected(&entries.behind(from).collect::<Vec<_>>(), &session.sim.control);
        let Some(mask) = session.mask().filter(|_| !line.results.is_empty() || line.raised.is_some()) else {
            if let Some(last) = self.calls.last_mut() {
                last.answer.corrected.extend(written); // the activation screen writes later
            }
            return;
        };
        let (field, mono) = Settings::of(&session.sim.control).probe;
        let tool = mask.task.of_tool();
        let used = ProbeInCall { field, mono, measures: !tool };
        let calibrates = matches!(mask.task, Task::Length | Task::Ring | Task::ToolProbe);
        let number = if tool { session.sim.control.number(TOOL_PROBE) as i64 } else { field };
        let own: Vec<_> = entries.behind(self.since).collect();
        let count = entries.len();
        self.calls.push(RunAnswer {
            answer: answer(line, written),
            call: OfCall { line: Some(line.line), cycle: None },
            probe: self.probes.next(used, (tool, number), calibrates, Some(line.line), line.raised.is_none()),
            alarms: line.raised.iter().map(|raised| raised.code.clone()).filter(|code| !code.is_empty()).collect(),
            place: amid(&own),
            from: self.since,
            to: count.saturating_sub(1),
        });
        self.since = count;
    }
}

/// Nothing limits what is measured by hand.
fn answer(line: &JogLine, written: Vec<Correction>) -> Answer {
    let figures = line.results.iter().map(|result| Figure {
        name: result.name,
        label: result.label.clone(),
        heading: result.label.clone(),
        symbol: String::new(),
        actual: result.value,
        set: None,
        deviation: None,
        unit: result.unit,
        limits: None,
    });
    let stopped = line.raised.as_ref();
    let verdict = match stopped {
        Some(raised) if raised.code.is_empty() => Verdict::Stopped,
        Some(_) => Verdict::Alarm,
        None => Verdict::Measured,
    };
    let words = Message::new(verdict.key());
    let code = stopped.map(|raised| raised.code.clone()).filter(|code| !code.is_empty());
    Answer {
        screen: None,
        feature: line.mask.clone().unwrap_or_else(|| Message::new("report-jog")),
        figures: figures.collect(),
        corrected: written,
        gauge: None,
        verdict,
        verdict_words: code.iter().fold(words, |words, code| words.text("code", code)),
        alarm: code,
        why: stopped.map_or_else(|| Message::new("answer-why-measured"), |raised| raised.message.clone()),
    }
}
