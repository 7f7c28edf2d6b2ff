//! A protocol that one machine writes is laid onto the same program on another machine: what comes of it is what the
//! first one measured.
#![allow(clippy::unwrap_used, clippy::panic)]

use super::*;
use crate::app::{Record, Verdict, csv};
use crate::control::Plane;
use crate::dialect::Dialect;
use crate::geometry::Mcs;
use crate::machine::Step;
use crate::run::{Limits, Session};
use crate::syntax;

/// A milling machine with a calibrated probe and a hole of 50 mm about the zero point: by so much larger, and so far
/// off in X and Y.
fn machine(size: f64, off: [f64; 2]) -> Setup {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE977").unwrap();
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.suit(cycle, 1);
    let [x, y] = off;
    let part = format!(
        r#"{{ "control": "sinumerik", "probe": {{ "radius": 3, "length": 50 }}, "workpiece": [
            {{ "shape": "hole", "size": [50, 40], "at": [{x}, {y}, 0], "errors": {{ "size": {size} }} }} ] }}"#
    );
    setup.workpiece = crate::json::setup_from_json(&part).unwrap().workpiece;
    setup
}

/// Measures the hole three times and logs it.
const PROGRAM: &str = "G17 G54 G90 T9 D1\nM6\nG0 X0 Y0\nG0 Z-10\n_PROTNAME[0]=\"PART\" _PROTNAME[1]=\"LOG_1\"\n\
    _PROTSYM[0]=\",\" _PROTSYM[1]=\"*\" _PROTFORM[0]=60 _PROTFORM[1]=80 _PROTFORM[4]=3 _PROTFORM[5]=12\n\
    _PROTVAL[0]=\"What, Axis, Set, Actual, Difference\" _PROTVAL[2]=\"D,hole,_OVR[0],_OVR[4],_OVR[16]\"\n\
    _PROTVAL[3]=\"M,_AXIS1,_OVR[1],_OVR[5],_OVR[17]\" _PROTVAL[4]=\"M,_AXIS2,_OVR[2],_OVR[6],_OVR[18]\"\nCYCLE100\n\
    _PRNUM=1 _SETVAL=50 _KNUM=0 _FA=2 _TSA=1 _MVAR=1 _VMS=0 _NMSP=1 _TUL=0.1 _TLL=-0.1 _TZL=0.01 _TMV=0.02\n\
    _TDIF=0.5 _K=1 _EVNUM=0 _STA1=0\nCYCLE977\nCYCLE977\nCYCLE977\nCYCLE101\nM30\n";

fn run(setup: &Setup) -> Outcome {
    let program = syntax::read(Dialect::Sinumerik, PROGRAM.as_bytes());
    Session::new(program, setup, Limits::default()).complete()
}

fn plain(message: &Message) -> String {
    if message.key == "record-decimal-sign" { ".".to_owned() } else { message.key.to_string() }
}

/// The actual values of all calls.
fn values(calls: &[RunAnswer]) -> Vec<f64> {
    calls.iter().flat_map(|call| &call.answer.figures).map(|figure| figure.actual).collect()
}

fn near(one: &[f64], other: &[f64], by: f64) -> bool {
    one.len() == other.len() && one.iter().zip(other).all(|(one, other)| (one - other).abs() < by)
}

/// Laid onto a machine whose part has no errors.
fn onto_nominal(text: &str, columns: Option<&ProtocolColumns>) -> Result<ProtocolView, Error> {
    let nominal = machine(0.0, [0.0; 2]);
    laid(&[text], columns, &nominal, &run(&nominal))
}

// oracle: hand: what the machine measured whose log or table is read; the log has three decimals
#[test]
fn what_one_machine_writes_is_read_on_another() {
    let real = machine(0.06, [0.03, -0.02]);
    let outcome = run(&real);
    let record = Record::new("part.mpf".to_owned(), &real, &outcome, Vec::new());
    let (_, log) = outcome.files.iter().next().unwrap();
    for (text, by) in [(log.join("\n"), 6e-4), (csv(&record, &plain), 2e-6)] {
        let view = onto_nominal(&text, None).unwrap();
        assert!(near(&values(&view.answers), &values(&record.calls), by), "{text}\n{:#?}", view.unfit);
        assert_eq!((view.missing, view.answers.len()), (0, 3));
        for (read, measured) in view.answers.iter().zip(&record.calls) {
            assert_eq!(read.answer.verdict, measured.answer.verdict);
            let used = |call: &RunAnswer| call.answer.figures[0].limits.unwrap().used.unwrap();
            assert!((used(read) - used(measured)).abs() < 0.01);
        }
    }
}

