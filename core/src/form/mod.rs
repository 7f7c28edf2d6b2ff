//! Catalogue × values → fields to show, and a drawing of them.

mod chain;
mod codes;
mod draw;
pub mod equipment;
mod fields;
pub mod machine;
mod masks;
mod variant;

pub use chain::{Bar, Chain, Limit, chain};
pub use draw::draw;
pub use fields::{Choice, Entry, Field, Group, argument_entry, fields};
#[cfg(feature = "json")]
pub(crate) use fields::{fields_by, name_arguments, of_list, take_numbers};
