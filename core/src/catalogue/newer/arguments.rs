//! What is known of each argument of these lists beside its place: its name on the screen, what corresponds to it on
//! the older control, and how that is known.

use crate::catalogue::CYCLES;
use crate::entry::{Arg, ArgumentList, Inputs, Param, Style};
use crate::message::Message;
use crate::name::Name;
use std::collections::BTreeSet;

/// How the meaning of an argument is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Evidence {
    /// Programs that run on such controls agree in its values.
    Values,
    /// The remedy of an alarm names it.
    Alarm,
    /// Its name and its place are published, and no more.
    Name,
}

/// An argument by its name there.
struct Known {
    name: &'static str,
    /// The list for which this counts instead of what counts for all; empty: all.
    list: &'static str,
    /// Name on the screen; empty: not known.
    screen: &'static str,
    /// What says it on the older control, where that is no parameter with the same meaning; empty: nothing.
    older: &'static str,
    evidence: Evidence,
    /// The alarm that names it; 0: none.
    alarm: u32,
    /// Key of its meaning; empty: that of the parameter beside it.
    meaning: &'static str,
    /// What programs write where nothing is to be said; empty: nothing.
    usual: &'static str,
}

/// What counts where nothing is said.
const PLAIN: Known =
    Known { name: "", list: "", screen: "", older: "", evidence: Evidence::Values, alarm: 0, meaning: "", usual: "" };

const fn values(name: &'static str, screen: &'static str, meaning: &'static str) -> Known {
    Known { name, screen, meaning, ..PLAIN }
}

const fn alarm(name: &'static str, screen: &'static str, alarm: u32, meaning: &'static str) -> Known {
    Known { name, screen, alarm, evidence: Evidence::Alarm, meaning, ..PLAIN }
}

const fn name_only(name: &'static str) -> Known {
    Known { name, evidence: Evidence::Name, meaning: "argument-name-only", ..PLAIN }
}

/// Name and place of an argument are known, and that it means what the parameter beside it means.
const fn named(name: &'static str, screen: &'static str) -> Known {
    Known { name, screen, evidence: Evidence::Name, ..PLAIN }
}

impl Known {
    const fn of(self, list: &'static str) -> Known {
        Known { list, ..self }
    }

    const fn meaning(self, meaning: &'static str) -> Known {
        Known { meaning, ..self }
    }

    const fn usual(self, usual: &'static str) -> Known {
        Known { usual, ..self }
    }

    const fn older(self, older: &'static str) -> Known {
        Known { older, ..self }
    }
}

/// Key of what `S_ID` is where the probe moves down to the measuring height.
const INFEED: &str = "argument-infeed";

/// Key of what the values of CYCLE961 are: its variants, whose numbers are not published, decide which.
const POINTS: &str = "argument-points";
/// Key of what `S_TSA` is in cycles that the older control does not have.
const SAFE: &str = "argument-safe";

