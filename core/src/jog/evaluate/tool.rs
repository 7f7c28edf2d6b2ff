//! Measuring tools at the tool probe (B:3988-4083). Machine coordinates, mm.

/// How far the tool's axis stands beside the middle of the probe while its length is measured, and whether the spindle
/// rotates: a tool that is wider than the upper side touches with the place `offset` inside of its circumference.
pub fn beside(radius: f64, offset: f64, upper: f64) -> (f64, bool) {
    if 2.0 * radius > upper { (radius - offset, true) } else { (0.0, false) }
}

/// Length of a tool whose end, shown with the length that was stored, was there at switching.
pub fn new_length(stored: f64, tip: f64, trigger: f64) -> f64 {
    stored + tip - trigger
}

/// Height of the tool's end while its radius is measured: `depth` below the upper side, and lower by the height of the
/// place that is to touch.
pub fn tip_height(top: f64, depth: f64, offset: f64) -> f64 {
    top - depth - offset
}

/// Radius of a tool whose axis was there at switching.
pub fn new_radius(axis: f64, trigger: f64) -> f64 {
    (axis - trigger).abs()
}
