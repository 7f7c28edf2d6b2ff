//! Three call styles: what is written is read back, and a change changes one value.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod compared;
mod convert;
mod elsewhere;
mod expressions;
mod generations;
mod newer;
mod round_trip;
mod same_meaning;
#[cfg(feature = "json")]
mod worth;
mod wrong_arguments;

use probewright_core::catalogue::example::worked;
use probewright_core::catalogue::find;
use probewright_core::control::delivery;
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, Style, Typed};
use probewright_core::program::calls::{CallSite, calls};
use probewright_core::program::change::{apply, change};
use probewright_core::program::write::{Written, snippet};
use probewright_core::syntax::read;

fn typed(pairs: &[(&str, &str)]) -> Typed {
    let owned = |(name, value): &(&str, &str)| ((*name).to_owned(), (*value).to_owned());
    pairs.iter().map(owned).collect()
}

fn cycle(name: &str) -> &'static Cycle {
    find(Dialect::Sinumerik, name).unwrap()
}

fn first_example(name: &str) -> Typed {
    worked(cycle(name))
}

fn written(name: &str, values: &Typed, style: Style) -> Written {
    snippet(cycle(name), values, &delivery(Dialect::Sinumerik), style, None)
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
    assert_eq!(lines[1], "CYCLE_PARA(2,,1,,1,,0.01,0.02,0.03,-0.03,1,20,3,0.06)");
    assert_eq!(lines[2], "CYCLE_978(0,100,1,20,,2001)");
}

// oracle: peer (argument order of newer controls)
#[test]
fn a_hole_in_the_list_of_newer_controls() {
    let values = typed(&[
        ("_MVAR", "1"),
        ("_KNUM", "0"),
        ("_PRNUM", "1"),
        ("_SETVAL", "132"),
        ("_VMS", "300"),
        ("_FA", "2"),
        ("_TSA", "1"),
        ("_NMSP", "1"),
        ("_TDIF", "0.06"),
        ("_TUL", "0.03"),
        ("_TLL", "-0.03"),
        ("_TMV", "0.02"),
        ("_K", "3"),
        ("_TZL", "0.01"),
    ]);
    let written = written("CYCLE977", &values, Style::Operate);
    assert_eq!(written.text, "CYCLE977(1,0,,1,132,,,2,1,,,,,,1,\"\",,0.01,0.06,0.03,-0.03,0.02,3,,,1,1)\n");
    let lost: Vec<&str> = written.findings.iter().map(|found| &*found.message.key).collect();
    assert_eq!(lost, ["write-lost"], "_VMS has no place there");
}

// oracle: manual B:11734
#[test]
fn nothing_goes_through_cycle_para_as_zero() {
    let text = "_TZL=0.5\nCYCLE_PARA(3,,,,,,0)\nCYCLE_978(0,100,1)\n";
    let site = &sites(text)[0];
    assert_eq!(site.values["_TZL"], "0.5");
    assert_eq!(site.values["_FA"], "3");
    assert_eq!(site.values["_KNUM"], "0", "an omitted argument is 0 for the called program");
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let changed =
        |name, value| String::from_utf8(apply(text.as_bytes(), &change(&program, site, name, value))).unwrap();
    assert_eq!(changed("_FA", "4"), text.replace("PARA(3", "PARA(4"));
    assert_eq!(changed("_FA", "0"), "_TZL=0.5 _FA=0\nCYCLE_PARA(,,,,,,0)\nCYCLE_978(0,100,1)\n");
    assert_eq!(changed("_KNUM", "2001"), text.replace("1)", "1,,,2001)"));
    assert_eq!(changed("_SETVAL", "-7.5"), text.replace("100,", "-7.5,"));
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
    assert!(sites("CYCLE978()\n")[0].list.is_none(), "the bare name takes the data");
}
