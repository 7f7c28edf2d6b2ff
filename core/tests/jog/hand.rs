//! The machine under the hand: what a tool or the body of the probe runs into, the plane, data that cannot be.

use super::{block, near};
use probewright_core::app::{JogLine, JogView, jog, jog_in_mm};
use probewright_core::control::{Edge, Plane, Units, delivery_in};
use probewright_core::dialect::Dialect;
use probewright_core::geometry::Mcs;
use probewright_core::jog::practice::{self, Piece};
use probewright_core::jog::{Input, Session, State};
use probewright_core::machine::Setup;
use probewright_core::workpiece::{Noise, ProbeBody, Shape, Solid, ToolProbe};

fn told(setup: &Setup, script: &str) -> JogView {
    jog(script, setup, None).unwrap()
}

/// What a line raised and what helps, by their keys.
fn raised(line: &JogLine) -> Option<(&str, &str)> {
    let raised = line.raised.as_ref()?;
    Some((raised.message.key.as_ref(), raised.hint.as_ref().map_or("", |hint| hint.key.as_ref())))
}

/// The block with its corner at X 0, Y 0, Z 0 and, beside the probe T9, a tool T2 of 80 mm and this type and radius.
fn with_tool(kind: i64, radius: f64, corner: f64) -> Setup {
    let mut setup = block();
    let mut edge = Edge { kind, length: [80.0, 0.0, 0.0], radius, ..Edge::default() };
    edge.further.insert(7, corner);
    setup.control.tools.entry(2).or_default().edges.insert(1, edge);
    (setup.control.tool, setup.control.edge) = (2, 1);
    setup.position = Mcs([-60.0, 40.0, 30.0]);
    setup
}

// oracle: hand: the flank of the cylinder stands at the face, its end on the upper face; the point of a drill is there
#[test]
fn a_tool_that_runs_into_the_part_is_a_collision() {
    for (kind, corner) in [(120, 0.0), (110, 8.0), (220, 0.0)] {
        let setup = with_tool(kind, 8.0, corner);
        for (way, axis, stop) in [
            ("move Z-30\nmove X30\n", 0, -8.0),
            ("move Y-50\nmove X50\nmove Z-30\nmove Y30\n", 1, -8.0),
            ("move X50\nmove Z-5\n", 2, 0.0),
        ] {
            let what = format!("{kind} {way}");
            let view = told(&setup, &format!("mask tool_length\n{way}jog Z+0\n"));
            let [.., line, _] = &view.lines[..] else { unreachable!() };
            assert_eq!(raised(line), Some(("jog-crash-cutter", "jog-crash-hint")), "{what}");
            assert!((line.position[axis] - stop).abs() < 1e-6, "{what}: {:?}", line.position);
            // and it leaves where it came from, but for a motion that goes on
            let letter = ["X", "Y", "Z"][axis];
            let [back, on] = if axis == 2 { ["+1", "-1"] } else { ["-1", "+1"] };
            let view = told(&setup, &format!("{way}jog {letter}{on}\njog {letter}{back}\n"));
            let [.., again, away] = &view.lines[..] else { unreachable!() };
            assert_eq!(raised(again), Some(("jog-crash-cutter", "jog-crash-hint")), "{what}: told again");
            assert_eq!((raised(away), away.state), (None, State::Menu), "{what}");
            assert!(((away.position[axis] - stop).abs() - 1.0).abs() < 1e-6, "{what}: {:?}", away.position);
        }
    }
}

// oracle: hand: wherever a cylinder comes from, it stops before the block reaches into it
#[test]
fn no_tool_passes_through_the_part() {
    let mut noise = Noise::new(11);
    let mut hits = 0;
    for number in 0..60 {
        let radius = 1.0 + 12.0 * noise.uniform();
        let setup = with_tool(120, radius, 0.0);
        let mut place = || format!("X{:.3} Y{:.3}", 220.0 * noise.uniform() - 60.0, 200.0 * noise.uniform() - 60.0);
        let script = format!("move Z30\nmove {}\nmove Z-20\nmove {}\n", place(), place());
        for line in told(&setup, &script).lines {
            let [x, y, z] = line.position;
            let beside = |at: f64, length: f64| (at - at.clamp(0.0, length)).abs();
            let apart = beside(x, 100.0).hypot(beside(y, 80.0));
            assert!(z > -1e-6 || apart > radius - 1e-4, "{number}: {script}{:?}", line.position);
            hits += usize::from(line.raised.is_some());
        }
    }
    assert!(hits > 20, "{hits}");
}

