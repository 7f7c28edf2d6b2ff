//! Settable and programmed frames, scale factors.

use super::{clean, go, near};
use probewright_core::diagnostic::Code;
use probewright_core::machine::Stop;

#[test]
fn frames_are_used_and_left_out() {
    let frame = "$P_UIFR[1]=CTRANS(X,100,Y,50):CFINE(X,0.5):CROT(Z,90)\n";
    let outcome = clean(&format!("{frame}G54\nG0 X10 Y0 Z0"));
    // oracle: hand: turned by 90 degrees, X10 points along Y of the machine
    near(outcome.position.0, [100.5, 60.0, 0.0]);
    assert_eq!(outcome.control.frames[&1].fine, [0.5, 0.0, 0.0]);
    near((clean(&format!("{frame}G54\nG0 G53 X10 Y0 Z0")).position).0, [10.0, 0.0, 0.0]);
    near((clean(&format!("{frame}G54\nG500\nG0 SUPA X1 Y2 Z3")).position).0, [1.0, 2.0, 3.0]);
    // a frame acts only when it is activated again (B:1965)
    near((clean("G54\n$P_UIFR[1,X,TR]=7\nG0 X0 Y0 Z0").position).0, [0.0, 0.0, 0.0]);
    near((clean("$P_UIFR[99,X,FI]=7\nG599\nG0 X0 Y0 Z0").position).0, [7.0, 0.0, 0.0]);
}

#[test]
fn programmed_frames_replace_and_add() {
    // oracle: hand
    near((clean("TRANS X10 Y5\nATRANS X1\nG0 X0 Y0 Z0").position).0, [11.0, 5.0, 0.0]);
    near((clean("TRANS X10\nAROT Z90\nG0 X2 Y0 Z0").position).0, [10.0, 2.0, 0.0]);
    near((clean("TRANS X10\nROT RPL=90\nG0 X2 Y0 Z0").position).0, [0.0, 2.0, 0.0]);
    near((clean("TRANS X10\nTRANS\nG0 X2 Y0 Z0").position).0, [2.0, 0.0, 0.0]);
}

#[test]
fn scales_are_motion_and_stop_a_measurement() {
    // oracle: hand
    near((clean("TRANS X10\nASCALE X2\nG0 X3 Y4 Z5").position).0, [16.0, 4.0, 5.0]);
    near((clean("SCALE X2 Y2 Z2\nAROT Z90\nG0 X3 Y0 Z0").position).0, [0.0, 6.0, 0.0]);
    near((clean("$P_UIFR[1]=CTRANS(X,5):CSCALE(Y,3)\nG54\nG0 X1 Y2 Z0").position).0, [6.0, 6.0, 0.0]);
    near((clean("G70\nSCALE X2\nG0 X1 Y0 Z0").position).0, [50.8, 0.0, 0.0]);
    near((clean("SCALE X2\nSCALE\nG0 X3 Y0 Z0").position).0, [3.0, 0.0, 0.0]);
    for sheared in ["SCALE X2\nAROT Z30", "$P_UIFR[1]=CSCALE(X,2):CROT(Z,30)"] {
        let outcome = go(sheared);
        assert!(matches!(outcome.stop, Some(Stop::Fault(message)) if message.key == "run-shear"));
    }
    // oracle: manual B:744, A:15849: in whichever frame of the chain; without one there is only nothing to touch
    for (scale, alarm) in [
        ("SCALE X2", 61310),
        ("$P_UIFR[1,Z,SC]=2\nG54", 61310),
        ("$P_CHBFR[0,X,SC]=0.5\nG500", 61310),
        ("SCALE X2\nTRANS", 61301),
    ] {
        let outcome = go(&format!("{scale}\n_MVAR=1 _SETVAL=60 _KNUM=2001 _TNUM=20\nCYCLE977"));
        assert_eq!(outcome.stop, Some(Stop::Alarm(Code::Alarm(alarm))), "{scale}");
    }
}
