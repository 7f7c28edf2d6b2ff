//! A scan of a surface in pieces: asked for once, answered with figures, points and texts.

use super::setup_active::{PlaneName, choose_units, plane};
use super::{Error, dialect, object, setup_surface};
use crate::catalogue;
use crate::check::{self};
use crate::entry::Typed;
use crate::machine::{Setup, Stop};
use crate::refused::Path;
use crate::run::scanning::Deviation;
use crate::run::scanning::Session;
use crate::scan::text::{FORMS, piece};
use crate::scan::{Layout, turns};
use crate::workpiece::free::{FreeSurface, Heights, stl_triangles};
use crate::workpiece::{Shape, Solid};
use serde::Deserialize;
use serde_json::Value;
use std::ops::Range;
use std::sync::Arc;

/// Most triangles of a surface that is only looked at.
const DRAWN: usize = 30_000;

#[derive(Deserialize)]
struct Request {
    control: String,
    cycle: String,
    values: Typed,
    /// The machine, with a surface as its part.
    setup: Value,
    #[serde(default)]
    plane: Option<PlaneName>,
    #[serde(default)]
    units: Option<String>,
    /// Another surface in its place; absent: that of the setup.
    #[serde(default)]
    surface: Option<SurfaceName>,
}

/// What stands in the place of the surface of the setup, as large as that.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum SurfaceName {
    /// One of ours.
    Example(String),
    /// The file is one of grey values, row by row from above, with so many in a row.
    Picture(usize),
    /// The file is an STL file; its upper side lies where that of the other surface does, and it keeps its size.
    Stl,
}

/// A scan that is answered in pieces.
pub struct Scan {
    session: Result<Session, Stop>,
    part: Vec<Solid>,
}

impl Scan {
    /// A scan before its first point. `file`: the bytes that the request speaks of.
    pub fn new(request: &str, file: &[u8]) -> Result<Scan, Error> {
        let request: Request = super::request(request)?;
        let dialect = dialect(&request.control)?;
        let unknown = || super::unknown("document-scan", &request.cycle);
        let cycle = catalogue::find(dialect, &request.cycle).ok_or_else(unknown)?;
        let mut setup = super::start::start(dialect, Some(request.setup))?.setup;
        if let Some(name) = &request.units {
            choose_units(&mut setup.control, name)?;
        }
        if let Some(name) = request.plane {
            setup.control.plane = plane(name);
        }
        if let Some(name) = &request.surface {
            put_surface(&mut setup, name, file)?;
        }
        let checked = check::check(cycle, &request.values, &setup.control);
        let inputs = checked.inputs.ok_or_else(|| super::unknown("document-scan-values", &request.cycle))?;
        Ok(Scan { session: Session::new(&inputs, &setup).ok_or_else(unknown)?, part: setup.workpiece.solids })
    }

    /// Goes on by about so many points; true: it is over.
    pub fn advance(&mut self, points: usize) -> bool {
        match &mut self.session {
            Ok(session) => session.advance(points),
            Err(_) => true,
        }
    }

    /// How much is done, 0 to 1.
    pub fn share(&self) -> f64 {
        self.session.as_ref().map_or(1.0, Session::share)
    }

    /// What came out, as a `ScanView`.
    pub fn view(&self) -> Value {
        let stop = match &self.session {
            Ok(session) => session.stop(),
            Err(stop) => Some(stop),
        };
        let session = self.session.as_ref().ok();
        let cloud = session.map(Session::cloud);
        let which = |which: usize| deviation(session.map_or(Deviation::default(), |one| one.deviation(which)));
        object([
            ("points", cloud.map_or(0, |cloud| cloud.points().len()).into()),
            ("lines", cloud.map_or(0, |cloud| cloud.lines()).into()),
            ("alarms", stop.map(super::trace::stopped).into_iter().collect()),
            ("sent", which(0)),
            ("surface", which(1)),
            ("solids", super::setup_write::solids(&drawn(&self.part))),
            ("radius", session.map_or(0.0, |session| session.layout().radius).into()),
            ("origin", self.origin().into()),
        ])
    }