// oracle: hand: the tool meets the part on its way to the tool probe, which stands behind it
#[test]
fn a_tool_on_its_way_to_the_tool_probe_meets_the_part() {
    let mut setup = with_tool(120, 8.0, 0.0);
    let cube = Solid::new(Shape::Block { size: [20.0; 3] }, Mcs([20.0, 40.0, -30.0]));
    setup.tool_probes.push(ToolProbe::ideal(cube));
    for name in ["E_MESS_MT_DL[0]", "E_MESS_MT_DR[0]", "E_MESS_MT_D"] {
        setup.control.set(name, 40.0);
    }
    setup.control.set("_TP[0,4]", -30.0);
    setup.position = Mcs([20.0, 40.0, 5.0]);
    let view = told(&setup, "mask tool_length\nstart\n");
    assert_eq!(raised(&view.lines[1]), Some(("jog-crash-cutter", "jog-crash-reset-hint")));
    near(view.lines[1].position[2], 0.0, "Z");
}

// oracle: manual B:2888 (the probe is in the spindle), B:4147 (1x0 and 710 pass, others are 61309); hand: what passes
// and is no probe gives no signal
#[test]
fn a_tool_measures_no_workpiece() {
    let start = "mask set_edge\nmove Z-10\nmove X-40\nstart\n";
    let view = told(&with_tool(120, 8.0, 0.0), &format!("{start}reset\njog X-1\n"));
    let line = &view.lines[3];
    assert_eq!((line.state, raised(line)), (State::Alarm, Some(("jog-crash-cutter", "jog-probe-hint"))));
    near(line.position[0], -8.0, "X");
    assert!(line.results.is_empty() && line.changes.is_empty());
    assert_eq!((view.lines[5].state, &view.lines[5].raised), (State::Mask, &None));
    let view = told(&with_tool(220, 8.0, 0.0), start);
    assert_eq!(view.lines[3].raised.as_ref().unwrap().code, "61309");
    // nothing on the way
    let mut empty = with_tool(120, 8.0, 0.0);
    empty.workpiece.solids.clear();
    assert_eq!(told(&empty, start).lines[3].raised.as_ref().unwrap().code, "61301");
    // a probe that is entered as a mill is the only one
    let mut old = with_tool(120, 3.0, 0.0);
    old.control.tools.remove(&9);
    old.control.set_variable("$TC_DP3[2,1]", 50.0);
    let view = told(&old, start);
    assert_eq!((view.lines[3].state, &view.lines[3].raised), (State::Mask, &None));
    near(view.lines[3].results[0].value, 0.0, "X0");
    let view = told(&old, "mask set_edge\nmove Z-10\nmove X-1\n");
    assert_eq!(raised(&view.lines[2]), Some(("run-crash", "jog-crash-hint")));
    near(view.lines[2].position[0], -3.0, "ball");
}

// oracle: hand: the body is 20 mm in radius and its lower face 25 mm above the ball
#[test]
fn a_body_stops_as_the_ball_does() {
    let mut setup = block();
    setup.probe.body = Some(ProbeBody { radius: 20.0, distance: 25.0 });
    setup.position = Mcs([-40.0, 40.0, 20.0]);
    let view = told(&setup, "move Z-30\nmove X-10\njog X-1\nmask set_edge\nstart\n");
    let [_, hit, back, _, start] = &view.lines[..] else { unreachable!() };
    assert_eq!(raised(hit), Some(("run-crash-body", "jog-crash-hint")));
    near(hit.position[0], -20.0, "X");
    assert_eq!(raised(back), None);
    assert_eq!(raised(start), Some(("run-crash-body", "jog-crash-reset-hint")));
    assert!(view.lines.iter().all(|line| line.notes.is_empty()), "told once");
    // its lower face on the upper face of the block
    let view = told(&setup, "move X-10\nmove Z-40\njog Z-1\njog Z+1\n");
    let [_, down, again, up] = &view.lines[..] else { unreachable!() };
    near(down.position[2], -25.0, "Z");
    assert_eq!([down, again].map(raised), [Some(("run-crash-body", "jog-crash-hint")); 2]);
    assert_eq!(raised(up), None);
    near(up.position[2], -24.0, "Z");
}

