//! A program with macros is the same program written out: for reading, checking, running; and a changed value leaves
//! the macros as they are.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::dialect::Dialect::Sinumerik;
use probewright_core::entry::Typed;
use probewright_core::program::calls::calls;
use probewright_core::program::change::{apply, change};
use probewright_core::program::findings;
use probewright_core::run::{Limits, assumed};
use probewright_core::syntax::{Program, read};
use proptest::prelude::*;
use std::path::Path;

/// The programs of a folder in `tests`.
fn programs(folder: &str) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests").join(folder);
    let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut paths: Vec<_> = paths.filter(|path| path.extension().is_some_and(|end| end == "mpf")).collect();
    paths.sort();
    paths.iter().filter_map(|path| String::from_utf8(std::fs::read(path).unwrap()).ok()).collect()
}

/// Whether a part of a line can be the text of a macro: not a label, a number of a block, a text, a definition.
fn can_be_named(part: &str) -> bool {
    let first = part.trim_start_matches(['N', ':', '/']);
    let number = !first.is_empty() && first.bytes().all(|byte| byte.is_ascii_digit());
    !number
        && !part.contains(['"', ';', ':', '%'])
        && !part.contains(char::is_control)
        && !part.starts_with('/')
        && !part.is_empty()
}

/// The program with macros, and as many lines without them.
fn with_macros(text: &str, picks: &[(prop::sample::Index, prop::sample::Index, usize)]) -> (String, String) {
    let mut lines: Vec<String> = text.split('\n').map(str::to_owned).collect();
    let mut defined = String::new();
    for (number, (line, word, more)) in picks.iter().enumerate() {
        let line = line.get_mut(&mut lines[..]);
        let code = line.split(';').next().unwrap().trim_end();
        let parts: Vec<&str> = code.split(' ').collect();
        let from = word.index(parts.len());
        let to = (from + 1 + more).min(parts.len());
        let declares = ["DEF", "PROC", "EXTERN", "REDEF", "DEFINE"].iter().any(|word| code.contains(word));
        if declares || line.starts_with('%') || !parts[from..to].iter().all(|part| can_be_named(part)) {
            continue;
        }
        let name = format!("QQ{number}_");
        defined += &format!("DEFINE {name} AS {}\n", parts[from..to].join(" "));
        let begin: usize = parts[..from].iter().map(|part| part.len() + 1).sum();
        let length = parts[from..to].join(" ").len();
        line.replace_range(begin..begin + length, &name);
    }
    let header = if text.starts_with('%') { "" } else { "%_N_MAIN_MPF\n" };
    let comments = ";\n".repeat(defined.lines().count());
    let all = |before: &str, rest: &str| format!("%_N_UMAC_DEF\n{before}{header}{rest}");
    (all(&defined, &lines.join("\n")), all(&comments, text))
}

fn told(program: &Program) -> Vec<(u32, String)> {
    let line = |found: &probewright_core::diagnostic::Diagnostic| program.line_of(found.span.unwrap_or_default().start);
    // values of one macro have one place: of one that does not reach its call nothing is told where another one does
    let found = findings(program).into_iter().filter(|found| found.message.key != "advice-overwritten");
    let mut all: Vec<_> = found.map(|found| (line(&found), found.message.key.to_string())).collect();
    all.sort();
    all.dedup();
    all
}

fn picks() -> impl Strategy<Value = Vec<(prop::sample::Index, prop::sample::Index, usize)>> {
    prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>(), 0_usize..4), 1..12)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    // oracle: peer (the same program without macros)
    #[test]
    fn a_program_with_macros_is_the_program_written_out(at in any::<prop::sample::Index>(), picks in picks()) {
        let mut all = [programs("right"), programs("wrong")].concat();
        // a program of an 840C has no macros: what is told of its R parameters is so where they stand
        all.retain(|text| !text.contains("R23="));
        let (named, written) = with_macros(at.get::<String>(&all), &picks);
        let [named, written] = [named, written].map(|text| read(Sinumerik, text.as_bytes()));
        prop_assert_eq!(told(&named), told(&written), "{}", String::from_utf8_lossy(&named.source));
        let sites = [calls(&named), calls(&written)];
        prop_assert_eq!(sites[0].len(), sites[1].len());
        // an expression that only the run tells stays as it is written, with the macro or without
        let open = |text: &String| text.contains("QQ") || text.contains(['*', '/', '[', '+']);
        for (one, other) in sites[0].iter().zip(&sites[1]) {
            prop_assert_eq!((one.cycle.name, one.line), (other.cycle.name, other.line));
            prop_assert!(one.values.keys().eq(other.values.keys()), "{:?} {:?}", one.values, other.values);
            for (name, text) in one.values.iter().filter(|(name, text)| !open(text) && !open(&other.values[*name])) {
                prop_assert_eq!(Some(text), other.values.get(name), "{}", name);
            }
        }
        for found in findings(&named) {
            prop_assert!(found.span.unwrap_or_default().end as usize <= named.source.len());
        }
        let [one, other] = [&named, &written].map(|program| assumed::run(program, Limits::default()).outcome);
        prop_assert_eq!(&one.trace, &other.trace);
        let keys = |outcome: &probewright_core::run::Outcome| {
            outcome.diagnostics.iter().map(|found| found.message.key.to_string()).collect::<Vec<_>>()
        };
        prop_assert_eq!(keys(&one), keys(&other));
    }

    // oracle: peer (the values as they are read again)
    #[test]
    fn a_changed_value_leaves_the_macros(at in any::<prop::sample::Index>(), picks in picks()) {
        let all = programs("right");
        let (named, _) = with_macros(at.get::<String>(&all), &picks);
        let program = read(Sinumerik, named.as_bytes());
        let lines = |text: &[u8]| {
            let text = String::from_utf8_lossy(text).into_owned();
            text.lines().filter(|line| line.starts_with("DEFINE")).map(str::to_owned).collect::<Vec<_>>()
        };
        for (index, site) in calls(&program).iter().enumerate() {
            for name in site.values.keys() {
                let same = change(&program, site, name, &site.values[name]);
                let text = apply(&program.source, &same);
                let again = calls(&read(Sinumerik, &text));
                prop_assert_eq!(&again[index].values, &site.values, "{} {}", name, String::from_utf8_lossy(&text));
                let text = apply(&program.source, &change(&program, site, name, "1"));
                prop_assert_eq!(lines(&text), lines(&program.source));
                let again = calls(&read(Sinumerik, &text));
                let others = |values: &Typed| {
                    let others = values.iter().filter(|(other, _)| *other != name);
                    others.map(|(name, text)| (name.clone(), text.clone())).collect::<Vec<_>>()
                };
                prop_assert_eq!(others(&again[index].values), others(&site.values), "{} {}", name, named);
            }
        }
    }
}
