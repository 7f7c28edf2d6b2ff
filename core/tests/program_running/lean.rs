//! Programs whose plain motions stay text: calls, findings and edits are those of the whole tree.

use crate::large::programs;
use probewright_core::app;
use probewright_core::control::delivery;
use probewright_core::dialect::Dialect;
use probewright_core::entry::Style;
use probewright_core::program::calls::calls;
use probewright_core::program::convert::convert_all;
use probewright_core::program::revise::revise;
use probewright_core::syntax::{Program, read, read_lean};
use std::sync::Arc;

/// What is told about a program, its calls rewritten and a value of each changed.
fn told(program: &Program) -> Vec<String> {
    let control = delivery(program.dialect);
    let styles = [Style::Direct, Style::Indirect, Style::Operate].map(|style| {
        let done = convert_all(program, style, &control);
        format!("{:?} {:?}", done.edits, done.findings)
    });
    let sites = calls(program);
    let values = sites.iter().enumerate().filter_map(|(index, site)| {
        let name = site.values.keys().next()?;
        Some(format!("{:?}", revise(program, index, (name, "7"), &control, &mut |_, _, _| Vec::new())))
    });
    let read = format!("{:?}", app::calls(program));
    [read].into_iter().chain(styles).chain(values.take(3)).collect()
}

fn assert_same(dialect: Dialect, text: &[u8], what: &str) {
    let lean = read_lean(dialect, text, &Arc::default());
    assert_eq!(told(&read(dialect, text)), told(&lean), "{what}");
}

/// The text with a motion before each of its lines.
fn among_motions(text: &[u8]) -> Vec<u8> {
    let lines = text.split_inclusive(|byte| *byte == b'\n');
    lines.flat_map(|line| [b"G1 X5 Y-2.5 F100\n", line].concat()).collect()
}

// oracle: self: what the whole tree says
#[test]
fn a_program_is_told_the_same_with_motions_left_as_text() {
    let folders = ["right", "wrong"].map(programs).concat();
    assert!(folders.len() > 50);
    let mut left = 0;
    for path in folders {
        let text = std::fs::read(&path).unwrap();
        let dialect = Dialect::of(&text);
        let what = path.display().to_string();
        assert_same(dialect, &text, &what);
        let among = among_motions(&text);
        assert_same(dialect, &among, &format!("{what} among motions"));
        let lean = read_lean(dialect, &among, &Arc::default());
        left += usize::from(lean.blocks.iter().any(|block| block.plain));
    }
    assert!(left > 40, "{left}");
}

// oracle: hand: a frame that is corrected and not taken is moved in, and a motion before a call is no assignment for it
#[test]
fn a_motion_left_as_text_counts_where_motions_do() {
    let call = "T20 D1\nG17 G54 G40\nG0 X0\n_MVAR=101 _SETVAL=132 _KNUM=1 _PRNUM=1 _FA=2 _TSA=1\nCYCLE977\n";
    let found = |behind: &str| {
        let program = read_lean(Dialect::Sinumerik, format!("{call}{behind}M30\n").as_bytes(), &Arc::default());
        let told = app::calls(&program).diagnostics;
        told.iter().any(|one| one.message.key == "advice-frame")
    };
    assert!(found("G0 X10\n"));
    assert!(!found("G54\nG0 X10\n"));
    assert!(!found("G0 F100\n"));
}
