//! What no client should send, and what comes of it.

use crate::HOLE;
use crate::client::{Client, place};
use serde_json::{Value, json};

const URI: &str = "file:///parts/hostile.mpf";

// oracle: manual of the protocol (JSON-RPC 2.0: -32700, -32600, -32601, -32602; LSP: -32002)
#[test]
fn what_is_malformed_is_answered() {
    let mut client = Client::start();
    let mut code = |bytes: &[u8]| {
        client.raw(bytes);
        client.receive()["error"]["code"].as_i64().unwrap()
    };
    let framed = |text: &str| format!("Content-Length: {}\r\n\r\n{text}", text.len()).into_bytes();
    assert_eq!(code(b"nonsense\r\n\r\n"), -32600);
    assert_eq!(code(b"Content-Length: many\r\n\r\n"), -32600);
    assert_eq!(code(&framed("{")), -32700);
    assert_eq!(code(&framed("\u{fffd}")), -32700);
    assert_eq!(code(b"Content-Length: 2\r\n\r\n\xff\xff"), -32700);
    assert_eq!(code(&framed("[]")), -32600);
    assert_eq!(code(&framed(r#"{"id":1,"method":7}"#)), -32600);
    assert_eq!(code(&framed(&"[".repeat(100_000))), -32700);
    assert_eq!(code(&framed(r#"{"id":1,"method":"textDocument/hover"}"#)), -32002, "before the session");
    assert_eq!(client.answer("initialize", json!([1]))["error"]["code"], -32602);
    client.ask("initialize", json!({ "capabilities": {} }));
    assert_eq!(client.answer("initialize", json!({ "capabilities": {} }))["error"]["code"], -32600);
    assert_eq!(client.answer("textDocument/formatting", json!({}))["error"]["code"], -32601, "formatting never");
    assert_eq!(client.answer("textDocument/hover", json!({ "position": "here" }))["error"]["code"], -32602);
    client.tell("textDocument/didOpen", json!(7));
    assert_eq!(client.receive()["method"], "window/showMessage");
    client.ask("shutdown", Value::Null);
    assert_eq!(client.answer("textDocument/hover", json!({}))["error"]["code"], -32600, "after the session");
    client.tell("exit", Value::Null);
    assert!(client.vanish().success());
}

// oracle: manual of the protocol (exit: 0 after shutdown, else 1)
#[test]
fn a_client_that_goes_without_a_word_leaves_nothing_running() {
    assert_eq!(Client::english().vanish().code(), Some(1));
    let mut client = Client::english();
    client.tell("exit", Value::Null);
    assert_eq!(client.vanish().code(), Some(1));
    assert_eq!(Client::english().end().code(), Some(0));
}

// oracle: self (every answer comes, none is an error)
#[test]
fn places_that_are_not_there_have_answers() {
    let mut client = Client::english();
    let methods = ["hover", "completion", "definition", "references", "codeAction", "documentSymbol"];
    for text in
        ["", "\u{feff}", "%", "_MVAR=", "CYCLE977(", "\r\r\n\n", "O0110\nG102", "_KNUM=99999999999999999999\nCYCLE977"]
    {
        client.open(URI, text);
        for (line, character) in [(0, 0), (0, 3), (1, 2), (7, 7), (u32::MAX, u32::MAX)] {
            let at = json!({ "line": line, "character": character });
            for method in methods {
                let params = json!({ "textDocument": { "uri": URI }, "position": at,
                    "range": { "start": at, "end": { "line": 0, "character": 0 } },
                    "context": { "diagnostics": [], "includeDeclaration": true } });
                client.ask(&format!("textDocument/{method}"), params);
            }
        }
        client.tell("textDocument/didClose", json!({ "textDocument": { "uri": URI } }));
    }
    let unknown = json!({ "textDocument": { "uri": "untitled:none" }, "position": { "line": 0, "character": 0 } });
    assert!(client.ask("textDocument/hover", unknown).is_null());
    let range = json!({ "start": { "line": 5, "character": 0 }, "end": { "line": 0, "character": 0 } });
    let backwards = json!({ "range": range, "text": "X" });
    client.open(URI, HOLE);
    client.tell(
        "textDocument/didChange",
        json!({ "textDocument": { "uri": URI, "version": 2 }, "contentChanges": [backwards] }),
    );
    client.findings(URI, 2);
    assert!(client.end().success());
}

// oracle: manual of the protocol (-32800: the request was cancelled)
#[test]
fn a_request_that_nobody_wants_any_more_is_left_out() {
    let mut client = Client::english();
    client.open(URI, HOLE);
    let position = place(HOLE, "CYCLE977", 1);
    let hover = json!({ "jsonrpc": "2.0", "id": "x", "method": "textDocument/hover",
        "params": { "textDocument": { "uri": URI }, "position": position } });
    let cancel = json!({ "jsonrpc": "2.0", "method": "$/cancelRequest", "params": { "id": "x" } });
    let framed = |message: &Value| format!("Content-Length: {}\r\n\r\n{message}", message.to_string().len());
    client.raw((framed(&hover) + &framed(&cancel)).as_bytes());
    let answer = client.receive();
    // whether it came in time is up to the system; an answer it has in any case
    assert_eq!(answer["id"], "x");
    assert!(answer["error"]["code"] == -32800 || answer["result"]["contents"].is_object(), "{answer}");
}
