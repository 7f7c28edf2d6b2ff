//! The comment before a call that names the settings with which it was written, as the one of the manual's example
//! does (B:12421). What was changed since then is seen when the program is read (B:12549-12558).

use super::{ENTRIES, name};
use crate::control::Control;

/// Machine data after whose change the control cannot read its own calls back (B:12556-12558).
const TOOL_PROGRAMMING: [&str; 2] = ["MD18102", "MD18080"];

const MASK: &str = "_MZ_MASK";

/// The settings with which a call was written.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// `_MZ_MASK[0]` to `[7]`.
    mask: Vec<f64>,
    /// MD 18102 and MD 18080.
    tools: [f64; 2],
}

/// A setting that is another one now: its name, what it was, what it is.
pub type Changed = (String, f64, f64);

impl Mark {
    /// The settings of a machine.
    pub fn of(control: &Control) -> Mark {
        Mark {
            mask: (0..ENTRIES).map(|entry| control.number(&name(entry))).collect(),
            tools: TOOL_PROGRAMMING.map(|datum| control.number(datum)),
        }
    }

    /// `; _MZ_MASK=1,0,0,0,0,0,0,0 MD18102=0 MD18080=256`.
    pub fn text(&self) -> String {
        let mask: Vec<String> = self.mask.iter().map(f64::to_string).collect();
        let tools = TOOL_PROGRAMMING.iter().zip(self.tools);
        tools.fold(format!("; {MASK}={}", mask.join(",")), |text, (name, value)| format!("{text} {name}={value}"))
    }

    /// Reads a comment; none for any other.
    pub fn read(comment: &str) -> Option<Mark> {
        let mut words = comment.trim_start_matches(';').split_whitespace();
        let mut value = |name: &str| words.next()?.strip_prefix(name)?.strip_prefix('=');
        let mask: Option<Vec<f64>> = value(MASK)?.split(',').map(number).collect();
        let [first, second] = TOOL_PROGRAMMING;
        Some(Mark {
            mask: mask.filter(|mask| mask.len() == ENTRIES)?,
            tools: [number(value(first)?)?, number(value(second)?)?],
        })
    }

    /// The entries of the mask that are others on a machine.
    pub fn mask_changed(&self, now: &Mark) -> Vec<Changed> {
        changed((0..ENTRIES).map(name), &self.mask, &now.mask)
    }

    /// The kind of tool programming, where it is another on a machine.
    pub fn tools_changed(&self, now: &Mark) -> Vec<Changed> {
        changed(TOOL_PROGRAMMING.map(str::to_owned).into_iter(), &self.tools, &now.tools)
    }
}

fn number(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.is_finite())
}

fn changed(names: impl Iterator<Item = String>, before: &[f64], now: &[f64]) -> Vec<Changed> {
    let all = names.zip(before.iter().zip(now));
    all.filter(|(_, (before, now))| before != now).map(|(name, (before, now))| (name, *before, *now)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::delivery;
    use crate::dialect::Dialect;

    // oracle: hand
    #[test]
    fn it_is_read_as_it_was_written_and_nothing_else_is() {
        let mark = Mark::of(&delivery(Dialect::Sinumerik));
        assert_eq!(Mark::read(&mark.text()).as_ref(), Some(&mark));
        for other in [
            "",
            ";",
            "; _MZ_MASK[0]=1 generated",
            "; _MZ_MASK=1,0,0 MD18102=0 MD18080=256",
            "; _MZ_MASK=1,0,0,0,0,0,0,x MD18102=0 MD18080=256",
            "; _MZ_MASK=1,0,0,0,0,0,0,0 MD18102=0",
            "; _MZ_MASK=1,0,0,0,0,0,0,inf MD18102=0 MD18080=256",
        ] {
            assert_eq!(Mark::read(other), None, "{other}");
        }
    }
}
