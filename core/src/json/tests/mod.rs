//! What the page asks and gets.
#![allow(clippy::unwrap_used)]

mod calls;
mod equipment;
mod form;
mod machine;
mod outcome;
mod setup;
mod setup_limits;
mod setup_tools;
mod story;
mod supply;
mod wire;

use crate::entry::Typed;
use crate::json::asked::*;
use crate::json::*;
use serde_json::{Value, json};

fn request(cycle: &crate::entry::Cycle) -> String {
    asked(cycle, &crate::catalogue::example::worked(cycle))
}

fn asked(cycle: &crate::entry::Cycle, values: &Typed) -> String {
    json!({
        "control": cycle.dialect,
        "cycle": cycle.name,
        "values": values,
        "predict": true,
        "errors": { "part": { "size": 0.03 } },
    })
    .to_string()
}

/// An inch machine as the page would import it.
fn inch_machine() -> Value {
    json!({
        "control": "sinumerik",
        "units": "inch",
        "active": { "tool": 9, "edge": 1 },
        "environments": { "ROUGH": { "tool": 20, "edge": 1, "plane": "G18" } },
        "tools": { "9": { "edges": { "1": { "type": 710, "length": [50, 0, 0], "radius": 3 } } } },
        "probe": { "radius": 3, "length": 50 },
    })
}
