//! How the surface is followed, point by point (C:1278-1317, C:1336-1339). What each part stands for is named beside
//! it: RAPID WHEN SCANNING (O9960), PROBE FOR SCANNING (O9961), PROBE RETRACT (O9963), STEP (O9964), PROBE CHECK
//! (O9966), AXIAL PROBE (O9967), RADIAL PROBE (O9968), PROBE STATUS (O9984), IN POSITION CHECK (O9985).

use super::addresses::spacing;
use crate::catalogue::nct;
use crate::catalogue::nct::touch::{Calibration, POSITIONING};
use crate::catalogue::nct::{
    FALSE_TRIGGER, FORMAT_ERROR, OUT_OF_POSITION, PATH_OBSTRUCTED, SCANNING_FAIL, SCANNING_OBSTRUCTED,
    STYLUS_IN_CONTACT, axis_name,
};
use crate::catalogue::prelude::*;
use crate::machine::{MotionKind, Scanner};
use crate::scan::{Layout, Scanned};

/// Feed where F is not given, mm/min: then the points are right to 0.01 mm (C:1320).
const RATE: f64 = 120.0;
/// Accuracy a feed, mm per mm/min: 0.1 mm at F1200 (C:1318-1321); what the axis goes in 5 ms.
const ACCURACY: f64 = 0.1 / 1200.0;
/// Attempts at one position (C:1339).
const ATTEMPTS: usize = 3;
/// Least part of R by which a step goes on along the line, however steep the surface is.
const LEAST: f64 = 0.05;
/// Shorter ways are none, mm.
const NOTHING: f64 = 1e-6;

/// Where the stylus is, and what comes next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    /// Above the first point of a line.
    Above,
    /// At a point that was reached along the tool axis.
    Surface,
    /// At a wall that was met on the way along the line.
    Wall,
    /// At the deepest position, in nothing.
    Bottom,
    /// The line is done.
    End,
}

/// The scan on its way.
struct Follow {
    layout: Layout,
    /// Ball centre minus spindle axis (#504, #505).
    offset: [f64; 3],
    /// Start of the rectangle, and its end at the deepest position, WCS.
    start: Wcs,
    end: Wcs,
    spacing: f64,
    raster: f64,
    retract: f64,
    lines: usize,
    line: usize,
    state: State,
    /// Point before, along the line and along the tool.
    last: Option<[f64; 2]>,
    /// Direction of the surface there, along the line and along the tool.
    tangent: [f64; 2],
}

/// The scan before its first point.
pub fn scanner(machine: &mut dyn Machine, inputs: &Inputs) -> Result<Box<dyn Scanner>, Stop> {
    nct::ready_to_measure(machine)?;
    let start = machine.position();
    let format = Stop::Alarm(FORMAT_ERROR);
    let (spacing, along, across) = spacing(inputs).ok_or(format.clone())?;
    let mut layout = Layout::of(machine.control(), along, across);
    let [.., axial] = layout.axes;
    let mut end = start;
    for axis in layout.axes {
        end[axis] = inputs.number(axis_name(axis));
    }
    if end[axial] >= start[axial] {
        return Err(format);
    }
    layout.height = start[axial];
    layout.rate = inputs.given(address::F).unwrap_or(RATE);
    layout.accuracy = layout.rate * ACCURACY;
    layout.number = inputs.given(address::S).map(|number| number as i64);
    let calibrations = [0, 1].map(|index| Calibration::of(machine, index));
    layout.radius = calibrations.iter().map(|one| one.plus + one.minus).sum::<f64>() / 4.0;
    let mut offset = [0.0; 3];
    for (axis, one) in machine.control().plane.axes().into_iter().zip(&calibrations) {
        offset[axis] = one.offset;
    }
    if machine.control().limited(start, end).is_some() {
        return Err(Stop::Alarm(OUT_OF_POSITION));
    }
    Ok(Box::new(Follow {
        lines: lines((end[across] - start[across]).abs(), spacing),
        layout,
        offset,
        start,
        end,
        spacing,
        raster: inputs.number(address::R),
        retract: inputs.number(address::Q),
        line: 0,
        state: State::Above,
        last: None,
        tangent: [1.0, 0.0],
    }))
}

/// Lines over a distance: one each spacing, and one at the end where that leaves a rest.
fn lines(distance: f64, spacing: f64) -> usize {
    let whole = (distance / spacing + 1e-9).floor();
    let rest = distance - whole * spacing > NOTHING;
    (whole as usize).saturating_add(1 + usize::from(rest))
}

