//! What a session shows: functions, mask, activation screen, softkeys, and the machine under the hand.

use super::view::{
    PracticeActivation, PracticeArea, PracticeChoice, PracticeDeviation, PracticeField, PracticeFigure, PracticeKeys,
    PracticeMachine, PracticeMask, PracticePoint, PracticeShow, PracticeUse, PracticeWord,
};
use crate::app::help::{HelpSection, HelpText};
use crate::app::jog::stored;
use crate::app::whereabouts_in_jog;
use crate::control::{AXES, Control, OLDER_JOG, Plane, ROTARY, Store};
use crate::jog::activation::{Activation, choices};
use crate::jog::help::{self, Line};
use crate::jog::mask::{Field, Kind, Mask, Show, key};
use crate::jog::practice::piece;
use crate::jog::shadow::Deviation;
use crate::jog::states::Key;
use crate::jog::values::{Value, words};
use crate::jog::{Session, masks, settings};
use crate::manual::Cited;
use crate::message::Message;

/// The masks under their softkeys.
pub(super) fn areas(control: &Control) -> Vec<PracticeArea> {
    let one = |mask: &Mask| PracticeChoice {
        name: mask.name,
        label: Message::new(key("mask", mask.name)),
        piece: piece(mask),
    };
    let menu = masks::menu(masks::offered(control)).into_iter();
    menu.map(|(area, masks)| PracticeArea {
        label: Message::new(area.key()),
        masks: masks.into_iter().map(one).collect(),
    })
    .collect()
}

pub(super) fn shown(session: &Session, mask: &'static Mask) -> PracticeMask {
    let values = session.values();
    let wrong = values.missing(mask);
    let fields = mask.fields.iter().filter(|field| values.shown(field)).map(|field| {
        let wrong = wrong.as_ref().filter(|(one, _)| one.name == field.name).map(|(_, why)| why.clone());
        PracticeField { wrong, ..asked(session, field) }
    });
    let label = Message::new(key("mask", mask.name));
    let shows = mask.shows.iter().filter_map(|show| line(session, *show)).collect();
    let (fields, stores) = (fields.collect(), mask.by_hand());
    PracticeMask { name: mask.name, label, fields, stores, shows, help: told_help(mask) }
}

fn told_help(mask: &Mask) -> Vec<HelpSection> {
    let line = |line: &'static Line| HelpText { message: Message::new(line.key), source: Cited(line.source) };
    let section = |(heading, lines): (&'static str, Vec<&'static Line>)| HelpSection {
        label: Message::new(heading),
        lines: lines.into_iter().map(line).collect(),
    };
    let place = HelpSection { label: Message::new("where-title"), lines: whereabouts_in_jog(mask) };
    help::help(mask).into_iter().map(section).chain([place]).collect()
}

fn asked(session: &Session, field: &'static Field) -> PracticeField {
    let (values, control) = (session.values(), &session.sim.control);
    let unit = match field.kind {
        Kind::Length(_) => "mm",
        Kind::Angle => "deg",
        _ => "",
    };
    let mut choices = words(field, values, control).unwrap_or_default();
    // a zero offset that was entered by its name, or was active
    let held = values.word(field.name);
    if !choices.is_empty() && !choices.iter().any(|word| word == held) {
        choices.push(held.to_owned());
    }
    PracticeField {
        name: field.name,
        label: session.label("field", field.name),
        unit,
        value: values.get(field.name).cloned().unwrap_or(Value::Number(0.0)),
        choices: choices.into_iter().map(|word| choice(control, word)).collect(),
        wrong: None,
    }
}

/// A word with what it is called; names of axes and zero offsets, signs and numbers are called what they are.
fn choice(control: &Control, word: String) -> PracticeWord {
    let plain = word.len() < 2 || word.starts_with('$') || control.make().settable_named(&word).is_some();
    let label = (!plain).then(|| Message::new(key("word", &word)));
    PracticeWord { word, label }
}

/// A line of the left part; none: a result that is not there yet.
fn line(session: &Session, show: Show) -> Option<PracticeShow> {
    let control = &session.sim.control;
    let frame = session.chosen().map(|store| (told_name(control, store), control.stored_frame(store)));
    let offset = frame.as_ref().map(|(name, _)| name.clone());
    let axes = |values: [f64; 3], unit: &'static str| -> Vec<PracticeFigure> {
        AXES.into_iter().zip(values).map(|(axis, value)| PracticeFigure { axis, value, unit }).collect()
    };
    let result = |name: &'static str, unit: &'static str| {
        let value = session.outcome().results.iter().find(|(known, _)| *known == name)?.1;
        let figures = vec![PracticeFigure { axis: "", value, unit }];
        Some(PracticeShow { label: session.label("result", name), offset: None, figures })
    };
    let rotation = || PracticeShow {
        label: Message::new("jog-show-rotation"),
        offset: offset.clone(),
        figures: frame.as_ref().map_or(Vec::new(), |(_, frame)| axes(frame.rotation.0, "deg")),
    };
    Some(match show {
        Show::Length(name) => return result(name, "mm"),
        Show::Angle(name) => return result(name, "deg"),
        Show::Measuring => PracticeShow {
            label: Message::new("jog-show-measuring"),
            offset: Some(control.make().settable_name(session.measuring())),
            figures: Vec::new(),
        },
        Show::Translation => PracticeShow {
            label: Message::new("jog-show-translation"),
            figures: frame.as_ref().map_or(Vec::new(), |(_, frame)| {
                axes(std::array::from_fn(|axis| frame.coarse[axis] + frame.fine[axis]), "mm")
            }),
            offset,
        },
        Show::Rotation => rotation(),
        Show::Turned => match ROTARY.iter().position(|axis| *axis == session.values().word("angle_offset")) {
            None => rotation(),
            Some(axis) => PracticeShow {
                label: Message::new("jog-show-turned"),
                figures: frame.as_ref().map_or(Vec::new(), |(_, frame)| {
                    vec![PracticeFigure { axis: ROTARY[axis], value: frame.rotary[axis].0, unit: "deg" }]
                }),
                offset,
            },
        },
    })
}

