//! Commissioning of measuring cycles as lists of steps, and the connections of probes.

use crate::manual::Cited;
use crate::manual::commissioning::{CONNECTIONS, Connection, STEPS, Step};
use crate::message::Message;
use serde::Serialize;

/// All ways to commission, and all connections.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct CommissioningView {
    /// The ways, by operator panel and its version.
    pub paths: Vec<CommissioningPath>,
    /// Connections of probes.
    pub connections: Vec<ConnectionView>,
}

/// A way to commission.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct CommissioningPath {
    /// By which it is known.
    pub id: &'static str,
    /// For which machine it is.
    pub title: Message,
    /// Its steps, in their order.
    pub steps: Vec<CommissioningStep>,
}

/// A step of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct CommissioningStep {
    /// By which it is known in all ways: `adv-old/6-3`.
    pub id: String,
    /// As other steps name it: `6.3`; empty: none does.
    pub number: String,
    /// What it is about.
    pub title: Message,
    /// What is to be done.
    pub action: Message,
    /// When it is due; absent: always.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub condition: Option<Message>,
    /// How it is seen to be right.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub check: Option<Message>,
    /// Versions for which it is; empty: all.
    pub versions: &'static str,
    /// Files and archives.
    pub files: &'static str,
    /// Softkeys and lines, as the control has them.
    pub softkeys: &'static str,
    /// Place in the manual.
    pub source: Cited,
}

/// A connection.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ConnectionView {
    /// Pin, plug or address.
    pub signal: &'static str,
    /// Its name.
    pub title: Message,
    /// What it carries, and what is to be set and checked.
    pub meaning: Message,
    /// Place in the manual.
    pub source: Cited,
}

/// How measuring cycles come to a machine.
pub fn commissioning() -> CommissioningView {
    let path = |steps: &[Step]| {
        let id = steps.first()?.path;
        let title = Message::new(format!("commission-path-{id}"));
        Some(CommissioningPath { id, title, steps: steps.iter().map(step).collect() })
    };
    CommissioningView {
        paths: STEPS.chunk_by(|one, next| one.path == next.path).filter_map(path).collect(),
        connections: CONNECTIONS.iter().map(connection).collect(),
    }
}

fn step(step: &Step) -> CommissioningStep {
    let Step { path, id, more, versions, files, softkeys, source } = step;
    let said = |end: &str| Message::new(format!("commission-{path}-{id}{end}"));
    let further = |one: &str| more.contains(&one).then(|| said(&format!("-{one}")));
    CommissioningStep {
        id: format!("{path}/{id}"),
        number: if id.starts_with(|first: char| first.is_ascii_digit()) { id.replace('-', ".") } else { String::new() },
        title: said(""),
        action: said("-do"),
        condition: further("if"),
        check: further("check"),
        versions,
        files,
        softkeys,
        source: *source,
    }
}

fn connection(connection: &Connection) -> ConnectionView {
    let Connection { id, signal, source } = connection;
    let said = |end: &str| Message::new(format!("connection-{id}{end}"));
    ConnectionView { signal, title: said(""), meaning: said("-is"), source: *source }
}
