#![allow(clippy::unwrap_used)]
use super::*;
use crate::dialect::Dialect;
use crate::entry::names;
use crate::program::change::apply;
use crate::syntax::programs::programs;
use crate::syntax::read;
use crate::test_data::data;

/// The program with the names of today; empty: it is not converted.
fn converted(text: &str, answers: &[(u16, Name)]) -> String {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let older = find(&program, &programs(&program), &answers.iter().copied().collect());
    match edits(&program, &older) {
        edits if edits.is_empty() => String::new(),
        edits => String::from_utf8(apply(text.as_bytes(), &edits)).unwrap(),
    }
}

/// What is said: number of the finding, key, place, and the text that its cure would make.
fn told(text: &str) -> Vec<(String, String, String)> {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let mut found = Vec::new();
    let programs = programs(&program);
    findings(&program, &programs, &find(&program, &programs, &Answers::new()), &mut found);
    let one = |one: &crate::diagnostic::Diagnostic| {
        let cured = one.cure.as_ref().map(|cure| String::from_utf8(apply(text.as_bytes(), &cure.edits)).unwrap());
        (one.message.key.to_string(), program.written(one.span.unwrap()), cured.unwrap_or_default())
    };
    found.iter().map(one).filter(|(key, ..)| key != "older-missing").collect()
}

/// The cycles for which a question is open, a question each.
fn asked_of(text: &str) -> Vec<String> {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let programs = programs(&program);
    let mut found = Vec::new();
    findings(&program, &programs, &find(&program, &programs, &Answers::new()), &mut found);
    let open = found.iter().filter(|one| one.message.key.starts_with("older-open"));
    open.map(|one| one.message.word("cycles").unwrap().to_owned()).collect()
}

/// What is missing at the calls, and the program with it.
fn completed(text: &str) -> Vec<(String, String)> {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let mut found = Vec::new();
    let programs = programs(&program);
    findings(&program, &programs, &find(&program, &programs, &Answers::new()), &mut found);
    let missing = found.into_iter().filter(|one| one.message.key == "older-missing");
    let cured = |one: crate::diagnostic::Diagnostic| {
        let edits = one.cure.unwrap().edits;
        (one.message.word("names").unwrap().to_owned(), String::from_utf8(apply(text.as_bytes(), &edits)).unwrap())
    };
    missing.map(cured).collect()
}

// oracle: manual B:1696 (values of an earlier call stay), A:16313-16340 (R25 _VMS, R27 _NMSP, R36 _TSA)
#[test]
fn what_a_call_leaves_out_is_told_and_completed() {
    let text = "R23=100 R10=1 R22=1 R28=2 R30=1 R32=80 R25=0 R36=1\nL978\n";
    let all = completed(text);
    assert_eq!(all.len(), 1, "one call lacks something");
    let (names, cured) = &all[0];
    assert!(names.contains("R27 (_NMSP=1)"), "{names}");
    assert!(!names.contains("_VMS") && !names.contains("_TSA"), "{names}");
    assert!(cured.contains("R27=1") && cured.starts_with(text.lines().next().unwrap()), "{cured}");
    assert!(completed(cured).is_empty(), "what is completed lacks nothing");
    // a value given before an earlier call counts on
    assert!(completed(&format!("{cured}L978\n")).is_empty());
}

// oracle: manual B:2247-2251, B:16629 (the factor of the measuring path)
#[test]
fn a_factor_of_the_measuring_path_stays_a_number() {
    let text = "R23=100 R28=2 R32=80\nL978\n";
    assert!(told(text).iter().any(|(key, at, _)| key == "older-factor" && at == "R28=2"));
    assert!(converted(text, &[]).contains("_FA=2"));
}

// oracle: manual A:16398, A:16478 (of each cycle the table prints one of _INCA and _STA1 beside R26, or none)
#[test]
fn the_26th_parameter_is_never_open() {
    use crate::catalogue::{CYCLES, r_parameters};
    for cycle in CYCLES.iter().filter(|cycle| r_parameters::is_printed(cycle)) {
        let numbers = cycle.variants.iter().map(|one| Some(one.number as f64)).chain([None]);
        for variant in numbers {
            assert!(Called::of(cycle, variant).meant(26).len() <= 1, "{} {variant:?}", cycle.name);
        }
    }
}

