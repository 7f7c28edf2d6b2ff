//! `probewright test`: scenarios, so that a shop keeps its programs proven.

use crate::file::{self, Problem};
use probewright_core::app::{self, Beside, CaseView, Scenario, ScenarioRequest, ScenarioText, ScenarioView};
use probewright_core::json;
use probewright_core::message::{Arg, Message};
use probewright_core::words::Words;
use std::fmt::Write as _;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What is carried out, and where what came of it is written too.
#[derive(clap::Args)]
pub struct Arguments {
    #[arg(required = true)]
    scenarios: Vec<PathBuf>,
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    #[arg(long)]
    json: bool,
}

/// A scenario that was carried out, else why not.
struct Carried {
    path: PathBuf,
    came: Result<ScenarioView, Why>,
}

/// Why a scenario was not carried out.
struct Why {
    /// As a line.
    text: String,
    /// Whether that names the place that is wrong.
    placed: bool,
}

impl From<String> for Why {
    fn from(text: String) -> Why {
        Why { text, placed: false }
    }
}

/// Carries out every scenario; 1 when a case does not come to what it must.
pub fn test(asked: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let mut all = Vec::new();
    for path in files(&asked.scenarios, words)? {
        let came = carried_out(&path, words);
        let carried = Carried { path, came };
        if !asked.json {
            print(&carried, words, out)?;
        }
        all.push(carried);
    }
    let cases = || all.iter().filter_map(|one| one.came.as_ref().ok()).flat_map(|view| &view.cases);
    let good = cases().filter(|case| case.differences.is_empty()).count();
    let count = cases().count() + all.iter().filter(|one| one.came.is_err()).count();
    if let Some(path) = &asked.junit {
        file::write(path, std::iter::once(junit(&all, words)))?;
    }
    if asked.json {
        file::print_json(all.iter().map(document).collect(), words, out)?;
    } else {
        let said = Message::new("terminal-test-held").number("good", good as f64).number("count", count as f64);
        writeln!(out, "{}", words.text(&said))?;
    }
    Ok(if good == count { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The files that are named; of a folder every scenario below it.
fn files(named: &[PathBuf], words: &Words) -> Result<Vec<PathBuf>, Problem> {
    let mut all = Vec::new();
    for path in named {
        if !path.is_dir() {
            all.push(path.clone());
            continue;
        }
        let (found, others): (Vec<PathBuf>, _) = file::below(path)?.into_iter().partition(|path| is_scenario(path));
        if found.is_empty() {
            return Err(file::wrong_file(path, Message::new("terminal-test-none")));
        }
        tell_others(path, &others, words);
        all.extend(found);
    }
    Ok(all)
}

/// Names of files that are told.
const NAMED: usize = 8;

/// Tells the documents of a folder that are not carried out since their names are those of other files.
fn tell_others(folder: &Path, others: &[PathBuf], words: &Words) {
    let json = |path: &&PathBuf| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json"));
    let names = others.iter().filter(json).map(|path| path.display().to_string());
    let names: Vec<String> = names.collect();
    if names.is_empty() {
        return;
    }
    let more = (names.len() > NAMED).then_some("…".to_owned());
    let listed = names.iter().take(NAMED).cloned().chain(more).collect::<Vec<_>>().join(", ");
    let mut told = Message::new("terminal-test-others").text("path", folder.display().to_string());
    told.args.push(("files", Arg::Text(listed)));
    file::complain(&words.text(&told));
}

/// `scenario.json`, `bore.scenario.json`.
fn is_scenario(path: &Path) -> bool {
    let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().to_ascii_lowercase());
    name == "scenario.json" || name.ends_with(".scenario.json")
}

fn carried_out(path: &Path, words: &Words) -> Result<ScenarioView, Why> {
    let text = file::text(path).map_err(|problem| file::told(&problem, words))?;
    let refused = |refused: json::Error| {
        let refused = json::positioned(refused, &text);
        Why { text: file::refusal(path, &refused, words), placed: refused.position.is_some() }
    };
    let scenario: Scenario = json::file(&text).map_err(refused)?;
    let beside = beside(path, &scenario).map_err(|problem| file::told(&problem, words))?;
    app::scenario(ScenarioRequest { scenario, beside: Some(beside) }).map_err(refused)
}

/// The files that a scenario names without their text.
fn beside(path: &Path, scenario: &Scenario) -> Result<Vec<Beside>, Problem> {
    let named = std::iter::once(&scenario.program).chain(&scenario.with).filter(|one| one.text.is_none());
    let read = |ScenarioText { name, .. }: &ScenarioText| {
        let text = file::program(&path.with_file_name(name))?;
        Ok(Beside { name: name.clone(), text: String::from_utf8_lossy(&text).into_owned() })
    };
    named.map(read).collect()
}

fn print(carried: &Carried, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    let path = carried.path.display();
    let view = match &carried.came {
        Ok(view) => view,
        Err(why) => {
            writeln!(out, "{}  {}", words.key("terminal-test-failed"), why.text)?;
            return if why.placed { writeln!(out, "    {}", words.key("scenario-cure")) } else { Ok(()) };
        }
    };
    for CaseView { id, differences, unproven, .. } in &view.cases {
        let how = if differences.is_empty() { "terminal-test-passed" } else { "terminal-test-failed" };
        writeln!(out, "{}  {path}: {id}", words.key(how))?;
        for told in differences.iter().chain(unproven) {
            writeln!(out, "    {}", words.text(told))?;
        }
    }
    Ok(())
}

fn document(Carried { path, came }: &Carried) -> serde_json::Value {
    let file = path.display().to_string();
    match came {
        Ok(ScenarioView { source, cases }) => {
            serde_json::json!({ "file": file, "source": source, "cases": json::document(cases) })
        }
        Err(why) => serde_json::json!({ "file": file, "refused": why.text }),
    }
}

/// As tools that collect test results read it.
fn junit(all: &[Carried], words: &Words) -> String {
    let mut text = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    // a text takes whatever is written
    let _ = writeln!(text, "<testsuites {}>", counted(all));
    for carried @ Carried { path, came } in all {
        let suite = quoted(&path.display().to_string());
        let _ = writeln!(text, "  <testsuite name=\"{suite}\" {}>", counted([carried]));
        let mut case = |id: &str, told: &[String], unproven: &[String]| {
            let inside = match (told, unproven) {
                ([first, ..], _) => {
                    format!("<failure message=\"{}\">{}</failure>", quoted(first), quoted(&told.join("\n")))
                }
                ([], []) => String::new(),
                ([], _) => format!("<system-out>{}</system-out>", quoted(&unproven.join("\n"))),
            };
            let id = quoted(id);
            let _ = writeln!(text, "    <testcase classname=\"{suite}\" name=\"{id}\">{inside}</testcase>");
        };
        let texts = |told: &[Message]| told.iter().map(|one| words.text(one)).collect::<Vec<_>>();
        match came {
            Ok(view) => {
                for CaseView { id, differences, unproven, .. } in &view.cases {
                    case(id, &texts(differences), &texts(unproven));
                }
            }
            Err(why) => case(&suite, std::slice::from_ref(&why.text), &[]),
        }
        text.push_str("  </testsuite>\n");
    }
    text.push_str("</testsuites>\n");
    text
}

/// How many cases there are and how many of them failed; a scenario that was not carried out is one.
fn counted<'a>(all: impl IntoIterator<Item = &'a Carried>) -> String {
    let [mut tests, mut failures] = [0, 0];
    for one in all {
        let cases = one.came.as_ref().map_or(&[][..], |view| &view.cases[..]);
        tests += cases.len().max(1);
        failures += cases.iter().filter(|case| !case.differences.is_empty()).count() + usize::from(cases.is_empty());
    }
    format!("tests=\"{tests}\" failures=\"{failures}\"")
}

/// A text in XML; what XML has no character for is left out.
fn quoted(text: &str) -> String {
    let kept = text.chars().filter(|c| !c.is_control() || *c == '\n');
    let mut quoted = String::new();
    for c in kept {
        match c {
            '&' => quoted.push_str("&amp;"),
            '<' => quoted.push_str("&lt;"),
            '>' => quoted.push_str("&gt;"),
            '"' => quoted.push_str("&quot;"),
            c => quoted.push(c),
        }
    }
    quoted
}
