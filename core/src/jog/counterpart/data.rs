//! Data that the automatic cycle obeys where JOG takes another datum, or does one thing whatever is set: a row a
//! datum, told where it makes a difference (the pairs of B:14157-14368 beside B:13534-13884).

use super::Told;
use crate::catalogue::sinumerik::measuring_block::follow;
use crate::jog::mask::Task;
use crate::jog::settings::Settings;
use crate::message::Message;

/// What JOG takes in place of a bit of the cycles.
#[derive(Clone, Copy, Debug)]
enum Jog {
    /// A bit that means the same.
    Bit(&'static str),
    /// A bit that means the opposite.
    Not(&'static str),
    /// Always this one.
    Always(bool),
}

/// Which masks it concerns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Of {
    /// All with a workpiece probe.
    Workpiece,
    /// Those of a probe that was calibrated.
    Measuring,
    /// All with a workpiece probe that touches in every direction.
    Multi,
    /// All with a workpiece probe that touches in one direction.
    Mono,
    /// All with a tool in the spindle.
    Tool,
    /// Those that measure the tool.
    OffsetOfTool,
    /// All.
    All,
}

/// A bit of the cycles.
#[derive(Debug)]
struct Row {
    /// Its name.
    bit: &'static str,
    /// What JOG takes.
    jog: Jog,
    /// Where.
    of: Of,
    /// Bit that has to be set for it to count.
    with: Option<&'static str>,
    /// What is told.
    key: &'static str,
}

const fn row(bit: &'static str, jog: Jog, of: Of, key: &'static str) -> Row {
    Row { bit, jog, of, with: None, key }
}

impl Row {
    const fn with(self, bit: &'static str) -> Row {
        Row { with: Some(bit), ..self }
    }
}

#[rustfmt::skip]
const ROWS: &[Row] = &[
    row("_CHBIT[0]", Jog::Bit("E_MESS_MS_IN"), Of::Workpiece, "jog-differs-input"), // B:13834-13836;B:14251
    row("_CHBIT[1]", Jog::Bit("E_MESS_MT_IN"), Of::Tool, "jog-differs-input"), // B:13836-13837;B:14252
    row("_CHBIT[2]", Jog::Always(true), Of::All, "jog-differs-watched"), // B:13838;B:14258-14259
    row("_CHBIT[3]", Jog::Bit("_JM_B[0]"), Of::OffsetOfTool, "jog-differs-tool-memory"), // B:13839-13840;B:14353-14355
    row("_CHBIT[13]", Jog::Not("E_MESS_SETT[0]"), Of::Multi, "jog-differs-spindle"), // B:13867-13868;B:14298-14304
    row("_CHBIT[15]", Jog::Bit("_JM_B[1]"), Of::Workpiece, "jog-differs-attempts"), // B:13870;B:14356-14358
    row("_CHBIT[15]", Jog::Always(true), Of::Tool, "jog-differs-attempts-tool"), // B:13870;B:4015-4018
    // B:13871, B:14359-14361, B:4015-4018
    row("_CHBIT[16]", Jog::Bit("_JM_B[2]"), Of::Workpiece, "jog-differs-return").with("_CHBIT[2]"),
    row("_CHBIT[16]", Jog::Always(false), Of::Tool, "jog-differs-return-tool").with("_CHBIT[2]"),
    row("_CHBIT[17]", Jog::Bit("_JM_B[3]"), Of::Workpiece, "jog-differs-touches"), // B:13872;B:14362-14364
    row("_CHBIT[17]", Jog::Always(false), Of::Tool, "jog-differs-touches-tool"), // B:13872;B:4015-4018
    row("_CHBIT[10]", Jog::Always(false), Of::All, "jog-differs-screen"), // B:13855;B:3034
    row("_CBIT[0]", Jog::Always(false), Of::All, "jog-differs-repeats"), // B:13534;B:14356-14358
    row("_CBIT[8]", Jog::Always(false), Of::Mono, "jog-differs-offset-angle"), // B:13549-13550;B:14324
    row("_CBIT[12]", Jog::Always(false), Of::OffsetOfTool, "jog-differs-speeds"), // B:13558-13559;B:14262-14268
    row("_CBIT[13]", Jog::Always(false), Of::All, "jog-differs-erases"), // B:13560
    row("_CBIT[16]", Jog::Always(true), Of::Measuring, "jog-differs-watches-calibration"), // B:13664-13669
];

impl Told<'_> {
    fn concerns(&self, of: Of) -> bool {
        let (tool, mono) = (self.mask.task.of_tool(), Settings::of(&self.control).probe.1);
        match of {
            Of::All => true,
            Of::Workpiece => !tool,
            Of::Measuring => self.mask.task.corrects(),
            Of::Multi => !tool && !mono,
            Of::Mono => !tool && mono,
            Of::Tool => tool,
            Of::OffsetOfTool => tool && self.mask.task != Task::ToolProbe,
        }
    }

