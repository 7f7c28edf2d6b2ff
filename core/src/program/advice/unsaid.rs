//! What the text does not say before a call, so that the machine or another program decides. Asked once a program.

use super::{Seen, at_call, between, with_line};
use crate::control::{MachineSort, Transverse, probe::PROBE, tools::TURNING};
use crate::diagnostic::Diagnostic;
use crate::entry::{Inputs, ProbeUse, names};
use crate::own;
use crate::program::flow::Mode;

/// Every warning of this sort at a call.
pub fn doubts(seen: &Seen) -> impl Iterator<Item = Diagnostic> {
    let doubts = [open, plane, compensation, tool, diameter, radius, milled_diameter, length];
    doubts.into_iter().filter_map(|doubt| doubt(seen))
}

fn on_a_lathe(seen: &Seen) -> bool {
    seen.site.cycle.purpose.machine == MachineSort::Turning
}

fn usual_plane(seen: &Seen) -> &'static str {
    match (on_a_lathe(seen), at_call::milling_probe(seen)) {
        (true, _) => "G18",
        (false, Some(tool)) => at_call::plane_of(&tool),
        (false, None) => "G17",
    }
}

/// Another program, or the way through this one, decides what is active.
fn open(seen: &Seen) -> Option<Diagnostic> {
    let force = seen.force;
    let left_open = [
        ("G40", force.compensation == Mode::Open),
        (usual_plane(seen), force.plane == Mode::Open),
        // A tool that a variable names is programmed, and its D number with it.
        ("T", force.tool == Mode::Open && force.edge == Mode::Open),
        ("D", force.edge == Mode::Open),
    ];
    let words: Vec<&str> = left_open.into_iter().filter_map(|(word, open)| open.then_some(word)).collect();
    let functions: Vec<&str> = words.iter().copied().filter(|word| word.starts_with('G')).collect();
    let finding = own::ADVICE_OPEN.finding().text("words", words.join(", "));
    (!words.is_empty())
        .then(|| if functions.is_empty() { finding } else { with_line(finding, seen, &functions.join(" ")) })
}

/// Cycles measure in the axes of the plane, without one that of the reset state: G18 on a lathe, as in B:10425.
fn plane(seen: &Seen) -> Option<Diagnostic> {
    if !seen.force.plane.unset() {
        return None;
    }
    let usual = usual_plane(seen);
    let sentence = if on_a_lathe(seen) { own::ADVICE_PLANE.as_note() } else { own::ADVICE_PLANE };
    Some(with_line(sentence.finding().hint_text("plane", usual), seen, usual))
}

/// Compensation is off after a reset; a program that ends with it may be run again without one.
fn compensation(seen: &Seen) -> Option<Diagnostic> {
    let open = seen.force.compensation.unset() && seen.site.left_on;
    open.then(|| with_line(own::ADVICE_COMPENSATION_OPEN.finding(), seen, "G40"))
}

/// Nothing says which tool is in use.
fn tool(seen: &Seen) -> Option<Diagnostic> {
    if !seen.force.tool.unset() {
        return None;
    }
    let finding = own::ADVICE_TOOL_NONE.finding();
    Some(match the_probe(seen) {
        Some(change) => with_line(finding, seen, &change),
        None => finding,
    })
}

/// How the program changes to the one workpiece probe that the tool table has.
fn the_probe(seen: &Seen) -> Option<String> {
    let purpose = &seen.site.cycle.purpose;
    if purpose.probe != ProbeUse::Workpiece || on_a_lathe(seen) {
        return None;
    }
    let edges = seen.control.tools.iter().flat_map(|(number, tool)| tool.edges.iter().map(move |edge| (number, edge)));
    let probes: Vec<_> = edges.filter(|(_, (_, edge))| edge.kind == PROBE).collect();
    let [(number, (edge, _))] = probes[..] else { return None };
    let change = if seen.changes_tools { " M6" } else { "" };
    Some(format!("T{number} D{edge}{change}"))
}

/// On a lathe the setpoint in the transverse axis is a diameter with DIAMON, else a radius (B:10975).
fn diameter(seen: &Seen) -> Option<Diagnostic> {
    let open = on_a_lathe(seen) && seen.force.transverse.unset();
    open.then(|| with_line(own::ADVICE_DIAMETER.finding(), seen, "DIAMON"))
}

/// The setpoint of the transverse axis is taken for a radius; drawings of turned parts give diameters.
fn radius(seen: &Seen) -> Option<Diagnostic> {
    let param = seen.site.cycle.param(names::SETVAL.as_str())?;
    param.need(&seen.inputs)?;
    // it is one that is a diameter with DIAMON
    let diameters = Inputs { diameters: true, ..seen.inputs.clone() };
    let transverse = on_a_lathe(seen) && param.label(&diameters) != param.label(&seen.inputs);
    if !transverse || seen.force.transverse.is() != Some(&Transverse::Radius) {
        return None;
    }
    let set: f64 = seen.values.get(names::SETVAL.as_str())?.trim().parse().ok()?;
    let finding = own::ADVICE_RADIUS.finding().number("value", set).number("diameter", 2.0 * set).at(names::SETVAL);
    Some(between(finding, seen, "DIAMON", "DIAMOF"))
}

/// Milling cycles know no diameters in the transverse axis: chapter 6 names them, 5 does not (B:10623, B:10975).
fn milled_diameter(seen: &Seen) -> Option<Diagnostic> {
    at_call::milling_probe(seen).filter(|tool| TURNING.contains(&tool.kind))?;
    (*seen.force.transverse.is()? != Transverse::Radius).then(|| own::ADVICE_MILLED_DIAMETER.finding())
}

/// The length of a turning machine's probe does not lie where it stands: L1 counts along the ordinate and L2 along the
/// abscissa of each plane, L3 along the applicate (B:828, B:974-985).
fn length(seen: &Seen) -> Option<Diagnostic> {
    let tool = at_call::milling_probe(seen).filter(|tool| tool.unassigned)?;
    Some(own::ADVICE_LENGTH.finding().number("tool", tool.number as f64))
}
