//! One syntax tree for reading and writing part programs; lossless; a dialect a control.

mod advice;
pub(crate) mod arguments;
mod arrivals;
mod block;
mod block_rules;
mod bytes;
pub mod calls;
pub mod change;
pub mod convert;
mod expression;
mod findings;
pub mod flow;
mod fold;
mod held;
mod keyword;
mod marked;
mod nct;
mod nct_expression;
mod number;
pub mod position;
mod reader;
mod single;
mod sinumerik;
mod sinumerik_expression;
pub mod tools;
pub mod tree;
mod values;

pub use arrivals::arrivals;
pub use block::{read, read_told};
pub use findings::{findings, findings_of, findings_on, not_understood};
pub use single::is_value;
pub use tree::Program;
pub mod write;
