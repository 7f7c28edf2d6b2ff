//! The sample log of the manual, token by token.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::{Limits, Session};
use crate::control::Plane;
use crate::dialect::Dialect;
use crate::geometry::Mcs;
use crate::machine::Setup;
use crate::syntax::read;
use crate::workpiece::{Shape, Solid};

/// The program of B:11545-11638, its misprints put right by A:12900-12961; behind them what stands for its dots.
const PROGRAM: &str = "%_N_MEASPROGRAM_1_MPF
;$PATH=/_N_MPF_DIR
;Measure shaft with measuring log
DEF INT PARTNUM, JOBNUM, MP_COUNTER
_CBIT[11]=0
PARTNUM=123456789 JOBNUM=6878
_PROTNAME[0]=\"MEASPROGRAM_1\"
_PROTNAME[1]=\"LOG_1\"
_HEADLINE[0]=\"Part number: \"<<PARTNUM
_HEADLINE[1]=\"Job number: \"<<JOBNUM
_HEADLINE[2]=\"Supervisor: Müller Phone: 1234\"
_PROTSYM[0]=\",\" _PROTSYM[1]=\"*\"
_PROTFORM[0]=60
_PROTFORM[1]=80
_PROTFORM[2]=1
_PROTFORM[3]=3
_PROTFORM[4]=1
_PROTFORM[5]=12
_PROTVAL[0]=\"Meas.      , Axis      , Set       , Act. value, Difference, Time\"
_PROTVAL[1]=\"point      ,           , value\"
MP_COUNTER=1 _TXT[0]=<<MP_COUNTER
N100 G0 G17 G90 T3 D1 Z100 F1000
N110 X70 Y90
_MVAR=100 _SETVAL=80 _MA=3 _TSA=2 _FA=2
_KNUM=0 _PRNUM=1 _VMS=0 _NMSP=1
_PROTVAL[2]=\"_TXT[0],_AXIS,_OVR[0],_OVR[4],_OVR[16],_TIME\"
N150 CYCLE100
N160 CYCLE978
N170 Z200
N180 X64 Y38
N185 Z130
_MVAR=102 _SETVAL=70 _FA=2 _TSA=2 _ID=-20
_PROTFORM[4]=2
_PROTVAL[2]=\"_TXT[0],_AXIS1,_OVR[1],_OVR[5],_OVR[17],_TIME\"
_PROTVAL[3]=\" ,_AXIS2,_OVR[2],_OVR[6],_OVR[18]\"
MP_COUNTER=MP_COUNTER+1 _TXT[0]=<<MP_COUNTER
N190 CYCLE977
N210 CYCLE101
N220 Z200
N290 M2
";

/// A shaft of 70 mm at X64.009 Y37.998 on a plate whose upper face is at Z79.987.
fn setup() -> Setup {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    let probe = setup.control.tools[&9].clone();
    setup.control.tools.insert(3, probe);
    let shaft = Shape::Shaft { diameter: 70.0, height: 40.013 };
    setup.workpiece.solids.push(Solid::new(shaft, Mcs([64.009, 37.998, 120.0])));
    setup.position = Mcs([70.0, 200.0, 500.0]); // the shaft is not in its way
    setup
}

/// The log with these times at the blocks that call a cycle, seconds of the day. In the sample of the manual the header
/// is printed after the measurements, which no clock does.
fn log(times: [(&str, u32); 3]) -> Vec<String> {
    let mut session = Session::new(read(Dialect::Sinumerik, PROGRAM.as_bytes()), &setup(), Limits::default());
    for (block, second) in times {
        let line = PROGRAM.lines().position(|line| line.ends_with(block)).unwrap();
        while session.run.at < line {
            assert!(!session.advance(1), "{:?}", session.outcome().diagnostics);
        }
        let [hour, minute] = [second / 3600, second / 60 % 60];
        session.run.sim.clock = format!("1998-11-15T{hour:02}:{minute:02}:{:02}", second % 60).parse().unwrap();
        session.run.sim.seconds = 0.0;
    }
    let outcome = session.complete();
    assert_eq!((outcome.stop, outcome.diagnostics), (None, Vec::new()));
    assert_eq!(outcome.files.iter().map(|(name, _)| name).collect::<Vec<_>>(), ["LOG_1.MPF"]);
    outcome.files.lines("LOG_1.MPF").unwrap().to_vec()
}

/// Second of the day of the time at the end of a line.
fn second(line: &str) -> u32 {
    let time = line.rsplit(',').next().unwrap().trim();
    time.split(':').fold(0, |sum, part| 60 * sum + part.parse::<u32>().unwrap())
}

