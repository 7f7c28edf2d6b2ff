//! Calls in the list of a newer control. The checks hold the rules of the older one, whose manuals we have; here stands
//! which of them a newer control has as well. Of the others nothing is published: a value that only they refuse is
//! named in a note where it is not one that programs of newer controls have, and the call is neither simulated nor
//! written otherwise. An argument that is omitted is 0 there: who checks a call says so first, by [`with_omitted`].

use super::{Checked, Parsed, Target, check, error, parse, target, typed, variants};
use crate::control::Control;
use crate::control::frames::Store;
use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::entry::{Arg, ArgumentList, Cycle, Inputs, Kind, ProbeUse, Published, Style, Typed, names};
use crate::message::{self, Message};
use crate::name::Name;
use crate::own::{self, Own};

/// Highest number of a workpiece probe (61313).
pub const PROBES: f64 = 12.0;
/// Highest number of a tool probe (61416).
pub const TOOL_PROBES: f64 = 6.0;

/// Findings that follow from what the arguments mean and from the part, whichever control measures.
const SAME: [Own; 7] =
    [own::NOT_A_NUMBER, own::EXPRESSION, own::NO_VALUE, own::TOO_LARGE, own::TEXT_CHARACTERS, own::UNUSUAL, own::BALL];

/// Alarms whose condition is published for newer controls: `S_FA` above 0, the protection zone.
const SAME_ALARMS: [Code; 2] = [Code::Alarm(61308), Code::Alarm(61334)];

/// Warnings about two values that hold where both are written: what counts for an omitted one is another datum there.
/// That the dimension difference is above the safe area is none: it counts for tools, and posts write 1.01 and 1.
const ORDERS: [(Own, &[Name]); 3] = [
    (own::TOLERANCE_ORDER, &[names::TUL, names::TLL]),
    (own::BAND_DIFFERENCE, &[names::TUL, names::TLL, names::TDIF]),
    (own::ZERO_MEAN, &[names::TZL, names::TMV]),
];

/// Whether programs leave the argument empty because it belongs to a correction and this variant only measures:
/// argument 2 takes zero offsets alone.
pub fn is_unsaid(name: Name, inputs: &Inputs) -> bool {
    let corrected = inputs.cycle.param(names::KNUM.as_str()).map(|param| target(param, inputs));
    corrected == Some(Target::Tool) && [names::TMV, names::K, names::EVNUM].contains(&name)
}

/// Whether a list without this value does not say what is measured.
pub fn is_needed(name: Name) -> bool {
    NEEDED.contains(&name)
}

/// What says what is measured: each published program gives it.
const NEEDED: [Name; 4] = [names::SETVAL, names::SETV0, names::SETV1, names::MA];

/// Checks the values of a list.
pub fn check_listed(cycle: &'static Cycle, list: &ArgumentList, typed: &Typed, control: &Control) -> Checked {
    let typed = with_nothing(cycle, typed);
    let judged = judged(cycle, list, &typed, control);
    let older = judged.foreign.is_empty();
    let found = judged.found.into_iter().map(|one| in_words_of(list, one));
    Checked { diagnostics: found.collect(), inputs: judged.inputs.filter(|_| older) }
}

/// A finding that names an argument as the list does.
fn in_words_of(list: &ArgumentList, mut one: Diagnostic) -> Diagnostic {
    let named = |arg: &Arg| match arg {
        Arg::Newer(name, param) if *param == one.param && !name.is_empty() => Some(*name),
        _ => None,
    };
    let Some((name, param)) = list.args.iter().find_map(named).zip(one.param) else { return one };
    let texts = [Some(&mut one.message), one.hint.as_mut()].into_iter().flatten();
    for (_, text) in texts.flat_map(|message| &mut message.args) {
        if matches!(text, message::Arg::Text(text) if param == text.as_str()) {
            *text = message::Arg::Text(name.to_owned());
        }
    }
    one
}

/// A finding at an argument of a program's call, under its name there.
pub fn at_argument(list: &ArgumentList, one: Diagnostic) -> Diagnostic {
    let of = |arg: &Arg| match arg {
        Arg::Newer(name, Some(param)) if Some(*param) == one.param => Some(Name::new(name)),
        _ => None,
    };
    let param = list.args.iter().find_map(of).or(one.param);
    Diagnostic { param, ..in_words_of(list, one) }
}

