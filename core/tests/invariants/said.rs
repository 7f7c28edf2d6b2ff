//! What a measurement says of a correction, a repetition or a stop happens, with every combination of the data that
//! decide over it; what it says not to happen does not.

use super::draw::{Drawn, measuring, some};
use super::stand::stand;
use probewright_core::control::Control;
use probewright_core::diagnostic::Code;
use probewright_core::machine::trace::Step;
use probewright_core::message::Message;
use probewright_core::run::Outcome;
#[cfg(feature = "cli")]
use probewright_core::words::Words;
use std::collections::BTreeSet;

/// By how much more wrong than drawn a part is, so that differences end everywhere in the chain.
const SCALES: [f64; 5] = [0.03, 0.1, 1.0, 8.0, 12.0];
/// Data that decide what follows from a difference.
const DECIDING: [&str; 7] = ["_CBIT[0]", "_CBIT[1]", "_CBIT[2]", "_CHBIT[3]", "_CHBIT[4]", "_CHBIT[10]", "_CHBIT[11]"];

/// What a decision says of the correction.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Said {
    /// A target is corrected next.
    Corrected,
    /// No target is corrected until the next decision.
    Nothing,
    /// A frame was corrected before.
    FrameCorrected,
    /// The next step sets a mean value memory to 0.
    Restarts,
    /// The measurement is repeated.
    Repeated,
    /// The program waits.
    Halt,
    /// None of these.
    Other,
}

/// What a decision says, by its key; `evaluate-corrects-…` is an argument of others.
// oracle: hand (read off the English sentences)
fn said(message: &Message) -> Said {
    match message.word("follows").unwrap_or(&message.key) {
        "evaluate-corrects-whole" | "evaluate-corrects-both" | "evaluate-corrects-mean" => Said::Corrected,
        "evaluate-tool-geometry" | "evaluate-tool-wear" => Said::Corrected,
        "evaluate-corrects-nothing" | "evaluate-corrects-zero" | "evaluate-corrects-simulated" => Said::Nothing,
        "evaluate-tool-simulated" => Said::Nothing,
        "evaluate-safe-area" | "evaluate-safe-area-angle" | "evaluate-difference" | "evaluate-small" => Said::Nothing,
        "evaluate-tool-safe-area" | "evaluate-tool-difference" | "evaluate-tool-small" => Said::Nothing,
        "evaluate-activated" | "evaluate-not-activated" => Said::FrameCorrected,
        "evaluate-restarts" => Said::Restarts,
        "evaluate-repeat" => Said::Repeated,
        "evaluate-halt" | "evaluate-screen-halt" => Said::Halt,
        _ => Said::Other,
    }
}

/// Whether a step changes a tool, a frame or the data of a probe.
fn corrects(step: &Step) -> bool {
    let target = |name: &str| ["$TC_", "$P_", "_WP[", "_TP[", "_TPW["].iter().any(|stem| name.starts_with(stem));
    matches!(step, Step::Set { name, before, after } if target(name) && before != after)
}

/// Whether a step says something of the correction, or begins the measurement again.
fn ends(step: &Step) -> bool {
    matches!(step, Step::Decision { message } if !matches!(said(message), Said::Other | Said::Restarts | Said::Halt))
}

/// A decision of which nothing is held speaks of no correction.
#[cfg(feature = "cli")]
fn silent(message: &Message) {
    let known = said(message) != Said::Other || message.key == "evaluate-distortion"; // its limit, whatever follows
    assert!(known || !Words::english().text(message).contains("corrected"), "{message:?}");
}

#[cfg(not(feature = "cli"))]
fn silent(_: &Message) {}

