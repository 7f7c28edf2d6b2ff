//! The columns of the lines, put together by choosing.

#![allow(clippy::unwrap_used)]

use super::{COLUMN, FILE, OWN_HEADER, SEPARATOR, TITLES, VALUES, typed};
use crate::catalogue::cycle100::CYCLE100;
use crate::control::{Control, delivery};
use crate::dialect::Dialect;
use crate::entry::Columns;
use crate::form::{Entry, fields};
use crate::name::Name;

fn columns(name: Name, changes: &[(Name, &str)], control: &Control) -> Option<Columns> {
    let fields = fields(&CYCLE100, &typed(&CYCLE100, changes), control);
    match fields.into_iter().find(|field| field.name == name)?.entry {
        Entry::Text { columns } => columns,
        _ => None,
    }
}

fn delivered() -> Control {
    delivery(Dialect::Sinumerik)
}

// oracle: manual B:11513-11638 (the sample prints this line; how its blanks stand is told at `Columns::line`)
#[test]
fn chosen_columns_are_the_line_that_the_log_prints() {
    let control = delivered();
    let mut line = String::new();
    for wanted in ["_TXT[0]", "_AXIS", "_OVR[0]", "_OVR[4]", "_OVR[16]", "_TIME"] {
        let now = columns(VALUES[0], &[(VALUES[0], &line)], &control).unwrap();
        let offer = now.offers.iter().find(|offer| offer.text == wanted).unwrap();
        line = format!("{}{}{}", now.before, offer.text, now.after);
    }
    assert_eq!(line, "_TXT[0],_AXIS,_OVR[0],_OVR[4],_OVR[16],_TIME");
    let made = columns(VALUES[0], &[(VALUES[0], &line), (TITLES[1], "\"  \"")], &control).unwrap();
    let printed = "1           , Z          , 80.000     , 79.987     , -0.013     , 09:35:12";
    let dashes = "-".repeat(80);
    let shown: Vec<&str> = made.printed.iter().map(String::as_str).collect();
    assert_eq!(
        shown[0].split_whitespace().collect::<Vec<_>>(),
        ["Date:", "98/11/15", "Time:", "09:35:12", "Page:", "1"]
    );
    let end = [&*dashes, "Meas.,Axis,Set,Act. value,Difference,Time", &*dashes, printed];
    assert_eq!(shown[shown.len() - 4..], end);
    assert_eq!(made.marked, printed.replace("79.987     ", "79.987*    ").replace("-0.013     ", "-0.013*    "));
    let keys: Vec<&str> = made.list.iter().map(|column| &*column.label.key).collect();
    assert_eq!(keys[..2], ["log-column-text", "log-column-axis"]);
    assert!(keys[2].starts_with("result-set") && keys[3].starts_with("result-actual"), "{keys:?}");
    assert!(keys[4].starts_with("result-difference") && keys[5] == "log-column-time", "{keys:?}");
    assert_eq!((made.narrow.len(), &*made.list[1].without), (0, "_TXT[0],_OVR[0],_OVR[4],_OVR[16],_TIME"));
}

// oracle: manual B:11437 (a value wider than its column), B:11355 (separator), B:11338 (header of the user)
#[test]
fn the_preview_has_the_format_of_the_call() {
    let mut control = delivered();
    let line = (VALUES[0], "_OVR[0],_OVR[16],ab");
    control.set("_OVR[0]", 7.5);
    control.set(OWN_HEADER, 1.0);
    let made = columns(VALUES[0], &[line, (COLUMN, "5"), (SEPARATOR, ";")], &control).unwrap();
    assert_eq!(made.printed.last().unwrap(), "7.500;0.000; ab", "the last measurement counts");
    assert!(!made.printed.iter().any(|line| line.starts_with("Date:")), "the header of the user: {:?}", made.printed);
    control.set("_OVR[16]", -0.25);
    let made = columns(VALUES[0], &[line, (COLUMN, "5"), (SEPARATOR, ";")], &control).unwrap();
    assert_eq!(made.printed.last().unwrap(), "7.500;-0.250; ab");
    let narrow: Vec<_> = made.narrow.iter().map(|one| &*one.key).collect();
    assert_eq!(narrow, ["check-log-narrow"]);
    let unknown = columns(VALUES[0], &[(VALUES[0], "_OVI[0],_TIME")], &control).unwrap();
    assert_eq!((unknown.marked.as_str(), &*unknown.list[0].label.key), ("", "log-column-unknown"));
}

// oracle: self (adding and taking away change nothing else), hand (quotes, blanks, expressions)
#[test]
fn what_is_typed_stays() {
    let control = delivered();
    for typed in ["a, b ,_time", "\" ,x \"", ",", "  _OVR[4]", "ä,,ö"] {
        let now = columns(VALUES[0], &[(VALUES[0], typed)], &control).unwrap();
        let added = format!("{}_TIME{}", now.before, now.after);
        let again = columns(VALUES[0], &[(VALUES[0], &added)], &control).unwrap();
        assert_eq!(again.list.len(), now.list.len() + 1, "{typed}");
        assert_eq!(again.list.last().unwrap().without, typed, "{typed}");
    }
    for (empty, added) in [("", "x"), ("\"\"", "\"x\""), ("x,y", "x,y,x")] {
        let now = columns(TITLES[0], &[(TITLES[0], empty)], &control).unwrap();
        assert_eq!(format!("{}x{}", now.before, now.after), added);
    }
    assert_eq!(columns(VALUES[0], &[(VALUES[0], "\"_OVR[\"<<R1<<\"]\"")], &control), None);
    assert_eq!(columns(FILE, &[], &control), None);
}
