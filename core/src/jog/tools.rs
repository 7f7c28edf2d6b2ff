//! The tool probe and tools, with `E_MESS_MT_…` in place of the data of the automatic cycle, which are named like them
//! (B:3931-4083, B:14191-14200). Machine coordinates: frames do not count.

use super::evaluate;
use super::settings::{self, TOOL_PROBE};
use super::touching::alarm;
use crate::catalogue::sinumerik::state;
use crate::control::Control;
use crate::control::probe::PROBE;
use crate::geometry::{Dir, TOLERANCE, Wcs};
use crate::machine::{Machine, MotionKind, Stop};
use std::f64::consts::TAU;

/// A geometry value of a tool, and its wear.
const LENGTH: [&str; 2] = ["$TC_DP3", "$TC_DP12"];
const RADIUS: [&str; 2] = ["$TC_DP6", "$TC_DP15"];

/// The tool probe as the set-up describes it. Lengths in mm, feeds in mm/min.
struct Probe {
    /// Number, from 1 (`_JM_I[2]`).
    number: i64,
    /// Indices X Y Z of abscissa, ordinate, applicate.
    axes: [usize; 3],
    /// Trigger values by axis X Y Z, in minus and in plus direction (`_TP`).
    triggers: [[f64; 2]; 3],
    /// Diameter of the upper side (`E_MESS_MT_DL`), and where the radius is measured (`E_MESS_MT_DR`).
    upper: f64,
    lower: f64,
    /// From the upper side down to the end of the tool while the radius is measured (`E_MESS_MT_DZ`).
    depth: f64,
    /// Axis of the plane and direction of travel while the radius is measured (`E_MESS_MT_DIR`).
    towards: (usize, f64),
    /// Axes and directions that are calibrated (`E_MESS_MT_AX`).
    allowed: i64,
    /// Path and feed of calibrating and with the spindle standing (`E_MESS_MT_D`, `E_MESS_MT_FM`).
    path: f64,
    feed: f64,
    /// Radius of the tool.
    radius: f64,
    /// Positioning in the plane and along the applicate.
    positioning: [f64; 2],
}

impl Probe {
    /// Reads the data and checks what must be true before the first motion; error: number of the alarm.
    fn of(control: &Control, sideways: bool) -> Result<Probe, u32> {
        let edge = state::with_edge(control)?;
        if matches!(edge.kind, 400..=599 | PROBE) {
            return Err(61314); // A:15855
        }
        let number = control.number(TOOL_PROBE) as i64;
        if number < 1 || number as f64 > control.number("_CVAL[0]") {
            return Err(61313);
        }
        let datum = |name: &str| control.number(&format!("{name}[{}]", number - 1));
        let stored = |place: usize| control.basic_length(&format!("_TP[{},{place}]", number - 1));
        let direction = datum("E_MESS_MT_DIR");
        let probe = Probe {
            number,
            axes: control.plane.axes(),
            triggers: std::array::from_fn(|axis| [stored(2 * axis), stored(2 * axis + 1)]),
            upper: datum("E_MESS_MT_DL"),
            lower: datum("E_MESS_MT_DR"),
            depth: datum("E_MESS_MT_DZ"),
            towards: (usize::from(direction.abs() == 2.0), if direction > 0.0 { 1.0 } else { -1.0 }),
            allowed: datum("E_MESS_MT_AX") as i64,
            path: control.number("E_MESS_MT_D"),
            feed: control.number("E_MESS_MT_FM"),
            radius: control.active_radius(),
            positioning: settings::Settings::of(control).positioning,
        };
        // they must be entered (A:15841, B:14296)
        if probe.upper <= 0.0 || sideways && probe.lower <= 0.0 { Err(61230) } else { Ok(probe) }
    }

    /// Upper side.
    fn top(&self) -> f64 {
        self.triggers[self.axes[2]][0]
    }

    /// Trigger value along an axis of the plane.
    fn trigger(&self, place: usize, sign: f64) -> f64 {
        self.triggers[self.axes[place]][usize::from(sign > 0.0)]
    }

    /// Middle along an axis of the plane; none: not both sides were calibrated.
    fn middle(&self, place: usize) -> Option<f64> {
        let [minus, plus] = self.triggers[self.axes[place]];
        (minus > plus).then(|| (minus + plus) / 2.0)
    }

    /// Whether a side is calibrated: the digits of `E_MESS_MT_AX` by axis Z Y X, 1 minus, 2 plus, 3 both.
    fn allows(&self, place: usize, sign: f64) -> bool {
        let digit = self.allowed / 10_i64.pow(self.axes[place] as u32) % 10;
        digit & if sign < 0.0 { 1 } else { 2 } != 0
    }

    fn store(&self, machine: &mut dyn Machine, axis: usize, sign: f64, value: f64) {
        let place = 2 * axis + usize::from(sign > 0.0);
        let per = machine.control().basic_factor();
        machine.write(&format!("_TP[{},{place}]", self.number - 1), value / per);
    }