// oracle: hand: a hole above its tolerance is scrap, one below it rework; nobody knows what the machine corrected
#[test]
fn values_are_judged_by_the_limits_of_the_call() {
    for (actual, verdict) in [(50.05, Verdict::Within), (50.15, Verdict::Scrap), (49.85, Verdict::Rework)] {
        let view = onto_nominal(&format!("50 {actual}"), None).unwrap();
        assert_eq!(view.answers[0].answer.verdict, verdict);
        assert!(view.answers[0].answer.corrected.is_empty());
        assert_eq!(view.answers[1].answer.verdict_words.key, "record-missing");
        assert_eq!((view.fitted, view.missing), (1, 2));
    }
}

// oracle: hand: where the faces of the other part are touched
#[test]
fn arrows_lead_to_the_faces_of_the_real_part() {
    let real = machine(0.1, [0.03, -0.02]);
    let outcome = run(&real);
    let touches = |outcome: &Outcome| -> Vec<Mcs> {
        let entries = outcome.trace.entries.to_vec().into_iter();
        entries.filter_map(|one| if let Step::Touch { point, .. } = one.step { Some(point) } else { None }).collect()
    };
    let record = Record::new(String::new(), &real, &outcome, Vec::new());
    let view = onto_nominal(&csv(&record, &plain), None).unwrap();
    let there = touches(&outcome);
    assert_eq!(view.arrows.len(), there.len());
    for (arrow, there) in view.arrows.iter().zip(there) {
        let axis = (0..2).max_by(|a, b| arrow.by[*a].abs().total_cmp(&arrow.by[*b].abs())).unwrap();
        assert!((arrow.at[axis] + arrow.by[axis] - there[axis]).abs() < 2e-4, "{arrow:?} {there:?}");
    }
}

/// What a program measures on one part laid onto another, and where the first one is touched.
fn laid_onto(program: &str, real: &Setup, nominal: &Setup) -> (Vec<Arrow>, Vec<Mcs>) {
    let run = |setup: &Setup| {
        let program = syntax::read(Dialect::Sinumerik, program.as_bytes());
        Session::new(program, setup, Limits::default()).complete()
    };
    let outcome = run(real);
    assert!(outcome.finished(), "{:?}", outcome.stop);
    let record = Record::new(String::new(), real, &outcome, Vec::new());
    let view = laid(&[csv(&record, &plain)], None, nominal, &run(nominal)).unwrap();
    let entries = outcome.trace.entries.to_vec().into_iter();
    let touched = entries.filter_map(|one| if let Step::Touch { point, .. } = one.step { Some(point) } else { None });
    (view.arrows, touched.collect())
}

