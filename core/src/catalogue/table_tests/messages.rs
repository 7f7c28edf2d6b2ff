//! Texts for the operator against their table.

use crate::catalogue::operator_messages::{MESSAGES, Sender, shown_by};
use crate::test_data::{data, rows};
use std::collections::BTreeSet;

#[test]
fn texts_for_the_operator_are_those_of_the_table() {
    // oracle: manual, tests/data/operator_messages.tsv
    let rows = rows(data!("operator_messages.tsv"));
    let table: BTreeSet<[&str; 3]> = rows.iter().map(|row| [row[0], row[1], row[3]]).collect();
    let sender = |sender: Sender| match sender {
        Sender::Program(name) => name,
        Sender::EveryCycle => "measuring cycles",
        Sender::Jog => "measuring in JOG",
    };
    let ours: BTreeSet<[&str; 3]> = MESSAGES.iter().map(|one| [one.text, sender(one.sender), one.source]).collect();
    assert_eq!(ours, table);
    for row in rows {
        let message = MESSAGES.iter().find(|one| one.text == row[0]).unwrap();
        assert_eq!(message.waits, row[2] == "yes", "{row:?}");
        assert!(!shown_by(message).is_empty());
    }
}