fn told_name(control: &Control, store: Store) -> String {
    crate::jog::offset::name(control, store)
}

pub(super) fn activation(session: &Session, screen: &Activation) -> PracticeActivation {
    let control = &session.sim.control;
    let one = |name: &'static str| PracticeField {
        name,
        label: Message::new(key("field", name)),
        unit: "",
        value: screen.values.get(name).cloned().unwrap_or(Value::Word(String::new())),
        choices: choices(name).map(|word| choice(control, word.to_owned())).into(),
        wrong: None,
    };
    PracticeActivation { lines: screen.lines(control), fields: screen.fields().into_iter().map(one).collect() }
}

pub(super) fn keys(session: &Session) -> PracticeKeys {
    let [start, reset, calculate, back, mode] =
        [Key::Start, Key::Reset, Key::Calculate, Key::Back, Key::Mode].map(|key| session.takes(key));
    PracticeKeys { start, reset, calculate, back, mode }
}

/// A mask that NC start alone fills has no softkeys.
pub(super) fn points(session: &Session) -> Vec<PracticePoint> {
    let several = session.mask().is_some_and(|mask| !mask.at_once());
    let mut known = stored(&[], session.points()).into_iter().peekable();
    let one = |number: usize| {
        let name = format!("P{}", number + 1);
        let stored = known.next_if(|point| point.name == name);
        let waits = session.waits() && session.points().iter().position(Option::is_none) == Some(number);
        let line = format!("{} {name}", if session.kept_by_hand() { "store" } else { "reject" });
        PracticePoint { name, stored, waits, line }
    };
    (0..if several { session.points().len() } else { 0 }).map(one).collect()
}

pub(super) fn machine(session: &Session) -> PracticeMachine {
    let sim = &session.sim;
    let control = &sim.control;
    let mut measuring = control.clone();
    measuring.activate(session.measuring());
    let plane = settings::plane(control);
    let planes = Plane::ALL.map(|one| {
        let number = one.code();
        PracticeUse { name: format!("G{number}"), line: format!("set _JM_I[3] = {number}"), used: one == plane }
    });
    let others = control.frames.keys().copied().filter(|number| *number > 4);
    let offsets = (0..=4).chain(others).map(|number| PracticeUse {
        name: control.make().settable_name(number),
        line: format!("set _JM_I[4] = {}", settings::number(number)),
        used: number == session.measuring(),
    });
    let empty = PracticeUse { name: String::new(), line: "tool T0".to_owned(), used: control.tool == 0 };
    let tools = control.tools.iter().filter(|(tool, _)| **tool > 0).flat_map(|(tool, data)| {
        let one = |edge: &i64| PracticeUse {
            name: format!("T{tool} D{edge} {}", data.name),
            line: format!("tool T{tool} D{edge}"),
            used: control.active_place() == (*tool, *edge),
        };
        data.edges.keys().map(one).collect::<Vec<_>>()
    });
    let [abscissa, ordinate, _] = plane.axes();
    let older = settings::older(control);
    let versions = [("\u{2265} SW 6.3", false), ("\u{2264} SW 6.2", true)].map(|(name, is)| PracticeUse {
        name: name.to_owned(),
        line: format!("set {OLDER_JOG} = {}", u8::from(is)),
        used: older == is,
    });
    PracticeMachine {
        wcs: measuring.to_workpiece(sim.position).0,
        mcs: sim.position.0,
        active: control.make().settable_name(control.settable),
        axes: [abscissa, ordinate].map(|axis| AXES[axis]),
        versions: versions.into(),
        planes: planes.into(),
        offsets: offsets.collect(),
        offered: session.offers(),
        tools: std::iter::once(empty).chain(tools).collect(),
        probe: sim.has_probe(),
    }
}

pub(super) fn told(control: &Control, store: Store, deviation: Deviation) -> PracticeDeviation {
    let figure = |unit: &'static str| move |(axis, value): (&'static str, f64)| PracticeFigure { axis, value, unit };
    let lengths = deviation.lengths.into_iter().map(figure("mm"));
    let figures = lengths.chain(deviation.angles.into_iter().map(figure("deg"))).collect();
    PracticeDeviation { offset: told_name(control, store), figures }
}
