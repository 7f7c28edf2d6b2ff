//! What must hold for any bytes whatever. A function panics when it does not.

pub mod seeds;

use probewright_core::control::{Edge, Plane, Tool, delivery};
use probewright_core::dialect::Dialect;
use probewright_core::entry::Style;
use probewright_core::geometry::Mcs;
use probewright_core::machine::Setup;
use probewright_core::machine::trace::Step;
use probewright_core::program::calls::{CallSite, calls};
use probewright_core::program::{arrivals, change, convert, findings_of};
use probewright_core::run::{Limits, Outcome, run as simulate};
use probewright_core::syntax::{Program, read as parse};
use probewright_core::workpiece::{Shape, Solid};
use std::sync::LazyLock;

const DIALECTS: [Dialect; 2] = [Dialect::Sinumerik, Dialect::Nct];
const STYLES: [Style; 3] = [Style::Direct, Style::Indirect, Style::Operate];
/// Calls of a program that are written otherwise: each of them reads the whole program again.
const CONVERTED: usize = 4;

/// How much is done with one input.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// All of it: for tests, which have few inputs.
    All,
    /// One control, one value of each call, one call written in one style, chosen by the bytes: of many inputs together
    /// nothing is left out, and ten times as many are tried in the same time.
    Drawn,
}

/// Chooses by the bytes of an input, the same again for the same bytes.
struct Die {
    extent: Extent,
    state: u64,
}

impl Die {
    /// FNV-1a over the bytes.
    fn new(extent: Extent, bytes: &[u8]) -> Die {
        let state = bytes
            .iter()
            .fold(0xcbf2_9ce4_8422_2325, |state: u64, byte| (state ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3));
        Die { extent, state }
    }

    /// All of them, or one.
    fn of<T>(&mut self, all: Vec<T>) -> Vec<T> {
        if self.extent == Extent::All || all.is_empty() {
            return all;
        }
        self.state = self.state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        let chosen = (self.state >> 33) as usize % all.len();
        all.into_iter().skip(chosen).take(1).collect()
    }
}

/// Reading any bytes as a program, finding the calls, changing each of their values, writing them otherwise and judging
/// the whole does not panic; the source stays as it is, and every finding points into it.
pub fn read(bytes: &[u8], extent: Extent) {
    let mut die = Die::new(extent, bytes);
    for dialect in die.of(DIALECTS.to_vec()) {
        let program = parse(dialect, bytes);
        assert_eq!(program.source.as_slice(), bytes);
        let sites = calls(&program);
        for site in &sites {
            changed(&program, site, &mut die);
        }
        for index in die.of((0..sites.len().min(CONVERTED)).collect()) {
            converted(&program, index, &mut die);
        }
        for finding in findings_of(&program, &sites, &delivery(dialect)) {
            let inside =
                |span: probewright_core::diagnostic::Span| span.start <= span.end && span.end as usize <= bytes.len();
            assert!(finding.span.is_none_or(inside), "{finding:?}");
        }
    }
}

fn changed(program: &Program, site: &CallSite, die: &mut Die) {
    arrivals(program, site);
    for param in die.of(site.cycle.params.iter().collect()) {
        let edits = change::change(program, site, &param.name, "1");
        change::apply(&program.source, &edits);
    }
}

fn converted(program: &Program, index: usize, die: &mut Die) {
    for style in die.of(STYLES.to_vec()) {
        let written = convert::convert(program, index, style, &delivery(program.dialect));
        change::apply(&program.source, &written.edits);
    }
}

/// Running any bytes as a program of a mill of either control, or of a lathe, against a block of material does not
/// panic, ends within the limits and drives to numbers.
pub fn run(bytes: &[u8], extent: Extent) {
    let limits = Limits { steps: Some(500), depth: 4, trace: 250, own: 250, ..Limits::default() };
    for setup in Die::new(extent, bytes).of(MACHINES.iter().collect()) {
        let outcome = simulate(&parse(setup.control.dialect, bytes), setup, limits);
        assert!(outcome.trace.entries.len() <= limits.trace + limits.own);
        assert!(numbers(&outcome), "a position that is no number");
    }
}

/// Whether every place that the machine came to is a number.
fn numbers(outcome: &Outcome) -> bool {
    let finite = |place: &[f64; 3]| place.iter().all(|value| value.is_finite());
    let mut entries = outcome.trace.entries.iter();
    finite(&outcome.position)
        && entries.all(|entry| match &entry.step {
            Step::Motion { from, to, .. } => finite(from) && finite(to),
            Step::Touch { latched, point, .. } => finite(latched) && finite(point),
            _ => true,
        })
}

/// A mill of each control and a lathe, with a calibrated probe and a tool that cuts; made once.
static MACHINES: LazyLock<[Setup; 3]> = LazyLock::new(|| {
    [
        with_cutter(Setup::calibrated(Dialect::Sinumerik, Plane::G17), 120, 10.0),
        with_cutter(Setup::calibrated(Dialect::Nct, Plane::G17), 120, 10.0),
        with_cutter(Setup::turning(Plane::G18), 500, 0.8),
    ]
});

fn with_cutter(mut setup: Setup, kind: i64, radius: f64) -> Setup {
    setup.workpiece.solids.push(Solid::new(Shape::Block { size: [100.0, 100.0, 50.0] }, Mcs::default()));
    let edge = Edge { kind, tip: 3, length: [80.0, 0.0, 0.0], radius, ..Edge::default() };
    let tool = Tool { name: "CUTTER".into(), edges: [(1, edge)].into() };
    setup.control.tools.insert(20, tool);
    setup
}
