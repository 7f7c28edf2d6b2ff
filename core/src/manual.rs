//! Sources as a reader looks them up. Beside a fact the code names a line of a manual's text (`B:5773`); the reader is
//! shown title, edition and chapter, which are the same in every language of an edition.

pub mod commissioning;
pub mod explained;

use std::fmt;
use std::sync::LazyLock;

/// The manuals: letter that code names, title, and how many lines its text has.
pub const MANUALS: [(char, &str, u32); 3] = [
    ('A', "Measuring Cycles 10/2004", 18399),
    ('B', "Measuring Cycles 04/2006", 16998),
    ('C', "NCT Probing and Digitizing Cycles 2005", 1354),
];

/// A chapter of a manual.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chapter {
    /// Letter of the manual.
    pub manual: char,
    /// Line of its heading; where the text has lost that, the line before its first section.
    pub line: u32,
    /// `5.4.2`.
    pub number: &'static str,
    /// Its heading; empty in the manual in Chinese.
    pub title: &'static str,
    /// Of that manual: the chapter of the later edition with the same subject; empty: it has none.
    pub later: &'static str,
}

/// The chapters, by manual and line.
pub static CHAPTERS: LazyLock<Vec<Chapter>> = LazyLock::new(|| {
    let chapter = |[manual, line, number, title, later]: [&'static str; 5]| {
        Some(Chapter { manual: manual.chars().next()?, line: line.parse().ok()?, number, title, later })
    };
    rows(include_str!("manual/chapters.tsv")).filter_map(chapter).collect()
});

/// The rows of a table behind its head; one with other columns is none, which tests of the tables hold.
fn rows<const COLUMNS: usize>(table: &'static str) -> impl Iterator<Item = [&'static str; COLUMNS]> {
    table.lines().skip(1).filter_map(|row| row.split('\t').collect::<Vec<_>>().try_into().ok())
}

/// What a cell lists.
fn several(cell: &'static str) -> Vec<&'static str> {
    cell.split(';').filter(|one| !one.is_empty()).collect()
}

/// Lines of manuals where a fact is found, such as `B:2408-2469;A:2591`; shown and serialized as titles, editions and
/// chapters (`Measuring Cycles 04/2006, 3.1.2; Measuring Cycles 10/2004, 3.1.2`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(test, derive(ts_rs::TS), ts(as = "String"))]
pub struct Cited(pub &'static str);

impl fmt::Display for Cited {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str(&looked_up(self.0))
    }
}

/// Begins a source that is no manual: the published files and programs behind it.
pub const PRACTICE: &str = "practice: ";

/// The lines of manuals that a text names, as titles, editions and chapters; empty: it names none.
pub fn looked_up(text: &str) -> String {
    if let Some(others) = text.strip_prefix(PRACTICE) {
        return others.to_owned();
    }
    let mut told = String::new();
    let mut said: Vec<(char, &str)> = Vec::new();
    for place in cited(text) {
        let (letter, place) = (place.manual, (place.manual, place.number));
        if said.contains(&place) {
            continue;
        }
        let last = said.last().map(|(letter, _)| *letter);
        if last != Some(letter) {
            told.push_str(if last.is_some() { "; " } else { "" });
            told.push_str(manual(letter).map_or("", |(_, title, _)| *title));
        }
        told.push_str(", ");
        told.push_str(place.1);
        said.push(place);
    }
    told
}

/// The chapters in which the lines stand that a text names.
pub fn cited(text: &str) -> impl Iterator<Item = &'static Chapter> {
    text.split([';', ',', ' ']).flat_map(lines).filter_map(|(letter, line)| chapter(letter, line))
}

impl serde::Serialize for Cited {
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_str(self)
    }
}

/// First and last line of one citation.
fn lines(citation: &str) -> impl Iterator<Item = (char, u32)> {
    let parts = citation.trim().split_once(':');
    let letter = parts.and_then(|(letter, _)| letter.chars().next());
    let numbers = parts.map_or("", |(_, numbers)| numbers).split('-');
    numbers.filter_map(move |number| Some((letter?, number.parse().ok()?)))
}

fn manual(letter: char) -> Option<&'static (char, &'static str, u32)> {
    MANUALS.iter().find(|(known, ..)| *known == letter)
}

/// Chapter in which a line stands; none before the first chapter and behind the end of the text.
fn chapter(letter: char, line: u32) -> Option<&'static Chapter> {
    manual(letter).filter(|(.., lines)| line <= *lines)?;
    let after = CHAPTERS.partition_point(|chapter| (chapter.manual, chapter.line) <= (letter, line));
    CHAPTERS.get(after.checked_sub(1)?).filter(|chapter| chapter.manual == letter)
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: manual (the headings at B:5748, B:6374 and A:2591)
    #[test]
    fn a_line_is_looked_up_in_its_chapter() {
        assert_eq!(Cited("B:5773").to_string(), "Measuring Cycles 04/2006, 5.4.2.1");
        assert_eq!(
            Cited("B:2408-2469;A:2591").to_string(),
            "Measuring Cycles 04/2006, 3.1.2; Measuring Cycles 10/2004, 3.1.2"
        );
        assert_eq!(Cited("B:5773;B:5780;B:6380-6390").to_string(), "Measuring Cycles 04/2006, 5.4.2.1, 5.5.2");
    }

    // oracle: the table is sorted, and no chapter comes back
    #[test]
    fn chapters_stand_in_the_order_of_their_lines() {
        assert!(CHAPTERS.len() > 400);
        assert!(CHAPTERS.is_sorted_by(|a, b| (a.manual, a.line) < (b.manual, b.line)));
        assert_eq!(CHAPTERS.len() + 1, include_str!("manual/chapters.tsv").lines().count(), "no row is lost");
    }
}