/// Checks the values of a list as [`check_listed`]; a coarse zero offset is the one with its number, where
/// [`is_coarse`] says so to the control.
pub fn check_simulated(cycle: &'static Cycle, list: &ArgumentList, typed: &Typed, control: &Control) -> Checked {
    let mut as_older = typed.clone();
    if let Some(code) = coarse(typed) {
        as_older.insert(names::KNUM.to_string(), code.to_string());
    }
    let Checked { diagnostics, .. } = check_listed(cycle, list, typed, control);
    let inputs = check_listed(cycle, list, &as_older, control).inputs;
    let minus = typed.get(DIRECTION).is_some_and(|text| parse(text) == Parsed::Number(MINUS));
    Checked { diagnostics, inputs: inputs.map(|inputs| Inputs { minus, ..inputs }) }
}

/// Whether the correction goes into the coarse part of the zero offset; a number alone means the fine one there.
pub fn is_coarse(typed: &Typed) -> bool {
    coarse(typed).is_some()
}

/// What of a call that the older control could carry out is not sure on the newer one, so that it is not simulated.
pub fn unsure(cycle: &'static Cycle, list: &ArgumentList, typed: &Typed, control: &Control) -> Option<Diagnostic> {
    infeed(cycle, list, typed, control).or_else(|| fine(typed, control))
}

/// The infeed: which sign of it leads down differs between programs, so that nobody knows where the probe measures.
fn infeed(cycle: &'static Cycle, list: &ArgumentList, typed: &Typed, control: &Control) -> Option<Diagnostic> {
    let Parsed::Number(infeed) = parse(text(typed, names::ID)) else { return None };
    let used = is_infeed(list) && super::read(cycle, typed, control, &mut Vec::new()).uses(names::ID);
    (used && infeed != 0.0).then(|| own::NEWER_INFEED.finding().number("value", infeed).at(names::ID))
}

/// Whether `S_ID` leads down in this list.
pub fn is_infeed(list: &ArgumentList) -> bool {
    list.position(names::ID).is_some() && !list.has(ACROSS)
}

/// An argument of CYCLE998 alone, whose `S_ID` is the distance of its two points, and leads along the surface.
const ACROSS: &str = "S_SETV3";

/// The fine part of a zero offset whose coarse part is corrected: what becomes of it is a bit of a machine datum there,
/// of which no more than a name is published.
fn fine(typed: &Typed, control: &Control) -> Option<Diagnostic> {
    let number = coarse(typed)?;
    let frame = control.stored_frame(Store::Settable(usize::try_from(number).ok()?));
    let empty = frame.fine == [0.0; 3] && frame.rotary_fine.iter().all(|angle| angle.0 == 0.0);
    (!empty).then(|| own::NEWER_FINE.finding().number("value", (COARSE_FROM + number) as f64).at(names::KNUM))
}

/// The number of the zero offset whose coarse part is corrected.
fn coarse(typed: &Typed) -> Option<i64> {
    let Parsed::Number(code) = parse(text(typed, names::KNUM)) else { return None };
    let coarse = code.fract() == 0.0 && (10_001.0..=10_099.0).contains(&code);
    coarse.then_some(code as i64 - COARSE_FROM)
}

/// What the number of a zero offset has above that of its fine part, where the coarse part is meant.
pub const COARSE_FROM: i64 = 10_000;

/// Where the older control puts a correction of a settable frame, which the number in these lists says: 1 coarse, 0
/// fine (B:14035-14039).
pub const COARSE: &str = "_CHBIT[21]";

/// The argument for the measuring direction: 1 plus, 2 minus.
pub const DIRECTION: &str = "S_MD";
/// Its value for the minus direction.
pub const MINUS: f64 = 2.0;

/// Why a list is not simulated, where nothing else that is said of it tells: what of it means something else on the
/// older control.
pub fn not_simulated(cycle: &'static Cycle, list: &ArgumentList, typed: &Typed, control: &Control) -> Vec<Diagnostic> {
    let typed = with_nothing(cycle, typed);
    let judged = judged(cycle, list, &typed, control);
    let told = |name: &Name| judged.found.iter().any(|one| one.param == Some(*name));
    let unsure = |name: &Name| match *name {
        names::ID => is_infeed(list) && !is_nothing(text(&typed, names::ID)), // `unsure` tells it
        name => name == names::KNUM && is_coarse(&typed),
    };
    let names = judged.foreign.iter().filter(|name| !told(name) && !unsure(name));
    let why = names.map(|name| {
        let omitted = is_nothing(text(&typed, *name));
        let sentence = if omitted { own::NEWER_OMITTED } else { own::NEWER_UNSIMULATED };
        sentence.finding().text("param", *name).at(*name)
    });
    why.map(|one| in_words_of(list, one)).collect()
}

