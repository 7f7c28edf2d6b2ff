//! Stored tool environments: `TOOLENV("NAME")` keeps what a later correction with `_TENV` needs (B:2062-2102).

use super::{Control, Plane};
use serde::{Deserialize, Serialize};

/// What was in effect when an environment was stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Environment {
    /// T number.
    pub tool: i64,
    /// D number, 0 none.
    pub edge: i64,
    /// DL number, 0 none.
    #[serde(default)]
    pub location: i64,
    /// Working plane: it decides which length works in which axis.
    #[serde(default)]
    pub plane: Plane,
}

impl Control {
    /// Stores what is in effect now under this name; an environment of that name is replaced.
    pub fn store_environment(&mut self, name: &str) {
        let environment = Environment { tool: self.tool, edge: self.edge, location: self.location, plane: self.plane };
        self.environments.insert(name.to_owned(), environment);
    }
}
