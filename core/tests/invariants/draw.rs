//! What is drawn: machine, data, call and part. Plain figures, so that a failure shrinks to the ones that matter.

use probewright_core::catalogue::{CYCLES, find};
use probewright_core::control::{MachineSort, Plane, Units};
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, ProbeUse};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngSeed, TestCaseError, TestRunner};
use std::cell::RefCell;

/// All working planes.
pub const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];

/// One measurement. Lengths in mm, angles in degree.
#[derive(Clone, Debug)]
pub struct Drawn {
    pub cycle: &'static str,
    pub variant: i64,
    pub machine: Machine,
    pub call: Call,
    pub part: Part,
    /// Where all of it stands instead: turned about the applicate by the first angle, and moved.
    pub moved: Placed,
}

impl Drawn {
    pub fn cycle(&self) -> &'static Cycle {
        find(Dialect::Sinumerik, self.cycle).unwrap()
    }
}

/// The machine, its frames and its data.
#[derive(Clone, Debug)]
pub struct Machine {
    pub basic: Units,
    /// Index in [`PLANES`]; a lathe works in G18.
    pub plane: usize,
    /// System, global basic, channel basic, settable, programmed, outermost first.
    pub frames: [Placed; 5],
    /// Whether frames turn about the applicate alone.
    pub upright: bool,
    /// Settable frame in use.
    pub settable: usize,
    /// Bits of `_CBIT[]` and `_CHBIT[]` that are not as by default.
    pub bits: Vec<&'static str>,
    /// Radius of the ball.
    pub ball: f64,
    /// Ball centre minus spindle axis, known to the control.
    pub skew: [f64; 2],
}

/// A frame.
#[derive(Clone, Copy, Debug)]
pub struct Placed {
    pub at: [f64; 3],
    pub fine: f64,
    /// About X Y Z; the global basic frame and the frames of a lathe take none.
    pub turn: [f64; 3],
    pub mirror: [bool; 3],
}

/// Values of the call beside those of the worked measurement of its variant.
#[derive(Clone, Copy, Debug)]
pub struct Call {
    /// How much larger or smaller sizes, places and angles are.
    pub factors: [f64; 4],
    /// Index in the codes of `_KNUM` for its sort of target.
    pub target: usize,
    /// Measuring axis, where it is a choice; 0: that of the worked measurement.
    pub axis: u8,
    pub memory: bool,
    pub points: u8,
    pub feed: f64,
    pub path: f64,
    pub mono: bool,
    /// `_CORA` of a mono probe.
    pub aside: f64,
}

/// What is wrong with the part.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// In abscissa, ordinate and applicate of the workpiece system.
    pub shift: [f64; 3],
    pub size: f64,
    /// About abscissa, ordinate and applicate.
    pub tilt: [f64; 3],
}

/// Switches that the properties turn: all that a single call reads. `_CBIT[3]` and `_CHBIT[24]` convert data once, when
/// they are entered, and `_CBIT[13]` erases them.
pub const SWITCHES: [&str; 23] = [
    "_CBIT[0]", "_CBIT[1]", "_CBIT[2]", "_CBIT[5]", "_CBIT[8]", "_CBIT[12]", "_CBIT[14]", "_CBIT[15]", "_CBIT[16]",
    "_CHBIT[2]", "_CHBIT[3]", "_CHBIT[4]", "_CHBIT[5]", "_CHBIT[6]", "_CHBIT[7]", "_CHBIT[8]", "_CHBIT[13]",
    "_CHBIT[14]", "_CHBIT[15]", "_CHBIT[16]", "_CHBIT[17]", "_CHBIT[20]", "_CHBIT[21]",
];

fn placed(range: f64, turn: f64) -> impl Strategy<Value = Placed> {
    let at = prop::array::uniform3(-range..range);
    let turn = prop::array::uniform3(-turn..=turn);
    (at, -0.05..0.05_f64, turn, prop::array::uniform3(prop::bool::weighted(0.08)))
        .prop_map(|(at, fine, turn, mirror)| Placed { at, fine, turn, mirror })
}

fn machines() -> impl Strategy<Value = Machine> {
    let basic = prop::sample::select(vec![Units::Metric, Units::Inch]);
    let frames = [
        placed(5.0, 20.0).boxed(),
        placed(10.0, 0.0).boxed(),
        placed(20.0, 180.0).boxed(),
        placed(300.0, 180.0).boxed(),
        placed(30.0, 45.0).boxed(),
    ];
    let bits = prop::sample::subsequence(SWITCHES.to_vec(), 0..8);
    let skew = prop::array::uniform2(-0.06..0.06_f64);
    let upright = prop::bool::weighted(0.4);
    (basic, 0..3_usize, frames, upright, 0..3_usize, bits, 1.0..4.0_f64, skew).prop_map(
        |(basic, plane, frames, upright, settable, bits, ball, skew)| Machine {
            basic,
            plane,
            frames,
            upright,
            settable: [0, 1, 5][settable],
            bits,
            ball,
            skew,
        },
    )
}

