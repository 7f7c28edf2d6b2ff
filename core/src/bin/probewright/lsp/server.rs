//! The session with a client: its documents, what it asks, what it is told.

use super::diagnose::Place;
use super::known::{Document, Known};
use super::rpc::{self, Fault};
use super::settings::Settings;
use super::text::{Text, Units};
use super::{act, complete, diagnose, explain, find, outline, paths};
use crate::file::{self, Problem};
use lsp_types::{
    CodeActionParams, DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams,
    DocumentSymbolParams, ExecuteCommandParams, InitializeParams, Position, PositionEncodingKind, Range, Uri,
};
use probewright_core::diagnostic::Span;
use probewright_core::message::Message;
use probewright_core::words::Words;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// How far the session is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Stage {
    New,
    Begun,
    Ended,
}

/// What the client can.
struct Client {
    units: Units,
    markdown: bool,
    nested: bool,
    versioned: bool,
    disabled: bool,
    root: Option<PathBuf>,
}

/// A session.
pub struct Server {
    stage: Stage,
    words: Words,
    client: Client,
    settings: Settings,
    /// What is open, by address.
    open: BTreeMap<String, Document>,
    /// Of these the findings are not told yet.
    untold: BTreeSet<String>,
    /// Findings in files, by program and address of the file.
    beside: BTreeMap<String, BTreeMap<String, Vec<lsp_types::Diagnostic>>>,
    outgoing: Vec<Value>,
}

/// Why a request has no answer.
type Refused = (Fault, Message);

impl Server {
    /// A session that has not begun.
    pub fn new(words: Words) -> Server {
        let client = Client {
            units: Units::Utf16,
            markdown: false,
            nested: false,
            versioned: false,
            disabled: false,
            root: None,
        };
        Server {
            stage: Stage::New,
            words,
            client,
            settings: Settings::default(),
            open: BTreeMap::new(),
            untold: BTreeSet::new(),
            beside: BTreeMap::new(),
            outgoing: Vec::new(),
        }
    }

    /// Whether the client said that it has done with the session.
    pub fn is_ended(&self) -> bool {
        self.stage == Stage::Ended
    }

    /// What is to be sent, in order.
    pub fn sent(&mut self) -> impl Iterator<Item = Value> + use<> {
        std::mem::take(&mut self.outgoing).into_iter()
    }

    /// Refuses a message.
    pub fn refuse(&mut self, id: Value, fault: Fault, why: &Message) {
        self.outgoing.push(rpc::refusal(id, fault, &self.words.text(why)));
    }

    /// Leaves out a request that the client does not want any more.
    pub fn cancelled(&mut self, id: Value) {
        self.refuse(id, Fault::Cancelled, &Message::new("server-cancelled"));
    }

    /// Answers a request.
    pub fn asked(&mut self, id: Value, method: &str, params: Value) {
        match self.answer(method, params) {
            Ok(result) => self.outgoing.push(rpc::answer(id, result)),
            Err((fault, why)) => self.refuse(id, fault, &why),
        }
    }

    fn answer(&mut self, method: &str, params: Value) -> Result<Value, Refused> {
        match (self.stage, method) {
            (Stage::New, "initialize") => return self.initialize(read(method, params)?),
            (Stage::New, _) => return Err((Fault::Early, Message::new("server-early"))),
            (Stage::Begun, "initialize") => return Err((Fault::Request, Message::new("server-twice"))),
            (Stage::Ended, _) => return Err((Fault::Request, Message::new("server-ended"))),
            (Stage::Begun, "shutdown") => {
                self.stage = Stage::Ended;
                return Ok(Value::Null);
            }
            _ => {}
        }
        match method {
            "textDocument/hover" => self.hover(read(method, params)?),
            "textDocument/completion" => self.completion(read(method, params)?),
            "textDocument/definition" => self.places(read(method, params)?, find::definitions),
            "textDocument/references" => self.places(read(method, params)?, |_, known, at| find::references(known, at)),
            "textDocument/documentSymbol" => self.symbols(read(method, params)?),
            "textDocument/codeAction" => self.actions(read(method, params)?),
            "workspace/executeCommand" => self.execute(&read(method, params)?),
            _ => Err((Fault::Method, Message::new("server-method").text("name", method))),
        }
    }

