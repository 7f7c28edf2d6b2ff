//! What can be measured.

use probewright_core::{app, json};
use wasm_bindgen::prelude::wasm_bindgen;

/// `Catalogue`: everything that can be measured.
#[wasm_bindgen]
#[must_use]
pub fn catalogue() -> String {
    json::text(&app::catalogue())
}
