//! Where a control has the form of a cycle: softkeys of the support in its program editor, from measuring cycles SW 6.2
//! on and before; or why it has none. Softkeys are written as the control writes them in English.

use crate::entry::Cycle;
use std::sync::LazyLock;

/// Of which software the softkeys are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Measuring cycles from SW 6.2, with masks.
    Editor,
    /// Measuring cycles up to SW 5.4, with calls of auxiliary cycles.
    Older,
    /// The form is there from this version of the measuring cycles on, which stands for the softkeys.
    From,
    /// There is no mask: what stands for the softkeys is the end of the key that says why.
    None,
}

/// Softkeys of some variants of a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Softkeys {
    cycle: &'static str,
    /// Ends of the numbers of the variants, of which `x` is any digit; `*`: all.
    ends: &'static str,
    /// Software.
    pub way: Way,
    /// Softkeys one after another; empty: the manual does not print them.
    pub softkeys: &'static str,
    /// Auxiliary cycle that the support writes; empty: the cycle itself.
    pub call: &'static str,
    /// Place in the manual.
    pub source: &'static str,
}

/// All of them.
pub static SOFTKEYS: LazyLock<Vec<Softkeys>> = LazyLock::new(|| {
    include_str!("softkeys.tsv").lines().skip(1).filter_map(|row| read(&row.split('\t').collect::<Vec<_>>())).collect()
});

fn read(row: &[&'static str]) -> Option<Softkeys> {
    let [cycle, ends, way, softkeys, call, source] = *row else { return None };
    let way = match way {
        "editor" => Way::Editor,
        "older" => Way::Older,
        "from" => Way::From,
        "none" => Way::None,
        _ => return None,
    };
    Some(Softkeys { cycle, ends, way, softkeys, call, source })
}

impl Softkeys {
    fn has(&self, cycle: &Cycle, variant: i64) -> bool {
        let number = format!("{variant:02}");
        self.cycle == cycle.name && self.ends.split(';').any(|end| end == "*" || ends(&number, end))
    }
}

/// Whether a number ends so; `x`: any digit.
fn ends(number: &str, end: &str) -> bool {
    let same = |(digit, wanted): (u8, u8)| wanted == b'x' || wanted == digit;
    number.len() >= end.len() && number.bytes().rev().zip(end.bytes().rev()).all(same)
}

/// Softkeys of a variant of a cycle.
pub fn softkeys(cycle: &Cycle, variant: i64) -> impl Iterator<Item = &'static Softkeys> {
    SOFTKEYS.iter().filter(move |one| one.has(cycle, variant))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::CYCLES;
    use crate::manual::Cited;

    // oracle: self: no row is lost or serves nothing, and each form has a way or a reason
    #[test]
    fn each_form_has_softkeys_or_a_reason() {
        assert_eq!(SOFTKEYS.len() + 1, include_str!("softkeys.tsv").lines().count());
        for cycle in CYCLES {
            for variant in cycle.variants {
                let found: Vec<_> = softkeys(cycle, variant.number).collect();
                let of = |way| found.iter().filter(|one| one.way == way).count();
                assert_eq!(of(Way::Editor) + of(Way::None), 1, "{} {}", cycle.name, variant.number);
                assert!(of(Way::Older) <= 1, "{} {}", cycle.name, variant.number);
            }
        }
        for row in SOFTKEYS.iter() {
            let serves = CYCLES.iter().any(|cycle| cycle.variants.iter().any(|one| row.has(cycle, one.number)));
            assert!(serves && !Cited(row.source).to_string().is_empty(), "{row:?}");
        }
    }

    // oracle: manual B:12145-12406, B:11890-11900
    #[test]
    fn a_web_is_not_under_the_hole() {
        let of = |name: &str, variant: i64| {
            let cycle = CYCLES.iter().find(|one| one.name == name);
            let found = cycle.and_then(|cycle| softkeys(cycle, variant).next());
            found.map(|one| one.softkeys)
        };
        assert_eq!(of("CYCLE977", 104), Some("Measurem. milling > Workpiece measure > Slot or web"));
        assert_eq!(of("CYCLE979", 101), Some("Measurem. milling > Workpiece measure > Hole Shaft"));
        assert_eq!(of("CYCLE982", 112_005), Some("Measurem. turning > Tool measurem."));
    }
}
