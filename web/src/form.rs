//! What the first form needs.

use probewright_core::json;
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

/// `Catalogue`: everything that can be measured.
#[wasm_bindgen]
#[must_use]
pub fn catalogue() -> String {
    json::catalogue().to_string()
}

/// `FormRequest` → `FormView`.
///
/// # Errors
/// A request of the wrong shape or an unknown cycle.
#[wasm_bindgen]
pub fn form(request: &str) -> Result<String, JsError> {
    Ok(json::form(request)?.to_string())
}
