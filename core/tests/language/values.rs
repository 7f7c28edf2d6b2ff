//! Variables of all types, conversions, operators and functions.

use super::{clean, fault, findings, go, messages, near, number};
use probewright_core::diagnostic::Code;
use probewright_core::machine::Stop;

// oracle: manual (Job planning 03/2006, 1.9: conversions at an assignment; the types of the user data: B:1758 …)
#[test]
fn a_user_datum_keeps_its_type() {
    for (text, expected) in [
        ("_KNUM=7/4\nR1=_KNUM", 2.0),
        ("_OVI[0]=2.5\nR1=_OVI[0]", 3.0),
        ("_MVAR=R5+0.7\nCASE _MVAR OF 1 GOTOF ONE DEFAULT GOTOF OTHER\nOTHER: M30\nONE: R1=4", 4.0),
        ("_CBIT[3]=4\nR1=_CBIT[3]", 1.0),
        ("_CHBIT[2]=0.3\nIF _CHBIT[2]==1\nR1=5\nENDIF", 5.0),
        ("_CHBIT[2]=TRUE\nR1=_CHBIT[2]", 1.0),
        ("_SETVAL=7/4\nR1=_SETVAL", 1.75),
        ("$AC_MARKER[1]=7/2\nR1=2*$AC_MARKER[1]", 8.0),
    ] {
        near(number(text, "R1"), expected, text);
    }
    assert_eq!(fault("_KNUM=3000000000"), "run-range");
}

// oracle: manual (Job planning 03/2006, 1.9: conversions at an assignment)
#[test]
fn a_variable_keeps_its_type() {
    for (text, expected) in [
        ("DEF INT I\nI=2.5\nR1=I", 3.0),
        ("DEF INT I=2.4\nR1=I", 2.0),
        ("DEF BOOL SO\nSO=0.3\nR1=SO", 1.0),
        ("DEF BOOL SO\nSO=\"\"\nR1=SO", 0.0),
        ("DEF CHAR C=65\nR1=C+1", 66.0),
        ("DEF CHAR C='A'\nR1=C", 65.0),
        ("DEF CHAR C='A'\nR1=C==\"A\"", 1.0),
        ("DEF REAL ONE=1,THREE=3\nR1=ONE/THREE*3", 1.0),
        ("DEF AXIS WHICH=Y\nG0 X1 Y2 Z3\nR1=$AA_IW[WHICH]", 2.0),
        ("DEF AXIS WHICH=Y\nR1=WHICH==Y", 1.0),
        ("DEF FRAME F=CTRANS(X,5)\nF[Y,TR]=7\nR1=F[X,TR]+F[Y,TR]", 12.0),
        ("DEF FRAME F\nF=CTRANS(X,5):CROT(Z,90)\n$P_UIFR[1]=F\nG54\nG0 X1 Y0\nR1=$AA_IM[Y]", 1.0),
    ] {
        near(number(text, "R1"), expected, text);
    }
    for (text, key) in [
        ("DEF INT I\nI=3000000000", "run-range"),
        ("DEF REAL IT\nIT=\"1\"", "run-type"),
        ("DEF STRING[3] T\nT=\"ABCD\"", "run-text-long"),
        ("DEF STRING[3] T\nT=1", "run-type"),
        ("DEF FRAME F\nF=1", "run-type"),
        ("R1=\"5\"", "run-type"),
        ("_SETV[0]=1<<\"\"", "run-type"),
        ("DEF REAL A[2]\nA[2]=1", "run-index"),
        ("R1=1EX300*1EX300", "run-range"),
    ] {
        assert_eq!(fault(text), key, "{text}");
    }
    assert_eq!(findings("DEF INT A\nDEF INT A"), ["run-declared-twice"]);
    let beside = "R1=_SPEED[1]\nM30\n%_N_GUD6_DEF\nDEF CHAN REAL _SPEED[4]=(10,20,30,40)\nM17";
    assert_eq!(findings(beside), ["defined-here"]);
}