// oracle: manual A:16128-16737, tests/data/older_programs.json (composed from the tables by hand)
#[test]
fn programs_of_the_840c_get_the_names_of_today() {
    let all: Vec<serde_json::Value> = serde_json::from_str(data!("older_programs.json")).unwrap();
    let lines = |of: &serde_json::Value| -> String {
        of.as_array().unwrap().iter().map(|line| line.as_str().unwrap().to_owned() + "\n").collect()
    };
    assert!(all.len() >= 8);
    for one in &all {
        let (older, today) = (lines(&one["older"]), lines(&one["today"]));
        assert_eq!(converted(&older, &[]), today, "{}", one["name"]);
        // what is converted has nothing left of the 840C
        assert!(told(&today).is_empty(), "{}", one["name"]);
    }
}

// oracle: hand (every byte but the names stays: tabs, comments, blanks, line ends, expressions)
#[test]
fn what_is_no_name_stays_byte_for_byte() {
    let older = "\tN5 r[23] = 1 ; R23 of a bore\r\n(* ? *)\r\nN6\tR42=R5*2  R22 =1\r\n/N7 L977 P2 ;(L977)\r\nL979\r\n";
    let today = "\tN5 _MVAR = 1 ; R23 of a bore\r\n(* ? *)\r\nN6\t_SETVAL=R5*2  _PRNUM =1\r\n\
                 /N7 CYCLE977 P2 ;(L977)\r\nCYCLE979\r\n";
    assert_eq!(converted(older, &[]), today);
}

// oracle: manual A:16452, A:16479 (R19 is _ID and _SZA, and a protection zone needs both)
#[test]
fn what_the_manual_leaves_open_is_asked() {
    let text = "R23=1101 R19=-20 R32=80\nL977\n";
    assert_eq!(converted(text, &[]), "");
    let rest = "R32=80\nL977\n";
    let id = ("older-open-id".to_owned(), "R19=-20".to_owned(), format!("R23=1101 _ID=-20 {rest}"));
    let sza = ("older-open-sza".to_owned(), "R19=-20".to_owned(), format!("R23=1101 _SZA=-20 {rest}"));
    let call = ("older-call".to_owned(), "L977".to_owned(), String::new());
    assert_eq!(told(text), [call, id.clone(), sza]);
    // the answer in the program is enough
    assert_eq!(converted(&id.2, &[]), "_MVAR=1101 _ID=-20 _SETVAL=80\nCYCLE977\n");
    assert_eq!(converted(text, &[(19, names::SZA)]), "_MVAR=1101 _SZA=-20 _SETVAL=80\nCYCLE977\n");
}

// oracle: manual A:16396 (R32 and R42 are printed beside _SETVAL, in no order)
#[test]
fn of_two_setpoints_one_is_chosen() {
    let text = "R23=0 R32=44 R42=45\nL974\n";
    assert_eq!(converted(text, &[]), "");
    let cures: Vec<String> = told(text).into_iter().map(|(_, _, cured)| cured).collect();
    assert_eq!(cures, ["", "R23=0 _SETVAL=44\nL974\n", "R23=0 _SETVAL=45\nL974\n"]);
    assert_eq!(converted(text, &[(42, names::SETVAL)]), "_MVAR=0 _SETVAL=45\nCYCLE974\n");
    assert_eq!(converted("R23=0 R32=44 R42=44\nL974\n", &[]), "_MVAR=0 _SETVAL=44\nCYCLE974\n");
}

// oracle: hand (what counts is which assignments reach a call, and what else reads them)
#[test]
fn assignments_are_followed_to_the_calls() {
    for (older, today) in [
        // read by a motion too: it stays, and the name takes its value
        ("R23=100 R32=80\nG0 X=R32\nL978\n", "_MVAR=100 R32=80 _SETVAL=R32\nG0 X=R32\nCYCLE978\n"),
        // assigned anew for something else before a call comes
        ("R23=100 R32=80\nL978\nR32=5\nG0 X=R32\n", "_MVAR=100 _SETVAL=80\nCYCLE978\nR32=5\nG0 X=R32\n"),
        // one value for two cycles that take it as different parameters
        ("R23=13 R31=1\nL973\nR23=1\nL979\n", "_MVAR=13 _MD=1 _RF=1\nCYCLE973\n_MVAR=1\nCYCLE979\n"),
        // two ways to a call
        (
            "IF R1==1\nR32=8\nELSE\nR32=9\nENDIF\nR23=100\nL978\n",
            "IF R1==1\n_SETVAL=8\nELSE\n_SETVAL=9\nENDIF\n_MVAR=100\nCYCLE978\n",
        ),
        // not used: a line that has nothing else goes
        ("R23=100 R32=8\nR31=0\nL978\n", "_MVAR=100 _SETVAL=8\nCYCLE978\n"),
    ] {
        assert_eq!(converted(older, &[]), today);
    }
}

