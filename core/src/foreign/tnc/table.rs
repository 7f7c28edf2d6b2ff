//! The probe cycles of the control: its parameters in the order in which it writes them, with what it calls them.
//! `POST`: the order is what a published post processor writes, and the page with the values was not at hand.

use super::super::{Aim, ForeignCycle, Page, Parameter, Value};
use crate::entry::Task;
use crate::range::Range;
use Value::{Axis, Centre, Clearance, Direction, Height, Maximum, Minimum, Nominal, Own, Point, Tool, Usual};

/// Coordinates (TNC 320 9/2016, p. 396).
const COORDINATE: Range = Range::closed(-99_999.999_9, 99_999.999_9);
/// Lengths (TNC 320 9/2016, p. 396).
const LENGTH: Range = Range::closed(0.0, 99_999.999_9);
/// Angles (TNC 320 340 55x-04, p. 333).
const ANGLE: Range = Range::closed(-360.0, 360.0);
/// Where the order of a cycle is known from alone.
const POST: &str = "Autodesk post processor, revision 42300";

const fn q(name: &'static str, key: &'static str, text: &'static str, range: Range, value: Value) -> Parameter {
    Parameter { name, text, key, range, value, optional: false }
}

/// A cycle of which only its name and what it does are published.
const fn named(name: &'static str, key: &'static str, tasks: &'static [(Task, Aim)]) -> ForeignCycle {
    ForeignCycle { name, text: "", key, source: "", page: Page::Nothing, tasks, parameters: &[] }
}

/// A corner becomes a datum; no cycle only measures one.
const CORNER: &[(Task, Aim)] = &[
    (Task::InnerCorner, Aim::Datum),
    (Task::OuterCorner, Aim::Datum),
    (Task::InnerCorner, Aim::Measure),
    (Task::OuterCorner, Aim::Measure),
];

