//! Whether two documents say the same.

use serde_json::Value;

/// Where two documents differ, as a path with both; none where they are the same. Numbers may differ in their last
/// digits: sine and cosine of a browser are not those of a processor.
pub fn difference(native: &Value, browser: &Value, path: &str) -> Option<String> {
    match (native, browser) {
        (Value::Number(one), Value::Number(other)) => {
            let (one, other) = (one.as_f64()?, other.as_f64()?);
            let near = (one - other).abs() <= 1e-8 * one.abs().max(1.0);
            (!near).then(|| format!("{path}: {one} natively, {other} in the browser"))
        }
        (Value::Array(one), Value::Array(other)) if one.len() == other.len() => {
            let mut pairs = one.iter().zip(other).enumerate();
            pairs.find_map(|(index, (one, other))| difference(one, other, &format!("{path}[{index}]")))
        }
        (Value::Object(one), Value::Object(other)) if one.len() == other.len() => one.iter().find_map(|(name, one)| {
            let other = other.get(name).unwrap_or(&Value::Null);
            difference(one, other, &format!("{path}.{name}"))
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
        assert_eq!(difference(&one, &json!({ "a": [1.000_000_000_1, { "b": "x" }] }), ""), None);
        let other = difference(&one, &json!({ "a": [1.0, { "b": "y" }] }), "");
        assert_eq!(other.as_deref(), Some(".a[1].b: \"x\" natively, \"y\" in the browser"));
        assert!(difference(&one, &json!({ "a": [1.0] }), "").is_some());
        assert!(difference(&one, &json!({ "a": [1.1, { "b": "x" }] }), "").is_some());
    }
}
