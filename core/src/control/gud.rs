//! Which user data a SINUMERIK control with measuring cycles has: name and sizes (B:1744-1838, B:13097-13247).

/// A datum of the blocks GUD5 and GUD6.
pub struct Gud {
    /// Name without index.
    pub name: &'static str,
    /// Sizes of the array; empty for a single value.
    pub sizes: &'static [usize],
    /// Whether it holds text.
    pub text: bool,
}

const fn one(name: &'static str) -> Gud {
    Gud {
        name,
        sizes: &[],
        text: false,
    }
}

const fn list(name: &'static str, sizes: &'static [usize]) -> Gud {
    Gud {
        name,
        sizes,
        text: false,
    }
}

const fn text(name: &'static str, sizes: &'static [usize]) -> Gud {
    Gud {
        name,
        sizes,
        text: true,
    }
}

/// All of them, by name. Sizes that depend on others (`_EVMVNUM`, `_CVAL`) are those delivered, enlarged to the
/// largest that the manual allows.
pub const GUD: &[Gud] = &[
    one("_CALNUM"),
    list("_CBIT", &[30]), // B:13132 prints 16, appendix C 30 (B:16617)
    list("_CHBIT", &[30]),
    list("_CM", &[8]),
    one("_CORA"),
    one("_CPA"),
    one("_CPO"),
    list("_CVAL", &[4]),
    one("_DIGIT"),
    one("_DLNUM"),
    list("_EV", &[9999]), // _EVNUM allows 1..9999, B:2325
    list("_EVMVNUM", &[2]),
    one("_EVNUM"),
    one("_FA"),
    text("_HEADLINE", &[10]),
    one("_ID"),
    one("_INCA"),
    list("_JM_B", &[10]),
    list("_JM_I", &[10]),
    one("_K"),
    list("_KB", &[99, 7]),
    one("_KNUM"),
    one("_MA"),
    list("_MC_MTL", &[99]),
    one("_MC_SIMDIFF"),
    one("_MC_SIMSIM"),
    one("_MD"),
    list("_MFS", &[6]),
    one("_MT_COMP"),
    list("_MT_EC_L", &[6, 5]),
    list("_MT_EC_R", &[6, 5]),
    list("_MV", &[9999]),
    one("_MVAR"),
    list("_MZ_MASK", &[20]),
    one("_NMSP"),
    list("_OVI", &[20]),
    list("_OVR", &[32]),
    list("_PMI", &[4]),
    one("_PRNUM"),
    list("_PROTFORM", &[6]),
    text("_PROTNAME", &[2]),
    text("_PROTSYM", &[2]),
    text("_PROTVAL", &[13]),
    one("_RA"),
    one("_RF"),
    list("_SETV", &[9]),
    one("_SETVAL"),
    text("_SI", &[3]),
    list("_SPEED", &[4]),
    list("_SP_B", &[20]),
    one("_STA1"),
    one("_SZA"),
    one("_SZO"),
    one("_TDIF"),
    text("_TENV", &[]),
    one("_TLL"),
    one("_TMV"),
    text("_TNAME", &[]),
    one("_TNUM"),
    one("_TNVL"),
    list("_TP", &[99, 10]),
    list("_TPW", &[99, 10]),
    one("_TP_CF"),
    one("_TSA"),
    one("_TUL"),
    text("_TXT", &[100]),
    one("_TZL"),
    one("_VMS"),
    list("_WP", &[99, 11]), // _PRNUM has two digits, B:2277
];

/// A datum by its name in upper case.
pub fn find(name: &str) -> Option<&'static Gud> {
    GUD.iter().find(|gud| gud.name == name)
}

/// A datum by its name with its index, which lies inside of the array: `_WP[0,1]`.
pub fn named(name: &str) -> Option<&'static Gud> {
    let (stem, index) = match name.split_once('[') {
        Some((stem, rest)) => (stem, rest.strip_suffix(']')?.split(',').collect()),
        None => (name, Vec::new()),
    };
    let inside = |(index, size): (&&str, &usize)| index.parse::<usize>().is_ok_and(|i| i < *size);
    find(stem)
        .filter(|gud| index.len() == gud.sizes.len() && index.iter().zip(gud.sizes).all(inside))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::Dialect;
    use crate::control::delivery;

    #[test]
    fn what_is_delivered_is_known() {
        for name in delivery(Dialect::Sinumerik)
            .data
            .keys()
            .filter(|name| name.starts_with('_'))
        {
            let stem = name.split('[').next().unwrap_or_default();
            // oracle: self (two tables from the same source)
            assert!(find(stem).is_some(), "{name}");
        }
    }
}
