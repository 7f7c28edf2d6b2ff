//! The entries of a trace by column, in windows. Of a motion its end, its feed, its line and its kind are kept: where
//! it begins follows from the motion before it. So it takes 37 bytes, and a run of a million motions keeps all of them.

use super::trace::{Entry, MotionKind, Step};
use crate::geometry::{Around, Mcs};
use std::ops::Range;

/// Entries of a window; all have so many but the last.
pub const WINDOW: usize = 4096;

/// Kinds of motions by their numbers.
const KINDS: [MotionKind; 4] = [MotionKind::Rapid, MotionKind::Positioning, MotionKind::Measuring, MotionKind::Retract];
/// The number of what is no motion.
const OTHER: u8 = 4;

/// What happened, in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Entries(Vec<Window>);

/// Some entries, one behind the other. Places count from the first one of the window, motions among themselves.
#[derive(Clone, Debug, Default, PartialEq)]
struct Window {
    /// The kind of each, of a motion.
    sorts: Vec<u8>,
    /// The line of each from 1; 0: none.
    lines: Vec<u32>,
    /// What is in use from which place on.
    in_use: Vec<(u16, u32)>,
    /// The end of each motion.
    ends: Vec<Mcs>,
    /// The feed of each motion.
    feeds: Vec<f64>,
    /// Where motions begin that begin elsewhere than the one before them ends, by their numbers.
    starts: Vec<(u16, Mcs)>,
    /// Round what motions go that are not straight, by their numbers.
    rounds: Vec<(u16, Around<Mcs>)>,
    /// The others, by their places.
    others: Vec<(u16, Step)>,
}

/// What is no motion.
#[derive(Clone, Copy, Debug)]
pub struct Other<'a> {
    /// Place among all entries.
    pub at: usize,
    /// Line of the program, from 0.
    pub line: Option<u32>,
    /// What happened.
    pub step: &'a Step,
    /// Index of the tool that was in use then.
    pub in_use: usize,
}

impl Entries {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.0.last().map_or(0, |last| (self.0.len() - 1) * WINDOW + last.sorts.len())
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Adds one behind the others.
    pub fn push(&mut self, entry: Entry) {
        if self.0.last().is_none_or(|last| last.sorts.len() == WINDOW) {
            self.0.push(Window::default());
        }
        if let Some(last) = self.0.last_mut() {
            last.push(entry);
        }
    }

    /// Takes the last one away.
    pub fn pop(&mut self) -> Option<Entry> {
        let last = self.0.last_mut()?;
        let entry = last.pop();
        if last.sorts.is_empty() {
            self.0.pop();
        }
        entry
    }

    /// Leaves so many of them; the others, in their order.
    pub fn split_off(&mut self, at: usize) -> Vec<Entry> {
        let behind = self.len().saturating_sub(at);
        let mut behind: Vec<Entry> = (0..behind).filter_map(|_| self.pop()).collect();
        behind.reverse();
        behind
    }

    /// Leaves so many of them at most.
    pub fn truncate(&mut self, most: usize) {
        while self.len() > most {
            self.pop();
        }
    }

    /// The one at this place.
    pub fn get(&self, at: usize) -> Option<Entry> {
        self.0.get(at / WINDOW)?.get(at % WINDOW)
    }

    /// The last one.
    pub fn last(&self) -> Option<Entry> {
        self.get(self.len().checked_sub(1)?)
    }

    /// All, one after the other.
    pub fn iter(&self) -> Iter<'_> {
        Iter { of: self, left: 0..self.len() }
    }

    /// Those behind so many.
    pub fn behind(&self, at: usize) -> Iter<'_> {
        Iter { of: self, left: at.min(self.len())..self.len() }
    }

    /// All at once, where they are few.
    pub fn to_vec(&self) -> Vec<Entry> {
        self.iter().collect()
    }

    /// What is no motion, in order: a long run has few of them.
    pub fn others(&self) -> impl DoubleEndedIterator<Item = Other<'_>> + Clone {
        self.others_of(0)
    }

    /// What is no motion behind so many entries, in order.
    pub fn others_behind(&self, at: usize) -> impl Iterator<Item = Other<'_>> {
        self.others_of(at / WINDOW).skip_while(move |other| other.at < at)
    }

    /// What is no motion from this window on.
    fn others_of(&self, first: usize) -> impl DoubleEndedIterator<Item = Other<'_>> + Clone {
        self.0.iter().enumerate().skip(first).flat_map(|(number, window)| {
            window.others.iter().map(move |(place, step)| {
                let place = usize::from(*place);
                Other { at: number * WINDOW + place, line: window.line(place), step, in_use: window.used(place) }
            })
        })
    }

    /// What is in use, from which entry on: each where it is another one than before.
    pub fn in_use(&self) -> Vec<[usize; 2]> {
        let mut all: Vec<[usize; 2]> = Vec::new();
        for (number, window) in self.0.iter().enumerate() {
            for (place, used) in &window.in_use {
                let used = *used as usize;
                if all.last().is_none_or(|[_, last]| *last != used) {
                    all.push([number * WINDOW + usize::from(*place), used]);
                }
            }
        }
        all
    }
}

