//! What CYCLE116 refuses, how it is drawn and called.

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
use crate::program::calls::calls;
use crate::program::write::snippet;
use crate::syntax::read;

fn typed(changes: &[(&str, &str)]) -> Typed {
    let mut typed = example(&CYCLE116, &CYCLE116.variants[0]);
    let pair = |(name, value): &(&str, &str)| ((*name).to_owned(), (*value).to_owned());
    typed.extend(changes.iter().map(pair));
    typed
}

fn codes(changes: &[(&str, &str)]) -> Vec<Code> {
    let found = check(&CYCLE116, &typed(changes), &delivery(Dialect::Sinumerik)).diagnostics;
    found.iter().map(|one| one.code).collect()
}

// oracle: manual B:2447-2448, A:15857-15858
#[test]
fn points_that_determine_no_circle_are_refused() {
    assert_eq!(codes(&[]), []);
    assert_eq!(codes(&[("_DATE[3]", "0")]), [Code::Alarm(61316)]);
    assert_eq!(codes(&[("_DATE[0]", "5")]), [Code::Alarm(61317)]);
    let fourth = [("_DATE[0]", "4"), ("_DATE[7]", "10"), ("_DATE[8]", "0")];
    assert_eq!(codes(&fourth), []);
    assert_eq!(codes(&fourth[..2]).len(), 1, "its ordinate is missing");
}

// oracle: manual B:2456-2466
#[test]
fn the_picture_shows_the_circle() {
    let control = delivery(Dialect::Sinumerik);
    let drawn = draw(&CYCLE116, &typed(&[]), &control).unwrap();
    let edge = drawn.shapes.iter().find(|one| one.kind == ShapeKind::Edge);
    let (centre, radius) = edge.unwrap().circle.unwrap();
    assert!(centre[0].abs() < 1e-9 && centre[1].abs() < 1e-9 && (radius - 10.0).abs() < 1e-9);
}

// oracle: manual B:2456-2462
#[test]
fn a_program_may_use_an_array_of_its_own() {
    let text = b"DEF INT FAULT\nDEF REAL P[13]\nP[0]=3 P[1]=0 P[2]=10\nP[3]=-10 P[4]=0 P[5]=0 P[6]=-10\n\
        CYCLE116(P,FAULT)\nM30\n";
    let found = calls(&read(Dialect::Sinumerik, text));
    assert_eq!(found[0].values, typed(&[]));
    let control = delivery(Dialect::Sinumerik);
    let written = snippet(&CYCLE116, &typed(&[]), &control, Style::Direct, None).text;
    assert!(written.ends_with("CYCLE116(_DATE,_ALM)\n"), "{written}");
}
