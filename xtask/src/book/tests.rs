#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
use super::markdown::{Made, html};
use super::sources::{Group, Language, Source, Sources};
use super::words::Words;
use super::{Files, check, files, relative};
use crate::tools::root;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// A handbook of one language with these pages, by their names.
fn handbook(pages: &[(&str, &str)]) -> Sources {
    let pages = pages.iter().map(|(name, text)| Source::new((*name).to_owned(), (*text).to_owned()).unwrap());
    let groups = vec![Group { title: "Pages".to_owned(), pages: pages.collect() }];
    let words = Words::read(&root(), "en").unwrap();
    let beside = BTreeMap::from([("hole.png".to_owned(), vec![1, 2, 3])]);
    Sources { languages: vec![Language::new("en", words, groups)], beside }
}

/// The first page of a handbook.
fn first(sources: &Sources) -> anyhow::Result<Made> {
    let language = &sources.languages[0];
    html(sources, language, language.pages().next().unwrap())
}

/// A page without others.
fn alone(text: &str) -> Made {
    first(&handbook(&[("alone", text)])).unwrap()
}

/// Codes of the languages, and all files of the handbook of `docs/`.
fn docs() -> &'static (Vec<String>, Files) {
    static DOCS: std::sync::OnceLock<(Vec<String>, Files)> = std::sync::OnceLock::new();
    DOCS.get_or_init(|| {
        let sources = Sources::read(&root()).unwrap();
        let shared = ["book.css", "book.js", "icon.svg"].map(|name| (name.to_owned(), Vec::new()));
        let files = files(&sources, &Files::from(shared)).unwrap();
        (sources.languages.iter().map(|one| one.code.clone()).collect(), files)
    })
}

fn text<'a>(files: &'a Files, name: &str) -> &'a str {
    std::str::from_utf8(&files[name]).unwrap()
}

// oracle: hand
#[test]
fn headings_have_places_of_their_own_in_any_script() {
    let made = alone("# A title\n\n## Hole: 1\n\n## Hole 1\n\n## 工件测头\n\n### `_FA`\n");
    let ids: Vec<&str> = made.sections.iter().map(|section| section.id.as_str()).collect();
    assert_eq!(ids, ["a-title", "hole-1", "hole-1-2", "工件测头", "fa"]);
    assert!(made.body.contains("<h2 id=\"hole-1-2\">Hole 1<a "), "{}", made.body);
    assert!(made.body.contains("<h3 id=\"fa\"><code>_FA</code><a "), "{}", made.body);
}

// oracle: hand (the OWASP list of what a page of text must not become)
#[test]
fn nothing_on_a_page_becomes_a_script() {
    let made = alone(
        "# <script>alert(1)</script>\n\n<script>alert(2)</script>\n\nA <img src=x onerror=alert(3)> and `<b>`\n\n\
         | a |\n| --- |\n| <svg onload=alert(4)><br>next |\n\n```\n</code><script>\n```\n",
    );
    let tags = made.body.split('<').skip(1).map(|tag| tag.split(['>', ' ']).next().unwrap());
    let tags: BTreeSet<&str> = tags.map(|tag| tag.trim_start_matches('/')).collect();
    let known = ["a", "br", "code", "div", "h1", "p", "pre", "table", "tbody", "td", "th", "thead", "tr"];
    assert_eq!(tags.difference(&BTreeSet::from(known)).collect::<Vec<_>>(), [&""; 0]);
    assert!(made.body.contains("&lt;img src=x onerror=alert(3)&gt;"), "{}", made.body);
    assert_eq!(made.body.matches("<br>").count(), 1);
}

// oracle: hand
#[test]
fn a_table_scrolls_by_itself_and_its_named_rows_are_places() {
    let made =
        alone("# Data\n\n## Probes\n\n| name | meaning |\n| --- | --- |\n| `_WP[k,0]` | Ball |\n| 2 | Shaft |\n");
    assert!(made.body.contains("<div class=\"table\" role=\"group\" aria-labelledby=\"probes\" tabindex=\"0\">"));
    assert!(made.body.contains("<th scope=\"col\">name</th>"));
    assert!(made.body.contains("<tr><th scope=\"row\" id=\"wp-k-0\"><code>_WP[k,0]</code></th><td>Ball</td></tr>"));
    assert!(made.body.contains("<tr><th scope=\"row\">2</th><td>Shaft</td></tr>"));
    let texts: Vec<(&str, &[String])> = made.sections.iter().map(|one| (one.title.as_str(), &one.texts[..])).collect();
    assert_eq!(texts, [("Data", &[][..]), ("Probes", &["2 · Shaft".to_owned()]), ("_WP[k,0]", &["Ball".to_owned()])]);
}