    fn initialize(&mut self, asked: InitializeParams) -> Result<Value, Refused> {
        if let Some(words) = asked.locale.as_deref().and_then(Words::of) {
            self.words = words;
        }
        self.client = client(&asked);
        let options = asked.initialization_options.as_ref().unwrap_or(&Value::Null);
        let (settings, wrong) = Settings::of(options, self.client.root.as_deref(), &self.words);
        self.settings = settings;
        self.complain(wrong);
        self.stage = Stage::Begun;
        let encoding = match self.client.units {
            Units::Utf16 => PositionEncodingKind::UTF16,
            Units::Utf8 => PositionEncodingKind::UTF8,
        };
        let sync = json!({ "openClose": true, "change": 2, "save": { "includeText": false } });
        let capabilities = json!({
            "positionEncoding": encoding,
            "textDocumentSync": sync,
            "hoverProvider": true,
            "completionProvider": { "triggerCharacters": ["_", "=", "(", ","] },
            "definitionProvider": true,
            "referencesProvider": true,
            "documentSymbolProvider": true,
            "executeCommandProvider": { "commands": [act::TELL] },
            "codeActionProvider": { "codeActionKinds": ["quickfix", "refactor.rewrite"] },
        });
        let about = json!({ "name": "probewright", "version": env!("CARGO_PKG_VERSION") });
        Ok(json!({ "capabilities": capabilities, "serverInfo": about }))
    }

    /// Takes in what the client tells. What cannot be understood of that has nobody who waits for an answer.
    pub fn notified(&mut self, method: &str, params: Value) {
        if self.stage != Stage::Begun {
            return;
        }
        match method {
            "textDocument/didOpen" => self.with(method, params, Server::opened),
            "textDocument/didChange" => self.with(method, params, Server::changed),
            "textDocument/didClose" => self.with(method, params, Server::closed),
            "textDocument/didSave" | "workspace/didChangeWatchedFiles" => self.files_changed(&params),
            "workspace/didChangeConfiguration" => self.configured(params.get("settings")),
            _ => {}
        }
    }

    /// Takes in other settings. A client that has none sends nothing, or an empty object: those of the begin stay.
    fn configured(&mut self, value: Option<&Value>) {
        let empty = |value: &Value| value.as_object().is_some_and(serde_json::Map::is_empty);
        let Some(value) = value.filter(|value| !value.is_null() && !empty(value)) else { return };
        let (settings, wrong) = Settings::of(value, self.client.root.as_deref(), &self.words);
        self.settings = settings;
        self.complain(wrong);
        self.read_all_again();
    }

    fn with<T: DeserializeOwned>(&mut self, method: &str, params: Value, take: fn(&mut Server, T)) {
        match read(method, params) {
            Ok(params) => take(self, params),
            Err((_, why)) => {
                let text = self.words.text(&why);
                self.complain(Some(text));
            }
        }
    }

    /// Tells the user what is wrong with what the client sent.
    fn complain(&mut self, wrong: Option<String>) {
        let message = wrong.map(|text| json!({ "type": 1, "message": text }));
        self.outgoing.extend(message.map(|params| rpc::notification("window/showMessage", params)));
    }

    fn opened(&mut self, params: DidOpenTextDocumentParams) {
        let one = params.text_document;
        let text = Text::new(one.text, self.client.units);
        let document = Document { text, version: one.version, path: paths::path(&one.uri), known: None };
        self.open.insert(one.uri.as_str().to_owned(), document);
        self.is_new(one.uri.as_str());
    }

    fn changed(&mut self, params: DidChangeTextDocumentParams) {
        let uri = params.text_document.uri.as_str();
        let Some(mut document) = self.open.remove(uri) else { return };
        document.text = document.text.changed(params.content_changes);
        document.version = params.text_document.version;
        self.open.insert(uri.to_owned(), document);
        self.is_new(uri);
    }

    fn closed(&mut self, params: DidCloseTextDocumentParams) {
        let uri = params.text_document.uri.as_str();
        self.open.remove(uri);
        self.untold.remove(uri);
        let told = self.beside.remove(uri).unwrap_or_default();
        self.publish(uri);
        told.keys().for_each(|file| self.publish(file));
        self.read_others_again(uri);
    }

    /// A text is another one: what was known of it does not hold, nor what was known of those that it is beside.
    fn is_new(&mut self, uri: &str) {
        if let Some(document) = self.open.get_mut(uri) {
            document.known = None;
            self.untold.insert(uri.to_owned());
        }
        self.read_others_again(uri);
    }

    fn read_others_again(&mut self, uri: &str) {
        let path = uri.parse().ok().and_then(|uri| paths::path(&uri));
        if path.is_some_and(|path| self.settings.counts(&path)) {
            self.read_all_again();
        }
    }

