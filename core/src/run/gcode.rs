//! G functions: motion, plane, frames, units, absolute and incremental; and words without a value that set something.

use super::{
    Compensation, FeedType, Interpreter, Measure, Motion, Pole, Suppress, Words, contour::Outside, diameters, motion,
    noted, unread,
};
use crate::control::Plane;
use crate::diagnostic::Severity;
use crate::problem::Problem;
use crate::program::words::{Setting, setting};

pub fn settings(run: &mut Interpreter, found: &mut Words) {
    for call in &found.calls {
        match setting(&call.name) {
            Some(Setting::Suppress) => found.path.suppress = Suppress::All,
            Some(Setting::Transverse(transverse)) => diameters::of_channel(run, transverse),
            Some(Setting::RadiiInCycles) => diameters::of_cycles(run),
            Some(Setting::AsChannel) => diameters::as_channel(run),
            Some(Setting::Through) => run.modal.motion = Motion::Through,
            Some(Setting::Tangential) => run.modal.motion = Motion::Tangential,
            Some(Setting::Spline) => {
                run.modal.motion = Motion::Spline;
                run.tell(Severity::Warning, &Problem::new("run-spline", call.span, &*call.name));
            }
            Some(Setting::Approach) => {
                run.tell(Severity::Note, &Problem::new("run-contour-approach", call.span, &*call.name));
            }
            Some(Setting::EndOfSpline) | None => {}
        }
    }
}

/// Whether a G function is in a block beside the NCT macro that it calls (`G17 G110 D50`, C:1050).
pub fn beside_macro(code: f64) -> bool {
    code < 100.0 && code != 65.0
}

/// Applies those G functions of a block that count.
pub fn apply(run: &mut Interpreter, found: &mut Words, counts: fn(f64) -> bool) -> Result<(), Problem> {
    let codes = found.of("G").filter_map(|address| Some((address.value.number()?, address.span)));
    for (number, span) in codes.filter(|(number, _)| counts(*number)).collect::<Vec<_>>() {
        if let Some(instead) = (run.rules().instead)(number) {
            let problem = Problem::new("run-not-simulated", span, format!("G{number}"));
            match instead {
                Instead::Stays => found.path.stays = true,
                Instead::Leaves => {
                    found.path.stays = true;
                    unread::leave_axes(run, found);
                }
                Instead::GoesOn => {}
            }
            run.tell(Severity::Warning, &problem);
            continue;
        }
        let whole = number.fract() == 0.0 && (0.0..1000.0).contains(&number);
        if !(whole && one(run, number as u16, found)) {
            found.path.stays = true;
            unread::leave_axes(run, found);
            run.tell(Severity::Error, &Problem::new("run-unknown-word", span, format!("G{number}")));
        }
    }
    Ok(())
}

/// What is done instead of a G function that is not simulated.
pub enum Instead {
    /// The axes stay where they are: limits, fixed points, a thread that goes in and comes out again.
    Stays,
    /// Nobody knows where the axes of the block stand behind it: plunge-cutting along an inclined axis.
    Leaves,
    /// The block moves as without it: a smooth approach, what the maker of the machine defined.
    GoesOn,
}

/// SINUMERIK: G25 and G26 limits, G33 to G35, G63, G331, G332, G335, G336 threads, G74, G75 and G751 (by way of a
/// point) reference and fixed points, G147 to G348 smooth approach and retraction; G5 oblique plunge-cut grinding, G7
/// its compensating motion; G810 to G829 of the machine's maker (840D sl, Fundamentals, groups of G functions).
pub fn instead(number: f64) -> Option<Instead> {
    if number.fract() != 0.0 {
        return None;
    }
    match number as i64 {
        25 | 26 | 33..=35 | 63 | 74 | 75 | 331 | 332 | 335 | 336 | 751 => Some(Instead::Stays),
        5 | 7 => Some(Instead::Leaves),
        147 | 148 | 247 | 248 | 347 | 348 | 810..=829 => Some(Instead::GoesOn),
        _ => None,
    }
}

fn one(run: &mut Interpreter, code: u16, found: &mut Words) -> bool {
    match code {
        0 => run.modal.motion = Motion::Rapid,
        1 => run.modal.motion = Motion::Line,
        2 => run.modal.motion = Motion::Clockwise,
        3 => run.modal.motion = Motion::Counter,
        4 => found.path.dwell = true,
        17..=19 => run.sim.with_length(|control| control.plane = Plane::of(code).unwrap_or(control.plane)),
        40 => run.modal.compensation = Compensation::Off,
        41 => run.modal.compensation = Compensation::Left,
        42 => run.modal.compensation = Compensation::Right,
        53 => found.path.suppress = Suppress::Settable,
        54..=57 => run.sim.control.activate(usize::from(code) - 53),
        90 => run.modal.absolute = true,
        91 => run.modal.absolute = false,
        9 | 60 | 61 | 64 | 80 => {}
        94 => run.modal.feed_type = FeedType::Minute,
        _ if run.sim.control.choose_units(code) => {}
        _ => return (run.rules().function)(run, code, found),
    }
    true
}

pub fn sinumerik(run: &mut Interpreter, code: u16, found: &mut Words) -> bool {
    match code {
        58 | 59 => {} // see `frame`
        110 => found.path.pole = Some(Pole::Position),
        111 => found.path.pole = Some(Pole::Zero),
        112 => found.path.pole = Some(Pole::Before),
        153 => found.path.suppress = Suppress::All,
        500 => run.sim.control.activate(0),
        505..=599 => run.sim.control.activate(usize::from(code) - 500),
        93 => run.modal.feed_type = FeedType::Inverse,
        95 => run.modal.feed_type = FeedType::Revolution,
        // the spindle goes on turning as fast; G942 and G952 freeze its speed too
        97 | 942 | 952 | 971..=973 => {
            run.modal.speed = motion::spindle_speed(run);
            let a_turn = matches!(code, 97 | 952);
            run.modal.feed_type = if a_turn { FeedType::Revolution } else { FeedType::Minute };
        }
        // F is the time of a block, whose unit is not certain: the feed stays as it was before
        931 => {
            let place = found.function("G", 931.0).map_or(found.path.span, |word| word.span);
            noted::without(run, "run-passed", place, "G931");
        }
        96 | 962 => run.modal.feed_type = FeedType::Cutting,
        961 => run.modal.feed_type = FeedType::CuttingMinute,
        450 => run.modal.outside = Outside::Circle,
        451 => run.modal.outside = Outside::Meeting,
        62 | 140..=143 | 290 | 291 | 340 | 341 | 452 | 453 | 460..=462 | 601..=603 | 621 | 641..=645 => {}
        _ => return false,
    }
    true
}

pub fn nct(run: &mut Interpreter, code: u16, found: &mut Words) -> bool {
    match code {
        31 => found.path.measure = Some(Measure { input: 1, goes_on: false }),
        43 | 98 | 99 => {}
        49 => run.sim.with_length(|control| control.edge = 0),
        58 | 59 => run.sim.control.activate(usize::from(code) - 53),
        _ => return false,
    }
    true
}
