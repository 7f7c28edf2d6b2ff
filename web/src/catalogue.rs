//! What can be measured: asked for first, and once more of the module that knows all cycles.

use probewright_core::{app, json};
use wasm_bindgen::prelude::wasm_bindgen;

/// `Catalogue`: everything that can be measured.
#[wasm_bindgen]
#[must_use]
pub fn catalogue() -> String {
    json::text(&app::catalogue())
}
