//! Measuring cycles of CNC controls: what can be measured, forms, checks, reading and writing part programs,
//! and the simulation of the control. No browser, no clock, no random source of its own, no IO.
//!
//! Inside: millimetre, degree, mm/min, positions X Y Z of the machine unless something else is said. What is wrong is
//! said with a key and arguments ([`message::Message`]); the words are in Fluent files, with the feature `cli` in
//! `words`.
//!
//! # Check a call
//!
//! Values are texts, as somebody typed them. A check finds the alarms that the control would raise, and gives checked
//! inputs where there is nothing wrong.
//!
//! ```
//! use probewright_core::catalogue::find;
//! use probewright_core::check::check;
//! use probewright_core::control::delivery;
//! use probewright_core::diagnostic::Code;
//! use probewright_core::dialect::Dialect;
//! use probewright_core::entry::Typed;
//!
//! let cycle = find(Dialect::Sinumerik, "CYCLE977").ok_or("no such cycle")?;
//! let values = [("_MVAR", "1"), ("_SETVAL", "132"), ("_KNUM", "2000")];
//! let typed = Typed::from(values.map(|(name, value)| (name.to_owned(), value.to_owned())));
//! let checked = check(cycle, &typed, &delivery(Dialect::Sinumerik));
//! assert!(checked.diagnostics.iter().any(|found| found.code == Code::Alarm(61328)));
//! assert!(checked.inputs.is_none());
//! # Ok::<(), &str>(())
//! ```
//!
//! # Write a call
//!
//! ```
//! use probewright_core::catalogue::find;
//! use probewright_core::control::delivery;
//! use probewright_core::dialect::Dialect;
//! use probewright_core::entry::{Style, Typed};
//! use probewright_core::program::write::snippet;
//!
//! let cycle = find(Dialect::Sinumerik, "CYCLE977").ok_or("no such cycle")?;
//! let values = [("_MVAR", "1"), ("_SETVAL", "132,5"), ("_KNUM", "2001"), ("_TNUM", "20")];
//! let typed = Typed::from(values.map(|(name, value)| (name.to_owned(), value.to_owned())));
//! let written = snippet(cycle, &typed, &delivery(Dialect::Sinumerik), Style::Direct, None);
//! assert_eq!(written.text, "_MVAR=1 _SETVAL=132.5 _KNUM=2001 _TNUM=20\nCYCLE977\n");
//! # Ok::<(), &str>(())
//! ```
//!
//! # Run a program
//!
//! [`run::run`] takes the machine, [`run::assumed::run`] makes one that fits the program.
//!
//! ```
//! use probewright_core::dialect::Dialect;
//! use probewright_core::run::{Limits, assumed};
//! use probewright_core::syntax::read;
//!
//! let text = b"G17 G54 G90 T=\"PROBE\" D1 M6
//! G0 X180 Y130
//! Z20
//! _MVAR=101 _SETVAL=132 _KNUM=0 _FA=2 _TSA=1 _PRNUM=1
//! CYCLE977
//! M30";
//! let ran = assumed::run(&read(Dialect::Sinumerik, text), Limits::default());
//! assert!(ran.outcome.finished());
//! assert_eq!(ran.outcome.alarms(), []);
//! let measured = ran.outcome.control.number("_OVR[4]"); // the diameter
//! assert!((measured - 132.0).abs() < 1e-9);
//! ```
//!
//! # Features
//!
//! `json` reads and writes documents, `cli` has the terminal program with words and reports. See ARCHITECTURE.md
//! for the rooms and the invariants.

#[cfg(feature = "json")]
pub mod app;
pub mod catalogue;
pub mod check;
pub mod control;
pub mod diagnostic;
pub mod dialect;
pub mod encoding;
pub mod entry;
pub mod evaluate;
pub mod foreign;
pub mod form;
pub mod geometry;
pub mod jog;
#[cfg(feature = "json")]
pub mod json;
pub mod machine;
pub mod manual;
pub mod message;
pub mod name;
pub mod own;
pub mod picture;
mod problem;
pub mod program;
pub mod range;
pub mod refused;
#[cfg(feature = "cli")]
pub mod report;
pub mod run;
pub mod scan;
pub mod scene;
pub mod series;
pub mod setup_file;
pub mod support;
pub mod syntax;
#[cfg(test)]
mod test_data;
#[cfg(feature = "cli")]
pub mod words;
pub mod workpiece;
