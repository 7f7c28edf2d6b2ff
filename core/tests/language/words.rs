//! Tools, spindle, alarms, operator texts, ends, and what is not understood.

use super::{at, clean, fault, findings, go, messages, near, number, setup};
use probewright_core::dialect::Dialect;
use probewright_core::machine::trace::Step;
use probewright_core::run::{Limits, run};
use probewright_core::syntax::read;

// oracle: hand
#[test]
fn tools_are_chosen_and_told() {
    for (text, expected) in [
        ("T20 D2 M6\nR1=$P_TOOLNO*10+$P_TOOL", 202.0),
        ("T20 M6\nR1=$P_TOOLL[1]+$P_TOOLR", 90.0),
        // a turning tool is in a turret, which T turns at once
        ("T20 D1\nR1=$P_TOOLNO", 9.0),
        ("$TC_DP1[20,1]=500\nT20 D1\nR1=$P_TOOLNO", 20.0),
        ("T20 M6\n$TC_DP12[20,1]=0.5\nR1=$P_TOOLL[1]", 80.5),
        ("T20 M6\n$TC_SCP23[20,1]=0.25\nR1=$P_TOOLL[1]\nDL=2\nR1=100*R1+$P_TOOLL[1]", 8080.25),
        ("T20 M6\nDL=2\nD1\nR1=$P_DLNO", 0.0),
        ("$TC_DP1[33,1]=120 $TC_DP3[33,1]=60\nT33 M6\nR1=$P_TOOLL[1]", 60.0),
        ("$TC_DP25[20,1]=7\nR1=$TC_DP25[20,1]", 7.0),
        ("G18\nT20 M6\n$TC_DP4[20,1]=3\nR1=$P_TOOLL[2]", 3.0),
        ("T20\nR1=$P_TOOLNO*100+$P_TOOLP", 920.0),
    ] {
        near(number(text, "R1"), expected, text);
    }
    assert_eq!(fault("DL=9"), "run-range");
}

// oracle: hand
#[test]
fn the_spindle_is_turned() {
    let angles = |text: &str| {
        let outcome = clean(text);
        let steps = outcome.trace.entries.iter();
        let angles = steps.filter_map(|entry| match entry.step {
            Step::Orient { angle } => Some(angle.0),
            _ => None,
        });
        angles.collect::<Vec<_>>()
    };
    assert_eq!(angles("SPOS=90\nSPOS=IC(45)\nSPOSA=DC(10)\nM19"), [90.0, 135.0, 10.0, 0.0]);
}

// oracle: hand: the first spindle, an axis by its name in a variable; what the machine does not have is reported
#[test]
fn addresses_may_be_written_with_an_index() {
    let outcome = clean("S[1]=500 M[1]=3\nSPOS[1]=AC(90)\nSPOSA[1]=IC(-30)");
    assert_eq!(outcome.control.spindle.0, 60.0);
    at("DEF AXIS WAY=(Y)\nG0 AX[WAY]=7\nAX[X]=IC(2)", [2.0, 7.0, 0.0]);
    for (text, told) in
        [("SPOS[2]=45", "run-passed"), ("POS[SPINDLE]=100", "run-passed"), ("DISC=50", "run-not-simulated")]
    {
        assert!(findings(text).iter().all(|key| key == told), "{text}");
        assert!(!findings(text).is_empty(), "{text}");
    }
    // an array of the program comes before an address of the same letter
    let outcome = clean(
        "DEF REAL S[3]
S[0]=2.5 S[1]=4
R1=S[0]+S[1]",
    );
    assert_eq!(outcome.control.number("R1"), 6.5);
    assert_eq!(fault("DISC=101"), "run-range");
}

// oracle: hand: M3 and M4 turn with the speed that S gives, another S while it turns counts at once, M5 and SPOS end it
#[test]
fn the_spindle_turns() {
    let speeds = |text: &str| {
        let outcome = clean(text);
        let steps = outcome.trace.entries.iter();
        let speeds = steps.filter_map(|entry| match entry.step {
            Step::Spin { speed } => Some(speed),
            _ => None,
        });
        (speeds.collect::<Vec<_>>(), outcome.control.spindle_speed)
    };
    assert_eq!(speeds("S500 M3\nS300\nM4\nM5\nS200"), (vec![500.0, 300.0, -300.0, 0.0], 0.0));
    assert_eq!(speeds("M4 S500\nS300"), (vec![-500.0, -300.0], -300.0));
    assert_eq!(speeds("M3 S500\nSPOS=90"), (vec![500.0], 0.0));
}

