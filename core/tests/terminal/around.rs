//! Blocks around a call, and the result screen that follows it.

use super::{HOLE, err, example_setup, file, out, probewright};

// oracle: hand (a hole that is too small has material left; the loop goes back to before the call, and ends behind it)
#[test]
fn write_puts_a_block_around_the_call() {
    let call = ["write", "CYCLE977", "_MVAR=1", "_SETVAL=132", "_KNUM=2001", "_TNUM=20"];
    let asked = |blocks: &[&str]| probewright(&[&call, blocks].concat());
    let output = asked(&["--around", "rework.program=L100", "--around", "rework.passes=5"]);
    assert!(output.status.success(), "{}", err(&output));
    let text = out(&output);
    let mut from = 0;
    for line in [
        "PW1_AGAIN:\n",
        "\nCYCLE977\n",
        "ABS(_OVR[16])<=0.02 GOTOF PW1_GOOD\n",
        "(_OVR[16]<0) AND (R99<5)",
        "\nL100\n",
        "GOTOB PW1_AGAIN\n",
        "PW1_GOOD:\n",
    ] {
        from += text[from..].find(line).unwrap_or_else(|| panic!("{line:?} in its order: {text}"));
    }
    // hand: half of the tolerance, whose middle counts (B:2203-2211)
    let output = asked(&["_TUL=0.05", "_TLL=-0.03", "--around", "stop"]);
    assert!(out(&output).contains("ABS(_OVR[16])<=0.04 GOTOF"), "{}{}", out(&output), err(&output));
    let refused = [
        (&["--around", "rework"][..], "rework.program"), // it has to be entered
        (&["--around", "rework.program=L100", "--around", "rework.passes=0"], "rework.passes"),
        (&["--around", "rework.number=1"], "number"),
        (&["--around", "breakage"], "CYCLE977"), // it measures no tool
    ];
    for (blocks, named) in refused {
        let output = asked(blocks);
        assert_eq!(output.status.code(), Some(2), "{blocks:?}");
        assert!(err(&output).contains(named) && out(&output).is_empty(), "{blocks:?}: {}", err(&output));
    }
}

// oracle: manual B:12564-12578 (when it is shown), B:12608-12616 (what is on it), B:12627-12644 (decimals); hand (the
// figures)
#[test]
fn run_prints_the_result_screens() {
    let ran = |switches: &str| {
        let text = HOLE.replace("_CHBIT[4]=1", &format!("_CHBIT[4]=1 {switches}"));
        let path = file("screens.mpf", text.as_bytes());
        let output = probewright(&["run", &path, "--setup", &example_setup(), "--screens"]);
        assert!(output.status.success(), "{}{}", out(&output), err(&output));
        out(&output)
    };
    assert!(!ran("").contains("Workpiece measurement"));
    let shown = ran("_CHBIT[10]=1 _CHBIT[11]=1");
    let (_, screen) = shown.split_once("Workpiece measurement\nCYCLE977 1: ").unwrap_or_else(|| panic!("{shown}"));
    let row: Vec<&str> = screen.lines().nth(2).unwrap().split_whitespace().take(4).collect();
    assert_eq!(row, ["132.000000", "132.030000", "0.030000", "mm"], "{screen}");
    assert!(screen.contains("NC START"), "{screen}");
}
