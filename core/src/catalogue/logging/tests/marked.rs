//! The mark at results that exceed a limit, and that every difference has its actual value.

use crate::catalogue::CYCLES;
use crate::catalogue::logging::marks::pairs;
use crate::control::Plane;
use crate::diagnostic::Code;
use crate::dialect::Dialect;
use crate::entry::Inputs;
use crate::geometry::Mcs;
use crate::machine::{Setup, Stop};
use crate::run::{Limits, run};
use crate::syntax::read;
use crate::workpiece::{Shape, Solid};

/// A measurement of a hole of 40 mm with tool offset.
pub const CALL: &str = "_MVAR=1 _SETVAL=40 _PRNUM=1 _FA=4 _TSA=2 _KNUM=0 _TNUM=1 _VMS=0 _NMSP=1 _EVNUM=0 _K=1 _TZL=0\n\
    _TMV=0.2 _TUL=0.5 _TLL=-0.3 _TDIF=0.6\nG17 G0 X0 Y0 Z-10\nCYCLE977\n";

/// A machine with a hole of this diameter.
pub fn hole(diameter: f64) -> Setup {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.workpiece.solids.push(Solid::new(Shape::Hole { diameter, depth: 30.0 }, Mcs::default()));
    setup
}

/// The values of the block that measuring a hole of this diameter adds, and what stops the program.
fn block(diameter: f64) -> (Vec<String>, Option<Stop>) {
    let text = format!(
        "_PROTNAME[1]=\"LOG\" _PROTSYM[0]=\",\" _PROTSYM[1]=\"*\" _PROTVAL[0]=\"T\"\n\
         _PROTVAL[2]=\"_OVR[0],_OVR[4],_OVR[16],_OVR[5],_OVR[17],_OVR[29]\"\nCYCLE100\n{CALL}CYCLE101\nM30\n"
    );
    let outcome = run(&read(Dialect::Sinumerik, text.as_bytes()), &hole(diameter), Limits::default());
    let last = outcome.files.lines("LOG.MPF").unwrap().last().unwrap().clone();
    (last.split(',').map(|text| text.trim().to_owned()).collect(), outcome.stop)
}

// oracle: manual B:11439-11441 (which limits, and that actual value and difference have the mark), B:2211 (the setpoint
// in the middle of the tolerance, 40.1, limits at ±0.4), figures by hand
#[test]
fn what_exceeds_a_limit_has_the_mark() {
    assert_eq!(block(40.2).0, ["40.100", "40.200", "0.100", "0.000", "0.000", "0.600"]);
    for diameter in [40.55, 39.65, 40.75] {
        let (actual, difference) = (format!("{diameter:.3}*"), format!("{:.3}*", diameter - 40.1));
        assert_eq!(block(diameter).0, ["40.100", &actual, &difference, "0.000", "0.000", "0.600"]);
    }
    let (values, stop) = block(42.2);
    assert_eq!(values[..3], ["40.100", "42.200*", "2.100*"], "beyond the safe area");
    assert_eq!(stop, Some(Stop::Alarm(Code::Alarm(61303))));
}

// oracle: self (the keys of the results)
#[test]
fn differences_have_their_actual_values() {
    for cycle in CYCLES.iter().filter(|cycle| cycle.is_measuring_cycle()) {
        for variant in cycle.variants {
            let inputs = Inputs::new(cycle, variant.number);
            for (actual, difference) in pairs(&inputs) {
                assert!(actual.is_some(), "{} {}: {}", cycle.name, variant.number, difference.key);
            }
        }
    }
}