const Q247: Parameter = q("Q247", "tnc-q247", "STEPPING ANGLE", Range::closed(-120.0, 120.0), Usual(90.0));
const Q260: Parameter = q("Q260", "tnc-q260", "CLEARANCE HEIGHT", COORDINATE, Clearance);
const Q261: Parameter = q("Q261", "tnc-q261", "MEASURING HEIGHT", COORDINATE, Height);
const Q262: Parameter = q("Q262", "tnc-q262", "NOMINAL DIAMETER", LENGTH, Nominal(0));
const Q263: Parameter = q("Q263", "tnc-q263", "1ST POINT 1ST AXIS", COORDINATE, Point(0));
const Q264: Parameter = q("Q264", "tnc-q264", "1ST POINT 2ND AXIS", COORDINATE, Point(1));
const Q265: Parameter = q("Q265", "tnc-q265", "2ND POINT 1ST AXIS", COORDINATE, Own);
const Q266: Parameter = q("Q266", "tnc-q266", "2ND POINT 2ND AXIS", COORDINATE, Own);
const Q267: Parameter = q("Q267", "tnc-q267", "TRAVERSE DIRECTION", Range::closed(-1.0, 1.0), Direction);
const Q272: Parameter = q("Q272", "tnc-q272", "MEASURING AXIS", Range::closed(1.0, 3.0), Axis);
const Q273: Parameter = q("Q273", "tnc-q273", "CENTER IN 1ST AXIS", COORDINATE, Centre(0));
const Q274: Parameter = q("Q274", "tnc-q274", "CENTER IN 2ND AXIS", COORDINATE, Centre(1));
const Q275: Parameter = q("Q275", "tnc-q275", "MAXIMUM DIMENSION", LENGTH, Maximum(0));
const Q276: Parameter = q("Q276", "tnc-q276", "MINIMUM DIMENSION", LENGTH, Minimum(0));
const Q277: Parameter = q("Q277", "tnc-q277", "MAXIMUM DIMENSION", LENGTH, Maximum(0));
const Q278: Parameter = q("Q278", "tnc-q278", "MINIMUM DIMENSION", LENGTH, Minimum(0));
const Q279: Parameter = q("Q279", "tnc-q279", "TOLERANCE 1ST CENTER", LENGTH, Usual(0.0));
const Q280: Parameter = q("Q280", "tnc-q280", "TOLERANCE 2ND CENTER", LENGTH, Usual(0.0));
const Q281: Parameter = q("Q281", "tnc-q281", "MEASURING LOG", Range::closed(0.0, 2.0), Usual(0.0));
const Q282: Parameter = q("Q282", "tnc-q282", "1ST SIDE LENGTH", LENGTH, Nominal(0));
const Q283: Parameter = q("Q283", "tnc-q283", "2ND SIDE LENGTH", LENGTH, Nominal(1));
const Q284: Parameter = q("Q284", "tnc-q284", "MAX. LIMIT 1ST SIDE", LENGTH, Maximum(0));
const Q285: Parameter = q("Q285", "tnc-q285", "MIN. LIMIT 1ST SIDE", LENGTH, Minimum(0));
const Q286: Parameter = q("Q286", "tnc-q286", "MAX. LIMIT 2ND SIDE", LENGTH, Maximum(1));
const Q287: Parameter = q("Q287", "tnc-q287", "MIN. LIMIT 2ND SIDE", LENGTH, Minimum(1));
const Q288: Parameter = q("Q288", "tnc-q288", "MAXIMUM DIMENSION", Range::ANY, Maximum(0));
const Q289: Parameter = q("Q289", "tnc-q289", "MINIMUM DIMENSION", Range::ANY, Minimum(0));
const Q291: Parameter = q("Q291", "tnc-q291", "ANGLE OF 1ST HOLE", Range::ANY, Own);
const Q292: Parameter = q("Q292", "tnc-q292", "ANGLE OF 2ND HOLE", Range::ANY, Own);
const Q293: Parameter = q("Q293", "tnc-q293", "ANGLE OF 3RD HOLE", Range::ANY, Own);
const Q294: Parameter = q("Q294", "tnc-q294", "1ST POINT 3RD AXIS", COORDINATE, Own);
const Q301: Parameter = q("Q301", "tnc-q301", "MOVE TO CLEARANCE", Range::closed(0.0, 1.0), Usual(1.0));
const Q303: Parameter = q("Q303", "tnc-q303", "MEAS. VALUE TRANSFER", Range::closed(-1.0, 1.0), Usual(1.0));
const Q305: Parameter = q("Q305", "tnc-q305", "NUMBER IN TABLE", Range::NOT_NEGATIVE, Usual(0.0));
const Q307: Parameter = q("Q307", "tnc-q307", "PRESET ROTATION ANG.", Range::ANY, Own);
const Q309: Parameter = q("Q309", "tnc-q309", "PGM-STOP IF ERROR", Range::closed(0.0, 1.0), Usual(0.0));
const Q310: Parameter = q("Q310", "tnc-q310", "OFFS. 2ND MEASUREMNT", COORDINATE, Usual(0.0));
const Q311: Parameter = q("Q311", "tnc-q311", "NOMINAL LENGTH", LENGTH, Nominal(0));
const Q312: Parameter = q("Q312", "tnc-q312", "COMPENSATION AXIS", Range::ANY, Own);
const Q320: Parameter = q("Q320", "tnc-q320", "SET-UP CLEARANCE", LENGTH, Usual(0.0));
const Q321: Parameter = q("Q321", "tnc-q321", "CENTER IN 1ST AXIS", COORDINATE, Centre(0));
const Q322: Parameter = q("Q322", "tnc-q322", "CENTER IN 2ND AXIS", COORDINATE, Centre(1));
const Q323: Parameter = q("Q323", "tnc-q323", "FIRST SIDE LENGTH", LENGTH, Nominal(0));
const Q324: Parameter = q("Q324", "tnc-q324", "2ND SIDE LENGTH", LENGTH, Nominal(1));
const Q325: Parameter = q("Q325", "tnc-q325", "STARTING ANGLE", ANGLE, Usual(0.0));
const Q328: Parameter = q("Q328", "tnc-q328", "STARTNG PNT 1ST AXIS", COORDINATE, Centre(0));
const Q329: Parameter = q("Q329", "tnc-q329", "STARTNG PNT 2ND AXIS", COORDINATE, Centre(1));
const Q330: Parameter = q("Q330", "tnc-q330", "TOOL NUMBER", Range::NOT_NEGATIVE, Tool);
const Q331: Parameter = q("Q331", "tnc-q331", "DATUM", COORDINATE, Usual(0.0));
const Q332: Parameter = q("Q332", "tnc-q332", "DATUM", COORDINATE, Usual(0.0));
const Q333: Parameter = q("Q333", "tnc-q333", "DATUM", COORDINATE, Usual(0.0));
const Q337: Parameter = q("Q337", "tnc-q337", "SET TO ZERO", Range::ANY, Own);
const Q365: Parameter =
    Parameter { optional: true, ..q("Q365", "tnc-q365", "TYPE OF TRAVERSE", Range::ANY, Usual(1.0)) };
