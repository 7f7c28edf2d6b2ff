//! What the control tells about itself: `$P_…`, `$AA_…`, `$AC_…`.

use super::{Datum, Interpreter, Motion, contour, diameters, indices, mode, names, of_machine, stem, tool_memory};
use crate::control::frames::{CHANNEL_MASK, GLOBAL_MASK, joined};
use crate::control::{AXES, Frame, Tool, UnitFunction, Units, Value, machine_data, variables::component};
use crate::diagnostic::Span;
use crate::geometry::Degrees;
use crate::machine::Machine;
use crate::problem::Problem;

/// All frames in effect as one.
const TOTAL: &str = "$P_ACTFRAME";
/// The basic frames in effect as one.
const BASIC: &str = "$P_ACTBFRAME";

/// What a program may keep numbers in beside R parameters; nothing else looks at it.
pub const FREE: [&str; 2] = ["$AC_MARKER", "$AC_PARAM"];

/// Positions that `MEAS` latched (B:12790-12856).
const LATCHED: [&str; 3] = ["$AA_MW[", "$AA_MB[", "$AA_MM["];

/// Masks of basic frames. They count at once, unlike the frames.
pub const MASKS: [&str; 2] = [CHANNEL_MASK, GLOBAL_MASK];

/// `$…`: tool and frame data, what the control tells about itself, and what only the machine has.
pub fn read(run: &Interpreter, key: &str, place: Span) -> Result<Datum, Problem> {
    let other = another_name(run, key);
    let key = other.as_deref().unwrap_or(key);
    if let Some(value) = simulated(run, key) {
        return Ok(value);
    }
    if LATCHED.iter().any(|stem| key.starts_with(stem)) {
        return Err(Problem::new("run-not-measured", place, key));
    }
    if let Some(problem) = tool_memory::absent(run, key, place) {
        return Err(problem);
    }
    if machine_data::of_edge(stem(key)) && run.assumed.is_some() {
        return of_machine::assume(run, key.to_owned(), place).ok_or_else(|| Problem::new("run-no-tool", place, key));
    }
    of_machine::read(run, key, place).ok_or_else(|| Problem::new("run-system-variable", place, key))
}

/// Value of what is simulated.
pub fn simulated(run: &Interpreter, key: &str) -> Option<Datum> {
    let control = &run.sim.control;
    if let Some(value) = control.variable(key) {
        return Some(Datum::Number(value / names::variable_factor(run, key)));
    }
    if let Some(name) = tool_name(run, key) {
        return Some(Datum::Text(name.to_owned()));
    }
    if let Some(frame) = control.frame(key).or_else(|| together(run, key)) {
        return Some(Datum::Frame(Box::new(frame)));
    }
    if let Some(value) = run.measured.get(key) {
        return Some(Datum::Number(*value));
    }
    let value = tool(run, key).or_else(|| position(run, key)).or_else(|| state(run, key)).or_else(|| total(run, key));
    value.map(Datum::Number)
}

/// Another name of a datum: `$P_AD[6]` of the active edge, `$VA_IM[X]` measured at the axis, here as commanded.
fn another_name(run: &Interpreter, key: &str) -> Option<String> {
    if let Some(axis) = key.strip_prefix("$VA_IM[") {
        return Some(format!("$AA_IM[{axis}"));
    }
    let number = key.strip_prefix("$P_AD[")?.strip_suffix(']')?;
    let control = &run.sim.control;
    Some(format!("$TC_DP{number}[{},{}]", control.tool, control.edge))
}

/// `$TC_TP2[20]`: name of a tool.
fn tool_name<'a>(run: &'a Interpreter, key: &str) -> Option<&'a str> {
    let number = key.strip_prefix("$TC_TP2[")?.strip_suffix(']')?;
    Some(&run.sim.control.tools.get(&number.parse().ok()?)?.name)
}

/// Frames in effect as one: all, or the basic ones.
fn together(run: &Interpreter, name: &str) -> Option<Frame> {
    let control = &run.sim.control;
    match name {
        TOTAL => control.total_frame(),
        BASIC => joined(&control.basic_chain()),
        _ => None,
    }
}

/// The active tool, and what is known of the others.
fn tool(run: &Interpreter, key: &str) -> Option<f64> {
    let control = &run.sim.control;
    let factor = control.data_factor();
    Some(match stem(key) {
        "$P_TOOLNO" => control.tool as f64,
        "$P_TOOLP" => run.modal.prepared.unwrap_or(control.tool) as f64,
        "$P_TOOL" => control.edge as f64,
        "$P_DLNO" => control.location as f64,
        "$P_TOOLEXIST" => f64::from(u8::from(tool_of(run, key)?.is_some())),
        "$P_TOOLND" => tool_of(run, key)?.map_or(0, |tool| tool.edges.len()) as f64,
        "$P_TOOLR" => control.active_radius() / factor,
        "$P_TOOLL" => {
            let number: usize = indices(key).first()?.parse().ok()?;
            control.active_length()[*control.plane.axes().get(3_usize.checked_sub(number)?)?] / factor
        }
        _ => return None,
    })
}

/// The tool whose number is the index; the outer option: whether that is a number.
fn tool_of<'a>(run: &'a Interpreter, key: &str) -> Option<Option<&'a Tool>> {
    Some(run.sim.control.tools.get(&indices(key).first()?.parse().ok()?))
}

