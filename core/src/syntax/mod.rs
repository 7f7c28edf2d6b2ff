//! Part programs as text: one lossless tree, in the language of each control. What is not understood is kept and said.

pub(crate) mod arithmetic;
mod block;
mod bytes;
pub mod definitions;
mod expression;
pub mod fold;
mod grammar;
mod grown;
pub mod joined;
mod keyword;
pub mod language;
pub mod links;
pub mod macros;
mod nct;
mod nct_expression;
pub(crate) mod number;
mod pieces;
pub mod plain;
pub mod position;
pub mod programs;
mod reader;
mod sinumerik;
mod sinumerik_expression;
pub mod targets;
pub mod tree;

pub(crate) use block::BETWEEN;
pub use block::{LARGEST, is_value, is_value_of, read, read_held, read_lean, read_on};
pub(crate) use grammar::Grammar;
pub use plain::Plain;
pub use reader::DEPTH;
pub use tree::{Block, Expr, ExprId, Operator, Program, SyntaxError, Word, WordKind};
