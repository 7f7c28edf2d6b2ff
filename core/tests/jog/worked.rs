//! The 23 worked examples of `tests/data/jog_examples.json`: parts whose place is known, touched by an ideal ball.

use super::{data, near};
use probewright_core::control::{AXES, Control, Frame, Plane, Store, delivery};
use probewright_core::dialect::Dialect;
use probewright_core::geometry::{Degrees, Rpy, Wcs};
use probewright_core::jog::evaluate::{self, Chord, Found, Size};
use probewright_core::jog::mask::Element;
use probewright_core::jog::stylus::{Stylus, Touch};
use probewright_core::jog::values::Values;
use probewright_core::jog::{Mask, Outcome, Point, calculate, masks, offset};
use serde_json::Value;
use std::collections::BTreeSet;

/// All examples.
fn examples() -> Vec<Value> {
    let all: Value = serde_json::from_str(data!("jog_examples.json")).unwrap();
    all["worked"].as_array().unwrap().clone()
}

fn example(id: &str) -> Value {
    examples().into_iter().find(|one| one["id"] == id).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    std::array::from_fn(|index| number(&value[index]))
}

/// The frame that an example gives: translation, or coarse and fine, and rotation.
fn frame(given: &Value) -> Frame {
    let or = |name: &str, other: [f64; 3]| if given[name].is_array() { numbers(&given[name]) } else { other };
    Frame {
        coarse: or("TR", or("coarse", [0.0; 3])),
        fine: or("fine", [0.0; 3]),
        rotation: Rpy(or("RT", [0.0; 3])),
        ..Frame::default()
    }
}

/// A control with what an example gives: G54, the data of the probe, the frame that is active while measuring.
fn control(given: &Value) -> Control {
    let mut control = delivery(Dialect::Sinumerik);
    control.plane = Plane::G17;
    if let Some(data) = given["_WP"].as_object() {
        for (index, value) in data {
            control.set(format!("_WP[0,{index}]"), number(value));
        }
    }
    let mut g54 = frame(&given["G54"]);
    if let Some(angle) = given["G54_C"].as_f64() {
        g54.rotary[2] = Degrees(angle);
    }
    control.frames.insert(1, g54);
    control.activate(usize::from(given["wo_measuring"] == "G54"));
    control
}

/// The values of a mask as an example gives them.
fn values(mask: &Mask, given: &Value, control: &Control) -> Values {
    let mut values = Values::first(mask, control);
    let mut put = |name: &str, text: &str| {
        let field = mask.field(name).unwrap_or_else(|| panic!("{} {name}", mask.name));
        values.enter(mask, field, text, control).unwrap();
    };
    let names = [
        ("X0", "x0"),
        ("Y0", "y0"),
        ("spec_angle", "spec_angle"),
        ("pos", "pos"),
        ("corner", "corner"),
        ("Diameter", "diameter"),
        ("contact_angle", "contact_angle"),
        ("L", "l"),
        ("W", "w"),
        ("DZ", "dz"),
    ];
    for (given_name, name) in names {
        match &given[given_name] {
            Value::Number(number) => put(name, &number.to_string()),
            Value::String(text) => put(name, text),
            _ => {}
        }
    }
    match &given["angle_offset"] {
        Value::String(text) => put("angle_offset", if text == "Coord. rot." { "rotation" } else { text }),
        Value::Bool(yes) => put("angle_offset", if *yes { "yes" } else { "no" }),
        _ => {}
    }
    if let Some(text) = given["meas_direct"].as_str() {
        put("direction", &text[..1]);
        put("axis", &text[1..]);
        put("ref_axis", given["ref_axis"].as_str().unwrap());
    }
    if given["set_p1"] == true {
        put("set_p1", "yes");
        put("x1", &given["X1"].to_string());
        put("y1", &given["Y1"].to_string());
    } else if mask.field("set_p1").is_some() && given["angle_offset"] == "Coord. rot." {
        put("set_p1", "no");
    }
    values
}

fn touch(told: &Value) -> Touch {
    Touch {
        at: Wcs(numbers(&told["p"])),
        axis: AXES.iter().position(|axis| told["axis"] == *axis).unwrap(),
        sign: number(&told["direction"]),
    }
}

fn points(example: &Value) -> Vec<Point> {
    let touches = example["touches"].as_array().unwrap().iter();
    touches
        .map(|told| match told["centre"].is_array() {
            true => Point::Element(Found { centre: numbers(&told["centre"]), height: 0.0, size: [0.0; 2] }),
            false => Point::Touch(touch(told)),
        })
        .collect()
}

