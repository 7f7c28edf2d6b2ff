//! The plane in which the contour lies, as it is in the machine.

use super::{Element, Point, Round};
use crate::control::Control;
use crate::geometry::{Dir, Mcs, V3, Wcs};
use crate::machine::Route;

/// Unit vectors that differ by less are the same.
const SAME: f64 = 1e-9;

/// Directions of the working plane in machine coordinates, unscaled: the tool is not scaled with the contour.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    /// Along the abscissa, across it in the plane, along the applicate: right-handed.
    axes: [V3; 3],
    /// -1 where the frames mirror, so that what lies to the left in the program lies to the right here.
    hand: f64,
}

impl Plane {
    /// The working plane of the active WCS.
    pub fn of(control: &Control) -> Plane {
        let zero = V3::from(control.to_machine(Wcs([0.0; 3])).0);
        let seen = control.plane.axes().map(|axis| {
            let mut unit = [0.0; 3];
            unit[axis] = 1.0;
            (V3::from(control.to_machine(Wcs(unit)).0) - zero).normalize()
        });
        let [abscissa, ordinate, up] = seen;
        let across = up.cross(&abscissa);
        Plane { axes: [abscissa, across, up], hand: across.dot(&ordinate).signum() }
    }

    /// What left of the contour in another state of the frames is here, 1 or -1; none: the plane is another one.
    pub fn hand_of(&self, other: &Plane) -> Option<f64> {
        let same = self.axes[2].dot(&other.axes[2]);
        (same.abs() > 1.0 - SAME).then(|| same.signum() * other.hand)
    }

    /// A place as abscissa, ordinate and height.
    pub fn split(&self, point: Mcs) -> (Point, f64) {
        let point = V3::from(point);
        let [x, y, height] = self.axes.map(|axis| axis.dot(&point));
        (Point::new(x, y), height)
    }

    /// The place of abscissa, ordinate and height.
    pub fn place(&self, at: Point, height: f64) -> Mcs {
        let [abscissa, across, up] = self.axes;
        (abscissa * at.x + across * at.y + up * height).into()
    }

    /// Direction of the tool, a unit vector.
    pub fn up(&self) -> Dir<Mcs> {
        self.axes[2].into()
    }

    /// A way as it is seen in the plane; none: it is an arc across it.
    pub fn element(&self, way: &Route) -> Option<Element> {
        let sense = way.around.map_or(1.0, |around| self.axes[2].dot(&V3::from(around.axis)));
        if sense.abs() < 1.0 - SAME {
            return None;
        }
        let round = way.around.map(|around| Round {
            centre: self.split(around.centre).0,
            sweep: around.degrees.radians() * sense.signum(),
        });
        Some(Element { start: self.split(way.from).0, end: self.split(way.to).0, round })
    }
}
