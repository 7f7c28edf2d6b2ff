//! `probewright lsp`: a server of the Language Server Protocol on standard input and output. It never changes a text:
//! it tells findings, explains, and offers edits that the client applies when the user says so.

mod act;
mod complete;
mod diagnose;
mod explain;
mod find;
mod foreign;
mod known;
mod outline;
mod paths;
mod rpc;
mod server;
mod settings;
mod text;

use crate::file::Problem;
use probewright_core::words::Words;
use rpc::Incoming;
use serde_json::Value;
use server::Server;
use std::collections::VecDeque;
use std::io::Write;
use std::process::ExitCode;
use std::sync::mpsc::{Receiver, channel};

/// Serves until the client says `exit` or is gone: 0 where it said `shutdown` before, as the protocol has it, else 1.
pub fn serve(words: Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let incoming = listen();
    let mut server = Server::new(words);
    let mut queue = VecDeque::new();
    while let Some(message) = next(&incoming, &mut queue, &mut server, out)? {
        match message {
            Incoming::Notification { method, .. } if method == "exit" => break,
            Incoming::Notification { method, params } => server.notified(&method, params),
            Incoming::Wrong { id, fault, why } => server.refuse(id, fault, &why),
            Incoming::Request { id, .. } if is_cancelled(&queue, &id) => server.cancelled(id),
            Incoming::Request { id, method, params } => server.asked(id, &method, params),
        }
        send(&mut server, out)?;
    }
    Ok(if server.is_ended() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Reads on a thread of its own, so that what comes during work is known before the next piece of it.
fn listen() -> Receiver<Incoming> {
    let (to, from) = channel();
    std::thread::spawn(move || {
        let mut input = std::io::stdin().lock();
        while let Some(message) = rpc::next(&mut input) {
            if to.send(message).is_err() {
                return;
            }
        }
    });
    from
}

/// The next message; while there is none the findings are told of what changed. None: the client is gone.
fn next(
    incoming: &Receiver<Incoming>,
    queue: &mut VecDeque<Incoming>,
    server: &mut Server,
    out: &mut dyn Write,
) -> std::io::Result<Option<Incoming>> {
    loop {
        queue.extend(incoming.try_iter());
        if let Some(message) = queue.pop_front() {
            return Ok(Some(message));
        }
        if !server.tell_one() {
            return Ok(incoming.recv().ok());
        }
        send(server, out)?;
    }
}

fn is_cancelled(queue: &VecDeque<Incoming>, wanted: &Value) -> bool {
    queue.iter().any(|message| match message {
        Incoming::Notification { method, params } => method == "$/cancelRequest" && params.get("id") == Some(wanted),
        _ => false,
    })
}

fn send(server: &mut Server, out: &mut dyn Write) -> std::io::Result<()> {
    server.sent().try_for_each(|message| rpc::write(out, &message))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::text::{Text, Units};
    use super::{paths, rpc};
    use lsp_types::{Position, Range, TextDocumentContentChangeEvent};
    use proptest::prelude::*;

    // oracle: hand (ü: 2 bytes and a unit, 𝛂: 4 bytes and two units)
    #[test]
    fn places_count_as_client_and_server_agreed() {
        let text = "N1 ;ü𝛂x\r\nN2\rN3\n";
        let wide = Text::new(text.to_owned(), Units::Utf16);
        let bytes = Text::new(text.to_owned(), Units::Utf8);
        assert_eq!(wide.byte(Position::new(0, 7)), 10);
        assert_eq!(bytes.byte(Position::new(0, 10)), 10);
        assert_eq!(wide.byte(Position::new(0, 6)), 6, "inside of a character: its begin");
        assert_eq!(bytes.byte(Position::new(0, 8)), 6);
        assert_eq!(wide.byte(Position::new(0, 99)), 11, "the end of the line");
        assert_eq!(wide.byte(Position::new(99, 0)), text.len());
        assert_eq!(wide.position(10), Position::new(0, 7));
        assert_eq!(bytes.position(10), Position::new(0, 10));
        assert_eq!(wide.position(13), Position::new(1, 0));
        assert_eq!(wide.position(16), Position::new(2, 0));
        assert_eq!(wide.range_of_units(7, 10), Range::new(Position::new(0, 7), Position::new(1, 0)));
    }

    // oracle: self (the text as a whole)
    #[test]
    fn changes_make_the_text_that_a_whole_one_is() {
        let piece = "[N1 ;\\r\\nü𝛂]{0,6}";
        let position = || (0..4_u32, 0..9_u32).prop_map(|(line, character)| Position::new(line, character));
        proptest!(|(text in piece, edits in proptest::collection::vec((position(), position(), piece), 0..9))| {
            for units in [Units::Utf16, Units::Utf8] {
                let mut edited = Text::new(text.clone(), units);
                for (one, other, insert) in &edits {
                    let range = Some(Range::new(*one.min(other), *one.max(other)));
                    let change = TextDocumentContentChangeEvent { range, range_length: None, text: insert.clone() };
                    edited = edited.changed(vec![change]);
                    let whole = Text::new(edited.as_str().to_owned(), units);
                    for (byte, _) in edited.as_str().char_indices() {
                        prop_assert_eq!(edited.position(byte), whole.position(byte));
                        let inside = edited.as_str().get(byte..).is_some_and(|rest| rest.starts_with('\n'));
                        let at = edited.byte(edited.position(byte));
                        prop_assert!(at == byte || (inside && at + 1 == byte), "{} {}", at, byte);
                    }
                }
            }
        });
    }

    // oracle: hand
    #[test]
    fn addresses_are_paths() {
        for (uri, path) in [
            ("file:///a/b%20c.mpf", Some("/a/b c.mpf")),
            ("file:///c%3A/parts/%C3%BC.mpf", Some("c:/parts/ü.mpf")),
            ("file://host/a", Some("/a")),
            ("untitled:Untitled-1", None),
        ] {
            let found = uri.parse().ok().and_then(|uri| paths::path(&uri));
            assert_eq!(found.as_deref(), path.map(std::path::Path::new), "{uri}");
        }
        let made = paths::uri(std::path::Path::new("/a/ü 1.mpf")).unwrap();
        assert_eq!(made.as_str(), "file:///a/%C3%BC%201.mpf");
    }

    // oracle: hand
    #[test]
    fn what_is_malformed_leaves_the_next_message() {
        let good = r#"{"jsonrpc":"2.0","id":1,"method":"a"}"#;
        for bad in [
            "nonsense\r\n\r\n",
            "Content-Length: x\r\n\r\n",
            "Content-Length: 3\r\n\r\n{\"a",
            "Content-Length: 2\r\n\r\n[]",
        ] {
            let text = format!("{bad}Content-Length: {}\r\n\r\n{good}", good.len());
            let mut input = text.as_bytes();
            let first = rpc::next(&mut input).unwrap();
            assert!(matches!(first, rpc::Incoming::Wrong { .. }), "{bad}: {first:?}");
            let second = rpc::next(&mut input).unwrap();
            assert!(matches!(second, rpc::Incoming::Request { .. }), "{bad}: {second:?}");
            assert!(rpc::next(&mut input).is_none());
        }
    }
}
