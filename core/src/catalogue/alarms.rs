//! Every alarm of the measuring cycles, and the messages of the NCT macros that the catalogue has: what stops, who
//! raises it, and whether Probewright finds it. Meaning, cause and cure are words (`alarm-61303`, `.cause`, `.cure`).

use super::{CYCLES, nct, p9920};
use crate::control::{Control, GENERATION};
use crate::diagnostic::Code;
use Found::{Both, Check, Nowhere, Run};
use Waits::{Always, BeforeRepetition, Never, WithCbit2, WithCbit2OrBeforeRepetition};

/// An alarm or message. Those from 61000 to 61999 end the cycle and wait for NC RESET, those from 62000 to 62999 are
/// only shown and cleared by a key (B:15225-15236); what they mean is listed at B:15242.
pub struct Alarm {
    /// Number, or text of the message.
    pub code: Code,
    /// What Probewright does about it.
    pub found: Found,
    /// When a program that goes on waits for NC START first.
    pub waits: Waits,
    /// Programs beside the cycles of the catalogue that raise it: helpers of the cycles, measuring in JOG.
    pub programs: &'static [&'static str],
    /// Place in the manual.
    pub source: &'static str,
}

/// Where Probewright finds what raises an alarm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Found {
    /// While the call is written or the program is checked.
    Check,
    /// When the program runs on the simulated machine.
    Run,
    /// Both.
    Both,
    /// Nothing raises it yet.
    Nowhere,
}

/// When a program that goes on after an alarm waits for NC START first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Waits {
    /// Never, or it does not go on.
    Never,
    /// Always: an operator message of the NCT macros (C:1139-1145).
    Always,
    /// Before each repetition of a measurement (B:13535-13580).
    BeforeRepetition,
    /// With `_CBIT[2]` (B:13537, B:13584-13586).
    WithCbit2,
    /// With `_CBIT[2]`, and before each repetition.
    WithCbit2OrBeforeRepetition,
}

const NONE: &[&str] = &[];
/// Measuring tools in JOG.
const JOG: &[&str] = &["E_MT_CAL", "E_MT_RAD", "E_MT_LEN"];

