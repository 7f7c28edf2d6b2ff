//! Texts as people and programs write them.

use crate::syntax::is_value;

/// What stands for a text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Text<'a> {
    /// These characters; quotes around them are taken off.
    Plain(&'a str),
    /// An expression of the program; its text is known at run time only.
    Expression,
}

/// Reads a text: `MILL` and `"MILL"` are the same, inside of quotes blanks count, `"Part "<<R1` is an expression.
pub fn parse(text: &str) -> Text<'_> {
    let text = text.trim();
    if let Some(inner) = quoted(text) {
        return Text::Plain(inner);
    }
    let joined = text.contains('"') || text.contains("<<");
    if joined && is_value(text) { Text::Expression } else { Text::Plain(text) }
}

/// The characters of a text as they are typed: in quotes where blanks at the ends count.
pub fn typed(text: &str) -> String {
    if text.trim() == text { text.to_owned() } else { format!("\"{text}\"") }
}

fn quoted(text: &str) -> Option<&str> {
    let inner = text.strip_prefix('"')?.strip_suffix('"')?;
    (!inner.contains('"')).then_some(inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_as_typed() {
        // oracle: hand
        for (text, inner) in
            [(" MILL ", "MILL"), ("\"MILL 3\"", "MILL 3"), ("\"  \"", "  "), ("A\"B", "A\"B"), ("", ""), ("\"", "\"")]
        {
            assert_eq!(parse(text), Text::Plain(inner), "{text}");
        }
        for text in ["\"Part number: \"<<PARTNUM", "<<R1", "\"A\"<<\"B\""] {
            assert_eq!(parse(text), Text::Expression, "{text}");
        }
        for text in ["  ", " a", "a b"] {
            assert_eq!(parse(&typed(text)), Text::Plain(text), "{text}");
        }
    }
}
