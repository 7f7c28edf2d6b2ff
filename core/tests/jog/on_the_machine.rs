//! Every mask on the machine to practise on, as the page opens it: tests/data/jog_practice.json has what is done,
//! which the tests of the page do by mouse, keys and touch.

use probewright_core::app::{Practice, PracticeRequest, as_program, practise};
use probewright_core::dialect::Dialect;
use probewright_core::jog::practice::piece;
use probewright_core::jog::{FUNCTIONS, State, masks};
use std::collections::BTreeMap;

fn asked(mask: &str, lines: &[String]) -> PracticeRequest {
    PracticeRequest {
        control: Dialect::Sinumerik,
        setup: None,
        piece: Some(piece(masks::find(mask).unwrap())),
        script: [&[format!("mask {mask}")], lines].concat().join("\n"),
        seed: None,
        part: None,
        hides: false,
    }
}

// oracle: hand: each mask has its lines, writes something, and a zero offset where the part lies
#[test]
fn every_mask_is_done_on_its_machine() {
    let all: BTreeMap<String, Vec<String>> = serde_json::from_str(super::data!("jog_practice.json")).unwrap();
    let masks: Vec<&str> = FUNCTIONS.iter().flat_map(|one| one.masks).map(|mask| mask.name).collect();
    for mask in &masks {
        let lines = all.get(*mask).unwrap_or_else(|| panic!("{mask} has no lines"));
        let (view, _) = practise(asked(mask, lines)).unwrap();
        assert_eq!(view.refused, None, "{mask}");
        assert!(view.raised.is_none(), "{mask}: {:?}", view.raised);
        assert_eq!(view.state, State::Mask, "{mask}");
        assert!(!view.changes.is_empty() || ["align_edge", "align_plane"].contains(mask), "{mask} wrote nothing");
        let corrects = masks::find(mask).unwrap().task.corrects();
        assert_eq!(view.deviation.is_some(), corrects, "{mask}");
        for figure in view.deviation.iter().flat_map(|found| &found.figures) {
            assert!(figure.value.abs() < 1e-6, "{mask}: {figure:?}");
        }
        let program = as_program(asked(mask, lines)).unwrap();
        let centres = mask.starts_with("holes_") || mask.starts_with("spigots_");
        assert_eq!(program.text.is_empty(), centres, "{mask}: {:?}", program.told);
    }
    assert_eq!(all.len(), masks.len());
}

// oracle: self: what was asked before changes no answer, whether it is a line more, a line less, a line that is
// refused, another part or another mask
#[test]
fn a_session_that_goes_on_answers_as_a_new_one() {
    let all: BTreeMap<String, Vec<String>> = serde_json::from_str(super::data!("jog_practice.json")).unwrap();
    let mut session = Practice::default();
    let mut same = |asked: PracticeRequest| {
        let [(view, seen), (anew, there)] =
            [session.practise(asked.clone()), practise(asked.clone())].map(Result::unwrap);
        assert_eq!(view, anew, "{asked:?}");
        assert_eq!(seen.setup, there.setup, "{asked:?}");
        assert_eq!(seen.outcome, there.outcome, "{asked:?}");
    };
    for (mask, lines) in &all {
        for count in 0..=lines.len() {
            same(asked(mask, &lines[..count]));
        }
        let and = |more: &[&str]| {
            let more: Vec<String> = more.iter().map(|one| (*one).to_owned()).collect();
            asked(mask, &[&lines[..], &more].concat())
        };
        let moved = PracticeRequest { seed: Some(3), ..asked(mask, lines) };
        let keys =
            [and(&["jog Z1"]), and(&["jog Z2"]), and(&["jog Z2", "reject P4"]), and(&["jog Z3"]), and(&["jog Q5"])];
        for one in keys.into_iter().chain([asked(mask, &lines[..lines.len() - 1]), moved.clone()]) {
            same(one);
        }
        same(PracticeRequest { hides: true, ..moved });
        same(asked(mask, lines));
    }
}
