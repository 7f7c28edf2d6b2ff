//! Programs that call programs of the same text.

use super::{clean, fault, findings, number};
use probewright_core::machine::trace::Step;

// oracle: hand
#[test]
fn parameters_are_passed_by_value_and_by_reference() {
    let text = "DEF REAL OLD=2\nDEF REAL NEW\nTWICE(OLD+1,NEW)\nR1=OLD R2=NEW\nM30\n\
        %_N_TWICE_SPF\nPROC TWICE(REAL SIZE, VAR REAL RESULT)\nRESULT=2*SIZE\nSIZE=99\nRET";
    assert_eq!((number(text, "R1"), number(text, "R2")), (2.0, 6.0));
    let control = "TWICE(4,R7)\nTWICE(R7,_SETV[2])\nM30\nPROC TWICE(INT SIZE,VAR REAL RESULT)\nRESULT=2*SIZE\nM17";
    let outcome = clean(control);
    assert_eq!(outcome.control.number("R7"), 8.0);
    assert_eq!(outcome.control.number("_SETV[2]"), 16.0);
}

// oracle: manual (Job planning: what a call omits is 0 or the default of the PROC)
#[test]
fn omitted_arguments_have_their_default() {
    let text =
        "PART(1,,3)\nM30\n%_N_PART_SPF\nPROC PART(REAL A, REAL B, REAL C, REAL D=4)\nR1=1000*A+100*B+10*C+D\nRET";
    assert_eq!(number(text, "R1"), 1034.0);
}

// oracle: manual (Job planning, system variables: whether the call programs parameter n of the subprogram)
#[test]
fn a_program_asks_which_parameters_its_call_gives() {
    let part = "M30\n%_N_PART_SPF\nPROC PART(REAL A,VAR REAL B,REAL C=4)\n\
        R1=100*$P_SUBPAR[1]+10*$P_SUBPAR[2]+$P_SUBPAR[3]\n\
        IF NOT $P_SUBPAR[1] AND (R9==0)\nR9=1\nPART(1)\nENDIF\nR2=R1\nRET";
    for (call, given) in [("PART(1,R5,0)", 111.0), ("PART(0)", 100.0), ("R9=1\nPART(,R5)", 10.0), ("R9=1\nPART", 0.0)] {
        assert_eq!(number(&format!("{call}\n{part}"), "R2"), given, "{call}");
    }
    // each level its own
    assert_eq!(number(&format!("PART(,,5)\n{part}").replace("R2=R1", "R2=$P_SUBPAR[3]"), "R2"), 1.0);
}

/// A program with these blocks, and one that it calls.
fn with_return(main: &str, back: &str) -> String {
    format!("{main}\nM30\n%_N_BACK_SPF\nPROC BACK\n{back}\n")
}

