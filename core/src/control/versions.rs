//! Versions of the measuring cycles in which a datum exists, as far as the manual says it (chapter 12 and the notes at
//! the data).

use serde::Serialize;

/// Versions of a datum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Versions {
    /// Name, with an index where only this element is meant.
    #[serde(skip)]
    pub name: &'static str,
    /// The first one; empty: it is older than all that is told.
    pub from: &'static str,
    /// The last one; empty: still there.
    pub until: &'static str,
    /// Place in the manual.
    #[serde(skip)]
    pub source: &'static str,
}

const fn from(name: &'static str, from: &'static str, source: &'static str) -> Versions {
    Versions { name, from, until: "", source }
}

/// Those that the manual tells.
static TOLD: [Versions; 32] = [
    from("_CM", "4.3", "B:13496"),
    from("_MFS", "4.3", "B:13513"),
    from("_CBIT[5]", "5.4", "B:16333-16337"),
    from("_CBIT[6]", "6.2", "B:16338"),
    from("_CBIT[14]", "4.5", "B:16355-16360"),
    from("_CBIT[15]", "4.5", "B:16355-16360"),
    from("_CHBIT[8]", "6.3", "B:13934"),
    from("_CHBIT[23]", "6.3", "B:16548"),
    Versions { name: "_SI", from: "", until: "6.2", source: "B:13675" },
    from("_MZ_MASK", "6.2", "B:12123-12129"),
    from("_TPW", "6.3", "B:13406"),
    from("_TP_CF", "6.2", "B:13784"),
    from("_MT_COMP", "6.2", "B:13795"),
    from("_MT_EC_R", "6.2", "B:13805"),
    from("_MT_EC_L", "6.2", "B:13805"),
    from("_MC_MTL", "6.3", "A:14387"),
    from("_MC_SIMSIM", "6.3", "A:14388"),
    from("_MC_SIMDIFF", "6.3", "A:14389"),
    from("_JM_I[5]", "6.3", "A:15436"),
    from("_JM_I[6]", "6.3", "A:15436"),
    from("_JM_I[7]", "6.3", "A:15436"),
    from("_JM_I[8]", "6.3", "A:15436"),
    from("_JM_I[9]", "6.3", "A:15436"),
    Versions { name: "_JM_B[4]", from: "6.2", until: "6.2", source: "A:2948-2954;A:15449;B:14365-14366" },
    from("_JM_I", "5.3", "B:14319"),
    from("_JM_B", "5.3", "B:14351"),
    from("E_MESS_CAL_D", "6.3", "A:15380"),
    from("E_MESS_CAL_L", "6.3", "A:15381"),
    from("E_MESS_SETT", "6.2", "B:14302"),
    from("_TENV", "6.3", "B:2041;A:2142"),
    from("_DLNUM", "6.3", "B:2041;A:2142"),
    from("MD28083", "6.3", "B:12991"),
];

/// The versions of a datum: those of its element, else of the whole array.
pub fn versions(name: &str) -> Option<&'static Versions> {
    let of = |wanted: &str| TOLD.iter().find(|one| one.name.eq_ignore_ascii_case(wanted));
    of(name).or_else(|| of(super::arrays::stem(name)))
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: manual A:15436 (elements of measuring in JOG that came later than their array)
    #[test]
    fn an_element_may_be_younger_than_its_array() {
        let first = |name: &str| versions(name).map(|found| found.from);
        assert_eq!((first("_JM_I[5]"), first("_JM_I[4]"), first("_jm_i")), (Some("6.3"), Some("5.3"), Some("5.3")));
        assert_eq!((first("_CBIT[6]"), first("_CBIT[0]")), (Some("6.2"), None));
    }

    // oracle: self (the tables of all data)
    #[test]
    fn each_is_a_datum() {
        use crate::control::{gud, machine_data::MACHINE_DATA};
        let machine = |name: &str| MACHINE_DATA.iter().any(|one| one.number == name);
        let known = |name: &str| gud::find(name).is_some() || gud::named(name).is_some() || machine(name);
        let unknown: Vec<&str> = TOLD.iter().map(|one| one.name).filter(|name| !known(name)).collect();
        assert_eq!(unknown, Vec::<&str>::new());
    }
}
