//! Addresses of G65 P9920 (C:1216-1243), in the order of the block formats.

use super::{AT_CALIBRATION, AT_MEASUREMENT, CALIBRATE, DIAMETER, LENGTH};
use crate::catalogue::nct;
use crate::catalogue::prelude::*;

/// The tool sinks beside the disk.
const BESIDE: When = When::Variant(&[CALIBRATE, DIAMETER]);

/// T says what is done: 0 calibrates, a register is measured into (C:1219, C:1239).
const BY_REGISTER: &[Chooses] = &[
    Chooses { when: When::All(&[When::Given(address::T), When::Given(address::K)]), variant: DIAMETER, typed: "1" },
    Chooses { when: When::Given(address::T), variant: LENGTH, typed: "1" },
    Chooses { when: When::Always, variant: CALIBRATE, typed: "0" },
];

/// How the tool turns (C:1240, C:1251).
const TURNS: &[(i64, &str)] = &[
    (5, "p9920-m-still"),
    (3, "p9920-m-right"),
    (4, "p9920-m-left"),
    (13, "p9920-m-right-diameter"),
    (14, "p9920-m-left-diameter"),
];

/// All of them.
pub const PARAMS: &[Param] = &[
    Param {
        unit: Unit::ActiveLength,
        range: Range { max: 0.0, ..Range::ANY },
        needs: ALWAYS_REQUIRED,
        example: "-8",
        ..param(address::Z, "p9920-z", "C:1216;C:1236")
    },
    Param {
        unit: Unit::ActiveLength,
        range: Range::POSITIVE,
        usual: Range::closed(2.0, 30.0), // "about 2 mm" at least, C:1252
        needs: &[optional(AT_MEASUREMENT, "need-p9920-k")],
        chooses: &[Chooses { when: When::Given(address::T), variant: DIAMETER, typed: "5" }],
        ..param(address::K, "p9920-k", "C:1237;C:1252")
    },
    Param {
        unit: Unit::ActiveLength,
        range: Range::NOT_NEGATIVE,
        needs: &[required(AT_CALIBRATION, "need-p9920-reference"), optional(When::Always, "need-p9920-d")],
        labels: &[(AT_CALIBRATION, "p9920-d-reference")],
        example: "12",
        ..param(address::D, "p9920-d", "C:1217;C:1238;C:1256")
    },
    Param {
        unit: Unit::ActiveLength,
        default: Some(0.0),
        range: Range::NOT_NEGATIVE,
        needs: &[optional(AT_CALIBRATION, "need-nct-optional")],
        ..param(address::H, "p9920-h", "C:1218")
    },
    Param {
        kind: Kind::Integer,
        range: Range::closed(0.0, 99.0),
        needs: ALWAYS_REQUIRED,
        chooses: BY_REGISTER,
        example: "1",
        ..param(address::T, "p9920-t", "C:1219;C:1239")
    },
    Param {
        kind: Kind::Choice(TURNS),
        needs: &[optional(AT_MEASUREMENT, "need-nct-optional")],
        ..param(address::M, "p9920-m", "C:1240;C:1251")
    },
    Param {
        unit: Unit::ActiveLength,
        default: Some(2.0),
        range: Range::NOT_NEGATIVE,
        needs: &[optional(BESIDE, "need-nct-optional")],
        ..param(address::E, "p9920-e", "C:1220;C:1241;C:1256")
    },
    Param {
        name: address::F,
        key: "p9920-f",
        unit: Unit::BasicFeed,
        range: Range::POSITIVE,
        source: "C:1221;C:1242",
        ..nct::LENGTH
    },
    Param { name: address::S, key: "p9920-s", range: Range::POSITIVE, source: "C:1222;C:1243", ..nct::NUMBER },
];
