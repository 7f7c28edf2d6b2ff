//! NCT programs.

use super::near;
use super::running::machine;
use probewright_core::control::{Control, Plane};
use probewright_core::diagnostic::Code;
use probewright_core::dialect::Dialect;
use probewright_core::geometry::{Mcs, Rpy};
use probewright_core::machine::{Setup, Stop};
use probewright_core::run::{Limits, run};
use probewright_core::syntax::read;
use probewright_core::workpiece::{PartErrors, Shape, Solid};

fn edge(control: &Control, number: i64) -> f64 {
    control.register(number).length[0]
}

#[test]
fn nct_words_are_understood() {
    let setup = Setup::calibrated(Dialect::Nct, Plane::G17);
    let text = "%O0001 (TEST)\nG17 G90 G40 G55 G21\n#100=0\nWHILE [#100 LT 3] DO1\n#100=#100+1\nEND1\n\
        IF [#100 EQ 3] GOTO 50\n#101=9\nN50 G0 X[#100*2] Y5.\nG43 Z20. H98\nM30\n%";
    let outcome = run(&read(Dialect::Nct, text.as_bytes()), &setup, Limits::default());
    assert_eq!((outcome.stop.clone(), &outcome.diagnostics[..]), (None, &[][..]));
    // oracle: hand
    near(outcome.end().0, [6.0, 5.0, 20.0]);
    assert_eq!(outcome.control.number("#101"), 0.0);
    assert_eq!(outcome.control.settable, 2);
    assert_eq!(edge(&outcome.control, 98), 53.0);
}

/// A bore in the plane Z-X, its axis along Y, bigger and off its place.
fn bore(diameter: f64, at: [f64; 3]) -> Setup {
    let mut setup = Setup::calibrated(Dialect::Nct, Plane::G17);
    setup.workpiece.solids.push(Solid {
        shape: Shape::Hole { diameter, depth: 60.0 },
        at: Mcs(at),
        rotation: Rpy([-90.0, 0.0, 0.0]),
        errors: PartErrors::default(),
    });
    setup.position = Mcs([120.0, 300.0, 200.0]);
    setup
}

/// The bore of the manual of the other control (C:1159-1183), written anew: finds the centre for G59.
const BORE: &str = "%O0110 (BORE)\nG59 G18 G90 G40\nM19\nT98\nG43 Y100 H98\nG101 X120 Z200\nG101 Y-10\nG110 D50 S6\n\
    G0 Y100\nG41 D1\nG40\nM30\n%";

#[test]
fn a_bore_moves_its_work_offset() {
    let setup = bore(50.0, [120.4, 0.0, 199.7]);
    let outcome = run(&read(Dialect::Nct, BORE.as_bytes()), &setup, Limits::default());
    assert_eq!((outcome.stop.clone(), &outcome.diagnostics[..]), (None, &[][..]));
    // oracle: manual C:1159-1183: G59 takes over where the centre was found
    let offset = outcome.control.frames[&6].coarse;
    near(offset, [0.4, 0.0, -0.3]);
}

#[test]
fn a_bore_corrects_its_tool_behind_its_work_offset() {
    // oracle: manual C:1159-1183: the second call compares with H 0.3 and corrects register 1
    let setup = bore(50.2, [120.4, 0.0, 199.7]);
    let program = include_bytes!("../../../tests/cases/nct_bore/program.nc");
    let outcome = run(&read(Dialect::Nct, program), &setup, Limits::default());
    assert_eq!(outcome.stop, None, "{:?}", outcome.diagnostics);
    near(outcome.control.frames[&6].coarse, [0.4, 0.0, -0.3]);
    let before = outcome.before.register(1);
    let after = outcome.control.register(1);
    let change = (after.radius + after.radius_wear) - (before.radius + before.radius_wear);
    assert!(change.abs() > 0.05, "{after:?}");
}

#[test]
fn measuring_programs_hold_no_unknown_word() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/cases");
    let names =
        ["drill_measure", "web_measure", "zo_rectangle", "zo_determining", "one_point_measure", "hole_protection"];
    for name in names {
        let program = std::fs::read(folder.join(name).join("program.mpf")).unwrap();
        let mut setup = machine();
        for tool in [1, 7] {
            let like = setup.control.tools[&if tool == 1 { 20 } else { 9 }].clone();
            setup.control.tools.insert(tool, like);
        }
        let outcome = run(&read(Dialect::Sinumerik, &program), &setup, Limits::default());
        // oracle: hand: nothing to touch, so the first measurement finds no surface (B:13999)
        assert_eq!(outcome.stop, Some(Stop::Alarm(Code::Alarm(61301))), "{name}: {:?}", outcome.diagnostics);
        let unknown = outcome.diagnostics.iter().find(|found| found.message.key == "run-unknown-word");
        assert_eq!(unknown, None, "{name}");
    }
}