// oracle: hand
#[test]
fn a_paragraph_that_explains_a_term_is_a_place() {
    let made = alone("# T\n\n## Terms\n\n**Safe area**: No more.\n\n**It stops.** Why.\n\n**Sequence**\n\n- **A** b\n");
    assert!(made.body.contains("<p><strong id=\"safe-area\">Safe area</strong>: No more.</p>"), "{}", made.body);
    assert!(made.body.contains("<p><strong>It stops.</strong> Why.</p>"), "{}", made.body);
    assert!(made.body.contains("<p><strong>Sequence</strong></p>"), "{}", made.body);
    let told: Vec<(&str, usize)> = made.sections.iter().map(|one| (one.title.as_str(), one.texts.len())).collect();
    assert_eq!(told, [("T", 0), ("Terms", 3), ("Safe area", 1)]);
}

// oracle: hand
#[test]
fn links_lead_to_pages_of_the_handbook_and_pictures_come_along() {
    let pages = [
        (
            "cycles/CYCLE1",
            "# One\n\n[alarms](../alarms.md#61001) ![A hole](../hole.png) [site](https://example.org/)\n",
        ),
        ("alarms", "# Alarms\n\n## 61001\n\nNone.\n"),
    ];
    let sources = handbook(&pages);
    let body = first(&sources).unwrap().body;
    assert!(body.contains("<a href=\"../alarms.html#61001\">alarms</a>"), "{body}");
    assert!(body.contains("<img src=\"../../hole.png\" alt=\"A hole\">"), "{body}");
    assert!(body.contains("<a href=\"https://example.org/\">site</a>"), "{body}");
}

// oracle: hand
#[test]
fn a_link_to_nothing_is_refused() {
    for link in ["none.md", "../../secret.md", "cycles", "none.png"] {
        let page = format!("# One\n\n[there]({link})\n");
        let problem = first(&handbook(&[("one", &page)])).err().unwrap_or_else(|| panic!("{link} is taken"));
        assert!(problem.to_string().contains(link), "{problem}");
    }
    let page = |html: &str| Files::from([("a.html".to_owned(), html.as_bytes().to_vec())]);
    assert!(check::links(&page("<a href=\"a.html#here\"></a><p id=\"here\">")).is_ok());
    for lost in ["<a href=\"b.html\">", "<a href=\"#there\">", "<img src=\"b.png\">"] {
        assert!(check::links(&page(lost)).is_err(), "{lost}");
    }
}

// oracle: hand
#[test]
fn names_of_cycles_and_alarms_lead_to_them() {
    let pages = [
        ("jog", "# Jog\n\nAs CYCLE1: alarms 61001, 61002, `CYCLE1`, _CYCLE1.\n\n## CYCLE1\n"),
        ("cycles/CYCLE1", "# CYCLE1: One\n"),
        ("alarms", "# Alarms\n\n## 61001\n"),
    ];
    let body = first(&handbook(&pages)).unwrap().body;
    let words = "As <a href=\"cycles/CYCLE1.html\">CYCLE1</a>: alarms <a href=\"alarms.html#61001\">61001</a>, 61002, \
                 <code>CYCLE1</code>, _CYCLE1.";
    assert!(body.contains(words), "{body}");
    assert!(body.contains("<h2 id=\"cycle1\">CYCLE1<a class"), "{body}");
}

// oracle: hand
#[test]
fn what_a_page_refers_to_on_itself_is_a_link() {
    let made =
        alone("# T\n\n**A**: One. → Wear (D), B, Wear, C (`x`)\n\n**B**: 2.\n\n**Wear**: 3.\n\n**Wear (D)**: 4.\n");
    let links =
        "→ <a href=\"#wear-d\">Wear (D)</a>, <a href=\"#b\">B</a>, <a href=\"#wear\">Wear</a>, C (<code>x</code>)";
    assert!(made.body.contains(links), "{}", made.body);
}

// oracle: hand
#[test]
fn ways_lead_from_folder_to_folder() {
    assert_eq!(relative("en/alarms.html", "de/alarms.html"), "../de/alarms.html");
    assert_eq!(relative("en/cycles/A.html", "en/cycles/B.html"), "B.html");
    assert_eq!(relative("en/cycles/A.html", "en/index.html"), "../index.html");
    assert_eq!(relative("en/index.html", "en/cycles/A.html"), "cycles/A.html");
}

/// Markdown files below a folder, as paths from there.
fn pages_below(folder: &Path, from: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let inside = |path: PathBuf| match path.extension().and_then(|ending| ending.to_str()) {
        _ if path.is_dir() => pages_below(&path, from),
        Some("md") => vec![path.strip_prefix(from).unwrap().to_owned()],
        _ => Vec::new(),
    };
    entries.flat_map(inside).collect()
}

