//! The values of a call, from the mask, from where was touched, from the set-up of JOG.

use super::lay::Laid;
use super::{Layout, Source, Told, code};
use crate::control::{Control, machine_data};
use crate::entry::Unit;
use crate::entry::factor;
use crate::jog::calculate;
use crate::jog::evaluate;
use crate::jog::mask::Task;
use crate::jog::settings::{Settings, TOOL_PROBE};
use crate::jog::stylus::Stylus;

/// Places of a number that is made from places, mm: the control's own.
const DIGITS: f64 = 1e3;

/// Rounded to the places that the control shows.
pub fn rounded(value: f64) -> f64 {
    (value * DIGITS).round() / DIGITS
}

/// A value as typed, from mm, degree or a number.
pub fn typed(value: f64, unit: Unit, control: &Control) -> String {
    plain(value / factor(unit, control))
}

/// A number as a person types it: what a conversion adds behind the ninth place is none.
pub fn plain(number: f64) -> String {
    format!("{}", (number * 1e9).round() / 1e9 + 0.0)
}

/// Whether the tool in the spindle is wider than the upper side of the tool probe: then its length is measured beside
/// the middle, rotating (B:4065-4067).
pub fn wide(control: &Control) -> bool {
    let probe = control.number(TOOL_PROBE) as i64;
    let upper = control.number(&format!("E_MESS_MT_DL[{}]", probe - 1));
    evaluate::beside(control.active_radius(), 0.0, upper).1
}

impl Told<'_> {
    /// A value in mm, degree, or as the number that it is; none: it is not known.
    pub fn value(&self, source: Source, laid: &Laid) -> Option<f64> {
        let settings = Settings::of(&self.control);
        let field = |name: &str| self.values.number(name);
        let part = |name: &str| {
            let axis = calculate::axis(self.values, name);
            self.control.plane.axes().iter().position(|one| *one == axis).map_or(0.0, |place| place as f64 + 1.0)
        };
        Some(match source {
            Source::Field(name) => field(name),
            Source::Minus(name) => -field(name),
            Source::Size(name) => return self.size(name),
            Source::Number(number) => number,
            Source::Axis(name) => part(name),
            Source::Axes(offset, measuring) => 100.0 * part(offset) + part(measuring),
            Source::Direction(name) => f64::from(self.values.sign(name) < 0.0),
            Source::Target => self.target.map_or(0.0, code),
            Source::Rotary(name) => self.rotary(name),
            Source::Probe(more) => {
                let (field, mono) = settings.probe;
                field as f64 + if mono { 100.0 } else { 0.0 } + more
            }
            Source::ToolProbe => self.control.number(TOOL_PROBE),
            Source::ToolAxis => self.tool_axis(),
            Source::Path => settings.path,
            Source::Reach => self.reach(&settings, laid),
            Source::ToolPath => self.control.number("E_MESS_MT_D"),
            Source::Feed => settings.feed,
            Source::Positioning => settings.positioning[0],
            Source::Laid(number) => return laid.numbers.get(number).copied(),
        })
    }

    /// A size of the mask, else as it was measured.
    pub fn size(&self, name: &str) -> Option<f64> {
        let measured = self.results.iter().find(|(known, _)| *known == name).map(|(_, value)| rounded(*value));
        Some(self.values.number(name)).filter(|size| *size > 0.0).or(measured)
    }

    /// Number in the channel of the rotary axis that is corrected; 0: the rotation.
    fn rotary(&self, name: &str) -> f64 {
        let Some(axis) = self.control.rotary_axis(self.values.word(name)) else { return 0.0 };
        let mut numbers = 1..=machine_data::CHANNEL_AXES as i64;
        numbers.find(|number| self.control.rotary_channel_axis(*number) == Some(axis)).map_or(0.0, |one| one as f64)
    }

    /// Abscissa or ordinate, as the set-up of the tool probe says (`E_MESS_MT_DIR`).
    fn tool_axis(&self) -> f64 {
        let probe = self.control.number(TOOL_PROBE) as i64;
        let direction = self.control.number(&format!("E_MESS_MT_DIR[{}]", probe - 1));
        if direction.abs() == 2.0 { 2.0 } else { 1.0 }
    }

    /// The measuring path, inside not longer than the way of the ball from the centre to a wall.
    fn reach(&self, settings: &Settings, laid: &Laid) -> f64 {
        let sizes: Vec<f64> = match (self.mask.task, laid.layout) {
            (Task::Ring, _) => vec![self.values.number("d")],
            (Task::Distance, Layout::Middle { inside: true }) => laid.numbers.first().copied().into_iter().collect(),
            (Task::Element(element), _) if element.inside => {
                ["diameter", "l", "w"].iter().filter_map(|name| self.size(name)).collect()
            }
            _ => Vec::new(),
        };
        let ball = match self.mask.task {
            Task::Ring => Stylus::ideal(&self.control),
            _ => self.stylus(),
        };
        let room = sizes.into_iter().map(|size| size / 2.0 - ball.radius).fold(settings.path, f64::min);
        (room * DIGITS).floor().max(1.0) / DIGITS
    }
}