// oracle: manual A:16358, A:16398, A:16557 (CYCLE974 reads R26 in variant 1000 only, there as _STA1, which is R24 of
// CYCLE979); hand
#[test]
fn no_call_gets_the_value_of_another() {
    let bore = "R23=1 R24=15 R26=80 R31=500 R42=80\nL979\n";
    let today = "_MVAR=1 _STA1=15 _INCA=80 _RF=500 _SETVAL=80\nCYCLE979\n";
    assert_eq!(converted(&format!("{bore}R23=0\nL974\n"), &[]), format!("{today}_MVAR=0\nCYCLE974\n"));
    let clashes = |text: &str| told(text).iter().filter(|(key, ..)| key.starts_with("older-clash")).count();
    for clashing in [
        format!("{bore}R23=1000\nL974\n"),             // R26 would lie over R24
        "R23=1000 R26=80\nL974\nR23=1\nL979\n".into(), // R24 comes from elsewhere
        format!("{bore}_STA1=3\nL979\n"),              // written by name, over the R parameter
        // of one setpoint R42 is meant, and R32 lies over it
        "R42=44 R23=0\nL974\nR32=80 R23=100\nL978\nR23=0\nL974\n".into(),
    ] {
        assert_eq!(converted(&clashing, &[(42, names::SETVAL)]), "", "{clashing}");
    }
    assert_eq!(clashes(&format!("{bore}R23=1000\nL974\n")), 1);
    // what the finding says to do: R26 again before the later call, R24 before the one that is named
    let keys = |text: &str| told(text).into_iter().map(|(key, ..)| key).filter(|key| key.starts_with("older-clash"));
    assert_eq!(keys(&format!("{bore}R23=1000\nL974\n")).collect::<Vec<_>>(), ["older-clash-later"]);
    assert_eq!(clashes(&format!("{bore}R23=1000 R26=80\nL974\n")), 0);
    let before = |r24: &str| format!("R23=1000 R26=80\nL974\nR23=1 {r24}\nL979\n");
    assert_eq!(keys(&before("")).collect::<Vec<_>>(), ["older-clash"]);
    assert_eq!(clashes(&before("R24=15")), 0);
    let again = format!("{bore}R23=1000 R26=80\nL974\nR23=1 R24=15\nL979\n");
    assert_eq!(clashes(&again), 0);
    let more = "_MVAR=1000 _INCA=80 _STA1=80\nCYCLE974\n_MVAR=1 _STA1=15\nCYCLE979\n";
    assert_eq!(converted(&again, &[]), format!("{today}{more}"));
}

// oracle: manual A:16452, A:16479, A:16558 (R19 is _ID for the web of CYCLE979 and nothing for its hole)
#[test]
fn an_answer_and_its_cure_say_the_same() {
    let text = |variant| format!("R23=1101 R19=-20 R42=132\nL977\nR23={variant} R42=80 R24=0\nL979\n");
    let cure = |text: &str, key: &str| told(text).into_iter().find(|(known, ..)| known == key).unwrap().2;
    let hole = converted(&text(1), &[(19, names::SZA)]);
    assert!(hole.starts_with("_MVAR=1101 _SZA=-20 _SETVAL=132\nCYCLE977\n"), "{hole}");
    assert_eq!(converted(&cure(&text(1), "older-open-sza"), &[]), hole);
    // the web needs it as _ID, and then it would be that of CYCLE977 too
    assert_eq!(converted(&text(4), &[(19, names::SZA)]), "");
    assert_eq!(cure(&text(4), "older-open-sza"), "");
    assert_eq!(asked_of(&text(4)), ["CYCLE977", "CYCLE977"]);
    let web = converted(&text(4), &[(19, names::ID)]);
    assert_eq!(converted(&cure(&text(4), "older-open-id"), &[]), web);
    assert!(web.starts_with("_MVAR=1101 _ID=-20 "), "{web}");
}

// oracle: hand (a subprogram of the user has the number of a cycle; no variant comes; values that cannot be followed)
#[test]
fn what_is_no_measuring_call_stays() {
    for text in ["L977\n", "L997\n", "R23=1\nL100\n", "R23=1\nL977\nM30\n%_N_L977_SPF\nG0 X1\nM17\n"] {
        assert!(told(text).is_empty() && converted(text, &[]).is_empty(), "{text}");
    }
    for text in ["R23=1 R[R5]=3\nL977\n", "FOR R32=1 TO 3\nR23=100\nL978\nENDFOR\n"] {
        assert_eq!(converted(text, &[]), "");
        assert!(told(text).iter().any(|(key, ..)| key == "older-unclear"), "{text}");
    }
}

