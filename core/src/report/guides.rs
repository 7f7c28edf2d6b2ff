//! Guides to what Probewright does: their page in `docs/`, and what the terminal says of one.

use super::markdown::line;
use super::terms::plain;
use crate::app::{GuideView, terms};
use crate::words::Words;
use std::fmt::Write;

/// The page, Markdown.
pub fn page(words: &Words) -> String {
    let mut text = String::new();
    line(&mut text, &format!("# {}", words.key("report-guides")));
    line(&mut text, &words.key("report-guides-intro"));
    for group in terms().guides.chunk_by(|one, next| one.group == next.group) {
        if let Some(first) = group.first() {
            line(&mut text, &format!("## {}", words.text(&first.group)));
        }
        for guide in group {
            line(&mut text, &format!("### {}", words.text(&guide.title)));
            let said: Vec<String> = guide.lines.iter().map(|line| words.text(line)).collect();
            line(&mut text, format!("{} {}", said.join(" "), place(guide)).trim_end());
            line(&mut text, &format!("```sh\n{}\n```", guide.terminal.join("\n")));
        }
    }
    text.trim_end().to_owned() + "\n"
}

/// Place in the manual, if it tells of it.
fn place(guide: &GuideView) -> String {
    let source = guide.source.to_string();
    if source.is_empty() { source } else { format!("({source})") }
}

/// All guides with their names, as the terminal lists them.
pub fn list(words: &Words) -> String {
    let mut text = String::new();
    for group in terms().guides.chunk_by(|one, next| one.group == next.group) {
        if let Some(first) = group.first() {
            let _ = writeln!(text, "{}", words.text(&first.group));
        }
        for guide in group {
            let _ = writeln!(text, "  {:<14} {}", guide.id, words.text(&guide.title));
        }
    }
    text
}

/// A guide by its id or its title. Empty: none has it.
pub fn explained(asked: &str, words: &Words) -> String {
    let asked = plain(asked);
    told(words, |guide| [plain(guide.id), plain(&words.text(&guide.title))].contains(&asked))
}

/// The guides that have this among the words by which they are found. Empty: none has it.
pub fn found(asked: &str, words: &Words) -> String {
    let asked = plain(asked);
    let has = |guide: &GuideView, words: &Words| {
        let all = words.key(format!("guide-{}-words", guide.id));
        all.split([',', '，']).any(|one| plain(one) == asked)
    };
    let english = Words::english();
    told(words, |guide| has(guide, words) || has(guide, &english))
}

fn told(words: &Words, wanted: impl Fn(&GuideView) -> bool) -> String {
    let mut text = String::new();
    for guide in terms().guides.iter().filter(|guide| wanted(guide)) {
        let _ = writeln!(text, "{}", words.text(&guide.title));
        for line in &guide.lines {
            let _ = writeln!(text, "  {}", words.text(line));
        }
        for line in &guide.terminal {
            let _ = writeln!(text, "  $ {line}");
        }
        let place = place(guide);
        if !place.is_empty() {
            let _ = writeln!(text, "  {place}");
        }
    }
    text
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::manual::explained::GUIDES;

    // oracle: self
    #[test]
    fn the_page_is_that_of_the_table() {
        super::super::held("guides.md", page);
    }

    // oracle: hand (what somebody types who looks for it)
    #[test]
    fn a_guide_is_found_by_name_and_by_word() {
        let wanted = [
            ("en", "series", "series"),
            ("en", "Choosing _TZL, _TMV and _K", "limits"),
            ("en", "Cpk", "series"),
            ("en", "guard band", "certainty"),
            ("en", "JUnit", "scenarios"),
            ("de", "Messunsicherheit", "certainty"),
            ("de", "Nacharbeit", "around"),
            ("zh", "批量工件", "series"),
            ("zh", "返修", "around"),
        ];
        for (language, asked, id) in wanted {
            let words = Words::of(language).unwrap();
            let text = explained(asked, &words) + &found(asked, &words);
            assert!(text.contains(&words.key(format!("guide-{id}-1"))), "{asked}: {text}");
        }
        assert_eq!(found("nobody's word", &Words::english()), "");
        assert!(GUIDES.iter().all(|guide| list(&Words::english()).contains(guide.id)));
    }
}
