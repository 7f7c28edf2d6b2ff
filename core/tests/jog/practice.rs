//! The machine to practise on, as a page shows it: what is on the screen, what is refused, how far what was written is
//! from where the part lies.

use super::near;
use probewright_core::app::{
    JogAhead, PracticeFace, PracticePart, PracticeRequest, PracticeView, approach, jog, practise,
};
use probewright_core::dialect::Dialect;
use probewright_core::geometry::Degrees;
use probewright_core::jog::practice::{self, Piece, piece};
use probewright_core::jog::{State, masks};

fn asked(piece: Piece, script: &str) -> PracticeRequest {
    let control = Dialect::Sinumerik;
    let (setup, piece, script) = (None, Some(piece), script.to_owned());
    PracticeRequest { control, setup, piece, script, seed: None, part: None, hides: false }
}

fn seen(asked: PracticeRequest) -> PracticeView {
    let (view, source) = practise(asked).unwrap();
    assert!(!source.outcome.trace.entries.is_empty(), "the probe is to be seen");
    assert!(view.from <= source.outcome.trace.entries.len());
    view
}

/// The left face of the block.
const EDGE: &str = "mask set_edge\nzo = G54\nmove Z-8\nstart\n";
/// Its front and its left face.
const CORNER: &str = "mask corner_right\nzo = G54\nmove Y-25\nmove X20\nmove Z-8\nstart\nmove X80\nstart\n\
                      move X-25\nmove Y40\nstart\ncalculate\n";

// oracle: hand: the face lies where the slider put it, and half the oversize further out
#[test]
fn a_face_is_found_where_it_was_put() {
    let part = PracticePart { dx: 1.5, size: 0.4, ..PracticePart::default() };
    let view = seen(PracticeRequest { part: Some(part), ..asked(Piece::Block, EDGE) });
    assert_eq!((view.state, view.raised, view.refused), (State::Activate, None, None));
    let change = view.changes.iter().find(|change| change.name == "$P_UIFR[1,X,TR]").unwrap();
    near(change.after, 1.3, "G54");
    let off = view.deviation.unwrap();
    assert_eq!(off.offset, "G54");
    assert_eq!(off.figures.iter().map(|one| (one.axis, one.unit)).collect::<Vec<_>>(), [("X", "mm"), ("Z", "deg")]);
    off.figures.iter().for_each(|one| near(one.value, 0.0, one.axis));
}

// oracle: hand: an edge says nothing of the angle, a corner does; a part that leans is found to some hundredths
#[test]
fn what_is_left_of_the_angle_is_told() {
    let turned = PracticePart { dx: -2.0, dy: 1.0, tilt: Degrees(2.0), ..PracticePart::default() };
    let of = |script: &str| {
        let view = seen(PracticeRequest { part: Some(turned), ..asked(Piece::Block, script) });
        assert_eq!((view.raised, view.refused), (None, None), "{script}");
        view.deviation.unwrap().figures.iter().map(|one| (one.axis, one.value)).collect::<Vec<_>>()
    };
    let edge = of(EDGE);
    near(edge[1].1, -2.0, "the WCS is not turned, the part is");
    for (axis, value) in of(CORNER) {
        near(value, 0.0, axis);
    }
    for seed in 1..20 {
        let view = seen(PracticeRequest { seed: Some(seed), ..asked(Piece::Block, CORNER) });
        assert_eq!(view.truth.seed, u64::from(seed));
        let found = view.deviation.unwrap().figures;
        assert!(found.iter().all(|one| one.value.abs() < 0.1), "{seed}: {found:?}");
    }
}

// oracle: hand: the plane is aligned by the angles about abscissa and ordinate by which the part was made to lean
#[test]
fn a_plane_is_aligned_by_the_angles_of_its_lean() {
    let (lean_abscissa, lean_ordinate) = (Degrees(1.5), Degrees(-0.8));
    let part = PracticePart { dz: 0.4, lean_abscissa, lean_ordinate, ..PracticePart::default() };
    let script = "mask align_plane\nzo = G54\nmove Z10\nmove X20 Y20\nstart\nmove X80\nstart\nmove X50 Y60\nstart\n\
                  calculate\n";
    let view = seen(PracticeRequest { part: Some(part), ..asked(Piece::Block, script) });
    assert_eq!((view.raised, view.refused), (None, None));
    for (axis, angle) in [("X", lean_abscissa), ("Y", lean_ordinate)] {
        let name = format!("$P_UIFR[1,{axis},RT]");
        let change = view.changes.iter().find(|change| change.name == name).unwrap();
        near(change.after, angle.0, &name);
    }
    view.deviation.unwrap().figures.iter().for_each(|one| near(one.value, 0.0, one.axis));
}

