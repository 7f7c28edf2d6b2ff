//! One measuring block: to the start, `_FA` towards the surface and `_FA` into it, back (B:1111-1121, B:2213-2225).
//!
//! Axes count 0 abscissa, 1 ordinate, 2 applicate. Directions are +1 and -1 along the axis.

use super::{alarm, state};
use crate::check::Inputs;
use crate::control::Control;
use crate::diagnostic::Code;
use crate::geometry::TOLERANCE;
use crate::run::trace::MotionKind;
use crate::run::{Machine, Stop};

/// Pulled back between the fast and the slow touch, mm (B:13772).
const PULL_BACK: f64 = 2.0;

/// Whether two coordinates are more than the last bits of a sum apart: what is shorter is no motion.
fn apart(one: f64, other: f64) -> bool {
    (one - other).abs() > TOLERANCE
}

/// How the spindle stands while probing.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Spindle {
    /// As it is.
    Stays,
    /// A mono probe is turned into the direction of probing, plus this angle in degree (B:864-871, B:13624).
    Follows(f64),
}

/// Everything a measuring block needs besides the point.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Indices X Y Z of abscissa, ordinate, applicate.
    pub axes: [usize; 3],
    /// Radius of the probe in the tool memory, mm.
    pub radius: f64,
    /// `_FA`, mm.
    pub path: f64,
    /// Trigger values by axis: probing in minus and plus direction, mm; position at switching minus surface.
    triggers: [[f64; 2]; 3],
    /// Ball centre minus spindle axis in abscissa and ordinate, mm (`_WP[k,7]`, `_WP[k,8]`).
    pub skew: [f64; 2],
    feed: f64,
    fast: Option<f64>,
    attempts: u32,
    repeats: u32,
    monitored: bool,
    feed_plane: f64,
    feed_depth: f64,
    rapid_retract: bool,
    spindle: Spindle,
}

/// A surface to be touched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Axis.
    pub axis: usize,
    /// Direction of the probe, +1 or -1.
    pub direction: f64,
    /// Set coordinate of the surface, mm.
    pub set: f64,
    /// Distance of start and end from the set switching position, mm.
    pub path: f64,
}

impl Block {
    /// Reads parameters and data and checks what must be true before the first motion (sequence of B:4147-4157).
    pub fn prepare(machine: &mut dyn Machine, inputs: &Inputs) -> Result<Block, Stop> {
        let block = read(machine.control(), inputs).map_err(|number| alarm(machine, number))?;
        if let Some(angle) = follow_rotation(machine.control(), inputs) {
            turnable(machine)?;
            machine.orient(angle);
        }
        Ok(block)
    }

    /// Position at switching minus coordinate of the surface, mm.
    pub fn trigger(&self, axis: usize, direction: f64) -> f64 {
        self.triggers[axis.min(2)][usize::from(direction > 0.0)]
    }

    /// The same block with a probe that was never calibrated: plus or minus the radius (B:6402-6418).
    pub fn uncalibrated(&self) -> Block {
        let ideal = [self.radius, -self.radius];
        Block {
            triggers: [ideal; 3],
            skew: [0.0; 2],
            ..self.clone()
        }
    }

    /// Start of the measuring block in the measuring axis: the ball `path` before the set surface.
    pub fn start(&self, point: &Point) -> f64 {
        point.set + self.trigger(point.axis, point.direction) - point.direction * point.path
    }

    /// End of the measuring block in the measuring axis.
    pub fn end(&self, point: &Point) -> f64 {
        point.set + self.trigger(point.axis, point.direction) + point.direction * point.path
    }

    /// Intermediate positioning to X Y Z of the WCS, mm. A target beyond a software limit switch is alarm 61401: what
    /// the setpoint asks for cannot be reached (A:15920).
    pub fn travel(&self, machine: &mut dyn Machine, to: [f64; 3]) -> Result<(), Stop> {
        let from = machine.position();
        match machine.control().limited(from, to) {
            Some(_) => Err(alarm(machine, 61401)),
            None => self.go(machine, to),
        }
    }

    /// Intermediate positioning that ends at a software limit switch; whether it did (A:15921).
    pub fn travel_as_far(&self, machine: &mut dyn Machine, to: [f64; 3]) -> Result<bool, Stop> {
        let from = machine.position();
        let limited = machine.control().limited(from, to);
        self.go(machine, limited.unwrap_or(to))?;
        Ok(limited.is_some())
    }

