//! What a mask says to who stands before it: what it measures, where the probe is before NC start, what happens then,
//! what is written, what goes wrong; and the alarms that can come. A mask has its own lines, those of many are here.

use super::mask::{Element, Mask, Task};
use crate::catalogue::alarms;
use crate::diagnostic::Code;
use crate::entry::{ProbeUse, SECTIONS, Section};
use crate::message::Message;

/// A sentence or two.
#[derive(Debug)]
pub struct Line {
    /// Where it stands.
    pub section: Section,
    /// Key of its words: `jog-help-…`.
    pub key: &'static str,
    /// Place in the manual.
    pub source: &'static str,
}

/// What it measures.
pub(super) const fn measures(key: &'static str, source: &'static str) -> Line {
    Line { section: Section::Measures, key, source }
}

/// Where the probe or the tool is before NC start.
pub(super) const fn before(key: &'static str, source: &'static str) -> Line {
    Line { section: Section::Before, key, source }
}

/// What happens, in order.
pub(super) const fn order(key: &'static str, source: &'static str) -> Line {
    Line { section: Section::Order, key, source }
}

/// What is written.
pub(super) const fn corrects(key: &'static str, source: &'static str) -> Line {
    Line { section: Section::Corrects, key, source }
}

/// What goes wrong.
pub(super) const fn wrong(key: &'static str, source: &'static str) -> Line {
    Line { section: Section::Wrong, key, source }
}

/// A probe that was calibrated.
const CALIBRATED: &[Line] = &[
    before("jog-help-probe-before", "B:2985;B:3003"),
    wrong("jog-help-probe-wrong-calibrated", "B:13669"),
    wrong("jog-help-probe-wrong-way", "A:15843"),
];
/// One touch from where the probe is.
const TOUCH: &[Line] =
    &[order("jog-help-touch-order", "B:3030;B:14254"), wrong("jog-help-touch-wrong", "A:15842;A:15830")];
/// A pocket or a hole.
const INSIDE: &[Line] =
    &[order("jog-help-inside-order", "B:3361;B:5773-5799"), wrong("jog-help-inside-wrong", "A:15842;A:15843")];
/// A spigot.
const OUTSIDE: &[Line] = &[
    before("jog-help-outside-before", "B:3349-3351"),
    order("jog-help-outside-order", "B:3349-3361"),
    wrong("jog-help-outside-wrong", "A:15842;A:15843"),
    wrong("jog-help-outside-wrong-infeed", "A:15842;A:15843"),
];
/// NC start does everything.
const ONCE: &[Line] = &[order("jog-help-once-order", "B:3030-3034")];
/// Points are stored one by one.
const POINTS: &[Line] =
    &[order("jog-help-points-order", "B:3082-3088;B:3720-3728"), wrong("jog-help-points-wrong", "B:3684-3688")];
/// A zero offset is corrected.
const OFFSET: &[Line] = &[
    corrects("jog-help-offset-corrects", "B:2762-2764;B:2867-2868"),
    corrects("jog-help-offset-activation", "B:3802-3806;B:3862-3870"),
];
/// The same up to SW 6.2.
const OLDER_OFFSET: &[Line] = &[
    corrects("jog-help-offset-corrects", "A:2943-2946;A:3124"),
    corrects("jog-help-older-basic", "A:2948-2954"),
    corrects("jog-help-older-active", "A:2925;A:3124"),
];
/// The tool probe.
const TOOL: &[Line] =
    &[wrong("jog-help-tool-wrong-reach", "A:15842"), wrong("jog-help-tool-wrong-data", "A:15841;B:14296")];