// oracle: hand
#[test]
fn a_fault_names_what_is_written() {
    for (text, key, word) in [
        ("R1=ATAN2(1,)", "run-not-a-number", "ATAN2"),
        ("R1=_OVR[,1]", "run-not-a-number", "_OVR"),
        ("R1=2*(1EX300*1EX300)", "run-range", "1EX300*1EX300"),
        ("R1=(1EX300+1)*ABS(1EX300)", "run-range", "(1EX300+1)*ABS(1EX300)"),
    ] {
        let Some(Stop::Fault(message)) = go(text).stop else { panic!("{text}") };
        assert_eq!((&*message.key, message.word("word")), (key, Some(word)), "{text}");
    }
}

// oracle: hand
#[test]
fn arrays_are_set_and_repeated() {
    for (text, expected) in [
        ("DEF REAL F[2,3]=SET(1,,3)\nR1=F[0,0]+10*F[0,1]+100*F[0,2]", 301.0),
        ("DEF REAL F[2,3]=REP(4)\nR1=F[1,2]", 4.0),
        ("DEF REAL F[5]\nF[1]=REP(2,3)\nR1=F[0]+F[1]+F[3]+F[4]", 4.0),
        ("DEF INT F[3]=(1.6,2)\nR1=10*F[0]+F[1]", 22.0),
        ("DEF REAL F[2,2,2]\nF[1,0,1]=SET(5,6)\nR1=10*F[1,0,1]+F[1,1,0]", 56.0),
        ("DEF STRING[4] T[2]=SET(\"AB\",\"CD\")\nR1=STRLEN(T[0]<<T[1])", 4.0),
    ] {
        assert_eq!(number(text, "R1"), expected, "{text}");
    }
}

// oracle: manual (Job planning 03/2006, 1.7: equal to 10^-12 of the value, its own example included)
#[test]
fn almost_equal_numbers_are_equal() {
    for (expression, expected) in [
        ("0.1+0.2==0.3", 1.0),
        ("0.1+0.2<>0.3", 0.0),
        ("0.1+0.2<=0.3", 1.0),
        ("0.1+0.2>0.3", 0.0),
        ("ABS(61.02-61.01)>0.01", 0.0),
        ("1.00000000001==1", 0.0),
        ("2>1", 1.0),
        ("0==0", 1.0),
    ] {
        assert_eq!(number(&format!("R1={expression}"), "R1"), expected, "{expression}");
    }
}

// oracle: manual (Job planning 03/2006: priorities 1.7, ROUNDUP 1.24), else hand
#[test]
fn operators_and_functions_are_worked_out() {
    for (expression, expected) in [
        ("7 DIV 4.1", 1.0),
        ("7 MOD 4.1", 2.9),
        ("2*-3", -6.0),
        ("1+1-1+-1", 0.0),
        ("NOT 0 AND 1", 1.0),
        ("5 B_OR 2 B_AND 6", 7.0),
        ("B_NOT 5", -6.0),
        ("'B101'+'HF'", 20.0),
        ("ROUNDUP(3.1)", 4.0),
        ("ROUNDUP(-3.1)", -3.0),
        ("ROUND(-2.4)", -2.0),
        ("TRUNC(-2.7)", -2.0),
        ("ASIN(0.5)", 30.0),
        ("ROUND(ATAN2(30.5,80.1)*10000)", 208_455.0),
        ("ATAN2(1,-1)", 135.0),
        ("LN(EXP(2))", 2.0),
        ("SQRT(POT(3)+POT(4))", 5.0),
        ("TAN(45)", 1.0),
        ("MINVAL(2,-1)+MAXVAL(2,-1)*10", 19.0),
        ("BOUND(0,5,7)", 5.0),
    ] {
        near(number(&format!("R1={expression}"), "R1"), expected, expression);
    }
    for text in ["R1=SQRT(-1)", "R1=LN(0)", "R1=ASIN(2)", "R1=BOUND(5,0,1)", "R1=SIN(\"A\")"] {
        assert_eq!(fault(text), "run-function", "{text}");
    }
    assert_eq!(fault("R1=NOSUCH(1)"), "run-unknown-word");
}