/// The parameters whose values mean something else on the older control, or whose meaning is not known.
pub fn foreign(cycle: &'static Cycle, list: &ArgumentList, typed: &Typed, control: &Control) -> Vec<Name> {
    judged(cycle, list, &with_nothing(cycle, typed), control).foreign
}

/// Whether nothing is known of the variant.
pub fn is_open(cycle: &'static Cycle, list: &ArgumentList, typed: &Typed, control: &Control) -> bool {
    let typed = with_nothing(cycle, typed);
    let variant = variants::chosen(cycle, &typed, control);
    !variant.is_some_and(|number| list.when.holds(&Inputs::new(cycle, number)))
}

/// Values with a 0 where an omitted argument is one that the older control asks for.
fn with_nothing(cycle: &Cycle, typed: &Typed) -> Typed {
    let mut typed = typed.clone();
    for name in cycle.variant_param().into_iter().chain([names::KNUM]) {
        if text(&typed, name).trim().is_empty() && cycle.param(name.as_str()).is_some() {
            typed.insert(name.to_string(), "0".to_owned());
        }
    }
    typed
}

/// The values of a call with a 0 for each argument that it omits (S_FA: 61308). What says what is measured stays empty
/// where 0 says nothing, and so does what belongs to a correction that is none. Which arguments a variant needs whose
/// number is not published, nobody knows.
pub fn with_omitted(cycle: &'static Cycle, typed: &Typed) -> Typed {
    let mut typed = with_nothing(cycle, typed);
    let variant = cycle.variant_param().map(|name| parse(text(&typed, name)));
    let variant = if let Some(Parsed::Number(number)) = variant { number as i64 } else { 0 };
    let inputs = Inputs::new(cycle, variant);
    let lists = cycle.lists.iter().filter(|list| list.style == Style::Operate && list.when.holds(&inputs));
    let params = lists.flat_map(|list| list.args).filter_map(|arg| cycle.param(arg.param()?.as_str()));
    for param in params.filter(|param| !matches!(param.kind, Kind::Text(_)) && !is_unsaid(param.name, &inputs)) {
        let says = !is_needed(param.name) || matches!(param.kind, Kind::Real) && param.range.contains(0.0);
        if says && text(&typed, param.name).trim().is_empty() {
            typed.insert(param.name.to_string(), "0".to_owned());
        }
    }
    typed
}

/// Whether these values hold a tool target, which has an argument of its own in a list.
pub fn has_tool_target(cycle: &'static Cycle, typed: &Typed, control: &Control) -> bool {
    Judged::new(cycle, typed, control).corrects() == Some(Target::Tool) && !is_nothing(text(typed, names::KNUM))
}

/// The last settable zero offset, G599.
const LAST_ZERO: f64 = 99.0;

/// Whether a zero offset has the same number on both controls.
pub fn is_same_zero(code: f64) -> bool {
    code.fract() == 0.0 && matches!(code as i64, 0..=99 | 9999)
}

/// Numbers of zero offsets in programs of newer controls: fine, coarse, and the active one in three ways.
pub fn is_newer_zero(code: f64) -> bool {
    let known = matches!(code as i64, 10_001..=10_099 | 9000 | 19_999);
    is_same_zero(code) || code.fract() == 0.0 && known
}

/// What is needed of a tool that is corrected.
const OF_TOOL: [Name; 5] = [names::KNUM, names::TNUM, names::TNAME, names::DLNUM, names::TENV];

/// Values of a list, what is said about them, and what of them the older control cannot say.
struct Judged<'a> {
    cycle: &'static Cycle,
    typed: &'a Typed,
    control: &'a Control,
    found: Vec<Diagnostic>,
    foreign: Vec<Name>,
    inputs: Option<Inputs>,
}

