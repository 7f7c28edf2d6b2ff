//! G functions: motion, plane, frames, units, absolute and incremental.

use super::Stop;
use super::contour::Outside;
use super::interpret::Interpreter;
use super::modal::{Compensation, FeedType, Motion};
use super::path::{Measure, Pole, Suppress};
use super::problem::Problem;
use super::statement::Words;
use crate::catalogue::Dialect;
use crate::control::Plane;
use crate::diagnostic::Severity;

/// Applies the G functions of a block.
pub fn apply(run: &mut Interpreter, found: &mut Words) -> Result<(), Stop> {
    some(run, found, |_| true)
}

/// Applies the G functions that stand in a block beside the NCT macro that it calls (`G17 G110 D50`, C:1050).
pub fn apply_beside_macro(run: &mut Interpreter, found: &mut Words) -> Result<(), Stop> {
    some(run, found, |code| code < 100.0 && code != 65.0)
}

fn some(
    run: &mut Interpreter,
    found: &mut Words,
    counts: impl Fn(f64) -> bool,
) -> Result<(), Stop> {
    let codes: Vec<_> = found
        .addresses
        .iter()
        .filter(|address| address.name == "G")
        .filter_map(|address| address.value.number().map(|number| (number, address.span)))
        .filter(|(number, _)| counts(*number))
        .collect();
    for (number, span) in codes {
        let known = number.fract() == 0.0
            && (0.0..1000.0).contains(&number)
            && one(run, number as u16, found);
        if !known {
            run.tell(
                Severity::Error,
                &Problem::new("run-unknown-word", span, format!("G{number}")),
            );
        }
    }
    Ok(())
}

fn one(run: &mut Interpreter, code: u16, found: &mut Words) -> bool {
    let dialect = run.program.dialect;
    match code {
        0 => run.modal.motion = Motion::Rapid,
        1 => run.modal.motion = Motion::Line,
        2 => run.modal.motion = Motion::Clockwise,
        3 => run.modal.motion = Motion::Counter,
        4 => found.path.dwell = true,
        17 => run.sim.with_length(|control| control.plane = Plane::G17),
        18 => run.sim.with_length(|control| control.plane = Plane::G18),
        19 => run.sim.with_length(|control| control.plane = Plane::G19),
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
        _ if dialect == Dialect::Sinumerik => return sinumerik(run, code, found),
        _ => return nct(run, code, found),
    }
    true
}

fn sinumerik(run: &mut Interpreter, code: u16, found: &mut Words) -> bool {
    match code {
        110 => found.path.pole = Some(Pole::Position),
        111 => found.path.pole = Some(Pole::Zero),
        112 => found.path.pole = Some(Pole::Before),
        153 => found.path.suppress = Suppress::All,
        500 => run.sim.control.activate(0),
        505..=599 => run.sim.control.activate(usize::from(code) - 500),
        95 | 97 | 971 => run.modal.feed_type = FeedType::Revolution,
        96 | 962 => run.modal.feed_type = FeedType::Cutting,
        961 | 972 | 973 => run.modal.feed_type = FeedType::Minute,
        450 => run.modal.outside = Outside::Circle,
        451 => run.modal.outside = Outside::Meeting,
        62 | 140..=143 | 290 | 291 | 340 | 341 | 452 | 453 | 460..=462 | 601..=603 => {}
        621 | 641..=645 => {}
        _ => return false,
    }
    true
}

fn nct(run: &mut Interpreter, code: u16, found: &mut Words) -> bool {
    match code {
        31 => {
            found.path.measure = Some(Measure {
                input: 1,
                goes_on: false,
            });
        }
        43 => {}
        49 => run.sim.with_length(|control| control.edge = 0),
        58 | 59 => run.sim.control.activate(usize::from(code) - 53),
        98 | 99 => {}
        _ => return false,
    }
    true
}
