//! Names, written and read.

use crate::control::delivery;
use crate::dialect::Dialect;

#[test]
fn every_name_reads_what_was_written() {
    let mut control = delivery(Dialect::Sinumerik);
    let names = [
        "$P_UIFR[1,X,TR]", "$P_UIFR[99,Z,FI]", "$P_CHBFR[0,Y,RT]", "$P_NCBFR[15,X,TR]", "$P_SETFR[Z,TR]",
        "$P_UIFR[99,C,TR]", "$P_SETFR[C,FI]", "$TC_DP21[20,1]", "$TC_DP1[20,1]", "$TC_DP2[20,1]", "$TC_DP3[20,1]",
        "$TC_DP6[20,1]", "$TC_DP12[20,1]", "$TC_DP15[20,1]", "$TC_SCP13[20,1]", "$TC_ECP66[20,1]",
    ];
    // oracle: self (write, then read; each value its own)
    for (i, name) in names.iter().enumerate() {
        assert!(control.set_variable(name, i as f64 + 1.0), "{name}");
    }
    for (i, name) in names.iter().enumerate() {
        assert_eq!(control.variable(name), Some(i as f64 + 1.0), "{name}");
        assert!(control.variables().any(|(known, _)| known == *name), "{name}");
    }
    // oracle: hand
    assert_eq!(control.frames[&1].coarse[0], 1.0);
    assert_eq!(control.tools[&20].edges[&1].radius_wear, 14.0);
}

#[test]
fn other_names_are_refused() {
    let mut control = delivery(Dialect::Sinumerik);
    for name in [
        "$P_UIFR[100,X,TR]", "$P_UIFR[1,W,TR]", "$P_UIFR[1,C,RT]", "$P_UIFR[1,X,MM]", "$TC_DP99[1,1]",
        "$TC_SCP73[1,1]", "_OVR[0]", "$P_UIFR[1,X",
    ] {
        assert!(!control.set_variable(name, 1.0), "{name}");
        assert_eq!(control.variable(name), None, "{name}");
    }
}

#[test]
fn nct_has_plain_names() {
    let mut control = delivery(Dialect::Nct);
    assert!(
        control.set_variable("G59 X", 120.0) && control.set_variable("D1", 5.0) && control.set_variable("H98", 50.0)
    );
    assert_eq!(control.frames[&6].coarse[0], 120.0);
    assert_eq!(control.register(98).length[0], 50.0);
    assert_eq!(control.register(1).radius, 5.0);
    assert!(!control.set_variable("G60 X", 0.0));
}
