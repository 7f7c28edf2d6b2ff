//! Words of the control: settings of a block, those without effect here, those behind which nothing can be simulated.

use super::of_control::SWIVEL;
use super::standard::{driven, is_standard, is_step};
use crate::catalogue;
use crate::control::Transverse;
use crate::dialect::Dialect;
use crate::syntax::language::is_word;

/// Words that change nothing that is simulated: how the axes accelerate, blend and look ahead, how a corner is
/// approached, how an orientation is interpolated, which channel has an axis, what the screen shows and how the editor
/// groups blocks, what a subprogram may be interrupted by.
const WITHOUT_EFFECT: &[&str] = &[
    "STOPRE", "BRISK", "SOFT", "DRIVE", "BRISKA", "SOFTA", "DRIVEA", "FFWON", "FFWOF", "CFC", "CFIN", "CFTCP", "NORM",
    "CUT2D", "CUT2DF", "CDON", "CDOF", "CDOF2", "SAVE", "DISPLOF", "DISPLON", "SBLOF", "SBLON", "DELDTG", "STARTFIFO",
    "STOPFIFO", "FIFOCTRL", "WALIMON", "WALIMOF", "RTLION", "RTLIOF", "COMPOF", "COMPON", "COMPCAD", "COMPCURV",
    "CPRECON", "CPRECOF", "UPATH", "SPATH", "FNORM", "CUTCONOF", "BNAT", "ENAT", "CORROF", "DRFOF", "DYNNORM",
    "DYNPOS", "DYNROUGH", "DYNSEMIFIN", "DYNFINISH", "CYCLE832", "ORIWKS", "ORIMKS", "ORIAXES", "ORIVECT", "ORIEULER",
    "ORIRPY", "TRAFOOF", "TOROTOF", "PAROTOF", "TOFFOF", "TOWSTD", "FGROUP", "SPCON", "SPCOF", "WAITP", "WAITS", "GET",
    "GETD", "RELEASE", "AXTOCHAN", "GROUP_BEGIN", "GROUP_END", "WORKPIECE",
];

/// Words behind which nobody knows where the axes stand or in which coordinates they move: they stop the run.
const BEYOND: &[&str] = &[
    "TRANSMIT", "TRACYL", "TRAANG", "TRACON", "PRESETON", "PRESETONS", "ROTS", "AROTS", "TOFRAME", "TOROT", "PAROT",
    "TOFFON", "GEOAX", "POLY", "SPLINEPATH", "EXECSTRING", "GOTOS",
];

/// Names with a value, perhaps of an axis (`ACC[X]=50`), that change nothing that is simulated: acceleration, blending,
/// limits and overrides of speeds, the speed of a positioning axis, priorities.
const VALUES_WITHOUT_EFFECT: &[&str] = &[
    "ADIS", "ADISPOS", "ACC", "ACCLIMA", "JERKLIM", "JERKLIMA", "VELOLIM", "VELOLIMA", "FGREF", "FL", "FA", "FP",
    "OVR", "OVRA", "OVRRAP", "POLF",
];

/// Names with a value that do something which is not simulated; the axes go on without it.
const VALUES_TOLD: &[&str] = &["TCARR", "ID"];

/// Whether a run goes on without `ADIS=0.5`, `ACC[X]=50`, and whether it tells that; none: it is another name.
pub fn left_out(name: &str) -> Option<bool> {
    let told = VALUES_TOLD.contains(&name);
    (told || VALUES_WITHOUT_EFFECT.contains(&name)).then_some(told)
}

/// Whether the interpreter takes a word, or it changes nothing that is simulated.
pub fn known(name: &str) -> bool {
    WITHOUT_EFFECT.contains(&name) || setting(name).is_some()
}

/// Whether a word stops the run, as what comes behind it cannot be simulated.
pub fn beyond(name: &str) -> bool {
    BEYOND.contains(&name)
}

/// Whether nothing is made of the arguments of a word, so that they may name axes and channels that are not here.
pub fn ignores_arguments(name: &str) -> bool {
    let left_out = is_standard(name) && name != SWIVEL && catalogue::find(Dialect::Sinumerik, name).is_none();
    driven(name).is_none()
        && (left_out || is_step(name) || WITHOUT_EFFECT.contains(&name) || beyond(name) || is_word(name))
}

/// What a word sets.
pub enum Setting {
    /// No frame in this block.
    Suppress,
    /// How X is written.
    Transverse(Transverse),
    /// A circle through a point.
    Through,
    /// A spline.
    Spline,
    /// How a spline begins or ends.
    EndOfSpline,
    /// How a contour is approached other than by NORM.
    Approach,
}

/// What a word sets; none: it is no such word.
pub fn setting(name: &str) -> Option<Setting> {
    Some(match name {
        "SUPA" => Setting::Suppress,
        "DIAMOF" => Setting::Transverse(Transverse::Radius),
        "DIAMON" => Setting::Transverse(Transverse::Diameter),
        "DIAM90" => Setting::Transverse(Transverse::AbsoluteDiameter),
        "CIP" => Setting::Through,
        "ASPLINE" | "BSPLINE" | "CSPLINE" => Setting::Spline,
        "KONT" | "KONTT" | "KONTC" => Setting::Approach,
        "BAUTO" | "BTAN" | "EAUTO" | "ETAN" => Setting::EndOfSpline,
        _ => return None,
    })
}