    /// Of these points, in the order of the scan, four numbers each: X Y Z from the origin in machine coordinates, and
    /// the deviation from the true surface, mm. `surface`: of the points of the surface under the ball, else of those
    /// that are sent.
    pub fn cloud(&self, surface: bool, points: Range<usize>) -> Vec<f32> {
        let Ok(session) = &self.session else {
            return Vec::new();
        };
        let origin = self.origin();
        let (cloud, layout) = (session.cloud(), session.layout());
        let deviations = session.deviations();
        let numbers = |index: usize| {
            let point = if surface {
                cloud.surface(layout, index).into()
            } else {
                cloud.points().get(index).copied().unwrap_or_default()
            };
            let [x, y, z] = session.to_machine(point);
            [
                (x - origin[0]) as f32,
                (y - origin[1]) as f32,
                (z - origin[2]) as f32,
                deviations[index][usize::from(surface)],
            ]
        };
        let end = points.end.min(deviations.len());
        (points.start..end).flat_map(numbers).collect()
    }

    /// The turn of each point when they are drawn: the first ones are spread evenly over all, so that they show the
    /// surface where not all are drawn.
    pub fn turns(&self) -> Vec<u32> {
        let count = self.session.as_ref();
        let count = count.map_or(0, |session| session.deviations().len());
        turns(count).into_iter().map(|turn| turn as u32).collect()
    }

    /// The text of these points in the form of this name; pieces one behind the other are the whole text.
    pub fn text(&self, form: &str, from: usize, to: usize) -> Result<String, Error> {
        let known = FORMS.iter().find(|(name, _)| *name == form);
        let (_, form) = known.ok_or_else(|| super::unknown("document-form", form))?;
        let Ok(session) = &self.session else {
            return Ok(String::new());
        };
        let layout: &Layout = session.layout();
        Ok(piece(session.cloud(), layout, *form, from..to))
    }

    /// The first point, machine coordinates.
    fn origin(&self) -> [f64; 3] {
        let session = self.session.as_ref().ok();
        let first = session.and_then(|session| {
            let point = session.cloud().points().first()?;
            Some(session.to_machine(*point))
        });
        first.unwrap_or_default()
    }
}

fn deviation(found: Deviation) -> Value {
    object([("greatest", found.greatest.into()), ("mean", found.mean.into())])
}

/// Puts another surface in the place of that of the part; false: the part has none. `file`: the bytes of which the name
/// speaks.
pub fn put_surface(setup: &mut Setup, name: &SurfaceName, file: &[u8]) -> Result<bool, Error> {
    let mut put = false;
    for solid in &mut setup.workpiece.solids {
        if let Shape::Free(before) = &solid.shape {
            let surface = instead(before, name, file)?;
            solid.shape = Shape::Free(Arc::new(surface));
            put = true;
        }
    }
    Ok(put)
}

fn instead(before: &FreeSurface, name: &SurfaceName, file: &[u8]) -> Result<FreeSurface, Error> {
    let [low, high] = before.bounds();
    let [x, y, height] = [0, 1, 2].map(|axis| (high[axis] - low[axis]).max(1e-3));
    match name {
        SurfaceName::Example(name) => setup_surface::example(&Path::of(&["surface"]), name, [x, y, height]),
        SurfaceName::Picture(columns) => Ok(Heights::from_greys(file, *columns, [x, y], height)?.surface()?),
        SurfaceName::Stl => {
            let mut triangles = stl_triangles(file)?;
            let [low, high] = FreeSurface::from_triangles(&triangles)?.bounds();
            let middle = [0, 1].map(|axis| (low[axis] + high[axis]) / 2.0);
            for corner in triangles.as_flattened_mut() {
                corner[0] -= middle[0];
                corner[1] -= middle[1];
                corner[2] -= high[2];
            }
            Ok(FreeSurface::from_triangles(&triangles)?)
        }
    }
}

