//! A call is turned into another call style, in its place.

use super::{cycle, first_example, sites};
use probewright_core::control::{Control, Units, delivery, delivery_in};
use probewright_core::dialect::Dialect;
use probewright_core::entry::Style;
use probewright_core::program::calls::calls_on;
use probewright_core::program::change::apply;
use probewright_core::program::convert::convert;
use probewright_core::program::write::snippet;
use probewright_core::support;
use probewright_core::syntax::read;

/// The program with one call written in another style on a control with default data, and the keys of what is said.
pub fn converted(text: &str, index: usize, style: Style) -> (String, Vec<String>) {
    converted_on(&delivery(Dialect::Sinumerik), text, index, style)
}

/// The program with one call written in another style on this machine, and the keys of what is said.
fn converted_on(control: &Control, text: &str, index: usize, style: Style) -> (String, Vec<String>) {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let done = convert(&program, index, style, control);
    let after = apply(text.as_bytes(), &done.edits);
    let keys = done.findings.iter().map(|found| found.message.key.to_string());
    (String::from_utf8(after).unwrap(), keys.collect())
}

// oracle: hand
#[test]
fn a_call_is_converted_in_place() {
    let text = "N10 G17 ; start\r\nN20 _MVAR=0 _SETVAL=100 _MA=1\r\n_KNUM=0 _FA=3 G0 X5 ; go\r\n\
        N40 CYCLE978 ; measure\r\nN50 M30\r\n";
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

// oracle: hand: a jump, a repetition or a CASE still finds the block whose values go; a target that a run computes may
// be any
#[test]
fn a_block_number_that_something_leads_to_stays() {
    for leads in ["GOTOF N20", "REPEATB N0020", "CASE R1 OF 1 GOTOF N20 DEFAULT GOTOF N40", "GOTOF \"N\"<<R2"] {
        let text = format!("N10 {leads}\nN20 _MVAR=0 _SETVAL=100 _MA=1 _KNUM=0 _FA=3\nN30 CYCLE978\nN40 M30\n");
        let (indirect, _) = converted(&text, 0, Style::Indirect);
        assert!(indirect.lines().any(|line| line.trim() == "N20"), "{leads}\n{indirect}");
    }
    let text = "N10 G17\nN20 _MVAR=0 _SETVAL=100 _MA=1 _KNUM=0 _FA=3\nN30 CYCLE978\nN40 M30\n";
    assert!(!converted(text, 0, Style::Indirect).0.contains("N20"));
}

// oracle: hand
#[test]
fn a_call_that_relies_on_the_converted_one_is_told() {
    let text = "_MVAR=0 _SETVAL=100 _MA=1 _KNUM=0\nCYCLE978\n_SETVAL=50\nCYCLE978\n";
    assert_eq!(converted(text, 0, Style::Indirect).1, Vec::<String>::new());
    assert_eq!(converted(text, 0, Style::Operate).1, ["write-direction", "convert-added", "convert-others"]);
}

// oracle: self (what the form of that machine writes), manual B:12501-12539, B:13594-13596 (the data are converted)
#[test]
fn a_call_is_converted_as_the_forms_of_the_machine_write_it() {
    let text = "N10 G54\n; side\n_MVAR=0 _SETVAL=5 _MA=1 _KNUM=1 _TNUM=20 _VMS=200\nCYCLE978\nM30\n";
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
    let code = snippet(cycle("CYCLE977"), &first_example("CYCLE977"), &control, Style::Direct, None).text;
    let mark = code.lines().next().unwrap();
    let (operate, _) = converted_on(&control, &code, 0, Style::Operate);
    assert_eq!(operate.lines().next(), Some(mark));
    assert_eq!(operate.matches("_MZ_MASK").count(), 1, "{operate}");
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
    assert_eq!(indirect, "GOTOF A\nA: CYCLE_PARA(3)\nCYCLE_978(0,100,1,,,0) ; side\nM30\n");
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

// oracle: hand (a multi probe has no correction angle, a zero offset no memory: the list has no place for what is
// written there)
#[test]
fn values_that_count_for_nothing_do_not_go_in_silence() {
    let values = "_MVAR=101 _KNUM=1 _SETVAL=50 _PRNUM=1 _FA=2 _TSA=5 _VMS=0 _NMSP=1";
    for (more, told) in [("", false), (" _CORA=1", true), (" _CORA=0", false)] {
        let (list, why) = converted(&format!("{values}{more}\nCYCLE977\nM30\n"), 0, Style::Operate);
        assert!(list.starts_with("CYCLE977(101,1,"), "{list}");
        assert_eq!(why.contains(&"convert-unused".to_owned()), told, "{more}: {why:?}");
    }
}

// oracle: hand (on the way past the assignment the datum holds what the call before left)
#[test]
fn a_value_of_some_ways_only_is_not_written_into_the_call() {
    let text = |way: &str| {
        format!("_MVAR=1 _KNUM=0 _PRNUM=1 _FA=2 _TSA=5 _VMS=0 _NMSP=1\n{way}_SETVAL=30\nA: CYCLE977\nM30\n")
    };
    for style in [Style::Indirect, Style::Operate] {
        let (same, why) = converted(&text("IF R1==1 GOTOF A\n"), 0, style);
        assert_eq!((same, why), (text("IF R1==1 GOTOF A\n"), vec!["convert-skipped".to_owned()]));
        let (other, why) = converted(&text(""), 0, style);
        assert!(other != text("") && !why.contains(&"convert-skipped".to_owned()), "{other}: {why:?}");
    }
}

// oracle: hand (lists of newer controls have no argument for it, and read no user data)
#[test]
fn user_data_that_stay_are_told() {
    let values = "_MVAR=101 _KNUM=1 _SETVAL=50 _PRNUM=1 _FA=2 _TSA=5 _VMS=0 _NMSP=1";
    for (before, told) in [("", false), ("_CHBIT[14]=0\n", true), ("_RF=500\n", true), ("DEF REAL _RF\n_RF=5\n", false)]
    {
        let (list, why) = converted(&format!("{before}{values}\nCYCLE977\nM30\n"), 0, Style::Operate);
        assert!(list.starts_with(before) && list.contains("CYCLE977(101,1,"), "{list}");
        assert_eq!(why.contains(&"convert-stays".to_owned()), told, "{before}: {why:?}");
    }
}
