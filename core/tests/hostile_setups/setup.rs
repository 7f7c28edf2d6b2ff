//! Setup files with members of which each may be what nobody thinks of.

use crate::draw::Draw;
use probewright_core::control::{gud, machine_data, nct_data};
use probewright_core::dialect::Dialect;
use serde_json::{Map, Value, json};

/// Makes some members of a setup file others.
pub fn spoil(setup: &mut Value, dialect: Dialect, draw: &mut Draw) {
    for _ in 0..draw.of(&[0, 1, 1, 2, 3, 6]) {
        let mut leaves = Vec::new();
        numbers(setup, String::new(), &mut leaves);
        let path = leaves[draw.below(leaves.len())].clone();
        if let Some(place) = setup.pointer_mut(&path) {
            *place = changed(place, draw);
        }
    }
    if draw.chance(60) {
        probe(&mut setup["probe"], draw);
    }
    if draw.chance(40) {
        data(&mut setup["data"], dialect, draw);
    }
    if draw.chance(30) {
        edges(&mut setup["tools"], dialect, draw);
    }
    if draw.chance(20) {
        frame(&mut setup["frames"], dialect, draw);
    }
    if draw.chance(15) {
        setup["machine"] = machine(draw);
    }
    if draw.chance(10) {
        setup["active"]["spindle"] = draw.within(30.0).into();
        setup["active"]["rotary"] = triple(0.0, draw);
    }
    if draw.chance(20) {
        let cap = [("block", 3), ("turned", 4)];
        let solids = (0..draw.below(3)).map(|_| tool_probe(&cap, draw));
        setup["toolProbes"] = solids.collect();
    }
    if draw.chance(40) {
        let solids = (0..draw.below(4)).map(|_| solid(&SHAPES, draw));
        setup["workpiece"] = solids.collect();
    }
}

/// Another number of the sort that it was.
fn changed(before: &Value, draw: &mut Draw) -> Value {
    match before.as_f64() {
        Some(number) if number > 0.0 && draw.chance(70) && !before.is_i64() => draw.size(number).into(),
        Some(number) if before.is_i64() && number.abs() < 1e9 && draw.chance(60) => {
            let other = draw.within(number);
            (other as i64).into()
        }
        Some(number) => draw.within(number).into(),
        None => before.clone(),
    }
}

/// Where numbers stand.
fn numbers(value: &Value, path: String, found: &mut Vec<String>) {
    match value {
        Value::Number(_) => found.push(path),
        Value::Array(list) => {
            for (index, one) in list.iter().enumerate() {
                numbers(one, format!("{path}/{index}"), found);
            }
        }
        Value::Object(members) => {
            for (name, one) in members {
                let name = name.replace('~', "~0").replace('/', "~1");
                numbers(one, format!("{path}/{name}"), found);
            }
        }
        _ => {}
    }
}

fn triple(near: f64, draw: &mut Draw) -> Value {
    json!([draw.within(near), draw.within(near), draw.within(near)])
}

fn probe(probe: &mut Value, draw: &mut Draw) {
    let radius = probe["radius"].as_f64().unwrap_or(3.0);
    if draw.chance(50) {
        let distance = draw.between(0.0, 60.0);
        let body = [draw.between(0.0, 40.0), distance];
        let body = body.map(|size| if draw.chance(30) { draw.size(size) } else { size });
        probe["body"] = json!({ "radius": body[0], "distance": body[1] });
    }
    if draw.chance(30) {
        probe["stylus"] = draw.size(radius * 0.5).into();
    }
    if draw.chance(20) {
        probe["radius"] = draw.size(radius).into();
    }
    for (name, near) in [("skew", 0.1), ("preTravel", 0.02)] {
        if draw.chance(30) {
            probe[name] = json!([draw.within(near), draw.within(near)]);
        }
    }
    if draw.chance(10) {
        probe["delay"] = draw.within(0.001).into();
    }
    if draw.chance(10) {
        probe["falseSignal"] = draw.within(20.0).into();
    }
    if draw.chance(20) {
        probe["repeatability"] = json!([draw.size(0.001).min(1.0), draw.below(1 << 40)]);
    }
}

/// A name of a user datum, machine datum, R parameter or # variable.
pub fn datum(dialect: Dialect, draw: &mut Draw) -> String {
    if dialect == Dialect::Nct {
        let known: Vec<_> = nct_data::all().collect();
        return match draw.chance(70) {
            true => known[draw.below(known.len())].name.to_owned(),
            false => format!("#{}", draw.below(1000)),
        };
    }
    if draw.chance(30) {
        let table = machine_data::MACHINE_DATA;
        let names = table[draw.below(table.len())].names();
        return names[draw.below(names.len())].clone();
    }
    let all: Vec<_> = gud::all().filter(|gud| !gud.text()).collect();
    let gud = all[draw.below(all.len())];
    let element = &gud.elements[draw.below(gud.elements.len())];
    let places = gud.places(element, 3);
    gud.spelled(&places[draw.below(places.len())])
}

fn data(data: &mut Value, dialect: Dialect, draw: &mut Draw) {
    for _ in 0..draw.of(&[1, 2, 5, 20]) {
        let name = datum(dialect, draw);
        data[name] = draw.number(1.0).into();
    }
}

