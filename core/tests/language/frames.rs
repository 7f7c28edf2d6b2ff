//! Programmed frames, frame variables, the swivel cycle.

use super::{at, clean, fault, go, near, number, setup};
use probewright_core::diagnostic::Severity;
use probewright_core::dialect::Dialect;
use probewright_core::geometry::rigid::rotation;
use probewright_core::geometry::{Degrees, Mcs, Rpy};
use probewright_core::machine::Setup;
use probewright_core::machine::trace::Step;
use probewright_core::run::{Limits, run};
use probewright_core::syntax::read;
use probewright_core::workpiece::{PartErrors, Shape, Solid};

// oracle: hand
#[test]
fn mirrors_reverse_their_axes() {
    at("MIRROR X0\nG0 X10 Y5", [-10.0, 5.0, 0.0]);
    at("TRANS X100\nAMIRROR X0 Y0\nG0 X10 Y5", [90.0, -5.0, 0.0]);
    at("MIRROR X0\nATRANS X3\nG0 X10", [-13.0, 0.0, 0.0]);
    at("MIRROR X0\nMIRROR\nG0 X10", [10.0, 0.0, 0.0]);
    at("MIRROR X0\nAROT Z90\nG0 X10 Y0", [0.0, 10.0, 0.0]);
    at("$P_UIFR[1]=CTRANS(X,5):CMIRROR(X)\nG54\nG0 X1", [4.0, 0.0, 0.0]);
    at("$P_UIFR[1,Y,MI]=1\nG54\nG0 Y1", [0.0, -1.0, 0.0]);
}

// oracle: hand
#[test]
fn frames_are_variables_with_components() {
    for (text, expected) in [
        ("$P_CHBFR[0]=CTRANS(X,7)\nR1=$P_UBFR[X,TR]", 7.0),
        ("$P_SETFR=CTRANS(Y,7)\nG500\nR1=$P_SETFRAME[Y,TR]", 7.0),
        ("TRANS X7\nR1=$P_PFRAME[X,TR]", 7.0),
        ("$P_PFRAME=CTRANS(X,3):CROT(Z,90)\nR1=$P_PFRAME[Z,RT]", 90.0),
        ("$P_UIFR[1]=CTRANS(X,5)\nG54\nTRANS X2\nR1=$P_ACTFRAME[X,TR]", 7.0),
        ("$P_UIFR[1]=CTRANS(X,5)\n$P_UIFR[2]=$P_UIFR[1]:CTRANS(X,1)\nR1=$P_UIFR[2,X,TR]", 6.0),
        ("DEF FRAME F\nF=CROT(Z,90)\nG0 X1 Y0\nR1=$AA_IM[X]", 1.0),
        ("$P_UIFR[1]=CTRANS(X,1,Y,2):CFINE(X,0.5)\nR1=$P_UIFR[1,X,FI]+$P_UIFR[1,Y,TR]", 2.5),
        ("$P_UIFR[1]=CTRANS(C,30)\nG54\nG0 C10\nR1=$AA_IM[C]", 40.0),
    ] {
        near(number(text, "R1"), expected, text);
    }
    assert_eq!(fault("$P_ACTFRAME=CTRANS(X,1)"), "run-read-only");
    for (text, key) in
        [("SCALE X0", "run-range"), ("$P_UIFR[1,X,SC]=0", "run-range"), ("$P_UIFR[1]=CSCALE(X,0)", "run-function")]
    {
        assert_eq!(fault(text), key, "{text}");
    }
    assert_eq!(fault("R1=$P_UIFR[1,X,QQ]"), "run-unknown-variable");
    assert_eq!(fault("TRANS X1 ROT Z10"), "run-alone");
}

// oracle: hand: G53 without settable and programmed frame, SUPA and G153 without any
#[test]
fn frames_are_left_out_for_a_block() {
    let frames = "$P_CHBFR[0]=CTRANS(X,1)\n$P_UIFR[1]=CTRANS(X,10)\n$P_UIFR[99]=CTRANS(X,20)\nG54\nTRANS X100\n";
    for (words, x) in [
        ("G0 X0", 111.0),
        ("G0 G53 X0", 1.0),
        ("G0 G153 X0", 0.0),
        ("G0 SUPA X0", 0.0),
        ("G599\nTRANS\nG0 X0", 21.0),
        ("G500\nG0 X0", 101.0),
        ("G0 G53 X5\nG91 X1", 7.0),
    ] {
        at(&format!("{frames}{words}"), [x, 0.0, 0.0]);
    }
}

