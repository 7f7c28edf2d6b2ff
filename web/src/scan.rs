//! Scanning a surface.

use crate::scene::Scene;
use probewright_core::{app, json};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

/// A `ScanRequest` that is answered in pieces, so that a worker can tell between them how far it is.
#[wasm_bindgen]
pub struct Scan(app::Scan);

#[wasm_bindgen]
impl Scan {
    /// A scan before its first point; `file` holds the bytes that the request speaks of.
    ///
    /// # Errors
    /// A request, a setup or a file of the wrong shape.
    #[wasm_bindgen(constructor)]
    pub fn new(request: &str, file: &[u8]) -> Result<Scan, JsError> {
        Ok(Scan(app::Scan::new(json::question(request)?, file)?))
    }

    /// Goes on by about so many points; true: it is over.
    pub fn advance(&mut self, points: u32) -> bool {
        self.0.advance(points as usize)
    }

    /// How much is done, 0 to 1.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.0.share()
    }

    /// What came out, as a `ScanView`.
    #[must_use]
    pub fn view(&self) -> String {
        json::text(&self.0.view())
    }

    /// The surface.
    #[must_use]
    pub fn scene(&self) -> Scene {
        self.0.scene().into()
    }

    /// Of the points `from` to `to` (excluded), four numbers each: X Y Z from the origin of the view, and the deviation
    /// from the true surface, mm.
    #[must_use]
    pub fn cloud(&self, surface: bool, from: u32, to: u32) -> Vec<f32> {
        self.0.cloud(surface, from as usize..to as usize)
    }

    /// The turn of each point when they are drawn.
    #[must_use]
    pub fn turns(&self) -> Vec<u32> {
        self.0.turns()
    }

    /// Text of the points `from` to `to` (excluded): `program`, `points` or `surface`.
    ///
    /// # Errors
    /// Another name.
    pub fn text(&self, form: &str, from: u32, to: u32) -> Result<String, JsError> {
        Ok(self.0.text(form, from as usize, to as usize)?)
    }
}