// oracle: manual (Job planning, parameterizable subprogram return: the label is looked for behind the call, then before
// it; with the second parameter behind it; the third counts program levels)
#[test]
fn a_program_goes_back_to_a_label_of_its_caller() {
    let there = "BACK\nR1=R1+1\nN50 THERE: R1=R1+10\nR1=R1+100";
    for (main, back, expected) in [
        (there, "RET", 111.0),
        (there, "RET()", 111.0),
        (there, "RET(\"THERE\")", 110.0),
        (there, "ret (\"there\")", 110.0),
        (there, "RET(\"N50\")", 110.0),
        (there, "RET(\"TH\"<<\"ERE\",0)", 110.0),
        (there, "RET(\"THERE\",1)", 100.0),
        (there, "IF R1==0\nRET(\"THERE\",,1)\nENDIF\nR1=7", 110.0),
        ("THERE: R1=R1+1\nIF R1>2 GOTOF DONE\nBACK\nDONE:", "RET(\"THERE\")", 3.0),
        ("GOTOF GO\nTHERE: R1=1\nM30\nGO: BACK\nM30\nTHERE: R1=2", "RET(\"THERE\")", 2.0),
        ("BACK P3\nR1=R1+1\nTHERE:", "R1=R1+5\nRET(\"THERE\")", 5.0),
        ("PART: BACK\nREPEATB PART P=2\nR1=R1+1", "R1=R1+10\nRET(,,1)", 31.0),
    ] {
        assert_eq!(number(&with_return(main, back), "R1"), expected, "{main} {back}");
    }
    let outer = "OUTER\nR1=R1+1\nTHERE: R1=R1+10";
    for (back, expected) in [
        ("RET", 1011.0),
        ("RET(,,1)", 1011.0),
        ("RET(,,2)", 11.0),
        ("RET(\"THERE\",,2)", 10.0),
        ("RET(\"HERE\")", 5011.0),
    ] {
        let text = with_return(outer, back) + "%_N_OUTER_SPF\nBACK\nR1=R1+1000\nRET\nHERE: R1=5000\nRET";
        assert_eq!(number(&text, "R1"), expected, "{back}");
    }
    for (back, key) in [
        ("RET(\"NOWHERE\")", "run-label"),
        ("RET(,,2)", "run-range"),
        ("RET(,,0)", "run-range"),
        ("RET(,,,1)", "run-not-simulated"),
        ("RET(,,,,1)", "run-function"),
        ("RET(,\"A\")", "run-not-a-number"),
    ] {
        assert_eq!(fault(&with_return(there, back)), key, "{back}");
    }
}

// oracle: hand
#[test]
fn variables_belong_to_their_program() {
    let text =
        "DEF INT COUNT=5\nR1=7\nINNER\nR2=COUNT\nM30\n%_N_INNER_SPF\nDEF INT COUNT=1\nCOUNT=COUNT+1 R1=R1+COUNT\nM17";
    assert_eq!((number(text, "R1"), number(text, "R2")), (9.0, 5.0));
    assert_eq!(fault("DEF INT OUTER=1\nSUB\nM30\n%_N_SUB_SPF\nR1=OUTER\nM17"), "run-unknown-variable");
    let shared = "DEF CHAN REAL ALL=1\nSUB\nR1=ALL\nM30\n%_N_SUB_SPF\nALL=ALL+1\nM17";
    assert_eq!(number(shared, "R1"), 2.0);
}

// oracle: hand: a program that calls itself has its own variables each time
#[test]
fn recursion_works_down_to_its_end() {
    let text = "DEF REAL N\nFACTORIAL(5,N)\nR1=N\nM30\n%_N_FACTORIAL_SPF\nPROC FACTORIAL(INT N, VAR REAL RESULT)\n\
        DEF REAL BEFORE\nIF N<2\nRESULT=1\nRET\nENDIF\nFACTORIAL(N-1,BEFORE)\nRESULT=N*BEFORE\nRET";
    assert_eq!(number(text, "R1"), 120.0);
}

// oracle: hand
#[test]
fn whole_arrays_are_parameters() {
    let by_reference = "DEF REAL F[3]=(1,2,3)\nSUM(F,3)\nR1=F[0]\nM30\n%_N_SUM_SPF\nPROC SUM(VAR REAL LIST[3],INT N)\n\
        DEF INT I\nFOR I=1 TO N-1\nLIST[0]=LIST[0]+LIST[I]\nENDFOR\nRET";
    assert_eq!(number(by_reference, "R1"), 6.0);
    for size in ["[]", "[ ]", "[3]"] {
        assert_eq!(number(&by_reference.replace("LIST[3]", &format!("LIST{size}")), "R1"), 6.0);
        let by_value = format!("DEF REAL F[3]=(1,2,3)\nREAD(F)\nM30\nPROC READ(REAL G{size})\nR1=G[0]+G[2]\nRET");
        assert_eq!(number(&by_value, "R1"), 4.0, "{size}");
    }
    let by_value = "DEF REAL F[2,2]=(1,2,3,4)\nREAD(F)\nR2=F[1,1]\nM30\n%_N_READ_SPF\nPROC READ(REAL G[2,2])\n\
        R1=G[1,0]\nG[1,1]=0\nRET";
    assert_eq!((number(by_value, "R1"), number(by_value, "R2")), (3.0, 4.0));
}

