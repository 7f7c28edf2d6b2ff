//! What CYCLE119 refuses, how it is drawn, written and read.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod simulation;

use super::*;
use crate::catalogue::example::example;
use crate::check::check;
use crate::control::delivery;
use crate::diagnostic::Code;
use crate::dialect::Dialect;
use crate::entry::Typed;
use crate::form::draw;
use crate::name::Name;
use crate::own;
use crate::picture::ShapeKind;
use crate::program::calls::calls;
use crate::program::write::snippet;
use crate::syntax::read;

fn typed(changes: &[(&str, &str)]) -> Typed {
    let mut typed = example(&CYCLE119, &CYCLE119.variants[0]);
    let pair = |(name, value): &(&str, &str)| ((*name).to_owned(), (*value).to_owned());
    typed.extend(changes.iter().map(pair));
    typed
}

fn found(changes: &[(&str, &str)]) -> Vec<(Code, Option<&'static str>)> {
    let found = check(&CYCLE119, &typed(changes), &delivery(Dialect::Sinumerik)).diagnostics;
    found.iter().map(|one| (one.code, one.param.map(Name::as_str))).collect()
}

// oracle: manual A:15930 (61411), B:8566-8573, B:1971 (global basic frames take no rotation)
#[test]
fn what_gives_no_frame_is_refused() {
    assert_eq!(found(&[]), []);
    let line = [("_SETPOINT[1,0]", "5"), ("_SETPOINT[1,1]", "0"), ("_SETPOINT[1,2]", "15")];
    assert_eq!(found(&line), [(Code::Alarm(61411), Some("_SETPOINT[2,0]"))]);
    let same = [("_MEASPOINT[1,0]", "11"), ("_MEASPOINT[1,1]", "0")];
    assert_eq!(found(&same), [(Code::Alarm(61411), Some("_MEASPOINT[2,0]"))]);
    assert_eq!(found(&[("_COR", "1051")]), [(Code::Alarm(61321), Some("_COR"))]);
    assert_eq!(found(&[("_COR", "500")]), [(Code::Alarm(61321), Some("_COR"))]);
    assert_eq!(found(&[("_RESLIM", "")]), [(own::MISSING.code(), Some("_RESLIM"))]);
    assert_eq!(found(&[("_RESLIM", ""), ("_COR", "0")]), [], "nothing is corrected");
}

// oracle: manual B:8600-8622 (the measured points lie 1 mm beside the set ones in X)
#[test]
fn the_picture_shows_both_triangles() {
    let drawn = draw(&CYCLE119, &typed(&[]), &delivery(Dialect::Sinumerik)).unwrap();
    let triangle = |kind| {
        let shape = drawn.shapes.iter().find(|one| one.kind == kind && one.closed);
        shape.unwrap().points.clone()
    };
    let (set, measured) = (triangle(ShapeKind::Material), triangle(ShapeKind::Path));
    for (set, measured) in set.iter().zip(&measured) {
        assert_eq!([set[0] + 1.0, set[1]], *measured);
    }
}

// oracle: manual B:8600-8622 (the example, with arrays of its own names, and G54 by its number)
#[test]
fn the_example_of_the_manual_is_read_and_written() {
    let text = b"DEF REAL SOLL[3,3], IST[3,3]\nDEF REAL RES, RESLIMIT\nDEF INT ALARM\nDEF FRAME REFRAME\n\
        SOLL[0,0]=SET(10,0,0)\nSOLL[1,0]=SET(0,20,0)\nSOLL[2,0]=SET(0,0,30)\n\
        IST[0,0]=SET(11,0,0)\nIST[1,0]=SET(1,20,0)\nIST[2,0]=SET(1,0,30)\n\
        CYCLE119(SOLL,IST,ALARM,RES,REFRAME,1,1.2)\nM2\n";
    let found = calls(&read(Dialect::Sinumerik, text));
    assert_eq!(found[0].values, typed(&[]));
    let control = delivery(Dialect::Sinumerik);
    let written = snippet(&CYCLE119, &typed(&[]), &control, Style::Direct, None).text;
    let call = "CYCLE119(_SETPOINT,_MEASPOINT,_ALARM,_RES,_REFRAME,1,1.2)\n";
    assert!(written.ends_with(call), "{written}");
    let again = calls(&read(Dialect::Sinumerik, written.as_bytes()));
    assert_eq!(again[0].values, typed(&[]));
}