    /// Watched positioning of one axis of the plane, or of the applicate (2).
    fn go(&self, machine: &mut dyn Machine, place: usize, to: f64) -> Result<(), Stop> {
        let mut target = machine.position();
        let from = target;
        if (target[self.axes[place]] - to).abs() <= TOLERANCE {
            return Ok(());
        }
        target[self.axes[place]] = to;
        if machine.control().limited(from, target).is_some() {
            return Err(alarm(61401));
        }
        machine.travel(target, MotionKind::Positioning, self.positioning[usize::from(place == 2)], true)
    }

    /// Touches along an axis of the plane or the applicate, as far as `path`, and returns to the start.
    fn touch(&self, machine: &mut dyn Machine, place: usize, sign: f64, path: f64, feed: f64) -> Result<f64, Stop> {
        let start = machine.position();
        let axis = self.axes[place];
        let mut way: Dir<Wcs> = Dir::default();
        way[axis] = sign * path;
        let limited = machine.control().limited(start, start + way);
        let touched = machine.probe(limited.unwrap_or(start + way), feed)?;
        machine.travel(start, MotionKind::Retract, self.positioning[usize::from(place == 2)], false)?;
        let alarm = || alarm(if limited.is_some() { 61401 } else { 61301 });
        touched.map(|at| at[axis]).ok_or_else(alarm)
    }

    /// Twice: from where the tool stands, and from `near` before the place that was found (B:4015-4018).
    fn measure(
        &self,
        machine: &mut dyn Machine,
        place: usize,
        sign: f64,
        near: f64,
        feeds: [f64; 2],
    ) -> Result<f64, Stop> {
        let found = self.touch(machine, place, sign, 2.0 * self.path, feeds[0])?;
        let start = machine.position()[self.axes[place]];
        let before = found - sign * near;
        // never behind the start
        let before = if (before - start) * sign > 0.0 { before } else { start };
        self.go(machine, place, before)?;
        self.touch(machine, place, sign, 2.0 * near, feeds[1])
    }
}

/// Carries out in machine coordinates.
fn without_frames<T>(machine: &mut dyn Machine, measure: impl FnOnce(&mut dyn Machine) -> T) -> T {
    let frames = machine.control().take_frames();
    let outcome = measure(machine);
    machine.control().put_frames(frames);
    outcome
}

/// Calibrates the tool probe: its upper side, and with `diameter` the sides that `E_MESS_MT_AX` names; the tool stands
/// roughly over its middle.
///
/// # Errors
/// No signal, or what was hit or refused.
pub fn calibrate(machine: &mut dyn Machine, diameter: bool) -> Result<(), Stop> {
    let probe = Probe::of(machine.control(), diameter).map_err(alarm)?;
    without_frames(machine, |machine| {
        let start = machine.position();
        let top = probe.touch(machine, 2, -1.0, 2.0 * probe.path, probe.feed)?;
        probe.store(machine, probe.axes[2], -1.0, top);
        if !diameter {
            return Ok(());
        }
        let mut middle = [0, 1].map(|place| start[probe.axes[place]]);
        for place in 0..2 {
            let mut found = [None; 2];
            for sign in [-1.0, 1.0] {
                if probe.allows(place, sign) {
                    let value = side(machine, &probe, place, sign, top, middle)?;
                    probe.store(machine, probe.axes[place], sign, value);
                    found[usize::from(sign > 0.0)] = Some(value);
                }
            }
            if let [Some(minus), Some(plus)] = found {
                middle[place] = (minus + plus) / 2.0;
            }
        }
        Ok(())
    })
}

/// Touches a side of the tool probe, and comes back over its middle; its trigger value.
fn side(
    machine: &mut dyn Machine,
    probe: &Probe,
    place: usize,
    sign: f64,
    top: f64,
    middle: [f64; 2],
) -> Result<f64, Stop> {
    let height = machine.position()[probe.axes[2]];
    let beside = middle[place] - sign * (probe.lower / 2.0 + probe.radius + probe.path);
    probe.go(machine, 1 - place, middle[1 - place])?;
    probe.go(machine, place, beside)?;
    probe.go(machine, 2, top - probe.depth)?;
    let at = probe.touch(machine, place, sign, 2.0 * probe.path, probe.feed)?;
    probe.go(machine, 2, height)?;
    probe.go(machine, place, middle[place])?;
    Ok(at + sign * probe.radius)
}

