//! The steps of commissioning and the connections of probes: their page in `docs/`, and what the terminal prints.

use super::markdown::{line, table};
use super::terms::plain;
use crate::app::{
    CommissioningPath, CommissioningStep, CommissioningView, CompatibilityRow, CompatibilityView, ConnectionView,
    commissioning, compatibility_on,
};
use crate::control::Control;
use crate::manual::commissioning::CONNECTIONS;
use crate::message::Message;
use crate::words::Words;
use std::fmt::Write;

/// The page, Markdown.
pub fn page(words: &Words) -> String {
    let CommissioningView { paths, connections } = commissioning();
    let mut text = String::new();
    line(&mut text, &format!("# {}", words.key("report-commissioning")));
    line(&mut text, &words.key("report-commissioning-intro"));
    for path in &paths {
        line(&mut text, &format!("## {}", words.text(&path.title)));
        for step in &path.steps {
            line(&mut text, &format!("**{}** {}", titled(step, words), said(step, words).join(" ")));
        }
    }
    let row = |one: ConnectionView| {
        [quoted(one.signal), words.text(&one.title), words.text(&one.meaning), one.source.to_string()]
    };
    let title = words.key("report-connections");
    let columns = ["signal", "name", "meaning", "source"];
    table(&mut text, &title, columns, connections.into_iter().map(row), words);
    line(&mut text, &format!("## {}", words.key("report-compatibility")));
    let cells = |row: Vec<String>| format!("| {} |", row.join(" | "));
    let mut rows = versions(&compatibility_on(None), words).into_iter().map(cells);
    let head = rows.next().unwrap_or_default();
    let rule = "| --- ".repeat(head.matches(" |").count()) + "|";
    line(&mut text, &[head, rule].into_iter().chain(rows).collect::<Vec<_>>().join("\n"));
    text.trim_end().to_owned() + "\n"
}

/// Number and title of a step.
fn titled(step: &CommissioningStep, words: &Words) -> String {
    format!("{} {}", step.number, words.text(&step.title)).trim().to_owned()
}

/// What a step says beside its title.
fn said(step: &CommissioningStep, words: &Words) -> Vec<String> {
    let named = |key: &str, text: &str| {
        (!text.is_empty()).then(|| format!("{}: `{text}`.", words.key(format!("report-commissioning-{key}"))))
    };
    let sentences = [step.condition.as_ref(), Some(&step.action), step.check.as_ref()];
    let sentences = sentences.into_iter().flatten().map(|message| words.text(message));
    let data = [named("softkeys", step.softkeys), named("files", step.files), named("versions", step.versions)];
    sentences.chain(data.into_iter().flatten()).chain([format!("({})", step.source)]).collect()
}

/// Which versions work together, a row a software, their head first.
fn versions(view: &CompatibilityView, words: &Words) -> Vec<Vec<String>> {
    let heads = ["compatibility-component", "compatibility-version"].map(|key| words.key(key));
    let functions = view.functions.iter().map(|one| words.text(one));
    let head = heads.into_iter().chain(functions).chain([words.key("report-column-source")]);
    let row = |row: &CompatibilityRow| {
        let named = [row.component.to_owned(), format!("SW {}", row.version)].into_iter();
        named.chain(row.works.iter().map(|one| words.text(one))).chain([row.source.to_string()]).collect()
    };
    [head.collect()].into_iter().chain(view.rows.iter().map(row)).collect()
}

/// What a machine says of its software, then a software a line, each of its cells behind the name of its column.
fn told(view: &CompatibilityView, words: &Words) -> String {
    let table = versions(view, words);
    let [head, rows @ ..] = &table[..] else { return String::new() };
    let cell = |(name, cell): (&String, &String)| format!("{name}: {cell}");
    let line = |(row, of): (&Vec<String>, &CompatibilityRow)| {
        let cells: Vec<String> = head.iter().zip(row).skip(2).map(cell).collect();
        let here = if of.here { format!(" ({})", words.key("report-compatibility-here")) } else { String::new() };
        let named = row.iter().take(2).cloned().collect::<Vec<_>>().join(" ");
        format!("{named}{here}\n  {}\n", cells.join("; "))
    };
    let rows: String = rows.iter().zip(&view.rows).map(line).collect();
    format!("{}\n\n{rows}", words.text(&view.told))
}

/// The connections at a plug, pin or address of this name; empty: none.
pub fn connection(name: &str, words: &Words) -> String {
    let at = CONNECTIONS.iter().zip(commissioning().connections).filter(|(one, _)| one.is_at(name));
    at.map(|(_, one)| card(&one, words)).collect()
}

