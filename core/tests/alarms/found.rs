//! What the table of alarms says about being found, against what is found: the cases of the simulated cycles, the wrong
//! programs of `tests/wrong`, and for cycles of which only form and checks are known a walk over odd values.

use super::{simulated, table};
use probewright_core::catalogue::alarms::{ALARMS, Found};
use probewright_core::catalogue::{CYCLES, example};
use probewright_core::check::check;
use probewright_core::control::{Control, Edge, Plane, Tool, delivery};
use probewright_core::diagnostic::{Code, Diagnostic};
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, Typed};
use probewright_core::jog::{Input, Session};
use probewright_core::machine::{Setup, Stop};
use probewright_core::program::{findings, findings_on};
use probewright_core::syntax::{Program, read};
use std::collections::BTreeSet;

/// Alarms that nothing raises, with the reason. One that a check or a simulation begins to raise leaves this list and
/// changes its [`Found`] in the table.
const NOWHERE: &[(&str, &[u32])] = &[
    ("the manual gives no condition", &[61306, 61327]),
    ("a cycle that is not permitted is no entry", &[61312]),
    ("internal error of the cycles", &[61319, 61340, 61403, 61404]),
    ("the simulated machine has one spindle", &[61344]),
    ("the folder of the program is there, and its memory has room", &[61353, 61357]),
    ("internal error of the log", &[61358, 61359]),
];

/// Programs for what one odd value does not bring about: logs without contents, without titles or of data that cannot
/// be logged, and corners whose four points P1 to P4 do not make one.
const PROGRAMS: &[&str] = &[
    "_PROTNAME[1]=\"LOG\"\nCYCLE100\nM30\n",
    "_PROTNAME[1]=\"LOG\" _PROTFORM[5]=0 _PROTVAL[2]=\"R1\"\nCYCLE100\nM30\n",
    "_PROTNAME[1]=\"LOG\" _PROTVAL[2]=\"_OVI[0]\"\nCYCLE100\nM30\n",
    "_MVAR=117 _SETV[0]=SET(50,20,50,20,20,50,20,90)\nCYCLE961\nM30\n", // P1 is P2
    "_MVAR=117 _SETV[0]=SET(50,20,90,20,50,60,90,60)\nCYCLE961\nM30\n", // parallel
    "_MVAR=117 _SETV[0]=SET(-50,20,90,20,20,50,20,90)\nCYCLE961\nM30\n", // meet between P1 and P2
];
/// Values that are wrong for many parameters.
const ODD: [&str; 10] = ["", "-1", "0", "1", "3", "7", "103", "999", "-500", "100000"];
/// Types of tools (710 and 500: probes), planes, edge positions.
const TOOLS: &[(i64, Plane, i64)] = &[
    (120, Plane::G17, 0),
    (120, Plane::G18, 0),
    (710, Plane::G17, 0),
    (500, Plane::G18, 3),
    (500, Plane::G18, 9),
    (580, Plane::G19, 7),
];
/// Data of the machine that every cycle reads.
const DATA: &[&str] = &["_SPEED[0]", "_SPEED[1]", "_TP[0,8]", "_TP[0,9]", "_CM[5]"];

#[test]
fn the_table_says_where_each_alarm_is_found() {
    // oracle: self (cases, programs and calls that raise them)
    let (check, run) = (found_by_check(), found_in_a_run());
    for alarm in ALARMS {
        let name = alarm.code.to_string();
        let found = match (check.contains(&name), run.contains(&name)) {
            (true, true) => Found::Both,
            (true, false) => Found::Check,
            (false, true) => Found::Run,
            (false, false) => Found::Nowhere,
        };
        assert_eq!(alarm.found, found, "{name} in catalogue/alarms.rs");
    }
}

#[test]
fn alarms_that_nothing_raises_are_known_by_name() {
    // oracle: hand
    let nowhere = ALARMS.iter().filter(|alarm| alarm.found == Found::Nowhere);
    let mut listed: Vec<u32> = NOWHERE.iter().flat_map(|(_, numbers)| *numbers).copied().collect();
    listed.sort_unstable();
    let listed: Vec<Code> = listed.into_iter().map(Code::Alarm).collect();
    assert_eq!(nowhere.map(|alarm| alarm.code).collect::<Vec<_>>(), listed);
}