// oracle: manual B:2748-2752, hand: the spindle nose stays, the probe stands along Y, 50 mm long
#[test]
fn the_plane_takes_effect_at_once() {
    let mut setup = block();
    setup.position = Mcs([-30.0, 40.0, -10.0]);
    setup.control.set("_JM_I[4]", 0.0);
    let view = told(&setup, "mask align_edge\nstart\nset _JM_I[3] = 18\nset _JM_I[3] = 19\nset _JM_I[3] = 17\n");
    let [_, first, turned, beside, back] = &view.lines[..] else { unreachable!() };
    assert_eq!((first.plane, first.points.len()), (["X", "Y"], 1));
    assert_eq!((turned.plane, turned.position), (["Z", "X"], [-30.0, -10.0, 40.0]));
    assert_eq!((beside.plane, beside.position), (["Y", "Z"], [-80.0, 40.0, 40.0]));
    assert_eq!((back.plane, back.position), (["X", "Y"], [-30.0, 40.0, -10.0]));
    // the point of another plane does not count
    let view = told(&setup, "mask align_edge\nstart\nset _JM_I[3] = 18\nset _JM_I[3] = 17\nstart\n");
    assert_eq!((view.lines[4].state, view.lines[4].points[0].name.as_str()), (State::Mask, "P1"));
    // NC start changes nothing of it
    let mut session = Session::new(&setup);
    session.press(Input::Function("set_edge")).unwrap();
    session.sim.control.set("_JM_I[3]", 18.0);
    session.settle();
    let (plane, position) = (session.sim.control.plane, session.sim.position);
    session.press(Input::Start).unwrap();
    assert_eq!((plane, session.sim.position), (Plane::G18, position));
    // a machine that stands in another plane than that of the set-up
    setup.control.set("_JM_I[3]", 19.0);
    assert_eq!(Session::new(&setup).sim.control.plane, Plane::G19);
}

// oracle: manual B:14321-14336, B:14175
#[test]
fn data_that_cannot_be_are_refused() {
    for (line, key) in [
        ("_JM_I[4] = 77777", "jog-datum-range"),
        ("_JM_I[4] = -1", "jog-datum-range"),
        ("_JM_I[4] = 1.5", "jog-datum-whole"),
        ("_JM_I[0] = 2", "jog-datum-choice"),
        ("_JM_B[2] = 7", "jog-datum-choice"),
        ("_JM_I[1] = -1", "jog-datum-least"),
        ("E_MESS_D_M = 0", "jog-datum-above"),
        ("E_MESS_MT_DIR[0] = 0", "jog-datum-choice"),
        ("_JM_B[5] = 0.5", "jog-datum-choice"),
        ("E_MESS_SETT[9] = 0.5", "jog-datum-choice"),
        ("PW-JOG = 0.5", "jog-datum-choice"),
        ("PW-JOG = 2", "jog-datum-choice"),
        ("PW-GENERATION = 4", "jog-datum-choice"),
        ("MD10240 = 2", "jog-datum-choice"),
    ] {
        let view = told(&block(), &format!("set {line}\n"));
        assert_eq!(view.lines[0].refused.as_ref().unwrap().key, key, "{line}");
        assert!(view.lines[0].changes.is_empty());
    }
    for line in [
        "_JM_I[4] = 99", "_JM_I[4] = 100", "_JM_I[3] = 18", "_JM_I[0] = 1", "E_MESS_D_M = 0.5",
        "E_MESS_MT_DIR[0] = -2", "PW-JOG = 1",
    ] {
        assert_eq!(told(&block(), &format!("set {line}\n")).lines[0].refused, None, "{line}");
    }
}

