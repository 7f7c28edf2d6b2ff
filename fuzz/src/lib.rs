//! What must hold for any bytes whatever. A function panics when it does not.

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

const DIALECTS: [Dialect; 2] = [Dialect::Sinumerik, Dialect::Nct];
const STYLES: [Style; 3] = [Style::Direct, Style::Indirect, Style::Operate];
/// Calls of a program that are written otherwise: each of them reads the whole program again.
const CONVERTED: usize = 4;

/// Reading any bytes as a program, finding the calls, changing each of their values, writing them otherwise and judging
/// the whole does not panic; the source stays as it is, and every finding points into it.
pub fn read(bytes: &[u8]) {
    for dialect in DIALECTS {
        let program = parse(dialect, bytes);
        assert_eq!(program.source, bytes);
        let sites = calls(&program);
        for (index, site) in sites.iter().enumerate() {
            written_anew(&program, site, index);
        }
        for finding in findings_of(&program, &sites, &delivery(dialect)) {
            let inside =
                |span: probewright_core::diagnostic::Span| span.start <= span.end && span.end as usize <= bytes.len();
            assert!(finding.span.is_none_or(inside), "{finding:?}");
        }
    }
}

fn written_anew(program: &Program, site: &CallSite, index: usize) {
    arrivals(program, site);
    for param in site.cycle.params {
        let edits = change::change(program, site, &param.name, "1");
        change::apply(&program.source, &edits);
    }
    for style in STYLES.into_iter().filter(|_| index < CONVERTED) {
        let written = convert::convert(program, index, style, &delivery(program.dialect));
        change::apply(&program.source, &written.edits);
    }
}

/// Running any bytes as a program of a mill of either control, or of a lathe, against a block of material does not
/// panic, ends within the limits and drives to numbers.
pub fn run(bytes: &[u8]) {
    let limits = Limits { steps: Some(500), depth: 4, trace: 500, ..Limits::default() };
    for setup in machines() {
        let outcome = simulate(&parse(setup.control.dialect, bytes), &setup, limits);
        assert!(outcome.trace.entries.len() <= limits.trace);
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

/// A mill of each control and a lathe, with a calibrated probe and a tool that cuts.
fn machines() -> [Setup; 3] {
    let [mill, nct] = DIALECTS.map(|dialect| Setup::calibrated(dialect, Plane::G17));
    let lathe = Setup::turning(Plane::G18);
    [(mill, 120, 10.0), (nct, 120, 10.0), (lathe, 500, 0.8)].map(|(mut setup, kind, radius)| {
        setup.workpiece.solids.push(block());
        let edge = Edge { kind, tip: 3, length: [80.0, 0.0, 0.0], radius, ..Edge::default() };
        let tool = Tool { name: "CUTTER".into(), edges: [(1, edge)].into() };
        setup.control.tools.insert(20, tool);
        setup
    })
}

fn block() -> Solid {
    Solid::new(Shape::Block { size: [100.0, 100.0, 50.0] }, Mcs::default())
}
