//! Programs that test a probe: whether it switches (B:12790-12856, A:14006-14113), and how far repeated touches of one
//! place spread (B:15161-15217, A:15767-15807). They measure with `MEAS` and no cycle; the words are our own.

use crate::control::{AXES, Plane};
use std::fmt::Write;

/// What is touched, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct ProbeTest {
    /// Axis that moves: 0 X, 1 Y, 2 Z.
    pub axis: usize,
    /// Where the motion begins and where it ends without a signal, in the unit that is active.
    pub ends: [f64; 2],
    /// Feed a minute in that unit; that of the measuring cycles.
    pub feed: f64,
    /// Measuring input, 1 or 2.
    pub input: u8,
    /// T and D number of the probe.
    pub place: (i64, i64),
    /// Whether M6 changes the tool.
    pub changes: bool,
    /// Working plane.
    pub plane: Plane,
    /// Whether that unit is the inch: the program says so, as with G70 and G71 feed and measured position are in the
    /// basic system.
    pub inch: bool,
}

/// Where the values of repeated touches are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keep {
    /// In an array of the program, which is there until it ends: to be read at its M0.
    Array,
    /// In R parameters from this one on, which stay.
    Parameters(usize),
}

/// First of the R parameters.
pub const FIRST: usize = 100;

/// The words of a key, for comments and operator texts.
pub type Words<'a> = &'a dyn Fn(&str) -> String;

/// Keys of these words.
pub const SAYS: [&str; 5] =
    ["probe-test-function", "probe-test-repeat", "probe-test-switched", "probe-test-failed", "probe-test-done"];

impl ProbeTest {
    /// One touch: whether the probe switches, and where.
    pub fn function(&self, words: Words) -> String {
        let (axis, [start, end]) = (self.axis(), self.ends);
        let mut text = Text::new("PW_PROBE_CHECK", &words("probe-test-function"));
        text.line(&format!("DEF INT PW_SIG,PW_IN={}", self.input));
        self.begin(&mut text);
        text.line(&format!("G0 {axis}{start} F{}", self.feed));
        text.line(&format!("MEAS=PW_IN G1 {axis}{end}"));
        text.line("STOPRE");
        text.line("PW_SIG=$AC_MEA[PW_IN]");
        text.line("IF PW_SIG==0 GOTOF PW_FAIL");
        text.line(&format!("R1=$AA_MW[{axis}] R2=$AA_MM[{axis}]"));
        text.line(&message(&words("probe-test-switched")));
        text.line("M0");
        text.line("M2");
        text.failed(words);
        text.whole
    }

    /// So many touches of one place; the values are in the workpiece system, or in that of the machine.
    pub fn repeat(&self, count: usize, keep: Keep, machine: bool, words: Words) -> String {
        let (axis, input, [start, end]) = (self.axis(), self.input, self.ends);
        let mut text = Text::new("PW_REPEAT", &words("probe-test-repeat"));
        text.line("DEF INT PW_SIG,PW_K");
        if keep == Keep::Array {
            text.line(&format!("DEF REAL PW_VAL[{count}]"));
        }
        self.begin(&mut text);
        text.line("PW_K=0");
        text.line("PW_NEXT:");
        text.line(&format!("G0 {axis}{start} F{}", self.feed));
        text.line(&format!("MEAS={input} G1 {axis}{end}"));
        text.line("STOPRE");
        text.line(&format!("PW_SIG=$AC_MEA[{input}]"));
        text.line("IF PW_SIG==0 GOTOF PW_FAIL");
        let value = format!("{}[{axis}]", if machine { "$AA_MM" } else { "$AA_MW" });
        text.line(&match keep {
            Keep::Array => format!("PW_VAL[PW_K]={value}"),
            Keep::Parameters(first) => format!("R[{first}+PW_K]={value}"),
        });
        text.line("PW_K=PW_K+1");
        text.line(&format!("IF PW_K<{count} GOTOB PW_NEXT"));
        text.line(&message(&words("probe-test-done")));
        text.line("M0");
        text.line("STOPRE");
        text.line("M2");
        text.failed(words);
        text.whole
    }

    fn axis(&self) -> &'static str {
        AXES.get(self.axis).copied().unwrap_or("X")
    }

    /// Plane, dimensions, and the probe with its offset.
    fn begin(&self, text: &mut Text) {
        let (tool, edge) = self.place;
        let plane = self.plane.code();
        let units = if self.inch { 700 } else { 710 };
        if self.changes {
            text.line(&format!("T{tool}"));
            text.line("M6");
            text.line(&format!("G{plane} G90 G94 G{units} D{edge}"));
        } else {
            text.line(&format!("G{plane} G90 G94 G{units} T{tool} D{edge}"));
        }
    }
}

/// A program that grows line by line.
struct Text {
    whole: String,
    number: usize,
}

impl Text {
    fn new(name: &str, says: &str) -> Text {
        Text { whole: format!("%_N_{name}_MPF\n;$PATH=/_N_MPF_DIR\n;{says}\n"), number: 0 }
    }

    /// A block with its number; a label has none.
    fn line(&mut self, line: &str) {
        if line.ends_with(':') {
            let _ = writeln!(self.whole, "{line}");
        } else {
            self.number += 10;
            let _ = writeln!(self.whole, "N{} {line}", self.number);
        }
    }

    /// The branch of a probe that did not switch.
    fn failed(&mut self, words: Words) {
        self.line("PW_FAIL:");
        self.line(&message(&words("probe-test-failed")));
        self.line("M0");
        self.line("M2");
    }
}

fn message(says: &str) -> String {
    format!("MSG(\"{}\")", says.replace('"', "'"))
}
