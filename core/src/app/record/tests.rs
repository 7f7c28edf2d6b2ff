//! The record says what the results, the limits and the calibrations of a run say.
#![allow(clippy::unwrap_used, clippy::panic)]

use super::table::COLUMNS;
use super::*;
use crate::app::{self, Verdict};
use crate::control::{Plane, Units};
use crate::json;
use crate::run::{Limits, Session};
use crate::syntax;

/// The record of a program on a milling machine with a calibrated probe and a hole of 50 mm, by so much too large.
fn record(text: &str, size: f64, change: impl FnOnce(&mut Setup)) -> Record {
    let cycle = crate::catalogue::find(Dialect::Sinumerik, "CYCLE977").unwrap();
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.suit(cycle, 1);
    setup.workpiece = hole(size);
    change(&mut setup);
    let program = syntax::read(Dialect::Sinumerik, text.as_bytes());
    let outcome = Session::new(program, &setup, Limits::default()).complete();
    Record::new("part.mpf".to_owned(), &setup, &outcome, Vec::new())
}

/// A hole of 50 mm about the zero point, its upper edge at Z0.
fn hole(size: f64) -> crate::workpiece::Workpiece {
    let setup = format!(
        r#"{{ "control": "sinumerik", "probe": {{ "radius": 3, "length": 50 }}, "workpiece": [
            {{ "shape": "hole", "size": [50, 40], "at": [0, 0, 0], "errors": {{ "size": {size} }} }} ] }}"#
    );
    crate::json::setup_from_json(&setup).unwrap().workpiece
}

/// Measures the hole, once with each of these lines before the call.
const MEASURE: &str = "G17 G54 G90 T9 D1\nM6\nG0 X0 Y0\nG0 Z-10\n_PRNUM=1 _SETVAL=50 _KNUM=0 _FA=2 _TSA=1 _MVAR=1 \
    _VMS=0 _NMSP=1 _TUL=0.1 _TLL=-0.05 _TZL=0.01 _TMV=0.02 _TDIF=0.5 _K=1 _EVNUM=0 _STA1=0\nCYCLE977\nM30\n";

fn near(one: f64, other: f64) -> bool {
    (one - other).abs() < 1e-6
}

// oracle: manual B:2203-2211 (−0.05 to 0.1 is ±0.075 about a setpoint of 50.025), hand: the share of these 0.075
#[test]
fn a_row_has_its_limits_and_how_much_of_them_is_used() {
    for (size, used) in [(0.055, 0.4), (-0.02, 0.6), (0.025, 0.0), (0.115, 1.2)] {
        let record = record(MEASURE, size, |_| {});
        let call = &record.calls[0];
        let figure = &call.answer.figures[0];
        let limits = figure.limits.unwrap_or_else(|| panic!("{call:?}"));
        assert!(near(figure.deviation.unwrap(), size - 0.025) && near(figure.set.unwrap(), 50.025), "{figure:?}");
        assert!(near(limits.low, -0.075) && near(limits.high, 0.075), "{limits:?}");
        assert!(near(limits.used.unwrap(), used), "{limits:?}");
        assert_eq!(call.answer.verdict == Verdict::Within, used <= 1.0, "{call:?}");
        assert_eq!(call.alarms.is_empty(), used <= 1.0, "{:?}", call.alarms);
    }
}

// oracle: manual B:1787-1795 (a result counts in the system that was active at its call), hand
#[test]
fn a_result_keeps_the_unit_of_its_call() {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.suit(crate::catalogue::find(Dialect::Sinumerik, "CYCLE977").unwrap(), 1);
    setup.workpiece = hole(0.03);
    for (text, units) in [(MEASURE.to_owned(), Units::Metric), (MEASURE.replace("M30", "G70\nM30"), Units::Metric)] {
        let program = syntax::read(Dialect::Sinumerik, text.as_bytes());
        let outcome = Session::new(program, &setup, Limits::default()).complete();
        let left = outcome.left();
        assert_eq!(left.iter().map(|one| one.units).collect::<Vec<_>>(), [units], "{text}");
        assert!(left[0].results.iter().any(|(field, value)| field.name == "_OVR[4]" && near(*value, 50.03)));
    }
}

