//! How far a long run is, on a line of standard error that goes again; where nobody looks at it, nothing is written.

use probewright_core::message::Message;
use probewright_core::run::Session;
use probewright_core::words::Words;
use std::io::{IsTerminal, Write};
use std::time::{Duration, Instant};

/// Between two tellings; a run that is over before the first tells nothing.
const BETWEEN: Duration = Duration::from_millis(500);

/// What is told of a run.
pub struct Progress<'a> {
    words: &'a Words,
    watched: bool,
    told: Instant,
    /// Characters that stand on the line.
    shown: usize,
}

impl<'a> Progress<'a> {
    /// Before the first block.
    pub fn new(words: &'a Words) -> Progress<'a> {
        Progress { words, watched: std::io::stderr().is_terminal(), told: Instant::now(), shown: 0 }
    }

    /// Tells how far the run is, from time to time.
    pub fn tell(&mut self, session: &Session) {
        if !self.watched || self.told.elapsed() < BETWEEN {
            return;
        }
        self.told = Instant::now();
        let share = (session.share * 100.0).floor();
        let told = Message::new("terminal-progress").number("share", share).number("blocks", session.blocks() as f64);
        self.show(&self.words.text(&told));
    }

    /// Leaves the line empty.
    pub fn end(mut self) {
        if self.shown > 0 {
            self.show("");
            self.write("\r");
        }
    }

    fn show(&mut self, text: &str) {
        let length = text.chars().count();
        let blanks = " ".repeat(self.shown.saturating_sub(length));
        self.shown = length;
        self.write(&format!("\r{text}{blanks}"));
    }

    fn write(&self, text: &str) {
        let mut to = std::io::stderr().lock();
        drop(to.write_all(text.as_bytes()).and_then(|()| to.flush()));
    }
}