fn judged<'a>(cycle: &'static Cycle, list: &ArgumentList, typed: &'a Typed, control: &'a Control) -> Judged<'a> {
    let mut judged = Judged::new(cycle, typed, control);
    let Checked { diagnostics, inputs } = check(cycle, typed, control);
    judged.inputs = inputs;
    if is_open(cycle, list, typed, control) {
        judged.unknown(diagnostics);
    } else {
        judged.correction(diagnostics).into_iter().for_each(|one| judged.keep(one, list));
    }
    judged.probe();
    judged.numbers(list);
    judged.centre(list);
    judged
}

impl<'a> Judged<'a> {
    /// Nothing was said yet.
    fn new(cycle: &'static Cycle, typed: &'a Typed, control: &'a Control) -> Self {
        Self { cycle, typed, control, found: Vec::new(), foreign: Vec::new(), inputs: None }
    }

    fn read(&self) -> Inputs {
        super::read(self.cycle, self.typed, self.control, &mut Vec::new())
    }

    /// A value whose meaning is not known.
    fn open(&mut self, name: Name) {
        self.found.push(own::NEWER_OPEN.finding().text("param", name).text("value", text(self.typed, name)).at(name));
    }

    /// A variant of which nothing is published: the path has to be right all the same.
    fn unknown(&mut self, said: Vec<Diagnostic>) {
        let Some(name) = self.cycle.variant_param() else { return };
        self.foreign.push(name);
        let unread = |one: &Diagnostic| one.param == Some(name) && is_one_of(one, &SAME);
        let unread: Vec<Diagnostic> = said.into_iter().filter(unread).collect();
        if unread.is_empty() {
            self.open(name);
        }
        self.found.extend(unread);
        let written = text(self.typed, names::FA);
        let param = self.cycle.param(names::FA.as_str()).filter(|_| !written.is_empty());
        let judged = param.and_then(|param| typed::judge(param, &self.read(), self.control));
        // a tool cycle takes a signed path on the older control; what a sign means in a list is not published
        self.found.extend(judged.or_else(|| path(written).filter(|_| parse(written) == Parsed::Number(0.0))));
    }

    /// Which sort of target `_KNUM` names; none where the cycle has no target.
    fn corrects(&self) -> Option<Target> {
        self.cycle.param(names::KNUM.as_str()).map(|param| target(param, &self.read()))
    }

    /// `_KNUM`: a tool target belongs to another argument, a zero offset has numbers of its own. What else was said.
    fn correction(&mut self, mut said: Vec<Diagnostic>) -> Vec<Diagnostic> {
        let Some(target) = self.corrects() else { return said };
        let value = text(self.typed, names::KNUM);
        if target == Target::Tool && !is_nothing(value) {
            said.retain(|one| one.param.is_none_or(|name| !OF_TOOL.contains(&name)));
            self.found.push(own::NEWER_TARGET.finding().text("value", value).at(names::KNUM));
            self.foreign.push(names::KNUM);
        } else if let Some(code) = self.read().given(names::KNUM).filter(|code| !is_same_zero(*code)) {
            said.retain(|one| one.param != Some(names::KNUM));
            self.foreign.push(names::KNUM);
            if !is_newer_zero(code) && code.fract() == 0.0 && code > LAST_ZERO {
                self.found.push(own::NEWER_TARGET_PERHAPS.finding().text("value", value).at(names::KNUM));
            } else if !is_newer_zero(code) {
                self.open(names::KNUM);
            }
        }
        said
    }

    /// A finding of the older control, as far as it counts.
    fn keep(&mut self, one: Diagnostic, list: &ArgumentList) {
        if one.param == Some(names::PRNUM) && one.severity == Severity::Error {
            return self.foreign.push(names::PRNUM); // what is wrong with it, `probe` says
        }
        let says = |name: &Name| !is_nothing(text(self.typed, *name));
        let missing = one.code == own::MISSING.code();
        let order = ORDERS.iter().find(|(sentence, _)| sentence.code() == one.code);
        let counts = match order {
            Some((_, values)) => values.iter().all(says),
            None if missing => one.param.is_some_and(|name| NEEDED.contains(&name)),
            None => is_one_of(&one, &SAME) || SAME_ALARMS.contains(&one.code),
        };
        if counts {
            return self.found.push(one);
        }
        // which sign of the infeed leads down differs by the program
        let infeed = one.code == own::INFEED.code();
        let stops = infeed || one.severity == Severity::Error;
        let Some(name) = one.param.filter(|name| stops && !self.foreign.contains(name)) else { return };
        let published = self.read().given(name).is_some_and(|number| list.publishes(name, number));
        if says(&name) && !infeed && !published {
            self.open(name);
        }
        self.foreign.push(name);
    }

