//! The zero offset that a mask corrects: which there are, and what is written (B:2762-2781, B:2867-2868). Coarse takes
//! the fine part in, which becomes 0; what was not measured stays as the zero offset has it.

use super::settings;
use crate::control::{Control, Frame, Store};
use crate::evaluate::zero_offset::{self, Measured, Target};
use crate::evaluate::{Write, level};
use crate::geometry::{Degrees, Dir, Rpy, V3, Wcs, rigid};

/// The word of "measuring only".
pub const NONE: &str = "none";

/// Most settable frames of a control.
const SETTABLE: std::ops::RangeInclusive<usize> = 1..=99;

/// Name of a zero offset as programs have it.
pub fn name(control: &Control, store: Store) -> String {
    match store {
        Store::Settable(number) => control.make().settable_name(number),
        Store::System => "$P_SETFR".to_owned(),
        Store::ChannelBasic(index) => format!("$P_CHBFR[{index}]"),
        Store::GlobalBasic(index) => format!("$P_NCBFR[{index}]"),
    }
}

/// The zero offset with this name that can be corrected; `turned`: by a rotation as well.
pub fn named(control: &Control, word: &str, turned: bool) -> Option<Store> {
    let settable = |word: &str| control.make().settable_named(word).filter(|number| SETTABLE.contains(number));
    let basic = || basic(control, turned).into_iter().find(|store| name(control, *store) == word);
    settable(word).map(Store::Settable).or_else(basic)
}

/// What a mask offers: settable frames that hold something, G54 to G57 always; basic frames as `_JM_I[5]` says.
pub fn choices(control: &Control, turned: bool) -> Vec<String> {
    let others = control.frames.keys().copied().filter(|number| *number > 4 && SETTABLE.contains(number));
    let settable = (1..=4).chain(others).map(Store::Settable);
    let stores = settable.chain(basic(control, turned));
    std::iter::once(NONE.to_owned()).chain(stores.map(|store| name(control, store))).collect()
}

/// The settable frames that are taken although none is offered, as long as they hold nothing: `G505…G599`.
pub fn others(control: &Control) -> String {
    let name = |number: usize| control.make().settable_name(number);
    format!("{}…{}", name(5), name(*SETTABLE.end()))
}

/// The basic reference, with `_JM_I[5]` = 1 the basic frames too; global ones take no rotation (B:1971, B:2770-2781).
/// Up to SW 6.2 the last channel basic frame, with `_JM_B[4]` = 1 the basic reference instead (A:2948-2954).
fn basic(control: &Control, turned: bool) -> Vec<Store> {
    if settings::older(control) {
        return match control.bit("_JM_B[4]") {
            true => zero_offset::system_frame(control).then_some(Store::System).into_iter().collect(),
            false => zero_offset::last_basic(control).into_iter().collect(),
        };
    }
    let mut stores = Vec::new();
    if zero_offset::system_frame(control) {
        stores.push(Store::System);
    }
    if control.number("_JM_I[5]") == 1.0 {
        stores.extend(control.channel_basic_numbers().into_iter().map(Store::ChannelBasic));
        let global = control.stored.global.keys().filter(|_| !turned);
        stores.extend(global.map(|index| Store::GlobalBasic(*index)));
    }
    stores
}

/// What has to be written.
#[derive(Clone, Debug, PartialEq)]
pub enum Correction {
    /// The translation, so that what was measured gets its set position.
    Place(Measured),
    /// The rotation, and with a place the translation.
    Turn(Turn, Option<Measured>),
    /// An angle in addition to the translation of a rotary axis (index A B C).
    Rotary(usize, Degrees),
}

impl Correction {
    /// What gets its set position.
    pub fn place(&self) -> Option<&Measured> {
        match self {
            Correction::Place(place) | Correction::Turn(_, Some(place)) => Some(place),
            Correction::Turn(_, None) | Correction::Rotary(..) => None,
        }
    }
}

