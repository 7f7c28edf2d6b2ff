//! `www/src/wire.ts`: the types of questions and answers as the page sees them, with what is said of them here.

use crate::app::*;
use crate::form::Unfit;
use crate::machine::Step;
use crate::scan::text::Form;
use std::collections::BTreeMap;
use std::path::PathBuf;
use ts_rs::{Config, TS, TypeVisitor};

/// Before the types; points and directions of the page are vectors.
const HEAD: &str = "\
// Questions and answers of the core. Written from core/src/app by a test of the core (json/tests/wire.rs) when it runs
// with PROBEWRIGHT_UPDATE=1; not by hand.

export type Vec3 = [number, number, number];
";

/// Each type once, in the order of their names: the one in which ts-rs finds them differs from build to build.
struct Types {
    config: Config,
    texts: BTreeMap<String, String>,
}

impl TypeVisitor for Types {
    fn visit<T: TS + 'static + ?Sized>(&mut self) {
        let name = T::name(&self.config);
        if T::output_path().is_some() && !self.texts.contains_key(&name) {
            let docs = T::docs().map_or(String::new(), |docs| comment(&docs, ""));
            let text = format!("\n{docs}export {};\n", laid_out(T::decl(&self.config).trim_end_matches(';')));
            self.texts.insert(name, text);
            T::visit_dependencies(self);
        } else {
            T::visit_generics(self);
        }
    }
}

/// A comment of these lines.
fn comment(docs: &str, indent: &str) -> String {
    let lines = docs.lines().map(|line| line.trim().trim_start_matches("/**").trim_start_matches("*/"));
    let lines = lines.map(|line| line.trim_start_matches('*').trim()).filter(|line| !line.is_empty());
    let lines: Vec<&str> = lines.collect();
    match &lines[..] {
        [line] => format!("{indent}/** {line} */\n"),
        lines => format!("{indent}/**\n{indent} * {}\n{indent} */\n", lines.join(&format!("\n{indent} * "))),
    }
}

/// A declaration with a line for each member that has a comment.
fn laid_out(declaration: &str) -> String {
    let (mut text, mut depth, mut rest) = (String::new(), 0, declaration);
    let indent = |depth: usize| "  ".repeat(depth);
    let mut open: Vec<bool> = Vec::new();
    while let Some(first) = rest.chars().next() {
        let wide = open.last() == Some(&true);
        if let Some(end) = rest.starts_with("/**").then(|| rest.find("*/")).flatten() {
            let said = comment(&rest[..end + 2], &indent(depth));
            text = format!("{}\n{said}{}", text.trim_end(), indent(depth));
            rest = rest[end + 2..].trim_start();
            continue;
        }
        rest = &rest[first.len_utf8()..];
        match first {
            '{' => {
                open.push(rest.trim_start().starts_with("/**") || documented(rest));
                depth += usize::from(open.last() == Some(&true));
                text.push('{');
            }
            '}' => {
                open.pop();
                text.truncate(text.trim_end().trim_end_matches(',').len());
                depth -= usize::from(wide);
                text += &if wide { format!(",\n{}}}", indent(depth)) } else { " }".to_owned() };
            }
            '\n' => {}
            ' ' if text.ends_with(' ') => {}
            _ => text.push(first),
        }
    }
    text
}

/// Whether a member of the object that begins here has a comment.
fn documented(inside: &str) -> bool {
    let mut depth = 1;
    for (at, c) in inside.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            '/' if depth == 1 && inside[at..].starts_with("/**") => return true,
            _ => {}
        }
        if depth == 0 {
            return false;
        }
    }
    false
}

// oracle: self
#[test]
fn the_types_of_the_page_are_those_of_the_core() {
    let config = Config::new().with_large_int("number").with_array_tuple_limit(4);
    let mut types = Types { config, texts: BTreeMap::new() };
    types.visit::<Catalogue>();
    types.visit::<AlarmInfo>();
    types.visit::<Elsewhere>();
    types.visit::<FormRequest>();
    types.visit::<CertaintyRequest>();
    types.visit::<CertaintyView>();
    types.visit::<WholeCertaintyRequest>();
    types.visit::<WholeCertainty>();
    types.visit::<SeriesRequest>();
    types.visit::<SeriesStart>();
    types.visit::<SeriesView>();
    types.visit::<FormView>();
    types.visit::<HelpRequest>();
    types.visit::<HelpView>();
    types.visit::<TermsView>();
    types.visit::<ConceptRequest>();
    types.visit::<CompatibilityRequest>();
    types.visit::<CompatibilityView>();
    types.visit::<ConceptPicture>();
    types.visit::<CommissioningView>();
    types.visit::<MachineRequest>();
    types.visit::<MachineView>();
    types.visit::<BrakingRequest>();
    types.visit::<BrakingView>();
    types.visit::<RepeatRequest>();
    types.visit::<RepeatView>();
    types.visit::<UserProgramsRequest>();
    types.visit::<DefinitionsRequest>();
    types.visit::<DefinitionsView>();
    types.visit::<ReadBackRequest>();
    types.visit::<ReadBack>();
    types.visit::<UserProgramsView>();
    types.visit::<MachineCheckRequest>();
    types.visit::<MachineCheckView>();
    types.visit::<EquipRequest>();
    types.visit::<EquipView>();
    types.visit::<Story>();
    types.visit::<ReadRequest>();
    types.visit::<ReadView>();
    types.visit::<PointedRequest>();
    types.visit::<PointedView>();
    types.visit::<ChangeRequest>();
    types.visit::<Changed>();
    types.visit::<UnfitRequest>();
    types.visit::<Unfit>();
    types.visit::<ConvertRequest>();
    types.visit::<Converted>();
    types.visit::<AroundRequest>();
    types.visit::<AroundView>();
    types.visit::<CureRequest>();
    types.visit::<CuredAll>();
    types.visit::<Step>();
    types.visit::<Trace>();
    types.visit::<RunRequest>();
    types.visit::<RunView>();
    types.visit::<Record>();
    types.visit::<ProtocolRequest>();
    types.visit::<ProtocolView>();
    types.visit::<OfCall>();
    types.visit::<ScanRequest>();
    types.visit::<ScanView>();
    types.visit::<Form>();
    types.visit::<Recognised>();
    types.visit::<PracticeRequest>();
    types.visit::<PracticeView>();
    types.visit::<ScenarioRequest>();
    types.visit::<ScenarioView>();
    types.visit::<NoteRequest>();
    types.visit::<PracticeFace>();
    types.visit::<PracticeApproach>();
    types.visit::<PracticeProgram>();
    types.visit::<PracticeCallRequest>();
    types.visit::<PracticeCall>();
    types.visit::<crate::scene::View>();
    let texts: String = types.texts.into_values().collect();
    let text = format!("{HEAD}{texts}");
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../www/src/wire.ts");
    if std::env::var_os("PROBEWRIGHT_UPDATE").is_some() {
        std::fs::write(&path, &text).unwrap();
    }
    let written = std::fs::read_to_string(&path).unwrap();
    assert!(written == text, "www/src/wire.ts is not of these types: PROBEWRIGHT_UPDATE=1 writes it");
}
