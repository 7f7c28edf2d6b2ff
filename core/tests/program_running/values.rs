//! Tools and their data, expressions, arrays.

use super::{clean, clean_on, go, machine, near, number};
use probewright_core::machine::Stop;
use probewright_core::machine::trace::Step;

#[test]
fn tools_change_with_m6() {
    let outcome = clean("N10 T20 D2\nN20 M6");
    assert_eq!((outcome.control.tool, outcome.control.edge), (20, 2));
    // oracle: hand: the mill is 30 mm longer, the spindle stays, so its tip is 30 mm lower
    near(outcome.position.0, [0.0, 0.0, 470.0]);
    assert!(outcome.trace.entries.iter().any(|entry| entry.step == Step::Tool { tool: 20, edge: 2 }));
    let outcome = clean("T20 M6");
    assert_eq!((outcome.control.tool, outcome.control.edge), (20, 1));
    let outcome = clean("T=\"MILL\" M6\nD0");
    assert_eq!((outcome.control.tool, outcome.control.edge), (20, 0));
    near(outcome.position.0, [0.0, 0.0, 550.0]);
    let outcome = go("T77 M6");
    assert!(matches!(outcome.stop, Some(Stop::Fault(message)) if message.key == "run-no-tool"));
}

// oracle: manual (function manual W1 11/2006, 2.1.1: D1 to D9 activate an edge of the active tool; MD 20270 says the
// edge after a change); the mill is 80 mm long, the probe 50
#[test]
fn an_edge_behind_a_preselected_tool_is_of_the_one_in_use() {
    let tool_at = |text: &str| {
        let outcome = clean(text);
        ([outcome.control.tool, outcome.control.edge, outcome.control.number("R1") as i64], outcome.position.0[2])
    };
    assert_eq!(tool_at("T20\nM6\nG0 Z100\nT9\nSUPA G0 Z400 D0\nR1=$P_TOOL"), ([20, 0, 0], 400.0));
    assert_eq!(tool_at("T20\nM6\nT9\nG0 SUPA Z400 D0\nM6\nR1=$P_TOOL\nZ100"), ([9, 1, 1], 100.0));
    assert_eq!(tool_at("T20\nM6\nT9\nD2\nR1=$P_TOOL\nG0 Z100\nM6\nZ90"), ([9, 1, 2], 90.0));
    for (datum, edge) in [(2.0, 2), (1.0, 1), (0.0, 0), (-1.0, 2)] {
        let mut setup = machine();
        setup.control.set("MD20270", datum);
        setup.control.tools.insert(21, setup.control.tools[&20].clone());
        let outcome = clean_on(&setup, "T20\nM6\nD2\nT21\nM6");
        assert_eq!((outcome.control.tool, outcome.control.edge), (21, edge), "{datum}");
    }
    // with T, or with M6, it is of the one that comes
    assert_eq!(tool_at("T9\nM6\nT20 D2\nR1=$P_TOOL\nM6\nG0 Z100"), ([20, 2, 1], 100.0));
    assert_eq!(tool_at("T9\nM6\nT20\nR1=$P_TOOL\nD2 M6\nG0 Z100"), ([20, 2, 1], 100.0));
}

#[test]
fn tool_data_are_read_and_written() {
    let outcome = clean("$TC_DP15[20,1]=-0.02 R1=$TC_DP6[20,1]+$TC_DP15[20,1] R2=$P_TOOLR");
    assert_eq!(outcome.control.tools[&20].edges[&1].radius_wear, -0.02);
    assert_eq!(outcome.control.number("R1"), 9.98);
    assert_eq!(outcome.control.number("R2"), 3.0);
    let names: Vec<_> = outcome.changes().into_iter().map(|change| change.name).collect();
    assert_eq!(names, ["$TC_DP15[20,1]"]);
}