// oracle: hand (a word that cannot be read may assign an R parameter, or read one)
#[test]
fn what_cannot_be_read_is_told_and_nothing_is_converted() {
    let call = "L978\nM30\n";
    for (lines, unread) in [
        ("R23=100 R30=1 R32=(80 R22=1\n", "R32=("),
        ("R23=100 R30=1 R32=80# R22=1\n", "#"),
        ("R23=100 R30=1 R22=1 R32=\n", "R32="),
        ("R23=100 R30=1 R22=1\n@714 R32=80\n", "@714"),
        ("@714\nR23=100 R32=80\n", "@714"),
        ("R23=100 R30=1\nN15 R32 80\n", "80"),
    ] {
        let text = format!("{lines}{call}");
        assert_eq!(converted(&text, &[]), "", "{text}");
        let all = told(&text);
        let mut places = all.iter().filter(|(key, ..)| key == "older-unread").map(|(_, place, _)| place);
        assert!(places.any(|place| place.contains(unread)), "{text}{all:?}");
    }
    // in another program, and without anything for a call
    let other = "%_N_A_MPF\nX=5#\nM30\n%_N_B_MPF\nR23=100 R32=80\nL978\nM30\n";
    assert!(!converted(other, &[]).is_empty());
    assert!(told("R23=100 R32=(80\nL5\n").is_empty());
}

// oracle: hand (a block number is what jumps and repetitions look for, however they name it)
#[test]
fn a_block_number_stays_where_the_assignment_goes() {
    let begin = "N10 R23=100 R30=1 R32=80 R22=1\n";
    let today = "N10 _MVAR=100 _MA=1 _SETVAL=80 _PRNUM=1\n";
    for (jump, block, behind) in [
        ("CASE R7 OF 1 GOTOF N20 2 GOTOF N30 DEFAULT GOTOF N30\n", "N20", ""),
        ("IF R1==1 GOTOF N20\n", "N20", ""),
        ("", ":20", "IF R9==2 GOTOB N20\n"),
        ("", "/N20", ""),
        ("", "\tN20", ""),
    ] {
        let text = format!("{begin}{jump}{block} R42=81\nN30 L978\n{behind}M30\n");
        let wanted = format!("{today}{jump}{block}\nN30 CYCLE978\n{behind}M30\n");
        assert_eq!(converted(&text, &[]), wanted);
    }
    // an answer that takes the other setpoint away
    let text = "R23=0 R32=44\nN20 R42=45\nL974\n";
    let cures: Vec<String> = told(text).into_iter().map(|(_, _, cured)| cured).collect();
    assert_eq!(cures[1], "R23=0 _SETVAL=44\nN20\nL974\n");
}

// oracle: hand (a name ends where something else begins that is no letter and no digit)
#[test]
fn names_do_not_stick_to_what_is_beside_them() {
    for (older, today) in [
        ("N10R23=100R30=1R32=80R22=1\nN20L978\n", "N10 _MVAR=100 _MA=1 _SETVAL=80 _PRNUM=1\nN20 CYCLE978\n"),
        ("R23=100R32=80R28=4R36=R2\nL978P2\n", "_MVAR=100 _SETVAL=80 _FA=4 _TSA=R2\nCYCLE978 P2\n"),
        // what goes leaves no number beside a name
        ("N10R31=0R23=100R42=5 R32=80\nN20R19=1 L978\n", "N10 _MVAR=100 _SETVAL=80\nN20 CYCLE978\n"),
        // one that something else reads stays, and its name behind it
        ("R23=100R32=80R5=1\nX=R32\nL978\n", "_MVAR=100R32=80 _SETVAL=R32 R5=1\nX=R32\nCYCLE978\n"),
        ("R23=100 R32=80.R30=1\nL978\n", "_MVAR=100 _SETVAL=80. _MA=1\nCYCLE978\n"),
        ("N10R31=0G0 R23=100 R32=80\nL978\n", "N10 G0 _MVAR=100 _SETVAL=80\nCYCLE978\n"),
    ] {
        assert_eq!(converted(older, &[]), today);
    }
    assert!(completed("R23=100R32=80L978\n")[0].1.ends_with(" L978\n"));
}

