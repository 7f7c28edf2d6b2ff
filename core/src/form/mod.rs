//! Catalogue × values → fields to show, and a drawing of them.

mod chain;
mod codes;
mod draw;
pub mod equipment;
mod fields;
mod listed;
pub mod machine;
mod masks;
mod refit;
mod variant;

pub use chain::{Bar, Chain, Limit, chain};
pub use codes::known_variants;
pub use draw::draw;
pub use fields::{Choice, Entry, Field, Group, fields};
pub use listed::{argument_entry, fields_of_call};
pub use refit::{Unfit, unfit};
#[cfg(feature = "json")]
pub(crate) use {
    fields::fields_by,
    listed::{Listed, beside, name_arguments},
};
