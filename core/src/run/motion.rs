//! Motion of a program: straight lines, arcs, measuring blocks.

use super::{
    Address, Compensation, Coordinate, FeedType, Halt, Interpreter, Measure, Motion, Path, Suppress, addresses,
    arcs::Arc, contour, mode, polar, rounded, rounded::Rounded,
};
use crate::control::units::INCH;
use crate::control::{AXES, Transverse, Units};
use crate::diagnostic::Severity;
use crate::geometry::{Around, Degrees, Dir, Mcs, V3, Wcs, arc};
use crate::machine::{MotionKind, Route, Sim};
use crate::problem::Problem;
use std::f64::consts::TAU;

/// Axes that differ by less have not moved, mm.
const STILL: f64 = 1e-9;

pub fn go(run: &mut Interpreter, path: &Path) -> Result<(), Halt> {
    let from = position(run, path.suppress);
    if let Some(kind) = path.pole {
        polar::set_pole(run, path, kind, from);
        return Ok(());
    }
    let counts = |axis: &Option<Coordinate>| axis.is_some_and(|axis| !axis.absolute.unwrap_or(run.modal.absolute));
    let base = if path.axes.iter().any(counts) { incremental_base(run, path.suppress, from) } else { from };
    let to = std::array::from_fn(|i| target(run, from[i], base[i], path.axes[i], i));
    let to = polar::target(run, path, from, to);
    let Some(to) = polar::along(run, path, from, to) else {
        return Err(Problem::new("run-not-simulated", path.span, "ANG").into());
    };
    let feed = feed(run, path, to);
    let with_feed = run.modal.motion != Motion::Rapid || path.measure.is_some();
    if with_feed && feed <= 0.0 {
        run.tell(Severity::Error, &Problem::new("run-no-feed", path.span, ""));
    }
    let feed = if inverse(run, path) { feed } else { mode::feed(run, feed) };
    let outcome = match path.measure {
        Some(measure) => {
            let feed = timed(run, path, feed, &Route::straight(Mcs(from), Mcs(to)));
            let done = uncompensated(run, path).and_then(|()| measured(run, path, measure, to, feed));
            ends(run, path, [from, to], None);
            done
        }
        None => match rounded::corner(run, path, [from, to]) {
            Some(corner) => return with_corner(run, path, [from, to], &corner, feed),
            None => driven(run, path, [from, to], feed),
        },
    };
    let arrived = path.measure.is_none() && path.suppress == Suppress::Nothing && run.contour.is_none();
    let end = match arrived && run.modal.motion.is_straight() && outcome.is_ok() {
        true => Wcs(to),
        false => run.sim.control.to_workpiece(contour::stands(run)),
    };
    run.programmed = (nose(run), end);
    outcome
}

/// `POS[X]=5`: the axis moves by itself, fast and straight. Where frames turn it is refused, as on the control.
pub fn position_axis(run: &mut Interpreter, address: &Address) -> Result<(), Halt> {
    let span = address.span;
    if run.sim.control.rotated() {
        return Err(Problem::new("run-not-simulated", span, "POS").into());
    }
    let mut path = Path { span, ..Path::default() };
    addresses::take(run, address, &mut path)?;
    let motion = std::mem::replace(&mut run.modal.motion, Motion::Rapid);
    let gone = contour::leave(run).and_then(|()| go(run, &path));
    run.modal.motion = motion;
    run.tangent = None;
    gone
}

/// Straight, or round an axis, with the tool on the path or beside it.
fn driven(run: &mut Interpreter, path: &Path, [from, to]: [[f64; 3]; 2], feed: f64) -> Result<(), Halt> {
    let no_arc = || Problem::new("run-arc", path.span, "");
    let arc = match run.modal.motion {
        motion if motion.is_straight() => None,
        Motion::Tangential => tangential(run, path, from, to)?,
        Motion::Through => Some(through(run, path, from, to).ok_or_else(no_arc)?),
        _ => Some(in_plane(run, path, from, to).ok_or_else(no_arc)?),
    };
    let way = match arc {
        Some((to, around)) => around_axis(run, path, [from, to], around).ok_or_else(no_arc)?,
        None => {
            let from = match path.suppress {
                Suppress::Nothing => contour::stands(run),
                _ => run.sim.position,
            };
            Route::straight(from, machine(run, path.suppress, to))
        }
    };
    let feed = timed(run, path, feed, &way);
    along(run, path, way, feed)?;
    ends(run, path, [from, to], arc);
    Ok(())
}

/// Keeps the direction in which a motion ended; what did not move changes nothing.
fn ends(run: &mut Interpreter, path: &Path, [from, to]: [[f64; 3]; 2], arc: Option<InPlane>) {
    let direction = match arc {
        Some((to, around)) => around.leaves(from, to),
        None => V3::from(to) - V3::from(from),
    };
    if path.suppress != Suppress::Nothing {
        run.tangent = None;
    } else if direction.norm() > STILL {
        run.tangent = Some(direction.into());
    }
}

