//! What a pass of a loop leaves to the next one, and behind it.

use super::{COMPENSATION, HOLE, SPINDLE, called, found, tells};
use probewright_core::diagnostic::Code::Alarm;

// oracle: hand (what the end of a pass leaves, the next one finds)
#[test]
fn a_loop_is_followed_with_what_its_end_leaves() {
    let loops = [
        ("LOOP", "ENDLOOP"),
        ("WHILE R1<5", "ENDWHILE"),
        ("FOR R1=1 TO 5", "ENDFOR"),
        ("REPEAT", "UNTIL R1>5"),
        ("AGAIN:", "IF R1<5 GOTOB AGAIN"),
        ("N100 G0 X0", "GOTOB N100"),
    ];
    for (begin, end) in loops {
        let program = |body: &str| format!("G17 G40 G54 T9 D1\n{begin}\n{body}{end}\nM30\n");
        let milled = "G41 G1 X10\n";
        assert!(tells(&program(&format!("{HOLE}{milled}")), COMPENSATION), "{begin}");
        assert!(tells(&program(&format!("{HOLE}S500 M3\n")), SPINDLE), "{begin}");
        assert!(tells(&program(&format!("{HOLE}D0\n")), Alarm(61311)), "{begin}");
        // Each of these comes back as it was, or leaves it to the run.
        for right in [
            format!("{HOLE}{milled}G40 X0\n"),
            format!("G40\n{HOLE}{milled}"),
            format!("{HOLE}IF R2>1\n{milled}ENDIF\n"),
            format!("{HOLE}{milled}L77\n"),
            format!("{HOLE}{milled}M30\n"),
        ] {
            assert!(!tells(&program(&right), COMPENSATION), "{begin} {right}");
        }
        // In a subprogram, and around one.
        let inside = called("G17 G40 T9 D1\nL5", &format!("{begin}\n{HOLE}{milled}{end}"));
        assert!(tells(&inside, COMPENSATION), "{begin}");
        let around = called(&format!("G17 G40 T9 D1\n{begin}\nL5\n{end}"), &format!("{HOLE}{milled}"));
        assert!(tells(&around, COMPENSATION), "{begin}");
    }
}

// oracle: hand (a loop that may not run at all, and one that surely does)
#[test]
fn what_holds_behind_a_loop() {
    let behind = |begin: &str, end: &str| {
        let text = format!("G17 G40 G54 T9 D1\n{begin}\nG41 G1 X10\n{end}\n{HOLE}M30\n");
        tells(&text, COMPENSATION)
    };
    assert!(behind("FOR R1=1 TO 3", "ENDFOR"));
    assert!(behind("REPEAT", "UNTIL R1>5"));
    assert!(behind("AGAIN:", "IF R1<5 GOTOB AGAIN"));
    assert!(!behind("FOR R1=1 TO R2", "ENDFOR"));
    assert!(!behind("FOR R1=1 TO 0", "ENDFOR"));
    assert!(!behind("WHILE R1<5", "ENDWHILE"));
    // Out of the first pass or out of the second one.
    let text = "AGAIN:\nIF R1>3\nG41 G1 X5\nGOTOB AGAIN\nENDIF\n";
    assert!(!tells(&format!("G17 G40 T9 D1\n{text}{HOLE}M30\n"), COMPENSATION));
}

// oracle: self (each body a few times, however deep it stands)
#[test]
fn loops_in_loops_come_to_an_end() {
    let depth = 200;
    let begin: String = (0..depth).map(|n| format!("WHILE R{n}<5\nG{}\n", 17 + n % 3)).collect();
    let end: String = (0..depth).map(|n| format!("G{}\nENDWHILE\n", 40 + n % 3)).collect();
    assert!(!found(&format!("T9 D1\n{begin}{HOLE}{end}M30\n")).is_empty());
    let labels: String = (0..400).map(|n| format!("A{n}: G{}\n", 17 + n % 3)).collect();
    let jumps: String = (0..400).map(|n| format!("IF R1<{n} GOTOB A{n}\n")).collect();
    assert!(!found(&format!("D1\n{labels}{HOLE}{jumps}M30\n")).is_empty());
}
