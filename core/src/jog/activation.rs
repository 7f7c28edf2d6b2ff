//! The activation screen: why it is shown, its fields, its lines (B:3776-3912).

use super::offset;
use super::values::{Value, Values, wrong_word};
use crate::control::{Control, ROTARY, Store};
use crate::geometry::Degrees;
use crate::message::Message;

/// Why a zero offset that was written has to be activated.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reasons {
    /// It was not active while measuring.
    pub inactive: bool,
    /// It turns the WCS about an axis of the plane.
    pub tilts: bool,
    /// The rotary axes of the machine can turn the part until the probe stands perpendicular to the new plane.
    pub swivels: bool,
    /// It demands another position of a rotary axis: index A B C, and where it stands when the part is aligned.
    pub rotary: Option<(usize, Degrees)>,
    /// It stands there already: nothing was wrong, and nothing was written. The screen comes up all the same (B:3092).
    pub aligned: bool,
}

impl Reasons {
    /// Whether the screen is shown.
    pub fn any(self) -> bool {
        self.inactive || self.tilts || self.rotary.is_some()
    }
}

/// What is corrected, and what NC start will do.
#[derive(Clone, Debug, PartialEq)]
pub struct Activation {
    /// The zero offset that was written.
    pub store: Store,
    /// Why it is not active.
    pub reasons: Reasons,
    /// Whether the WCS was turned about the applicate.
    pub turned: bool,
    /// Values of the fields.
    pub values: Values,
}

/// Field 1: whether the zero offset becomes active.
pub const ACTIVATE: &str = "activate";
/// Whether the rotary axis moves to the position that aligns the part.
pub const POSITION: &str = "position_axis";
/// Whether the part is turned until the probe stands perpendicular to the plane (B:3880-3897).
pub const ORIENT: &str = "orient";
/// Along what the probe is retracted before.
pub const RETRACT: &str = "retract";
/// What the other fields take.
const YES: [&str; 2] = ["yes", "no"];
/// What the retraction takes.
const WAYS: [&str; 2] = ["Z", "no"];

/// What a field takes, the first one as the screen comes up.
pub fn choices(name: &str) -> [&'static str; 2] {
    if name == RETRACT { WAYS } else { YES }
}

impl Activation {
    /// As the screen comes up.
    pub fn new(store: Store, reasons: Reasons, turned: bool) -> Activation {
        let mut values = Values::default();
        for name in [ACTIVATE, ORIENT, RETRACT, POSITION] {
            values.put(name, Value::Word(choices(name)[0].to_owned()));
        }
        Activation { store, reasons, turned, values }
    }

    /// Names of its fields.
    pub fn fields(&self) -> Vec<&'static str> {
        // a plane that is not active is none to which the probe could stand
        let orients = self.reasons.swivels && self.values.word(ACTIVATE) == YES[0];
        let retracts = orients && self.values.word(ORIENT) == YES[0];
        let positions = self.reasons.rotary.is_some() && !self.reasons.aligned;
        let shown = [(ACTIVATE, true), (ORIENT, orients), (RETRACT, retracts), (POSITION, positions)];
        shown.into_iter().filter_map(|(name, shown)| shown.then_some(name)).collect()
    }

    /// Whether a field is there and says yes, or a way.
    pub fn says(&self, name: &str) -> bool {
        self.fields().contains(&name) && self.values.word(name) == choices(name)[0]
    }

    /// Chooses in a field.
    ///
    /// # Errors
    /// There is no such field, or no such choice.
    pub fn toggle(&mut self, name: &str, word: &str) -> Result<(), Message> {
        let fields = self.fields();
        let Some(field) = fields.iter().find(|field| field.eq_ignore_ascii_case(name)) else {
            return Err(Message::new("jog-no-field").text("field", name).text("known", fields.join(", ")));
        };
        let known = choices(field);
        let Some(word) = known.into_iter().find(|known| known.eq_ignore_ascii_case(word.trim())) else {
            return Err(wrong_word(field, word.trim(), known.join(", ")));
        };
        self.values.put(field, Value::Word(word.to_owned()));
        Ok(())
    }

    /// The lines of the screen, from above.
    pub fn lines(&self, control: &Control) -> Vec<Message> {
        let name = offset::name(control, self.store);
        let mut lines = Vec::new();
        let orients = self.says(ORIENT);
        if self.reasons.inactive && !orients && !self.reasons.aligned {
            lines.push(Message::new("jog-line-inactive").text("offset", &name));
        }
        if self.reasons.tilts && (orients || !self.reasons.swivels) {
            lines.push(Message::new("jog-line-tilted"));
        }
        if self.reasons.tilts {
            let way = if self.reasons.swivels { "jog-line-swivels" } else { "jog-line-no-swivel" };
            lines.extend((orients || !self.reasons.swivels).then(|| Message::new(way)));
        }
        if self.turned {
            lines.push(Message::new("jog-line-turned"));
        }
        if let Some((axis, _)) = self.reasons.rotary {
            let key = if self.reasons.aligned { "jog-line-aligned" } else { "jog-line-rotary" };
            lines.push(Message::new(key).text("axis", ROTARY[axis.min(2)]));
        }
        lines.push(Message::new("jog-line-start"));
        lines
    }
}
