//! Reading part programs: nothing is lost, nothing panics, and the manuals' programs are understood.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::diagnostic::Span;
use probewright_core::dialect::Dialect;
use probewright_core::message::Message;
use probewright_core::program::findings;
use probewright_core::syntax::tree::WordKind;
use probewright_core::syntax::{Program, read};
use proptest::prelude::*;
use std::path::{Path, PathBuf};

const DIALECTS: [Dialect; 2] = [Dialect::Sinumerik, Dialect::Nct];

fn inside(inner: Span, outer: Span) -> bool {
    outer.start <= inner.start && inner.start <= inner.end && inner.end <= outer.end
}

/// Lines in order and inside the source, words and comments in order and inside their line; gaps hold separators only.
fn check_places(program: &Program) {
    let whole = Span { start: 0, end: program.source.len() as u32 };
    let mut behind = 0;
    let mut next_word = 0;
    for block in &program.blocks {
        assert!(inside(block.span, whole) && block.span.start >= behind);
        let gap = program.text(Span { start: behind, end: block.span.start });
        assert!(gap.iter().all(|byte| matches!(byte, b'\r' | b'\n')), "only line ends between lines");
        behind = block.span.end;
        assert_eq!(block.words.start, next_word, "every word belongs to one line");
        next_word = block.words.end;
        let mut at = block.number.map_or(block.span.start, |number| number.end);
        for word in program.words_of(block) {
            assert!(inside(word.span, block.span) && word.span.start >= at && word.span.end > word.span.start);
            // of a macro come several words
            at = if program.replaced.text.is_empty() { word.span.end } else { word.span.start };
        }
        for place in block.comment.iter().chain(&block.number) {
            assert!(inside(*place, block.span));
        }
    }
    assert_eq!(next_word as usize, program.words.len());
    let text = |start, end| program.text(Span { start, end });
    assert!(
        text(behind, program.end).iter().all(|byte| matches!(byte, b'\r' | b'\n')),
        "nothing behind the last line but its end"
    );
    let unread = text(program.end, whole.end);
    assert!(
        unread.first().is_none_or(|byte| *byte == 0x1A) || unread.iter().all(|byte| *byte == 0),
        "nothing is left unread but what stands behind the end of the file"
    );
    let unknown: Vec<Span> =
        program.words.iter().filter(|word| word.kind == WordKind::Unknown).map(|word| word.span).collect();
    for span in unknown {
        assert!(program.errors.iter().any(|error| inside(error.span, span)), "what is not understood is reported");
    }
    for error in &program.errors {
        assert!(inside(error.span, whole));
    }
}

// oracle: self (invariants of the tree)
proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn any_bytes_are_kept_and_every_place_lies_inside(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        for dialect in DIALECTS {
            let program = read(dialect, &bytes);
            prop_assert_eq!(&*program.source, &bytes);
            check_places(&program);
        }
    }

    #[test]
    fn any_mixture_of_words_is_kept_and_every_place_lies_inside(
        words in proptest::collection::vec(proptest::sample::select(WORDS), 0..60)
    ) {
        let bytes = words.concat().into_bytes();
        for dialect in DIALECTS {
            let program = read(dialect, &bytes);
            prop_assert_eq!(&*program.source, &bytes);
            check_places(&program);
        }
    }
}

const WORDS: &[&str] = &[
    " ", " ", "\n", "\r\n", "\u{feff}", "N10 ", ":5 ", "/2", "X", "10", "-.5", "G1", "=", "==", "(", ")", "[", "]",
    ",", "\"", ";", "IF ", "GOTOF ", "DEF REAL ", "CASE", " OF ", "PROC P", "FOR ", " TO ", "R1", "_MVAR", "SET(",
    "$P_UIFR", ":", "<<", " AND ", "NOT ", "'H1F'", "1EX5", "%_N_A_MPF", "#100", "#[", "O12", "SIN[", "WHILE[", "DO1",
    "\0", "é", "CYCLE977",
];