/// The part with surfaces that are not too fine to be drawn.
fn drawn(part: &[Solid]) -> Vec<Solid> {
    let coarse = |shape: &Shape| match shape {
        Shape::Free(surface) => Some(Shape::Free(Arc::new(surface.coarser(DRAWN)?))),
        _ => None,
    };
    let mut part = part.to_vec();
    for solid in &mut part {
        if let Some(shape) = coarse(&solid.shape) {
            solid.shape = shape;
        }
    }
    part
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)]
    use super::*;
    use serde_json::json;

    /// A request for the example of the form, on the machine that the form makes.
    fn request(surface: Value) -> String {
        let cycle = &crate::catalogue::p9969::P9969;
        let values = crate::catalogue::example::worked(cycle);
        let form = json!({ "control": "nct", "cycle": cycle.name, "values": values, "predict": true });
        let view = crate::json::form(&form.to_string()).unwrap();
        let asked = json!({
            "control": "nct", "cycle": cycle.name, "values": values,
            "setup": view["setup"], "surface": surface,
        });
        asked.to_string()
    }

    fn scanned(surface: Value, file: &[u8]) -> Scan {
        let mut scan = Scan::new(&request(surface), file).unwrap();
        while !scan.advance(50) {}
        assert_eq!(scan.share(), 1.0);
        scan
    }

    const BOX: &str = "solid s\nvertex -90 -90 7\nvertex 90 -90 7\nvertex 0 120 7\nendsolid";

    // oracle: hand: the example has 6 lines; on the flat top of a file or a white picture nothing has to be taken out
    #[test]
    fn surfaces_of_all_sorts_are_scanned() {
        for (surface, file, flat) in [
            (json!(null), Vec::new(), false),
            (json!({ "example": "dome" }), Vec::new(), false),
            (json!({ "picture": 3 }), vec![255; 12], true),
            (json!("stl"), BOX.as_bytes().to_vec(), true),
        ] {
            let scan = scanned(surface.clone(), &file);
            let view = scan.view();
            assert_eq!(view["alarms"], json!([]), "{surface}");
            assert_eq!(view["lines"], 6, "{surface}");
            let points = view["points"].as_u64().unwrap() as usize;
            assert!(points >= 6 * 21, "{surface}");
            for taken_out in [false, true] {
                let whole = scan.cloud(taken_out, 0..points);
                assert_eq!(whole.len(), 4 * points);
                let [first, rest] = [0..50, 50..points + 9].map(|part| scan.cloud(taken_out, part));
                assert_eq!([first, rest].concat(), whole);
            }
            assert_eq!(scan.cloud(false, 0..1)[..3], [0.0; 3]);
            assert_eq!(scan.turns().len(), points);
            let (sent, taken) = (view["sent"]["mean"].as_f64().unwrap(), view["surface"]["mean"].as_f64().unwrap());
            assert!(if flat { sent < 0.02 } else { taken < sent / 2.0 }, "{surface} {sent} {taken}");
            let lines = |form: &str| scan.text(form, 0, points).unwrap().lines().count();
            assert_eq!((lines("points"), lines("surface")), (points, points));
            assert!(lines("program") > points);
            assert!(scan.text("picture", 0, 1).is_err());
        }
    }

    // oracle: hand
    #[test]
    fn what_is_no_surface_is_refused() {
        for (surface, file) in [
            (json!({ "example": "moon" }), vec![]),
            (json!({ "picture": 5 }), vec![0; 12]),
            (json!({ "picture": 0 }), vec![]),
            (json!("stl"), b"solid".to_vec()),
            (json!("stl"), vec![0xff; 200]),
        ] {
            assert!(Scan::new(&request(surface.clone()), &file).is_err(), "{surface}");
        }
        assert!(Scan::new("{}", &[]).is_err());
        let other = request(json!(null)).replace("G65 P9969", "G110");
        assert!(Scan::new(&other, &[]).is_err());
    }
}
