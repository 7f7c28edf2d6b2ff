//! CYCLE198 and CYCLE199 with lines of the user in the branches of chosen cycles (B:2471-2501, A:2683-2716). As
//! delivered each is a CASE that jumps to the label of the cycle, whose lines end in M17; the variable of the CASE is
//! not printed.

use super::{ALL, BEFORE, UserProgram, callers, label};
use crate::dialect::Dialect;
use crate::entry::{Cycle, names};
use crate::syntax::language::BY_TEXT;
use crate::syntax::programs::bare;
use crate::syntax::targets::Targets;
use crate::syntax::{Block, Expr, ExprId, Program, Word, WordKind, read};
use std::collections::BTreeSet;
use std::fmt::Write;

/// Lines of a cycle.
pub struct Branch {
    /// The cycle.
    pub cycle: &'static Cycle,
    /// Lines before its measurement.
    pub before: Vec<String>,
    /// Lines behind it.
    pub behind: Vec<String>,
}

/// Label behind the branches of a whole file.
pub const END: &str = "_MEND";

/// The comment of a branch: key with the cycle.
pub type Words<'a> = &'a dyn Fn(&str, &Cycle) -> String;

/// The lines of one of both programs: to insert, or, where the variable of the CASE is known, as a whole file.
pub fn write(user: &UserProgram, branches: &[Branch], variable: Option<&str>, words: Words) -> String {
    let before = user.name == BEFORE.name;
    let mut text = String::new();
    if let Some(variable) = variable {
        let _ = writeln!(text, "%_N_{}_SPF\n;$PATH=/_N_CUS_DIR\nPROC {}", user.name, user.name);
        let jumps: Vec<String> = branches.iter().map(|branch| jump(branch.cycle)).collect();
        let _ = writeln!(text, "CASE {variable} OF {} DEFAULT GOTOF {END}", jumps.join(" "));
    }
    for branch in branches {
        let (key, lines) = match before {
            true => ("user-program-before-line", &branch.before),
            false => ("user-program-behind-line", &branch.behind),
        };
        let _ = writeln!(text, "{}: ;{}", label(branch.cycle), words(key, branch.cycle));
        for line in lines {
            let _ = writeln!(text, "{line}");
        }
        text.push_str("M17\n");
    }
    if variable.is_some() {
        let _ = writeln!(text, "{END}:\nM17");
    }
    text
}

fn jump(cycle: &Cycle) -> String {
    let number = cycle.name.trim_start_matches("CYCLE");
    format!("{number} GOTOF {}", label(cycle))
}

/// The lines of a text; an error: one that cannot stand between label and M17, because it ends the program, declares
/// something or cannot be written.
///
/// # Errors
/// That line.
pub fn lines(text: &str) -> Result<Vec<String>, String> {
    let all = text.split(['\n', '|']).map(str::trim).filter(|line| !line.is_empty());
    all.map(|line| if stands(line) { Ok(line.to_owned()) } else { Err(line.to_owned()) }).collect()
}

/// Most characters of a line.
const LONGEST: usize = 500;

fn stands(line: &str) -> bool {
    let program = read(Dialect::Sinumerik, line.as_bytes());
    let ends = |word: &Word| {
        program.machine_function(word).is_some_and(|number| [2.0, 17.0, 30.0].contains(&number))
            || program.is_keyword(word, &["RET", "PROC", "EXTERN", "DEF", "REDEF", "CASE"])
    };
    let named = program.words.iter().any(ends) || line.ends_with(':') || line.starts_with('%');
    line.len() <= LONGEST && !named && !line.chars().any(char::is_control)
}

/// What lines call that calls them again: a measuring cycle, or one of both programs.
pub fn calls_again(lines: &[String]) -> Option<&'static str> {
    let text = lines.join("\n");
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let called: BTreeSet<String> = program.blocks.iter().flat_map(|block| named(&program, block)).collect();
    let mut names = callers().map(|cycle| cycle.name).chain(ALL.map(|user| user.name));
    names.find(|name| called.contains(*name))
}

/// What a block calls: by the name, or by a text, which may have folders (`CALL "NAME"`, `EXTCALL("NAME")`).
fn named<'a>(program: &'a Program, block: &Block) -> impl Iterator<Item = String> + 'a {
    let words = program.words_of(block);
    let by_text = |word: &Word| program.is_call(word, &BY_TEXT);
    let behind = words.iter().any(by_text);
    let text = move |id: &ExprId| match program.expr(*id) {
        Some(Expr::Text(place)) => Some(bare(&program.name(*place)).to_owned()),
        _ => None,
    };
    words.iter().flat_map(move |word| match &word.kind {
        WordKind::Call { args, .. } if by_text(word) => args.iter().filter_map(text).collect(),
        WordKind::Call { name, .. } => vec![bare(&program.name(*name)).to_owned()], // `PCALL` keeps its ending
        WordKind::Constant(id) if behind => text(id).into_iter().collect(),
        _ => Vec::new(),
    })
}