impl FromIterator<Entry> for Entries {
    fn from_iter<I: IntoIterator<Item = Entry>>(entries: I) -> Entries {
        let mut all = Entries::default();
        all.extend(entries);
        all
    }
}

impl Extend<Entry> for Entries {
    fn extend<I: IntoIterator<Item = Entry>>(&mut self, entries: I) {
        entries.into_iter().for_each(|entry| self.push(entry));
    }
}

impl<'a> IntoIterator for &'a Entries {
    type Item = Entry;
    type IntoIter = Iter<'a>;

    fn into_iter(self) -> Iter<'a> {
        self.iter()
    }
}

/// Entries one after the other, made anew as they are asked for.
#[derive(Clone, Debug)]
pub struct Iter<'a> {
    of: &'a Entries,
    left: Range<usize>,
}

impl Iterator for Iter<'_> {
    type Item = Entry;

    fn next(&mut self) -> Option<Entry> {
        self.of.get(self.left.next()?)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.left.size_hint()
    }
}

impl DoubleEndedIterator for Iter<'_> {
    fn next_back(&mut self) -> Option<Entry> {
        self.of.get(self.left.next_back()?)
    }
}

impl ExactSizeIterator for Iter<'_> {}

/// What is kept for a number, where something is.
fn kept<T: Copy>(all: &[(u16, T)], number: usize) -> Option<T> {
    let found = all.binary_search_by_key(&number, |(of, _)| usize::from(*of)).ok()?;
    all.get(found).map(|(_, kept)| *kept)
}

/// Whether two places are the same to the last bit.
fn same(one: Mcs, other: Mcs) -> bool {
    one.0.map(f64::to_bits) == other.0.map(f64::to_bits)
}

impl Window {
    fn push(&mut self, Entry { line, step, in_use }: Entry) {
        let (place, number) = (self.sorts.len() as u16, self.ends.len() as u16);
        self.lines.push(line.map_or(0, |line| line.saturating_add(1)));
        let in_use = in_use as u32;
        if self.in_use.last().is_none_or(|(_, last)| *last != in_use) {
            self.in_use.push((place, in_use));
        }
        let Step::Motion { kind, from, to, around, feed } = step else {
            self.sorts.push(OTHER);
            self.others.push((place, step));
            return;
        };
        self.sorts.push(kind as u8);
        if self.ends.last().is_none_or(|end| !same(*end, from)) {
            self.starts.push((number, from));
        }
        self.rounds.extend(around.map(|around| (number, around)));
        self.ends.push(to);
        self.feeds.push(feed);
    }

    fn pop(&mut self) -> Option<Entry> {
        let place = self.sorts.len().checked_sub(1)?;
        let entry = self.get(place);
        self.in_use.pop_if(|(from, _)| usize::from(*from) == place);
        self.lines.pop();
        if self.sorts.pop() == Some(OTHER) {
            self.others.pop();
            return entry;
        }
        self.ends.pop();
        self.feeds.pop();
        let number = self.ends.len();
        self.starts.pop_if(|(of, _)| usize::from(*of) == number);
        self.rounds.pop_if(|(of, _)| usize::from(*of) == number);
        entry
    }

    fn get(&self, place: usize) -> Option<Entry> {
        let sort = *self.sorts.get(place)?;
        let before = self.others.partition_point(|(of, _)| usize::from(*of) < place);
        let step = match KINDS.get(usize::from(sort)) {
            None => self.others.get(before)?.1.clone(),
            Some(kind) => self.motion(*kind, place - before)?,
        };
        Some(Entry { line: self.line(place), step, in_use: self.used(place) })
    }

    fn motion(&self, kind: MotionKind, number: usize) -> Option<Step> {
        let before = || self.ends.get(number.checked_sub(1)?).copied();
        Some(Step::Motion {
            kind,
            from: kept(&self.starts, number).or_else(before)?,
            to: *self.ends.get(number)?,
            around: kept(&self.rounds, number),
            feed: *self.feeds.get(number)?,
        })
    }

    fn line(&self, place: usize) -> Option<u32> {
        self.lines.get(place)?.checked_sub(1)
    }

