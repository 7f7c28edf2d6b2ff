//! Real roots of polynomials of low degree.

/// Real roots of `a x² + b x + c`, ascending; a linear equation where `a` vanishes.
pub fn quadratic(a: f64, b: f64, c: f64) -> Vec<f64> {
    if a.abs() < 1e-14 {
        return if b.abs() < 1e-14 { Vec::new() } else { vec![-c / b] };
    }
    let inner = b * b - 4.0 * a * c;
    if inner < 0.0 {
        return Vec::new();
    }
    let q = -0.5 * (b + inner.sqrt().copysign(b));
    let (first, second) = if q == 0.0 { (0.0, 0.0) } else { (q / a, c / q) };
    vec![first.min(second), first.max(second)]
}

/// Real roots within `[low, high]`, ascending, of a polynomial with the lowest coefficient first.
/// Between the roots of the derivative the polynomial is monotone, so that each sign change is one root.
pub fn polynomial(coefficients: &[f64], low: f64, high: f64) -> Vec<f64> {
    if coefficients.len() < 2 {
        return Vec::new();
    }
    let derivative: Vec<f64> = coefficients.iter().enumerate().skip(1).map(|(power, c)| c * power as f64).collect();
    let mut borders = vec![low];
    borders.extend(polynomial(&derivative, low, high));
    borders.push(high);
    let mut found: Vec<f64> = Vec::new();
    for pair in borders.windows(2) {
        let Some(root) = bracketed(|x| value(coefficients, x), pair[0], pair[1]) else { continue };
        if found.last() != Some(&root) {
            found.push(root);
        }
    }
    found
}

/// Root of a function near `start`, given as value and slope, by Newton's method; none where it does not close in.
pub fn newton(f: impl Fn(f64) -> (f64, f64), start: f64) -> Option<f64> {
    let mut x = start;
    for _ in 0..10 {
        let (value, slope) = f(x);
        let step = value / slope;
        if !step.is_finite() {
            return None;
        }
        x -= step;
        if step.abs() <= 1e-13 * (1.0 + x.abs()) {
            return Some(x);
        }
    }
    None
}

/// A root that is known roughly, closed in by a few steps of Newton's method, none of them longer than 0.001.
pub fn polished(f: impl Fn(f64) -> (f64, f64), start: f64) -> f64 {
    let mut x = start;
    for _ in 0..4 {
        let (value, slope) = f(x);
        let step = value / slope;
        if !step.is_finite() || step.abs() > 1e-3 {
            break;
        }
        x -= step;
    }
    x
}

/// Root of a function near two places, by the line through the last two; none where it does not close in.
pub fn secant(f: impl Fn(f64) -> f64, [mut a, mut b]: [f64; 2]) -> Option<f64> {
    let [mut at_a, mut at_b] = [f(a), f(b)];
    for _ in 0..12 {
        let last = (b - a).abs();
        let step = at_b * (b - a) / (at_b - at_a);
        let exact = at_b == 0.0 || step.abs() <= 1e-15 * (1.0 + b.abs());
        if exact || last < 1e-12 && step.abs() >= last {
            return Some(b); // nearer than that is noise
        }
        if !step.is_finite() {
            return None;
        }
        (a, at_a) = (b, at_b);
        b -= step;
        at_b = f(b);
    }
    None
}

/// Root of a function that changes sign between `low` and `high`: secant steps (Illinois), halved where they stall.
pub fn bracketed(f: impl Fn(f64) -> f64, low: f64, high: f64) -> Option<f64> {
    let (mut a, mut b) = (low, high);
    let (mut fa, mut fb) = (f(a), f(b));
    if fa == 0.0 {
        return Some(a);
    }
    if fb == 0.0 {
        return Some(b);
    }
    if fa.signum() == fb.signum() {
        return None;
    }
    for step in 0..200 {
        let secant = b - fb * (b - a) / (fb - fa);
        let x = if step % 3 == 2 || !(a.min(b)..=a.max(b)).contains(&secant) { 0.5 * (a + b) } else { secant };
        let fx = f(x);
        if fx == 0.0 || x == a || x == b {
            return Some(x);
        }
        if fx.signum() == fa.signum() {
            (a, fa) = (x, fx);
            fb *= 0.5;
        } else {
            (b, fb) = (x, fx);
            fa *= 0.5;
        }
        if (b - a).abs() <= 1e-15 * (1.0 + a.abs()) {
            break;
        }
    }
    Some(0.5 * (a + b))
}

fn value(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand: (x − 1)(x − 2)(x − 3)(x + 4)
    #[test]
    fn quartic_with_known_roots() {
        let found = polynomial(&[-24.0, 38.0, -13.0, -2.0, 1.0], -10.0, 10.0);
        assert_eq!(found.len(), 4, "{found:?}");
        for (root, expected) in found.iter().zip([-4.0, 1.0, 2.0, 3.0]) {
            assert!((root - expected).abs() < 1e-12, "{found:?}");
        }
        assert_eq!(polynomial(&[-24.0, 38.0, -13.0, -2.0, 1.0], 1.5, 2.5).len(), 1);
    }

    // oracle: hand; the small root keeps its digits
    #[test]
    fn quadratic_without_cancellation() {
        assert_eq!(quadratic(1.0, -3.0, 2.0), [1.0, 2.0]);
        assert!(quadratic(1.0, 0.0, 1.0).is_empty());
        assert_eq!(quadratic(0.0, 2.0, -3.0), [1.5]);
        let small = quadratic(1.0, -1e8, 1.0)[0];
        assert!((small / 1e-8 - 1.0).abs() < 1e-12, "{small}");
    }

    // oracle: hand: x³ = 2
    #[test]
    fn bracketed_root() {
        let root = bracketed(|x| x * x * x - 2.0, 0.0, 10.0);
        assert!(root.is_some_and(|root| (root - 2f64.cbrt()).abs() < 1e-14), "{root:?}");
        assert_eq!(bracketed(|x| x * x + 1.0, -1.0, 1.0), None);
    }

    // oracle: hand: x³ = 2; x² + 1 has none
    #[test]
    fn root_by_secants() {
        let root = secant(|x| x * x * x - 2.0, [1.2, 1.3]);
        assert!(root.is_some_and(|root| (root - 2f64.cbrt()).abs() < 1e-14), "{root:?}");
        assert_eq!(secant(|x| x * x + 1.0, [0.3, 0.7]), None);
        assert_eq!(secant(|_| 1.0, [0.3, 0.7]), None);
    }

    // oracle: hand: x³ = 2
    #[test]
    fn root_by_its_slope() {
        let root = newton(|x| (x * x * x - 2.0, 3.0 * x * x), 1.0);
        assert!(root.is_some_and(|root| (root - 2f64.cbrt()).abs() < 1e-14), "{root:?}");
        assert_eq!(newton(|x| (x * x + 1.0, 2.0 * x), 0.0), None);
        assert_eq!(newton(|x| (x * x + 1.0, 2.0 * x), 0.7), None);
    }
}