// oracle: hand (a macro that says the call, or the name of an R parameter, has no place for another name)
#[test]
fn what_a_macro_says_is_not_converted() {
    let begin = "N10 R23=100 R30=1 R32=80\n";
    for text in [
        format!("DEFINE MESS AS L978\n{begin}N20 MESS\nM30\n"),
        format!("DEFINE MESS AS L978\n{begin}N20 MESS\nN30 R30=2\nN40 L978\nM30\n"),
        format!("DEFINE MESS AS L978 M8\n{begin}N20 MESS\nM30\n"),
        format!("DEFINE SOLL AS R32\n{begin}SOLL=81\nL978\n"),
        format!("DEFINE SOLL AS R32=81\n{begin}SOLL\nL978\n"),
        format!("DEFINE ALLES AS R32=81 L978\n{begin}ALLES\n"),
    ] {
        assert_eq!(converted(&text, &[]), "", "{text}");
        assert!(told(&text).iter().any(|(key, ..)| key == "older-unclear"), "{text}");
    }
    let value = format!("DEFINE WERT AS 81\n{begin}R32=WERT\nL978\n");
    assert!(converted(&value, &[]).contains("\n_SETVAL=WERT\nCYCLE978"));
}

// oracle: manual B:4112 (CYCLE997 from SW 6.3), B:2404 (CYCLE119 too)
#[test]
fn a_call_with_the_number_of_a_newer_cycle_is_told() {
    let newer = |text: &str| -> Vec<String> {
        let all = told(text).into_iter().filter(|(key, ..)| key == "older-new");
        all.map(|(_, place, _)| place).collect()
    };
    assert_eq!(newer("R23=1 R42=44\nL994\nL997\nL119\n"), ["L997", "L119"]);
    assert_eq!(newer("R23=1\nL997\n"), ["L997"]);
    assert!(newer("R23=1\nL997\nM30\n%_N_L997_SPF\nG0 X1\nM17\n").is_empty(), "a program of the user");
}

// oracle: manual A:16314, A:16557 (R31 is _MD for CYCLE973, and _RF for CYCLE979), r_params.md rule 3 (say so)
#[test]
fn an_assignment_that_gets_several_names_is_told() {
    let both = |text: &str| told(text).into_iter().rev().find(|(key, ..)| key == "older-both").map(|(_, at, _)| at);
    assert_eq!(both("R23=13 R31=1\nL973\nR23=1\nL979\n").as_deref(), Some("R31=1"));
    assert_eq!(both("R23=13 R31=1\nL973\nR23=1 R31=500\nL979\n"), None);
}

// oracle: hand (R19 is one parameter for CYCLE998, so nothing asks for it)
#[test]
fn an_answer_without_a_question_is_told() {
    let idle = |text: &str| {
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let (programs, mut found) = (programs(&program), Vec::new());
        let older = find(&program, &programs, &Answers::from([(19, names::SZA)]));
        findings(&program, &programs, &older, &mut found);
        found.iter().filter(|one| one.message.key == "older-idle").count()
    };
    assert_eq!(idle("R23=105 R19=40\nL998\n"), 1);
    assert_eq!(idle("R23=1101 R32=80\nL977\n"), 1, "nothing gives R19 a value");
    assert_eq!(idle("R23=1101 R19=-20 R32=80\nL977\n"), 0);
}

// oracle: hand (R43 is written by nobody, and read behind the call)
#[test]
fn results_that_are_read_are_told() {
    let read = |text: &str| told(text).into_iter().filter(|(key, ..)| key == "older-result").count();
    assert_eq!(read("R23=1\nL977\nR50=R50+R45"), 2, "each of a block");
    assert_eq!(read("R23=1\nL977\nIF R43>5\nM0\nENDIF\nX=R200\n"), 2);
    assert_eq!(read("X=R43\nR23=1\nL977\nR43=1\nX=R43 Y=R1\n"), 0);
}

/// What is said with these answers: key, place, hint.
fn told_with(text: &str, answers: &[(u16, Name)]) -> Vec<(String, String, String)> {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let (programs, mut found) = (programs(&program), Vec::new());
    findings(&program, &programs, &find(&program, &programs, &answers.iter().copied().collect()), &mut found);
    let placed = found.into_iter().filter(|one| one.span.is_some());
    let hint = |one: &crate::diagnostic::Diagnostic| one.hint.as_ref().map(|hint| hint.key.to_string());
    placed
        .map(|one| (one.message.key.to_string(), program.written(one.span.unwrap()), hint(&one).unwrap_or_default()))
        .collect()
}