/// The labels of lines.
pub fn labels(lines: &[String]) -> BTreeSet<String> {
    let text = lines.join("\n");
    let program = read(Dialect::Sinumerik, text.as_bytes());
    program.words.iter().filter_map(Word::label).map(|place| program.name(place)).collect()
}

/// Whether the file has this label: it is that of a cycle, or in a whole file the one behind the branches.
pub fn is_taken(name: &str, whole: bool) -> bool {
    whole && name == END || callers().any(|cycle| label(cycle) == name)
}

/// The lines in which something cannot be read.
pub fn unread(lines: &[String]) -> Vec<&str> {
    let text = lines.join("\n");
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let places: BTreeSet<u32> = program.errors.iter().map(|error| program.line_of(error.span.start)).collect();
    places.into_iter().filter_map(|line| lines.get(line as usize).map(String::as_str)).collect()
}

/// Where lines jump to without having that label, nor one of these.
pub fn leaves(lines: &[String], labels: &[String]) -> Vec<String> {
    let text = lines.join("\n");
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let own = Targets::of(&program);
    let target = |word: &Word| match &word.kind {
        WordKind::Keyword { value: Some(value), .. } if program.is_keyword(word, &JUMPS) => {
            Some(program.written(program.place(*value)).to_ascii_uppercase())
        }
        _ => None,
    };
    let there = |name: &String| !own.blocks(name).is_empty() || labels.contains(name);
    program.words.iter().filter_map(target).filter(|name| !there(name)).collect()
}

/// Words with a target behind them.
const JUMPS: [&str; 3] = ["GOTO", "GOTOF", "GOTOB"];

