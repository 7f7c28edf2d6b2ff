//! The simulated machine with a tool that touches tool probes.

use super::Sim;
use crate::geometry::{Dir, Mcs, Stretch, V3};
use crate::machine::{MotionKind, Route, Stop, in_use};
use crate::workpiece::tool_probe::Contact;
use crate::workpiece::{Feeler, Noise, Obstacle, Tool, ToolProbe, Touching, tool::Piece, tool_probe};

/// The scatter of all tool probes comes from the sequence of the first.
pub(super) fn noise(probes: &[ToolProbe]) -> Noise {
    Noise::new(probes.first().map_or(1, |probe| probe.repeatability.1))
}

impl Sim {
    /// Makes the tool in use real when it first moves; none without a tool, or where it could touch nothing.
    fn take_up(&mut self) -> Option<()> {
        if self.tool_probes.is_empty() {
            return None;
        }
        self.make_real()
    }

    /// A tool that nobody told is from now on as its data say; none without a tool.
    pub(super) fn make_real(&mut self) -> Option<()> {
        let edge = self.control.active_edge()?;
        let nominal = || Tool::nominal(edge, &self.control);
        self.real_tools.entry(self.control.active_place()).or_insert_with(nominal);
        Some(())
    }

    /// Lets a turning tool that nobody told otherwise lie as the cycle that begins takes its position: `on`, mirrored
    /// in the ordinate (`_CHBIT[23]`, B:14051); and back behind the cycle.
    pub(crate) fn recode(&mut self, on: bool) {
        let place = self.control.active_place();
        if on == self.recoded || self.told_tools.contains(&place) {
            return;
        }
        self.recoded = on;
        if self.take_up().is_some()
            && let Some(tool) = self.real_tools.remove(&place)
        {
            self.real_tools.insert(place, tool.recoded(true));
        }
    }

    /// Whether it lies so now.
    pub(crate) fn recoded(&self) -> bool {
        self.recoded
    }

    /// What can touch of the tool in use with the machine at `at`, and the way from there to where its lengths refer.
    fn tool_at(&self, at: Mcs) -> Option<(Vec<Piece>, Dir<Mcs>)> {
        let tool = self.real_tool()?;
        let error = tool.error(&self.control);
        let point = V3::from(at + error);
        let spindle = in_use::stands(&self.control);
        Some((tool.pieces(point, self.control.plane, spindle), error))
    }

    /// The tool in use as it is, where it was told or has moved.
    pub(crate) fn real_tool(&self) -> Option<&Tool> {
        self.real_tools.get(&self.control.active_place())
    }

    /// Where the tool in use is stopped by a tool probe.
    pub(super) fn tool_obstacle(&mut self, way: &Route) -> Option<Obstacle> {
        self.take_up()?;
        let (tool, error) = self.tool_at(way.from)?;
        let near = |stretch: &Stretch| tool_probe::may_meet(&self.tool_probes, &tool, way.from, stretch);
        let mut effort = 0;
        let met = way.search(Dir::default(), &mut effort, near, |[begin, end]| {
            let [from, to] = [begin, end].map(|part| way.at(part));
            let (tool, _) = self.tool_at(from)?;
            let contact = tool_probe::obstacle(&self.tool_probes, &tool, from, to)?;
            let met = seen(&contact, &Route::straight(from, to), error);
            let part = begin + met.part * (end - begin);
            Some(Obstacle { part, ..met })
        });
        self.effort += effort;
        met
    }

    /// What of the tool in use would meet the part, and the way there from the position; none where it may cut.
    pub(super) fn cutting(&mut self) -> Option<(Feeler, Dir<Mcs>)> {
        if !self.in_jog || self.part.is_nothing() {
            return None;
        }
        self.make_real()?;
        let tool = self.real_tool()?;
        let (feeler, end) = Feeler::tool(tool, self.control.plane.axes());
        Some((feeler, tool.error(&self.control) + end))
    }

    /// Where the tool in use runs into the part.
    fn cut(&mut self, way: &Route) -> Option<Obstacle> {
        let (feeler, end) = self.cutting()?;
        let met = way.obstacle(&self.part, &feeler, end, &mut self.effort)?;
        Some(Obstacle { by: Touching::Cutter, ..met })
    }

