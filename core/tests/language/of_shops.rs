//! What main programs of shops are full of beside motion: files, texts that are blocks, questions to the control, data
//! of tools, transformations, swivelled planes.

use super::{at, clean, fault, findings, go, go_on, messages, near, number, running, setup};
use probewright_core::geometry::Mcs;
use probewright_core::machine::Stop;
use probewright_core::run::Outcome;
use probewright_core::workpiece::{Shape, Solid, ToolProbe};

fn files(outcome: &Outcome) -> Vec<(&str, Vec<&str>)> {
    outcome.files.iter().map(|(name, lines)| (name, lines.iter().map(String::as_str).collect())).collect()
}

// oracle: hand (a path names the file however it is written; line 0 asks for the last lines; what is not there: 3)
#[test]
fn a_program_writes_reads_and_deletes_files_of_the_run() {
    let text = "DEF INT F\nDEF STRING[100] L[2]\nR1=ISFILE(\"LOG\")\n\
        WRITE(F,\"/_N_MPF_DIR/_N_LOG_MPF\",\"ONE \"<<1.5)\nWRITE(F,\"LOG\",\"TWO\")\nWRITE(F,\"log.mpf\",\"THREE\")\n\
        R2=F R3=ISFILE(\"_N_LOG_MPF\")\nREAD(F,\"LOG\",2,2,L)\nMSG(L[0]<<L[1])\nREAD(F,\"LOG\",0,1,L)\nMSG(L[0])\n\
        READ(F,\"LOG\",3,2,L)\nR4=F\nREAD(F,\"LOG\",1,3,L)\nR5=F\nREAD(F,\"NOBODY\",1,1,L)\nR6=F\n\
        WRITE(F,\"OLD\",\"X\")\nDELETE(F,\"OLD\")\nR7=F\nDELETE(F,\"OLD\")\nR8=F\n\
        EXTWRITE(F,\"EXT:RESULT.TXT\",\"A\")\nM30";
    let outcome = clean(text);
    assert_eq!(files(&outcome), [("LOG.MPF", vec!["ONE 1.5", "TWO", "THREE"]), ("RESULT.TXT", vec!["A"])]);
    assert_eq!(messages(text), ["TWOTHREE", "THREE"]);
    let found = [1, 2, 3, 4, 5, 6, 7, 8].map(|i| outcome.control.number(&format!("R{i}")));
    assert_eq!(found, [0.0, 0.0, 1.0, 21.0, 22.0, 3.0, 0.0, 3.0]);
}

// oracle: hand (a control fills its memory, and says so)
#[test]
fn files_have_an_end() {
    let text = "DEF INT F\nWHILE F==0\nWRITE(F,\"LOG\",\"LINE\")\nENDWHILE\nR1=F\nM30";
    assert_eq!(number(text, "R1"), 10.0);
}

// oracle: hand (the block of the text stands in the place of the call)
#[test]
fn a_text_is_carried_out_as_a_block() {
    at("DEF STRING[40] T=\"G0 X5 Y=R1\"\nR1=7\nEXECSTRING(T)\nEXECSTRING(\"Z\"<<3)", [5.0, 7.0, 3.0]);
    let called = "EXECSTRING(\"SUB(4)\")\nG0 Y1\nM30\n%_N_SUB_SPF\nPROC SUB(INT N)\nG0 X=N\nM17";
    assert_eq!(clean(called).end().0, [4.0, 1.0, 0.0]);
    // what is no plain block is told at the call
    let outcome = go("G0 X2\nEXECSTRING(\"IF R1 GOTOF A\")\nG0 Y2");
    assert_eq!((outcome.stop.is_none(), outcome.end().0), (true, [2.0, 2.0, 0.0]));
    assert_eq!(outcome.diagnostics[0].message.key, "run-not-simulated");
    assert_eq!(fault("EXECSTRING(\"R1=1/0\")"), "run-division");
    assert_eq!(fault("EXECSTRING(5)"), "run-function");
}

