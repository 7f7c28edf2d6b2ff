//! CYCLE972: tool probe on turning machines: calibrating it, measuring the lengths of turning tools (B:8736-9090).
//! CYCLE982 with its variants 0 and 1 does the same (B:8752-8760): it does the work, and draws it.

#[cfg(test)]
mod tests;

use crate::catalogue::common::length;
use crate::catalogue::cycle982::params::{ABSCISSA, ORDINATE};
use crate::catalogue::cycle982::{picture, propose, simulate};
use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::{ProbeData, checks as about, params as shared, turning};
use crate::catalogue::{older, tool_probe};

/// Measuring variants (B:8766-8771).
const VARIANTS: &[Variant] = &[
    Variant { number: 0, key: "cycle972-calibrate", source: "B:8770;B:8816;A:9685" },
    Variant { number: 1, key: "cycle972-measure", source: "B:8771;B:8964;A:9686" },
];

/// The probe is calibrated.
const CALIBRATE: When = When::Variant(&[0]);
/// A tool is measured.
const MEASURE: When = When::Variant(&[1]);

/// The entry. Example: the turning tool T3 of B:9044-9053, length L1.
pub static CYCLE972: Cycle = Cycle {
    name: "CYCLE972",
    key: "cycle972",
    variants: VARIANTS,
    params: PARAMS,
    purpose: Purpose { probe: ProbeUse::Tool, calibrates: CALIBRATE, ..Purpose::TURNING },
    // in the list of newer controls CYCLE972 is not known to us
    lists: &[older::CYCLE972_CALIBRATION, older::CYCLE972],
    settings: &[
        "_TP", "_CVAL[0]", "_SPEED", "_EVMVNUM[0]", "_CBIT[0]", "_CBIT[1]", "_CHBIT[2]", "_CHBIT[3]", "_CHBIT[5]",
        "_CHBIT[15]", "_CHBIT[16]", "_CHBIT[17]",
    ],
    results: RESULTS,
    // A:15856, A:15873
    alarms: &[tool_probe::ALARMS, &alarms([61315, 61330])],
    checks,
    help: Help::new(&[LINES, &tool_probe::help::lines([When::Always, CALIBRATE, MEASURE], [NEVER; 2])]),
    picture: Drawing::staged(picture::stage, picture::marks),
    simulation: Some(Simulation::new(propose::propose, simulate::turning_tools).with_tool(propose::tool)),
    aims: Aims {
        elements: &[(CALIBRATE, Element::Probe), (When::Always, Element::Tool)],
        corrects: &[(CALIBRATE, Corrects::Setter, &[]), (When::Not(&CALIBRATE), Corrects::Tool, &[])],
        options: &[(When::Always, "aim-tools", "aim-tools-turning")],
    },
    source: "B:8736-9090",
    ..common::CYCLE
};

/// Parameters (B:8856-8862, B:9010-9018), in the order in which the snippet writes them.
const PARAMS: &[Param] = &[
    Param { example: "1", source: "B:8766-8771;B:15455-15456", ..common::MVAR },
    Param {
        kind: Kind::ChoiceBy(&[
            (CALIBRATE, &[(1, "ma-lathe-abscissa"), (2, "ma-lathe-ordinate")]),
            (MEASURE, &[(1, "ma-lathe-l2"), (2, "ma-lathe-l1")]),
        ]),
        needs: common::ALWAYS_REQUIRED,
        key: "ma-lathe-length",
        labels: &[(CALIBRATE, "ma-calibrate")],
        example: "2",
        source: "B:8859;B:9014;B:15453",
        ..common::MA
    },
    shared::PRNUM,
    Param { key: "fa-tool", example: "1", source: "B:2221;B:9057;B:15448", ..common::FA },
    Param { key: "tsa-tool", labels: &[(CALIBRATE, "tsa-tool-probe")], source: "B:8849;B:15472", ..common::TSA },
    Param { source: "B:2164-2170;B:15474", ..common::VMS },
    shared::NMSP,
    Param { needs: &[optional(MEASURE, "need-memory-empirical")], ..shared::EVNUM },
    Param { example: "0.001", ..shared::TZL },
    Param { needs: &[optional(MEASURE, "need-default")], example: "0.8", ..shared::TDIF },
];

