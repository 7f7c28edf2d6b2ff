//! Changes of an open text come to what the text as a whole comes to.

use crate::HOLE;
use crate::client::{Client, able};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use serde_json::{Value, json};

const URI: &str = "file:///parts/edited.mpf";
const PIECES: &[&str] = &["_KNUM=2001", "Maß ü𝛂", "\nCYCLE977\n", "_MVAR=1,5 ", ";", "\nM30\n", ""];

/// Applies a change as a client does that counts UTF-16 units.
fn changed(text: &str, start: usize, end: usize, insert: &str) -> (Value, String) {
    let position = |at: usize| {
        let line = text[..at].rfind('\n').map_or(0, |end| end + 1);
        json!({ "line": text[..at].matches('\n').count(), "character": text[line..at].encode_utf16().count() })
    };
    let change = json!({ "range": { "start": position(start), "end": position(end) }, "text": insert });
    let mut after = text.to_owned();
    after.replace_range(start..end, insert);
    (change, after)
}

// oracle: self (the same text opened as a whole)
#[test]
fn random_edits_are_a_whole_text() {
    let edit = (any::<prop::sample::Index>(), 0..12_usize, prop::sample::select(PIECES));
    let mut runner = TestRunner::new(ProptestConfig { cases: 12, ..ProptestConfig::default() });
    let done = runner.run(&prop::collection::vec(edit, 1..8), |edits| {
        let mut client = Client::session(able(), "en", Value::Null);
        let mut text = format!("; Größe 𝛂\n{HOLE}").replace("\nN90", "\r\nN90");
        client.open(URI, &text);
        let mut changes = Vec::new();
        for (at, length, insert) in edits {
            // between the two characters of a line end no client puts anything
            let edge = |at: &usize| text.is_char_boundary(*at) && !text[*at..].starts_with('\n');
            let places: Vec<usize> = (0..=text.len()).filter(edge).collect();
            let start = at.index(places.len());
            let end = (start + length).min(places.len() - 1);
            let (change, after) = changed(&text, places[start], places[end], insert);
            changes.push(change);
            text = after;
        }
        let document = json!({ "uri": URI, "version": 2 });
        client.tell("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
        let edited = client.findings(URI, 2);
        client.tell("textDocument/didClose", json!({ "textDocument": { "uri": URI } }));
        prop_assert_eq!(client.open(URI, &text), edited);
        Ok(())
    });
    done.unwrap();
}

// oracle: hand (the protocol: UTF-8 where the client offers it)
#[test]
fn a_client_that_counts_bytes_gets_bytes() {
    let text = "N10 ; ü\nN20 MSG(\"ü\") R1=1,5\n";
    for (offered, comma) in [(json!(["utf-8", "utf-16"]), 18), (json!(["utf-16"]), 17)] {
        let can = json!({ "general": { "positionEncodings": offered } });
        let mut client = Client::session(can, "en", Value::Null);
        let found = client.open(URI, text);
        assert_eq!(found.len(), 1, "{found:?}");
        assert_eq!(found[0]["range"]["start"], json!({ "line": 1, "character": comma }));
        let hover = json!({ "textDocument": { "uri": URI }, "position": { "line": 99, "character": 99 } });
        assert!(client.ask("textDocument/hover", hover).is_null());
    }
}
