//! What a machine changes in the definition files of the measuring cycles, and the program that assigns its values
//! (B:13262-13292, B:14205-14234). The delivered files are printed nowhere: lines are written, no files.

use super::machine::{differing, head, listed, places, value, written};
use crate::control::gud::{self, Block, Gud, Initial, Kind};
use crate::control::{CALIBRATED, Control, Units, Value, arrays::stem};
use std::fmt::Write;

/// A definition file of the measuring cycles (B:13082-13087, B:14157-14168).
pub struct DefinitionFile {
    /// Name.
    pub name: &'static str,
    /// Block of its data.
    pub block: Block,
}

/// In the order in which they are activated. The last one is GUD7.DEF up to cycles 6.02.16 (B:14162).
pub static FILES: [DefinitionFile; 3] = [
    DefinitionFile { name: "GUD5.DEF", block: Block::Gud5 },
    DefinitionFile { name: "GUD6.DEF", block: Block::Gud6 },
    DefinitionFile { name: "GUD7_MC.DEF", block: Block::Gud7 },
];

/// Name of the program that assigns values, as the control has it.
pub const VALUES: &str = "%_N_PW_MEAS_VALUES_MPF";

/// How many tool probes there are, by which the arrays of measuring in JOG are sized (B:14217-14225).
pub const TOOL_PROBES: &str = "_CVAL[0]";
/// Data that size others: they stand in a definition, since a program cannot make an array larger.
const SIZES: [&str; 2] = ["_CVAL", "_EVMVNUM"];
/// Memories: their values belong to the user (B:13089-13091).
pub const MEMORIES: [&str; 2] = ["_EV", "_MV"];
/// Wipes all arrays at the next call (B:13644).
const WIPES: &str = "_CBIT[13]";

/// A machine as its files have it: nothing that wipes arrays, and the switches of units as the basic system wants them,
/// in which the values are written. With others the next call would convert them (B:13594-13598).
pub fn as_written(control: &Control) -> Control {
    let mut control = control.clone();
    control.settle_units();
    control.set(WIPES, 0.0);
    control
}

/// What the delivered files have, those of a metric machine (B:13565, B:13883): on a machine in inch every length and
/// speed differs. What calibration writes counts as delivered where the machine has it as its system is delivered.
pub fn as_delivered(control: &Control) -> Control {
    let mut delivered = control.delivered_alike(Units::Metric);
    let own = control.delivered_alike(control.basic_units).data;
    for (name, value) in own.iter().filter(|(name, _)| stem(name) == CALIBRATED) {
        delivered.data.insert(name.clone(), value.clone());
    }
    delivered
}
/// Arrays of tool probes.
const OF_TOOL_PROBES: [&str; 2] = ["_TP", "_TPW"];
/// Elements of a tool probe that a list shorter than its array leaves at 0, where no measuring is possible.
const ALWAYS: [usize; 3] = [7, 8, 9];
/// Most characters of a block of the program.
const WIDTH: usize = 80;

/// Block numbers that the manual prints (B:13276-13286, B:14228).
const NUMBERS: [(&str, u16); 7] =
    [("_CVAL", 10), ("_TP", 11), ("_WP", 12), ("_KB", 13), ("_EVMVNUM", 40), ("_JM_I", 92), ("_TPW", 111)];

/// The lines of a definition file that differ from delivery; empty: none does.
pub fn lines(file: &DefinitionFile, control: &Control, delivered: &Control) -> String {
    let changed = differing(control, delivered);
    let own = |gud: &Gud, name: &String| gud::named(name).is_some_and(|one| one.name == gud.name);
    let differs = |gud: &Gud| {
        let by_value = file.block != Block::Gud5 && changed.iter().any(|name| own(gud, name));
        by_value || size(control, gud) != size(delivered, gud)
    };
    let simple =
        |gud: &&Gud| gud.block == file.block && gud.of_machine() && !matches!(gud.kind, Kind::Text | Kind::Frame);
    let mut text = String::new();
    for gud in gud::all().filter(simple).filter(|gud| differs(gud)) {
        let _ = writeln!(text, "{}", line(gud, control, delivered));
    }
    text
}