// oracle: hand (counted to five by the same program; without a condition it would go on for ever)
#[test]
fn a_program_starts_itself_again() {
    assert_eq!(number("R1=R1+1\nIF R1<5\nGOTOS\nENDIF\nM30", "R1"), 5.0);
    assert_eq!(number("R1=R1+1\nIF R1<3 GOTOS\nM30", "R1"), 3.0);
    let outcome = go("R1=R1+1\nGOTOS");
    assert_eq!((outcome.stop.clone(), outcome.control.number("R1")), (None, 1.0));
    assert_eq!(findings("R1=R1+1\nGOTOS"), ["run-restart"]);
}

// oracle: hand; of arrays the programs of a tester, from the examples of ISVAR in Job planning
#[test]
fn a_program_asks_what_there_is() {
    for (question, answer) in [
        ("ISVAR(\"R1\")", 1.0),
        ("ISVAR(\"r[5]\")", 1.0),
        ("ISVAR(\"OWN\")", 1.0),
        ("ISVAR(\"OWN[3]\")", 0.0),
        ("ISVAR(\"_OVR[0]\")", 1.0),
        ("ISVAR(\"NOBODY\")", 0.0),
        ("ISVAR(\"$MC_GCODE_RESET_VALUES[7]\")", 1.0),
        // an index that is left out, in whole or in part; a bracket that is not closed
        ("ISVAR(\"OWN[]\")", 1.0),
        ("ISVAR(\"OWN[,]\")", 0.0),
        ("ISVAR(\"OWN[1\")", 0.0),
        ("ISVAR(\"OWN1]\")", 0.0),
        ("ISVAR(\"FIELD\")", 1.0),
        ("ISVAR(\"FIELD[,]\")", 1.0),
        ("ISVAR(\"field[2, ]\")", 1.0),
        ("ISVAR(\"FIELD[,3]\")", 1.0),
        ("ISVAR(\"FIELD[3,]\")", 0.0),
        ("ISVAR(\"FIELD[,4]\")", 0.0),
        ("ISVAR(\"FIELD[2,3]\")", 1.0),
        ("ISVAR(\"FIELD[2,4]\")", 0.0),
        ("ISVAR(\"FIELD[1,1\")", 0.0),
        ("ISVAR(\"_OVR\")", 1.0),
        ("ISVAR(\"_OVR[]\")", 1.0),
        ("ISVAR(\"_OVR[0\")", 0.0),
        ("ISVAR(\"_WP[,]\")", 1.0),
        ("ISVAR(\"_MVAR\")", 1.0),
        ("ISVAR(\"_MVAR[]\")", 0.0),
        ("ISVAR(\"R[]\")", 1.0),
        ("ISVAR(\"NOBODY[]\")", 0.0),
        ("ISAXIS(2)", 1.0),
        ("ISAXIS(7)", 0.0),
        ("ISFILE(\"NOBODY\")", 0.0),
        ("SPRINT(\"%5.1F\",2)==\"  2.0\"", 1.0),
    ] {
        assert_eq!(number(&format!("DEF INT OWN[2]\nDEF INT FIELD[3,4]\nR9=({question})"), "R9"), answer, "{question}");
    }
    assert_eq!(number("R1=5\nIF R1==4 GOTOF A ELSE GOTOF B\nA: R2=1\nM30\nB: R2=2", "R2"), 2.0);
    assert_eq!(number("R1=4\nIF R1==4 GOTOF A ELSE GOTOF B\nA: R2=1\nM30\nB: R2=2", "R2"), 1.0);
    // what only the machine knows is assumed, and told
    assert_eq!(findings("R1=STRINGIS(\"A\")"), ["run-machine-value"]);
}

// oracle: hand (data of magazines are what was written; a tool that is made has its name and number)
#[test]
fn the_tool_memory_is_read_and_written() {
    assert_eq!(number("$TC_MPP6[1,4]=20\nR1=$TC_MPP6[1,4]", "R1"), 20.0);
    let text = "DEF INT N,A\nN=NEWT(\"NEW ONE\",1)\n$TC_DP1[N,1]=120 $TC_DP3[N,1]=75 $TC_DP6[N,1]=4\n$TC_TP8[N]=3\n\
        R1=GETT(\"new one\",1)-N R2=$TC_TP8[N] R3=$TC_DP3[N,1]\nT=\"NEW ONE\" M6\nGETEXET(A)\nR4=A-N\n\
        T20\nGETSELT(A)\nR5=A\nM6\nDELT(\"NEW ONE\",1)\nR6=GETT(\"NEW ONE\",1)";
    let control = clean(text).control;
    assert_eq!([1, 2, 3, 4, 5, 6].map(|i| control.number(&format!("R{i}"))), [0.0, 3.0, 75.0, 0.0, 20.0, -1.0]);
    assert_eq!(findings("R1=$TC_MOP2[20,1]"), ["run-machine-value"]);
    for text in ["R1=$TC_MOP2[77,1]", "R1=$TC_TP8[77]", "R1=$TC_DP3[77,1]"] {
        assert_eq!(fault(text), "run-no-tool", "{text}");
    }
    assert_eq!(fault("R1=$TC_DP3[20,9]"), "run-no-edge");
}