// oracle: definition: how far what is written is from where the part lies does not depend on what was written before,
// nor on the zero offset in which was measured
#[test]
fn the_mark_does_not_depend_on_the_zero_offset_before() {
    let part = PracticePart { dx: 1.5, dy: -0.7, tilt: Degrees(2.0), ..PracticePart::default() };
    let edge = "mask set_edge\nzo = G54\nx0 = 4\nmove machine Z-8\nstart\n";
    let other = "mask set_edge\nzo = G54\naxis = Y\nmove machine Y-25\nmove machine X50\nmove machine Z-8\nstart\n";
    let hole = "mask hole_1\nzo = G54\ndiameter = 40\nmove machine Z-10\nstart\n";
    let corner = CORNER.replace("move ", "move machine ");
    let pieces = [(Piece::Block, edge), (Piece::Block, other), (Piece::Hole, hole), (Piece::Block, &corner)];
    for (piece, script) in pieces {
        let marks = [([0.0; 3], 0), ([0.0; 3], 1), ([-20.0, 15.0, 10.0], 0), ([300.0, -200.0, 50.0], 0)];
        let marks = marks.map(|(shift, measuring)| {
            let set: Vec<String> = ["X", "Y", "Z"]
                .into_iter()
                .zip(shift)
                .map(|(axis, value)| format!("set $P_UIFR[1,{axis},TR] = {value}\n"))
                .collect();
            let script = format!("{}set _JM_I[4] = {measuring}\n{script}", set.concat());
            let view = seen(PracticeRequest { part: Some(part), ..asked(piece, &script) });
            assert_eq!((view.raised, view.refused), (None, None), "{script}");
            view.deviation.unwrap().figures.iter().map(|one| (one.axis, one.value)).collect::<Vec<_>>()
        });
        for mark in &marks {
            assert_eq!(mark.len(), marks[0].len());
            mark.iter().zip(&marks[0]).for_each(|(one, first)| near(one.1, first.1, &format!("{script}: {}", one.0)));
            mark.iter().filter(|one| one.0 != "Z").for_each(|one| assert!(one.1.abs() < 0.02, "{script}: {marks:?}"));
        }
    }
}

// oracle: hand: what calibrates wrongly makes every measurement wrong by as much
#[test]
fn a_wrong_calibration_shows() {
    let wrong = "mask cal_radius\nd = 40.2\nmove Z-10\nstart\n";
    let hole = format!("{wrong}mask hole_1\nzo = none\ndiameter = 40\nstart\n");
    let view = seen(asked(Piece::Hole, &hole));
    assert_eq!((view.raised, view.refused), (None, None));
    near(view.mask.unwrap().shows[2].figures[0].value, 40.2, "diameter");
    let edge = format!("{wrong}mask set_edge\nzo = G54\naxis = X\ndirection = +\nstart\n");
    near(seen(asked(Piece::Hole, &edge)).deviation.unwrap().figures[0].value, 0.1, "the wall at X plus");
}

// oracle: manual: the table of masks
#[test]
fn each_mask_opens_on_its_piece() {
    for mask in masks::all() {
        let version = u8::from(mask.older.is_some());
        let view = seen(asked(piece(mask), &format!("set PW-JOG = {version}\nmask {}", mask.name)));
        assert_eq!((view.state, view.refused), (State::Mask, None), "{}", mask.name);
        let open = view.mask.unwrap();
        assert_eq!((open.name, open.fields.is_empty()), (mask.name, false));
        assert_eq!(open.help.len(), 6, "measures, before, order, corrects, wrong, where: {}", mask.name);
        assert_eq!(view.points.len(), if mask.points == 1 { 0 } else { mask.points });
        let listed = view.areas.iter().flat_map(|area| &area.masks);
        assert_eq!(listed.filter(|one| one.name == mask.name && one.piece == piece(mask)).count(), 1);
    }
    let view = seen(asked(Piece::Block, ""));
    assert_eq!(view.areas.iter().map(|area| area.masks.len()).sum::<usize>(), 21);
    assert_eq!((view.state, view.mask), (State::Menu, None));
}