    /// Monitored: `_SPEED[1]` in the plane, `_SPEED[2]` in the applicate; else rapid traverse (B:13743-13763).
    fn go(&self, machine: &mut dyn Machine, to: [f64; 3]) -> Result<(), Stop> {
        let from = machine.position();
        if (0..3).all(|axis| !apart(from[axis], to[axis])) {
            return Ok(());
        }
        if !self.monitored {
            return machine.travel(to, MotionKind::Rapid, 0.0, false);
        }
        let feed = self.positioning_feed(from, to);
        match machine.travel(to, MotionKind::Positioning, feed, true) {
            Err(Stop::Alarm(Code::Alarm(number))) => Err(alarm(machine, number)),
            outcome => outcome,
        }
    }

    fn positioning_feed(&self, from: [f64; 3], to: [f64; 3]) -> f64 {
        let [abscissa, ordinate, _] = self.axes;
        let moves = |axis: usize| apart(from[axis], to[axis]);
        if moves(abscissa) || moves(ordinate) {
            self.feed_plane
        } else {
            self.feed_depth
        }
    }

    /// Touches a surface `_NMSP` times from where the probe stands beside it, and returns to the start of the block.
    /// Coordinate of the surface, mm.
    pub fn measure(&self, machine: &mut dyn Machine, point: &Point) -> Result<f64, Stop> {
        Ok(self.latch(machine, point)? - self.trigger(point.axis, point.direction))
    }

    /// The same without the trigger value: mean position at switching, mm.
    pub fn latch(&self, machine: &mut dyn Machine, point: &Point) -> Result<f64, Stop> {
        self.orient(machine, point);
        let mut start = machine.position();
        start[self.axes[point.axis.min(2)]] = self.start(point);
        self.travel_as_far(machine, start)?;
        let start = machine.position();
        let mut sum = 0.0;
        for _ in 0..self.repeats {
            sum += self.attempt(machine, point, start)?;
        }
        Ok(sum / f64::from(self.repeats))
    }

    /// Probes up to five times until the probe switches (B:13999-14001); each attempt begins at the start. Where a
    /// software limit switch ends the way before the probe switches, it is 61401 instead of 61301 (A:15920).
    fn attempt(
        &self,
        machine: &mut dyn Machine,
        point: &Point,
        start: [f64; 3],
    ) -> Result<f64, Stop> {
        let mut end = start;
        end[self.axes[point.axis.min(2)]] = self.end(point);
        let limited = machine.control().limited(start, end);
        for _ in 0..self.attempts {
            let touched = self.touch(machine, point, start, limited.unwrap_or(end))?;
            self.back(machine, start)?;
            if let Some(position) = touched {
                return Ok(position[self.axes[point.axis.min(2)]]);
            }
        }
        let number = if limited.is_some() { 61401 } else { 61301 };
        Err(alarm(machine, number))
    }

    /// Towards the surface; with `_CHBIT[17]` fast, back by 2 mm (not behind the start) and slowly again.
    fn touch(
        &self,
        machine: &mut dyn Machine,
        point: &Point,
        start: [f64; 3],
        end: [f64; 3],
    ) -> Result<Option<[f64; 3]>, Stop> {
        let axis = self.axes[point.axis.min(2)];
        if let Some(fast) = self.fast {
            let Some(first) = machine.probe(end, fast)? else {
                return Ok(None);
            };
            let room = (first[axis] - start[axis]).abs().min(PULL_BACK);
            let mut pulled = start;
            pulled[axis] = first[axis] - point.direction * room;
            self.back(machine, pulled)?;
        }
        machine.probe(end, self.feed)
    }

    /// Away from the surface (B:1121, B:14005-14007).
    fn back(&self, machine: &mut dyn Machine, to: [f64; 3]) -> Result<(), Stop> {
        let feed = match self.rapid_retract || !self.monitored {
            true => 0.0,
            false => self.positioning_feed(machine.position(), to),
        };
        machine.travel(to, MotionKind::Retract, feed, false)
    }

    fn orient(&self, machine: &mut dyn Machine, point: &Point) {
        let angle = match (point.axis, point.direction > 0.0) {
            (0, true) => 0.0,
            (1, true) => 90.0,
            (0, false) => 180.0,
            (1, false) => 270.0,
            _ => return,
        };
        if let Spindle::Follows(offset) = self.spindle {
            machine.orient((angle + offset).rem_euclid(360.0));
        }
    }
}

