//! The workpiece probe by its tool data: whether the milling cycles may be called with it, and where its body lies.

use super::{Control, Edge, Plane, tools::side};
use crate::geometry::{Dir, Mcs, V3};

/// Type of a 3D probe.
pub const PROBE: i64 = 710;

/// Why a tool is none with which a milling cycle may be called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unfit {
    /// The type is none of 1x0, 710 and 5xy (B:4147-4150).
    Type,
    /// The type is 1xy with another last digit than 0: a probe by B:906-910, none by B:4147. No call is refused.
    Digit,
    /// It is a turning tool, and the lengths are not assigned as on a turning machine: SD 42950 is not 2 (B:4151).
    Assignment,
    /// It is a turning tool with another cutting edge position than 5 to 8 (B:4150).
    Tip,
    /// The body does not stand on this plane: 5 and 7 measure in G17, 6 and 8 in G19 (B:4152).
    Plane,
}

impl Control {
    /// Whether a milling cycle may be called with this tool now, in the order of B:4147-4152.
    pub fn unfit(&self, edge: &Edge) -> Option<Unfit> {
        match edge.kind {
            PROBE => None,
            100..=199 if edge.kind % 10 == 0 => None,
            100..=199 => Some(Unfit::Digit),
            _ if !edge.is_turning() => Some(Unfit::Type),
            _ if edge.tip != 0 && edge.body().is_none() => Some(Unfit::Tip),
            _ if !self.all_as_turning_tools() => Some(Unfit::Assignment),
            _ => match (edge.tip, self.plane) {
                (5 | 7, Plane::G17) | (6 | 8, Plane::G19) => None,
                (5..=8, _) => Some(Unfit::Plane),
                _ => Some(Unfit::Tip),
            },
        }
    }

    /// Direction from the ball to the body of the probe, X Y Z of the machine: [`Edge::stands`], or the applicate.
    pub fn stands(&self) -> Dir<Mcs> {
        self.active_edge().and_then(Edge::stands).unwrap_or_else(|| upright(self.plane))
    }
}

/// Along the applicate of a plane.
pub fn upright(plane: Plane) -> Dir<Mcs> {
    let [_, _, applicate] = plane.axes();
    V3::ith(applicate, 1.0).into()
}

impl Edge {
    /// Direction from the ball of a turning machine's probe to its body, as abscissa and ordinate of the plane in which
    /// its cutting edge position counts: with 5 and 7 it lies along the abscissa, with 6 and 8 along the ordinate, and
    /// 7 and 8 point in minus direction (B:974-1022, B:13474-13481).
    pub fn body(&self) -> Option<[f64; 2]> {
        let lies = self.is_turning() && (5..=8).contains(&self.tip);
        lies.then(|| side(self.tip, false).map(|towards| 0.0 - towards)) // the body is behind P
    }

    /// Direction from the ball to its body on the machine, X Y Z: the cutting edge position is that of G18, as no plane
    /// turns the probe. So it stands on G17 with 5 and 7, on G19 with 6 and 8 (B:4152).
    pub fn stands(&self) -> Option<Dir<Mcs>> {
        self.body().map(|[z, x]| Dir::new([x, 0.0, z]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::{TOOL_LENGTH_TYPE, delivery};
    use crate::dialect::Dialect;

    fn edge(kind: i64, tip: i64) -> Edge {
        Edge { kind, tip, ..Edge::default() }
    }

    #[test]
    fn types_of_a_probe() {
        let control = delivery(Dialect::Sinumerik);
        // oracle: manual B:4147, B:766, B:906-910 (1x0 and 710 always; 1xy in one place only)
        for (kind, unfit) in [
            (710, None),
            (100, None),
            (120, None),
            (145, Some(Unfit::Digit)),
            (0, Some(Unfit::Type)),
            (220, Some(Unfit::Type)),
            (711, Some(Unfit::Type)),
            (500, Some(Unfit::Assignment)),
        ] {
            assert_eq!(control.unfit(&edge(kind, 0)), unfit, "{kind}");
        }
    }

    #[test]
    fn the_probe_of_a_turning_machine_measures_where_it_stands_on_the_plane() {
        let mut control = delivery(Dialect::Sinumerik);
        control.set(TOOL_LENGTH_TYPE, 2.0);
        // oracle: manual B:4149-4152
        for plane in [Plane::G17, Plane::G18, Plane::G19] {
            control.plane = plane;
            for tip in 0..10 {
                let unfit = match (tip, plane) {
                    (5 | 7, Plane::G17) | (6 | 8, Plane::G19) => None,
                    (5..=8, _) => Some(Unfit::Plane),
                    _ => Some(Unfit::Tip),
                };
                for kind in [500, 580] {
                    let edge = edge(kind, tip);
                    assert_eq!(control.unfit(&edge), unfit, "{plane:?} {tip}");
                    let stands = edge.stands();
                    let along = stands.map(|to| to.map(f64::abs) == upright(plane).0);
                    assert_eq!(along == Some(true), unfit.is_none(), "{plane:?} {tip}");
                }
            }
        }
    }
}
