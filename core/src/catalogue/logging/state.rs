//! What the cycles of the log know from one call to the next. The control keeps it in its user data: whether the log is
//! on (B:13551), and fields of `_PROTVAL[]` that are its own (B:13170).

use crate::control::{Control, Value};

/// 1: the log is on.
pub const ON: &str = "_CBIT[9]";
/// Where the members of [`State`] are.
const FIELDS: [&str; 5] = ["_PROTVAL[6]", "_PROTVAL[7]", "_PROTVAL[8]", "_PROTVAL[9]", "_PROTVAL[10]"];
/// Files of a log beside its first one (B:11196).
const FOLLOWING: usize = 9;

/// How far the log is.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct State {
    /// Name of the log as the control shows it, `LOG_1.MPF`; empty: none was begun.
    pub log: String,
    /// Which of its files is written: 0 the first, then those with a digit.
    pub number: usize,
    /// Lines of the present page.
    pub lines: usize,
    /// Number of the present page.
    pub page: i64,
    /// Whether a block of values was printed last.
    pub block: bool,
}

impl State {
    /// As the control has it.
    pub fn of(control: &Control) -> State {
        let [log, number, lines, page, block] = FIELDS.map(|name| control.text(name));
        State {
            log: log.to_owned(),
            number: number.parse().unwrap_or_default(),
            lines: lines.parse().unwrap_or_default(),
            page: page.parse().unwrap_or_default(),
            block: block == "1",
        }
    }

    /// Leaves it on the control.
    pub fn keep(&self, control: &mut Control) {
        let texts = [
            self.log.clone(),
            self.number.to_string(),
            self.lines.to_string(),
            self.page.to_string(),
            u8::from(self.block).to_string(),
        ];
        for (name, text) in FIELDS.into_iter().zip(texts) {
            control.data.insert(name.to_owned(), Value::Text(text));
        }
    }

    /// Whether all files are full.
    pub fn full(&self) -> bool {
        self.number > FOLLOWING
    }

    /// The file that is written: `LOG_1_2.MPF`.
    pub fn file(&self) -> String {
        match (self.number, self.log.rsplit_once('.')) {
            (1.., Some((name, kind))) => format!("{name}_{}.{kind}", self.number),
            _ => self.log.clone(),
        }
    }
}
