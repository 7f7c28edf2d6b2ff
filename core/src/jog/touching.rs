//! How the machine touches: one point along an axis from where the probe stands, an element by four blocks, a ring in
//! two runs (B:2738-2754, B:3015-3034, B:3328-3361). Every way between the points is watched; the way back is not.

use super::evaluate::{self, Chord, Flat, Found, Size};
use super::mask::Element;
use super::settings::Settings;
use super::stylus::{Stylus, Touch};
use crate::catalogue::sinumerik::{calibrated_as::Used, measuring_block::followed, state};
use crate::control::{Control, MachineSort};
use crate::diagnostic::Code;
use crate::geometry::{Degrees, Dir, TOLERANCE, V3, Wcs};
use crate::machine::{Machine, MotionKind, Step, Stop};
use crate::message::Message;

/// Pulled back between the fast and the slow touch, mm (B:13772).
const PULL_BACK: f64 = 2.0;

/// The probe, and how it touches.
#[derive(Clone, Debug, PartialEq)]
pub struct Touching {
    /// The set-up of JOG.
    pub settings: Settings,
    /// What the control knows of the probe.
    pub stylus: Stylus,
}

/// How the axes of the plane lie in the machine. The cycles turn the spindle with a WCS that turns about the applicate
/// alone (B:13979-13981); in JOG the manual knows no such limit (B:14304), so that of a tilted one it follows as far as
/// it can, seen along the spindle.
struct Lies {
    /// Indices of abscissa and ordinate.
    plane: [usize; 2],
    /// Their directions in the machine, not mirrored: the data of the probe take the other direction there.
    axes: [V3; 2],
}

impl Lies {
    fn of(control: &Control) -> Lies {
        let [abscissa, ordinate, _] = control.plane.axes();
        let plane = [abscissa, ordinate];
        let axes = plane.map(|axis| {
            let sense = if control.mirrored(axis) { -1.0 } else { 1.0 };
            V3::from(control.direction_to_machine(V3::ith(axis, sense).into()))
        });
        Lies { plane, axes }
    }

    /// The turn about the spindle that is nearest to how they lie; none: there is none, they stand across it.
    fn heading(&self) -> Option<Degrees> {
        let ([first, second], [abscissa, ordinate]) = (self.plane, self.axes);
        let (cosine, sine) = (abscissa[first] + ordinate[second], abscissa[second] - ordinate[first]);
        (cosine.hypot(sine) > TOLERANCE).then(|| Degrees::of(sine.atan2(cosine)))
    }

    /// How much of the skew of a probe no turn of the spindle brings into the plane, mm.
    fn left(&self, control: &Control, field: i64) -> f64 {
        let [first, second] = self.plane;
        let (sine, cosine) = self.heading().unwrap_or(Degrees(0.0)).sin_cos();
        let mut stands = [V3::zeros(); 2];
        (stands[0][first], stands[0][second]) = (cosine, sine);
        (stands[1][first], stands[1][second]) = (-sine, cosine);
        let skew = [7, 8].map(|place| control.basic_length(&format!("_WP[{},{place}]", field - 1)));
        (0..2).map(|place| (self.axes[place] - stands[place]) * skew[place]).sum::<V3>().norm()
    }
}

/// A length with the decimals that JOG shows; none: they are 0.
fn rounded(length: f64) -> Option<f64> {
    Some((length * 1e4).round() / 1e4).filter(|length| *length > 0.0)
}

/// An alarm of the control.
pub fn alarm(number: u32) -> Stop {
    Stop::Alarm(Code::Alarm(number))
}

impl Touching {
    /// Reads the set-up and checks what must be true before the first motion; the spindle follows a turned WCS.
    ///
    /// # Errors
    /// The alarm that says what is not.
    pub fn prepare(machine: &mut dyn Machine, calibrates: bool) -> Result<Touching, Stop> {
        let control = machine.control();
        let settings = Settings::of(control);
        let (field, mono) = settings.probe;
        fit(control, field, mono, calibrates).map_err(alarm)?;
        let stylus = if calibrates { Stylus::ideal(control) } else { Stylus::of(control, field, mono) };
        let turns = settings.follows && !mono && control.spindle_positions;
        let lies = Lies::of(control);
        let left = rounded(lies.left(control, field)).filter(|_| !mono && !calibrates);
        if let Some(angle) = turns.then(|| lies.heading().map(|angle| followed(control, angle))).flatten() {
            machine.orient(angle);
        }
        if let Some(value) = left {
            let message = Message::new("jog-skew-tilted").number("value", value);
            machine.record(Step::Decision { message });
        }
        Ok(Touching { settings, stylus })
    }

