//! What holds for every measurement, whatever is measured on whatever machine: machine, data, call and part are drawn
//! at random, and each property looks at all of them. Combinations are where a rule that is right for each of its parts
//! goes wrong.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod again;
mod bits;
mod draw;
mod only;
mod said;
mod same;
mod stand;
mod view;