// oracle: hand (the machine's own axes do something else there, and afterwards nobody knows where they are)
#[test]
fn nothing_moves_in_other_coordinates() {
    for text in [
        "TRANSMIT\nX7 Y3\nTRAFOOF\nY1",
        "TRACYL(40)\nX7\nPOS[Z]=3\nTRAFOOF\nY1",
        "PRESETON(C,5) GEOAX(3,Z2)\nX7\nGEOAX()\nY1",
        "ROTS X10 Y10\nX7\nROT\nY1",
        "GEOAX()\nTOFRAME\nROTS\nY1",
        "CONTPRON(TABLE,\"G\",R1)\nX7 Y9\nEXECUTE(R1)\nY1",
        "NPROTDEF(1,FALSE,1)\nX7\nEXECUTE(R1)\nY1",
    ] {
        let outcome = go(&format!("G0 X5 Y5\n{text}"));
        assert_eq!((outcome.stop.clone(), outcome.end().0), (None, [5.0, 1.0, 0.0]), "{text}");
    }
    let measured = |behind: &str| {
        let text = format!("G0 X5 Z10\nTRANSMIT\nX7\nTRAFOOF\n{behind}\n_MVAR=100 _SETVAL=0 _MA=3 _PRNUM=1\nCYCLE978");
        let stop = go(&text).stop;
        matches!(stop, Some(Stop::Fault(message)) if message.key == "run-unread-value")
    };
    assert!(measured(""));
    assert!(!measured("G0 X5"));
}

// oracle: hand (the loop waits for what only the action writes)
#[test]
fn a_loop_that_waits_for_an_action_is_left() {
    let text = "ID=1 WHEN $AA_IM[Z]>10 DO $AC_MARKER[1]=4 M8\nWHILE $AC_MARKER[1]==0\nENDWHILE\nR1=$AC_MARKER[1]";
    assert_eq!(go(text).control.number("R1"), 4.0);
    let mut told = findings(text);
    told.sort();
    assert_eq!(told, ["run-synchronous", "run-waits"]);
    // a clock runs, also from what was written into it
    for wait in ["WHILE ($AC_TIME-R1)<5\nENDWHILE", "$AC_TIMER[2]=0\nREPEAT\nSTOPRE\nUNTIL $AC_TIMER[2]>10"] {
        assert_eq!(go(&format!("R1=$AC_TIME\n{wait}\nR2=1")).control.number("R2"), 1.0, "{wait}");
    }
    assert_eq!(fault("$AC_TIMER[2]=-1\nWHILE $AC_TIMER[2]<10\nENDWHILE"), "run-endless");
    assert_eq!(fault("ID=1 WHEN TRUE DO M8\nWHILE R1==0\nENDWHILE"), "run-endless");
}

