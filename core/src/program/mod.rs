//! One syntax tree for reading and writing part programs; lossless; a dialect a control.

pub mod tree;
