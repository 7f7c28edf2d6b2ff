//! Standard cycles of the control, which drill, mill and turn: what a run makes of each. The arguments and their order
//! are from memory of the field: the guide of these cycles is not among the manuals of this project, so nobody has held
//! them against it yet.

/// A cycle whose motion is driven.
#[derive(Debug, PartialEq, Eq)]
pub struct Standard {
    /// Name in upper case.
    pub name: &'static str,
    /// Names of its arguments, in their order.
    pub args: &'static [&'static str],
    /// What it does.
    pub work: Work,
}

/// What a cycle does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    /// Goes to a depth and comes back.
    Drill(Way),
    /// Goes to positions, at each of which the modal cycle works.
    Row,
    /// On a circle.
    Circle,
    /// In rows and columns.
    Grid,
}

/// How a drilling cycle goes to its depth and back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Down with feed, back with rapid traverse.
    Plain,
    /// Down and back with feeds.
    Reamed,
    /// In several steps.
    Pecks,
    /// Down and back with the feed of a thread.
    Thread,
}

/// Those that are driven, in the order of the manual.
static DRIVEN: &[Standard] = &[
    Standard { name: "CYCLE81", args: &["RTP", "RFP", "SDIS", "DP", "DPR"], work: Work::Drill(Way::Plain) },
    Standard { name: "CYCLE82", args: &["RTP", "RFP", "SDIS", "DP", "DPR", "DTB"], work: Work::Drill(Way::Plain) },
    Standard {
        name: "CYCLE83",
        args: &[
            "RTP", "RFP", "SDIS", "DP", "DPR", "FDEP", "FDPR", "DAM", "DTB", "DTS", "FRF", "VARI", "_AXN", "_MDEP",
            "_VRT", "_DTD", "_DIS1",
        ],
        work: Work::Drill(Way::Pecks),
    },
    Standard {
        name: "CYCLE84",
        args: &[
            "RTP", "RFP", "SDIS", "DP", "DPR", "DTB", "SDAC", "MPIT", "PIT", "POSS", "SST", "SST1", "_AXN", "_PTAB",
        ],
        work: Work::Drill(Way::Thread),
    },
    Standard {
        name: "CYCLE840",
        args: &["RTP", "RFP", "SDIS", "DP", "DPR", "DTB", "SDR", "SDAC", "ENC", "MPIT", "PIT", "_AXN", "_PTAB"],
        work: Work::Drill(Way::Thread),
    },
    Standard {
        name: "CYCLE85",
        args: &["RTP", "RFP", "SDIS", "DP", "DPR", "DTB", "FFR", "RFF"],
        work: Work::Drill(Way::Reamed),
    },
    Standard {
        name: "CYCLE86",
        args: &["RTP", "RFP", "SDIS", "DP", "DPR", "DTB", "SDIR", "RPA", "RPO", "RPAP", "POSS"],
        work: Work::Drill(Way::Plain),
    },
    Standard { name: "CYCLE87", args: &["RTP", "RFP", "SDIS", "DP", "DPR", "SDIR"], work: Work::Drill(Way::Plain) },
    Standard {
        name: "CYCLE88",
        args: &["RTP", "RFP", "SDIS", "DP", "DPR", "DTB", "SDIR"],
        work: Work::Drill(Way::Plain),
    },
    Standard { name: "CYCLE89", args: &["RTP", "RFP", "SDIS", "DP", "DPR", "DTB"], work: Work::Drill(Way::Reamed) },
    Standard { name: "HOLES1", args: &["SPCA", "SPCO", "STA1", "FDIS", "DBH", "NUM"], work: Work::Row },
    Standard { name: "HOLES2", args: &["CPA", "CPO", "RAD", "STA1", "INDA", "NUM"], work: Work::Circle },
    Standard {
        name: "CYCLE801",
        args: &["_SPCA", "_SPCO", "_STA", "_DIS1", "_DIS2", "_NUM1", "_NUM2"],
        work: Work::Grid,
    },
];

/// Cycles without CYCLE in their name whose motion is left out: pockets, slots, spigots, contours.
const LEFT_OUT: [&str; 7] = ["LONGHOLE", "POCKET1", "POCKET2", "POCKET3", "POCKET4", "SLOT1", "SLOT2"];

/// Numbers of cycles that drill, mill, turn and swivel, and of parts of the measuring cycles (B:2384-2393).
const OF_CONTROL: [std::ops::RangeInclusive<u32>; 4] = [60..=199, 800..=899, 930..=959, 4071..=4079];

/// The cycle that is driven.
pub fn driven(name: &str) -> Option<&'static Standard> {
    DRIVEN.iter().find(|one| one.name == name)
}

/// Whether a name is that of a standard cycle, driven or not: `CYCLE83`, `POCKET3`.
pub fn is_standard(name: &str) -> bool {
    let number = name.strip_prefix("CYCLE").and_then(|digits| digits.parse().ok());
    let numbered = number.is_some_and(|number| OF_CONTROL.iter().any(|numbers| numbers.contains(&number)));
    numbered || LEFT_OUT.contains(&name) || driven(name).is_some()
}

/// Whether a name is that of a step of ShopMill or ShopTurn: `F_HEAD`, `E_PO_CIR`. Names that begin so belong to the
/// control.
pub fn is_step(name: &str) -> bool {
    let rest = name.strip_prefix("F_").or_else(|| name.strip_prefix("E_"));
    rest.is_some_and(|rest| rest.starts_with(|first: char| first.is_ascii_alphabetic()))
}

impl Standard {
    /// Place of an argument; none: the cycle has no such argument.
    pub fn place(&self, name: &str) -> Option<usize> {
        self.args.iter().position(|one| *one == name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::CYCLES;

    // oracle: hand: standard cycles measure nothing
    #[test]
    fn no_standard_cycle_is_in_the_catalogue() {
        for one in DRIVEN {
            assert!(is_standard(one.name) && CYCLES.iter().all(|cycle| cycle.name != one.name), "{}", one.name);
            let places: Vec<_> = one.args.iter().map(|name| one.place(name)).collect();
            assert_eq!(places, (0..one.args.len()).map(Some).collect::<Vec<_>>(), "{}", one.name);
        }
        assert!(is_step("F_HEAD") && is_step("E_PO_CIR") && !is_step("F_") && !is_step("E_1") && !is_step("END_F"));
        assert!(is_standard("POCKET4") && is_standard("CYCLE95") && !is_standard("CYCLE20") && !is_standard("CYCLE"));
    }
}
