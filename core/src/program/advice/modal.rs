//! What the words before a call have put in force, as far as the text tells.

use crate::program::fold::{self, Known};
use crate::program::tree::{Program, Word, WordKind};

/// State at a place of the text; none: nothing was programmed yet.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Modal {
    /// G17, G18 or G19.
    pub plane: Option<u16>,
    /// G40, G41 or G42.
    pub compensation: Option<u16>,
    /// G500, G54 to G57, G505 to G599.
    pub frame: Option<u16>,
    /// Number after the last T.
    pub tool: Option<f64>,
    /// A T was programmed, and no D since.
    pub edge_open: bool,
    /// Number after the last D.
    pub edge: Option<f64>,
    /// M3 or M4, with no stop or positioning since.
    pub turning: bool,
    /// DIAMON, DIAMOF or DIAM90 was programmed.
    pub diameter: bool,
}

impl Modal {
    /// Takes in one word.
    pub fn word(&mut self, program: &Program, word: &Word) {
        match &word.kind {
            WordKind::Address {
                name,
                value,
                extension,
                ..
            } => {
                let number = fold::number(program, *value, &Known::new());
                self.address(&program.name(*name), extension.is_some(), number);
            }
            WordKind::Assign { name, .. } if program.is(*name, "SPOS") => self.turning = false,
            WordKind::Assign { name, .. } if program.is(*name, "T") => self.change(None),
            WordKind::Call { name, .. } => match program.name(*name).as_str() {
                "DIAMON" | "DIAMOF" | "DIAM90" => self.diameter = true,
                _ => {}
            },
            _ => {}
        }
    }

    fn address(&mut self, name: &str, extension: bool, number: Option<f64>) {
        match name {
            "G" => self.function(number.unwrap_or(-1.0)),
            "T" => self.change(number),
            "D" => {
                self.edge = number;
                self.edge_open = false;
            }
            "M" if !extension => match number.unwrap_or(-1.0) {
                3.0 | 4.0 => self.turning = true,
                5.0 | 6.0 | 19.0 => self.turning = false,
                _ => {}
            },
            "SPOS" => self.turning = false,
            _ => {}
        }
    }

    fn change(&mut self, number: Option<f64>) {
        self.tool = number;
        self.edge = None;
        self.edge_open = true;
    }

    fn function(&mut self, number: f64) {
        if number.fract() != 0.0 || !(0.0..1000.0).contains(&number) {
            return;
        }
        let code = number as u16;
        match code {
            17..=19 => self.plane = Some(code),
            40..=42 => self.compensation = Some(code),
            54..=57 | 500 | 505..=599 => self.frame = Some(code),
            _ => {}
        }
    }
}
