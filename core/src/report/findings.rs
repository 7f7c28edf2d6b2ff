//! Findings of ours, `PW135`, as a person reads them who saw the number: every sentence that comes under it, from the
//! same words as the finding itself.

use crate::message::Message;
use crate::words::Words;
use crate::{own, problem};

/// What a finding means and what helps, for each sentence that it may say. Empty: there is none of this name.
pub fn finding(asked: &str, words: &Words) -> String {
    let own = asked.split_at_checked(2).filter(|(sort, _)| sort.eq_ignore_ascii_case("PW"));
    let Some(number) = own.and_then(|(_, digits)| digits.parse().ok()) else { return String::new() };
    let told = said(number).into_iter().map(|(cause, cure)| {
        let cure = match cure {
            "" => String::new(),
            key => format!("  {}\n", sentence(key, words)),
        };
        format!("PW{number:03}: {}\n{cure}", sentence(cause, words))
    });
    told.collect()
}

/// What may be said under a number, and what helps; that is empty where the sentence says it.
fn said(number: u16) -> Vec<(&'static str, &'static str)> {
    let ours = own::ALL.iter().filter(|one| one.number == number);
    let ours = ours.map(|one| (one.cause, one.hint));
    let of_run = number.checked_sub(problem::FIRST).and_then(|at| problem::KEYS.get(usize::from(at)));
    let of_run = of_run.map(|key| (*key, problem::cure(key).unwrap_or_default()));
    ours.chain(of_run).collect()
}

/// A sentence with `…` where it names what it found.
fn sentence(key: &'static str, words: &Words) -> String {
    let text = words.text(&Message::new(key));
    let mut parts = text.split("{$");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |told, part| {
        let rest = part.split_once('}').map_or("", |(_, rest)| rest);
        told + "…" + rest
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::words::LANGUAGES;

    // oracle: self (the table of the sentences against the words)
    #[test]
    fn every_finding_has_words_in_every_language() {
        for language in LANGUAGES {
            let words = Words::of(language.code).unwrap();
            let keys = own::ALL.iter().flat_map(|one| [one.cause, one.hint]);
            for key in keys.filter(|key| !key.is_empty()) {
                let found = words.find(&Message::new(key));
                assert!(found.is_some(), "{}: {key}", language.code);
            }
        }
    }
}
