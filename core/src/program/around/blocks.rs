//! The blocks of SINUMERIK, the outermost first: what follows from a result stands outside of what measures again, and
//! a log around all of it, as it would delete that of the pass before (B:11229). Results are in `_OVR[]` and `_OVI[]`
//! (B:1837-1838); `_OVI[9]` is the number of the alarm (B:5699). M0, MSG, SETAL, IF and jumps are those of the language
//! of the control.

use super::{Block, Field, Kind, Line, Suits};
use crate::range::Range;

/// Arithmetic parameters of a channel as delivered: R0 to R99.
const PARAMETERS: Range = Range::closed(0.0, 99.0);
/// Passes of a loop.
const PASSES: Range = Range::closed(1.0, 99.0);
/// Alarms of the user that halt the program; those from 67000 on only show.
const ALARMS: Range = Range::closed(65_000.0, 66_999.0);

/// A line with its comment.
pub(super) const fn line(code: &'static str, says: &'static str) -> Line {
    Line { code, says }
}

/// A field with what it has where nothing is entered.
pub(super) const fn field(name: &'static str, kind: Kind, preset: &'static str) -> Field {
    Field { name, kind, preset }
}

pub(super) const RESULT: Field = field("result", Kind::Result, "");
pub(super) const DEVIATION: Field = field("result", Kind::Deviation, "");
pub(super) const LIMIT: Field = field("limit", Kind::Limit, "0.02");
pub(super) const REWORK: Field = field("program", Kind::Program, "");

const WITHIN: &str = "around-say-within";