/// The feed on a way, mm/min: where F tells the time of the block, the way in that time.
fn timed(run: &Interpreter, path: &Path, feed: f64, way: &Route) -> f64 {
    if inverse(run, path) { feed * way.length() } else { feed }
}

/// Whether F tells the time of the block.
fn inverse(run: &Interpreter, path: &Path) -> bool {
    run.modal.feed_type == FeedType::Inverse && path.feed.is_none()
}

/// To where a corner begins, and along it; increments of the next block count from the corner itself.
fn with_corner(
    run: &mut Interpreter,
    path: &Path,
    [from, to]: [[f64; 3]; 2],
    corner: &Rounded,
    feed: f64,
) -> Result<(), Halt> {
    let [start, begin, end, at] = [from, corner.begin, corner.end, to].map(|end| machine(run, path.suppress, end));
    let feed = timed(run, path, feed, &Route::straight(start, at));
    along(run, path, Route::straight(start, begin), feed)?;
    let seen = corner.around.and_then(|around| around.mapped(|point| machine(run, path.suppress, point)));
    if seen.is_none() && corner.around.is_some() {
        return Err(Problem::new("run-arc", path.span, "").into());
    }
    let own = path.corner_feed.or(Some(run.modal.corner_feed)).filter(|feed| *feed > 0.0);
    let own = own.map(|own| in_minutes(run, own * run.sim.control.data_factor(), to));
    along(run, path, Route { from: begin, to: end, around: seen }, own.unwrap_or(feed))?;
    run.programmed = (nose(run), Wcs(to));
    run.tangent = None; // what goes on behind a corner is a line
    Ok(())
}

/// Along a way in the machine, with the tool on the path or beside it.
fn along(run: &mut Interpreter, path: &Path, way: Route, feed: f64) -> Result<(), Halt> {
    let (kind, feed) = match run.modal.motion {
        Motion::Rapid => (MotionKind::Rapid, 0.0),
        _ => (MotionKind::Positioning, feed),
    };
    if path.suppress == Suppress::Nothing && contour::concerns(run, &way) {
        return contour::follow(run, &contour::Motion { way, kind, feed, span: path.span });
    }
    uncompensated(run, path)?;
    run.sim.travel_machine(way.to, way.around, kind, feed, false).map_err(Halt::at(path.span))
}

/// What comes now is driven as programmed, whatever compensation is on.
fn uncompensated(run: &mut Interpreter, path: &Path) -> Result<(), Halt> {
    if run.modal.compensation != Compensation::Off {
        run.tell(Severity::Warning, &Problem::new("run-radius-compensation", path.span, ""));
    }
    contour::leave(run)
}

/// Turns the rotary axes of a block, before the others move.
pub fn turn(run: &mut Interpreter, path: &Path) -> Result<(), Halt> {
    for (axis, position) in path.rotary.into_iter().enumerate() {
        if let Some(position) = position {
            contour::finish(run)?;
            run.sim.turn_table(axis, position).map_err(Halt::at(path.span))?;
        }
    }
    Ok(())
}

/// Where the program has the spindle nose: no new frame and no new tool moves it.
fn nose(run: &Interpreter) -> Mcs {
    contour::stands(run) + run.sim.control.active_length()
}

/// Where a machine stands before its first motion: the spindle nose, and the position in the WCS.
pub fn standing(sim: &Sim) -> (Mcs, Wcs) {
    (sim.position + sim.control.active_length(), sim.control.to_workpiece(sim.position))
}

/// From where incremental positions count: the programmed end of the last motion, also where a frame or tool has
/// changed since (SD 42440, SD 42442 as delivered); where something else moved the axes, their position.
fn incremental_base(run: &Interpreter, suppress: Suppress, from: [f64; 3]) -> [f64; 3] {
    let end = run.programmed.1;
    if suppress == Suppress::Nothing && is_where_it_went(run) { end.0 } else { from }
}

/// Whether the axes stand where the last motion of the program left them: nothing else has moved them since.
fn is_where_it_went(run: &Interpreter) -> bool {
    (nose(run) - run.programmed.0).iter().all(|way| way.abs() < STILL)
}

/// mm/min, 0 where there is none; with a constant cutting speed that at the target.
fn feed(run: &Interpreter, path: &Path, to: [f64; 3]) -> f64 {
    let feed = match path.feed {
        Some(own) => own * run.sim.control.data_factor(),
        None => run.modal.feed * run.modal.feed_factor,
    };
    if inverse(run, path) {
        return run.modal.feed; // a way only with the length of the block
    }
    in_minutes(run, feed, to)
}

