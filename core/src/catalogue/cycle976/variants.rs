//! Measuring variants of CYCLE976 (B:5060-5084; the surface stands in A:5796-5799 and B:15595).

use super::params::{ANGLE, LENGTH, ONE, SURFACE, TWO, UNKNOWN};
use crate::entry::{Variant, When, names};
use crate::name::Name;

/// Holes with a known centre, holes with an unknown one, surfaces; in each the digits count up.
pub const VARIANTS: &[Variant] = &[
    Variant { number: 1, key: "cycle976-known-four", source: "B:5066-5084;B:5124-5162;A:5773-5792" },
    Variant { number: 101, key: "cycle976-known-four-ball", source: "B:5066-5084;B:5124-5162;A:5773-5792" },
    Variant { number: 1001, key: "cycle976-known-one", source: "B:5066-5084;B:5124-5162;A:5773-5792" },
    Variant { number: 2001, key: "cycle976-known-two", source: "B:5066-5084;B:5124-5162;A:5773-5792" },
    Variant { number: 2101, key: "cycle976-known-two-ball", source: "B:5066-5084;B:5124-5162;A:5773-5792" },
    Variant { number: 10_001, key: "cycle976-known-four-skew", source: "B:5066-5084;B:5124-5162;A:5773-5792" },
    Variant { number: 10_101, key: "cycle976-known-four-skew-ball", source: "B:5066-5084;B:5124-5162;A:5773-5792" },
    Variant { number: 12_001, key: "cycle976-known-two-skew", source: "B:5066-5084;B:5124-5162;A:5773-5792" },
    Variant { number: 12_101, key: "cycle976-known-two-skew-ball", source: "B:5066-5084;B:5124-5162;A:5773-5792" },
    Variant { number: 100_001, key: "cycle976-known-angle-four", source: "B:5066-5084;B:5124-5162;A:5773-5792" },
    Variant { number: 100_101, key: "cycle976-known-angle-four-ball", source: "B:5066-5084;B:5124-5162;A:5773-5792" },
    Variant { number: 101_001, key: "cycle976-known-angle-one", source: "B:5066-5084;B:5124-5162;A:5773-5792" },
    Variant { number: 102_001, key: "cycle976-known-angle-two", source: "B:5066-5084;B:5124-5162;A:5773-5792" },
    Variant { number: 102_101, key: "cycle976-known-angle-two-ball", source: "B:5066-5084;B:5124-5162;A:5773-5792" },
    Variant { number: 110_001, key: "cycle976-known-angle-four-skew", source: "B:5066-5084;B:5124-5162;A:5773-5792" },
    Variant {
        number: 110_101,
        key: "cycle976-known-angle-four-skew-ball",
        source: "B:5066-5084;B:5124-5162;A:5773-5792",
    },
    Variant { number: 112_001, key: "cycle976-known-angle-two-skew", source: "B:5066-5084;B:5124-5162;A:5773-5792" },
    Variant {
        number: 112_101,
        key: "cycle976-known-angle-two-skew-ball",
        source: "B:5066-5084;B:5124-5162;A:5773-5792",
    },
    Variant { number: 8, key: "cycle976-unknown-four", source: "B:5222-5256;A:5977-5998" },
    Variant { number: 108, key: "cycle976-unknown-four-ball", source: "B:5222-5256;A:5977-5998" },
    Variant { number: 10_008, key: "cycle976-unknown-four-skew", source: "B:5222-5256;A:5977-5998" },
    Variant { number: 10_108, key: "cycle976-unknown-four-skew-ball", source: "B:5222-5256;A:5977-5998" },
    Variant { number: 100_008, key: "cycle976-unknown-angle-four", source: "B:5222-5256;A:5977-5998" },
    Variant { number: 100_108, key: "cycle976-unknown-angle-four-ball", source: "B:5222-5256;A:5977-5998" },
    Variant { number: 110_008, key: "cycle976-unknown-angle-four-skew", source: "B:5222-5256;A:5977-5998" },
    Variant { number: 110_108, key: "cycle976-unknown-angle-four-skew-ball", source: "B:5222-5256;A:5977-5998" },
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
