//! What programs need.

use probewright_core::json;
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

/// `AlarmInfo[]`: all alarms and messages.
#[wasm_bindgen]
#[must_use]
pub fn alarms() -> String {
    json::text(&json::alarms())
}

#[wasm_bindgen(inline_js = "
export function tell(share) {
  globalThis.dispatchEvent?.(new CustomEvent('probewright-progress', { detail: share }));
}")]
extern "C" {
    fn tell(share: f64);
}

/// `ReadRequest` → `ReadView`. A long program says on the way how far it is, as an event `probewright-progress` with the
/// share that is done.
///
/// # Errors
/// A request of the wrong shape.
#[wasm_bindgen]
pub fn read(request: &str) -> Result<String, JsError> {
    Ok(json::text(&json::read_told(request, &mut |share| {
        tell(share)
    })?))
}

/// `ChangeRequest` → `Edit[]`.
///
/// # Errors
/// A request of the wrong shape or a call that is not there.
#[wasm_bindgen]
pub fn change(request: &str) -> Result<String, JsError> {
    Ok(json::text(&json::change(request)?))
}

/// `ConvertRequest` → `Converted`.
///
/// # Errors
/// A request of the wrong shape.
#[wasm_bindgen]
pub fn convert(request: &str) -> Result<String, JsError> {
    Ok(json::text(&json::convert(request)?))
}

/// `RunRequest` → `RunView`.
///
/// # Errors
/// A request or a setup of the wrong shape.
#[wasm_bindgen]
pub fn run(request: &str) -> Result<String, JsError> {
    Ok(json::text(&json::run(request)?))
}

/// Text of a setup file → `Setup` with everything in it that the file leaves to its default.
///
/// # Errors
/// The text is no setup: why, with the place.
#[wasm_bindgen]
pub fn setup(text: &str) -> Result<String, JsError> {
    let setup = json::setup_from_json(text)?;
    Ok(json::text(&json::setup_to_json(&setup)))
}

/// `MachineRequest` → `MachineView`.
///
/// # Errors
/// A request or a setup of the wrong shape.
#[wasm_bindgen]
pub fn machine(request: &str) -> Result<String, JsError> {
    Ok(json::text(&json::machine(request)?))
}
