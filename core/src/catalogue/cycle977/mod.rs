//! CYCLE977: hole, shaft, groove, web and rectangle, measured parallel to the axes (B:5600-6285).

pub mod params;
mod results;
mod variants;

pub use results::RESULTS;
pub use variants::VARIANTS;