    fn read_all_again(&mut self) {
        self.open.values_mut().for_each(|document| document.known = None);
        self.untold.extend(self.open.keys().cloned());
    }

    /// A file beside the programs, or the setup file, may be another one.
    fn files_changed(&mut self, params: &Value) {
        let saved = params.pointer("/textDocument/uri").into_iter();
        let watched = params.get("changes").and_then(Value::as_array).into_iter().flatten();
        let mut uris = saved.chain(watched.filter_map(|one| one.get("uri"))).filter_map(Value::as_str);
        let counts = |uri: &str| {
            let path = uri.parse().ok().and_then(|uri| paths::path(&uri));
            path.is_some_and(|path| self.settings.counts(&path))
        };
        if uris.any(counts) {
            self.settings.again(&self.words);
            self.read_all_again();
        }
    }

    /// Tells the findings of one document that changed; whether there was one.
    pub fn tell_one(&mut self) -> bool {
        let Some(uri) = self.untold.pop_first() else { return false };
        if let Err(problem) = self.know(&uri) {
            let text = file::told(&problem, &self.words);
            self.complain(Some(text));
        }
        let units = self.client.units;
        let known = self.open.get(&uri).and_then(|document| document.known.as_ref());
        let beside = known.map(|known| diagnose::beside(known, units, &self.words)).unwrap_or_default();
        let before = self.beside.insert(uri.clone(), beside).unwrap_or_default();
        let now = self.beside.get(&uri).into_iter().flat_map(|files| files.keys().cloned());
        let files: BTreeSet<String> = before.into_keys().chain(now).collect();
        self.publish(&uri);
        files.iter().for_each(|file| self.publish(file));
        true
    }

    /// Sends all findings of a file: its own, where it is open, and those that programs found which it is beside.
    fn publish(&mut self, uri: &str) {
        let Ok(address) = uri.parse::<Uri>() else { return };
        let document = self.open.get(uri);
        let known = document.and_then(|document| document.known.as_ref());
        let mut all = match (document, known) {
            (Some(document), Some(known)) => {
                diagnose::own(known, &Place { text: &document.text, uri: &address }, &self.words)
            }
            _ => Vec::new(),
        };
        let holds = |(program, _): &(&String, &_)| !self.untold.contains(*program);
        for one in self.beside.iter().filter(holds).filter_map(|(_, files)| files.get(uri)).flatten() {
            if !all.contains(one) {
                all.push(one.clone());
            }
        }
        let mut params = json!({ "uri": uri, "diagnostics": all });
        if let Some(document) = document {
            params["version"] = document.version.into();
        }
        self.outgoing.push(rpc::notification("textDocument/publishDiagnostics", params));
    }

    /// Finds out what there is to know about a document, where nobody has yet.
    fn know(&mut self, uri: &str) -> Result<(), Problem> {
        let Some(document) = self.open.get(uri).filter(|document| document.known.is_none()) else { return Ok(()) };
        let shown = |path: &Path| {
            let mut all = self.open.values();
            all.find(|one| one.path.as_deref().is_some_and(|own| paths::same(own, path)))
        };
        let read = |path: &Path| match shown(path) {
            Some(document) => Ok(document.text.as_str().as_bytes().to_vec()),
            None => file::program(path),
        };
        // a file that cannot be read does not hide what is wrong with the program
        let (known, problem) = match Known::of(document, &self.settings, &read) {
            Ok(known) => (Some(known), None),
            Err(problem) => (Known::alone(document, &self.settings).ok(), Some(problem)),
        };
        if let Some(document) = self.open.get_mut(uri) {
            document.known = known;
        }
        problem.map_or(Ok(()), Err)
    }

    /// Finds out what there is to know about a document that somebody asks about.
    fn look_up(&mut self, uri: &Uri) {
        if let Err(problem) = self.know(uri.as_str()) {
            let text = file::told(&problem, &self.words);
            self.complain(Some(text));
        }
    }

    /// A document with what is known about it; none: it is not open.
    fn looked_up(&self, uri: &Uri) -> Option<(&Document, &Known)> {
        let document = self.open.get(uri.as_str())?;
        Some((document, document.known.as_ref()?))
    }

    fn hover(&mut self, asked: At) -> Result<Value, Refused> {
        self.look_up(&asked.text_document.uri);
        let Some((document, known)) = self.looked_up(&asked.text_document.uri) else { return Ok(Value::Null) };
        let at = document.text.byte(asked.position) as u32;
        let told = explain::at(document, known, at, &self.words).map(|text| match self.client.markdown {
            true => json!({ "contents": { "kind": "markdown", "value": explain::markdown(&text) } }),
            false => json!({ "contents": { "kind": "plaintext", "value": text } }),
        });
        Ok(told.unwrap_or_default())
    }

