//! The masks against the tables of the manual, in `tests/data`.

use super::data;
use probewright_core::jog::mask::{Kind, Least, Show};
use probewright_core::jog::{FUNCTIONS, OLDER, masks};
use std::collections::BTreeSet;

fn rows(text: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    text.lines().skip(1).map(|line| line.split('\t').collect())
}

fn takes(kind: Kind) -> String {
    match kind {
        Kind::Offset { turned: false } => "offset".into(),
        Kind::Offset { turned: true } => "turned offset".into(),
        Kind::Length(Least::Any) => "mm".into(),
        Kind::Length(Least::Zero) => "mm >= 0".into(),
        Kind::Length(Least::Above) => "mm > 0".into(),
        Kind::Angle => "deg".into(),
        Kind::Words(words) => words.join("|"),
        Kind::OtherAxis => "other axis".into(),
        Kind::Turned => "rotation or axis".into(),
    }
}

// oracle: manual (tests/data/jog_fields.tsv has the line of each field)
#[test]
fn every_mask_has_the_fields_of_the_control_in_their_order() {
    let mut seen = 0;
    for mask in masks::all() {
        let wanted: Vec<Vec<&str>> = rows(data!("jog_fields.tsv")).filter(|row| row[0] == mask.name).collect();
        let names: Vec<&str> = wanted.iter().map(|row| row[1]).collect();
        assert_eq!(mask.fields.iter().map(|field| field.name).collect::<Vec<_>>(), names, "{}", mask.name);
        for (field, row) in mask.fields.iter().zip(&wanted) {
            assert_eq!(takes(field.kind), row[2], "{} {}", mask.name, field.name);
            let when = field.when.iter().map(|(name, words)| format!("{name}={}", words.join("|")));
            let when = Some(when.collect::<Vec<_>>().join(" ")).filter(|when| !when.is_empty());
            assert_eq!(when.as_deref().unwrap_or("-"), row[3], "{} {}", mask.name, field.name);
            let cited: BTreeSet<&str> = field.source.split(';').collect();
            assert!(cited.iter().all(|line| line.contains(':')), "{} {}", mask.name, field.name);
        }
        seen += wanted.len();
    }
    assert_eq!(seen, rows(data!("jog_fields.tsv")).count());
}

// oracle: manual (tests/data/jog_masks.tsv has the lines of each function)
#[test]
fn every_function_has_its_masks_points_and_results() {
    assert_eq!(FUNCTIONS.len(), 18);
    let older = OLDER.iter().filter(|function| function.masks.iter().all(|mask| mask.older.is_some()));
    assert_eq!((older.clone().count(), OLDER.len()), (6, 9), "tools are measured alike");
    let there: BTreeSet<String> = FUNCTIONS
        .iter()
        .chain(older)
        .flat_map(|function| {
            function.masks.iter().map(move |mask| {
                let shows: Vec<&str> = mask
                    .shows
                    .iter()
                    .map(|show| match show {
                        Show::Translation => "translation",
                        Show::Rotation => "rotation",
                        Show::Turned => "rotary rotation",
                        Show::Measuring => "measuring",
                        Show::Length(name) | Show::Angle(name) => name,
                    })
                    .collect();
                let shows = Some(shows.join(" ")).filter(|shows| !shows.is_empty());
                let shows = shows.as_deref().unwrap_or("-").to_owned();
                format!("{}\t{}\t{}\t{shows}\t{}", function.name, mask.name, mask.points, mask.source)
            })
        })
        .collect();
    let wanted: BTreeSet<String> = rows(data!("jog_masks.tsv")).map(|row| row.join("\t")).collect();
    assert_eq!(there, wanted);
}
