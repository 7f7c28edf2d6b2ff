//! Measuring variants of CYCLE982 (B:9224-9279, its lost lines from A:10287-10319): the combinations of the digits that
//! exist, calibration first, then one measurement, automatic measurement, incremental measurement.

use crate::catalogue::Variant;

/// All 68.
pub const VARIANTS: &[Variant] = &[
    variant(0, "cycle982-calibrate", "B:9369;A:10287-10319"),
    variant(10, "cycle982-calibrate-workpiece", "B:9370;A:10287-10319"),
    variant(
        100_000,
        "cycle982-incremental-calibrate",
        "B:9835;A:10287-10319",
    ),
    variant(
        100_010,
        "cycle982-incremental-calibrate-workpiece",
        "B:9836;A:10287-10319",
    ),
    variant(1, "cycle982-measure", "B:9622;B:9629;A:10287-10319"),
    variant(101, "cycle982-measure-reversal", "A:10287-10319"),
    variant(1001, "cycle982-measure-radius", "A:10287-10319"),
    variant(
        1101,
        "cycle982-measure-radius-reversal",
        "B:9636;A:10287-10319",
    ),
    variant(
        2001,
        "cycle982-measure-both",
        "B:9658;A:10709;A:10287-10319",
    ),
    variant(2101, "cycle982-measure-both-reversal", "A:10287-10319"),
    variant(
        10_001,
        "cycle982-measure-radial",
        "B:9628;B:9630;A:10287-10319",
    ),
    variant(
        10_101,
        "cycle982-measure-radial-reversal",
        "B:9637;A:10287-10319",
    ),
    variant(11_001, "cycle982-measure-radius-radial", "A:10287-10319"),
    variant(
        11_101,
        "cycle982-measure-radius-radial-reversal",
        "A:10287-10319",
    ),
    variant(
        12_001,
        "cycle982-measure-both-radial",
        "B:9638;A:10287-10319",
    ),
    variant(
        12_101,
        "cycle982-measure-both-radial-reversal",
        "B:9661-9668;A:10710;A:10287-10319",
    ),
    variant(11, "cycle982-measure-workpiece", "A:10287-10319"),
    variant(111, "cycle982-measure-reversal-workpiece", "A:10287-10319"),
    variant(1011, "cycle982-measure-radius-workpiece", "A:10287-10319"),
    variant(
        1111,
        "cycle982-measure-radius-reversal-workpiece",
        "A:10287-10319",
    ),
    variant(2011, "cycle982-measure-both-workpiece", "A:10287-10319"),
    variant(
        2111,
        "cycle982-measure-both-reversal-workpiece",
        "A:10287-10319",
    ),
    variant(10_011, "cycle982-measure-radial-workpiece", "A:10287-10319"),
    variant(
        10_111,
        "cycle982-measure-radial-reversal-workpiece",
        "A:10287-10319",
    ),
    variant(
        11_011,
        "cycle982-measure-radius-radial-workpiece",
        "A:10287-10319",
    ),
    variant(
        11_111,
        "cycle982-measure-radius-radial-reversal-workpiece",
        "A:10287-10319",
    ),
    variant(
        12_011,
        "cycle982-measure-both-radial-workpiece",
        "A:10287-10319",
    ),
    variant(
        12_111,
        "cycle982-measure-both-radial-reversal-workpiece",
        "A:10287-10319",
    ),
    variant(2, "cycle982-automatic", "B:9752;A:10917;A:10287-10319"),
    variant(102, "cycle982-automatic-reversal", "A:10287-10319"),
    variant(
        3002,
        "cycle982-automatic-upper",
        "B:9762-9768;A:10923;A:10287-10319",
    ),
    variant(3102, "cycle982-automatic-upper-reversal", "A:10287-10319"),
    variant(
        4002,
        "cycle982-automatic-opposite",
        "B:9787;A:10936;A:10287-10319",
    ),
    variant(
        4102,
        "cycle982-automatic-opposite-reversal",
        "A:10287-10319",
    ),
    variant(10_002, "cycle982-automatic-radial", "A:10287-10319"),
    variant(
        10_102,
        "cycle982-automatic-radial-reversal",
        "A:10922;A:10287-10319",
    ),
    variant(
        13_002,
        "cycle982-automatic-upper-radial",
        "A:10926;A:10287-10319",
    ),
    variant(
        13_102,
        "cycle982-automatic-upper-radial-reversal",
        "A:10287-10319",
    ),
    variant(
        14_002,
        "cycle982-automatic-opposite-radial",
        "B:9793;A:10939;A:10287-10319",
    ),
    variant(
        14_102,
        "cycle982-automatic-opposite-radial-reversal",
        "A:10287-10319",
    ),
    variant(12, "cycle982-automatic-workpiece", "A:10287-10319"),
    variant(
        112,
        "cycle982-automatic-reversal-workpiece",
        "A:10287-10319",
    ),
    variant(3012, "cycle982-automatic-upper-workpiece", "A:10287-10319"),
    variant(
        3112,
        "cycle982-automatic-upper-reversal-workpiece",
        "A:10287-10319",
    ),
    variant(
        4012,
        "cycle982-automatic-opposite-workpiece",
        "A:10287-10319",
    ),
    variant(
        4112,
        "cycle982-automatic-opposite-reversal-workpiece",
        "A:10287-10319",
    ),
    variant(
        10_012,
        "cycle982-automatic-radial-workpiece",
        "A:10287-10319",
    ),
    variant(
        10_112,
        "cycle982-automatic-radial-reversal-workpiece",
        "A:10287-10319",
    ),
    variant(
        13_012,
        "cycle982-automatic-upper-radial-workpiece",
        "A:10287-10319",
    ),
    variant(
        13_112,
        "cycle982-automatic-upper-radial-reversal-workpiece",
        "A:10287-10319",
    ),
    variant(
        14_012,
        "cycle982-automatic-opposite-radial-workpiece",
        "A:10287-10319",
    ),
    variant(
        14_112,
        "cycle982-automatic-opposite-radial-reversal-workpiece",
        "A:10287-10319",
    ),
    variant(
        100_001,
        "cycle982-incremental-measure",
        "B:9921;A:10287-10319",
    ),
    variant(
        100_101,
        "cycle982-incremental-measure-reversal",
        "A:10287-10319",
    ),
    variant(
        101_001,
        "cycle982-incremental-measure-radius",
        "A:10287-10319",
    ),
    variant(
        101_101,
        "cycle982-incremental-measure-radius-reversal",
        "A:10287-10319",
    ),
    variant(
        110_001,
        "cycle982-incremental-measure-radial",
        "A:10287-10319",
    ),
    variant(
        110_101,
        "cycle982-incremental-measure-radial-reversal",
        "A:10287-10319",
    ),
    variant(
        111_001,
        "cycle982-incremental-measure-radius-radial",
        "A:10287-10319",
    ),
    variant(
        111_101,
        "cycle982-incremental-measure-radius-radial-reversal",
        "A:10287-10319",
    ),
    variant(
        100_011,
        "cycle982-incremental-measure-workpiece",
        "B:9922;A:10287-10319",
    ),
    variant(
        100_111,
        "cycle982-incremental-measure-reversal-workpiece",
        "A:10287-10319",
    ),
    variant(
        101_011,
        "cycle982-incremental-measure-radius-workpiece",
        "A:10287-10319",
    ),
    variant(
        101_111,
        "cycle982-incremental-measure-radius-reversal-workpiece",
        "A:10287-10319",
    ),
    variant(
        110_011,
        "cycle982-incremental-measure-radial-workpiece",
        "A:10287-10319",
    ),
    variant(
        110_111,
        "cycle982-incremental-measure-radial-reversal-workpiece",
        "A:10287-10319",
    ),
    variant(
        111_011,
        "cycle982-incremental-measure-radius-radial-workpiece",
        "A:10287-10319",
    ),
    variant(
        111_111,
        "cycle982-incremental-measure-radius-radial-reversal-workpiece",
        "A:10287-10319",
    ),
];

const fn variant(number: i64, key: &'static str, source: &'static str) -> Variant {
    Variant {
        number,
        key,
        source,
    }
}
