//! What is said about measuring calls of an 840C, and the cures: the whole program with the names of today, or one
//! assignment where the manual leaves open what is meant.

use super::edits::{edits, named, separated, without};
use super::{Answers, Assigned, Call, Clash, Older, find};
use crate::catalogue::r_parameters::{Called, FACTOR, SETPOINTS, VARIANT};
use crate::diagnostic::{Cure, Diagnostic, Edit};
use crate::entry::names;
use crate::message::{Arg, Message};
use crate::name::Name;
use crate::own::{self, Own};
use crate::program::advice::outside_older as outside;
use crate::program::findings::not_understood;
use crate::syntax::fold::{NOTHING, number};
use crate::syntax::programs::Programs;
use crate::syntax::{Program, SyntaxError};
use std::collections::{BTreeMap, BTreeSet};

/// Whether it is said of a measuring call of an 840C.
pub fn is_of_call(found: &Diagnostic) -> bool {
    found.code == own::OLDER_CALL.code()
}

/// What is to be said; the first call has the cure for all of them, as long as nothing is open.
pub fn findings(program: &Program, programs: &Programs, older: &Older, found: &mut Vec<Diagnostic>) {
    let answered = answered(program, programs, older);
    let mut cure = Some(edits(program, older)).filter(|edits| !edits.is_empty());
    for call in &older.calls {
        let (name, cycle) = (program.name(call.name), call.cycle.name);
        let mut finding =
            own::OLDER_CALL.finding().text("word", name).text("cycle", cycle).on(program.placed(call.name));
        finding.message.args.push(("names", Arg::Text(meanings(call)))); // ours, however long
        found.push(match cure.take() {
            Some(edits) => finding.cured(Message::new("older-convert").text("cycles", of_calls(&older.calls)), edits),
            None => finding,
        });
        found.extend(missing(program, older, call));
    }
    found.extend(older.newer.iter().map(|(name, cycle)| {
        own::OLDER_NEW.finding().text("word", program.name(*name)).text("cycle", cycle.name).on(*name)
    }));
    found.extend(idle(older));
    for one in &older.assigned {
        if one.names.len() > 1 && one.open.is_empty() {
            found.push(both(program, older, one));
        }
        if one.number == FACTOR && !one.names.is_empty() {
            found.push(own::OLDER_FACTOR.finding().text("text", one.text(program)).on(one.word));
        }
        if !one.open.is_empty() {
            found.extend(questions(program, older, &answered, one));
        } else if one.names.is_empty() && !one.read {
            found.push(not_taken(program, older, one));
        }
    }
    for clash in &older.clashes {
        let Some(call) = older.calls.get(clash.call) else { continue };
        let later = clash.later(older);
        let sentence = if later.is_some() { &own::OLDER_CLASH_LATER } else { &own::OLDER_CLASH };
        let finding = sentence.finding().text("word", program.name(call.name)).text("name", clash.name);
        let finding = match later {
            Some(other) => finding.text("other", program.name(other.name)),
            None => finding,
        };
        found.push(finding.text("text", program.written(clash.place(program))).on(program.placed(call.name)));
    }
    for (number, place) in &older.results {
        found.push(own::OLDER_RESULT.finding().text("name", format!("R{number}")).on(*place));
    }
    for place in &older.unread {
        found.push(own::OLDER_UNREAD.finding().text("text", program.written(*place)).on(*place));
    }
    for place in &older.ways {
        found.push(own::OLDER_WAY.finding().text("text", program.written(*place)).on(*place));
    }
    if let Some(place) = older.unclear {
        found.push(own::OLDER_UNCLEAR.finding().text("text", program.written(place)).on(place));
    }
}

/// Answers to which there is no question.
fn idle(older: &Older) -> impl Iterator<Item = Diagnostic> {
    let idle = older.answers.iter().filter(|(number, _)| !older.answered.contains(number));
    idle.map(|(number, name)| own::OLDER_IDLE.finding().text("text", format!("R{number}={name}")))
}

/// That an assignment gets several names, since its calls take it as different parameters.
fn both(program: &Program, older: &Older, one: &Assigned) -> Diagnostic {
    let names: Vec<&str> = one.names.iter().map(|name| name.as_str()).collect();
    let finding = own::OLDER_BOTH.finding().text("text", one.text(program)).text("cycles", taken_by(older, one));
    finding.text("names", names.join(", ")).on(one.word)
}

/// Why an assignment goes: another R parameter is the setpoint, or the variant does not use it.
fn not_taken(program: &Program, older: &Older, one: &Assigned) -> Diagnostic {
    let calls = || one.calls.iter().filter_map(|at| older.calls.get(*at));
    let rival = calls().find_map(|call| call.instead.get(&one.number));
    let (sentence, cycles) = match rival {
        Some(_) => (&own::OLDER_OTHER, of_calls(calls().filter(|call| call.instead.contains_key(&one.number)))),
        None => (&own::OLDER_UNUSED, of_calls(calls())),
    };
    let finding = sentence.finding().text("text", one.text(program)).text("cycles", cycles).on(one.word);
    match rival {
        Some(rival) => finding.text("other", format!("R{rival}")),
        None => finding,
    }
}

