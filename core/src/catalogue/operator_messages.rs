//! Texts by which the cycles speak to the operator without a number: no alarms. Meaning and what to do are words
//! (`message-new-log`, `.cure`). The text itself is that of the English control.

use super::CYCLES;
use super::alarms::Found;

/// A text on the screen.
pub struct OperatorMessage {
    /// As it is shown.
    pub text: &'static str,
    /// Key of its meaning.
    pub key: &'static str,
    /// Whether the program waits for NC START.
    pub waits: bool,
    /// Whether the simulation shows it.
    pub found: Found,
    /// Who shows it.
    pub sender: Sender,
    /// Place in the manual.
    pub source: &'static str,
}

/// Who shows a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sender {
    /// This program.
    Program(&'static str),
    /// Every measuring cycle.
    EveryCycle,
    /// Measuring in JOG.
    Jog,
}

/// The log goes on in another file.
pub const NEW_LOG: &str = "New log file has been created";
/// No file of the log has room.
pub const LOG_NAME: &str = "Please specify new log name";

/// All of them: the log, the cycles, JOG.
pub static MESSAGES: &[OperatorMessage] = &[
    OperatorMessage {
        found: Found::Run,
        ..shown(NEW_LOG, "message-new-log", Sender::Program("CYCLE106"), "B:11194;A:12504")
    },
    OperatorMessage {
        found: Found::Run,
        ..waiting(shown(LOG_NAME, "message-log-name", Sender::Program("CYCLE106"), "B:11198;A:12510"))
    },
    OperatorMessage {
        found: Found::Run,
        ..waiting(shown(
            "Please acknowledge measurement result screen with NC start",
            "message-result-screen",
            Sender::EveryCycle,
            "B:12574;A:13773",
        ))
    },
    raised(jog(
        "You have corrected in an inactive WO! / You have applied an offset in a non-active ZO!",
        "message-inactive-offset",
        "B:3837;B:3856;A:4457",
    )),
    raised(jog("Activate this work offset? Yes", "message-activate-offset", "B:3838-3839")),
    raised(jog(
        "The work is rotated round the tool axis! Please note when traversing in work! / The WCS is about the ...",
        "message-rotated",
        "B:3840-3843;B:3860",
    )),
    raised(waiting(jog("Please press NC start to activate!", "message-press-start", "B:3864;B:3901"))),
    raised(jog("The new WCS has new orientation!", "message-new-orientation", "B:3895;A:4493")),
    jog("Set probe perpendicular to plane?", "message-perpendicular", "B:3882"),
    jog("Alignment made by swivelling! Retract: Z", "message-aligned", "B:3882-3883"),
    jog("Measuring 4th measuring point exited", "message-fourth-exited", "B:3761-3762"),
    jog("Angle between str. line P1-P2 and 1st axis", "message-angle-line", "B:3706;B:3753"),
];

const fn jog(text: &'static str, key: &'static str, source: &'static str) -> OperatorMessage {
    shown(text, key, Sender::Jog, source)
}

const fn shown(text: &'static str, key: &'static str, sender: Sender, source: &'static str) -> OperatorMessage {
    OperatorMessage { text, key, waits: false, found: Found::Nowhere, sender, source }
}

/// One that the session of measuring in JOG shows.
const fn raised(message: OperatorMessage) -> OperatorMessage {
    OperatorMessage { found: Found::Run, ..message }
}

const fn waiting(message: OperatorMessage) -> OperatorMessage {
    OperatorMessage { waits: true, ..message }
}

/// The message with this text (case does not matter).
pub fn find(text: &str) -> Option<&'static OperatorMessage> {
    MESSAGES.iter().find(|message| message.text.eq_ignore_ascii_case(text))
}

/// Names of who shows it.
pub fn shown_by(message: &OperatorMessage) -> Vec<&'static str> {
    match message.sender {
        Sender::Program(name) => vec![name],
        Sender::Jog => vec!["JOG"],
        Sender::EveryCycle => {
            CYCLES.iter().filter(|cycle| cycle.is_measuring_cycle()).map(|cycle| cycle.name).collect()
        }
    }
}
