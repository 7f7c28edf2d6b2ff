//! What the reader makes of single words and expressions, and what it says about mistakes.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::diagnostic::Span;
use probewright_core::dialect::Dialect;
use probewright_core::syntax::tree::{Expr, ExprId, Operator, Word, WordKind};
use probewright_core::syntax::{Program, read};

/// An expression with every bracket that its tree implies.
fn show(program: &Program, id: ExprId) -> String {
    let text = |span: Span| program.name(span);
    let list = |ids: &[ExprId]| ids.iter().map(|id| show(program, *id)).collect::<Vec<_>>().join(",");
    match program.expr(id).unwrap() {
        Expr::Number(value, _) => value.to_string(),
        Expr::Text(span) => format!("'{}'", text(*span)),
        Expr::Name { name, index } if index.is_empty() => text(*name),
        Expr::Name { name, index } => format!("{}[{}]", text(*name), list(index)),
        Expr::Unary(operator, inner) => {
            format!("({} {})", symbol(*operator), show(program, *inner))
        }
        Expr::Binary(left, operator, right) => {
            format!("({} {} {})", show(program, *left), symbol(*operator), show(program, *right))
        }
        Expr::Call(name, arguments) => format!("{}({})", text(*name), list(arguments)),
        Expr::List(elements) => format!("LIST({})", list(elements)),
        Expr::Omitted => String::new(),
    }
}

fn symbol(operator: Operator) -> String {
    format!("{operator:?}").to_uppercase()
}

/// Words of a line, one a piece of text.
fn words(dialect: Dialect, line: &str) -> Vec<String> {
    let program = read(dialect, line.as_bytes());
    let text = |span: Span| program.name(span);
    let optional = |id: &Option<ExprId>| id.map_or(String::new(), |id| show(&program, id));
    let word = |word: &Word| match &word.kind {
        WordKind::Address { name, extension, mode, value } => {
            let extension = extension.map_or(String::new(), |number| number.to_string());
            let mode = mode.map_or(String::new(), &text);
            format!("{}{extension}:{mode}{}", text(*name), show(&program, *value))
        }
        WordKind::Assign { name, index, value, .. } => {
            let index: Vec<String> = index.iter().map(|id| show(&program, *id)).collect();
            format!("{}[{}]={}", text(*name), index.join(","), show(&program, *value))
        }
        WordKind::Declare { name, index, value } => {
            format!("declare {}[{}] {}", text(*name), index.len(), optional(value)).trim_end().to_owned()
        }
        WordKind::Constant(value) => format!("constant {}", show(&program, *value)),
        WordKind::Call { name, args } => {
            let arguments: Vec<String> = args.iter().map(|id| show(&program, *id)).collect();
            if word.span.end > name.end { format!("{}({})", text(*name), arguments.join(",")) } else { text(*name) }
        }
        WordKind::Label(name) => format!("label {}", text(*name)),
        WordKind::Keyword { name, value } => format!("{} {}", text(*name), optional(value)).trim().to_owned(),
        WordKind::Header => format!("header {}", text(word.span)),
        WordKind::Unknown => "unknown".to_owned(),
    };
    program.words.iter().map(word).collect()
}

fn sinumerik(line: &str) -> Vec<String> {
    words(Dialect::Sinumerik, line)
}

fn expression(text: &str) -> String {
    sinumerik(&format!("R1={text}")).join(" | ")
}

// oracle: peer (precedence.mpf, basic_math.mpf of the language corpus) and hand
#[test]
fn operators_bind_in_the_order_of_the_control() {
    for (text, expected) in [
        ("2+3*4", "(2 PLUS (3 TIMES 4))"),
        ("10-2-3", "((10 MINUS 2) MINUS 3)"),
        ("2+6 DIV 4", "(2 PLUS (6 DIV 4))"),
        ("1+7 mod 4", "(1 PLUS (7 MOD 4))"),
        ("(2+3)*4", "((2 PLUS 3) TIMES 4)"),
        ("2*-3", "(2 TIMES (MINUS 3))"),
        ("1+-1", "(1 PLUS (MINUS 1))"),
        ("6 B_AND 3 B_OR 8", "((6 BITAND 3) BITOR 8)"),
        ("R2>1+2", "(R2 GREATER (1 PLUS 2))"),
        ("NOT R2 AND R3", "((NOT R2) AND R3)"),
        ("(R2==1) OR (R3<>2)", "((R2 EQUAL 1) OR (R3 NOTEQUAL 2))"),
        ("\"a\"<<R2+1<<\"b\"", "(('A' JOIN (R2 PLUS 1)) JOIN 'B')"),
        ("<<R2", "(JOIN R2)"),
        ("CTRANS(X,1):CROT(Z,2)", "(CTRANS(X,1) CHAIN CROT(Z,2))"),
        ("_TPW[_PRNUM-1,4]+20", "(_TPW[(_PRNUM MINUS 1),4] PLUS 20)"),
        ("SQRT(POT(3)+POT(4))", "SQRT((POT(3) PLUS POT(4)))"),
        ("'HFF'+'B11'+1EX2", "((255 PLUS 3) PLUS 100)"),
    ] {
        assert_eq!(expression(text), format!("R1[]={expected}"), "{text}");
    }
}

