//! Which variant does what a mask of measuring in JOG does, as data (chapter 4 beside chapters 5 and 6). What a call
//! has to say follows from the fields of the mask, from where was touched, and from the set-up of JOG.

use crate::entry::names;
use crate::name::Name;

pub(crate) use super::cycle961::edges as corner_edges;

/// A mask, and a variant of an automatic cycle that does the same.
#[derive(Debug)]
pub struct Counterpart {
    /// Name of the mask.
    pub mask: &'static str,
    /// Name of the cycle.
    pub cycle: &'static str,
    /// Its variant.
    pub variant: i64,
    /// Variants that measure the same, with more or for another purpose: their calls open this mask too.
    pub also: &'static [i64],
    /// Last digits of `_MA` with which a call of the variant is meant; none: any.
    pub axis: &'static [i64],
    /// What the mask must hold.
    pub when: &'static [Holds],
    /// Where the call begins, and what follows from it.
    pub layout: Layout,
    /// The values of the call.
    pub values: &'static [(Name, Source)],
    /// Whether it corrects the fine part of a translation (B:1990-2003), where JOG writes the coarse one.
    pub fine: bool,
    /// What is different, beside what follows from the correction.
    pub differs: &'static [&'static str],
    /// Where the manual describes the variant.
    pub source: &'static str,
}

