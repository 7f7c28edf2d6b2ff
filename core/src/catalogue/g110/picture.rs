//! Bore or boss from above, with clearance, overtravel and tolerance.

use super::BOSS;
use crate::check::Inputs;
use crate::form::picture::{Picture, PictureShape, ShapeKind, View};

const BALL: f64 = 3.0;

/// Circles about the centre, and the ways to the four walls.
pub fn picture(inputs: &Inputs) -> Picture {
    let given = |name: &str, otherwise: f64| inputs.numbers.get(name).copied().unwrap_or(otherwise);
    let boss = inputs.variant == BOSS;
    let radius = given("D", 50.0).abs() / 2.0;
    let side = if boss { 1.0 } else { -1.0 };
    let contact = (radius + side * BALL).max(0.0);
    let from = if boss {
        contact + given("R", 5.0).abs()
    } else {
        0.0
    };
    let limit = if boss {
        radius - given("Q", 10.0).abs()
    } else {
        radius + given("Q", 10.0).abs()
    };
    let mut shapes = vec![
        circle(ShapeKind::Edge, radius, Some("D")),
        circle(ShapeKind::Zone, limit.max(0.0), Some("Q")),
        line(
            ShapeKind::Dimension,
            [-radius, 0.0],
            [radius, 0.0],
            Some("D"),
        ),
    ];
    if boss {
        shapes.push(line(
            ShapeKind::Dimension,
            [contact, 0.0],
            [from, 0.0],
            Some("R"),
        ));
    }
    for (name, kind) in [("H", ShapeKind::Tolerance), ("U", ShapeKind::Zone)] {
        if let Some(limit) = inputs.numbers.get(name) {
            let half = limit.abs() / 2.0;
            shapes.push(circle(kind, radius + half, Some(name)));
            shapes.push(circle(kind, (radius - half).max(0.0), Some(name)));
        }
    }
    for [x, y] in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]] {
        shapes.push(line(
            ShapeKind::Path,
            [x * from, y * from],
            [x * contact, y * contact],
            None,
        ));
        shapes.push(PictureShape {
            points: vec![[x * radius, y * radius]],
            ..line(ShapeKind::Touch, [0.0; 2], [0.0; 2], None)
        });
    }
    shapes.push(circle(ShapeKind::Probe, BALL, None));
    Picture {
        view: View::Plane,
        shapes,
    }
}

fn circle(kind: ShapeKind, radius: f64, field: Option<&'static str>) -> PictureShape {
    PictureShape {
        kind,
        points: Vec::new(),
        circle: Some(([0.0; 2], radius)),
        closed: true,
        text: None,
        field,
    }
}

fn line(
    kind: ShapeKind,
    from: [f64; 2],
    to: [f64; 2],
    field: Option<&'static str>,
) -> PictureShape {
    PictureShape {
        kind,
        points: vec![from, to],
        circle: None,
        closed: false,
        text: field.map(String::from),
        field,
    }
}
