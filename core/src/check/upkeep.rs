//! What a measuring call does with the data of the control before anything else: arrays that are in the other basic
//! system are converted (B:13594-13598, B:14059-14061), and arrays are erased on demand (B:13644). And its last step,
//! the measuring result screen.

use crate::control::delivery::{factor, scaled};
use crate::control::gud::{Block, Element, Gud};
use crate::control::{Control, Units, Value, gud};
use crate::diagnostic::Diagnostic;
use crate::entry::Cycle;
use crate::machine::{Machine, Step};
use crate::message::Message;
use crate::own;
use std::collections::BTreeMap;

/// 1: the next call sets [`ERASED`] and the switch itself to 0 (B:13560, B:13644).
const ERASE: &str = "_CBIT[13]";
const ERASED: [&str; 6] = ["_TP", "_TPW", "_WP", "_KB", "_EV", "_MV"];
/// In which basic system data stand, 1 metric: those of the control, and those of the channel.
const METRIC: [(&str, bool); 2] = [("_CBIT[3]", false), ("_CHBIT[24]", true)];

/// One thing that a call does first.
pub struct Due {
    /// As a warning before the call.
    pub finding: Diagnostic,
    /// As what the call did.
    told: Message,
    /// The data with what they become.
    writes: BTreeMap<String, Value>,
    /// The switch, with what it becomes.
    switch: (&'static str, f64),
}

/// What a call of this cycle does first on this control.
pub fn due(cycle: &Cycle, control: &Control) -> Vec<Due> {
    if !cycle.is_measuring_cycle() {
        return Vec::new();
    }
    let metric = control.basic_units == Units::Metric;
    let wrong = METRIC.into_iter().filter(|(bit, _)| control.bit(bit) != metric);
    let mut all: Vec<Due> = wrong.map(|one| convert(control, one)).collect();
    if control.bit(ERASE) {
        all.push(erase(control));
    }
    all
}

/// The control as it is behind that.
pub fn done(control: &Control, due: &[Due]) -> Control {
    let mut control = control.clone();
    due.iter().for_each(|one| one.apply(&mut control));
    control
}

/// Does it on a machine, and tells it.
pub fn perform(machine: &mut dyn Machine, cycle: &Cycle) {
    for one in due(cycle, machine.control()) {
        one.apply(machine.control());
        machine.record(Step::Decision { message: one.told });
    }
}

/// The result screen is shown until the cycle ends.
pub const SCREEN: &str = "evaluate-screen";
/// It waits for NC START.
pub const SCREEN_HALTS: &str = "evaluate-screen-halt";
/// It stays until the next measuring cycle.
pub const SCREEN_STAYS: &str = "evaluate-screen-stays";

/// The measuring result screen at a call's end: its time, or that it waits for NC START (B:12564-12578, B:13953-13971).
/// CYCLE102 shows it (B:2386).
pub fn screen(machine: &mut dyn Machine, cycle: &Cycle) {
    if shows(machine.control(), cycle) {
        show(machine);
    }
}

/// Whether a call of this cycle shows its results at its end.
pub fn shows(control: &Control, cycle: &Cycle) -> bool {
    cycle.is_measuring_cycle() && control.bit("_CHBIT[10]")
}

/// Shows it, as long as the machine says, where it shows any.
pub fn show(machine: &mut dyn Machine) {
    if !machine.reports() {
        return;
    }
    let control = machine.control();
    let key = match (control.bit("_CHBIT[11]"), control.bit("_CHBIT[18]")) {
        (true, _) => SCREEN_HALTS,
        (false, true) => SCREEN_STAYS,
        (false, false) => SCREEN,
    };
    machine.record(Step::Decision { message: Message::new(key) });
}

/// The switches as a call of this cycle leaves them.
pub fn settle(control: &mut Control, cycle: &Cycle) {
    for one in due(cycle, control) {
        control.set(one.switch.0, one.switch.1);
    }
}

impl Due {
    fn apply(&self, control: &mut Control) {
        for (name, value) in &self.writes {
            control.data.insert(name.clone(), value.clone());
        }
        control.set(self.switch.0, self.switch.1);
    }
}

/// Lengths, feeds and speeds of the control or of the channel, from the other basic system into that of the machine.
fn convert(control: &Control, (bit, channel): (&'static str, bool)) -> Due {
    let basic = control.basic_units;
    let (before, right) = if basic == Units::Metric { (Units::Inch, 1.0) } else { (Units::Metric, 0.0) };
    let ratio = |element: &Element| factor(element.unit, before) / factor(element.unit, basic);
    let counts = |gud: &&Gud| {
        gud.block != Block::Gud7
            && gud.of_machine()
            && gud.channel == channel
            && gud.elements.iter().any(|element| ratio(element) != 1.0)
    };
    let converted = |(name, value): (&String, &Value)| {
        let (gud, at) = gud::place(name).filter(|(gud, _)| counts(gud))?;
        let ratio = ratio(gud.element(&at)?);
        Some((name.clone(), scaled(value, ratio)))
    };
    let arrays: Vec<String> = gud::all().filter(counts).map(|gud| format!("{}[]", gud.name)).collect();
    let words = |key| Message::new(key).text("bit", bit).number("value", right).text("data", arrays.join(", "));
    let mut finding = own::CONVERTS.finding();
    finding.message = words(own::CONVERTS.cause);
    Due {
        finding: finding.hint(words(own::CONVERTS.hint)),
        told: words("evaluate-converted"),
        writes: control.data.iter().filter_map(converted).collect(),
        switch: (bit, right),
    }
}

fn erase(control: &Control) -> Due {
    let erased = |name: &&String| {
        let stem = name.split('[').next();
        stem.is_some_and(|stem| ERASED.contains(&stem))
    };
    let names = control.data.keys().filter(erased);
    Due {
        finding: own::ERASES.finding(),
        told: Message::new("evaluate-erased"),
        writes: names.map(|name| (name.clone(), Value::Number(0.0))).collect(),
        switch: (ERASE, 0.0),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::check::{Checked, check};
    use crate::control::{Plane, rebuilt};
    use crate::diagnostic::{Code, Severity};
    use crate::dialect::Dialect;
    use crate::entry::Typed;
    use crate::geometry::Mcs;
    use crate::machine::Setup;
    use crate::program::calls::calls_on;
    use crate::run::{Limits, Outcome, run};
    use crate::syntax::read;
    use crate::workpiece::{Shape, Solid};

    /// A hole, measured twice.
    const PROGRAM: &str = "G17 G54 G0 X0 Y0 Z-10\n_MVAR=1 _SETVAL=40 _PRNUM=1 _FA=2 _TSA=1 _KNUM=0 _TNUM=1 _VMS=0 \
        _NMSP=1 _EVNUM=2 _K=1 _TZL=0 _TMV=0.2 _TUL=0.5 _TLL=-0.5 _TDIF=0.6\nCYCLE977\nR1=_OVR[4] R2=_CBIT[13]\n\
        CYCLE977\nM30\n";

    fn setup(units: Units) -> Setup {
        let mut setup = Setup::calibrated_in(Dialect::Sinumerik, Plane::G17, units);
        setup.control.set("_EV[1]", 0.01 / units.factor());
        setup.control.set("_KB[0,2]", 15.0 / units.factor());
        setup.workpiece.solids.push(Solid::new(Shape::Hole { diameter: 40.02, depth: 30.0 }, Mcs::default()));
        setup
    }

    fn carried_out(setup: &Setup) -> Outcome {
        let mut text = PROGRAM.to_owned();
        if setup.control.basic_units == Units::Inch {
            text = format!("G710\n{text}");
        }
        run(&read(Dialect::Sinumerik, text.as_bytes()), setup, Limits::default())
    }

    fn doubts(outcome: &Outcome) -> Vec<Code> {
        let found = outcome.diagnostics.iter().filter(|one| one.severity == Severity::Warning);
        found.map(|one| one.code).filter(|code| matches!(code, Code::Own(160..=161))).collect()
    }

    // oracle: manual B:13596, B:14061, B:16328 (what stands in the other system is converted, with a message)
    #[test]
    fn data_of_the_other_system_measure_like_right_ones() {
        for (units, other) in [(Units::Metric, Units::Inch), (Units::Inch, Units::Metric)] {
            let right = setup(units);
            let expected = carried_out(&right);
            assert_eq!(expected.stop, None, "{:?}", expected.diagnostics);
            let mut wrong = right.clone();
            wrong.control.data = rebuilt(&right.control, other).data;
            wrong.control.set("MD10240", right.control.number("MD10240"));
            let outcome = carried_out(&wrong);
            for name in expected.control.data.keys() {
                let [one, other] = [&expected, &outcome].map(|one| one.control.number(name));
                assert!((one - other).abs() < 1e-9, "{name}: {one} {other}");
            }
            assert_eq!(doubts(&outcome), [Code::Own(161); 2]);
            assert_eq!(doubts(&expected), []);
            let told = outcome.decisions();
            let told = told.iter().filter(|one| one.key == "evaluate-converted");
            assert_eq!(told.count(), 2, "once for the control, once for the channel");
        }
    }

    // oracle: manual B:13560, B:13644 (at the next call, once)
    #[test]
    fn arrays_are_erased_at_the_next_call() {
        let mut setup = setup(Units::Metric);
        setup.control.set("_CBIT[13]", 1.0);
        setup.control.set("_MV[3]", 0.02);
        let outcome = carried_out(&setup);
        assert_eq!(outcome.alarms(), [Code::Alarm(61341)], "nothing is calibrated any more");
        let left = |name: &String| {
            let stem = name.split('[').next().unwrap();
            ERASED.contains(&stem) && outcome.control.number(name) != 0.0
        };
        assert_eq!(outcome.control.data.keys().find(|name| left(name)), None);
        assert!(!outcome.control.bit("_CBIT[13]"));
        assert_eq!(outcome.control.number("_SPEED[1]"), 1000.0);
        assert_eq!(doubts(&outcome), [Code::Own(160)]);
        let names: Vec<String> = outcome.changes().into_iter().map(|one| one.name).collect();
        for name in ["_WP[0,0]", "_EV[1]", "_MV[3]", "_KB[0,2]", "_TP[0,7]", "_TP[0,9]", "_TPW[2,7]"] {
            assert!(names.iter().any(|one| one == name), "{name}");
        }
        // axes are no length: 133 in every system of units
        let changes = outcome.changes();
        let axes = changes.iter().find(|one| one.name == "_TP[0,7]").unwrap();
        assert_eq!((axes.before, axes.after), (133.0, 0.0));
    }

    // oracle: hand (the first call erases; a program that computes measures nothing)
    #[test]
    fn a_program_is_warned_about_at_the_call_that_does_it() {
        let text = format!("_CBIT[13]=1\n{PROGRAM}");
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let sites = calls_on(&program, setup(Units::Metric).control);
        let erases = |index: usize| sites[index].diagnostics.iter().filter(|one| one.code == Code::Own(160)).count();
        assert_eq!([erases(0), erases(1)], [1, 0]);
        let mut control = setup(Units::Metric).control;
        control.set("_CBIT[13]", 1.0);
        let helper = crate::catalogue::find(Dialect::Sinumerik, "CYCLE116").unwrap();
        let Checked { diagnostics, .. } = check(helper, &Typed::new(), &control);
        assert!(diagnostics.iter().all(|one| one.code != Code::Own(160)));
    }
}
