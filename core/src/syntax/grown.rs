//! What was read of a line with its macros replaced, in the tree of the program: places in the line as it is written,
//! names in the text that stands for them.

use super::macros::Line;
use super::tree::{Expr, ExprId, Program, SyntaxError, Word, WordKind};
use crate::diagnostic::Span;
use std::collections::{BTreeMap, BTreeSet};

/// Lines of a program in which macros are replaced.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Replaced {
    /// Their texts, one behind the other. Names and texts of the tree that lie behind the source lie here.
    pub text: Vec<u8>,
    /// The parts of these texts in their order: end, place in the source, and whether a macro stands there.
    pieces: Vec<(u32, Span, bool)>,
    /// Places of which a macro says more than the value that is read there.
    shared: BTreeSet<(u32, u32)>,
    /// Where the texts lie of words that could not be read, by the place where they begin.
    unread: BTreeMap<u32, Span>,
    /// Where the texts lie of expressions of which macros say a part.
    said: BTreeMap<ExprId, Span>,
}

impl Program {
    /// Where the first text lies in which macros are replaced; not directly behind the source, where empty places lie.
    fn beyond(&self) -> u32 {
        (self.source.len() as u32).saturating_add(1)
    }

    /// Text of a place that is none of the source.
    pub(super) fn replaced_text(&self, span: Span) -> &[u8] {
        let from = |at: u32| Some(at.checked_sub(self.beyond())? as usize);
        let range = from(span.start).zip(from(span.end)).map(|(start, end)| start..end);
        range.and_then(|range| self.replaced.text.get(range)).unwrap_or_default()
    }

    /// A place in the source: of what a macro says, the name that stands there.
    pub fn placed(&self, span: Span) -> Span {
        if self.replaced.pieces.is_empty() || span.start < self.beyond() {
            return span;
        }
        let own = |at: u32| at.saturating_sub(self.beyond());
        let (start, end) = (own(span.start), own(span.end));
        Map { pieces: &self.replaced.pieces, from: 0 }.hull(Span { start, end })
    }

    /// A word that could not be read, in upper case, with what its macros say.
    pub fn said(&self, word: &Word) -> String {
        self.name(self.replaced.unread.get(&word.span.start).copied().unwrap_or(word.span))
    }

    /// The text of an expression with what its macros say: what the control reads.
    pub fn said_of(&self, id: ExprId) -> String {
        self.written(self.replaced.said.get(&id).copied().unwrap_or_else(|| self.place(id)))
    }

    /// Whether a macro stands at a place that says more than the value that is read there: it cannot be written anew.
    pub fn is_of_macro(&self, place: Span) -> bool {
        self.replaced.shared.contains(&(place.start, place.end))
    }
}

/// Pieces of replaced lines.
struct Map<'a> {
    pieces: &'a [(u32, Span, bool)],
    /// Where the first of them begins.
    from: u32,
}

impl Map<'_> {
    /// The piece that has the byte at this place, and where it begins.
    fn piece(&self, at: u32) -> Option<(u32, Span, bool)> {
        let index = self.pieces.partition_point(|(end, ..)| *end <= at).min(self.pieces.len().checked_sub(1)?);
        let from = index.checked_sub(1).and_then(|before| self.pieces.get(before)).map_or(self.from, |(end, ..)| *end);
        self.pieces.get(index).map(|(_, place, replaced)| (from, *place, *replaced))
    }

    fn start(&self, at: u32) -> u32 {
        self.piece(at).map_or(0, |(from, place, replaced)| match replaced {
            true => place.start,
            false => (place.start + at.saturating_sub(from)).min(place.end),
        })
    }

    /// The place in the source with all macros of which it has a part.
    fn hull(&self, span: Span) -> Span {
        let start = self.start(span.start);
        if span.end <= span.start {
            return Span { start, end: start };
        }
        let end = self.piece(span.end - 1).map_or(start, |(from, place, replaced)| match replaced {
            true => place.end,
            false => (place.start + span.end.saturating_sub(from)).min(place.end),
        });
        Span { start, end: end.max(start) }
    }

    /// The place in the source of what stands there letter by letter.
    fn exact(&self, span: Span) -> Option<Span> {
        let (from, place, replaced) = self.piece(span.start)?;
        let start = place.start + span.start.checked_sub(from)?;
        let end = start + (span.end - span.start);
        (!replaced && end <= place.end).then_some(Span { start, end })
    }

    /// Whether a place has a part of a macro and not all of it.
    fn parts(&self, span: Span) -> bool {
        let begins = self.piece(span.start).is_some_and(|(from, _, replaced)| replaced && from < span.start);
        let last = span.end.saturating_sub(1).max(span.start);
        let index = self.pieces.partition_point(|(end, ..)| *end <= last);
        let ends = self.pieces.get(index).is_some_and(|(end, _, replaced)| *replaced && span.end < *end);
        begins || ends
    }
}

