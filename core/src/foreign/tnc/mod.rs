//! HEIDENHAIN TNC: `TCH PROBE 4xx`, one `Qnnn=value` a line, in DIN/ISO `G4xx` with the same parameters. Facts from
//! published pages of its manuals (TNC 320 9/2016, TNC 320 340 55x-04, iTNC 530, TNC 640 9/2015, TNC7) and from what a
//! published post processor writes (Autodesk, revision 42300); `table` names the page of each cycle.

mod log;
mod read;
mod table;

use super::{Foreign, ForeignCycle, Parameter};
use std::fmt::Write;

/// The control.
pub static CONTROL: Foreign = Foreign {
    name: "HEIDENHAIN TNC",
    cycles: &table::CYCLES,
    results: "tnc-results",
    unpublished: "tnc-unpublished",
    named: read::named,
    is_program: read::is_program,
    calls: read::calls,
    values: read::values_of_line,
    is_log: log::is_log,
    logs: log::logs,
    call,
};

/// A call: a line a parameter, each but the last going on with `~`.
fn call(cycle: &ForeignCycle, values: &[(&Parameter, f64)]) -> String {
    let mut text = format!("{} {}", cycle.name, cycle.text);
    for (parameter, value) in values {
        let _ = write!(text, " ~\n  {}={} ;{}", parameter.name, number(*value), parameter.text);
    }
    text + "\n"
}

/// A number with its sign and at most four decimals, as the control writes it.
fn number(value: f64) -> String {
    let text = format!("{:+.4}", value + 0.0);
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "+0".to_owned() } else { text.to_owned() }
}
