//! What a control exports, read line by line: machine data of a start-up file or an archive
//! (`N18118 $MN_MM_NUM_GUD_MODULES=7`, below `CHANDATA(2)` those of the second channel), definition files
//! (`DEF NCK REAL _TP[2,10]=(…)`), values of user data, and lines that somebody typed (`MD18118 = 7`). Any text can be
//! read; what no check asks for is counted.

use super::words::{Scan, Token};
use crate::control::definitions::First;
use crate::control::gud::{Gud, Kind};
use crate::control::machine_data::{MACHINE_DATA, MachineDatum};
use crate::control::{Value, arrays, gud, setting_data};
use std::collections::{BTreeMap, BTreeSet};

/// Most elements of an array in a definition.
const ELEMENTS: usize = 10_000;
/// Names of the geometry axes, of which there are three (A:15878, B:14084-14093).
pub const GEOMETRY_NAMES: &str = "MD20060";
const AXES: usize = 3;
/// Signs of the log.
const SIGNS: &str = "_PROTSYM";
/// Highest number of a channel that is told from others; a control has ten.
const CHANNELS: u32 = 99;

/// Where a value stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// Which of the files.
    pub file: usize,
    /// Line, from 1.
    pub line: u32,
}

/// A value that a file gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// The value.
    pub value: Value,
    /// Where.
    pub place: Place,
    /// By a definition, which an assignment changes whatever the order of the files.
    pub defined: bool,
    /// The name of a machine datum as its control wrote it, `N28040 $MC_MM_LUD_VALUES_MEM`; empty: it did not. Names
    /// differ between versions, and a control reads its own only.
    pub spelled: String,
}

/// Values of an array in a definition: elements behind a list that is shorter than the array, or without one, are 0
/// (B:14228-14234).
#[derive(Clone, Debug)]
struct List {
    sizes: Vec<usize>,
    count: usize,
    zero: Given,
}

/// A line that says something that does not go together with another, or that cannot be read.
#[derive(Clone, Debug, PartialEq)]
pub struct Odd {
    /// The datum.
    pub name: String,
    /// Channel; 0: none is said.
    pub channel: u32,
    /// Where.
    pub place: Place,
    /// What it says, and the value of before where there was another.
    pub texts: [String; 2],
}

/// Everything that the files give.
#[derive(Clone, Debug, Default)]
pub struct Exported {
    /// By name (`MD18118`, `MD13200[0]`, `_WP[0,1]`) and channel; 0: a datum of the control, or no channel is said.
    pub data: BTreeMap<(String, u32), Given>,
    /// Sizes of the arrays in definition lines, by name.
    pub sizes: BTreeMap<String, (Vec<usize>, Place)>,
    /// Arrays whose definition is a comment: they are not there (B:13278-13282).
    pub removed: BTreeMap<String, Place>,
    lists: BTreeMap<(String, u32), List>,
    /// Data that are given again with another value; the last one counts.
    pub twice: Vec<Odd>,
    /// Data whose value cannot be read.
    pub unread: Vec<Odd>,
    /// Numbers that are given a text.
    pub texts: Vec<Odd>,
    /// Texts that are given a number.
    pub numbers: Vec<Odd>,
    /// Arrays whose size cannot be read.
    pub unsized_arrays: Vec<Odd>,
    /// Lists with more values than there are elements behind the first one.
    pub beyond: Vec<Odd>,
    /// Data whose number in front is that of another datum.
    pub unlike: Vec<Odd>,
    /// Data that were found by the number in front alone: the manual prints another identifier.
    pub renamed: Vec<Odd>,
    /// Assignments of which no check knows the datum.
    pub others: usize,
    /// Channels of which something is assigned, whether a check knows it or not.
    sections: BTreeSet<u32>,
}

impl Exported {
    /// Reads one more file.
    pub fn add(&mut self, file: usize, text: &str) {
        let mut channel = 0;
        for (line, text) in (1..).zip(text.trim_start_matches('\u{feff}').lines()) {
            let place = Place { file, line };
            if let Some(name) = removed(text) {
                self.remove(name, place);
            }
            Line {
                to: self,
                place,
                channel: &mut channel,
                number: None,
                spelled: String::new(),
                scan: Scan::new(text),
            }
            .read();
        }
    }

    /// Takes an array away, if no line of the same file defines it.
    fn remove(&mut self, name: &str, place: Place) {
        if self.sizes.get(name).is_none_or(|(_, defined)| defined.file != place.file) {
            self.sizes.remove(name);
            self.lists.retain(|(array, _), _| array != name);
            self.removed.insert(name.to_owned(), place);
        }
    }

