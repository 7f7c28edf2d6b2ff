//! Scenarios: a shop keeps its programs proven by what must come of them.

mod file;
mod held;
mod noted;

pub use file::{Expected, ExpectedCall, Scenario, ScenarioCase, ScenarioText};
pub use noted::{NoteRequest, noted};

use super::beside::{Beside, Whole};
use super::run::session;
use super::{Error, ProgramText};
use crate::machine::Setup;
use crate::manual::looked_up;
use crate::message::Message;
use crate::refused::{Path, Step};
use crate::run::{Limits, Outcome};
use crate::setup_file;
use held::differences;
use serde::{Deserialize, Serialize};

/// Work in blocks after which a case is given up: nobody watches it.
const BLOCKS: u64 = 10_000_000;

/// A scenario to carry out.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ScenarioRequest {
    /// The scenario.
    pub scenario: Scenario,
    /// Files that it names without their text; absent: none.
    pub beside: Option<Vec<Beside>>,
}

/// What came of a scenario.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ScenarioView {
    /// What it is about, and where its figures come from.
    pub source: String,
    /// Its cases in their order.
    pub cases: Vec<CaseView>,
}

/// What came of a case.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct CaseView {
    /// What it is called.
    pub id: String,
    /// Where the expectation comes from.
    pub oracle: String,
    /// How it differs from the expectation; empty: it holds.
    pub differences: Vec<Message>,
    /// What it does not prove although it holds.
    pub unproven: Vec<Message>,
}

/// Carries out a scenario, each case from the beginning.
///
/// # Errors
/// It has no case, a file that it names is not there, or what the machine of a case describes cannot be.
pub fn scenario(asked: ScenarioRequest) -> Result<ScenarioView, Error> {
    let ScenarioRequest { scenario, beside } = asked;
    let beside = beside.unwrap_or_default();
    let program = text(&scenario.program, &beside, &Path::of(&["program"]))?;
    let with = scenario.with.iter().enumerate().map(|(index, one)| {
        let text = text(one, &beside, &Path::of(&["with"]).element(index))?;
        Ok(Beside { name: one.name.clone(), text })
    });
    let with = with.collect::<Result<Vec<_>, Error>>()?;
    let member = |name: &str| Step::Member(name.to_owned());
    setup_file::setup(scenario.setup.clone()).map_err(|refused| refused.within(member("setup")))?;
    if scenario.cases.is_empty() {
        return Err(Error::new("scenario-no-case", Path::of(&["cases"])));
    }
    let cases = scenario.cases.iter().enumerate().map(|(index, case)| {
        let within = |refused: Error| refused.within(Step::Element(index)).within(member("cases"));
        let setup = scenario.machine(case).map_err(within)?;
        case.expect.proves().map_err(|refused| within(refused.within(member("expect"))))?;
        let (differences, unproven) = match replaced(&program, case) {
            Ok(text) => {
                let outcome = carried_out(&scenario, &setup, text.into(), with.clone());
                (differences(&case.expect, &outcome), unproven(&outcome))
            }
            Err(message) => (vec![message], Vec::new()),
        };
        let unproven = if differences.is_empty() { unproven } else { Vec::new() };
        Ok(CaseView { id: case.id.clone(), oracle: source(&case.oracle), differences, unproven })
    });
    let cases = cases.collect::<Result<Vec<_>, Error>>()?;
    Ok(ScenarioView { source: source(&scenario.source), cases })
}

/// Says that a run called no cycle, and what it went on without, where it did.
fn unproven(outcome: &Outcome) -> Vec<Message> {
    if !outcome.left().is_empty() {
        return Vec::new();
    }
    let without = (!outcome.passed_over.is_empty()).then(|| outcome.ending(|line| (None, line)));
    std::iter::once(Message::new("scenario-unmeasured")).chain(without).collect()
}

/// Where figures come from, as a reader looks it up.
fn source(text: &str) -> String {
    let chapters = looked_up(text);
    if chapters.is_empty() { text.to_owned() } else { chapters }
}

/// The text of a file: its own, else that of the file beside.
fn text(file: &ScenarioText, beside: &[Beside], path: &Path) -> Result<String, Error> {
    let found = || beside.iter().find(|one| one.name == file.name).map(|one| one.text.clone());
    let missing = || Error::new("scenario-file", path.member("name")).text("name", &file.name);
    file.text.clone().or_else(found).ok_or_else(missing)
}

impl Scenario {
    /// The machine of a case.
    ///
    /// # Errors
    /// What is described cannot be, or a variable of the case does not exist.
    pub fn machine(&self, case: &ScenarioCase) -> Result<Setup, Error> {
        let mut setup = setup_file::setup(self.setup.clone().with(case.workpiece.clone(), &case.tools, &case.data))?;
        for (name, value) in &case.variables {
            if !setup.control.set_variable(name, *value) {
                let path = Path::of(&["variables", name]);
                return Err(Error::new("scenario-variable", path).text("name", name));
            }
        }
        setup.control.activate(setup.control.settable);
        Ok(setup)
    }
}

/// The program of a case; else which text is not in it.
fn replaced(program: &str, case: &ScenarioCase) -> Result<String, Message> {
    case.replace.iter().try_fold(program.to_owned(), |program, (old, new)| {
        let missing = || Message::new("scenario-replace").text("text", old);
        if program.contains(old.as_str()) { Ok(program.replace(old.as_str(), new)) } else { Err(missing()) }
    })
}

fn carried_out(scenario: &Scenario, setup: &Setup, text: ProgramText, with: Vec<Beside>) -> Outcome {
    let whole = Whole::new(setup.control.dialect, text, Some(with));
    let Scenario { strict, mode, .. } = *scenario;
    let target = scenario.target.unwrap_or_default();
    let limits = Limits { steps: Some(BLOCKS), strict, mode, target, ..Limits::default() };
    let main = Some(scenario.main.as_str()).filter(|name| !name.is_empty());
    let session = session(&whole, setup, limits, main, scenario.arguments.clone());
    session.of_file(&scenario.program.name).complete()
}
