//! What the page can ask of the core. Every question and answer is JSON text; `www/src/wire.ts` describes it.
//! A question of the wrong shape is an exception with the reason.
//!
//! Built twice, each time with one of its features: the page fetches what the form of the first visit needs first, and
//! everything, with all cycles and the simulation, once that form stands.

mod catalogue;
mod form;
mod panic;
#[cfg(feature = "program")]
mod program;
#[cfg(feature = "program")]
mod scan;
#[cfg(feature = "program")]
mod scene;
#[cfg(feature = "program")]
mod steps;

pub use catalogue::catalogue;
pub use form::form;
#[cfg(feature = "program")]
pub use program::{
    Answer, Held, Recogniser, Run, alarms, approach, as_mask, as_program, change, convert, cure, equip, form_seen,
    help, machine, note, practise, protocol, read, scenario, setup, story,
};
#[cfg(feature = "program")]
pub use scan::Scan;
#[cfg(feature = "program")]
pub use scene::Scene;
#[cfg(feature = "program")]
pub use steps::Steps;

use wasm_bindgen::prelude::wasm_bindgen;

/// Version of the core, as in its `Cargo.toml`.
#[wasm_bindgen]
#[must_use]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}