fn calls() -> impl Strategy<Value = Call> {
    (
        prop::array::uniform4(0.85..1.15_f64),
        0..8_usize,
        0..4_u8,
        any::<bool>(),
        1..4_u8,
        prop::sample::select(vec![0.0, 0.0, 120.0, 300.0]),
        4.0..8.0_f64,
        prop::bool::weighted(0.2),
        prop::sample::select(vec![0.0, 15.0]),
    )
        .prop_map(|(factors, target, axis, memory, points, feed, path, mono, aside)| Call {
            factors,
            target,
            axis,
            memory,
            points,
            feed,
            path,
            mono,
            aside,
        })
}

fn parts() -> impl Strategy<Value = Part> {
    let shift = prop::array::uniform3(-0.3..0.3_f64);
    let tilt = prop::array::uniform3(-0.3..0.3_f64);
    (shift, -0.3..0.3_f64, tilt).prop_map(|(shift, size, tilt)| Part { shift, size, tilt })
}

/// Measurements of one variant.
fn measurements(cycle: &'static Cycle, variant: i64) -> impl Strategy<Value = Drawn> {
    (machines(), calls(), parts(), placed(500.0, 180.0)).prop_map(move |(machine, call, part, moved)| Drawn {
        cycle: cycle.name,
        variant,
        machine,
        call,
        part,
        moved,
    })
}

/// Measuring cycles that touch something, of milling and of turning machines.
pub fn measuring() -> impl Iterator<Item = &'static Cycle> {
    let touches = |cycle: &&&Cycle| {
        cycle.dialect == Dialect::Sinumerik && cycle.purpose.probe.measures() && cycle.work().is_some()
    };
    CYCLES.iter().filter(touches).copied()
}

/// Those that measure a part on a milling machine.
pub fn milling() -> impl Iterator<Item = &'static Cycle> {
    measuring().filter(|cycle| is_milling(cycle))
}

pub fn is_milling(cycle: &Cycle) -> bool {
    let purpose = &cycle.purpose;
    purpose.machine == MachineSort::Milling && purpose.probe == ProbeUse::Workpiece
}

/// So many measurements of a variant.
pub fn some(cycle: &'static Cycle, variant: i64, count: usize) -> Vec<Drawn> {
    let config = Config { rng_seed: RngSeed::Fixed(seed()), failure_persistence: None, ..Config::default() };
    let mut runner = TestRunner::new(config);
    let strategy = measurements(cycle, variant);
    (0..count).map(|_| strategy.new_tree(&mut runner).unwrap().current()).collect()
}

/// Why there was nothing to look at; none: the measurement counts.
pub type Passed = Option<String>;

/// Holds a property for so many measurements of every variant of these cycles. One that looks at next to nothing proves
/// nothing, so a third has to count.
pub fn hold(
    cycles: impl Iterator<Item = &'static Cycle>,
    cases: u32,
    property: impl Fn(&Drawn) -> Result<Passed, TestCaseError>,
) {
    for cycle in cycles {
        for variant in cycle.variants {
            let passed = RefCell::new(Vec::new());
            let config = Config {
                rng_seed: RngSeed::Fixed(seed()),
                failure_persistence: None,
                ..Config::with_cases(cases * longer())
            };
            let outcome = TestRunner::new(config).run(&measurements(cycle, variant.number), |drawn| {
                passed.borrow_mut().extend(property(&drawn)?);
                Ok(())
            });
            outcome.unwrap_or_else(|problem| panic!("{problem}"));
            let most = cases * longer() * 2 / 3;
            let passed = passed.into_inner();
            assert!(passed.len() as u32 <= most, "{} {}: {passed:?} of {cases}", cycle.name, variant.number);
        }
    }
}

/// `PROBEWRIGHT_SEED` draws other measurements.
fn seed() -> u64 {
    told("PROBEWRIGHT_SEED").unwrap_or(1)
}

/// `PROBEWRIGHT_CASES` draws so many times as many.
fn longer() -> u32 {
    told("PROBEWRIGHT_CASES").map_or(1, |times| times as u32)
}

fn told(name: &str) -> Option<u64> {
    std::env::var(name).ok()?.parse().ok()
}
