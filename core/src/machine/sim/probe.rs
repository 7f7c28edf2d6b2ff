//! The simulated machine with a probe that touches the part.

use super::Sim;
use crate::control::braking::Deflection;
use crate::control::probe::{PROBE, Unfit};
use crate::control::{Edge, LATHE_PROBE};
use crate::diagnostic::Code;
use crate::geometry::{Degrees, Dir, Mcs};
use crate::machine::{MotionKind, Route, Step, Stop};
use crate::message::Message;
use crate::workpiece::probe::{Stand, ball_offset, touch};
use crate::workpiece::{Body, Contact, Feeler, Obstacle, Touching};

/// How far the ball is lifted off a face so that it does not touch, and how far is looked for what is opposite, mm.
const JUST_FREE: f64 = 0.01;
const WIDEST: f64 = 1000.0;
/// How far what only touches may reach in, mm.
const FARTHEST_IN: f64 = 1e-6;
/// Most feeds that are remembered as told.
const FEEDS: usize = 1000;

impl Sim {
    /// Whether the simulated probe is in use: type 710 or 580, or a measuring cycle of workpieces is running. Any other
    /// tool touches the tool probes only; that it cuts is not simulated. In JOG, where nobody cuts, the tool in the
    /// spindle decides alone, and one that is none meets the part.
    pub fn has_probe(&self) -> bool {
        let Some(edge) = self.control.active_edge() else { return self.measuring.is_some() && !self.in_jog };
        let probe = [PROBE, LATHE_PROBE].contains(&edge.kind);
        let stands = || !self.measures_tool() && self.stands_for_probe(edge);
        probe || if self.in_jog { stands() } else { self.measuring.is_some() }
    }

    /// Whether a mask of JOG measures the tool in the spindle, or with it the tool probe: then it is none
    /// (B:3938-3945).
    fn measures_tool(&self) -> bool {
        self.in_cycle && self.measuring.is_none()
    }

    /// Whether a tool of the type of a mill is the probe: types 1x0 are those of probes, too (B:4147). It is where no
    /// tool is of the type of a probe alone, and nobody told what of it cuts.
    fn stands_for_probe(&self, edge: &Edge) -> bool {
        let fits = matches!(self.control.unfit(edge), None | Some(Unfit::Digit));
        let edges = || self.control.tools.values().flat_map(|tool| tool.edges.values());
        fits && !self.told_tools.contains(&self.control.active_place()) && !edges().any(|edge| edge.kind == PROBE)
    }

    /// Whether it is the probe of a turning machine, whose spindle holds the part, only in a milling cycle the probe.
    pub(super) fn in_turret(&self) -> bool {
        self.control.active_edge().is_some_and(Edge::is_turning)
    }

    /// How far the probe is turned from the abscissa to the ordinate: with the spindle that holds it.
    fn probe_angle(&self) -> Degrees {
        if self.in_turret() { Degrees(0.0) - self.held_at } else { self.control.turned() }
    }

    /// Makes the probe of a turning machine that nobody told otherwise as long as its data say when it first moves.
    pub(super) fn hold(&mut self) {
        if self.in_turret() && self.has_probe() {
            self.make_real();
        }
    }

    /// From the point to which the tool length refers to the spindle axis at the height of the real ball centre:
    /// differs from zero when the probe is not as long as the control believes.
    fn ball_height(&self) -> Dir<Mcs> {
        let axis = self.tool_axis();
        let mut height = Dir::default();
        if self.in_turret() {
            return self.real_tool().map_or(height, |tool| tool.error(&self.control));
        }
        height[axis] = self.control.active_length()[axis] - self.probe.length;
        height
    }

    /// Where a motion is stopped by the part.
    pub(super) fn obstacle(&mut self, way: &Route) -> Option<Obstacle> {
        if self.part.is_nothing() {
            return None;
        }
        let (feeler, ball) = (self.feeler(), self.ball());
        way.obstacle(&self.part, &feeler, ball, &mut self.effort)
    }

    /// What of the probe can touch, as it stands.
    pub(super) fn feeler(&self) -> Feeler {
        let edge = self.control.active_edge().filter(|edge| edge.is_turning());
        if edge.is_some_and(|edge| edge.stands().is_none() || self.probe.body.is_none()) {
            return Feeler::ball(self.probe.radius); // how long the stylus is in a turret no datum tells
        }
        Feeler::new(&self.probe, self.control.stands())
    }