/// A feed that is written like F, mm/min.
fn in_minutes(run: &Interpreter, feed: f64, to: [f64; 3]) -> f64 {
    match run.modal.feed_type {
        FeedType::Minute | FeedType::CuttingMinute | FeedType::Inverse => feed,
        FeedType::Revolution => feed * run.modal.speed.abs(),
        FeedType::Cutting => feed * turns(run, to[0].abs()),
    }
}

/// Speed of the main spindle where the tool stands, revolutions a minute.
pub fn spindle_speed(run: &Interpreter) -> f64 {
    match run.modal.feed_type {
        FeedType::Minute | FeedType::Revolution | FeedType::Inverse => run.modal.speed,
        FeedType::Cutting | FeedType::CuttingMinute => turns(run, position(run, Suppress::Nothing)[0].abs()),
    }
}

/// Revolutions a minute with which the circumference passes as fast as S says, m or feet a minute, at this distance
/// from the turning centre, mm; LIMS is the most. None, 0, at the centre itself without LIMS.
fn turns(run: &Interpreter, distance: f64) -> f64 {
    let a_minute = run.modal.speed.abs()
        * match run.sim.control.active_units {
            Units::Metric => 1000.0,
            Units::Inch => 12.0 * INCH,
        };
    if a_minute == 0.0 {
        return 0.0; // a spindle that stands does so at the centre too
    }
    let turns = a_minute / (TAU * distance);
    match run.modal.speed_limit {
        Some(limit) => turns.min(limit),
        None if turns.is_finite() => turns,
        None => 0.0,
    }
}

/// Target of an axis that stands at `from`, mm; increments count from `base`.
pub fn target(run: &Interpreter, from: f64, base: f64, written: Option<Coordinate>, axis: usize) -> f64 {
    let Some(Coordinate { value, absolute, diameter }) = written else { return from };
    let absolute = absolute.unwrap_or(run.modal.absolute);
    let value = value * radius_of(run, axis, absolute, diameter);
    if absolute { value } else { base + value }
}

/// What a written coordinate of an axis is multiplied with: one half for a diameter, as the block itself says or as is
/// active.
fn radius_of(run: &Interpreter, axis: usize, absolute: bool, own: Option<bool>) -> f64 {
    let active = match run.sim.control.transverse {
        Transverse::Radius => false,
        Transverse::Diameter => true,
        Transverse::AbsoluteDiameter => absolute,
    };
    if axis == 0 && own.unwrap_or(active) { 0.5 } else { 1.0 }
}

fn position(run: &Interpreter, suppress: Suppress) -> [f64; 3] {
    let control = &run.sim.control;
    match suppress {
        Suppress::Nothing => control.to_workpiece(contour::stands(run)).0,
        Suppress::Settable => control.basic_chain().iter().fold(run.sim.position.0, |point, frame| frame.inward(point)),
        Suppress::All => run.sim.position.0,
    }
}

fn machine(run: &Interpreter, suppress: Suppress, point: [f64; 3]) -> Mcs {
    let control = &run.sim.control;
    match suppress {
        Suppress::Nothing => control.to_machine(Wcs(point)),
        Suppress::Settable => Mcs(control.basic_chain().iter().rev().fold(point, |point, frame| frame.outward(point))),
        Suppress::All => Mcs(point),
    }
}

/// A target and the way there round an axis, both in the coordinates of the block.
type InPlane = ([f64; 3], Around<[f64; 3]>);

/// Such a way in the machine; none: it is no circle there.
fn around_axis(run: &Interpreter, path: &Path, [from, to]: [[f64; 3]; 2], around: Around<[f64; 3]>) -> Option<Route> {
    let seen = |point| machine(run, path.suppress, point);
    Some(Route { from: seen(from), to: seen(to), around: Some(around.mapped(seen)?) })
}