    /// What of the data differs, each with the values of both.
    pub fn data(&self) -> Vec<Message> {
        let bit = |name: &str| self.control.bit(name);
        let differs = |row: &&Row| {
            let there = bit(row.bit);
            let alike = match row.jog {
                Jog::Bit(name) => bit(name) == there,
                Jog::Not(name) => bit(name) != there,
                Jog::Always(one) => one == there,
            };
            !alike && row.with.is_none_or(bit) && self.concerns(row.of)
        };
        let told = |row: &Row| {
            let number = |name: &str| self.control.number(name);
            let message = Message::new(row.key).text("cycle", row.bit).number("there", number(row.bit));
            match row.jog {
                Jog::Bit(name) | Jog::Not(name) => message.text("jog", name).number("here", number(name)),
                Jog::Always(_) => message,
            }
        };
        ROWS.iter().filter(differs).map(told).chain(self.feeds()).chain(self.tilted()).collect()
    }

    /// In a tilted WCS the spindle of the cycle stays, that of JOG follows (B:13979-13981, B:14304).
    fn tilted(&self) -> Option<Message> {
        let both = self.control.bit("_CHBIT[13]") && Settings::of(&self.control).follows;
        let tilted = both && self.concerns(Of::Multi) && follow(&self.control).is_none();
        tilted.then(|| Message::new("jog-differs-tilted"))
    }

    /// The feeds between the points, where the cycle watches the way too (B:13732-13733, B:14258-14259).
    fn feeds(&self) -> Option<Message> {
        if self.mask.task.of_tool() || !self.control.bit("_CHBIT[2]") {
            return None;
        }
        let here = Settings::of(&self.control).positioning;
        let there = ["_SPEED[1]", "_SPEED[2]"].map(|name| self.control.basic_length(name));
        let alike = (0..2).all(|place| (here[place] - there[place]).abs() < 1e-6);
        let message = || {
            let named = [("plane", there[0]), ("depth", there[1]), ("feed", here[0]), ("infeed", here[1])];
            named.into_iter().fold(Message::new("jog-differs-feeds"), |told, (name, value)| told.number(name, value))
        };
        (!alike).then(message)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::control::gud;

    /// Bits that make no difference between JOG and a call of its counterpart, and why.
    const ALIKE: &[(&str, &str)] = &[
        ("_CBIT[1]", "acts with _CBIT[0] only, and is told with it"),
        ("_CBIT[2]", "tolerances: the calls correct a zero offset, or say no tolerance of the tool"),
        ("_CBIT[3]", "the unit of the data, for both"),
        ("_CBIT[5]", "CYCLE982"),
        ("_CBIT[6]", "the log, which is none of the measurement"),
        ("_CBIT[7]", "tool carriers of turning machines"),
        ("_CBIT[11]", "the log"),
        ("_CBIT[14]", "JOG takes the same one"),
        ("_CBIT[15]", "JOG takes the same one"),
        ("_CHBIT[4]", "mean values: of tool offsets by a workpiece"),
        ("_CHBIT[5]", "empirical values, of which the calls name none"),
        ("_CHBIT[6]", "tool offsets by a workpiece"),
        ("_CHBIT[7]", "CYCLE994"),
        ("_CHBIT[8]", "tool offsets by a workpiece"),
        ("_CHBIT[11]", "acts with _CHBIT[10] only, and is told with it"),
        ("_CHBIT[14]", "the spindle of JOG turns the same way"),
        ("_CHBIT[18]", "acts with _CHBIT[10] only, and is told with it"),
        ("_CHBIT[19]", "CYCLE974, CYCLE994"),
        ("_CHBIT[20]", "CYCLE982"),
        ("_CHBIT[21]", "told with what is written"),
        ("_CHBIT[22]", "the manual does not tell by how much the last touch is slower"),
        ("_CHBIT[23]", "CYCLE982"),
        ("_CHBIT[24]", "the unit of the data, for both"),
    ];

    // oracle: manual B:13534-13884, B:14353-14368: each bit of both is told, or makes no difference
    #[test]
    fn no_bit_is_forgotten() {
        let mut missing = Vec::new();
        let of_jog = |row: &Row| match row.jog {
            Jog::Bit(name) | Jog::Not(name) => name,
            Jog::Always(_) => "",
        };
        for (array, count) in [("_CBIT", 30), ("_CHBIT", 30), ("_JM_B", 4)] {
            for index in 0..count {
                let name = format!("{array}[{index}]");
                let (gud, at) = gud::place(&name).unwrap();
                let means = gud.element(&at).is_some_and(|element| !element.internal);
                let told = ROWS.iter().any(|row| row.bit == name || of_jog(row) == name);
                let alike = ALIKE.iter().any(|(bit, _)| *bit == name);
                if means != (told || alike) || told && alike {
                    missing.push(name);
                }
            }
        }
        assert_eq!(missing, Vec::<String>::new());
    }
}