/// The connections with this in their name, which has words that stand together. Empty: none has it.
pub fn named(asked: &str, words: &Words) -> String {
    let asked = plain(asked);
    let spaced = |text: &str| format!(" {text} ");
    let has = |one: &ConnectionView, words: &Words| {
        let title = plain(&words.text(&one.title));
        // words of Chinese stand without spaces
        if asked.is_ascii() { spaced(&title).contains(&spaced(&asked)) } else { title.contains(&asked) }
    };
    let english = Words::english();
    let found = commissioning().connections.into_iter();
    let found = found.filter(|one| asked.len() > 2 && (has(one, words) || has(one, &english)));
    found.map(|one| card(&one, words)).collect()
}

fn card(one: &ConnectionView, words: &Words) -> String {
    let at = if one.signal.is_empty() { String::new() } else { format!(" ({})", one.signal) };
    format!("{}{at}: {} ({})\n", words.text(&one.title), words.text(&one.meaning), one.source)
}

/// A signal in a table; empty: there is none.
fn quoted(signal: &str) -> String {
    if signal.is_empty() { String::new() } else { format!("`{signal}`") }
}

/// The ways with their names, as the terminal prints them.
pub fn ways(words: &Words) -> String {
    let ways = commissioning().paths.into_iter().map(|path| (path.id, path.title));
    let others = [("connections", "report-connections"), ("compatibility", "report-compatibility")];
    let all = ways.chain(others.map(|(id, key)| (id, Message::new(key))));
    all.map(|(id, title)| format!("{id}: {}\n", words.text(&title))).collect()
}

/// The steps of a way by its name, `connections` all connections, `compatibility` which versions work together, held
/// against this control. Empty: there is none.
pub fn steps(way: &str, control: Option<&Control>, words: &Words) -> String {
    let CommissioningView { paths, connections } = commissioning();
    let mut text = String::new();
    if way.eq_ignore_ascii_case("connections") {
        return connections.iter().map(|one| card(one, words)).collect();
    }
    if way.eq_ignore_ascii_case("compatibility") {
        return told(&compatibility_on(control), words);
    }
    let Some(CommissioningPath { title, steps, .. }) = paths.into_iter().find(|one| one.id.eq_ignore_ascii_case(way))
    else {
        return text;
    };
    let _ = writeln!(text, "{}", words.text(&title));
    for step in &steps {
        let _ = writeln!(text, "\n[ ] {}", titled(step, words));
        for sentence in said(step, words) {
            let _ = writeln!(text, "    {sentence}");
        }
    }
    text
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::control::{Value, delivery};
    use crate::dialect::Dialect;

    // oracle: self
    #[test]
    fn the_page_is_that_of_the_tables() {
        super::super::held("commissioning.md", page);
    }

    // oracle: self: each way that is listed has its steps
    #[test]
    fn each_way_has_steps() {
        let words = Words::of("en").unwrap();
        for way in commissioning().paths {
            assert!(steps(way.id, None, &words).contains("[ ] "), "{}", way.id);
        }
        assert!(ways(&words).lines().all(|way| !steps(way.split(':').next().unwrap(), None, &words).is_empty()));
        assert!(steps("connections", None, &words).contains("X121"));
        assert!(steps("compatibility", None, &words).contains("MMC100.2"));
        assert_eq!(steps("nobody", None, &words), "");
    }

    // oracle: manual A:13964-13968: an NCU with software 6.x, or 5.3
    #[test]
    fn the_software_of_a_machine_is_marked() {
        let words = Words::of("en").unwrap();
        let mut control = delivery(Dialect::Sinumerik);
        let here = |control: Option<&Control>| {
            let text = steps("compatibility", control, &words);
            text.lines().filter(|line| line.ends_with("(this machine)")).count()
        };
        assert_eq!((here(None), here(Some(&control))), (0, 3)); // it is delivered with 6
        control.data.insert("_SI[1]".to_owned(), Value::Text("5".to_owned()));
        assert_eq!(here(Some(&control)), 1);
    }

    // oracle: manual B:12816-12823
    #[test]
    fn a_connection_is_explained_by_its_address() {
        let words = Words::of("en").unwrap();
        assert_eq!(connection("DBX107", &words).lines().count(), 2);
        assert_eq!(connection("X99", &words), "");
    }

    // oracle: hand (what somebody types who looks for it): each by its whole title, and by a word of it
    #[test]
    fn a_connection_is_explained_by_its_name() {
        for language in ["en", "de", "zh"] {
            let words = Words::of(language).unwrap();
            for one in commissioning().connections {
                let title = words.text(&one.title);
                assert!(named(&title, &words).contains(&words.text(&one.meaning)), "{title}");
                assert!(!card(&one, &words).contains("()"), "{title}");
            }
        }
        for (language, asked) in [("en", "distributor"), ("en", "cable distributor"), ("de", "cable distributor")] {
            let words = Words::of(language).unwrap();
            assert_eq!(named(asked, &words).lines().count(), 3, "{asked}");
        }
        let words = Words::of("en").unwrap();
        assert!(named("nobody", &words).is_empty() && named("", &words).is_empty());
    }
}
