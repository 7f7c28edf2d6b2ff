//! CYCLE977: hole, shaft, groove, web and rectangle, measured parallel to the axes (B:5600-6285).

mod element;
pub mod params;
mod results;
pub mod simulate;
mod variants;

pub use results::RESULTS;
pub use variants::VARIANTS;
