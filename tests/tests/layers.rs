//! The rooms of the core only look down: what code names by a path stands in its own room or in a lower one. The order
//! is the drawing in ARCHITECTURE.md. What only tests name does not count.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_tests::root;
use probewright_tests::rust::{Found, Sources};
use std::collections::BTreeSet;

/// The rooms from the lowest to the highest: a line of the drawing stands on those below it, and in a line a room on
/// those to its left.
fn rooms() -> Vec<String> {
    let text = std::fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let section = text.split("\n## ").find(|section| section.starts_with("Layers\n")).expect("a section `Layers`");
    let drawing = section.split("```").nth(1).expect("a drawing");
    let lines = drawing.lines().rev().filter_map(|line| line.split_once("  "));
    lines.flat_map(|(_, rooms)| rooms.split_whitespace()).map(str::to_owned).collect()
}

fn core() -> Sources {
    Sources::read(&root().join("core/src/lib.rs")).unwrap()
}

/// Height of the room of a path: the longest name that fits (`program/advice` before `program`).
fn height(rooms: &[String], path: &[String]) -> Option<usize> {
    let fits = |room: &str| room.split('/').eq(path.iter().take(room.split('/').count()));
    let found = rooms.iter().enumerate().filter(|(_, room)| fits(room));
    found.max_by_key(|(_, room)| room.len()).map(|(height, _)| height)
}

/// What is wrong with a path, in a line.
fn fault(one: &Found, rooms: &[String], root_items: &BTreeSet<String>) -> Option<String> {
    let from = height(rooms, &one.module).unwrap_or_else(|| panic!("{:?} is not in the drawing", one.module));
    let named = one.what.first()?;
    let file = one.file.strip_prefix(root()).unwrap_or(&one.file);
    let at = format!("{}:{}", file.display(), one.line);
    match height(rooms, &one.what) {
        Some(to) if to <= from => None,
        Some(to) => Some(format!("{at}: {} names {}, which stands above it", rooms[from], rooms[to])),
        None if root_items.contains(named) => None,
        None => Some(format!("{at}: {} names crate::{named}, which is no room", rooms[from])),
    }
}

// oracle: the drawing in ARCHITECTURE.md
#[test]
fn rooms_only_look_down() {
    let rooms = rooms();
    let core = core();
    assert!(core.files > 300, "{}", core.files);
    let inside = core.paths.iter().filter(|one| !one.module.is_empty());
    let faults: BTreeSet<String> = inside.filter_map(|one| fault(one, &rooms, &core.root_items)).collect();
    let lines: Vec<&str> = faults.iter().map(String::as_str).collect();
    assert!(lines.is_empty(), "{} lines look up:\n{}", lines.len(), lines.join("\n"));
}

/// What of the catalogue a run may name: what finds an entry, a list, its arguments or an alarm, and the log, which
/// belongs to no entry but to the end of each measurement. Everything else it asks the entries.
const NAMED: [&str; 8] = ["CYCLES", "find", "by_program", "Functions", "list", "Argument", "alarms", "log"];

// oracle: the drawing in ARCHITECTURE.md
#[test]
fn a_run_knows_of_a_cycle_what_its_entry_says() {
    let core = core();
    let of_run = core.paths.iter().filter(|one| one.module.first().is_some_and(|room| room == "run"));
    let named: Vec<_> = of_run.filter(|one| one.what.first().is_some_and(|room| room == "catalogue")).collect();
    assert!(named.len() > 5, "{}", named.len());
    let inside = named.iter().filter(|one| one.what.get(1).is_some_and(|name| !NAMED.contains(&name.as_str())));
    let lines: Vec<String> = inside.map(|one| format!("{}:{} {:?}", one.file.display(), one.line, one.what)).collect();
    assert_eq!(lines, [""; 0]);
}

// oracle: the modules of core/src/lib.rs, and the terminal program
#[test]
fn the_drawing_shows_every_room_once() {
    let drawn = rooms();
    assert_eq!(drawn.iter().collect::<BTreeSet<_>>().len(), drawn.len(), "{drawn:?}");
    let drawn: BTreeSet<&str> = drawn.iter().map(|room| room.split('/').next().unwrap()).collect();
    let core = core();
    let there = core.rooms.iter().map(String::as_str).chain(["bin"]);
    assert_eq!(drawn, there.collect());
}

/// Paths that a text in the module `a::b` names, with their lines.
fn paths(text: &str) -> Vec<String> {
    let found = Sources::of(text, &["a", "b"]).unwrap().paths;
    found.iter().map(|one| format!("{} {}", one.line, one.what.join("::"))).collect()
}

// oracle: hand
#[test]
fn every_way_to_name_a_path_is_seen() {
    assert_eq!(paths("use crate::x::{y, z::{self, w as v}};"), ["1 x::y", "1 x::z", "1 x::z::w"]);
    assert_eq!(paths("use super::super::x::*;\nuse super::c::D;"), ["1 x", "2 a::c::D"]);
    assert_eq!(paths("fn f(g: &crate::x::G<super::H>) -> u8 { vec![crate::y::<u8>()] }"), ["1 x::G", "1 a::H", "1 y"]);
    assert_eq!(paths("mod c { use super::super::super::x; }\npub(crate) fn f() {}"), ["1 x"]);
    assert_eq!(paths("\n\nfn f() { if crate::x::A { crate::y::B { c: 1 } } }"), ["3 x::A", "3 y::B"]);
}

// oracle: hand
#[test]
fn what_only_tests_name_is_not_seen() {
    assert!(paths("#[cfg(test)]\nmod tests { use crate::x; }\n#[cfg(all(test, feature = \"c\"))]\nmod o;").is_empty());
    assert!(paths("#[cfg(test)]\nuse crate::x::{y, z};\n#[test]\nfn f() { crate::x(); }").is_empty());
    assert_eq!(paths("#[cfg(not(test))]\nuse crate::x;\n#[cfg(feature = \"cli\")]\nuse crate::y;"), ["2 x", "4 y"]);
    assert_eq!(paths("// crate::x\nconst A: &str = \"crate::y\";\nuse crate::z;"), ["3 z"]);
}