// oracle: hand
#[test]
fn what_does_nothing_leaves_everything_as_it_was() {
    for (line, key) in [
        ("x0 = far", "jog-wrong-number"),
        ("x0 =", "jog-empty-number"),
        ("axis =", "jog-empty-word"),
        ("diameter = 5", "jog-no-field"),
        ("calculate", "jog-at-once"),
        ("reject P1", "jog-grey"),
        ("move X", "jog-script-move"),
        ("fly", "jog-script-command"),
    ] {
        let view = seen(asked(Piece::Block, &format!("mask set_edge\nx0 = 5\n{line}\nx0 = 7\n")));
        let refused = view.refused.unwrap();
        assert_eq!((refused.line, refused.message.key.as_ref()), (3, key), "{line}");
        let fields = view.mask.unwrap().fields;
        let x0 = fields.iter().find(|field| field.name == "x0").unwrap();
        assert_eq!(x0.value, probewright_core::jog::values::Value::Number(5.0));
    }
    let nct = PracticeRequest { control: Dialect::Nct, ..asked(Piece::Block, "") };
    assert!(practise(nct).is_err());
}

// oracle: hand: the face lies at X 0, the ball has a radius of 3
#[test]
fn what_is_hit_stops_and_is_left_backwards() {
    let crash = "mask set_edge\nmove Z-8\njog X+60\n";
    let view = seen(asked(Piece::Block, crash));
    let raised = view.raised.unwrap();
    assert_eq!(raised.message.key, "run-crash");
    assert_eq!(raised.hint.unwrap().key, "jog-crash-hint");
    near(view.machine.mcs[0], -3.0, "X");
    let view = seen(asked(Piece::Block, &format!("{crash}jog X-1\n")));
    assert_eq!((view.raised, view.state), (None, State::Mask));
    near(view.machine.mcs[0], -4.0, "X");
}

/// What the next key would do, and what it does.
fn before_and_after(piece: Piece, script: &str, keys: &str) -> (JogAhead, PracticeView) {
    let ahead = seen(asked(piece, script)).ahead.unwrap();
    (ahead, seen(asked(piece, &format!("{script}{keys}"))))
}

// oracle: self: what is told before is what happens then
#[test]
fn what_would_happen_happens() {
    let edge = EDGE.strip_suffix("start\n").unwrap();
    let (ahead, after) = before_and_after(Piece::Block, edge, "start\n");
    assert_eq!((ahead.start, ahead.point, ahead.activates), (true, None, after.state == State::Activate));
    assert_eq!(ahead.changes, after.changes);
    assert_eq!((ahead.raised, ahead.refused), (None, None));
    let shown = after.mask.unwrap().shows;
    near(ahead.results[0].value, shown.last().unwrap().figures[0].value, "meas X0");
    // the left face lies at X 0 and the ball has a radius of 3
    assert_eq!(ahead.touches.len(), 1);
    near(ahead.touches[0][0], -3.0, "X");
    // the last of three points, with Calculate
    let corner = CORNER.strip_suffix("start\ncalculate\n").unwrap();
    let (ahead, after) = before_and_after(Piece::Block, corner, "start\ncalculate\n");
    assert_eq!((ahead.point.as_deref(), &ahead.changes), (Some("P3"), &after.changes));
    assert!(!ahead.changes.is_empty() && ahead.results.len() == 3);
    let (ahead, after) = before_and_after(Piece::Block, &format!("{corner}start\n"), "calculate\n");
    assert_eq!((ahead.start, ahead.touches.len(), ahead.changes), (false, 0, after.changes));
    // not the last one
    let (ahead, after) = before_and_after(Piece::Block, "mask align_edge\nmove X-20 Z-8\n", "start\n");
    assert_eq!((ahead.point.as_deref(), ahead.results.len(), ahead.changes.len()), (Some("P1"), 0, 0));
    assert_eq!(Some(ahead.touches[0]), after.points[0].stored.as_ref().unwrap().touch);
    // four touches of a hole
    let hole = "mask hole_1\ndiameter = 40\nmove Z-8\n";
    assert_eq!(seen(asked(Piece::Hole, hole)).ahead.unwrap().touches.len(), 4);
}

