//! What any call on any machine can be told has words and everything that they name.

use probewright_core::catalogue::CYCLES;
use probewright_core::catalogue::example::worked;
use probewright_core::check::check;
use probewright_core::check::newer::check_listed;
use probewright_core::control::{Control, Edge, Frame, Plane, delivery};
use probewright_core::diagnostic::{Diagnostic, Severity};
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, Kind, Style, Typed};
use probewright_core::form::machine::{Entry, Setting, groups};
use probewright_core::geometry::Rpy;
use probewright_core::message::Message;
use probewright_core::words::{LANGUAGES, Words};
use proptest::collection;
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::RngSeed;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

/// What may be typed for a parameter.
const VALUES: &[&str] = &[
    "", "0", "1", "-1", "3", "20", "132", "-132", "0,5", "1,2,3", "1e9", "1e308", "-1e308", "1.5e", "NaN", "inf", "٣",
    "R1", "R1+", "30", "90", "-45", "101", "1001", "1105", "2001", "9999", "1000000", "399999999", "102001", "1002001",
    "2000", "1011", "12x", "\"", "A\nB", "360", "1e-9",
];

/// Values of the machine's data that are no choices of a list.
const DATA: &[f64] = &[-1.0, 0.0, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 50.0, 101.0, 201.0];

/// Types of the tool in use: none, milling tool, drill, grinding tool, turning tools, probe, and one that is driven.
const TOOLS: &[i64] = &[0, 120, 200, 400, 500, 580, 710, 720];

/// Values of a call and of the machine.
#[derive(Debug, Clone)]
struct Drawn {
    values: Vec<usize>,
    data: Vec<usize>,
    /// One in so many values of the worked example, and of the machine's data, is another one.
    one_in: [usize; 2],
    /// Tool in use: type; length and radius, mm; tip.
    tool: (i64, f64, f64, i64),
    plane: Plane,
    /// The frame that is active.
    frame: Frame,
    /// Speed, 1/min, and whether it can be positioned.
    spindle: (f64, bool),
}

prop_compose! {
    fn drawn()(
        values in collection::vec(0..1_000_000_usize, 40),
        data in collection::vec(0..1_000_000_usize, 500),
        one_in in [select(vec![1, 3, 20]), select(vec![2, 3, 100])],
        tool in (select(TOOLS), select(&[0.0, 60.0][..]), select(&[-1.0, 0.0, 3.0, 30.0][..]), 0..10_i64),
        plane in select(Plane::ALL.to_vec()),
        turned in select(vec![[0.0; 3], [0.0, 0.0, 30.0], [20.0, 0.0, 0.0]]),
        mirror in select(vec![[false; 3], [true, false, false]]),
        spindle in (select(vec![0.0, 500.0]), any::<bool>()),
    ) -> Drawn {
        let frame = Frame { rotation: Rpy(turned), mirror, ..Frame::default() };
        Drawn { values, data, one_in, tool, plane, frame, spindle }
    }
}

/// What is drawn instead with this number, where one in so many values is another one.
fn other(number: usize, one_in: usize) -> Option<usize> {
    number.is_multiple_of(one_in).then_some(number / one_in)
}

impl Drawn {
    /// A machine with these settings, whose draws begin here.
    fn machine(&self, dialect: Dialect, settings: &[Setting], begin: usize) -> Control {
        let mut control = delivery(dialect);
        for (setting, number) in settings.iter().zip(self.data.iter().cycle().skip(begin)) {
            let Some(pick) = other(*number, self.one_in[1]) else { continue };
            match setting.entry {
                Entry::Choice { choices } if pick % 5 > 0 => {
                    control.set(&setting.name, choices[pick / 5 % choices.len()] as f64);
                }
                Entry::Text => {}
                _ => control.set(&setting.name, DATA[pick / 5 % DATA.len()]),
            }
        }
        let (kind, length, radius, tip) = self.tool;
        let edge = Edge { kind, length: [length; 3], radius, tip, ..Edge::default() };
        control.tools.entry(1).or_default().edges.insert(1, edge);
        (control.tool, control.edge) = (1, 1);
        control.plane = self.plane;
        control.active = self.frame;
        (control.spindle_speed, control.spindle_positions) = self.spindle;
        control
    }

