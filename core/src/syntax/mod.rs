//! Part programs as text: one lossless tree for reading and writing, in the language of each control. Reading never
//! fails; what is not understood is kept and said.

mod block;
mod bytes;
mod expression;
pub mod fold;
mod grammar;
mod keyword;
pub mod language;
pub mod links;
mod nct;
mod nct_expression;
mod number;
pub mod position;
pub mod programs;
mod reader;
mod single;
mod sinumerik;
mod sinumerik_expression;
pub mod tree;

pub(crate) use block::BETWEEN;
pub use block::{read, read_told};
pub(crate) use grammar::Grammar;
pub use single::is_value;
pub use tree::{Block, Expr, ExprId, Operator, Program, SyntaxError, Word, WordKind};
