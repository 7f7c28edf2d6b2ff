//! The machine and the part of one run: what the setup says, and what was drawn for this run.

use super::random::Source;
use crate::control::{Control, Value};
use crate::machine::Setup;
pub use crate::machine::series::{Mode, Per, Series, Shape, Vary};
use crate::refused::{Path, Refused};
use crate::workpiece::Shape as Form;
use std::borrow::Cow;

impl Shape {
    /// The number of this index; `half` is the half width, of the normal distribution `sigma` counts.
    pub fn number(self, source: Source, index: u64, sigma: f64, half: f64) -> f64 {
        let uniform = || source.uniform(index);
        match self {
            Shape::Normal => sigma * source.normal(index),
            Shape::Uniform => half * (2.0 * uniform() - 1.0),
            Shape::Triangular => {
                let share = uniform();
                let away = 1.0 - (2.0 * share.min(1.0 - share)).sqrt();
                if share < 0.5 { -half * away } else { half * away }
            }
            Shape::Arcsine => half * libm::sin(std::f64::consts::PI * (uniform() - 0.5)),
        }
    }
}

/// The machine of a run, from 0. `left`: the control as the run before it left it, in production.
pub fn machine(setup: &Setup, series: &Series, run: u32, left: Option<&Control>) -> Setup {
    let mut made = setup.clone();
    if let Some(left) = left {
        carry_over(&mut made.control, left);
    }
    for (at, vary) in series.vary.iter().enumerate() {
        let index = match vary.per {
            Per::Part => u64::from(run),
            Per::Series => 0,
        };
        let source = Source::new(series.seed, &source_name(&series.vary[..at], &vary.what));
        let drawn = vary.shape.number(source, index, vary.sigma, vary.half);
        let corrected = |name: &str| {
            let [now, before] = [&made.control, &setup.control].map(|control| value(control, name).unwrap_or(0.0));
            now - before
        };
        let followed: f64 = vary.follows.iter().map(|(name, factor)| factor * corrected(name)).sum();
        let listed = run.checked_rem(vary.values.len() as u32).map_or(0.0, |at| vary.values[at as usize]);
        add(&mut made, &vary.what, vary.mean + vary.drift * f64::from(run) + drawn + listed + followed);
    }
    scatter(&mut made, series.seed, run);
    made
}

/// Name of the source of a variation: one of the same datum that is listed again draws numbers of its own.
fn source_name<'a>(before: &[Vary], what: &'a str) -> Cow<'a, str> {
    match before.iter().filter(|other| other.what == what).count() {
        0 => what.into(),
        count => format!("{what} {count}").into(),
    }
}

/// Gives the touches of a run their own numbers.
pub fn scatter(setup: &mut Setup, seed: u64, run: u32) {
    setup.probe.repeatability.1 = Source::new(seed, "touch").bits(u64::from(run));
    for probe in &mut setup.tool_probes {
        probe.repeatability.1 = Source::new(seed, "tool touch").bits(u64::from(run));
    }
}

/// Tools, frames and data go on from part to part; what is active begins anew with the program.
fn carry_over(control: &mut Control, left: &Control) {
    control.tools.clone_from(&left.tools);
    control.frames.clone_from(&left.frames);
    control.stored.clone_from(&left.stored);
    control.data.clone_from(&left.data);
    control.activate(control.settable);
}

/// The first variation that names nothing of this machine, by its place in the setup file.
///
/// # Errors
/// Names that are not known.
pub fn known(setup: &Setup) -> Result<(), Refused> {
    let mut setup = setup.clone();
    let varied = std::mem::take(&mut setup.series.vary);
    for (index, vary) in varied.iter().enumerate() {
        let path = Path::of(&["series", "vary"]).element(index);
        if !add(&mut setup, &vary.what, 0.0) {
            return Err(Refused::new("setup-vary", path.member("what")).text("name", &vary.what));
        }
        if let Some(name) = vary.follows.keys().find(|name| value(&setup.control, name).is_none()) {
            return Err(Refused::new("setup-vary", path.member("follows")).text("name", name));
        }
    }
    Ok(())
}

