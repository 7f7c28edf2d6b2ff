//! A program and the files that belong to it: one text, as the control has one program memory.

use super::block::before_end;
use crate::dialect::Dialect;
use std::sync::Arc;

const MARK: &[u8] = b"\xef\xbb\xbf";

/// A program with the files behind it.
pub struct Joined {
    /// All of it.
    pub text: Arc<Vec<u8>>,
    /// Language of the program.
    pub dialect: Dialect,
    /// Where each file begins in the text, bytes, the program first; its header counts only where the file has one.
    pub starts: Vec<usize>,
}

impl Joined {
    /// A program alone.
    pub fn new(dialect: Dialect, source: Vec<u8>) -> Joined {
        Joined::held(dialect, Arc::new(source))
    }

    /// A program alone that somebody else holds too.
    pub fn held(dialect: Dialect, text: Arc<Vec<u8>>) -> Joined {
        Joined { text, dialect, starts: vec![0] }
    }

    /// Puts a file behind them. One without a header gets one with its name.
    pub fn add(&mut self, name: &str, source: &[u8]) {
        // nothing counts behind an end of file, and what follows is in a line of its own
        let text = Arc::make_mut(&mut self.text);
        let last = self.starts.last().copied().unwrap_or(0);
        let end = before_end(text.get(last..).unwrap_or_default()).len();
        text.truncate(last + end);
        text.push(b'\n');
        // inside the text a mark of UTF-8 would be a character; blanks in its place leave every place as it was
        let marked = source.strip_prefix(MARK);
        let (blanks, source) = marked.map_or((&b""[..], source), |source| (&b"   "[..], source));
        if self.dialect == Dialect::Sinumerik && !source.trim_ascii_start().starts_with(b"%") {
            text.extend(header(name).into_bytes());
        }
        self.starts.push(text.len());
        text.extend(blanks);
        text.extend(source);
    }
}

/// `SUB.SPF` is `%_N_SUB_SPF`, `GUD4.DEF` is `%_N_GUD4_DEF`.
fn header(file: &str) -> String {
    let (name, ending) = file.rsplit_once('.').filter(|(name, _)| !name.is_empty()).unwrap_or((file, ""));
    let known = |one: char| if one.is_ascii_alphanumeric() { one.to_ascii_uppercase() } else { '_' };
    let name: String = name.chars().map(known).collect();
    let name = name.strip_prefix("_N_").unwrap_or(&name);
    let bare = ["_SPF", "_MPF", "_DEF"].iter().any(|ending| name.ends_with(ending));
    match (bare, ending.to_ascii_uppercase().as_str()) {
        (true, _) => format!("%_N_{name}\n"),
        (false, "DEF") => format!("%_N_{name}_DEF\n"),
        (false, "MPF") => format!("%_N_{name}_MPF\n"),
        (false, _) => format!("%_N_{name}_SPF\n"),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::indexing_slicing)]
    use super::*;

    // oracle: hand (three bytes of a mark, three blanks; the first line counts, be it a header or not)
    #[test]
    fn a_mark_at_the_begin_of_a_file_is_none_in_the_middle_of_a_text() {
        for (first, name) in [("DEF NCK REAL A=5\n", "GUD4.DEF"), ("%_N_GUD4_DEF\nDEF NCK REAL A=5\n", "any.txt")] {
            let mut joined = Joined::new(Dialect::Sinumerik, b"R1=A\nM30\n".to_vec());
            joined.add(name, format!("\u{feff}{first}M17\n").as_bytes());
            assert_eq!(&joined.text[joined.starts[1]..], format!("   {first}M17\n").as_bytes());
            let program = crate::syntax::read(joined.dialect, &joined.text);
            assert!(program.errors.is_empty(), "{:?}", program.errors);
            let found = crate::syntax::definitions::definitions(&joined.text).definitions;
            assert_eq!(found.lines, ["DEF NCK REAL A=5"], "{first}");
        }
    }

    // oracle: self (what a header of a program or definition file has to say: core/src/syntax/programs.rs)
    #[test]
    fn a_file_without_a_header_gets_one() {
        for (file, source, text) in [
            ("l105.spf", "M17", "M30\n%_N_L105_SPF\nM17"),
            ("_N_A_B_SPF", "M17", "M30\n%_N_A_B_SPF\nM17"),
            ("GUD4.DEF", "DEF NCK REAL A", "M30\n%_N_GUD4_DEF\nDEF NCK REAL A"),
            ("any.SPF", "\n%_N_B_SPF\nM17", "M30\n\n%_N_B_SPF\nM17"),
        ] {
            let mut joined = Joined::new(Dialect::Sinumerik, b"M30\x1aleft".to_vec());
            joined.add(file, source.as_bytes());
            assert_eq!(String::from_utf8_lossy(&joined.text), text, "{file}");
            assert_eq!(&joined.text[joined.starts[1]..], source.as_bytes(), "{file}");
        }
    }
}