/// Practice: published programs and generators; alarms: the remedies of the newer controls. What counts for one list
/// stands before what counts for all.
const ARGUMENTS: &[Known] = &[
    values("S_MVAR", "", ""),
    name_only("S_KNUM").of("CYCLE971"),
    name_only("S_KNUM").of("CYCLE982"),
    name_only("S_KNUM").of("CYCLE995"),
    name_only("S_KNUM").of("CYCLE9960"),
    values("S_KNUM", "", "argument-zero"),
    alarm("S_KNUM1", "", 61328, "argument-tool").older("_KNUM"),
    alarm("S_PRNUM", "", 61416, "argument-tool-probe").of("CYCLE971"),
    alarm("S_PRNUM", "", 61416, "argument-tool-probe").of("CYCLE982"),
    alarm("S_PRNUM", "", 61313, "argument-probe"),
    alarm("S_SETV", "", 61424, "argument-ball").of("CYCLE996"),
    name_only("S_SETV").of("CYCLE9960"),
    alarm("S_SETV", "", 61346, ""),
    alarm("S_SETV0", "", 61367, POINTS).of("CYCLE961"),
    alarm("S_SETV1", "", 61367, POINTS).of("CYCLE961"),
    alarm("S_SETV2", "", 61367, POINTS).of("CYCLE961"),
    alarm("S_SETV3", "", 61367, POINTS).of("CYCLE961"),
    alarm("S_SETV4", "", 61368, POINTS).of("CYCLE961"),
    alarm("S_SETV5", "", 61368, POINTS).of("CYCLE961"),
    alarm("S_SETV6", "", 61369, POINTS).of("CYCLE961"),
    alarm("S_SETV7", "", 61369, POINTS).of("CYCLE961"),
    alarm("S_SETV0", "", 61346, "").of("CYCLE977"),
    alarm("S_SETV1", "", 61346, "").of("CYCLE977"),
    named("S_SETV0", "").of("CYCLE998"),
    alarm("S_FA", "DFA", 61308, ""),
    name_only("S_TSA").of("CYCLE961"),
    alarm("S_TSA", "TSA", 61303, SAFE).of("CYCLE995"),
    alarm("S_TSA", "TSA", 61303, SAFE).of("CYCLE996"),
    alarm("S_TSA", "TSA", 61303, SAFE).of("CYCLE9960"),
    alarm("S_TSA", "TSA", 61303, ""),
    values("S_STA1", "α0", "argument-probing-angle").of("CYCLE977"),
    named("S_STA1", "α0"),
    alarm("S_INCA", "α1", 61443, ""),
    name_only("S_ID").of("CYCLE982"),
    values("S_ID", "", "").of("CYCLE998"),
    values("S_ID", "DZ", INFEED),
    alarm("S_SZA", "XS", 61334, ""),
    alarm("S_SZO", "YS", 61334, ""),
    values("S_MA", "", ""),
    values("S_MD", "", "argument-direction").of("CYCLE978").older("_MD"),
    values("S_MD", "", "argument-direction").of("CYCLE998").older("_MD"),
    alarm("S_MD", "", 61326, "argument-direction-open").older("_MD"),
    values("S_RA", "", ""),
    alarm("S_NMSP", "", 61318, "").usual("1"),
    alarm("S_K", "FW", 61318, ""),
    alarm("S_EVNUM", "", 61318, "").usual("0"),
    name_only("S_TNAME").of("CYCLE9960"),
    alarm("S_TNAME", "", 61320, "").usual("\"\""),
    named("S_DLNUM", "DL"),
    values("S_TZL", "", "").usual("0"),
    alarm("S_TDIF", "DIF", 61306, "").usual("1.01"),
    values("S_TUL", "", "").usual("1.01"),
    values("S_TLL", "", "").usual("-1.01"),
    values("S_TMV", "", ""),
    alarm("S_F1", "F1", 61350, ""),
    alarm("S_S1", "S1", 61350, ""),
    named("S_F2", ""),
    named("S_S2", ""),
    named("S_F3", ""),
    named("S_S3", ""),
    named("S_VMS", ""),
    named("S_CORA", ""),
    named("S_CPA", ""),
    named("S_CPO", ""),
    named("S_CALNUM", ""),
    alarm("S_TC", "", 61423, "argument-carrier").older("_TNUM"),
    alarm("S_TNVL", "", 61430, "argument-vectors").of("CYCLE996"),
    named("S_TNVL", ""),
    values("S_XM", "", "argument-centre-x"),
    values("S_YM", "", "argument-centre-y"),
    named("S_MCBIT", "").meaning("argument-bits").older("_CBIT[], _CHBIT[]"),
    values("_DMODE", "", "argument-plane").usual("1"),
    named("_AMODE", "").meaning("argument-mode").of("CYCLE998"),
    values("_AMODE", "", "argument-mode").usual("1"),
    Known { meaning: "argument-unnamed", ..name_only("") },
];

/// An argument of a list, with what is known of it.
#[derive(Clone, Copy)]
pub struct Argument {
    /// Its list.
    pub list: &'static ArgumentList,
    /// Its place, from 1.
    pub place: usize,
    /// Its name there; empty: none is published.
    pub name: &'static str,
    /// The parameter of the older control with the same meaning.
    pub param: Option<Name>,
    known: &'static Known,
}

/// What is published of an argument that the dictionary does not name.
const ONLY_NAMED: &Known = &name_only("");

/// What counts behind the last published argument, and where one has no name.
const NOT_NAMED: &Known = &Known { meaning: "argument-unnamed", ..name_only("") };

