//! What is active at a place of a program, as far as its text tells.

use super::Meet;
use crate::control::{Plane, Transverse};
use crate::diagnostic::Span;

/// One thing that is active.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Mode<T> {
    /// Nothing was programmed since the main program began.
    #[default]
    Unset,
    /// This.
    Is(T),
    /// It depends on what the text does not tell: a branch, a program elsewhere, a value of the run.
    Open,
}

impl<T: PartialEq + Clone> Mode<T> {
    /// What is active for certain.
    pub fn is(&self) -> Option<&T> {
        let Mode::Is(value) = self else { return None };
        Some(value)
    }

    /// Whether nothing was programmed for certain.
    pub fn unset(&self) -> bool {
        *self == Mode::Unset
    }

    fn meet(&self, other: &Self) -> Self {
        if self == other { self.clone() } else { Mode::Open }
    }
}

/// A tool, as the program names it.
#[derive(Clone, Debug, PartialEq)]
pub enum Tool {
    /// T number.
    Number(i64),
    /// Name under tool management, in upper case.
    Name(String),
}

/// A function of tool radius compensation and its place, which makes no difference between two states.
#[derive(Clone, Copy, Debug)]
pub struct Compensation {
    /// 40, 41 or 42.
    pub code: u16,
    /// Place of the word.
    pub at: Span,
}

impl PartialEq for Compensation {
    fn eq(&self, other: &Self) -> bool {
        self.code == other.code
    }
}

/// State at a place of the program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// G17, G18 or G19.
    pub plane: Mode<Plane>,
    /// G40, G41 or G42.
    pub compensation: Mode<Compensation>,
    /// G500, G54 to G57, G505 to G599.
    pub frame: Mode<u16>,
    /// DIAMON, DIAMOF, DIAM90, as they count for X.
    pub transverse: Mode<Transverse>,
    /// What the channel has of these while X has its own (`DIAMONA[X]`).
    pub channel: Option<Mode<Transverse>>,
    /// G70, G71, G700 or G710.
    pub units: Mode<u16>,
    /// M3 or M4 (true), or a stop or positioning since.
    pub turning: Mode<bool>,
    /// Tool in use.
    pub tool: Mode<Tool>,
    /// D number; unset behind a tool change: none was programmed since.
    pub edge: Mode<i64>,
    /// Tool that M6 brings.
    pub prepared: Option<Mode<Tool>>,
    /// D number that counts for it.
    pub waiting: Mode<i64>,
}

impl State {
    /// Nothing is known.
    pub fn elsewhere() -> State {
        State {
            plane: Mode::Open,
            compensation: Mode::Open,
            frame: Mode::Open,
            transverse: Mode::Open,
            channel: None,
            units: Mode::Open,
            turning: Mode::Open,
            tool: Mode::Open,
            edge: Mode::Open,
            prepared: None,
            waiting: Mode::Open,
        }
    }

    /// The functions of the caller again (`SAVE`).
    pub fn restore(&mut self, caller: &State) {
        let State { plane, compensation, frame, transverse, channel, units, .. } = caller.clone();
        *self = State { plane, compensation, frame, transverse, channel, units, ..std::mem::take(self) };
    }

    /// DIAMON and its like count for X unless that has its own.
    pub fn of_channel(&mut self, transverse: Transverse) {
        *self.channel.as_mut().unwrap_or(&mut self.transverse) = Mode::Is(transverse);
    }

    /// `DIAMONA[X]` and its like.
    pub fn of_x(&mut self, own: Transverse) {
        let before = std::mem::replace(&mut self.transverse, Mode::Is(own));
        self.channel.get_or_insert(before);
    }

    /// DIAMCHAN, `DIAMCHANA[X]`.
    pub fn as_channel(&mut self) {
        if let Some(channel) = self.channel.take() {
            self.transverse = channel;
        }
    }

    /// T: the tool is in use at once, or M6 brings it.
    pub fn choose(&mut self, tool: Mode<Tool>, prepares: bool) {
        if prepares {
            self.prepared = Some(tool);
            self.waiting = Mode::Unset;
        } else {
            self.tool = tool;
            self.edge = Mode::Unset;
        }
    }

    /// D: of the tool in use; in a block with T or M6 also of the one that M6 brings.
    pub fn correct(&mut self, edge: Mode<i64>, of_next: bool) {
        if of_next {
            self.waiting.clone_from(&edge);
        }
        self.edge = edge;
    }

    /// M6.
    pub fn change(&mut self) {
        match self.prepared.take() {
            Some(tool) => {
                self.tool = tool;
                self.edge = std::mem::take(&mut self.waiting);
            }
            None => {
                self.tool = Mode::Open;
                self.edge = Mode::Open;
            }
        }
    }

    /// A G function, and its place.
    pub fn function(&mut self, code: i64, at: Span) {
        let Ok(code) = u16::try_from(code) else { return };
        match code {
            17..=19 => self.plane = Plane::of(code).map_or(Mode::Open, Mode::Is),
            40..=42 => self.compensation = Mode::Is(Compensation { code, at }),
            70 | 71 | 700 | 710 => self.units = Mode::Is(code),
            54..=57 | 500 | 505..=599 => self.frame = Mode::Is(code),
            _ => {}
        }
    }

    /// An M function of the main spindle.
    pub fn machine(&mut self, code: i64) {
        match code {
            3 | 4 => self.turning = Mode::Is(true),
            5 | 19 => self.turning = Mode::Is(false),
            6 => {
                self.turning = Mode::Is(false);
                self.change();
            }
            _ => {}
        }
    }
}

impl Meet for State {
    fn meet(&self, other: &State) -> State {
        let alike = self.channel == other.channel;
        State {
            plane: self.plane.meet(&other.plane),
            compensation: self.compensation.meet(&other.compensation),
            frame: self.frame.meet(&other.frame),
            transverse: if alike { self.transverse.meet(&other.transverse) } else { Mode::Open },
            channel: if alike { self.channel.clone() } else { Some(Mode::Open) },
            units: self.units.meet(&other.units),
            turning: self.turning.meet(&other.turning),
            tool: self.tool.meet(&other.tool),
            edge: self.edge.meet(&other.edge),
            prepared: if self.prepared == other.prepared { self.prepared.clone() } else { Some(Mode::Open) },
            waiting: self.waiting.meet(&other.waiting),
        }
    }
}
