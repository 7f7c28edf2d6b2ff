//! Each variant that is carried out is found by one way alone: element, what is corrected, what is left to choose.

use crate::app::{CycleInfo, catalogue};
use crate::entry::{Corrects, Element, ProbeUse};
use std::collections::{BTreeMap, BTreeSet};

// oracle: self (what a user chooses among leads to one variant, and to each of them; the log measures nothing)
#[test]
fn each_variant_is_found_by_one_way() {
    let of_log = |cycle: &&CycleInfo| cycle.purpose.probe == ProbeUse::Log;
    for cycle in catalogue().cycles.iter().filter(|cycle| cycle.simulated && !of_log(cycle)) {
        for variant in &cycle.variants {
            let aim = variant.aim.as_ref();
            assert!(aim.is_some_and(|aim| !aim.corrects.is_empty()), "{} {}", cycle.cycle, variant.mvar);
        }
    }
    type Way = (Element, Corrects, BTreeSet<[&'static str; 2]>);
    for control in [crate::dialect::Dialect::Sinumerik, crate::dialect::Dialect::Nct] {
        let mut ways: BTreeMap<Way, (&str, i64)> = BTreeMap::new();
        for cycle in catalogue().cycles.iter().filter(|cycle| cycle.control == control) {
            for variant in &cycle.variants {
                for corrected in variant.aim.iter().flat_map(|aim| &aim.corrects) {
                    let aim = variant.aim.as_ref().map(|aim| (aim.element, aim.options.iter().copied().collect()));
                    let Some((element, options)) = aim else { continue };
                    let here = (cycle.cycle, variant.mvar);
                    let before = ways.insert((element, corrected.corrects, options), here);
                    assert_eq!(before, None, "{here:?} is found as another is");
                }
            }
        }
    }
}

// oracle: self (a choice between two answers has both)
#[test]
fn each_element_is_measured_by_something_and_has_its_own_name() {
    let catalogue = catalogue();
    let aims = catalogue.cycles.iter().flat_map(|cycle| &cycle.variants).filter_map(|variant| variant.aim.as_ref());
    let measured: BTreeSet<Element> = aims.map(|aim| aim.element).collect();
    assert_eq!(measured, Element::ALL.into());
    let keys: BTreeSet<&str> = Element::ALL.iter().flat_map(|element| element.keys()).collect();
    assert_eq!(keys.len(), 2 * Element::ALL.len());
}

// oracle: manual B:1894-1896 (0: nothing is corrected), C:1089 (S or T, not both)
#[test]
fn what_is_corrected_is_a_call_without_an_error() {
    let of_log = |cycle: &&CycleInfo| cycle.purpose.probe == ProbeUse::Log;
    for cycle in catalogue().cycles.iter().filter(|cycle| cycle.simulated && !of_log(cycle)) {
        for variant in &cycle.variants {
            for corrected in variant.aim.iter().flat_map(|aim| &aim.corrects) {
                let found = crate::catalogue::find(cycle.control, cycle.cycle);
                let Some(entry) = found else { continue };
                let mut values = variant.usual.example.clone();
                values.extend(corrected.values.clone());
                let mut findings = Vec::new();
                let inputs =
                    crate::check::read(entry, &values, &crate::control::delivery(cycle.control), &mut findings);
                let worse = findings.iter().filter(|one| one.severity == crate::diagnostic::Severity::Error);
                assert_eq!(worse.count(), 0, "{} {}: {findings:?}", cycle.cycle, variant.mvar);
                assert_eq!(inputs.variant, variant.mvar, "{}", cycle.cycle);
            }
        }
    }
}