/// Takes the words of a replaced line into the tree; the comment of the line comes back.
pub(super) fn take(tree: &mut Program, mut line: Program, text: &Line, comment: Option<Span>) -> Option<Span> {
    let from = tree.replaced.text.len() as u32;
    let pieces: Vec<_> = text.pieces.iter().map(|piece| (from + piece.end as u32, piece.at, piece.replaced)).collect();
    let (moved, beyond) = (tree.exprs.len() as ExprId, tree.beyond());
    let map = Map { pieces: &pieces, from };
    let within = |span: Span| Span { start: from + span.start, end: from + span.end };
    let behind = |span: Span| Span { start: beyond + span.start, end: beyond + span.end };
    let place = |span: Span| map.hull(within(span));
    let name = |span: Span| {
        let span = within(span);
        map.exact(span).unwrap_or(behind(span))
    };
    share(tree, &line, &map, &within);
    let numbers = line.exprs.iter().zip(0..).filter_map(|(expr, id)| match expr {
        Expr::Number(_, span) => Some((id, *span)),
        _ => None,
    });
    let said = line.places.iter().copied().chain(numbers).map(|(id, span)| (id, within(span)));
    let said = said.filter(|(_, span)| map.exact(*span).is_none());
    tree.replaced.said.extend(said.map(|(id, span)| (moved + id, behind(span))));
    for expr in &mut line.exprs {
        grow(expr, moved, &place, &name);
    }
    for word in line.words.iter().filter(|word| word.kind == WordKind::Unknown) {
        let span = within(word.span);
        tree.replaced.unread.insert(map.hull(span).start, behind(span));
    }
    tree.exprs.append(&mut line.exprs);
    tree.places.extend(line.places.into_iter().map(|(id, span)| (id + moved, place(span))));
    tree.words.extend(
        line.words.into_iter().map(|word| Word { span: place(word.span), kind: kind(word.kind, moved, &name) }),
    );
    tree.errors.extend(line.errors.into_iter().map(|error| SyntaxError { span: place(error.span), ..error }));
    let comment = comment.map(place);
    tree.replaced.text.extend_from_slice(&text.text);
    tree.replaced.pieces.extend(pieces);
    comment
}

/// Keeps the places of values of which a macro says more: an address with its value, several words.
fn share(tree: &mut Program, line: &Program, map: &Map, within: &dyn Fn(Span) -> Span) {
    let numbers = line.exprs.iter().filter_map(|expr| match expr {
        Expr::Number(_, span) | Expr::Text(span) => Some(*span),
        _ => None,
    });
    let all: Vec<Span> = line.places.iter().map(|(_, span)| *span).chain(numbers).map(within).collect();
    let (parts, whole): (Vec<Span>, Vec<Span>) = all.into_iter().partition(|span| map.parts(*span));
    let hull = |span: Span| {
        let hull = map.hull(span);
        (hull.start, hull.end)
    };
    let words = line.words.iter().map(|word| within(word.span)).filter(|span| map.parts(*span));
    let whole: BTreeSet<_> = whole.into_iter().map(hull).collect();
    tree.replaced.shared.extend(parts.into_iter().chain(words).map(hull).filter(|place| !whole.contains(place)));
}

type Moved<'a> = &'a dyn Fn(Span) -> Span;

/// An expression with its places and parts in the tree of the program.
fn grow(expr: &mut Expr, moved: ExprId, place: Moved, name: Moved) {
    let list = |ids: &mut Box<[ExprId]>| ids.iter_mut().for_each(|id| *id += moved);
    match expr {
        Expr::Number(_, span) => *span = place(*span),
        Expr::Text(span) => *span = name(*span),
        Expr::Name { name: span, index } => {
            *span = name(*span);
            list(index);
        }
        Expr::Unary(_, inner) => *inner += moved,
        Expr::Binary(left, _, right) => {
            *left += moved;
            *right += moved;
        }
        Expr::Call(span, arguments) => {
            *span = name(*span);
            list(arguments);
        }
        Expr::List(elements) => list(elements),
        Expr::Omitted => {}
    }
}

/// What a word is, with its names and expressions in the tree of the program.
fn kind(kind: WordKind, moved: ExprId, name: Moved) -> WordKind {
    let list = |ids: Box<[ExprId]>| ids.iter().map(|id| id + moved).collect();
    let place = name;
    match kind {
        WordKind::Address { name, extension, mode, value } => {
            WordKind::Address { name: place(name), extension, mode: mode.map(place), value: value + moved }
        }
        WordKind::Assign { name, index, value } => {
            WordKind::Assign { name: place(name), index: list(index), value: value + moved }
        }
        WordKind::Declare { name, index, value } => {
            WordKind::Declare { name: place(name), index: list(index), value: value.map(|id| id + moved) }
        }
        WordKind::Constant(value) => WordKind::Constant(value + moved),
        WordKind::Call { name, args } => WordKind::Call { name: place(name), args: list(args) },
        WordKind::Label(name) => WordKind::Label(place(name)),
        WordKind::Keyword { name, value } => WordKind::Keyword { name: place(name), value: value.map(|id| id + moved) },
        WordKind::Header => WordKind::Header,
        WordKind::Unknown => WordKind::Unknown,
    }
}
