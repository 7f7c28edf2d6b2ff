//! What makes a measurement uncertain, and the machine and the part of one run with it.

use crate::entry::{Inputs, ProbeUse};
use crate::geometry::{Degrees, Rpy, rigid};
use crate::machine::Setup;
use crate::series::draw::scatter;
use crate::series::random::Source;

/// What spreads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cause {
    /// The switching point of each touch.
    Touch,
    /// The same while the probe was calibrated, one touch a direction.
    Calibration,
    /// The form of the part, of which nobody knows how it lies.
    Form,
    /// The temperature of the part.
    Temperature,
}

impl Cause {
    const ALL: [Cause; 4] = [Cause::Touch, Cause::Calibration, Cause::Form, Cause::Temperature];

    pub fn key(self) -> &'static str {
        match self {
            Cause::Touch => "certainty-touch",
            Cause::Calibration => "certainty-calibration",
            Cause::Form => "certainty-form",
            Cause::Temperature => "certainty-temperature",
        }
    }

    /// Whether it has to do with this call.
    pub fn concerns(self, inputs: &Inputs, setup: &Setup) -> bool {
        let workpiece = inputs.cycle.purpose.probe == ProbeUse::Workpiece;
        match self {
            Cause::Touch if workpiece => setup.probe.repeatability.0 > 0.0,
            Cause::Touch => tool_probes(setup) > 0.0,
            Cause::Calibration | Cause::Temperature => workpiece && !inputs.cycle.purpose.calibrates.holds(inputs),
            Cause::Form => true,
        }
    }
}

/// The largest scatter of the tool probes, mm.
fn tool_probes(setup: &Setup) -> f64 {
    setup.tool_probes.iter().map(|probe| probe.repeatability.0).fold(0.0, f64::max)
}

/// Where what spreads is drawn from.
pub(super) struct Draws<'a> {
    pub setup: &'a Setup,
    pub seed: u64,
}

impl Draws<'_> {
    /// What spreads on this machine.
    pub fn causes(&self) -> Vec<Cause> {
        let probe = self.setup.probe.repeatability.0 > 0.0;
        let there = |cause: &Cause| match cause {
            Cause::Touch => probe || tool_probes(self.setup) > 0.0,
            Cause::Calibration => probe,
            Cause::Form => self.setup.workpiece.solids.iter().any(|solid| solid.errors.out_of_round.0 != 0.0),
            Cause::Temperature => self.setup.temperature.spread > 0.0 && self.setup.temperature.expansion != 0.0,
        };
        Cause::ALL.into_iter().filter(there).collect()
    }

    /// Machine and part of one run.
    pub fn drawn(&self, causes: &[Cause], run: u32) -> Setup {
        let mut setup = self.setup.clone();
        let deviation = setup.probe.repeatability.0;
        scatter(&mut setup, self.seed, run);
        if !causes.contains(&Cause::Touch) {
            setup.probe.repeatability.0 = 0.0;
            setup.tool_probes.iter_mut().for_each(|probe| probe.repeatability.0 = 0.0);
        }
        if causes.contains(&Cause::Calibration) {
            self.calibrated(&mut setup, deviation, run);
        }
        if causes.contains(&Cause::Form) {
            self.turned(&mut setup, run);
        }
        setup
    }

    /// By which factor the lengths of the part are larger than at the temperature for which its setpoints hold: it
    /// grows alike in all directions, about its zero point.
    pub fn growth(&self, causes: &[Cause], run: u32) -> f64 {
        let temperature = &self.setup.temperature;
        if !causes.contains(&Cause::Temperature) {
            return 1.0;
        }
        let warmer = temperature.spread * self.source("temperature").normal(u64::from(run));
        1.0 + temperature.expansion * 1e-6 * warmer
    }

    fn source(&self, name: &str) -> Source {
        Source::new(self.seed, name)
    }

    /// Trigger values of two opposite touches are off by the half of their sum and of their difference: as a ball of
    /// another radius off the axis is, each with 1/√2 of the deviation. In the tool axis there is one.
    fn calibrated(&self, setup: &mut Setup, deviation: f64, run: u32) {
        let number = |name: &str| self.source(name).normal(u64::from(run)) * deviation;
        let half = std::f64::consts::FRAC_1_SQRT_2;
        setup.probe.radius += half * number("ball");
        setup.probe.skew[0] += half * number("skew abscissa");
        setup.probe.skew[1] += half * number("skew ordinate");
        setup.probe.length += number("length");
    }

    /// Lobes of which nobody knows where they are: the part is turned about its axis, before it leans.
    fn turned(&self, setup: &mut Setup, run: u32) {
        let angle = 360.0 * self.source("form").uniform(u64::from(run));
        let [_, _, axis] = setup.control.plane.axes();
        let turn = Rpy::about(axis, Degrees(angle));
        for solid in setup.workpiece.solids.iter_mut().filter(|solid| solid.errors.out_of_round.0 != 0.0) {
            let tilt = &mut solid.errors.tilt;
            *tilt = match *tilt == Rpy::default() {
                true => turn,
                false => rigid::angles(&(rigid::rotation(*tilt) * rigid::rotation(turn))),
            };
        }
    }
}