// oracle: manual (Job planning, string operations: places count from 0, -1 where nothing is found)
#[test]
fn texts_are_joined_and_searched() {
    for (expression, expected) in [
        ("STRLEN(\"AB\"<<12)", 4.0),
        ("INDEX(\"CONTENT\",\"N\")", 2.0),
        ("RINDEX(\"CONTENT\",\"N\")", 5.0),
        ("INDEX(\"CONTENT\",\"X\")", -1.0),
        ("MINDEX(\"CONTENT\",\"TE\")", 3.0),
        ("MATCH(\"CONTENT\",\"TENT\")", 3.0),
        ("NUMBER(\"-1.5\")", -1.5),
        ("ISNUMBER(\"1A\")", 0.0),
        ("ISNUMBER(\"1234.9876Ex-7\")", 1.0),
        ("NUMBER(\"1.5EX2\")", 150.0),
        ("NUMBER(\"-2ex+1\")", -20.0),
        ("ISNUMBER(\"1EX\")", 0.0),
        ("SUBSTR(\"CONTENT\",3,2)==\"TE\"", 1.0),
        ("SUBSTR(\"CONTENT\",4)==\"ENT\"", 1.0),
        ("TOUPPER(\"ab\")==\"AB\"", 1.0),
    ] {
        assert_eq!(number(&format!("R1={expression}"), "R1"), expected, "{expression}");
    }
    let text = "DEF STRING[9] T=\"ABC\"\nDEF CHAR C='!'\nT[1]='X'\n\
        MSG(\"<\"<<T<<\">\"<<T[0]<<C<<1.50<<\" \"<<0.1+0.2<<\" \"<<AXNAME(\"Y\"))";
    assert_eq!(messages(text), ["<AXC>A!1.5 0.3 Y"]);
}

// oracle: hand: a name that looks like an address is a variable once it is declared, but never that of an axis
#[test]
fn a_variable_may_look_like_an_address() {
    for (text, expected) in [
        ("DEF INT A1=5\nA1=A1+1\nR1=A1", 6.0),
        ("DEF REAL S1=5\nS1=7\nR1=S1", 7.0),
        ("DEF REAL T1[3]\nT1[2]=7\nR1=T1[2]", 7.0),
        ("DEF FRAME F1=CTRANS(X,1)\nF1[X,TR]=2\nR1=F1[X,TR]", 2.0),
        ("DEF CHAR E1\nE1=\"B\"\nR1=E1", 66.0),
        ("DEF REAL A,U\nA=3 U=4\nR1=A*U", 12.0),
        ("TAKE(R1)\nM30\nPROC TAKE(VAR REAL A)\nA=42\nRET", 42.0),
    ] {
        assert_eq!(number(text, "R1"), expected, "{text}");
    }
    for text in ["DEF REAL X", "G0 X1\nDEF INT _A,Z=3", "PUT(1)\nM30\nPROC PUT(REAL Y)\nRET"] {
        assert_eq!(fault(text), "run-axis-name", "{text}");
    }
    // the machine has an axis C, which stays where it is
    let outcome = go("DEF REAL C\nC=42\nR1=C");
    assert_eq!(outcome.diagnostics[0].message.key, "run-axis-variable");
    assert_eq!((outcome.control.number("R1"), outcome.control.rotary[2].0), (42.0, 0.0));
}

// oracle: hand: what the control tells about tools, spindle and probe, and what it lets a program keep
#[test]
fn the_control_tells_about_itself() {
    for (expression, expected) in [
        ("GETT(\"mill\",1)", 20.0),
        ("GETT(\"NOBODY\")", -1.0),
        ("$P_TOOLEXIST[20]+10*$P_TOOLEXIST[77]", 1.0),
        ("$P_TOOLND[20]", 2.0),
        ("$TC_TP2[20]==\"MILL\"", 1.0),
        ("$P_AD[3]", 50.0),
        ("$P_MSNUM", 1.0),
        ("$A_PROBE[1]", 0.0),
        ("$P_CHBFRMASK", 0.0),
        ("$P_AXN2==Y", 1.0),
        ("$VA_IM[Z]", 50.0),
    ] {
        assert_eq!(number(&format!("R1={expression}"), "R1"), expected, "{expression}");
    }
    assert_eq!(number("S500 M4\nR1=$AA_S[1]*10+$P_SDIR[1]", "R1"), 5004.0);
    assert_eq!(number("G55\nR1=$P_GG[8]", "R1"), 3.0);
    assert_eq!(number("$AC_MARKER[1]=3\n$AC_PARAM[0]=$AC_MARKER[1]+0.5\nR1=$AC_PARAM[0]", "R1"), 3.5);
    assert_eq!(messages("MSG(123456789.123<<\" \"<<1/3<<\" \"<<-0.0<<\" \"<<20)"), ["123456789.123 0.3333333333 0 20"]);
}

