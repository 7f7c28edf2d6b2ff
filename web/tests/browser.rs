//! Runs in headless Chromium: the module loads there and answers.
#![cfg(target_arch = "wasm32")]

use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

// oracle: self (Cargo.toml)
#[wasm_bindgen_test]
fn version_is_that_of_the_workspace() {
    assert_eq!(probewright_web::version(), env!("CARGO_PKG_VERSION"));
}
