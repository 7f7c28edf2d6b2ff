//! What the page can ask of the core. Every question and answer is JSON text; `www/src/wire.ts` describes it.
//! A question of the wrong shape is an exception with the reason.

mod catalogue;
mod form;
mod panic;
mod program;
mod scan;
mod scene;
mod steps;

pub use catalogue::catalogue;
pub use form::form;
pub use program::{
    Answer, Held, Recogniser, Run, alarms, approach, as_mask, as_program, braking, change, commissioning, convert,
    cure, definitions, elsewhere, equip, form_seen, help, machine, machine_check, note, pointed, practice_record,
    practice_setup, protocol, read, read_back, repeat, scenario, series, series_start, setup, story, terms,
    user_programs,
};
pub use scan::Scan;
pub use scene::Scene;
pub use steps::Steps;

use wasm_bindgen::prelude::wasm_bindgen;

/// Version of the core, as in its `Cargo.toml`.
#[wasm_bindgen]
#[must_use]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}
