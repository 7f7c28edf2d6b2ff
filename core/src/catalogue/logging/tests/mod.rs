//! What the cycles of the log refuse, how they are written and read.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod columns;
mod in_a_run;
mod marked;

use super::OWN_HEADER;
use super::names::*;
use crate::catalogue::cycle100::CYCLE100;
use crate::catalogue::cycle105::CYCLE105;
use crate::catalogue::cycle106::CYCLE106;
use crate::catalogue::cycle113::CYCLE113;
use crate::catalogue::cycle118::CYCLE118;
use crate::catalogue::example::example;
use crate::check::check;
use crate::control::delivery;
use crate::diagnostic::Code;
use crate::dialect::Dialect;
use crate::entry::{Cycle, Style, Typed};
use crate::name::Name;
use crate::own;
use crate::program::calls::calls;
use crate::program::change::{apply, change};
use crate::program::write::snippet;
use crate::syntax::read;

fn typed(cycle: &'static Cycle, changes: &[(Name, &str)]) -> Typed {
    let mut typed = example(cycle, &cycle.variants[0]);
    let pair = |(name, value): &(Name, &str)| (name.to_string(), (*value).to_owned());
    typed.extend(changes.iter().map(pair));
    typed
}

fn found(cycle: &'static Cycle, changes: &[(Name, &str)]) -> Vec<(Code, Option<Name>)> {
    let control = delivery(Dialect::Sinumerik);
    let found = check(cycle, &typed(cycle, changes), &control).diagnostics;
    found.iter().map(|one| (one.code, one.param)).collect()
}

// oracle: manual A:15914, A:15945 (61370, 62308: the titles are there, whoever prints the header), B:11437 (widths)
#[test]
fn titles_count_with_an_own_header_too() {
    let mut control = delivery(Dialect::Sinumerik);
    control.set(OWN_HEADER, 1.0);
    for (changes, told) in [
        (vec![(COLUMN, "0")], false),
        (vec![(COLUMN, "0"), (TITLES[0], "")], true),
        (vec![(VALUE_LINES, "0")], false),
        (vec![(VALUE_LINES, "0"), (TITLES[0], ""), (TITLES[1], ""), (VALUES[0], "")], true),
    ] {
        let found = check(&CYCLE105, &typed(&CYCLE105, &changes), &control).diagnostics;
        let refused = found.iter().any(|one| matches!(one.code, Code::Alarm(61370 | 62308)));
        assert_eq!(refused, told, "{changes:?} {found:?}");
    }
}

// oracle: manual B:11192 (name), A:15903-15948 (alarms), B:11437 (widths)
#[test]
fn what_a_log_cannot_be_is_told() {
    let alarm = Code::Alarm;
    assert_eq!(found(&CYCLE100, &[]), []);
    assert_eq!(found(&CYCLE100, &[(FILE, "")]), [(alarm(61354), Some(FILE))]);
    for (name, number) in
        [("1LOG", 61352), ("L", 61352), ("L1", 61352), ("MY-LOG", 61352), ("LOG.MPF", 61355), ("LOG_SPF", 61355)]
    {
        assert_eq!(found(&CYCLE100, &[(FILE, name)]), [(alarm(number), Some(FILE))], "{name}");
    }
    let wide = "_OVR[0],_OVR[1],_OVR[2],_OVR[3],_OVR[4],_OVR[5],_OVR[6]";
    for (changes, expected) in [
        (vec![(LINE, "201")], (alarm(62310), LINE)),
        (vec![(VALUE_LINES, "5")], (alarm(61363), VALUE_LINES)),
        (vec![(VALUES[0], "_OVI[0]")], (alarm(61361), VALUES[0])),
        (vec![(VALUES[0], wide)], (alarm(62307), VALUES[0])),
        (vec![(VALUES[0], wide), (COLUMN, "29")], (alarm(61371), VALUES[0])),
        (vec![(COLUMN, "7")], (alarm(62309), VALUES[0])), // the time has eight characters
        (vec![(COLUMN, "0"), (TITLES[0], "")], (alarm(62308), COLUMN)),
        (vec![(COLUMN, "0")], (alarm(62309), VALUES[0])), // the title "Time" is narrower
        (vec![(TITLES[0], ""), (TITLES[1], ""), (VALUES[0], "")], (alarm(61370), VALUES[0])),
    ] {
        let (code, at) = expected;
        assert_eq!(found(&CYCLE100, &changes), [(code, Some(at))], "{changes:?}");
    }
}

// oracle: manual B:11239-11251, A:15902 (61360: a job that CYCLE106 does not know)
#[test]
fn header_and_values_have_their_numbers() {
    assert_eq!(found(&CYCLE105, &[(JOB, "1")]), []);
    assert_eq!(found(&CYCLE105, &[(JOB, "2")]), [(own::RANGE.code(), Some(JOB))]);
    assert_eq!(found(&CYCLE106, &[(JOB, "2")]), []);
    assert_eq!(found(&CYCLE106, &[(JOB, "0")]), [(Code::Alarm(61360), Some(JOB))]);
    assert_eq!(
        found(&CYCLE118, &[(Name::new("PAR4"), "11"), (Name::new("PAR5"), "1")]),
        [(Code::Alarm(61362), Some(Name::new("PAR4")))]
    );
    assert_eq!(found(&CYCLE118, &[(Name::new("PAR4"), "3")]), [(own::MISSING.code(), Some(Name::new("PAR5")))]);
}