// oracle: hand
#[test]
fn a_call_may_ask_for_several_passes() {
    assert_eq!(number("L10 P3\nM30\n%_N_L10_SPF\nR1=R1+1\nM17", "R1"), 3.0);
    assert_eq!(number("L10 P0\nM30\n%_N_L10_SPF\nR1=R1+1\nM17", "R1"), 0.0);
    assert_eq!(number("CALL \"L10\"\nM30\n%_N_L10_SPF\nR1=R1+1\nM17", "R1"), 1.0);
    let named = "DEF STRING[9] WHICH=\"L10\"\nCALL WHICH\nM30\n%_N_L10_SPF\nR1=R1+1\nM17";
    assert_eq!(number(named, "R1"), 1.0);
}

// oracle: hand: SAVE brings back what was active at the call
#[test]
fn save_restores_the_modal_functions() {
    let called = |attributes: &str| {
        let text = format!("G90 G0 X10\nSUB\nX5\nR1=$AA_IW[X]\nM30\n%_N_SUB_SPF\nPROC SUB {attributes}\nG91\nRET");
        number(&text, "R1")
    };
    assert_eq!((called("SAVE"), called("DISPLOF")), (5.0, 15.0));
}

// oracle: manual (MD20800: M2 and M30 are ends of a subprogram like M17)
#[test]
fn each_end_of_a_subprogram_goes_back() {
    for end in ["M17", "RET", "M2", "M30", "M02", ""] {
        let text = format!("SUB P2\nR1=R1+10\nM30\n%_N_SUB_SPF\nR1=R1+1\n{end}");
        assert_eq!(number(&text, "R1"), 12.0, "{end}");
    }
}

// oracle: hand
#[test]
fn jumps_stay_in_their_program() {
    let text = "SUB\nTHERE: R1=R1+10\nM30\n%_N_SUB_SPF\nGOTOF THERE\nR1=99\nTHERE: R1=R1+1\nM17";
    assert_eq!(number(text, "R1"), 11.0);
    assert_eq!(fault("SUB\nTHERE: M30\n%_N_SUB_SPF\nGOTO THERE\nM17"), "run-label");
}

// oracle: hand
#[test]
fn what_does_not_fit_is_told() {
    assert_eq!(fault("SUB(1,2)\nM30\n%_N_SUB_SPF\nPROC SUB(REAL A)\nRET"), "run-arguments");
    assert_eq!(fault("SUB(1)\nM30\n%_N_SUB_SPF\nPROC SUB(VAR REAL A)\nRET"), "run-argument");
    assert_eq!(fault("SUB(\"A\")\nM30\n%_N_SUB_SPF\nPROC SUB(REAL A)\nRET"), "run-argument");
    assert_eq!(findings("EXTERN AWAY(REAL)\nAWAY(1)\nM30"), ["run-subprogram"]);
    assert_eq!(fault("SUB\nM30\n%_N_SUB_SPF\nSUB"), "run-depth");
}

// oracle: hand: rows of 1, 2 and 3 steps of 2.5 mm; R1 and R2 after three passes of the part
#[test]
fn a_program_with_a_bit_of_everything_runs() {
    let outcome = clean(include_str!("../programs/subprograms.mpf"));
    let numbers = ["R1", "R2"].map(|name| outcome.control.number(name));
    assert_eq!(numbers, [3.0, 6.0]);
    let texts = outcome.trace.entries.others().rev();
    let mut texts = texts.filter_map(|entry| match entry.step {
        Step::Message { text, .. } => Some(text.as_str()),
        _ => None,
    });
    assert_eq!(texts.next(), Some("GRID of 15 mm, 2"));
}