#[test]
fn expressions_are_worked_out() {
    // oracle: hand
    let cases = [
        ("2+3*4", 14.0),
        ("(2+3)*4", 20.0),
        ("7 DIV 2", 3.0),
        ("7 MOD 4", 3.0),
        ("-SIN(30)", -0.5),
        ("SQRT(9)+ABS(-1)", 4.0),
        ("ATAN2(1,1)", 45.0),
        ("(3>2) AND NOT(1==2)", 1.0),
        ("6 B_AND 3", 2.0),
        ("TRUNC(2.7)+ROUND(2.5)", 5.0),
        ("MINVAL(3,2)+BOUND(0,5,9)", 7.0),
        ("POT(3)", 9.0),
        ("STRLEN(\"AB\"<<12)", 4.0),
        ("\"A\"==\"B\"", 0.0),
    ];
    for (expression, value) in cases {
        let found = number(&format!("R1={expression}"), "R1");
        assert!((found - value).abs() < 1e-12, "{expression}: {found}");
    }
    let fails = [
        ("R1=1/0", "run-division"),
        ("R1=SQRT(-1)", "run-function"),
        ("R1=\"A\"+1", "run-not-a-number"),
        ("R1=_NOBODY", "run-unknown-variable"),
        ("R1=$AA_MW[X]", "run-not-measured"),
        ("_NOBODY=1", "run-unknown-variable"),
        ("_OVR[32]=1", "run-index"),
        ("$P_TOOLR=1", "run-read-only"),
    ];
    for (text, key) in fails {
        let outcome = go(text);
        assert!(
            matches!(&outcome.stop, Some(Stop::Fault(message)) if message.key == key),
            "{text}: {:?}",
            outcome.stop
        );
        assert!(outcome.diagnostics[0].span.is_some());
    }
}

#[test]
fn arrays_are_filled_in_the_order_of_their_elements() {
    // oracle: hand (the last index counts first; REP goes to the end of the array)
    let outcome = clean(
        "_WP[0,9]=SET(1,2,3)\nR998=REP(4)\n_SETV[7]=REP(8)\nDEF REAL A[2,2]\nA[0,1]=SET(5,6)\nR1=A[1,0]\nR2=A[1,1]",
    );
    for (name, expected) in [
        ("_WP[0,9]", 1.0),
        ("_WP[0,10]", 2.0),
        ("_WP[1,0]", 3.0),
        ("R997", 0.0),
        ("R998", 4.0),
        ("R999", 4.0),
        ("_SETV[6]", 0.0),
        ("_SETV[7]", 8.0),
        ("_SETV[8]", 8.0),
        ("R1", 6.0),
        ("R2", 0.0),
    ] {
        assert_eq!(outcome.control.number(name), expected, "{name}");
    }
    let whole = clean("_WP=REP(7)");
    assert_eq!(whole.control.number("_WP[2,10]"), 7.0);
    assert!(!whole.control.data.contains_key("_WP[3,0]"), "there are three probes, B:13346");
    assert!(go("_SETV[8]=SET(1,2)").stop.is_some(), "no room for the second");
}

#[test]
fn arrays_are_filled() {
    let outcome = clean("_SETV[1]=SET(5,,7)\n_EV[3]=0.5 R2=_EV[R9+3]");
    // oracle: hand
    assert_eq!(outcome.control.number("_SETV[1]"), 5.0);
    assert_eq!(outcome.control.number("_SETV[3]"), 7.0);
    assert!(!outcome.control.data.contains_key("_SETV[2]"));
    assert_eq!(outcome.control.number("R2"), 0.5);
    let text = "DEF REAL LIST[3]\nDEF INT I, TEN=10\nDEF STRING[10] NAME=\"AB\"\nLIST=SET(1,2,3)\nR1=LIST[2]+TEN";
    assert_eq!(number(text, "R1"), 13.0);
    assert_eq!(number("R1=_FA R2=_WP[0,1]", "R1"), 2.0); // oracle: manual B:1779
}