const Q380: Parameter = q("Q380", "tnc-q380", "REFERENCE ANGLE", Range::ANY, Own);
const Q381: Parameter = q("Q381", "tnc-q381", "PROBE IN TS AXIS", Range::ANY, Usual(0.0));
const Q382: Parameter = q("Q382", "tnc-q382", "1ST CO. FOR TS AXIS", COORDINATE, Usual(0.0));
const Q383: Parameter = q("Q383", "tnc-q383", "2ND CO. FOR TS AXIS", COORDINATE, Usual(0.0));
const Q384: Parameter = q("Q384", "tnc-q384", "3RD CO. FOR TS AXIS", COORDINATE, Usual(0.0));
const Q405: Parameter = q("Q405", "tnc-q405", "DATUM", COORDINATE, Usual(0.0));
const Q423: Parameter =
    Parameter { optional: true, ..q("Q423", "tnc-q423", "NO. OF MEAS. POINTS", Range::ANY, Usual(4.0)) };

/// The cycles.
pub static CYCLES: [ForeignCycle; 24] = [
    ForeignCycle {
        name: "TCH PROBE 400",
        text: "BASIC ROTATION",
        key: "tnc-400",
        source: POST,
        page: Page::Order,
        tasks: &[(Task::Angle, Aim::Datum)],
        parameters: &[Q263, Q264, Q265, Q266, Q272, Q267, Q261, Q320, Q260, Q301, Q307, Q305],
    },
    ForeignCycle {
        name: "TCH PROBE 403",
        text: "ROT IN ROTARY AXIS",
        key: "tnc-403",
        source: POST,
        page: Page::Order,
        tasks: &[],
        parameters: &[Q263, Q264, Q265, Q266, Q272, Q267, Q261, Q320, Q260, Q301, Q312, Q337, Q305, Q303, Q380],
    },
    ForeignCycle {
        name: "TCH PROBE 408",
        text: "SLOT CENTER REF PT",
        key: "tnc-408",
        source: POST,
        page: Page::Order,
        tasks: &[(Task::Pocket, Aim::Datum)],
        parameters: &[
            Q321,
            Q322,
            Parameter { text: "SLOT WIDTH", ..Q311 },
            Q272,
            Q261,
            Q320,
            Q260,
            Q301,
            Q305,
            Q405,
            Q303,
            Q381,
            Q382,
            Q383,
            Q384,
            Q333,
        ],
    },
    ForeignCycle {
        name: "TCH PROBE 409",
        text: "RIDGE CENTER REF PT",
        key: "tnc-409",
        source: POST,
        page: Page::Order,
        tasks: &[(Task::Web, Aim::Datum)],
        parameters: &[
            Q321,
            Q322,
            Parameter { text: "RIDGE WIDTH", ..Q311 },
            Q272,
            Q261,
            Q320,
            Q260,
            Q305,
            Q405,
            Q303,
            Q381,
            Q382,
            Q383,
            Q384,
            Q333,
        ],
    },
    ForeignCycle {
        name: "TCH PROBE 410",
        text: "DATUM INSIDE RECTAN.",
        key: "tnc-410",
        source: POST,
        page: Page::Order,
        tasks: &[(Task::Rectangle, Aim::Datum)],
        parameters: &[
            Q321, Q322, Q323, Q324, Q261, Q320, Q260, Q301, Q305, Q331, Q332, Q303, Q381, Q382, Q383, Q384, Q333,
        ],
    },
    ForeignCycle {
        name: "TCH PROBE 411",
        text: "DATUM OUTS. RECTAN.",
        key: "tnc-411",
        source: POST,
        page: Page::Order,
        tasks: &[(Task::Island, Aim::Datum)],
        parameters: &[
            Q321, Q322, Q323, Q324, Q261, Q320, Q260, Q301, Q305, Q331, Q332, Q303, Q381, Q382, Q383, Q384, Q333,
        ],
    },
    ForeignCycle {
        name: "TCH PROBE 412",
        text: "DATUM INSIDE CIRCLE",
        key: "tnc-412",
        source: "iTNC 530, cycle programming, p. 362",
        page: Page::Whole,
        tasks: &[(Task::Bore, Aim::Datum)],
        parameters: &[
            Q321, Q322, Q262, Q325, Q247, Q261, Q320, Q260, Q301, Q305, Q331, Q332, Q303, Q381, Q382, Q383, Q384, Q333,
            Q423, Q365,
        ],
    },
    ForeignCycle {
        name: "TCH PROBE 413",
        text: "DATUM OUTSIDE CIRCLE",
        key: "tnc-413",
        source: POST,
        page: Page::Order,
        tasks: &[(Task::Boss, Aim::Datum)],
        parameters: &[
            Q321, Q322, Q262, Q325, Q247, Q261, Q320, Q260, Q301, Q305, Q331, Q332, Q303, Q381, Q382, Q383, Q384, Q333,
            Q423, Q365,
        ],
    },
    named("TCH PROBE 414", "tnc-414", &[]),
    named("TCH PROBE 415", "tnc-415", CORNER),
    named("TCH PROBE 416", "tnc-416", &[]),
    ForeignCycle {
        name: "TCH PROBE 417",
        text: "DATUM IN TS AXIS",
        key: "tnc-417",
        source: POST,
        page: Page::Order,
        tasks: &[(Task::Face, Aim::Datum)],
        parameters: &[Q263, Q264, Q294, Q320, Q260, Q305, Q333, Q303],
    },
    named("TCH PROBE 418", "tnc-418", &[]),
    ForeignCycle {
        name: "TCH PROBE 419",
        text: "DATUM IN ONE AXIS",
        key: "tnc-419",
        source: POST,
        page: Page::Order,
        tasks: &[(Task::Wall, Aim::Datum)],
        parameters: &[Q263, Q264, Q261, Q320, Q260, Q272, Q267, Q305, Q333, Q303],
    },
    ForeignCycle {
        name: "TCH PROBE 420",
        text: "MEASURE ANGLE",
        key: "tnc-420",
        source: POST,
        page: Page::Order,
        tasks: &[(Task::Angle, Aim::Measure)],
        parameters: &[Q263, Q264, Q265, Q266, Q272, Q267, Q261, Q320, Q260, Q301, Q281],
    },
    ForeignCycle {
        name: "TCH PROBE 421",
        text: "MEASURE HOLE",
        key: "tnc-421",
        source: "TNC7, 81762x-19, log of cycle 421; TNC 320 9/2016, p. 396",
        page: Page::Whole,
        tasks: &[(Task::Bore, Aim::Measure)],
        parameters: &[Q273, Q274, Q262, Q325, Q247, Q261, Q320, Q260, Q301, Q275, Q276, Q279, Q280, Q281, Q309, Q330],
    },
    ForeignCycle {
        name: "TCH PROBE 422",
        text: "MEAS. CIRCLE OUTSIDE",
        key: "tnc-422",
        source: POST,
        page: Page::Order,
        tasks: &[(Task::Boss, Aim::Measure)],
        parameters: &[Q273, Q274, Q262, Q325, Q247, Q261, Q320, Q260, Q301, Q277, Q278, Q279, Q280, Q281, Q309, Q330],
    },
    ForeignCycle {
        name: "TCH PROBE 423",
        text: "MEAS. RECTAN. INSIDE",
        key: "tnc-423",
        source: "TNC 320 9/2016, p. 396",
        page: Page::Whole,
        tasks: &[(Task::Rectangle, Aim::Measure)],
        parameters: &[
            Q273, Q274, Q282, Q283, Q261, Q320, Q260, Q301, Q284, Q285, Q286, Q287, Q279, Q280, Q281, Q309, Q330,
        ],
    },
    ForeignCycle {
        name: "TCH PROBE 424",
        text: "MEAS. RECTAN. OUTS.",
        key: "tnc-424",
        source: POST,
        page: Page::Order,
        tasks: &[(Task::Island, Aim::Measure)],
        parameters: &[
            Q273, Q274, Q282, Q283, Q261, Q320, Q260, Q301, Q284, Q285, Q286, Q287, Q279, Q280, Q281, Q309, Q330,
        ],
    },
    ForeignCycle {
        name: "TCH PROBE 425",
        text: "MEASURE INSIDE WIDTH",
        key: "tnc-425",
        source: "TNC 320 340 55x-04, p. 393",
        page: Page::Whole,
        tasks: &[(Task::Pocket, Aim::Measure)],
        parameters: &[Q328, Q329, Q310, Q272, Q261, Q260, Q311, Q288, Q289, Q281, Q309, Q330],
    },
    ForeignCycle {
        name: "TCH PROBE 426",
        text: "MEASURE RIDGE WIDTH",
        key: "tnc-426",
        source: POST,
        page: Page::Order,
        tasks: &[(Task::Web, Aim::Measure)],
        parameters: &[Q263, Q264, Q265, Q266, Q272, Q261, Q320, Q260, Q311, Q288, Q289, Q281, Q309, Q330],
    },
    ForeignCycle {
        name: "TCH PROBE 427",
        text: "MEASURE COORDINATE",
        key: "tnc-427",
        source: "TNC7, 81762x-16, cycle 427",
        page: Page::Whole,
        tasks: &[(Task::Wall, Aim::Measure), (Task::Face, Aim::Measure)],
        parameters: &[Q263, Q264, Q261, Q320, Q272, Q267, Q260, Q281, Q288, Q289, Q309, Q330],
    },
    ForeignCycle {
        name: "TCH PROBE 430",
        text: "MEAS. BOLT HOLE CIRC",
        key: "tnc-430",
        source: "iTNC 530 340 49x-04, p. 138; TNC7 basic 81762x-19, cycle 430",
        page: Page::Without(&["Q281", "Q309", "Q330"]),
        tasks: &[],
        parameters: &[
            Q273,
            Q274,
            Q262,
            Q291,
            Q292,
            Q293,
            Q261,
            Q260,
            Q288,
            Q289,
            Q279,
            Q280,
            Parameter { optional: true, ..Q281 },
            Parameter { optional: true, ..Q309 },
            Parameter { optional: true, ..Q330 },
        ],
    },
    named("TCH PROBE 431", "tnc-431", &[]),
];