// oracle: hand (B:14170-14172: the data of JOG are metric on any machine)
#[test]
fn a_machine_in_inches_says_that_jog_is_metric() {
    let told = |units: Units| jog_in_mm(&delivery_in(Dialect::Sinumerik, units)).is_some();
    assert_eq!([Units::Metric, Units::Inch].map(told), [false, true]);
    assert!(jog_in_mm(&practice::machine(Piece::Block).control).is_none());
}

// oracle: hand (B:14170-14172: the data of JOG are metric; numbers and flags have no unit)
#[test]
fn what_is_set_is_told_in_its_unit() {
    for (name, value, unit) in [
        ("PW-JOG", 1.0, ""),
        ("MD20050[0]", 2.0, ""),
        ("R1", 5.0, ""),
        ("_JM_I[4]", 1.0, ""),
        ("E_MESS_FM", 200.0, ""),
        ("E_MESS_D_M", 40.0, "mm"),
        ("$P_UIFR[1,X,TR]", 5.0, "mm"),
        ("$P_UIFR[1,X,RT]", 5.0, "deg"),
        ("$TC_DP1[9,1]", 120.0, ""),
        ("$TC_DP3[9,1]", 51.0, "mm"),
        ("_WP[0,0]", 5.9, "mm"),
    ] {
        let view = told(&block(), &format!("set {name} = {value}\n"));
        let changes: Vec<_> =
            view.lines[0].changes.iter().map(|one| (one.name.as_str(), one.after, one.unit)).collect();
        assert_eq!(changes, [(name, value, unit)]);
    }
    let mut setup = block();
    setup.control = delivery_in(Dialect::Sinumerik, Units::Inch);
    let view = told(&setup, "set E_MESS_D_M = 40\n");
    assert_eq!((view.lines[0].changes[0].before, view.lines[0].changes[0].after), (50.0, 40.0));
}

// oracle: hand (as P-CHANGE of the sequence: else points of different meaning would be combined): another WCS of the
// measurement, or another probe, rejects the stored points; what changes neither does not
#[test]
fn points_of_another_wcs_or_probe_are_rejected() {
    let mut setup = block();
    setup.control.frames.entry(1).or_default().rotation[2] = 4.0;
    let edge = setup.control.tools[&9].edges[&1].clone();
    setup.control.tools.entry(8).or_default().edges.insert(1, Edge { length: [60.0, 0.0, 0.0], ..edge });
    let first = "mask align_edge\nzo = G55\naxis = X\nref_axis = Y\nmove machine X-20 Y20 Z-5\nstart\n";
    for (line, rejects) in [
        ("set _JM_I[4] = 1", true),
        ("set _JM_I[4] = 0", false),
        ("set $P_UIFR[0,Y,TR] = 3", true),
        ("set $P_UIFR[2,Y,TR] = 3", false),
        ("set $P_SETFR[Z,RT] = 1", true),
        ("set _WP[0,1] = 2.9", true),
        ("set E_MESS_D_M = 40", false),
        ("set _JM_I[3] = 18", true),
        ("axis = Y", true),
        ("tool T8", true),
    ] {
        let view = told(&setup, &format!("{first}{line}\n"));
        let last = view.lines.last().unwrap();
        assert_eq!((last.refused.as_ref(), last.state), (None, State::Mask), "{line}");
        let told: Vec<&str> = last.notes.iter().map(|note| note.key.as_ref()).collect();
        assert_eq!(told, if rejects { &["jog-rejected"][..] } else { &[] }, "{line}");
        assert_eq!(last.plc[4], !rejects, "{line}");
    }
    // all stored, then the WCS changes: Calculate is gone
    let view = told(&setup, &format!("{first}jog Y40\nstart\nset _JM_I[4] = 1\ncalculate\n"));
    assert_eq!(view.lines.last().unwrap().refused.as_ref().unwrap().key, "jog-missing");
    // one that waits to be stored by hand is none
    let older = "set PW-JOG = 1\nmask old_corner\nmove machine X20 Y-20 Z-5\nstart\nset _JM_I[4] = 1\nstore P1\n";
    let view = told(&setup, older);
    let [.., changed, stored] = &view.lines[..] else { unreachable!() };
    assert_eq!(changed.notes[0].key, "jog-rejected");
    assert_eq!(stored.refused.as_ref().unwrap().key, "jog-older-order");
}
