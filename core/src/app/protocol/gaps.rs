//! Files of a log that are missing among those that are read: a log that goes on has `_1` to `_9` behind its name
//! (B:11194-11200).

use crate::message::Message;
use std::collections::BTreeSet;

/// Most files that follow the first one.
const MOST: usize = 9;

/// Says which file is missing before the last one that is there. `log`: names of the files that the program leaves, the
/// first one without a number; files with other names say nothing.
pub fn gap<'a>(names: &[String], log: impl Iterator<Item = &'a str>) -> Option<Message> {
    let first = log.map(stem).min_by_key(String::len)?;
    let name = |number: usize| if number == 0 { first.clone() } else { format!("{first}_{number}") };
    let given: BTreeSet<String> = names.iter().map(|name| stem(name)).collect();
    let last = (0..=MOST).rev().find(|number| given.contains(&name(*number)))?;
    let missing = (0..last).find(|number| !given.contains(&name(*number)))?;
    Some(Message::new("protocol-gap").text("name", name(missing)))
}

/// A name without folder and ending, in upper case.
fn stem(name: &str) -> String {
    let name = name.rsplit(['/', '\\']).next().unwrap_or_default();
    name.rsplit_once('.').map_or(name, |(stem, _)| stem).to_ascii_uppercase()
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: manual B:11194-11200 (LOG_1, LOG_1_1 to LOG_1_9), hand
    #[test]
    fn a_missing_file_of_a_log_is_named() {
        let of = |names: &[&str]| {
            let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
            let found = gap(&names, ["LOG_1.MPF", "LOG_1_1.MPF"].into_iter());
            found.map(|message| message.word("name").unwrap_or_default().to_owned())
        };
        for whole in [&["LOG_1.MPF"][..], &["log_1_1.mpf", "a/LOG_1.MPF"], &["measured.csv"], &[]] {
            assert_eq!(of(whole), None, "{whole:?}");
        }
        assert_eq!(of(&["LOG_1_8.MPF"]).as_deref(), Some("LOG_1"));
        assert_eq!(of(&["LOG_1.MPF", "LOG_1_2.MPF"]).as_deref(), Some("LOG_1_1"));
    }
}
