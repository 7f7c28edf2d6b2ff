//! `docs/coverage.md`: each chapter of the manuals with what serves it here, generated from the places that the code
//! cites. A chapter that nothing serves fails.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::manual::{CHAPTERS, Chapter, MANUALS, cited};
use probewright_tests::{files, root};
use std::collections::{BTreeMap, BTreeSet};

/// Where a reader of a chapter goes: by the beginning of the path of a file that cites it, the longest first.
/// `{}`: the next part of the path in capitals.
const PLACES: &[(&str, &str)] = &[
    ("manual/concepts.tsv", "[concepts](terms.md)"),
    ("manual/guides.tsv", "[guides](guides.md)"),
    ("manual/terms.tsv", "[terms](terms.md)"),
    ("manual/steps.tsv", "[commissioning](commissioning.md)"),
    ("manual/connections.tsv", "[commissioning](commissioning.md)"),
    ("manual/compatibility.tsv", "[commissioning](commissioning.md)"),
    ("catalogue/alarms", "[alarms](alarms.md)"),
    ("catalogue/cycle", "[{}](cycles/{}.md)"),
    ("catalogue/g1", "[{}](cycles/{}.md)"),
    ("catalogue/p99", "[G65 {}](cycles/G65-{}.md)"),
    ("catalogue/help", "help pages"),
    ("catalogue/softkeys", "help pages"),
    ("catalogue/logging", "log"),
    ("catalogue/older", "calls with arguments"),
    ("catalogue/newer", "[newer controls](generations.md)"),
    ("catalogue/r_parameters", "programs with R parameters"),
    ("catalogue/subroutines", "programs of older versions"),
    ("catalogue/operator_messages", "messages of the run"),
    ("catalogue", "forms of all cycles"),
    ("control/gud", "[user data](machine-data.md)"),
    ("control/machine_data", "[machine data](machine-data.md)"),
    ("control/nct_data", "[NCT data](machine-data.md)"),
    ("control/needs", "check of a machine"),
    ("control/braking", "braking path"),
    ("control/definitions", "definition files"),
    ("control", "the simulated control"),
    ("app/machine_check", "check of a machine"),
    ("app/protocol", "values of a real machine"),
    ("app/user_programs", "CYCLE198, CYCLE199"),
    ("app/series", "series of parts"),
    ("app/answer", "result screens"),
    ("app/whereabouts", "help pages"),
    ("app", "the page's answers"),
    ("program/user_programs", "CYCLE198, CYCLE199"),
    ("program/probe_test", "test of a probe"),
    ("program/around", "[blocks around a call](around.md)"),
    ("program", "reading of programs"),
    ("run", "run of a program"),
    ("jog", "[measuring in JOG](jog.md)"),
    ("support", "program editor support"),
    ("check", "checks of a call"),
    ("entry", "forms of all cycles"),
    ("form", "forms of all cycles"),
    ("evaluate", "corrections"),
    ("machine", "the simulated machine"),
    ("workpiece", "the simulated machine"),
    ("geometry", "the simulated machine"),
    ("scan", "digitizing"),
    ("series", "series of parts"),
    ("scene", "3D view"),
    ("picture", "3D view"),
    ("syntax", "reading of programs"),
    ("dialect", "reading of programs"),
    ("name", "forms of all cycles"),
    ("range", "forms of all cycles"),
    ("report", "generated pages"),
    ("json", "the page's answers"),
    ("setup_file", "the simulated machine"),
    ("own", "findings"),
    ("foreign", "controls of other makers"),
    ("bin", "terminal"),
    ("test_data", "tests"),
    ("manual", ""),
];

