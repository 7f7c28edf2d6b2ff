//! How the control carries out a program when it does not machine: what becomes of measuring cycles then (B:660-694).

use super::modal::Motion;
use super::{Interpreter, stem};
use crate::control::AXES;
use crate::diagnostic::{Severity, Span};
use crate::dialect::Dialect;
use crate::entry::Cycle;
use crate::machine::{Machine, Pretended};
use crate::own;
use crate::problem::Problem;
use serde::{Deserialize, Serialize};

/// How a program is carried out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "RunMode"))]
pub enum Mode {
    /// In AUTOMATIC: the cycles measure.
    #[default]
    Automatic,
    /// With the feed of the dry run, `$P_DRYRUN`.
    DryRun,
    /// Without motion of the axes, `$P_ISTEST`.
    ProgramTest,
    /// Searched through up to a block, `$P_SEARCH` without `$A_PROTO`; from there on as in AUTOMATIC.
    BlockSearch,
    /// The simulation of HMI Advanced, `$P_SIM`: the cycles are executed.
    Simulation,
    /// The simulation of Jobshop products, `$P_SEARCH` with `$A_PROTO`: measured, but nothing is corrected, shown,
    /// monitored or logged.
    Jobshop,
}

/// Every mode with its name as a document and the terminal have it.
pub const MODES: [(Mode, &str); 6] = [
    (Mode::Automatic, "automatic"),
    (Mode::DryRun, "dry-run"),
    (Mode::ProgramTest, "program-test"),
    (Mode::BlockSearch, "block-search"),
    (Mode::Simulation, "simulation"),
    (Mode::Jobshop, "jobshop"),
];

/// Feed of the dry run as delivered, mm/min (SD 42100; SD 42101 = 0: it counts where it is greater than what is
/// programmed). Data of the control itself: the manuals of the measuring cycles only name the mode (B:664).
const DRY_RUN_FEED: f64 = 5000.0;
/// Whether the cycles are executed in a simulation.
const EXECUTED: &str = "_MC_SIMSIM";
/// Deviation of the measured positions in a simulation, in the basic system.
const DEVIATION: &str = "_MC_SIMDIFF";

impl Mode {
    /// Whether it is that of machining.
    pub fn is_automatic(&self) -> bool {
        *self == Mode::Automatic
    }

    /// The system variables that are 1 in it.
    fn variables(self) -> &'static [&'static str] {
        match self {
            Mode::Automatic => &[],
            Mode::DryRun => &["$P_DRYRUN"],
            Mode::ProgramTest => &["$P_ISTEST"],
            Mode::BlockSearch => &["$P_SEARCH"],
            Mode::Simulation => &["$P_SIM"],
            Mode::Jobshop => &["$P_SEARCH", "$A_PROTO"],
        }
    }
}

/// The mode that is active here: a block search ends at its block. NCT has none of them.
fn active(run: &Interpreter) -> Mode {
    match run.limits.mode {
        _ if run.program.dialect == Dialect::Nct => Mode::Automatic,
        Mode::BlockSearch if !run.searching => Mode::Automatic,
        mode => mode,
    }
}

/// `$P_ISTEST` and the like.
pub fn variable(run: &Interpreter, key: &str) -> f64 {
    f64::from(u8::from(active(run).variables().contains(&stem(key))))
}

/// The program comes to a block, where a search may end. In program test, and where it is searched, no axis moves.
pub fn comes(run: &mut Interpreter, span: Span) {
    let searching = run.searching && run.program.dialect == Dialect::Sinumerik;
    run.searching &= run.sim.line.is_none_or(|line| line + 1 != run.limits.target);
    if searching && !run.searching {
        let from = own::SEARCH_ENDED.finding().text("position", position(run));
        run.tell_once(from.on(span));
    }
    run.sim.still = matches!(active(run), Mode::ProgramTest | Mode::BlockSearch);
}

/// Where the axes stand in the program's own coordinates. How they come there after NC start the manuals do not say: of
/// the search they tell only that cycles are skipped (B:660-668; A:568-585).
fn position(run: &Interpreter) -> String {
    let control = &run.sim.control;
    let factor = control.active_factor();
    let mut at = run.sim.position().0.map(|value| value / factor);
    at[0] *= control.transverse.shown();
    let named = AXES.iter().zip(at).map(|(axis, value)| format!("{axis}{}", (value * 1000.0).round() / 1000.0));
    named.collect::<Vec<_>>().join(" ")
}

/// Whether a measuring cycle is skipped here, which is told with what its results hold then. In a simulation what it
/// does only seems so.
pub fn skips(run: &mut Interpreter, cycle: &Cycle, span: Span) -> bool {
    let mode = active(run);
    let whole = mode != Mode::Jobshop;
    run.sim.pretended = Pretended { whole, ..Pretended::default() };
    if !cycle.is_measuring_cycle() {
        return false;
    }
    let control = &run.sim.control;
    let key = match mode {
        Mode::Automatic => return false,
        Mode::DryRun => "run-skipped-dry-run",
        Mode::ProgramTest => "run-skipped-program-test",
        Mode::BlockSearch => "run-skipped-block-search",
        Mode::Simulation | Mode::Jobshop if !control.bit(EXECUTED) => "run-skipped-simulation",
        Mode::Simulation | Mode::Jobshop => {
            let deviation = control.basic_length(DEVIATION);
            run.sim.pretended = Pretended { deviation, whole };
            if mode == Mode::Jobshop {
                run.tell(Severity::Note, &Problem::new("run-jobshop", span, cycle.name));
            }
            if deviation != 0.0 {
                let told = Problem::new("run-deviation", span, cycle.name);
                run.tell(Severity::Note, &told.number("deviation", deviation));
            }
            return false;
        }
    };
    run.tell(Severity::Note, &Problem::new(key, span, cycle.name));
    true
}

/// The feed of a motion that is not in rapid traverse: in a dry run the greater of both.
pub fn feed(run: &Interpreter, programmed: f64) -> f64 {
    if active(run) == Mode::DryRun && run.modal.motion != Motion::Rapid {
        programmed.max(DRY_RUN_FEED)
    } else {
        programmed
    }
}

/// Tells, however the program ended, that a search did not come to its block, and that an NCT control has no such mode.
pub fn ended(run: &mut Interpreter) {
    if run.program.dialect == Dialect::Nct && run.limits.mode != Mode::Automatic {
        let name = MODES.iter().find(|(mode, _)| *mode == run.limits.mode).map_or("", |(_, name)| *name);
        let problem = Problem::new("run-mode-none", Span::default(), name);
        run.keep(problem.diagnostic(Severity::Warning));
    }
    if active(run) == Mode::BlockSearch {
        let key = if run.limits.target == 0 { "run-search-target" } else { "run-search-missed" };
        let problem = Problem::at(key, Span::default()).number("line", f64::from(run.limits.target));
        run.keep(problem.diagnostic(Severity::Warning));
    }
}