// oracle: hand: the data of the control are those of the probe; with a ball that is 0.1 mm smaller they are not
#[test]
fn a_row_says_whence_the_calibration_of_its_probe() {
    let state = |record: &Record| record.calls.iter().map(|call| call.probe.state).collect::<Vec<_>>();
    let stored = record(MEASURE, 0.0, |_| {});
    assert_eq!(state(&stored), [CalibrationState::Stored]);
    assert_eq!((stored.calls[0].probe.number, stored.calls[0].probe.tool), (1, false));
    let other = record(MEASURE, 0.0, |setup| setup.probe.radius -= 0.05);
    assert_eq!(state(&other), [CalibrationState::Differs]);
    // CYCLE976 in the hole as a ring of 50 mm, then the hole with the same probe and with another one
    let calibrate =
        MEASURE.replace("CYCLE977", "_MVAR=1 _CALNUM=1 _CORA=0 _TZL=0 _SETVAL=50\nCYCLE976\n_MVAR=1\nCYCLE977");
    let twice = calibrate.replace("M30", "_PRNUM=2\nCYCLE977\nM30");
    let record = record(&twice, 0.0, |setup| setup.probe.radius -= 0.05);
    let expected = [CalibrationState::Calibrates, CalibrationState::Run, CalibrationState::Differs];
    assert_eq!(state(&record), expected, "{:?}", record.calls);
    assert_eq!(record.calls[1].probe.line, record.calls[0].call.line);
}

/// As the key, but for the decimal sign.
fn plain(message: &Message, comma: &str) -> String {
    if message.key == "record-decimal-sign" { comma.to_owned() } else { message.key.to_string() }
}

// oracle: hand: fields of a spreadsheet: parted by commas with a decimal point, by semicolons with a comma
#[test]
fn the_table_has_a_line_for_each_quantity() {
    let record = record(MEASURE, 0.055, |_| {});
    for (sign, parted) in [(".", ','), (",", ';')] {
        let text = csv(&record, &|message| plain(message, sign));
        let lines: Vec<&str> = text.strip_prefix('\u{feff}').unwrap().split_terminator("\r\n").collect();
        assert_eq!(lines.len(), 1 + record.calls[0].answer.figures.len());
        assert!(lines.iter().all(|line| line.split(parted).count() == COLUMNS.len()), "{text}");
        let row: Vec<&str> = lines[1].split(parted).collect();
        let numbers = ["50.025", "-0.075", "0.075", "50.055", "0.03", "0.4"].map(|number| number.replace('.', sign));
        assert_eq!(row[..3], ["1", "6", "CYCLE977"], "{text}");
        assert_eq!(row[5..11], numbers, "{text}");
        let within = |line: &str| line.split(parted).nth(12).unwrap().to_owned();
        assert_eq!([within(lines[1]), within(lines[2])], ["record-within", "record-unlimited"], "each by itself");
    }
}

// oracle: hand
#[test]
fn a_text_in_the_table_breaks_no_column_and_is_no_formula() {
    let mut record = record(MEASURE, 0.0, |_| {});
    record.files = vec![RecordFile { name: "=a;\"b\",c\nd.spf".to_owned(), line: 2 }];
    let text = csv(&record, &|message| plain(message, "."));
    assert!(text.contains("\r\n1,\"'=a;\"\"b\"\",c\nd.spf:5\",CYCLE977,"), "{text}");
}

// oracle: hand: a call that finds nothing has a line, with its alarm
#[test]
fn a_call_without_a_result_has_a_line() {
    let record = record(MEASURE, 0.0, |setup| setup.workpiece = crate::workpiece::Workpiece::default());
    let call = record.calls.last().unwrap();
    assert!(call.answer.figures.is_empty() && !call.alarms.is_empty(), "{call:?}");
    let text = csv(&record, &|message| plain(message, "."));
    let last = text.trim_end().rsplit("\r\n").next().unwrap();
    assert!(last.starts_with("1,6,CYCLE977,") && last.contains(&call.alarms[0]), "{text}");
}

