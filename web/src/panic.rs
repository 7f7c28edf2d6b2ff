//! A panic is a defect of this program: it is reported to the console with its place, and to the page
//! as an event `probewright-panic`, so that the page can say so instead of going silent.

use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(inline_js = "
export function report_panic(text) {
  console.error(text);
  globalThis.dispatchEvent?.(new CustomEvent('probewright-panic', { detail: text }));
}")]
extern "C" {
    fn report_panic(text: &str);
}

/// Runs once when the module is loaded.
#[wasm_bindgen(start)]
fn start() {
    std::panic::set_hook(Box::new(|info| report_panic(&info.to_string())));
}