// oracle: hand: nothing is within twice the measuring path; the probe is to be calibrated as it is used (B:13669)
#[test]
fn what_would_go_wrong_is_told() {
    let far = "mask set_edge\nzo = G54\nmove Z-8\nmove X-300\n";
    let (ahead, after) = before_and_after(Piece::Block, far, "start\n");
    assert_eq!(ahead.raised.as_ref().unwrap().code, "61301");
    assert_eq!((ahead.raised, ahead.changes.len(), ahead.results.len()), (after.raised, 0, 0));
    let other = "mask set_edge\nset _WP[0,9] = 18\n";
    assert_eq!(seen(asked(Piece::Block, other)).ahead.unwrap().raised.unwrap().code, "61341");
    let same = "mask align_edge\nref_axis = Y\nmove X-20 Z-8\nstart\n";
    assert_eq!(seen(asked(Piece::Block, same)).ahead.unwrap().refused.unwrap().key, "jog-same-place");
    // in the menu, and where a field is wrong, there is nothing to tell
    assert_eq!(seen(asked(Piece::Block, "")).ahead, None);
    assert_eq!(seen(asked(Piece::Hole, "mask cal_radius\nset E_MESS_CAL_D[0] = 0\n<<\nmask cal_radius\n")).ahead, None);
}

// oracle: definition: while nobody is to know how the part lies, what is told is the same however it lies
#[test]
fn what_is_hidden_is_not_told_ahead() {
    let start = |script: &'static str| script.split_once("start\n").unwrap().0;
    let last = CORNER.strip_suffix("start\ncalculate\n").unwrap();
    for (piece, script) in [
        (Piece::Block, start(EDGE)),
        (Piece::Block, start(CORNER)),
        (Piece::Block, last),
        (Piece::Block, "mask set_edge\nmove Z-8\nmove X-300\n"),
        (Piece::Block, "mask set_edge\nset _WP[0,9] = 18\n"),
        (Piece::Hole, "mask hole_1\nzo = G55\ndiameter = 40\nmove Z-8\n"),
        (Piece::Hole, "mask cal_radius\nd = 40\nmove Z-8\n"),
    ] {
        let told =
            |seed| seen(PracticeRequest { seed: Some(seed), hides: true, ..asked(piece, script) }).ahead.unwrap();
        let first = told(1);
        assert!((2..8).all(|seed| told(seed) == first), "{script}");
        assert!(first.touches.is_empty() && first.results.is_empty() && first.changes.is_empty(), "{script}");
    }
}

// oracle: hand: the point that is stored, the zero offset and the question follow from the mask; 61341 from the data of
// the probe (B:13669)
#[test]
fn what_the_call_says_is_told_although_the_part_is_hidden() {
    let told = |script: &str| {
        let ahead = seen(PracticeRequest { seed: Some(3), hides: true, ..asked(Piece::Block, script) }).ahead.unwrap();
        let hidden = ahead.hidden.clone().unwrap();
        let shows = hidden.shows.iter().map(|one| one.key.clone().into_owned()).collect::<Vec<_>>();
        (ahead, shows, hidden.corrects)
    };
    let (ahead, shows, corrects) = told(EDGE.strip_suffix("start\n").unwrap());
    assert_eq!((ahead.point, ahead.activates, ahead.raised), (None, true, None));
    assert_eq!((shows, corrects.as_deref()), (vec!["jog-result-meas-x0".to_owned()], Some("G54")));
    let (ahead, shows, corrects) = told("mask corner_right\nzo = none\nmove Y-25\nmove X20\nmove Z-8\n");
    assert_eq!((ahead.point.as_deref(), ahead.activates, shows.len(), corrects), (Some("P1"), false, 0, None));
    let (ahead, shows, _) = told("mask set_edge\nzo = G54\nset _WP[0,9] = 18\n");
    assert_eq!((ahead.raised.unwrap().code, ahead.activates, shows.len()), ("61341".into(), false, 0));
    // what Calculate would do follows from points that are on the screen
    let script = CORNER.strip_suffix("calculate\n").unwrap();
    let ready = seen(PracticeRequest { seed: Some(3), hides: true, ..asked(Piece::Block, script) }).ahead.unwrap();
    assert!(!ready.start && ready.hidden.is_none() && ready.results.len() == 3);
}

/// The line that puts the probe in front of a face, or why there is none.
fn faced(piece: Piece, script: &str, at: [f64; 3], normal: [f64; 3]) -> Result<Option<String>, String> {
    let told = approach(PracticeFace { practice: asked(piece, script), at, normal }).unwrap();
    told.refused.map_or(Ok(told.line), |why| Err(why.key.into_owned()))
}

