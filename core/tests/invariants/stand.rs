//! A drawn measurement as it stands on the machine: control, probe, part and the checked call.

use super::draw::{Drawn, Machine, PLANES, Placed};
use nalgebra::{Matrix3, Rotation3, Vector3};
use probewright_core::catalogue::example::example;
use probewright_core::check::{check, read};
use probewright_core::control::{Control, Frame, MachineSort, Plane, Units};
use probewright_core::entry::{Cycle, Inputs, ProbeUse, Typed, Unit, factor};
use probewright_core::geometry::rigid::{angles, rotation};
use probewright_core::geometry::{Dir, Rpy};
use probewright_core::machine::Setup;
use probewright_core::machine::setup::PROBE_TOOL;
use probewright_core::run::{Outcome, predict};
use probewright_core::workpiece::PartErrors;
use probewright_core::workpiece::tool::Tool;

/// Codes of `_KNUM` for a zero offset (B:1930-1969) with the frame that each of them corrects. 1000 and 9999 are told
/// apart by the settable frame in use.
pub const ZERO: [i64; 8] = [1, 5, 1011, 1051, 2000, 9999, 1000, 0];
/// Codes for a tool offset (B:1894-1928): radius, length, inverted, additive, none.
pub const TOOL: [i64; 8] = [2001, 1, 12_001, 100_001, 2001, 400_001, 1_002_001, 0];

/// Control, probe and part before a call, and the call.
#[derive(Clone)]
pub struct Stand {
    pub setup: Setup,
    pub inputs: Inputs,
}

impl Stand {
    pub fn run(&self) -> Outcome {
        predict(self.inputs.cycle, &self.inputs, &self.setup)
    }
}

/// The measurement on its machine; the findings where the cycle refuses what was drawn.
pub fn stand(drawn: &Drawn) -> Result<Stand, String> {
    stand_in(drawn, drawn.machine.basic, None)
}

/// The same with this basic system of units, and with what a program says of units before the call.
pub fn stand_in(drawn: &Drawn, basic: Units, code: Option<u16>) -> Result<Stand, String> {
    let cycle = drawn.cycle();
    let mut setup = machine(drawn, basic);
    if let Some(code) = code {
        assert!(setup.control.choose_units(code));
    }
    let typed = typed(drawn, &setup.control);
    let checked = check(cycle, &typed, &setup.control);
    let refused = || format!("{:?}", checked.diagnostics.iter().map(|found| &found.message).collect::<Vec<_>>());
    let inputs = checked.inputs.clone().ok_or_else(refused)?;
    put_part(&mut setup, &inputs, drawn);
    Ok(Stand { setup, inputs })
}

/// Puts the part that the call proposes on the machine, with its errors, and the probe before it.
fn put_part(setup: &mut Setup, inputs: &Inputs, drawn: &Drawn) {
    let proposal = (inputs.cycle.work().unwrap().propose)(inputs, &setup.control);
    let plane = setup.control.plane;
    let errors = PartErrors {
        shift: setup.control.direction_to_machine(Dir::new(at(plane, drawn.part.shift))).0,
        size: drawn.part.size,
        tilt: on_the_machine(&setup.control, at(plane, tilt(inputs.cycle, drawn.part.tilt))),
        ..PartErrors::default()
    };
    setup.workpiece = proposal.workpiece;
    for solid in &mut setup.workpiece.solids {
        solid.errors = errors;
    }
    setup.workpiece.solids.extend(proposal.fixture);
    setup.tool_probes = proposal.tool_probes;
    for probe in &mut setup.tool_probes {
        probe.solid.errors.shift = errors.shift;
    }
    let control = &setup.control;
    if let Some(edge) = control.active_edge() {
        let real = proposal.real_tool.unwrap_or_else(|| Tool::nominal(edge, control));
        setup.real_tools.insert(control.active_place(), real);
    }
    for proposed in proposal.tools {
        let tool = setup.control.tools.entry(proposed.tool).or_default();
        tool.name = proposed.name;
        tool.edges.entry(proposed.edge).or_insert(proposed.data);
    }
    setup.position = setup.control.to_machine(proposal.start);
}

