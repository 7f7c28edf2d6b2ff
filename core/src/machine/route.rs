//! The way of one motion, straight or round an axis, and what stops the probe on it.

use crate::control::Control;
use crate::geometry::{Around, Dir, FARTHEST, Mcs, Stretch, V3, roots};
use crate::workpiece::{Boundary, Contact, Feeler, Obstacle};

/// How far a stretch of an arc that counts as straight may be from its chord, mm.
const FLAT: f64 = 1e-5;
/// Radian that such a stretch has at most.
const ROUND: f64 = 0.5;
/// Looks after which longer stretches will do, so that a way that grazes the part all along comes to an end.
const LOOKS: usize = 4096;
/// Radian of these: 3 degree.
const COARSE: f64 = 3.0 / 180.0 * std::f64::consts::PI;
/// How many stretches that are only held against boxes cost as much as one that is looked at.
pub const LOOK: usize = 4;

/// Speed of rapid traverse, mm/min: no datum of the control tells it.
const RAPID: f64 = 10_000.0;

/// From where to where, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Route {
    /// Start.
    pub from: Mcs,
    /// End.
    pub to: Mcs,
    /// Round what; none: straight.
    pub around: Option<Around<Mcs>>,
}

impl Route {
    /// A straight way.
    pub fn straight(from: Mcs, to: Mcs) -> Route {
        Route { from, to, around: None }
    }

    /// Moved by so much, mm.
    pub fn moved(&self, by: Dir<Mcs>) -> Route {
        Route {
            from: self.from + by,
            to: self.to + by,
            around: self.around.map(|around| Around { centre: around.centre + by, ..around }),
        }
    }

    /// The place after a part of it, 0 to 1.
    pub fn at(&self, part: f64) -> Mcs {
        match &self.around {
            Some(around) => around.at(self.from, self.to, part),
            None => between(self.from, self.to, part),
        }
    }

    /// Length, mm.
    pub fn length(&self) -> f64 {
        match &self.around {
            Some(around) => around.length(self.from, self.to),
            None => {
                let [x, y, z] = (self.to - self.from).0;
                x.hypot(y).hypot(z)
            }
        }
    }

    /// How long a motion at this feed takes on it, s; 0: rapid traverse.
    pub fn seconds(&self, feed: f64) -> f64 {
        60.0 * self.length() / if feed > 0.0 { feed } else { RAPID }
    }

    /// What lies between two parts of it, 0 to 1, seen so far away.
    fn stretch(&self, parts: [f64; 2], shift: Dir<Mcs>) -> Stretch {
        let stretch = match &self.around {
            Some(around) => around.stretch(self.from, self.to, parts),
            None => {
                let [from, to] = parts.map(|part| V3::from(self.at(part).0));
                Stretch::straight(from, to)
            }
        };
        stretch.moved(&shift.into())
    }

    /// Whether it lies where contact can be computed: both ends, and of an arc its axis.
    pub fn is_near(&self) -> bool {
        let centre = self.around.map_or(self.from, |around| around.centre);
        [self.from.0, self.to.0, centre.0].into_iter().flatten().all(|value| value.abs() <= FARTHEST)
    }

    /// Whether all its places are within the software limit switches; of a straight way its end, as it may lead back.
    pub fn within_limits(&self, control: &Control) -> bool {
        if !control.limits.any() {
            return true;
        }
        if self.around.is_none() {
            return control.within_limits(self.to);
        }
        let stretch = self.stretch([0.0, 1.0], Dir::default());
        let bounds = [V3::x(), V3::y(), V3::z()].map(|axis| stretch.along(&axis));
        let corner = |side: usize| bounds.map(|bounds| bounds[side]);
        control.within_limits(Mcs(corner(0))) && control.within_limits(Mcs(corner(1)))
    }

    /// The first part of it, as far as this place.
    pub fn until(&self, part: f64, stop: Mcs) -> Route {
        let around = self.around.map(|around| Around { degrees: around.degrees * part, ..around });
        Route { to: stop, around, ..*self }
    }

    /// Where the probe meets the part, whose ball has its centre `shift` away from the positions of the way. How much
    /// had to be looked at for that is added to `effort`: see [`Route::search`].
    pub fn obstacle(&self, part: &Boundary, probe: &Feeler, shift: Dir<Mcs>, effort: &mut usize) -> Option<Obstacle> {
        let mut looked = 0;
        let ball = self.stops_ball(part, probe, shift, &mut looked);
        let free = ball.map_or(*self, |met| self.until(met.part, met.stop));
        let caught = free.catches(part, probe, shift, &mut looked);
        *effort += looked * part.weight();
        let Some(ball) = ball else { return caught };
        Some(ball.or_before(caught, free.length()))
    }