/// Where an axis stands: `$AA_IW` WCS, `$P_EP` programmed, `$AA_IB` basic, `$AA_IM` spindle nose; rotary in degree.
fn position(run: &Interpreter, key: &str) -> Option<f64> {
    let control = &run.sim.control;
    let (stem, index) = (stem(key), indices(key));
    let name = *index.first()?;
    if let Some(axis) = control.rotary_axis(name) {
        let stands = control.rotary[axis];
        return match stem {
            "$AA_IM" | "$AA_IB" => Some(stands.0),
            "$AA_IW" | "$P_EP" => Some((stands - control.rotary_to_machine(axis, Degrees(0.0))).0),
            _ => None,
        };
    }
    let axis = AXES.iter().position(|axis| *axis == name)?;
    let at = run.sim.position;
    let shown = if axis == 0 { control.transverse.shown() } else { 1.0 };
    let value = match stem {
        "$AA_IW" => control.to_workpiece(at)[axis] * shown,
        "$P_EP" => control.to_workpiece(contour::stands(run))[axis] * shown,
        "$AA_IB" => at[axis],
        "$AA_IM" => at[axis] + control.active_length()[axis],
        _ => return None,
    };
    Some(value / control.data_factor())
}

/// What else the control tells about itself.
fn state(run: &Interpreter, key: &str) -> Option<f64> {
    let control = &run.sim.control;
    Some(match stem(key) {
        "$P_UIFRNUM" => control.settable as f64,
        "$P_DRYRUN" | "$P_ISTEST" | "$P_SEARCH" | "$P_SIM" | "$A_PROTO" => mode::variable(run, key),
        "$AC_MEA" => 0.0,
        "$A_PROBE" if run.sim.has_probe() => f64::from(u8::from(run.sim.in_contact())),
        "$P_MSNUM" => 1.0,
        "$P_SDIR" if key == "$P_SDIR[1]" => match control.spindle_speed {
            0.0 => 5.0,
            speed if speed > 0.0 => 3.0,
            _ => 4.0,
        },
        "$AA_S" if key == "$AA_S[1]" => control.spindle_speed.abs(),
        stem if FREE.contains(&stem) => control.number(key),
        "$P_F" => run.modal.feed,
        "$P_S" => run.modal.speed,
        "$P_GG" => group(run, key)?,
        "$P_SUBPAR" => f64::from(u8::from(given(run, key)?)),
        _ if MASKS.contains(&key) => mask(run, key),
        "$MN_SCALING_SYSTEM_IS_METRIC" => f64::from(u8::from(control.basic_units == Units::Metric)),
        _ => control.number(machine_data::setting(key)?),
    })
}

/// A component of `$P_ACTFRAME` or `$P_ACTBFRAME`.
fn total(run: &Interpreter, key: &str) -> Option<f64> {
    let (stem, index) = (stem(key), indices(key));
    let [axis, part] = index[..] else { return None };
    Some(component(&together(run, stem)?, axis, part)? / names::variable_factor(run, key))
}

/// Whether the call of the present program gives its parameter with this number; none: there is no call or no such one.
fn given(run: &Interpreter, key: &str) -> Option<bool> {
    let number: usize = indices(key).first()?.parse().ok()?;
    run.levels.last()?.given.get(number.checked_sub(1)?).copied()
}

/// Bits of the basic frames in the chain; where the mask was never set, of all that exist.
fn mask(run: &Interpreter, key: &str) -> f64 {
    let control = &run.sim.control;
    if let Some(Value::Number(bits)) = control.data.get(key) {
        return *bits;
    }
    let numbers = match key == CHANNEL_MASK {
        true => control.channel_basic_numbers(),
        false => control.stored.global.keys().copied().collect(),
    };
    numbers.into_iter().map(|index| 2.0_f64.powi(index as i32)).fold(0.0, |all, bit| all + bit)
}

/// Group 13.
const UNITS: [UnitFunction; 4] = [UnitFunction::G70, UnitFunction::G71, UnitFunction::G700, UnitFunction::G710];

/// Active G function of a group: 1 motion, 6 plane (G17 is 1), 7 compensation, 8 zero offset (G500 is 1, G54 2), 13
/// units (G70, G71, G700, G710), 14 absolute or incremental, 29 diameters.
fn group(run: &Interpreter, key: &str) -> Option<f64> {
    let control = &run.sim.control;
    let place = match *indices(key).first()? {
        "1" => match run.modal.motion {
            Motion::Spline => return None,
            Motion::Tangential => 14, // the fifteenth (Fundamentals 10.2004, 12.3)
            motion => motion as usize,
        },
        "6" => control.plane as usize,
        "7" => run.modal.compensation as usize,
        "8" => control.settable,
        "13" => UNITS.iter().position(|function| *function == control.unit_function())?,
        "14" => usize::from(!run.modal.absolute),
        "29" => diameters::active(run),
        _ => return None,
    };
    Some(place as f64 + 1.0)
}

/// The G function that `G[group]=number` means, in the groups of [`group`] that are functions with a number.
pub fn function(group: f64, number: f64) -> Option<u16> {
    let whole = |value: f64| (value.fract() == 0.0 && (1.0..=u16::MAX.into()).contains(&value)).then_some(value as u16);
    let place = whole(number)? - 1;
    match (whole(group)?, place) {
        (1, 0..4) => Some(place),
        (6, 0..3) => Some(17 + place),
        (7, 0..3) => Some(40 + place),
        (8, 0) => Some(500),
        (8, 1..5) => Some(53 + place),
        (8, 5..100) => Some(500 + place),
        (13, _) => UNITS.get(usize::from(place)).map(|function| *function as u16),
        (14, 0..2) => Some(90 + place),
        _ => None,
    }
}