/// `N11 DEF NCK REAL _TP[2,10]=(0,…)`; an array without elements is a comment, as the manual does it (B:13281).
fn line(gud: &Gud, control: &Control, delivered: &Control) -> String {
    let number = NUMBERS.iter().find(|(name, _)| *name == gud.name).map(|(_, number)| format!("N{number} "));
    let head = format!("{}{}", number.unwrap_or_default(), head(gud));
    let sizes = size(control, gud);
    let index = |sizes: &[usize]| sizes.iter().map(usize::to_string).collect::<Vec<_>>().join(",");
    if sizes.is_empty() {
        return format!("{head}={}", written(&value(control, gud.name)));
    }
    if sizes.contains(&0) {
        let one: Vec<usize> = sizes.iter().map(|size| (*size).max(1)).collect();
        return format!(";{head}[{}]", index(&one));
    }
    let head = format!("{head}[{}]", index(&sizes));
    if gud.block == Block::Gud5 {
        return head; // memories begin with 0
    }
    let values = listed(places(&sizes).iter().map(|at| element(gud, at, control, delivered)), sizes.len());
    let list = if gud.block == Block::Gud7 { "SET" } else { "" };
    if values.is_empty() { head } else { format!("{head}={list}({values})") }
}

/// An element; one beyond the delivered size has the value that is delivered for all.
fn element(gud: &Gud, at: &[usize], control: &Control, delivered: &Control) -> Value {
    let own = value(control, &gud.spelled(at));
    if gud.name == CALIBRATED && own == value(delivered, &gud.spelled(at)) {
        return Value::Number(0.0);
    }
    let beyond = at.iter().zip(gud.sizes).any(|(index, size)| index >= size);
    let initial = gud.elements.first().map(|element| element.initial);
    match initial {
        Some(Initial::Number(number)) if beyond => Value::Number(number),
        _ => own,
    }
}

/// Whether an array of measuring in JOG has an element for each tool probe.
fn of_tool_probes(gud: &Gud) -> bool {
    let each = gud.elements.first().is_some_and(|element| element.index == "k" && !element.internal);
    gud.block == Block::Gud7 && gud.sizes.len() == 1 && each
}

/// Sizes of an array on this machine: as its definition files have them, but for fields that are counted.
pub fn size(control: &Control, gud: &Gud) -> Vec<usize> {
    let defined = control.definitions.sizes.get(gud.name);
    let mut sizes = defined.cloned().unwrap_or_else(|| gud.sizes.to_vec());
    let (Some(first), Some(most)) = (sizes.first_mut(), gud.sizes.first()) else { return sizes };
    let count = |name: &str| control.number(name).max(0.0) as usize;
    if !gud.counted.is_empty() {
        *first = count(gud.counted).min(*most);
    } else if of_tool_probes(gud) && defined.is_none() {
        *first = count(TOOL_PROBES).clamp(1, LARGEST);
    }
    sizes
}

/// The names of its elements on this machine.
pub fn elements(control: &Control, gud: &Gud) -> Vec<String> {
    places(&size(control, gud)).iter().map(|at| gud.spelled(at)).collect()
}

/// The datum that counts the fields of an array.
pub fn counter(gud: &Gud) -> Option<&'static str> {
    Some(gud.counted).filter(|counted| !counted.is_empty())
}

/// `DEF NCK BOOL _CBIT[17]`, the line that keeps a size with the machine.
pub fn sized(gud: &Gud, sizes: &[usize]) -> String {
    format!("{}[{}]", head(gud), sizes.iter().map(usize::to_string).collect::<Vec<_>>().join(","))
}

/// Most probes (B:929).
const LARGEST: usize = 99;

