//! First contact of a ball on a straight way with a wall that is out of round.
//!
//! The square of the distance from anything, less the square of the way, is concave along a straight way: of each point
//! of the thing it is linear, and the least of linear functions is concave. So the distances at two places bound those
//! between them from below, and a long stretch is told free at once. Of straight lines, which an endless wall is made
//! of, the part of the way across them counts only: along the wall nothing is lost.

use super::LobedWall;
use crate::geometry::{Path, TOLERANCE, roots};

/// From where on the place of the wall that is nearest is sought, mm off it.
const NEAR: f64 = 0.01;
/// From where on the contact is closed in by the slope of the distance, mm off it, and how fast it has to close.
const CLOSE: f64 = 1e-3;
/// Places looked at after which what is grazed is passed over sooner and sooner; see `Search::slack`.
const LOOKS: usize = 300;
/// What the squares of distances and ways lose, as a part of them.
const ROUNDING: f64 = 4e-16;

impl LobedWall {
    /// Length after which a ball of this radius begins to touch the wall.
    pub fn first(&self, path: &Path, radius: f64) -> Option<f64> {
        Search { wall: self, path, radius, across: self.across(path), looked: 0 }.first()
    }

    /// The largest part of a way across a line of the wall, squared; none where it may come to where the lines meet.
    fn across(&self, path: &Path) -> Option<f64> {
        let slope = self.lobes.slope;
        let far = path.from.norm() + path.length + self.depth;
        if slope.abs() * far > 0.5 * self.lobes.radius {
            return None;
        }
        let aside = slope.abs() * path.direction.xy().norm();
        let along = (path.direction.z.abs() - aside).max(0.0) / slope.hypot(1.0);
        Some((1.0 - along * along).max(0.0))
    }
}

/// A place of the way and the distances there, mm; those that take long only when they are asked for.
struct Place {
    way: f64,
    /// Distance, and how it changes.
    exact: Option<[f64; 2]>,
    /// Distance from the wall without rims.
    endless: Option<f64>,
}

impl Place {
    fn at(way: f64) -> Place {
        Place { way, exact: None, endless: None }
    }
}

struct Search<'a> {
    wall: &'a LobedWall,
    path: &'a Path,
    radius: f64,
    across: Option<f64>,
    /// How many nearest places were sought.
    looked: usize,
}

impl Search<'_> {
    fn first(&mut self) -> Option<f64> {
        let mut here = Place::at(0.0);
        let mut step = self.path.length;
        let mut leaving = TOLERANCE;
        loop {
            let [free, slope] = self.free(&mut here);
            if free < CLOSE
                && slope < -CLOSE
                && let Some(root) = roots::newton(|s| self.gap(s), here.way)
            {
                return (root > 0.0 && root <= self.path.length).then_some(root);
            }
            let touches = free < 0.1 * TOLERANCE;
            if touches && slope < 0.0 {
                return (here.way > 0.0).then_some(here.way);
            }
            let sure = if touches { leaving } else { free }.max(self.slack());
            leaving = if touches { 2.0 * leaving } else { TOLERANCE };
            let there = here.way + step.max(sure);
            let mut there = Place::at(there.min(self.path.length));
            if step > sure && !self.clears(&mut here, &mut there) {
                step = (0.3 * step).max(sure);
                continue;
            }
            if there.way >= self.path.length {
                return None;
            }
            step = 2.0 * (there.way - here.way);
            here = there;
        }
    }

    /// How far the ball is from the wall, and how that changes, which is not told far away.
    fn free(&mut self, place: &mut Place) -> [f64; 2] {
        let surely = self.wall.at_least(&self.path.at(place.way)) - self.radius;
        if surely > NEAR {
            return [surely, 0.0];
        }
        let [distance, slope] = self.exact(place);
        [distance - self.radius, slope]
    }

    /// Whether the ball stays clear between two places.
    fn clears(&mut self, here: &mut Place, there: &mut Place) -> bool {
        let half = (there.way - here.way) / 2.0;
        let ways = [here.way, there.way];
        let rims = [0.0, self.wall.depth];
        let reach = self.radius + self.wall.lobes.amplitude.abs();
        let mean = |rims| ways.map(|way| self.wall.off_mean(&self.path.at(way), rims));
        if stays_beyond(mean(rims), half, 1.0, reach) {
            return true;
        }
        if let Some(across) = self.across
            && stays_beyond(mean(ENDLESS), half, across, reach)
        {
            return true;
        }
        let reach = self.radius;
        let exact = [self.exact(here)[0], self.exact(there)[0]];
        if stays_beyond(exact, half, 1.0, reach) {
            return true;
        }
        self.across.is_some_and(|across| {
            across < 0.5 && {
                let endless = [self.endless(here), self.endless(there)];
                stays_beyond(endless, half, across, reach)
            }
        })
    }

    /// How far the ball goes at least from a place where it is free, mm: what it grazes meanwhile is passed over. It
    /// grows where the ball goes along the wall so near that it would be looked at too often.
    fn slack(&self) -> f64 {
        let beyond = self.looked.saturating_sub(LOOKS).min(60);
        0.1 * TOLERANCE * (1_u64 << beyond) as f64
    }

    fn exact(&mut self, place: &mut Place) -> [f64; 2] {
        let (wall, path) = (self.wall, self.path);
        let looked = &mut self.looked;
        *place.exact.get_or_insert_with(|| {
            *looked += 1;
            distance(wall, path, place.way)
        })
    }

    fn endless(&mut self, place: &mut Place) -> f64 {
        let p = self.path.at(place.way);
        let (wall, looked) = (self.wall, &mut self.looked);
        *place.endless.get_or_insert_with(|| {
            *looked += 1;
            (p - wall.foot_between(&p, ENDLESS)).norm()
        })
    }

    fn gap(&self, way: f64) -> (f64, f64) {
        let [distance, slope] = distance(self.wall, self.path, way);
        (distance - self.radius, slope)
    }
}

