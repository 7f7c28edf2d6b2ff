//! Alarms of newer controls that the older one does not have, or whose remedy differs there: by the remedies that the
//! newer controls show. Their words are `newer-alarm-` with the number.

/// Numbers in order. 62303 to 62306 are the warnings that go with 61303 to 61306.
pub const NEWER: &[u32] = &[
    61_307, 61_309, 61_313, 61_320, 61_328, 61_333, 61_338, 61_339, 61_341, 61_343, 61_344, 61_345, 61_346, 61_347,
    61_349, 61_350, 61_351, 61_357, 61_364, 61_365, 61_366, 61_367, 61_368, 61_369, 61_372, 61_373, 61_374, 61_375,
    61_376, 61_377, 61_378, 61_379, 61_380, 61_401, 61_402, 61_405, 61_415, 61_416, 61_418, 61_419, 61_420, 61_421,
    61_422, 61_423, 61_424, 61_425, 61_426, 61_427, 61_428, 61_429, 61_430, 61_440, 61_441, 61_442, 61_443, 61_444,
    61_445, 61_446, 62_303, 62_304, 62_305, 62_306, 62_312, 62_315, 62_316, 62_317, 62_318, 62_319, 62_320, 62_377,
];

/// Key of what a newer control says about an alarm; none: what the older one says, as far as it is known.
pub fn key(code: &str) -> Option<String> {
    let number: u32 = code.parse().ok()?;
    NEWER.contains(&number).then(|| format!("newer-alarm-{number}"))
}

#[cfg(test)]
mod tests {
    use crate::catalogue::alarms::cure;
    use crate::control::{GENERATION, delivery};
    use crate::diagnostic::Code;
    use crate::dialect::Dialect;

    // oracle: peer (remedies of newer controls: 61338 names setting data in the place of `_SPEED[]`)
    #[test]
    fn a_remedy_is_that_of_the_generation() {
        let mut control = delivery(Dialect::Sinumerik);
        let mut of = |generation: f64, code: u32| {
            control.set(GENERATION, generation);
            cure(Code::Alarm(code), &control)
        };
        let all = [(0.0, 61_338), (1.0, 61_338), (2.0, 61_338), (3.0, 61_338), (3.0, 61_301)];
        let found = all.map(|(generation, code)| of(generation, code));
        let (older, newer) = ("alarm-61338.cure", "newer-alarm-61338");
        assert_eq!(found, [older, older, newer, newer, "alarm-61301.cure"]);
    }
}