    /// Elements behind the lists of definitions that no file gives, with the channel of the list.
    pub fn behind_lists(&self) -> impl Iterator<Item = (String, u32, &Given)> {
        let of_list = |((name, channel), list): (&'_ (String, u32), &'_ List)| -> Vec<(String, u32)> {
            let names = arrays::following(name, &list.sizes).skip(list.count);
            names.map(|name| (name, *channel)).filter(|key| !self.data.contains_key(key)).collect()
        };
        let all = self.lists.iter().map(move |(key, list)| (of_list((key, list)), &list.zero));
        all.flat_map(|(names, zero)| names.into_iter().map(move |(name, channel)| (name, channel, zero)))
    }

    /// The channels that see a datum of their own; of a datum of the control 0 alone.
    pub fn seeing(&self, own: bool) -> Vec<u32> {
        if own { self.channels() } else { vec![0] }
    }

    /// A datum as a channel sees it.
    pub fn get(&self, name: &str, channel: u32) -> Option<&Given> {
        let of = |channel| self.data.get(&(name.to_owned(), channel));
        of(channel).or_else(|| of(0)).or_else(|| self.behind_list(name, channel)).or_else(|| self.behind_list(name, 0))
    }

    /// An element behind the list of a definition.
    fn behind_list(&self, name: &str, channel: u32) -> Option<&Given> {
        let (stem, index) = arrays::split(name)?;
        let list = self.lists.get(&(stem.to_owned(), channel))?;
        arrays::place(&index, &list.sizes).filter(|place| *place >= list.count).map(|_| &list.zero)
    }

    /// A number as a channel sees it.
    pub fn number(&self, name: &str, channel: u32) -> Option<f64> {
        match self.get(name, channel)?.value {
            Value::Number(number) => Some(number),
            Value::Text(_) => None,
        }
    }

    /// Channels of which something is assigned; 0 alone: no channel is named.
    pub fn channels(&self) -> Vec<u32> {
        if self.sections.is_empty() { vec![0] } else { self.sections.iter().copied().collect() }
    }

    /// Whether something stands there that says what a datum is, and cannot be read.
    pub fn any_unread(&self) -> bool {
        [&self.unread, &self.texts, &self.numbers, &self.unsized_arrays].iter().any(|odd| !odd.is_empty())
    }
}

/// A line while it is read.
struct Line<'a> {
    to: &'a mut Exported,
    place: Place,
    channel: &'a mut u32,
    /// Number of the machine datum in front: `N18118`.
    number: Option<String>,
    /// The datum as its control wrote it; empty: it did not.
    spelled: String,
    scan: Scan<'a>,
}

