//! Where a program goes on: jumps, branches, loops. Structure is found once, before the run.

use super::programs::Programs;
use super::tree::{Program, Word, WordKind};
use std::collections::BTreeMap;

/// What stands at a block with a control structure, with the blocks that belong to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Link {
    /// `IF`: block of `ELSE` or `ENDIF`.
    If(usize),
    /// `ELSE`: block of `ENDIF`.
    Else(usize),
    /// `ENDIF`.
    EndIf,
    /// `WHILE`, `FOR`, `LOOP`, `REPEAT`: block of its end.
    Begin(usize),
    /// `ENDWHILE`, `ENDFOR`, `ENDLOOP`, `UNTIL`: block of its begin.
    End(usize),
    /// Begin or end without its counterpart.
    Alone,
}

/// Links by block.
pub type Links = BTreeMap<usize, Link>;

/// Finds what belongs together. NCT `WHILE … DOn`, or `DOn` alone, and `ENDn` pair where their numbers are the same.
pub fn links(program: &Program, programs: &Programs) -> Links {
    let mut links = Links::new();
    let mut open: Vec<Open> = Vec::new();
    for (i, block) in program.blocks.iter().enumerate() {
        let words = program.words_of(block);
        if programs.units.binary_search_by_key(&i, |unit| unit.blocks.start).is_ok() {
            open.clear();
        }
        let Some(name) = structural(program, words) else { continue };
        let number = loop_number(program, words);
        if let Some(end) = end_of(name) {
            links.insert(i, Link::Alone);
            open.push(Open { block: i, end, number, otherwise: false });
            continue;
        }
        let matching = open.last().is_some_and(|open| {
            (open.end == name && open.number == number) || (open.end == "ENDIF" && name == "ELSE" && !open.otherwise)
        });
        let Some(Open { block: begin, end, otherwise, .. }) = matching.then(|| open.pop()).flatten() else {
            links.insert(i, Link::Alone);
            continue;
        };
        if name == "ELSE" {
            links.insert(begin, Link::If(i));
            links.insert(i, Link::Alone);
            open.push(Open { block: i, end, number, otherwise: true });
        } else if name == "ENDIF" {
            links.insert(begin, if otherwise { Link::Else(i) } else { Link::If(i) });
            links.insert(i, Link::EndIf);
        } else {
            links.insert(begin, Link::Begin(i));
            links.insert(i, Link::End(begin));
        }
    }
    links
}

/// A structure whose end has not come yet.
struct Open {
    block: usize,
    end: &'static str,
    /// NCT: number behind `DO`, which `END` repeats.
    number: Option<f64>,
    /// Whether it is the `ELSE` part.
    otherwise: bool,
}

/// Word that ends what this one begins.
fn end_of(name: &str) -> Option<&'static str> {
    Some(match name {
        "IF" => "ENDIF",
        "WHILE" | "DO" => "ENDWHILE",
        "FOR" => "ENDFOR",
        "LOOP" => "ENDLOOP",
        "REPEAT" => "UNTIL",
        _ => return None,
    })
}

/// The word of a block that belongs to a control structure; an `IF` with a jump is none.
pub fn structural(program: &Program, words: &[Word]) -> Option<&'static str> {
    let jump = |word: &Word| {
        program.is_keyword(word, &["GOTO", "GOTOF", "GOTOB", "GOTOC", "THEN"]) || program.is_call(word, &["GOTOS"])
    };
    words.iter().find_map(|word| {
        let WordKind::Keyword { name, value } = &word.kind else { return None };
        if program.is(*name, "END") {
            return Some("ENDWHILE");
        }
        let found = program.grammar().structures.iter().find(|known| program.is(*name, known))?;
        let labelled = *found == "REPEAT" && value.is_some();
        let jump = ["IF", "ELSE"].contains(found) && words.iter().any(jump);
        (!jump && !labelled).then_some(*found)
    })
}

/// The number behind `DO` or `END` of NCT.
fn loop_number(program: &Program, words: &[Word]) -> Option<f64> {
    words.iter().find_map(|word| match word.kind {
        WordKind::Keyword { value: Some(value), .. } if program.is_keyword(word, &["DO", "END"]) => {
            program.number(value)
        }
        _ => None,
    })
}