    fn stand(&self) -> Stand {
        Stand { turned: self.probe_angle(), axis: self.tool_axis(), feeler: self.feeler() }
    }

    /// From the point to which the tool length refers to the real centre of the ball.
    pub(super) fn ball(&self) -> Dir<Mcs> {
        self.ball_height() + ball_offset(&self.probe, self.probe_angle(), self.tool_axis())
    }

    /// Where the machine is when the ball is so far, mm, before the face of the part that is nearest to a point, in the
    /// direction out of the part there. It is never beyond the middle between the face and what is opposite, and in it
    /// where that is wanted. None: there is no part.
    pub fn before(&self, point: Mcs, normal: Dir<Mcs>, far: f64, middle: bool) -> Option<Mcs> {
        if self.part.is_nothing() {
            return None;
        }
        let radius = self.probe.radius;
        let face = point + normal * -self.part.distance(point);
        let ball = |away: f64| face + normal * (radius + away);
        let room = match self.part.first(radius, ball(JUST_FREE), ball(JUST_FREE + WIDEST)) {
            Contact::Hit(met) => Some((JUST_FREE + met.part * WIDEST) / 2.0),
            _ => None,
        };
        let away = room.map_or(far, |room| if middle { room } else { far.min(room) });
        Some(ball(away) + -self.ball())
    }

    /// Whether what is in the spindle reaches into the part or a tool probe where it stands: then it would have met it
    /// on its way down there. What reaches in no further than rounding only touches.
    pub fn reaches_in(&mut self) -> bool {
        let mut above = self.position;
        above[self.tool_axis()] += WIDEST;
        let way = Route::straight(above, self.position);
        let met = if self.has_probe() { self.obstacle(&way) } else { self.tool_stopped(&way) };
        met.is_some_and(|met| (1.0 - met.part) * WIDEST > FARTHEST_IN)
    }

    /// Coordinate X Y Z of the machine at which the ball is so far above the part and the tool probes, mm.
    pub fn above(&self, axis: usize, far: f64) -> f64 {
        let mut up = Dir::default();
        up[axis] = 1.0;
        let probes = self.tool_probes.iter().map(|probe| Body::new(&probe.solid).farthest(up));
        let top = probes.fold(self.part.farthest(up), f64::max);
        top + self.probe.radius + far - self.ball()[axis]
    }

    /// Coordinate Z of the machine at which nothing of the part reaches the ball however the rotary axes turn it, mm.
    pub fn above_turning(&self) -> f64 {
        if self.part.is_nothing() {
            return self.position[2];
        }
        let centre = self.control.rotary_centre;
        let far = |axis: usize| {
            let reach = |sign: f64| {
                let mut direction = Dir::default();
                direction[axis] = sign;
                (self.part.farthest(direction) - sign * centre[axis]).abs()
            };
            reach(1.0).max(reach(-1.0))
        };
        let reach = far(0).hypot(far(1)).hypot(far(2));
        centre[2] + reach + self.probe.radius - self.ball()[2]
    }

    /// A straight measuring motion; where the probe switched, if it did.
    pub(super) fn seek(&mut self, to: Mcs, feed: f64) -> Result<Option<Mcs>, Stop> {
        let from = self.position;
        self.admit(&Route::straight(from, to))?;
        if !self.has_probe() {
            return self.seek_with_tool(to, feed);
        }
        let height = self.ball_height();
        let signal = touch(&self.part, &self.probe, &self.stand(), from + height, to + height, feed, &mut self.noise);
        let end = signal.map_or(to, |met| met.stop + -height);
        let way = Route::straight(from, end);
        if let Some(stop) = self.false_signal(&way, MotionKind::Measuring, feed) {
            return Ok(Some(stop));
        }
        self.go(&way, MotionKind::Measuring, feed);
        let Some(met) = signal.map(|met| Obstacle { stop: end, ..met }) else { return Ok(None) };
        if met.by == Touching::Body {
            return Err(self.crash(&met));
        }
        self.switched(&met);
        self.tell_deflection(feed);
        self.drive_on(&way, feed);
        if met.by == Touching::Stylus {
            self.stylus_touched = true;
            self.note(Step::Decision { message: Message::new("run-stylus") });
        }
        Ok(Some(end))
    }

