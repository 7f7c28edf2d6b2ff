//! CYCLE198 and CYCLE199 with lines of the user for chosen cycles.

use super::{Error, cycle};
use crate::dialect::Dialect;
use crate::entry::{Cycle, Typed};
use crate::manual::Cited;
use crate::message::Message;
use crate::program::user_programs::skeleton::{Branch, END, calls_again, changed, is_taken, labels, leaves};
use crate::program::user_programs::skeleton::{lines, unread, write};
use crate::program::user_programs::{BEFORE, BEHIND, callers, label};
use crate::refused::Path;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// Which cycles get lines of their own.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct UserProgramsRequest {
    /// The cycles that were chosen.
    pub branches: Vec<UserBranch>,
    /// Variable of the CASE in the delivered file; absent: lines to insert are written.
    pub variable: Option<String>,
    /// Words by key, for comments: of `user-program-before-line` and `user-program-behind-line` for each cycle.
    pub words: Option<Typed>,
}

/// Lines of a cycle.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct UserBranch {
    /// The cycle.
    pub cycle: String,
    /// Lines before its measurement.
    pub before: String,
    /// Lines behind it.
    pub behind: String,
}

/// The two programs.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct UserProgramsView {
    /// Cycles that can be chosen.
    pub labels: Vec<UserLabel>,
    /// CYCLE198; empty: nothing is chosen.
    pub before: String,
    /// CYCLE199.
    pub behind: String,
    /// What should be known beside them.
    pub notes: Vec<Message>,
    /// Places in the manual.
    pub sources: [Cited; 2],
}

/// A cycle that can be chosen.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct UserLabel {
    /// The cycle.
    pub cycle: &'static str,
    /// Stem of its messages.
    pub key: &'static str,
    /// Label of its lines.
    pub label: String,
}

/// The two programs with the chosen branches.
///
/// # Errors
/// A cycle that calls neither or is chosen twice, a line that cannot stand there, or no name of a variable.
pub fn user_programs(asked: UserProgramsRequest) -> Result<UserProgramsView, Error> {
    let variable = asked.variable.as_deref().map(str::trim).filter(|name| !name.is_empty());
    if let Some(name) = variable.filter(|name| !is_variable(name)) {
        return Err(Error::new("user-program-variable", Path::of(&["variable"])).text("name", name));
    }
    let branches = asked.branches.iter().map(|one| branch(one, variable.is_some())).collect::<Result<Vec<_>, _>>()?;
    let once = |(at, one): &(usize, &Branch)| branches.iter().take(*at).all(|other| other.cycle.name != one.cycle.name);
    if let Some((_, twice)) = branches.iter().enumerate().find(|one| !once(one)) {
        return Err(Error::new("user-program-twice", Path::of(&["branches"])).text("name", twice.cycle.name));
    }
    let said = |key: &str, cycle: &Cycle| {
        let known = asked.words.as_ref().and_then(|words| words.get(key));
        known.map_or_else(|| cycle.name.to_owned(), |text| text.replace(CYCLE, cycle.name))
    };
    let mut notes = Vec::new();
    if !branches.is_empty() {
        notes.push(Message::new(if variable.is_some() { "user-program-own" } else { "user-program-insert" }));
    }
    let mut targets: Vec<String> = branches.iter().map(|branch| label(branch.cycle)).collect();
    targets.extend(variable.map(|_| END.to_owned()));
    for note in branches.iter().flat_map(|branch| doubts(branch, &targets)).chain(repeated(&branches)) {
        if !notes.contains(&note) {
            notes.push(note);
        }
    }
    let text = |user| if branches.is_empty() { String::new() } else { write(user, &branches, variable, &said) };
    let of = |cycle: &'static Cycle| UserLabel { cycle: cycle.name, key: cycle.key, label: label(cycle) };
    Ok(UserProgramsView {
        labels: callers().map(of).collect(),
        before: text(&BEFORE),
        behind: text(&BEHIND),
        notes,
        sources: [BEFORE.source, BEHIND.source].map(Cited),
    })
}

/// What lines do that they should not: cannot be read, write parameters of their cycle, jump to where no label is.
fn doubts(branch: &Branch, labels: &[String]) -> Vec<Message> {
    let changed = changed(branch.cycle, &branch.before).into_iter();
    let changes = changed.map(|name| Message::new("user-program-changes").text("name", name));
    let both = [&branch.before, &branch.behind];
    let unread = both.into_iter().flat_map(|lines| unread(lines));
    let unread = unread.map(|line| Message::new("user-program-unread").text("line", line));
    let left = both.into_iter().flat_map(|lines| leaves(lines, labels));
    unread.chain(changes).chain(left.map(|name| Message::new("user-program-jump").text("name", name))).collect()
}

/// Labels that the lines of more than one cycle have: in one file they would be there more than once.
fn repeated(branches: &[Branch]) -> Vec<Message> {
    let sides: [fn(&Branch) -> &Vec<String>; 2] = [|branch| &branch.before, |branch| &branch.behind];
    let of_side = sides.iter().flat_map(|side| {
        let mut seen = BTreeSet::new();
        let all = branches.iter().flat_map(|branch| labels(side(branch)));
        all.filter(|name| !seen.insert(name.clone())).collect::<Vec<_>>()
    });
    of_side.map(|name| Message::new("user-program-repeated").text("name", name)).collect()
}

