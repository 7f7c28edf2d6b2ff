//! The name of a parameter: a slip does not compile.

use serde::Serialize;
use std::borrow::Borrow;
use std::fmt;
use std::ops::Deref;

/// Name of a parameter as the manual writes it (`_SETV[0]`, `D`): one constant for an entry and what reads it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(as = "String"))]
pub struct Name(&'static str);

impl Name {
    /// A name; a constant beside the entry, or in the list of those that entries share.
    pub const fn new(name: &'static str) -> Name {
        Name(name)
    }

    /// As the manual writes it.
    pub const fn as_str(self) -> &'static str {
        self.0
    }
}

/// The name of a variable without leading zeroes in its numeric extension: `R01` is `R1` (fundamentals manual 10.2004,
/// p. 2-15), `#0100` is `#100`; other names stay.
pub fn numbered(mut name: String) -> String {
    let bytes = name.as_bytes();
    if let [b'R' | b'#', digits @ ..] = bytes
        && digits.iter().all(u8::is_ascii_digit)
    {
        let zeroes = digits.iter().take_while(|digit| **digit == b'0').count().min(digits.len().saturating_sub(1));
        name.drain(1..=zeroes);
    }
    name
}

impl Deref for Name {
    type Target = str;

    fn deref(&self) -> &str {
        self.0
    }
}

impl Borrow<str> for Name {
    fn borrow(&self) -> &str {
        self.0
    }
}

impl PartialEq<str> for Name {
    fn eq(&self, other: &str) -> bool {
        self.0 == other
    }
}

impl PartialEq<&str> for Name {
    fn eq(&self, other: &&str) -> bool {
        self.0 == *other
    }
}

impl PartialEq<Name> for &str {
    fn eq(&self, other: &Name) -> bool {
        *self == other.0
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.0)
    }
}

impl fmt::Debug for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl From<Name> for String {
    fn from(name: Name) -> String {
        name.0.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::numbered;

    // oracle: manual (fundamentals 10.2004, p. 2-15: leading zeroes are ignored in variables with numeric extensions)
    #[test]
    fn leading_zeroes_are_no_part_of_a_number() {
        for (written, name) in [
            ("R01", "R1"),
            ("R1", "R1"),
            ("R10", "R10"),
            ("R00", "R0"),
            ("R0", "R0"),
            ("R0100", "R100"),
            ("#0100", "#100"),
            ("R", "R"),
            ("#", "#"),
            ("R0A", "R0A"),
            ("L01", "L01"),
            ("", ""),
        ] {
            assert_eq!(numbered(written.into()), name, "{written}");
        }
    }
}
