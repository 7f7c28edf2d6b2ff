//! The reference grooves of a turning machine, in `_KB[]` (B:13473-13482).

use crate::control::Control;

/// Index of the upper face in `_KB` and of the base below it: both grooves of a pair have the same depth (B:13480).
const DEPTH: [usize; 2] = [5, 6];

/// One of the two grooves of a pair, seen by a probe with cutting edge position 7 or 8.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Groove {
    /// Axes of the plane, 0 abscissa and 1 ordinate: across the walls, and of the base.
    pub axes: [usize; 2],
    /// Second indices of its data in `_KB`: edge in plus direction, edge in minus direction, base.
    data: [usize; 3],
}

/// A groove by its data; machine coordinates, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Axes of the plane, 0 abscissa and 1 ordinate: across the walls, and of the base.
    pub axes: [usize; 2],
    /// Wall touched in plus direction, wall touched in minus direction.
    pub walls: [f64; 2],
    /// Base.
    pub base: f64,
    /// Depth; 0 where the data do not tell it.
    pub depth: f64,
}

impl Groove {
    /// The groove of a cutting edge position.
    pub fn of(tip: i64) -> Option<Groove> {
        match tip {
            7 => Some(Groove { axes: [1, 0], data: [0, 1, 2] }),
            8 => Some(Groove { axes: [0, 1], data: [3, 4, 6] }),
            _ => None,
        }
    }

    /// Names of its data in a pair, counted from 0.
    pub fn names(&self, pair: i64) -> [String; 3] {
        self.data.map(|index| format!("_KB[{pair},{index}]"))
    }

    /// Where it is.
    pub fn place(&self, control: &Control, pair: i64) -> Place {
        let [plus, minus, base] = self.names(pair).map(|name| control.basic_length(&name));
        let [upper, lower] = DEPTH.map(|index| control.basic_length(&format!("_KB[{pair},{index}]")));
        Place { axes: self.axes, walls: [plus, minus], base, depth: (upper - lower).max(0.0) }
    }
}

impl Place {
    /// Middle between the walls, machine coordinates, mm.
    pub fn centre(&self) -> f64 {
        (self.walls[0] + self.walls[1]) / 2.0
    }

    /// Distance of the walls, mm.
    pub fn width(&self) -> f64 {
        self.walls[0] - self.walls[1]
    }

    /// Height of a ball of this radius over the base while the walls are touched: half of the depth, and clear of the
    /// base; without a depth where the base is touched from.
    pub fn height(&self, radius: f64, path: f64) -> f64 {
        let middle = self.depth / 2.0;
        self.base + if middle > radius { middle } else { radius + path }
    }

    /// How far before the set switching position a wall is touched from: all of the path, as long as the ball stays
    /// clear of the other wall, else from the middle.
    pub fn path(&self, radius: f64, path: f64) -> f64 {
        let room = self.width() - 2.0 * radius;
        if path < room || room <= 0.0 { path } else { room / 2.0 }
    }
}
