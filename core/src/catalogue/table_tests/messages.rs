//! Texts for the operator against their table.

use super::common_rows;
use crate::catalogue::operator_messages::{MESSAGES, Sender, shown_by};
use std::collections::BTreeSet;

#[test]
fn texts_for_the_operator_are_those_of_the_table() {
    // oracle: manual, spec/common/messages.tsv. Rows in brackets have no text; those of the test programs of chapter 10
    // are texts of a program, not of the cycles.
    let rows = common_rows("messages.tsv");
    if rows.is_empty() {
        return;
    }
    let own = |row: &&Vec<String>| !row[0].starts_with('(') && !row[1].contains("program");
    let table: BTreeSet<[&str; 3]> =
        rows.iter().filter(own).map(|row| [row[0].as_str(), row[1].as_str(), row[4].as_str()]).collect();
    let sender = |sender: Sender| match sender {
        Sender::Program(name) => name,
        Sender::EveryCycle => "measuring cycles",
        Sender::Jog => "measuring in JOG",
    };
    let ours: BTreeSet<[&str; 3]> = MESSAGES.iter().map(|one| [one.text, sender(one.sender), one.source]).collect();
    assert_eq!(ours, table);
    for row in rows.iter().filter(own) {
        let message = MESSAGES.iter().find(|one| one.text == row[0]).unwrap();
        let words = ["halt", "M0", "NC START"];
        let waits = words.iter().any(|word| row[3].contains(word));
        assert_eq!(message.waits, waits, "{row:?}");
        assert!(!shown_by(message).is_empty());
    }
}