/// Every case of a simulated cycle raises its alarm (tested beside this); measuring in JOG has one of its own.
fn found_in_a_run() -> BTreeSet<String> {
    let cases = simulated().flat_map(|cycle| table(cycle.name).cases);
    cases.map(|case| case.code.to_string()).chain([found_in_jog()]).collect()
}

/// What a tool raises whose tool probe has no diameter in the set-up of JOG.
fn found_in_jog() -> String {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.control.set_variable("$TC_DP1[1,1]", 120.0);
    let mut session = Session::new(&setup);
    session.take_tool(1, 1).unwrap();
    session.press(Input::Function("tool_length")).unwrap();
    session.carry_out(Input::Start).unwrap();
    let Some(Stop::Alarm(code)) = session.stopped() else { panic!("{:?}", session.stopped()) };
    code.to_string()
}

fn found_by_check() -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut add = |list: Vec<Diagnostic>| found.extend(list.iter().map(|one| one.code.to_string()));
    for (program, control) in case_programs() {
        add(findings_on(&program, control));
    }
    wrong_programs().iter().for_each(|program| add(findings(program)));
    for text in PROGRAMS {
        add(findings(&read(Dialect::Sinumerik, text.as_bytes())));
    }
    for cycle in CYCLES {
        walk(cycle, &mut add);
    }
    found
}

/// The cases of simulated cycles as programs that are only checked.
fn case_programs() -> Vec<(Program, Control)> {
    let mut programs = Vec::new();
    for cycle in simulated() {
        let table = table(cycle.name);
        for case in &table.cases {
            let mut setup = (table.setup)();
            (case.prepare)(&mut setup);
            let text = table.program.replace("{change}", case.change);
            programs.push((read(cycle.dialect, text.as_bytes()), setup.control));
        }
    }
    programs
}

fn wrong_programs() -> Vec<Program> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/wrong");
    let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let programs = paths.filter(|path| path.extension().is_some_and(|name| name == "mpf"));
    programs.map(|path| read(Dialect::Sinumerik, &std::fs::read(path).unwrap())).collect()
}

/// Every variant's example with one value that is odd, and as it is on machines where something is wrong.
fn walk(cycle: &'static Cycle, add: &mut impl FnMut(Vec<Diagnostic>)) {
    let machines = machines(cycle);
    for variant in cycle.variants {
        let usual = example::example(cycle, variant);
        for control in &machines {
            add(check(cycle, &usual, control).diagnostics);
        }
        let values = cycle.params.iter().flat_map(|param| ODD.map(|odd| (param.name, odd)));
        for (name, value) in values {
            let mut typed: Typed = usual.clone();
            typed.insert(name.to_string(), value.to_owned());
            for control in &machines[..2] {
                add(check(cycle, &typed, control).diagnostics);
            }
        }
    }
}

/// With default data; with tools of several types in use, in several planes; with data of the machine that are wrong.
fn machines(cycle: &Cycle) -> Vec<Control> {
    let usual = delivery(cycle.dialect);
    let mut machines = vec![usual.clone()];
    for (kind, plane, tip) in TOOLS {
        machines.push(with_tool(&usual, *kind, *plane, *tip));
    }
    let mill = machines[1].clone();
    for name in cycle.settings.iter().chain(DATA) {
        for value in [-1.0, 0.0, 1.0, 2.0, 3.0, 201.0] {
            let mut control = mill.clone();
            control.set(*name, value);
            machines.push(control);
        }
    }
    let mut control = mill;
    control.spindle_positions = false;
    control.program_frame.rotation[2] = 30.0;
    machines.push(control);
    machines
}

/// A machine with this tool in use, its size and the depth of the tool probe unknown.
fn with_tool(usual: &Control, kind: i64, plane: Plane, tip: i64) -> Control {
    let edge = Edge { kind, tip, ..Edge::default() };
    let tool = Tool { name: "TOOL".into(), edges: [(1, edge)].into() };
    let mut control = usual.clone();
    (control.plane, control.tool, control.edge) = (plane, 1, 1);
    control.tools.insert(1, tool);
    control.set("_TP[0,9]", 0.0);
    control
}