/// Everything from parameters and data; error: number of the alarm.
fn read(control: &Control, inputs: &Inputs) -> Result<Block, u32> {
    if let Some(number) = state::refusal(control) {
        return Err(number);
    }
    let radius = control.active_radius();
    let number = inputs.integer("_PRNUM");
    let mono = number / 100 == 1;
    let index = number % 100 - 1;
    if index < 0 || (index + 1) as f64 > control.number("_CVAL[1]") {
        return Err(61313);
    }
    if mono && !control.spindle_positions {
        return Err(61373); // A:15917, B:864
    }
    let path = inputs.number("_FA");
    if path <= 0.0 {
        return Err(61308);
    }
    let probe = |i: usize| control.basic_length(&format!("_WP[{index},{i}]"));
    let spindle = match (mono, control.bit("_CBIT[8]")) {
        (false, _) => Spindle::Stays,
        (true, false) => Spindle::Follows(0.0),
        (true, true) => Spindle::Follows(inputs.number("_CORA")),
    };
    let monitored = control.bit("_CHBIT[2]");
    let (feed_plane, feed_depth) = speeds(control, monitored)?;
    Ok(Block {
        axes: control.plane.axes(),
        radius,
        path,
        triggers: [1, 3, 5].map(|i| [probe(i), probe(i + 1)]),
        // The skew of a mono probe turns with the spindle, so that it is not carried over.
        skew: if mono { [0.0; 2] } else { [probe(7), probe(8)] },
        feed: measuring_feed(inputs),
        fast: (control.bit("_CHBIT[17]") && path > 1.0).then(|| control.basic_length("_SPEED[3]")),
        attempts: if control.bit("_CHBIT[15]") { 1 } else { 5 },
        repeats: u32::try_from(inputs.integer("_NMSP")).unwrap_or(1).max(1),
        monitored,
        feed_plane,
        feed_depth,
        rapid_retract: control.bit("_CHBIT[16]"),
        spindle,
    })
}

/// Asks for a spindle that a measuring variant can turn (61372, A:15916).
pub fn turnable(machine: &mut dyn Machine) -> Result<(), Stop> {
    if machine.control().spindle_positions {
        return Ok(());
    }
    Err(alarm(machine, 61372))
}

/// `_VMS`, or 150 mm/min up to `_FA` = 1 and 300 mm/min above (B:2164-2170).
fn measuring_feed(inputs: &Inputs) -> f64 {
    match inputs.number("_VMS") {
        feed if feed > 0.0 => feed,
        _ if inputs.number("_FA") > 1.0 => 300.0,
        _ => 150.0,
    }
}

/// Speeds of monitored positioning in the plane and in the applicate, mm/min (B:13732-13733, A:15879-15880).
fn speeds(control: &Control, monitored: bool) -> Result<(f64, f64), u32> {
    if control.number("_SPEED[0]") < 0.0 {
        return Err(61339);
    }
    let (plane, depth) = (
        control.basic_length("_SPEED[1]"),
        control.basic_length("_SPEED[2]"),
    );
    if monitored && (plane == 0.0 || depth == 0.0) {
        return Err(61338);
    }
    Ok((plane, depth))
}

/// Whether the triggers of this axis are there: they differ (61341 otherwise, B:13565-13667).
pub fn calibrated(block: &Block, axis: usize) -> bool {
    let [minus, plus] = block.triggers[axis.min(2)];
    minus != plus
}

/// With `_CHBIT[13]` a multi probe turns with the coordinate system: 90 degree of rotation about the applicate, and only
/// about it, give 270 degree (with `_CHBIT[14]` 90) of the spindle (B:13973-13987).
fn follow_rotation(control: &Control, inputs: &Inputs) -> Option<f64> {
    if !control.bit("_CHBIT[13]") || inputs.integer("_PRNUM") / 100 != 0 {
        return None;
    }
    let [abscissa, ordinate, applicate] = control.plane.axes();
    let sum = |axis: usize| {
        control
            .chain()
            .iter()
            .map(|frame| frame.rotation[axis])
            .sum::<f64>()
    };
    if sum(abscissa) != 0.0 || sum(ordinate) != 0.0 {
        return None;
    }
    let rotation = sum(applicate);
    let angle = if control.bit("_CHBIT[14]") {
        rotation
    } else {
        -rotation
    };
    Some(angle.rem_euclid(360.0))
}