impl Scanner for Follow {
    fn next(&mut self, machine: &mut dyn Machine) -> Result<Option<Scanned>, Stop> {
        loop {
            let found = match self.state {
                State::Above => self.down(machine)?,
                State::Surface | State::Wall => self.onward(machine)?,
                State::Bottom => self.along_bottom(machine)?,
                State::End if self.line + 1 < self.lines => self.next_line(machine).map(|()| None)?,
                State::End => return self.leave(machine).map(|()| None),
            };
            if let Some(at) = found {
                return Ok(Some(Scanned { line: self.line, at }));
            }
        }
    }

    fn share(&self) -> f64 {
        let [along, ..] = self.layout.axes;
        let [from, to] = self.ends();
        let reached = self.last.map_or(from, |[at, _]| at);
        let way = self.end[along] - self.start[along];
        let part = if way == 0.0 { 0.0 } else { (reached - from) / (to - from) };
        ((self.line as f64 + part) / self.lines as f64).clamp(0.0, 1.0)
    }

    fn layout(&self) -> &Layout {
        &self.layout
    }
}

impl Follow {
    /// Coordinates at which this line begins and ends: there, and back on the next one.
    fn ends(&self) -> [f64; 2] {
        let [along, ..] = self.layout.axes;
        let ends = [self.start[along], self.end[along]];
        if self.line.is_multiple_of(2) { ends } else { [ends[1], ends[0]] }
    }

    /// Way along this line: +1 or −1.
    fn direction(&self) -> f64 {
        let [from, to] = self.ends();
        if to < from { -1.0 } else { 1.0 }
    }

    /// Rest of the line, mm.
    fn rest(&self, machine: &dyn Machine) -> f64 {
        let [along, ..] = self.layout.axes;
        (self.ends()[1] - machine.position()[along]) * self.direction()
    }

    /// AXIAL PROBE: down to the surface, not below the deepest position (C:1280).
    fn down(&mut self, machine: &mut dyn Machine) -> Result<Option<[f64; 3]>, Stop> {
        let [.., axial] = self.layout.axes;
        let deepest = self.end[axial];
        let found = if machine.position()[axial] > deepest { self.search(machine, axial, deepest)? } else { None };
        if found.is_none() {
            self.state = State::Bottom;
        }
        Ok(found.map(|at| self.found(at, State::Surface)))
    }

    /// On along the line from a point, then down. What is met beside is a wall (C:1316-1317).
    fn onward(&mut self, machine: &mut dyn Machine) -> Result<Option<[f64; 3]>, Stop> {
        let [along, _, axial] = self.layout.axes;
        let rest = self.rest(machine);
        if rest <= NOTHING {
            self.state = State::End;
            return Ok(None);
        }
        let position = machine.position();
        let way = if self.state == State::Wall {
            // back by Q, up by R, and on towards it (RADIAL PROBE)
            let room = (position[along] - self.ends()[0]).abs();
            let back = position[along] - self.direction() * self.retract.min(room);
            free(machine, along, back, MotionKind::Retract)?;
            free(machine, axial, position[axial] + self.raster, MotionKind::Positioning)?;
            self.raster
        } else {
            // PROBE RETRACT and STEP: up by Q, on by R along the tangent
            let [level, rise] = self.tangent.map(|part| part * self.raster);
            free(machine, axial, position[axial] + self.retract + rise.max(0.0), MotionKind::Retract)?;
            level.max(self.raster * LEAST)
        };
        let to = position[along] + self.direction() * way.min(rest);
        if let Some(at) = self.search(machine, along, to)? {
            return Ok(Some(self.found(at, State::Wall)));
        }
        self.down(machine)
    }

    /// At the deepest position: on along the line to a wall, else to its end (C:1280).
    fn along_bottom(&mut self, machine: &mut dyn Machine) -> Result<Option<[f64; 3]>, Stop> {
        let [along, ..] = self.layout.axes;
        self.last = None;
        let found = if self.rest(machine) > NOTHING { self.search(machine, along, self.ends()[1])? } else { None };
        if found.is_none() {
            self.state = State::End;
        }
        Ok(found.map(|at| self.found(at, State::Wall)))
    }

