//! The softkeys by which a control opens a mask of measuring in JOG, from measuring cycles SW 6.3 on and before, as the
//! control writes them in English.

use super::mask::Mask;
use std::sync::LazyLock;

/// Of which measuring cycles the softkeys are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Software {
    /// From SW 6.3.
    Newer,
    /// Up to SW 6.2.
    Older,
    /// All.
    Both,
}

/// Softkeys of a mask.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Softkeys {
    mask: &'static str,
    /// Software.
    pub software: Software,
    /// Softkeys one after another.
    pub softkeys: &'static str,
    /// Place in the manual.
    pub source: &'static str,
}

/// All of them.
pub static SOFTKEYS: LazyLock<Vec<Softkeys>> = LazyLock::new(|| {
    include_str!("softkeys.tsv").lines().skip(1).filter_map(|row| read(&row.split('\t').collect::<Vec<_>>())).collect()
});

fn read(row: &[&'static str]) -> Option<Softkeys> {
    let [mask, software, softkeys, source] = *row else { return None };
    let software = match software {
        "newer" => Software::Newer,
        "older" => Software::Older,
        "both" => Software::Both,
        _ => return None,
    };
    Some(Softkeys { mask, software, softkeys, source })
}

/// Softkeys of a mask.
pub fn softkeys(mask: &Mask) -> impl Iterator<Item = &'static Softkeys> {
    SOFTKEYS.iter().filter(|one| one.mask == mask.name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::jog::masks::{FUNCTIONS, OLDER, all, menu};
    use crate::manual::Cited;

    // oracle: self: no row is lost or serves nothing, and each mask has the way of the software that offers it
    #[test]
    fn each_mask_has_its_softkeys() {
        assert_eq!(SOFTKEYS.len() + 1, include_str!("softkeys.tsv").lines().count());
        for mask in all() {
            let has = |functions: &[crate::jog::mask::Function]| {
                functions.iter().flat_map(|function| function.masks).any(|one| one.name == mask.name)
            };
            let software = match (has(FUNCTIONS), has(OLDER)) {
                (true, true) => Software::Both,
                (true, false) => Software::Newer,
                _ => Software::Older,
            };
            let found: Vec<Software> = softkeys(mask).map(|one| one.software).collect();
            assert_eq!(found, [software], "{}", mask.name);
        }
        for row in SOFTKEYS.iter() {
            let serves = all().any(|mask| mask.name == row.mask);
            assert!(serves && !Cited(row.source).to_string().is_empty(), "{row:?}");
        }
    }

    // oracle: manual B:2722-2728, B:2894-2895, B:2991-2993, B:3167-3168, B:3264-3268, B:3295-3299, B:4037-4057: the
    // masks of a softkey of the bar are those whose way leads through it, all of them, in its order
    #[test]
    fn the_menu_is_that_of_the_control() {
        for (functions, software) in [(FUNCTIONS, Software::Newer), (OLDER, Software::Older)] {
            let mut ways: Vec<Vec<&str>> = Vec::new();
            for (_, masks) in menu(functions) {
                let way = |mask: &Mask| softkeys(mask).next().map_or("", |one| one.softkeys);
                let bar = |mask: &Mask| {
                    let keys: Vec<&str> = way(mask).split(" > ").collect();
                    if keys[0] == "Measure tool" { keys[0] } else { keys[1] }
                };
                let bars: Vec<&str> = masks.iter().map(|mask| bar(mask)).collect();
                assert!(bars.iter().all(|one| *one == bars[0]), "{bars:?}");
                ways.push(masks.iter().map(|mask| mask.name).collect());
            }
            let wanted: &[&[&str]] = if software == Software::Newer {
                &[
                    &["set_edge", "align_edge", "distance"],
                    &["corner_right", "corner_any"],
                    &["pocket_rect", "hole_1", "holes_2", "holes_3", "holes_4"],
                    &["spigot_rect", "spigot_1", "spigots_2", "spigots_3", "spigots_4"],
                    &["align_plane"],
                    &["cal_length", "cal_radius"],
                    &["tool_length", "tool_radius", "tool_cal"],
                ]
            } else {
                &[
                    &["old_edge"],
                    &["old_corner"],
                    &["old_hole"],
                    &["old_spigot"],
                    &["old_cal_length", "old_cal_radius"],
                    &["tool_length", "tool_radius", "tool_cal"],
                ]
            };
            assert_eq!(ways, wanted);
        }
    }

    // oracle: manual B:3260-3330, A:3036-3040: holes and spigots are under two softkeys
    #[test]
    fn two_spigots_are_not_under_the_holes() {
        let of = |name: &str| all().find(|mask| mask.name == name).and_then(|mask| softkeys(mask).next());
        let keys = |name| of(name).map(|one| one.softkeys);
        assert_eq!(keys("spigots_2"), Some("Measure workpiece > Spigot > 2 circular spigots"));
        assert_eq!(keys("old_cal_radius"), Some("Measure workpiece > Calibrate probe > Radius"));
    }
}
