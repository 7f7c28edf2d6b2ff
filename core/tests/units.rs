//! The same physical measurement gives the same physical result, whatever the basic system of the machine and the
//! units of the program are.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "running/turning.rs"]
mod turning;

use probewright_core::catalogue::{Cycle, Dialect, MachineSort, ProbeUse, Style, find};
use probewright_core::check::{Typed, check, factor, unit_name};
use probewright_core::control::{Control, Edge, Frame, Plane, Tool, Units};
use probewright_core::program;
use probewright_core::program::write::snippet;
use probewright_core::run::trace::Step;
use probewright_core::run::{Limits, Outcome, Setup, run};
use proptest::prelude::*;

const BASIC: [Units; 2] = [Units::Metric, Units::Inch];

/// Errors of the part, mm: position and size.
type Errors = ([f64; 3], f64);

/// Values of a call: numbers in mm, mm/min and degree, by parameter.
type Physical = Vec<(&'static str, f64)>;

/// A machine with something in every place that a measurement reads or corrects; all lengths the same in mm.
fn machine(dialect: Dialect, basic: Units) -> Setup {
    let mut setup = Setup::calibrated_in(dialect, Plane::G17, basic);
    let control = &mut setup.control;
    let mill = Edge {
        kind: 120,
        length: [80.0, 0.0, 0.0],
        radius: 10.0,
        ..Edge::default()
    };
    match dialect {
        Dialect::Sinumerik => {
            let tool = Tool {
                name: "MILL".into(),
                edges: [(1, mill)].into(),
            };
            control.tools.insert(20, tool);
            control.set("_EV[9]", 0.01 / control.basic_factor());
            control.set("_MV[9]", 0.02 / control.basic_factor());
            control.set("_CHBIT[4]", 1.0);
            control.set("_WP[0,7]", 0.25 / control.basic_factor());
        }
        Dialect::Nct => *control.register_mut(1) = mill,
    }
    let offset = Frame {
        coarse: [310.0, -45.0, 20.0],
        fine: [0.0; 3],
        rotation: [0.0, 0.0, 30.0],
        ..Frame::default()
    };
    control.frames.insert(1, offset);
    control.activate(1);
    setup
}

/// A turning machine with a tool to be corrected, a memory in use and the zero point in front of the chuck; all lengths
/// the same in mm.
fn turning_machine(basic: Units) -> Setup {
    let mut setup = Setup::turning_in(Plane::G18, basic);
    let control = &mut setup.control;
    control.tools.insert(20, turning::tool(0.8));
    control.set("_EV[9]", 0.01 / control.basic_factor());
    control.set("_MV[9]", 0.02 / control.basic_factor());
    control.set("_CHBIT[4]", 1.0);
    control.set("_WP[0,3]", 2.9 / control.basic_factor());
    control
        .frames
        .insert(1, Frame::translation([0.0, 0.0, 210.0]));
    control.activate(1);
    setup
}

/// A machine with the tool that a variant measures before the tool probe, a memory in use and a zero offset; all lengths
/// the same in mm.
fn tool_probe_machine(cycle: &Cycle, variant: i64, basic: Units) -> Setup {
    let plane = match cycle.purpose.machine {
        MachineSort::Turning => Plane::G18,
        _ => Plane::G17,
    };
    let mut setup = Setup::calibrated_in(cycle.dialect, plane, basic);
    setup.suit(cycle, variant);
    let control = &mut setup.control;
    control.set("_EV[9]", 0.01 / control.basic_factor());
    control
        .frames
        .insert(1, Frame::translation([30.0, 0.0, 60.0]));
    control.activate(1);
    setup
}

/// The machine on which a cycle measures.
fn machine_for(cycle: &Cycle, values: &Physical, basic: Units) -> Setup {
    match (cycle.purpose.probe, cycle.purpose.machine) {
        (ProbeUse::Tool, _) => {
            let variant = values.iter().find(|(name, _)| *name == "_MVAR");
            tool_probe_machine(cycle, variant.unwrap().1 as i64, basic)
        }
        (_, MachineSort::Turning) => turning_machine(basic),
        _ => machine(cycle.dialect, basic),
    }
}

/// Physical values as a form takes them on this control.
fn typed(cycle: &Cycle, values: &Physical, control: &Control) -> Typed {
    let as_typed = |(name, value): &(&'static str, f64)| {
        let param = cycle.params.iter().find(|param| param.name == *name);
        let per = factor(param.expect(name).unit, control);
        ((*name).to_owned(), format!("{}", value / per))
    };
    values.iter().map(as_typed).collect()
}

/// The call, written by the form and run as a program that begins with a G function of units.
fn measure(
    cycle: &'static Cycle,
    values: &Physical,
    basic: Units,
    code: u16,
    errors: Errors,
) -> Outcome {
    let mut setup = machine_for(cycle, values, basic);
    let mut at_call = setup.control.clone();
    assert!(at_call.choose_units(code));
    let typed = typed(cycle, values, &at_call);
    let checked = check(cycle, &typed, &at_call);
    let inputs = checked
        .inputs
        .unwrap_or_else(|| panic!("{:?}", checked.diagnostics));
    let proposal = (cycle.work().unwrap().propose)(&inputs, &setup.control);
    setup.workpiece = proposal.workpiece;
    for solid in &mut setup.workpiece.solids {
        (solid.errors.shift, solid.errors.size) = errors;
    }
    setup.workpiece.solids.extend(proposal.fixture);
    setup.tool_probes = proposal.tool_probes;
    for probe in &mut setup.tool_probes {
        probe.solid.errors.shift = errors.0;
    }
    if let Some(tool) = proposal.real_tool {
        let in_use = (setup.control.tool, setup.control.edge);
        setup.real_tools.insert(in_use, tool);
    }
    setup.position = setup.control.to_machine(proposal.start);
    let text = format!(
        "G{code}\n{}M30\n",
        snippet(cycle, &typed, &at_call, Style::Direct, None).text
    );
    let outcome = run(
        &program::read(cycle.dialect, text.as_bytes()),
        &setup,
        Limits::default(),
    );
    assert_eq!(outcome.stop, None, "{text}{:?}", outcome.diagnostics);
    outcome
}

/// Everything that can be compared, in mm, mm/min and degree.
fn physical(cycle: &'static Cycle, outcome: &Outcome) -> Vec<(String, f64)> {
    let mut list = Vec::new();
    for (field, value) in outcome.results(cycle) {
        list.push((
            field.name.to_owned(),
            value * factor(field.unit, &outcome.control),
        ));
    }
    for change in outcome.changes() {
        list.push((change.name, change.after - change.before));
    }
    for entry in &outcome.trace.entries {
        if let Step::Motion { to, feed, .. } = &entry.step {
            list.extend(
                to.iter()
                    .chain([feed])
                    .map(|value| ("motion".to_owned(), *value)),
            );
        }
    }
    list
}

fn same(cycle: &'static Cycle, a: &Outcome, b: &Outcome, what: &str) {
    let (a, b) = (physical(cycle, a), physical(cycle, b));
    assert!(a.iter().any(|(_, value)| *value != 0.0));
    assert_eq!(a.len(), b.len(), "{what}: {a:?} {b:?}");
    for ((name, one), (other_name, other)) in a.iter().zip(&b) {
        assert_eq!(name, other_name, "{what}");
        assert!(
            (one - other).abs() < 1e-8,
            "{what} {name}: {one} is not {other}"
        );
    }
}

/// Values for any variant of the workpiece cycles; a form leaves out what a variant does not use.
fn workpiece(variant: i64, axis: i64) -> Physical {
    let zone = if variant % 2 == 1 {
        [20.0, 25.0]
    } else {
        [110.0, 120.0]
    };
    let knum = if variant % 1000 >= 100 { 1.0 } else { 2001.0 };
    vec![
        ("_MVAR", variant as f64),
        ("_SETVAL", 60.0),
        ("_SETV[0]", 60.0),
        ("_SETV[1]", 70.0),
        ("_ID", -25.0),
        ("_SZA", zone[0]),
        ("_SZO", zone[1]),
        ("_MA", axis as f64),
        ("_KNUM", knum),
        ("_TNUM", 20.0),
        ("_EVNUM", 10.0),
        ("_TSA", 1.5),
        ("_TUL", 0.5),
        ("_TLL", -0.4),
        ("_TDIF", 1.4),
        ("_TMV", 0.2),
        ("_TZL", 0.005),
        ("_K", 3.0),
        ("_VMS", 240.0),
        ("_FA", 3.0),
    ]
}

/// Values for any variant of the cycles of turning machines.
fn turned(variant: i64, axis: i64) -> Physical {
    let values = workpiece(variant, axis);
    let mut values: Physical = values
        .into_iter()
        .filter(|(name, _)| *name != "_KNUM")
        .collect();
    values.extend([
        ("_KNUM", 1.0),
        ("_STA1", 30.0),
        ("_CALNUM", 1.0),
        ("_MD", 1.0),
    ]);
    values
}

/// Values for any variant of the cycles at a tool probe. The radius of a cutter lies across its axis (B:9279).
fn before_a_tool_probe(variant: i64, axis: i64) -> Physical {
    let digit = |place: u32| variant / 10_i64.pow(place - 1) % 10;
    let axis = match (digit(4), digit(5)) {
        (1 | 2, 0) => 2,
        (1 | 2, _) => 1,
        _ => axis,
    };
    vec![
        ("_MVAR", variant as f64),
        ("_MA", axis as f64),
        ("_MD", 1.0),
        ("_ID", 0.0),
        ("_STA1", 20.0),
        ("_CORA", 2.0),
        ("_PRNUM", 1.0),
        ("_EVNUM", 10.0),
        ("_TSA", 1.5),
        ("_TDIF", 1.4),
        ("_TZL", 0.005),
        ("_FA", 3.0),
    ]
}

fn used(cycle: &Cycle, values: Physical) -> Physical {
    let has = |name: &str| cycle.params.iter().any(|param| param.name == name);
    values.into_iter().filter(|(name, _)| has(name)).collect()
}

fn all_units_agree(cycle: &'static Cycle, values: &Physical, codes: &[u16], errors: Errors) {
    let metric = measure(cycle, values, Units::Metric, codes[0], errors);
    for basic in BASIC {
        for code in codes {
            let other = measure(cycle, values, basic, *code, errors);
            same(
                cycle,
                &metric,
                &other,
                &format!("{} {values:?} {basic:?} G{code}", cycle.name),
            );
        }
    }
}

fn errors() -> impl Strategy<Value = Errors> {
    let place = prop::array::uniform3(-0.3..0.3);
    (place, -0.35..0.35)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    // oracle: self (the four units of the program on both machines against a metric program on a metric machine)
    #[test]
    fn cycle977_in_all_units(index in 0_usize..24, axis in 1_i64..=2, errors in errors()) {
        let cycle = find(Dialect::Sinumerik, "CYCLE977").unwrap();
        let variant = cycle.variants[index % cycle.variants.len()].number;
        let mut values = used(cycle, workpiece(variant, axis));
        if variant % 10 >= 5 {
            values.retain(|(name, _)| *name != "_SETVAL");
        }
        all_units_agree(cycle, &values, &[71, 70, 700, 710], errors);
    }

    // oracle: self, as above
    #[test]
    fn cycle978_in_all_units(index in 0_usize..4, axis in 1_i64..=2, errors in errors()) {
        let cycle = find(Dialect::Sinumerik, "CYCLE978").unwrap();
        let variant = cycle.variants[index].number;
        all_units_agree(cycle, &used(cycle, workpiece(variant, axis)), &[71, 70, 700, 710], errors);
    }

    // oracle: self, as above, on a turning machine with X as diameter
    #[test]
    fn turning_in_all_units(name in prop::sample::select(vec!["CYCLE973", "CYCLE974", "CYCLE994"]), index in 0_usize..12, axis in 1_i64..=2, errors in errors()) {
        let cycle = find(Dialect::Sinumerik, name).unwrap();
        let variant = cycle.variants[index % cycle.variants.len()].number;
        // the walls of the groove of position 7 lie in the ordinate, of its base there is one direction
        let axis = if variant % 100 == 13 { 2 } else { axis };
        all_units_agree(cycle, &used(cycle, turned(variant, axis)), &[71, 70, 700, 710], errors);
    }

    // oracle: self, as above, with tools before a tool probe
    #[test]
    fn tool_probes_in_all_units(name in prop::sample::select(vec!["CYCLE971", "CYCLE972", "CYCLE982"]), index in 0_usize..68, axis in 1_i64..=2, errors in errors()) {
        let cycle = find(Dialect::Sinumerik, name).unwrap();
        let variant = cycle.variants[index % cycle.variants.len()].number;
        all_units_agree(cycle, &used(cycle, before_a_tool_probe(variant, axis)), &[71, 70, 700, 710], errors);
    }

    // oracle: self, as above, with the two units of the other control
    #[test]
    fn g110_in_all_units(boss in any::<bool>(), errors in errors()) {
        let cycle = find(Dialect::Nct, "G110").unwrap();
        let mut values = vec![("D", 50.0), ("R", 6.0), ("Q", 8.0), ("S", 2.0), ("M", 3.0), ("H", 0.1), ("U", 0.2)];
        if boss {
            values.push(("Z", -12.0));
        }
        all_units_agree(cycle, &values, &[21, 20], errors);
    }
}

// oracle: manual B:2164-2170: 150 mm/min or 5.9055 inch/min with _FA = 1, 300 mm/min or 11.811 inch/min above;
// _FA is mm on both machines (B:2241-2245)
#[test]
fn measuring_feed_and_path_as_delivered() {
    let cycle = find(Dialect::Sinumerik, "CYCLE978").unwrap();
    for (path, inch_feed) in [(1.0, 5.9055), (2.0, 11.811)] {
        let values: Physical = vec![
            ("_MVAR", 100.0),
            ("_SETVAL", 0.0),
            ("_MA", 1.0),
            ("_KNUM", 0.0),
            ("_FA", path),
        ];
        for basic in BASIC {
            let outcome = measure(cycle, &values, basic, 71, ([0.0; 3], 0.0));
            let measured = outcome
                .trace
                .entries
                .iter()
                .find_map(|entry| match &entry.step {
                    Step::Motion {
                        from,
                        to,
                        feed,
                        kind,
                        ..
                    } if format!("{kind:?}") == "Measuring" => Some((*from, *to, *feed)),
                    _ => None,
                });
            let (from, to, feed) = measured.unwrap();
            assert!((feed / 25.4 - inch_feed).abs() < 1e-3, "{feed}");
            let way = from
                .iter()
                .zip(to)
                .map(|(a, b)| (a - b).powi(2))
                .sum::<f64>()
                .sqrt();
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
        let param = cycle
            .params
            .iter()
            .find(|param| param.name == name)
            .unwrap();
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
    let outcome = run(
        &program::read(Dialect::Sinumerik, text.as_bytes()),
        &setup,
        Limits::default(),
    );
    assert_eq!(
        (&outcome.stop, &outcome.diagnostics[..]),
        (&None, &[][..]),
        "{text}"
    );
    outcome
}

// oracle: hand: G70 and G71 change the lengths of the program, G700 and G710 also feeds, tool and frame data
#[test]
fn feeds_and_system_data_follow_g700_only() {
    for (basic, code, data) in [
        (Units::Metric, 70, 1.0),
        (Units::Metric, 700, 25.4),
        (Units::Inch, 71, 25.4),
        (Units::Inch, 710, 1.0),
    ] {
        let text = format!(
            "G500\nG{code}\nR1=$TC_DP6[20,1]\n$TC_DP15[20,1]=0.5\nR2=$TC_DP15[20,1]\n$P_UIFR[2,X,TR]=1\n\
             G1 G91 X1 F10\nR3=$AA_IW[X]\nR4=$P_GG[13]\nM30\n"
        );
        let outcome = go(&text, basic);
        let near = |name: &str, expected: f64| {
            let found = outcome.control.number(name);
            assert!(
                (found - expected).abs() < 1e-9,
                "G{code} {name}: {found} is not {expected}"
            );
        };
        near("R1", 10.0 / data);
        near("R2", 0.5);
        near(
            "R3",
            if matches!(code, 70 | 700) { 25.4 } else { 1.0 } / data,
        );
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
        let feed = outcome
            .trace
            .entries
            .iter()
            .find_map(|entry| match &entry.step {
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
