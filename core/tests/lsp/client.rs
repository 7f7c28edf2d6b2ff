//! A client: sends and receives messages, and finds places by their text.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, ExitStatus, Stdio};

/// A session with the server.
pub struct Client {
    process: Child,
    input: Option<ChildStdin>,
    output: BufReader<ChildStdout>,
    number: i64,
    /// What the server said beside its answers.
    pub told: Vec<Value>,
}

/// What a client of today says that it can.
pub fn able() -> Value {
    json!({
        "general": { "positionEncodings": ["utf-16"] },
        "textDocument": {
            "hover": { "contentFormat": ["markdown", "plaintext"] },
            "documentSymbol": { "hierarchicalDocumentSymbolSupport": true },
        },
        "workspace": { "workspaceEdit": { "documentChanges": true } },
    })
}

impl Client {
    /// Starts the server, without a session.
    pub fn start() -> Client {
        let mut process = Command::new(env!("CARGO_BIN_EXE_probewright"))
            .env("LC_ALL", "C")
            .arg("lsp")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let input = process.stdin.take();
        let output = BufReader::new(process.stdout.take().unwrap());
        Client { process, input, output, number: 0, told: Vec::new() }
    }

    /// A session of a client that can this, in a language, with options.
    pub fn session(can: Value, locale: &str, options: Value) -> Client {
        let mut client = Client::start();
        let begun = client.ask(
            "initialize",
            json!({ "processId": null, "rootUri": null, "capabilities": can, "locale": locale,
                "initializationOptions": options }),
        );
        assert!(begun["capabilities"]["hoverProvider"] == true, "{begun}");
        client.tell("initialized", json!({}));
        client
    }

    /// A session in English.
    pub fn english() -> Client {
        Client::session(able(), "en", Value::Null)
    }

    /// Sends bytes as they are.
    pub fn raw(&mut self, bytes: &[u8]) {
        let input = self.input.as_mut().unwrap();
        input.write_all(bytes).unwrap();
        input.flush().unwrap();
    }

    pub fn send(&mut self, message: &Value) {
        let text = message.to_string();
        self.raw(format!("Content-Length: {}\r\n\r\n{text}", text.len()).as_bytes());
    }

    pub fn tell(&mut self, method: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// The next message of the server.
    pub fn receive(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            assert!(self.output.read_line(&mut line).unwrap() > 0, "the server is gone");
            match line.trim().split_once(": ") {
                Some(("Content-Length", value)) => length = value.parse().unwrap(),
                _ => break,
            }
        }
        let mut body = vec![0; length];
        self.output.read_exact(&mut body).unwrap();
        serde_json::from_slice(&body).unwrap()
    }

    /// The whole answer to a request.
    pub fn answer(&mut self, method: &str, params: Value) -> Value {
        self.number += 1;
        let id = self.number;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        loop {
            let message = self.receive();
            if message["id"] == id {
                return message;
            }
            self.told.push(message);
        }
    }

    /// The result of a request.
    pub fn ask(&mut self, method: &str, params: Value) -> Value {
        let answer = self.answer(method, params);
        assert!(answer.get("error").is_none(), "{method}: {answer}");
        answer["result"].clone()
    }

    /// Opens a text; its findings.
    pub fn open(&mut self, uri: &str, text: &str) -> Vec<Value> {
        let document = json!({ "uri": uri, "languageId": "sinumerik", "version": 1, "text": text });
        self.tell("textDocument/didOpen", json!({ "textDocument": document }));
        self.findings(uri, 1)
    }

    /// The findings of a version of a text.
    pub fn findings(&mut self, uri: &str, version: i64) -> Vec<Value> {
        loop {
            let message = self.receive();
            let params = &message["params"];
            if message["method"] == "textDocument/publishDiagnostics"
                && params["uri"] == uri
                && params["version"] == version
            {
                return params["diagnostics"].as_array().unwrap().clone();
            }
            self.told.push(message);
        }
    }

    /// Asks about the first place of a word in a text, some characters into it.
    pub fn at(&mut self, method: &str, uri: &str, text: &str, word: &str, into: usize) -> Value {
        let mut params = json!({ "textDocument": { "uri": uri }, "position": place(text, word, into) });
        params["context"] = json!({ "includeDeclaration": false });
        self.ask(method, params)
    }

    /// What is offered to change at a word.
    pub fn actions(&mut self, uri: &str, text: &str, word: &str) -> Vec<Value> {
        let place = place(text, word, 0);
        let range = json!({ "start": place, "end": place });
        let params = json!({ "textDocument": { "uri": uri }, "range": range, "context": { "diagnostics": [] } });
        self.ask("textDocument/codeAction", params).as_array().unwrap().clone()
    }

    /// Ends the session as the protocol has it.
    pub fn end(mut self) -> ExitStatus {
        assert!(self.ask("shutdown", Value::Null).is_null());
        self.tell("exit", Value::Null);
        self.process.wait().unwrap()
    }

    /// Goes without a word.
    pub fn vanish(mut self) -> ExitStatus {
        drop(self.input.take());
        self.process.wait().unwrap()
    }
}

/// The position of the first place of a word, some characters into it, in UTF-16 units.
pub fn place(text: &str, word: &str, into: usize) -> Value {
    let at = text.find(word).unwrap_or_else(|| panic!("{word}")) + into;
    let start = text[..at].rfind('\n').map_or(0, |end| end + 1);
    json!({ "line": text[..at].matches('\n').count(), "character": text[start..at].encode_utf16().count() })
}

/// What stands at a range of a text, counted in UTF-16 units.
pub fn within<'a>(text: &'a str, range: &Value) -> &'a str {
    &text[byte(text, &range["start"])..byte(text, &range["end"])]
}

/// The byte of a position.
pub fn byte(text: &str, position: &Value) -> usize {
    let line = position["line"].as_u64().unwrap() as usize;
    let start: usize = text.split_inclusive('\n').take(line).map(str::len).sum();
    let mut units = position["character"].as_u64().unwrap() as usize;
    let rest = text[start..].chars().take_while(|one| {
        let fits = units >= one.len_utf16();
        units -= if fits { one.len_utf16() } else { 0 };
        fits
    });
    start + rest.map(char::len_utf8).sum::<usize>()
}

/// The text after the edits of an action, each for the text as it was.
pub fn done(text: &str, action: &Value) -> String {
    let mut edits = action["edit"]["documentChanges"][0]["edits"].as_array().unwrap().clone();
    edits.sort_by_key(|edit| byte(text, &edit["range"]["start"]));
    edits.iter().rev().fold(text.to_owned(), |mut changed, edit| {
        let (start, end) = (byte(text, &edit["range"]["start"]), byte(text, &edit["range"]["end"]));
        changed.replace_range(start..end, edit["newText"].as_str().unwrap());
        changed
    })
}
