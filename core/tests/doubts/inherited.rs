//! Values that an earlier call left.

use super::{INHERITED, OVERWRITTEN, called, found, tells};
use probewright_core::dialect::Dialect;

/// Parameters about which a program raises the warning that an earlier call left them.
fn inherited(text: &str) -> Vec<&'static str> {
    let all = found(text);
    let doubts = all.iter().filter(|finding| finding.code == INHERITED);
    doubts.filter_map(|finding| finding.param.map(|name| name.as_str())).collect()
}

// oracle: hand (labels, units and choices of both calls)
#[test]
fn a_value_that_means_something_else_at_a_later_call_is_warned_about() {
    let hole = "_MVAR=1 _SETVAL=132 _KNUM=0 _PRNUM=2 _FA=4 _TSA=2 _VMS=200 _EVNUM=7\nCYCLE977\n";
    let edge = hole.replace("_MVAR=1 ", "_MVAR=100 _MA=1 ").replace("977", "978").replace("=132", "=0");
    for (program, expected) in [
        // diameter, position
        (format!("{hole}_MVAR=0 _MA=1\nCYCLE978\n"), vec!["_SETVAL"]),
        (format!("{hole}_MVAR=0 _MA=1 _SETVAL=0\nCYCLE978\n"), vec![]),
        // hole, groove
        (format!("{hole}_MVAR=3 _MA=1\nCYCLE977\n"), vec!["_SETVAL"]),
        // both a diameter; path, safe area, feed and probe are meant to stay
        (format!("{hole}_MVAR=2 _ID=-5\nCYCLE977\n"), vec![]),
        (format!("{hole}_MVAR=1 _CPA=1 _CPO=1 _STA1=0 _INCA=60 _RF=500\nCYCLE979\n"), vec![]),
        // the number of a variant of another cycle
        (format!("{hole}_MA=1 _SETVAL=0\nCYCLE978\n"), vec!["_MVAR"]),
        // a zero offset, the length of tool edge 1
        (edge.replace("_KNUM=0", "_KNUM=1") + "_MVAR=0 _SETVAL=5 _TNUM=3\nCYCLE978\n", vec!["_KNUM"]),
        (format!("{edge}_MVAR=0 _SETVAL=5\nCYCLE978\n"), vec![]),
        // degrees out of millimetres
        (format!("{edge}_MVAR=105 _SETVAL=0 _MA=102 _ID=60 _RA=0 _STA1=0\nCYCLE998\n"), vec!["_TSA"]),
        // the probe and the memory of workpieces
        (format!("{hole}_MVAR=1 _MA=3 _ID=20 _TSA=5 _FA=10\nCYCLE971\n"), vec!["_EVNUM", "_PRNUM"]),
        (format!("{hole}_MVAR=1 _MA=3 _ID=20 _TSA=5 _FA=10 _PRNUM=1 _EVNUM=0\nCYCLE971\n"), vec![]),
    ] {
        let mut told = inherited(&program);
        told.sort_unstable();
        assert_eq!(told, expected, "{program}");
    }
}

// oracle: self (every example of the catalogue, written in full after every other one, inherits nothing)
#[test]
fn a_call_that_is_written_in_full_inherits_nothing() {
    use probewright_core::catalogue::CYCLES;
    use probewright_core::catalogue::example::worked;
    use probewright_core::control::delivery;
    use probewright_core::entry::Style;
    use probewright_core::program::write::snippet;
    let control = delivery(Dialect::Sinumerik);
    let examples = CYCLES.iter().filter(|cycle| cycle.dialect == Dialect::Sinumerik);
    let texts: Vec<String> = examples
        .map(|cycle| {
            let mut typed = worked(cycle);
            for param in cycle.params {
                let delivered = param.fallback(&control).map(|value| value.to_string());
                typed.entry(param.name.to_string()).or_insert(delivered.unwrap_or_default());
            }
            snippet(cycle, &typed, &control, Style::Direct, None).text
        })
        .collect();
    for first in &texts {
        for second in &texts {
            let program = format!("{first}\n{second}\n");
            assert_eq!(inherited(&program), [""; 0], "{program}");
        }
    }
}

// oracle: hand (parameters are data of the channel: what a subprogram writes counts behind it)
#[test]
fn a_value_that_a_subprogram_writes_anew_is_warned_about() {
    let begin = "G17 G40 G54 T9 D1\n";
    let values = "_MVAR=1 _SETVAL=132 _KNUM=0 _PRNUM=1 _FA=2 _TSA=2\n";
    for (main, sub, warned) in [
        ("L5\nCYCLE977", "_SETVAL=4", true),
        ("L5\nCYCLE977", "_SETVAL=R1", true),
        ("L5\nCYCLE977", "_SETVAL=132 _FA=2", false),
        ("L5\nCYCLE977", "R5=4", false),
        ("L5\n_SETVAL=132\nCYCLE977", "_SETVAL=4", false),
        ("CYCLE977\nL5", "_SETVAL=4", false),
        ("L5\nCYCLE977", "L6\nM17\n%_N_L6_SPF\n_SETVAL=4", true),
    ] {
        let text = called(&format!("{begin}{values}{main}"), sub);
        assert_eq!(tells(&text, OVERWRITTEN), warned, "{text}");
    }
}
