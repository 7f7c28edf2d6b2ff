//! One syntax tree for reading and writing part programs; lossless; a dialect a control.

mod block;
mod bytes;
mod expression;
mod keyword;
mod nct;
mod nct_expression;
mod number;
pub mod position;
mod reader;
mod sinumerik;
mod sinumerik_expression;
pub mod tree;

pub use block::read;
pub use tree::Program;
pub mod write;