    fn completion(&mut self, at: At) -> Result<Value, Refused> {
        self.look_up(&at.text_document.uri);
        let found = self.looked_up(&at.text_document.uri);
        let items = found.map(|(document, known)| complete::at(document, known, at.position, &self.words));
        Ok(json!({ "isIncomplete": false, "items": items.unwrap_or_default() }))
    }

    fn places(&mut self, asked: At, find: impl Fn(&Document, &Known, u32) -> Vec<Span>) -> Result<Value, Refused> {
        let uri = &asked.text_document.uri;
        self.look_up(uri);
        let units = self.client.units;
        let Some((document, known)) = self.looked_up(uri) else { return Ok(json!([])) };
        let at = document.text.byte(asked.position) as u32;
        let location = |place: Span| {
            if known.joined.of_program(place) {
                return Some(json!({ "uri": uri, "range": document.text.range(place) }));
            }
            let (path, source, place) = known.joined.place(place)?;
            let text = Text::new(String::from_utf8_lossy(source).into_owned(), units);
            Some(json!({ "uri": paths::uri(path)?, "range": text.range(place) }))
        };
        Ok(find(document, known, at).into_iter().filter_map(location).collect())
    }

    fn symbols(&mut self, asked: DocumentSymbolParams) -> Result<Value, Refused> {
        let uri = asked.text_document.uri;
        self.look_up(&uri);
        let Some((document, known)) = self.looked_up(&uri) else { return Ok(json!([])) };
        let symbols = outline::outline(document, known, &self.words);
        Ok(outline::told(&symbols, self.client.nested, uri.as_str()).into())
    }

    fn actions(&mut self, asked: CodeActionParams) -> Result<Value, Refused> {
        let uri = asked.text_document.uri;
        self.look_up(&uri);
        let Some((document, known)) = self.looked_up(&uri) else { return Ok(json!([])) };
        let asked = act::Asked {
            document,
            known,
            settings: &self.settings,
            uri: &uri,
            range: Range::new(asked.range.start, asked.range.end.max(asked.range.start)),
            only: asked.context.only,
            versioned: self.client.versioned,
            disabled: self.client.disabled,
            words: &self.words,
        };
        Ok(act::actions(&asked).into())
    }

    /// Shows the reason that an action without effect carries.
    fn execute(&mut self, asked: &ExecuteCommandParams) -> Result<Value, Refused> {
        if asked.command != act::TELL {
            return Err((Fault::Parameters, Message::new("server-method").text("name", &*asked.command)));
        }
        self.complain(asked.arguments.first().and_then(Value::as_str).map(str::to_owned));
        Ok(Value::Null)
    }
}

/// A place of a document. What else a request has is not needed.
#[derive(serde::Deserialize)]
#[serde(rename_all = "camelCase")]
struct At {
    text_document: lsp_types::TextDocumentIdentifier,
    position: Position,
}

/// Parameters of a message.
fn read<T: DeserializeOwned>(method: &str, params: Value) -> Result<T, Refused> {
    serde_json::from_value(params).map_err(|error| {
        let why = Message::new("server-parameters").text("name", method).text("text", error.to_string());
        (Fault::Parameters, why)
    })
}

/// What the client can. Relative paths of the settings begin in its first folder.
fn client(asked: &InitializeParams) -> Client {
    let can = serde_json::to_value(&asked.capabilities).unwrap_or_default();
    let has = |path: &str, text: &str| match can.pointer(path) {
        Some(Value::Array(list)) => list.iter().any(|one| one == text),
        _ => false,
    };
    let is = |path: &str| can.pointer(path).and_then(Value::as_bool) == Some(true);
    let folder = asked.workspace_folders.iter().flatten().next().map(|folder| &folder.uri);
    #[allow(deprecated)] // clients without folders say it so
    let root = folder.or(asked.root_uri.as_ref()).and_then(paths::path);
    Client {
        units: if has("/general/positionEncodings", "utf-8") { Units::Utf8 } else { Units::Utf16 },
        markdown: has("/textDocument/hover/contentFormat", "markdown"),
        nested: is("/textDocument/documentSymbol/hierarchicalDocumentSymbolSupport"),
        versioned: is("/workspace/workspaceEdit/documentChanges"),
        disabled: is("/textDocument/codeAction/disabledSupport"),
        root,
    }
}
