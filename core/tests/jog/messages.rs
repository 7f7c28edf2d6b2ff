//! Each message that refuses an input, raised by a line of a script.

use super::block;
use probewright_core::app::{JogWrong, jog};
use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::jog::{Input, Session};
use probewright_core::machine::Setup;
use probewright_core::words::Words;

/// Why the last line of a script does nothing on the block.
fn refused(script: &str) -> String {
    match jog(script, &block(), None) {
        Ok(view) => {
            let last = view.lines.last().unwrap();
            assert_eq!(view.lines.len(), script.lines().count(), "{script}");
            last.refused.clone().unwrap_or_else(|| panic!("{script}")).key.into_owned()
        }
        Err(JogWrong::Line(wrong)) => {
            assert_eq!(wrong.hint.key, format!("{}-hint", wrong.message.key), "{script}");
            wrong.message.key.into_owned()
        }
        Err(JogWrong::Machine(message)) => message.key.into_owned(),
    }
}

/// Both points of an edge along Y, stored.
const READY: &str = "mask align_edge\naxis = X\nref_axis = Y\nmove machine X-20 Y20 Z-5\nstart\njog Y40\nstart\n";
/// The corner up to SW 6.2, its first point touched.
const CORNER: &str = "set PW-JOG = 1\nmask old_corner\nmove machine X20 Y-20 Z-5\nstart\n";

/// All four stored.
const STORED: &str = "set PW-JOG = 1\nmask old_corner\nmove machine X20 Y-20 Z-5\nstart\nstore P1\njog X40\nstart\n\
                      store P2\n\
                      jog X-80\njog Y40\nstart\nstore P3\njog Y30\nstart\nstore P4\n";

// oracle: manual B:3034-3088, B:3684-3688, B:3722-3736 (what counts when), A:3188-3200 (up to SW 6.2); hand for the
// rest
#[test]
fn what_does_nothing_is_told() {
    for (script, key) in [
        ("start", "jog-no-mask"),
        ("activate", "jog-nothing-to-activate"),
        ("mask nothing", "jog-no-function"),
        ("mask set_edge\nmode", "jog-mode"),
        ("mask set_edge\ncalculate", "jog-at-once"),
        ("mask align_edge\ncalculate", "jog-missing"),
        ("mask align_edge\nreject P1", "jog-grey"),
        ("mask align_edge\nstore P1", "jog-stores-itself"),
        ("mask set_edge\ny0 = 3", "jog-no-field"),
        ("mask set_edge\nx0 = much", "jog-wrong-number"),
        ("mask set_edge\nx0 = 1e9", "jog-wrong-far"),
        ("mask set_edge\naxis = Q", "jog-wrong-word"),
        ("mask cal_radius\nd = 0", "jog-wrong-above"),
        ("mask hole_1\ndiameter = -1", "jog-wrong-below"),
        ("mask spigot_1\nstart", "jog-wrong-above"),
        ("tool T77", "jog-no-tool"),
        ("set _NOTHING[3] = 1", "jog-no-datum"),
        ("set PW-JOG = 1\nmask hole_1", "jog-no-function"),
        ("mask old_hole", "jog-no-function"),
    ] {
        assert_eq!(refused(script), key, "{script}");
    }
    for (before, line, key) in [
        (READY, "start", "jog-all-stored"),
        (READY, "reset", "jog-refused"),
        (CORNER, "calculate", "jog-missing"),
        (CORNER, "store P2", "jog-older-order"),
        (CORNER, "reject P1", "jog-older-reject"),
        (STORED, "start", "jog-older-stored"),
    ] {
        assert_eq!(refused(&format!("{before}{line}")), key, "{line}");
    }
}

// oracle: hand: the grammar of a script, each fault with what helps
#[test]
fn what_cannot_be_read_is_told() {
    let long = "start\n".repeat(100_001);
    for (script, key) in [
        ("go", "jog-script-command"),
        ("start now", "jog-script-alone"),
        ("move Q1", "jog-script-move"),
        ("reject P9", "jog-script-point"),
        ("plc P1 maybe", "jog-script-plc"),
        ("tool 9", "jog-script-tool"),
        ("set A", "jog-script-set"),
        (&long, "jog-script-long"),
    ] {
        assert_eq!(refused(script), key, "{}", &script[..script.len().min(20)]);
    }
}

// oracle: manual B:3736, A:15830
#[test]
fn keys_that_a_script_does_not_press_are_told() {
    let mut session = Session::new(&block());
    super::open(&mut session, "set_edge", &[]);
    assert_eq!(session.press(Input::Function("hole_1")).unwrap_err().key, "jog-open");
    super::stand(&mut session, [-500.0, 20.0, -5.0]);
    session.carry_out(Input::Start).unwrap();
    assert_eq!(session.press(Input::Start).unwrap_err().key, "jog-pending");
    let nct = Setup::calibrated(Dialect::Nct, Plane::G17);
    assert!(matches!(jog("start", &nct, None), Err(JogWrong::Machine(message)) if message.key == "jog-no-jog"));
}

// oracle: self: what a field takes is what the refusal and the list of masks name
#[test]
fn zero_offsets_that_are_not_offered_are_named() {
    let view = jog("mask set_edge\nzo = G505\nzo = G600\n", &block(), None).unwrap();
    assert_eq!(view.lines[1].refused, None);
    let refused = view.lines[2].refused.as_ref().unwrap();
    let told = Words::english().text(refused);
    assert!(told.contains("G57") && told.contains("G505…G599"), "{told}");
}
