//! What the control's own editor makes of a call that it reads back, by the active settings (B:12549-12558).

use super::Seen;
use crate::check::{Parsed, parse};
use crate::control::Control;
use crate::diagnostic::{Diagnostic, Edit, Span};
use crate::entry::{Param, names};
use crate::message::Message;
use crate::program::calls::CallSite;
use crate::program::change::{change, line_before};
use crate::program::own_words::mark_before;
use crate::support::{Changed, Mark, Support};
use crate::syntax::Program;
use crate::{check, own, support};

/// Numbers that differ by less are the same one, rounded.
const ROUNDED: f64 = 0.001;

/// A value that reading back would change.
struct Change {
    name: &'static str,
    before: String,
    after: String,
}

/// Findings at one call. `control` has plane and units of the call.
pub fn look(seen: &Seen, control: &Control, found: &mut Vec<Diagnostic>) {
    let site = seen.site;
    // the settings with which the call was written, if a comment before it names them, and those of the machine
    let (marked, now) = (mark_before(seen.program, site), Mark::of(seen.control));
    let renewed = marked.as_ref().map(|(_, place)| Edit::replace(*place, now.text()));
    let mut say = |finding: Diagnostic| found.push(finding.on(site.span));
    // the control does not read its calls back once this changed
    if let Some(changes) = marked.as_ref().and_then(|(then, _)| listed(&then.tools_changed(&now))) {
        say(own::ADVICE_TOOL_PROGRAMMING.finding().text("changes", changes));
    }
    // the lists of newer controls are not of this support
    let Some(support) = Support::of(site.cycle, seen.control).filter(|_| site.newer_list().is_none()) else { return };
    if let Some(changes) = marked.as_ref().and_then(|(then, _)| listed(&then.mask_changed(&now))) {
        let finding = own::ADVICE_MASK.finding().text("changes", changes);
        say(finding.cured(Message::new("advice-mask-cure"), renewed.clone().into_iter().collect()));
    }
    taken_over(seen, support, control, renewed).map(&mut say);
    site.cycle.params.iter().filter_map(|param| support::finding(support, param, &seen.inputs)).for_each(&mut say);
}

/// `_MZ_MASK[4]: 1 → 0`; none for no change.
fn listed(changed: &[Changed]) -> Option<String> {
    let each: Vec<String> = changed.iter().map(|(name, before, now)| format!("{name}: {before} → {now}")).collect();
    (!each.is_empty()).then(|| each.join(", "))
}

/// The values that would become others, with the edits that make them so now.
fn taken_over(seen: &Seen, support: Support, control: &Control, renewed: Option<Edit>) -> Option<Diagnostic> {
    let site = seen.site;
    let entered = support.entered(site.cycle, &site.values, control);
    let inputs = check::read(site.cycle, &entered.values, control, &mut Vec::new());
    let used = site.cycle.params.iter().filter(|param| param.need(&inputs).is_some());
    let changed = |param: &Param| value(site, param, entered.values.get(param.name.as_str())?, control);
    let values: Vec<Change> = used.filter_map(changed).collect();
    let bits: Vec<Change> = entered.bits.iter().filter_map(|(name, on)| bit(site, name, *on, control)).collect();
    let written = |one: &Change| site.expression(one.name).unwrap_or(&one.before).to_owned();
    let told = |one: &Change| format!("{}={} → {}", one.name, written(one), one.after);
    let all: Vec<String> = values.iter().chain(&bits).map(told).collect();
    if all.is_empty() {
        return None;
    }
    let of_values = values.iter().flat_map(|one| change(seen.program, site, one.name, &one.after));
    let of_bits = bits.iter().filter_map(|one| set(seen.program, site, one));
    let edits: Vec<Edit> = of_values.chain(of_bits).chain(renewed).collect();
    let finding = own::ADVICE_READ_BACK.finding().text("changes", all.join(", "));
    if values.iter().any(|one| site.expression(one.name).is_some()) {
        return Some(finding); // an expression is no click's to take away
    }
    Some(finding.cured(Message::new("advice-read-back-cure"), edits))
}

/// What the program does not say counts as delivered; without a mean value the limit of its formation counts nothing.
fn value(site: &CallSite, param: &Param, after: &str, control: &Control) -> Option<Change> {
    let before = match site.values.get(param.name.as_str()) {
        Some(text) => text.clone(),
        None if param.name == names::TMV => return None,
        None => param.fallback(control)?.to_string(),
    };
    different(param.name.as_str(), before, after)
}

fn bit(site: &CallSite, name: &'static str, on: bool, control: &Control) -> Option<Change> {
    let set = site.bits.iter().find(|(one, ..)| *one == name);
    let before = set.map_or_else(|| control.number(name).to_string(), |(_, text, _)| text.clone());
    different(name, before, if on { "1" } else { "0" })
}

fn different(name: &'static str, before: String, after: &str) -> Option<Change> {
    let same = match (parse(&before), parse(after)) {
        (Parsed::Number(before), Parsed::Number(after)) => (before - after).abs() < ROUNDED,
        _ => before == after,
    };
    (!same).then(|| Change { name, before, after: after.to_owned() })
}

/// The bit in the place where the call sets it, else on a line of its own before the call.
fn set(program: &Program, site: &CallSite, change: &Change) -> Option<Edit> {
    let own = |(name, _, place): &&(&str, String, Span)| {
        site.own_from <= place.start && place.end <= site.span.end && *name == change.name
    };
    match site.bits.iter().find(own) {
        Some((.., place)) => Some(Edit::replace(*place, change.after.as_str())),
        None => line_before(program, site.first_line, &format!("{}={}", change.name, change.after)),
    }
}
