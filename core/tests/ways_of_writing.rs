//! Three ways of writing a call: what is written is read back, and a change changes one value.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::catalogue::example::example;
use probewright_core::catalogue::{Arg, CYCLES, Cycle, Dialect, Kind, MachineSort, Style, find};
use probewright_core::check::{Typed, check};
use probewright_core::control::{Control, Plane, Units, delivery, delivery_in};
use probewright_core::message;
use probewright_core::program::calls::{CallSite, calls, calls_on};
use probewright_core::program::change::{apply, change};
use probewright_core::program::convert::convert;
use probewright_core::program::read;
use probewright_core::program::write::{Written, snippet};
use probewright_core::run::setup::Setup;
use probewright_core::run::{self, Limits};
use probewright_core::support;
use proptest::prelude::*;
use std::collections::BTreeSet;

fn typed(pairs: &[(&str, &str)]) -> Typed {
    let owned = |(name, value): &(&str, &str)| ((*name).to_owned(), (*value).to_owned());
    pairs.iter().map(owned).collect()
}

fn cycle(name: &str) -> &'static Cycle {
    find(Dialect::Sinumerik, name).unwrap()
}

fn first_example(name: &str) -> Typed {
    typed(cycle(name).example)
}

fn written(name: &str, values: &Typed, style: Style) -> Written {
    snippet(
        cycle(name),
        values,
        &delivery(Dialect::Sinumerik),
        style,
        None,
    )
}

fn sites(text: &str) -> Vec<CallSite> {
    calls(&read(Dialect::Sinumerik, text.as_bytes()))
}

// oracle: manual B:11734-11753, B:11987-11996
#[test]
fn a_surface_as_a_parameterizing_call() {
    let mut values = first_example("CYCLE978");
    values.insert("_VMS".into(), "0".into());
    let text = written("CYCLE978", &values, Style::Indirect).text;
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "_VMS=0", "a 0 cannot pass through CYCLE_PARA");
    assert_eq!(
        lines[1],
        "CYCLE_PARA(2,,1,,1,,0.01,0.02,0.03,-0.03,1,20,3,0.06)"
    );
    assert_eq!(lines[2], "CYCLE_978(0,100,1,20,,2001)");
}

// oracle: peer (argument order of newer controls)
#[test]
fn a_hole_in_the_list_of_newer_controls() {
    let values = typed(&[
        ("_MVAR", "1"),
        ("_KNUM", "2001"),
        ("_PRNUM", "1"),
        ("_SETVAL", "132"),
        ("_FA", "2"),
        ("_TSA", "1"),
        ("_NMSP", "1"),
        ("_TNAME", "DRILL"),
        ("_TDIF", "0.06"),
        ("_TUL", "0.03"),
        ("_TLL", "-0.03"),
        ("_TMV", "0.02"),
        ("_K", "3"),
        ("_TZL", "0.01"),
    ]);
    let written = written("CYCLE977", &values, Style::Operate);
    assert_eq!(
        written.text,
        "CYCLE977(1,2001,,1,132,,,2,1,,,,,,1,\"DRILL\",,,0.06,0.03,-0.03,0.02,3)\n"
    );
    let lost: Vec<&str> = written
        .findings
        .iter()
        .map(|found| &*found.message.key)
        .collect();
    assert_eq!(lost, ["write-lost"], "_TZL has no place there");
}

// oracle: manual B:11734
#[test]
fn nothing_goes_through_cycle_para_as_zero() {
    let text = "_TZL=0.5\nCYCLE_PARA(3,,,,,,0)\nCYCLE_978(0,100,1)\n";
    let site = &sites(text)[0];
    assert_eq!(site.values["_TZL"], "0.5");
    assert_eq!(site.values["_FA"], "3");
    assert_eq!(
        site.values["_KNUM"], "0",
        "an omitted argument is 0 for the called program"
    );
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let changed = |name, value| {
        String::from_utf8(apply(text.as_bytes(), &change(&program, site, name, value))).unwrap()
    };
    assert_eq!(changed("_FA", "4"), text.replace("PARA(3", "PARA(4"));
    assert_eq!(
        changed("_FA", "0"),
        "_TZL=0.5 _FA=0\nCYCLE_PARA(,,,,,,0)\nCYCLE_978(0,100,1)\n"
    );
    assert_eq!(changed("_KNUM", "2001"), text.replace("1)", "1,,,2001)"));
    assert_eq!(changed("_SETVAL", "-7.5"), text.replace("100,", "-7.5,"));
}

