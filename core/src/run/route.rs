//! The way of one motion, straight or round an axis, and what stops the probe on it. Machine coordinates, mm.

use crate::geometry::arc::Around;
use crate::geometry::{TOLERANCE, roots};
use crate::workpiece::contact::{Boundary, Contact};
use crate::workpiece::feeler::{Feeler, Touching};

/// From where to where, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Route {
    /// Start.
    pub from: [f64; 3],
    /// End.
    pub to: [f64; 3],
    /// Round what; none: straight.
    pub around: Option<Around>,
}

/// Where part or tool probe stops a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Obstacle {
    /// Part of the way that is done, 0 to 1.
    pub part: f64,
    /// Position then.
    pub stop: [f64; 3],
    /// Centre of the ball then, or of a tool the point to which its lengths refer.
    pub ball: [f64; 3],
    /// Point touched.
    pub point: [f64; 3],
    /// Outward unit normal there.
    pub normal: [f64; 3],
    /// What of the probe touches; of a tool always what stands for its ball.
    pub by: Touching,
}

impl Route {
    /// A straight way.
    pub fn straight(from: [f64; 3], to: [f64; 3]) -> Route {
        Route {
            from,
            to,
            around: None,
        }
    }

    /// The same way so far away.
    pub fn moved(&self, by: [f64; 3]) -> Route {
        Route {
            from: add(self.from, by, 1.0),
            to: add(self.to, by, 1.0),
            around: self.around.map(|around| Around {
                centre: add(around.centre, by, 1.0),
                ..around
            }),
        }
    }

    /// The place after a part of it, 0 to 1.
    pub fn at(&self, part: f64) -> [f64; 3] {
        match &self.around {
            Some(around) => around.at(self.from, self.to, part),
            None => add(self.from, add(self.to, self.from, -1.0), part),
        }
    }

    /// Length, mm.
    pub fn length(&self) -> f64 {
        match &self.around {
            Some(around) => around.length(self.from, self.to),
            None => {
                let [x, y, z] = add(self.to, self.from, -1.0);
                x.hypot(y).hypot(z)
            }
        }
    }

    /// Ends of pieces that are straight, or short enough to be taken for it.
    pub fn ends(&self) -> impl Iterator<Item = [f64; 3]> {
        let count = self.around.map_or(1, |around| around.pieces());
        (1..=count).map(move |piece| self.at(piece as f64 / count as f64))
    }

    /// The first part of it, as far as this place.
    pub fn until(&self, part: f64, stop: [f64; 3]) -> Route {
        let around = self.around.map(|around| Around {
            degrees: around.degrees * part,
            ..around
        });
        Route {
            to: stop,
            around,
            ..*self
        }
    }

    /// Where the probe meets the part, whose ball has its centre `shift` away from the positions of the way.
    pub fn obstacle(&self, part: &Boundary, probe: &Feeler, shift: [f64; 3]) -> Option<Obstacle> {
        let ball = self.stops_ball(part, probe.radius, shift);
        let free = ball.map_or(*self, |met| self.until(met.part, met.stop));
        let Some(ball) = ball else {
            return free.catches(part, probe, shift);
        };
        let caught = free.catches(part, probe, shift);
        let before = caught.filter(|met| (1.0 - met.part) * free.length() > TOLERANCE);
        let before = before.map(|met| Obstacle {
            part: met.part * ball.part,
            ..met
        });
        before.or(Some(ball))
    }

    /// Where the ball meets the part.
    ///
    /// An arc is looked at piece by piece; what lies farther away than the ball can come is passed at once.
    fn stops_ball(&self, part: &Boundary, radius: f64, shift: [f64; 3]) -> Option<Obstacle> {
        let Some(around) = &self.around else {
            return straight(part, radius, self.from, self.to, shift);
        };
        let (piece, length) = (1.0 / around.pieces() as f64, self.length());
        let mut done = 0.0;
        while done < 1.0 {
            let from = self.at(done);
            let free = part.distance(add(from, shift, 1.0)) - radius;
            let next = (done + (free / length).max(piece)).min(1.0);
            if free < piece * length
                && let Some(met) = straight(part, radius, from, self.at(next), shift)
            {
                return Some(self.on_arc(part, radius, shift, [done, next], met));
            }
            done = next;
        }
        None
    }

