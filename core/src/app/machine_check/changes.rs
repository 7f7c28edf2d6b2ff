//! The lines to change, as a file that a control reads: data of the control, then each channel's.

use super::fault::{MachineFault, written};
use std::collections::BTreeMap;
use std::fmt::Write;

/// A line for each datum that a value mends; several that concern its bits together.
pub fn lines(faults: &[MachineFault]) -> String {
    let mut values: BTreeMap<(u32, &str), f64> = BTreeMap::new();
    let mut order: Vec<((u32, &str), String)> = Vec::new();
    for fault in faults {
        let Some(mended) = &fault.mended else { continue };
        let datum = (fault.channel.unwrap_or(0), fault.name.as_str());
        let before = values.get(&datum).copied();
        let value = match (before, mended.bits) {
            (Some(before), Some([set, clear])) => f64::from(before as u32 & !clear | set),
            (Some(before), None) => before, // the first says most: what other data are, then what is allowed
            (None, _) => mended.value,
        };
        if values.insert(datum, value).is_none() {
            order.push((datum, fault.line_name()));
        }
    }
    order.sort_by_key(|((channel, _), _)| *channel);
    let (mut text, mut channel) = (String::new(), 0);
    for (datum, name) in order {
        if datum.0 != channel {
            channel = datum.0;
            let _ = writeln!(text, "CHANDATA({channel})");
        }
        let value = values.get(&datum).copied().unwrap_or_default();
        // a datum whose name is not printed is a comment: no control reads its number alone
        let comment = if datum.1.starts_with("MD") && name == datum.1 { ";" } else { "" };
        let _ = writeln!(text, "{comment}{name}={}", written(datum.1, value));
    }
    text
}
