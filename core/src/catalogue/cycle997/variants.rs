//! Measuring variants of CYCLE997 (B:8242-8259, B:15850).

use crate::entry::Variant;

/// Where all of them stand. Four points at an angle with the diameter follow from the digits; the text names the digits
/// of three points only (B:8371).
const SOURCE: &str = "B:8246-8259;B:15850";

const fn variant(number: i64, key: &'static str) -> Variant {
    Variant { number, key, source: SOURCE }
}

/// One sphere, three spheres; in each parallel to the axes, then at an angle with three and with four points.
pub const VARIANTS: &[Variant] = &[
    variant(109, "cycle997-one"),
    variant(119, "cycle997-one-repeat"),
    variant(1_000_109, "cycle997-one-diameter"),
    variant(1_000_119, "cycle997-one-diameter-repeat"),
    variant(1109, "cycle997-one-angle"),
    variant(1119, "cycle997-one-angle-repeat"),
    variant(1_001_109, "cycle997-one-angle-diameter"),
    variant(1_001_119, "cycle997-one-angle-diameter-repeat"),
    variant(101_109, "cycle997-one-angle-four"),
    variant(101_119, "cycle997-one-angle-four-repeat"),
    variant(1_101_109, "cycle997-one-angle-four-diameter"),
    variant(1_101_119, "cycle997-one-angle-four-diameter-repeat"),
    variant(10_109, "cycle997-three"),
    variant(10_119, "cycle997-three-repeat"),
    variant(1_010_109, "cycle997-three-diameter"),
    variant(1_010_119, "cycle997-three-diameter-repeat"),
    variant(11_109, "cycle997-three-angle"),
    variant(11_119, "cycle997-three-angle-repeat"),
    variant(1_011_109, "cycle997-three-angle-diameter"),
    variant(1_011_119, "cycle997-three-angle-diameter-repeat"),
    variant(111_109, "cycle997-three-angle-four"),
    variant(111_119, "cycle997-three-angle-four-repeat"),
    variant(1_111_109, "cycle997-three-angle-four-diameter"),
    variant(1_111_119, "cycle997-three-angle-four-diameter-repeat"),
];