// oracle: hand (what the machine has counts where nothing is written)
#[test]
fn data_of_the_machine_count() {
    let mut control = delivery(Dialect::Sinumerik);
    let typed = typed(&CYCLE100, &[(FILE, ""), (COLUMN, "")]);
    control.data.insert(FILE.into(), crate::control::Value::Text("LOG".into()));
    control.set(COLUMN, 7.0);
    let found = check(&CYCLE100, &typed, &control);
    let codes: Vec<Code> = found.diagnostics.iter().map(|one| one.code).collect();
    assert_eq!(codes, [Code::Alarm(62309)]);
    assert_eq!(found.inputs.unwrap().text(FILE), "LOG");
}

// oracle: manual B:11513-11600 (the sample program), B:11404 (blanks in a title line)
#[test]
fn texts_of_a_program_are_read_as_they_stand() {
    let text = "DEF INT PARTNUM\n_PROTNAME[1]=\"LOG_1\" _PROTVAL[1]=\"  \"\n\
        _HEADLINE[0]=\"Part number: \"<<PARTNUM\n_PROTVAL[2]=\"_TXT[0],_AXIS,_TIME\"\nCYCLE100\n";
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let site = &calls(&program)[0];
    assert_eq!(site.values[TITLES[1].as_str()], "\"  \"");
    assert_eq!(site.values[HEADLINES[0].as_str()], "\"Part number: \"<<PARTNUM");
    let codes: Vec<Code> = site.diagnostics.iter().map(|one| one.code).collect();
    assert_eq!(codes, [Code::Own(3)], "known at run time only");
    let changed = |name, value| {
        let edits = change(&program, site, name, value);
        String::from_utf8(apply(text.as_bytes(), &edits)).unwrap()
    };
    assert_eq!(changed(FILE.as_str(), "LOG_2"), text.replace("LOG_1", "LOG_2"));
    assert_eq!(changed(TITLES[1].as_str(), "\" \""), text.replace("\"  \"", "\" \""));
    assert_eq!(changed(FILE.as_str(), "\"L_\"<<R1"), text.replace("\"LOG_1\"", "\"L_\"<<R1"));
    assert_eq!(changed(HEADLINES[0].as_str(), "Part 7"), text.replace("\"Part number: \"<<PARTNUM", "\"Part 7\""));
    let control = delivery(Dialect::Sinumerik);
    let written = snippet(&CYCLE100, &site.values, &control, Style::Direct, None).text;
    let again = calls(&read(Dialect::Sinumerik, written.as_bytes()));
    assert_eq!(again[0].values, site.values, "{written}");
}

// oracle: manual B:11241, B:11217 (CYCLE105 takes its contents from data)
#[test]
fn an_argument_and_data_make_one_call() {
    let text = "_PROTVAL[2]=\"_OVR[4]\"\nCYCLE105(0)\n_PROTVAL[2]=\"R27\"\nCYCLE105(0)\n";
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let sites = calls(&program);
    let shown: Vec<_> =
        sites.iter().map(|one| (&*one.values[VALUES[0].as_str()], &*one.values[JOB.as_str()])).collect();
    assert_eq!(shown, [("_OVR[4]", "0"), ("R27", "0")]);
    assert_eq!((sites[1].first_line, sites[1].line), (2, 3));
}

// oracle: manual B:11296-11320 (both examples; the second one as A:12644-12650 has it)
#[test]
fn one_number_or_several() {
    let text = "DEF STRING[12] TEXTVAR\nCYCLE118(31.83,2,TEXTVAR)\nCYCLE118(0,_DIGIT,TEXTVAR,3,11)\n";
    let sites = calls(&read(Dialect::Sinumerik, text.as_bytes()));
    let values = |index: usize| -> Vec<(&str, &str)> {
        let values = sites[index].values.iter();
        values.map(|(name, value)| (name.as_str(), value.as_str())).collect()
    };
    assert_eq!(values(0), [("PAR1", "31.83"), ("PAR2", "2")]);
    let several = [("PAR1", "0"), ("PAR2", "_DIGIT"), ("PAR4", "3"), ("PAR5", "11")];
    assert_eq!(values(1), several);
}

// oracle: manual B:11258-11260 (eight characters in a variable of ten), B:11296-11308 (31.830988618 becomes 31.83)
#[test]
fn texts_are_drawn_in_their_variables() {
    let written = |cycle: &'static Cycle, changes: &[(Name, &str)]| {
        let control = delivery(cycle.dialect);
        let picture = crate::form::draw(cycle, &typed(cycle, changes), &control).unwrap();
        let cells = picture.shapes.into_iter();
        let texts = cells.filter_map(|shape| shape.text).collect::<Vec<_>>();
        texts.concat()
    };
    assert_eq!(written(&CYCLE113, &[]), "06/12/31");
    assert_eq!(written(&CYCLE113, &[(JOB, "2")]), "23:59:00");
    assert_eq!(written(&CYCLE118, &[]), "31.8331.830988618PAR2");
    let many = written(&CYCLE118, &[(Name::new("PAR4"), "2"), (Name::new("PAR5"), "11")]);
    assert_eq!(many, "R110.00_TXT[0]R120.00_TXT[1]PAR2");
}