// oracle: manual (Job planning, alarms in the cycle area: 61000 and 65000 stop, 62000 and 67000 are shown)
#[test]
fn a_program_raises_alarms() {
    assert_eq!(fault("SETAL(65000)\nR1=1"), "run-set-alarm");
    assert_eq!(fault("SETAL(61301)"), "run-set-alarm");
    assert_eq!(fault("SETAL(12345)"), "run-alarm-number");
    assert_eq!(messages("SETAL(67001,\"look\")\nMSG(\"on\")"), ["67001 look", "on"]);
}

// oracle: hand
#[test]
fn programs_end_and_stop_where_they_say() {
    assert_eq!(messages("M0\nM1\nMSG(\"A\"<<1.5)\nMSG()\nM30\nMSG(\"no\")"), ["M0", "M1", "A1.5", ""]);
    for last in ["M2", "M30", "M17", "RET"] {
        assert_eq!(number(&format!("R1=1\n{last}\nR1=2"), "R1"), 1.0, "{last}");
    }
}

// oracle: hand
#[test]
fn a_block_number_a_skip_level_and_a_comment_change_nothing() {
    assert_eq!(number("N10 R1=1 ; R1=5\n/2 N20 R1=R1+1\n:30 R1=R1+1", "R1"), 3.0);
}

// oracle: hand
#[test]
fn skip_levels_leave_out_what_is_switched_on() {
    let text = "/N10 R1=R1+1\n/0 R1=R1+10\n/2 R1=R1+100\n/9 R1=R1+1000\nR2=7\n/2 GOTOF OUT\nR2=8\nOUT: M30";
    let program = read(Dialect::Sinumerik, text.as_bytes());
    for (skip, expected, end) in [(&[][..], 1111.0, 7.0), (&[0], 1100.0, 7.0), (&[2, 9], 11.0, 8.0)] {
        let mut setup = setup();
        setup.skip = skip.iter().copied().collect();
        let control = run(&program, &setup, Limits::default()).control;
        assert_eq!(control.number("R1"), expected, "{skip:?}");
        assert_eq!(control.number("R2"), end, "{skip:?}");
    }
}

// oracle: hand: each at its place, none left out silently
#[test]
fn what_is_not_simulated_is_told() {
    for (text, key) in [
        ("FROBNICATE", "run-subprogram"),
        ("FROBNICATE(1,2)", "run-subprogram"),
        ("G777", "run-unknown-word"),
        ("G5 X5", "run-not-simulated"),
        ("G751 X5", "run-not-simulated"),
        ("G931", "run-passed"),
        ("SCPARA[X]=1", "run-passed"),
        ("DISRP=1", "run-passed"),
        ("MOVT=5", "run-passed"),
        ("CPON=(X2)", "run-passed"),
        ("DIAMONA[U]", "run-passed"),
        ("INTERSEC(1,2,3)", "run-passed"),
        ("G331 Z-5 K1", "run-not-simulated"),
        ("WHEN $AA_IW[Z]>10 DO M8", "run-synchronous"),
        ("U5", "run-axes"),
        ("A90", "run-axes"),
        ("M77", "run-machine-function"),
        ("L77", "run-subprogram"),
        ("X=DC(5)", "run-function"),
        ("POS[X]=5", "run-positioning"),
        ("POSA[U1]=5", "run-axes"),
        ("R1=$AN_NOBODY", "run-machine-value"),
    ] {
        let found = go(&format!("G0 Y1\n{text}"));
        let finding = &found.diagnostics[0];
        assert_eq!(finding.message.key, key, "{text}");
        let start = finding.span.unwrap().start as usize;
        assert!((6..6 + text.len()).contains(&start), "{text}: {start}");
    }
}

