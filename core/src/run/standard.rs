//! Standard cycles in a run: holes along their planes, patterns of positions. Feeds are simple and dwells are left out;
//! depths, positions and the end are those of the cycle.

use super::{Call, Datum, Halt, Interpreter, Motion, Next, Path, action, contour, motion};
use super::{FeedType, path::Coordinate};
use crate::control::Transverse;
use crate::control::units::INCH;
use crate::diagnostic::Span;
use crate::problem::Problem;
use crate::program::standard::{Standard, Way, Work, driven};

/// Most positions of a pattern.
const POSITIONS: f64 = 10_000.0;
/// Most steps of a deep hole; one with more is drilled at once.
const PECKS: usize = 1000;
/// How far a drill goes back to break the chip where the call does not say it, mm.
const BREAK: f64 = 1.0;
/// Arguments without which no hole is drilled: retraction plane, reference plane, safety clearance.
const PLANES: usize = 3;

/// Positions of a pattern at which the modal program is still to be called, the next one last.
#[derive(Clone, Debug, Default)]
pub struct Pattern {
    /// Program level and block of the pattern.
    of: (usize, usize),
    left: Vec<[f64; 2]>,
}

/// Whether a call has the values that its motion needs.
pub fn has_values(standard: &Standard, call: &Call) -> bool {
    let there = |name: &str| standard.place(name).and_then(|at| call.arg(at)).and_then(Datum::number).is_some();
    match standard.work {
        Work::Drill(_) => standard.args.iter().take(PLANES).all(|name| there(name)) && (there("DP") || there("DPR")),
        Work::Row | Work::Circle | Work::Grid => true,
    }
}

/// Carries out a cycle; a modal program at a position of a pattern goes on there.
pub fn perform(run: &mut Interpreter, at: usize, standard: &Standard, call: &Call) -> Result<Option<Next>, Halt> {
    let values = Values { standard, call, factor: run.sim.control.active_factor() };
    match standard.work {
        Work::Drill(way) => drill(run, way, &values).map(|()| None),
        Work::Row | Work::Circle | Work::Grid => positions(run, at, &values),
    }
}

/// The arguments of a call by their names.
struct Values<'a> {
    standard: &'a Standard,
    call: &'a Call,
    /// mm in a length of the program.
    factor: f64,
}

impl Values<'_> {
    /// A number as written, 0 where it is omitted.
    fn number(&self, name: &str) -> f64 {
        let written = self.standard.place(name).and_then(|place| self.call.arg(place)?.number());
        written.filter(|number| number.is_finite()).unwrap_or(0.0)
    }

    fn length(&self, name: &str) -> f64 {
        self.number(name) * self.factor
    }

    fn span(&self) -> Span {
        self.call.span
    }
}

/// A hole where the tool stands.
struct Hole {
    /// Axis of the hole.
    axis: usize,
    retraction: f64,
    /// Reference plane and the safety clearance before it.
    start: f64,
    depth: f64,
    /// 1 or -1: from the hole to its outside.
    out: f64,
    reference: f64,
}

impl Hole {
    /// Planes of a call; a depth from the reference plane counts where both are given.
    fn of(run: &Interpreter, values: &Values) -> Hole {
        let [retraction, reference] = ["RTP", "RFP"].map(|name| values.length(name));
        let out = if retraction < reference { -1.0 } else { 1.0 };
        let relative = values.length("DPR");
        let depth = if relative == 0.0 { values.length("DP") } else { reference - out * relative.abs() };
        let axes = run.sim.control.plane.axes();
        let axis = match values.number("_AXN") {
            1.0 => axes[0],
            2.0 => axes[1],
            _ => axes[2],
        };
        Hole { axis, retraction, start: reference + out * values.length("SDIS").abs(), depth, out, reference }
    }

    /// Along the axis of the hole, to a height.
    fn to(
        &self,
        run: &mut Interpreter,
        span: Span,
        motion: Motion,
        height: f64,
        feed: Option<f64>,
    ) -> Result<(), Halt> {
        let mut axes = [None; 3];
        axes[self.axis] = Some(height);
        go(run, span, motion, axes, feed)
    }
}