/// What a mask, or the tool in the spindle, must hold for a counterpart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Holds {
    /// A choice is one of these words.
    Word(&'static str, &'static [&'static str]),
    /// A number is 0, or it is not.
    Zero(&'static str, bool),
    /// The tool is wider than the upper side of the tool probe, or it is not.
    Wide(bool),
}

/// Where a call begins. Numbers that follow are taken by [`Source::Laid`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// Where the probe, or the tool, stood at NC start.
    Here,
    /// Before the set position of an edge, as far away as the probe was from the edge. Laid: that way.
    Before,
    /// Over the set centre: the cycle takes where it begins as set position.
    Set,
    /// Beside or in a round element, on the line of its first point. Laid: nothing.
    Around,
    /// Opposite the first of two points of an edge. Laid: the way to the second.
    Along,
    /// Over the first of three points that lie along the axes. Laid: the ways to the others.
    Level,
    /// Opposite a corner. Laid: both distances, angle of the reference edge, angle to the other.
    Opposite,
    /// Over the second of four points before a corner; inside of it, or outside with a way up. Laid: abscissa and
    /// ordinate of P1 to P4, infeed.
    Points {
        /// Whether the corner is that of a pocket.
        inside: bool,
    },
    /// At the set middle of two edges. Laid: their distance, infeed.
    Middle {
        /// Between two walls, or over a web.
        inside: bool,
    },
}

/// Where a value of a call comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Source {
    /// A number of the mask.
    Field(&'static str),
    /// A number of the mask with the other sign.
    Minus(&'static str),
    /// A size of the mask; where it is 0 the one that was measured.
    Size(&'static str),
    /// A number.
    Number(f64),
    /// An axis of the mask as part of the plane, from 1.
    Axis(&'static str),
    /// Two axes of the mask: the first one in the hundreds.
    Axes(&'static str, &'static str),
    /// A direction of the mask: 0 plus, 1 minus.
    Direction(&'static str),
    /// The zero offset that the mask corrects.
    Target,
    /// The rotary axis that the mask corrects, by its number in the channel; 0: the rotation.
    Rotary(&'static str),
    /// The workpiece probe, and what its number says in addition.
    Probe(f64),
    /// The tool probe.
    ToolProbe,
    /// The axis towards which the radius of a tool is measured.
    ToolAxis,
    /// Measuring path of the set-up.
    Path,
    /// That path, inside not longer than the way from the centre.
    Reach,
    /// Path of the tool probe.
    ToolPath,
    /// Measuring feed of the set-up.
    Feed,
    /// Feed of intermediate positioning.
    Positioning,
    /// A number of the layout.
    Laid(usize),
}

/// The probe and the feed, which every call with a workpiece probe has.
const PROBE: (Name, Source) = (names::PRNUM, Source::Probe(0.0));
const FEED: (Name, Source) = (names::VMS, Source::Feed);
const TARGET: (Name, Source) = (names::KNUM, Source::Target);
/// The safe area of a plane is as wide as the block is long: what the block finds is corrected.
const PATH: (Name, Source) = (names::FA, Source::Path);
const REACH: (Name, Source) = (names::FA, Source::Reach);
const SAFE_REACH: (Name, Source) = (names::TSA, Source::Reach);
/// The safe area of an angle lets every angle pass that the cycle takes.
const SAFE_ANGLE: (Name, Source) = (names::TSA, Source::Number(90.0));
/// Where everything is corrected, however small.
const ALWAYS: (Name, Source) = (names::TZL, Source::Number(0.0));

const EXPECTED: &str = "jog-differs-expected";
const STAND: &str = "jog-differs-stand";
const FOUND: &str = "jog-differs-points";
const TOOL_DATA: &str = "jog-differs-tool-data";

const PLAIN: Counterpart = Counterpart {
    mask: "",
    cycle: "",
    variant: 0,
    also: &[],
    axis: &[],
    when: &[],
    layout: Layout::Here,
    values: &[],
    fine: false,
    differs: &[],
    source: "",
};

const fn element(
    mask: &'static str,
    variant: i64,
    also: &'static [i64],
    when: &'static [Holds],
    values: &'static [(Name, Source)],
    source: &'static str,
) -> Counterpart {
    let (cycle, layout, differs) = ("CYCLE977", Layout::Set, &[EXPECTED, STAND]);
    Counterpart { mask, cycle, variant, also, when, layout, values, differs, source, fine: true, ..PLAIN }
}

const STRAIGHT: &[Holds] = &[Holds::Zero("contact_angle", true)];
const ANGLED: &[Holds] = &[Holds::Zero("contact_angle", false)];
const DIAMETER: (Name, Source) = (names::SETVAL, Source::Size("diameter"));
const DOWN: (Name, Source) = (names::ID, Source::Minus("dz"));
const RECTANGLE: [(Name, Source); 2] = [(names::SETV0, Source::Field("l")), (names::SETV1, Source::Field("w"))];

const fn angled(
    mask: &'static str,
    variant: i64,
    also: &'static [i64],
    differs: &'static [&'static str],
    source: &'static str,
) -> Counterpart {
    let (cycle, layout, when, values) = ("CYCLE979", Layout::Around, ANGLED, AROUND);
    Counterpart { mask, cycle, variant, also, when, layout, values, differs, source, fine: true, ..PLAIN }
}

/// Four points a right angle apart.
const AROUND: &[(Name, Source)] = &[
    DIAMETER,
    (names::CPA, Source::Field("x0")),
    (names::CPO, Source::Field("y0")),
    (names::STA1, Source::Field("contact_angle")),
    (names::INCA, Source::Number(90.0)),
    (names::RF, Source::Positioning),
    TARGET,
    (names::PRNUM, Source::Probe(1000.0)),
    REACH,
    SAFE_REACH,
    FEED,
];

const DISTANCES: &[(Name, Source)] = &[
    (names::STA1, Source::Laid(2)),
    (names::INCA, Source::Laid(3)),
    (names::ID, Source::Number(0.0)),
    (names::SETV0, Source::Laid(0)),
    (names::SETV1, Source::Laid(1)),
    (names::SETV2, Source::Minus("x0")),
    (names::SETV3, Source::Minus("y0")),
    (names::SETV4, Source::Number(3.0)),
    TARGET,
    PATH,
    PROBE,
    FEED,
];

const PLACES: &[(Name, Source)] = &[
    (names::ID, Source::Laid(8)),
    (names::SETV0, Source::Laid(0)),
    (names::SETV1, Source::Laid(1)),
    (names::SETV2, Source::Laid(2)),
    (names::SETV3, Source::Laid(3)),
    (names::SETV4, Source::Laid(4)),
    (names::SETV5, Source::Laid(5)),
    (names::SETV6, Source::Laid(6)),
    (names::SETV7, Source::Laid(7)),
    TARGET,
    PATH,
    PROBE,
    FEED,
];

/// Positions of a corner whose reference edge leads from it along plus; the cycle turns the abscissa into the edge as
/// it leads away from the corner.
const ALONG_PLUS: Holds = Holds::Word("pos", &["1", "4"]);
const INSIDE: Holds = Holds::Word("corner", &["inside"]);
const OUTSIDE: Holds = Holds::Word("corner", &["outside"]);

const fn rectangle_corner(
    variant: i64,
    when: &'static [Holds],
    also: &'static [i64],
    source: &'static str,
) -> Counterpart {
    let (cycle, layout, differs) = ("CYCLE961", Layout::Opposite, &[FOUND]);
    Counterpart {
        mask: "corner_right",
        cycle,
        variant,
        also,
        when,
        layout,
        values: DISTANCES,
        differs,
        source,
        ..PLAIN
    }
}

const fn corner(
    mask: &'static str,
    inside: bool,
    also: &'static [i64],
    differs: &'static [&'static str],
) -> Counterpart {
    let (variant, when, source): (i64, &'static [Holds], _) =
        if inside { (117, &[INSIDE], "B:7868;B:8054") } else { (118, &[OUTSIDE], "B:7869;B:8055") };
    let layout = Layout::Points { inside };
    Counterpart { mask, cycle: "CYCLE961", variant, also, when, layout, values: PLACES, differs, source, ..PLAIN }
}

const fn width(variant: i64, inside: bool, also: &'static [i64], source: &'static str) -> Counterpart {
    let (values, differs): (&'static [_], &'static [_]) =
        if inside { (GROOVE, &[EXPECTED, STAND, FOUND]) } else { (WEB, &[EXPECTED, STAND, FOUND, "jog-differs-up"]) };
    let layout = Layout::Middle { inside };
    Counterpart {
        mask: "distance",
        cycle: "CYCLE977",
        variant,
        also,
        layout,
        values,
        differs,
        source,
        fine: true,
        ..PLAIN
    }
}

const GROOVE: &[(Name, Source)] =
    &[(names::SETVAL, Source::Laid(0)), (names::MA, Source::Axis("axis")), TARGET, REACH, SAFE_REACH, PROBE, FEED];
const WEB: &[(Name, Source)] = &[
    (names::SETVAL, Source::Laid(0)),
    (names::MA, Source::Axis("axis")),
    (names::ID, Source::Laid(1)),
    TARGET,
    REACH,
    SAFE_REACH,
    PROBE,
    FEED,
];

const fn tool(
    mask: &'static str,
    variant: i64,
    when: &'static [Holds],
    also: &'static [i64],
    axis: &'static [i64],
    values: &'static [(Name, Source)],
    source: &'static str,
) -> Counterpart {
    Counterpart { mask, cycle: "CYCLE971", variant, also, axis, when, values, differs: &[TOOL_DATA], source, ..PLAIN }
}

const TOOL_PATH: (Name, Source) = (names::FA, Source::ToolPath);
const TOOL_SAFE: (Name, Source) = (names::TSA, Source::ToolPath);
const TOOL_MOST: (Name, Source) = (names::TDIF, Source::ToolPath);
const EDGE: (Name, Source) = (names::ID, Source::Field("v"));

/// The table, in the order in which a counterpart is sought: the first one counts whose conditions hold and whose
/// layout can be made.
pub const TABLE: &[Counterpart] = &[
    Counterpart {
        mask: "set_edge",
        cycle: "CYCLE978",
        variant: 100,
        also: &[0, 1000, 1100],
        layout: Layout::Before,
        values: &[
            (names::SETVAL, Source::Field("x0")),
            (names::MA, Source::Axis("axis")),
            TARGET,
            (names::FA, Source::Laid(0)),
            (names::TSA, Source::Laid(0)),
            PROBE,
            FEED,
        ],
        differs: &[EXPECTED],
        source: "B:6326;B:6456",
        fine: true,
        ..PLAIN
    },
    Counterpart {
        mask: "align_edge",
        cycle: "CYCLE998",
        variant: 100_105,
        also: &[105, 1105],
        layout: Layout::Along,
        values: &[
            (names::STA1, Source::Field("spec_angle")),
            (names::MA, Source::Axes("ref_axis", "axis")),
            (names::ID, Source::Laid(0)),
            (names::RA, Source::Rotary("angle_offset")),
            (names::MD, Source::Direction("direction")),
            TARGET,
            PATH,
            SAFE_ANGLE,
            PROBE,
            FEED,
        ],
        differs: &[FOUND, "jog-differs-angle"],
        source: "B:7322;B:7399;B:7548-7560",
        ..PLAIN
    },
    width(103, true, &[3, 1003, 1103], "B:5653;B:6183"),
    width(104, false, &[4, 1004, 1104], "B:5654;B:6184"),
    rectangle_corner(105, &[INSIDE, ALONG_PLUS], &[], "B:7864;B:7917"),
    rectangle_corner(106, &[OUTSIDE, ALONG_PLUS], &[], "B:7865;B:7918"),
    corner("corner_any", true, &[107], &[]),
    corner("corner_any", false, &[108], &["jog-differs-up"]),
    corner("corner_right", true, &[], &["jog-differs-fourth"]),
    corner("corner_right", false, &[], &["jog-differs-fourth", "jog-differs-up"]),
    element(
        "pocket_rect",
        105,
        &[5, 1005, 1105],
        &[],
        &[RECTANGLE[0], RECTANGLE[1], TARGET, REACH, SAFE_REACH, PROBE, FEED],
        "B:5655;B:6185",
    ),
    element(
        "hole_1",
        101,
        &[1, 1001, 1101],
        STRAIGHT,
        &[DIAMETER, TARGET, REACH, SAFE_REACH, PROBE, FEED],
        "B:5651;B:6181",
    ),
    angled("hole_1", 101, &[1], &[EXPECTED, FOUND], "B:6770;B:7157"),
    element(
        "spigot_rect",
        106,
        &[6, 1006, 1106],
        &[],
        &[RECTANGLE[0], RECTANGLE[1], DOWN, TARGET, REACH, SAFE_REACH, PROBE, FEED],
        "B:5656;B:6186",
    ),
    element(
        "spigot_1",
        102,
        &[2, 1002, 1102],
        STRAIGHT,
        &[DIAMETER, DOWN, TARGET, REACH, SAFE_REACH, PROBE, FEED],
        "B:5652;B:6182",
    ),
    angled("spigot_1", 102, &[2], &[EXPECTED, FOUND, "jog-differs-around"], "B:6771;B:7158"),
    Counterpart {
        mask: "align_plane",
        cycle: "CYCLE998",
        variant: 100_106,
        also: &[106],
        layout: Layout::Level,
        values: &[
            (names::STA1, Source::Number(0.0)),
            (names::INCA, Source::Number(0.0)),
            (names::ID, Source::Laid(0)),
            (names::SETV0, Source::Laid(1)),
            (names::MD, Source::Number(1.0)),
            TARGET,
            PATH,
            SAFE_ANGLE,
            PROBE,
            FEED,
        ],
        differs: &[FOUND],
        source: "B:7324;B:7605",
        ..PLAIN
    },
    Counterpart {
        mask: "cal_length",
        cycle: "CYCLE976",
        variant: 10_000,
        values: &[
            (names::SETVAL, Source::Field("z0")),
            (names::MA, Source::Number(3.0)),
            (names::MD, Source::Number(1.0)),
            PATH,
            (names::TSA, Source::Path),
            ALWAYS,
            PROBE,
            FEED,
        ],
        source: "B:5463-5501",
        ..PLAIN
    },
    Counterpart {
        mask: "cal_radius",
        cycle: "CYCLE976",
        variant: 10_108,
        also: &[8, 108, 10_008, 1, 101, 10_001, 10_101, 100_008, 100_108, 110_008, 110_108],
        values: &[(names::SETVAL, Source::Field("d")), REACH, SAFE_REACH, ALWAYS, PROBE, FEED],
        source: "B:5222-5256",
        ..PLAIN
    },
    tool(
        "tool_cal",
        0,
        &[Holds::Word("cal_kind", &["length"])],
        &[10],
        &[3],
        &[(names::MA, Source::Number(3.0)), TOOL_PATH, TOOL_SAFE, ALWAYS, (names::PRNUM, Source::ToolProbe)],
        "B:4188;B:4415",
    ),
    tool(
        "tool_cal",
        100_000,
        &[Holds::Word("cal_kind", &["length_and_diameter"])],
        &[0, 10, 100_010],
        &[],
        &[TOOL_PATH, TOOL_SAFE, ALWAYS, (names::PRNUM, Source::ToolProbe)],
        "B:4621;B:4648",
    ),
    tool(
        "tool_length",
        1,
        &[Holds::Wide(false)],
        &[11],
        &[3],
        &[
            (names::MA, Source::Number(3.0)),
            EDGE,
            TOOL_PATH,
            TOOL_SAFE,
            TOOL_MOST,
            ALWAYS,
            (names::PRNUM, Source::ToolProbe),
        ],
        "B:4189;B:4836",
    ),
    tool(
        "tool_length",
        2,
        &[Holds::Wide(true)],
        &[12],
        &[3],
        &[
            (names::MA, Source::Number(103.0)),
            EDGE,
            TOOL_PATH,
            TOOL_SAFE,
            TOOL_MOST,
            ALWAYS,
            (names::PRNUM, Source::ToolProbe),
        ],
        "B:4190;B:4837",
    ),
    tool(
        "tool_radius",
        2,
        &[],
        &[1, 11, 12],
        &[1, 2],
        &[
            (names::MA, Source::ToolAxis),
            EDGE,
            TOOL_PATH,
            TOOL_SAFE,
            TOOL_MOST,
            ALWAYS,
            (names::PRNUM, Source::ToolProbe),
        ],
        "B:4190;B:4837",
    ),
];
