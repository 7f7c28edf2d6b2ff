//! Errors and warnings of CYCLE979.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod motion;
mod simulation;

use super::CYCLE979;
use crate::catalogue::example::changed;
use crate::check::check;
use crate::control::{Control, delivery};
use crate::diagnostic::{Code, Severity};

/// Everything found in the worked example with some values changed, on a control that was changed.
fn found(changes: &[(&str, &str)], prepare: impl Fn(&mut Control)) -> Vec<(Severity, Code, &'static str)> {
    let mut control = delivery(CYCLE979.dialect);
    control.set("_CHBIT[4]", 1.0); // as in the example, B:7085
    prepare(&mut control);
    let values = changed(&CYCLE979, changes);
    let found = check(&CYCLE979, &values, &control).diagnostics;
    found.into_iter().map(|one| (one.severity, one.code, one.param.unwrap().as_str())).collect()
}

#[test]
fn mistakes_are_told() {
    // oracle: manual B:6744-6752, B:6850, B:6984-6994, A:15857, A:15909 for the alarms, hand for the rest
    let (error, warning) = (Severity::Error, Severity::Warning);
    let (alarm, own) = (Code::Alarm, Code::Own);
    for (changes, wanted) in [
        (&[][..], None),
        (&[("_PRNUM", "1001")], None),
        (&[("_PRNUM", "1101"), ("_CORA", "0")], None),
        (&[("_PRNUM", "201")], Some((error, alarm(61313), "_PRNUM"))),
        (&[("_PRNUM", "1004")], Some((error, alarm(61313), "_PRNUM"))),
        (&[("_PRNUM", "2001")], Some((error, alarm(61313), "_PRNUM"))),
        (&[("_INCA", "")], Some((error, own(1), "_INCA"))),
        (&[("_INCA", "0")], Some((error, alarm(61316), "_INCA"))),
        (&[("_INCA", "180")], Some((error, alarm(61316), "_INCA"))),
        (&[("_INCA", "-173")], Some((error, own(52), "_INCA"))),
        (&[("_INCA", "-121")], Some((warning, own(53), "_INCA"))),
        (&[("_INCA", "-120")], None),
        (&[("_INCA", "91"), ("_PRNUM", "1001")], Some((warning, own(53), "_INCA"))),
        (&[("_STA1", "-91"), ("_INCA", "90"), ("_PRNUM", "1001")], Some((error, own(52), "_INCA"))),
        (&[("_STA1", "361")], Some((error, own(5), "_STA1"))),
        (&[("_RF", "")], Some((error, own(1), "_RF"))),
        (&[("_RF", "0")], Some((error, alarm(61365), "_RF"))),
        (&[("_SETVAL", "5")], Some((error, own(30), "_SETVAL"))),
        (&[("_FA", "70")], Some((warning, own(54), "_FA"))),
        (&[("_SETVAL", "90"), ("_FA", "84")], Some((error, alarm(61302), "_FA"))),
        (&[("_MVAR", "2"), ("_FA", "70")], None),
        (&[("_MVAR", "3"), ("_FA", "70")], None),
        (&[("_MVAR", "3"), ("_PRNUM", "1001")], Some((warning, own(50), "_PRNUM"))),
        (&[("_MVAR", "4")], Some((error, own(1), "_ID"))),
        (&[("_MVAR", "4"), ("_ID", "20")], None),
        (&[("_MVAR", "4"), ("_ID", "-20")], Some((warning, own(55), "_ID"))),
        (&[("_MVAR", "4"), ("_ID", "3")], Some((warning, own(56), "_ID"))),
        (&[("_MVAR", "101"), ("_KNUM", "3001")], Some((error, alarm(61321), "_KNUM"))),
        (&[("_MVAR", "103"), ("_KNUM", "2")], None),
    ] {
        let found = found(changes, |_| ());
        assert_eq!(found, Vec::from_iter(wanted), "{changes:?}");
    }
}

#[test]
fn the_ball_diameter_has_to_be_known() {
    // oracle: manual B:6873
    let doubt = (Severity::Warning, Code::Own(51), "_PRNUM");
    let unknown = |control: &mut Control| control.set("_WP[0,0]", 0.0);
    assert_eq!(found(&[], unknown), [doubt]);
}

#[test]
fn a_length_to_the_circumference_needs_no_ball_radius() {
    // oracle: manual B:6929
    let web = [("_MVAR", "4"), ("_ID", "3")];
    let outer = |control: &mut Control| control.set("_CBIT[14]", 1.0);
    assert_eq!(found(&web, outer), []);
}