    /// Touches along an axis X Y Z from where the probe stands, and comes back. First the skew of the probe is driven
    /// out across the axis, so that the ball is where the spindle axis was (B:2740).
    ///
    /// # Errors
    /// No signal, or what was hit or refused.
    pub fn along(&self, machine: &mut dyn Machine, axis: usize, sign: f64) -> Result<Touch, Stop> {
        self.calibrated(machine, &[(self.stylus.place(axis), sign)])?;
        self.first(machine, axis, sign)
    }

    /// Touches as [`Touching::along`] does, with a probe that was calibrated or not.
    ///
    /// # Errors
    /// No signal, or what was hit or refused.
    pub fn first(&self, machine: &mut dyn Machine, axis: usize, sign: f64) -> Result<Touch, Stop> {
        let here = machine.position();
        let start = self.spindle_for(here);
        let start = Wcs(std::array::from_fn(|i| if i == axis { here[i] } else { start[i] }));
        let mut way = Dir::default();
        way[axis] = sign;
        let end = start + way * (2.0 * self.settings.path);
        self.face(machine, way);
        self.travel(machine, start)?;
        let at = self.seek(machine, start, end)?;
        self.back(machine, here)?;
        Ok(Touch { at, axis, sign })
    }

    /// Refuses a probe of which one of these trigger values, by axis of the plane and direction, was never found
    /// (61341). A length that ends at the circumference of the ball is touched with none (B:5581-5583).
    fn calibrated(&self, machine: &mut dyn Machine, sides: &[(usize, f64)]) -> Result<(), Stop> {
        let none = machine.control().bit("_CBIT[14]");
        let found = |(place, sign): &(usize, f64)| {
            let [minus, plus] = self.stylus.triggers[*place];
            let value = if *sign > 0.0 { plus } else { minus };
            minus != plus && (value != 0.0 || *place == 2 && none)
        };
        if sides.iter().all(found) { Ok(()) } else { Err(alarm(61341)) }
    }

    /// Where the spindle stands when the ball is at a point, at the height at which the spindle is.
    fn spindle_for(&self, ball: Wcs) -> Wcs {
        let [abscissa, ordinate, _] = self.stylus.plane.axes();
        let mut at = ball;
        at[abscissa] -= self.stylus.skew[0];
        at[ordinate] -= self.stylus.skew[1];
        at
    }

    /// A place of the plane with the height of a position.
    fn flat(&self, position: Wcs, [first, second]: Flat) -> Wcs {
        let [abscissa, ordinate, _] = self.stylus.plane.axes();
        let mut at = position;
        (at[abscissa], at[ordinate]) = (first, second);
        at
    }

    /// A position so much higher.
    fn higher(&self, position: Wcs, by: f64) -> Wcs {
        let mut at = position;
        at[self.stylus.plane.axes()[2]] += by;
        at
    }

    /// Touches an element from where the probe stands, roughly in or over its centre, and comes back.
    ///
    /// # Errors
    /// No signal, or what was hit or refused.
    pub fn element(&self, machine: &mut dyn Machine, size: &Size) -> Result<Found, Stop> {
        self.fits(size.element.inside, size.size)?;
        if !size.element.round || self.stylus.radius <= 0.0 {
            self.calibrated(machine, &[(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0)])?;
        }
        let start = machine.position();
        let mut at = self.stylus.in_plane(start);
        let mut latched = [start; 4];
        for number in 0..4 {
            if number == 2 {
                let balls = [latched[0], latched[1]].map(|at| self.stylus.in_plane(self.stylus.ball_at(at)));
                at = evaluate::middle(at, size.angle, balls);
            }
            latched[number] = self.block(machine, size, number, at, start)?;
        }
        self.travel(machine, start)?;
        let height = self.stylus.ball_at(start)[self.stylus.plane.axes()[2]] - size.infeed;
        Ok(evaluate::element(&self.stylus, size, latched, height))
    }