    /// What is met first. An arc is halved again and again: a stretch is left out where `near` is sure that nothing can
    /// be met on it, and `look` sees the others between two parts of the way, in their order, when they are as good as
    /// straight. Each stretch counts as one in `effort`, and one that is looked at as `LOOK`.
    pub fn search<T>(
        &self,
        shift: Dir<Mcs>,
        effort: &mut usize,
        near: impl Fn(&Stretch) -> bool,
        mut look: impl FnMut([f64; 2]) -> Option<T>,
    ) -> Option<T> {
        let Some(around) = &self.around else { return look([0.0, 1.0]) };
        let radius = around.radius(self.from, self.to);
        let mut waiting = vec![[0.0, 1.0]];
        let mut looks = 0;
        while let Some([begin, end]) = waiting.pop() {
            *effort += 1;
            if !near(&self.stretch([begin, end], shift)) {
                continue;
            }
            let angle = (around.degrees * (end - begin)).radians().abs();
            let flat = radius * angle * angle / 8.0 <= FLAT && angle <= ROUND;
            if flat || (looks >= LOOKS && angle <= COARSE) {
                (looks, *effort) = (looks + 1, *effort + LOOK);
                if let Some(met) = look([begin, end]) {
                    return Some(met);
                }
                continue;
            }
            let middle = (begin + end) / 2.0;
            waiting.extend([[middle, end], [begin, middle]]);
        }
        None
    }

    /// Where the ball meets the part. One that reaches into the part at the start may leave it.
    fn stops_ball(&self, part: &Boundary, probe: &Feeler, shift: Dir<Mcs>, effort: &mut usize) -> Option<Obstacle> {
        let mut leaving: Option<(f64, Obstacle)> = None;
        let near = |stretch: &Stretch| probe.ball_may_meet(part, stretch);
        let met = self.search(shift, effort, near, |[begin, end]| {
            let [from, to] = [begin, end].map(|part| self.at(part));
            let before = leaving.take().filter(|(left, _)| *left == begin);
            match straight(part, probe.radius, from, to, shift) {
                Ahead::Free => None,
                Ahead::Met(met) => Some(self.on_arc(part, probe.radius, shift, [begin, end], met)),
                Ahead::Leaving(met) => {
                    let pressed = Obstacle { part: begin, ..met };
                    leaving = Some((end, before.map_or(pressed, |(_, first)| first)));
                    None
                }
            }
        });
        let pressed = leaving.filter(|(left, _)| *left == 1.0);
        met.or(pressed.map(|(_, met)| met))
    }

    /// Where stylus or body of the probe meet the part on a way that is free for the ball.
    fn catches(&self, part: &Boundary, probe: &Feeler, shift: Dir<Mcs>, effort: &mut usize) -> Option<Obstacle> {
        let near = |stretch: &Stretch| probe.rods_may_meet(part, stretch);
        self.search(shift, effort, near, |[begin, end]| {
            let [from, to] = [begin, end].map(|part| self.at(part));
            let met = probe.caught(part, from + shift, to + shift)?;
            let (part, stop) = (begin + met.part * (end - begin), between(from, to, met.part));
            Some(Obstacle { part, stop, ball: stop + shift, ..met })
        })
    }

    /// What was met on a straight piece between two parts of the way, as on the way itself, less than a sagitta aside.
    fn on_arc(&self, part: &Boundary, radius: f64, shift: Dir<Mcs>, [begin, end]: [f64; 2], met: Obstacle) -> Obstacle {
        if self.around.is_none() {
            return met;
        }
        let gap = |at: f64| part.distance(self.at(at) + shift) - radius;
        let straight = begin + met.part * (end - begin);
        let at = roots::bracketed(gap, begin, end).unwrap_or(straight);
        let stop = self.at(at);
        Obstacle { part: at, stop, ball: stop + shift, ..met }
    }
}

/// What a ball meets on a straight way.
enum Ahead {
    /// Nothing.
    Free,
    /// This.
    Met(Obstacle),
    /// It reaches into the part at the start, goes out of it and has not left it at the end.
    Leaving(Obstacle),
}

/// What a ball meets on a straight way. One that reaches into the part at the start and leaves it goes on.
fn straight(part: &Boundary, radius: f64, from: Mcs, to: Mcs, shift: Dir<Mcs>) -> Ahead {
    let end = to + shift;
    let mut start = from + shift;
    let mut gone = 0.0;
    for _ in 0..4 {
        let seen = |met: Obstacle| Obstacle { part: gone + met.part * (1.0 - gone), stop: met.ball + -shift, ..met };
        match part.first(radius, start, end) {
            Contact::None => return Ahead::Free,
            Contact::Hit(met) => return Ahead::Met(seen(met)),
            Contact::Already(met, depth) => match released(start, end, met.normal, depth) {
                None => return Ahead::Met(seen(met)),
                Some(share) if share >= 1.0 => return Ahead::Leaving(seen(met)),
                Some(share) => {
                    start = between(start, end, share);
                    gone += share * (1.0 - gone);
                }
            },
        }
    }
    Ahead::Free
}

/// After which part of its way a ball that reaches into the part by `depth` is free, as a deflected stylus on its way
/// back; more than 1: the way is too short for that; none: it does not leave.
fn released(from: Mcs, to: Mcs, normal: Dir<Mcs>, depth: f64) -> Option<f64> {
    let way = to - from;
    let outward: f64 = (0..3).map(|i| way[i] * normal[i]).sum();
    (outward > 0.0).then(|| depth * (1.0 + 1e-9) / outward + 1e-12)
}

/// The place after a part of the straight way, 0 to 1.
fn between(from: Mcs, to: Mcs, part: f64) -> Mcs {
    from + (to - from) * part
}