/// All of them, SINUMERIK by number, then NCT.
pub static ALARMS: &[Alarm] = &[
    alarm(61016, Run, NONE, "A:15840"),
    alarm(61230, Run, JOG, "A:15841"),
    alarm(61301, Run, NONE, "A:15842"),
    alarm(61302, Both, NONE, "A:15843"),
    alarm(61303, Both, NONE, "A:15844"),
    alarm(61306, Nowhere, NONE, "A:15845"),
    alarm(61307, Both, NONE, "A:15846"),
    alarm(61308, Both, NONE, "A:15847"),
    alarm(61309, Both, NONE, "A:15848"),
    alarm(61310, Run, NONE, "A:15849"),
    alarm(61311, Both, NONE, "A:15850"),
    alarm(61312, Nowhere, NONE, "A:15851"),
    alarm(61313, Both, NONE, "A:15852"),
    alarm(61314, Both, NONE, "A:15855"),
    alarm(61315, Both, NONE, "A:15856"),
    alarm(61316, Both, NONE, "A:15857"),
    alarm(61317, Check, NONE, "A:15858"),
    alarm(61318, Both, NONE, "A:15859"),
    alarm(61319, Nowhere, NONE, "A:15860"),
    alarm(61320, Both, NONE, "A:15861"),
    alarm(61321, Both, NONE, "A:15862"),
    alarm(61322, Both, &["CYCLE114"], "A:15863"),
    alarm(61323, Both, &["CYCLE114"], "A:15864"),
    alarm(61324, Both, &["CYCLE114"], "A:15865"),
    alarm(61325, Both, NONE, "A:15866"),
    alarm(61326, Both, NONE, "A:15867"),
    alarm(61327, Nowhere, NONE, "A:15868"),
    alarm(61328, Both, NONE, "A:15871"),
    alarm(61329, Both, NONE, "A:15872"),
    alarm(61330, Both, NONE, "A:15873"),
    alarm(61331, Both, NONE, "A:15874"),
    alarm(61332, Run, JOG, "A:15875"),
    alarm(61333, Both, NONE, "A:15876"),
    alarm(61334, Both, NONE, "A:15877"),
    alarm(61336, Run, NONE, "A:15878"),
    alarm(61338, Both, NONE, "A:15879"),
    alarm(61339, Both, NONE, "A:15880"),
    alarm(61340, Nowhere, NONE, "A:15881"),
    alarm(61341, Run, NONE, "A:15882"),
    alarm(61342, Run, NONE, "A:15883"),
    alarm(61343, Run, NONE, "A:15886"),
    alarm(61344, Nowhere, NONE, "A:15887"),
    alarm(61345, Both, NONE, "A:15888"),
    alarm(61346, Both, NONE, "A:15889"),
    alarm(61347, Both, NONE, "A:15890"),
    alarm(61349, Both, NONE, "A:15891"),
    alarm(61350, Both, NONE, "A:15892"),
    alarm(61351, Both, NONE, "A:15893"),
    alarm(61352, Both, NONE, "A:15894"),
    alarm(61353, Nowhere, NONE, "A:15895"),
    alarm(61354, Both, NONE, "A:15896"),
    alarm(61355, Both, NONE, "A:15897"),
    alarm(61356, Run, NONE, "A:15898"),
    alarm(61357, Nowhere, NONE, "A:15899"),
    alarm(61358, Nowhere, NONE, "A:15900"),
    alarm(61359, Nowhere, NONE, "A:15901"),
    alarm(61360, Both, NONE, "A:15902"),
    alarm(61361, Both, NONE, "A:15903"),
    alarm(61362, Both, NONE, "A:15904"),
    alarm(61363, Both, NONE, "A:15907"),
    alarm(61364, Both, NONE, "A:15908"),
    alarm(61365, Both, NONE, "A:15909"),
    alarm(61366, Both, NONE, "A:15910"),
    alarm(61367, Both, NONE, "A:15911"),
    alarm(61368, Both, NONE, "A:15912"),
    alarm(61369, Both, NONE, "A:15913"),
    alarm(61370, Both, NONE, "A:15914"),
    alarm(61371, Both, NONE, "A:15915"),
    alarm(61372, Both, NONE, "A:15916"),
    alarm(61373, Both, NONE, "A:15917"),
    alarm(61401, Run, NONE, "A:15920"),
    alarm(61402, Run, NONE, "A:15921"),
    alarm(61403, Nowhere, NONE, "A:15922"),
    alarm(61404, Nowhere, NONE, "A:15923"),
    alarm(61405, Run, NONE, "A:15924"),
    alarm(61406, Both, NONE, "A:15925"),
    alarm(61407, Both, NONE, "A:15926"),
    alarm(61408, Both, NONE, "A:15927"),
    alarm(61409, Both, NONE, "A:15928"),
    alarm(61410, Run, NONE, "A:15929"),
    alarm(61411, Both, NONE, "A:15930"),
    alarm(61412, Run, NONE, "A:15931"),
    alarm(61413, Both, NONE, "A:15932"),
    alarm(61414, Run, NONE, "A:15933"),
    alarm(61415, Both, NONE, "A:15934"),
    alarm(61416, Run, NONE, "A:15935"),
    waiting(BeforeRepetition, alarm(62303, Run, NONE, "A:15940")),
    waiting(WithCbit2, alarm(62304, Run, NONE, "A:15941")),
    waiting(WithCbit2, alarm(62305, Run, NONE, "A:15942")),
    waiting(WithCbit2OrBeforeRepetition, alarm(62306, Run, NONE, "A:15943")),
    alarm(62307, Both, NONE, "A:15944"),
    alarm(62308, Both, NONE, "A:15945"),
    alarm(62309, Both, NONE, "A:15946"),
    alarm(62310, Both, NONE, "A:15947"),
    alarm(62311, Run, NONE, "A:15948"),
    message(nct::FORMAT_ERROR, Both, "C:195-204;C:1123-1137"),
    message(nct::NO_TOOL_LENGTH, Run, "C:125-132;C:195-204"),
    message(nct::STYLUS_IN_CONTACT, Run, "C:125-132;C:195-204"),
    message(nct::PATH_OBSTRUCTED, Run, "C:125-132"),
    message(nct::FALSE_TRIGGER, Run, "C:125-132;C:195-204"),
    message(nct::OUT_OF_POSITION, Run, "C:121-123;C:195-204"),
    message(nct::PROBE_FAIL, Run, "C:195-204"),
    message(nct::NO_MOVEMENT, Both, "C:195-204"),
    waiting(Always, message(nct::OUT_OF_TOLERANCE, Run, "C:1142")),
    waiting(Always, message(nct::UPPER_TOLERANCE, Run, "C:1143")),
    waiting(Always, message(nct::TOOL_TOO_LARGE, Run, "C:1144")),
    message(p9920::MEASURING_DEVICE, Run, "C:1204"),
    message(p9920::DEPRESSED, Run, "C:1204"),
    message(p9920::TOO_SMALL, Run, "C:1224;C:1245"),
    message(p9920::INCORRECT, Run, "C:1224;C:1245"),
    message(nct::SCANNING_OBSTRUCTED, Run, "C:1338"),
    message(nct::SCANNING_FAIL, Run, "C:1339"),
];