// oracle: self
#[test]
fn mutations_of_a_program_never_panic_and_are_kept() {
    let seeds = [
        include_bytes!("programs/hole.mpf").as_slice(),
        include_bytes!("programs/language.mpf"),
        include_bytes!("programs/bore.nc"),
    ];
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    let mut random = move |below: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state % below.max(1) as u64) as usize
    };
    for round in 0..3000 {
        let mut bytes = seeds[round % seeds.len()].to_vec();
        for _ in 0..=random(4) {
            let at = random(bytes.len());
            match random(4) {
                0 => bytes[at] = random(256) as u8,
                1 => drop(bytes.drain(at..(at + random(20)).min(bytes.len()))),
                2 => bytes.insert(at, b"()[]\"=;,:<+-/%#\n\r "[random(18)]),
                _ => {
                    let piece = bytes[at..(at + random(30)).min(bytes.len())].to_vec();
                    let to = random(bytes.len());
                    bytes.splice(to..to, piece);
                }
            }
        }
        for dialect in DIALECTS {
            let program = read(dialect, &bytes);
            assert_eq!(*program.source, bytes);
            check_places(&program);
        }
    }
}

// oracle: hand (a reader that recurses without a limit overflows its stack here)
#[test]
fn deep_and_long_expressions_end_as_a_syntax_error() {
    let deep = format!("X={}1{}", "(".repeat(100_000), ")".repeat(100_000));
    let long = format!("X=1{}", "+1".repeat(100_000));
    let signs = format!("X={}1", "-".repeat(100_000));
    for text in [&deep, &long, &signs] {
        let program = read(Dialect::Sinumerik, text.as_bytes());
        assert_eq!(program.errors[0].sentence.cause, "syntax-depth");
        let limit = findings(&program).into_iter().map(|found| found.message).find(|one| one.key == "syntax-depth");
        assert_eq!(limit, Some(Message::new("syntax-depth").number("most", 100.0)));
        check_places(&program);
    }
    for text in [format!("#1={}1", "[".repeat(100_000)), format!("#1={}1", "#".repeat(100_000))] {
        assert_eq!(read(Dialect::Nct, text.as_bytes()).errors[0].sentence.cause, "syntax-depth");
    }
}

/// `file:line: text` of everything that was not understood.
fn unknown(dialect: Dialect, path: &Path) -> Vec<String> {
    let program = read(dialect, &std::fs::read(path).unwrap());
    check_places(&program);
    let name = path.file_name().unwrap().to_string_lossy().into_owned();
    let show = |span: Span, key| {
        format!("{name}:{}: {key} {}", program.line_of(span.start) + 1, String::from_utf8_lossy(program.text(span)))
    };
    program.errors.iter().map(|error| show(error.span, error.sentence.cause)).collect()
}

fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let mut files: Vec<_> = entries.filter(|path| path.extension().is_some_and(|found| found == ending)).collect();
    files.sort();
    files
}

// oracle: hand: programs with what those of the manuals have in them: measurements, logs, definitions, swivel tables,
// measuring of tools, and whole programs of the language
#[test]
fn every_measuring_program_is_understood() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut folders: Vec<PathBuf> =
        std::fs::read_dir(root.join("tests/cases")).unwrap().map(|entry| entry.unwrap().path()).collect();
    folders.extend(["tests/right", "core/tests/language/programs"].map(|folder| root.join(folder)));
    let (mut left, mut count) = (Vec::new(), 0);
    for folder in folders {
        for (ending, dialect) in [("mpf", Dialect::Sinumerik), ("nc", Dialect::Nct)] {
            for path in files(&folder, ending) {
                left.extend(unknown(dialect, &path));
                count += 1;
            }
        }
    }
    assert!(left.is_empty(), "{left:#?}");
    assert!(count >= 167, "{count}");
}

// oracle: hand
#[test]
fn own_programs_are_understood() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/programs");
    let mut left = Vec::new();
    for path in files(&folder, "mpf") {
        left.extend(unknown(Dialect::Sinumerik, &path));
    }
    for path in files(&folder, "nc") {
        left.extend(unknown(Dialect::Nct, &path));
    }
    assert!(left.is_empty(), "{left:#?}");
}

// oracle: Unicode (halfwidth and fullwidth forms, U+FF01 to U+FF5E: ASCII moved by FEE0)
#[test]
fn characters_of_full_width_are_replaced_by_those_of_the_language() {
    let mut text = "G0 X１０．５\n_MVAR＝１ CYCLE977（）\n".to_owned();
    for _ in 0..20 {
        let found = findings(&read(Dialect::Sinumerik, text.as_bytes()));
        let mut foreign = found.into_iter().filter(|finding| finding.message.key == "syntax-character");
        let Some(cure) = foreign.find_map(|finding| finding.cure) else { break };
        for edit in cure.edits {
            text.replace_range(edit.span.start as usize..edit.span.end as usize, &edit.insert);
        }
    }
    assert_eq!(text, "G0 X10.5\n_MVAR=1 CYCLE977()\n");
}