/// The groups of a mask, its own lines first.
fn groups(mask: &Mask) -> Vec<&'static [Line]> {
    let how = match mask.task {
        Task::Element(Element { inside: true, .. }) | Task::Centres(Element { inside: true, .. }) | Task::Ring => {
            INSIDE
        }
        Task::Element(_) | Task::Centres(_) => OUTSIDE,
        Task::ToolProbe | Task::ToolLength | Task::ToolRadius => TOOL,
        _ => TOUCH,
    };
    let mut groups = vec![mask.help];
    if mask.task.corrects() {
        groups.extend([CALIBRATED, if mask.older.is_some() { OLDER_OFFSET } else { OFFSET }]);
    }
    // the two runs in a ring are told by the mask
    if mask.task != Task::Ring {
        groups.push(how);
    }
    match (mask.at_once(), mask.by_hand()) {
        (true, _) => groups.push(ONCE),
        (_, false) => groups.push(POINTS),
        _ => {} // the mask tells it
    }
    groups
}

/// The help of a mask: the sections that say something, each with the key of its heading.
pub fn help(mask: &Mask) -> Vec<(&'static str, Vec<&'static Line>)> {
    let lines: Vec<&'static Line> = groups(mask).into_iter().flatten().collect();
    let probe = if mask.task.of_tool() { ProbeUse::Tool } else { ProbeUse::Workpiece };
    let section = |section: Section| {
        let own: Vec<&Line> = lines.iter().copied().filter(|line| line.section == section).collect();
        (!own.is_empty()).then(|| (section.key(probe), own))
    };
    SECTIONS.into_iter().filter_map(section).collect()
}

/// Alarms of a control that cannot measure at all, and of any way (A:15840-15935).
const OF_ALL: &[u32] = &[61016, 61301, 61310, 61311, 61313, 61336, 61342, 61401, 61416];
/// Of a probe: unsuitable, or something in its way.
const OF_PROBES: &[u32] = &[61302, 61309, 61373];
/// Of one that must be calibrated.
const OF_CALIBRATED: &[u32] = &[61341];
/// Of the tool probe: no tool to be measured, its data, where the tool is.
const OF_TOOLS: &[u32] = &[61230, 61302, 61314];

/// The alarms that a mask can raise, by their numbers.
pub fn alarms(mask: &Mask) -> Vec<Code> {
    let own: &[u32] = match (mask.task, mask.points) {
        (Task::Ring, _) => &[61372],
        (Task::Element(Element { inside: false, .. }), _) => &[61402],
        (Task::Corner, 3) => &[61367],
        (Task::Corner, _) => &[61367, 61368],
        (Task::Centres(Element { inside, .. }), points) => match (inside, points) {
            (true, 2) => &[61367],
            (true, 3) => &[61316, 61367],
            (true, _) => &[61367, 61368],
            (false, 2) => &[61367, 61402],
            (false, 3) => &[61316, 61367, 61402],
            (false, _) => &[61367, 61368, 61402],
        },
        (Task::ToolLength | Task::ToolRadius, _) => &[61332, 61350],
        _ => &[],
    };
    let kind = if mask.task.of_tool() { OF_TOOLS } else { OF_PROBES };
    let calibrated = if mask.task.corrects() { OF_CALIBRATED } else { &[] };
    let mut numbers: Vec<u32> = [OF_ALL, kind, calibrated, own].concat();
    numbers.sort_unstable();
    numbers.into_iter().map(Code::Alarm).collect()
}

/// Alarms whose cure speaks of a call: in JOG it speaks of the mask and of the set-up.
const CURED_HERE: &[u32] = &[61301, 61302, 61309, 61311, 61313, 61316, 61332, 61350, 61367, 61368, 61372, 61401];
/// Those of them of which it is another one with the tool probe.
const CURED_FOR_TOOLS: &[u32] = &[61301, 61302, 61313];

/// Key of what helps against an alarm that a mask raises.
pub fn cure(code: Code, mask: Option<&Mask>) -> String {
    let tool = mask.is_some_and(|mask| mask.task.of_tool());
    match code {
        Code::Alarm(number) if tool && CURED_FOR_TOOLS.contains(&number) => format!("jog-cure-{number}-tool"),
        Code::Alarm(number) if CURED_HERE.contains(&number) => format!("jog-cure-{number}"),
        _ => format!("{}.cure", alarms::key(code)),
    }
}

