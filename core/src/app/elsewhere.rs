//! What only newer controls and controls of other makers have: for search, and for a card that explains one.

use crate::catalogue::alarms;
use crate::catalogue::newer::alarms::NEWER;
use crate::catalogue::newer::arguments::Argument;
use crate::catalogue::newer::{LISTS, title};
use crate::control::OF_LISTS;
use crate::control::setting_data::SETTING_DATA;
use crate::foreign::{CONTROLS, Foreign, ForeignCycle};
use crate::message::Message;
use serde::Serialize;

/// Something of such a control.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Elsewhere {
    /// Its name there: `SD54600`, `S_MD`, `CYCLE996`, `61444`, `TCH PROBE 421`.
    pub code: String,
    /// Whether it is an alarm.
    pub alarm: bool,
    /// Key of what it means.
    pub key: String,
    /// Key of what more there is to say; not every language file has it.
    pub help: String,
    /// Other names by which it is looked for.
    pub words: String,
    /// What else is known of it.
    pub lines: Vec<Message>,
    /// Its arguments or parameters, in their order.
    pub parts: Vec<ElsewherePart>,
    /// Calls that have it, each with its place there: `CYCLE977 (9)`.
    pub owners: Vec<String>,
}

/// An argument or a parameter of a cycle.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ElsewherePart {
    /// Its name; empty: none is published.
    pub name: String,
    /// Key of what it means.
    pub key: String,
}

/// All of it.
pub fn elsewhere() -> Vec<Elsewhere> {
    let controls = CONTROLS.into_iter();
    let foreign = controls.flat_map(|control| control.cycles.iter().map(move |cycle| of_foreign(control, cycle)));
    [cycles(), arguments(), data(), newer_alarms()].concat().into_iter().chain(foreign).collect()
}

/// Cycles that only newer controls have.
fn cycles() -> Vec<Elsewhere> {
    let alone = LISTS.iter().filter_map(|list| Some((list, title(list)?)));
    let of = alone.map(|(list, title)| Elsewhere {
        code: list.name.to_owned(),
        key: title.key.into_owned(),
        words: list.name.trim_start_matches(|one: char| one.is_ascii_alphabetic()).to_owned(),
        lines: vec![Message::new("write-unpublished-alone").text("cycle", list.name)],
        parts: Argument::all(list).map(|one| ElsewherePart { name: one.name.to_owned(), key: one.meaning() }).collect(),
        ..Elsewhere::default()
    });
    of.collect()
}

/// Arguments of the lists, those with one meaning together.
fn arguments() -> Vec<Elsewhere> {
    let mut all: Vec<Elsewhere> = Vec::new();
    for one in LISTS.iter().flat_map(Argument::all).filter(|one| !one.name.is_empty()) {
        let (meaning, lines) = (one.meaning(), one.about());
        let place = format!("{} ({})", one.list.name, one.place);
        match all.iter_mut().find(|known| known.code == one.name && known.key == meaning && known.lines == lines) {
            Some(known) => known.owners.push(place),
            None => all.push(Elsewhere {
                code: one.name.to_owned(),
                help: format!("{meaning}-help"),
                key: meaning,
                words: one.screen().to_owned(),
                lines,
                owners: vec![place],
                ..Elsewhere::default()
            }),
        }
    }
    all
}

/// Setting data, and machine data that newer controls have in their place.
fn data() -> Vec<Elsewhere> {
    let of = SETTING_DATA.iter().map(|datum| Elsewhere {
        code: datum.name(),
        key: datum.key(OF_LISTS),
        help: format!("{}.help", datum.key(OF_LISTS)),
        words: format!("{} {} {}", datum.number, datum.identifier(), datum.older_name()),
        lines: vec![match datum.older_name() {
            none if none.is_empty() => Message::new("argument-no-older"),
            older => Message::new("argument-older").text("name", older),
        }],
        ..Elsewhere::default()
    });
    of.collect()
}

/// Alarms that the older control does not have.
fn newer_alarms() -> Vec<Elsewhere> {
    let alone = NEWER.iter().map(u32::to_string).filter(|number| alarms::find(number).is_none());
    let of = alone.map(|number| Elsewhere {
        key: format!("newer-alarm-{number}"),
        code: number,
        alarm: true,
        ..Elsewhere::default()
    });
    of.collect()
}

fn of_foreign(control: &Foreign, cycle: &'static ForeignCycle) -> Elsewhere {
    let source = (!cycle.source.is_empty()).then(|| Message::new("foreign-source").source(cycle.source));
    let number = cycle.name.rsplit(' ').next().unwrap_or_default();
    Elsewhere {
        code: cycle.name.to_owned(),
        key: cycle.title(),
        words: format!("{number} G{number} {}", control.name),
        lines: cycle.unwritten(control).into_iter().chain(source).collect(),
        parts: cycle
            .parameters
            .iter()
            .map(|one| ElsewherePart { name: one.name.to_owned(), key: one.key.to_owned() })
            .collect(),
        ..Elsewhere::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    // oracle: peer (published lists, data and remedies of newer controls; pages of the TNC)
    #[test]
    fn what_other_controls_have_is_found_by_its_name() {
        let all = elsewhere();
        let of = |code: &str| all.iter().filter(|one| one.code == code).collect::<Vec<_>>();
        for code in ["SD54600", "MD51740", "61444", "61422", "S_MD", "S_TZL", "CYCLE996", "CYCLE150", "TCH PROBE 421"] {
            assert!(!of(code).is_empty(), "{code}");
        }
        assert!(of("61422").iter().all(|one| one.alarm && one.key == "newer-alarm-61422"));
        assert_eq!(of("CYCLE996").first().map(|one| one.parts.len()), Some(18));
        assert!(of("S_MD").iter().any(|one| one.owners.contains(&"CYCLE978 (9)".to_owned())));
        // an alarm that the older control has too stands in its own table, and a name with one meaning once
        assert!(of("61303").is_empty());
        let told: BTreeSet<_> = all.iter().map(|one| (&one.code, &one.key, format!("{:?}", one.lines))).collect();
        assert_eq!(told.len(), all.len());
    }
}
