//! Words of the control: settings of a block, those without effect here, those behind which nothing can be simulated.

use super::of_control::{EXECUTE_TEXT, SWIVEL};
use super::standard::{driven, is_standard, is_step};
use crate::catalogue;
use crate::control::Transverse;
use crate::dialect::Dialect;
use crate::syntax::language::is_word;

/// Words that change nothing that is simulated: how the axes accelerate, blend and look ahead, how a corner is
/// approached, how an orientation is interpolated, which channel has an axis, what the screen shows and how the editor
/// groups blocks, what a subprogram may be interrupted by.
const WITHOUT_EFFECT: &[&str] = &[
    "STOPRE", "BRISK", "SOFT", "DRIVE", "BRISKA", "SOFTA", "DRIVEA", "FFWON", "FFWOF", "CFC", "CFCIN", "CFIN", "CFTCP",
    "NORM", "CUT2D", "CUT2DF", "CDON", "CDOF", "CDOF2", "SAVE", "DISPLOF", "DISPLON", "SBLOF", "SBLON", "DELDTG",
    "STARTFIFO", "STOPFIFO", "FIFOCTRL", "WALIMON", "WALIMOF", "RTLION", "RTLIOF", "COMPOF", "COMPON", "COMPCAD",
    "COMPCURV", "CPRECON", "CPRECOF", "UPATH", "SPATH", "FNORM", "CUTCONOF", "BNAT", "ENAT", "CORROF", "DRFOF",
    "DYNNORM", "DYNPOS", "DYNROUGH", "DYNSEMIFIN", "DYNFINISH", "CYCLE832", "ORIWKS", "ORIMKS", "ORIAXES", "ORIVECT",
    "ORIEULER", "ORIRPY", "TRAFOOF", "SPLINEPATH", "TOROTOF", "PAROTOF", "TOFFOF", "TOWSTD", "FGROUP", "SPCON",
    "SPCOF", "WAITP", "WAITS", "GET", "GETD", "RELEASE", "AXTOCHAN", "GROUP_BEGIN", "GROUP_END", "WORKPIECE",
];

/// Words behind which nobody knows where the axes stand or in which coordinates they move, up to what ends that: other
/// coordinates, other axes, another position, frames that are not simulated.
const TRANSFORMATIONS: [&str; 11] =
    ["TRANSMIT", "TRACYL", "TRACON", "GEOAX", "PRESETON", "PRESETONS", "ROTS", "AROTS", "TOFRAME", "TOROT", "PAROT"];

/// Words whose arguments are values, some of which are handed back.
const WITH_VALUES: [&str; 15] = [
    "WRITE", "READ", "DELETE", "EXTOPEN", "EXTWRITE", "EXTCLOSE", "FILEDATE", "FILEINFO", "FILESIZE", "FILESTAT",
    "FILETIME", "GETSELT", "GETEXET", "DELT", "TCA",
];

/// Names with a value, perhaps of an axis (`ACC[X]=50`), that change nothing that is simulated: acceleration, blending,
/// limits and overrides of speeds, the speed of a positioning axis, priorities.
const VALUES_WITHOUT_EFFECT: &[&str] = &[
    "ADIS", "ADISPOS", "ACC", "ACCLIMA", "JERKLIM", "JERKLIMA", "VELOLIM", "VELOLIMA", "FGREF", "FL", "FA", "FP",
    "OVR", "OVRA", "OVRRAP", "POLF", "ACCLIM", "ATOL", "COUPFACT", "CTOL", "FLIM", "OTOL", "SCC", "SPN", "SPP",
    "STOLF", "SVC",
];

