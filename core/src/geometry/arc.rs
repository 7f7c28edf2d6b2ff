//! An arc about a centre of the plane, as the chords that are driven.

/// Degrees of an arc per chord.
const CHORD: f64 = 3.0;

/// Ends of the chords of an arc from a point about a centre, mm: the last one is the end of the arc. Degrees, positive
/// from the first axis towards the second.
pub fn chords(centre: [f64; 2], from: [f64; 2], degrees: f64) -> Vec<[f64; 2]> {
    let [x, y] = [from[0] - centre[0], from[1] - centre[1]];
    let (radius, first) = (x.hypot(y), y.atan2(x));
    let count = (degrees.abs() / CHORD).ceil().max(1.0) as usize;
    let sweep = degrees.to_radians();
    let end = |part: usize| {
        let angle = first + sweep * part as f64 / count as f64;
        [
            centre[0] + radius * angle.cos(),
            centre[1] + radius * angle.sin(),
        ]
    };
    (1..=count).map(end).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::chords;

    // oracle: hand
    #[test]
    fn a_quarter_is_driven_on_its_circle() {
        for (degrees, end) in [
            (90.0, [5.0, 12.0]),
            (-90.0, [5.0, -8.0]),
            (360.0, [15.0, 2.0]),
        ] {
            let ends = chords([5.0, 2.0], [15.0, 2.0], degrees);
            assert_eq!(ends.len(), (degrees.abs() / 3.0) as usize);
            for [x, y] in &ends {
                assert!(((x - 5.0_f64).hypot(y - 2.0) - 10.0).abs() < 1e-9);
            }
            let [x, y] = ends.last().unwrap();
            assert!((x - end[0]).hypot(y - end[1]) < 1e-9, "{degrees}: {x} {y}");
        }
    }
}