    /// Numbers whose meaning is not published, of the arguments of which some are.
    fn numbers(&mut self, list: &ArgumentList) {
        for (argument, published) in list.published {
            let name = list.typed_as(argument);
            let Parsed::Number(number) = parse(text(self.typed, name)) else { continue };
            // an omitted one is 0
            let omitted = number == 0.0 && matches!(published, Published::Seen(_));
            if published.holds(number) || omitted || self.foreign.contains(&name) {
                continue;
            }
            if matches!(published, Published::Seen(_)) {
                let finding = own::NEWER_SEEN.finding().text("param", *argument).number("value", number);
                self.found.push(finding.at(name));
                continue;
            }
            self.foreign.push(name);
            if self.found.iter().all(|one| one.param != Some(name)) {
                self.open(name);
            }
        }
    }

    /// The centre beside which the probe starts, and the mode that says so: one without the other.
    fn centre(&mut self, list: &ArgumentList) {
        let Parsed::Number(mode) = parse(text(self.typed, Name::new(MODE))) else { return };
        if !list.has(CENTRE[0]) {
            return;
        }
        let given = |says: fn(&str) -> bool| CENTRE.iter().any(|name| says(text(self.typed, Name::new(name))));
        let found = match mode == BESIDE {
            true if !given(|text| !text.trim().is_empty()) => own::NEWER_CENTRE_MISSING.finding(),
            false if given(|text| !is_nothing(text)) => own::NEWER_CENTRE_UNUSED.finding().number("value", mode),
            _ => return,
        };
        self.found.push(found.at(Name::new(MODE)));
    }

    /// The number of a probe.
    fn probe(&mut self) {
        let Parsed::Number(number) = parse(text(self.typed, names::PRNUM)) else { return };
        if let Some(found) = probe_number(self.cycle.purpose.probe, number) {
            self.found.push(found);
            self.foreign.push(names::PRNUM);
        }
    }
}

/// A measuring path of 0 or below, which no list has (remedy of alarm 61308).
pub fn path(text: &str) -> Option<Diagnostic> {
    let Parsed::Number(number) = parse(text) else { return None };
    let message = Message::new(own::RANGE.cause).text("param", names::FA).number("value", number).text("unit", "");
    let hint = Message::new("check-range-above-hint").number("min", 0.0).text("unit", "");
    let found = error(Code::Alarm(61308), message).hint(hint).at(names::FA);
    (number <= 0.0).then_some(found)
}

/// A number that no probe of this sort has.
pub fn probe_number(probe: ProbeUse, number: f64) -> Option<Diagnostic> {
    let (alarm, most) = match probe {
        ProbeUse::Workpiece => (61313, PROBES),
        ProbeUse::Tool => (61416, TOOL_PROBES),
        _ => return None,
    };
    let message = Message::new("check-probe-number").number("number", number);
    let hint = Message::new("check-probe-number-hint").number("fields", most);
    let found = error(Code::Alarm(alarm), message).hint(hint).at(names::PRNUM);
    (!(1.0..=most).contains(&number) || number.fract() != 0.0).then_some(found)
}

/// The argument for the working plane.
pub const PLANE: &str = "_DMODE";

/// The arguments for a centre beside which the probe starts, and how `_AMODE` says that they give it.
pub const CENTRE: [&str; 2] = ["S_XM", "S_YM"];
/// The argument for the mode.
pub const MODE: &str = "_AMODE";
/// Its value where the centre is given.
pub const BESIDE: f64 = 11.0;

/// What is typed for a parameter; empty where nothing is.
fn text(typed: &Typed, name: Name) -> &str {
    typed.get(name.as_str()).map_or("", String::as_str)
}

/// Whether nothing is written, or 0.
pub fn is_nothing(text: &str) -> bool {
    matches!(parse(text), Parsed::Empty | Parsed::Number(0.0))
}

fn is_one_of(one: &Diagnostic, sentences: &[Own]) -> bool {
    sentences.iter().any(|sentence| sentence.cause == one.message.key) // some share their number with a rule
}
