//! What a shop writes by hand around a measuring call: halt by result, rework loop, mean of several measurements, …
//! Each block is data: its fields, the calls that it suits, its lines before and behind the call. A block is read back
//! by its lines.

mod absent;
mod blocks;
mod nct;
mod pattern;
mod read;
mod revise;
mod values;
mod write;

pub use absent::{Absent, absent};
pub use read::{Found, found};
pub use revise::{Around, Carried, Stray, carried, inputs_at, revise, strays};
pub use values::{choices, completed, preset, problem};
pub use write::{Lines, Words, write};

use crate::control::MachineSort;
use crate::dialect::Dialect;
use crate::entry::{Corrects, Element, Inputs, ProbeUse, ResultField, Unit, names};
use crate::range::Range;

/// A block around a call.
pub struct Block {
    /// By this a question names it, the same on both controls: `rework`.
    pub name: &'static str,
    /// Its fields in the order in which they are asked for.
    pub fields: &'static [Field],
    /// What a call needs so that the block makes sense at it; all of these.
    pub suits: &'static [Suits],
    /// Lines before the call.
    pub before: &'static [Line],
    /// Lines behind the call.
    pub after: &'static [Line],
}

/// A line. In braces stand the names of fields, free names of the program (`pattern::Free`) and what the call itself
/// gives (`pattern::given`).
pub struct Line {
    /// Text of the program.
    pub code: &'static str,
    /// Key of its comment; empty: it has none.
    pub says: &'static str,
}

/// What is asked for.
pub struct Field {
    /// By this a question names it: `limit`.
    pub name: &'static str,
    /// What can be entered.
    pub kind: Kind,
    /// As typed where nothing is entered; the key of a text for an operator text; empty: it follows from the call, or
    /// has to be entered.
    pub preset: &'static str,
}

/// What can be entered.
pub enum Kind {
    /// A result of the call that a program can read.
    Result,
    /// One that is held against a limit: where the call has no difference, nothing stands for it by itself.
    Deviation,
    /// A number in the unit of that result.
    Limit,
    /// A whole number.
    Whole(Range),
    /// On which side of the setpoint there is material left: the sign of the difference as a comparison with 0.
    Side,
    /// A text that the operator reads.
    Text,
    /// A program that is called: its name, NCT its number.
    Program,
    /// Where the program goes on: a label, NCT a block number.
    Target,
    /// Number of an arithmetic parameter, NCT of a variable that stays.
    Variable(Range),
    /// Name of a file on the control.
    File,
    /// Name of a file that the control makes anew: where nothing is entered, the first that the program does not name.
    NewFile,
}

/// What a call has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Suits {
    /// Results that a program can read.
    Results,
    /// It measures a workpiece.
    Workpiece,
    /// It measures a tool.
    Tool,
    /// It corrects the tool that made the surface.
    CorrectsTool,
    /// It corrects nothing.
    Uncorrected,
    /// It may be made with the spindle turned: a probe in a spindle that no variant orients by itself.
    Turned,
    /// The straight way from its end to its beginning does not lead through the part.
    Returns,
    /// It names a work offset, in which its deviation can be read (NCT).
    Offset,
}

/// The blocks of a control, the outermost first.
pub fn blocks(dialect: Dialect) -> &'static [Block] {
    match dialect {
        Dialect::Sinumerik => blocks::BLOCKS,
        Dialect::Nct => nct::BLOCKS,
    }
}

/// The block of a control with this name.
pub fn block(dialect: Dialect, name: &str) -> Option<&'static Block> {
    blocks(dialect).iter().find(|block| block.name == name)
}

impl Block {
    /// Key of its title; with `-help` what it does, with `-words` by what it is found.
    pub fn key(&self) -> String {
        format!("around-{}", self.name)
    }

    /// Whether it makes sense at a call with these values.
    pub fn suits(&self, inputs: &Inputs) -> bool {
        self.suits.iter().all(|suits| suits.holds(inputs))
    }

    /// A field by its name.
    pub fn field(&self, name: &str) -> Option<&'static Field> {
        self.fields.iter().find(|field| field.name == name)
    }

    /// Keys of what stands in its lines in the words of whoever writes them, each once: comments and operator texts.
    pub fn says(&self) -> Vec<&'static str> {
        let texts = self.fields.iter().filter(|field| matches!(field.kind, Kind::Text)).map(|field| field.preset);
        let mut keys: Vec<&str> = texts.collect();
        for line in self.before.iter().chain(self.after) {
            if !line.says.is_empty() && !keys.contains(&line.says) {
                keys.push(line.says);
            }
        }
        keys
    }
}

impl Field {
    /// Key of its label.
    pub fn key(&self) -> String {
        format!("around-field-{}", self.name)
    }
}

impl Suits {
    fn holds(self, inputs: &Inputs) -> bool {
        let purpose = &inputs.cycle.purpose;
        let found = purpose.probe.measures() && !inputs.cycle.results.is_empty();
        let measures = found && !purpose.calibrates.holds(inputs);
        match self {
            Suits::Results => !results(inputs).is_empty(),
            Suits::Workpiece => measures && purpose.probe == ProbeUse::Workpiece,
            Suits::Tool => measures && purpose.probe == ProbeUse::Tool,
            Suits::CorrectsTool => corrects(inputs, Corrects::Tool),
            Suits::Uncorrected => corrects(inputs, Corrects::Nothing),
            Suits::Turned => {
                let milling = purpose.machine == MachineSort::Milling;
                let mono = inputs.any(names::PRNUM).is_some_and(|number| number as i64 / 100 % 10 == 1);
                let differential = inputs.variant / 1000 % 10 == 1;
                milling && !mono && !differential
            }
            // a shaft or a web about a given centre: it ends in front of its last point (B:6898-6905, B:6939)
            Suits::Returns => {
                let element = inputs.cycle.aim(inputs).map(|aim| aim.element);
                let around = matches!(element, Some(Element::Shaft | Element::Web));
                !(around && inputs.cycle.param(names::CPA.as_str()).is_some())
            }
            Suits::Offset => pattern::offset(inputs).is_some(),
        }
    }
}

/// Whether a call corrects this with its values as they are: nothing with `_KNUM` = 0 (B:1894-1896).
fn corrects(inputs: &Inputs, what: Corrects) -> bool {
    let none = inputs.any(names::KNUM) == Some(0.0);
    let aim = inputs.cycle.aim(inputs);
    let named = aim.is_some_and(|aim| aim.corrects.iter().any(|one| one.corrects == what));
    if what == Corrects::Nothing { none && inputs.cycle.aim(inputs).is_some() } else { named && !none }
}

/// Results of a call that a program can read and hold against a limit: differences first, then what else is measured,
/// and the number of the alarm last.
pub fn results(inputs: &Inputs) -> Vec<&'static ResultField> {
    if inputs.cycle.dialect != Dialect::Sinumerik || !inputs.cycle.purpose.probe.measures() {
        return Vec::new();
    }
    let measured = |field: &&ResultField| field.unit != Unit::None && field.when.holds(inputs);
    let mut found: Vec<&ResultField> = inputs.cycle.results.iter().filter(measured).collect();
    found.sort_by_key(|field| !is_difference(field));
    found.extend(inputs.cycle.alarm_result().filter(|field| field.when.holds(inputs)));
    found
}

/// Whether a result says how far something is from its setpoint.
pub fn is_difference(field: &ResultField) -> bool {
    field.key.contains("difference")
}
