//! A measuring block along any direction of the plane, both axes moving at once (B:6835-6858, B:8453-8467).
//!
//! What the probe is worth in such a direction follows from its active ball and its skew: the ball centre stands on the
//! line, and the surface lies the radius of the active ball before it. Along an axis this is the trigger value, which
//! is stored with the skew in it.

use super::Way;
use crate::catalogue::prelude::*;

/// A surface to be touched along any direction of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Direction of the probe from the abscissa towards the ordinate.
    pub angle: Degrees,
    /// Where the surface is expected: abscissa, ordinate, mm.
    pub set: [f64; 2],
    /// Distance of start and end from the set switching position, mm.
    pub path: f64,
}

impl Ray {
    /// Towards the point of a circle, or of two walls opposite each other, that lies at this angle from its centre:
    /// from within or from outside; mm.
    pub fn at(angle: Degrees, centre: [f64; 2], radius: f64, inside: bool, path: f64) -> Ray {
        let (sine, cosine) = angle.sin_cos();
        let set = [centre[0] + radius * cosine, centre[1] + radius * sine];
        Ray { angle: if inside { angle } else { angle + Degrees(180.0) }, set, path }
    }

    /// Unit vector of the direction: abscissa, ordinate.
    pub fn direction(&self) -> [f64; 2] {
        let (sine, cosine) = self.angle.sin_cos();
        [cosine, sine]
    }
}

impl Block {
    /// Start of the block: abscissa and ordinate of the spindle axis, mm, the ball `path` before the set surface.
    pub fn start_along(&self, ray: &Ray) -> [f64; 2] {
        self.on(ray, -ray.path)
    }

    /// Where the spindle axis stands when the ball, on the ray, is `beyond` the set switching position.
    fn on(&self, ray: &Ray, beyond: f64) -> [f64; 2] {
        let direction = ray.direction();
        let way = beyond - self.ball;
        std::array::from_fn(|i| ray.set[i] + direction[i] * way - self.skew[i])
    }

    /// Moves straight to the start of the block, touches the surface `_NMSP` times and returns to the start. Where the
    /// ball centre stood at switching, abscissa and ordinate, mm: its distance from the surface is the radius of the
    /// active ball, wherever it met it.
    pub fn ball_along(&self, machine: &mut dyn Machine, ray: &Ray) -> Result<[f64; 2], Stop> {
        let [x, y] = self.latch_along(machine, ray)?;
        Ok([x + self.skew[0], y + self.skew[1]])
    }

    /// Touches as [`Block::ball_along`] does; mean position of the spindle at switching, abscissa and ordinate, mm.
    pub fn latch_along(&self, machine: &mut dyn Machine, ray: &Ray) -> Result<[f64; 2], Stop> {
        self.orient(machine, ray.angle);
        let here = machine.position().0;
        let way = Way {
            start: Wcs(self.placed(here, self.start_along(ray))),
            end: Wcs(self.placed(here, self.on(ray, ray.path))),
            direction: self.placed([0.0; 3], ray.direction()),
        };
        self.travel(machine, way.start)?;
        let position = self.mean(machine, &way)?;
        Ok([position[self.axes[0]], position[self.axes[1]]])
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

    use super::*;
    use crate::catalogue::sinumerik::testing::{at, call, setup, solid, stopped};
    use crate::control::{MachineSort, Plane};
    use crate::geometry::{Mcs, Rpy};
    use crate::machine::Setup;
    use crate::machine::sim::Sim;
    use crate::machine::trace::{MotionKind, Step};
    use crate::workpiece::Shape;
    use proptest::prelude::*;

    const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];
    /// Width of the web that is touched, mm.
    const WIDTH: f64 = 40.0;
    /// Where its middle stands.
    const MIDDLE: [f64; 2] = [12.0, -7.0];

    /// Coordinate of the touched surface along the ray, mm.
    fn surface(block: &Block, sim: &mut Sim, ray: &Ray) -> Result<f64, Stop> {
        let [abscissa, ordinate] = ray.direction();
        let [x, y] = block.ball_along(sim, ray)?;
        Ok(x * abscissa + y * ordinate + block.ball)
    }

