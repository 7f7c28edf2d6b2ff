//! Questions to the core as the page asks them, and what comes back. The build asks the core as it runs natively, the
//! test asks the module in the browser; what they are told has to be the same.

pub mod ask;
pub mod same;