/// Whether the size of a datum is chosen.
pub fn is_sized(gud: &Gud) -> bool {
    gud.of_machine() && (!gud.counted.is_empty() || of_tool_probes(gud))
}

/// The program that assigns values that differ from delivery, to be run once in AUTOMATIC (B:13290-13292); of tool
/// probes always what a short list in a definition leaves at 0. Empty: nothing differs.
pub fn values(control: &Control, delivered: &Control) -> String {
    let changed = differing(control, delivered);
    if changed.is_empty() {
        return String::new();
    }
    let of_program = |gud: &Gud| gud.of_machine() && !SIZES.contains(&gud.name) && !MEMORIES.contains(&gud.name);
    let mut text = format!("{VALUES}\n;$PATH=/_N_MPF_DIR\n");
    let mut number = 0;
    for gud in gud::all().filter(|gud| of_program(gud)) {
        let probes = OF_TOOL_PROBES.contains(&gud.name);
        let counted = size(control, gud);
        let always = |at: &[usize]| probes && at.get(1).is_some_and(|index| ALWAYS.contains(index));
        let mut names: Vec<String> = if probes {
            places(&counted).iter().filter(|at| always(at)).map(|at| gud.spelled(at)).collect()
        } else {
            Vec::new()
        };
        let there = |name: &&String| {
            let place = gud::place(name).filter(|(one, _)| one.name == gud.name);
            place.is_some_and(|(_, at)| at.iter().zip(&counted).all(|(index, size)| index < size))
        };
        names.extend(changed.iter().filter(there).cloned());
        names.sort_by_cached_key(|name| gud::place(name).map(|(_, at)| at));
        names.dedup();
        let all = names.iter().map(|name| format!("{name}={}", written(&value(control, name))));
        for block in blocks(all) {
            number += 10;
            let _ = writeln!(text, "N{number} {block}");
        }
    }
    let _ = writeln!(text, "N{} M2", number + 10);
    text
}

/// Assignments in blocks of at most this many characters.
fn blocks(all: impl Iterator<Item = String>) -> Vec<String> {
    let mut blocks: Vec<String> = Vec::new();
    for one in all {
        match blocks.last_mut().filter(|block| block.len() + one.len() < WIDTH) {
            Some(block) => *block += &format!(" {one}"),
            None => blocks.push(one),
        }
    }
    blocks
}

