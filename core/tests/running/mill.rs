//! The tool that measurements of a part correct in tests.

use probewright_core::control::{Edge, Tool};

/// An end mill with radius 10 and length 80, mm, the same in each of these D numbers.
pub fn tool(numbers: &[i64]) -> Tool {
    let edge = Edge { kind: 120, length: [80.0, 0.0, 0.0], radius: 10.0, ..Edge::default() };
    Tool { name: "MILL".into(), edges: numbers.iter().map(|number| (*number, edge.clone())).collect() }
}
