//! Where a form, or a mask of measuring in JOG, is on the control: its softkeys, its settings, and what the masks need.

use super::help::HelpText;
use crate::catalogue::in_jog::TABLE;
use crate::catalogue::softkeys::{Softkeys, Way, softkeys};
use crate::entry::Cycle;
use crate::jog::mask::{Area, Mask, key};
use crate::jog::masks;
use crate::jog::softkeys::{self, Software};
use crate::manual::Cited;
use crate::message::Message;

/// Sentences about a variant, each with its place.
pub fn whereabouts(cycle: &Cycle, variant: i64) -> Vec<HelpText> {
    let text = |message, source| HelpText { message, source: Cited(source) };
    let from = softkeys(cycle, variant).find(|one| one.way == Way::From).into_iter();
    let from = from.map(|one| text(Message::new("where-from").text("version", one.softkeys), one.source));
    let ways = softkeys(cycle, variant).filter(|one| one.way != Way::From);
    let mut told: Vec<HelpText> = from.chain(ways.map(|one| text(way(one), one.source))).collect();
    told.extend(in_jog(cycle, variant).into_iter().map(|message| text(message, "B:2722-2728;B:3959-4057")));
    let has = |way| softkeys(cycle, variant).any(|one| one.way == way);
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

/// The masks of measuring in JOG that measure the same.
fn in_jog(cycle: &Cycle, variant: i64) -> Vec<Message> {
    let mut found: Vec<Message> = Vec::new();
    let same = |number: i64, also: &[i64]| number == variant || also.contains(&variant);
    for one in TABLE.iter().filter(|one| one.cycle == cycle.name && same(one.variant, one.also)) {
        let Some(area) = masks::find(one.mask).map(|mask| mask.task.area()) else { continue };
        let mask = key("mask", one.mask);
        let message = match area {
            Area::Tool => Message::new("where-jog-tool").text("mask", mask),
            _ => Message::new("where-jog").text("area", area.key()).text("mask", mask),
        };
        if !found.contains(&message) {
            found.push(message);
        }
    }
    found
}

/// Sentences about a mask of measuring in JOG, each with its place.
pub fn whereabouts_in_jog(mask: &Mask) -> Vec<HelpText> {
    let text = |message, source| HelpText { message, source: Cited(source) };
    let mut told: Vec<HelpText> = Vec::new();
    for one in softkeys::softkeys(mask) {
        let (way, files) = match one.software {
            Software::Newer => ("where-jog-newer", Some("where-jog-files")),
            Software::Older => ("where-jog-older", Some("where-jog-files-older")),
            Software::Both => ("where-jog-both", None),
        };
        told.push(text(Message::new(way).text("softkeys", one.softkeys), one.source));
        told.push(text(Message::new("where-jog-needs"), "B:2656-2674;B:14686"));
        let files = files.map_or(vec!["where-jog-files", "where-jog-files-older"], |files| vec![files]);
        told.extend(files.into_iter().map(|files| text(Message::new(files), "B:14399-14412")));
    }
    let settings = if mask.task.of_tool() { "where-jog-settings-tool" } else { "where-jog-settings" };
    told.push(text(Message::new(settings), "B:2690-2700;B:14254;B:14296"));
    told
}