/// Why words could not be read, and what the text calls and does not hold, for those to whom the findings of the
/// program are not told anyway.
pub fn reasons(program: &Program, programs: &Programs, older: &Older) -> Vec<Diagnostic> {
    let within = |error: &&SyntaxError| {
        let behind = older.unread.partition_point(|word| word.start <= error.span.start);
        let word = behind.checked_sub(1).and_then(|at| older.unread.get(at));
        word.is_some_and(|word| error.span.start <= word.end)
    };
    let mut found: Vec<Diagnostic> =
        program.errors.iter().filter(within).map(|error| not_understood(program, error)).collect();
    if !older.calls.is_empty() {
        outside(program, programs, older, &mut found);
    }
    found
}

/// R parameters to which nothing gives a value at a call of which one variant comes: their names, and the values on
/// delivery.
pub fn left_out(program: &Program, older: &Older, call: &Call) -> Vec<(u16, Name, f64)> {
    let variants = call.given.get(&VARIANT).into_iter().flatten().filter_map(|at| older.assigned.get(*at));
    let variants: Vec<&Assigned> = variants.collect();
    let [variant] = variants[..] else { return Vec::new() };
    let called = Called::of(call.cycle, number(program, variant.value, NOTHING));
    called.left_out(|number| call.given.contains_key(&number))
}

/// What the call gives no value to: on both controls the value of an earlier call counts (B:1696). The cure writes the
/// values on delivery behind the last assignment that reaches the call.
fn missing(program: &Program, older: &Older, call: &Call) -> Option<Diagnostic> {
    let of = |number: &u16| call.given.get(number).into_iter().flatten().filter_map(|at| older.assigned.get(*at));
    let left = left_out(program, older, call);
    let last = call.given.keys().flat_map(of).map(|one| one.word.end).filter(|end| *end <= call.word.start).max();
    let names: Vec<String> = left.iter().map(|(number, name, value)| format!("R{number} ({name}={value})")).collect();
    let values: Vec<String> = left.iter().map(|(number, _, value)| format!("R{number}={value}")).collect();
    let mut finding = own::OLDER_MISSING.finding().text("word", program.name(call.name)).on(program.placed(call.name));
    finding.message.args.push(("names", Arg::Text(names.join(", ")))); // ours, however long
    let found = (!left.is_empty()).then_some(finding)?;
    let Some(last) = last else { return Some(found) };
    let label = Message::new("older-complete").text("word", program.name(call.name));
    let written = vec![Edit::insert(last, format!(" {}", values.join(" ")))];
    Some(found.cured(label, separated(program, written)))
}

/// What each R parameter of a call is: `R23 = _MVAR, R19 = _ID / _SZA`; those that are nothing are told by themselves.
fn meanings(call: &Call) -> String {
    let named = |(number, names): (&u16, &BTreeSet<Name>)| {
        let mut names: Vec<&str> = names.iter().map(|name| name.as_str()).collect();
        names.sort_unstable();
        (!names.is_empty()).then(|| format!("R{number} = {}", names.join(" / ")))
    };
    call.names.iter().filter_map(named).collect::<Vec<_>>().join(", ")
}

/// The program with each answer that a question has, by R parameter and name.
type Answered = BTreeMap<(u16, Name), Older>;

fn answered(program: &Program, programs: &Programs, older: &Older) -> Answered {
    let asked = older.assigned.iter().flat_map(|one| one.open.iter().map(|name| (one.number, *name)));
    let with = |(number, name): (u16, Name)| {
        let mut answers: Answers = older.answers.clone();
        answers.insert(number, name);
        ((number, name), find(program, programs, &answers))
    };
    asked.collect::<BTreeSet<_>>().into_iter().map(with).collect()
}

/// The question at an assignment, once for each answer, which is its cure. Each answer is a sentence of its own, so
/// that all assignments can be answered alike.
fn questions(program: &Program, older: &Older, answered: &Answered, one: &Assigned) -> Vec<Diagnostic> {
    let other = |name: Name| match one.rival() {
        Some(rival) => format!("R{rival}"),
        None => {
            one.open.iter().filter(|other| **other != name).map(|name| name.as_str()).collect::<Vec<_>>().join(", ")
        }
    };
    let question = |name: &Name| {
        let finding = sentence(one, *name)?.finding().text("text", one.text(program));
        let finding = finding.text("cycles", open_for(older, one)).text("other", other(*name)).on(one.word);
        Some(match answered.get(&(one.number, *name)).map(|older| answer(program, older, one, *name)) {
            Some(Ok(cure)) => finding.cured(cure.label, cure.edits),
            Some(Err(reason)) => finding.hint(reason),
            None => finding,
        })
    };
    one.open.iter().filter_map(question).collect()
}

