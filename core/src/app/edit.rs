//! Edits of a program: a value changed in a form, a call in another style.

use super::beside::{Beside, Whole};
use super::finding::{Edit, Finding, edits, placed};
use super::start::{Machine, start};
use super::{Error, ProgramText, unknown};
use crate::control::Control;
use crate::dialect::Dialect;
use crate::entry::{Cycle, Style, Typed};
use crate::form::{self, Unfit};
use crate::message::Message;
use crate::name::Name;
use crate::program::change::apply;
use crate::program::compared::ComparedValue;
use crate::program::convert as converting;
use crate::program::cure::cure_all;
use crate::program::revise::{self, revise};
use crate::program::touched::TouchedLine;
use crate::syntax;
use crate::syntax::position::Positions;
use serde::{Deserialize, Serialize};

/// A new value of a call.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ChangeRequest {
    /// Control.
    pub control: Dialect,
    /// Text of the program.
    pub text: ProgramText,
    /// Which of its calls, from 0.
    pub call: usize,
    /// Parameter.
    pub name: String,
    /// New value, as typed; empty: the parameter is removed.
    pub value: String,
    /// Parameters that are typed along with it: where it chooses another variant, their values are meant for that.
    pub along: Option<Vec<String>>,
    /// Machine on which the program starts; absent: the core's own as it is.
    pub setup: Option<Machine>,
    /// Files beside it, of which definition files count; absent: none.
    pub with: Option<Vec<Beside>>,
}

impl ChangeRequest {
    /// That value alone, on the core's own machine and without files beside the program.
    pub fn new(control: Dialect, text: impl Into<ProgramText>, call: usize, name: &str, value: &str) -> Self {
        Self {
            control,
            text: text.into(),
            call,
            name: name.to_owned(),
            value: value.to_owned(),
            along: None,
            setup: None,
            with: None,
        }
    }
}

/// What a new value does to a program.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Changed {
    /// Lists of edits, each for the text after the ones before it; the only places that change.
    pub steps: Vec<Vec<Edit>>,
    /// Lines outside of the call's own that they change.
    pub elsewhere: Vec<TouchedLine>,
    /// The expression of the program that the value takes the place of; null: there is none, or the value is one too.
    pub replaced: Option<Replaced>,
    /// Parameters that the new variant does not know, or whose value does not fit it, taken out of the call.
    pub taken: Vec<Name>,
    /// Those of them whose value does not fit.
    pub unfit: Vec<Unfit>,
    /// What the calls of the program would say otherwise.
    pub values: Vec<ComparedValue>,
    /// Whether more changes than this value of this call: other lines, other calls that read it, other values of it.
    pub reaches: bool,
    /// What that means.
    pub findings: Vec<Finding>,
}

/// An expression of a call that another value would take the place of.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Replaced {
    /// As the call has it.
    pub text: String,
    /// What it is worth there; null: only the run tells.
    pub worth: Option<String>,
    /// Its variables.
    pub variables: Vec<Variable>,
}

/// A variable of an expression.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Variable {
    /// Its name, in upper case.
    pub name: String,
    /// Lines, from 1, that read what it holds at the call.
    pub uses: Vec<u32>,
    /// Lines, from 1, that may have given it its value.
    pub assigned: Vec<u32>,
    /// The assignment with which the expression is worth the new value; null: see `why`.
    pub change: Option<Assignment>,
    /// Why there is none.
    pub why: Option<Message>,
}

/// An assignment that would be another.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Assignment {
    /// The number that it would assign, as it is written.
    pub value: String,
    /// The only places of the text that change.
    pub edits: Vec<Edit>,
    /// Its line, as it is and as it would be.
    pub line: TouchedLine,
    /// What the calls of the program would say otherwise.
    pub values: Vec<ComparedValue>,
}

impl Replaced {
    fn placed(found: &revise::Replaced, positions: &Positions) -> Replaced {
        let variables = found.variables.iter().map(|one| Variable {
            name: one.name.clone(),
            uses: one.uses.clone(),
            assigned: one.assigned.clone(),
            change: one.change.as_ref().ok().map(|change| Assignment {
                value: change.value.clone(),
                edits: edits(std::slice::from_ref(&change.edit), positions),
                line: change.line.clone(),
                values: change.values.clone(),
            }),
            why: one.change.as_ref().err().cloned(),
        });
        Replaced { text: found.text.clone(), worth: found.worth.clone(), variables: variables.collect() }
    }
}

/// A call in another style.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ConvertRequest {
    /// Control.
    pub control: Dialect,
    /// Text of the program.
    pub text: ProgramText,
    /// Which of its calls, from 0; absent: all that can be written so.
    pub call: Option<usize>,
    /// The call style.
    pub style: Style,
    /// Machine on which the program starts; absent: the core's own as it is.
    pub setup: Option<Machine>,
    /// Files beside it, of which definition files count; absent: none.
    pub with: Option<Vec<Beside>>,
}

