//! What a setup and its trace look like.

pub mod plan;
mod plan_solid;
