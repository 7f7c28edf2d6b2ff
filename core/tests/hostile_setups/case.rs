//! Questions of the page about hostile machines: a form with its prediction, or a program.

use crate::draw::Draw;
use crate::setup::{datum, spoil};
use probewright_core::catalogue::CYCLES;
use probewright_core::catalogue::example::example;
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, Variant};
use probewright_core::{app, json};
use serde_json::{Map, Value, json as document};

/// A question.
pub struct Case {
    /// Cycle and variant.
    pub name: String,
    /// Of a program; else of a form.
    pub run: bool,
    /// The question itself.
    pub request: Value,
}

impl Case {
    /// The one with this seed.
    pub fn new(seed: u64) -> Case {
        let mut draw = Draw::new(seed);
        let cycle = &CYCLES[draw.below(CYCLES.len())];
        let variant = &cycle.variants[draw.below(cycle.variants.len())];
        let run = draw.chance(40);
        let mut request = asked(cycle, variant, &mut draw);
        if run {
            request = program(cycle, &request, &mut draw);
        }
        Case { name: format!("{} {}", cycle.name, variant.number), run, request }
    }

    /// A form at which much has to be looked at: a part with every error, and a probe with stylus and body.
    pub fn heavy(seed: u64) -> Case {
        let mut draw = Draw::new(seed);
        draw.wild = draw.of(&[0, 0, 0, 1, 5]);
        let measured = CYCLES.iter().filter(|cycle| cycle.work().is_some());
        let measured: Vec<_> = measured.collect();
        let cycle = measured[draw.below(measured.len())];
        let variant = &cycle.variants[draw.below(cycle.variants.len())];
        let mut request = asked(cycle, variant, &mut draw);
        request["limits"] = false.into();
        let part = &mut request["errors"]["part"];
        part["outOfRound"] = draw.sized(-5.0, 0.7).into();
        if draw.chance(50) {
            part["taper"] = draw.sized(-4.0, 0.5).into();
        }
        let probe = &mut request["setup"]["probe"];
        if probe.is_object() && draw.chance(80) {
            let radius = match draw.chance(60) {
                true => nearly_fits(&request["values"], &mut draw),
                false => draw.sized(-0.5, 2.0).abs(),
            };
            let distance = draw.sized(-0.5, 1.5).abs();
            let probe = &mut request["setup"]["probe"];
            probe["body"] = document!({ "radius": radius, "distance": distance });
            if draw.chance(30) {
                let ball = probe["radius"].as_f64().unwrap_or(3.0);
                probe["stylus"] = (ball - draw.sized(-5.0, 0.0).abs()).abs().into();
            }
        }
        Case { name: format!("{} {}", cycle.name, variant.number), run: false, request }
    }

    /// The answer, or why there is none.
    pub fn answer(&self) -> Result<Value, json::Error> {
        let request = self.request.to_string();
        if !self.run {
            return form(&request);
        }
        let mut run = app::Run::new(json::question(&request)?)?;
        while !run.advance(1000) {}
        Ok(json::document(&run.view()))
    }
}

fn form(request: &str) -> Result<Value, json::Error> {
    Ok(json::document(&app::form(json::question(request)?)?))
}

/// A radius that a body has which has little room in what is measured.
fn nearly_fits(values: &Value, draw: &mut Draw) -> f64 {
    let sizes = ["_SETVAL", "D", "W", "_SETV[0]", "_SETV[1]"];
    let sizes = sizes.iter().filter_map(|name| values[name].as_str()?.parse::<f64>().ok());
    let sizes: Vec<f64> = sizes.collect();
    let size = if sizes.is_empty() { 20.0 } else { draw.of(&sizes) };
    (size / 2.0 - draw.sized(-4.0, 0.7)).abs().max(0.1)
}

/// The worked measurement of a variant, some of its values others, with errors and on a machine.
fn asked(cycle: &'static Cycle, variant: &Variant, draw: &mut Draw) -> Value {
    let control = cycle.dialect;
    let mut values = example(cycle, variant);
    let plane = draw.of(&["G17", "G17", "G18", "G19"]);
    let mut request = document!({ "control": control, "cycle": cycle.name, "values": values, "predict": true });
    if draw.chance(70) {
        let mut setup = machine(&request, plane);
        spoil(&mut setup, cycle.dialect, draw);
        request["setup"] = setup;
    } else {
        request["setup"] = document!({ "own": own(cycle.dialect, plane, draw) });
    }
    let count = if cycle.params.is_empty() { 0 } else { draw.of(&[0, 0, 1, 2, 5]) };
    for _ in 0..count {
        let param = &cycle.params[draw.below(cycle.params.len())];
        let before = values.get(param.name.as_str()).and_then(|text| text.parse().ok());
        let number = draw.number(before.unwrap_or(1.0));
        values.insert(param.name.to_string(), format!("{number:?}"));
    }
    request["values"] = document!(values);
    request["errors"] = errors(draw);
    request["limits"] = (draw.below(100) == 0).into();
    if draw.chance(20) {
        request["plane"] = draw.of(&["G17", "G18", "G19"]).into();
    }
    request
}

