//! What a machine can hold of the rules for words: lengths, full stops, words that a language does not use.

use super::{files, folders, texts};
use probewright_core::words::LANGUAGES;
use std::collections::BTreeSet;

/// What a text is for. Its key says it.
#[derive(Clone, Copy, PartialEq)]
enum Sort {
    /// Name of a parameter.
    Label,
    /// What is wrong, and why it matters.
    Finding,
    /// What to do, or the cause of an alarm.
    Hint,
    /// Help of a field or of a choice.
    Help,
    /// A line of a help page.
    Page,
    /// Shown for a moment.
    Toast,
}

impl Sort {
    fn of(file: &str, key: &str) -> Option<Sort> {
        let begins = |starts: &[&str]| starts.iter().any(|start| key.starts_with(start));
        let ends = |ends: &[&str]| ends.iter().any(|end| key.ends_with(end));
        match () {
            () if key.starts_with("notice-") => Some(Sort::Toast),
            () if file == "page.ftl" || ends(&["-words"]) || begins(&["help-section-"]) => None,
            () if begins(&["help-", "jog-help-"]) => Some(Sort::Page),
            () if ends(&["-hint", ".cure", ".cause"]) => Some(Sort::Hint),
            () if ends(&["-help", ".help"]) => Some(Sort::Help),
            () if begins(&["check-", "run-", "syntax-", "write-", "alarm-"]) => Some(Sort::Finding),
            () if begins(&["param-"]) && !key.contains('.') => Some(Sort::Label),
            () => None,
        }
    }

    /// Characters that such a text may have. German is longer; Chinese needs about half of the English.
    fn longest(self, language: &str) -> usize {
        let [english, german] = match self {
            Sort::Label => [32, 40],
            Sort::Finding | Sort::Hint => [110, 130],
            Sort::Help => [180, 200],
            Sort::Page => [190, 220],
            Sort::Toast => [60, 75],
        };
        match language {
            "de" => german,
            "zh" => english * 3 / 4,
            _ => english,
        }
    }

    /// Whether such a text is a sentence, with its full stop.
    fn is_sentence(self) -> bool {
        self != Sort::Label
    }
}

/// Texts that may be longer, because they list what has to be listed.
const LISTS: [&str; 1] = ["alarm-61309.cure"];

/// Words that a language does not use, with what it says instead. `#` is a digit or an argument.
const UNUSED: &[(&str, &[(&str, &str)])] = &[
    (
        "en",
        &[
            ("doubt", "warning"),
            ("doubts", "warnings"),
            ("mended", "fixed"),
            ("delivered", "default"),
            ("reckoned", "calculated"),
            ("standing spindle", "stationary spindle"),
            ("turning spindle", "rotating spindle"),
            ("in force", "active"),
            ("on its way", "loading"),
            ("on their way", "loading"),
            ("upon each other", "coincident"),
            ("tool correction", "tool offset"),
            ("safety zone", "protection zone or safe area"),
            ("target value", "setpoint"),
            ("please", ""),
            ("digit #", "4th digit"),
            ("digits #", "3rd to 5th digits"),
        ],
    ),
    (
        "de",
        &[
            ("Formular", "Maske"),
            ("Meßtaster", "Messtaster"),
            ("Nullpunktoffset", "Nullpunktverschiebung"),
            ("Sicherheitszone", "Schutzzone"),
            ("Werkzeugoffset", "Werkzeugkorrektur"),
            ("erfolgt", "the verb"),
            ("mittels", "mit"),
            ("seitens", "von"),
            ("überprüfen", "prüfen"),
            ("bitte", ""),
            ("Kalibration", "Kalibrieren"),
            ("Zielwert", "Sollwert"),
            ("Stelle #", "4. Stelle"),
            ("Stellen #", "3. bis 5. Stelle"),
        ],
    ),
    (
        "zh",
        &[
            ("疑问", "警告"),
            ("测量头", "测头"),
            ("出厂值", "默认值"),
            ("额定值", "设定值"),
            ("置信", "安全区"),
            ("可信范围", "安全区"),
            ("重量因素", "加权系数"),
            ("触发器", "触发点"),
            ("标定", "校准"),
            ("差分测量", "差值测量"),
            ("测尖", "测球"),
            ("圆轴", "回转轴"),
            ("该数位", "第 4 位"),
        ],
    ),
];

/// Whether a text has these words, in a language with spaces as whole words.
fn has(text: &str, words: &str) -> bool {
    let number = |one: char| one.is_ascii_digit() || one == '{';
    let (text, words) = (text.replace(number, "#").to_lowercase(), words.to_lowercase());
    let letter = |side: Option<char>| side.is_some_and(|one| one.is_alphabetic() && one.is_ascii());
    text.match_indices(&words)
        .any(|(at, _)| !letter(text[..at].chars().next_back()) && !letter(text[at + words.len()..].chars().next()))
}

