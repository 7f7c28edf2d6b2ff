//! Where the values of a call are written.

use super::calls::CallSite;
use super::change::word_around;
use crate::diagnostic::Span;
use crate::name::Name;
use crate::syntax::{Program, WordKind};
use std::collections::BTreeMap;

/// The place of each value that is written in one place: with the name of its parameter where that stands beside it.
pub fn places(program: &Program, site: &CallSite) -> BTreeMap<Name, Span> {
    site.places.iter().map(|(name, place)| (*name, with_name(program, *place))).collect()
}

/// The whole word of an assignment or an address; an argument and an element of a list stand alone.
fn with_name(program: &Program, place: Span) -> Span {
    match program.word_at(place).map(|word| &word.kind) {
        Some(WordKind::Assign { .. } | WordKind::Address { .. }) => word_around(program, place),
        _ => place,
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::calls::{calls, calls_on};
    use super::super::write::{Written, snippet};
    use super::places;
    use crate::catalogue::CYCLES;
    use crate::catalogue::example::example;
    use crate::control::data::FORMS;
    use crate::control::{Control, delivery};
    use crate::dialect::Dialect;
    use crate::entry::{Cycle, Style};
    use crate::syntax::read;

    /// What stands at the places of the last call.
    fn written(dialect: Dialect, text: &str) -> Vec<(String, String)> {
        let program = read(dialect, text.as_bytes());
        let sites = calls(&program);
        let found = places(&program, sites.last().unwrap());
        found.into_iter().map(|(name, span)| (name.to_string(), program.written(span))).collect()
    }

    fn pairs(list: &[(&str, &str)]) -> Vec<(String, String)> {
        list.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect()
    }

    // oracle: hand
    #[test]
    fn a_value_stands_with_its_name_where_it_has_one() {
        let text = "_MVAR=1 _FA = R2*2\n_SETVAL=132 _TNUM=20\nCYCLE977\n";
        let expected = [("_FA", "_FA = R2*2"), ("_MVAR", "_MVAR=1"), ("_SETVAL", "_SETVAL=132"), ("_TNUM", "_TNUM=20")];
        let mut found = written(Dialect::Sinumerik, text);
        found.sort();
        assert_eq!(found, pairs(&expected));
        let mut found = written(Dialect::Nct, "G102 D50. I10. J-2.5\n");
        found.retain(|(name, _)| name == "D");
        assert_eq!(found, pairs(&[("D", "D50.")]));
    }

    // oracle: hand
    #[test]
    fn an_element_of_a_list_stands_alone() {
        let found = written(Dialect::Sinumerik, "_MVAR=5 _SETV[0]=SET(30,40) _KNUM=1\nCYCLE977\n");
        let element = |name: &str| found.iter().find(|(one, _)| one == name).map(|(_, text)| text.as_str());
        assert_eq!(
            [element("_SETV[0]"), element("_SETV[1]"), element("_KNUM")],
            [Some("30"), Some("40"), Some("_KNUM=1")]
        );
    }

    /// A call is read at the places at which it was written. An omitted argument, and a variant of several selections,
    /// is read at the whole call; an element with two indexes without its name.
    fn agree(cycle: &'static Cycle, control: &Control, written: &Written) {
        let program = read(control.dialect, written.text.as_bytes());
        let sites = calls_on(&program, control.clone());
        let site = sites.last().unwrap();
        let mut found = places(&program, site);
        found.retain(|_, place| *place != site.span);
        let mut own = written.places.clone();
        own.retain(|name, _| cycle.variant_param() != Some(*name) || found.contains_key(name));
        for (name, place) in own.iter_mut().filter(|(name, _)| name.contains(',')) {
            place.start = found.get(name).map_or(place.start, |found| found.start.max(place.start));
        }
        assert_eq!(own, found, "{}", written.text);
    }

    // oracle: peer (the reader)
    #[test]
    fn the_writer_tells_where_the_reader_finds_each_value() {
        let label = |name: &str, _: &str| format!("Maß {name}");
        let mut texts = 0;
        for (cycle, variant) in CYCLES.iter().flat_map(|cycle| cycle.variants.iter().map(move |one| (*cycle, one))) {
            let typed = example(cycle, variant);
            for (style, forms) in [Style::Direct, Style::Indirect, Style::Operate]
                .into_iter()
                .flat_map(|style| [0.0, 1.0].map(|forms| (style, forms)))
            {
                let mut control = delivery(cycle.dialect);
                control.set(FORMS, forms);
                let written = snippet(cycle, &typed, &control, style, Some(&label));
                if !written.text.is_empty() {
                    agree(cycle, &control, &written);
                    texts += 1;
                }
            }
        }
        assert!(texts > CYCLES.len());
    }
}
