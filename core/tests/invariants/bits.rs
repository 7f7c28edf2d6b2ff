//! Every switch of `_CBIT[]` and `_CHBIT[]` changes something in some measurement, or is listed with the reason why
//! nothing comes of it here. What the data list as internal has no meaning that a manual tells.

use super::draw::{Drawn, some};
use super::stand::{Stand, stand, typed};
use probewright_core::catalogue::find;
use probewright_core::check::check;
use probewright_core::control::gud;
use probewright_core::dialect::Dialect;

/// A measurement in which a switch matters.
struct Row {
    switch: &'static str,
    cycle: &'static str,
    variant: i64,
    /// Data with which it does, beside it.
    with: &'static [(&'static str, f64)],
}

const fn row(switch: &'static str, cycle: &'static str, variant: i64, with: &'static [(&'static str, f64)]) -> Row {
    Row { switch, cycle, variant, with }
}

// oracle: manual (the lines beside each)
#[rustfmt::skip]
const ROWS: &[Row] = &[
    row("_CBIT[0]", "CYCLE977", 1, &[]),                               // B:13534
    row("_CBIT[1]", "CYCLE977", 1, &[("_CBIT[0]", 1.0)]),              // B:13536
    row("_CBIT[2]", "CYCLE977", 1, &[]),                               // B:13537
    row("_CBIT[3]", "CYCLE977", 1, &[]),                               // B:13539
    row("_CBIT[5]", "CYCLE982", 1, &[]),                               // B:13541
    row("_CBIT[8]", "CYCLE978", 100, &[]),                             // B:13549
    row("_CBIT[12]", "CYCLE971", 2, &[]),                              // B:13558
    row("_CBIT[13]", "CYCLE977", 1, &[]),                              // B:13560
    row("_CBIT[14]", "CYCLE976", 10_000, &[]),                            // B:13561
    row("_CBIT[15]", "CYCLE976", 101, &[]),                            // B:13563
    row("_CBIT[16]", "CYCLE977", 101, &[("_WP[0,10]", 3.0)]),          // B:13565
    row("_CHBIT[2]", "CYCLE977", 1, &[]),                              // B:13838
    row("_CHBIT[3]", "CYCLE971", 1, &[]),                              // B:13839
    row("_CHBIT[4]", "CYCLE977", 1, &[]),                              // B:13841
    row("_CHBIT[5]", "CYCLE977", 1, &[]),                              // B:13843
    row("_CHBIT[6]", "CYCLE977", 1, &[]),                              // B:13845
    row("_CHBIT[7]", "CYCLE994", 1, &[("_WP[0,0]", 6.2)]),                              // B:13850
    row("_CHBIT[8]", "CYCLE977", 1, &[]),                              // B:13852
    row("_CHBIT[10]", "CYCLE977", 1, &[]),                             // B:13855
    row("_CHBIT[11]", "CYCLE977", 1, &[("_CHBIT[10]", 1.0)]),          // B:13864
    row("_CHBIT[13]", "CYCLE977", 101, &[]),                           // B:13867
    row("_CHBIT[14]", "CYCLE977", 101, &[("_CHBIT[13]", 1.0)]),        // B:13869
    row("_CHBIT[15]", "CYCLE977", 101, &[]),                           // B:13870
    row("_CHBIT[16]", "CYCLE977", 101, &[]),                           // B:13871
    row("_CHBIT[17]", "CYCLE977", 101, &[]),                           // B:13872
    row("_CHBIT[18]", "CYCLE977", 1, &[("_CHBIT[10]", 1.0)]),          // B:13873
    row("_CHBIT[19]", "CYCLE974", 0, &[]),                             // B:13874
    row("_CHBIT[20]", "CYCLE982", 1101, &[]),                          // B:13875
    row("_CHBIT[21]", "CYCLE977", 101, &[]),                           // B:13876
    row("_CHBIT[23]", "CYCLE982", 1, &[]),                             // B:13882
    row("_CHBIT[24]", "CYCLE977", 1, &[]),                             // B:13883
];

/// Switches from which nothing comes here, and why.
const SILENT: &[(&str, &str)] = &[
    ("_CBIT[6]", "lines of the log, which is off in these calls"),
    ("_CBIT[7]", "orientable tool carriers: the setup has none"),
    ("_CBIT[11]", "header of the log, which is off in these calls"),
    ("_CHBIT[0]", "the input at which the probe is connected, as a cycle has it; MEAS of a program is told of another"),
    ("_CHBIT[1]", "the same of the tool probe"),
    ("_CHBIT[22]", "by how much the last touch of a turning tool is slower, no manual tells"),
];

/// Whether a call, its findings or what it leaves differ with the switch.
fn matters(drawn: &Drawn, stand: &Stand, row: &Row) -> bool {
    let [off, on] = [0.0, 1.0].map(|value| {
        let mut stand = stand.clone();
        let control = &mut stand.setup.control;
        row.with.iter().for_each(|(name, value)| control.set(*name, *value));
        control.set(row.switch, value);
        let checked = check(drawn.cycle(), &typed(drawn, control), control);
        stand.inputs = checked.inputs.unwrap_or(stand.inputs);
        let mut outcome = stand.run();
        outcome.control.set(row.switch, 0.0);
        (checked.diagnostics, outcome)
    });
    on.0 != off.0 || on.1.control != off.1.control || on.1.trace != off.1.trace || on.1.stop != off.1.stop
}

/// Measurements of a row: as wrong as drawn, and so wrong that limits are passed.
fn shown(row: &Row) -> bool {
    let cycle = find(Dialect::Sinumerik, row.cycle).unwrap();
    some(cycle, row.variant, 48).into_iter().any(|drawn| {
        [1.0, 20.0].into_iter().any(|scale| {
            let mut drawn = drawn.clone();
            drawn.part.shift = drawn.part.shift.map(|shift| shift * scale);
            drawn.part.size *= scale.min(10.0);
            stand(&drawn).is_ok_and(|stand| matters(&drawn, &stand, row))
        })
    })
}

#[test]
fn every_switch_matters() {
    let silent: Vec<&str> = ROWS.iter().filter(|row| !shown(row)).map(|row| row.switch).collect();
    assert_eq!(silent, Vec::<&str>::new());
}

#[test]
fn no_switch_is_forgotten() {
    let mut missing = Vec::new();
    for array in ["_CBIT", "_CHBIT"] {
        let gud = gud::named(&format!("{array}[0]")).unwrap();
        for index in 0..30 {
            let name = format!("{array}[{index}]");
            let known = gud.element(&[index]).is_some_and(|element| !element.internal);
            let listed = ROWS.iter().map(|row| row.switch).chain(SILENT.iter().map(|(name, _)| *name));
            let times = listed.filter(|one| *one == name).count();
            if times != usize::from(known) {
                missing.push(format!("{name}: {known}, listed {times} times"));
            }
        }
    }
    assert_eq!(missing, Vec::<String>::new());
}
