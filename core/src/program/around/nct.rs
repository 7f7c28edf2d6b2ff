//! The blocks of NCT, the outermost first. A macro tells its deviation to no variable; what a program can read is the
//! work offset that the call names at S (C:1079), which the macro moves by the deviation from the one in use. #3000
//! stops with an alarm, #3006 until START, each with the comment of its block; #5201 and on are the work offsets, #4014
//! is the G function of the one in use; #1 to #33 belong to the program, #500 and on stay (C:84-88).

use super::blocks::{LIMIT, REWORK, field, line};
use super::{Block, Kind, Line, Suits};
use crate::range::Range;

/// Variables that stay and that no macro uses (C:84-88, C:1193-1200).
const STAYING: Range = Range::closed(514.0, 999.0);
/// Numbers of an alarm of the program.
const ALARMS: Range = Range::closed(1.0, 200.0);
/// Passes of a loop.
const PASSES: Range = Range::closed(1.0, 99.0);

const SAVED_1: Line = line("#{a}=#{o1}", "around-say-offset");
const SAVED_2: Line = line("#{b}=#{o2}", "");
const SAVED_3: Line = line("#{c}=#{o3}", "");
const DISTANCE: Line = line(
    "#{d}=SQRT[[#{s1}-#{a}]*[#{s1}-#{a}]+[#{s2}-#{b}]*[#{s2}-#{b}]+[#{s3}-#{c}]*[#{s3}-#{c}]]",
    "around-say-deviation",
);
const WITHIN: Line = line("IF[#{d}LE{limit}]GOTO{n1}", "around-say-within");

pub(super) const BLOCKS: &[Block] = &[
    Block {
        name: "skip",
        fields: &[field("variable", Kind::Variable(STAYING), "520")],
        suits: &[Suits::Workpiece],
        before: &[line("IF[#{variable}EQ1]GOTO{n1}", "around-say-measured")],
        after: &[line("#{variable}=1", "around-say-mark"), line("N{n1}", "")],
    },
    Block {
        name: "finish",
        fields: &[field("semi", Kind::Program, ""), field("finish", Kind::Program, "")],
        suits: &[Suits::Workpiece, Suits::CorrectsTool],
        before: &[line("M98P{semi}(PW-SEMI-FINISH)", "")],
        after: &[line("M98P{finish}(PW-FINISH)", "")],
    },
    Block {
        name: "stop",
        fields: &[LIMIT, field("text", Kind::Text, "around-text-stop")],
        suits: &[Suits::Workpiece, Suits::Offset],
        before: &[SAVED_1, SAVED_2, SAVED_3],
        after: &[DISTANCE, WITHIN, line("#3006=1({text})", ""), line("N{n1}", "")],
    },
    Block {
        name: "alarm",
        fields: &[LIMIT, field("number", Kind::Whole(ALARMS), "1"), field("text", Kind::Text, "around-text-stop")],
        suits: &[Suits::Workpiece, Suits::Offset],
        before: &[SAVED_1, SAVED_2, SAVED_3],
        after: &[DISTANCE, WITHIN, line("#3000={number}({text})", ""), line("N{n1}", "")],
    },
    Block {
        name: "jump",
        fields: &[LIMIT, field("target", Kind::Target, "")],
        suits: &[Suits::Workpiece, Suits::Offset],
        before: &[SAVED_1, SAVED_2, SAVED_3],
        after: &[DISTANCE, line("IF[#{d}GT{limit}]GOTO{target}", "around-say-jump")],
    },
    Block {
        name: "keep",
        fields: &[field("variable", Kind::Variable(STAYING), "521")],
        suits: &[Suits::Workpiece, Suits::Offset],
        before: &[SAVED_1, SAVED_2, SAVED_3],
        after: &[DISTANCE, line("#{variable}=#{d}", "around-say-keep")],
    },
    Block {
        name: "rework",
        fields: &[
            LIMIT,
            field("passes", Kind::Whole(PASSES), "3"),
            REWORK,
            field("text", Kind::Text, "around-text-rework"),
        ],
        suits: &[Suits::Workpiece, Suits::Offset],
        before: &[
            SAVED_1,
            SAVED_2,
            SAVED_3,
            line("#{e}=0", "around-say-count"),
            line("N{n3}", ""),
            line("#{s1}=#{a}", "around-say-restore"),
            line("#{s2}=#{b}", ""),
            line("#{s3}=#{c}", ""),
        ],
        after: &[
            DISTANCE,
            WITHIN,
            line("IF[#{e}GE{passes}]GOTO{n2}", "around-say-passes"),
            line("#{e}=#{e}+1", ""),
            line("M98P{program}", "around-say-rework"),
            line("GOTO{n3}", "around-say-again"),
            line("N{n2}#3006=1({text})", ""),
            line("N{n1}", ""),
        ],
    },
];
