//! Motion of a program: targets from axis words, straight lines, arcs as chords.

use super::interpret::Interpreter;
use super::modal::{Compensation, Motion};
use super::problem::Problem;
use super::trace::MotionKind;
use super::{Machine, Stop};
use crate::diagnostic::{Severity, Span};
use crate::geometry::arc::chords;

/// How a block measures its positions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Suppress {
    /// In the WCS.
    #[default]
    Nothing,
    /// G53: without settable and programmed frame.
    Settable,
    /// G153, SUPA: without any frame.
    All,
}

/// Axis words of one block, mm.
#[derive(Clone, Debug, Default)]
pub struct Path {
    /// Target value by axis and whether it is absolute (AC), incremental (IC) or as the modal G90/G91 says.
    pub axes: [Option<(f64, Option<bool>)>; 3],
    /// Centre I J K, from the start.
    pub centre: [f64; 3],
    /// Whether a centre was given.
    pub centred: bool,
    /// CR or R: radius, negative for more than a half circle.
    pub radius: Option<f64>,
    /// Frames left out in this block.
    pub suppress: Suppress,
    /// MEAS or MEAW: number of the input, sign for the edge.
    pub measure: Option<i64>,
    /// Whether F is a time (G4).
    pub dwell: bool,
    /// Place of the block.
    pub span: Span,
}

impl Path {
    /// Whether the block moves.
    pub fn moves(&self) -> bool {
        self.axes.iter().any(Option::is_some) || (self.centred || self.radius.is_some())
    }
}

/// Carries out the motion of a block.
pub fn go(run: &mut Interpreter, path: &Path) -> Result<(), Stop> {
    if run.modal.compensation != Compensation::Off {
        run.tell(
            Severity::Warning,
            &Problem::new("run-radius-compensation", path.span, ""),
        );
    }
    let from = position(run, path.suppress);
    let to: [f64; 3] = std::array::from_fn(|i| match path.axes[i] {
        None => from[i],
        Some((value, mode)) => {
            if mode.unwrap_or(run.modal.absolute) {
                value
            } else {
                from[i] + value
            }
        }
    });
    let feed = run.modal.feed * run.modal.feed_factor;
    if run.modal.motion != Motion::Rapid && feed <= 0.0 {
        run.tell(Severity::Error, &Problem::new("run-no-feed", path.span, ""));
    }
    let outcome = match run.modal.motion {
        _ if path.measure.is_some() => measure(run, path, to, feed),
        Motion::Rapid => straight(run, path.suppress, to, MotionKind::Rapid, 0.0),
        Motion::Line | Motion::Spline => {
            straight(run, path.suppress, to, MotionKind::Positioning, feed)
        }
        _ => arc(run, path, from, to, feed),
    };
    outcome.map_err(|stop| run.stopped(stop, path.span))
}

fn position(run: &Interpreter, suppress: Suppress) -> [f64; 3] {
    let basic = run.sim.control.basic_chain();
    match suppress {
        Suppress::Nothing => run.sim.position(),
        Suppress::Settable => basic
            .iter()
            .fold(run.sim.position, |point, frame| frame.inward(point)),
        Suppress::All => run.sim.position,
    }
}

fn machine(run: &Interpreter, suppress: Suppress, point: [f64; 3]) -> [f64; 3] {
    let basic = run.sim.control.basic_chain();
    match suppress {
        Suppress::Nothing => run.sim.control.to_machine(point),
        Suppress::Settable => basic
            .iter()
            .rev()
            .fold(point, |point, frame| frame.outward(point)),
        Suppress::All => point,
    }
}

fn straight(
    run: &mut Interpreter,
    suppress: Suppress,
    to: [f64; 3],
    kind: MotionKind,
    feed: f64,
) -> Result<(), Stop> {
    let to = machine(run, suppress, to);
    run.sim.travel_machine(to, kind, feed, false)
}