const CALIBRATED_ABSCISSA: When = When::All(&[CALIBRATE, ABSCISSA]);
const CALIBRATED_ORDINATE: When = When::All(&[CALIBRATE, ORDINATE]);
const L1: When = When::All(&[MEASURE, ORDINATE]);
const L2: When = When::All(&[MEASURE, ABSCISSA]);

/// What it leaves in the result arrays (B:8777-8812), in their order; of a pair of directions, the one that was touched
/// is set. The unit of `_OVR[]` is not defined by the manual; here the active unit counts.
const RESULTS: &[ResultField] = &[
    length("_OVR[8]", "result-trigger-minus-abscissa", CALIBRATED_ABSCISSA, "B:8779"),
    length("_OVR[8]", "result-actual-l1", L1, "B:8798"),
    length("_OVR[9]", "result-trigger-minus-abscissa-difference", CALIBRATED_ABSCISSA, "B:8783"),
    length("_OVR[9]", "result-difference-l1", L1, "B:8799"),
    length("_OVR[10]", "result-trigger-plus-abscissa", CALIBRATED_ABSCISSA, "B:8780"),
    length("_OVR[10]", "result-actual-l2", L2, "B:8800"),
    length("_OVR[11]", "result-trigger-plus-abscissa-difference", CALIBRATED_ABSCISSA, "B:8784"),
    length("_OVR[11]", "result-difference-l2", L2, "B:8801"),
    length("_OVR[12]", "result-trigger-minus-ordinate", CALIBRATED_ORDINATE, "B:8781"),
    length("_OVR[13]", "result-trigger-minus-ordinate-difference", CALIBRATED_ORDINATE, "B:8785"),
    length("_OVR[14]", "result-trigger-plus-ordinate", CALIBRATED_ORDINATE, "B:8782"),
    length("_OVR[15]", "result-trigger-plus-ordinate-difference", CALIBRATED_ORDINATE, "B:8786"),
    length("_OVR[27]", "result-zero-offset-area", When::Always, "B:8787;B:8802"),
    length("_OVR[28]", "result-safe-area", When::Always, "B:8788;B:8803"),
    length("_OVR[29]", "result-dimensional-difference", MEASURE, "B:8804"),
    length("_OVR[30]", "result-empirical-value", MEASURE, "B:8805"),
    integer("_OVI[0]", "result-edge", MEASURE, "B:8806"),
    integer("_OVI[2]", "result-cycle", When::Always, "B:8789;B:8807"),
    integer("_OVI[3]", "result-variant", When::Always, "B:8790;B:8808"),
    integer("_OVI[5]", "result-probe", When::Always, "B:8791;B:8809"),
    integer("_OVI[7]", "result-empirical-memory", MEASURE, "B:8810"),
    integer("_OVI[8]", "result-tool", MEASURE, "B:8811"),
    integer("_OVI[9]", "result-alarm", When::Always, "B:8792;B:8812"),
    integer("_OVI[12]", "result-internal-error", When::Always, "B:16022"),
];

/// The lines of the help page (B:8712-9211), section by section, in the order in which they are read.
const LINES: &[HelpLine] = &[
    measures(CALIBRATE, "help-cycle972-measures-side", "B:8834-8850"),
    measures(MEASURE, "help-cycle972-measures-length", "B:8954-8968"),
    before(When::Always, "help-tool-not-turned", "A:15873;B:9819"),
    order(When::Always, "help-cycle972-order-travel", "B:8870;B:8923;B:9441"),
    order(CALIBRATE, "help-cycle972-order-nose", "B:8870"),
    order(MEASURE, "help-cycle972-order-tip", "B:9073"),
];

/// What several values, the data of the tool probe and the tool in use say together.
fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    about::number(inputs, control, found);
    about::memory(inputs, control, found);
    about::limits(inputs, found);
    about::speeds(control, found);
    about::place(&ProbeData::of(inputs, control), found);
    shared_checks::rotation(control, found);
    if let Some(edge) = about::tool_in_use(control, found) {
        turning::tool(inputs, edge, CALIBRATE.holds(inputs), found);
    }
}