    /// The worked example with other values, whose draws begin here.
    fn call(&self, cycle: &'static Cycle, variant: i64, begin: usize) -> Typed {
        let mut typed = worked(cycle);
        for (param, number) in cycle.params.iter().zip(self.values.iter().cycle().skip(begin)) {
            let text = match (&param.kind, other(*number, self.one_in[0])) {
                (Kind::Variant(_), _) if number % 50 > 0 => variant.to_string(),
                (_, Some(pick)) => VALUES[pick % VALUES.len()].to_owned(),
                _ => continue,
            };
            typed.insert(param.name.to_string(), text);
        }
        typed
    }
}

/// What a check says of these values, as a call of its own and in the list of a newer control.
fn told_of(cycle: &'static Cycle, typed: &Typed, control: &Control) -> Vec<Diagnostic> {
    let newer = cycle.lists.iter().filter(|list| list.style == Style::Operate);
    let newer = newer.flat_map(|list| check_listed(cycle, list, typed, control).diagnostics);
    check(cycle, typed, control).diagnostics.into_iter().chain(newer).collect()
}

/// The arguments that each English text asks for, by its key.
fn arguments() -> BTreeMap<&'static str, BTreeSet<&'static str>> {
    let english = LANGUAGES.iter().find(|language| language.code == "en").unwrap();
    let mut asked: BTreeMap<_, BTreeSet<_>> = BTreeMap::new();
    let mut key = "";
    for line in english.files.iter().flat_map(|(_, text)| text.lines()) {
        match line.split_once(" =") {
            Some((begun, _)) if !line.starts_with([' ', '#']) => key = begun,
            _ => {}
        }
        let placeables = line.split('{').skip(1).filter_map(|rest| rest.trim_start().strip_prefix('$'));
        let names = placeables.filter_map(|rest| rest.split([' ', '}', '-']).next());
        asked.entry(key).or_default().extend(names);
    }
    asked
}

/// Why a message cannot be shown: no words, an argument that is missing, something that does not belong on a line.
fn wrong(words: &Words, message: &Message, asked: &BTreeMap<&str, BTreeSet<&str>>) -> Option<String> {
    let Some(text) = words.find(message) else { return Some(format!("{} has no words", message.key)) };
    let given: BTreeSet<&str> = message.args.iter().map(|(name, _)| *name).collect();
    let missing: Vec<_> = asked[&*message.key].difference(&given).collect();
    let shown = missing.is_empty() && !text.contains("{$") && !text.chars().any(char::is_control);
    (!shown).then(|| format!("{} lacks {missing:?}: {text}", message.key))
}

/// What is set on a machine with a control of this make.
fn settings(dialect: Dialect) -> Vec<Setting> {
    groups(&delivery(dialect)).into_iter().flat_map(|group| group.settings).collect()
}

/// `PROBEWRIGHT_SEED` draws others.
fn seed() -> RngSeed {
    let told = std::env::var("PROBEWRIGHT_SEED").ok();
    RngSeed::Fixed(told.and_then(|text| text.parse().ok()).unwrap_or(1))
}

// oracle: self (a missing argument or word would show its name; every language asks for the arguments of English)
#[test]
fn every_finding_has_all_its_words() {
    let (words, asked) = (Words::english(), arguments());
    let (sinumerik, nct) = (settings(Dialect::Sinumerik), settings(Dialect::Nct));
    let variants = || CYCLES.iter().flat_map(|cycle| cycle.variants.iter().map(move |one| (*cycle, one.number)));
    let seen = RefCell::new(BTreeSet::new());
    let config = ProptestConfig { rng_seed: seed(), failure_persistence: None, ..ProptestConfig::with_cases(60) };
    proptest!(config, |(drawn in drawn())| {
        for (begin, (cycle, variant)) in variants().enumerate() {
            let settings = if cycle.dialect == Dialect::Nct { &nct } else { &sinumerik };
            let control = drawn.machine(cycle.dialect, settings, begin);
            for finding in told_of(cycle, &drawn.call(cycle, variant, begin), &control) {
                for message in std::iter::once(&finding.message).chain(&finding.hint) {
                    let wrong = wrong(&words, message, &asked);
                    prop_assert!(wrong.is_none(), "{} {}: {:?}", cycle.name, variant, wrong);
                    seen.borrow_mut().insert(message.key.to_string());
                }
                prop_assert!(finding.hint.is_some() || finding.severity == Severity::Note, "{:?}", finding.message);
            }
        }
    });
    let seen = seen.into_inner();
    let wanted = ["check-compensation-inside-hint", "check-cm-direction", "check-offset-large"];
    assert!(wanted.iter().all(|key| seen.contains(*key)) && seen.len() > 300, "{} {seen:?}", seen.len());
}
