//! JSON-RPC as the Language Server Protocol frames it: a header with the length, then the message. What is malformed is
//! an item of its own, so that it is answered and the next message is read.

use probewright_core::message::Message;
use serde_json::{Value, json};
use std::io::{BufRead, Read, Write};

/// Largest message that is read, bytes: a program of 100 MB with every character escaped.
const LARGEST: u64 = 1 << 30;
/// Longest line of a header, bytes.
const LONGEST_LINE: u64 = 4096;

/// What is wrong with a message, with its number in the protocol.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// No JSON.
    Parse = -32700,
    /// JSON, but not a message, or not now.
    Request = -32600,
    /// The server has no such method.
    Method = -32601,
    /// The parameters have another shape.
    Parameters = -32602,
    /// `initialize` has not come.
    Early = -32002,
    /// The client does not want it any more.
    Cancelled = -32800,
}

/// What comes from the client.
#[derive(Debug)]
pub enum Incoming {
    /// Wants an answer.
    Request { id: Value, method: String, params: Value },
    /// Wants none.
    Notification { method: String, params: Value },
    /// Cannot be understood.
    Wrong { id: Value, fault: Fault, why: Message },
}

/// The next message; none: the client is gone. Answers to requests of the server are left out, since it has none.
pub fn next(from: &mut dyn BufRead) -> Option<Incoming> {
    loop {
        let wrong = |fault, why| Some(Incoming::Wrong { id: Value::Null, fault, why });
        let length = match header(from)? {
            Some(length) if length <= LARGEST => length,
            Some(length) => {
                std::io::copy(&mut from.take(length), &mut std::io::sink()).ok()?;
                let most = (LARGEST >> 20) as f64;
                return wrong(Fault::Request, Message::new("terminal-large").number("most", most));
            }
            None => return wrong(Fault::Request, Message::new("server-length")),
        };
        let mut body = Vec::new();
        from.take(length).read_to_end(&mut body).ok()?;
        if (body.len() as u64) < length {
            return None;
        }
        match serde_json::from_slice(&body) {
            Err(_) => return wrong(Fault::Parse, Message::new("server-malformed")),
            Ok(message) => {
                if let Some(message) = understood(message) {
                    return Some(message);
                }
            }
        }
    }
}

/// Length of the message behind a header; `Some(None)`: the header has none. Lines that say something else are skipped.
fn header(from: &mut dyn BufRead) -> Option<Option<u64>> {
    let mut length = None;
    let mut any = false;
    loop {
        let mut line = Vec::new();
        if from.take(LONGEST_LINE).read_until(b'\n', &mut line).ok()? == 0 {
            return None;
        }
        let line = String::from_utf8_lossy(&line);
        let line = line.trim();
        match line.split_once(':') {
            _ if line.is_empty() && any => return Some(length),
            _ if line.is_empty() => {}
            Some((name, value)) if name.eq_ignore_ascii_case("Content-Length") => length = value.trim().parse().ok(),
            _ => {}
        }
        any |= !line.is_empty();
    }
}

/// A message by what it has; none: the answer to a request.
fn understood(message: Value) -> Option<Incoming> {
    let malformed = |id| Some(Incoming::Wrong { id, fault: Fault::Request, why: Message::new("server-malformed") });
    let Value::Object(mut members) = message else { return malformed(Value::Null) };
    let id = members.remove("id");
    let params = members.remove("params").unwrap_or_default();
    match (members.remove("method"), id) {
        (Some(Value::String(method)), None) => Some(Incoming::Notification { method, params }),
        (Some(Value::String(method)), Some(id)) if id.is_string() || id.is_number() => {
            Some(Incoming::Request { id, method, params })
        }
        (None, Some(_)) if members.contains_key("result") || members.contains_key("error") => None,
        (_, Some(id)) if id.is_string() || id.is_number() => malformed(id),
        _ => malformed(Value::Null),
    }
}

/// Writes a message with its header.
pub fn write(to: &mut dyn Write, message: &Value) -> std::io::Result<()> {
    let text = message.to_string();
    write!(to, "Content-Length: {}\r\n\r\n{text}", text.len())?;
    to.flush()
}

/// The answer to a request.
pub fn answer(id: Value, result: Value) -> Value {
    json!({ "jsonrpc": "2.0", "id": id, "result": result })
}

/// A request that has no answer.
pub fn refusal(id: Value, fault: Fault, text: &str) -> Value {
    json!({ "jsonrpc": "2.0", "id": id, "error": { "code": fault as i32, "message": text } })
}

/// Something that the client is told.
pub fn notification(method: &str, params: Value) -> Value {
    json!({ "jsonrpc": "2.0", "method": method, "params": params })
}