    /// The measuring input of the probe, or of the tool probe that a tool may touch, 1 or 2 (B:13834-13837).
    pub fn measuring_input(&self) -> Option<i64> {
        let named = match self.has_probe() {
            true => "_CHBIT[0]",
            false if self.tool_probes.is_empty() => return None,
            false => "_CHBIT[1]",
        };
        Some(1 + i64::from(self.control.bit(named)))
    }

    /// A straight motion to a machine position that measures where the stylus comes free, and ends there; elsewhere it
    /// ends at its target, with the stylus deflected or not.
    pub(crate) fn release_machine(&mut self, to: Mcs, feed: f64) -> Result<Option<Mcs>, Stop> {
        let from = self.position;
        self.admit(&Route::straight(from, to))?;
        let deflected = self.has_probe() && self.part.distance(from + self.ball()) < self.probe.radius - FARTHEST_IN;
        let back = Route::straight(to, from);
        let free = if deflected { self.obstacle(&back) } else { None };
        let end = free.filter(|met| met.part > 0.0).map(|met| met.stop);
        self.go(&Route::straight(from, end.unwrap_or(to)), MotionKind::Measuring, feed);
        self.skipped = Some(self.control.to_workpiece(self.position));
        Ok(end)
    }

    /// The probe switches. That its stylus was deflected and not its ball spoils a measurement, and is told there.
    pub(super) fn switched(&mut self, met: &Obstacle) {
        self.touching = true;
        self.note(Step::Touch { latched: met.stop, ball: met.ball, point: met.point, normal: met.normal, by: met.by });
    }

    /// What the probe has to take, as the axis goes on after the signal: the measured value is latched before. It is
    /// told where the machine says how it stops, once for each feed: two of them take turns where the first touch is a
    /// fast one (B:14013).
    fn tell_deflection(&mut self, feed: f64) {
        let known = |feed: f64| self.deflected_at.contains(&feed.to_bits());
        let Some(told) = self.control.deflection_at(feed).filter(|_| !known(feed)) else { return };
        if self.deflected_at.len() < FEEDS {
            self.deflected_at.insert(feed.to_bits());
        }
        let key = if told.is_too_far() { "run-deflected-too-far" } else { "run-deflected" };
        let message = Message::new(key).number("feed", feed).number("path", told.told());
        self.note(Step::Decision { message: message.number("deflection", told.permitted) });
    }

    /// The axis goes on by its braking path and comes back, as the next block takes it: the stylus gives way. What was
    /// latched counts, and the cycle goes on from there.
    fn drive_on(&mut self, way: &Route, feed: f64) {
        let short = |told: &Deflection| told.path <= WIDEST && way.length() > 0.0;
        let Some(told) = self.control.deflection_at(feed).filter(short) else { return };
        let (long, ahead) = (way.length(), way.to - way.from);
        let beyond = way.to + ahead * (told.path / long);
        self.go(&Route::straight(way.to, beyond), MotionKind::Positioning, feed);
        self.go(&Route::straight(beyond, way.to), MotionKind::Positioning, feed);
    }

    /// Probe or tool hits something where nobody watches, or with what gives no signal.
    pub(super) fn crash(&mut self, met: &Obstacle) -> Stop {
        self.note(Step::Crash { point: met.point, normal: met.normal, by: met.by });
        Stop::Fault(Message::new(match met.by {
            Touching::Ball => "run-crash",
            Touching::Stylus => "run-crash-stylus",
            Touching::Body => "run-crash-body",
            Touching::Tool => "run-crash-tool",
            Touching::Cutter => "jog-crash-cutter",
        }))
    }

    /// Whether a measurement was spoilt by the stylus since the last question.
    pub fn stylus_touched(&mut self) -> bool {
        std::mem::take(&mut self.stylus_touched)
    }

    /// Where a watched way, of which the length is counted, ends by a signal that is none; so far it is gone.
    pub(super) fn false_signal(&mut self, way: &Route, kind: MotionKind, feed: f64) -> Option<Mcs> {
        let (before, length) = (self.watched, way.length());
        self.watched += length;
        let after = self.probe.false_signal? - before;
        if !(0.0..length).contains(&after) {
            return None;
        }
        self.touching = false;
        let part = after / length;
        let stop = way.at(part);
        self.go(&way.until(part, stop), kind, feed);
        self.note(Step::Decision { message: Message::new("run-false-signal") });
        Some(stop)
    }

    /// The alarm of a signal where none may come.
    pub(super) fn collision(&self) -> Code {
        self.control.make().unexpected[usize::from(self.touching)]
    }
}