fn drill(run: &mut Interpreter, way: Way, values: &Values) -> Result<(), Halt> {
    let (hole, span) = (Hole::of(run, values), values.span());
    hole.to(run, span, Motion::Rapid, hole.start, None)?;
    match way {
        Way::Plain => hole.to(run, span, Motion::Line, hole.depth, None)?,
        Way::Reamed => {
            let feed = |name| Some(values.number(name)).filter(|feed| *feed > 0.0);
            hole.to(run, span, Motion::Line, hole.depth, feed("FFR"))?;
            hole.to(run, span, Motion::Line, hole.start, feed("RFF"))?;
        }
        Way::Pecks => pecks(run, &hole, values)?,
        Way::Thread => thread(run, &hole, values)?,
    }
    hole.to(run, span, Motion::Rapid, hole.retraction, None)
}

/// A deep hole: back to its start (VARI 1), or a little to break the chip, after each step but the last.
fn pecks(run: &mut Interpreter, hole: &Hole, values: &Values) -> Result<(), Halt> {
    let span = values.span();
    let steps = steps(hole, values);
    for (at, depth) in steps.iter().enumerate() {
        hole.to(run, span, Motion::Line, *depth, None)?;
        if at + 1 == steps.len() {
            break;
        }
        if values.number("VARI") == 1.0 {
            hole.to(run, span, Motion::Rapid, hole.start, None)?;
            let before = before(hole, *depth, values);
            hole.to(run, span, Motion::Rapid, before, None)?;
        } else {
            let back = values.length("_VRT");
            let back = if back > 0.0 { back } else { BREAK };
            hole.to(run, span, Motion::Line, depth + hole.out * back, None)?;
        }
        run.sim.room().map_err(Halt::at(span))?;
    }
    Ok(())
}

/// Where rapid traverse ends before the depth of the last step: as far as _DIS1 says, else by the depth: 0.6 mm to
/// 30 mm, then a fiftieth of it, at most 7 mm.
fn before(hole: &Hole, depth: f64, values: &Values) -> f64 {
    let drilled = (hole.reference - depth).abs();
    let away = match values.length("_DIS1") {
        own if own > 0.0 => own,
        _ if drilled <= 30.0 => 0.6,
        _ => (drilled / 50.0).min(7.0),
    };
    let limit = (hole.start - depth).abs();
    depth + hole.out * away.min(limit)
}

/// Depths of the steps, the last is that of the hole. Each is smaller than the one before by DAM (or this part of it,
/// where it is negative), as long as it is not below DAM or _MDEP; what is left of two smallest is halved.
fn steps(hole: &Hole, values: &Values) -> Vec<f64> {
    let whole = (hole.reference - hole.depth).abs();
    let first = match values.length("FDPR") {
        0.0 if values.number("FDEP") == 0.0 => whole,
        0.0 => (hole.reference - values.length("FDEP")).abs(),
        relative => relative.abs(),
    };
    let (less, least) = (values.number("DAM"), values.length("_MDEP").abs());
    let smaller = |step: f64| match less {
        factor if factor < 0.0 => (step * -factor).max(least),
        amount if amount > 0.0 => (step - amount * values.factor).max(amount * values.factor).max(least),
        _ => step,
    };
    let (mut found, mut drilled, mut step) = (Vec::new(), 0.0, first);
    while step > 0.0 && found.len() < PECKS {
        let left = whole - drilled;
        let smallest = smaller(step) >= step;
        step = if smallest && left > step && left < 2.0 * step { left / 2.0 } else { step };
        drilled += step;
        if drilled >= whole - 1e-9 {
            break;
        }
        found.push(hole.reference - hole.out * drilled);
        step = smaller(step).min(whole);
    }
    if found.len() == PECKS {
        found.clear();
    }
    found.push(hole.depth);
    found
}