/// Measures the length of the tool in the spindle, which stands over the tool probe.
///
/// # Errors
/// No signal, or what was hit or refused.
pub fn length(machine: &mut dyn Machine, offset: f64) -> Result<(), Stop> {
    let probe = Probe::of(machine.control(), false).map_err(alarm)?;
    let (start, tip) = without_frames(machine, |machine| -> Result<(Wcs, f64), Stop> {
        let start = machine.position();
        if start[probe.axes[2]] <= probe.top() {
            return Err(alarm(61332)); // the end of the tool is not above the probe
        }
        let (beside, rotates) = evaluate::beside(probe.radius, offset, probe.upper);
        let middle = [0, 1].map(|place| probe.middle(place).unwrap_or(start[probe.axes[place]]));
        let side = if start[probe.axes[0]] >= middle[0] { 1.0 } else { -1.0 };
        probe.go(machine, 1, middle[1])?;
        probe.go(machine, 0, middle[0] + side * beside)?;
        let near = machine.control().number("E_MESS_D_L");
        Ok((start, turning(machine, &probe, (2, -1.0), near, rotates)?))
    })?;
    back(machine, &probe, start)?;
    let stored = machine.control().active_length()[probe.axes[2]];
    write(machine, LENGTH, evaluate::new_length(stored, tip, probe.top()) - stored);
    Ok(())
}

/// Measures the radius of the tool in the spindle, which stands beside the tool probe.
///
/// # Errors
/// No signal, or what was hit or refused.
pub fn radius(machine: &mut dyn Machine, offset: f64) -> Result<(), Stop> {
    let probe = Probe::of(machine.control(), true).map_err(alarm)?;
    let (place, sign) = probe.towards;
    let trigger = probe.trigger(place, sign);
    let (start, at) = without_frames(machine, |machine| -> Result<(Wcs, f64), Stop> {
        let start = machine.position();
        if (trigger - start[probe.axes[place]]) * sign <= 0.0 {
            return Err(alarm(61332)); // the tool does not stand on the side from which it approaches
        }
        let other = probe.middle(1 - place).unwrap_or(start[probe.axes[1 - place]]);
        probe.go(machine, 1 - place, other)?;
        probe.go(machine, 2, evaluate::tip_height(probe.top(), probe.depth, offset))?;
        let near = machine.control().number("E_MESS_D_R");
        Ok((start, turning(machine, &probe, (place, sign), near, true)?))
    })?;
    back(machine, &probe, start)?;
    let stored = probe.radius;
    write(machine, RADIUS, evaluate::new_radius(at, trigger) - stored);
    Ok(())
}

/// Back to where the tool stood: up or sideways first, so that it leaves the probe as it came.
fn back(machine: &mut dyn Machine, probe: &Probe, start: Wcs) -> Result<(), Stop> {
    without_frames(machine, |machine| {
        let (place, _) = probe.towards;
        for axis in [place, 2, 1 - place] {
            probe.go(machine, axis, start[probe.axes[axis]])?;
        }
        Ok(())
    })
}

/// Touches twice, with the spindle standing or rotating; it stands again then.
fn turning(
    machine: &mut dyn Machine,
    probe: &Probe,
    (place, sign): (usize, f64),
    near: f64,
    rotates: bool,
) -> Result<f64, Stop> {
    let feeds = feeds(machine, probe, rotates)?;
    let touched = probe.measure(machine, place, sign, near, feeds);
    machine.spin(0.0);
    touched
}

/// Feeds of the first and the second touch, mm/min; a rotating spindle turns from now on (B:14262-14268). Data that
/// make no feed are 61350 (A:15892).
fn feeds(machine: &mut dyn Machine, probe: &Probe, rotates: bool) -> Result<[f64; 2], Stop> {
    if !rotates || probe.radius <= 0.0 {
        return Ok([probe.feed; 2]);
    }
    let control = machine.control();
    let datum = |name: &str| control.number(name);
    let peripheral = datum("E_MESS_MAX_V") * 1000.0;
    let speed = (peripheral / (TAU * probe.radius)).min(datum("E_MESS_MAX_S"));
    let most = datum("E_MESS_MAX_F");
    let slow = (speed * datum("E_MESS_MIN_D")).min(most);
    let fast = (slow * datum("E_MESS_F_FAK1")).max(datum("E_MESS_MIN_F")).min(most);
    if slow <= 0.0 || fast <= 0.0 {
        return Err(alarm(61350));
    }
    machine.spin(-speed); // M4, as the automatic cycle is set when delivered (B:13503)
    Ok([fast, slow])
}

/// Adds a difference to a length or radius of the tool in the spindle: to the geometry, which takes the wear in, or
/// with `_JM_B[0]` = 1 to the wear (B:4003-4006, B:14353-14355).
fn write(machine: &mut dyn Machine, [geometry, wear]: [&str; 2], difference: f64) {
    let control = machine.control();
    let name = |part: &str| format!("{part}[{},{}]", control.tool, control.edge);
    let (geometry, wear) = (name(geometry), name(wear));
    let value = |name: &str| control.variable(name).unwrap_or_default();
    let (old, worn) = (value(&geometry), value(&wear));
    if control.bit("_JM_B[0]") {
        return machine.write_correction(wear, worn + difference);
    }
    // the wear first: where it is the length in use, the spindle nose stays
    machine.write_correction(wear, 0.0);
    machine.write_correction(geometry, old + worn + difference);
}