// oracle: self (a cure that answers a question is the text that the answer gives in the terminal), DESIGN.md
#[test]
fn each_answer_has_a_cure_or_says_why_it_has_none() {
    let setpoints = [(32, names::SETVAL), (42, names::SETVAL)];
    for (text, first, second) in [
        // each setpoint is that of one call, and one of them comes to both
        (
            "R23=102 R42=70 R28=2\nL977\nR23=101 R32=80\nL977\n",
            "R23=102 _SETVAL=70 R28=2\nL977\nR23=101 _SETVAL=80\nL977\n",
            "R23=102 _SETVAL=70 R28=2\nL977\nR23=101 \nL977\n",
        ),
        ("R23=0 R32=44 R42=45\nL974\n", "R23=0 _SETVAL=44\nL974\n", "R23=0 _SETVAL=45\nL974\n"),
        // one that a motion reads stays: only the whole program can be written so
        (
            "R23=0 R32=44 R42=45\nX=R42\nL974\n",
            "_MVAR=0 _SETVAL=44 R42=45\nX=R42\nCYCLE974\n",
            "_MVAR=0 R42=45 _SETVAL=R42\nX=R42\nCYCLE974\n",
        ),
        // two ways
        (
            "R23=0 R42=45\nIF R1\nR32=44\nELSE\nR32=46\nENDIF\nL974\n",
            "R23=0\nIF R1\n_SETVAL=44\nELSE\n_SETVAL=46\nENDIF\nL974\n",
            "R23=0 _SETVAL=45\nIF R1\nELSE\nENDIF\nL974\n",
        ),
    ] {
        let cures: Vec<(String, String)> = told(text)
            .into_iter()
            .filter(|(key, ..)| key.starts_with("older-open"))
            .map(|(key, _, cured)| (key, cured))
            .collect();
        for ((key, cured), wanted) in [("older-open-first", first), ("older-open-second", second)]
            .map(|(key, wanted)| (cures.iter().find(|(known, _)| known == key).unwrap(), wanted.replace(" \n", "\n")))
        {
            assert_eq!(*cured, wanted, "{text}{key}");
            let answer = setpoints[usize::from(key == "older-open-second")];
            let today = converted(text, &[answer]);
            let again = converted(cured, &[]);
            assert!(!today.is_empty() && (again == today || *cured == today), "{text}{key}: {again}{today}");
        }
    }
    // the infeed of the call before would be that of this one
    let text = "R23=102 R42=70 R19=-20\nL977\nR23=1101 R19=-20 R42=80\nL977\n";
    let all = told_with(text, &[]);
    let sza = all.iter().find(|(key, ..)| key == "older-open-sza").unwrap();
    assert_eq!(sza.2, "older-answer-clash-hint");
    assert_eq!(converted(text, &[(19, names::SZA)]), "");
    let id = all.iter().find(|(key, ..)| key == "older-open-id").unwrap();
    assert_eq!(id.2, "older-open-hint");
}

// oracle: hand (numbers are equal however they are written; what a variable holds may change between two lines)
#[test]
fn two_setpoints_of_one_value_are_one() {
    for (older, today) in [
        ("R32=50 R42=50.0", "_SETVAL=50"),
        ("R32=1.5*2 R42=3", "_SETVAL=1.5*2"),
        ("R42=3 R32=3.", "_SETVAL=3."),
        ("R32=R7 R42=R7", "_SETVAL=R7"),
        ("R42=R7+1 R10=5 R32=R7+1", "_KNUM=5 _SETVAL=R7+1"),
    ] {
        let text = format!("R23=0 {older}\nL974\n");
        assert_eq!(converted(&text, &[]), format!("_MVAR=0 {today}\nCYCLE974\n"));
        let all = told_with(&text, &[]);
        let left = all.iter().find(|(_, place, _)| place.starts_with("R42")).unwrap();
        assert_eq!(left.0, "older-other", "{text}");
    }
    for other in ["R32=R7 R7=2 R42=R7", "R32=R7\nR42=R7", "R32=R32+1 R42=R32+1", "R32=R[R1] R42=R[R1]", "R32=5 R42=6"] {
        assert_eq!(converted(&format!("R23=0 {other}\nL974\n"), &[]), "", "{other}");
    }
    let all = told_with("R23=0 R32=5 R42=6\nL974\n", &[(42, names::SETVAL)]);
    assert_eq!(all.iter().find(|(_, place, _)| place == "R32=5").unwrap().0, "older-other");
}