// oracle: the folder docs/
#[test]
fn every_page_of_docs_is_in_the_handbook() {
    let (codes, files) = docs();
    let folder = root().join("docs");
    let all = pages_below(&folder, &folder);
    assert!(all.len() > 100, "{}", all.len());
    for page in &all {
        let own = page.components().next().is_some_and(|one| codes.iter().any(|code| one.as_os_str() == code.as_str()));
        let place = if own { page.clone() } else { Path::new("en").join(page) };
        let name = place.with_extension("html").to_str().unwrap().replace('\\', "/");
        assert!(files.contains_key(&name), "{name}");
    }
    let pages = files.keys().filter(|name| name.ends_with(".html")).count();
    assert_eq!(pages, all.len() + codes.len() + 1, "and first pages");
}

// oracle: self (check::links, tested above)
#[test]
fn every_link_of_docs_leads_somewhere() {
    assert!(check::links(&docs().1).unwrap().contains("en/alarms.html"));
}

// oracle: hand: a concept has its picture in each language, which is there without a network too
#[test]
fn concepts_have_their_pictures_in_each_language() {
    let (codes, files) = docs();
    for code in codes {
        let (page, list) = (text(files, &format!("{code}/terms.html")), text(files, &format!("{code}.json")));
        assert!(page.matches("<img src=\"../concepts/").count() > 25, "{code}");
        assert!(page.contains("<img src=\"../concepts/mean-value.svg\""), "{code}");
        assert!(list.contains("\"concepts/mean-value.svg\""), "{code}");
    }
    assert!(text(files, "concepts/mean-value.svg").starts_with("<svg "));
}

// oracle: hand (a page is read by a person who cannot edit it)
#[test]
fn a_page_says_where_it_is_and_nothing_to_editors() {
    let (_, files) = docs();
    for (code, name, note) in
        [("en", "English", "do not edit"), ("de", "Deutsch", "nicht bearbeiten"), ("zh", "中文", "请勿编辑")]
    {
        let page = text(files, &format!("{code}/alarms.html"));
        assert!(page.contains(&format!("<html lang=\"{code}\">")));
        assert!(page.contains(&format!("lang=\"{code}\" hreflang=\"{code}\" aria-current=\"true\">{name}</a>")));
        assert!(page.contains("<a href=\"alarms.html\" aria-current=\"page\">"));
        let told = files.iter().filter(|(name, _)| name.starts_with(&format!("{code}/")));
        let told: Vec<&String> =
            told.filter(|(_, bytes)| String::from_utf8_lossy(bytes).contains(note)).map(|(name, _)| name).collect();
        assert_eq!(told, [""; 0]);
    }
    assert!(text(files, "en/coverage.html").contains("<a href=\"../de/index.html\""), "German has no such page");
}

// oracle: hand
#[test]
fn every_text_of_a_language_is_in_its_index() {
    let (_, files) = docs();
    let index = text(files, "search-zh.js").strip_prefix("probewrightBook(").unwrap().strip_suffix(");\n").unwrap();
    let index: serde_json::Value = serde_json::from_str(index).unwrap();
    let sections = index["sections"].as_array().unwrap();
    let alarm = sections.iter().find(|one| one[3] == "61016").unwrap();
    assert_eq!((&alarm[1], &alarm[2]), (&1.into(), &"61016".into()));
    let texts = index["texts"].as_array().unwrap();
    let first = &texts[alarm[4][0].as_u64().unwrap() as usize];
    assert!(first.as_str().unwrap().starts_with("缺少循环的系统坐标框架。"), "{first}");
    let different: BTreeSet<&str> = texts.iter().map(|text| text.as_str().unwrap()).collect();
    assert_eq!(different.len(), texts.len(), "each text once");
}

// oracle: hand
#[test]
fn the_list_for_offline_changes_with_what_the_files_hold() {
    let (_, files) = docs();
    let list: serde_json::Value = serde_json::from_str(text(files, "de.json")).unwrap();
    let names: Vec<&str> = list["files"].as_array().unwrap().iter().map(|name| name.as_str().unwrap()).collect();
    for name in ["de/index.html", "de/alarms.html", "search-de.js", "book.css", "book.js"] {
        assert!(names.contains(&name), "{name}");
    }
    assert!(!names.iter().any(|name| name.starts_with("en/")));
    let list = |bytes: &[u8]| super::list([(&"a".to_owned(), &bytes.to_vec())].into_iter());
    assert_eq!(list(b"one"), list(b"one"));
    assert_ne!(list(b"one"), list(b"two"));
}

// oracle: hand
#[test]
fn only_a_handbook_is_replaced() {
    let folder = std::env::temp_dir().join(format!("probewright-handbook-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("thesis.txt"), "years of work").unwrap();
    assert!(super::clear(&folder).is_err());
    assert!(folder.join("thesis.txt").exists());
    std::fs::write(folder.join(super::SCRIPT), "").unwrap();
    super::clear(&folder).unwrap();
    assert!(!folder.exists());
}