/// Bytes of a value in the memory for user data (B:12953); INT is not printed: 32 bits.
pub fn bytes(kind: Kind) -> usize {
    match kind {
        Kind::Bool => 1,
        Kind::Integer => 4,
        Kind::Real => 8,
        Kind::Text | Kind::Frame => 0, // none of them is sized
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::control::delivery;
    use crate::dialect::Dialect;

    fn changed(values: &[(&str, f64)]) -> (Control, Control) {
        let mut control = delivery(Dialect::Sinumerik);
        values.iter().for_each(|(name, value)| control.set(*name, *value));
        control.fill_fields();
        let control = as_written(&control);
        let delivered = as_delivered(&control);
        (control, delivered)
    }

    fn of(file: &str, (control, delivered): &(Control, Control)) -> Vec<String> {
        let file = FILES.iter().find(|one| one.name == file).unwrap();
        lines(file, control, delivered).lines().map(str::to_owned).collect()
    }

    // oracle: self
    #[test]
    fn a_machine_as_delivered_changes_nothing() {
        let machine = changed(&[]);
        assert!(FILES.iter().all(|file| of(file.name, &machine).is_empty()));
        assert_eq!(values(&machine.0, &machine.1), "");
    }

    // oracle: manual B:13262-13288 (two probes of each sort, no gauging block, ten memories), with what follows from
    // it: _TPW goes with its count, and GUD5 has the memories; the list of _TP goes on for the second probe
    #[test]
    fn the_first_example_of_the_manual_is_written() {
        let machine = changed(&[
            ("_CVAL[0]", 2.0),
            ("_CVAL[1]", 2.0),
            ("_CVAL[2]", 0.0),
            ("_CVAL[3]", 0.0),
            ("_EVMVNUM[0]", 10.0),
            ("_EVMVNUM[1]", 10.0),
        ]);
        assert_eq!(of("GUD5.DEF", &machine), ["DEF CHAN REAL _EV[10]", "DEF CHAN REAL _MV[10]"]);
        let gud6 = of("GUD6.DEF", &machine);
        for line in [
            "N10 DEF NCK INT _CVAL[4]=(2,2,0,0)",
            "N11 DEF NCK REAL _TP[2,10]=(0,0,0,0,0,0,0,133,0,2,0,0,0,0,0,0,0,133,0,2)",
            ";N13 DEF NCK REAL _KB[1,7]",
            ";N111 DEF NCK REAL _TPW[1,10]",
            "N40 DEF CHAN INT _EVMVNUM[2]=(10,10)",
        ] {
            assert!(gud6.iter().any(|one| one == line), "{line}\n{gud6:#?}");
        }
        assert!(gud6.iter().any(|line| line == "N12 DEF NCK REAL _WP[2,11]"), "{gud6:#?}");
    }

    // oracle: hand: what was calibrated is kept, and nothing else looks calibrated
    #[test]
    fn a_probe_is_as_calibrated_as_the_machine_says() {
        let gud6 = of("GUD6.DEF", &changed(&[("_CVAL[1]", 2.0), ("_WP[1,0]", 5.99)]));
        let line = gud6.iter().find(|line| line.contains("_WP[")).unwrap();
        assert_eq!(line, "N12 DEF NCK REAL _WP[2,11]=(0,0,0,0,0,0,0,0,0,0,0,5.99)");
    }

    // oracle: manual B:14217-14225 (least memory: one tool probe)
    #[test]
    fn arrays_of_measuring_in_jog_follow_the_tool_probes() {
        let machine = changed(&[("_CVAL[0]", 1.0)]);
        let lines = of("GUD7_MC.DEF", &machine);
        for line in [
            "DEF CHAN INT E_MESS_MT_TYP[1]",
            "DEF CHAN INT E_MESS_MT_AX[1]=SET(133)",
            "DEF CHAN REAL E_MESS_MT_DL[1]",
            "DEF CHAN REAL E_MESS_MT_DZ[1]=SET(2)",
            "DEF CHAN INT E_MESS_MT_DIR[1]=SET(-1)",
        ] {
            assert!(lines.iter().any(|one| one == line), "{line}\n{lines:#?}");
        }
        // a fourth probe has what is delivered for each
        let four = of("GUD7_MC.DEF", &changed(&[("_CVAL[0]", 4.0)]));
        assert!(four.iter().any(|one| one == "DEF CHAN INT E_MESS_MT_AX[4]=SET(133,133,133,133)"), "{four:#?}");
    }

    // oracle: manual B:13290-13292 and hand (sizes and memories stay out, elements of each tool probe are written,
    // nothing that wipes arrays)
    #[test]
    fn the_program_assigns_what_no_definition_sizes() {
        let machine = changed(&[
            ("_CVAL[0]", 1.0),
            ("_CVAL[3]", 0.0),
            ("_TP[0,6]", 20.0),
            ("_TP[2,6]", 9.0),
            ("_CBIT[14]", 1.0),
            ("_CBIT[13]", 1.0),
            ("_SPEED[0]", 80.0),
            ("_EV[3]", 0.5),
        ]);
        let text = values(&machine.0, &machine.1);
        assert_eq!(
            text,
            "%_N_PW_MEAS_VALUES_MPF\n;$PATH=/_N_MPF_DIR\nN10 _TP[0,6]=20 _TP[0,7]=133 _TP[0,8]=0 _TP[0,9]=2\n\
             N20 _CBIT[14]=1\nN30 _SPEED[0]=80\nN40 M2\n"
        );
    }
}