impl Line<'_> {
    fn read(&mut self) {
        loop {
            let word = match self.scan.token() {
                Token::End => return,
                Token::Word(word) => word.to_ascii_uppercase(),
                Token::Number(_) | Token::Text(_) | Token::Sign(_) => continue,
            };
            match word.as_str() {
                "DEF" => return self.definition(),
                "CHANDATA" => return self.of_channel(),
                _ if self.number.is_none() && numbered(&word) => self.number = Some(word),
                _ => self.assignment(&word),
            }
        }
    }

    /// `CHANDATA(2)`
    fn of_channel(&mut self) {
        let (_, number) = (self.scan.token(), self.scan.token());
        if let Token::Number(number) = number {
            *self.channel = (number as u32).min(CHANNELS);
        }
    }

    /// `_TP[0,6]=20`, `18118: 7`; a word without a value is none.
    fn assignment(&mut self, word: &str) {
        let before = self.scan;
        let index = self.scan.index();
        let open = index.is_none() && self.scan.rest().starts_with('[');
        if open && gud::find(word).is_some() {
            self.to.unread.push(self.odd(word.to_owned(), before.rest()));
            self.scan.skip_to_comma();
            return;
        }
        if !self.scan.assigns() {
            return;
        }
        if *self.channel > 0 {
            self.to.sections.insert(*self.channel);
        }
        let number = self.number.take();
        self.spelled.clear();
        if gud::find(word).is_some_and(|gud| gud.kind == Kind::Frame) {
            self.to.others += 1; // values of a frame have a notation of their own, and no check asks for them
            return self.scan.skip();
        }
        let digits = number.as_deref().and_then(|number| number.get(1..));
        // a name without its area is none of a machine datum: `N20050 R1=0` is a block of a program
        let Some(datum) = known(word, digits.filter(|_| word.starts_with('$')), index) else {
            self.to.others += 1;
            self.scan.value();
            return;
        };
        if let Some(digits) = digits.filter(|digits| is_of_another(&datum.name, digits)) {
            let texts = [digits.to_owned(), String::new()];
            self.to.unlike.push(Odd { name: datum.name.clone(), channel: *self.channel, place: self.place, texts });
            self.spelled = word.to_owned(); // the control reads the name
        } else if word.starts_with('$') {
            if let Some(identifier) = other_identifier(&datum.name, word) {
                let texts = [word.to_owned(), identifier.to_owned()];
                self.to.renamed.push(Odd {
                    name: datum.name.clone(),
                    channel: *self.channel,
                    place: self.place,
                    texts,
                });
            }
            self.spelled = number.iter().map(String::as_str).chain([word]).collect::<Vec<_>>().join(" ");
        }
        let unnumbered = gud::find(word).is_some() && arrays::split(&datum.name).is_none();
        match self.values(&datum.sizes) {
            Ok(_) if unnumbered => self.to.unread.push(self.odd(word.to_owned(), before.rest())),
            Ok(values) => self.take(&datum, &values, false),
            Err(text) => self.to.unread.push(self.odd(datum.name, &text)),
        }
    }

    /// Gives a datum its values, if these are of its kind.
    fn take(&mut self, datum: &Datum, values: &First, defined: bool) {
        let text = |value: &&Value| matches!(value, Value::Text(_));
        let other = |value: &&Value| datum.holds.is_some_and(|holds| (holds == Holds::Text) != text(value));
        let Some(wrong) = each(values).find(other) else { return self.fill(datum, values, defined) };
        let odd = self.odd(datum.name.clone(), &shown(wrong));
        if text(&wrong) { self.to.texts.push(odd) } else { self.to.numbers.push(odd) }
    }

    /// The next values, for something of these sizes; else what stands there instead, and the line goes on behind it.
    fn values(&mut self, sizes: &[usize]) -> Result<First, String> {
        let before = self.scan;
        let found = self.scan.values().filter(|values| !self.scan.goes_on() && fits(values, sizes));
        found.ok_or_else(|| {
            self.scan = before;
            self.scan.skip();
            before.rest().to_owned()
        })
    }

    /// What this line says and no control can read so.
    fn odd(&self, name: String, text: &str) -> Odd {
        Odd { name, channel: *self.channel, place: self.place, texts: [text.to_owned(), String::new()] }
    }

    /// `DEF NCK REAL _TP[2,10]=(0,0,…)`, several names behind commas.
    fn definition(&mut self) {
        loop {
            match self.scan.token() {
                Token::End => return,
                Token::Word(word) => {
                    let name = word.to_ascii_uppercase();
                    match gud::find(&name) {
                        Some(found) => self.defined(found, name),
                        None => drop(self.scan.index()),
                    }
                }
                Token::Number(_) | Token::Text(_) | Token::Sign(_) => {}
            }
        }
    }

    /// Sizes and values behind a name in a definition.
    fn defined(&mut self, found: &Gud, name: String) {
        let before = self.scan;
        let index = self.scan.index();
        self.spelled.clear();
        self.to.removed.remove(&name);
        let sizes = match index.as_deref() {
            Some(index) => sizes(index),
            None => (!before.rest().starts_with('[')).then(Vec::new),
        };
        let Some(sizes) = sizes else {
            self.to.unsized_arrays.push(self.odd(name, before.rest()));
            if self.scan.assigns() {
                self.scan.skip();
            }
            return self.scan.skip_to_comma();
        };
        self.to.sizes.insert(name.clone(), (sizes.clone(), self.place));
        let values = if self.scan.assigns() { self.values(&sizes) } else { Ok(First::Each(Vec::new())) };
        match values {
            Ok(values) => {
                self.list(found, &sizes, values.count());
                self.take(&Datum { name, sizes, channel: found.channel, holds: holds(found) }, &values, true);
            }
            Err(text) => {
                self.to.unread.push(self.odd(name, &text));
                self.scan.skip_to_comma();
            }
        }
    }

    /// Remembers how far the list of a definition goes.
    fn list(&mut self, gud: &Gud, sizes: &[usize], count: usize) {
        let channel = if gud.channel { *self.channel } else { 0 };
        let value = if gud.text() { Value::Text(String::new()) } else { Value::Number(0.0) };
        let zero = Given { value, place: self.place, defined: true, spelled: String::new() };
        self.to.lists.insert((gud.name.to_owned(), channel), List { sizes: sizes.to_vec(), count, zero });
    }

    /// Remembers that values of a list have no element: of an array whose definition came before in its size.
    fn beyond(&mut self, datum: &Datum, values: &First) {
        let Some(count) = values.counted().filter(|count| *count > 1) else { return };
        let defined = self.to.sizes.get(arrays::stem(&datum.name)).map(|(sizes, _)| sizes);
        let room = arrays::following(&datum.name, defined.unwrap_or(&datum.sizes)).count();
        if count > room {
            let texts = [count, room].map(|count| count.to_string());
            let channel = if datum.channel { *self.channel } else { 0 };
            self.to.beyond.push(Odd { name: datum.name.clone(), channel, place: self.place, texts });
        }
    }

    /// Gives a datum, or the elements of an array from this one on, their values.
    fn fill(&mut self, datum: &Datum, values: &First, defined: bool) {
        self.beyond(datum, values);
        let alone = datum.sizes.is_empty() || of_one(values) && datum.name.contains('[');
        let names = match alone {
            true => vec![datum.name.clone()],
            false => arrays::following(&datum.name, &datum.sizes).take(values.count()).collect(),
        };
        for (at, name) in names.into_iter().enumerate() {
            if let Some(value) = values.begins(at) {
                self.give(name, datum.channel, value.clone(), defined);
            }
        }
    }

    fn give(&mut self, name: String, of_channel: bool, value: Value, defined: bool) {
        let channel = if of_channel { *self.channel } else { 0 };
        let given = Given { value, place: self.place, defined, spelled: self.spelled.clone() };
        let key = (name, channel);
        let before = self.to.data.get(&key);
        if before.is_some_and(|before| defined && !before.defined) {
            return; // the program of value assignments runs behind the definitions
        }
        let texts = before.filter(|before| before.defined == defined && before.value != given.value);
        if let Some(before) = texts {
            let texts = [shown(&given.value), shown(&before.value)];
            self.to.twice.push(Odd { name: key.0.clone(), channel, place: self.place, texts });
        }
        self.to.data.insert(key, given);
    }
}