/// Characters of a text as it is shown, with five for each argument; none where the number decides which text it is.
fn length(text: &str) -> Option<usize> {
    if text.contains("->") {
        return None;
    }
    let shown = text.trim().split('{').enumerate().map(|(at, part)| match part.split_once('}') {
        Some((inside, behind)) if at > 0 => {
            let inside = inside.trim();
            let argument = if inside.starts_with('$') { 5 } else { inside.trim_matches('"').chars().count() };
            argument + behind.chars().count()
        }
        _ => part.chars().count(),
    });
    Some(shown.sum())
}

/// Symbols that a line break must not part from the number before them.
const UNITS: [&str; 12] = ["mm", "mm/min", "in/min", "m/min", "ft/min", "rpm", "r/min", "1/min", "MB", "kB", "s", "V"];

/// A unit with a breakable blank before it, or `MD` and `SD` with one or none before their number.
fn parted(text: &str) -> Option<&'static str> {
    let number = |side: &str| side.ends_with(|one: char| one.is_ascii_digit() || one == '}');
    let longer = |rest: &str| rest.starts_with(|one: char| one.is_ascii_alphanumeric() || one == '/');
    let parts = |unit: &str| {
        let breaks = |at: usize| text[..at].strip_suffix(' ').is_some_and(number) && !longer(&text[at + unit.len()..]);
        text.match_indices(unit).any(|(at, _)| breaks(at))
    };
    let five = |rest: &str| rest.len() >= 5 && rest.bytes().take(5).all(|one| one.is_ascii_digit());
    let joins = |name: &str| {
        let alone = |at: usize| !text[..at].ends_with(['_', '$', '"']);
        text.match_indices(name).any(|(at, _)| alone(at) && five(text[at + name.len()..].trim_start_matches(' ')))
    };
    UNITS.into_iter().find(|unit| parts(unit)).or_else(|| ["MD", "SD"].into_iter().find(|name| joins(name)))
}

/// Asks about every text with its language, file and key; what is answered is what is wrong with it.
fn faults(wrong: impl Fn(&str, &str, &str, &str) -> Option<String>) -> Vec<String> {
    let mut faults = Vec::new();
    for folder in folders() {
        for language in LANGUAGES {
            for file in files(&folder.join(language.code)) {
                let texts = texts(&folder.join(language.code).join(&file));
                let found = texts.iter().filter_map(|(key, text)| Some((key, wrong(language.code, &file, key, text)?)));
                faults.extend(found.map(|(key, fault)| format!("{}/{file} {key}: {fault}", language.code)));
            }
        }
    }
    faults
}

// oracle: hand (the rules for words: how long a text of each kind may be)
#[test]
fn texts_keep_the_length_of_their_kind() {
    let long = faults(|language, file, key, text| {
        let most = Sort::of(file, key).filter(|_| !LISTS.contains(&key))?.longest(language);
        length(text).filter(|length| *length > most).map(|length| format!("{length} of {most} characters"))
    });
    assert!(long.is_empty(), "{}:\n{}", long.len(), long.join("\n"));
}

// oracle: hand (the rules for words: sentences end in a full stop, labels do not)
#[test]
fn sentences_end_in_a_full_stop_and_labels_do_not() {
    let wrong = faults(|_, file, key, text| {
        let stops = text.trim().ends_with(['.', '。', '?', '？', '…', '}']);
        let label = text.trim().ends_with(['.', '。']);
        let sentence = Sort::of(file, key)?.is_sentence();
        (if sentence { !stops } else { label }).then(|| text.trim().to_owned())
    });
    assert!(wrong.is_empty(), "{}:\n{}", wrong.len(), wrong.join("\n"));
}

/// A text without the word of the manual in Chinese that it quotes, by which a term is found.
fn unquoted(text: &str) -> String {
    let Some((before, quoted)) = text.split_once("10/2004 手册中称“") else { return text.to_owned() };
    before.to_owned() + quoted.split_once('”').map_or("", |(_, behind)| behind)
}

// oracle: hand (the rules for words: one word for one thing)
#[test]
fn no_text_uses_a_word_that_its_language_does_not() {
    let wrong = faults(|language, _, key, text| {
        let (_, unused) = UNUSED.iter().find(|(code, _)| *code == language).filter(|_| !key.ends_with("-words"))?;
        let (word, instead) = unused.iter().find(|(word, _)| has(&unquoted(text), word))?;
        Some(format!("“{word}”, better “{instead}”: {}", text.trim()))
    });
    assert!(wrong.is_empty(), "{}:\n{}", wrong.len(), wrong.join("\n"));
}

