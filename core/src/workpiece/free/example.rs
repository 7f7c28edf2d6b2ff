//! Surfaces of ours, as formulas.

use super::{FreeSurface, Heights, Refused};
use std::cell::RefCell;
use std::collections::VecDeque;
use std::f64::consts::PI;
use std::sync::Arc;

/// A surface of ours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Example {
    /// Part of a sphere.
    Dome,
    /// Hills and hollows.
    Waves,
    /// Higher towards two sides, lower towards the others.
    Saddle,
    /// Two levels with a flank between them.
    Step,
}

/// All of them, by name.
pub const EXAMPLES: [(&str, Example); 4] =
    [("waves", Example::Waves), ("dome", Example::Dome), ("saddle", Example::Saddle), ("step", Example::Step)];

/// Cells along the longer side.
const CELLS: f64 = 64.0;
/// What a height is rounded to, so that it is short in a file, mm.
const RESOLUTION: f64 = 1e-4;

/// Surfaces that are kept: that of a form's part and that of its picture.
const KEPT: usize = 2;

/// A surface with what it was asked for by.
type Made = ((Example, [f64; 2], f64), Arc<FreeSurface>);

thread_local! {
    /// The surfaces that were asked for last, the newest first.
    static MADE: RefCell<VecDeque<Made>> = const { RefCell::new(VecDeque::new()) };
}

impl Example {
    /// The surface of [`Example::heights`]. A form asks for the same at every keystroke: it is made once and shared.
    ///
    /// # Errors
    /// The heights are no grid, or not numbers.
    pub fn surface(self, size: [f64; 2], height: f64) -> Result<Arc<FreeSurface>, Refused> {
        let asked = (self, size, height);
        let known =
            |made: &VecDeque<Made>| made.iter().find(|(by, _)| *by == asked).map(|(_, known)| Arc::clone(known));
        if let Some(known) = MADE.with_borrow(known) {
            return Ok(known);
        }
        let surface = Arc::new(self.heights(size, height).surface()?);
        MADE.with_borrow_mut(|made| {
            made.push_front((asked, Arc::clone(&surface)));
            made.truncate(KEPT);
        });
        Ok(surface)
    }

    /// Over a rectangle X × Y, mm, from 0 down to so many mm; a dome is no higher than half a sphere.
    pub fn heights(self, size: [f64; 2], height: f64) -> Heights {
        let cell = size[0].max(size[1]) / CELLS;
        let cells = size.map(|length| (length / cell).round() as usize);
        let half = size.map(|length| length / 2.0);
        Heights::over(size, cells, |x, y| {
            let (u, v) = (x / half[0], y / half[1]);
            let exact = match self {
                Example::Dome => dome(x.hypot(y), half[0].hypot(half[1]), height),
                Example::Waves => height * ((2.0 * PI * u).cos() * (PI * v).cos() - 1.0) / 2.0,
                Example::Saddle => height * ((u * u - v * v) - 1.0) / 2.0,
                Example::Step => height * (((6.0 * u + v).clamp(-1.0, 1.0) * PI / 2.0).sin() - 1.0) / 2.0,
            };
            (exact / RESOLUTION).round() * RESOLUTION
        })
    }
}

/// Height at a distance from the middle, of a sphere whose top is 0 and which is `height` lower at `reach`.
fn dome(away: f64, reach: f64, height: f64) -> f64 {
    let height = height.min(reach);
    let radius = (reach * reach + height * height) / (2.0 * height);
    (radius * radius - away * away).max(0.0).sqrt() - radius
}