/// The array in a line that was made a comment: `;N13 DEF NCK REAL _KB[3,7]`.
fn removed(text: &str) -> Option<&'static str> {
    let (before, comment) = text.split_once(';')?;
    let mut scan = Scan::new(comment);
    let mut word = || if let Token::Word(word) = scan.token() { Some(word.to_ascii_uppercase()) } else { None };
    let first = word()?;
    let begins = before.trim().is_empty() || numbered(&before.trim().to_ascii_uppercase());
    if !begins || first != "DEF" && !(numbered(&first) && word()? == "DEF") {
        return None;
    }
    (0..3).find_map(|_| gud::find(&word()?)).map(|gud| gud.name)
}

/// Whether it is one value, not several for an array.
fn of_one(values: &First) -> bool {
    matches!(values, First::Each(values) if values.len() < 2)
}

/// Whether a control can hold values in something of these sizes: its largest numbers are those of a mask of 32 bits,
/// and several values need an array.
fn fits(values: &First, sizes: &[usize]) -> bool {
    let possible = |value: &Value| !matches!(value, Value::Number(number) if number.abs() > f64::from(u32::MAX));
    each(values).all(possible) && (!sizes.is_empty() || of_one(values))
}

/// The values that are written.
fn each(values: &First) -> impl Iterator<Item = &Value> {
    let (list, one) = match values {
        First::Each(values) => (values.as_slice(), None),
        First::Same(value, _) => ([].as_slice(), Some(value)),
    };
    list.iter().flatten().chain(one)
}

/// What a datum holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Holds {
    Number,
    Text,
}

/// What a user datum holds; none: either. The two signs of the log are CHAR (B:13165), which takes a code too.
fn holds(gud: &Gud) -> Option<Holds> {
    match gud.kind {
        Kind::Frame => None,
        Kind::Text if gud.name == SIGNS => None,
        Kind::Text => Some(Holds::Text),
        Kind::Real | Kind::Integer | Kind::Bool => Some(Holds::Number),
    }
}

/// Whether a number of a block is that of another machine datum than the one that is named: the control reads the name.
fn is_of_another(name: &str, digits: &str) -> bool {
    let of = |digits: &str| MACHINE_DATA.iter().find(|datum| datum.number.get(2..) == Some(digits));
    of(digits).is_some_and(|datum| datum.number != arrays::stem(name) && name.starts_with("MD"))
}

/// The identifier of a machine datum in the manual, where a name with its area, `$MN_SOMETHING_ELSE`, is another.
fn other_identifier(name: &str, word: &str) -> Option<&'static str> {
    let datum = MACHINE_DATA.iter().find(|datum| datum.number == arrays::stem(name))?;
    (!datum.identifier.is_empty() && plain(word) != datum.identifier).then_some(datum.identifier)
}

/// The identifier in a name with its area: `MM_NUM_GUD_MODULES` of `$MN_MM_NUM_GUD_MODULES`.
fn plain(name: &str) -> &str {
    name.strip_prefix('$').and_then(|name| name.split_once('_')).map_or(name, |(_, plain)| plain)
}

/// A value as it is shown.
pub fn shown(value: &Value) -> String {
    match value {
        Value::Number(number) => number.to_string(),
        Value::Text(text) => format!("\"{text}\""),
    }
}

