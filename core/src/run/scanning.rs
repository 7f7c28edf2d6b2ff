//! A scan in pieces, whose progress is told and which can be left; then its comparison with the true surface.

use crate::entry::Inputs;
use crate::geometry::{Mcs, Wcs};
use crate::machine::{Machine, Scanner, Setup, Sim, Stop, too_many};
use crate::scan::{Cloud, Layout, POINTS};

/// Part of the work that scanning is; the rest is the comparison.
const SCANNING: f64 = 0.75;

/// How far points are from the true surface, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Deviation {
    /// Greatest.
    pub greatest: f64,
    /// Root of the mean square.
    pub mean: f64,
}

/// A scan on its way.
pub struct Session {
    sim: Sim,
    scanner: Box<dyn Scanner>,
    /// What was scanned so far.
    pub cloud: Cloud,
    scanned: bool,
    /// Why it ended before its end.
    pub stop: Option<Stop>,
    /// Of each point compared so far, as sent and with the ball taken out; outside of the surface positive, mm.
    pub deviations: Vec<[f32; 2]>,
}

impl Session {
    /// Before the first point; none for a cycle that does not scan.
    pub fn new(inputs: &Inputs, setup: &Setup) -> Option<Result<Session, Stop>> {
        let scan = inputs.cycle.scan()?;
        let mut sim = Sim::new(setup);
        sim.measuring = Some(inputs.cycle.purpose.machine);
        sim.quiet(true);
        let scanner = scan(&mut sim, inputs);
        Some(scanner.map(|scanner| Session {
            sim,
            scanner,
            cloud: Cloud::default(),
            scanned: false,
            stop: None,
            deviations: Vec::new(),
        }))
    }

    /// Goes on by so many points; true: everything is done.
    pub fn advance(&mut self, points: usize) -> bool {
        for _ in 0..points {
            match self.scanned {
                true if self.done() => return true,
                true => self.compare(),
                false => self.scan(),
            }
        }
        self.done()
    }

    fn done(&self) -> bool {
        self.scanned && self.deviations.len() == self.cloud.points().len()
    }

    fn scan(&mut self) {
        let next = match self.cloud.points().len() {
            POINTS => Err(too_many(POINTS)),
            _ => self.scanner.next(&mut self.sim),
        };
        match next {
            Ok(Some(point)) => self.cloud.push(point),
            ended => (self.scanned, self.stop) = (true, ended.err()),
        }
    }

    fn compare(&mut self) {
        let index = self.deviations.len();
        let sent = self.cloud.points().get(index).copied().unwrap_or_default();
        let surface = self.cloud.surface(self.scanner.layout(), index);
        let away = |point| self.sim.distance(self.to_machine(Wcs(point))) as f32;
        self.deviations.push([away(sent), away(surface.into())]);
    }

    /// How much is done, 0 to 1.
    pub fn share(&self) -> f64 {
        if !self.scanned {
            return SCANNING * self.scanner.share();
        }
        SCANNING + (1.0 - SCANNING) * self.deviations.len() as f64 / self.cloud.points().len().max(1) as f64
    }

    /// How it is scanned.
    pub fn layout(&self) -> &Layout {
        self.scanner.layout()
    }

    /// Deviation of the points as sent (0), or with the ball taken out (1).
    pub fn deviation(&self, which: usize) -> Deviation {
        let values = self.deviations.iter().filter_map(|both| both.get(which).copied().map(f64::from));
        let greatest = values.clone().fold(0.0_f64, |greatest, value| greatest.max(value.abs()));
        let squares: f64 = values.map(|value| value * value).sum();
        Deviation { greatest, mean: (squares / self.deviations.len().max(1) as f64).sqrt() }
    }

    /// A point of the scan on the machine.
    pub fn to_machine(&self, point: Wcs) -> Mcs {
        self.sim.control.to_machine(point)
    }
}