/// Number of the variant that these values choose.
fn variant_of(values: &Typed) -> i64 {
    let number = values.get("_MVAR").and_then(|text| text.parse().ok());
    number.unwrap_or(0)
}

/// The machine with the proposed part of a call before its probe.
fn before_the_part(cycle: &'static Cycle, values: &Typed) -> Setup {
    let plane = match cycle.purpose.machine {
        MachineSort::Turning => Plane::G18,
        _ => Plane::G17,
    };
    let mut setup = Setup::for_variant(cycle, variant_of(values), plane);
    let inputs = check(cycle, values, &setup.control).inputs.unwrap();
    let proposal = (cycle.work().unwrap().propose)(&inputs, &setup.control);
    setup.workpiece = proposal.workpiece;
    setup.workpiece.solids.extend(proposal.fixture);
    setup.tool_probes = proposal.tool_probes;
    let in_use = (setup.control.tool, setup.control.edge);
    let lies = proposal.real_tool.map(|tool| (in_use, tool));
    setup.real_tools.extend(lies);
    for solid in &mut setup.workpiece.solids {
        solid.errors.size = 0.02;
    }
    setup.position = setup.control.to_machine(proposal.start);
    for tool in proposal.tools {
        let of = setup.control.tools.entry(tool.tool).or_default();
        of.name = tool.name;
        of.edges.entry(tool.edge).or_insert(tool.data);
    }
    setup
}

/// The values that a way of writing can say, and the text; none where it has no list for this variant, or cannot say
/// what is needed.
fn whole(cycle: &'static Cycle, values: &Typed, style: Style) -> Option<(Typed, Written)> {
    let mut values = values.clone();
    loop {
        let written = written(cycle.name, &values, style);
        if written.text.is_empty() {
            return None;
        }
        let lost = written
            .findings
            .iter()
            .filter(|one| one.message.key == "write-lost");
        let names: Vec<_> = lost.map(|one| one.message.args[0].1.clone()).collect();
        if names.is_empty() {
            let control = Setup::for_variant(cycle, variant_of(&values), Plane::G17).control;
            let complete = check(cycle, &values, &control).inputs.is_some();
            return complete.then_some((values, written));
        }
        for name in names {
            let message::Arg::Text(name) = name else {
                panic!("{name:?}");
            };
            values.remove(&name).unwrap();
        }
    }
}

/// Results, tools and frames behind a call that is written so.
fn done(cycle: &'static Cycle, setup: &Setup, text: &str) -> (Vec<f64>, Control) {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let outcome = run::run(&program, setup, Limits::default());
    assert_eq!(outcome.stop, None, "{text}\n{:?}", outcome.diagnostics);
    let results = cycle.results.iter();
    let numbers = results.map(|field| outcome.control.number(field.name));
    (numbers.collect(), outcome.control)
}

