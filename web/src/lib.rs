//! What the page can ask of the core. Every question and answer is JSON text; `www/src/wire.ts` describes it.
//! A question of the wrong shape is an exception with the reason.

mod panic;

use probewright_core::json;
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

/// Version of the core, as in its `Cargo.toml`.
#[wasm_bindgen]
#[must_use]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}

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

/// `ReadRequest` → `ReadView`.
///
/// # Errors
/// A request of the wrong shape.
#[wasm_bindgen]
pub fn read(request: &str) -> Result<String, JsError> {
    Ok(json::read(request)?.to_string())
}

/// `ChangeRequest` → `Edit[]`.
///
/// # Errors
/// A request of the wrong shape or a call that is not there.
#[wasm_bindgen]
pub fn change(request: &str) -> Result<String, JsError> {
    Ok(json::change(request)?.to_string())
}

/// `ConvertRequest` → `Converted`.
///
/// # Errors
/// A request of the wrong shape.
#[wasm_bindgen]
pub fn convert(request: &str) -> Result<String, JsError> {
    Ok(json::convert(request)?.to_string())
}

/// `RunRequest` → `RunView`.
///
/// # Errors
/// A request or a setup of the wrong shape.
#[wasm_bindgen]
pub fn run(request: &str) -> Result<String, JsError> {
    Ok(json::run(request)?.to_string())
}