// oracle: hand (57: about X, Y, Z in turn; a plane turned by 90 about Y has its X along -Z of the part)
#[test]
fn the_swivel_cycle_turns_the_plane_by_its_angles() {
    // without turning the axes (direction 0) the coordinates turn alone
    let plane = "CYCLE800(1,\"T\",0,57,10,20,30,0,90,0,0,0,0,0)\n";
    at(&format!("{plane}G0 X1 Y2 Z3"), [13.0, 22.0, 29.0]);
    // a programmed frame stands in the plane, and does not take it away
    at(&format!("{plane}TRANS X1\nG0 X0 Y0 Z0\nTRANS\nY2"), [10.0, 22.0, 29.0]);
    // an additional plane, shifted behind its turn
    at(&format!("{plane}CYCLE800(1,\"T\",1,57,0,0,0,0,-90,0,1,2,3,0)\nG0 X0 Y0 Z0"), [11.0, 22.0, 33.0]);
    // the table turns the part, so that the tool stands across the plane
    let outcome = clean("CYCLE800(1,\"T\",0,57,0,0,0,30,0,0,0,0,0,-1)\nG0 X5 Y6 Z50");
    near(outcome.control.rotary[0].0, 30.0, "table");
    near(outcome.position[1], 6.0, "level");
    near(outcome.position[2], 50.0, "level");
    at(&format!("{plane}CYCLE800()\nG0 X1 Y2 Z3"), [1.0, 2.0, 3.0]);
    // angles that are not simulated: nothing moves
    let outcome = go("G0 X1\nCYCLE800(1,\"T\",0,192,0,0,0,30,10,0,0,0,0,-1)\nG0 X9\nCYCLE800()\nG0 Y3");
    assert_eq!((outcome.stop.clone(), outcome.end().0), (None, [1.0, 3.0, 0.0]));
    assert_eq!(findings("CYCLE800(1,\"T\",0,192,0,0,0,30,10,0,0,0,0,-1)"), ["run-swivel"]);
}

// oracle: hand (G58 puts the translation of an axis, G59 its fine part; the others stay)
#[test]
fn parts_of_the_programmed_frame_are_put() {
    at("TRANS X1 Y2\nG58 X5\nG59 Y0.5\nG0 X0 Y0", [5.0, 2.5, 0.0]);
}

// oracle: manual (Job planning: the sign of MEAS is the edge; B:13834-13837: the inputs), hand: a block with its upper
// face at Z0, a ball of 3 mm
#[test]
fn the_edge_and_the_input_of_a_measuring_block_count() {
    let mut setup = setup();
    setup.position = Mcs([0.0, 0.0, 300.0]);
    setup.workpiece.solids.push(running::block());
    let run = |text: &str| go_on(&setup, &format!("T9 D1 M6\nG0 X0 Y0\nZ20\nF300\n{text}"));
    let values = |text: &str| {
        let outcome = run(text);
        let found = [1, 2, 3].map(|number| outcome.control.number(&format!("R{number}")));
        (found, outcome.diagnostics.iter().map(|one| one.message.key.to_string()).collect::<Vec<_>>())
    };
    let radius = setup.probe.radius;
    let ask = "R1=$AC_MEA[1] R2=$AA_IW[Z]";
    assert_eq!(values(&format!("MEAS=1 G1 Z-1\n{ask} R3=$AA_MW[Z]")), ([1.0, radius, radius], vec![]));
    assert_eq!(values(&format!("MEAS=-1 G1 Z-1\n{ask}")), ([0.0, -1.0, 0.0], vec![]));
    let away = format!("MEAW=1 G1 Z2\nMEAS=-1 G1 Z30\n{ask} R3=$AA_MW[Z]");
    let (found, told) = values(&away);
    assert!(
        told.is_empty() && (found[1] - radius).abs() < 1e-6 && (found[2] - radius).abs() < 1e-6,
        "{found:?} {told:?}"
    );
    assert_eq!(values("MEAS=2 G1 Z-1").1, ["run-measuring-input"]);
    assert_eq!(values("_CHBIT[0]=1\nMEAS=2 G1 Z-1").1, [""; 0]);
}

// oracle: hand: the end of an end mill meets the tool probe, which is at input 2 as delivered (`_CHBIT[1]`)
#[test]
fn a_tool_is_measured_by_a_measuring_block() {
    let mut setup = setup();
    setup.position = Mcs([0.0, 0.0, 300.0]);
    let cap = Solid::new(Shape::Block { size: [20.0; 3] }, Mcs([200.0, 0.0, -10.0]));
    setup.tool_probes.push(ToolProbe::ideal(cap));
    let outcome = go_on(&setup, "T20 D1 M6\nG0 X200 Y0\nZ20\nMEAS=2 G1 F300 Z-30\nR1=$AC_MEA[2] R2=$AA_MW[Z]\nG0 Z20");
    assert_eq!((outcome.stop.clone(), &outcome.diagnostics[..]), (None, &[][..]));
    assert_eq!(["R1", "R2"].map(|name| outcome.control.number(name)), [1.0, -10.0]);
}
