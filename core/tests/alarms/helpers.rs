//! Helper cycles: they hand the number of an alarm back and raise none.

use super::table::Table;
use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::machine::Setup;

const HANDED_BACK: &str = "the program gets the number and goes on (B:2448, B:8579-8583); tested beside the cycle";

pub fn cycle116() -> Table {
    Table {
        program: "DEF INT FAULT\nDEF REAL P[13]=SET(3,0,10,-10,0,0,-10)\nCYCLE116(P,FAULT)\nM30\n",
        usual: "",
        setup,
        cases: Vec::new(),
        unreached: vec![(61316, HANDED_BACK), (61317, HANDED_BACK)],
    }
}

pub fn cycle119() -> Table {
    Table {
        program: "DEF REAL SOLL[3,3]=SET(10,0,0,0,20,0,0,0,30), IST[3,3]=SET(11,0,0,1,20,0,1,0,30), RES\n\
            DEF INT FAULT\nDEF FRAME WAY\nG54\nCYCLE119(SOLL,IST,FAULT,RES,WAY,9999,1.2)\nM30\n",
        usual: "",
        setup,
        cases: Vec::new(),
        unreached: [61321, 61411, 61412, 61414].map(|number| (number, HANDED_BACK)).to_vec(),
    }
}

fn setup() -> Setup {
    Setup::calibrated(Dialect::Sinumerik, Plane::G17)
}