/// What helps where points make nothing, which the control tells by the words of an alarm.
pub fn cure_of(why: &Message, mask: Option<&Mask>) -> Option<Message> {
    let number = why.key.strip_prefix("alarm-")?.parse().ok()?;
    Some(Message::new(cure(Code::Alarm(number), mask)))
}

#[cfg(all(test, feature = "cli"))]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::jog::masks;
    use crate::manual::Cited;
    use crate::words::Words;
    use std::collections::BTreeSet;

    // oracle: manual: for each point that a mask has, where the probe is before it (B:3015-3649)
    #[test]
    fn every_mask_says_where_each_point_is() {
        let words = Words::english();
        for mask in masks::all() {
            let sections = help(mask);
            assert_eq!(sections.len(), SECTIONS.len(), "{}", mask.name);
            let (_, lines) = &sections[1];
            let text: String = lines.iter().map(|line| words.key(line.key)).collect();
            let told =
                |number: usize| text.contains(&format!("P{number}")) || mask.points == 4 && text.contains("P1 to P4");
            assert!(mask.at_once() || (1..=mask.points).all(told), "{}: {text}", mask.name);
            for line in sections.iter().flat_map(|(_, lines)| lines) {
                assert!(!Cited(line.source).to_string().is_empty(), "{}", line.key);
            }
        }
    }

    /// Data of JOG and those that it shares with the cycles (B:14157-14368, B:2746-2754, B:13346, B:3984), data of the
    /// tool, the control's own.
    const KNOWN: [&str; 8] = ["_JM_", "E_MESS_", "_WP", "_TP", "_CVAL", "_SI", "$TC_DP", "MM_"];

    // oracle: manual (B:14157-14368): JOG has no parameters, it has masks and data of its own
    #[test]
    fn no_cure_names_what_jog_does_not_have() {
        let words = Words::english();
        let mut cures = BTreeSet::new();
        for mask in masks::all() {
            for code in super::alarms(mask) {
                let key = cure(code, Some(mask));
                let text = words.key(key.clone());
                let names = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '$'));
                for name in names.filter(|name| name.contains('_')) {
                    assert!(KNOWN.iter().any(|known| name.starts_with(known)), "{} {code}: {text}", mask.name);
                }
                let call = ["program ", "the call", "the cycle", "etpoint", "ariant", "CYCLE"];
                assert!(!call.iter().any(|word| text.contains(word)), "{} {code}: {text}", mask.name);
                cures.insert(key);
            }
        }
        let own = CURED_HERE.iter().map(|number| format!("jog-cure-{number}"));
        let unsaid: Vec<String> = own.filter(|key| !cures.contains(key)).collect();
        assert!(unsaid.is_empty(), "{unsaid:?}");
    }

    // oracle: self: an alarm that a sentence names is one of those that the mask can raise; every sentence is said
    #[test]
    fn sentences_name_the_alarms_of_their_mask() {
        let words = Words::english();
        let mut said = BTreeSet::new();
        for mask in masks::all() {
            let known: Vec<String> = alarms(mask).iter().map(ToString::to_string).collect();
            for line in groups(mask).into_iter().flatten() {
                said.insert(line.key);
                let text = words.key(line.key);
                let named = text.split(|c: char| !c.is_ascii_digit()).filter(|number| number.len() == 5);
                for number in named {
                    assert!(known.iter().any(|one| one == number), "{}: {text}", mask.name);
                }
            }
        }
        let file = include_str!("../../messages/en/jog.ftl").lines();
        let keys = file.filter_map(|line| line.split_once(" = ")).map(|(key, _)| key);
        let unsaid: Vec<&str> = keys.filter(|key| key.starts_with("jog-help-") && !said.contains(key)).collect();
        assert!(unsaid.is_empty(), "{unsaid:?}");
    }
}
