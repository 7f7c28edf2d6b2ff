//! The languages of part programs.

/// The language of the part program, and with it the control.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(rename = "ControlName"))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Dialect {
    /// SINUMERIK 840D/840Di/810D.
    Sinumerik,
    /// NCT milling controls.
    Nct,
}

impl Dialect {
    /// Name of the control, the same in every language.
    pub fn name(self) -> &'static str {
        match self {
            Dialect::Sinumerik => "SINUMERIK",
            Dialect::Nct => "NCT",
        }
    }

    /// The control of a program: one that does not tell is taken as SINUMERIK.
    pub fn of(source: &[u8]) -> Dialect {
        Dialect::told(source).unwrap_or(Dialect::Sinumerik)
    }

    /// The control that the beginning of a program tells: NCT programs begin with `%O` or `O` and a number (C:1159),
    /// those of a SINUMERIK archive with `%_N_` (A:2643).
    pub fn told(source: &[u8]) -> Option<Dialect> {
        let rest = source.strip_prefix(b"\xef\xbb\xbf").unwrap_or(source).trim_ascii_start();
        if rest.get(..4).is_some_and(|begin| begin.eq_ignore_ascii_case(b"%_N_")) {
            return Some(Dialect::Sinumerik);
        }
        let rest = rest.strip_prefix(b"%").unwrap_or(rest).trim_ascii_start();
        let nct = matches!(rest, [b'O' | b'o', digit, ..] if digit.is_ascii_digit());
        nct.then_some(Dialect::Nct)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: manual (C:1159, A:2643)
    #[test]
    fn the_beginning_of_a_program_tells_its_control() {
        let nct = ["O1000\n", "%O0210 (BORE)\n", "\u{feff}%\nO0100\nM19\n", "  o12"];
        nct.iter().for_each(|text| assert_eq!(Dialect::told(text.as_bytes()), Some(Dialect::Nct), "{text}"));
        let archive = "%_N_CIRCLE_MPF\n;$PATH=/_N_WKS_DIR\n";
        assert_eq!(Dialect::told(archive.as_bytes()), Some(Dialect::Sinumerik));
        for text in ["", "%", "O", "OFFN=1", "N10 G0 X1", "_MVAR=1\nCYCLE977\n"] {
            assert_eq!(Dialect::told(text.as_bytes()), None, "{text}");
            assert_eq!(Dialect::of(text.as_bytes()), Dialect::Sinumerik, "{text}");
        }
    }
}
