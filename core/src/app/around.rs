//! Blocks around a call: which suit it, which stand there, and edits that add, change or remove them.

use super::beside::{Beside, Whole};
use super::finding::{Edit, edits};
use super::start::{Machine, start};
use super::{Error, ProgramText, cycle, unknown};
use crate::check;
use crate::dialect::Dialect;
use crate::entry::{Inputs, Typed};
use crate::message::Message;
use crate::program::around::{
    Around, Block, Field, Kind, absent, blocks, choices, completed, found, inputs_at, preset, problem, revise, write,
};
use crate::program::calls::calls_on;
use crate::syntax;
use crate::syntax::position::Positions;
use serde::{Deserialize, Serialize};

/// What is asked about the blocks around a call.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct AroundRequest {
    /// Control.
    pub control: Dialect,
    /// Cycle of a call that is still to be written.
    pub cycle: String,
    /// Its values as typed.
    #[serde(default)]
    #[cfg_attr(test, ts(optional, as = "Option<Typed>"))]
    pub values: Typed,
    /// Text of the program.
    pub text: ProgramText,
    /// Which of its calls, from 0; absent: the call is still to be written.
    pub call: Option<usize>,
    /// The blocks that are wanted; absent: those that stand there.
    pub wanted: Option<Vec<Wanted>>,
    /// Words by key, for comments and operator texts.
    #[serde(default)]
    #[cfg_attr(test, ts(optional, as = "Option<Typed>"))]
    pub words: Typed,
    /// Whether each line gets its comment.
    #[serde(default)]
    #[cfg_attr(test, ts(optional, as = "Option<bool>"))]
    pub comments: bool,
    /// Machine; absent: the core's own as it is.
    pub setup: Option<Machine>,
    /// Files beside it, of which definition files count; absent: none.
    pub with: Option<Vec<Beside>>,
}

/// A block that is wanted.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "AroundWanted"))]
pub struct Wanted {
    /// Its name.
    pub name: String,
    /// Its values as typed.
    #[serde(default)]
    pub values: Typed,
}

/// The blocks around a call.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct AroundView {
    /// Those that suit the call or stand there, the outermost first.
    pub blocks: Vec<AroundBlock>,
    /// Lines before a call that is still to be written.
    pub before: String,
    /// Lines behind it.
    pub after: String,
    /// The only places of the text that change, where the call is in the program.
    pub edits: Vec<Edit>,
    /// Blocks that this control cannot have.
    pub absent: Vec<AroundAbsent>,
}

/// A block that a control cannot have.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct AroundAbsent {
    /// Key of its title.
    pub key: String,
    /// Key of the sentence that says why.
    pub why: &'static str,
}

/// A block.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct AroundBlock {
    /// Its name.
    pub name: &'static str,
    /// Key of its title; with `-help` what it does.
    pub key: String,
    /// Whether it is wanted.
    pub wanted: bool,
    /// Whether it suits the call.
    pub suits: bool,
    /// Its fields.
    pub fields: Vec<AroundField>,
    /// Keys of its comments and texts.
    pub says: Vec<&'static str>,
}

/// A field of a block.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct AroundField {
    /// Its name.
    pub name: &'static str,
    /// Key of its label.
    pub key: String,
    /// As typed, else as the program has it.
    pub value: String,
    /// What counts without: a value, of a text its key.
    pub preset: String,
    /// Whether that is the key of a text.
    pub text: bool,
    /// What can be chosen, each with the key of its name; empty: anything can be entered.
    pub choices: Vec<[&'static str; 2]>,
    /// What is wrong with it.
    pub problem: Option<Message>,
}

