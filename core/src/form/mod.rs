//! Catalogue × values → fields to show, and a drawing of them.

pub mod picture;
