//! The way of working as a table: in which state an input does what, and what is on the screen then (B:2602-3912). An
//! input that no row has does nothing, and is told.

/// What is on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "JogState"))]
pub enum State {
    /// The vertical bar of the functions.
    Menu,
    /// The mask of a function, points missing.
    Mask,
    /// The mask, all points stored: Calculate can be pressed.
    Ready,
    /// A measurement runs.
    Busy,
    /// The activation screen.
    Activate,
    /// The activation runs.
    Moving,
    /// An alarm is pending.
    Alarm,
}

/// What is pressed, or happens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// Softkey of a function.
    Function,
    /// A field is changed.
    Field,
    /// NC start.
    Start,
    /// The running measurement or activation is through.
    Done,
    /// It ended with an alarm.
    Failed,
    /// RESET.
    Reset,
    /// A softkey P1 to P4 that is black, or its bit from the PLC.
    Point,
    /// Calculate.
    Calculate,
    /// The softkey `<<`.
    Back,
    /// Another mode.
    Mode,
}

/// When a row counts; of several the first that holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum When {
    /// Always.
    Always,
    /// The fields are valid, and a point is missing.
    Measurable,
    /// Another point is missing.
    More,
    /// NC start does everything: there are no points to be stored one by one, and the activation screen is not needed.
    Complete,
    /// As before, and the activation screen is needed.
    Inactive,
    /// The activation screen is needed.
    ToActivate,
    /// The user stores each point after its touch (up to SW 6.2).
    ByHand,
    /// As before, and as many are stored as can make a corner.
    Enough,
}

/// What a row does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Does {
    /// Opens the mask with its last values.
    Open,
    /// Changes the field; one that says how is touched rejects all points.
    Change,
    /// Begins to measure the missing point with the lowest number.
    Measure,
    /// Stores the point: its softkey becomes black.
    Store,
    /// The point is found and waits to be stored.
    Hold,
    /// Stores the point that waits, which is the next in order.
    Keep,
    /// Shows the result, writes the zero offset.
    Write,
    /// Cancels: the point stays grey, those stored before it stay.
    Cancel,
    /// Raises the alarm.
    Raise,
    /// Acknowledges the alarm.
    Acknowledge,
    /// Makes a point grey: it has to be measured again.
    Reject,
    /// Leaves the mask: its points are lost.
    Leave,
    /// Changes what NC start will do.
    Toggle,
    /// Begins to activate.
    Activate,
    /// The zero offset is active, and offered for the next measurement.
    Offer,
    /// Leaves the screen: the zero offset stays written, not active.
    Close,
    /// Leaves the area: no zero offset is offered any more.
    Quit,
}

/// One row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// State before.
    pub from: State,
    /// Input.
    pub key: Key,
    /// When it counts.
    pub when: When,
    /// What happens.
    pub does: Does,
    /// State then.
    pub to: State,
    /// Where the manual says so; ours where it does not.
    pub source: &'static str,
}

const fn row(from: State, key: Key, when: When, does: Does, to: State, source: &'static str) -> Row {
    Row { from, key, when, does, to, source }
}

/// The table.
pub const ROWS: &[Row] = &{
    use State::{Activate, Alarm, Busy, Mask, Menu, Moving, Ready};
    use When::Always;
    [
        row(Menu, Key::Function, Always, Does::Open, Mask, "B:2731;B:3794"),
        row(Menu, Key::Mode, Always, Does::Quit, Menu, "B:3736"),
        row(Mask, Key::Field, Always, Does::Change, Mask, "B:3963"),
        row(Ready, Key::Field, Always, Does::Change, Ready, "B:3963"),
        row(Mask, Key::Start, When::Measurable, Does::Measure, Busy, "B:3030;B:3082;B:3086"),
        row(Busy, Key::Done, When::ByHand, Does::Hold, Mask, "A:3183-3188"),
        row(Busy, Key::Done, When::More, Does::Store, Mask, "B:3084;B:2806-2817"),
        row(Busy, Key::Done, When::Complete, Does::Write, Mask, "B:3034"),
        row(Busy, Key::Done, When::Inactive, Does::Write, Activate, "B:3034;B:3802-3806"),
        row(Busy, Key::Done, Always, Does::Store, Ready, "B:3088;B:3720"),
        row(Busy, Key::Reset, Always, Does::Cancel, Mask, "B:2602"),
        row(Busy, Key::Failed, Always, Does::Raise, Alarm, "A:15817"),
        row(Alarm, Key::Reset, Always, Does::Acknowledge, Mask, "A:15830"),
        row(Mask, Key::Point, When::ByHand, Does::Keep, Mask, "A:3188;A:3198"),
        row(Mask, Key::Calculate, When::Enough, Does::Write, Mask, "A:3190-3200"),
        row(Mask, Key::Point, Always, Does::Reject, Mask, "B:3684-3688;B:2797-2804"),
        row(Ready, Key::Point, Always, Does::Reject, Mask, "B:3684-3688;B:2797-2804"),
        row(Ready, Key::Calculate, When::ToActivate, Does::Write, Activate, "B:3722;B:3802-3806"),
        row(Ready, Key::Calculate, Always, Does::Write, Mask, "B:3722;B:3728"),
        row(Mask, Key::Back, Always, Does::Leave, Menu, "B:3732"),
        row(Ready, Key::Back, Always, Does::Leave, Menu, "B:3732"),
        row(Activate, Key::Field, Always, Does::Toggle, Activate, "B:3889-3897"),
        row(Activate, Key::Start, Always, Does::Activate, Moving, "B:3862-3866;B:3903"),
        row(Activate, Key::Back, Always, Does::Close, Mask, "B:3870;B:3912"),
        row(Moving, Key::Done, Always, Does::Offer, Mask, "B:3868;B:3908;B:3784"),
        row(Moving, Key::Failed, Always, Does::Raise, Alarm, "A:15817"),
        row(Moving, Key::Reset, Always, Does::Cancel, Mask, "B:2602"),
    ]
};

/// The row that an input takes.
pub fn row_of(from: State, key: Key, holds: impl Fn(When) -> bool) -> Option<&'static Row> {
    ROWS.iter().find(|row| row.from == from && row.key == key && (row.when == When::Always || holds(row.when)))
}