/// The blocks around a call.
///
/// # Errors
/// There is no such cycle or call.
pub fn around(asked: AroundRequest) -> Result<AroundView, Error> {
    let dialect = asked.control;
    let whole = Whole::defined(dialect, asked.text, asked.with);
    let control = start(dialect, asked.setup)?.setup.control;
    let words = |key: &str| asked.words.get(key).cloned().unwrap_or_else(|| key.to_owned());
    let wanted = |list: &[Wanted]| list.iter().map(|one| of(&one.name, &one.values)).collect::<Vec<_>>();
    let Some(index) = asked.call else {
        let cycle = cycle(dialect, &asked.cycle)?;
        let inputs = check::read(cycle, &asked.values, &control, &mut Vec::new());
        let wanted = wanted(&asked.wanted.unwrap_or_default());
        let mut taken = String::from_utf8_lossy(whole.text()).into_owned();
        let mut view = view(dialect, &inputs, &wanted, &taken);
        for (block, one) in chosen(dialect, &inputs, &wanted) {
            let lines = write(block, &one.values, &inputs, &taken, &words, asked.comments);
            taken = taken + &lines.before + &lines.after;
            view.before.insert_str(0, &lines.before);
            view.after.push_str(&lines.after);
        }
        return Ok(view);
    };
    let program = syntax::read_held(dialect, whole.text(), &control.definitions.macros, &mut |_| {});
    let sites = calls_on(&program, control.clone());
    let site = sites.get(index).ok_or_else(|| unknown("document-call", &index.to_string()))?;
    let inputs = inputs_at(site, &control);
    let there = || found(&program, site, &inputs).iter().map(|one| of(one.block.name, &one.values())).collect();
    let wanted = asked.wanted.as_deref().map_or_else(there, wanted);
    let mut view = view(dialect, &inputs, &wanted, &String::from_utf8_lossy(whole.text()));
    let made = revise(&program, site, &wanted, &inputs, &words, asked.comments);
    view.edits = edits(&made, &Positions::new(&program.source));
    Ok(view)
}

fn of(name: &str, values: &Typed) -> Around {
    Around { name: name.to_owned(), values: values.clone() }
}

/// The wanted blocks that can be written, the innermost first.
fn chosen<'a>(dialect: Dialect, inputs: &Inputs, wanted: &'a [Around]) -> Vec<(&'static Block, &'a Around)> {
    let of = |block: &'static Block| Some((block, wanted.iter().find(|one| one.name == block.name)?));
    let right = |(block, one): &(&'static Block, &Around)| {
        block.fields.iter().all(|field| problem(block, field, &one.values, inputs).is_none())
    };
    blocks(dialect).iter().rev().filter_map(of).filter(right).collect()
}

/// `text`: that of the program, whose names are not used again.
fn view(dialect: Dialect, inputs: &Inputs, wanted: &[Around], text: &str) -> AroundView {
    let taken = text.to_ascii_uppercase();
    let shown = blocks(dialect).iter().filter_map(|block| {
        let own = wanted.iter().find(|one| one.name == block.name);
        let suits = block.suits(inputs);
        let values = own.map_or_else(Typed::new, |one| one.values.clone());
        let free = completed(block, &Typed::new(), &taken);
        let fields = || block.fields.iter().map(|one| field(block, one, (&values, &free), inputs)).collect();
        (suits || own.is_some()).then(|| AroundBlock {
            name: block.name,
            key: block.key(),
            wanted: own.is_some(),
            suits,
            fields: fields(),
            says: block.says(),
        })
    });
    let blocks = shown.collect();
    let absent = absent(dialect).iter().map(|one| AroundAbsent { key: format!("around-{}", one.name), why: one.why });
    AroundView { blocks, before: String::new(), after: String::new(), edits: Vec::new(), absent: absent.collect() }
}

/// `free`: what counts of a field where nothing is entered, so that it differs from what the program has.
fn field(
    block: &'static Block,
    field: &'static Field,
    (values, free): (&Typed, &Typed),
    inputs: &Inputs,
) -> AroundField {
    AroundField {
        name: field.name,
        key: field.key(),
        value: values.get(field.name).cloned().unwrap_or_default(),
        preset: free.get(field.name).cloned().unwrap_or_else(|| preset(field, inputs)),
        text: matches!(field.kind, Kind::Text),
        choices: choices(field, inputs).into_iter().map(|(value, key)| [value, key]).collect(),
        problem: problem(block, field, values, inputs),
    }
}