/// The part gets warmer than it is made for, K: its sizes grow with `temperature.expansion` of the machine, about the
/// place where it is clamped.
pub const WARMTH: &str = "temperature.part";

/// A machine of which one thing is more by so much; none: it has no such thing.
pub fn varied(setup: &Setup, what: &str, by: f64) -> Option<Setup> {
    let mut made = setup.clone();
    add(&mut made, what, by).then_some(made)
}

/// How a feature gets another size where the radius of the tool that cuts it gets smaller by 1: a hole smaller by 2, a
/// shaft larger by 2; none: of this solid that is not told.
pub fn worn_by(setup: &Setup, solid: usize) -> Option<f64> {
    match setup.workpiece.solids.get(solid)?.shape {
        Form::Hole { .. } | Form::Groove { .. } | Form::Pocket { .. } => Some(-2.0),
        Form::Shaft { .. } | Form::Web { .. } | Form::Island { .. } | Form::Turned { .. } => Some(2.0),
        _ => None,
    }
}

/// The size of a solid that its error changes, mm; of a rectangle the mean of both.
fn size(shape: &Form) -> f64 {
    match shape {
        Form::Hole { diameter, .. } | Form::Shaft { diameter, .. } | Form::Turned { diameter, .. } => *diameter,
        Form::Sphere { diameter } => *diameter,
        Form::Groove { width, .. } | Form::Web { width, .. } => *width,
        Form::Pocket { length, .. } | Form::Island { length, .. } => (length[0] + length[1]) / 2.0,
        _ => 0.0,
    }
}

/// Warms all parts by so much, K.
fn warm(setup: &mut Setup, by: f64) -> bool {
    let grows = setup.temperature.expansion * 1e-6 * by;
    for solid in &mut setup.workpiece.solids {
        solid.errors.size += size(&solid.shape) * grows;
    }
    !setup.workpiece.solids.is_empty()
}

/// Something that can vary.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variable {
    /// Its name in the setup file.
    pub name: String,
    /// In words: key of a message.
    pub label: &'static str,
    /// Which solid of the part, from 0; absent: it is of the probe.
    pub solid: Option<usize>,
}

/// What can vary of probe and parts of this machine.
pub fn variables(setup: &Setup) -> Vec<Variable> {
    const ERRORS: [(&str, &str); 9] = [
        ("size", "equip-size-error"),
        ("shift[0]", "equip-shift-x"),
        ("shift[1]", "equip-shift-y"),
        ("shift[2]", "equip-shift-z"),
        ("tilt[0]", "series-tilt-x"),
        ("tilt[1]", "series-tilt-y"),
        ("tilt[2]", "series-tilt-z"),
        ("taper", "series-taper"),
        ("outOfRound[0]", "series-out-of-round"),
    ];
    const PROBE: [(&str, &str); 7] = [
        ("radius", "series-ball-radius"),
        ("length", "equip-probe-length"),
        ("delay", "equip-delay"),
        ("skew[0]", "equip-skew-x"),
        ("skew[1]", "equip-skew-y"),
        ("preTravel[0]", "equip-travel"),
        ("preTravel[1]", "equip-travel-lobes"),
    ];
    let solids = 0..setup.workpiece.solids.len();
    let errors = solids.flat_map(|at| {
        let of = move |(name, label)| (format!("workpiece[{at}].errors.{name}"), label);
        ERRORS.map(|one| (of(one), Some(at)))
    });
    let probe = PROBE.map(|(name, label)| ((format!("probe.{name}"), label), None));
    let warm = (!setup.workpiece.solids.is_empty()).then(|| ((WARMTH.to_owned(), "series-warmth"), None));
    errors.chain(probe).chain(warm).map(|((name, label), solid)| Variable { name, label, solid }).collect()
}