/// Depths of a wall without rims.
const ENDLESS: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// Distance from the wall, and how it changes with the way.
fn distance(wall: &LobedWall, path: &Path, way: f64) -> [f64; 2] {
    let p = path.at(way);
    let away = p - wall.foot(&p);
    let distance = away.norm();
    [distance, away.dot(&path.direction) / distance]
}

/// Whether something stays farther away than `reach` between two places that are `2·half` apart, where it has these
/// distances; `across`: the largest part of the way that leads across it, squared.
fn stays_beyond([here, there]: [f64; 2], half: f64, across: f64, reach: f64) -> bool {
    let [here, there] = [here * here, there * there];
    let growth = (there - here) / (2.0 * half);
    let least = match growth.abs() < 2.0 * across * half {
        true => (here + there) / 2.0 - across * half * half - growth * growth / (4.0 * across),
        false => here.min(there),
    };
    least > reach * reach + ROUNDING * (here + there + half * half)
}

#[cfg(test)]
mod tests {
    use super::super::Lobes;
    use super::*;
    use crate::geometry::V3;
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    fn search(wall: &LobedWall, path: &Path, radius: f64) -> (Option<f64>, usize) {
        let mut search = Search { wall, path, radius, across: wall.across(path), looked: 0 };
        (search.first(), search.looked)
    }

    /// Walls, balls, and ways of which some run along the wall.
    fn cases() -> impl Strategy<Value = (LobedWall, Path, f64)> {
        let wall = (2.0..80.0, -4.0..0.0, 1..13_u32, -0.05..0.05).prop_map(
            |(radius, amplitude, count, slope): (f64, f64, u32, f64)| {
                let amplitude = 10_f64.powf(amplitude) * 0.3;
                let lobes = Lobes { radius, slope, amplitude, count };
                LobedWall { lobes, depth: 40.0 }
            },
        );
        let ball = prop_oneof![Just(0.0), 0.3..0.7, 1.0..4.0];
        let place = (0.0..TAU, -45.0..10.0, -7.0..1.0, any::<bool>());
        let way = (0..3_usize, 0.0..TAU, -1.0..1.0, 0.5..60.0);
        (wall, ball, place, way).prop_map(|(wall, ball, (angle, z, gap, within), way)| {
            let ball: f64 = ball;
            let gap = 10_f64.powf(gap);
            let radius = wall.lobes.radius - wall.lobes.slope * z;
            let out = if within { radius - ball - gap } else { radius + ball + gap };
            let from = V3::new(out * angle.cos(), out * angle.sin(), z);
            let (kind, turn, climb, length): (usize, f64, f64, f64) = way;
            let direction = match kind {
                0 => V3::new(0.0, 0.0, climb.signum()),
                1 => V3::new(-angle.sin(), angle.cos(), climb * 1e-3),
                _ => V3::new(turn.cos(), turn.sin(), climb),
            };
            let path = Path::new(from, from + direction.normalize() * length);
            (wall, path, ball)
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(150))]

        // oracle: self, by looking everywhere: before the contact the ball is free, at it its distance is its radius,
        // and however it goes along the wall few places are looked at
        #[test]
        fn a_ball_is_free_until_it_touches((wall, path, radius) in cases()) {
            let gap = |s: f64| distance(&wall, &path, s)[0] - radius;
            prop_assume!(gap(0.0) > TOLERANCE);
            let (met, looked) = search(&wall, &path, radius);
            prop_assert!(looked < 400, "{looked}");
            let end = met.unwrap_or(path.length);
            let coarse = if looked > LOOKS { 1e-3 } else { 2e-9 };
            for part in 0..=300 {
                let s = end * f64::from(part) / 300.0;
                prop_assert!(gap(s) > -coarse, "{s} of {end}: {}", gap(s));
            }
            if let Some(s) = met {
                prop_assert!(gap(s).abs() < 2e-9, "{s}: {}", gap(s));
            }
        }
    }

    // oracle: hand: upright along a cylinder with lobes the distance does not change, whatever it is
    #[test]
    fn along_the_wall_two_looks_will_do() {
        let lobes = Lobes { radius: 10.0, slope: 0.0, amplitude: 0.05, count: 3 };
        let wall = LobedWall { lobes, depth: 40.0 };
        for gap in [1e-6, 1e-3, 0.04] {
            let from = V3::new(10.05 - 0.5 - gap, 0.0, -1.0);
            let path = Path::new(from, from - V3::z() * 30.0);
            let (met, looked) = search(&wall, &path, 0.5);
            assert_eq!(met, None);
            assert!(looked < 10, "{gap}: {looked}");
        }
    }
}
