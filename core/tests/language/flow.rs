//! Repeated program parts, labels and jumps.

use super::{fault, go, number};

// oracle: manual (Job planning: label, label and end label, single block, ENDLABEL)
#[test]
fn program_parts_are_repeated() {
    for (text, expected) in [
        ("PART: R1=R1+1\nR1=R1+10\nREPEAT PART P=2\nM30", 33.0),
        ("PART: R1=R1+1\nR1=R1+10\nREPEAT PART\nM30", 22.0),
        ("FIRST: R1=R1+1\nLAST: R1=R1+10\nR1=R1+100\nREPEAT FIRST LAST P=2\nM30", 133.0),
        ("R1=R1+100\nONE: R1=R1+1\nR1=R1+10\nREPEATB ONE P=3\nM30", 114.0),
        ("PART: R1=R1+1\nENDLABEL: R1=R1+10\nR1=R1+100\nREPEAT PART P=1\nM30", 122.0),
        ("REPEAT LATER P=2\nM30\nLATER: R1=R1+1\nENDLABEL: R1=R1+10\nM30", 22.0),
        ("PART: R1=R1+1\nREPEAT PART P=0\nM30", 1.0),
        // a repetition inside of one
        ("OUTER: R1=R1+1\nINNER: R2=R2+1\nREPEATB INNER P=2\nREPEAT OUTER P=1\nR1=100*R1+R2\nM30", 206.0),
        // the part calls a program
        ("PART: L10\nREPEAT PART P=2\nM30\n%_N_L10_SPF\nR1=R1+1\nM17", 3.0),
        // a jump out of it ends it
        ("PART: R1=R1+1\nIF R1==3 GOTOF OUT\nREPEAT PART P=9\nOUT: R2=0\nM30", 3.0),
    ] {
        assert_eq!(number(text, "R1"), expected, "{text}");
    }
    assert_eq!(fault("REPEAT NOWHERE P=2\nM30"), "run-label");
    assert_eq!(fault("PART: R1=1\nREPEAT PART P=-1"), "run-range");
    assert_eq!(fault("PART: R1=1\nREPEAT PART LAST\nLAST: M30"), "run-depth");
}

// oracle: manual (Job planning: GOTO looks forward first, GOTOC needs no target)
#[test]
fn jumps_look_where_they_should() {
    for (text, expected) in [
        ("GOTOF A\nR1=1\nA: R1=R1+2\nM30", 2.0),
        ("R1=R1+1\nB: R1=R1+1\nIF R1<5 GOTOB B\nM30", 5.0),
        ("A: R1=R1+1\nIF R1>3 GOTOF OUT\nGOTO A\nA: R1=R1+10\nOUT: M30", 11.0),
        ("GOTOC NOWHERE\nR1=4\nM30", 4.0),
        ("GOTOF 50\nR1=9\nN50 R1=R1+1\nM30", 1.0),
        ("DEF STRING[8] WHERE=\"C\"\nGOTOF WHERE\nR1=9\nC: R1=R1+1\nM30", 1.0),
    ] {
        assert_eq!(number(text, "R1"), expected, "{text}");
    }
    assert_eq!(fault("A: R1=1\nGOTOF A"), "run-label");
}

// oracle: hand
#[test]
fn a_case_may_compare_texts_and_fall_through() {
    let case = |value: &str| {
        format!(
            "DEF STRING[4] T={value}\nCASE(T) OF \"A\" GOTOF ONE \"B\" GOTOF TWO\nR1=3\nM30\nONE: R1=1\nM30\n\
                TWO: R1=2\nM30"
        )
    };
    for (value, expected) in [("\"A\"", 1.0), ("\"B\"", 2.0), ("\"C\"", 3.0)] {
        assert_eq!(number(&case(value), "R1"), expected, "{value}");
    }
}

// oracle: hand: behind the word of a structure that is left by a jump nothing may stand, as it would be passed over
#[test]
fn what_shares_a_block_with_a_structure_is_never_passed_over() {
    for (text, word) in [
        ("IF R1==1\nR2=1\nELSE R2=2\nENDIF", "R2=2"),
        ("IF R1==0\nR2=1\nELSE R2=2\nENDIF", "R2=2"),
        ("IF R1==1\nR2=1\nENDIF R2=2", "R2=2"),
        ("WHILE R1<2\nR1=R1+1\nENDWHILE R2=2", "R2=2"),
        ("FOR R1=2 TO 1\nENDFOR R2=2", "R2=2"),
        ("FOR R1=1 TO 3 R2=R2+1\nENDFOR", "R2=R2+1"),
        ("PART: R1=R1+1\nR2=2 REPEAT PART P=2", "R2=2"),
        ("PART: R1=R1+1\nX5 REPEATB PART", "X5"),
    ] {
        let outcome = go(text);
        let found = &outcome.diagnostics[0];
        assert_eq!(found.message.key, "run-alone", "{text}");
        let place = found.span.unwrap();
        assert_eq!(&text[place.start as usize..place.end as usize], word, "{text}");
    }
    for text in [
        "IF R1==0 R1=3\nENDIF",
        "WHILE R1<3 R1=R1+1\nENDWHILE",
        "LOOP R1=R1+1\nIF R1==3 GOTOF OUT\nENDLOOP\nOUT:",
        "N10 FOR R2=1 TO 3 ; three\nR1=R1+1\nN30 ENDFOR",
        "REPEAT\nR1=R1+1\nUNTIL R1==3",
    ] {
        assert_eq!(number(text, "R1"), 3.0, "{text}");
    }
}

// oracle: hand: what a block calls comes before its M30 or M17
#[test]
fn a_block_calls_before_it_ends() {
    assert_eq!(super::messages("MSG(\"A\") M30\nMSG(\"B\")"), ["A"]);
    let back = "SUB\nM30\n%_N_SUB_SPF\nMSG(\"A\") M17\nMSG(\"B\")";
    assert_eq!(super::messages(back), ["A"]);
    assert_eq!(fault("SUB M30\n%_N_SUB_SPF\nM17"), "run-alone");
}

// oracle: hand
#[test]
fn loops_nest() {
    let text = "DEF INT I,J\nFOR I=1 TO 3\nFOR J=I TO 3\nR1=R1+1\nENDFOR\nENDFOR\nWHILE R2<4\nR2=R2+1\nREPEAT\n\
        R3=R3+1\nUNTIL R3>=R2\nENDWHILE\nM30";
    assert_eq!(number(text, "R1"), 6.0);
    assert_eq!(number(text, "R3"), 4.0);
}
