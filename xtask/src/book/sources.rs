//! The pages of `docs/`, by language and in their order.

use super::words::Words;
use anyhow::{Context, Result, bail};
use std::collections::{BTreeMap, HashMap};
use std::fs;
use std::path::Path;

/// The language at the top of `docs/`; others are folders in it.
const FIRST: &str = "en";
/// Groups of the contents, each with its pages; cycles follow, as many as there are.
const GROUPS: [(&str, &[&str]); 2] = [
    ("book-basics", &["guides", "terms", "jog", "commissioning", "around"]),
    ("book-reference", &["alarms", "machine-data", "generations", "coverage"]),
];
const CYCLES: &str = "cycles/";
const ALARMS: &str = "alarms";
/// Pictures that all languages share.
const PICTURES: &str = "concepts";
/// Groups of the cycles: how their names begin.
const CONTROLS: [(&str, &str); 2] = [("book-cycles", "CYCLE"), ("book-macros", "G")];

/// Everything that the handbook is made of.
pub struct Sources {
    pub languages: Vec<Language>,
    /// Files of `docs/` that are no pages, by their paths there: pages may show or name them.
    pub beside: BTreeMap<String, Vec<u8>>,
}

/// The handbook in a language.
pub struct Language {
    pub code: String,
    pub words: Words,
    pub groups: Vec<Group>,
    named: HashMap<String, Named>,
}

/// Where a word leads: a page, and a place on it.
pub struct Named {
    pub page: String,
    pub place: Option<String>,
}

/// Pages under one title.
pub struct Group {
    pub title: String,
    pub pages: Vec<Source>,
}

/// A page as it is written.
pub struct Source {
    /// Its path in the folder of its language, without its ending: `cycles/CYCLE977`.
    pub name: String,
    pub title: String,
    pub markdown: String,
}

impl Sources {
    /// Reads `docs/` and the words of the handbook below the root of the repository.
    pub fn read(root: &Path) -> Result<Sources> {
        let mut codes = names(&root.join("www/messages"))?;
        codes.sort_by_key(|code| code != FIRST); // the first language first, the others by name
        let docs = root.join("docs");
        let languages = codes.iter().map(|code| Language::read(root, &docs, code));
        let languages = languages.collect::<Result<Vec<_>>>()?;
        let drawn = names(&docs.join(PICTURES))?.into_iter().map(|name| format!("{PICTURES}/{name}"));
        let beside = names(&docs)?.into_iter().chain(drawn);
        let beside = beside.filter(|name| docs.join(name).is_file() && !name.ends_with(".md"));
        let beside = beside.map(|name| Ok((name.clone(), fs::read(docs.join(&name))?))).collect::<Result<_>>()?;
        Ok(Sources { languages, beside })
    }
}

impl Language {
    fn read(root: &Path, docs: &Path, code: &str) -> Result<Language> {
        let folder = if code == FIRST { docs.to_owned() } else { docs.join(code) };
        let words = Words::read(root, code)?;
        let note = words.text("report-generated")?;
        let mut pages = BTreeMap::new();
        for (within, prefix) in [(folder.clone(), ""), (folder.join("cycles"), CYCLES)] {
            for name in names(&within)?.iter().filter_map(|name| name.strip_suffix(".md")) {
                let path = within.join(format!("{name}.md"));
                let markdown = fs::read_to_string(&path).with_context(|| path.display().to_string())?;
                let name = format!("{prefix}{name}");
                pages.insert(name.clone(), Source::new(name, without_note(&markdown, &note))?);
            }
        }
        let groups = grouped(&words, pages)?;
        Ok(Language::new(code, words, groups))
    }

    pub fn new(code: &str, words: Words, groups: Vec<Group>) -> Language {
        Language { code: code.to_owned(), words, named: named(&groups), groups }
    }

    /// Where its pages stand in `docs/`, with a slash behind it.
    pub fn folder(&self) -> String {
        if self.code == FIRST { String::new() } else { format!("{}/", self.code) }
    }