// oracle: hand: how the axes accelerate, blend and are shared between channels changes nothing that is measured
#[test]
fn what_changes_nothing_runs_through() {
    for text in [
        "BRISK FFWON SOFT\nG64 G602\nSTOPRE",
        "G641 ADIS=0.5\nG642 ADISPOS=1",
        "ACC[X]=50 ACC[U]=20\nVELOLIM[X]=50\nJERKLIM[C]=75\nOVR=80",
        "FGROUP(X,Y,C)\nFGREF[A]=10\nFL[X]=3000",
        "WAITP(U)\nWAITS(1)\nGET(B)\nRELEASE(X,B)\nGETD(Q1)",
        "ORIWKS ORIAXES\nTRAFOOF\nTOROTOF PAROTOF",
        "COMPCAD\nCOMPOF\nCYCLE832(0.05,3,1)\nDYNFINISH",
        "CORROF\nCORROF(X,\"DRF\")\nDRFOF\nRTLIOF\nSTOPFIFO\nDELDTG",
        "SPCON(1)\nSPCOF\nFRC=20",
    ] {
        at(&format!("{text}\nG0 X3"), [3.0, 0.0, 0.0]);
    }
}

// oracle: hand: the axes that are here go on, what is left out is reported where it stands
#[test]
fn what_is_left_out_leaves_the_axes_where_they_belong() {
    for (text, told, x) in [
        ("G75 X0", "run-not-simulated", 5.0),
        ("G75 FP=1 X1=0", "run-not-simulated", 5.0),
        ("G74 X1=0 C1=0", "run-not-simulated", 5.0),
        ("G25 X1\nG26 S3000", "run-not-simulated", 5.0),
        ("G331 Z-10 K1 S500\nG332 Z5 K1", "run-not-simulated", 5.0),
        ("POS[U]=20 X7", "run-axes", 7.0),
        ("POS[X]=20", "run-positioning", 20.0),
        ("TRANS X1\nPOSA[X]=IC(20) F100\nWAITP(X)", "run-positioning", 26.0),
        ("G1 F100 X6 POS[X]=8 FA[X]=500", "run-positioning", 8.0),
        ("G247 G41 DISR=5 X6 Y0 F100\nG40 G1 X7", "run-not-simulated", 7.0),
        ("TRAORI\nX7 A3=0 C3=1", "run-passed", 7.0),
        ("G[30]=1 X7", "run-passed", 7.0),
        ("FXS[Z1]=1 OS[Z]=1 STAT=2 SUG=35 X7", "run-passed", 7.0),
        ("FINEA[X]\nMEASA[X]=(1,1) X7", "run-passed", 7.0),
        ("POLY PO[X]=(7,1,2) PL=1 F100", "run-spline", 7.0),
        ("CALL \"A\" BLOCK BEGIN TO LAST\nX7", "run-passed", 7.0),
        ("WAITM(1,1,2)\nX7", "run-passed", 7.0),
        ("IDS=1 DO $AC_MARKER[1]=5\nID=2 EVERY $A_IN[1]==1 DO M8\nX7", "run-synchronous", 7.0),
        ("SETINT(1) PRIO=1 LIFTFAST\nX7", "run-synchronous", 7.0),
        ("TCARR=1\nTCOABS\nX7", "run-passed", 7.0),
        ("S2=500 T2=20 X7\nM6", "run-passed", 7.0),
        ("H5 X7", "run-machine-function", 7.0),
        ("M2=3 M2=30\nM70\n$A_OUT[3]=1\nX7", "run-machine-function", 7.0),
    ] {
        let outcome = go(&format!("G0 X5\n{text}"));
        assert_eq!(outcome.stop, None, "{text}");
        let mut keys = outcome.diagnostics.iter().map(|found| &*found.message.key);
        assert!(keys.clone().count() > 0 && keys.all(|key| key == told), "{text}");
        near(outcome.position[0], x, text);
        assert_eq!(outcome.control.spindle_speed, 0.0, "{text}");
    }
    assert_eq!(fault("G0 X5\nROT Z30\nPOS[X]=7"), "run-not-simulated");
}