    /// RAPID WHEN SCANNING: up by Q and over to the next line, at a fixed distance. The stylus must stay free (C:1337).
    fn next_line(&mut self, machine: &mut dyn Machine) -> Result<(), Stop> {
        let [_, across, axial] = self.layout.axes;
        let above = machine.position()[axial] + self.retract;
        free(machine, axial, above, MotionKind::Retract)?;
        self.line += 1;
        let way = self.end[across] - self.start[across];
        let done = (self.line as f64 * self.spacing).min(way.abs());
        let to = self.start[across] + done.copysign(way);
        go(machine, across, to, MotionKind::Positioning, STYLUS_IN_CONTACT)?;
        self.state = State::Above;
        self.last = None;
        self.tangent = [1.0, 0.0];
        Ok(())
    }

    /// Up to where the tool axis stood at the call.
    fn leave(&self, machine: &mut dyn Machine) -> Result<(), Stop> {
        let [.., axial] = self.layout.axes;
        let to = self.layout.height.max(machine.position()[axial]);
        free(machine, axial, to, MotionKind::Positioning)
    }

    /// PROBE FOR SCANNING: along one axis to a position, with the feed that decides over the accuracy. A signal that is
    /// gone when the stylus stands, or that is there before it moves, is no position: up by Q and once more (C:1339).
    fn search(&self, machine: &mut dyn Machine, axis: usize, to: f64) -> Result<Option<[f64; 3]>, Stop> {
        let [.., axial] = self.layout.axes;
        for _ in 0..ATTEMPTS {
            let from = machine.position();
            let mut target = from;
            target[axis] = to;
            let Some(at) = machine.probe(target, self.layout.rate)? else { return Ok(None) };
            if machine.signal_stands() && at[axis] != from[axis] {
                return Ok(Some(self.sampled(from, at, axis)));
            }
            let above = machine.position()[axial] + self.retract;
            match free(machine, axial, above, MotionKind::Retract) {
                Err(Stop::Alarm(SCANNING_OBSTRUCTED)) => {} // it was pressed all the way: the next attempt tells
                other => other?,
            }
        }
        Err(Stop::Alarm(SCANNING_FAIL))
    }

    /// What the control reads: it looks at the signal in fixed times, so that the axis has gone on by a part of the way
    /// of one of them (C:1318-1321). With the ball where it is, not the spindle.
    fn sampled(&self, from: Wcs, at: Wcs, axis: usize) -> [f64; 3] {
        let between = self.layout.accuracy;
        let way = at[axis] - from[axis];
        let read = (way.abs() / between - 1e-6).ceil() * between;
        let mut point: [f64; 3] = std::array::from_fn(|one| at[one] + self.offset[one]);
        point[axis] += (read - way.abs()).max(0.0).copysign(way);
        point
    }

    /// Takes a point in: it and the one before give the direction of the surface. A wall that is less steep than 45
    /// degrees is followed from above.
    fn found(&mut self, at: [f64; 3], met: State) -> [f64; 3] {
        let [along, _, axial] = self.layout.axes;
        let here = [at[along], at[axial]];
        if let Some([before, height]) = self.last {
            let (level, rise) = ((here[0] - before) * self.direction(), here[1] - height);
            let way = level.hypot(rise);
            if way > NOTHING {
                self.tangent = [level / way, rise / way];
            }
        }
        self.last = Some(here);
        let [level, rise] = self.tangent;
        let flat = met == State::Wall && level > rise.abs() && level < 1.0;
        self.state = if flat { State::Surface } else { met };
        at
    }
}

/// Moves along one axis to get away from the surface: nothing else may be met.
fn free(machine: &mut dyn Machine, axis: usize, to: f64, kind: MotionKind) -> Result<(), Stop> {
    go(machine, axis, to, kind, SCANNING_OBSTRUCTED)
}

/// Moves along one axis where nothing may be met, `met` being said otherwise. A signal without contact is passed over.
fn go(machine: &mut dyn Machine, axis: usize, to: f64, kind: MotionKind, met: Code) -> Result<(), Stop> {
    for _ in 0..ATTEMPTS {
        let mut target = machine.position();
        target[axis] = to;
        match machine.travel(target, kind, POSITIONING, true) {
            Err(Stop::Alarm(FALSE_TRIGGER)) => {}
            Err(Stop::Alarm(PATH_OBSTRUCTED)) => return Err(Stop::Alarm(met)),
            other => return other,
        }
    }
    Err(Stop::Alarm(SCANNING_FAIL))
}
