//! JOG and the measuring cycle level an oblique plane by one rule.

use super::{near, open, stand};
use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::geometry::{Mcs, Rpy};
use probewright_core::jog::{Input, Session};
use probewright_core::machine::Setup;
use probewright_core::run::{Limits, run};
use probewright_core::syntax::read;
use probewright_core::workpiece::{Shape, Solid};

/// A plane as it leans in example 2 (B:3882), G54 active, turned about the applicate by so much.
fn setup(heading: f64) -> Setup {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    let mut part = Solid::new(Shape::Block { size: [300.0, 300.0, 40.0] }, Mcs([0.0; 3]));
    part.rotation = Rpy([-6.1069, -14.303, 0.0]);
    setup.workpiece.solids.push(part);
    setup.probe.stylus = Some(0.0);
    setup.control.set("_JM_I[4]", 1.0);
    setup.control.frames.entry(1).or_default().rotation[2] = heading;
    setup.control.activate(1);
    setup
}

/// What JOG makes of G54.
fn by_jog(heading: f64) -> Rpy {
    let mut session = Session::new(&setup(heading));
    open(&mut session, "align_plane", &[]);
    for [x, y] in [[0.0, 0.0], [50.0, 5.0], [-10.0, 35.0]] {
        stand(&mut session, [x, y, 40.0]);
        session.carry_out(Input::Start).unwrap();
    }
    session.press(Input::Calculate).unwrap();
    session.sim.control.frames[&1].rotation
}

/// What the cycle makes of it, from three points of the same face.
fn by_cycle(heading: f64) -> Rpy {
    let text = b"G54 G17 G90 T9 D1\nM6\nG0 X0 Y0\nZ40\n\
        _FA=60 _TSA=30 _STA1=0 _INCA=0 _MVAR=100106 _MD=1 _ID=50 _SETV[0]=35 _KNUM=1 _PRNUM=1\nCYCLE998\nM30\n";
    let outcome = run(&read(Dialect::Sinumerik, text), &setup(heading), Limits::default());
    assert_eq!(outcome.alarms(), []);
    outcome.control.frames[&1].rotation
}

// oracle: manual B:3882 (0 about the infeed axis), and each of the two against the other
#[test]
fn both_turn_about_abscissa_and_ordinate_alone() {
    for heading in [0.0, 12.0, -25.0] {
        let (jog, cycle) = (by_jog(heading), by_cycle(heading));
        (0..3).for_each(|axis| near(jog[axis], cycle[axis], "one rule"));
        near(jog[2], heading, "the rotation about the applicate stays");
        if heading == 0.0 {
            (0..2).for_each(|axis| near(jog[axis], [-6.1069, -14.303][axis], "as printed"));
        }
    }
}
