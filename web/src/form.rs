//! The form.

use probewright_core::{app, json};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

/// `FormRequest` → `FormView`.
///
/// # Errors
/// A request of the wrong shape or an unknown cycle.
#[wasm_bindgen]
pub fn form(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::form)?)
}
