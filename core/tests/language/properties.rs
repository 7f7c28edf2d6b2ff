//! Properties: an expression is what f64 makes of it, structure always comes to its end, any words end within the
//! limits.

use super::{near, number, setup};
use probewright_core::dialect::Dialect;
use probewright_core::run::{Limits, Session, run};
use probewright_core::syntax::read;
use proptest::prelude::*;

/// An expression as text, with what f64 makes of it.
#[derive(Clone, Debug)]
struct Expression {
    text: String,
    value: f64,
}

fn leaf() -> impl Strategy<Value = Expression> {
    (-1000_i32..1000, 0_u32..3).prop_map(|(digits, decimals)| {
        let value = f64::from(digits) / 10_f64.powi(decimals as i32);
        let text = match value < 0.0 {
            true => format!("({value})"),
            false => format!("{value}"),
        };
        Expression { text, value }
    })
}

/// Operators that are worked out in the order of the text only where brackets stand: the oracle keeps its own tree.
fn joined(left: Expression, operator: usize, right: Expression) -> Expression {
    let (a, b) = (left.value, right.value);
    let (sign, value) = match operator {
        0 => ("+", a + b),
        1 => ("-", a - b),
        2 => ("*", a * b),
        3 if b != 0.0 => ("/", a / b),
        4 if b != 0.0 => (" DIV ", (a / b).trunc()),
        5 if b != 0.0 => (" MOD ", a % b),
        6 => (" AND ", truth(a != 0.0 && b != 0.0)),
        7 => (" OR ", truth(a != 0.0 || b != 0.0)),
        _ => (" XOR ", truth((a != 0.0) != (b != 0.0))),
    };
    Expression { text: format!("({}{sign}{})", left.text, right.text), value }
}

fn truth(holds: bool) -> f64 {
    f64::from(u8::from(holds))
}

/// Sine of an angle in degree: the turns are taken off first, and quarters have no rounding.
fn sine(degree: f64) -> f64 {
    match degree.rem_euclid(360.0) {
        0.0 | 180.0 => 0.0,
        90.0 => 1.0,
        270.0 => -1.0,
        part => part.to_radians().sin(),
    }
}

fn cosine(degree: f64) -> f64 {
    match degree.rem_euclid(360.0) {
        0.0 => 1.0,
        90.0 | 270.0 => 0.0,
        180.0 => -1.0,
        part => part.to_radians().cos(),
    }
}

fn called(function: usize, inner: Expression) -> Expression {
    let x = inner.value;
    let (name, value) = match function {
        0 => ("ABS", x.abs()),
        1 => ("TRUNC", x.trunc()),
        2 => ("ROUNDUP", x.ceil()),
        3 => ("-", -x),
        4 => ("NOT ", truth(x == 0.0)),
        5 => ("SIN", sine(x)),
        6 => ("COS", cosine(x)),
        7 if x >= 0.0 => ("SQRT", x.sqrt()),
        _ => ("POT", x * x),
    };
    Expression { text: format!("{name}({})", inner.text), value }
}

fn expression() -> impl Strategy<Value = Expression> {
    leaf().prop_recursive(5, 40, 2, |inner| {
        prop_oneof![
            (inner.clone(), 0_usize..9, inner.clone()).prop_map(|(a, operator, b)| joined(a, operator, b)),
            (0_usize..9, inner).prop_map(|(function, a)| called(function, a)),
        ]
    })
}

/// Sums and products without brackets: `*` and `/` bind tighter, equal ones go from left to right.
fn sum(terms: &[(bool, Vec<(bool, u32)>)]) -> Expression {
    let (mut text, mut total) = (String::new(), 0.0);
    for (i, (minus, factors)) in terms.iter().enumerate() {
        let mut product = f64::NAN;
        text.push_str(if *minus {
            "-"
        } else if i > 0 {
            "+"
        } else {
            ""
        });
        for (k, (over, factor)) in factors.iter().enumerate() {
            let factor_value = f64::from(*factor);
            product = match (k, over) {
                (0, _) => factor_value,
                (_, true) => product / factor_value,
                (_, false) => product * factor_value,
            };
            if k > 0 {
                text.push(if *over { '/' } else { '*' });
            }
            text.push_str(&factor.to_string());
        }
        total = if *minus { total - product } else { total + product };
    }
    Expression { text, value: total }
}

/// A piece of structure that ends, `depth` levels below it; the count of `R1` steps that it makes.
#[derive(Clone, Debug)]
struct Structure {
    text: String,
    steps: f64,
}

fn structure() -> impl Strategy<Value = Structure> {
    let step = Just(Structure { text: "R1=R1+1\n".into(), steps: 1.0 });
    step.prop_recursive(4, 24, 3, |inner| {
        prop_oneof![
            (prop::collection::vec(inner.clone(), 1..4)).prop_map(|parts| Structure {
                text: parts.iter().map(|part| part.text.as_str()).collect(),
                steps: parts.iter().map(|part| part.steps).sum(),
            }),
            (0_u32..4, inner.clone(), any::<u32>()).prop_map(|(count, part, name)| looped(count, &part, name)),
            (any::<bool>(), inner.clone(), inner).prop_map(|(holds, yes, no)| Structure {
                text: format!("IF {}\n{}ELSE\n{}ENDIF\n", u8::from(holds), yes.text, no.text),
                steps: if holds { yes.steps } else { no.steps },
            }),
        ]
    })
}

