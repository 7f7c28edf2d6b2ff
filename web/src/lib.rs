//! What the page can ask of the core. Every answer is JSON text; `www/src/wire.ts` describes it.

mod panic;

use wasm_bindgen::prelude::wasm_bindgen;

/// Version of the core, as in its `Cargo.toml`.
#[wasm_bindgen]
#[must_use]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}
