//! Words without a value: settings of a block, modal functions, and those that change nothing that is simulated.

use super::interpret::Interpreter;
use super::modal::Motion;
use super::path::Suppress;
use super::problem::Problem;
use super::statement::Words;
use crate::catalogue::Dialect;
use crate::control::Transverse;
use crate::diagnostic::Severity;

/// Words that change nothing that is simulated: how the axes accelerate and look ahead, how a corner is approached, what
/// the screen shows, what a subprogram may be interrupted by.
const WITHOUT_EFFECT: [&str; 37] = [
    "STOPRE",
    "BRISK",
    "SOFT",
    "DRIVE",
    "BRISKA",
    "SOFTA",
    "DRIVEA",
    "FFWON",
    "FFWOF",
    "CFC",
    "CFIN",
    "CFTCP",
    "NORM",
    "CUT2D",
    "CUT2DF",
    "CDON",
    "CDOF",
    "SAVE",
    "DISPLOF",
    "DISPLON",
    "SBLOF",
    "SBLON",
    "DELDTG",
    "STARTFIFO",
    "STOPFIFO",
    "FIFOCTRL",
    "WALIMON",
    "WALIMOF",
    "RTLION",
    "RTLIOF",
    "COMPOF",
    "UPATH",
    "SPATH",
    "FNORM",
    "CUTCONOF",
    "BNAT",
    "ENAT",
];

/// Whether [`apply`] takes a word, or it changes nothing that is simulated.
pub fn known(name: &str) -> bool {
    WITHOUT_EFFECT.contains(&name) || setting(name).is_some()
}

/// What a word sets.
enum Setting {
    Suppress,
    Transverse(Transverse),
    Motion(Motion),
    EndOfSpline,
    /// How a contour is approached other than by NORM.
    Approach,
}

fn setting(name: &str) -> Option<Setting> {
    Some(match name {
        "SUPA" => Setting::Suppress,
        "DIAMOF" => Setting::Transverse(Transverse::Radius),
        "DIAMON" => Setting::Transverse(Transverse::Diameter),
        "DIAM90" => Setting::Transverse(Transverse::AbsoluteDiameter),
        "CIP" => Setting::Motion(Motion::Through),
        "ASPLINE" | "BSPLINE" | "CSPLINE" => Setting::Motion(Motion::Spline),
        "KONT" | "KONTT" | "KONTC" => Setting::Approach,
        "BAUTO" | "BTAN" | "EAUTO" | "ETAN" => Setting::EndOfSpline,
        _ => return None,
    })
}

/// Takes the settings of a block.
pub fn apply(run: &mut Interpreter, found: &mut Words) {
    if run.program.dialect == Dialect::Nct {
        found.calls.clear();
    }
    for call in &found.calls {
        match setting(&call.name) {
            Some(Setting::Suppress) => found.path.suppress = Suppress::All,
            Some(Setting::Transverse(transverse)) => run.sim.control.transverse = transverse,
            Some(Setting::Motion(motion)) => {
                run.modal.motion = motion;
                if motion == Motion::Spline {
                    let problem = Problem::new("run-spline", call.span, &*call.name);
                    run.tell(Severity::Warning, &problem);
                }
            }
            Some(Setting::Approach) => {
                let problem = Problem::new("run-contour-approach", call.span, &*call.name);
                run.tell(Severity::Note, &problem);
            }
            Some(Setting::EndOfSpline) | None => {}
        }
    }
}
