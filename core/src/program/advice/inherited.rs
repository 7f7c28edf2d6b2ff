//! Values that were written for an earlier call and reach this one, where they mean something else: the data of a call
//! persist until they are overwritten (`_TSA` in mm reaching a cycle that takes it as degrees). And values that were
//! written for a call and do not reach it.

use super::Seen;
use crate::control::Transverse;
use crate::diagnostic::Diagnostic;
use crate::entry::{Inputs, Kind, Level, Param, Unit};
use crate::message::Message;
use crate::program::calls::CallSite;
use crate::program::change::{change, line_at_begin};
use crate::syntax::Program;
use crate::{check, own};

/// Labels of one parameter in the same words; where they differ is in their help. A test holds them against the words.
const SAME: [&[&str]; 8] = [
    &["id-points", "id-points-abscissa"],
    &["ma-calibrate", "ma-calibrated"],
    &["md", "md-incremental"],
    &["setval-diameter", "setval-turned-diameter", "setval-two-diameter"],
    &["setval-width", "setval-width-angle"],
    &["sta1", "sta1-first"],
    &["sza-length", "sza-turned"],
    &["szo", "szo-turned"],
];

/// What a value says at a call.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Meaning {
    /// Stem of the parameter's label.
    label: &'static str,
    unit: Unit,
    /// Key of the choice that the value is.
    choice: Option<&'static str>,
}

impl Meaning {
    fn of(param: &Param, inputs: &Inputs) -> Meaning {
        let number = inputs.given(param.name);
        let is = |value: i64| Some(value as f64) == number;
        let variants = if let Kind::Variant(_) = param.kind { inputs.cycle.variants } else { &[] };
        let variant = variants.iter().find(|variant| is(variant.number)).map(|variant| variant.key);
        let choices = param.kind.choices(inputs).unwrap_or_default();
        let label = param.label(inputs);
        let same = SAME.iter().find(|same| same.contains(&label));
        Meaning {
            label: same.and_then(|same| same.first()).unwrap_or(&label),
            unit: param.unit_with(inputs),
            choice: variant.or_else(|| choices.iter().find(|(value, _)| is(*value)).map(|(_, key)| *key)),
        }
    }

    /// Key of the words that tell it from another meaning.
    fn words(&self, other: &Meaning) -> String {
        match self.choice {
            Some(choice) if self.label == other.label => choice.to_owned(),
            _ => format!("param-{}", self.label),
        }
    }
}

/// Warnings about the values that a call did not write itself.
pub fn look(seen: &Seen, found: &mut Vec<Diagnostic>) {
    // Most values were written for the same call.
    let mut writer: Option<(usize, Inputs)> = None;
    for param in seen.site.cycle.params {
        let Some((level, _)) = param.need(&seen.inputs) else { continue };
        let Some(index) = owner(seen, param.name.as_str()) else { continue };
        let Some(site) = seen.sites.get(index) else { continue };
        if writer.as_ref().is_none_or(|(known, _)| *known != index) {
            let inputs = Inputs {
                plane: site.plane,
                diameters: site.transverse != Transverse::Radius,
                ..check::read(site.cycle, &site.values, seen.control, &mut Vec::new())
            };
            writer = Some((index, inputs));
        }
        if let Some((_, there)) = &writer {
            found.extend(doubt(seen, param, level, site, there));
        }
    }
}