// oracle: self (the same call, whichever way it is written)
#[test]
fn every_way_of_writing_does_the_same() {
    let mut compared = BTreeSet::new();
    for cycle in CYCLES.iter().filter(|cycle| cycle.work().is_some()) {
        for variant in cycle.variants {
            let values = example(cycle, variant);
            for style in [Style::Indirect, Style::Operate] {
                if !cycle.lists.iter().any(|list| list.style == style) {
                    continue;
                }
                let Some((values, other)) = whole(cycle, &values, style) else {
                    continue;
                };
                let setup = before_the_part(cycle, &values);
                let direct = written(cycle.name, &values, Style::Direct);
                let (numbers, control) = done(cycle, &setup, &direct.text);
                let (others, other_control) = done(cycle, &setup, &other.text);
                assert_eq!(numbers, others, "{}", other.text);
                assert_eq!(control.tools, other_control.tools, "{}", other.text);
                assert_eq!(control.frames, other_control.frames, "{}", other.text);
                compared.insert((cycle.name, style == Style::Operate));
            }
        }
    }
    let ways = CYCLES.iter().filter(|cycle| cycle.work().is_some());
    let ways = ways.flat_map(|cycle| cycle.lists.iter().map(|list| (cycle.name, list.style)));
    let ways = ways.filter(|(_, style)| *style != Style::Direct);
    let ways: BTreeSet<_> = ways
        .map(|(name, style)| (name, style == Style::Operate))
        .collect();
    assert_eq!(
        compared, ways,
        "each way of each cycle says something in full"
    );
}

fn converted(text: &str, index: usize, style: Style) -> (String, Vec<String>) {
    converted_on(&delivery(Dialect::Sinumerik), text, index, style)
}

/// The program with one call written in another way on this machine, and the keys of what is said.
fn converted_on(
    control: &Control,
    text: &str,
    index: usize,
    style: Style,
) -> (String, Vec<String>) {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let done = convert(&program, index, style, control);
    let after = apply(text.as_bytes(), &done.edits);
    let keys = done
        .findings
        .iter()
        .map(|found| found.message.key.to_string());
    (String::from_utf8(after).unwrap(), keys.collect())
}

// oracle: hand
#[test]
fn a_call_is_converted_in_place() {
    let text = "N10 G17 ; start\r\nN20 _MVAR=0 _SETVAL=100 _MA=1\r\n_KNUM=0 _FA=3 G0 X5 ; go\r\nN40 CYCLE978 ; measure\r\nN50 M30\r\n";
    let (indirect, findings) = converted(text, 0, Style::Indirect);
    assert_eq!(
        indirect,
        "N10 G17 ; start\r\nG0 X5 ; go\r\nCYCLE_PARA(3)\r\nN40 CYCLE_978(0,100,1,,,0) ; measure\r\nN50 M30\r\n"
    );
    assert!(findings.is_empty());
    let (again, _) = converted(&indirect, 0, Style::Direct);
    let found = sites(&again);
    assert_eq!(found[0].list.map(|list| list.name), None);
    assert_eq!(found[0].values["_FA"], "3");
    assert_eq!(found[0].values["_SETVAL"], "100");
    let same = converted(text, 0, Style::Direct);
    assert_eq!(same, (text.to_owned(), vec!["convert-same".to_owned()]));
}

// oracle: hand
#[test]
fn a_call_that_relies_on_the_converted_one_is_told() {
    let text = "_MVAR=0 _SETVAL=100 _MA=1 _KNUM=0\nCYCLE978\n_SETVAL=50\nCYCLE978\n";
    assert_eq!(converted(text, 0, Style::Indirect).1, Vec::<String>::new());
    assert_eq!(converted(text, 0, Style::Operate).1, ["convert-others"]);
}

// oracle: self (what the form of that machine writes), manual B:12501-12539, B:13594-13596 (the data are converted)
#[test]
fn a_call_is_converted_as_the_forms_of_the_machine_write_it() {
    let text =
        "N10 G54\n; side\n_MVAR=0 _SETVAL=5 _MA=1 _KNUM=1 _TNUM=20 _VMS=200\nCYCLE978\nM30\n";
    for units in [Units::Metric, Units::Inch] {
        for mean in [0.0, 1.0] {
            let mut control = delivery_in(Dialect::Sinumerik, units);
            control.set(support::FORMS, 1.0);
            control.set(support::name(support::MEAN), mean);
            let site = &calls_on(&read(Dialect::Sinumerik, text.as_bytes()), control.clone())[0];
            let own = |style| {
                let code = snippet(site.cycle, &site.values, &control, style, None).text;
                format!("N10 G54\n; side\n{code}M30\n")
            };
            let on = |text: &str, style| converted_on(&control, text, 0, style).0;
            let indirect = on(text, Style::Indirect);
            assert_eq!(indirect, own(Style::Indirect));
            let direct = on(&indirect, Style::Direct);
            assert_eq!(direct, own(Style::Direct), "one comment with the settings");
            assert_eq!(on(&direct, Style::Indirect), indirect);
        }
    }
}