    /// Where the tool in use is stopped, by a tool probe or by the part.
    pub(super) fn tool_stopped(&mut self, way: &Route) -> Option<Obstacle> {
        let met = [self.tool_obstacle(way), self.cut(way)];
        met.into_iter().flatten().min_by(|one, other| one.part.total_cmp(&other.part))
    }

    /// A measuring motion of the tool in use; where the tool probe switched. One that is to measure the part gives no
    /// signal at all: the axis goes on until something stops it.
    pub(super) fn seek_with_tool(&mut self, to: Mcs, feed: f64) -> Result<Option<Mcs>, Stop> {
        if self.measuring.is_some() {
            return self.travel_machine(to, None, MotionKind::Measuring, feed, false).map(|()| None);
        }
        let from = self.position;
        let crash = self.cut(&Route::straight(from, to));
        let end = crash.map_or(to, |met| met.stop);
        let latched = self.probe_with_tool(end, feed);
        match crash {
            Some(met) if latched.is_none() => Err(self.crash(&met)),
            _ => Ok(latched),
        }
    }

    /// Moves the tool in use until a tool probe switches; the position then.
    fn probe_with_tool(&mut self, to: Mcs, feed: f64) -> Option<Mcs> {
        let way = Route::straight(self.position, to);
        let tool = self.take_up().and_then(|()| self.tool_at(way.from));
        let touched = tool.and_then(|(tool, error)| {
            let noise = &mut self.tool_noise;
            let touched = tool_probe::touch(&self.tool_probes, &tool, way.from, to, feed, noise);
            touched.map(|(contact, signal)| (seen(&contact, &way, error), signal))
        });
        let Some((met, signal)) = touched else {
            self.go(&way, MotionKind::Measuring, feed);
            return None;
        };
        let end = way.at(share(&way, signal));
        self.go(&Route::straight(way.from, end), MotionKind::Measuring, feed);
        self.switched(&Obstacle { stop: end, ..met });
        Some(end)
    }
}

fn seen(contact: &Contact, way: &Route, error: Dir<Mcs>) -> Obstacle {
    let meeting = &contact.meeting;
    let part = share(way, meeting.way);
    let stop = way.at(part);
    Obstacle {
        part,
        stop,
        ball: stop + error,
        point: meeting.point.into(),
        normal: meeting.normal.into(),
        by: Touching::Tool,
    }
}