fn doubt(seen: &Seen, param: &'static Param, level: Level, site: &CallSite, there: &Inputs) -> Option<Diagnostic> {
    let written = site.cycle.param(param.name.as_str())?;
    written.need(there)?;
    let (before, now) = (Meaning::of(written, there), Meaning::of(param, &seen.inputs));
    let value = seen.values.get(param.name.as_str())?.as_str();
    if before == now || !counts(seen, param, site, (&before, &now)) {
        return None;
    }
    let sentence = match level {
        _ if before.unit != now.unit => own::ADVICE_INHERITED,
        Level::Required => own::ADVICE_INHERITED_MEANING,
        _ => own::ADVICE_INHERITED_MEANING.as_note(),
    };
    let finding = sentence
        .finding()
        .text("name", param.name)
        .text("value", value)
        .text("cycle", site.cycle.name)
        .number("line", f64::from(site.line + 1))
        .text("before", before.words(&now))
        .text("now", now.words(&before))
        .hint_text("name", param.name)
        .at(param.name)
        .on(seen.site.span);
    let Some(value) = param.fallback(seen.control).map(|value| value.to_string()) else { return Some(finding) };
    let edits = change(seen.program, seen.site, param.name.as_str(), &value);
    Some(finding.cured(Message::new("advice-write").text("name", param.name).text("value", value), edits))
}

/// Whether the difference may be an accident. What has a delivered value (path, safe area, feed, probe number) says how
/// is measured and is meant to stay, unless its unit or sort of probe is another one. Others say what is measured.
fn counts(seen: &Seen, param: &Param, site: &CallSite, (before, now): (&Meaning, &Meaning)) -> bool {
    let number = seen.inputs.given(param.name);
    if matches!(param.kind, Kind::Knum) && number == Some(0.0) {
        return false; // nothing is corrected, whatever it means
    }
    if before.unit != now.unit || param.default.is_none() {
        return true;
    }
    let probes = (site.cycle.purpose.probe, seen.site.cycle.purpose.probe);
    probes.0 != probes.1 && before.label != now.label && number != param.default
}

/// The earlier call for which a value was written.
fn owner(seen: &Seen, name: &str) -> Option<usize> {
    let place = *seen.site.places.get(name)?;
    let index = seen.sites.partition_point(|site| site.span.end <= place.start);
    let site = seen.sites.get(index)?;
    let own = index < seen.index && place.start >= site.own_from;
    (own && site.places.get(name) == Some(&place)).then_some(index)
}

/// Assignments that do not reach their call: a subprogram called between writes the same datum of the channel.
pub fn overwritten(program: &Program, sites: &[CallSite], found: &mut Vec<Diagnostic>) {
    for site in sites {
        for (name, place, call) in &site.overwritten {
            let line = f64::from(program.line_of(call.start) + 1);
            let finding = own::ADVICE_OVERWRITTEN.finding().text("name", *name).number("line", line);
            let value = program.written(*place);
            let edit = line_at_begin(program, site.line, &format!("{name}={value}"));
            let label = Message::new("advice-write").text("name", *name).text("value", value.trim());
            found.push(finding.hint_text("name", *name).cured(label, edit.into_iter().collect()).on(*place));
        }
    }
}

#[cfg(all(test, feature = "cli"))]
mod tests {
    use super::*;
    use crate::catalogue::CYCLES;
    use crate::dialect::Dialect;
    use crate::words::Words;
    use std::collections::{BTreeMap, BTreeSet};

    // oracle: self (the English words)
    #[test]
    fn labels_of_the_same_words_mean_the_same() {
        let words = Words::english();
        let mut labels: BTreeMap<(&str, String), BTreeSet<&str>> = BTreeMap::new();
        let cycles = CYCLES.iter().filter(|cycle| cycle.dialect == Dialect::Sinumerik);
        let params = cycles.flat_map(|cycle| cycle.params);
        for param in params.filter(|param| param.default.is_none()) {
            // The stem alone is a label where it has words.
            let stems = param.labels.iter().map(|(_, stem)| *stem).chain([param.key]);
            for stem in stems {
                let label = words.find(&Message::new(format!("param-{stem}"))).unwrap_or_else(|| stem.to_owned());
                labels.entry((param.name.as_str(), label)).or_default().insert(stem);
            }
        }
        let groups: Vec<BTreeSet<&str>> = labels.into_values().filter(|same| same.len() > 1).collect();
        let ours: BTreeSet<BTreeSet<&str>> = SAME.iter().map(|same| same.iter().copied().collect()).collect();
        assert_eq!(ours, groups.into_iter().collect());
    }
}