// oracle: hand (written forms of the manuals' programs, without blanks where the control allows it)
#[test]
fn words_are_told_apart() {
    for (line, expected) in [
        ("N10G1F500X10Y-.5", vec!["G:1", "F:500", "X:10", "Y:-0.5"]),
        ("X=IC(5) Y = AC(R1+1) SPOS=DC(90)", vec!["X:IC5", "Y:AC(R1 PLUS 1)", "SPOS:DC90"]),
        ("S1=500 M2=3 T=\"PROBE\" R10=5", vec!["S1:500", "M2:3", "T:'PROBE'", "R10[]=5"]),
        ("_SETV[0]=5 $P_UIFR[1,X,TR]=7", vec!["_SETV[0]=5", "$P_UIFR[1,X,TR]=7"]),
        ("L10 L11(1,,3) STOPRE MSG ()", vec!["L10", "L11(1,,3)", "STOPRE", "MSG()"]),
        ("N5 END_1: M30", vec!["label END_1", "M:30"]),
        ("IF R1==1 GOTOF N100", vec!["IF (R1 EQUAL 1)", "GOTOF N100"]),
        (
            "CASE(R1) OF 7 GOTOF A1 DEFAULT GOTOF B1",
            vec!["CASE R1", "OF", "constant 7", "GOTOF A1", "DEFAULT", "GOTOF B1"],
        ),
        ("FOR X=0 TO 9", vec!["FOR", "X[]=0", "TO 9"]),
        ("DEF REAL A[2]=SET(1,,3),B", vec!["DEF", "REAL", "declare A[1] SET(1,,3)", "declare B[0]"]),
        ("DEF STRING[9] R1=\"x\"", vec!["DEF", "STRING 9", "declare R1[0] 'X'"]),
        ("PROC P(REAL A) SAVE", vec!["PROC", "declare P[0]", "REAL", "declare A[0]", "SAVE"]),
        ("%_N_A_MPF", vec!["header %_N_A_MPF"]),
    ] {
        assert_eq!(sinumerik(line), expected, "{line}");
    }
    for (line, expected) in [
        ("N1 G110 D#1 S6(bore)Q[#2/5]", vec!["G:110", "D:#1", "S:6", "Q:(#2 OVER 5)"]),
        ("#100=-[#1+2]*3", vec!["#100[]=((MINUS (#1 PLUS 2)) TIMES 3)"]),
        ("#[#1+1]=ATAN[1]/[2]", vec!["#[(#1 PLUS 1)]=ATAN(1,2)"]),
        ("IF[#1 EQ 2]GOTO 30", vec!["IF (#1 EQUAL 2)", "GOTO 30"]),
        ("WHILE[#1LT6]DO1", vec!["WHILE (#1 LESS 6)", "DO 1"]),
        ("%O0110 (BORE)", vec!["header %O0110"]),
    ] {
        assert_eq!(words(Dialect::Nct, line), expected, "{line}");
    }
}

// oracle: hand
#[test]
fn block_number_skip_level_and_comment_belong_to_the_line() {
    let program = read(Dialect::Sinumerik, b"/2 N10 X1 ; c\r\n:20 MSG(\"a;b\")\n\nN30\n");
    let shown: Vec<_> = program
        .blocks
        .iter()
        .map(|block| (block.skip, block.number.map(|place| program.name(place)), block.comment.is_some()))
        .collect();
    let numbered = |number: &str| Some(number.to_owned());
    assert_eq!(
        shown,
        [
            (Some(2), numbered("N10"), true),
            (None, numbered(":20"), false),
            (None, None, false),
            (None, numbered("N30"), false)
        ]
    );
}

// oracle: hand
#[test]
fn every_mistake_is_named_with_words_and_the_rest_of_the_line_is_read() {
    let messages = include_str!("../messages/en/syntax.ftl");
    for (line, key) in [
        ("^? X1", "syntax-unknown"),
        ("_FA=1^,5 X1", "syntax-comma"),
        ("X1^,5 Y1", "syntax-comma"),
        ("R1=(1+^2 X1", "syntax-bracket"),
        ("CYCLE977(101,1,,1,132,^,", "syntax-bracket"),
        ("CYCLE977(101, 1,, 1, 132^, ; measure", "syntax-bracket"),
        ("CYCLE_978(0,100, X^1", "syntax-bracket"),
        ("CYCLE_978^(", "syntax-bracket"),
        ("R1=(1^,", "syntax-bracket"),
        ("_SETV[0]=SET(1,2^,", "syntax-bracket"),
        ("R1=^* X1", "syntax-operand"),
        ("R1^=", "syntax-value"),
        ("AN^D X1", "syntax-operator"),
        ("FELD[1^] X1", "syntax-equals"),
        ("FELD[1,2,3,4]^=1 X1", "syntax-index"),
        ("MSG(^\"open X1", "syntax-text"),
        ("R1=^'HZZ' X1", "syntax-number"),
        ("_FA=1^e-3 X1", "syntax-exponent"),
        ("R1=2+1.5^E3 X1", "syntax-exponent"),
        ("X1^e308 Y1", "syntax-exponent"),
    ] {
        let place = line.find('^').unwrap() as u32;
        let line = line.replacen('^', "", 1);
        let program = read(Dialect::Sinumerik, line.as_bytes());
        assert_eq!(program.errors.iter().map(|error| error.sentence.cause).collect::<Vec<_>>(), [key], "{line}");
        assert_eq!(program.errors[0].span.start, place, "{line}");
        assert!(messages.contains(&format!("\n{key} = ")), "{key} has words");
    }
    let comment = read(Dialect::Nct, b"G1 (open");
    assert_eq!(comment.errors[0].sentence.cause, "syntax-comment");
    // oracle: hand (what an editor puts before the text is no word)
    let marked = read(Dialect::Sinumerik, "\u{feff}%_N_A_MPF\nX1".as_bytes());
    assert_eq!(marked.errors, []);
    let kept = sinumerik("_FA=1,5 CYCLE977");
    assert_eq!(kept, ["unknown", "CYCLE977"]);
}
