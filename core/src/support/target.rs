//! The correction targets that are offered: the usual ones, or all (B:12503-12504).

use super::{Support, TARGETS, name};
use crate::check::{Target, target};
use crate::control::{MachineSort, Store};
use crate::diagnostic::Diagnostic;
use crate::entry::{Inputs, Kind, Param};
use crate::evaluate::knum::{self, Quantity, ToolCode, ZeroCode};
use crate::own;

/// What the settings make of a correction target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Offer {
    /// It is offered, or not known.
    Same,
    /// This edge with the usual correction.
    Instead(i64),
    /// It is not offered, and nothing comes instead.
    None,
}

/// The one correction of a limited choice: the radius on milling machines, the length in the measuring axis on lathes.
pub fn usual(inputs: &Inputs) -> Quantity {
    match inputs.cycle.purpose.machine {
        MachineSort::Turning => Quantity::MeasuringAxis,
        MachineSort::Milling | MachineSort::Any => Quantity::Radius,
    }
}

/// Whether the limited choice holds this zero offset: none, the settable ones, the last basic frame of the channel.
pub fn usual_zero(code: i64) -> bool {
    matches!(knum::zero(code), Ok(None | Some(ZeroCode::Stored(Store::Settable(_)) | ZeroCode::LastBasic)))
}

/// What the settings make of the target that the values name.
pub fn offer(support: Support, param: &Param, inputs: &Inputs) -> Offer {
    let code = inputs.given(param.name).map(|number| number as i64);
    let (Kind::Knum, Some(code), false) = (&param.kind, code, support.entry(TARGETS)) else { return Offer::Same };
    match target(param, inputs) {
        Target::Zero if usual_zero(code) || knum::zero(code).is_err() => Offer::Same,
        Target::Zero => Offer::None,
        Target::Tool => tool(code, inputs),
    }
}

/// A wrong code is left to the checks.
fn tool(code: i64, inputs: &Inputs) -> Offer {
    let Ok(Some(read)) = knum::tool(code, inputs.five_digit_edges) else { return Offer::Same };
    let offered =
        ToolCode { edge: read.edge, quantity: usual(inputs), inverted: false, location: false, environment: false };
    match read.edge {
        _ if read == offered => Offer::Same,
        0 => Offer::None,
        _ => Offer::Instead(knum::tool_code(&offered, inputs.five_digit_edges)),
    }
}

/// Tells that the target is not among those offered.
pub fn finding(support: Support, param: &'static Param, inputs: &Inputs) -> Option<Diagnostic> {
    if offer(support, param, inputs) != Offer::None {
        return None;
    }
    let finding = own::TARGET_NOT_OFFERED.finding().text("param", param.name);
    Some(finding.number("value", inputs.number(param.name)).hint_text("entry", name(TARGETS)).at(param.name))
}