pub(super) const BLOCKS: &[Block] = &[
    Block {
        name: "skip",
        fields: &[field("variable", Kind::Variable(PARAMETERS), "20")],
        suits: &[Suits::Workpiece],
        before: &[line("IF R{variable}==1 GOTOF {label}_MEASURED", "around-say-measured")],
        after: &[line("R{variable}=1", "around-say-mark"), line("{label}_MEASURED:", "")],
    },
    Block {
        name: "log",
        fields: &[RESULT, field("part", Kind::File, "PART"), field("file", Kind::NewFile, "LOG_1")],
        suits: &[Suits::Workpiece, Suits::Results],
        before: &[
            line("_PROTNAME[0]=\"{part}\" _PROTNAME[1]=\"{file}\"", "around-say-log"),
            line("_PROTVAL[2]=\"{result},_TIME\"", ""),
            line("{on}", ""),
        ],
        after: &[line("{off}", "around-say-log-off")],
    },
    Block {
        name: "finish",
        fields: &[
            field("semi", Kind::Program, ""),
            field("finish", Kind::Program, ""),
            field("text", Kind::Text, "around-text-finish"),
        ],
        suits: &[Suits::Workpiece, Suits::CorrectsTool],
        before: &[line("{semi}", "around-say-semi")],
        after: &[
            line("IF {alarm}==0 GOTOF {label}_FINISH", "around-say-no-alarm"),
            line("MSG(\"{text}\")", ""),
            line("M0", "around-say-halt"),
            line("{label}_FINISH:", ""),
            line("{finish}", "around-say-finish"),
        ],
    },
    Block {
        name: "stop",
        fields: &[DEVIATION, LIMIT, field("text", Kind::Text, "around-text-stop")],
        suits: &[Suits::Results],
        before: &[],
        after: &[
            line("IF ABS({result})<={limit} GOTOF {label}_PASS", WITHIN),
            line("MSG(\"{text}\")", ""),
            line("M0", "around-say-halt"),
            line("{label}_PASS:", ""),
        ],
    },
    Block {
        name: "message",
        fields: &[DEVIATION, LIMIT, field("text", Kind::Text, "around-text-stop")],
        suits: &[Suits::Results],
        before: &[],
        after: &[
            line("IF ABS({result})<={limit} GOTOF {label}_QUIET", WITHIN),
            line("MSG(\"{text}\")", "around-say-goes-on"),
            line("{label}_QUIET:", ""),
        ],
    },
    Block {
        name: "alarm",
        fields: &[
            DEVIATION,
            LIMIT,
            field("number", Kind::Whole(ALARMS), "65000"),
            field("text", Kind::Text, "around-text-stop"),
        ],
        suits: &[Suits::Results],
        before: &[],
        after: &[
            line("IF ABS({result})<={limit} GOTOF {label}_CLEAR", WITHIN),
            line("SETAL({number},\"{text}\")", "around-say-alarm"),
            line("{label}_CLEAR:", ""),
        ],
    },
    Block {
        name: "jump",
        fields: &[DEVIATION, LIMIT, field("target", Kind::Target, "")],
        suits: &[Suits::Results],
        before: &[],
        after: &[line("IF ABS({result})>{limit} GOTOF {target}", "around-say-jump")],
    },
    Block {
        name: "keep",
        fields: &[RESULT, field("variable", Kind::Variable(PARAMETERS), "10")],
        suits: &[Suits::Results],
        before: &[],
        after: &[line("R{variable}={result}", "around-say-keep")],
    },
    Block {
        name: "rework",
        fields: &[
            DEVIATION,
            LIMIT,
            field("side", Kind::Side, ""),
            field("passes", Kind::Whole(PASSES), "3"),
            REWORK,
            field("text", Kind::Text, "around-text-rework"),
        ],
        suits: &[Suits::Workpiece, Suits::Results],
        before: &[line("R{a}=0", "around-say-count"), line("{label}_AGAIN:", "")],
        after: &[
            line("IF ABS({result})<={limit} GOTOF {label}_GOOD", WITHIN),
            line("IF ({result}{side}0) AND (R{a}<{passes}) GOTOF {label}_REWORK", "around-say-left"),
            line("MSG(\"{text}\")", ""),
            line("M0", "around-say-halt"),
            line("GOTOF {label}_GOOD", ""),
            line("{label}_REWORK:", ""),
            line("R{a}=R{a}+1", ""),
            line("{program}", "around-say-rework"),
            line("GOTOB {label}_AGAIN", "around-say-again"),
            line("{label}_GOOD:", ""),
        ],
    },
    Block {
        name: "breakage",
        fields: &[
            DEVIATION,
            field("limit", Kind::Limit, "0.5"),
            field("program", Kind::Program, ""),
            field("text", Kind::Text, "around-text-breakage"),
        ],
        suits: &[Suits::Tool, Suits::Results],
        before: &[line("R{a}=0", "around-say-spare-none"), line("{label}_CHECK:", "")],
        after: &[
            line("IF ABS({result})<={limit} GOTOF {label}_WHOLE", "around-say-whole"),
            line("IF R{a}>0 GOTOF {label}_BROKEN", "around-say-spare-too"),
            line("R{a}=1", ""),
            line("{program}", "around-say-spare"),
            line("GOTOB {label}_CHECK", "around-say-again"),
            line("{label}_BROKEN:", ""),
            line("MSG(\"{text}\")", ""),
            line("M0", "around-say-halt"),
            line("{label}_WHOLE:", ""),
        ],
    },
    Block {
        name: "mean",
        fields: &[
            RESULT,
            field("times", Kind::Whole(Range::closed(2.0, 20.0)), "4"),
            field("variable", Kind::Variable(PARAMETERS), "30"),
        ],
        suits: &[Suits::Workpiece, Suits::Results, Suits::Uncorrected, Suits::Turned, Suits::Returns],
        before: &[
            line("R{a}=0", "around-say-count"),
            line("R{variable}=0", ""),
            line("R{b}=$AA_IW[{abscissa}] R{c}=$AA_IW[{ordinate}]", "around-say-stands"),
            line("{label}_TURN:", ""),
            line("G0 {abscissa}=AC(R{b}) {ordinate}=AC(R{c})", "around-say-again-from"),
            line("SPOS=180*(R{a} MOD 2)", "around-say-turn"),
        ],
        after: &[
            line("R{variable}=R{variable}+{result}", ""),
            line("R{a}=R{a}+1", ""),
            line("IF R{a}<{times} GOTOB {label}_TURN", "around-say-again"),
            line("R{variable}=R{variable}/{times}", "around-say-mean"),
        ],
    },
];