/// Adds to a member of the setup; false: there is none of this name.
fn add(setup: &mut Setup, what: &str, by: f64) -> bool {
    if let Some(name) = what.strip_prefix("data.") {
        let control = &mut setup.control;
        let Some(before) = value(control, name) else { return false };
        if !control.set_variable(name, before + by) {
            control.set(name, before + by);
        }
        return true;
    }
    if what == WARMTH {
        return warm(setup, by);
    }
    member(setup, what).map(|member| *member += by).is_some()
}

/// A tool or frame variable or a datum, as a number. Values that only the machine has (`$…`) are not corrected.
fn value(control: &Control, name: &str) -> Option<f64> {
    let datum = || !name.starts_with('$') && control.knows(name, &Value::Number(0.0));
    let datum = || datum().then(|| control.number(name));
    control.variable(name).or_else(datum)
}

/// A number of probe or part by its name in the setup file.
fn member<'a>(setup: &'a mut Setup, what: &str) -> Option<&'a mut f64> {
    let probe = &mut setup.probe;
    if let Some(name) = what.strip_prefix("probe.") {
        return match name {
            "radius" => Some(&mut probe.radius),
            "length" => Some(&mut probe.length),
            "delay" => Some(&mut probe.delay),
            "preTravel[0]" => Some(&mut probe.pre_travel.0),
            "preTravel[1]" => Some(&mut probe.pre_travel.1),
            _ => probe.skew.get_mut(element(name, "skew[")?),
        };
    }
    let (index, name) = what.strip_prefix("workpiece[")?.split_once("].errors.")?;
    let errors = &mut setup.workpiece.solids.get_mut(index.parse::<usize>().ok()?)?.errors;
    match name {
        "size" => Some(&mut errors.size),
        "taper" => Some(&mut errors.taper),
        "outOfRound[0]" => Some(&mut errors.out_of_round.0),
        _ => match (element(name, "shift["), element(name, "tilt[")) {
            (Some(axis), _) => errors.shift.get_mut(axis),
            (_, Some(axis)) => errors.tilt.0.get_mut(axis),
            _ => None,
        },
    }
}

