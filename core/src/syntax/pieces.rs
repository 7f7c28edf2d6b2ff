//! A text that can be run in pieces of some lines: one at a time is at hand, so that it may be longer than memory. Its
//! lines need nothing of one another: no jumps, no repetitions, no programs, no names that are declared or read, and no
//! block that waits for the next one.

use super::tree::{Expr, Program, Word, WordKind};
use crate::dialect::Dialect;

/// G functions of a block that waits for the next one, and of measuring blocks and macros that are called again.
const WAITING: [i64; 6] = [31, 41, 42, 65, 66, 67];
/// The last of the ordinary G functions of NCT: behind it are its macros.
const LAST: f64 = 99.0;
/// M functions that go to another place.
const GOING: [i64; 2] = [98, 99];
/// Addresses beside G and M.
const ADDRESSES: &[u8] = b"XYZABCUVWIJKFSTDH";
/// Calls that only tell something or wait.
const TELLING: [&str; 2] = ["MSG", "STOPRE"];
/// A call that counts from then on.
const MODAL: &str = "MCALL";

impl Program {
    /// Whether this can be the beginning of a text that is run in pieces: before its motions it may write data and call
    /// cycles.
    pub fn begins_pieces(&self) -> bool {
        let mut words = self.words.iter().skip_while(|word| word.kind == WordKind::Header);
        self.is_understood()
            && words.all(|word| match &word.kind {
                WordKind::Assign { .. } => true,
                WordKind::Call { name, .. } => !self.is(*name, MODAL),
                _ => self.is_ordinary(word),
            })
    }

    /// Whether this can be a later piece.
    pub fn goes_on_in_pieces(&self) -> bool {
        self.is_understood() && self.words.iter().all(|word| self.is_ordinary(word) || self.is_call(word, &TELLING))
    }

    /// Whether every word can be read, none asks for a variable, and the text has no end before its last byte.
    fn is_understood(&self) -> bool {
        let reads = |expr: &Expr| matches!(expr, Expr::Name { .. } | Expr::Call(..));
        self.errors.is_empty() && self.end as usize == self.source.len() && !self.exprs.iter().any(reads)
    }

    /// Whether a word is an address that concerns its block alone, or what is active from then on.
    fn is_ordinary(&self, word: &Word) -> bool {
        let WordKind::Address { name, value, .. } = word.kind else { return false };
        let [letter] = self.text(name) else { return self.is(name, "CR") && self.number(value).is_some() };
        match (letter.to_ascii_uppercase(), self.number(value)) {
            (b'G', Some(code)) => {
                (self.dialect == Dialect::Sinumerik || code <= LAST) && !WAITING.contains(&(code as i64))
            }
            (b'M', Some(code)) => !GOING.contains(&(code as i64)),
            (b'T', None) => true,
            (other, number) => number.is_some() && ADDRESSES.contains(&other),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::read;

    // oracle: hand
    #[test]
    fn what_needs_other_lines_is_not_run_in_pieces() {
        let program = |text: &str| read(Dialect::Sinumerik, text.as_bytes());
        for text in [
            "N10 G1 X1 F100\nM30\n",
            "T1 D1\nM6\n; text\n/ G0 Z5\n",
            "T=\"MILL\" S1=500\nMSG(\"A\")\n",
            "G2 X1 Y2 I3 J0\n",
        ] {
            assert!(program(text).begins_pieces() && program(text).goes_on_in_pieces(), "{text}");
        }
        for text in ["%_N_A_MPF\n_MVAR=1 _SETVAL=5\nCYCLE977\nG0 X1\n", "R1=5\n"] {
            assert!(program(text).begins_pieces() && !program(text).goes_on_in_pieces(), "{text}");
        }
        for text in [
            "GOTOF A\n", "A: X1\n", "R1=R2\n", "X=R1\n", "DEF REAL A\n", "IF R1==1 GOTOF N5\n", "PROC A\n",
            "X1\n%_N_B_SPF\n", "G41 X1\n", "X1 RND=5\n", "G1 X(((\n", "X1\rY2\n", "X1\n\u{1a}\n", "MCALL L10\n",
            "REPEAT A\n",
        ] {
            assert!(!program(text).begins_pieces(), "{text}");
        }
    }
}