/// How the part is turned where a cycle measures angles. That of the others is not, so that what they find is known,
/// and walls of a corner stay upright: met elsewhere, leaning ones would give another corner.
fn tilt(cycle: &Cycle, [abscissa, ordinate, applicate]: [f64; 3]) -> [f64; 3] {
    match cycle.name {
        "CYCLE961" => [0.0, 0.0, applicate],
        "CYCLE997" | "CYCLE998" => [abscissa, ordinate, applicate],
        _ => [0.0; 3],
    }
}

/// A rotation of the workpiece system, angles about its X Y Z, as one of the machine.
fn on_the_machine(control: &Control, turn: [f64; 3]) -> Rpy {
    let axis = |own: usize| {
        let mut axis = [0.0; 3];
        axis[own] = 1.0;
        Vector3::from(control.direction_to_machine(Dir::new(axis)).0)
    };
    let axes = Matrix3::from_columns(&[axis(0), axis(1), axis(2)]);
    angles(&Rotation3::from_matrix_unchecked(axes * rotation(Rpy(turn)).matrix() * axes.transpose()))
}

/// Abscissa, ordinate, applicate as X Y Z.
pub fn at(plane: Plane, values: [f64; 3]) -> [f64; 3] {
    let mut point = [0.0; 3];
    for (axis, value) in plane.axes().into_iter().zip(values) {
        point[axis] = value;
    }
    point
}

fn machine(drawn: &Drawn, basic: Units) -> Setup {
    let cycle = drawn.cycle();
    let lathe = cycle.purpose.machine == MachineSort::Turning;
    let plane = if lathe { Plane::G18 } else { PLANES[drawn.machine.plane] };
    let mut setup = Setup::calibrated_in(cycle.dialect, plane, basic);
    setup.suit(cycle, drawn.variant);
    let parallel = lathe || cycle.purpose.probe == ProbeUse::Tool;
    let turns = match cycle.name {
        _ if parallel => [0.0; 3],
        // the length of the probe lies along the applicate
        name if drawn.machine.upright || name == "CYCLE976" => at(plane, [0.0, 0.0, 1.0]),
        _ => [1.0; 3],
    };
    let mirrors = !parallel && !["CYCLE976", "CYCLE997", "CYCLE998"].contains(&cycle.name);
    frames(&mut setup.control, &drawn.machine, turns, mirrors);
    for name in &drawn.machine.bits {
        let turned = 1.0 - setup.control.number(name);
        setup.control.set(*name, turned);
    }
    // the memories of CYCLE998 are those of an angle
    let unit = if cycle.name == "CYCLE998" { 1.0 } else { setup.control.basic_factor() };
    for (name, value) in [("_EV[9]", 0.01), ("_MV[9]", 0.02)] {
        setup.control.set(name, value / unit);
    }
    if !lathe && cycle.purpose.probe == ProbeUse::Workpiece {
        calibrated(&mut setup, drawn);
    }
    setup
}

fn frames(control: &mut Control, machine: &Machine, turns: [f64; 3], mirrors: bool) {
    let frame = |placed: &Placed, any: bool| Frame {
        coarse: placed.at,
        fine: [placed.fine; 3],
        rotation: Rpy(std::array::from_fn(|axis| if any { placed.turn[axis] * turns[axis] } else { 0.0 })),
        mirror: if mirrors { placed.mirror } else { [false; 3] },
        ..Frame::default()
    };
    let [system, global, channel, settable, programmed] = &machine.frames;
    control.stored.system = frame(system, true);
    control.stored.global.insert(0, frame(global, false));
    control.stored.channel.insert(0, frame(channel, true));
    for number in [0, 1, 5] {
        let mut frame = frame(settable, true);
        frame.coarse[0] += number as f64;
        control.frames.insert(number, frame);
    }
    control.activate(machine.settable);
    control.program_frame = Frame { fine: [0.0; 3], ..frame(programmed, true) };
}

