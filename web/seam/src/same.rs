//! Whether two documents say the same.

use serde_json::Value;

/// By how much numbers may differ, as a part of them or of 1: sine and cosine of a browser are not those of a
/// processor.
pub const SAME: f64 = 1e-8;
/// Tolerance of what has single precision.
pub const SINGLE: f64 = 1e-6;

/// Where two documents differ, as a path with both; none where they are the same. Numbers may differ in their last
/// digits, by this part of them.
pub fn difference(native: &Value, browser: &Value, path: &str, part: f64) -> Option<String> {
    match (native, browser) {
        (Value::Number(one), Value::Number(other)) => {
            let (one, other) = (one.as_f64()?, other.as_f64()?);
            let near = (one - other).abs() <= part * one.abs().max(1.0);
            (!near).then(|| format!("{path}: {one} natively, {other} in the browser"))
        }
        (Value::Array(one), Value::Array(other)) if one.len() == other.len() => {
            let mut pairs = one.iter().zip(other).enumerate();
            pairs.find_map(|(index, (one, other))| difference(one, other, &format!("{path}[{index}]"), part))
        }
        (Value::Object(one), Value::Object(other)) if one.len() == other.len() => one.iter().find_map(|(name, one)| {
            let other = other.get(name).unwrap_or(&Value::Null);
            difference(one, other, &format!("{path}.{name}"), part)
        }),
        _ => (native != browser).then(|| format!("{path}: {native} natively, {browser} in the browser")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    // oracle: hand
    #[test]
    fn a_difference_names_its_place() {
        let one = json!({ "a": [1.0, { "b": "x" }] });
        assert_eq!(difference(&one, &json!({ "a": [1.000_000_000_1, { "b": "x" }] }), "", SAME), None);
        let other = difference(&one, &json!({ "a": [1.0, { "b": "y" }] }), "", SAME);
        assert_eq!(other.as_deref(), Some(".a[1].b: \"x\" natively, \"y\" in the browser"));
        assert!(difference(&one, &json!({ "a": [1.0] }), "", SAME).is_some());
        assert!(difference(&one, &json!({ "a": [1.1, { "b": "x" }] }), "", SAME).is_some());
    }
}
