//! Measuring variants of CYCLE976 (B:5060-5084; the surface stands in A:5796-5799 and B:15595).

use super::params::{ANGLE, LENGTH, ONE, SURFACE, TWO, UNKNOWN};
use crate::entry::{Variant, When, names};
use crate::name::Name;

/// Where holes with a known centre stand.
const KNOWN: &str = "B:5066-5084;B:5124-5162;A:5773-5792";
/// Where holes with an unknown centre stand.
const CENTRE: &str = "B:5222-5256;A:5977-5998";

/// Holes with a known centre, holes with an unknown one, surfaces; in each the digits count up.
pub const VARIANTS: &[Variant] = &[
    Variant { number: 1, key: "cycle976-known-four", source: KNOWN },
    Variant { number: 101, key: "cycle976-known-four-ball", source: KNOWN },
    Variant { number: 1001, key: "cycle976-known-one", source: KNOWN },
    Variant { number: 2001, key: "cycle976-known-two", source: KNOWN },
    Variant { number: 2101, key: "cycle976-known-two-ball", source: KNOWN },
    Variant { number: 10_001, key: "cycle976-known-four-skew", source: KNOWN },
    Variant { number: 10_101, key: "cycle976-known-four-skew-ball", source: KNOWN },
    Variant { number: 12_001, key: "cycle976-known-two-skew", source: KNOWN },
    Variant { number: 12_101, key: "cycle976-known-two-skew-ball", source: KNOWN },
    Variant { number: 100_001, key: "cycle976-known-angle-four", source: KNOWN },
    Variant { number: 100_101, key: "cycle976-known-angle-four-ball", source: KNOWN },
    Variant { number: 101_001, key: "cycle976-known-angle-one", source: KNOWN },
    Variant { number: 102_001, key: "cycle976-known-angle-two", source: KNOWN },
    Variant { number: 102_101, key: "cycle976-known-angle-two-ball", source: KNOWN },
    Variant { number: 110_001, key: "cycle976-known-angle-four-skew", source: KNOWN },
    Variant { number: 110_101, key: "cycle976-known-angle-four-skew-ball", source: KNOWN },
    Variant { number: 112_001, key: "cycle976-known-angle-two-skew", source: KNOWN },
    Variant { number: 112_101, key: "cycle976-known-angle-two-skew-ball", source: KNOWN },
    Variant { number: 8, key: "cycle976-unknown-four", source: CENTRE },
    Variant { number: 108, key: "cycle976-unknown-four-ball", source: CENTRE },
    Variant { number: 10_008, key: "cycle976-unknown-four-skew", source: CENTRE },
    Variant { number: 10_108, key: "cycle976-unknown-four-skew-ball", source: CENTRE },
    Variant { number: 100_008, key: "cycle976-unknown-angle-four", source: CENTRE },
    Variant { number: 100_108, key: "cycle976-unknown-angle-four-ball", source: CENTRE },
    Variant { number: 110_008, key: "cycle976-unknown-angle-four-skew", source: CENTRE },
    Variant { number: 110_108, key: "cycle976-unknown-angle-four-skew-ball", source: CENTRE },
    Variant { number: 0, key: "cycle976-surface", source: "B:5348-5369;A:5796-5798" },
    Variant { number: 10_000, key: "cycle976-length", source: "B:5463-5501;A:5799" },
];

/// What the variants calibrate beside the ring: the surface of B:5423-5432, the length of B:5564-5569, and an unknown
/// centre that the path bridges (B:5282-5289).
pub const EXAMPLES: &[(When, &[(Name, &str)])] = &[
    (When::Any(&[ONE, TWO]), &[(names::MA, "1"), (names::MD, "0")]),
    (ANGLE, &[(names::STA1, "30")]),
    (UNKNOWN, &[(names::PRNUM, "2"), (names::FA, "55.123")]),
    (
        When::Any(&[SURFACE, LENGTH]),
        &[
            (names::SETVAL, "20"),
            (names::MA, "3"),
            (names::MD, "1"),
            (names::PRNUM, "1"),
            (names::TSA, "4"),
            (names::FA, "2"),
        ],
    ),
    (LENGTH, &[(names::TSA, "25"), (names::FA, "12")]),
];