/// Names of the results in the examples.
fn result_name(name: &'static str) -> &'static [&'static str] {
    match name {
        "meas_x0" => &["meas X0", "measX0", "centre"],
        "meas_y0" => &["meas Y0", "measY0"],
        "meas_l" => &["meas L", "L"],
        "meas_w" => &["meas W"],
        other => std::slice::from_ref(match other {
            "alpha" => &"alpha",
            "beta" => &"beta",
            _ => &"diameter",
        }),
    }
}

/// Figures of the examples are rounded to 1e-9, of which a chain of them makes a little more.
fn close(found: f64, wanted: f64, what: &str) {
    assert!((found - wanted).abs() < 2e-8, "{what}: {found}, expected {wanted}");
}

fn compare(example: &Value, outcome: &Outcome) {
    let (id, expected) = (&example["id"], &example["expected"]);
    let mut compared = 0;
    for (name, value) in &outcome.results {
        for known in result_name(name) {
            if let Some(wanted) = expected[*known].as_f64() {
                close(*value, wanted, &format!("{id} {name}"));
                compared += 1;
            }
        }
    }
    let shown = expected.as_object().unwrap().iter().filter(|(name, value)| value.is_f64() && !name.starts_with("G54"));
    assert_eq!(compared, shown.count(), "{id}: every result is compared");
}

/// Writes what an outcome corrects into G54.
fn correct(control: &mut Control, outcome: &Outcome) {
    let correction = outcome.correction.as_ref().unwrap();
    for write in offset::writes(control, Store::Settable(1), correction) {
        assert!(control.set_variable(&write.name, write.value), "{}", write.name);
    }
}

/// G54 is what an example expects.
fn g54(control: &Control, expected: &Value, what: &str) {
    let frame = control.frames[&1];
    let told = |name: &str, found: [f64; 3]| {
        if expected[name].is_array() {
            let wanted: [f64; 3] = numbers(&expected[name]);
            (0..3).for_each(|axis| close(found[axis], wanted[axis], &format!("{what} {name} {axis}")));
        }
    };
    told("TR", frame.origin());
    told("coarse", frame.coarse);
    told("fine", frame.fine);
    told("RT", frame.rotation.0);
    assert_eq!(frame.fine, [0.0; 3], "{what}");
}

/// Examples that a mask calculates from touches along axes, or from centres: all but those of the next tests.
const BY_MASK: [(&str, &str); 13] = [
    ("W03", "set_edge"),
    ("W04", "align_edge"),
    ("W05", "align_edge"),
    ("W06a", "distance"),
    ("W06b", "distance"),
    ("W06c", "distance"),
    ("W07", "corner_right"),
    ("W08", "corner_any"),
    ("W12a", "holes_2"),
    ("W12b", "holes_2"),
    ("W13", "holes_3"),
    ("W14", "holes_4"),
    ("W15", "align_plane"),
];

// oracle: hand (tests/data/jog_examples.json)
#[test]
fn masks_give_what_was_worked_out() {
    for (id, mask) in BY_MASK {
        let example = example(id);
        let (given, expected) = (&example["given"], &example["expected"]);
        let mask = masks::find(mask).unwrap();
        let mut control = control(given);
        let values = values(mask, given, &control);
        let stylus = Stylus::of(&control, 1, false);
        let points = points(&example);
        if mask.name.starts_with("corner") {
            let sides = [(1, 0), (1, 0), (0, 1), (0, 1)];
            for (point, (axis, place)) in points.iter().zip(sides) {
                let Point::Touch(touch) = point else { panic!("{id}") };
                let side = probewright_core::jog::corner_sides(&values)[place];
                assert_eq!((touch.axis, touch.sign), (axis, side.sign), "{id}: position of the corner");
            }
        }
        let outcome = calculate(&control, mask, &values, &stylus, &points).unwrap();
        compare(&example, &outcome);
        if expected["G54"].is_object() {
            correct(&mut control, &outcome);
            g54(&control, &expected["G54"], id);
        }
        if let Some(angle) = expected["G54_C"].as_f64() {
            let before = control.frames[&1].rotation;
            correct(&mut control, &outcome);
            close(control.frames[&1].rotary[2].0, angle, id);
            assert_eq!(control.frames[&1].rotation, before, "{id}: the rotation stays");
        }
    }
}

/// What the mask of an element says of it.
fn size(given: &Value, round: bool, inside: bool) -> Size {
    let of = |name: &str| given[name].as_f64().unwrap_or_default();
    Size {
        element: Element { round, inside },
        size: if round { [of("Diameter"); 2] } else { [of("L"), of("W")] },
        angle: Degrees(of("contact_angle")),
        infeed: of("DZ"),
    }
}

// oracle: hand (tests/data/jog_examples.json)
#[test]
fn elements_give_what_was_worked_out() {
    for (id, mask, round, inside) in
        [("W09", "hole_1", true, true), ("W10", "hole_1", true, true), ("W11", "spigot_rect", false, false)]
    {
        let example = example(id);
        let (given, expected) = (&example["given"], &example["expected"]);
        let mask = masks::find(mask).unwrap();
        let mut control = control(given);
        let values = values(mask, given, &control);
        let stylus = Stylus::of(&control, 1, false);
        let size = size(given, round, inside);
        let latched: [Wcs; 4] = std::array::from_fn(|index| Wcs(numbers(&example["touches"][index]["p"])));
        let found = evaluate::element(&stylus, &size, latched, latched[0][2]);
        let outcome = calculate(&control, mask, &values, &stylus, &[Point::Element(found)]).unwrap();
        compare(&example, &outcome);
        if expected["G54"].is_object() {
            correct(&mut control, &outcome);
            g54(&control, &expected["G54"], id);
        }
        let start: [f64; 3] = numbers(&given["start"]);
        let mut at = [start[0], start[1]];
        let path = number(&given["E_MESS_D_M"]);
        for number in 0..4 {
            if number == 2 {
                let balls = [latched[0], latched[1]].map(|at| stylus.in_plane(stylus.ball_at(at)));
                at = evaluate::middle(at, size.angle, balls);
            }
            let block = evaluate::block(&size, number, at, stylus.radius, path);
            let wanted = match (&expected["blocks"][number], &expected["first_block"]) {
                (Value::Null, first) if number == 0 => first,
                (Value::Null, _) => continue,
                (told, _) => told,
            };
            for (found, name) in [(block.start, "start"), (block.end, "end")] {
                (0..2)
                    .for_each(|axis| close(found[axis], wanted[name][axis].as_f64().unwrap(), &format!("{id} {name}")));
            }
        }
    }
}

// oracle: hand (tests/data/jog_examples.json): the first three touches make the same circle
#[test]
fn three_touches_of_a_hole_make_the_same_circle() {
    let example = example("W10");
    let control = control(&example["given"]);
    let stylus = Stylus::of(&control, 1, false);
    let ball = |index: usize| stylus.in_plane(stylus.ball_at(Wcs(numbers(&example["touches"][index]["p"]))));
    let centre = evaluate::circle([ball(0), ball(1), ball(2)]).unwrap();
    close(centre[0], 4.0, "X");
    close(centre[1], 2.0, "Y");
}

// oracle: hand (tests/data/jog_examples.json)
#[test]
fn calibrating_gives_what_was_worked_out() {
    for id in ["W01a", "W01b"] {
        let example = example(id);
        let (given, expected) = (&example["given"], &example["expected"]);
        let position = touch(&example["touches"][0]).at[2];
        let circumference = given["_CBIT[14]"] == 1;
        let of = |name: &str| number(&given[name]);
        let (length, trigger) = evaluate::length(of("L1_old"), position, of("Z0"), of("r"), circumference);
        near(length, number(&expected["L1"]), id);
        near(trigger, number(&expected["_WP[k,5]"]), id);
    }
    let example = example("W02");
    let at: Vec<[f64; 3]> = example["touches"].as_array().unwrap().iter().map(|told| numbers(&told["p"])).collect();
    let chord = |first: usize, axis: usize| Chord {
        plus: at[first][axis],
        minus: at[first + 1][axis],
        across: at[first][1 - axis],
    };
    let run = |first: usize| [chord(first, 0), chord(first + 2, 1)];
    let ring = evaluate::ring(number(&example["given"]["D"]), run(0), run(4), false);
    let [[x, to_x], [y, to_y]] = ring.triggers;
    let found = [ring.ball, x, to_x, y, to_y, ring.skew[0], ring.skew[1]];
    for (place, value) in [0, 1, 2, 3, 4, 7, 8].into_iter().zip(found) {
        close(value, number(&example["expected"][format!("_WP[k,{place}]")]), &format!("_WP {place}"));
    }
    (0..2).for_each(|axis| close(ring.centre[axis], number(&example["expected"]["centre"][axis]), "centre"));
}

/// A mask, its values, and which touches are its points.
type Step = (&'static str, &'static [(&'static str, &'static str)], std::ops::Range<usize>);

// oracle: hand (tests/data/jog_examples.json): each step presupposes the one before
#[test]
fn a_cascade_finds_the_part_whole() {
    let example = example("W16");
    let (given, expected) = (&example["given"], &example["expected"]);
    let mut control = control(given);
    control.frames.insert(1, frame(&given["start_G54"]));
    control.activate(1);
    let stylus = Stylus::of(&control, 1, false);
    let told = example["touches"].as_array().unwrap();
    let steps: [Step; 5] = [
        ("align_plane", &[], 0..3),
        ("align_edge", &[("axis", "Y"), ("ref_axis", "X")], 3..5),
        ("set_edge", &[("axis", "X")], 5..6),
        ("set_edge", &[("axis", "Y")], 6..7),
        ("set_edge", &[("axis", "Z"), ("direction", "-")], 7..8),
    ];
    for (mask, entered, touches) in steps {
        let mask = masks::find(mask).unwrap();
        let mut values = Values::first(mask, &control);
        for (name, text) in entered {
            values.enter(mask, mask.field(name).unwrap(), text, &control).unwrap();
        }
        let points: Vec<Point> = told[touches.clone()].iter().map(|told| Point::Touch(touch(told))).collect();
        g54(&control, &told[touches.start]["zo"], mask.name);
        let outcome = calculate(&control, mask, &values, &stylus, &points).unwrap();
        let after = match mask.name {
            "align_plane" => &expected["after_plane"],
            "align_edge" => &expected["after_edge"],
            _ => &Value::Null,
        };
        for (name, value) in outcome.results.iter().filter(|(name, _)| after[*name].is_f64()) {
            close(*value, number(&after[*name]), name);
        }
        correct(&mut control, &outcome);
        control.activate(1);
        g54(&control, after, mask.name);
    }
    g54(&control, &expected["G54"], "the part");
}

// oracle: hand (tests/data/jog_examples.json)
#[test]
fn tools_give_what_was_worked_out() {
    let [calibrated, length, radius] = ["W17", "W18", "W19"].map(example);
    let of = |example: &Value, name: &str| number(&example["given"][name]);
    // the face is the radius of the calibration tool away from its axis
    let face = number(&calibrated["touches"][1]["axis_at"]) - of(&calibrated, "R");
    near(face, number(&calibrated["expected"]["t(X,-)"]), "face");
    near(number(&calibrated["touches"][0]["tip"]), number(&calibrated["expected"]["t(Z,-)"]), "top");
    let (beside, rotates) = evaluate::beside(of(&length, "R"), of(&length, "V"), of(&length, "E_MESS_MT_DL"));
    assert_eq!(Value::Bool(rotates), length["expected"]["rotating"]);
    near(beside, number(&length["expected"]["beside_centre"]), "beside");
    let tip = number(&length["touches"][0]["tip"]);
    near(
        evaluate::new_length(of(&length, "L1_old"), tip, of(&length, "t(Z,-)")),
        number(&length["expected"]["L1"]),
        "L1",
    );
    let low = evaluate::tip_height(of(&radius, "t(Z,-)"), of(&radius, "E_MESS_MT_DZ"), of(&radius, "V"));
    near(low, number(&radius["expected"]["tip_height"]), "height");
    let found = evaluate::new_radius(number(&radius["touches"][0]["axis_at"]), of(&radius, "t(X,-)"));
    near(found, number(&radius["expected"]["R"]), "radius");
    near(found - of(&radius, "R_old"), number(&radius["expected"]["wear"]), "wear");
}

// oracle: self: no example is left out
#[test]
fn every_example_is_in_a_test() {
    let by_mask = BY_MASK.iter().map(|(id, _)| *id);
    let others = ["W01a", "W01b", "W02", "W09", "W10", "W11", "W16", "W17", "W18", "W19"];
    let tested: BTreeSet<String> = by_mask.chain(others).map(str::to_owned).collect();
    let all: BTreeSet<String> = examples().iter().map(|one| one["id"].as_str().unwrap().to_owned()).collect();
    assert_eq!(all, tested);
    assert_eq!(all.len(), 23);
}