/// A tapped hole: in and out with the lead of the thread at the speed of the call, or of the spindle.
fn thread(run: &mut Interpreter, hole: &Hole, values: &Values) -> Result<(), Halt> {
    let speed = [values.number("SST"), run.modal.speed].into_iter().find(|speed| *speed != 0.0).unwrap_or(0.0);
    let lead = lead(values);
    let feed = Some(speed.abs() * lead).filter(|feed| *feed > 0.0);
    let motion = if feed.is_none() && run.modal.feed <= 0.0 { Motion::Rapid } else { Motion::Line };
    let kind = run.modal.feed_type;
    if feed.is_some() {
        run.modal.feed_type = FeedType::Minute;
    }
    let own = feed.map(|feed| feed / run.sim.control.data_factor());
    let done = hole
        .to(run, values.span(), motion, hole.depth, own)
        .and_then(|()| hole.to(run, values.span(), motion, hole.start, own));
    run.modal.feed_type = kind;
    done
}

/// Leads of the coarse metric threads M3 to M48, mm (ISO 261).
const LEADS: [(f64, f64); 21] = [
    (3.0, 0.5),
    (4.0, 0.7),
    (5.0, 0.8),
    (6.0, 1.0),
    (8.0, 1.25),
    (10.0, 1.5),
    (12.0, 1.75),
    (14.0, 2.0),
    (16.0, 2.0),
    (18.0, 2.5),
    (20.0, 2.5),
    (22.0, 2.5),
    (24.0, 3.0),
    (27.0, 3.0),
    (30.0, 3.5),
    (33.0, 3.5),
    (36.0, 4.0),
    (39.0, 4.0),
    (42.0, 4.5),
    (45.0, 4.5),
    (48.0, 5.0),
];

/// Lead of a thread, mm: PIT in the unit of _PTAB (1 mm, 2 threads an inch, 3 inch), or that of the size MPIT; else 0.
fn lead(values: &Values) -> f64 {
    let (written, size) = (values.number("PIT").abs(), values.number("MPIT").abs());
    match values.number("_PTAB") {
        _ if written == 0.0 => LEADS.iter().find(|(known, _)| *known == size).map_or(0.0, |(_, lead)| *lead),
        1.0 => written,
        2.0 => INCH / written,
        3.0 => INCH * written,
        _ => written * values.factor,
    }
}

/// Goes to the positions of a pattern; at each the modal cycle works.
fn positions(run: &mut Interpreter, at: usize, values: &Values) -> Result<Option<Next>, Halt> {
    let of = (run.levels.len(), at);
    let mut left = match std::mem::take(&mut run.pattern) {
        pattern if pattern.of == of && !pattern.left.is_empty() => pattern.left,
        _ => points(run, values)?,
    };
    let modal = run.levels.last().and_then(|level| level.modal.clone());
    let modal = modal.filter(|modal| driven(&modal.name).is_none_or(|one| matches!(one.work, Work::Drill(_))));
    let [a, o, _] = run.sim.control.plane.axes();
    while let Some([x, y]) = left.pop() {
        let mut axes = [None; 3];
        (axes[a], axes[o]) = (Some(x), Some(y));
        let written = std::mem::replace(&mut run.sim.control.transverse, Transverse::Radius);
        let gone = go(run, values.span(), Motion::Rapid, axes, None);
        run.sim.control.transverse = written;
        gone?;
        run.sim.room().map_err(Halt::at(values.span()))?;
        run.work += 1;
        let Some(modal) = &modal else { continue };
        if let Some(next) = action::carry_out(run, at, modal, 1)? {
            if let Some(level) = run.levels.last_mut().filter(|_| !left.is_empty()) {
                level.again = true;
                run.pattern = Pattern { of, left };
            }
            return Ok(Some(next));
        }
    }
    Ok(None)
}

/// Positions of a pattern in the plane, mm, the first one last. A row and a grid begin at the end or corner that is
/// nearest to where the tool stands.
fn points(run: &Interpreter, values: &Values) -> Result<Vec<[f64; 2]>, Problem> {
    let mut found = match values.standard.work {
        Work::Circle => circle(values)?,
        Work::Grid => grid(run, values)?,
        Work::Row | Work::Drill(_) => row(run, values)?,
    };
    found.reverse();
    Ok(found)
}

/// A number of positions.
fn count(values: &Values, name: &str) -> Result<usize, Problem> {
    let number = values.number(name).trunc();
    if number > POSITIONS {
        return Err(Problem::new("run-range", values.span(), name));
    }
    Ok(number.max(0.0) as usize)
}