    /// Refuses an element into which the ball does not fit.
    fn fits(&self, inside: bool, size: Flat) -> Result<(), Stop> {
        let ball = 2.0 * self.stylus.radius;
        match inside && size.into_iter().any(|size| size != 0.0 && size <= ball) {
            true => Err(Stop::Fault(Message::new("jog-ball").number("value", ball))),
            false => Ok(()),
        }
    }

    /// One of the four blocks: to its start, down beside a spigot, towards the wall, back, up and over a spigot at the
    /// height of the start. `at`: the place of the ball through which the line of the block runs.
    fn block(&self, machine: &mut dyn Machine, size: &Size, number: usize, at: Flat, start: Wcs) -> Result<Wcs, Stop> {
        let block = evaluate::block(size, number, at, self.stylus.radius, self.settings.path);
        let [above, end] = [block.start, block.end].map(|ball| self.spindle_for(self.flat(start, ball)));
        let end = self.higher(end, -size.infeed);
        let (sine, cosine) = block.towards.sin_cos();
        self.face(machine, Dir::new(self.flat(Wcs::default(), [cosine, sine]).0));
        let shortened = match size.element.inside {
            true => self.travel(machine, above).map(|()| false)?,
            false => self.travel_as_far(machine, above)?,
        };
        let above = machine.position();
        let low = self.higher(above, -size.infeed);
        match self.travel(machine, low) {
            // a collision behind a way that a software limit switch shortened (A:15921)
            Err(Stop::Alarm(Code::Alarm(61302))) if shortened => return Err(alarm(61402)),
            outcome => outcome?,
        }
        let latched = self.seek(machine, low, end)?;
        self.back(machine, low)?;
        self.travel(machine, above)?;
        if !size.element.inside {
            self.travel(machine, self.flat(above, self.stylus.in_plane(start)))?;
        }
        Ok(latched)
    }

    /// Touches a ring of this diameter in two runs, the first with the spindle turned by 180 degree, from where the
    /// probe stands; ends in the middle that was found (B:5326-5332). A mono probe follows its directions in both.
    ///
    /// # Errors
    /// No signal, or what was hit or refused.
    pub fn ring(&self, machine: &mut dyn Machine, diameter: f64) -> Result<evaluate::Ring, Stop> {
        let (_, follows) = self.settings.probe;
        if !machine.control().spindle_positions {
            return Err(alarm(if follows { 61373 } else { 61372 }));
        }
        self.fits(true, [diameter; 2])?;
        let start = machine.position();
        let usual = machine.control().spindle;
        if !follows {
            machine.orient((usual + Degrees(180.0)).positive());
        }
        let turned = self.run(machine, start, self.stylus.in_plane(start), diameter)?;
        if !follows {
            machine.orient(usual);
        }
        let again = turned.map(|chord| (chord.plus + chord.minus) / 2.0);
        let second = self.run(machine, start, again, diameter)?;
        let ring = evaluate::ring(diameter, turned, second, follows);
        self.travel(machine, self.flat(start, ring.centre))?;
        Ok(ring)
    }

    /// One run: plus and minus along the abscissa, to the middle, plus and minus along the ordinate.
    fn run(&self, machine: &mut dyn Machine, start: Wcs, at: Flat, diameter: f64) -> Result<[Chord; 2], Stop> {
        let size = Size {
            element: Element { round: true, inside: true },
            size: [diameter; 2],
            angle: Degrees(0.0),
            infeed: 0.0,
        };
        let mut at = at;
        let mut chords = [Chord { plus: 0.0, minus: 0.0, across: 0.0 }; 2];
        for axis in 0..2 {
            let plus = self.stylus.in_plane(self.block(machine, &size, 2 * axis, at, start)?);
            let minus = self.stylus.in_plane(self.block(machine, &size, 2 * axis + 1, at, start)?);
            chords[axis] = Chord { plus: plus[axis], minus: minus[axis], across: at[1 - axis] };
            at[axis] = (plus[axis] + minus[axis]) / 2.0;
        }
        Ok(chords)
    }