/// The index behind the name of a list.
fn element(text: &str, list: &str) -> Option<usize> {
    text.strip_prefix(list)?.strip_suffix(']')?.parse().ok()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::control::Plane;
    use crate::dialect::Dialect;
    use crate::geometry::Mcs;
    use crate::series::spread::Spread;
    use crate::workpiece::Solid;

    fn vary(what: &str) -> Vary {
        serde_json::from_str(&format!("{{ \"what\": \"{what}\", \"sigma\": 0.01 }}")).unwrap()
    }

    fn part(vary: Vec<Vary>) -> (Setup, Series) {
        let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
        setup.workpiece.solids.push(Solid::new(Form::Hole { diameter: 50.0, depth: 30.0 }, Mcs([0.0; 3])));
        (setup, Series { vary, ..Series::default() })
    }

    // oracle: definition: a run alone is the same as in the series, and an order of sources means nothing
    #[test]
    fn a_run_alone_is_the_same() {
        let all = ["workpiece[0].errors.size", "probe.skew[1]", "data._WP[0,1]"];
        let (setup, series) = part(all.map(vary).to_vec());
        let (_, turned) = part(all.iter().rev().map(|what| vary(what)).collect());
        for run in [0, 1, 4711] {
            let made = machine(&setup, &series, run, None);
            assert_eq!(made, machine(&setup, &turned, run, None));
            assert_ne!(made, machine(&setup, &series, run + 1, None));
            assert_ne!(made, machine(&setup, &Series { seed: 2, ..series.clone() }, run, None));
        }
    }

    // oracle: hand: two variations of σ that know nothing of each other spread by √2·σ together, here within 4
    // standard errors; the first one draws the same numbers with the second as without
    #[test]
    fn a_datum_listed_twice_draws_twice() {
        let (setup, series) = part(vec![vary("probe.radius"), vary("probe.radius")]);
        let (_, alone) = part(vec![vary("probe.radius")]);
        let radius = |series: &Series, run| machine(&setup, series, run, None).probe.radius - setup.probe.radius;
        let spread = Spread::of((0..4000).map(|run| radius(&series, run)).collect());
        assert!((spread.deviation - 0.01 * 2f64.sqrt()).abs() < 4.0 * spread.deviation_error, "{}", spread.deviation);
        let rest = (0..4000).map(|run| (radius(&series, run) - radius(&alone, run), radius(&alone, run)));
        let common = rest.map(|(second, first)| second * first).sum::<f64>() / 4000.0 / 0.01_f64.powi(2);
        assert!(common.abs() < 4.0 / 4000f64.sqrt(), "{common}");
    }

    // oracle: hand: 3 runs later the mean is 3 drifts away; what is drawn once is the same in each
    #[test]
    fn drift_and_what_is_common() {
        let drifts = Vary { sigma: 0.0, drift: 0.001, ..vary("workpiece[0].errors.size") };
        let common = Vary { per: Per::Series, ..vary("probe.radius") };
        let (setup, series) = part(vec![drifts, common]);
        let [first, fourth] = [0, 3].map(|run| machine(&setup, &series, run, None));
        assert_eq!(first.workpiece.solids[0].errors.size, 0.0);
        assert!((fourth.workpiece.solids[0].errors.size - 0.003).abs() < 1e-15);
        assert_eq!(first.probe.radius, fourth.probe.radius);
        assert_ne!(first.probe.radius, setup.probe.radius);
    }

    // oracle: definition: what is named can vary; hand: a list comes from the first again
    #[test]
    fn what_is_named_varies_also_by_a_list() {
        let (mut setup, series) = part(Vec::new());
        let varied: Vec<Vary> = variables(&setup).iter().map(|one| vary(&one.name)).collect();
        assert_eq!(varied.len(), 17);
        setup.series = Series { vary: varied, ..series.clone() };
        known(&setup).unwrap();
        let listed = Vary { sigma: 0.0, values: vec![0.03, 0.05], ..vary("workpiece[0].errors.size") };
        let series = Series { vary: vec![listed], ..series };
        let sizes = [0, 1, 2].map(|run| machine(&setup, &series, run, None).workpiece.solids[0].errors.size);
        assert_eq!(sizes, [0.03, 0.05, 0.03]);
    }

    // oracle: hand: 0.01 mm more wear of the radius makes a hole smaller by 0.02 mm
    #[test]
    fn a_correction_reaches_the_next_part() {
        let mut follows = Vary { sigma: 0.0, ..vary("workpiece[0].errors.size") };
        follows.follows.insert("$TC_DP15[9,1]".into(), -2.0);
        let (setup, series) = part(vec![follows]);
        let mut left = setup.control.clone();
        assert!(left.set_variable("$TC_DP15[9,1]", 0.01));
        let next = machine(&setup, &series, 1, Some(&left));
        assert!((next.workpiece.solids[0].errors.size + 0.02).abs() < 1e-15);
        assert_eq!(next.control.variable("$TC_DP15[9,1]"), Some(0.01));
    }

    // oracle: definition
    #[test]
    fn what_is_not_there_is_named() {
        let good = "workpiece[0].errors.shift[2] workpiece[0].errors.tilt[2] workpiece[0].errors.outOfRound[0] \
                    probe.preTravel[1] probe.length data.R10 data.$TC_DP3[9,1] data.$P_UIFR[1,X,TR]";
        let (mut setup, mut series) = part(good.split_whitespace().map(vary).collect());
        setup.series = series.clone();
        known(&setup).unwrap();
        for wrong in ["workpiece[1].errors.size", "workpiece[0].size", "probe.skew[2]", "probe", "data.NOTHING", ""] {
            series.vary.push(vary(wrong));
            setup.series = series.clone();
            assert_eq!(known(&setup).unwrap_err().path.to_string(), "series.vary[8].what", "{wrong}");
            series.vary.pop();
        }
    }
}
