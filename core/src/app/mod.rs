//! What can be asked: questions and answers as plain data, a function each. Page, terminal program and tests ask the
//! same; `json` only writes them down.

mod ahead;
mod alarms;
mod answer;
mod around;
#[cfg(test)]
mod around_tests;
mod beside;
mod braking;
mod catalogue;
mod certainty;
mod changes;
mod commissioning;
mod concept;
mod definitions;
mod edit;
mod elsewhere;
mod encoding;
mod equip;
mod finding;
mod foreign;
mod form;
mod help;
mod jog;
mod machine;
mod machine_check;
mod older;
mod outcome;
mod places;
mod pointed;
mod practice;
mod predict;
mod program;
mod program_text;
mod protocol;
mod record;
mod repeat;
mod run;
mod scan;
mod scenario;
mod series;
mod start;
mod story;
mod supply;
mod terms;
mod trace;
mod twin;
mod unfit;
mod unsimulated;
mod user_programs;
mod whereabouts;
mod written;

pub use crate::refused::Refused as Error;
pub use ahead::{JogAhead, JogHidden, ahead};
pub use alarms::{AlarmInfo, alarm, alarms};
pub use answer::{
    Answer, Band, BandKind, Correction, Figure, Gauge, Limited, Mark, Needle, Part, ResultScreen, ScreenRow,
    ScreenUntil, ScreenValue, Verdict,
};
pub use around::{AroundAbsent, AroundBlock, AroundField, AroundRequest, AroundView, Wanted as AroundWanted, around};
pub use beside::{Beside, FileStart};
pub use braking::{BrakingPath, BrakingRequest, BrakingView, braking};
pub use catalogue::{
    AroundInfo, Catalogue, CycleInfo, ExplainedInfo, ExplainedKind, ParameterInfo, Purpose, Values, VariantInfo,
    catalogue,
};
pub use certainty::{
    CallCertainty, Certain, CertainChances, CertaintyRequest, CertaintyView, Contribution, WholeCertainty,
    WholeCertaintyRequest, certainty, certainty_of, whole_certainty,
};
pub use changes::{Change, changes};
pub use commissioning::{
    CommissioningPath, CommissioningStep, CommissioningView, CompatibilityRequest, CompatibilityRow, CompatibilityView,
    ConnectionView, commissioning, compatibility, compatibility_on,
};
pub use concept::{ConceptExample, ConceptPicture, ConceptRequest, concept_picture};
pub use definitions::{
    DefinitionsRequest, DefinitionsText, DefinitionsView, MemoryNeed, MemoryShare, ReadBack, ReadBackRequest,
    definitions, read_back,
};
pub use edit::{
    Assignment, ChangeRequest, Changed, ConvertRequest, Converted, CureRequest, CuredAll, Replaced, Variable, change,
    convert, cure,
};
pub use elsewhere::{Elsewhere, ElsewherePart, elsewhere};
pub use encoding::{FileHead, Recognised};
pub use equip::{CellText, EquipRequest, EquipView, EquipmentChange, EquipmentRows, RowOf, equip};
pub use finding::{Cure, Edit, Finding, findings};
pub use foreign::{ForeignCallView, ForeignFigure, ForeignLog, ForeignParameter, ForeignView, foreign, log_of};
pub use form::{FormRequest, FormView, LoggedCall, form};
pub use help::{HelpRequest, HelpResult, HelpSection, HelpText, HelpView, help};
pub use jog::{JogLine, JogPoint, JogResult, JogView, JogWrong, jog, jog_in_mm};
pub use machine::{MachineField, MachineGroup, MachineProblem, MachineRequest, MachineView, machine, machine_doubts};
pub use machine_check::{
    ExportedFile, MachineAxis, MachineCheckRequest, MachineCheckView, MachineFault, MachineLimit, MachinePlace,
    machine_check,
};
pub use older::{OlderCall, OlderLeft, OlderName, OlderParameter, OlderRequest, OlderView, answers, older};
pub use outcome::{Measured, Outcome, Raised};
pub use pointed::{PointedRequest, PointedView, pointed};
pub use practice::{
    Practice, PracticeActivation, PracticeApproach, PracticeArea, PracticeCall, PracticeCallRequest, PracticeChoice,
    PracticeDeviation, PracticeFace, PracticeField, PracticeFigure, PracticeKeys, PracticeMachine, PracticeMask,
    PracticePart, PracticePoint, PracticeProgram, PracticeRefusal, PracticeRequest, PracticeShow, PracticeUse,
    PracticeView, PracticeWord, approach, as_mask, as_program, call_text, jog_program, practice_record, practice_setup,
    practise,
};
pub use predict::{ErrorLimit, ErrorSliders, PartSliders, ProbeSliders};
pub use program::{
    Arrival, CallView, OtherCall, ProgramParameter, ProgramPlace, ReadRequest, ReadView, calls, calls_on, read,
};
pub use program_text::ProgramText;
pub use protocol::{Arrow, ProtocolColumns, ProtocolLine, ProtocolRequest, ProtocolView, laid, missing_file, protocol};
pub use record::{
    CalibrationState, ProbeOfCall, Record, RecordAbout, RecordFile, TableCall, TableRequest, csv, record_table,
};
pub use repeat::{RepeatFound, RepeatRequest, RepeatTrend, RepeatUsual, RepeatView, repeat, repeat_on, repeat_texts};
pub use run::{OfCall, Run, RunAlarm, RunAnswer, RunAssumed, RunDecision, RunRequest, RunResult, RunView};
pub use scan::{Scan, ScanRequest, ScanView, SurfaceChoice, put_surface};
pub use scenario::{
    CaseView, Expected, ExpectedCall, NoteRequest, Scenario, ScenarioCase, ScenarioRequest, ScenarioText, ScenarioView,
    noted, scenario,
};
pub use series::{
    Prepared, SeriesAlarm, SeriesCall, SeriesCorrection, SeriesExample, SeriesFigure, SeriesFollow, SeriesMemory,
    SeriesName, SeriesPreset, SeriesRequest, SeriesShare, SeriesSpread, SeriesStart, SeriesView, SeriesWeight, series,
    series_csv, series_of, series_start,
};
pub use start::{Beginning, Machine, OwnMachine};
pub use story::{Story, story};
pub use supply::{NewTool, Offer, Supply};
pub use terms::{ConceptView, GuideView, TermView, TermsView, terms};
pub use trace::columns::{Columns, columns, others};
pub use trace::{Trace, happened};
pub use twin::{Shared, TwinView};
pub use unfit::{UnfitRequest, unfit};
pub use user_programs::{CYCLE, UserBranch, UserLabel, UserProgramsRequest, UserProgramsView, user_programs};
pub use whereabouts::{whereabouts, whereabouts_in_jog};
pub use written::WrittenFile;

use crate::control::{Control, UnitFunction};
use crate::dialect::Dialect;
use crate::entry::Cycle;
use crate::refused::Path;

/// The cycle of a control with this name.
fn cycle(dialect: Dialect, name: &str) -> Result<&'static Cycle, Error> {
    crate::catalogue::find(dialect, name).ok_or_else(|| unknown("document-cycle", name))
}

/// Makes a G function of units the active one, where the control has it.
fn choose_units(control: &mut Control, function: UnitFunction) -> Result<(), Error> {
    if control.choose_units(function as u16) {
        return Ok(());
    }
    let path = Path::of(&["units"]);
    Err(Error::new("setup-units", path).text("name", format!("{function:?}")))
}

/// A name that nothing has.
fn unknown(key: &'static str, name: &str) -> Error {
    Error::new(key, Path::default()).text("name", name)
}