/// How a frame is turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Turn {
    /// So that a direction of the part has an angle from one axis X Y Z towards another.
    Angle {
        /// The direction, in the WCS that was active while measuring.
        along: Dir<Wcs>,
        /// From which axis towards which the angle counts.
        axes: [usize; 2],
        /// The set angle.
        set: Degrees,
        /// Whether the direction has a beginning: an edge has none.
        directed: bool,
    },
    /// So that a plane with this normal is level.
    Level(V3),
}

/// A channel basic frame is right up to SW 6.2 as soon as G500 is active (A:2948).
fn target(control: &Control, store: Store) -> Target {
    let without_settable = settings::older(control) && matches!(store, Store::ChannelBasic(_));
    Target { store, without_settable, activate: false }
}

/// The control once a zero offset that was corrected is right: it is active.
pub fn in_effect(control: &Control, store: Store) -> Control {
    let mut control = control.clone();
    let settable = match store {
        Store::Settable(number) => number,
        _ if target(&control, store).without_settable => 0,
        _ => control.settable,
    };
    control.activate(settable);
    control
}

/// Whether a zero offset has a scale factor, of which no measurement makes anything (61310, B:744), active or not.
pub fn scaled(control: &Control, store: Store) -> bool {
    zero_offset::scaled(control, &target(control, store))
}

/// What writes a correction into a frame.
pub fn writes(control: &Control, store: Store, correction: &Correction) -> Vec<Write> {
    let target = target(control, store);
    let old = control.stored_frame(store).rotation;
    match correction {
        Correction::Place(measured) => zero_offset::placed(control, &target, old, measured),
        Correction::Turn(turn, None) => zero_offset::turned(control, &target, rotation(control, &target, turn)),
        Correction::Turn(turn, Some(measured)) => {
            zero_offset::placed(control, &target, rotation(control, &target, turn), measured)
        }
        Correction::Rotary(axis, angle) => zero_offset::rotary(control, &target, *axis, *angle, true),
    }
}

/// The rotation of a frame that turns the part as it should lie.
fn rotation(control: &Control, target: &Target, turn: &Turn) -> Rpy {
    match turn {
        Turn::Level(normal) => {
            let [.., applicate] = control.plane.axes();
            let seen = zero_offset::seen(control, target, (*normal).into());
            zero_offset::levelled(control, target, V3::ith(applicate, 1.0).into(), seen)
        }
        Turn::Angle { along, axes: [from, to], set, directed } => {
            let seen = zero_offset::seen(control, target, along.0);
            let angle = Degrees::of(seen[*to].atan2(seen[*from])) - *set;
            let wrong = if *directed { within(angle, 360.0) } else { within(angle, 180.0) };
            let third = 3 - from - to;
            let sense = if (from + 1) % 3 == *to { 1.0 } else { -1.0 };
            let about = rigid::rotation(Rpy::about(third, wrong * sense));
            zero_offset::rotation(control, target, &about)
        }
    }
}

/// An angle less whole periods, from minus half of one to half of one.
fn within(angle: Degrees, period: f64) -> Degrees {
    angle - Degrees(period * (angle.0 / period).round())
}

/// The angle that goes into a rotary axis: measured minus set, with the sense of the axis as the table stands; a
/// positive angle moves the tool counter-clockwise about the part, so that the table turns the part back (B:627,
/// B:3100). Which axis carries the part is not checked (B:3102).
pub fn rotary(control: &Control, axis: usize, [from, to]: [usize; 2], wrong: Degrees) -> Correction {
    let about = V3::from(control.turn_axis(from, to));
    let alike = about.dot(&V3::from(control.rotary_direction(axis)));
    Correction::Rotary(axis, wrong * 1.0_f64.copysign(alike))
}

/// Whether a frame that is corrected tilts the WCS: turns it about an axis of the plane.
pub fn tilts(control: &Control, before: &Frame, after: &Frame) -> bool {
    let [.., applicate] = control.plane.axes();
    let up = |frame: &Frame| V3::from(frame.turn(V3::ith(applicate, 1.0).into()));
    (up(before) - up(after)).norm() > level::SAME
}
