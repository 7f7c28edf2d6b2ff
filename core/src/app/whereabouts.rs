//! Where a form, or a mask of measuring in JOG, is on the control: its softkeys, its settings, and what the masks need.

use super::help::HelpText;
use crate::catalogue::in_jog::TABLE;
use crate::catalogue::softkeys::{Softkeys, Way, softkeys};
use crate::entry::Cycle;
use crate::jog::mask::Mask;
use crate::jog::masks;
use crate::jog::softkeys::{self, Software};
use crate::manual::Cited;
use crate::message::Message;

/// Sentences about a variant, each with its place.
pub fn whereabouts(cycle: &Cycle, variant: i64) -> Vec<HelpText> {
    let text = |message, source| HelpText { message, source: Cited(source) };
    let from = softkeys(cycle, variant).find(|one| one.way == Way::From).into_iter();
    let from = from.map(|one| text(Message::new("where-from").text("version", one.softkeys), one.source));
    // what is there only from a later version has no softkeys before
    let is_new = softkeys(cycle, variant).any(|one| one.way == Way::From);
    let has = |way| softkeys(cycle, variant).any(|one| one.way == way) && !(is_new && way == Way::Older);
    let ways = softkeys(cycle, variant).filter(|one| one.way != Way::From && has(one.way));
    let mut told: Vec<HelpText> = from.chain(ways.map(|one| text(way(one), one.source))).collect();
    told.extend(in_jog(cycle, variant).into_iter().map(|(message, source)| text(message, source)));
    if has(Way::Editor) {
        told.push(text(Message::new("where-settings"), "B:12467-12493"));
        told.push(text(Message::new("where-files"), "B:14654-14655;A:15688-15695"));
    }
    if has(Way::Older) {
        told.push(text(Message::new("where-files-older"), "B:11640-11660;A:12963-12975"));
    }
    told
}

fn way(one: &Softkeys) -> Message {
    let key = match one.way {
        Way::None => return Message::new(format!("where-none-{}", one.softkeys)),
        Way::Editor | Way::From => "where-editor",
        Way::Older if one.softkeys.is_empty() => "where-older-call",
        Way::Older => "where-older",
    };
    Message::new(key).text("softkeys", one.softkeys).text("call", one.call)
}

/// The softkeys of the masks of measuring in JOG that measure the same, each with its place.
fn in_jog(cycle: &Cycle, variant: i64) -> Vec<(Message, &'static str)> {
    let same = |number: i64, also: &[i64]| number == variant || also.contains(&variant);
    let tasks = TABLE.iter().filter(|one| one.cycle == cycle.name && same(one.variant, one.also));
    let masks = tasks.filter_map(|one| masks::find(one.mask));
    let mut found: Vec<(Message, &'static str)> = Vec::new();
    for one in masks.flat_map(softkeys::softkeys) {
        let told = (Message::new(of_software(one.software)).text("softkeys", one.softkeys), one.source);
        if !found.contains(&told) {
            found.push(told);
        }
    }
    found
}

/// The sentence with the softkeys of a mask.
fn of_software(software: Software) -> &'static str {
    match software {
        Software::Newer => "where-jog-newer",
        Software::Older => "where-jog-older",
        Software::Both => "where-jog-both",
    }
}

/// Sentences about a mask of measuring in JOG, each with its place.
pub fn whereabouts_in_jog(mask: &Mask) -> Vec<HelpText> {
    let text = |message, source| HelpText { message, source: Cited(source) };
    let mut told: Vec<HelpText> = Vec::new();
    for one in softkeys::softkeys(mask) {
        let files = match one.software {
            Software::Newer => Some("where-jog-files"),
            Software::Older => Some("where-jog-files-older"),
            Software::Both => None,
        };
        told.push(text(Message::new(of_software(one.software)).text("softkeys", one.softkeys), one.source));
        told.push(text(Message::new("where-jog-needs"), "B:2656-2674;B:14686"));
        let files = files.map_or(vec!["where-jog-files", "where-jog-files-older"], |files| vec![files]);
        told.extend(files.into_iter().map(|files| text(Message::new(files), "B:14399-14412")));
    }
    let settings = if mask.task.of_tool() { "where-jog-settings-tool" } else { "where-jog-settings" };
    told.push(text(Message::new(settings), "B:2690-2700;B:14254;B:14296"));
    told
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::CYCLES;

    fn keys(name: &str, variant: i64) -> Vec<String> {
        let cycle = CYCLES.iter().find(|one| one.name == name);
        let told = cycle.map(|cycle| whereabouts(cycle, variant)).unwrap_or_default();
        told.into_iter().map(|one| one.message.key.to_string()).collect()
    }

    // oracle: manual B:11767-11771 (the auxiliary cycle has an absolute and an incremental calibration alone), B:2259
    #[test]
    fn what_came_later_has_no_softkeys_before() {
        for variant in [10, 10_010, 100_000, 100_010] {
            let told = keys("CYCLE971", variant);
            assert!(told.iter().any(|key| key == "where-from"), "{variant}: {told:?}");
            assert!(!told.iter().any(|key| key.starts_with("where-older")), "{variant}: {told:?}");
            assert!(!told.iter().any(|key| key == "where-files-older"), "{variant}: {told:?}");
        }
        assert!(keys("CYCLE971", 0).iter().any(|key| key == "where-older"));
    }

    // oracle: self: a form and its mask in JOG name the same softkeys
    #[test]
    fn a_form_names_the_softkeys_of_its_mask() {
        let mut compared = 0;
        for one in TABLE.iter() {
            let cycle = CYCLES.iter().find(|cycle| cycle.name == one.cycle);
            let (Some(cycle), Some(mask)) = (cycle, masks::find(one.mask)) else { continue };
            let told = whereabouts(cycle, one.variant);
            let ways = [Software::Newer, Software::Older, Software::Both].map(of_software);
            let of_masks = whereabouts_in_jog(mask).into_iter();
            for of_mask in of_masks.filter(|text| ways.contains(&text.message.key.as_ref())) {
                compared += 1;
                let there = told.iter().any(|text| text.message == of_mask.message);
                assert!(there, "{} {}: {:?}", one.cycle, one.variant, of_mask.message);
            }
        }
        assert!(compared > 10);
    }
}