    /// A web turned by `angle`, its wall moved outwards by half of `grown`, and a probe beside it.
    fn web(plane: Plane, angle: f64, grown: f64) -> Setup {
        let mut setup = setup(plane);
        let shape = Shape::Web { width: WIDTH, height: 30.0, length: 60.0 };
        let mut web = solid(plane, shape, [MIDDLE[0], MIDDLE[1], 0.0], false);
        web.errors.tilt = Rpy(at(plane, [0.0, 0.0, angle]));
        web.errors.size = grown;
        setup.workpiece.solids.push(web);
        let (sine, cosine) = Degrees(angle).sin_cos();
        let far = WIDTH / 2.0 + 20.0;
        setup.position = Mcs(at(plane, [MIDDLE[0] + cosine * far, MIDDLE[1] + sine * far, -10.0]));
        setup
    }

    /// Towards the wall whose outward normal stands at `angle`.
    fn ray(angle: f64) -> Ray {
        let (sine, cosine) = Degrees(angle).sin_cos();
        Ray {
            angle: Degrees(angle + 180.0),
            set: [MIDDLE[0] + cosine * WIDTH / 2.0, MIDDLE[1] + sine * WIDTH / 2.0],
            path: 4.0,
        }
    }

    fn block(sim: &mut Sim, values: &[(&'static str, f64)]) -> Block {
        sim.measuring = Some(MachineSort::Milling);
        Block::prepare(sim, &call("CYCLE979", 1, values)).unwrap()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]

        // oracle: hand (the wall as it was made; the active ball is smaller by the pre-travel)
        #[test]
        fn a_wall_at_any_angle_is_found_with_a_skewed_probe(
            angle in -360.0..360.0_f64, grown in -2.0..2.0_f64, skew in prop::array::uniform2(-1.0..1.0_f64),
            late in 0.0..0.1_f64, plane in 0..3_usize,
        ) {
            let plane = PLANES[plane];
            let mut setup = web(plane, angle, grown);
            setup.probe.skew = skew;
            setup.probe.pre_travel.0 = late;
            let data = [(0, 2.0 * (3.0 - late)), (7, skew[0]), (8, skew[1])];
            data.iter().for_each(|(i, value)| setup.control.set(format!("_WP[0,{i}]"), *value));
            let mut sim = Sim::new(&setup);
            let block = block(&mut sim, &[("_FA", 4.0), ("_NMSP", 2.0)]);
            let ray = ray(angle);
            let [x, y] = ray.direction();
            let found = surface(&block, &mut sim, &ray).unwrap();
            let wall = ray.set[0] * x + ray.set[1] * y - grown / 2.0;
            prop_assert!((found - wall).abs() < 1e-9, "{found} {wall}");
            let start = block.start_along(&ray);
            for (axis, wanted) in plane.axes().into_iter().zip([start[0], start[1], -10.0]) {
                prop_assert!((sim.position[axis] - wanted).abs() < 1e-9, "{:?}", sim.position);
            }
            let ball = block.ball_along(&mut sim, &ray).unwrap();
            let from_middle = (ball[0] - MIDDLE[0]) * y - (ball[1] - MIDDLE[1]) * x;
            prop_assert!(from_middle.abs() < 1e-9, "off the line by {from_middle}");
        }

        // oracle: self (along an axis both ways of measuring are the same one, where trigger values, active ball and
        // skew come from one calibration: sequence of B:13441-13463)
        #[test]
        fn along_an_axis_it_is_the_trigger_value(skew in prop::array::uniform2(-1.0..1.0_f64), ball in 0.5..4.0_f64) {
            let mut setup = setup(Plane::G17);
            let [x, y] = skew;
            let data = [2.0 * ball, ball - x, -ball - x, ball - y, -ball - y, ball, -ball, x, y];
            (0..9).for_each(|i| setup.control.set(format!("_WP[0,{i}]"), data[i]));
            let mut sim = Sim::new(&setup);
            let block = block(&mut sim, &[]);
            for (angle, axis, direction) in [(0.0, 0, 1.0), (90.0, 1, 1.0), (180.0, 0, -1.0), (-90.0, 1, -1.0)] {
                let ray = Ray { angle: Degrees(angle), set: [0.0; 2], path: block.path };
                let start = block.start(&block.point(axis, direction, 0.0));
                prop_assert!((block.start_along(&ray)[axis] - start).abs() < 1e-12, "{angle}");
            }
        }
    }

    #[test]
    fn all_motions_lie_on_one_line() {
        // oracle: manual B:13772, B:2164-2170: fast, back by 2 mm, slowly, back to the start
        let mut setup = web(Plane::G17, 30.0, 0.0);
        setup.control.set("_CHBIT[17]", 1.0);
        let mut sim = Sim::new(&setup);
        let block = block(&mut sim, &[("_FA", 4.0)]);
        surface(&block, &mut sim, &ray(30.0)).unwrap();
        let away = |to: [f64; 3]| {
            let (sine, cosine) = Degrees(30.0).sin_cos();
            let (x, y) = (to[0] - MIDDLE[0], to[1] - MIDDLE[1]);
            assert!((y * cosine - x * sine).abs() < 1e-9, "{to:?}");
            ((x * cosine + y * sine - WIDTH / 2.0 - 3.0) * 1e6).round() / 1e6
        };
        let motions: Vec<(MotionKind, f64, f64)> = sim
            .trace
            .entries
            .iter()
            .filter_map(|entry| match entry.step {
                Step::Motion { kind, to, feed, .. } => Some((kind, away(to.0), feed)),
                _ => None,
            })
            .collect();
        use MotionKind::{Measuring, Positioning, Retract};
        assert_eq!(
            motions,
            [
                (Positioning, 4.0, 1000.0),
                (Measuring, 0.0, 900.0),
                (Retract, 2.0, 1000.0),
                (Measuring, 0.0, 300.0),
                (Retract, 4.0, 1000.0)
            ]
        );
    }

    #[test]
    fn a_mono_probe_looks_along_the_ray() {
        // oracle: manual B:864-871, B:13624-13626
        let mut sim = Sim::new(&web(Plane::G17, 30.0, 0.0));
        sim.control.set("_CBIT[8]", 1.0);
        let block = block(&mut sim, &[("_PRNUM", 101.0), ("_CORA", 5.0), ("_FA", 4.0)]);
        surface(&block, &mut sim, &ray(30.0)).unwrap();
        assert_eq!(sim.control.spindle.0, 155.0);
    }

    #[test]
    fn a_wall_that_is_not_there_or_beyond_a_limit_switch_is_told() {
        // oracle: manual A:15842, A:15920: the wall is touched at X 12 + 23 cos 30 = 31.9
        let outcome = |size: f64, limit: Option<f64>| {
            let mut sim = Sim::new(&web(Plane::G17, 30.0, size));
            sim.control.limits.minus[0] = limit;
            let block = block(&mut sim, &[("_FA", 4.0)]);
            surface(&block, &mut sim, &ray(30.0)).map(|_| ())
        };
        assert_eq!(outcome(0.0, None), Ok(()));
        assert_eq!(outcome(0.0, Some(31.9)), Ok(()));
        assert_eq!(stopped(outcome(-9.0, None)), 61301);
        assert_eq!(stopped(outcome(0.0, Some(32.0))), 61401);
        assert_eq!(stopped(outcome(0.0, Some(36.0))), 61401);
    }

    #[test]
    fn an_arc_keeps_the_ball_at_its_distance() {
        // oracle: hand (skew of 0.4, 0.3: the spindle axis goes round a centre that lies beside)
        for plane in PLANES {
            let mut setup = setup(plane);
            [(7, 0.4), (8, 0.3)].iter().for_each(|(i, value)| {
                setup.control.set(format!("_WP[0,{i}]"), *value);
            });
            setup.position = Mcs(at(plane, [19.6, -0.3, -10.0]));
            let mut sim = Sim::new(&setup);
            let block = block(&mut sim, &[]);
            block.travel_around(&mut sim, [0.0; 2], Degrees(-90.0), 900.0).unwrap();
            let wanted = at(plane, [-0.4, -20.3, -10.0]);
            for (is, wanted) in sim.position.iter().zip(wanted) {
                assert!((is - wanted).abs() < 1e-9, "{:?}", sim.position);
            }
            for entry in &sim.trace.entries {
                let Step::Motion { kind, to, feed, .. } = entry.step else { continue };
                let [x, y, _] = plane.axes().map(|axis| to[axis]);
                assert_eq!((kind, feed), (MotionKind::Positioning, 900.0));
                assert!(((x + 0.4).hypot(y + 0.3) - 20.0).abs() < 1e-9);
            }
        }
    }
}