// oracle: hand (the rules for words: a number and its unit, MD and its number, stay on one line)
#[test]
fn numbers_stay_with_their_units() {
    let wrong = faults(|_, _, key, text| {
        let what = parted(text).filter(|_| !key.ends_with("-words"))?;
        Some(format!("no-break space at {what}: {}", text.trim()))
    });
    assert!(wrong.is_empty(), "{}:\n{}", wrong.len(), wrong.join("\n"));
    assert_eq!(
        ["{ $path } mm,", "5 mm/min", "MD18080", "5\u{a0}mm", "MD\u{a0}18080", "3 mmx"].map(parted),
        [Some("mm"), Some("mm/min"), Some("MD"), None, None, None]
    );
}

// oracle: self: the terminal writes numbers as they are and knows no function, and prints its name
#[test]
fn no_text_calls_a_function() {
    let calls = |text: &str| {
        text.split('{').skip(1).any(|inside| {
            let behind = inside.trim_start().trim_start_matches(|c: char| c.is_ascii_uppercase());
            behind.starts_with('(') && behind.len() < inside.trim_start().len()
        })
    };
    let wrong = faults(|_, _, _, text| calls(text).then(|| text.trim().to_owned()));
    assert!(wrong.is_empty(), "{}:\n{}", wrong.len(), wrong.join("\n"));
    assert!(calls("a { NUMBER($way) }") && !calls("a (b) { $way } (c)"));
}

/// Texts of what is too large that name no limit, with the reason.
const NO_LIMIT: [(&str, &str); 7] = [
    ("alarm-", "sentence of the control's own alarm: the limit depends on machine and variant"),
    ("nct-", "sentence of the control's own message: the limit is a value of the call"),
    ("evaluate-", "a line of the run, beside the values that were compared"),
    ("guide-", "a guide says what happens, not what happened"),
    ("help-", "a help page says what a mistake does to the result"),
    ("jog-help-", "the same of a mask"),
    ("notice-link-long", "the limit is one of the packed text, which nobody can measure"),
];

// oracle: hand (the rules for words: what is wrong has its value, and the next step needs the limit)
#[test]
fn what_is_too_large_has_its_limit() {
    let wrong = faults(|language, _, key, text| {
        let limit = ["$most", "$limit", "$max"].iter().any(|name| text.contains(name));
        let too = ["too large", "too many", "too long", "too deep", "too big"].iter().any(|words| text.contains(words));
        let excused = NO_LIMIT.iter().any(|(start, _)| key.starts_with(start)) || key.ends_with("-words");
        (language == "en" && too && !limit && !excused).then(|| text.trim().to_owned())
    });
    assert!(wrong.is_empty(), "{}:\n{}", wrong.len(), wrong.join("\n"));
}

/// What stands in quotation marks of the language.
fn quoted<'a>(text: &'a str, language: &str) -> Vec<&'a str> {
    let [open, close] = if language == "de" { ['„', '“'] } else { ['“', '”'] };
    text.split(open).skip(1).filter_map(|rest| Some(rest.split_once(close)?.0)).collect()
}

// oracle: self: what a guide tells to press, choose or look at is there under that name
#[test]
fn guides_name_controls_as_the_page_does() {
    let mut named = 0;
    for language in LANGUAGES {
        let all = folders().map(|folder| {
            let folder = folder.join(language.code);
            let others = files(&folder).into_iter().filter(|file| file != "guides.ftl");
            others.flat_map(|file| texts(&folder.join(file)).into_values()).collect::<Vec<_>>()
        });
        let known: BTreeSet<&str> = all.iter().flatten().map(|text| text.trim()).collect();
        let [core, _] = folders();
        for (key, text) in texts(&core.join(language.code).join("guides.ftl")) {
            for name in quoted(&text, language.code) {
                assert!(known.contains(name), "{} {key}: nothing on the page is called “{name}”", language.code);
                named += 1;
            }
        }
    }
    assert!(named > 100);
}

// oracle: hand
#[test]
fn whole_words_are_told_from_parts_of_others() {
    assert!(has("Die Messung erfolgt hier", "erfolgt") && !has("nacherfolgte", "erfolgt"));
    assert!(has("按额定值补偿", "额定值") && !has("", "please"));
    assert!(has("Digit { $place } of it", "digit #") && !has("the 4th digit of 12", "digit #"));
    assert_eq!(length(" { $value } mm, { \"_FA\" }."), Some(14));
}
