//! Commissioning of measuring cycles as lists of steps, the connections of probes, and which versions work together.

use super::start::Machine;
use super::{Error, start};
use crate::catalogue::sinumerik::state::software;
use crate::control::Control;
use crate::dialect::Dialect;
use crate::manual::Cited;
use crate::manual::commissioning::{CONNECTIONS, Connection, FUNCTIONS, SOFTWARE, STEPS, Software, Step};
use crate::message::Message;
use serde::{Deserialize, Serialize};

/// The datum that says the software of the control, up to measuring cycles SW 6.2 (B:13675-13687).
const OF_CONTROL: &str = "_SI[1]";

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

/// For which machine the versions are asked.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct CompatibilityRequest {
    /// Machine; absent: none in particular.
    pub setup: Option<Machine>,
}

/// Which versions work together.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct CompatibilityView {
    /// What works with a software or not.
    pub functions: Vec<Message>,
    /// Software of the components, those of a component together.
    pub rows: Vec<CompatibilityRow>,
    /// What the machine says of its software.
    pub told: Message,
}

/// Software of a component.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct CompatibilityRow {
    /// NCU, CCU or operator panel.
    pub component: &'static str,
    /// Version of its software.
    pub version: &'static str,
    /// Whether each function works with it.
    pub works: Vec<Message>,
    /// Whether the machine may have it.
    pub here: bool,
    /// Place in the manual.
    pub source: Cited,
}

/// Which versions work together, held against what the machine says of its software.
///
/// # Errors
/// A machine that cannot be.
pub fn compatibility(asked: CompatibilityRequest) -> Result<CompatibilityView, Error> {
    let setup = asked.setup.map(|machine| start::start(Dialect::Sinumerik, Some(machine))).transpose()?;
    Ok(compatibility_on(setup.as_ref().map(|start| &start.setup.control)))
}

/// Which versions work together, held against this control.
pub fn compatibility_on(control: Option<&Control>) -> CompatibilityView {
    let digit = control.map(|control| software(control) as u32).filter(|digit| *digit > 0);
    let told = match digit {
        Some(digit) => Message::new("compatibility-here").text("name", OF_CONTROL).number("version", f64::from(digit)),
        None => Message::new("compatibility-unknown").text("name", OF_CONTROL),
    };
    CompatibilityView {
        functions: FUNCTIONS.map(|one| Message::new(format!("compatibility-{one}"))).to_vec(),
        rows: SOFTWARE.iter().map(|one| row(one, digit)).collect(),
        told,
    }
}

/// Only the NCU has the software that the datum names: those of a CCU and of a panel
/// count differently (A:13970-13992).
fn row(one: &Software, digit: Option<u32>) -> CompatibilityRow {
    let Software { component, version, works, source } = one;
    let word = |works: Option<bool>| match works {
        Some(true) => "compatibility-yes",
        Some(false) => "compatibility-no",
        None => "compatibility-any",
    };
    let major = version.split('.').next().and_then(|first| first.parse().ok());
    CompatibilityRow {
        component,
        version,
        works: works.map(|works| Message::new(word(works))).to_vec(),
        here: *component == "NCU" && digit.is_some() && major == digit,
        source: *source,
    }
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    // oracle: manual A:13964-13968, B:4162 (cycles from SW 6.2 need NCK SW 6.3)
    #[test]
    #[cfg(feature = "cli")]
    fn the_requirements_say_what_the_table_says() {
        let [_, newer, ..] = FUNCTIONS;
        let least = SOFTWARE.iter().find(|one| one.component == "NCU" && one.works[1] == Some(true)).unwrap();
        for language in ["en", "de", "zh"] {
            let words = crate::words::Words::of(language).unwrap();
            let said = words.key("commission-requirements-versions-do");
            let version =
                newer.strip_prefix("cycles-").unwrap().chars().map(String::from).collect::<Vec<_>>().join(".");
            let found = said.find(&format!("SW {version}")).zip(said.find(&format!("NCK SW {}", least.version)));
            assert!(found.is_some_and(|(cycles, control)| cycles < control), "{language}: {said}");
        }
    }

    // oracle: manual A:13964-13968, B:13675-13687
    #[test]
    fn the_software_of_the_machine_is_marked() {
        let machine =
            |data: &str| serde_json::from_str(&format!(r#"{{ "own": {{ "data": {{ {data} }} }} }}"#)).unwrap();
        let of = |data| compatibility(CompatibilityRequest { setup: Some(machine(data)) }).unwrap();
        let here = |view: &CompatibilityView| {
            let rows = view.rows.iter().filter(|row| row.here);
            rows.map(|row| (row.version, row.works[1].key.clone().into_owned())).collect::<Vec<_>>()
        };
        assert_eq!(here(&of(r#""_SI[1]": "5""#)), [("5.3", "compatibility-no".to_owned())]);
        let six: Vec<&str> = of(r#""_SI[1]": "6""#).rows.iter().filter(|row| row.here).map(|row| row.version).collect();
        assert_eq!(six, ["6.2", "6.3", "6.4"]);
        let none = compatibility(CompatibilityRequest::default()).unwrap();
        assert_eq!((here(&none).len(), none.told.key.as_ref()), (0, "compatibility-unknown"));
    }
}
