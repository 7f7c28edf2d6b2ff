//! The lines to change, as a file that a control reads: data of the control, then each channel's.

use super::fault::{MachineFault, written};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// A datum in a channel; 0: no channel is said.
type Datum = (u32, String);

fn datum(fault: &MachineFault) -> Datum {
    (fault.channel.unwrap_or(0), fault.name.clone())
}

/// Gives all faults of a datum the value that mends them all: several may concern its bits.
pub fn together(faults: &mut [MachineFault]) {
    let mut values: BTreeMap<Datum, f64> = BTreeMap::new();
    for fault in faults.iter() {
        let Some(mended) = &fault.mended else { continue };
        let before = values.get(&datum(fault)).copied();
        let value = match (before, mended.bits) {
            (Some(before), Some([set, clear])) => f64::from(before as u32 & !clear | set),
            (Some(before), None) => before, // the first says most: what other data are, then what is allowed
            (None, _) => mended.value,
        };
        values.insert(datum(fault), value);
    }
    for fault in faults.iter_mut().filter(|fault| fault.mended.is_some()) {
        if let Some(value) = values.get(&datum(fault)) {
            fault.mend(*value);
        }
    }
}

/// A line for each datum that a value mends.
pub fn lines(faults: &[MachineFault]) -> String {
    let mut seen = BTreeSet::new();
    let mended = faults.iter().filter_map(|fault| Some((fault, fault.mended.as_ref()?.value)));
    let mut order: Vec<(Datum, String, f64)> = mended
        .filter(|(fault, _)| seen.insert(datum(fault)))
        .map(|(fault, value)| (datum(fault), fault.line_name(), value))
        .collect();
    order.sort_by_key(|((channel, _), ..)| *channel);
    let (mut text, mut channel) = (String::new(), 0);
    for (datum, name, value) in order {
        if datum.0 != channel {
            channel = datum.0;
            let _ = writeln!(text, "CHANDATA({channel})");
        }
        // a datum whose name is not printed is a comment: no control reads its number alone
        let comment = if datum.1.starts_with("MD") && name == datum.1 { ";" } else { "" };
        let _ = writeln!(text, "{comment}{name}={}", written(&datum.1, value));
    }
    text
}
