//! One syntax tree for reading and writing part programs; lossless; a dialect a control.

mod advice;
pub(crate) mod arguments;
pub mod around;
mod arrivals;
mod block_rules;
pub mod calls;
mod carried;
pub mod change;
pub mod compared;
pub mod convert;
pub mod cure;
pub mod defined_here;
mod findings;
pub mod flow;
mod held;
mod jumped;
pub mod lists;
pub(crate) mod nct_functions;
pub mod of_control;
pub mod others;
mod own_words;
pub mod places;
pub mod probe_test;
pub mod r_parameters;
mod readers;
pub mod revise;
pub mod standard;
pub mod tools;
pub mod touched;
pub mod user_programs;
mod values;
pub mod variables;
pub mod words;

pub use arrivals::arrivals;
pub use findings::{findings, findings_of, findings_on, not_understood};
pub mod write;
