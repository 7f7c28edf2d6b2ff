//! What is measured in a mask: the points in their turn, those that are rejected, what they come to.

use super::{Input, Session};
use crate::catalogue::alarms;
use crate::control::{Control, Frame, MachineSort};
use crate::diagnostic::Code;
use crate::geometry::{Degrees, Dir, Mcs};
use crate::jog::calculate::{self, Outcome, Point, Unfit};
use crate::jog::counterpart::Taken;
use crate::jog::evaluate::Size;
use crate::jog::mask::{Mask, Task};
use crate::jog::settings::Settings;
use crate::jog::states::{Key, State};
use crate::jog::stylus::Stylus;
use crate::jog::touching::{Touching, alarm};
use crate::jog::{calibrating, offset, tools};
use crate::machine::{Step, Stop};
use crate::message::Message;

/// In what points are touched: those of another WCS, or of another probe, make no measurement together.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TouchedIn {
    frames: Vec<Frame>,
    stylus: Stylus,
    length: Dir<Mcs>,
}

impl TouchedIn {
    /// As a control stands.
    fn of(control: &Control) -> TouchedIn {
        let (field, mono) = Settings::of(control).probe;
        let stylus = Stylus::of(control, field, mono);
        TouchedIn { frames: control.chain().to_vec(), stylus, length: control.active_length() }
    }
}

impl Session {
    /// Rejects the points that were touched in another WCS than the next one would be, or with another probe.
    pub(super) fn compare(&mut self) {
        if self.stored() == 0 && !self.waits() {
            return;
        }
        let mut control = self.sim.control.clone();
        control.activate(self.measuring());
        if self.touched_in.as_ref().is_some_and(|known| *known != TouchedIn::of(&control)) {
            self.reject_all();
        }
    }

    /// Rejects all points, stored or waiting, and tells which those are.
    pub(super) fn reject_all(&mut self) {
        let waits = self.waits().then(|| self.next());
        let there = |(number, point): (usize, &Option<Point>)| point.is_some() || waits == Some(number);
        let named = self.points.iter().enumerate().filter(|point| there(*point));
        let named: Vec<String> = named.map(|(number, _)| format!("P{}", number + 1)).collect();
        if !named.is_empty() && self.mask.is_some_and(|mask| !mask.at_once()) {
            let message = Message::new("jog-rejected").text("points", named.join(", "));
            self.sim.note(Step::Decision { message });
        }
        self.points.fill(None);
        self.taken.fill(None);
        self.measured = None;
        self.touched_in = None;
        if self.state == State::Ready {
            self.state = State::Mask;
        }
    }

    /// The zero offset of the set-up becomes active, as its plane is (B:2748-2752).
    pub(super) fn begin(&mut self) {
        self.take_plane();
        self.compare();
        let measuring = self.measuring();
        self.sim.control.activate(measuring);
        self.touched_in = Some(TouchedIn::of(&self.sim.control));
        self.measured = None;
        if self.mask.is_some_and(Mask::at_once) {
            self.points.fill(None);
        }
    }

    /// Number of the missing point that is measured next, from 0.
    pub(super) fn next(&self) -> usize {
        self.points.iter().position(Option::is_none).unwrap_or_default()
    }

    /// Measures what NC start began.
    pub(super) fn measure(&mut self) -> Result<(), Stop> {
        let Some(mask) = self.mask else { return Ok(()) };
        let number = self.next();
        let from = self.sim.position;
        self.sim.measuring = (!mask.task.of_tool()).then_some(MachineSort::Milling);
        self.sim.in_cycle = true;
        let outcome = self.point(mask, number);
        self.sim.in_cycle = false;
        self.sim.measuring = None;
        self.measured = outcome?;
        let at = self.measured.as_ref().map_or(from, |point| self.place(point));
        if let Some(taken) = self.taken.get_mut(number) {
            *taken = Some(Taken { from, at });
        }
        Ok(())
    }

    /// Where a point lies in the machine: the surface that was touched, the centre of the element.
    pub(super) fn place(&self, point: &Point) -> Mcs {
        let Some(stylus) = &self.stylus else { return self.sim.position };
        self.sim.control.to_machine(match point {
            Point::Touch(touch) => {
                let mut at = touch.at;
                at[touch.axis] = stylus.surface(touch);
                at
            }
            Point::Element(found) => stylus.placed(found.centre, found.height),
        })
    }