    fn used(&self, place: usize) -> usize {
        let behind = self.in_use.partition_point(|(from, _)| usize::from(*from) <= place);
        behind.checked_sub(1).and_then(|at| self.in_use.get(at)).map_or(0, |(_, used)| *used as usize)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::{Degrees, Dir};
    use proptest::prelude::*;

    fn place() -> impl Strategy<Value = Mcs> {
        // few values, so that motions often begin where the one before them ended, and a 0 of each sign
        let value = || prop::sample::select(vec![0.0, -0.0, 1.0, 2.5]);
        [value(), value(), value()].prop_map(Mcs)
    }

    fn step() -> impl Strategy<Value = Step> {
        let around = (place(), any::<bool>()).prop_map(|(centre, round)| {
            let axis = Dir::new([0.0, 0.0, 1.0]);
            round.then_some(Around { centre, axis, degrees: Degrees(90.0) })
        });
        let kind = prop::sample::select(KINDS.to_vec());
        prop_oneof![
            4 => (kind, place(), place(), around, 0..3_u8).prop_map(|(kind, from, to, around, feed)| {
                Step::Motion { kind, from, to, around, feed: f64::from(feed) }
            }),
            1 => Just(Step::CallEnd),
            1 => "[A-Z]{1,3}".prop_map(|text| Step::Message { text, waits: false }),
        ]
    }

    fn entry() -> impl Strategy<Value = Entry> {
        let line = prop_oneof![Just(None), (0..5_u32).prop_map(Some)];
        (line, step(), 0..3_usize).prop_map(|(line, step, in_use)| Entry { line, step, in_use })
    }

    /// To the last bit: a 0 has a sign.
    fn shown<'a>(entries: impl IntoIterator<Item = &'a Entry>) -> Vec<String> {
        entries.into_iter().map(|entry| format!("{entry:?}")).collect()
    }

    proptest! {
        // oracle: self: a list of the entries themselves
        #[test]
        fn what_is_kept_is_what_was_added(all in proptest::collection::vec(entry(), 0..40), at in 0..40_usize) {
            let mut entries: Entries = all.iter().cloned().collect();
            prop_assert_eq!((entries.len(), entries.is_empty()), (all.len(), all.is_empty()));
            prop_assert_eq!(shown(&entries.to_vec()), shown(&all));
            prop_assert_eq!(entries.get(at), all.get(at).cloned());
            let back: Vec<Entry> = entries.iter().rev().collect();
            prop_assert_eq!(shown(&back), shown(all.iter().rev()));
            let others: Vec<(usize, Option<u32>, &Step, usize)> =
                entries.others().map(|one| (one.at, one.line, one.step, one.in_use)).collect();
            let other = |(_, one): &(usize, &Entry)| !matches!(one.step, Step::Motion { .. });
            let wanted = all.iter().enumerate().filter(other);
            let wanted: Vec<_> = wanted.map(|(at, one)| (at, one.line, &one.step, one.in_use)).collect();
            prop_assert_eq!(others, wanted);
            for [from, used] in entries.in_use() {
                prop_assert_eq!(all[from].in_use, used);
            }
            let behind = entries.split_off(at);
            let at = at.min(all.len());
            prop_assert_eq!(shown(&behind), shown(&all[at..]));
            prop_assert_eq!(&entries, &all[..at].iter().cloned().collect::<Entries>());
            prop_assert_eq!(entries.last(), all[..at].last().cloned());
        }
    }

    // oracle: hand: over the edges of windows, the same as one by one; a straight motion takes less than 40 bytes
    #[test]
    fn windows_follow_one_another() {
        let motion = |number: usize| Entry {
            line: Some(number as u32),
            step: Step::Motion {
                kind: MotionKind::Positioning,
                from: Mcs([number as f64, 0.0, 0.0]),
                to: Mcs([number as f64 + 1.0, 0.0, 0.0]),
                around: None,
                feed: 100.0,
            },
            in_use: usize::from(number >= WINDOW),
        };
        let count = 2 * WINDOW + 10;
        let mut entries: Entries = (0..count).map(motion).collect();
        assert_eq!(entries.0.len(), 3);
        assert!(entries.iter().enumerate().all(|(number, entry)| entry == motion(number)));
        assert_eq!(entries.in_use(), [[0, 0], [WINDOW, 1]]);
        assert!(entries.0.iter().all(|window| window.starts.len() == 1));
        assert_eq!(entries.split_off(WINDOW).len(), WINDOW + 10);
        assert_eq!((entries.len(), entries.0.len()), (WINDOW, 1));
    }
}