/// The machine and the part that the page would show for a question.
fn machine(request: &Value, plane: &str) -> Value {
    let mut request = request.clone();
    request["setup"] = document!({ "own": { "plane": plane } });
    let view = form(&request.to_string()).unwrap_or_default();
    view["setup"].clone()
}

fn own(dialect: Dialect, plane: &str, draw: &mut Draw) -> Value {
    let mut data = Map::new();
    for _ in 0..draw.below(4) {
        data.insert(datum(dialect, draw), draw.number(1.0).into());
    }
    document!({ "basic": draw.of(&["mm", "inch"]), "plane": plane, "data": data })
}

/// What the sliders say; they are also fields.
fn errors(draw: &mut Draw) -> Value {
    let part =
        [("dx", 0.2), ("dy", 0.2), ("dz", 0.2), ("size", 0.2), ("tilt", 0.5), ("taper", 0.01), ("outOfRound", 0.02)];
    let probe = [("skewX", 0.05), ("skewY", 0.05), ("radius", 0.02), ("preTravel", 0.02), ("repeatability", 0.001)];
    let mut some = |all: &[(&str, f64)]| {
        let mut members = Map::new();
        for (name, size) in all {
            if draw.chance(30) {
                let near = draw.between(-size, *size);
                members.insert((*name).to_owned(), draw.number(near).into());
            }
        }
        members
    };
    document!({ "part": some(&part), "probe": some(&probe) })
}

/// A program with the call of a form, and before it what spoils it.
fn program(cycle: &Cycle, form: &Value, draw: &mut Draw) -> Value {
    let snippet = self::form(&form.to_string()).unwrap_or_default();
    let snippet = snippet["snippet"].as_str().unwrap_or_default().to_owned();
    let before: String = (0..draw.below(6)).map(|_| line(cycle.dialect, draw)).collect();
    let behind = line(cycle.dialect, draw);
    document!({ "control": form["control"], "setup": form["setup"],
        "text": format!("{before}{snippet}\n{behind}M30\n") })
}

fn line(dialect: Dialect, draw: &mut Draw) -> String {
    let mut number = |near: f64| match dialect {
        Dialect::Nct => format!("{}", draw.number(near)),
        Dialect::Sinumerik => format!("{:e}", draw.number(near)).replace('e', "EX"),
    };
    let [a, b, c] = [number(10.0), number(1.0), number(0.0)];
    let name = datum(dialect, draw);
    if dialect == Dialect::Nct {
        return match draw.below(8) {
            0 => format!("G0 X{a} Y{b}\n"),
            1 => format!("G1 F100 Z{a}\n"),
            2 => format!("G2 X{a} Y{b} I{c} J{a} F100\n"),
            3 => format!("T{} M6\nG43 H{}\n", draw.below(3), draw.below(100)),
            4 => format!("G41 D{}\nG1 X{a} F100\nG1 Y{b}\nG40 X{c}\n", draw.below(4)),
            5 => format!("G68 X{a} Y{b} R{c}\nG0 X{b}\n"),
            6 => format!("#1=[{a}]*{b}\n#5221=#1\n"),
            _ => format!("{name}={a}\n"),
        };
    }
    let (tool, edge) = (draw.of(&[3, 9, 20]), draw.of(&[1, 1, 2]));
    match draw.below(16) {
        0 => format!("$TC_DP{}[{tool},{edge}]={a}\n", draw.of(&[1, 2, 3, 6, 7, 15, 12, 21])),
        1 => format!("$TC_DP6[{tool},1]={c}\n$TC_DP15[{tool},1]={b}\nT{tool} D1 M6\nG0 X0\n"),
        2 => format!("T{tool} D{edge} M6\nG0 X={a} Y={b}\n"),
        3 => format!("G1 F100 X={a} Z={b}\n"),
        4 => format!("G{} X={a} Y={b} I={c} J={a} F100\n", draw.of(&[2, 3])),
        5 => format!("G2 X={a} Y={b} CR={c} TURN={} F=100\n", draw.below(3)),
        6 => format!("$P_UIFR[1,{},{}]={a}\nG54\n", draw.of(&["X", "Y", "Z"]), draw.of(&["TR", "FI", "RT", "SC"])),
        7 => format!("TRANS X={a} Y={b}\nAROT RPL={c}\nASCALE X={b}\n"),
        8 => format!("G41\nG1 X={a} F100\nG1 Y={b}\nG2 X={c} Y={a} CR={b}\nG40 X={c}\n"),
        9 => format!("M3 S={a}\nSPOS={b}\n"),
        10 => {
            format!("R1={a}*{b}\nR2=SQRT(R1)+TAN({c})+{a} MOD {b}\nR3=R1 DIV {c}\nG0 X=R2 Y=R1\n")
        }
        11 => format!("G{}\n", draw.of(&[17, 18, 19, 70, 71, 700, 710, 90, 91, 96, 95])),
        12 => format!("MEAS=1 G1 X={a} F=100\n"),
        13 => format!("G111 X={a}\nG1 AP={b} RP={c} F=100\n"),
        _ => format!("{name}={a}\n"),
    }
}
