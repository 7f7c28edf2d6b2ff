//! What counts in which unit: fields, feeds, data of the system.

use super::call::measure;
use super::machines::machine;
use super::{BASIC, Physical};
use probewright_core::catalogue::find;
use probewright_core::control::Units;
use probewright_core::dialect::Dialect;
use probewright_core::entry::unit_name;
use probewright_core::machine::trace::Step;
use probewright_core::run::{Limits, Outcome, run};
use probewright_core::syntax;

// oracle: manual B:2164-2170: 150 mm/min or 5.9055 inch/min with _FA = 1, 300 mm/min or 11.811 inch/min above;
// _FA is mm on both machines (B:2241-2245)
#[test]
fn measuring_feed_and_path_as_delivered() {
    let cycle = find(Dialect::Sinumerik, "CYCLE978").unwrap();
    for (path, inch_feed) in [(1.0, 5.9055), (2.0, 11.811)] {
        let values: Physical = vec![("_MVAR", 100.0), ("_SETVAL", 0.0), ("_MA", 1.0), ("_KNUM", 0.0), ("_FA", path)];
        for basic in BASIC {
            let outcome = measure(cycle, &values, basic, 71, ([0.0; 3], 0.0));
            let measured = outcome.trace.entries.iter().find_map(|entry| match &entry.step {
                Step::Motion { from, to, feed, kind, .. } if format!("{kind:?}") == "Measuring" => {
                    Some((*from, *to, *feed))
                }
                _ => None,
            });
            let (from, to, feed) = measured.unwrap();
            assert!((feed / 25.4 - inch_feed).abs() < 1e-3, "{feed}");
            let way = from.iter().zip(to.0).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
            assert!((way - path).abs() < 1e-9, "{way}");
        }
    }
}

// oracle: manual B:1787-1795
#[test]
fn fields_name_the_unit_in_which_they_count() {
    let cycle = find(Dialect::Sinumerik, "CYCLE977").unwrap();
    let unit = |name: &str, basic: Units, code: u16| {
        let mut control = machine(Dialect::Sinumerik, basic).control;
        assert!(control.choose_units(code));
        let param = cycle.params.iter().find(|param| param.name == name).unwrap();
        unit_name(param.unit, &control)
    };
    for code in [70, 700] {
        assert_eq!(unit("_SETVAL", Units::Metric, code), "inch");
        assert_eq!(unit("_TSA", Units::Metric, code), "mm");
        assert_eq!(unit("_VMS", Units::Metric, code), "mm/min");
        assert_eq!(unit("_FA", Units::Inch, code), "mm");
    }
    for code in [71, 710] {
        assert_eq!(unit("_SETVAL", Units::Inch, code), "mm");
        assert_eq!(unit("_TSA", Units::Inch, code), "inch");
        assert_eq!(unit("_VMS", Units::Inch, code), "inch/min");
    }
}

fn go(text: &str, basic: Units) -> Outcome {
    let setup = machine(Dialect::Sinumerik, basic);
    let outcome = run(&syntax::read(Dialect::Sinumerik, text.as_bytes()), &setup, Limits::default());
    assert_eq!((&outcome.stop, &outcome.diagnostics[..]), (&None, &[][..]), "{text}");
    outcome
}

// oracle: hand: G70 and G71 change the lengths of the program, G700 and G710 also feeds, tool and frame data
#[test]
fn feeds_and_system_data_follow_g700_only() {
    for (basic, code, data) in
        [(Units::Metric, 70, 1.0), (Units::Metric, 700, 25.4), (Units::Inch, 71, 25.4), (Units::Inch, 710, 1.0)]
    {
        let text = format!(
            "G500 G0 X0\nG{code}\nR1=$TC_DP6[20,1]\n$TC_DP15[20,1]=0.5\nR2=$TC_DP15[20,1]\n$P_UIFR[2,X,TR]=1\n\
             G1 G91 X1 F10\nR3=$AA_IW[X]\nR4=$P_GG[13]\nM30\n"
        );
        let outcome = go(&text, basic);
        let near = |name: &str, expected: f64| {
            let found = outcome.control.number(name);
            assert!((found - expected).abs() < 1e-9, "G{code} {name}: {found} is not {expected}");
        };
        near("R1", 10.0 / data);
        near("R2", 0.5);
        near("R3", if matches!(code, 70 | 700) { 25.4 } else { 1.0 } / data);
        near(
            "R4",
            match code {
                70 => 1.0,
                71 => 2.0,
                700 => 3.0,
                _ => 4.0,
            },
        );
        assert!((outcome.control.variable("$TC_DP15[20,1]").unwrap() - 0.5 * data).abs() < 1e-12);
        assert!((outcome.control.variable("$P_UIFR[2,X,TR]").unwrap() - data).abs() < 1e-12);
        let feed = outcome.trace.entries.iter().rev().find_map(|entry| match &entry.step {
            Step::Motion { feed, .. } => Some(*feed),
            _ => None,
        });
        assert_eq!(feed, Some(10.0 * data));
        let recorded = outcome.trace.entries.iter().any(|entry| {
            matches!(&entry.step, Step::Set { name, after, .. } if name == "$TC_DP15[20,1]" && *after == 0.5 * data)
        });
        assert!(recorded, "corrections are recorded in mm");
    }
}
