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

    /// The control of a program: NCT programs begin with `%O` or `O` and a number (C:1159), all others are SINUMERIK.
    pub fn of(source: &[u8]) -> Dialect {
        let rest = source.strip_prefix(b"\xef\xbb\xbf").unwrap_or(source).trim_ascii_start();
        let rest = rest.strip_prefix(b"%").unwrap_or(rest).trim_ascii_start();
        match rest {
            [b'O' | b'o', digit, ..] if digit.is_ascii_digit() => Dialect::Nct,
            _ => Dialect::Sinumerik,
        }
    }
}
