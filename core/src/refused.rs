//! Why a description is refused: what is wrong, and at which of its members.

use crate::message::Message;
use std::borrow::Cow;
use std::fmt;

/// One step into a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// Member of an object.
    Member(String),
    /// Element of a list, from 0.
    Element(usize),
}

/// A place in a document, shown as `tools.20.edges.1.radius` or `workpiece[0].size`; empty: the whole.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Path(pub Vec<Step>);

impl Path {
    /// The members with these names, one in the other.
    pub fn of(names: &[&str]) -> Path {
        Path(names.iter().map(|name| Step::Member((*name).to_owned())).collect())
    }

    /// A member of it.
    pub fn member(&self, name: impl ToString) -> Path {
        self.step(Step::Member(name.to_string()))
    }

    /// An element of it.
    pub fn element(&self, index: usize) -> Path {
        self.step(Step::Element(index))
    }

    fn step(&self, step: Step) -> Path {
        Path(self.0.iter().cloned().chain([step]).collect())
    }
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, step) in self.0.iter().enumerate() {
            match step {
                Step::Element(index) => write!(f, "[{index}]")?,
                Step::Member(name) if number == 0 => f.write_str(name)?,
                Step::Member(name) => write!(f, ".{name}")?,
            }
        }
        Ok(())
    }
}

/// Why a document is refused. No language is known here: shown as it is, it is its message as JSON.
#[derive(Clone, Debug, PartialEq)]
pub struct Refused {
    /// What is wrong; its argument `path` is the place.
    pub message: Message,
    /// Where.
    pub path: Path,
    /// Line and column of the place in the text, from 1, where the text is known.
    pub position: Option<(usize, usize)>,
}

impl Refused {
    /// What is wrong at this place.
    pub fn new(key: impl Into<Cow<'static, str>>, path: Path) -> Refused {
        Refused { message: Message::new(key), path, position: None }.named()
    }

    /// With a number in its sentence.
    pub fn number(self, name: &'static str, value: f64) -> Refused {
        Refused { message: self.message.number(name, value), ..self }
    }

    /// With a text in its sentence.
    pub fn text(self, name: &'static str, value: impl Into<String>) -> Refused {
        Refused { message: self.message.text(name, value), ..self }
    }

    /// Told from one member further out.
    pub fn within(mut self, step: Step) -> Refused {
        self.path.0.insert(0, step);
        self.named()
    }

    /// With the place among the arguments.
    fn named(mut self) -> Refused {
        let path = if self.path.0.is_empty() { "document-whole".to_owned() } else { self.path.to_string() };
        self.message.args.retain(|(name, _)| *name != "path");
        self.message = self.message.text("path", path);
        self
    }
}
