//! Parts that a program mills: their size is what the path of the mill leaves of them, and follows the tool that the
//! measurement corrects.

use super::bench::{call, near, result, with};
use super::tool::{MEASURED, machine};
use probewright_core::dialect::Dialect;
use probewright_core::machine::Setup;
use probewright_core::machine::route::Route;
use probewright_core::machine::trace::{MotionKind, Step};
use probewright_core::run::{Limits, run};
use probewright_core::syntax::read;
use probewright_core::workpiece::PartErrors;

/// Radius of the mill as it is, mm; the tool memory says 10.
const TRUE: f64 = 9.88;

/// What is milled by its measuring variant: the program, and the set sizes along X and Y, where it has them.
const JOBS: [(f64, &str, [Option<f64>; 2]); 6] = [
    (1.0, "G0 X0 Y0\nG41 G1 X30\nG3 X30 Y0 I-30 J0\nG40 G1 X0", [Some(60.0), Some(60.0)]),
    (2.0, "G0 X60 Y0\nG41 G1 X30\nG2 X30 Y0 I-30 J0\nG40 G1 X60", [Some(60.0), Some(60.0)]),
    (3.0, "G0 X0 Y-40\nG41 G1 X30\nY40\nX-30\nY-40\nG40 X0", [Some(60.0), None]),
    (4.0, "G0 X60 Y-40\nG42 G1 X30\nY40\nX-30\nY-40\nG40 X-60", [Some(60.0), None]),
    (5.0, "G0 X0 Y0\nG41 G1 X30\nY22\nX-30\nY-22\nX30\nY0\nG40 X0", [Some(60.0), Some(44.0)]),
    (6.0, "G0 X60 Y0\nG42 G1 X30\nY22\nX-30\nY-22\nX30\nY0\nG40 X60", [Some(60.0), Some(44.0)]),
];

/// What the radius is corrected by: `_KNUM`, what a program says to mill with it, and where it is kept (B:1894-1928,
/// B:2031-2060).
const OFFSETS: [(f64, &str, &str); 2] = [(2001.0, "D1", "$TC_DP15[20,1]"), (1_002_001.0, "D1 DL=2", "$TC_SCP26[20,1]")];

/// Holes, grooves and inner rectangles have odd variants.
fn inside(variant: f64) -> bool {
    variant % 2.0 == 1.0
}

/// How much larger the part becomes than it should be in X or Y: what the mill leaves where it passes beside the
/// middle, sampled along every motion with feed.
fn machined(setup: &mut Setup, variant: f64, text: &str, axis: usize, size: f64) -> f64 {
    let text = format!("G17 G90 G40 T20 M6\nF500 {text}\nM30");
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let outcome = run(&program, setup, Limits::default());
    assert_eq!((&outcome.stop, &outcome.diagnostics[..]), (&None, &[][..]));
    let steps = outcome.trace.entries.iter();
    let routes = steps.filter_map(|entry| match entry.step {
        Step::Motion { kind: MotionKind::Positioning, from, to, around, .. } => Some(Route { from, to, around }),
        _ => None,
    });
    // a circle is as far away everywhere, a straight line where it passes the middle
    let away = routes.flat_map(|route| {
        let places = (0..=400).map(move |part| route.at(f64::from(part) / 400.0).0);
        places.filter_map(move |[x, y, _]| match route.around {
            Some(_) => Some(x.hypot(y)),
            None => ([x, y][1 - axis].abs() < 1.0).then_some([x, y][axis].abs()),
        })
    });
    let half = match inside(variant) {
        true => away.fold(0.0, f64::max) + TRUE,
        false => away.fold(f64::INFINITY, f64::min) - TRUE,
    };
    2.0 * half - size
}

// oracle: hand: a mill that is thinner than the tool memory says leaves twice the difference in holes and on shafts;
// the correction of its wear radius, or of an additive offset with which it mills, brings the next part to size
#[test]
fn the_next_part_follows_the_corrected_mill() {
    for (variant, text, sizes) in JOBS {
        for frame in ["", "MIRROR Y0\n", "AROT Z180\n"] {
            for offset in OFFSETS {
                two_parts(variant, &format!("{frame}{text}"), sizes, offset);
            }
        }
    }
}

/// Mills and measures a part and, with the mill that this corrects, another one.
fn two_parts(variant: f64, text: &str, sizes: [Option<f64>; 2], (code, edge, datum): (f64, &str, &str)) {
    let mut setup = machine();
    let judged = [
        ("_MVAR", variant),
        ("_MA", 1.0),
        ("_ID", -25.0),
        ("_KNUM", code),
        ("_DLNUM", 2.0),
        ("_TZL", 0.001),
        ("_TMV", 0.01),
        ("_TUL", 0.5),
        ("_TLL", -0.5),
        ("_TDIF", 0.5),
    ];
    let values = with(&MEASURED, &judged);
    let what = format!("{variant} {code} {text}");
    let program = format!("{edge}\n{text}");
    let mut wrong = Vec::new();
    for _ in 0..2 {
        let made: Vec<f64> = (0..2)
            .filter_map(|axis| Some((axis, sizes[axis]?)))
            .map(|(axis, size)| machined(&mut setup, variant, &program, axis, size))
            .collect();
        let size = made[0];
        made.iter().for_each(|other| near(*other, size, 1e-9, &what));
        let errors = PartErrors { size, ..PartErrors::default() };
        call(&mut setup, "CYCLE977", &values, errors);
        near(result(&setup, 16), size, 1e-9, &what);
        wrong.push(size);
    }
    let believed = 10.0 - TRUE;
    let first = if inside(variant) { -2.0 } else { 2.0 } * believed;
    near(wrong[0], first, 1e-9, &what);
    near(wrong[1], 0.0, 1e-9, &what);
    let corrected = setup.control.variable(datum).unwrap();
    near(corrected, -believed, 1e-9, &what);
}