// oracle: hand (the comment belongs to the support, which has no lists of newer controls)
#[test]
fn the_settings_of_forms_stay_where_nothing_takes_their_place() {
    let mut control = delivery(Dialect::Sinumerik);
    control.set(support::FORMS, 1.0);
    let code = snippet(
        cycle("CYCLE977"),
        &first_example("CYCLE977"),
        &control,
        Style::Direct,
        None,
    )
    .text;
    let mark = code.lines().next().unwrap();
    let (operate, _) = converted_on(&control, &code, 0, Style::Operate);
    assert_eq!(operate.lines().next(), Some(mark));
    assert_eq!(operate.matches("_MZ_MASK").count(), 1, "{operate}");
}

/// Random numbers for the parameters of a call: whether one is given, its value.
type Numbers = Vec<(bool, i32)>;

fn numbers() -> impl Strategy<Value = Numbers> {
    proptest::collection::vec((any::<bool>(), -99_999..99_999_i32), 40)
}

/// Values of a call of this variant, whole numbers where they are codes.
fn values(cycle: &Cycle, variant: i64, numbers: &Numbers) -> Typed {
    let mut typed = Typed::new();
    for (param, (given, number)) in cycle.params.iter().zip(numbers) {
        let text = match param.kind {
            Kind::Variant(_) => variant.to_string(),
            Kind::Real if *given => (f64::from(*number) / 1000.0).to_string(),
            Kind::Text(_) if *given => format!("T{}", number.unsigned_abs() % 100),
            Kind::Knum if *given => (number.abs() % 9999).to_string(),
            _ if *given => (number / 1000).to_string(),
            _ => continue,
        };
        typed.insert(param.name.into(), text);
    }
    typed
}

/// Whether this way of writing says the parameter.
fn says(cycle: &Cycle, site: &CallSite, style: Style, name: &str) -> bool {
    let named = |arg: &Arg| matches!(arg, Arg::Param(param) if *param == name);
    style != Style::Operate
        || cycle.variant_param() == Some(name)
        || site.list.is_some_and(|list| list.args.iter().any(named))
}

// oracle: self (writing and reading are inverse)
proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn every_variant_is_read_back_in_every_way_of_writing(numbers in numbers(), other in 1..9000_u32) {
        let variants = CYCLES.iter().flat_map(|cycle| cycle.variants.iter().map(move |variant| (*cycle, variant.number)));
        let calls_of = variants.flat_map(|call| [Style::Direct, Style::Indirect, Style::Operate].map(|style| (call, style)));
        for ((cycle, variant), style) in calls_of {
            let typed = values(cycle, variant, &numbers);
            let text = snippet(cycle, &typed, &delivery(cycle.dialect), style, None).text;
            if text.is_empty() {
                prop_assert!(style != Style::Direct, "{}", cycle.name);
                continue;
            }
            let program = read(cycle.dialect, text.as_bytes());
            prop_assert!(program.errors.is_empty(), "{}", text);
            let found = calls(&program);
            prop_assert_eq!(found.len(), 1, "{}", &text);
            let site = &found[0];
            prop_assert_eq!(site.cycle.name, cycle.name);
            let inputs = probewright_core::check::read(cycle, &typed, &delivery(cycle.dialect), &mut Vec::new());
            for param in cycle.params.iter().filter(|param| param.need(&inputs).is_some()) {
                let Some(value) = typed.get(param.name).filter(|_| says(cycle, site, style, param.name)) else {
                    continue;
                };
                let read = site.values.get(param.name).map(String::as_str);
                prop_assert_eq!(read, Some(value.as_str()), "{} in {}", param.name, &text);
            }
            for other in [Style::Direct, Style::Indirect].into_iter().filter(|other| *other != style) {
                if cycle.dialect == Dialect::Nct || style == Style::Operate {
                    continue;
                }
                let (after, _) = converted(&text, 0, other);
                let again = sites(&after);
                prop_assert_eq!(again.len(), 1, "{}", &after);
                for param in cycle.params.iter().filter(|param| param.need(&inputs).is_some()) {
                    if let Some(before) = site.values.get(param.name).filter(|value| !value.is_empty()) {
                        let after_value = again[0].values.get(param.name);
                        prop_assert_eq!(after_value, Some(before), "{} of\n{}\n{}", param.name, &text, &after);
                    }
                }
            }
            for param in cycle.params.iter().filter(|param| matches!(param.kind, Kind::Real)) {
                if !says(cycle, site, style, param.name) {
                    continue;
                }
                let edits = change(&program, site, param.name, &other.to_string());
                let after = read(cycle.dialect, &apply(text.as_bytes(), &edits));
                let again = calls(&after);
                prop_assert_eq!(again.len(), 1);
                prop_assert_eq!(&again[0].values[param.name], &other.to_string(), "{} in {}", param.name, &text);
                for (name, read) in site.values.iter().filter(|(name, _)| *name != param.name) {
                    prop_assert_eq!(&again[0].values[name], read, "{} in {}", name, &text);
                }
            }
        }
    }
}

