//! A program whose text comes in pieces, of which one at a time is at hand; see [`Program::begins_pieces`]. Blocks
//! count from the beginning of their piece, lines and places of what is told from that of the text.

use super::Interpreter;
use crate::diagnostic::Span;
use crate::syntax::Program;
use std::rc::Rc;

/// A piece of a text.
pub struct Piece {
    /// What it says.
    pub program: Program,
    /// Which share of the text lies before it, and which share with it, 0 to 1.
    pub share: [f64; 2],
}

/// Gives the piece that comes next; none: there is no more.
pub type More = Box<dyn FnMut() -> Option<Piece>>;

/// Where in the text the piece is that is at hand.
pub struct Pieces {
    pub(super) more: Option<More>,
    /// Lines before it.
    pub(super) lines: u32,
    /// Bytes before it.
    bytes: u32,
    pub(super) share: [f64; 2],
}

impl Default for Pieces {
    fn default() -> Pieces {
        Pieces { more: None, lines: 0, bytes: 0, share: [0.0, 1.0] }
    }
}

impl Pieces {
    /// A place of the piece in the text.
    pub(super) fn placed(&self, span: Span) -> Span {
        Span { start: span.start + self.bytes, end: span.end + self.bytes }
    }
}

/// Goes on in the next piece; false: there is none.
pub(super) fn next(run: &mut Interpreter) -> bool {
    let Some(piece) = run.pieces.more.as_mut().filter(|_| run.levels.len() == 1).and_then(|more| more()) else {
        return false;
    };
    let before = std::mem::replace(&mut run.program, Rc::new(piece.program));
    run.pieces.lines += before.blocks.len() as u32;
    run.pieces.bytes += before.source.len() as u32;
    run.pieces.share = piece.share;
    if let Some(level) = run.levels.first_mut() {
        level.blocks = 0..run.program.blocks.len();
    }
    run.at = 0;
    run.heavy.clear(); // blocks of the piece before
    true
}