/// Which part of a way so many mm are.
fn share(way: &Route, length: f64) -> f64 {
    let whole = way.length();
    if whole == 0.0 { 0.0 } else { length / whole }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::control::{Edge, Plane};
    use crate::diagnostic::Code;
    use crate::dialect::Dialect;
    use crate::geometry::{Around, Degrees, Wcs};
    use crate::machine::{Machine, Setup};
    use crate::workpiece::{Cut, Cutter, Shape, Solid};

    /// A cube of 20 mm about the origin and an end mill of 70 mm and 5 mm radius above it; it is longer than its data
    /// say.
    fn sim() -> Sim {
        let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
        let edge = Edge { kind: 120, length: [70.0, 0.0, 0.0], radius: 5.0, ..Edge::default() };
        let tool = setup.control.tools.entry(3).or_default();
        tool.edges.insert(1, edge);
        (setup.control.tool, setup.control.edge) = (3, 1);
        let real = Tool { length: [70.5, 0.0, 0.0], cut: Cut::Cutter(Cutter { teeth: 2, ..Cutter::smooth(5.2) }) };
        setup.real_tools.insert((3, 1), real);
        setup.tool_probes.push(ToolProbe::ideal(Solid::new(Shape::Block { size: [20.0; 3] }, Mcs::default())));
        setup.position = Mcs([0.0, 0.0, 30.0]);
        Sim::new(&setup)
    }

    #[test]
    fn a_longer_tool_switches_earlier_whatever_is_corrected_meanwhile() {
        // oracle: hand: the position of the control is that of a tool of 70 mm, later of one of 70.5 mm
        let mut sim = sim();
        let latched = sim.probe(Wcs([0.0, 0.0, -10.0]), 150.0).unwrap().unwrap();
        assert!((latched[2] - 0.5).abs() < 1e-9, "{latched:?}");
        sim.travel(Wcs([0.0, 0.0, 30.0]), MotionKind::Retract, 1000.0, false).unwrap();
        sim.correct("$TC_DP3[3,1]", 70.5);
        let latched = sim.probe(Wcs([0.0, 0.0, -10.0]), 150.0).unwrap().unwrap();
        assert!(latched[2].abs() < 1e-9, "{latched:?}");
    }

    #[test]
    fn a_spindle_that_turns_brings_the_highest_edge() {
        // oracle: hand: teeth at 60 and 240 degree reach 5.2·cos 60, turning ones 5.2
        for (speed, reach) in [(0.0, 2.6), (500.0, 5.2), (-500.0, 5.2)] {
            let mut sim = sim();
            sim.orient(Degrees(60.0));
            sim.spin(speed);
            sim.position = Mcs([40.0, 0.0, -5.0]);
            let latched = sim.probe(Wcs([0.0, 0.0, -5.0]), 150.0).unwrap().unwrap();
            assert!((latched[0] - 10.0 - reach).abs() < 1e-9, "{latched:?}");
        }
    }

    #[test]
    fn a_tool_that_runs_into_the_probe_is_a_collision() {
        // oracle: manual B:13743-13763
        let mut sim = sim();
        let stop = sim.travel(Wcs([0.0, 0.0, -5.0]), MotionKind::Positioning, 1000.0, true);
        assert_eq!(stop, Err(Stop::Alarm(Code::Alarm(61302))));
        assert!((sim.position[2] - 0.5).abs() < 1e-9);
        let away = sim.travel(Wcs([0.0, 0.0, 20.0]), MotionKind::Retract, 1000.0, true);
        assert!(away.is_ok());
    }

    #[test]
    fn a_tool_meets_the_probe_on_an_arc() {
        // oracle: hand: from below the upright edge at [10, -10] round [30, -20]: the axis of the tool stops 5.2 mm
        // from it, 12.58 degree before the direction to the edge as it turns
        let mut sim = sim();
        sim.spin(500.0);
        sim.position = Mcs([30.0, -40.0, -5.0]);
        let around =
            Around { centre: Wcs([30.0, -20.0, -5.0]), axis: Dir::new([0.0, 0.0, 1.0]), degrees: Degrees(-180.0) };
        let to = [30.0, 0.0, -5.0];
        let stop = sim.travel_around(Wcs(to), &around, MotionKind::Positioning, 1000.0, true);
        assert_eq!(stop, Err(Stop::Alarm(Code::Alarm(61302))));
        let [x, y, _] = sim.position.0;
        assert!(((x - 10.0).hypot(y + 10.0) - 5.2).abs() < 1e-4, "{x} {y}");
        let angle = (y + 20.0).atan2(x - 30.0).to_degrees();
        assert!((angle - 153.435 - 12.58).abs() < 0.01, "{angle}");
        let mut sim = self::sim();
        sim.spin(500.0);
        sim.position = Mcs([30.0, -45.0, -5.0]);
        let beside = Around { centre: Wcs([35.0, -25.0, -5.0]), ..around };
        let to = beside.end(sim.position(), 0.0);
        let free = sim.travel_around(to, &beside, MotionKind::Positioning, 1000.0, true);
        assert_eq!(free, Ok(()));
    }

    #[test]
    fn a_table_that_turns_meets_the_tool_where_nobody_cuts() {
        // oracle: hand: the corner of a block of 60 mm is 42.4 mm from its middle, the mill 30 mm beside its face
        let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
        let edge = Edge { kind: 120, length: [70.0, 0.0, 0.0], radius: 5.0, ..Edge::default() };
        setup.control.tools.entry(3).or_default().edges.insert(1, edge);
        (setup.control.tool, setup.control.edge) = (3, 1);
        setup.workpiece.solids.push(Solid::new(Shape::Block { size: [60.0; 3] }, Mcs::default()));
        for (x, in_jog, meets) in [(40.0, true, true), (40.0, false, false), (50.0, true, false)] {
            setup.position = Mcs([x, 0.0, -10.0]);
            let mut sim = Sim::new(&setup);
            sim.in_jog = in_jog;
            assert_eq!(sim.turn_table(2, Degrees(90.0)).is_err(), meets, "{x} {in_jog}");
        }
    }
}
