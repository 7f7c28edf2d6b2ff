//! Machine data (and one setting datum) that measuring cycles depend on (B:12920-14151, B:1899-2086).

mod table;

pub use table::MACHINE_DATA;

use super::BASIC_SYSTEM;
use crate::range::Range;

/// A machine datum.
#[derive(Clone, Copy)]
pub struct MachineDatum {
    /// `MD28082`, or `SD42950` of a setting datum.
    pub number: &'static str,
    /// Name; empty where the manual prints none.
    pub identifier: &'static str,
    /// Standard value with system software up to 59 and from 63 on, as printed.
    pub standard: [&'static str; 2],
    /// What the measuring cycles want, as printed.
    pub cycles: &'static str,
    /// What measuring in JOG wants, as printed.
    pub jog: &'static str,
    /// Smallest and largest value, as printed.
    pub bounds: [&'static str; 2],
    /// After what a change counts.
    pub effective: &'static str,
    /// Unit, as printed.
    pub unit: &'static str,
    /// Number of elements; 0: a single value.
    pub elements: usize,
    /// Whether it holds names.
    pub text: bool,
    /// Values with which the core begins: what a machine must have so that the cycles work (see DESIGN.md).
    pub initial: &'static [f64],
    /// Names with which the core begins, where the datum holds names.
    pub initial_names: &'static [&'static str],
    /// Place in the manual.
    pub source: &'static str,
}

/// Channel axes that can be named: three linear and three rotary ones.
pub const CHANNEL_AXES: usize = 6;

/// Setting datum that decides along which axes the lengths of drills and mills count (B:828).
pub const TOOL_LENGTH_TYPE: &str = "SD42950";

/// The setting datum that a program calls by its identifier: `$SC_TOOL_LENGTH_TYPE` is [`TOOL_LENGTH_TYPE`].
pub fn setting(name: &str) -> Option<&'static str> {
    let identifier = name.strip_prefix("$SC_")?;
    let mut settings = MACHINE_DATA.iter().filter(|datum| datum.number.starts_with("SD"));
    settings.find(|datum| datum.identifier == identifier).map(|datum| datum.number)
}

/// Beginnings of names that only the machine has a value for: machine and setting data, inputs, outputs and data of
/// the PLC, real values of axes and channel, states of the program, data of tools and magazines.
const OF_MACHINE: [&str; 21] = [
    "$MN_", "$MC_", "$MA_", "$MM_", "$MNS_", "$MCS_", "$MAS_", "$SN_", "$SC_", "$SA_", "$SNS_", "$SCS_", "$A_", "$AN_",
    "$AC_", "$AA_", "$VA_", "$VC_", "$VN_", "$P_", "$TC_",
];

/// Whether only the machine has a value for such a name; frames and cutting edges are those of the
/// control.
pub fn of_machine(name: &str) -> bool {
    let stem = name.split('[').next().unwrap_or(name);
    let frame = stem.starts_with("$P_") && (stem.ends_with("FR") || stem.ends_with("FRAME"));
    !frame && !of_edge(stem) && OF_MACHINE.iter().any(|begin| stem.starts_with(begin) && stem.len() > begin.len())
}

/// Whether a name is that of a datum of a cutting edge: `$TC_DP6`, `$TC_SCP13`.
pub fn of_edge(stem: &str) -> bool {
    let number = |begin: &&str| stem.strip_prefix(begin).is_some_and(|rest| rest.parse::<u32>().is_ok());
    ["$TC_DP", "$TC_SCP", "$TC_ECP"].iter().any(number)
}

/// Whether such a name has an axis as its index.
pub fn of_axes(name: &str) -> bool {
    ["$AA_", "$VA_", "$MA_", "$SA_"].iter().any(|begin| name.starts_with(begin))
}

/// Whether a text is the value of such a name.
pub fn is_text(name: &str) -> bool {
    let named = name.contains("NAME") || name.contains("PATH") && !name.starts_with("$AC_");
    named || ["$P_PROG", "$P_TOOLT", "$TC_TP2"].contains(&name)
}

/// The machine datum that a program calls by its identifier, as the setup has it: `$MC_AXCONF_MACHAX_USED[1]` is
/// `MD20070[1]`.
pub fn numbered(name: &str) -> Option<String> {
    let begin = ["$MN_", "$MC_", "$MA_"].iter().find_map(|begin| name.strip_prefix(begin))?;
    let (identifier, index) = begin.split_at(begin.find('[').unwrap_or(begin.len()));
    let mut data = MACHINE_DATA.iter().filter(|datum| datum.number.starts_with("MD"));
    data.find(|datum| datum.identifier == identifier).map(|datum| format!("{}{index}", datum.number))
}

impl MachineDatum {
    /// Names of its elements as the setup has them: `MD20050[0]`, or the plain number.
    pub fn names(&self) -> Vec<String> {
        match self.elements {
            0 => vec![self.number.to_owned()],
            count => (0..count).map(|i| format!("{}[{i}]", self.number)).collect(),
        }
    }

    /// What it can be, as its bounds say; the basic system is a switch (B:13594), whose bounds are not printed.
    pub fn range(&self) -> Range {
        if self.number == BASIC_SYSTEM {
            return Range::closed(0.0, 1.0);
        }
        let [min, max] = self.bounds.map(number);
        let open = Range::ANY;
        Range {
            min: min.unwrap_or(open.min),
            min_included: min.is_some(),
            max: max.unwrap_or(open.max),
            max_included: max.is_some(),
        }
    }

    /// Whether only whole numbers are printed as its bounds.
    pub fn is_whole(&self) -> bool {
        let printed = self.bounds.iter().all(|bound| !bound.is_empty() && !bound.contains('.'));
        printed || self.number == BASIC_SYSTEM
    }

    /// Key of its words.
    pub fn key(&self) -> String {
        format!("datum-{}", self.number.to_lowercase())
    }
}

/// Reads a number as the manual prints it: decimal, or hexadecimal with `H` behind it (`21H`), or `TRUE` and `FALSE`.
pub fn number(text: &str) -> Option<f64> {
    match text.trim() {
        "TRUE" => Some(1.0),
        "FALSE" => Some(0.0),
        text => match text.strip_suffix(['H', 'h']) {
            Some(digits) => u32::from_str_radix(digits, 16).ok().map(f64::from),
            None => text.parse().ok().filter(|value: &f64| value.is_finite()),
        },
    }
}