/// What of a document is not as its schema says; `at`: the place.
#[cfg(feature = "cli")]
fn wrong(at: &str, value: &serde_json::Value, schema: &serde_json::Value, root: &serde_json::Value) -> Vec<String> {
    if let Some(name) = schema["$ref"].as_str().and_then(|path| path.strip_prefix("#/$defs/")) {
        return wrong(at, value, &root["$defs"][name], root);
    }
    if let Some(any) = schema["anyOf"].as_array() {
        let fits = any.iter().any(|one| wrong(at, value, one, root).is_empty());
        return if fits { Vec::new() } else { vec![format!("{at}: none of them")] };
    }
    let sort = match value {
        serde_json::Value::Null => "null",
        serde_json::Value::Bool(_) => "boolean",
        serde_json::Value::Number(number) if number.is_f64() => "number",
        serde_json::Value::Number(_) => "integer",
        serde_json::Value::String(_) => "string",
        serde_json::Value::Array(_) => "array",
        serde_json::Value::Object(_) => "object",
    };
    let types = schema["type"].as_array().cloned().unwrap_or_else(|| vec![schema["type"].clone()]);
    let known = types.iter().any(|one| one.is_null() || one == sort || one == "number" && sort == "integer");
    let mut found = if known { Vec::new() } else { vec![format!("{at}: {sort}")] };
    for name in schema["required"].as_array().into_iter().flatten().filter_map(|name| name.as_str()) {
        found.extend(value.get(name).is_none().then(|| format!("{at}: no {name}")));
    }
    for (name, one) in value.as_object().into_iter().flatten() {
        match &schema["properties"][name] {
            serde_json::Value::Null if schema["properties"].is_object() => found.push(format!("{at}: {name}?")),
            own => found.extend(wrong(&format!("{at}.{name}"), one, own, root)),
        }
    }
    let elements = value.as_array().into_iter().flatten();
    found.extend(elements.flat_map(|one| wrong(&format!("{at}[]"), one, &schema["items"], root)));
    found
}

// oracle: self: the document is what the schema in docs says, nothing more and nothing less
#[cfg(feature = "cli")]
#[test]
fn the_document_is_as_its_schema_says() {
    let schema = crate::setup_file::schema::<Record>();
    let crash = |setup: &mut Setup| setup.workpiece = crate::workpiece::Workpiece::default();
    for record in [record(MEASURE, 0.055, |_| {}), record(MEASURE, 0.3, |_| {}), record(MEASURE, 0.0, crash)] {
        let document = crate::json::document(&record);
        assert_eq!(wrong("record", &document, &schema, &schema), Vec::<String>::new());
    }
    let without = serde_json::json!({ "format": "1" });
    assert!(wrong("record", &without, &schema, &schema).len() > 3, "what is wrong is found");
}

// oracle: self (a session in the page is that of the terminal, where the part lies the same)
#[test]
fn a_session_has_the_same_record_in_page_and_terminal() {
    let script = "mask set_edge\nzo = G54\nx0 = 10\njog Z-40\njog X20\nstart\n";
    let request = r#"{ "control": "sinumerik", "script": "", "seed": 7 }"#;
    let asked = app::PracticeRequest { script: script.to_owned(), ..json::question(request).unwrap() };
    let page = app::practice_record(asked, "edge.jog").unwrap();
    let setup = crate::jog::practice::machine(Default::default());
    let view = app::jog(script, &setup, Some(7)).unwrap();
    assert!(page.calls.iter().any(|call| !call.answer.figures.is_empty()), "{page:?}");
    assert_eq!(page, Record::of_jog("edge.jog".to_owned(), &setup, view));
}

// oracle: manual B:1346-1360, hand: a safe area is no limit of the part
#[test]
fn a_safe_area_is_no_tolerance() {
    let record = record(&MEASURE.replace("_MVAR=1 ", "_MVAR=101 "), 0.01, |_| {});
    let call = &record.calls[0];
    assert!(!call.answer.figures.is_empty() && call.answer.gauge.is_some(), "{call:?}");
    assert!(call.answer.figures.iter().all(|figure| figure.limits.is_none()), "{call:?}");
    assert_eq!(call.answer.why.key, "answer-why-area");
    let text = csv(&record, &|message| plain(message, "."));
    assert!(text.contains("record-unlimited") && !text.contains("record-within"), "{text}");
}

// oracle: definition: a moment that nobody gave is none
#[test]
fn a_record_has_the_clock_of_its_setup_only() {
    assert_eq!(record(MEASURE, 0.0, |_| {}).about.clock, "");
    let clock = "2026-05-31T08:00:00";
    assert_eq!(record(MEASURE, 0.0, |setup| setup.clock = clock.parse().unwrap()).about.clock, clock);
}