/// Names with a value that do something which is not simulated: tool carriers, actions, oscillation, travel to a fixed
/// stop, measuring of one axis, grinding wheels, positions of joints, orientations, couplings, sets of parameters of
/// the drives, addresses of the machine's maker (840D sl, Job planning and Fundamentals, lists of statements); the axes
/// go on without it.
const VALUES_TOLD: &[&str] = &[
    "TCARR", "ID", "IDS", "FXS", "FXST", "FXSW", "OS", "OST1", "OST2", "OSP1", "OSP2", "OST", "OSCTRL", "OSNSC", "OSE",
    "OSB", "MEASA", "MEAWA", "MEAC", "POSP", "STAT", "TU", "SUG", "ST", "TOFF", "TOFFL", "TOFFR", "CUTMOD", "LEAD",
    "TILT", "THETA", "NUT", "DITS", "DITE", "FZ", "GFRAME", "ALF", "DILF", "PRIO", "SCPARA", "DISPR", "DISRP",
    "CUTMODK", "FDA", "FMA", "OMA1", "OMA2", "OMA3", "OMA4", "OMA5", "OSCILL", "PHI", "PSI", "ISD", "SR", "SRA", "STA",
    "TOFFLR", MOVES_TOOL, "CPBC", "CPDEF", "CPDEL", "CPFMOF", "CPFMON", "CPFMSON", "CPFPOS", "CPFRS", "CPLA",
    "CPLCTID", "CPLDEF", "CPLDEL", "CPLDEN", "CPLINSC", "CPLINTR", "CPLNUM", "CPLOF", "CPLON", "CPLOUTSC", "CPLOUTTR",
    "CPLPOS", "CPLSETVAL", "CPMALARM", "CPMBRAKE", "CPMPRT", "CPMRESET", "CPMSTART", "CPMVDI", "CPOF", "CPON", "CPRES",
    "CPSETTYPE", "CPSYNCOP", "CPSYNCOP2", "CPSYNCOV", "CPSYNFIP", "CPSYNFIP2", "CPSYNFIV",
];

/// A way along the tool, wherever that points (`MOVT=5`): nobody knows where the axes stand behind it.
pub const MOVES_TOOL: &str = "MOVT";

/// Whether a run goes on without `ADIS=0.5`, `ACC[X]=50`, and whether it tells that; none: it is another name.
pub fn left_out(name: &str) -> Option<bool> {
    let told = VALUES_TOLD.contains(&name);
    (told || VALUES_WITHOUT_EFFECT.contains(&name)).then_some(told)
}

/// Whether the interpreter takes a word, or it changes nothing that is simulated.
pub fn known(name: &str) -> bool {
    WITHOUT_EFFECT.contains(&name) || setting(name).is_some() || of_axis(name).is_some()
}

/// Whether a word begins something behind which the axes are not those that are written.
pub fn transforms(name: &str) -> bool {
    TRANSFORMATIONS.contains(&name)
}

/// Whether a word has values as arguments, and hands back what it found in some of them.
pub fn hands_back(name: &str) -> bool {
    WITH_VALUES.contains(&name)
}

/// Whether nothing is made of the arguments of a word, so that they may name axes and channels that are not here.
pub fn ignores_arguments(name: &str) -> bool {
    let left_out = is_standard(name) && name != SWIVEL && catalogue::find(Dialect::Sinumerik, name).is_none();
    let word = WITHOUT_EFFECT.contains(&name) || is_word(name);
    driven(name).is_none()
        && name != EXECUTE_TEXT
        && !hands_back(name)
        && (left_out || is_step(name) || transforms(name) || word)
}

/// What a word sets.
pub enum Setting {
    /// No frame in this block.
    Suppress,
    /// How X is written.
    Transverse(Transverse),
    /// X by its radius, as a cycle computes with it, while the control still shows what was active before.
    RadiiInCycles,
    /// Each axis is written again as the channel says.
    AsChannel,
    /// A circle through a point.
    Through,
    /// A circle that goes on from the motion before.
    Tangential,
    /// A spline.
    Spline,
    /// How a spline begins or ends.
    EndOfSpline,
    /// How a contour is approached other than by NORM.
    Approach,
}

/// What a word with the name of an axis says of its positions alone (`DIAMONA[X]`); the inner none: they are written as
/// the channel says. The outer: it is no such word.
pub fn of_axis(name: &str) -> Option<Option<Transverse>> {
    Some(match name {
        "DIAMOFA" => Some(Transverse::Radius),
        "DIAMONA" => Some(Transverse::Diameter),
        "DIAM90A" => Some(Transverse::AbsoluteDiameter),
        "DIAMCHANA" => None,
        _ => return None,
    })
}

/// What a word sets; none: it is no such word.
pub fn setting(name: &str) -> Option<Setting> {
    Some(match name {
        "SUPA" => Setting::Suppress,
        "DIAMOF" => Setting::Transverse(Transverse::Radius),
        "DIAMON" => Setting::Transverse(Transverse::Diameter),
        "DIAM90" => Setting::Transverse(Transverse::AbsoluteDiameter),
        "DIAMCYCOF" => Setting::RadiiInCycles,
        "DIAMCHAN" => Setting::AsChannel,
        "CIP" => Setting::Through,
        "CT" => Setting::Tangential,
        "ASPLINE" | "BSPLINE" | "CSPLINE" | "POLY" => Setting::Spline,
        "KONT" | "KONTT" | "KONTC" => Setting::Approach,
        "BAUTO" | "BTAN" | "EAUTO" | "ETAN" => Setting::EndOfSpline,
        _ => return None,
    })
}