/// A probe as drawn, of which the control knows everything: trigger points are position at switching minus surface, so
/// the skew is in them (DESIGN.md). A mono probe has none here.
// oracle: hand (B:13441-13463: field 1 abscissa minus, 2 abscissa plus, …)
fn calibrated(setup: &mut Setup, drawn: &Drawn) {
    let radius = drawn.machine.ball;
    let skew = if drawn.call.mono { [0.0; 2] } else { drawn.machine.skew };
    // with `_CBIT[14]` L1 goes to the end of the ball (B:13652)
    let below = if setup.control.bit("_CBIT[14]") { radius } else { 0.0 };
    setup.probe.radius = radius;
    setup.probe.skew = skew;
    setup.probe.stylus = Some(0.0); // frames tilt the part, so that a straight one would meet it above the ball
    let control = &mut setup.control;
    let unit = control.basic_factor();
    let edge = control.tools.get_mut(&PROBE_TOOL).unwrap().edges.get_mut(&1).unwrap();
    edge.radius = radius;
    edge.length[0] = setup.probe.length + below;
    let beside = [skew[0], skew[1], below];
    let mut data = vec![(0, 2.0 * radius), (7, skew[0]), (8, skew[1])];
    for (axis, beside) in beside.into_iter().enumerate() {
        data.push((1 + 2 * axis, radius - beside));
        data.push((2 + 2 * axis, -radius - beside));
    }
    for (field, value) in data {
        control.set(format!("_WP[0,{field}]"), value / unit);
    }
}

/// The worked measurement of the variant with what was drawn, as a form takes it on this control.
pub fn typed(drawn: &Drawn, control: &Control) -> Typed {
    let cycle = drawn.cycle();
    let variant = cycle.variants.iter().find(|variant| variant.number == drawn.variant).unwrap();
    let mut values = example(cycle, variant);
    let worked = read(cycle, &values, control, &mut Vec::new());
    for param in cycle.params {
        let shown = values.get(param.name.as_str()).and_then(|text| text.parse::<f64>().ok());
        let unit = param.unit_with(&worked);
        let Some(value) = drawn_value(drawn, param.name.as_str(), unit, shown) else {
            continue;
        };
        values.insert(param.name.to_string(), format!("{}", value / factor(unit, control)));
    }
    values
}

/// A value as drawn, mm or degree; none: it is not written.
fn drawn_value(drawn: &Drawn, name: &str, unit: Unit, shown: Option<f64>) -> Option<f64> {
    let call = &drawn.call;
    let milling = drawn.cycle().purpose.machine == MachineSort::Milling;
    let multi_only = drawn.cycle == "CYCLE961"; // B:7528
    let [size, depth, angle, zone] = call.factors;
    let code = |codes: [i64; 8]| codes[call.target] as f64;
    let corrects_zero = drawn.variant / 100 % 10 == 1 || shown.is_none_or(|code| code < 2000.0 && code != 1.0);
    Some(match name {
        "_KNUM" if drawn.cycle().purpose.probe == ProbeUse::Tool => return shown,
        "_KNUM" if corrects_zero => code(ZERO),
        "_KNUM" => code(TOOL),
        "_PRNUM" if call.mono && !multi_only && milling => 101.0,
        "_CORA" if call.mono && !multi_only && milling => call.aside,
        "_DLNUM" => 2.0,
        "_PRNUM" => 1.0,
        "_RA" => 0.0, // which rotary axis it is depends on the plane
        "_EVNUM" if call.memory => 10.0,
        "_EVNUM" => 0.0,
        "_NMSP" => f64::from(call.points),
        "_VMS" => call.feed,
        "_FA" if drawn.cycle == "CYCLE998" => 3.0 * call.path, // a slope over a long way
        "_FA" if milling => call.path,
        "_FA" => call.path / 2.0, // grooves of a lathe leave no more room
        "_TSA" => 3.0,
        "_TDIF" => 2.0,
        "_MA" if call.axis > 0 && shown.is_some_and(|axis| axis < 3.0) => {
            let applicate = ["CYCLE974", "CYCLE978", "CYCLE994"].contains(&drawn.cycle);
            f64::from(if applicate { call.axis } else { call.axis.min(2) })
        }
        "_ID" => shown? * depth,
        "_SZA" | "_SZO" => shown? * size * zone.clamp(0.95, 1.05),
        _ if name.starts_with("_SETV") && unit != Unit::None => shown? * size,
        "_STA1" => shown? * angle,
        "_INCA" if drawn.cycle != "CYCLE961" => shown? * angle, // of a rectangle it is 90
        _ => return shown,
    })
}
