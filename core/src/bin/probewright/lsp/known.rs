//! What is known about a program that an editor shows: its tree, its calls, what is wrong with it.

use super::settings::Settings;
use super::text::Text;
use crate::file::Problem;
use crate::joined::Joined;
use probewright_core::control::delivery;
use probewright_core::diagnostic::{Diagnostic, Span};
use probewright_core::form::{self, Field};
use probewright_core::message::Message;
use probewright_core::name::Name;
use probewright_core::program::calls::{CallSite, calls_on};
use probewright_core::program::places::places;
use probewright_core::syntax::{Program, Word};
use probewright_core::{control::Control, program, syntax};
use std::path::{Path, PathBuf};

/// A program that an editor shows.
pub struct Document {
    pub text: Text,
    pub version: i32,
    /// None: it is no file yet.
    pub path: Option<PathBuf>,
    /// Since the last change; none: nobody has asked.
    pub known: Option<Known>,
}

/// What is known about a text, as `probewright check` finds it.
pub struct Known {
    /// The text and the files beside it.
    pub joined: Joined,
    /// Their tree.
    pub program: Program,
    /// Their calls.
    pub sites: Vec<CallSite>,
    /// The control on which the program starts.
    pub control: Control,
    /// What is wrong.
    pub found: Vec<Diagnostic>,
}

/// A value of a call, and the place at which it is written.
pub struct Valued<'a> {
    pub site: &'a CallSite,
    pub name: Name,
    pub place: Span,
}

impl Known {
    /// Reads a text with the files around it, as `read` gives them.
    pub fn of(
        document: &Document,
        settings: &Settings,
        read: &dyn Fn(&Path) -> Result<Vec<u8>, Problem>,
    ) -> Result<Known, Problem> {
        let path = document.path.as_deref().unwrap_or(Path::new(""));
        let source = document.text.as_str().as_bytes().to_vec();
        Ok(Known::made(Joined::around(path, source, settings.with(), settings.control(), read)?, settings))
    }

    /// Reads a text without the files around it.
    pub fn alone(document: &Document, settings: &Settings) -> Result<Known, Problem> {
        let path = document.path.as_deref().unwrap_or(Path::new(""));
        let source = document.text.as_str().as_bytes().to_vec();
        Ok(Known::made(Joined::around(path, source, &[], settings.control(), &crate::file::program)?, settings))
    }

    fn made(joined: Joined, settings: &Settings) -> Known {
        let control = match &settings.described {
            Some(described) => described.setup.control.clone(),
            None => delivery(joined.dialect),
        };
        let program = syntax::read_held(control.dialect, &joined.text, &control.definitions.macros, &mut |_| {});
        let sites = calls_on(&program, control.clone());
        let found = program::findings_of(&program, &sites, &control);
        Known { joined, program, sites, control, found }
    }

    /// The calls of the program itself, by their numbers in it.
    pub fn own(&self) -> impl Iterator<Item = (usize, &CallSite)> {
        self.sites.iter().filter(|site| self.joined.of_program(site.span)).enumerate()
    }

    /// The word at a byte, also behind its end.
    pub fn word(&self, at: u32) -> Option<&Word> {
        let before = at.saturating_sub(1);
        let at = self.program.word_at(Span { start: at, end: at });
        at.or_else(|| self.program.word_at(Span { start: before, end: before + 1 }))
    }

    /// The call at a byte.
    pub fn call(&self, at: u32) -> Option<&CallSite> {
        self.own().map(|(_, site)| site).find(|site| touches(site.span, at))
    }

    /// The call that what is written at a byte may still reach: the next one of the text.
    pub fn next(&self, at: u32) -> Option<&CallSite> {
        self.own().map(|(_, site)| site).find(|site| site.span.end >= at)
    }

    /// The values that are written at a byte, each with the call that it reaches; that of the nearest one first.
    pub fn valued(&self, at: u32) -> Vec<Valued<'_>> {
        let mut found = Vec::new();
        for site in &self.sites {
            let own = places(&self.program, site).into_iter().filter(|(_, place)| *place != site.span);
            let others =
                site.origins.iter().flat_map(|(name, all)| all.iter().map(|one| (*name, self.whole(one.place))));
            let here = own.chain(others).find(|(_, place)| touches(*place, at));
            found.extend(here.map(|(name, place)| Valued { site, name, place }));
        }
        found.sort_by_key(|one| one.site.span.start < at);
        found
    }

    /// The assignment around a value.
    fn whole(&self, place: Span) -> Span {
        self.program.word_at(place).filter(|word| word.called().is_none()).map_or(place, |word| word.span)
    }

    /// Where the values of a call are written that do not stand in it, in the order of the text.
    pub fn written(&self, site: &CallSite) -> Vec<Span> {
        let origins = site.origins.values().flatten().map(|one| self.whole(one.place));
        let mut all: Vec<Span> = places(&self.program, site).into_values().chain(origins).collect();
        all.retain(|place| !site.span.holds(*place));
        all.sort_by_key(|place| (place.start, place.end));
        all.dedup();
        all
    }

    /// The fields of a call with its values: in the list of a newer control those of the list.
    pub fn fields(&self, site: &CallSite) -> Vec<Field> {
        let control = site.control_at(&self.control);
        match site.newer_list() {
            Some(list) => form::fields_of_call(site.cycle, list, &site.values, &control),
            None => form::fields(site.cycle, &site.values, &control),
        }
    }

    /// Number of the variant of a call, where that is known.
    pub fn variant(&self, site: &CallSite) -> Option<i64> {
        site.variant(&site.control_at(&self.control))
    }

    /// What a call is called: its variant where that is known, else its cycle.
    pub fn title(&self, site: &CallSite) -> Message {
        let title = site.title(&site.control_at(&self.control));
        title.unwrap_or_else(|| Message::new(format!("{}-title", site.cycle.key)))
    }
}

/// Whether a byte is in a place, or behind its last one.
pub fn touches(place: Span, at: u32) -> bool {
    place.start <= at && at <= place.end
}

/// The name around a byte of a text, with an index: `_SETV[0]`, `$TC_DP12`, `#500`, `PW100`.
pub fn name_around(text: &str, at: usize) -> &str {
    let of_name = |one: char| one.is_alphanumeric() || "_$#".contains(one);
    let (before, behind) = text.split_at_checked(at).unwrap_or((text, ""));
    let in_index = before.rfind('[').filter(|open| before.get(open + 1..).is_some_and(in_brackets));
    let head = in_index.and_then(|open| before.get(..open)).unwrap_or(before);
    let start = head.len() - head.chars().rev().take_while(|one| of_name(*one)).map(char::len_utf8).sum::<usize>();
    let mut end = match in_index {
        Some(open) => open,
        None => at + behind.chars().take_while(|one| of_name(*one)).map(char::len_utf8).sum::<usize>(),
    };
    if let Some(rest) = text.get(end..).and_then(|rest| rest.strip_prefix('[')) {
        let inside = rest.find(']').and_then(|close| rest.get(..close)).filter(|inside| in_brackets(inside));
        end += inside.map_or(0, |inside| inside.len() + 2);
    }
    text.get(start..end).unwrap_or_default()
}

fn in_brackets(text: &str) -> bool {
    text.chars().all(|one| one.is_ascii_alphanumeric() || ",_$ ".contains(one))
}