    /// All pages, as one reads them.
    pub fn pages(&self) -> impl Iterator<Item = &Source> {
        self.groups.iter().flat_map(|group| &group.pages)
    }

    /// A page by its name.
    pub fn page(&self, name: &str) -> Option<&Source> {
        self.pages().find(|page| page.name == name)
    }

    /// What a word in a text leads to: a cycle to its page, an alarm to its section.
    pub fn named(&self, word: &str) -> Option<&Named> {
        self.named.get(word)
    }
}

/// Words that lead somewhere.
fn named(groups: &[Group]) -> HashMap<String, Named> {
    let mut all = HashMap::new();
    for page in groups.iter().flat_map(|group| &group.pages) {
        if let Some(cycle) = page.name.strip_prefix(CYCLES) {
            all.insert(cycle.to_owned(), Named { page: page.name.clone(), place: None });
        }
        if page.name == ALARMS {
            let headings = page.markdown.lines().filter_map(|line| line.strip_prefix("## "));
            for number in headings.filter(|heading| is_number(heading)) {
                all.insert(number.to_owned(), Named { page: page.name.clone(), place: Some(number.to_owned()) });
            }
        }
    }
    all
}

/// Of an alarm: five digits, which name nothing else that has a section.
fn is_number(word: &str) -> bool {
    word.len() == 5 && word.bytes().all(|one| one.is_ascii_digit())
}

/// Without what is said to those who would edit the page: the sentence that ends as the note does.
fn without_note(markdown: &str, note: &str) -> String {
    let clause = note.rsplit([';', '，']).next().unwrap_or(note).trim();
    let lines = markdown.lines().map(|line| match line.split_once(clause) {
        Some((before, after)) => {
            let sentence = |end: &str| before.rfind(end).map(|at| at + end.len());
            format!("{}{}", &before[..sentence(". ").or(sentence("。")).unwrap_or(0)], after.trim_start())
        }
        None => line.to_owned(),
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// The order of the contents; a page that has no place there would be lost.
fn grouped(words: &Words, mut pages: BTreeMap<String, Source>) -> Result<Vec<Group>> {
    let mut groups = Vec::new();
    for (title, names) in GROUPS {
        let pages = names.iter().filter_map(|name| pages.remove(*name)).collect();
        groups.push(Group { title: words.text(title)?, pages });
    }
    for (title, begin) in CONTROLS {
        let begin = format!("{CYCLES}{begin}");
        let names: Vec<String> = pages.keys().filter(|name| name.starts_with(&begin)).cloned().collect();
        let pages = names.iter().filter_map(|name| pages.remove(name)).collect();
        groups.push(Group { title: words.text(title)?, pages });
    }
    if let Some(name) = pages.keys().next() {
        bail!("docs/{name}.md has no place in the contents of the handbook (xtask/src/book/sources.rs)");
    }
    Ok(groups)
}

impl Source {
    /// The title is the first line.
    pub fn new(name: String, markdown: String) -> Result<Source> {
        let title = markdown.lines().next().and_then(|line| line.strip_prefix("# "));
        let title = title.with_context(|| format!("docs: {name}.md does not begin with its title"))?;
        Ok(Source { title: title.to_owned(), name, markdown })
    }

    /// Its file in the handbook.
    pub fn file(&self, language: &Language) -> String {
        format!("{}/{}.html", language.code, self.name)
    }
}

/// Whether a file beside the pages is a picture that pages of every language show.
pub fn is_drawn(name: &str) -> bool {
    name.split_once('/').is_some_and(|(folder, _)| folder == PICTURES)
}

/// What a folder holds, in order.
fn names(folder: &Path) -> Result<Vec<String>> {
    let entries = fs::read_dir(folder).with_context(|| folder.display().to_string())?;
    let mut names =
        entries.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned())).collect::<Result<Vec<_>>>()?;
    names.sort();
    Ok(names)
}