// oracle: manual B:11870-11879, B:13515-13520 (feed and speed of the call stand in data of the machine)
#[test]
fn data_of_the_machine_that_a_call_sets_are_kept() {
    let direct = "_MVAR=2 _MA=3 _ID=1 _PRNUM=1\n_MFS[0]=800 _MFS[1]=20\nCYCLE971\n";
    let turned = |text: &str, style| {
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let edits = convert(&program, 0, style, &delivery(Dialect::Sinumerik)).edits;
        String::from_utf8(apply(text.as_bytes(), &edits)).unwrap()
    };
    let indirect = turned(direct, Style::Indirect);
    assert!(indirect.contains("CYCLE_971(2,3,1,1,800,20)"), "{indirect}");
    let back = turned(&indirect, Style::Direct);
    let site = &sites(&back)[0];
    assert_eq!(site.values["_MFS[0]"], "800", "{back}");
    assert_eq!(site.values["_MFS[1]"], "20", "{back}");
}

// oracle: hand: a jump to the label comes past what stands behind it
#[test]
fn what_belongs_to_a_call_stays_behind_its_label() {
    let text = "GOTOF A\nA: _MVAR=0 _SETVAL=100 _MA=1 _KNUM=0 _FA=3 CYCLE978 ; side\nM30\n";
    let (indirect, _) = converted(text, 0, Style::Indirect);
    assert_eq!(
        indirect,
        "GOTOF A\nA: CYCLE_PARA(3)\nCYCLE_978(0,100,1,,,0) ; side\nM30\n"
    );
    assert_eq!(sites(&indirect)[0].values["_FA"], "3");
}

// oracle: manual B:11640-12133 (the selections are numbers in the call)
#[test]
fn selections_are_written_for_a_variant_that_is_known() {
    let text = "_MVAR=R5 _MA=1 _FA=3 _PRNUM=1\nCYCLE976\n";
    let (same, findings) = converted(text, 0, Style::Indirect);
    assert_eq!(same, text);
    assert_eq!(findings, ["write-variant-open"]);
}

// oracle: manual B:11734 (an argument that is left out is 0)
#[test]
fn a_call_may_leave_out_all_its_arguments() {
    for text in ["CYCLE_978()\n", "CYCLE_978\n"] {
        let found = sites(text);
        assert_eq!(found.len(), 1, "{text}");
        assert_eq!(found[0].list.map(|list| list.name), Some("CYCLE_978"));
        assert_eq!(found[0].values["_SETVAL"], "0");
    }
    assert!(
        sites("CYCLE978()\n")[0].list.is_none(),
        "the bare name takes the data"
    );
}