// oracle: hand: half of E_MESS_D_M = 50 mm and the radius of 3 mm before a face; the block is from X 0 Y 0 Z -40 to
// X 100 Y 80 Z 0 and the probe comes from X -30 Y 40 Z 30
#[test]
fn the_probe_gets_in_front_of_a_face() {
    let block = |at, normal| faced(Piece::Block, "mask set_edge\nzo = G54\n", at, normal).unwrap().unwrap();
    let right = block([100.0, 30.0, -8.0], [1.0, 0.0, 0.0]);
    assert!(right.starts_with("move machine X128 Y30 Z-"), "{right}");
    let front = block([20.0, 0.0, -8.0], [0.0, -1.0, 0.0]);
    assert!(front.starts_with("move machine X20 Y-28 Z-"), "{front}");
    // the line is carried out, and what is measured there is the face
    let script = format!("mask set_edge\nzo = G54\ndirection = -\n{right}\n");
    let view = seen(asked(Piece::Block, &script));
    assert_eq!((view.raised, view.refused), (None, None));
    near(view.ahead.unwrap().results[0].value, 100.0, "right face");
    assert_eq!(faced(Piece::Block, &script, [100.0, 30.0, -8.0], [1.0, 0.0, 0.0]), Ok(None), "it is there");
    // a probe that is deep beside the block first goes up
    let beside = format!("{script}mask set_edge\n");
    let left = faced(Piece::Block, &beside, [0.0, 30.0, -8.0], [-1.0, 0.0, 0.0]).unwrap().unwrap();
    let view = seen(asked(Piece::Block, &format!("{beside}{left}\n")));
    assert!(left.starts_with("move machine Z") && view.raised.is_none(), "{left}: {:?}", view.raised);
    near(view.machine.mcs[0], -28.0, "X");
}

// oracle: hand: a hole of 40 mm about X 50 Y 40 is measured from its middle
#[test]
fn an_element_is_measured_from_inside_its_middle() {
    let script = "mask hole_1\ndiameter = 40\n";
    let line = faced(Piece::Hole, script, [70.0, 40.0, -10.0], [-1.0, 0.0, 0.0]).unwrap().unwrap();
    let view = seen(asked(Piece::Hole, &format!("{script}{line}\n")));
    assert_eq!((view.raised, view.refused), (None, None), "{line}");
    assert!((view.machine.mcs[0] - 50.0).abs() < 0.01 && (view.machine.mcs[1] - 40.0).abs() < 0.01, "{line}");
    assert!(view.ahead.unwrap().raised.is_none());
}

// oracle: hand
#[test]
fn what_cannot_be_reached_is_told() {
    let edge = "mask set_edge\n";
    for (piece, script, at, normal, key) in [
        (Piece::Block, edge, [50.0, 40.0, -40.0], [0.0, 0.0, -1.0], "jog-face-below"),
        (Piece::Block, edge, [50.0, 40.0, 0.0], [0.0; 3], "jog-face-nothing"),
        (Piece::Block, edge, [1e300, 40.0, 0.0], [0.0, 0.0, 1.0], "jog-face-nothing"),
        (Piece::Block, "tool T0\n", [50.0, 40.0, 0.0], [0.0, 0.0, 1.0], "jog-face-no-probe"),
        (Piece::Probe, "", [50.0, 40.0, 50.0], [0.0, 0.0, 1.0], "jog-face-no-probe"),
    ] {
        assert_eq!(faced(piece, script, at, normal), Err(key.to_owned()), "{piece:?} {at:?}");
    }
}

// oracle: hand: the tool probe is a cube of 20 mm with its upper face at Z 50; T1 with its 80 mm stands over it at Z
// 60, where T2 with its 95 mm, of which the data know 94.8, would be 5 mm in it
#[test]
fn a_tool_is_not_taken_where_there_is_no_room() {
    let before = "tool T1\nmove machine Z60\n";
    let view = seen(asked(Piece::Probe, &format!("{before}tool T2 D1\n")));
    let refused = view.refused.unwrap();
    assert_eq!((refused.line, refused.message.key.as_ref()), (3, "jog-tool-room"));
    near(view.machine.mcs[2], 60.0, "Z");
    let view = seen(asked(Piece::Probe, &format!("{before}move machine Z70\ntool T2 D1\n")));
    assert_eq!((view.refused, view.raised), (None, None));
    near(view.machine.mcs[2], 55.2, "Z");
    // who stands in it all the same gets out upwards, and nowhere else
    let mut setup = practice::machine(Piece::Probe);
    setup.control.tool = 2;
    setup.position.0[2] = 40.0;
    let raised = |script: &str| {
        let view = jog(script, &setup, None).unwrap();
        let line = view.lines.last().unwrap();
        (line.raised.is_some(), line.position[2])
    };
    assert_eq!(raised("jog Z20\n"), (false, 60.0));
    assert_eq!(raised("jog X5\n"), (true, 40.0));
    assert_eq!(raised("jog Z-5\n"), (true, 40.0));
}
