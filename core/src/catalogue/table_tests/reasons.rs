//! The reason of a need against the parameter that it stands at.

use super::*;

/// Reasons that tell what one parameter does, with that parameter.
// oracle: hand (read off the sentences)
const OF_ONE: &[(&str, &str)] = &[
    ("need-memory", "_EVNUM"),
    ("need-memory-empirical", "_EVNUM"),
    ("need-tool-name", "_TNAME"),
    ("need-additive", "_DLNUM"),
    ("need-environment", "_TENV"),
    ("need-mono", "_CORA"),
    ("need-points", "_INCA"),
    ("need-circular", "_RF"),
    ("need-distortion", "_TNVL"),
    ("need-rotary", "_RA"),
    ("need-signed-path", "_FA"),
];
/// Reasons that say that a default applies.
const DEFAULT: &[&str] = &["need-default", "need-tolerance", "need-distortion"];

fn needs() -> impl Iterator<Item = (&'static Param, &'static str)> {
    let params = CYCLES.iter().flat_map(|cycle| cycle.params);
    params.flat_map(|param| param.needs.iter().map(move |need| (param, need.reason)))
}

// oracle: hand (read off the sentences)
#[test]
fn a_reason_fits_its_parameter() {
    for (param, reason) in needs() {
        let owner = OF_ONE.iter().find(|(of_one, _)| *of_one == reason);
        assert!(owner.is_none_or(|(_, name)| param.name == *name), "{}: {reason}", param.name);
        assert!(!DEFAULT.contains(&reason) || param.default.is_some(), "{}: {reason}", param.name);
    }
}

// oracle: self
#[test]
fn every_reason_of_one_parameter_is_used() {
    let unused = OF_ONE.iter().find(|(of_one, _)| !needs().any(|(_, reason)| reason == *of_one));
    assert_eq!(unused, None);
}
