//! A scan of a surface in pieces: asked for once, answered with figures, points and texts.

use super::outcome::Raised;
use super::start::{Machine, start};
use super::{Error, choose_units, unknown};
use crate::control::{Plane, UnitFunction};
use crate::dialect::Dialect;
use crate::entry::Typed;
use crate::geometry::Wcs;
use crate::machine::{Setup, Stop};
use crate::refused::Path;
use crate::run::scanning::{Deviation, Session};
use crate::scan::text::{FORMS, piece};
use crate::scan::turns;
use crate::scene::Scene;
use crate::setup_file;
use crate::workpiece::{FreeSurface, Heights, Shape, Solid, free::stl_triangles};
use crate::{catalogue, check};
use serde::{Deserialize, Serialize};
use std::ops::Range;
use std::sync::Arc;

/// Most triangles of a surface that is only looked at.
const DRAWN: usize = 30_000;

/// Which surface is scanned, and how.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ScanRequest {
    /// Control.
    pub control: Dialect,
    /// A cycle that scans.
    pub cycle: String,
    /// Values as typed, by parameter.
    pub values: Typed,
    /// Machine, with a surface as its part: that of a form.
    pub setup: Machine,
    /// Working plane at the call, where it is not that of the machine.
    pub plane: Option<Plane>,
    /// G function of units at the call, likewise.
    pub units: Option<UnitFunction>,
    /// Another surface in its place, as large; absent: that of the machine.
    pub surface: Option<SurfaceChoice>,
}

/// What replaces a surface, as large as that.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum SurfaceChoice {
    /// One of ours.
    Example(String),
    /// The file is one of grey values, row by row from above, with so many in a row.
    Picture(usize),
    /// The file is an STL file; its upper side lies where that of the other surface does, and it keeps its size.
    Stl,
}

/// What came out of a scan.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ScanView {
    /// How many points were scanned.
    pub points: usize,
    /// In how many lines.
    pub lines: usize,
    /// Why it did not come to its end.
    pub alarms: Vec<Raised>,
    /// How far the points as sent are from the true surface.
    pub sent: Deviation,
    /// How far the points are from the true surface, with the ball taken out.
    pub surface: Deviation,
    /// The part.
    pub solids: Vec<Solid>,
    /// Radius of the ball, mm.
    pub radius: f64,
    /// From where the points count, machine coordinates, mm.
    pub origin: [f64; 3],
}

/// A scan that is answered in pieces.
pub struct Scan {
    session: Result<Session, Stop>,
    part: Vec<Solid>,
}

