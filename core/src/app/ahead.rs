//! What the next key would do in a session of measuring in JOG, found out on a copy of it; where nobody is to know yet
//! how the part lies, on a copy whose table is empty.

use super::changes::Change;
use super::jog::{JogResult, changed, note, raised, results};
use super::outcome::Raised;
use crate::jog::mask::Show;
use crate::jog::states::Key;
use crate::jog::{Input, Mask, Session, State, offset};
use crate::machine::Step;
use crate::message::Message;
use crate::workpiece::Workpiece;
use serde::Serialize;

/// What NC start would do from where the probe is, with Calculate where it stores the last point; what Calculate would
/// do where all are stored.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct JogAhead {
    /// Whether NC start is the next key; else Calculate.
    pub start: bool,
    /// The point that would be stored, `P2`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub point: Option<String>,
    /// Whether it would wait for the user to store it.
    pub waits: bool,
    /// Positions at which the probe would switch, in the WCS of the measurement, mm.
    pub touches: Vec<[f64; 3]>,
    /// The alarm that would come, or what would be hit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub raised: Option<Raised>,
    /// Why nothing comes of the points.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<Message>,
    /// What the user should know of the touches.
    pub notes: Vec<Message>,
    /// Results that would be shown.
    pub results: Vec<JogResult>,
    /// What would be written.
    pub changes: Vec<Change>,
    /// Whether the activation screen would come up.
    pub activates: bool,
    /// What is known although nobody is to know yet how the part lies: there are no touches, results and changes then.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hidden: Option<JogHidden>,
}

/// What the call alone tells of a result.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct JogHidden {
    /// What would be shown.
    pub shows: Vec<Message>,
    /// The zero offset that would be corrected.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corrects: Option<String>,
}

/// A place that is touched again, as with a fast and a slow touch, counts once, mm.
const SAME: f64 = 1.0;

/// What the next key would do; none: neither NC start measures nor Calculate calculates now.
pub fn ahead(session: &Session) -> Option<JogAhead> {
    let mask = session.mask()?;
    let start = session.state() == State::Mask && session.takes(Key::Start);
    if !start && !session.takes(Key::Calculate) {
        return None;
    }
    let mut copy = session.clone();
    let done = carry_out(&mut copy, start);
    let steps = copy.sim.trace.entries.behind(session.sim.trace.entries.len());
    let steps: Vec<Step> = steps.map(|entry| entry.step).collect();
    let raised = copy.stopped().filter(|_| start).map(|stop| raised(&copy, stop));
    let stores = start && raised.is_none() && !mask.at_once();
    let point = session.points().iter().position(Option::is_none).filter(|_| stores);
    let calculates = raised.is_none() && done == Ok(true);
    Some(JogAhead {
        start,
        point: point.map(|number| format!("P{}", number + 1)),
        waits: mask.by_hand(),
        touches: touches(session, &steps),
        raised,
        refused: done.err(),
        notes: steps.iter().filter_map(note).collect(),
        results: if calculates { results(&copy) } else { Vec::new() },
        changes: steps.iter().filter_map(|step| changed(&copy.sim.control, step)).collect(),
        activates: copy.activation().is_some(),
        hidden: None,
    })
}

/// The same while nobody is to know how the part lies: what the call alone says. What Calculate would do follows from
/// points that are on the screen, and a tool is not the part.
pub fn hidden(session: &Session) -> Option<JogAhead> {
    let mask = session.mask()?;
    let start = session.state() == State::Mask && session.takes(Key::Start);
    if !start || mask.task.of_tool() {
        return ahead(session);
    }
    let raised = raised_at_once(session);
    let missing = session.points().iter().filter(|point| point.is_none()).count();
    let shows = raised.is_none() && !mask.by_hand() && (mask.at_once() || missing == 1);
    let (store, point) = (session.chosen(), session.points().iter().position(Option::is_none));
    let shown = mask.shows.iter().filter_map(|show| match show {
        Show::Length(name) | Show::Angle(name) => Some(session.label("result", name)),
        _ => None,
    });
    Some(JogAhead {
        start,
        point: point.filter(|_| raised.is_none() && !mask.at_once()).map(|number| format!("P{}", number + 1)),
        waits: mask.by_hand(),
        touches: Vec::new(),
        raised,
        refused: None,
        notes: Vec::new(),
        results: Vec::new(),
        changes: Vec::new(),
        activates: shows && store.is_some_and(|store| session.surely_activates(store)),
        hidden: Some(JogHidden {
            shows: if shows { shown.collect() } else { Vec::new() },
            corrects: store.filter(|_| shows).map(|store| offset::name(&session.sim.control, store)),
        }),
    })
}

/// The alarm that NC start raises before anything moves, whatever lies on the table.
fn raised_at_once(session: &Session) -> Option<Raised> {
    let mut copy = session.clone();
    copy.sim.equip(Workpiece::default(), Vec::new(), None);
    let before = copy.sim.trace.entries.len();
    copy.carry_out(Input::Start).ok()?;
    let moves = |step: Step| matches!(step, Step::Motion { from, to, .. } if from != to);
    let moved = copy.sim.trace.entries.behind(before).any(|entry| moves(entry.step));
    copy.stopped().filter(|_| !moved).map(|stop| raised(&copy, stop))
}

/// Whether something is calculated.
fn carry_out(session: &mut Session, start: bool) -> Result<bool, Message> {
    if start {
        session.carry_out(Input::Start)?;
    }
    let ready = if start { session.state() == State::Ready } else { session.takes(Key::Calculate) };
    if ready {
        session.press(Input::Calculate)?;
    }
    Ok(ready || session.mask().is_some_and(Mask::at_once))
}

/// Where the probe would switch, as the position is shown.
fn touches(session: &Session, steps: &[Step]) -> Vec<[f64; 3]> {
    let mut control = session.sim.control.clone();
    control.activate(session.measuring());
    let switched = steps.iter().filter_map(|step| match step {
        Step::Touch { latched, .. } => Some(control.to_workpiece(*latched).0),
        _ => None,
    });
    let mut touches: Vec<[f64; 3]> = Vec::new();
    for at in switched {
        match touches.last_mut().filter(|last| (0..3).all(|axis| (last[axis] - at[axis]).abs() < SAME)) {
            Some(last) => *last = at,
            None => touches.push(at),
        }
    }
    touches
}
