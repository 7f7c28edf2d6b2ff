//! Points and lines of the plane, as CYCLE961 needs them.

/// Abscissa and ordinate, mm.
pub type Point = [f64; 2];

/// Unit vector at an angle to the abscissa, degree, counter-clockwise.
pub fn unit(degrees: f64) -> Point {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [cos, sin]
}

/// The point some way from another one.
pub fn along(from: Point, direction: Point, way: f64) -> Point {
    [from[0] + direction[0] * way, from[1] + direction[1] * way]
}

/// Vector from one point to another.
pub fn away(from: Point, to: Point) -> Point {
    [to[0] - from[0], to[1] - from[1]]
}

/// Cross product: positive where `v` is turned counter-clockwise from `u`, 0 where they are parallel.
pub fn across(u: Point, v: Point) -> f64 {
    u[0] * v[1] - u[1] * v[0]
}

/// Distance of two points, mm.
pub fn distance(from: Point, to: Point) -> f64 {
    let [x, y] = away(from, to);
    x.hypot(y)
}

/// Unit vector from one point to another; the abscissa where they are the same.
pub fn direction(from: Point, to: Point) -> Point {
    let length = distance(from, to);
    if length > 0.0 { away(from, to).map(|part| part / length) } else { [1.0, 0.0] }
}

/// Where the lines through two points meet, as shares of their directions from these points; none where the sine of the
/// angle between them is not above `least`.
pub fn shares([a, b]: [Point; 2], [u, v]: [Point; 2], least: f64) -> Option<[f64; 2]> {
    let turn = across(u, v);
    let parallel = turn.abs() <= least * u[0].hypot(u[1]) * v[0].hypot(v[1]);
    let between = away(a, b);
    (!parallel).then(|| [across(between, v) / turn, across(between, u) / turn])
}