/// Edits that write calls in another way.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Converted {
    /// The only places of the text that change; none: it is not possible, see the findings.
    pub edits: Vec<Edit>,
    /// What has to be said about it.
    pub findings: Vec<Finding>,
    /// The values that the calls would gain, lose or have otherwise.
    pub values: Vec<ComparedValue>,
    /// How many calls are written anew.
    pub calls: usize,
}

/// All findings of a kind, to be cured at once.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct CureRequest {
    /// Control.
    pub control: Dialect,
    /// Text of the program.
    pub text: ProgramText,
    /// Name of the findings.
    pub code: String,
    /// Key of their cause.
    pub key: String,
    /// Machine on which the program starts; absent: the core's own as it is.
    pub setup: Option<Machine>,
    /// Files beside it, of which definition files count; absent: none.
    pub with: Option<Vec<Beside>>,
}

/// Edits that cure findings of a kind.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct CuredAll {
    /// The only places of the text that change.
    pub edits: Vec<Edit>,
    /// Findings that are gone then.
    pub gone: usize,
    /// Findings with a cure that are left then.
    pub left: usize,
}

/// Gives a parameter of a call another value.
///
/// ```
/// use probewright_core::app::{ChangeRequest, change};
/// use probewright_core::dialect::Dialect;
///
/// let text = "_MVAR=1 _SETVAL=132 ; bore\nCYCLE977\nM30\n".to_owned();
/// let done = change(ChangeRequest::new(Dialect::Sinumerik, text, 0, "_SETVAL", "40"))?;
/// let edit = &done.steps[0][0];
/// assert_eq!((edit.from, edit.to, edit.insert.as_str()), (16, 19, "40")); // nothing else changes
/// # Ok::<(), probewright_core::app::Error>(())
/// ```
///
/// # Errors
/// There is no such call.
pub fn change(asked: ChangeRequest) -> Result<Changed, Error> {
    let whole = Whole::defined(asked.control, asked.text, asked.with);
    let control = start(asked.control, asked.setup)?.setup.control;
    let mut program = syntax::read_held(asked.control, whole.text(), &control.definitions.macros, &mut |_| {});
    let along = asked.along.unwrap_or_default();
    let mut misfits = Vec::new();
    let mut unfit = |cycle: &'static Cycle, [before, after]: [&Typed; 2], control: &Control| {
        misfits = form::unfit(cycle, before, after, control);
        misfits.retain(|one| !along.iter().any(|name| one.name == name.as_str()));
        misfits.iter().map(|one| one.name).collect()
    };
    let done = revise(&program, asked.call, (&asked.name, &asked.value), &control, &mut unfit);
    let done = done.ok_or_else(|| unknown("document-call", &asked.call.to_string()))?;
    let unfit = misfits.into_iter().filter(|one| done.taken.contains(&one.name)).collect();
    let replaced = done.replaced.as_ref().map(|found| Replaced::placed(found, &Positions::new(&program.source)));
    let mut steps = Vec::new();
    for step in &done.steps {
        steps.push(edits(step, &Positions::new(&program.source)));
        program = program.again(&apply(&program.source, step));
    }
    Ok(Changed {
        steps,
        elsewhere: done.elsewhere,
        replaced,
        taken: done.taken,
        unfit,
        values: done.values,
        reaches: done.reaches,
        findings: placed(&done.findings, &Positions::new(b"")),
    })
}

/// Writes calls in another way.
///
/// # Errors
/// The machine has no such G function of units.
pub fn convert(asked: ConvertRequest) -> Result<Converted, Error> {
    let whole = Whole::defined(asked.control, asked.text, asked.with);
    let control = start(asked.control, asked.setup)?.setup.control;
    let program = syntax::read_held(asked.control, whole.text(), &control.definitions.macros, &mut |_| {});
    let done = match asked.call {
        Some(call) => converting::convert(&program, call, asked.style, &control),
        None => converting::convert_all(&program, asked.style, &control),
    };
    let positions = Positions::new(&program.source);
    Ok(Converted {
        edits: edits(&done.edits, &positions),
        findings: placed(&done.findings, &positions),
        values: done.values,
        calls: done.calls,
    })
}

/// Cures all findings of a kind.
///
/// # Errors
/// The machine has no such G function of units.
pub fn cure(asked: CureRequest) -> Result<CuredAll, Error> {
    let whole = Whole::defined(asked.control, asked.text, asked.with);
    let control = start(asked.control, asked.setup)?.setup.control;
    let program = syntax::read_held(asked.control, whole.text(), &control.definitions.macros, &mut |_| {});
    let done = cure_all(&program, &asked.code, &asked.key, &control);
    let edits = edits(&done.edits, &Positions::new(&program.source));
    Ok(CuredAll { edits, gone: done.gone, left: done.left })
}