// oracle: hand: the oblique face (turned by 30 degrees about X, as G57 says) lies level afterwards, and coordinates of
// the part stay coordinates of the part
#[test]
fn the_swivel_cycle_turns_the_part_level() {
    let mut setup = setup();
    setup.control.rotary_centre = Mcs([0.0, 0.0, -100.0]);
    setup.workpiece.solids.push(Solid {
        shape: Shape::Block { size: [40.0; 3] },
        at: Mcs([0.0, 5.0, 3.0]),
        rotation: Rpy([30.0, 0.0, 0.0]),
        errors: PartErrors::default(),
    });
    setup.position = Mcs([0.0, 0.0, 300.0]);
    let text = "$P_UIFR[4]=CTRANS(Y,5,Z,3):CROT(X,30)\nG57\nG0 X0 Y0 Z100\n\
        CYCLE800(1,\"\",0,57,0,0,0,0,0,0,0,0,0,-1)\nR1=$P_ACTFRAME[X,RT]\nG0 X5 Y6 Z50\nMEAS=1 G1 Z-5 F300\n\
        R2=$AA_MW[Z]\nR3=$AC_MEA[1]\n\
        G0 Z50\nCYCLE800(1,\"\",0,57,0,0,0,0,0,0,0,0,0,-1)\nG500\nCYCLE800(1,\"\",0,57)\n";
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let outcome = run(&program, &setup, Limits::default());
    assert_eq!((&outcome.stop, &outcome.diagnostics[..]), (&None, &[][..]));
    let found = ["R1", "R2", "R3"].map(|name| outcome.control.number(name));
    for (found, expected) in found.into_iter().zip([0.0, 3.0, 1.0]) {
        near(found, expected, "swivel");
    }
    let tables = outcome.trace.entries.iter();
    let turned: Vec<_> = tables
        .filter_map(|entry| match &entry.step {
            Step::Table { axis, to, solids, .. } => Some((*axis, to.0, solids[0].rotation[0])),
            _ => None,
        })
        .collect();
    assert_eq!(turned.len(), 2, "there and back: {turned:?}");
    near(turned[0].1, 30.0, "table");
    near(turned[0].2, 0.0, "the face lies level");
    near(turned[1].2, 30.0, "and back");
}

// oracle: manual (SD 42440 and SD 42442 are 1 by default: an incremental motion goes along with a new frame or tool)
#[test]
fn increments_count_from_the_programmed_position() {
    at("G0 X1\nTRANS X100\nX=IC(1)", [102.0, 0.0, 0.0]);
    at("TRANS X100\nG0 X=IC(1)", [101.0, 0.0, 0.0]);
    at("G0 X1 Y2\nTRANS X100 Y7\nG91 X1", [102.0, 2.0, 0.0]);
    at("G0 X1\nG0 SUPA X5\nG91 X1", [6.0, 0.0, 0.0]);
    near(number("G0 X1\nTRANS X100\nR1=$AA_IW[X]", "R1"), -99.0, "the axis has not moved");
    near(number("G0 Z10\nT20 M6\nG91 G0 Z5\nR1=$AA_IW[Z]", "R1"), 15.0, "another tool");
}

// oracle: hand
#[test]
fn units_reach_frames_and_feeds_as_they_should() {
    at("G70\nTRANS X1\nG0 X1 Y0", [50.8, 0.0, 0.0]);
    at("G700\n$P_UIFR[1,X,TR]=1\nG54\nG0 X0", [25.4, 0.0, 0.0]);
    at("G70\nROT Z90\nG0 X1 Y0", [0.0, 25.4, 0.0]);
    assert!(clean("G710 G0 X1").position[0] == 1.0);
}

// oracle: hand: the table stands where it stood, the coordinates are those of the machine again
#[test]
fn the_swivel_cycle_gives_the_plane_up() {
    for up in ["CYCLE800()", "CYCLE800", "CYCLE800(1,\"0\",0,57)"] {
        let text = format!(
            "$P_UIFR[1]=CTRANS(X,5):CROT(Z,90)\nG54\nCYCLE800(1,\"\",0,57)\nR1=$P_PARTFRAME[Z,RT]\nG500\n{up}\n\
                G0 X7 Y3\nR2=$P_PARTFRAME[Z,RT]"
        );
        let outcome = clean(&text);
        assert_eq!(outcome.position, [7.0, 3.0, 0.0], "{up}");
        assert_eq!(outcome.control.rotary, [0.0, 0.0, 90.0].map(Degrees), "{up}");
        near(outcome.control.number("R1"), -90.0, up);
        near(outcome.control.number("R2"), 0.0, up);
    }
}