/// A loop of each kind, with a counter of its own.
fn looped(count: u32, part: &Structure, name: u32) -> Structure {
    let counter = format!("R{}", 100 + name % 800);
    let text = match name % 3 {
        0 => format!("FOR {counter}=1 TO {count}\n{}ENDFOR\n", part.text),
        1 => format!("{counter}=0\nWHILE {counter}<{count}\n{counter}={counter}+1\n{}ENDWHILE\n", part.text),
        _ => format!("{counter}=0\nREPEAT\n{}{counter}={counter}+1\nUNTIL {counter}>={count}\n", part.text),
    };
    let times = if name % 3 == 2 { count.max(1) } else { count };
    Structure { text, steps: part.steps * f64::from(times) }
}

/// Words of which random programs are made: every sort of control structure and of state.
const WORDS: [&str; 51] = [
    "IF R1>2",
    "ELSE",
    "ENDIF",
    "WHILE R1<3",
    "ENDWHILE",
    "FOR R1=1 TO 5",
    "ENDFOR",
    "REPEAT",
    "UNTIL R1>4",
    "LOOP",
    "ENDLOOP",
    "GOTOB A1",
    "GOTOF A1",
    "GOTO A1",
    "GOTOC A1",
    "A1:",
    "REPEAT A1 P=3",
    "REPEATB A1",
    "ENDLABEL:",
    "CASE R1 OF 1 GOTOF A1 DEFAULT GOTOB A1",
    "SUB(1,R2)",
    "SUB P3",
    "PROC SUB(INT N, VAR REAL OUT) SAVE",
    "%_N_SUB_SPF",
    "RET",
    "M17",
    "M30",
    "DEF FRAME F=CROT(Z,R1)",
    "DEF STRING[4] T=\"AB\"",
    "T=T<<R1",
    "DEF INT G[2,3]=REP(1)",
    "G=SET(1,2,3)",
    "CALL \"SUB\"",
    "SETAL(67000)",
    "MIRROR X0",
    "AROT Z45",
    "ASCALE X2",
    "CYCLE800(1,\"\",0,57)",
    "DIAMON",
    "DL=1",
    "G2 X1 Y1 CR=R1",
    "CIP X1 I1=2",
    "G41 G1 X5 F100",
    "G42 G1 X30 Y40 F100",
    "G3 X60 Y40 CR=20",
    "G1 X90 Z5",
    "G40 Y0",
    "G451 OFFN=R1",
    "T20 M6 D1",
    "R2=$AA_IW[X]",
    "R1=R1+1",
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    // oracle: f64, calculated beside the text
    #[test]
    fn expressions_are_what_f64_makes_of_them(expression in expression()) {
        prop_assume!(expression.value.is_finite() && expression.value.abs() < 1e100);
        let found = number(&format!("R1={}", expression.text), "R1");
        near(found, expression.value, &expression.text);
    }

    // oracle: f64, calculated beside the text
    #[test]
    fn products_bind_tighter_than_sums(
        terms in prop::collection::vec((any::<bool>(), prop::collection::vec((any::<bool>(), 1_u32..50), 1..4)), 1..5),
    ) {
        let expression = sum(&terms);
        near(number(&format!("R1={}", expression.text), "R1"), expression.value, &expression.text);
    }

    // oracle: counted while the text is made. A counter that two nested loops share may make them longer or shorter.
    #[test]
    fn structures_come_to_their_end(structure in structure()) {
        let counters: Vec<&str> = ["FOR R", "WHILE R", "UNTIL R"]
            .into_iter()
            .flat_map(|word| structure.text.match_indices(word))
            .filter_map(|(at, word)| structure.text[at + word.len()..].split(|c: char| !c.is_ascii_digit()).next())
            .collect();
        let own = counters.iter().collect::<std::collections::BTreeSet<_>>().len();
        prop_assume!(own == counters.len() && structure.steps < 2000.0);
        let found = number(&structure.text, "R1");
        prop_assert_eq!(found, structure.steps, "{}", structure.text);
    }

    // oracle: self (the limits), and a run in pieces is the run in one
    #[test]
    fn any_words_end_within_the_limits(
        lines in prop::collection::vec(prop::collection::vec(prop::sample::select(WORDS.to_vec()), 1..3), 0..20),
        pieces in 1_u64..40,
    ) {
        let text: Vec<String> = lines.iter().map(|words| words.join(" ")).collect();
        let program = read(Dialect::Sinumerik, text.join("\n").as_bytes());
        let limits = Limits { steps: Some(300), depth: 4, trace: 250, own: 250, ..Limits::default() };
        let whole = run(&program, &setup(), limits);
        prop_assert!(whole.trace.entries.len() <= limits.trace + limits.own);
        prop_assert!(whole.position.iter().all(|value| value.is_finite()));
        let mut session = Session::new(program, &setup(), limits);
        let mut rounds = 0_u64;
        while !session.advance(pieces) {
            rounds += 1;
            prop_assert!(rounds <= 300 && (0.0..=1.0).contains(&session.share));
        }
        prop_assert_eq!(session.outcome(), whole);
    }
}

// oracle: hand
#[test]
fn a_run_that_is_left_says_so() {
    let program = read(Dialect::Sinumerik, b"R1=1\nA: R1=R1+1\nGOTOB A");
    let mut session = Session::new(program, &setup(), Limits::default());
    assert!(!session.advance(100));
    assert!(session.share > 0.0 && session.share < 1.0);
    let outcome = session.outcome();
    assert!(
        matches!(&outcome.stop, Some(probewright_core::machine::Stop::Fault(message)) if message.key == "run-cancelled")
    );
    assert!(outcome.control.number("R1") > 10.0);
}