/// What serves a chapter.
type Served = BTreeMap<(char, &'static str), BTreeSet<String>>;

/// Whether a file only tests: what it cites serves nobody.
fn is_test(path: &str) -> bool {
    path.split('/')
        .any(|part| part == "tests" || part.ends_with("tests") || part.ends_with("tests.rs") || part == "table_tests")
}

fn place(path: &str) -> String {
    let (begin, place) = PLACES.iter().find(|(begin, _)| path.starts_with(begin)).expect(path);
    let part = path.split('/').nth(begin.matches('/').count()).unwrap_or_default();
    place.replace("{}", &part.trim_end_matches(".rs").to_uppercase())
}

fn served() -> Served {
    let core = root().join("core/src");
    let mut served = Served::new();
    for file in files(&core, &["rs", "tsv"]) {
        let path = file.strip_prefix(&core).unwrap().to_string_lossy().replace('\\', "/");
        if is_test(&path) || path == "manual.rs" || path == "manual/chapters.tsv" {
            continue;
        }
        let text = std::fs::read_to_string(&file).unwrap();
        let words = text.split(|letter: char| !letter.is_ascii_alphanumeric() && !":-".contains(letter));
        for chapter in words.filter(|word| word.contains(':')).flat_map(cited) {
            served.entry((chapter.manual, chapter.number)).or_default().insert(place(&path));
        }
    }
    served
}

/// What serves the chapter itself; else what serves the chapters below it, or in the later edition that on its subject.
fn of(served: &Served, chapter: &Chapter) -> (Option<BTreeSet<String>>, &'static str) {
    let own = served.get(&(chapter.manual, chapter.number)).cloned();
    match own {
        Some(_) => (own, ""),
        None if below(chapter).next().is_some() => (None, "below"),
        None => (later(served, chapter), "later"),
    }
}

/// What serves the chapter of the later edition with the same subject, or the chapters below that.
fn later(served: &Served, chapter: &Chapter) -> Option<BTreeSet<String>> {
    let same = CHAPTERS.iter().find(|one| one.manual == 'B' && one.number == chapter.later && chapter.manual == 'A')?;
    let all = std::iter::once(same).chain(below(same));
    let places: BTreeSet<String> =
        all.filter_map(|one| served.get(&(one.manual, one.number))).flatten().cloned().collect();
    (!places.is_empty()).then_some(places)
}

fn below(chapter: &Chapter) -> impl Iterator<Item = &'static Chapter> {
    let (manual, begin) = (chapter.manual, format!("{}.", chapter.number));
    CHAPTERS.iter().filter(move |one| one.manual == manual && one.number.starts_with(&begin))
}

fn page(served: &Served) -> String {
    let mut text =
        "# What the manuals say, and where it is here\n\nEach chapter of the three manuals with what serves it. \
                    Generated from the places that the code cites; do not edit. A heading without a text of its own is \
                    served by the chapters below it.\n"
            .to_owned();
    for (letter, title, _) in MANUALS {
        text += &format!("\n## {title}\n\n| chapter | served by |\n| --- | --- |\n");
        for chapter in CHAPTERS.iter().filter(|chapter| chapter.manual == letter) {
            let (places, how) = of(served, chapter);
            let named =
                places.as_ref().map(|all| all.iter().filter(|place| !place.is_empty()).cloned().collect::<Vec<_>>());
            let says = match (named, how) {
                (Some(named), "later") => format!("as 04/2006, {}: {}", chapter.later, named.join(", ")),
                (Some(named), _) => named.join(", "),
                (None, "below") => "the chapters below".to_owned(),
                (None, _) => String::new(),
            };
            text += &format!("| {} {} | {says} |\n", chapter.number, chapter.title).replace("  |", " |");
        }
    }
    text
}

// oracle: self: every chapter has something
#[test]
fn no_chapter_of_the_manuals_has_nothing() {
    let served = served();
    let empty = |chapter: &&Chapter| {
        let (places, how) = of(&served, chapter);
        how != "below" && places.as_ref().is_none_or(|all| all.iter().all(|place| place.is_empty() || place == "tests"))
    };
    let missing: Vec<String> =
        CHAPTERS.iter().filter(empty).map(|one| format!("{} {} {}", one.manual, one.number, one.title)).collect();
    assert!(missing.is_empty(), "nothing serves\n{}", missing.join("\n"));
}

// oracle: self: a section stands in its chapter
#[test]
fn every_section_has_its_chapter() {
    let listed: BTreeSet<_> = CHAPTERS.iter().map(|one| (one.manual, one.number)).collect();
    let above = |one: &&Chapter| one.number.rsplit_once('.').map(|(above, _)| (one.manual, above));
    let lacking: BTreeSet<_> =
        CHAPTERS.iter().filter_map(|one| above(&one)).filter(|one| !listed.contains(one)).collect();
    assert!(lacking.is_empty(), "no row for {lacking:?}");
}

// oracle: self
#[test]
fn the_page_is_that_of_the_code() {
    let page = page(&served());
    let file = root().join("docs/coverage.md");
    if std::env::var_os("PROBEWRIGHT_UPDATE").is_some() {
        std::fs::write(&file, &page).unwrap();
    }
    assert_eq!(std::fs::read_to_string(&file).unwrap(), page);
}
