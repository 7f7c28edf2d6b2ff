//! Draws the 3D view: flat arrays in, pixels out. Knows no cycle and no trace; the page builds the geometry.
//!
//! Drawing happens only when [`Renderer::render`] is called. Lengths are millimetres relative to an origin that the
//! caller subtracts first (single precision), screen lengths are device pixels, colours are sRGB with straight alpha.
#![cfg(target_arch = "wasm32")]

mod cloud;
mod gpu;
mod layout;
mod path;
mod pipelines;
mod renderer;
mod scene;
mod sky;
mod target;
mod texel;

pub use renderer::Renderer;