/// A datum that a check knows.
struct Datum {
    name: String,
    /// Sizes of the array that it is; empty: a single value.
    sizes: Vec<usize>,
    channel: bool,
    /// What its values have to be; none: either a number or a text.
    holds: Option<Holds>,
}

fn numbered(word: &str) -> bool {
    let digits = word.strip_prefix('N').unwrap_or_default();
    !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit())
}

/// Sizes of an array in a definition; none: they are no numbers, or too large.
fn sizes(index: &str) -> Option<Vec<usize>> {
    let sizes: Vec<usize> = index.split(',').map(|one| one.trim().parse().ok()).collect::<Option<_>>()?;
    let count = sizes.iter().try_fold(1_usize, |count, size| count.checked_mul(*size))?;
    (count <= ELEMENTS).then_some(sizes)
}

/// The datum with this name in upper case, known by its number where the name is not printed in the manual.
fn known(name: &str, number: Option<&str>, index: Option<String>) -> Option<Datum> {
    let index = index.map_or(String::new(), |index| format!("[{index}]"));
    if let Some(gud) = gud::find(name) {
        let (name, sizes) = (format!("{name}{index}"), gud.sizes.to_vec());
        return Some(Datum { name, sizes, channel: gud.channel, holds: holds(gud) });
    }
    if let Some(datum) = number.and_then(setting_data::find).or_else(|| setting_data::find(name)) {
        let name = format!("{}{index}", datum.name());
        return Some(Datum { name, sizes: Vec::new(), channel: datum.of_channel(), holds: Some(Holds::Number) });
    }
    let datum = machine_datum(name, number)?;
    let sizes = match datum.elements {
        0 if datum.number == GEOMETRY_NAMES => vec![AXES],
        0 => Vec::new(),
        elements => vec![elements],
    };
    let holds = Some(if datum.text { Holds::Text } else { Holds::Number });
    Some(Datum { name: format!("{}{index}", datum.number), sizes, channel: of_channel(datum), holds })
}

/// Whether every channel has its own: machine data 20000 to 29999, setting data 42000 to 42999.
pub fn of_channel(datum: &MachineDatum) -> bool {
    let digits = datum.number.get(2..).unwrap_or_default();
    matches!(digits.parse(), Ok(20_000..30_000 | 42_000..43_000))
}

