//! Where a form is on the control: in its program editor, in JOG, and what the masks need.

use super::help::HelpText;
use crate::catalogue::in_jog::TABLE;
use crate::catalogue::softkeys::{Softkeys, Way, softkeys};
use crate::entry::Cycle;
use crate::jog::mask::{Area, Function, key};
use crate::jog::masks::FUNCTIONS;
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
        let function = FUNCTIONS.iter().find(|function| function.masks.iter().any(|mask| mask.name == one.mask));
        let Some(Function { area, .. }) = function else { continue };
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