    /// One point; none: the function stores what it found itself.
    pub(super) fn point(&mut self, mask: &Mask, number: usize) -> Result<Option<Point>, Stop> {
        let target = self.chosen();
        let (values, sim) = (&self.values, &mut self.sim);
        match mask.task {
            Task::Length => return calibrating::length(sim, values.number("z0")).map(|()| None),
            Task::Ring => return calibrating::ring(sim, values.number("d")).map(|()| None),
            Task::ToolProbe => {
                let diameter = values.word("cal_kind") == "length_and_diameter";
                return tools::calibrate(sim, diameter).map(|()| None);
            }
            Task::ToolLength => return tools::length(sim, values.number("v")).map(|()| None),
            Task::ToolRadius => return tools::radius(sim, values.number("v")).map(|()| None),
            _ => {}
        }
        let touching = Touching::prepare(sim, false)?;
        if target.is_some_and(|store| offset::scaled(&sim.control, store)) {
            return Err(alarm(61310));
        }
        self.stylus = Some(touching.stylus);
        let [abscissa, ordinate, applicate] = touching.stylus.plane.axes();
        let (axis, sign) = match mask.task {
            Task::Element(element) | Task::Centres(element) => {
                let of = |name: &str| values.number(name);
                let size = Size {
                    element,
                    size: if element.round { [of("diameter"); 2] } else { [of("l"), of("w")] },
                    angle: Degrees(of("contact_angle")),
                    infeed: of("dz"),
                };
                return touching.element(sim, &size).map(|found| Some(Point::Element(found)));
            }
            Task::Corner => {
                let side = calculate::corner_sides(values)[usize::from(number > 1)];
                ([abscissa, ordinate][side.axis.min(1)], side.sign)
            }
            Task::Plane => (applicate, -1.0),
            Task::Distance if number == 1 => (calculate::axis(values, "axis"), values.sign("direction_2")),
            _ => (calculate::axis(values, "axis"), values.sign("direction")),
        };
        touching.along(sim, axis, sign).map(|touch| Some(Point::Touch(touch)))
    }

    /// Stores the point that was measured.
    pub(super) fn store(&mut self) {
        let number = self.next();
        if let (Some(point), Some(place)) = (self.measured.take(), self.points.get_mut(number)) {
            *place = Some(point);
        }
    }

    /// Stores the point that waits: none is stored that was not touched, and none out of its turn (A:3188, A:3198).
    pub(super) fn keep(&mut self, input: Input) -> Result<(), Message> {
        let next = self.next();
        if !matches!(input, Input::Point(number) if number == next + 1) || self.measured.is_none() {
            return Err(Message::new("jog-older-order").text("point", format!("P{}", next + 1)));
        }
        self.store();
        Ok(())
    }

    /// What all points come to, the one that was measured last among them.
    pub(super) fn calculated(&self) -> Result<Outcome, Message> {
        let (Some(mask), Some(stylus)) = (self.mask, &self.stylus) else { return Ok(Outcome::default()) };
        let points: Vec<Point> =
            self.points.iter().copied().chain([self.measured.filter(|_| !mask.by_hand())]).flatten().collect();
        let told = |unfit| match unfit {
            // the control's words speak of the points of an edge
            Unfit::Alarm(61367) if matches!(mask.task, Task::Centres(_)) => Message::new("jog-same-centres"),
            Unfit::Alarm(number) => Message::new(alarms::key(Code::Alarm(number))),
            Unfit::Told(key) => Message::new(key),
        };
        let outcome = calculate::calculate(&self.sim.control, mask, &self.values, stylus, &points);
        // which zero offset is corrected can be chosen behind the points, too
        let scaled = || self.chosen().is_some_and(|store| offset::scaled(&self.sim.control, store));
        match outcome {
            Ok(Outcome { correction: Some(_), .. }) if scaled() => Err(told(Unfit::Alarm(61310))),
            outcome => outcome.map_err(told),
        }
    }

    pub(super) fn reject(&mut self, input: Input) -> Result<(), Message> {
        let number = match input {
            Input::Point(number) | Input::Plc(number, _) => number,
            _ => 0,
        };
        let place = number.checked_sub(1).and_then(|place| self.points.get_mut(place));
        match place {
            Some(point) if point.is_some() => {
                *point = None;
                if let Some(taken) = number.checked_sub(1).and_then(|place| self.taken.get_mut(place)) {
                    *taken = None;
                }
                Ok(())
            }
            _ => Err(Message::new("jog-grey").text("point", format!("P{number}"))),
        }
    }

    /// A bit of the PLC: set, it rejects a point that is stored while its softkey is on the screen (B:2797-2804).
    pub(super) fn plc_bit(&mut self, number: usize, set: bool) -> Result<(), Message> {
        let place = number.checked_sub(1).filter(|place| *place < self.rejects.len());
        let Some(place) = place else {
            return Err(Message::new("jog-grey").text("point", format!("P{number}")));
        };
        self.rejects[place] = set;
        let stored = self.points.get(place).is_some_and(Option::is_some);
        if set
            && stored
            && !self.kept_by_hand()
            && let Ok(row) = self.row(Key::Point)
        {
            return self.act(row, Input::Plc(number, set));
        }
        Ok(())
    }
}
