//! Whether a text is one value that a program can hold.

use super::block::read;
use super::tree::WordKind;
use crate::dialect::Dialect;

/// Whether a text stands as one value behind a name (SINUMERIK `_FA=…`) or an address (NCT `D…`), and as nothing more:
/// `R1+` and `R1 M30` do not.
pub fn is_value(text: &str) -> bool {
    stands(Dialect::Sinumerik, "_X=", text) || stands(Dialect::Nct, "D", text)
}

fn stands(dialect: Dialect, before: &str, text: &str) -> bool {
    let source = format!("{before}{text}");
    let program = read(dialect, source.as_bytes());
    let ([word], [block]) = (&program.words[..], &program.blocks[..]) else { return false };
    let whole = word.span.start == 0 && word.span.end as usize == source.len();
    let value = matches!(word.kind, WordKind::Assign { .. } | WordKind::Address { .. });
    whole && value && block.comment.is_none() && program.errors.is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand
    #[test]
    fn one_value_and_nothing_more() {
        for text in
            ["R1", "-R1", "(R1+2)*3", "_OVR[4]-0.5", "$AA_IW[X]", "SQRT(R1)", "#500", "[[#1+2]/2]", "R1 + 2", "1.5EX-3"]
        {
            assert!(is_value(text), "{text}");
        }
        for text in [
            "R1+", "(((", "R1 M30", "a b", "R1;2", "R1 ;2", "R1\nM30", "R1=2", "(R1", "R1)", "5 mm", "R[1", "1e5",
            "\"", "", "R1,R2", "#1+#2", "[#1+2]/2",
        ] {
            assert!(!is_value(text), "{text}");
        }
    }
}