// oracle: hand
#[test]
fn names_do_not_know_upper_and_lower_case() {
    assert_eq!(number("DEF REAL lAyEr=2.5\nr1=LAYER*4\nR2=R1", "R2"), 10.0);
    assert_eq!(clean("def int i\nfor i=1 to 3\nr1=r1+i\nendfor").control.number("R1"), 6.0);
}

// oracle: manual (Fundamentals 10.2004, p. 2-15: leading zeroes are ignored in variables with numeric extensions)
#[test]
fn leading_zeroes_of_a_variable_are_ignored() {
    for (text, expected) in [
        ("R01=10 R02=20\nR03=R01+R02\nR4=R3", 30.0),
        ("R1=5\nR4=R0001*2", 10.0),
        ("R[03]=7\nR4=R03", 7.0),
        ("R01=3\nIF R1==3\nR04=1\nENDIF", 1.0),
        ("FOR R01=1 TO 3\nR4=R4+R1\nENDFOR", 6.0),
        ("R1=1\nWAY(R01)\nR4=R1\nM30\n%_N_WAY_SPF\nPROC WAY(VAR REAL GIVEN)\nGIVEN=GIVEN+7\nRET", 8.0),
        ("R04=ISVAR(\"R01\")", 1.0),
        ("R00=4\nR4=R0", 4.0),
    ] {
        near(number(text, "R4"), expected, text);
    }
}

// oracle: manual B:828, B:974-985 (L1 along the applicate; with 2 along the ordinate)
#[test]
fn a_program_chooses_how_long_its_tools_are() {
    let text = "T20 M6 D1\nR1=$SC_TOOL_LENGTH_TYPE\nR2=$AA_IB[Y]\n$SC_TOOL_LENGTH_TYPE=2\nR3=$SC_TOOL_LENGTH_TYPE\n\
        R4=$AA_IB[Y]";
    let control = clean(text).control;
    let read = |name: &str| control.number(name);
    assert_eq!((read("R1"), read("R3")), (0.0, 2.0));
    assert_eq!(read("R4") - read("R2"), -80.0, "T20 is 80 mm long");
}

// oracle: manual (Job planning: `G[group]=number` selects the function that `$P_GG[group]` names)
#[test]
fn a_function_is_selected_by_its_group() {
    let text = "$P_UIFR[2]=CTRANS(X,20)\n$P_UIFR[6]=CTRANS(X,60)\n";
    for (selected, written) in [
        ("G[8]=3\nG0 X1", "G55\nG0 X1"),
        ("R5=6 G[8]=R5+1\nG0 X1", "G506\nG0 X1"),
        ("G55\nG[8]=1\nG0 X1", "G500\nG0 X1"),
        ("G0 X5\nG[14]=2 X1", "G0 X5\nG91 X1"),
        ("G[6]=2\nR1=$P_GG[6]\nG0 X=R1", "G18\nG0 X2"),
        ("G[1]=2 F77 X3\nG[13]=3\nG[1]=1 X1", "G1 F77 X3\nG700 G0 X1"),
    ] {
        let run = |blocks: &str| clean(&format!("{text}{blocks}")).position;
        assert_eq!(run(selected), run(written), "{selected}");
    }
    assert_eq!(findings("G[99]=1"), ["run-passed"]);
}

// oracle: hand: a letter with a number and no `=` is the address, whatever a program declared; the declaration is told
#[test]
fn a_variable_with_the_name_of_an_address_hides_no_function() {
    for (text, told) in [
        ("DEF REAL M[3]\nM[1]=2\nG0 X5\nM30\nG0 X7", "M"),
        ("DEF REAL M\nM=2\nG0 X5\nM30\nG0 X7", "M"),
        ("DEF INT F=1\nF=F+1\nG1 F100 X5", "F"),
        ("DEF INT G\nG=90\nF100\nG1\nX5", "G"),
    ] {
        let outcome = go(text);
        let told_of: Vec<_> =
            outcome.diagnostics.iter().map(|found| (found.code, found.message.word("word"))).collect();
        assert_eq!(told_of, [(Code::Own(244), Some(told))], "{text}");
        let place = outcome.diagnostics[0].span.unwrap();
        assert_eq!(place.start as usize, text.find(&format!(" {told}")).unwrap() + 1, "{text}");
        assert_eq!((outcome.stop, outcome.position.0[0]), (None, 5.0), "{text}");
    }
}