/// Whether what the decision at this index says happens.
fn holds(steps: &[&Step], at: usize, message: &Message, control: &Control) -> bool {
    let bit = |name: &str| control.bit(name);
    let behind = || steps[at + 1..].iter().take_while(|step| !ends(step));
    match said(message) {
        Said::Corrected => behind().any(|step| corrects(step)),
        Said::Nothing => !behind().any(|step| corrects(step)),
        Said::FrameCorrected => steps[..at].iter().rev().take_while(|step| !ends(step)).any(|step| corrects(step)),
        Said::Restarts => {
            let name = message.word("name");
            matches!(steps.get(at + 1), Some(Step::Set { name: set, after: 0.0, .. }) if Some(set.as_str()) == name)
        }
        // an alarm ends a repetition that cannot begin
        Said::Repeated => bit("_CBIT[0]") && behind().any(|step| matches!(step, Step::Motion { .. } | Step::Alarm(_))),
        Said::Halt if message.key == "evaluate-screen-halt" => bit("_CHBIT[10]") && bit("_CHBIT[11]"),
        // B:13572-13586: before a repetition, or behind the alarms over a size
        Said::Halt => match (steps[at - 1], steps.get(at + 1)) {
            (_, Some(Step::Decision { message })) if said(message) == Said::Repeated => bit("_CBIT[1]"),
            (Step::Alarm(Code::Alarm(62304..=62306)), _) => bit("_CBIT[2]"),
            _ => false,
        },
        Said::Other => true,
    }
}

/// The measurement with the data that decide as the bits of a number say, and its part so many times as wrong.
fn carried_out(drawn: &Drawn, scale: f64, bits: usize) -> Option<(Control, Outcome)> {
    let mut drawn = drawn.clone();
    drawn.machine.bits.retain(|name| !DECIDING.contains(name));
    drawn.part.shift = drawn.part.shift.map(|shift| shift * scale);
    drawn.part.size *= scale;
    let mut stand = stand(&drawn).ok()?;
    for (index, name) in DECIDING.into_iter().enumerate() {
        stand.setup.control.set(name, f64::from(u8::from(bits >> index & 1 == 1)));
    }
    let outcome = stand.run();
    Some((stand.setup.control, outcome))
}

// oracle: manual B:1286-1390 (chain), B:13534-13541 and B:13841 (bits), B:1914 and B:1932 (_KNUM=0)
#[test]
fn what_a_decision_says_happens() {
    let mut seen = BTreeSet::new();
    for (cycle, variant) in measuring().flat_map(|cycle| cycle.variants.iter().map(move |variant| (cycle, variant))) {
        for (index, drawn) in some(cycle, variant.number, 3 * SCALES.len()).into_iter().enumerate() {
            let bits = 37 * index + variant.number as usize; // 37: no power of two, so that all bits change
            let Some((control, outcome)) = carried_out(&drawn, SCALES[index % SCALES.len()], bits) else { continue };
            let entries = outcome.trace.entries.to_vec();
            let steps: Vec<&Step> = entries.iter().map(|entry| &entry.step).collect();
            for (at, step) in steps.iter().enumerate() {
                let Step::Decision { message } = step else { continue };
                silent(message);
                let key = message.word("follows").unwrap_or(&message.key).to_owned();
                assert!(holds(&steps, at, message, &control), "{message:?}: {drawn:?}, {bits}, {:?}", &steps[at..]);
                seen.insert(key);
            }
        }
    }
    let wanted = ["evaluate-corrects-whole", "evaluate-corrects-both", "evaluate-corrects-mean"].into_iter();
    let wanted = wanted.chain(["evaluate-corrects-nothing", "evaluate-restarts", "evaluate-small", "evaluate-halt"]);
    let wanted = wanted.chain(["evaluate-difference", "evaluate-safe-area", "evaluate-repeat", "evaluate-activated"]);
    let wanted = wanted.chain(["evaluate-tool-safe-area", "evaluate-tool-difference", "evaluate-tool-small"]);
    let wanted = wanted.chain(["evaluate-tool-geometry", "evaluate-tool-wear", "evaluate-screen-halt"]);
    assert_eq!(wanted.filter(|key| !seen.contains(*key)).collect::<Vec<_>>(), Vec::<&str>::new());
}
