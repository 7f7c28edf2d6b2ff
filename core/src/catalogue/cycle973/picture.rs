//! CYCLE973 drawn: the surface, or the section through the reference groove, touched along the measuring axis; beside
//! the groove the stylus with what is determined about it. The groove is drawn for the cutting edge position of the
//! probe in use: of 7 the walls lie in the ordinate, of 8 in the abscissa (B:13473-13482).

use super::params::{BALL as DIAMETER, SKEW, SURFACE, TWO};
use crate::catalogue::lathe::figures;
use crate::catalogue::lathe::figures::{axis, named, per};
use crate::catalogue::prelude::*;

/// Bands of the trigger value, mm.
const BANDS: [(Name, f64, f64); 2] = [(names::TSA, -2.6, 2.6), (names::TZL, -1.2, 1.2)];
/// The grooves of both cutting edge positions: walls, base, and the upper face, mm.
const GROOVES: [(&str, f64); 7] = [
    ("_KB[0,0]", 18.0),
    ("_KB[0,1]", -18.0),
    ("_KB[0,2]", -20.0),
    ("_KB[0,3]", 18.0),
    ("_KB[0,4]", -18.0),
    ("_KB[0,5]", 20.0),
    ("_KB[0,6]", -20.0),
];
/// From the zero point to a surface, mm.
const SET: f64 = 40.0;

/// The surface on its side of the zero point, or the first pair of grooves.
pub fn stage(inputs: &Inputs) -> Staging {
    if SURFACE.holds(inputs) {
        let look = if axis(inputs) == 2 { Look::section(0) } else { Look { held: true, ..Look::ABOVE } };
        let set = (SET * per(inputs)).copysign(inputs.number(names::SETVAL));
        return figures::stage(inputs, look).with(names::SETVAL, set);
    }
    let look = Look { cut: true, ..Look::ABOVE.ways(names::MVAR) };
    let stage = figures::stage(inputs, look).ball(3.0).with(names::FA, 7.0).with(names::CALNUM, 1.0);
    let fields = Fields { edges: &[names::CALNUM], ..Fields::CYCLE };
    Staging {
        tip: Some(if turned(inputs) { 8 } else { 7 }),
        fields,
        data: GROOVES.map(|(name, value)| (name.to_owned(), value)).to_vec(),
        ..stage
    }
}

/// Whether the groove is that of cutting edge position 8: the axis of both walls says it, else the probe in use.
fn turned(inputs: &Inputs) -> bool {
    if TWO.holds(inputs) {
        return inputs.integer(names::MA) == 1;
    }
    inputs.body.is_some_and(|[abscissa, _]| abscissa == 0.0)
}

/// Setpoint or groove, direction, limits, and what is determined.
pub fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let ([seen], paper) = (looks, usize::from(axis(inputs) != 0)) else { return Vec::new() };
    let used: Vec<_> = BANDS.into_iter().filter(|(name, ..)| inputs.uses(*name)).collect();
    let mut shapes = seen.bands(ShapeKind::Tolerance, &used);
    shapes.extend(seen.arrows(names::MD, 3.0));
    shapes.extend(seen.path(names::FA, 0, 2.5));
    let Some(touch) = seen.touches.first() else { return shapes };
    let axes = [0, 1].map(|axis| (axis == paper).then_some(names::MA));
    if SURFACE.holds(inputs) {
        let [low, _] = seen.extent;
        shapes.extend(seen.position(names::SETVAL, paper, None).into_iter().take(1));
        shapes.extend(figures::set(inputs, seen, paper, low[1 - paper] - 4.0));
        shapes.extend(seen.axes(touch.at, axes).into_iter().nth(paper));
        if axis(inputs) != 2 {
            shapes.extend(figures::probe(inputs, touch.start));
        }
        return shapes;
    }
    shapes.extend(seen.axes(seen.middle(), axes));
    let turned = turned(inputs);
    let back = if turned { [0.0, 1.0] } else { [1.0, 0.0] };
    shapes.extend(figures::stylus(touch.start, back));
    let pair = (inputs.number(names::CALNUM) - 1.0).max(0.0);
    let [low, high] = seen.extent;
    let tip = line(ShapeKind::Label, vec![[high[0] + 12.0, high[1] - 4.0]]).text(if turned { "SL 8" } else { "SL 7" });
    let data = line(ShapeKind::Label, vec![[low[0] + 12.0, low[1] + 4.0]]).text(format!("_KB[{pair}]"));
    shapes.extend([tip.of(names::PRNUM), data.of(names::CALNUM)]);
    if SKEW.holds(inputs) || DIAMETER.holds(inputs) {
        shapes.extend(stylus(inputs, [high[0] + 52.0, seen.middle()[1]]));
    }
    shapes
}

/// The stylus by itself: ball diameter, and the place of the ball beside the middle of the probe. Of its own, as the
/// probe of the picture has no skew.
fn stylus(inputs: &Inputs, at: [f64; 2]) -> Vec<PictureShape> {
    let (skewed, radius) = (SKEW.holds(inputs), 8.0);
    let place = |x: f64, y: f64| add(at, [x, y]);
    let aside = if skewed { 7.0 } else { 0.0 };
    let mut shapes = vec![
        rectangle(ShapeKind::Probe, place(0.0, 30.0), [22.0, 12.0]).of(names::PRNUM),
        line(ShapeKind::Probe, vec![place(0.0, 24.0), place(aside, -16.0)]).of(names::PRNUM),
        circle(ShapeKind::Probe, place(aside, -16.0), radius).of(names::PRNUM),
        line(ShapeKind::Axis, vec![place(0.0, 40.0), place(0.0, -38.0)]).of(names::MVAR),
    ];
    if skewed {
        shapes.push(named("s", place(0.0, -34.0), place(aside, -34.0)));
        shapes.push(line(ShapeKind::Axis, vec![place(aside, -16.0), place(aside, -38.0)]).of(names::MVAR));
    }
    if DIAMETER.holds(inputs) {
        shapes.push(named("Ø", place(aside - radius, -3.0), place(aside + radius, -3.0)));
    }
    shapes
}