fn machine_datum(name: &str, number: Option<&str>) -> Option<&'static MachineDatum> {
    let plain = plain(name);
    let digits = number.or_else(|| name.strip_prefix("MD").or_else(|| name.strip_prefix("SD"))).unwrap_or(name);
    let of_number = |datum: &&MachineDatum| datum.number.get(2..) == Some(digits);
    let of_name = |datum: &&MachineDatum| !datum.identifier.is_empty() && datum.identifier == plain;
    MACHINE_DATA.iter().find(of_name).or_else(|| MACHINE_DATA.iter().find(of_number))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use proptest::prelude::*;

    fn read(text: &str) -> Exported {
        let mut read = Exported::default();
        read.add(0, text);
        read
    }

    fn number(text: &str, name: &str) -> Option<f64> {
        read(text).number(name, 0)
    }

    // oracle: hand
    #[test]
    fn machine_data_are_read_however_they_are_written() {
        for text in [
            "N18118 $MN_MM_NUM_GUD_MODULES=7",
            "N18118 $MM_NUM_GUD_MODULES = 7 '1a2b",
            "$MN_MM_NUM_GUD_MODULES=7 ;delivered",
            "MD18118 = 7",
            "MD18118=7",
            "18118: 7",
            "md18118=7",
            "MM_NUM_GUD_MODULES=7.0",
            "\u{feff}N18118 $MN_SOMETHING_ELSE='H07'",
            "MD 18118 = 7",
            "MD18118 := 7",
            "MD18118 'B111'\nMD18118=7",
        ] {
            assert_eq!(number(text, "MD18118"), Some(7.0), "{text}");
        }
        for text in ["", "; MD18118=7", "MD18118", "MD18118=", "MD18118=seven", "18118", "MD181181=7"] {
            assert_eq!(number(text, "MD18118"), None, "{text}");
        }
        assert_eq!(number("N28082 $MC_MM_SYSTEM_FRAME_MASK='H21'", "MD28082"), Some(33.0));
        assert_eq!(number("MD20110=4045H", "MD20110"), Some(16453.0));
        assert_eq!(number("N13200 $MN_MEAS_PROBE_LOW_ACTIVE[1]=TRUE", "MD13200[1]"), Some(1.0));
        assert_eq!(number("N32300 $MA_MAX_AX_ACCEL[X1]=1.5", "MD32300[X1]"), Some(1.5));
        assert_eq!(read("MD18118=seven").unread.len(), 1);
        for text in ["MD 18120 = 12,5", "MD18120=99999999999999999999", "MD18150=1e99", "_SPEED[1]=12,5"] {
            let read = read(text);
            assert_eq!((read.unread.len(), read.data.len()), (1, 0), "{text}");
        }
        let several = read("MD18120=30,18130=100, MD18118=7\nMD20110='HFFFFFFFF'");
        assert_eq!((several.unread.len(), several.data.len()), (0, 4));
        let unlike = |text: &str| read(text).unlike.into_iter().map(|odd| odd.name).collect::<Vec<_>>();
        assert_eq!(unlike("N18130 $MN_MM_NUM_GUD_NAMES_NCK=15"), ["MD18120"]);
        assert_eq!(unlike("N18120 $MN_MM_NUM_GUD_NAMES_NCK=15\nN10 $MN_MM_NUM_GUD_NAMES_NCK=15"), [""; 0]);
        let renamed = |text: &str| read(text).renamed.into_iter().map(|odd| odd.texts[1].clone()).collect::<Vec<_>>();
        assert_eq!(renamed("N18120 $MN_SOMETHING_ELSE=30"), ["MM_NUM_GUD_NAMES_NCK"]);
        for text in ["N18120 $MN_MM_NUM_GUD_NAMES_NCK=30", "MD18120=30", "$MM_NUM_GUD_MODULES=7"] {
            assert_eq!(renamed(text), [""; 0], "{text}");
        }
        assert_eq!(read("N10000 $MN_AXCONF_MACHAX_NAME_TAB[0]=\"X1\"").others, 1);
    }

    // oracle: hand (the same line with blanks where somebody types them)
    #[test]
    fn blanks_do_not_hide_a_datum() {
        for (text, name) in [
            ("MD 20050[2] = 0", "MD20050[2]"),
            ("MD 20050 [2]=0", "MD20050[2]"),
            ("20050[2]=0", "MD20050[2]"),
            ("MD20050[ 2 ] : 0", "MD20050[2]"),
            ("MD 13200 [0] = FALSE", "MD13200[0]"),
            ("N20050 $MC_AXCONF_GEOAX_ASSIGN_TAB [\t2 ] =0", "MD20050[2]"),
            ("_TP [ 0 ,\t9 ] = 0", "_TP[0,9]"),
            ("MD 32200[ 0, X1 ]=0", "MD32200[0,X1]"),
            ("MD18120=30, 20050[2] = 0", "MD20050[2]"),
        ] {
            assert_eq!(number(text, name), Some(0.0), "{text}");
        }
        assert_eq!(read("_TP [ 0, 9 ]").data.len(), 0);
    }

    // oracle: hand (`==` compares; a block number is none of a machine datum unless its name stands behind it)
    #[test]
    fn what_is_compared_is_not_assigned() {
        for text in [
            "IF _CHBIT[2]==0 GOTOF A", "IF (_CBIT[0] == TRUE)", "IF 18118==7", "IF _SPEED[1]<=5 GOTOF A",
            "IF _SPEED[1]<>5", "IF _CBIT[R[1]]==0 GOTOF A", "N20050 R1=0",
        ] {
            let read = read(text);
            assert_eq!((read.data.len(), read.unread.len()), (0, 0), "{text}");
        }
        let told = read("_CBIT[R[1]]=0\n_SPEED[0]=_SPEED[1]==0");
        assert_eq!((told.data.len(), told.unread.len()), (0, 2));
    }

    // oracle: hand
    #[test]
    fn each_channel_has_its_own() {
        let read =
            read("CHANDATA(1)\nN28082 $MC_A=1\n_CHBIT[2]=0\nCHANDATA(2)\nN28082 $MC_A=2 \nMD18118=7\n_SPEED[1]=5");
        assert_eq!((read.number("MD28082", 1), read.number("MD28082", 2)), (Some(1.0), Some(2.0)));
        assert_eq!((read.number("_CHBIT[2]", 1), read.number("_CHBIT[2]", 2)), (Some(0.0), None));
        assert_eq!((read.number("MD18118", 1), read.number("_SPEED[1]", 2)), (Some(7.0), Some(5.0)));
        assert_eq!(read.channels(), [1, 2]);
    }

    // oracle: manual B:13278-13288 (the changed lines of the example)
    #[test]
    fn definition_files_give_sizes_and_values() {
        let text = "%_N_GUD6_DEF\n;$PATH=/_N_DEF_DIR\nN10 DEF NCK INT _CVAL[4]=(2,2,0,0)\n\
                    N11 DEF NCK REAL _TP[2,10]=(0,0,0,0,0,0,0,133,0,2)\nN12 DEF NCK REAL _WP[2,11]\n\
                    ;N13 DEF NCK REAL _KB[3,7]\nN40 DEF CHAN INT _EVMVNUM[2]=(10,10)\nM17\n";
        let read = read(text);
        assert_eq!(read.sizes.get("_TP").map(|(sizes, _)| sizes.as_slice()), Some([2, 10].as_slice()));
        assert_eq!(read.sizes.get("_WP").map(|(_, place)| place.line), Some(5));
        assert!(!read.sizes.contains_key("_KB"));
        assert_eq!((read.number("_CVAL[1]", 0), read.number("_CVAL[2]", 0)), (Some(2.0), Some(0.0)));
        assert_eq!((read.number("_TP[0,7]", 0), read.number("_TP[1,7]", 0)), (Some(133.0), Some(0.0)));
        assert_eq!((read.number("_TP[2,7]", 0), read.number("_WP[0,1]", 0)), (None, Some(0.0)));
        assert_eq!(read.removed.keys().collect::<Vec<_>>(), ["_KB"]);
        assert_eq!(read.number("_EVMVNUM[1]", 0), Some(10.0));
        let set = self::read("DEF CHAN INT _JM_I[10] = SET(0,1,,17)\nDEF CHAN REAL _MC_MTL[3]=(33.3,33.3,33.3)");
        assert_eq!((set.number("_JM_I[1]", 0), set.number("_JM_I[2]", 0)), (Some(1.0), None));
        assert_eq!((set.number("_JM_I[3]", 0), set.number("_MC_MTL[2]", 0)), (Some(17.0), Some(33.3)));
    }

    // oracle: hand (the tester's lines: each says something that no control reads so, and nothing of it is taken)
    #[test]
    fn a_value_that_cannot_be_read_is_told_wherever_it_stands() {
        for (text, name) in [
            ("DEF CHAN REAL _SPEED[4]=(50,abc,1000,900)", "_SPEED"),
            ("DEF CHAN REAL _SPEED[4]=(50,1000,1.0.0,900)", "_SPEED"),
            ("DEF CHAN REAL _SPEED[4]=(50,1000,0,900", "_SPEED"),
            ("DEF CHAN REAL _SPEED[4]=SET(REP(0,4))", "_SPEED"),
            ("DEF CHAN BOOL _CHBIT[30]=(0,1,1,rep(0))", "_CHBIT"),
            ("DEF NCK INT _CVAL[4]=REP(1,0)", "_CVAL"),
            ("DEF NCK INT _CVAL[4]=REP(_CBIT[0])", "_CVAL"),
            ("DEF NCK INT _DIGIT=4*_CVAL", "_DIGIT"),
            ("DEF NCK INT _DIGIT=4,5", "_DIGIT"),
            ("DEF NCK INT _DIGIT=(4,5)", "_DIGIT"),
            ("DEF NCK INT _DIGIT=", "_DIGIT"),
            ("_CBIT[13]=(abc)", "_CBIT[13]"),
            ("_CBIT[13]=REP(abc)", "_CBIT[13]"),
            ("_CBIT[13=1", "_CBIT"),
            ("_TP[0,3+3]=1", "_TP"),
            ("SD54600[0]=REP(1)", "SD54600[0]"),
        ] {
            let read = read(text);
            let told: Vec<&str> = read.unread.iter().map(|odd| odd.name.as_str()).collect();
            assert_eq!((told, read.data.len(), read.lists.len()), (vec![name], 0, 0), "{text}");
        }
        for text in ["DEF NCK INT _CVAL[2+2]=(2,2,0,0)", "DEF NCK INT _CVAL[4=(2,2,0,0)", "DEF NCK INT _CVAL[]=(2)"] {
            let read = read(text);
            assert_eq!((read.unsized_arrays.len(), read.data.len(), read.sizes.len()), (1, 0, 0), "{text}");
        }
        // what stands behind it counts
        let read = read("DEF NCK INT _CVAL[4]=(a,_DIGIT=5), _DIGIT=3\n_CBIT[0]=(x) _CBIT[1]=1");
        assert_eq!((read.unread.len(), read.data.len()), (2, 2));
        assert_eq!((read.number("_DIGIT", 0), read.number("_CBIT[1]", 0)), (Some(3.0), Some(1.0)));
    }

    // oracle: hand: lists of one value more than elements, from the first one and from a later one; what fits is not
    // told
    #[test]
    fn values_without_an_element_are_told_with_their_line() {
        let read = read(
            "DEF NCK INT _CVAL[4]=(2,2,0,0)\nDEF NCK INT _CVAL[4]=(2,2,0,0,9)\n_CVAL[2]=SET(1,2,3)\n_CVAL[3]=5\n\
             DEF NCK REAL _TP[2,10]\n_TP[1,8]=REP(1)\n_TP[1,8]=REP(1,3)",
        );
        let told: Vec<_> =
            read.beyond.iter().map(|odd| (odd.name.as_str(), odd.place.line, odd.texts.clone())).collect();
        let counts = |values: &str, elements: &str| [values.to_owned(), elements.to_owned()];
        let wanted =
            [("_CVAL", 2, counts("5", "4")), ("_CVAL[2]", 3, counts("3", "2")), ("_TP[1,8]", 7, counts("3", "2"))];
        assert_eq!(told, wanted);
    }

    // oracle: hand (REP fills from the element on to the end of the array, or as many as it says)
    #[test]
    fn one_value_for_many_elements_is_read() {
        let read = read("DEF NCK INT _CVAL[4]=REP(1)\nDEF NCK REAL _TP[2,10]=rep(3,12)\n_CBIT[14]=REP(1,2)");
        assert_eq!((read.unread.len(), read.data.len()), (0, 4 + 12 + 2));
        let numbers = ["_CVAL[3]", "_TP[1,1]", "_TP[1,2]", "_CBIT[15]", "_CBIT[13]"].map(|name| read.number(name, 0));
        assert_eq!(numbers, [Some(1.0), Some(3.0), Some(0.0), Some(1.0), None]);
    }

    /// What a line gives an array of six elements, as the reader of programs reads it; none: it is told.
    fn as_a_program(values: &str) -> Option<Vec<Option<f64>>> {
        let found = crate::syntax::definitions::definitions(format!("DEF NCK REAL OWN[6]={values}").as_bytes());
        let datum = found.definitions.find("OWN")?;
        let number = |at| match datum.begins(at) {
            Some(Value::Number(number)) => Some(*number),
            _ => None,
        };
        Some((0..6).map(number).collect())
    }

    proptest! {
        // oracle: self (both readers of a definition file find the same values, or both tell them)
        #[test]
        fn values_are_read_as_in_a_program(
            list in prop::collection::vec(
                prop::sample::select(vec!["", "1", "-2.5", "TRUE", "abc", "(1", "\"A\""]),
                0..7,
            ),
            form in 0..4_usize,
            closed in prop::bool::weighted(0.9),
        ) {
            let inside = list.join(",");
            let close = if closed { ")" } else { "" };
            let one = list.first().copied().unwrap_or("7");
            let values = match form {
                0 => format!("({inside}{close}"),
                1 => format!("SET({inside}{close}"),
                2 => format!("REP({one}{close}"),
                _ => format!("REP({one},{}{close}", list.len()),
            };
            prop_assume!(!inside.is_empty());
            let read = read(&format!("DEF NCK REAL _MFS[6]={values}"));
            let told = !read.unread.is_empty();
            if !closed {
                prop_assert!(told, "{}", values);
                return Ok(());
            }
            match as_a_program(&values) {
                Some(wanted) => {
                    let datum = |at: usize| read.data.get(&(format!("_MFS[{at}]"), 0));
                    let found: Vec<_> = (0..6).map(|at| datum(at).map(|one| shown(&one.value))).collect();
                    let wanted: Vec<_> = wanted.iter().map(|one| one.map(|number| number.to_string())).collect();
                    prop_assert_eq!((told, found), (false, wanted), "{}", values);
                }
                None => prop_assert!(told || values.contains('"'), "{}", values),
            }
        }
    }

    // oracle: hand
    #[test]
    fn several_in_a_line_and_texts_are_read_and_another_value_is_told() {
        let read = read("N10 _TP[0,6]=20 _TP[1,6]=20 _PROTNAME[0]=\"A=1 ;B\"\nN20 _TP[0,6]=25\nN30 _TP[0,6]=25");
        assert_eq!((read.number("_TP[0,6]", 0), read.number("_TP[1,6]", 0)), (Some(25.0), Some(20.0)));
        assert_eq!(read.get("_PROTNAME[0]", 0).unwrap().value, Value::Text("A=1 ;B".to_owned()));
        let told: Vec<_> = read.twice.iter().map(|odd| (odd.name.as_str(), odd.place.line, &odd.texts[1])).collect();
        assert_eq!(told, [("_TP[0,6]", 2, &"20".to_owned())]);
    }

    proptest! {
        // oracle: self
        #[test]
        fn any_text_is_read(text in any::<String>(), line in "[N$MD_A-Z0-9=\\[\\](),;'\" .:-]{0,80}") {
            for text in [text.clone(), line.clone(), format!("DEF NCK REAL _TP[{line}"), format!("_TP[{line}={text}")] {
                let _ = read(&text);
            }
        }
    }
}