impl Scan {
    /// A scan before its first point. `file`: the bytes that the request speaks of.
    ///
    /// # Errors
    /// A cycle that does not scan, a call with errors, or a surface that cannot be touched.
    pub fn new(asked: ScanRequest, file: &[u8]) -> Result<Scan, Error> {
        let scans = || unknown("document-scan", &asked.cycle);
        let cycle = catalogue::find(asked.control, &asked.cycle).ok_or_else(scans)?;
        let mut setup = start(asked.control, Some(asked.setup))?.setup;
        if let Some(function) = asked.units {
            choose_units(&mut setup.control, function)?;
        }
        setup.control.plane = asked.plane.unwrap_or(setup.control.plane);
        if let Some(choice) = &asked.surface {
            put_surface(&mut setup, choice, file)?;
        }
        let checked = check::check(cycle, &asked.values, &setup.control);
        let inputs = checked.inputs.ok_or_else(|| unknown("document-scan-values", &asked.cycle))?;
        Ok(Scan { session: Session::new(&inputs, &setup).ok_or_else(scans)?, part: setup.workpiece.solids })
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

    /// What came out.
    pub fn view(&self) -> ScanView {
        let session = self.session.as_ref();
        let deviation = |which: usize| session.map_or(Deviation::default(), |one| one.deviation(which));
        ScanView {
            points: session.map_or(0, |one| one.cloud.points().len()),
            lines: session.map_or(0, |one| one.cloud.lines()),
            alarms: session.map_or_else(Some, |one| one.stop.as_ref()).map(Raised::stop).into_iter().collect(),
            sent: deviation(0),
            surface: deviation(1),
            solids: drawn(&self.part),
            radius: self.radius(),
            origin: self.origin(),
        }
    }

    /// The part as it is drawn.
    pub fn scene(&self) -> Scene {
        Scene::still(&drawn(&self.part), self.radius())
    }

    /// Radius of the ball, mm.
    fn radius(&self) -> f64 {
        self.session.as_ref().map_or(0.0, |session| session.layout().radius)
    }

    /// Of these points, in the order of the scan, four numbers each: X Y Z from the origin in machine coordinates, and
    /// the deviation from the true surface, mm. `surface`: of the points of the surface under the ball, else of those
    /// that are sent.
    pub fn cloud(&self, surface: bool, points: Range<usize>) -> Vec<f32> {
        let Ok(session) = &self.session else { return Vec::new() };
        let origin = self.origin();
        let (cloud, deviations) = (&session.cloud, &session.deviations);
        let numbers = |index: usize| {
            let point = match surface {
                true => cloud.surface(session.layout(), index).into(),
                false => cloud.points().get(index).copied().unwrap_or_default(),
            };
            let at = session.to_machine(Wcs(point)).0;
            let [x, y, z] = [0, 1, 2].map(|axis| (at[axis] - origin[axis]) as f32);
            [x, y, z, deviations[index][usize::from(surface)]]
        };
        let end = points.end.min(deviations.len());
        (points.start..end).flat_map(numbers).collect()
    }

    /// The turn of each point when they are drawn: the first ones are spread evenly over all, so that they show the
    /// surface where not all are drawn.
    pub fn turns(&self) -> Vec<u32> {
        let count = self.session.as_ref().map_or(0, |session| session.deviations.len());
        turns(count).into_iter().map(|turn| turn as u32).collect()
    }

    /// The text of these points in the form of this name; pieces one behind the other are the whole text.
    ///
    /// # Errors
    /// There is no form of this name.
    pub fn text(&self, form: &str, from: usize, to: usize) -> Result<String, Error> {
        let known = FORMS.iter().find(|(name, _)| *name == form);
        let (_, form) = known.ok_or_else(|| unknown("document-form", form))?;
        let Ok(session) = &self.session else { return Ok(String::new()) };
        Ok(piece(&session.cloud, session.layout(), *form, from..to))
    }

    /// The first point, machine coordinates.
    fn origin(&self) -> [f64; 3] {
        let Ok(session) = &self.session else { return [0.0; 3] };
        session.cloud.points().first().map_or([0.0; 3], |point| session.to_machine(Wcs(*point)).0)
    }
}

/// Puts another surface in the place of that of the part; false: the part has none. `file`: the bytes of which the name
/// speaks.
///
/// # Errors
/// The surface cannot be made.
pub fn put_surface(setup: &mut Setup, name: &SurfaceChoice, file: &[u8]) -> Result<bool, Error> {
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

fn instead(before: &FreeSurface, name: &SurfaceChoice, file: &[u8]) -> Result<FreeSurface, Error> {
    let [low, high] = before.bounds();
    let [x, y, height] = [0, 1, 2].map(|axis| (high[axis] - low[axis]).max(1e-3));
    match name {
        SurfaceChoice::Example(name) => setup_file::example(&Path::of(&["surface"]), name, [x, y, height]),
        SurfaceChoice::Picture(columns) => Ok(Heights::from_greys(file, *columns, [x, y], height)?.surface()?),
        SurfaceChoice::Stl => {
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
    let mut part = part.to_vec();
    for solid in &mut part {
        if let Shape::Free(surface) = &solid.shape
            && let Some(coarse) = surface.coarser(DRAWN)
        {
            solid.shape = Shape::Free(Arc::new(coarse));
        }
    }
    part
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)]
    use super::*;
    use serde_json::{Value, json};

    /// A request for the example of the form, on the machine that the form makes.
    fn request(surface: Value) -> String {
        let cycle = &crate::catalogue::p9969::P9969;
        let values = crate::catalogue::example::worked(cycle);
        let form = json!({ "control": "nct", "cycle": cycle.name, "values": values, "predict": true });
        let view = crate::json::asked::form(&form.to_string()).unwrap();
        let asked = json!({
            "control": "nct", "cycle": cycle.name, "values": values,
            "setup": view["setup"], "surface": surface,
        });
        asked.to_string()
    }

    fn begun(request: &str, file: &[u8]) -> Result<Scan, crate::json::Error> {
        Scan::new(crate::json::question(request)?, file)
    }

    fn scanned(surface: Value, file: &[u8]) -> Scan {
        let mut scan = begun(&request(surface), file).unwrap();
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
            let view = crate::json::document(&scan.view());
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
            assert!(begun(&request(surface.clone()), &file).is_err(), "{surface}");
        }
        assert!(begun("{}", &[]).is_err());
        let other = request(json!(null)).replace("G65 P9969", "G110");
        assert!(begun(&other, &[]).is_err());
    }
}
