//! Cycles of the log: a log of R parameters in the part program memory.

use super::table::{Case, Table, program};
use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::machine::Setup;

/// What one line of the manual each names, and nothing on the simulated control brings about.
const UNREACHED: &[(u32, &str)] = &[
    (61353, "the folder is that of the calling program (B:11192), which is there"),
    (61357, "the part program memory of the simulated control has room"),
    (61358, "internal error of the cycle (A:15900)"),
    (61359, "internal error of the cycle (A:15901)"),
];
/// Eighteen columns: more than 200 characters.
const WIDE: &str = "_PROTVAL[2]=\"R1,R2,R3,R4,R5,R6,R7,R8,R9,R10,R11,R12,R13,R14,R15,R16,R17,R18\"";
/// Seven columns: more than 80 characters.
const LONG: &str = "_PROTVAL[2]=\"R1,R2,R3,R4,R5,R6,R7\"";

/// What is wrong with the file.
fn files() -> Vec<Case> {
    vec![
        program(61352, "_PROTNAME[1]=\"/_N_MPF_DIR/LOG\""),
        program(61352, "_PROTNAME[1]=\"1LOG\""),
        program(61354, "_PROTNAME[1]=\"\""),
        program(61355, "_PROTNAME[1]=\"LOG.TXT\""),
        program(61355, "_PROTNAME[1]=\"LOG_SPF\""),
        program(61356, "_PROTNAME[1]=\"PART\""), // it is being carried out: its file is open
    ]
}

/// What is wrong with the contents.
fn contents() -> Vec<Case> {
    vec![
        program(61361, "_PROTVAL[2]=\"_OVI[0]\""),
        program(61363, "_PROTFORM[4]=5"),
        program(61370, "_PROTVAL[0]=\"\" _PROTVAL[2]=\"\""),
        program(61371, WIDE),
        program(62307, LONG),
        program(62308, "_PROTFORM[5]=0 _PROTVAL[0]=\"\""),
        program(62309, "_PROTFORM[5]=4"),
        program(62310, "_PROTFORM[1]=201"),
        program(62311, "_PROTFORM[1]=12 R1=123456789.5"),
    ]
}

fn log(program: &'static str, cases: Vec<Case>, unreached: &[(u32, &'static str)]) -> Table {
    Table { program, usual: "", setup, cases, unreached: unreached.to_vec() }
}

/// Header and blocks: CYCLE100 with what it calls.
pub fn cycle100() -> Table {
    let text = "%_N_PART_MPF\n_PROTNAME[1]=\"LOG\" _PROTVAL[0]=\"A\" _PROTVAL[2]=\"R1\"\n{change}\n\
        CYCLE100\nCYCLE105(0)\nCYCLE101\nM30\n";
    let own = [(61360, "CYCLE100 calls CYCLE106 with a job that this knows (B:11253)")];
    log(text, files().into_iter().chain(contents()).collect(), &[UNREACHED, &own].concat())
}

pub fn cycle101() -> Table {
    log("CYCLE101\nM30\n", Vec::new(), &[])
}

pub fn cycle105() -> Table {
    let text = "_PROTNAME[1]=\"LOG\" _PROTVAL[0]=\"A\" _PROTVAL[2]=\"R1\"\n{change}\nCYCLE105(0)\nM30\n";
    log(text, contents(), &[])
}

pub fn cycle106() -> Table {
    let text = "%_N_PART_MPF\n_PROTNAME[1]=\"LOG\" _PROTVAL[0]=\"A\" _PROTVAL[2]=\"R1\" R20=2\n{change}\n\
        CYCLE106(R20)\nM30\n";
    let jobs = [program(61360, "R20=3")];
    log(text, files().into_iter().chain(contents()).chain(jobs).collect(), UNREACHED)
}

pub fn cycle113() -> Table {
    log("DEF STRING[10] T\nCYCLE113(1,T)\nM30\n", Vec::new(), &[])
}

pub fn cycle118() -> Table {
    let text = "DEF STRING[12] T\nR20=3\n{change}\nCYCLE118(0,2,T,R20,1)\nM30\n";
    log(text, vec![program(61362, "R20=11")], &[])
}

fn setup() -> Setup {
    Setup::calibrated(Dialect::Sinumerik, Plane::G17)
}
