//! A measurement changes its results, what it corrects and what it remembers, and nothing else; and everything that it
//! changes is told.

use super::draw::{Drawn, hold, measuring};
use super::stand::stand;
use probewright_core::control::{Control, Value};
use probewright_core::entry::ProbeUse;
use probewright_core::machine::trace::Step;
use probewright_core::run::Outcome;
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;
use std::collections::BTreeSet;

/// Names of everything that has another value afterwards.
fn changed(before: &Control, after: &Control) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for name in before.data.keys().chain(after.data.keys()) {
        if before.data.get(name) != after.data.get(name) {
            names.insert(name.clone());
        }
    }
    let stored = before.variables().chain(after.variables()).map(|(name, _)| name);
    names.extend(stored.filter(|name| before.variable(name).unwrap_or(0.0) != after.variable(name).unwrap_or(0.0)));
    names
}

/// The frame that `_KNUM` means (B:1930-1969).
fn frame(knum: i64, before: &Control) -> String {
    match knum {
        1..=99 => format!("$P_UIFR[{knum},"),
        1011..=1026 => format!("$P_CHBFR[{},", knum - 1011),
        1051..=1066 => format!("$P_NCBFR[{},", knum - 1051),
        2000 => "$P_SETFR[".to_owned(),
        9999 if before.settable != 0 => format!("$P_UIFR[{},", before.settable),
        1000 | 9999 => {
            let last = before.channel_basic_numbers().into_iter().next_back();
            format!("$P_CHBFR[{},", last.unwrap())
        }
        _ => "nothing".to_owned(),
    }
}

/// Whether a measurement may change this datum.
fn may_change(drawn: &Drawn, values: &dyn Fn(&str) -> i64, before: &Control, name: &str) -> bool {
    let starts = |stems: &[String]| stems.iter().any(|stem| name.starts_with(stem.as_str()));
    let results = ["_OVR[", "_OVI[", "_MP_RES"].map(str::to_owned);
    let cycle = drawn.cycle();
    let probe = (values("_PRNUM") % 100 - 1).max(0);
    let memory = values("_EVNUM") - 1;
    let remembered = [format!("_MV[{memory}]"), format!("_EV[{memory}]")];
    let calibrates = cycle.purpose.calibrates.holds(&probewright_core::entry::Inputs::new(cycle, drawn.variant));
    let calibrated = [format!("_WP[{probe},"), format!("_TP[{probe},"), format!("_TPW[{probe},")];
    let knum = values("_KNUM");
    let frame = [frame(knum, before)];
    let of_tool = name.starts_with("$TC_");
    // a tool at a tool probe and, with its length, a probe that is calibrated correct themselves
    let own = format!("[{},{}]", before.tool, before.edge);
    let corrected = format!("[{},{}]", values("_TNUM"), knum % 1000);
    let itself = calibrates || cycle.purpose.probe == ProbeUse::Tool;
    starts(&results)
        || memory >= 0 && remembered.contains(&name.to_owned())
        || (calibrates || differential(drawn)) && starts(&calibrated)
        || of_tool && name.ends_with(if itself { &own } else { &corrected })
        || !itself && starts(&frame)
}

/// Whether a measurement turns the spindle by 180 degree to find the skew, and keeps what it found (A:7281-7291).
fn differential(drawn: &Drawn) -> bool {
    [("CYCLE978", 1000), ("CYCLE978", 1100), ("CYCLE998", 1105)].contains(&(drawn.cycle, drawn.variant))
}

fn told(outcome: &Outcome) -> BTreeSet<String> {
    let steps = outcome.trace.entries.iter();
    let name = |step: &Step| match step {
        Step::Set { name, .. } => Some(name.clone()),
        _ => None,
    };
    steps.filter_map(|entry| name(&entry.step)).collect()
}

/// What a program would find otherwise than before although no datum says so.
fn modal(before: &Control, after: &Control) -> Option<String> {
    let state = |control: &Control| {
        let units = (control.basic_units, control.active_units, control.data_follow);
        let tool = (control.tool, control.edge, control.location);
        let place = (control.plane, control.transverse, control.settable);
        format!("{units:?} {tool:?} {place:?} {:?} {:?}", control.program_frame, control.rotary)
    };
    (state(before) != state(after)).then(|| format!("{} became {}", state(before), state(after)))
}

// oracle: manual B:1894-2060 (targets), B:2191-2206 (memories), B:13357 (data of the probes)
#[test]
fn nothing_else_changes() {
    hold(measuring(), 10, |drawn| -> Result<_, TestCaseError> {
        let stand = match stand(drawn) {
            Ok(stand) => stand,
            Err(refused) => return Ok(Some(refused)),
        };
        let outcome = stand.run();
        let before = &stand.setup.control;
        let values = |name: &str| stand.inputs.cycle.param(name).map_or(0, |param| stand.inputs.integer(param.name));
        let told = told(&outcome);
        for name in changed(before, &outcome.control) {
            prop_assert!(may_change(drawn, &values, before, &name), "{} changes: {:?}", name, drawn);
            let known = told.contains(&name) || matches!(outcome.control.data.get(&name), Some(Value::Text(_)));
            prop_assert!(known, "{} changes and is not told: {:?}", name, drawn);
        }
        prop_assert_eq!(modal(before, &outcome.control), None, "{:?}", drawn);
        Ok(outcome.stop.map(|stop| format!("{stop:?}")))
    });
}