fn edges(tools: &mut Value, dialect: Dialect, draw: &mut Draw) {
    let number = match dialect {
        Dialect::Nct => "0".to_owned(),
        Dialect::Sinumerik => draw.of(&["3", "9", "20", "99"]).to_owned(),
    };
    let register = draw.of(&["1", "1", "2", "98", "99"]);
    if !tools[&number].is_object() {
        tools[&number] = json!({ "edges": {} });
    }
    let edge = &mut tools[&number]["edges"][register];
    if !edge.is_object() {
        *edge = json!({ "type": 120, "length": [80, 0, 0], "radius": 5 });
    }
    edge["type"] = draw.of(&[120, 120, 200, 240, 500, 500, 580, 710, 0, -1]).into();
    edge["tip"] = (draw.below(11) as i64 - 1).into();
    for name in ["radius", "radiusWear"] {
        if draw.chance(60) {
            edge[name] = draw.within(0.1).into();
        }
    }
    for name in ["length", "lengthWear"] {
        if draw.chance(40) {
            edge[name] = triple(40.0, draw);
        }
    }
    let further = (0..draw.below(3)).map(|_| {
        let number = draw.of(&[7, 8, 10, 11, 16, 21, 22, 23, 24, 25]);
        (number.to_string(), draw.within(1.0).into())
    });
    edge["further"] = further.collect::<Map<_, _>>().into();
    if draw.chance(50) {
        edge["real"] = real(draw);
    }
}

fn real(draw: &mut Draw) -> Value {
    let cut = if draw.chance(30) {
        let sides = [-1.0, 0.0, 1.0];
        json!({ "nose": { "radius": draw.size(0.8), "side": [draw.of(&sides), draw.of(&sides)] } })
    } else {
        let radius = draw.size(8.0);
        let mut part = |most: f64| {
            if draw.chance(60) { 0.0 } else { draw.between(0.0, most) }
        };
        let corner = part(radius);
        let chamfer = [part(radius - corner), part(5.0)];
        json!({ "cutter": {
            "radius": radius, "corner": corner, "teeth": draw.below(101),
            "chamfer": chamfer, "angle": draw.within(10.0),
            "runout": [draw.within(0.01), draw.within(0.01)], "runoutAngle": draw.within(10.0),
            "axis": draw.below(3), "disc": draw.size(0.0)
        } })
    };
    json!({ "length": triple(70.0, draw), "cut": cut })
}

fn frame(frames: &mut Value, dialect: Dialect, draw: &mut Draw) {
    let name = match dialect {
        Dialect::Nct => draw.of(&["G54", "G55", "COMMON"]),
        Dialect::Sinumerik => draw.of(&["G54", "G55", "G505", "$P_CHBFR[0]", "$P_SETFR", "$P_NCBFR[1]"]),
    };
    let mut one = json!({ "coarse": triple(0.0, draw) });
    for (member, near) in [("fine", 0.1), ("rotation", 10.0), ("rotary", 0.0), ("scale", 1.0)] {
        if draw.chance(30) {
            one[member] = triple(near, draw);
        }
    }
    if draw.chance(20) {
        one["mirror"] = json!([draw.chance(50), draw.chance(50), draw.chance(50)]);
    }
    frames[name] = one;
}

fn machine(draw: &mut Draw) -> Value {
    let mut limit = |near: f64| (!draw.chance(60)).then(|| draw.within(near));
    let minus = [limit(-1000.0), limit(-1000.0), limit(-1000.0)];
    let plus = [limit(1000.0), limit(1000.0), limit(1000.0)];
    json!({
        "limitsMinus": minus, "limitsPlus": plus, "spindlePositions": draw.chance(50),
        "rotaryCentre": triple(10.0, draw), "turret": { "diameter": draw.size(300.0), "width": draw.size(80.0) }
    })
}

/// Shapes, and how many sizes each has.
const SHAPES: [(&str, usize); 13] = [
    ("hole", 2),
    ("hole", 2),
    ("shaft", 2),
    ("groove", 3),
    ("web", 3),
    ("pocket", 3),
    ("island", 3),
    ("block", 3),
    ("turned", 4),
    ("chuck", 3),
    ("sphere", 1),
    ("outerCorner", 4),
    ("innerCorner", 4),
];

fn sizes(shape: &str, count: usize, draw: &mut Draw) -> Vec<f64> {
    let mut sizes: Vec<f64> = (0..count).map(|_| draw.size(40.0)).collect();
    match (shape, &mut sizes[..]) {
        ("turned", [diameter, length, bore, depth]) => match draw.chance(50) {
            true => (*bore, *depth) = (0.0, 0.0),
            false => (*bore, *depth) = (*diameter * draw.between(0.0, 1.0), *length * draw.between(0.0, 1.0)),
        },
        ("outerCorner" | "innerCorner", [angle, ..]) => *angle = draw.between(1.0, 179.0),
        _ => {}
    }
    sizes
}

fn solid(shapes: &[(&str, usize)], draw: &mut Draw) -> Value {
    let (shape, count) = draw.of(shapes);
    let sizes = sizes(shape, count, draw);
    let least = sizes.iter().copied().fold(f64::INFINITY, f64::min);
    let size = draw.within(0.1).clamp(-0.4 * least.abs(), 1e6);
    let lobes = draw.within(0.05).clamp(-0.2 * least.abs(), 0.2 * least.abs());
    json!({
        "shape": shape, "size": sizes, "at": triple(0.0, draw), "rotation": triple(0.0, draw),
        "errors": {
            "shift": triple(0.1, draw), "size": size, "tilt": triple(0.5, draw), "taper": draw.within(0.01),
            "outOfRound": [lobes, draw.of(&[0, 1, 2, 3, 3, 5, 12, 100])]
        }
    })
}

fn tool_probe(shapes: &[(&str, usize)], draw: &mut Draw) -> Value {
    let mut solid = solid(shapes, draw);
    if solid["shape"] == "turned" {
        solid["size"][2] = 0.into();
        solid["size"][3] = 0.into();
    }
    json!({ "solid": solid, "preTravel": draw.within(0.01), "delay": draw.within(0.001),
        "repeatability": [draw.within(0.001), draw.below(100)] })
}
