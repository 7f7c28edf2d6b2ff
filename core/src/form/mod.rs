//! Catalogue × values → fields to show, and a drawing of them.

mod codes;
mod draw;
mod fields;
pub mod machine;
mod masks;
mod variant;

pub use draw::draw;
#[cfg(feature = "json")]
pub(crate) use fields::fields_by;
pub use fields::{Choice, Entry, Field, Group, fields};