    /// Turns a mono probe into its direction of travel; along the applicate it stands as it is.
    fn face(&self, machine: &mut dyn Machine, way: Dir<Wcs>) {
        if !self.settings.probe.1 {
            return;
        }
        let [abscissa, ordinate, _] = self.stylus.plane.axes();
        let seen = machine.control().direction_to_machine(way);
        if seen[abscissa].hypot(seen[ordinate]) > TOLERANCE {
            machine.orient((-Degrees::of(seen[ordinate].atan2(seen[abscissa]))).positive());
        }
    }

    /// Watched positioning; a target beyond a software limit switch is 61401 (A:15920).
    fn travel(&self, machine: &mut dyn Machine, to: Wcs) -> Result<(), Stop> {
        let from = machine.position();
        if machine.control().limited(from, to).is_some() {
            return Err(alarm(61401));
        }
        self.go(machine, to)
    }

    /// Watched positioning as far as a software limit switch allows; whether it was shortened.
    fn travel_as_far(&self, machine: &mut dyn Machine, to: Wcs) -> Result<bool, Stop> {
        let from = machine.position();
        let limited = machine.control().limited(from, to);
        self.go(machine, limited.unwrap_or(to))?;
        Ok(limited.is_some())
    }

    fn go(&self, machine: &mut dyn Machine, to: Wcs) -> Result<(), Stop> {
        let from = machine.position();
        match (0..3).any(|axis| (from[axis] - to[axis]).abs() > TOLERANCE) {
            true => machine.travel(to, MotionKind::Positioning, self.feed(from, to), true),
            false => Ok(()),
        }
    }

    /// Feed of a way: that of the applicate where it leads along it alone.
    fn feed(&self, from: Wcs, to: Wcs) -> f64 {
        let [abscissa, ordinate, _] = self.stylus.plane.axes();
        let across = [abscissa, ordinate].into_iter().any(|axis| (from[axis] - to[axis]).abs() > TOLERANCE);
        self.settings.positioning[usize::from(!across)]
    }

    /// Towards the wall until the probe switches, as often as is set, each time from the start (B:14356-14358); the
    /// probe stands where it switched.
    fn seek(&self, machine: &mut dyn Machine, start: Wcs, end: Wcs) -> Result<Wcs, Stop> {
        let limited = machine.control().limited(start, end);
        let reached = limited.unwrap_or(end);
        for attempt in 0..self.settings.attempts {
            if attempt > 0 {
                self.back(machine, start)?;
            }
            if let Some(at) = self.touch(machine, start, reached)? {
                return Ok(at);
            }
        }
        self.back(machine, start)?;
        Err(alarm(if limited.is_some() { 61401 } else { 61301 }))
    }

    /// Once; with `_JM_B[3]` fast, back by 2 mm, not behind the start, and slowly again (B:14362-14364).
    fn touch(&self, machine: &mut dyn Machine, start: Wcs, end: Wcs) -> Result<Option<Wcs>, Stop> {
        let Some(fast) = self.settings.fast else { return machine.probe(end, self.settings.feed) };
        let Some(first) = machine.probe(end, fast)? else { return Ok(None) };
        let gone = first - start;
        let length = gone.iter().map(|part| part * part).sum::<f64>().sqrt();
        let part = if length > PULL_BACK { 1.0 - PULL_BACK / length } else { 0.0 };
        self.back(machine, start + gone * part)?;
        machine.probe(end, self.settings.feed)
    }

    /// Away from the wall.
    fn back(&self, machine: &mut dyn Machine, to: Wcs) -> Result<(), Stop> {
        let feed = if self.settings.rapid_return { 0.0 } else { self.feed(machine.position(), to) };
        machine.travel(to, MotionKind::Retract, feed, false)
    }
}

/// What the control and the probe must be before anything moves; else the number of the alarm. How the probe was
/// calibrated is always watched in JOG (B:13669).
fn fit(control: &Control, field: i64, mono: bool, calibrates: bool) -> Result<(), u32> {
    state::fit(control, MachineSort::Milling)?;
    if field < 1 || field as f64 > control.number("_CVAL[1]") {
        return Err(61313);
    }
    if mono && !control.spindle_positions {
        return Err(61373);
    }
    let used = Used { field, mono, milling: true };
    if !calibrates && used.differs(control) { Err(61341) } else { Ok(()) }
}
