//! The turning tool that tests measure, correct or follow.

use probewright_core::control::{Edge, Tool};

/// A turning tool with cutting edge position 3, L1 60 and L2 40, in D1; radius of its nose, mm.
pub fn tool(radius: f64) -> Tool {
    let edge = Edge { kind: 500, tip: 3, length: [60.0, 40.0, 0.0], radius, ..Edge::default() };
    Tool { name: "TURNING".into(), edges: [(1, edge)].into() }
}