// oracle: manual (function manual K2: CRPL 0 turns in the working plane, 1 to 3 about Z, Y, X; INVFRAME takes a frame
// back)
#[test]
fn frames_are_made_by_functions() {
    at("$P_PFRAME=CRPL(0,90)\nG0 X10 Y0", [0.0, 10.0, 0.0]);
    at("$P_PFRAME=crpl(1,90)\nG0 X10 Y0", [0.0, 10.0, 0.0]);
    at("G19\n$P_PFRAME=CRPL(0,90)\nR1=$P_PFRAME[X,RT]\n$P_PFRAME=CTRANS()\nG17\nG0 X0 Y0 Z=R1", [0.0, 0.0, 90.0]);
    for (plane, axis) in [(1, "Z"), (2, "Y"), (3, "X")] {
        let text = format!("$P_UIFR[1]=CTRANS(X,1):CRPL({plane},30)\nR1=$P_UIFR[1,{axis},RT]");
        near(number(&text, "R1"), 30.0, &text);
    }
    let back = "DEF FRAME F=CTRANS(X,5,Y,7):CROT(Z,30,X,20):CMIRROR(Y)\n$P_UIFR[1]=F:INVFRAME(F)\nG54\nG0 X1 Y2 Z3";
    at(back, [1.0, 2.0, 3.0]);
    for wrong in ["R1=CRPL(4,30)", "R1=INVFRAME(5)", "$P_PFRAME=INVFRAME(CSCALE(X,2):CROT(Z,90))"] {
        assert!(go(wrong).stop.is_some(), "{wrong}");
    }
    near(
        number(
            "$P_CHBFR[0]=CTRANS(X,5)\n$P_UIFR[1]=CTRANS(X,1)\nG54\nR1=10*$P_ACTBFRAME[X,TR]+$P_ACTFRAME[X,TR]",
            "R1",
        ),
        56.0,
        "basic frames and all",
    );
}

/// A block that is clamped askew, its front left upper corner in the machine's zero; G56 stands there, parallel to the
/// axes.
fn askew() -> Setup {
    let turn = rotation(Rpy([4.0, -3.0, 5.0]));
    let corner: [f64; 3] = (turn * nalgebra::Vector3::new(50.0, 40.0, 0.0)).into();
    let mut setup = setup();
    setup.workpiece.solids.push(Solid {
        shape: Shape::Block { size: [100.0, 80.0, 50.0] },
        at: Mcs(corner),
        rotation: Rpy([4.0, -3.0, 5.0]),
        errors: PartErrors::default(),
    });
    setup.control.rotary_centre = Mcs([30.0, 30.0, -80.0]);
    setup.position = Mcs([0.0, 0.0, 60.0]);
    setup
}

// oracle: manual B:7696-7786 (the way of its example, in our words): afterwards the corner is the zero of G57 and the
// edges are its axes
#[test]
fn an_oblique_part_is_set_up_with_the_swivel_cycle() {
    let text = "G56 G17 G90 G1 F500\nCYCLE800(1,\"\",0,57,0,0,0,0,0,0,0,0,0,-1)\n$P_UIFR[4]=$P_UIFR[3]\nX20 Y25\nZ40\n\
        _PRNUM=1 _VMS=0 _NMSP=1 _TSA=20 _EVNUM=0\n\
        _FA=40 _STA1=0 _INCA=0 _MVAR=100106 _MD=1 _ID=50 _SETV[0]=35 _SETVAL=0 _KNUM=4\nCYCLE998\nG57\n\
        CYCLE800(1,\"\",0,57,0,0,0,0,0,0,0,0,0,-1)\nX20 Y25\nZ20\n_MVAR=100 _SETVAL=0 _MA=3 _TSA=10 _FA=20\nCYCLE978\n\
        G57\n\
        Z20\nX25 Y-20\nZ-10\n_MVAR=105 _MA=102 _SETVAL=0 _RA=0 _STA1=0\nCYCLE998\nG57\n\
        X25 Y-20\nZ-10\n_MVAR=100 _MA=2 _FA=10\nCYCLE978\nG57\nX-20 Y-20\nY25\n_MA=1\nCYCLE978\nG57\nZ20";
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let outcome = run(&program, &askew(), Limits::default());
    let errors: Vec<_> = outcome.diagnostics.iter().filter(|found| found.severity == Severity::Error).collect();
    assert_eq!((&outcome.stop, errors), (&None, Vec::new()));
    let frame = outcome.control.frames[&4];
    let (found, wanted) = (rotation(frame.rotation), rotation(Rpy([4.0, -3.0, 5.0])));
    assert!((found.matrix() - wanted.matrix()).norm() < 1e-9, "{:?}", frame.rotation);
    for (axis, at) in frame.origin().into_iter().enumerate() {
        near(at, 0.0, ["X", "Y", "Z"][axis]);
    }
}