fn row(run: &Interpreter, values: &Values) -> Result<Vec<[f64; 2]>, Problem> {
    let line = Line { from: ["SPCA", "SPCO"].map(|name| values.length(name)), angle: values.number("STA1") };
    let [first, apart] = ["FDIS", "DBH"].map(|name| values.length(name));
    let mut found: Vec<_> = (0..count(values, "NUM")?).map(|i| line.at(first + apart * i as f64, 0.0)).collect();
    if let [begin, .., end] = found[..]
        && nearer(run, end, begin)
    {
        found.reverse();
    }
    Ok(found)
}

/// Positions on a circle, INDA apart; 0 spreads them over the whole circle.
fn circle(values: &Values) -> Result<Vec<[f64; 2]>, Problem> {
    let count = count(values, "NUM")?;
    let centre = ["CPA", "CPO"].map(|name| values.length(name));
    let (radius, own) = (values.length("RAD"), values.number("INDA"));
    let step = if own == 0.0 { 360.0 / count.max(1) as f64 } else { own };
    let at = |i: usize| Line { from: centre, angle: values.number("STA1") + step * i as f64 }.at(radius, 0.0);
    Ok((0..count).map(at).collect())
}

/// Rows of a grid, each begun where the one before it ended.
fn grid(run: &Interpreter, values: &Values) -> Result<Vec<[f64; 2]>, Problem> {
    let line = Line { from: ["_SPCA", "_SPCO"].map(|name| values.length(name)), angle: values.number("_STA") };
    let [apart, rows] = ["_DIS1", "_DIS2"].map(|name| values.length(name));
    let [columns, lines] = [count(values, "_NUM1")?, count(values, "_NUM2")?];
    if columns as f64 * lines as f64 > POSITIONS {
        return Err(Problem::new("run-range", values.span(), "_NUM1"));
    }
    let at = |column: usize, row: usize| line.at(apart * column as f64, rows * row as f64);
    let last = [columns.saturating_sub(1), lines.saturating_sub(1)];
    let mut begin = [0, 0];
    for corner in [[last[0], 0], [0, last[1]], last] {
        if nearer(run, at(corner[0], corner[1]), at(begin[0], begin[1])) {
            begin = corner;
        }
    }
    let from = |begin: usize, last: usize, i: usize| if begin == 0 { i } else { last - i };
    let place = |i: usize| {
        let (row, column) = (i / columns, i % columns);
        let column = if row % 2 == 0 { column } else { last[0] - column };
        at(from(begin[0], last[0], column), from(begin[1], last[1], row))
    };
    Ok((0..columns * lines).map(place).collect())
}

/// Whether the first point is nearer to where the tool stands.
fn nearer(run: &Interpreter, one: [f64; 2], other: [f64; 2]) -> bool {
    let [a, o, _] = run.sim.control.plane.axes();
    let stands = run.sim.control.to_workpiece(contour::stands(run));
    let away = |point: [f64; 2]| contour::distance(point, [stands[a], stands[o]]);
    away(one) < away(other) - 1e-9
}

/// A direction in the plane from a point.
struct Line {
    from: [f64; 2],
    /// Degree, from the abscissa.
    angle: f64,
}

impl Line {
    /// So far along it and to the left of it, mm.
    fn at(&self, along: f64, left: f64) -> [f64; 2] {
        let (sine, cosine) = self.angle.to_radians().sin_cos();
        [self.from[0] + along * cosine - left * sine, self.from[1] + along * sine + left * cosine]
    }
}

/// To absolute positions, mm, with the feed F or one that is written like it.
fn go(
    run: &mut Interpreter,
    span: Span,
    motion: Motion,
    axes: [Option<f64>; 3],
    feed: Option<f64>,
) -> Result<(), Halt> {
    let axes = axes.map(|axis| axis.map(|value| Coordinate { value, absolute: Some(true), diameter: None }));
    let before = std::mem::replace(&mut run.modal.motion, motion);
    let gone = motion::go(run, &Path { axes, feed, span, ..Path::default() });
    run.modal.motion = before;
    gone
}