/// What stands between separators, or in the first line between blanks.
fn tokens(line: &str) -> Vec<&str> {
    if line.starts_with("Date:") { line.split_whitespace().collect() } else { line.split(',').map(str::trim).collect() }
}

// oracle: manual B:11513-11638, A:12866-12961
#[test]
fn the_sample_of_the_manual_comes_out() {
    let header = 10 * 3600 + 5 * 60 + 30;
    // how long the measurements take is known behind a first run
    let first = log([("CYCLE100", header), ("CYCLE978", 0), ("CYCLE977", 0)]);
    let [one, two] = [second(&first[12]), second(&first[16])];
    let wanted = [9 * 3600 + 35 * 60 + 12, 9 * 3600 + 36 * 60 + 45];
    let lines = log([("CYCLE100", header), ("CYCLE978", wanted[0] - one), ("CYCLE977", wanted[1] - two)]);
    let dashes = "-".repeat(80);
    let expected: [&[&str]; 18] = [
        &["Date:", "98/11/15", "Time:", "10:05:30", "Page:", "1"],
        &[""],
        &["Program: MEASPROGRAM_1"],
        &[""],
        &["Part number: 123456789"],
        &["Job number: 6878"],
        &["Supervisor: Müller Phone: 1234"],
        &[&dashes],
        &["Meas.", "Axis", "Set", "Act. value", "Difference", "Time"],
        &["point", "", "value"],
        &[&dashes],
        &["CYCLE978", "_MVAR", "100"],
        &["1", "Z", "80.000", "79.987", "-0.013", "09:35:12"],
        &[""],
        &[""],
        &["CYCLE977", "_MVAR", "102"],
        &["2", "X", "64.000", "64.009", "0.009", "09:36:45"],
        &["", "Y", "38.000", "37.998", "-0.002"],
    ];
    let found: Vec<Vec<&str>> = lines.iter().map(|line| tokens(line)).collect();
    assert_eq!(found, expected);
    // how it looks: columns of twelve characters, a blank behind the separator
    assert_eq!(lines[11], "CYCLE978    , _MVAR      , 100");
}

// oracle: hand (the log measures nothing, so the probe is in the spindle for the first measurement)
#[test]
fn a_log_before_a_measurement_leaves_the_assumed_machine_as_it_is() {
    let measured = "_MVAR=1 _SETVAL=30 _FA=2 _TSA=1 _PRNUM=1 _KNUM=0\nCYCLE977\nM30\n";
    let logged = format!("_PROTNAME[0]=\"PART\" _PROTNAME[1]=\"LOG\" _PROTVAL[2]=\"_OVR[4]\"\nCYCLE100\n{measured}");
    let [alone, behind] = [measured, &logged].map(|text| {
        let ran = super::assumed::run(&read(Dialect::Sinumerik, text.as_bytes()), Limits::default());
        (ran.setup.control.tool, ran.outcome.control.number("_OVR[4]"))
    });
    assert_eq!(alone, behind);
    assert!(alone.1 > 0.0, "{alone:?}");
}

// oracle: manual A:15898 (the file is used by an NC program already): that of a program which is carried out is open,
// whether its name is in the text or not; that of another one is replaced (B:11229)
#[test]
fn a_log_cannot_take_the_file_of_a_program_that_is_carried_out() {
    let ends = |text: &str, file: &str| {
        let session = Session::new(read(Dialect::Sinumerik, text.as_bytes()), &setup(), Limits::default());
        let outcome = session.of_file(file).complete();
        outcome.alarms().iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    let log = "_PROTNAME[1]=\"PART\" _PROTVAL[0]=\"A\" _PROTVAL[2]=\"R1\"\nCYCLE100\n";
    let in_use = ["61356"];
    let alone = format!("{log}M30\n");
    assert_eq!(ends(&alone, "part.mpf"), in_use);
    assert_eq!(ends(&alone, ""), [""; 0]);
    assert_eq!(ends(&format!("%_N_OTHER_MPF\n{alone}"), "part.mpf"), [""; 0]);
    let (main, other) = ("%_N_MAIN_MPF\n", "%_N_PART_MPF\n");
    assert_eq!(ends(&format!("{main}PART\nM30\n{other}{log}M17\n"), ""), in_use);
    assert_eq!(ends(&format!("{main}PART\n{log}M30\n{other}R1=1\nM17\n"), ""), [""; 0]);
}
