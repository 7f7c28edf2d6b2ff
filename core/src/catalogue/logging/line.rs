//! What is in `_PROTVAL[2]` to `_PROTVAL[5]`: fields parted by commas, whatever separates them in the log
//! (B:11375).

/// A field of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Field<'a> {
    /// The time, `hh:mm:ss`.
    Time,
    /// A datum whose length is known on the machine only: result, R parameter, text, name of an axis.
    Datum,
    /// A text that is printed as it stands.
    Comment(&'a str),
    /// A datum that no log can show: alarm 61361.
    Unknown(&'a str),
}

/// Fields of `_OVR[]` (B:2380).
const RESULTS: usize = 32;
/// Texts of `_TXT[]` (B:11360).
const TEXTS: usize = 100;
/// Characters of the time.
const TIME: usize = 8;

impl Field<'_> {
    /// Characters that it needs, where they are known.
    pub fn width(&self) -> Option<usize> {
        match self {
            Field::Time => Some(TIME),
            Field::Comment(text) => Some(text.chars().count()),
            Field::Datum | Field::Unknown(_) => None,
        }
    }
}

/// The fields of a line.
pub fn fields(line: &str) -> impl Iterator<Item = Field<'_>> {
    line.split(',').map(|text| field(text.trim()))
}

/// Widths of the columns that a title line makes where they are not fixed: characters between its commas (B:11437).
pub fn widths(title: &str) -> impl Iterator<Item = usize> {
    title.split(',').map(|text| text.chars().count())
}

/// Names of user data begin with `_`; of these the log knows the following (B:11377-11400).
fn field(text: &str) -> Field<'_> {
    let upper = text.to_ascii_uppercase();
    match upper.as_str() {
        "_TIME" => Field::Time,
        "_AXIS" | "_AXIS1" | "_AXIS2" | "_AXIS3" => Field::Datum,
        _ if element(&upper, "_OVR").is_some_and(|index| index < RESULTS) => Field::Datum,
        _ if element(&upper, "_TXT").is_some_and(|index| index < TEXTS) => Field::Datum,
        _ if register(&upper) => Field::Datum,
        _ if upper.starts_with(['_', '$']) => Field::Unknown(text),
        _ => Field::Comment(text),
    }
}

/// Index of `_OVR[4]`.
fn element(text: &str, array: &str) -> Option<usize> {
    text.strip_prefix(array)?.strip_prefix('[')?.strip_suffix(']')?.trim().parse().ok()
}

/// `R27`.
fn register(text: &str) -> bool {
    let number = text.strip_prefix('R').unwrap_or_default();
    !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_examples_of_the_manual() {
        // oracle: manual B:11408-11411
        let kinds: Vec<Field> = fields("_AXIS,_OVR[1],_OVR[5],R27,_TXT[99],_TIME, INCH,").collect();
        let datum = Field::Datum;
        let comment = Field::Comment;
        assert_eq!(kinds, [datum, datum, datum, datum, datum, Field::Time, comment("INCH"), comment("")]);
        for unknown in ["_OVI[2]", "_OVR[32]", "_SETVAL", "$AA_IW[X]", "_TXT[100]"] {
            let first = fields(unknown).next();
            assert_eq!(first, Some(Field::Unknown(unknown)));
        }
        assert_eq!(widths("Meas. , Axis").collect::<Vec<_>>(), [6, 5]);
    }
}