// oracle: hand: what is known and does not take these values, what is known and not computed, what nobody knows
#[test]
fn a_function_is_told_for_what_it_is() {
    for (text, key) in [
        ("R1=REPLACE(\"a\",\"b\",\"c\")", "run-unknown-word"),
        ("R1=FOO(X)", "run-unknown-word"),
        ("R1=FOO(1)", "run-unknown-word"),
        ("R1=SIN(1,2)", "run-function"),
        ("R1=SIN(X)", "run-function"),
        ("R1=STRLEN(5)", "run-function"),
        ("R1=CALCDAT(1)", "run-function"),
        ("R1=MODAXVAL(X,5)", "run-function"),
        ("G0 X=INTERSEC(1,2,3)", "run-not-simulated"),
        ("IF AXTOINT(Y)==2 GOTOF OUT\nOUT: M30", "run-not-simulated"),
        ("R1=INTERSEC(1,2,3)\nR2=R1", "run-unread-value"),
        ("R1=AXTOINT(Y)\nIF R1==2\nENDIF", "run-unread-value"),
        ("DEF REAL PAIR[2]\nR1=INTERSEC(1,2,PAIR)\nR2=PAIR[0]", "run-unread-value"),
        ("DEF REAL PAIR[2]\nINTERSEC(1,2,PAIR)\nR2=PAIR[1]", "run-unread-value"),
    ] {
        assert_eq!(fault(text), key, "{text}");
    }
    let text = "R1=INTERSEC(1,2,3)\nR2=GETTCOR(_OVR)\nR1=7\nR3=R1";
    assert_eq!(findings(text), ["run-passed"]);
    assert_eq!(go(text).control.number("R3"), 7.0);
}

// oracle: hand: the remainder within a turn; 180° of MD 30330 from -90° on as the setup says
#[test]
fn a_position_is_brought_into_its_modulo_range() {
    for (text, expected) in [
        ("R1=MODAXVAL(B,370)", 10.0),
        ("R1=MODAXVAL(C,-10)", 350.0),
        ("R1=MODAXVAL(A,360)", 0.0),
        ("R1=MODAXVAL(B,725.5)", 5.5),
        ("$MA_MODULO_RANGE[B]=180 $MA_MODULO_RANGE_START[B]=-90\nR1=MODAXVAL(B,100)", -80.0),
    ] {
        near(number(text, "R1"), expected, text);
    }
}

// oracle: hand: 3-4-5 about (1,2); the centre of four points at the corners of a rectangle; three points in a line
#[test]
fn a_circle_goes_through_the_points_of_an_array() {
    let text = "DEF REAL PTS[4,2]=SET(6,2,1,7,-4,2,1,-3), RES[3]\nDEF BOOL OK\nOK=CALCDAT(PTS,3,RES)\n\
        R1=OK R2=RES[0] R3=RES[1] R4=RES[2]\nPTS[0,0]=SET(8,6,-6,6,-6,-6,8,-6)\nR5=CALCDAT(PTS,4,RES)\n\
        R6=RES[0] R7=RES[1] R8=RES[2]\nPTS[0,0]=SET(0,0,1,1,2,2)\nR9=CALCDAT(PTS,3,RES)\nR10=RES[0]";
    let outcome = clean(text);
    for (at, expected) in [1.0, 1.0, 2.0, 5.0, 1.0, 1.0, 0.0, 85.0_f64.sqrt(), 0.0, 1.0].into_iter().enumerate() {
        near(outcome.control.number(&format!("R{}", at + 1)), expected, &format!("R{}", at + 1));
    }
    for text in ["R1=CALCDAT(PTS,2,RES)", "R1=CALCDAT(PTS,4,RES)", "R1=CALCDAT(PTS,3,5)", "R1=CALCDAT(PTS,3)"] {
        assert_eq!(fault(&format!("DEF REAL PTS[3,2],RES[3]\n{text}")), "run-function", "{text}");
    }
}