/// The sentence of an answer.
fn sentence(one: &Assigned, name: Name) -> Option<&'static Own> {
    static SENTENCES: [(Name, Own); 5] = [
        (names::ID, own::OLDER_ID),
        (names::SZA, own::OLDER_SZA),
        (names::MD, own::OLDER_MD),
        (names::RA, own::OLDER_RA),
        (names::RF, own::OLDER_RF),
    ];
    match one.rival() {
        Some(rival) if one.number < rival => Some(&own::OLDER_FIRST),
        Some(_) => Some(&own::OLDER_SECOND),
        None => SENTENCES.iter().find(|(known, _)| *known == name).map(|(_, sentence)| sentence),
    }
}

/// The cure of an answer, in the program that is answered so: the assignments with which it is decided, else the whole
/// program, which is what the answer gives in the terminal. Else the reason why there is none.
fn answer(program: &Program, older: &Older, one: &Assigned, name: Name) -> Result<Cure, Message> {
    let at = older.assigned.binary_search_by_key(&one.word.start, |other| other.word.start);
    let part = |key| Message::new(key).text("text", one.text(program));
    let open = || part("older-answer-part-hint");
    let now = at.ok().and_then(|at| older.assigned.get(at)).filter(|now| now.open.is_empty()).ok_or_else(open)?;
    let together = if one.rival().is_some() { together(older, now) } else { vec![now] };
    let concerned = |clash: &&Clash| together.iter().any(|one| one.calls.contains(&clash.call));
    if let Some(clash) = older.clashes.iter().find(concerned) {
        let word = older.calls.get(clash.call).map(|call| program.name(call.name)).unwrap_or_default();
        let hint = Message::new("older-answer-clash-hint").text("word", word).text("name", clash.name);
        return Err(hint.text("text", program.written(clash.place(program))));
    }
    // what is read elsewhere too stays as an R parameter, and would come to the call as one
    if together.iter().any(|one| one.read) {
        let label = Message::new("older-answer-whole").text("cycles", of_calls(&older.calls));
        let label = label.text("name", name).text("text", one.text(program));
        let whole = Some(edits(program, older)).filter(|edits| !edits.is_empty());
        return whole.map(|edits| Cure { label, edits }).ok_or_else(|| part("older-answer-later-hint"));
    }
    let (taken, spare): (Vec<&Assigned>, Vec<&Assigned>) = together.iter().partition(|one| !one.names.is_empty());
    let texts = |all: &[&Assigned]| all.iter().map(|one| one.text(program)).collect::<Vec<_>>().join(", ");
    let key = if spare.is_empty() { "older-answer" } else { "older-answer-without" };
    let label = Message::new(key).text("name", name).text("text", texts(&taken));
    let label = if spare.is_empty() { label } else { label.text("other", texts(&spare)) };
    let mut all: Vec<Edit> = taken.iter().flat_map(|one| named(program, one, one.names.iter().copied())).collect();
    all.extend(without(program, &spare.iter().map(|one| one.word).collect::<Vec<_>>()));
    Ok(Cure { label, edits: separated(program, all) })
}

/// The setpoints that have to be written at once: those of the same calls, and of the calls that these reach.
fn together<'a>(older: &'a Older, one: &'a Assigned) -> Vec<&'a Assigned> {
    let mut calls: BTreeSet<usize> = one.calls.iter().copied().collect();
    loop {
        let of_calls =
            |one: &&Assigned| SETPOINTS.contains(&one.number) && one.calls.iter().any(|call| calls.contains(call));
        let found: Vec<&Assigned> = older.assigned.iter().filter(of_calls).collect();
        let before = calls.len();
        calls.extend(found.iter().flat_map(|one| &one.calls));
        if calls.len() == before {
            return found;
        }
    }
}

/// The cycles that take an assignment.
fn taken_by(older: &Older, one: &Assigned) -> String {
    let calls = one.calls.iter().filter_map(|at| older.calls.get(*at));
    of_calls(calls.filter(|call| call.names.get(&one.number).is_some_and(|names| !names.is_empty())))
}

/// Those for which it is open what an assignment is.
fn open_for(older: &Older, one: &Assigned) -> String {
    let names = |call: &Call, number| call.names.get(&number).map_or(0, BTreeSet::len);
    let open = |call: &&Call| match one.rival() {
        Some(rival) => names(call, one.number) > 0 && names(call, rival) > 0,
        None => names(call, one.number) > 1,
    };
    of_calls(one.calls.iter().filter_map(|at| older.calls.get(*at)).filter(open))
}

/// Names of the cycles of calls, each once.
fn of_calls<'a>(calls: impl IntoIterator<Item = &'a Call>) -> String {
    let mut names: Vec<&str> = calls.into_iter().map(|call| call.cycle.name).collect();
    names.sort_unstable();
    names.dedup();
    names.join(", ")
}