/// A machine with this part.
fn with_part(part: &str) -> Setup {
    let file =
        format!(r#"{{ "control": "sinumerik", "probe": {{ "radius": 3, "length": 50 }}, "workpiece": [{part}] }}"#);
    let mut setup = machine(0.0, [0.0; 2]);
    setup.workpiece = crate::json::setup_from_json(&file).unwrap().workpiece;
    setup
}

// oracle: hand: a face turned by 0.5 degree about its first point is further off at the second, 40 mm away
#[test]
fn arrows_of_an_angle_turn_with_the_face() {
    let program = "G17 G54 G90 T9 D1\nM6\nG0 Z50\nG0 X-20 Y-40\nG0 Z-5\n_PRNUM=1 _SETVAL=-20 _KNUM=0 _FA=8 _TSA=5 \
        _MVAR=105 _VMS=0 _NMSP=1 _STA1=0 _ID=40 _MA=102 _RA=0\nCYCLE998\nM30\n";
    let block = |turned: f64| {
        let errors = format!(r#""errors": {{ "tilt": [0, 0, {turned}] }}"#);
        with_part(&format!(r#"{{ "shape": "block", "size": [200, 40, 20], "at": [0, 0, 0], {errors} }}"#))
    };
    let (arrows, there) = laid_onto(program, &block(0.5), &block(0.0));
    assert_eq!((arrows.len(), there.len()), (1, 2), "none at the first point: {arrows:?}");
    // where the first point lies the angle does not tell
    let turned = arrows[0].at[1] + arrows[0].by[1] - -20.0;
    assert!((turned - (there[1][1] - there[0][1])).abs() < 2e-3, "{arrows:?} {there:?}");
}

fn columns(named: &[(&str, &str)]) -> ProtocolColumns {
    let of = |name: &str| named.iter().find(|(one, _)| *one == name).map(|(_, column)| (*column).to_owned());
    ProtocolColumns {
        number: of("number"),
        line: of("line"),
        result: of("result"),
        nominal: of("nominal"),
        actual: of("actual"),
        deviation: of("deviation"),
    }
}

// oracle: hand
#[test]
fn chosen_columns_say_what_stands_where() {
    let german = "Protokoll vom 28.11.\nNr;Soll;Ist;Abw\n1;50;50,02 mm;+0,02\n3;50,000;50,04*;0,04\n";
    let by_number = columns(&[("number", "nr"), ("actual", "Ist"), ("deviation", "Abw"), ("nominal", "Soll")]);
    let in_order = columns(&[("nominal", "2"), ("actual", "3")]);
    let results = columns(&[("line", "1"), ("result", "2"), ("actual", "3")]);
    let offsets = columns(&[("nominal", "Soll"), ("deviation", "Abw")]);
    let of = |text: &str, columns: &ProtocolColumns| onto_nominal(text, Some(columns)).unwrap();
    assert!(near(&values(&of(german, &by_number).answers), &[50.02, 50.04], 1e-9));
    assert_eq!(of(german, &by_number).missing, 1);
    assert!(near(&values(&of(german, &offsets).answers), &[50.02, 50.04], 1e-9));
    let view = of(german, &in_order);
    assert!(near(&values(&view.answers), &[50.02, 50.04], 1e-9) && view.answers[2].answer.figures.is_empty());
    // the headings are known although the columns are named by their numbers
    assert_eq!(view.unfit.len(), 0, "{:?}", view.unfit);
    let view = of("12 _OVR[5] 0.01\n12 _OVR[4] 50.01\n13 _OVR[4] 50.02\n", &results);
    assert!(near(&values(&view.answers), &[50.01, 0.01, 50.02], 1e-9), "{:?}", view.unfit);
}

// oracle: hand: tables with headings of their own say what stands where; figures alone would not
#[test]
fn headings_of_a_table_are_recognised() {
    let line = 1 + PROGRAM.lines().position(|line| line == "CYCLE977").unwrap();
    let next = line + 1;
    for text in [
        format!("Part 7\nLine;Actual\n{line};50.02\n{next};50.04\n"),
        format!("Zeile;Istwert [mm]\n{line};50,02\n{next};50,04\n"),
        format!("行;实际值\n{line};50.02\n{next};50.04\n"),
        format!("Program line\tDeviation\tNominal\n{line}\t0.02\t50\n{next}\t0.04\t50\n"),
    ] {
        let view = onto_nominal(&text, None).unwrap();
        let sizes: Vec<f64> = values(&view.answers[..2]);
        assert!(near(&sizes, &[50.02, 50.04], 1e-9), "{text} {:?}", view.unfit);
        assert_eq!((view.recognised.line.as_deref(), view.unfit.len()), (Some("1"), 0), "{text}");
    }
    assert_eq!(onto_nominal("50 50.02\n", None).unwrap().recognised, ProtocolColumns::default());
}

/// The lines of the program in which the calls stand.
fn lines_of_calls() -> [usize; 3] {
    let first = 1 + PROGRAM.lines().position(|line| line == "CYCLE977").unwrap();
    [first, first + 1, first + 2]
}

/// What a table comes to: the actual value of each call, none where it has none, and the lines that do not fit, with
/// why.
/// `A`, `B` and `C` stand for the lines of the calls.
fn come_to(table: &str) -> (Vec<Option<f64>>, Vec<(u32, String)>) {
    let [a, b, c] = lines_of_calls().map(|line| line.to_string());
    let view = onto_nominal(&table.replace("A", &a).replace("B", &b).replace("C", &c), None).unwrap();
    let sizes = view.answers.iter().map(|call| call.answer.figures.first().map(|one| one.actual));
    let unfit = view.unfit.iter().map(|one| (one.line, one.why.key.to_string()));
    assert_eq!(view.doubtful, [], "{table}");
    (sizes.collect(), unfit.collect())
}

// oracle: hand: which call a line is about is what its column says, whatever else its figures could mean
#[test]
fn headings_win_over_what_the_figures_could_mean() {
    for (table, sizes, unfit) in [
        ("line;actual;nominal\nA;50.015;50\n9999;50;50\n", [Some(50.015), None, None], vec![(3, "protocol-no-line")]),
        (
            "line;nominal;actual\nA;50;50.015\n9999;50;49.99\n",
            [Some(50.015), None, None],
            vec![(3, "protocol-no-line")],
        ),
        (
            "line;actual;nominal\n109;50.015;50\n113;50.02;50\n",
            [None; 3],
            vec![(2, "protocol-no-line"), (3, "protocol-no-line")],
        ),
        ("line;nominal;actual\nC;50;50.03\nA;50;50.01\n", [Some(50.01), None, Some(50.03)], vec![]),
        (
            "nr;actual;nominal\n3;50.015;50\n9;50;50\n",
            [None, None, Some(50.015)],
            vec![(3, "protocol-no-number-of-call")],
        ),
        ("nr;nominal;actual\nbore;50;50.01\nslot;77;77.2\n", [Some(50.01), None, None], vec![(3, "protocol-no-call")]),
        ("actual;nominal\n50.015;50\n50;50\n", [Some(50.015), Some(50.0), None], vec![]),
        ("nr;line;actual\n1;A;50.01\n2;C;50.02\n", [Some(50.01), None, None], vec![(3, "protocol-other-line")]),
        ("line;actual\nA.5;50.01\n-1;50.02\n", [None; 3], vec![(2, "protocol-no-line"), (3, "protocol-no-line")]),
        ("line;size\nA;50.01\n9999;50\n", [None; 3], vec![(2, "protocol-no-actual"), (3, "protocol-no-actual")]),
        (
            "line;actual\nA;\n;50.01\nB;50.02\n",
            [None, Some(50.02), None],
            vec![(2, "protocol-blank"), (3, "protocol-blank")],
        ),
        // what stands above the headings is no part of the table; the next headings may have another order
        ("7;50;50.09\nline;actual\nA;50.01\n", [Some(50.01), None, None], vec![(1, "protocol-above")]),
        (
            "line;actual;nominal\nA;50.01;50\nline;nominal;actual\nB;50;50.02\n",
            [Some(50.01), Some(50.02), None],
            vec![],
        ),
    ] {
        let (found, told) = come_to(table);
        let wanted: Vec<(u32, String)> = unfit.iter().map(|(line, why)| (*line, (*why).to_owned())).collect();
        assert_eq!((&found[..], &told), (&sizes[..], &wanted), "{table}");
    }
}

// oracle: hand: for each order of the columns, each sign between them and each sign of decimals, what was written is
// read, or the line is told; nothing else is ever read
#[test]
fn a_table_is_read_as_it_was_written_or_told() {
    let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let heads = ["line", "nominal", "actual"];
    let actual = [50.015, 49.5, 50.0];
    for (sign, decimal, quoted) in [';', '\t', '|', ',']
        .into_iter()
        .flat_map(|sign| [(sign, '.', false), (sign, '.', true), (sign, ',', false), (sign, ',', true)].into_iter())
    {
        let written = |value: f64| {
            let text = format!("{value:.3}").replace('.', &decimal.to_string());
            if quoted { format!("\"{text}\"") } else { text }
        };
        for order in orders {
            let row = |cells: [String; 3]| order.map(|at| cells[at].clone()).join(&sign.to_string()) + "\n";
            let body = lines_of_calls()
                .into_iter()
                .zip(actual)
                .map(|(line, value)| row([line.to_string(), written(50.0), written(value)]));
            let table: String = std::iter::once(row(heads.map(str::to_owned))).chain(body).collect();
            let (sizes, unfit) = come_to(&table);
            let cut = sign == ',' && decimal == ',' && !quoted;
            let wanted = if cut { vec![None; 3] } else { actual.map(Some).to_vec() };
            assert_eq!((sizes, unfit.len()), (wanted, if cut { 3 } else { 0 }), "{table}");
            assert!(unfit.iter().all(|(_, why)| why == "protocol-wide"), "{unfit:?}");
        }
    }
}

// oracle: RFC 4180, 2 (quotes, line breaks within them, quotes written twice), hand
#[test]
fn quotes_are_read_by_the_standard_of_such_tables() {
    for (table, sizes, unfit) in [
        (
            "line,name,actual\nA,\"bore\nB,x,50.5\",50.01\nB,\"a \"\"b\"\"\",50.02\n",
            [Some(50.01), Some(50.02), None],
            vec![],
        ),
        ("line;actual\nA;\"50.015\nB;50.02\n", [None, Some(50.02), None], vec![(2, "protocol-quote")]),
        ("line;actual\nA;\"50.015\nB;\"50.02\"\n", [None, Some(50.02), None], vec![(2, "protocol-quote")]),
        ("line;actual;note\nA;50.01;2\" pipe\nB;50.02;2\" pipe\n", [Some(50.01), Some(50.02), None], vec![]),
        ("line;actual\nA;50.01;note\n", [None; 3], vec![(2, "protocol-cells")]),
        ("line;actual\nA;50.01;;\n", [Some(50.01), None, None], vec![]),
    ] {
        let (found, told) = come_to(table);
        let wanted: Vec<(u32, String)> = unfit.iter().map(|(line, why)| (*line, (*why).to_owned())).collect();
        assert_eq!((&found[..], &told), (&sizes[..], &wanted), "{table}");
    }
}

// oracle: hand: without headings nobody knows whether a comma parts whole numbers or their decimals
#[test]
fn a_comma_between_whole_numbers_is_told() {
    for line in ["50,50,015", "50,50", "50,50,500"] {
        assert_eq!(come_to(&format!("{line}\n")), (vec![None; 3], vec![(1, "protocol-comma".to_owned())]), "{line}");
    }
    let chosen = columns(&[("number", "1"), ("actual", "2")]);
    let of = |text: &str| onto_nominal(text, Some(&chosen)).unwrap();
    assert_eq!(of("1,50,015\n2,50,02\n").unfit.len(), 2);
    assert_eq!(of("1,50\n2,50.02,7\n").fitted, 2);
}

// oracle: hand: a log that goes on in a second file is the log in one; a line is told with its file
#[test]
fn files_of_a_protocol_are_read_together() {
    let real = machine(0.06, [0.03, -0.02]);
    let outcome = run(&real);
    let (_, log) = outcome.files.iter().next().unwrap();
    let nominal = machine(0.0, [0.0; 2]);
    let of = |texts: &[String]| laid(texts, None, &nominal, &run(&nominal)).unwrap();
    let whole = of(&[log.join("\n")]);
    let cut = log.iter().rposition(|line| line.contains("_MVAR")).unwrap();
    let parts = of(&[log[..cut].join("\n"), format!("what\n{}", log[cut..].join("\n"))]);
    assert_eq!(values(&parts.answers), values(&whole.answers));
    assert_eq!(parts.unfit.last().map(|one| (one.file, one.line)), Some((1, 1)));
}

// oracle: hand
#[test]
fn a_picture_is_no_protocol() {
    let picture = String::from_utf8_lossy(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x01\0").into_owned();
    assert_eq!(onto_nominal(&picture, None).unwrap_err().message.key, "file-binary");
}

// oracle: hand: each line that is not laid is told, with its number and why
#[test]
fn no_line_is_dropped() {
    let chosen = columns(&[("number", "1"), ("nominal", "2"), ("actual", "3"), ("deviation", "4")]);
    let text = "1,50,50.02,0.02\n\n----\n9,50,50.02,0.02\n2,50,none,0.02\n2,50,50.02,0.05\n2,77,77.01,0.01\nend\n";
    let view = onto_nominal(text, Some(&chosen)).unwrap();
    let told: Vec<(u32, &str)> = view.unfit.iter().map(|one| (one.line, one.why.key.as_ref())).collect();
    let expected = [
        (4, "protocol-no-number-of-call"),
        (5, "protocol-no-number"),
        (6, "protocol-differs"),
        (7, "protocol-no-call"),
        (8, "protocol-no-number"),
    ];
    assert_eq!((view.fitted, &told[..]), (1, &expected[..]));
    let view = onto_nominal("CYCLE977, _MVAR, 1\nCYCLE978, _MVAR, 100\n50, 50.01, 0.01\nhello\n", None).unwrap();
    let told: Vec<&str> = view.unfit.iter().map(|one| one.why.key.as_ref()).collect();
    assert_eq!(told, ["protocol-no-heading", "protocol-no-call", "protocol-no-value"]);
}

// oracle: hand: 50.05 is 0.05 above 50, not 0.5; a tolerance zone behind the values is no difference, nor is nothing
#[test]
fn a_line_that_contradicts_itself_is_told() {
    let of = |line: &str| onto_nominal(&format!("CYCLE977, _MVAR, 1\n{line}\n"), None).unwrap();
    let view = of("D, hole, 50.000, 50.050, 0.500");
    assert_eq!((view.fitted, view.unfit.len()), (2, 0));
    let told: Vec<(u32, &str)> = view.doubtful.iter().map(|one| (one.line, one.why.key.as_ref())).collect();
    assert_eq!(told, [(2, "protocol-contradicted")]);
    for line in ["D, hole, 50.000, 50.050, 0.050", "D, hole, 50.000, 50.050", "D, hole, 50.000, 50.050, 55.100, 44.900"]
    {
        assert_eq!(of(line).doubtful, [], "{line}");
    }
}

// oracle: hand: the program says what stands in which column of its log, whatever else the line could mean
#[test]
fn a_log_is_read_by_what_the_program_prints() {
    for columns in [
        "_TXT[0],_OVR[1],_OVR[2],_OVR[5],_OVR[6]",
        "_OVR[6],_OVR[5],_OVR[0],_OVR[4]",
        "_OVR[4],_OVR[5],_TIME,_OVR[6],_OVR[17]",
    ] {
        let text =
            PROGRAM.replace("_PROTFORM[4]=3", "_PROTFORM[4]=1").replace("D,hole,_OVR[0],_OVR[4],_OVR[16]", columns);
        let text =
            text.replace("_PROTNAME[0]", "_HEADLINE[0]=\"Order 4711, part 12, 3 of 5\" _PROTFORM[3]=1 _PROTNAME[0]");
        let at = |off: [f64; 2]| {
            let mut setup = machine(0.06, off);
            for solid in &mut setup.workpiece.solids {
                let [x, y, z] = solid.at.0;
                solid.at = Mcs([x + 130.0, y + 130.0, z]);
            }
            setup
        };
        let text = text.replace("G0 X0 Y0", "G0 X130 Y130");
        let done = |setup: &Setup| {
            let program = syntax::read(Dialect::Sinumerik, text.as_bytes());
            Session::new(program, setup, Limits::default()).complete()
        };
        let (real, nominal) = (at([0.011, -0.007]), at([0.0; 2]));
        let outcome = done(&real);
        let (_, log) = outcome.files.iter().next().unwrap();
        let view = laid(&[log.join("\n")], None, &nominal, &done(&nominal)).unwrap();
        let of = |name: &str| {
            let figures = view.answers.iter().flat_map(|call| &call.answer.figures);
            figures.filter(|one| one.name == name).map(|one| (one.actual * 1e3).round() / 1e3).collect::<Vec<_>>()
        };
        let measured = |name: &str, value: f64| if columns.contains(name) { vec![value; 3] } else { Vec::new() };
        for (name, value) in [("_OVR[4]", 50.06), ("_OVR[5]", 130.011), ("_OVR[6]", 129.993)] {
            assert_eq!(of(name), measured(name, value), "{columns}: {name}\n{}", log.join("\n"));
        }
        assert_eq!(view.missing, 0);
    }
}

// oracle: manual B:11439-11441 (the mark says that a limit is exceeded), hand
#[test]
fn a_mark_that_the_tolerance_does_not_have_is_told() {
    let of = |line: &str| onto_nominal(&format!("CYCLE977, _MVAR, 1\n{line}\n"), None).unwrap();
    let keys = |view: &ProtocolView| view.doubtful.iter().map(|one| one.why.key.to_string()).collect::<Vec<_>>();
    assert_eq!(keys(&of("D, hole, 50.000, 50.050*, 0.050*")), ["protocol-marked"]);
    for fine in ["D, hole, 50.000, 50.050, 0.050", "D, hole, 50.000, 50.150*, 0.150*"] {
        assert_eq!(keys(&of(fine)), [""; 0], "{fine}");
    }
}

// oracle: hand: a chosen column leaves a value at the call of its heading
#[test]
fn chosen_columns_go_with_the_headings_of_the_log() {
    let text = "CYCLE977 ; _MVAR ; 1\n50.01\nCYCLE977 ; _MVAR ; 1\n50.02\n";
    let view = onto_nominal(text, Some(&columns(&[("actual", "1")]))).unwrap();
    let sizes: Vec<f64> =
        view.answers.iter().map(|call| call.answer.figures.first().map_or(0.0, |one| one.actual)).collect();
    assert_eq!(sizes, [50.01, 50.02, 0.0], "{:?}", view.unfit);
}

// oracle: hand: it comes to its end
#[test]
fn a_line_may_be_as_long_as_it_likes() {
    let view = onto_nominal(&format!("{}\n50;50.02;0.02\n", "77;".repeat(200_000)), None).unwrap();
    assert_eq!((view.fitted, view.unfit.len()), (1, 1));
    assert!(view.unfit[0].text.len() < 1000);
}

// oracle: hand
#[test]
fn a_protocol_with_nothing_to_read_is_refused() {
    let key = |text: &str, chosen: Option<ProtocolColumns>| {
        onto_nominal(text, chosen.as_ref()).unwrap_err().message.key.into_owned()
    };
    assert_eq!(key("", None), "protocol-empty");
    assert_eq!(key("\n---\n", None), "protocol-empty");
    assert_eq!(key("a;b\n1;2\n", Some(columns(&[("actual", "c")]))), "protocol-no-column");
    assert_eq!(key("a;b\n1;2\n", Some(columns(&[("nominal", "a")]))), "protocol-no-actual");
    let air = machine(0.0, [0.0; 2]);
    let nothing = Session::new(syntax::read(Dialect::Sinumerik, b"M30\n"), &air, Limits::default()).complete();
    assert_eq!(laid(&["50 50"], None, &air, &nothing).unwrap_err().message.key, "protocol-no-calls");
}

// oracle: hand
#[test]
fn a_field_is_a_figure_or_none() {
    use super::text::Figure;
    let value = |field: &str| Figure::of(field).map(|figure| figure.value);
    for (field, figure) in [
        ("50.02", Some(50.02)),
        ("+0,02", Some(0.02)),
        ("−0.02 mm", Some(-0.02)),
        ("Ø 50.1*", Some(50.1)),
        (".5", Some(0.5)),
        ("09:35:12", None),
        ("98/11/15", None),
        ("N10", None),
        ("1'132.015", Some(1132.015)),
        ("1’132", Some(1132.0)),
        ("1.132,015", Some(1132.015)),
        ("1,132.015", Some(1132.015)),
        ("1 132,015 mm", Some(1132.015)),
        ("-1\u{a0}234\u{a0}567,5*", Some(-1_234_567.5)),
        ("132.030,", Some(132.03)),
        ("132 015", None),
        ("1.132.015", None),
        ("1'32.015", None),
        ("1.132'015", None),
        ("1,32E+2", None),
        ("", None),
        ("-", None),
        (".", None),
        ("1.2.3", None),
        ("99999999999999", None),
    ] {
        assert_eq!(value(field), figure, "{field}");
    }
}

// oracle: hand: the figures of a log of another control stand in groups, and say the same of the same hole
#[test]
fn a_log_in_groups_is_laid_onto_the_calls() {
    let log = "Measuring log for touch probe cycle 421 Hole measuring\nNominal values:\n\
        Center in reference axis: 0.0000\nCenter in minor axis: 0.0000\nDiameter: 50.0000\n\
        Actual values:\nCenter in reference axis: 0.0810\nCenter in minor axis: -0.0470\nDiameter: 50.0259\n\
        Deviations:\nCenter in reference axis: 0.0810\nCenter in minor axis: -0.0470\nDiameter: 0.0259\n";
    let view = onto_nominal(log, None).unwrap();
    assert_eq!((view.fitted, view.missing, view.unfit.len()), (3, 2, 0), "{:?}", view.unfit);
    let first = values(&view.answers[..1]);
    let near = |wanted: f64| first.iter().any(|one| (one - wanted).abs() < 1e-9);
    assert!(near(50.0259) && near(0.081) && near(-0.047), "{first:?}");
}

/// The log of a hole of 50 mm, in its own unit with as many decimals; with the limits that it was measured against.
fn log_of_hole(actual: f64, inch: bool, with_limits: bool) -> String {
    let one = |mm: f64| if inch { format!("{:.5}", mm / 25.4) } else { format!("{mm:.4}") };
    let limits = format!("Maximum dimension for hole: {}\nMinimum dimension for hole: {}\n", one(50.045), one(50.0));
    format!(
        "Measuring log for touch probe cycle 421 Hole measuring\nType of dimension (0 = MM / 1 = INCH): {}\n\
         Nominal values:\nDiameter: {}\nGiven limit values:\n{}Actual values:\nDiameter: {}\nDeviations:\n\
         Diameter: {}\n",
        u8::from(inch),
        one(50.0),
        if with_limits { &limits } else { "" },
        one(actual),
        one(actual - 50.0),
    )
}

// oracle: peer (TNC7, log of cycle 421: 12.0259 between 12 and 12.045 is a good hole); hand: the control measures from
// the middle of the tolerance, the log tells the nominal value, in mm or in inches
#[test]
fn a_log_with_the_nominal_value_is_judged_by_the_same_limits() {
    let text = "G17 G54 G90 T9 D1\nM6\nG0 X0 Y0\nG0 Z-10\n_PRNUM=1 _SETVAL=50 _KNUM=0 _FA=2 _TSA=1 _MVAR=1 _VMS=0\n\
        _NMSP=1 _TUL=0.045 _TLL=0 _TZL=0.01 _TMV=0.02 _TDIF=0.5 _K=1 _EVNUM=0 _STA1=0\nCYCLE977\nM30\n";
    let nominal = machine(0.0, [0.0; 2]);
    let outcome =
        Session::new(syntax::read(Dialect::Sinumerik, text.as_bytes()), &nominal, Limits::default()).complete();
    for (actual, wanted) in
        [(50.0259, Verdict::Within), (50.001, Verdict::Within), (50.048, Verdict::Scrap), (49.995, Verdict::Rework)]
    {
        for (inch, with_limits) in [(false, false), (false, true), (true, false), (true, true)] {
            let log = log_of_hole(actual, inch, with_limits);
            let view = laid(&[log.as_str()], None, &nominal, &outcome).unwrap();
            assert_eq!(view.fitted, 1, "{log}{:?}", view.unfit);
            let answer = &view.answers[0].answer;
            assert_eq!(answer.verdict, wanted, "{log}");
            let (set, limits) = (answer.figures[0].set.unwrap(), answer.figures[0].limits.unwrap());
            let told = [set, set + limits.low, set + limits.high, answer.figures[0].actual];
            assert!(near(&told, &[50.0, 50.0, 50.045, actual], 4e-4), "{log}{told:?}");
        }
    }
}

// oracle: manual B:11356 (the mark is what the program says), B:13174 (decimals), hand: what the machine measured,
// rounded; a number of which nobody can tell whether its last digit is the mark is told
#[test]
fn a_log_is_read_with_the_marks_of_its_program() {
    let (real, nominal) = (machine(0.24, [0.3, -0.2]), machine(0.0, [0.0; 2]));
    let marks = ["*", "#", "1", "0", "E", "e", "ä", ".", "'", "-", "+", "|", "%", "←", " ", ""];
    let texts = marks.iter().flat_map(|mark| [0_i32, 1, 3, 4].map(|digits| (*mark, digits)));
    for ((mark, digits), separator) in texts.flat_map(|one| [",", ";", "/"].map(|separator| (one, separator))) {
        let symbols = format!("_PROTSYM[0]=\"{separator}\" _PROTSYM[1]=\"{mark}\" _DIGIT={digits}");
        let text = PROGRAM.replace("_PROTSYM[0]=\",\" _PROTSYM[1]=\"*\"", &symbols);
        let done = |setup: &Setup| {
            let program = syntax::read(Dialect::Sinumerik, text.as_bytes());
            Session::new(program, setup, Limits::default()).complete()
        };
        let outcome = done(&real);
        let record = Record::new(String::new(), &real, &outcome, Vec::new());
        let (_, log) = outcome.files.iter().next().unwrap_or_else(|| panic!("{symbols} {:?}", outcome.stop));
        let view = laid(&[log.join("\n")], None, &nominal, &done(&nominal)).unwrap();
        let name = format!("{symbols}\n{}\n{:#?}", log.join("\n"), view.unfit);
        let is_either = digits == 0 && mark.parse::<u32>().is_ok();
        let (read, measured) = (values(&view.answers), values(&record.calls));
        assert_eq!(read.len(), if is_either { 6 } else { measured.len() }, "{name}");
        let half = 0.51 * 0.1_f64.powi(digits);
        assert!(read.iter().all(|one| measured.iter().any(|other| (one - other).abs() < half)), "{read:?} {name}");
        assert_eq!(view.unfit.iter().any(|one| one.why.key == "protocol-mark"), is_either, "{name}");
        assert!(view.unfit.iter().all(|one| one.why.key != "protocol-no-call"), "{name}");
    }
}

// oracle: hand: a measurement that stands there twice is no other quantity; a result that is named is that one
#[test]
fn a_line_that_is_repeated_is_told() {
    let at = |text: &str| {
        let view = onto_nominal(text, None).unwrap();
        let told: Vec<_> = view.unfit.iter().map(|one| (one.line, one.why.key.to_string())).collect();
        (values(&view.answers), told)
    };
    let again = |line| vec![(line, "protocol-again".to_owned())];
    assert_eq!(at("Nr;Soll;Ist\n1;50,000;50,015\n1;50;50,016\n"), (vec![50.015], again(3)));
    assert_eq!(at("Nr;Soll;Ist;Abw\n1;50,000;50,015;0,015\n1;50;50,016;0,5\n").1.len(), 1);
    // a centre is expected at 3 by the log: all three figures agree, or its result is named
    let centre = "Nr;Soll;Ist;Abw\n1;50,000;50,015;0,015\n1;3;3,016;0,016\n";
    assert_eq!(at(centre), (vec![50.015, 3.016], Vec::new()));
    for head in ["Result", "Ergebnis", "Variable"] {
        let named = format!("Nr;{head};Soll;Ist\n1;_OVR[6];0;0,016\n1;_ovr[4];50;50,015\n");
        let (all, told) = at(&named);
        assert_eq!((&all[..], told.len()), (&[50.015, 0.016][..], 0), "{named}");
    }
    // above a verdict stands no name
    let (all, told) = at("Nr;Ergebnis;Soll;Ist\n1;i.O.;50;50,015\n2;n.i.O.;50;50,2\n");
    assert_eq!((&all[..], told.len()), (&[50.015, 50.2][..], 0));
}

// oracle: hand
#[test]
fn columns_that_could_be_meant_as_well_are_told() {
    let keys = |text: &str, chosen: Option<&ProtocolColumns>| {
        let view = onto_nominal(text, chosen).unwrap();
        assert_eq!(values(&view.answers), [50.015], "{text}");
        view.doubtful.iter().map(|one| (one.line, one.why.key.to_string())).collect::<Vec<_>>()
    };
    let told = [(1, "protocol-two-columns".to_owned())];
    assert_eq!(keys("Nr;Soll;Ist;Ist\n1;50;50,015;50,3\n", None), told);
    assert_eq!(keys("Nr;Soll;Ist;Messwert\n1;50;50,015;50,3\n", None), told);
    let named = columns(&[("nominal", "Soll"), ("actual", "ist")]);
    assert_eq!(keys("Nr;Soll;Ist;Ist\n1;50;50,015;50,3\n", Some(&named)), told);
    assert_eq!(keys("Nr;Soll;Ist;Messwert\n1;50;50,015;50,3\n", Some(&named)), []);
    let numbered = columns(&[("nominal", "2"), ("actual", "3")]);
    assert_eq!(keys("Nr;Soll;Ist;Ist\n1;50;50,015;50,3\n", Some(&numbered)), []);
    for same in [columns(&[("nominal", "2"), ("actual", "2")]), columns(&[("nominal", "Soll"), ("actual", "2")])] {
        let refused = onto_nominal("Nr;Soll;Ist\n1;50;50,015\n", Some(&same)).unwrap_err();
        assert_eq!(refused.message.key, "protocol-same-column");
    }
}