    /// Where stylus or body of the probe meet the part on a way that is free for the ball; on an arc to its pieces.
    fn catches(&self, part: &Boundary, probe: &Feeler, shift: [f64; 3]) -> Option<Obstacle> {
        let mut from = self.from;
        let count = self.ends().count() as f64;
        for (piece, to) in self.ends().enumerate() {
            let ball = add(from, shift, 1.0);
            if let Some(met) = probe.caught(part, ball, add(to, shift, 1.0)) {
                let stop = add(from, add(to, from, -1.0), met.part);
                return Some(Obstacle {
                    part: (piece as f64 + met.part) / count,
                    stop,
                    ball: add(stop, shift, 1.0),
                    point: met.point,
                    normal: met.normal,
                    by: met.by,
                });
            }
            from = to;
        }
        None
    }
}

impl Route {
    /// What was met on a straight piece between two parts of the way, as it is on the way itself, which the piece leaves
    /// by less than its sagitta.
    fn on_arc(
        &self,
        part: &Boundary,
        radius: f64,
        shift: [f64; 3],
        [done, next]: [f64; 2],
        met: Obstacle,
    ) -> Obstacle {
        let gap = |at: f64| part.distance(add(self.at(at), shift, 1.0)) - radius;
        let straight = done + met.part * (next - done);
        let at = roots::bracketed(gap, done, next).unwrap_or(straight);
        let stop = self.at(at);
        Obstacle {
            part: at,
            stop,
            ball: add(stop, shift, 1.0),
            ..met
        }
    }
}

/// The same on a straight way. A ball that reaches into the part at the start and leaves it goes on.
fn straight(
    part: &Boundary,
    radius: f64,
    from: [f64; 3],
    to: [f64; 3],
    shift: [f64; 3],
) -> Option<Obstacle> {
    let end = add(to, shift, 1.0);
    let mut start = add(from, shift, 1.0);
    let mut gone = 0.0;
    for _ in 0..4 {
        match part.first(radius, start, end) {
            Contact::None => return None,
            Contact::Hit {
                t,
                ball,
                point,
                normal,
            } => {
                return Some(Obstacle {
                    part: gone + t * (1.0 - gone),
                    stop: add(ball, shift, -1.0),
                    ball,
                    point,
                    normal,
                    by: Touching::Ball,
                });
            }
            Contact::Already {
                point,
                normal,
                depth,
            } => match released(start, end, normal, depth) {
                Some(share) => {
                    start = add(start, add(end, start, -1.0), share);
                    gone += share * (1.0 - gone);
                }
                None => {
                    return Some(Obstacle {
                        part: gone,
                        stop: add(start, shift, -1.0),
                        ball: start,
                        point,
                        normal,
                        by: Touching::Ball,
                    });
                }
            },
        }
    }
    None
}

/// After which part of its way a ball that reaches into the part by `depth` is free again; none when it does not leave.
/// A stylus that is deflected by pre-travel or delay leaves the part on its way back.
fn released(from: [f64; 3], to: [f64; 3], normal: [f64; 3], depth: f64) -> Option<f64> {
    let way = add(to, from, -1.0);
    let outward: f64 = (0..3).map(|i| way[i] * normal[i]).sum();
    let part = depth * (1.0 + 1e-9) / outward + 1e-12;
    (outward > 0.0 && part < 1.0).then_some(part)
}

/// A point and so many times a vector.
pub fn add(a: [f64; 3], b: [f64; 3], factor: f64) -> [f64; 3] {
    std::array::from_fn(|i| a[i] + factor * b[i])
}
