//! An alarm as a person reads it, for the terminal and for `docs/alarms.md`.

use crate::app::AlarmInfo;
use crate::catalogue::alarms::{ALARMS, Alarm, Found, Waits, stops};
use crate::catalogue::operator_messages::{MESSAGES, OperatorMessage, Sender};
use crate::catalogue::{CYCLES, alarms, newer, operator_messages};
use crate::diagnostic::Code;
use crate::entry::{Cycle, ProbeUse};
use crate::manual::Cited;
use crate::message::Message;
use crate::report::markdown::line;
use crate::report::said;
use crate::words::Words;

/// What the words say about an alarm.
pub struct Told {
    /// `61303`, `FORMAT ERROR`.
    pub code: String,
    /// What it means.
    pub meaning: String,
    /// Why it comes, where the meaning does not say it already.
    pub cause: Option<String>,
    /// What to do.
    pub cure: String,
    /// What the control does.
    pub effect: String,
    /// Cycles and programs that raise it.
    pub sources: String,
    /// When Probewright detects it.
    pub found: String,
    /// What a newer control says instead.
    pub newer: Option<String>,
    /// Place in the manual.
    pub source: Cited,
}

/// All alarms, then all texts for the operator, in words.
pub fn all(words: &Words) -> impl Iterator<Item = Told> {
    let messages = MESSAGES.iter().map(move |message| told_message(message, words));
    ALARMS.iter().map(move |alarm| told_alarm(alarm, words)).chain(messages)
}

/// The alarm or text with this name in words.
pub fn named(name: &str, words: &Words) -> Option<Told> {
    let alarm = alarms::find(name).map(|alarm| told_alarm(alarm, words));
    alarm.or_else(|| operator_messages::find(name).map(|message| told_message(message, words)))
}

/// What a newer control says about an alarm of this number, also about one that the older control does not have.
pub fn of_newer(code: &str, words: &Words) -> Option<String> {
    newer::alarms::key(code).map(|key| words.key(key))
}

fn told_alarm(alarm: &Alarm, words: &Words) -> Told {
    let mut measuring = CYCLES.iter().filter(|cycle| cycle.is_measuring_cycle());
    let by_every_cycle = measuring.all(|cycle| cycle.alarms().contains(&alarm.code));
    told(AlarmInfo::of(alarm), effect(alarm, words), by_every_cycle, words)
}

fn told_message(message: &OperatorMessage, words: &Words) -> Told {
    let effect = if message.waits { "effect-start" } else { "effect-shown" };
    told(AlarmInfo::of_message(message), words.key(effect), message.sender == Sender::EveryCycle, words)
}

/// What every measuring cycle raises does not name each of them.
fn told(info: AlarmInfo, effect: String, by_every_cycle: bool, words: &Words) -> Told {
    let AlarmInfo { code, key, cycles, found, source, .. } = info;
    Told {
        newer: of_newer(&code, words),
        code,
        cause: words.find(&Message::new(format!("{key}.cause"))),
        cure: words.key(format!("{key}.cure")),
        meaning: words.key(key),
        effect,
        sources: if by_every_cycle { words.key("alarms-every-cycle") } else { cycles.join(", ") },
        found: words.key(found_key(found)),
        source,
    }
}

/// What the control does. Cycles that only compute hand the number back, and nothing stops (B:2448).
fn effect(alarm: &Alarm, words: &Words) -> String {
    let (computing, others): (Vec<&&Cycle>, Vec<&&Cycle>) = CYCLES
        .iter()
        .filter(|cycle| cycle.alarms().contains(&alarm.code))
        .partition(|cycle| cycle.purpose.probe == ProbeUse::None);
    let names: Vec<&str> = computing.iter().map(|cycle| cycle.name).collect();
    let returned = Message::new("effect-returned").text("cycles", names.join(", "));
    let raised = !others.is_empty() || names.is_empty() || !alarm.programs.is_empty();
    let raised = raised.then(|| words.key(effect_key(alarm)));
    let returned = (!names.is_empty()).then(|| words.text(&returned));
    [raised, returned].into_iter().flatten().collect::<Vec<_>>().join(" ")
}

/// Key of what the control does.
fn effect_key(alarm: &Alarm) -> &'static str {
    match (alarm.waits, alarm.code) {
        (Waits::BeforeRepetition, _) => "effect-repeat",
        (Waits::WithCbit2, _) => "effect-tolerance",
        (Waits::WithCbit2OrBeforeRepetition, _) => "effect-difference",
        (Waits::Always, _) => "effect-start",
        (Waits::Never, Code::Nct(_)) => "effect-abort",
        (Waits::Never, code) if stops(code) => "effect-reset",
        (Waits::Never, _) => "effect-message",
    }
}

/// Key of when Probewright detects it.
fn found_key(found: Found) -> &'static str {
    match found {
        Found::Check => "found-check",
        Found::Run => "found-run",
        Found::Both => "found-both",
        Found::Nowhere => "found-nowhere",
    }
}

/// The page of all alarms, Markdown: a section each.
pub fn page(words: &Words) -> String {
    let mut text = String::new();
    line(&mut text, &format!("# {}", words.key("report-alarms")));
    line(&mut text, &words.key("alarms-intro"));
    line(&mut text, &words.key("report-generated"));
    all(words).for_each(|told| section(&mut text, told, words));
    text.pop();
    text
}

fn section(text: &mut String, told: Told, words: &Words) {
    line(text, &format!("## {}", told.code));
    let cause = told.cause.map_or(String::new(), |cause| format!(" {cause}"));
    line(text, &format!("**{}**{cause}", told.meaning));
    line(text, &told.cure);
    line(text, &told.effect);
    let raised = [("cycles", told.sources), ("found", told.found), ("source", told.source.to_string())];
    line(text, &said(words, "report-raised", &raised));
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::report::held;

    // oracle: self. With PROBEWRIGHT_UPDATE=1 the page is written instead.
    #[test]
    fn the_pages_in_docs_are_those_of_the_catalogue() {
        held("alarms.md", page);
    }

    // oracle: self
    #[test]
    fn every_alarm_has_a_cure_and_words_without_gaps() {
        let words = Words::english();
        for told in all(&words) {
            let key = &told.code;
            for text in [&told.meaning, &told.cure, &told.effect, &told.found] {
                assert!(text.contains(' ') && !text.contains("{$"), "{key}: {text}");
            }
            assert_ne!(told.cause.as_ref(), Some(&told.meaning), "{key}");
        }
    }

    // oracle: self
    #[test]
    fn every_message_of_the_macros_has_a_cause() {
        for words in ["en", "zh"].map(|code| Words::of(code).unwrap()) {
            for alarm in ALARMS {
                let told = told_alarm(alarm, &words);
                let macros = matches!(alarm.code, Code::Nct(_));
                assert!(!macros || told.cause.is_some(), "{}", told.code);
            }
        }
    }
}