/// `MEAS=1 G1 X100`, on NCT `G31 X100`: stops at the signal; `$AC_MEA`, `$AA_MW`, `$AA_MM` tell where (B:12790-12856),
/// on NCT #5061 (N 183). The sign is the edge: with `MEAS=-1` the signal is that of a stylus that comes free. Behind
/// the signal of `MEAW` the stylus is deflected until the end.
fn measured(run: &mut Interpreter, path: &Path, measure: Measure, to: [f64; 3], feed: f64) -> Result<(), Halt> {
    let to = machine(run, path.suppress, to);
    let input = measure.input.abs();
    let wired = run.sim.measuring_input().filter(|wired| *wired != input && !run.program.grammar().numbered);
    if let Some(wired) = wired {
        let told = Problem::new("run-measuring-input", path.span, format!("MEAS={}", measure.input));
        run.tell(Severity::Warning, &told.number("input", wired as f64));
    }
    let latched = match measure.input < 0 {
        true => run.sim.release_machine(to, feed),
        false => run.sim.probe_machine(to, feed),
    };
    let latched = latched.map_err(Halt::at(path.span))?;
    run.measured.insert(format!("$AC_MEA[{input}]"), f64::from(u8::from(latched.is_some())));
    let Some(position) = latched else { return Ok(()) };
    let control = &run.sim.control;
    let (own, length) = (control.to_workpiece(position), control.active_length());
    let factor = control.data_factor();
    for (i, axis) in AXES.iter().enumerate() {
        let shown = if i == 0 { control.transverse.shown() } else { 1.0 };
        let basic = position[i] / factor;
        for (name, value) in [("MW", own[i] * shown / factor), ("MB", basic), ("MM", basic + length[i] / factor)] {
            run.measured.insert(format!("$AA_{name}[{axis}]"), value);
        }
    }
    if measure.goes_on {
        run.sim.press_on(to, feed);
    }
    Ok(())
}

/// CIP: the target, and the way there.
fn through(run: &Interpreter, path: &Path, from: [f64; 3], to: [f64; 3]) -> Option<InPlane> {
    let middle = std::array::from_fn(|i| target(run, from[i], from[i], path.middle[i], i));
    Some((to, arc::through(from, middle, to)?))
}

/// An arc or a helix in the working plane: the target, which an opening angle may tell, and the way there.
fn in_plane(run: &Interpreter, path: &Path, from: [f64; 3], to: [f64; 3]) -> Option<InPlane> {
    Some(placed(run, arc(run, path, from, to)?, from, to))
}

/// CT: an arc or a helix that goes on in the plane as the last motion ended there; none: straight on. Where nothing
/// moved before, or something else has moved since, or only across the plane, nobody knows how. A new frame takes the
/// direction with it (Fundamentals, circle with tangential transition).
fn tangential(run: &Interpreter, path: &Path, from: [f64; 3], to: [f64; 3]) -> Result<Option<InPlane>, Problem> {
    let [a, o, _] = run.sim.control.plane.axes();
    let known = run.tangent.filter(|_| path.suppress == Suppress::Nothing && is_where_it_went(run));
    let seen = known.map(|tangent| [tangent[a], tangent[o]]).filter(|[x, y]| x.hypot(*y) > STILL);
    let tangent = seen.ok_or_else(|| Problem::new("run-not-simulated", path.span, "CT"))?;
    let found = Arc::tangential(tangent, [from[a], from[o]], [to[a], to[o]]);
    let found = found.filter(|arc| arc.is_some() || path.turns == 0.0);
    let arc = found.ok_or_else(|| Problem::new("run-arc", path.span, ""))?;
    Ok(arc.map(|arc| placed(run, arc.with_turns(path.turns), from, to)))
}

/// An arc of the plane in space.
fn placed(run: &Interpreter, arc: Arc, from: [f64; 3], to: [f64; 3]) -> InPlane {
    let [a, o, p] = run.sim.control.plane.axes();
    let (mut centre, mut axis, mut end) = (from, Dir::default(), to);
    [centre[a], centre[o]] = arc.centre;
    [end[a], end[o]] = arc.end;
    axis[p] = 1.0;
    (end, Around { centre, axis, degrees: Degrees::of(arc.sweep) })
}

/// The arc in the plane: with a radius or an opening angle, else about a centre.
fn arc(run: &Interpreter, path: &Path, from: [f64; 3], to: [f64; 3]) -> Option<Arc> {
    let [a, o, _] = run.sim.control.plane.axes();
    let counter = run.modal.motion == Motion::Counter;
    let (start, end) = ([from[a], from[o]], [to[a], to[o]]);
    let centred = path.centre[a].is_some() || path.centre[o].is_some();
    if path.polar.is_written() && !centred && path.radius.is_none() && path.angle.is_none() {
        return Some(Arc::about(run.modal.pole, start, end, counter)?.with_turns(path.turns));
    }
    let centre = [a, o].map(|i| match path.centre[i] {
        Some(Coordinate { value, absolute: Some(true), .. }) => value * radius_of(run, i, true, None),
        Some(Coordinate { value, .. }) => from[i] + value,
        None => from[i],
    });
    let ends = path.axes[a].is_some() || path.axes[o].is_some();
    let arc = match (path.radius, path.angle) {
        (Some(radius), _) => Arc::with_radius(radius, start, end, counter),
        (None, Some(_)) if centred && ends => None,
        (None, Some(angle)) if centred => Arc::turned(centre, start, angle, counter),
        (None, Some(angle)) => Arc::with_angle(angle, start, end, counter),
        (None, None) => Arc::about(centre, start, end, counter),
    };
    Some(arc?.with_turns(path.turns))
}