/// Stands in the words of a comment for the name of the cycle.
pub const CYCLE: &str = "CYCLE";

fn branch(asked: &UserBranch, whole: bool) -> Result<Branch, Error> {
    let cycle = cycle(Dialect::Sinumerik, &asked.cycle)?;
    if !cycle.is_measuring_cycle() {
        return Err(Error::new("user-program-cycle", Path::of(&["branches"])).text("name", cycle.name));
    }
    let wrong = |key: &'static str| Error::new(key, Path::of(&["branches"]));
    let read = |text: &str| {
        let lines = lines(text).map_err(|line| wrong("user-program-line").text("line", line))?;
        if let Some(name) = calls_again(&lines) {
            return Err(wrong("user-program-again").text("name", name));
        }
        match labels(&lines).into_iter().find(|name| is_taken(name, whole)) {
            Some(name) => Err(wrong("user-program-label").text("name", name)),
            None => Ok(lines),
        }
    };
    Ok(Branch { cycle, before: read(&asked.before)?, behind: read(&asked.behind)? })
}

/// Whether it may be the name of a variable, with an index or without.
fn is_variable(name: &str) -> bool {
    let index = |c: char| c.is_ascii_alphanumeric() || "_[],$".contains(c);
    let begins = name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_' || c == '$');
    begins && name.len() <= 32 && name.chars().all(index)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn asked(cycle: &str, before: &str, variable: Option<&str>) -> UserProgramsRequest {
        let branch = UserBranch { cycle: cycle.into(), before: before.into(), behind: "M28".into() };
        UserProgramsRequest { branches: vec![branch], variable: variable.map(str::to_owned), words: None }
    }

    #[test]
    fn what_is_chosen_is_written() {
        // oracle: manual B:2482-2508
        let view = user_programs(asked("CYCLE977", "M27", None)).unwrap();
        assert_eq!(view.before, "_M977: ;CYCLE977\nM27\nM17\n");
        assert_eq!(view.behind, "_M977: ;CYCLE977\nM28\nM17\n");
        assert!(view.labels.iter().any(|one| one.label == "_M998"));
        let told = serde_json::to_value(&view).unwrap();
        assert!(told["sources"][0].as_str().unwrap().starts_with("Measuring Cycles 04/2006, "), "{told}");
        let nothing = user_programs(UserProgramsRequest::default()).unwrap();
        assert_eq!((nothing.before.as_str(), nothing.notes.len()), ("", 0));
        let whole = user_programs(asked("CYCLE977", "_SETVAL=1", Some("_OVI[2]"))).unwrap();
        assert!(whole.before.contains("CASE _OVI[2] OF 977 GOTOF _M977"), "{}", whole.before);
        let keys: Vec<_> = whole.notes.iter().map(|note| note.key.as_ref()).collect();
        assert_eq!(keys, ["user-program-own", "user-program-changes"]);
    }

    #[test]
    fn what_cannot_be_is_refused() {
        // oracle: hand
        let refused = |request| user_programs(request).unwrap_err().message.key.to_string();
        assert_eq!(refused(asked("CYCLE977", "M17", None)), "user-program-line");
        for again in ["CYCLE977", "CYCLE978", "CYCLE198", "CALL \"CYCLE977\""] {
            assert_eq!(refused(asked("CYCLE977", again, None)), "user-program-again");
        }
        assert_eq!(refused(asked("CYCLE977", "DEF INT X", None)), "user-program-line");
        assert_eq!(refused(asked("CYCLE977", "_M977: M27", None)), "user-program-label");
        let mut twice = asked("CYCLE977", "M27", None);
        twice.branches.push(UserBranch { cycle: "cycle977".into(), before: "M29".into(), behind: String::new() });
        assert!(["user-program-twice", "document-cycle"].contains(&refused(twice.clone()).as_str()));
        twice.branches[1].cycle = "CYCLE977".into();
        assert_eq!(refused(twice), "user-program-twice");
        let told = |before: &str, variable| {
            let notes = user_programs(asked("CYCLE977", before, variable)).unwrap().notes.into_iter();
            notes.map(|note| note.key.to_string()).collect::<Vec<_>>()
        };
        assert_eq!(told("GOTOF ABC", None), ["user-program-insert", "user-program-jump"]);
        assert_eq!(told("GOTOF _MEND", Some("_OVI[2]")), ["user-program-own"]);
        assert_eq!(told(")(", None), ["user-program-insert", "user-program-unread"]);
        assert_eq!(told("_MVAR=2", None), ["user-program-insert", "user-program-changes"]);
        let mut several = asked("CYCLE977", "AGAIN: M27|GOTOB AGAIN", None);
        several.branches.push(UserBranch { cycle: "CYCLE978".into(), ..several.branches[0].clone() });
        let notes = user_programs(several).unwrap().notes;
        assert_eq!(notes.iter().filter(|note| note.key == "user-program-repeated").count(), 1);
        assert_eq!(told("AGAIN: M27|GOTOB AGAIN", None), ["user-program-insert"]);
        assert_eq!(refused(asked("CYCLE116", "M27", None)), "user-program-cycle");
        assert_eq!(refused(asked("CYCLE5", "M27", None)), "document-cycle");
        assert_eq!(refused(asked("CYCLE977", "M27", Some("1 OR"))), "user-program-variable");
    }
}