impl Argument {
    /// The argument at this index of a list; behind its last one too.
    pub fn at(list: &'static ArgumentList, index: usize) -> Argument {
        let (name, param) = match list.args.get(index) {
            Some(Arg::Newer(name, param)) => (*name, *param),
            _ => ("", None),
        };
        let of = |list: &str| ARGUMENTS.iter().find(|one| one.name == name && one.list == list);
        let known = if name.is_empty() { Some(NOT_NAMED) } else { of(list.name).or_else(|| of("")) };
        Argument { list, place: index + 1, name, param, known: known.unwrap_or(ONLY_NAMED) }
    }

    /// Every published argument of a list, in order.
    pub fn all(list: &'static ArgumentList) -> impl Iterator<Item = Argument> {
        (0..list.args.len()).map(move |index| Argument::at(list, index))
    }

    /// Under which name its value is told and changed: its own, else its place.
    pub fn key(&self) -> &'static str {
        match (self.name, self.place) {
            _ if self.list.style != Style::Operate => "",
            ("", 2) => "2",
            ("", 3) => "3",
            ("", 4) => "4",
            ("", 19) => "19",
            ("", 23) => "23",
            (name, _) => name,
        }
    }

    /// Its name on the screen; empty: not known.
    pub fn screen(&self) -> &'static str {
        self.known.screen
    }

    /// What says it on the older control; empty: nothing does, or it is not known.
    pub fn older(&self) -> &'static str {
        let own = CYCLES.iter().find(|cycle| cycle.name == self.list.name);
        // a cycle of both controls says itself whether it has the parameter
        let has = |older: &&str| {
            own.is_none_or(|cycle| !older.starts_with('_') || older.contains("[]") || cycle.param(older).is_some())
        };
        self.param.as_ref().map_or(Some(self.known.older).filter(has).unwrap_or_default(), |name| name.as_str())
    }

    /// What programs write where nothing is to be said; empty: nothing.
    pub fn usual(&self) -> &'static str {
        self.known.usual
    }

    /// Whether it is something to enter that the older control does not have, or has otherwise.
    pub fn is_field(&self) -> bool {
        let mode = matches!(self.name, "_DMODE" | "_AMODE");
        self.param.is_none() && self.evidence() == Evidence::Values && !mode
    }

    /// How its meaning is known. Programs are published with the lists that are written alone.
    pub fn evidence(&self) -> Evidence {
        match self.known.evidence {
            Evidence::Values if !self.list.is_written() => Evidence::Name,
            known => known,
        }
    }

    /// The alarm whose remedy names it.
    pub fn alarm(&self) -> Option<u32> {
        (self.known.alarm != 0).then_some(self.known.alarm)
    }

    /// Whether it is the number of the variant, and its digits are not published.
    pub fn is_open(&self) -> bool {
        self.evidence() == Evidence::Name && (self.param.is_none() || self.is_variant()) || self.name == "S_KNUM1"
    }

    fn is_variant(&self) -> bool {
        self.name == "S_MVAR"
    }

    /// Key of its meaning.
    pub fn meaning(&self) -> String {
        match self.known.meaning {
            "" => self.param().map_or("argument-name-only".into(), |param| format!("param-{}", self.label(param))),
            own => own.into(),
        }
    }

    /// Whether it is the travel down to the measuring height, whose sign differs between programs.
    pub fn is_infeed(&self) -> bool {
        self.known.meaning == INFEED
    }

    /// What the parameter is in the variants of which the list is known, else in all that use it; where they differ,
    /// what it is by itself.
    fn label(&self, param: &Param) -> &'static str {
        let own = CYCLES.iter().find(|cycle| cycle.name == self.list.name);
        let variants =
            own.into_iter().flat_map(|cycle| cycle.variants.iter().map(|one| Inputs::new(cycle, one.number)));
        let using: Vec<Inputs> = variants.filter(|inputs| param.is_known(inputs)).collect();
        let one = |all: BTreeSet<&'static str>| all.first().copied().filter(|_| all.len() == 1);
        let known =
            using.iter().filter(|inputs| self.list.when.holds(inputs)).map(|inputs| param.label(inputs)).collect();
        one(known).or_else(|| one(using.iter().map(|inputs| param.label(inputs)).collect())).unwrap_or(param.key)
    }

    /// What else is known of it, a line each.
    pub fn about(&self) -> Vec<Message> {
        let named = |key: &'static str, name: &str| Message::new(key).text("name", name);
        let screen = (!self.screen().is_empty()).then(|| named("argument-screen", self.screen()));
        let older = match self.older() {
            "" => Message::new("argument-no-older"),
            older => named("argument-older", older),
        };
        let known = match (self.evidence(), self.alarm()) {
            (Evidence::Values, _) => Message::new("argument-values"),
            (Evidence::Alarm, Some(alarm)) => Message::new("argument-alarm").number("alarm", f64::from(alarm)),
            _ => Message::new("argument-name-known"),
        };
        let open = self.is_open().then(|| Message::new("argument-open"));
        screen.into_iter().chain([older, known]).chain(open).collect()
    }

    /// The parameter with its meaning: that of the cycle that the list calls, else of another one.
    fn param(&self) -> Option<&'static Param> {
        let name = self.param?;
        let own = CYCLES.iter().filter(|cycle| cycle.name == self.list.name);
        own.chain(CYCLES.iter()).find_map(|cycle| cycle.param(name.as_str()))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::catalogue::newer::LISTS;
    use crate::test_data::{data, rows};

    // oracle: self (a row that no list has would be read by nobody; a name of which nothing is said is only a name)
    #[test]
    fn each_row_is_an_argument_of_its_list() {
        for known in ARGUMENTS.iter().filter(|one| !one.name.is_empty()) {
            let mut lists = LISTS.iter().filter(|list| known.list.is_empty() || known.list == list.name);
            let has = |list: &'static ArgumentList| Argument::all(list).any(|one| one.name == known.name);
            assert!(lists.any(has), "{} {}", known.name, known.list);
            let same = ARGUMENTS.iter().filter(|one| one.name == known.name && one.list == known.list);
            assert_eq!(same.count(), 1, "{}", known.name);
        }
    }

    // oracle: self (a value without a name could be neither told nor changed)
    #[test]
    fn each_argument_has_a_name_or_its_place() {
        for argument in LISTS.iter().flat_map(Argument::all) {
            let own = if argument.name.is_empty() { argument.place.to_string() } else { argument.name.to_owned() };
            assert_eq!(argument.key(), own, "{}", argument.list.name);
        }
    }

    // oracle: peer, tests/data/newer_calls.tsv (calls that machine users and generators publish)
    #[test]
    fn what_is_known_from_programs_stands_in_one() {
        let calls = rows(data!("newer_calls.tsv"));
        let given = |argument: &Argument| {
            let of_cycle = calls.iter().filter(|row| row[0] == argument.list.name);
            let mut texts = of_cycle.filter_map(|row| row[1].split(',').nth(argument.place - 1));
            texts.any(|text| !text.is_empty() && text != "\"\"")
        };
        for argument in LISTS.iter().flat_map(Argument::all).filter(|one| one.evidence() == Evidence::Values) {
            assert!(given(&argument), "{} {}", argument.list.name, argument.name);
        }
    }

    // oracle: self (what is published is told of an argument that the list has)
    #[test]
    fn numbers_are_published_of_arguments_of_the_list() {
        for list in &LISTS {
            assert!(list.published.iter().all(|(name, _)| list.has(name)), "{}", list.name);
            assert_eq!(list.published.is_empty(), !list.is_written(), "{}", list.name);
        }
    }

    // oracle: peer (published lists and programs; the digits of S_KNUM1 and of most variants are not published)
    #[test]
    fn what_is_not_published_is_open() {
        let open = |cycle: &str| -> Vec<&'static str> {
            let list = LISTS.iter().find(|list| list.name == cycle).unwrap();
            Argument::all(list).filter(Argument::is_open).map(|one| one.name).collect()
        };
        assert_eq!(open("CYCLE977"), ["S_KNUM1", "S_MCBIT", "_DP"]);
        assert_eq!(open("CYCLE978"), ["S_KNUM1", "S_MCBIT", "_DP"]);
        assert_eq!(open("CYCLE150"), ["S_PICT", "", "S_PROT", "", "S_PATH"]);
        assert_eq!(open("CYCLE982"), ["S_MVAR", "S_KNUM", "S_ID", "S_MCBIT", "_DMODE", "_AMODE", ""]);
    }
}