/// `MEAS=1 G1 X100`: stops at the signal; `$AC_MEA`, `$AA_MW`, `$AA_MM` tell where (B:12790-12856).
fn measure(run: &mut Interpreter, path: &Path, to: [f64; 3], feed: f64) -> Result<(), Stop> {
    let to = machine(run, path.suppress, to);
    let latched = if run.sim.has_probe() {
        run.sim.probe_machine(to, feed)?
    } else {
        run.sim
            .travel_machine(to, MotionKind::Measuring, feed, false)?;
        None
    };
    let input = path.measure.unwrap_or(1).abs();
    run.measured.insert(
        format!("$AC_MEA[{input}]"),
        f64::from(u8::from(latched.is_some())),
    );
    if let Some(position) = latched {
        let (own, length) = (
            run.sim.control.to_workpiece(position),
            run.sim.control.active_length(),
        );
        let factor = run.sim.control.data_factor();
        for (i, axis) in crate::control::variables::AXES.iter().enumerate() {
            run.measured
                .insert(format!("$AA_MW[{axis}]"), own[i] / factor);
            run.measured.insert(
                format!("$AA_MM[{axis}]"),
                (position[i] + length[i]) / factor,
            );
        }
    }
    Ok(())
}

fn arc(
    run: &mut Interpreter,
    path: &Path,
    from: [f64; 3],
    to: [f64; 3],
    feed: f64,
) -> Result<(), Stop> {
    let [a, o, p] = run.sim.control.plane.axes();
    let counter = run.modal.motion == Motion::Counter;
    let start = [from[a], from[o]];
    let end = [to[a], to[o]];
    let centre = match path.radius {
        Some(radius) => centre_by_radius(start, end, radius, counter),
        None => Some([start[0] + path.centre[a], start[1] + path.centre[o]]),
    };
    let Some(centre) = centre.filter(|centre| fits(*centre, start, end)) else {
        return Err(Stop::Fault(Problem::new("run-arc", path.span, "").message));
    };
    let first = (start[1] - centre[1]).atan2(start[0] - centre[0]);
    let last = (end[1] - centre[1]).atan2(end[0] - centre[0]);
    let sweep = sweep(last - first, counter);
    let chords = chords(centre, start, sweep.to_degrees());
    for (i, [x, y]) in chords.iter().enumerate() {
        let part = (i + 1) as f64 / chords.len() as f64;
        let mut point = [0.0; 3];
        (point[a], point[o]) = (*x, *y);
        point[p] = from[p] + (to[p] - from[p]) * part;
        let point = if i + 1 == chords.len() { to } else { point };
        straight(run, path.suppress, point, MotionKind::Positioning, feed)?;
    }
    Ok(())
}

/// Both ends lie on one circle within 0.01 mm.
fn fits(centre: [f64; 2], start: [f64; 2], end: [f64; 2]) -> bool {
    let radius = |point: [f64; 2]| (point[0] - centre[0]).hypot(point[1] - centre[1]);
    radius(start) > 0.0 && (radius(start) - radius(end)).abs() <= 0.01
}

/// Angle from start to end, radian; a full circle where they are the same.
fn sweep(difference: f64, counter: bool) -> f64 {
    let turn = std::f64::consts::TAU;
    let positive = difference.rem_euclid(turn);
    let positive = if positive < 1e-9 { turn } else { positive };
    let whole = (positive - turn).abs() < 1e-9;
    match counter {
        true => positive,
        false if whole => -turn,
        false => positive - turn,
    }
}

fn centre_by_radius(
    start: [f64; 2],
    end: [f64; 2],
    radius: f64,
    counter: bool,
) -> Option<[f64; 2]> {
    let (dx, dy) = (end[0] - start[0], end[1] - start[1]);
    let length = dx.hypot(dy);
    let below = radius * radius - length * length / 4.0;
    if length == 0.0 || below < -1e-6 {
        return None;
    }
    let height = below.max(0.0).sqrt() / length;
    let side = if counter == (radius > 0.0) { 1.0 } else { -1.0 };
    Some([
        start[0] + dx / 2.0 - side * height * dy,
        start[1] + dy / 2.0 + side * height * dx,
    ])
}