const fn alarm(number: u32, found: Found, programs: &'static [&'static str], source: &'static str) -> Alarm {
    Alarm { code: Code::Alarm(number), found, waits: Never, programs, source }
}

const fn message(code: Code, found: Found, source: &'static str) -> Alarm {
    Alarm { code, found, waits: Never, programs: NONE, source }
}

const fn waiting(waits: Waits, alarm: Alarm) -> Alarm {
    Alarm { waits, ..alarm }
}

/// The alarm with this number, or the message with this text (case does not matter).
pub fn find(text: &str) -> Option<&'static Alarm> {
    let number = text.parse().ok().map(Code::Alarm);
    ALARMS.iter().find(|alarm| match alarm.code {
        Code::Nct(message) => message.eq_ignore_ascii_case(text),
        code => Some(code) == number,
    })
}

/// Who raises it: the cycles of the catalogue, then other programs.
pub fn raised_by(alarm: &Alarm) -> Vec<&'static str> {
    let cycles = CYCLES.iter().filter(|cycle| cycle.alarms().contains(&alarm.code));
    cycles.map(|cycle| cycle.name).chain(alarm.programs.iter().copied()).collect()
}

/// Key of an alarm's words: `alarm-61303`, `nct-format-error`, `pw012`.
pub fn key(alarm: Code) -> String {
    match alarm {
        Code::Alarm(number) => format!("alarm-{number}"),
        Code::Nct(text) => {
            let words: String =
                text.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' }).collect();
            format!("nct-{}", words.trim_end_matches('-'))
        }
        Code::Own(number) => format!("pw{number:03}"),
    }
}

/// Key of the remedy of an alarm on this control: a newer one has other data.
pub fn cure(alarm: Code, control: &Control) -> String {
    newer_cure(&alarm.to_string(), control).unwrap_or_else(|| format!("{}.cure", key(alarm)))
}

/// Key of the remedy that only a control of the second or third generation has.
pub fn newer_cure(code: &str, control: &Control) -> Option<String> {
    super::newer::alarms::key(code).filter(|_| control.number(GENERATION) > 1.0)
}

/// Whether the program cannot go on. A 61xxx stops it until NC RESET, a 62xxx is a message that the clear key takes
/// away (A:15840-15948); the operator messages of the NCT macros go on with START (C:1139-1145).
pub fn stops(code: Code) -> bool {
    match code {
        Code::Alarm(number) => number < 62000,
        Code::Nct(_) => ALARMS.iter().all(|alarm| alarm.code != code || alarm.waits == Never),
        Code::Own(_) => true,
    }
}