/// The parameters of a cycle that lines write: it would measure something else.
pub fn changed(cycle: &'static Cycle, lines: &[String]) -> Vec<&'static str> {
    let text = lines.join("\n");
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let written = |name: &str| {
        program.words.iter().any(|word| match &word.kind {
            WordKind::Assign { name: place, .. } => program.is(*place, name),
            _ => false,
        })
    };
    let own = cycle.params.iter().filter(|param| !param.is_machine_datum()).map(|param| param.name.as_str());
    let all = own.chain([names::MVAR.as_str()]);
    all.filter(|name| written(name)).collect::<BTreeSet<_>>().into_iter().collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::catalogue::find;
    use crate::program::user_programs::{BEHIND, UserPrograms, callers};

    fn branch(name: &str, before: &str, behind: &str) -> Branch {
        let cycle = find(Dialect::Sinumerik, name).unwrap();
        Branch { cycle, before: lines(before).unwrap(), behind: lines(behind).unwrap() }
    }

    fn words(key: &str, cycle: &Cycle) -> String {
        format!("{key} {}", cycle.name)
    }

    #[test]
    fn a_branch_is_written_between_label_and_m17() {
        // oracle: manual B:2482-2508 (CASE, label of the cycle, its lines, M17)
        let branches = [branch("CYCLE977", "M27|G4 F0.5", "M28"), branch("CYCLE978", "M27", "")];
        let inserted = write(&BEFORE, &branches, None, &words);
        assert_eq!(
            inserted,
            "_M977: ;user-program-before-line CYCLE977\nM27\nG4 F0.5\nM17\n\
             _M978: ;user-program-before-line CYCLE978\nM27\nM17\n"
        );
        let whole = write(&BEHIND, &branches, Some("_X"), &words);
        assert!(whole.contains("CASE _X OF 977 GOTOF _M977 978 GOTOF _M978 DEFAULT GOTOF _MEND\n"), "{whole}");
        assert!(whole.starts_with("%_N_CYCLE199_SPF\n") && whole.ends_with("_MEND:\nM17\n"));
        // what is written is found again around the calls of these cycles
        let program = read(Dialect::Sinumerik, whole.as_bytes());
        assert!(program.errors.is_empty(), "{:?}", program.errors);
        let found = UserPrograms::of(&program);
        let keys = |name: &str| -> Vec<String> {
            let notes = found.around(find(Dialect::Sinumerik, name).unwrap());
            notes.iter().map(|note| note.message.key.to_string()).collect()
        };
        assert_eq!(keys("CYCLE977"), ["user-program-runs-behind"]);
        assert_eq!(keys("CYCLE979"), ["user-program-runs-behind-whole"]);
        assert_eq!(keys("CYCLE116"), [""; 0]);
    }

    #[test]
    fn each_caller_has_a_label_of_its_own() {
        // oracle: manual B:2492 (_M977)
        let labels: Vec<String> = callers().map(label).collect();
        assert!(labels.contains(&"_M977".to_owned()) && labels.len() >= 13, "{labels:?}");
        let once: std::collections::BTreeSet<_> = labels.iter().collect();
        assert_eq!(once.len(), labels.len());
    }

    #[test]
    fn lines_that_end_the_branch_are_refused() {
        // oracle: hand
        for wrong in ["M17", "M27\nM30", "RET", "_M977:", "PROC X", "DEF INT X", "CASE R1 OF 1 GOTOF A", "%_N_X_SPF"] {
            assert!(lines(wrong).is_err(), "{wrong}");
        }
        assert_eq!(lines(" M27 |\n G4 F1 ").unwrap(), ["M27", "G4 F1"]);
        let cycle = find(Dialect::Sinumerik, "CYCLE977").unwrap();
        assert_eq!(changed(cycle, &lines("_SETVAL=5|R1=2").unwrap()), ["_SETVAL"]);
        assert_eq!(changed(cycle, &lines("_MVAR=2").unwrap()), ["_MVAR"]);
    }

    #[test]
    fn what_would_call_these_lines_again_is_found() {
        // oracle: manual B:2482-2508 (every measuring cycle calls both)
        for cycle in callers() {
            for line in [cycle.name.to_owned(), format!("M27|IF R1==0|{}|ENDIF", cycle.name)] {
                assert_eq!(calls_again(&lines(&line).unwrap()), Some(cycle.name), "{line}");
            }
        }
        assert_eq!(calls_again(&lines("M27|CYCLE198").unwrap()), Some("CYCLE198"));
        assert_eq!(calls_again(&lines("M27|CYCLE199()").unwrap()), Some("CYCLE199"));
        assert_eq!(calls_again(&lines("M27|CYCLE116|MY_COVER(1)|L10").unwrap()), None);
        for call in [
            "CALL \"CYCLE977\"",
            "CALL \"/_N_CST_DIR/_N_CYCLE977_SPF\"",
            "call \"cycle977\"",
            "EXTCALL(\"CYCLE977.SPF\")",
            "EXTCALL \"CYCLE977\"",
            "MCALL CYCLE977",
            "PCALL /_N_CST_DIR/_N_CYCLE977_SPF",
            "IF R1==1 CYCLE977",
        ] {
            assert_eq!(calls_again(&lines(call).unwrap()), Some("CYCLE977"), "{call}");
        }
        for other in ["CALL \"COVER\"", "MSG(\"CYCLE977\")", "CALL PROGRAM_OF_CYCLE977", "R1=2 ;CYCLE977"] {
            assert_eq!(calls_again(&lines(other).unwrap()), None, "{other}");
        }
    }

    #[test]
    fn labels_of_the_file_are_taken() {
        // oracle: manual B:2482-2508 (a label for each cycle), hand (what is written has each label once)
        let found = |text: &str| labels(&lines(text).unwrap()).into_iter().find(|name| is_taken(name, true));
        for cycle in callers() {
            let label = label(cycle);
            assert_eq!(found(&format!("M27|{label}: M28")), Some(label.clone()));
            assert_eq!(found(&format!("{}: M28", label.to_ascii_lowercase())), Some(label));
        }
        assert_eq!(found("N10 _MEND: M28"), Some(END.to_owned()));
        assert!(!is_taken(END, false));
        assert_eq!(found("AGAIN: M28|GOTOF _M977"), None);
    }

    #[test]
    fn lines_that_cannot_be_read_are_found() {
        // oracle: hand
        let found = |text: &str| unread(&lines(text).unwrap()).into_iter().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(found("M27|)(|R1=(2"), [")(", "R1=(2"]);
        assert_eq!(found("IF R1==1|M27|ENDIF|G4 F0.5|MY_COVER(1,\"A\")"), [""; 0]);
    }

    #[test]
    fn jumps_out_of_the_lines_are_found() {
        // oracle: hand
        let labels = ["_MEND".to_owned()];
        let left = |text: &str| leaves(&lines(text).unwrap(), &labels);
        assert_eq!(left("GOTOF ABC"), ["ABC"]);
        assert_eq!(left("IF R1==1 GOTOF abc|M27"), ["ABC"]);
        assert_eq!(left("IF R1==1 GOTOF ABC|M27|ABC: M28|GOTOF _MEND"), [""; 0]);
        assert_eq!(left("GOTOF N0100|N100 M28"), [""; 0]);
    }
}
