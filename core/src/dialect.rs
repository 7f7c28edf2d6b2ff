//! The languages of part programs.

/// The language of the part program, and with it the control.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Dialect {
    /// SINUMERIK 840D/840Di/810D.
    Sinumerik,
    /// NCT milling controls.
    Nct,
}
