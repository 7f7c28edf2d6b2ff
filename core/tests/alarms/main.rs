//! Every alarm that an entry of the catalogue names is raised by a program, or stands in a list with the reason why it
//! cannot be. A new cycle needs its cases here as soon as it is simulated.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod cycle961;
mod cycle971;
mod cycle973;
mod cycle974;
mod cycle976;
mod cycle977;
mod cycle978;
mod cycle979;
mod cycle994;
mod cycle997;
mod cycle998;
mod found;
mod helpers;
mod lathe;
mod log;
#[path = "../running/mill.rs"]
mod mill;
mod nct;
mod p9920;
mod table;
#[path = "../running/turning.rs"]
mod turning;
mod turning_tool;
mod workpiece;

use probewright_core::catalogue::CYCLES;
use probewright_core::catalogue::alarms::stops;
use probewright_core::diagnostic::Code;
use probewright_core::entry::Cycle;
use probewright_core::machine::{Setup, Stop};
use probewright_core::run::{Limits, Outcome, run};
use probewright_core::syntax::read;
use table::{Case, Table};

/// The cases of a cycle.
fn table(name: &str) -> Table {
    match name {
        "CYCLE100" => log::cycle100(),
        "CYCLE101" => log::cycle101(),
        "CYCLE105" => log::cycle105(),
        "CYCLE106" => log::cycle106(),
        "CYCLE113" => log::cycle113(),
        "CYCLE116" => helpers::cycle116(),
        "CYCLE118" => log::cycle118(),
        "CYCLE119" => helpers::cycle119(),
        "CYCLE961" => cycle961::table(),
        "CYCLE971" => cycle971::table(),
        "CYCLE972" => turning_tool::cycle972(),
        "CYCLE973" => cycle973::table(),
        "CYCLE974" => cycle974::table(),
        "CYCLE976" => cycle976::table(),
        "CYCLE977" => cycle977::table(),
        "CYCLE978" => cycle978::table(),
        "CYCLE979" => cycle979::table(),
        "CYCLE982" => turning_tool::cycle982(),
        "CYCLE994" => cycle994::table(),
        "CYCLE997" => cycle997::table(),
        "CYCLE998" => cycle998::table(),
        "G101" => nct::g101(),
        "G102" => nct::g102(),
        "G103" => nct::g103(),
        "G104" => nct::g104(),
        "G105" => nct::g105(),
        "G106" => nct::g106(),
        "G107" => nct::g107(),
        "G108" => nct::g108(),
        "G109" => nct::g109(),
        "G110" => nct::g110(),
        "G65 P9920" => p9920::table(),
        "G65 P9969" => nct::p9969(),
        _ => panic!("{name} has no cases for its alarms"),
    }
}

/// Cycles of which more than form and text is known.
fn simulated() -> impl Iterator<Item = &'static Cycle> {
    let all = CYCLES.iter().copied();
    all.filter(|cycle| cycle.simulation.is_some())
}

/// Runs the program of a table with the change of a case.
fn outcome(cycle: &Cycle, table: &Table, change: &str, prepare: fn(&mut Setup)) -> Outcome {
    let mut setup = (table.setup)();
    prepare(&mut setup);
    let text = table.program.replace("{change}", change);
    let program = read(cycle.dialect, text.as_bytes());
    run(&program, &setup, Limits::default())
}

#[test]
fn without_a_change_nothing_is_raised() {
    // oracle: self: otherwise the cases below would prove nothing
    for cycle in simulated() {
        let table = table(cycle.name);
        let outcome = outcome(cycle, &table, table.usual, |_| ());
        assert_eq!(outcome.stop, None, "{}", cycle.name);
        assert_eq!(outcome.alarms(), [], "{}", cycle.name);
    }
}

#[test]
fn every_case_raises_its_alarm() {
    // oracle: manual A:15840-15948, C:125-132, C:1123-1145 (what the tables say about each number and message)
    for cycle in simulated() {
        let table = table(cycle.name);
        for Case { code, change, prepare } in &table.cases {
            let outcome = outcome(cycle, &table, change, *prepare);
            let context = format!("{} {code:?} {:?}", cycle.name, outcome.diagnostics);
            assert!(outcome.alarms().contains(code), "{context}");
            for raised in outcome.alarms() {
                assert!(cycle.alarms().contains(&raised), "{raised:?} {context}");
            }
            let stopped = outcome.stop == Some(Stop::Alarm(*code));
            assert_eq!(stopped, stops(*code), "{context}");
        }
    }
}

#[test]
fn the_number_of_the_alarm_is_a_result() {
    // oracle: manual B:5699, B:7355, B:7888, B:8302
    let named = |cycle: &&Cycle| cycle.results.iter().any(|field| field.name == "_OVI[9]");
    for cycle in simulated().filter(named) {
        let table = table(cycle.name);
        for case in &table.cases {
            let outcome = outcome(cycle, &table, case.change, case.prepare);
            if let Some(Stop::Alarm(Code::Alarm(number))) = outcome.stop {
                let left = outcome.control.number("_OVI[9]");
                assert_eq!(left, f64::from(number), "{} {}", cycle.name, case.change);
            }
        }
    }
}

#[test]
fn every_listed_alarm_is_reached_or_excused() {
    // oracle: self (the catalogue)
    for cycle in simulated() {
        let table = table(cycle.name);
        let reached: Vec<Code> = table.cases.iter().map(|case| case.code).collect();
        for code in cycle.alarms() {
            let excused = table.unreached.iter().any(|(number, reason)| {
                assert!(!reason.is_empty());
                Code::Alarm(*number) == code
            });
            assert!(
                reached.contains(&code) != excused,
                "{} {code:?}: neither reached nor excused, or both",
                cycle.name
            );
        }
        for code in reached {
            assert!(cycle.alarms().contains(&code), "{} {code:?}", cycle.name);
        }
    }
}
