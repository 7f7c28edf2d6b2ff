//! How measuring cycles come to a machine: the steps of commissioning and upgrade by operator panel, and the
//! connections of probes. Their words are messages: `commission-…`, its `-do`, `-if` and `-check`; `connection-…`.

use super::{Cited, rows, several};
use std::sync::LazyLock;

/// A step of a way to commission.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// End of the key of the way to which it belongs.
    pub path: &'static str,
    /// By which the way knows it.
    pub id: &'static str,
    /// Which sentences it has beside what is to be done: `if` when it is due, `check` how it is seen to be right.
    pub more: Vec<&'static str>,
    /// Versions for which it is.
    pub versions: &'static str,
    /// Files and archives.
    pub files: &'static str,
    /// Softkeys and lines, as the control has them.
    pub softkeys: &'static str,
    /// Where the manuals tell of it.
    pub source: Cited,
}

/// A signal of a plug, or a bit of the interface to the PLC.
#[derive(Clone, Debug, PartialEq)]
pub struct Connection {
    /// End of its keys.
    pub id: &'static str,
    /// Pin, plug or address.
    pub signal: &'static str,
    /// Where the manuals tell of it.
    pub source: Cited,
}

impl Connection {
    /// Whether its pin, plug or address has this name, or begins with it before its dot: `X121`, `DBX107.0`, `DBX107`.
    pub fn is_at(&self, name: &str) -> bool {
        let begins = |part: &str| {
            let rest = part.get(..name.len()).filter(|begin| begin.eq_ignore_ascii_case(name));
            rest.is_some() && part.get(name.len()..).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        !name.is_empty() && (self.signal.eq_ignore_ascii_case(name) || self.signal.split([' ', ',']).any(begins))
    }
}

/// Software of a component: which versions of the measuring cycles work with it (A:13938-13996).
#[derive(Clone, Debug, PartialEq)]
pub struct Software {
    /// NCU, CCU or operator panel.
    pub component: &'static str,
    /// Version of its software, `6.2`.
    pub version: &'static str,
    /// What works with it, in the order of [`FUNCTIONS`]; none: it does not matter for that.
    pub works: [Option<bool>; 5],
    /// Where the manuals tell of it.
    pub source: Cited,
}

/// Ends of the keys of what works with a software or not: cycles, measuring in JOG, masks of the program editor.
pub const FUNCTIONS: [&str; 5] = ["cycles-54", "cycles-62", "jog-54", "jog-62", "support-62"];

/// The software of all components.
pub static SOFTWARE: LazyLock<Vec<Software>> = LazyLock::new(|| {
    let works = |cell: &str| (cell != "-").then_some(cell == "yes");
    let software = |[component, version, a, b, c, d, e, source]: [&'static str; 8]| Software {
        component,
        version: version.trim_start_matches("SW "),
        works: [a, b, c, d, e].map(works),
        source: Cited(source),
    };
    rows(include_str!("compatibility.tsv")).map(software).collect()
});

/// All steps, those of a way together and in their order.
pub static STEPS: LazyLock<Vec<Step>> = LazyLock::new(|| {
    let step = |[path, id, more, versions, files, softkeys, source]: [&'static str; 7]| Step {
        path,
        id,
        more: several(more),
        versions,
        files,
        softkeys,
        source: Cited(source),
    };
    rows(include_str!("steps.tsv")).map(step).collect()
});

/// All connections.
pub static CONNECTIONS: LazyLock<Vec<Connection>> = LazyLock::new(|| {
    let connection = |[id, signal, source]: [&'static str; 3]| Connection { id, signal, source: Cited(source) };
    rows(include_str!("connections.tsv")).map(connection).collect()
});

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    // oracle: manual B:12697, B:12816-12823: plugs and the bits of the PLC by their names
    #[test]
    fn a_connection_is_found_by_its_name() {
        let at = |name: &str| CONNECTIONS.iter().filter(|one| one.is_at(name)).map(|one| one.id).collect::<Vec<_>>();
        assert_eq!(at("DBX107"), ["plc-1", "plc-2"]);
        assert_eq!(at("dbx107.1"), ["plc-2"]);
        assert_eq!(at("X10"), ["distributor-1"]);
        assert_eq!(at("X121.9"), ["x121-9"]);
        assert!(at("X121").contains(&"distributor") && at("X121").contains(&"x121-1"));
        assert!(at("X1").is_empty() && at("").is_empty() && at("X").is_empty());
    }

    // oracle: self: no row of a table is lost, each place of a manual is found
    #[test]
    fn the_tables_are_whole() {
        assert_eq!(STEPS.len() + 1, include_str!("steps.tsv").lines().count());
        assert_eq!(CONNECTIONS.len() + 1, include_str!("connections.tsv").lines().count());
        let ids: BTreeSet<_> = STEPS.iter().map(|step| (step.path, step.id)).collect();
        assert_eq!(ids.len(), STEPS.len());
        assert!(STEPS.iter().all(|step| !step.source.to_string().is_empty()));
        assert!(CONNECTIONS.iter().all(|one| !one.source.to_string().is_empty()));
        let mut compatibility = include_str!("compatibility.tsv").lines();
        let head: Vec<&str> = compatibility.next().unwrap_or_default().split('\t').collect();
        assert_eq!(head[2..7], FUNCTIONS);
        assert_eq!(SOFTWARE.len(), compatibility.count());
        assert!(SOFTWARE.iter().all(|one| !one.source.to_string().is_empty()));
        let paths = STEPS.chunk_by(|one, next| one.path == next.path).count();
        assert_eq!(STEPS.iter().map(|step| step.path).collect::<BTreeSet<_>>().len(), paths, "a way stands together");
    }
}
