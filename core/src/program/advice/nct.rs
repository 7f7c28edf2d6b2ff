//! What has to be active at a macro of NCT: the spindle is oriented (C:68-72, M19 in every example: C:234), the stylus
//! is switched on (M59, which orients too, and M55 to switch it off: C:64), and a macro may be called on its level.

use crate::catalogue::by_program;
use crate::diagnostic::{Diagnostic, Span};
use crate::entry::ProbeUse;
use crate::message::Message;
use crate::own::{self, Own};
use crate::program::calls::CallSite;
use crate::program::change::line_at_begin;
use crate::program::flow::Mode;
use crate::syntax::programs::{Programs, Unit, numbered};
use crate::syntax::{Block, Program, Word};

/// Everything about the macros that the text calls.
pub fn look(program: &Program, programs: &Programs, sites: &[CallSite], found: &mut Vec<Diagnostic>) {
    if sites.is_empty() {
        return;
    }
    let calls = callers(program, programs);
    let quiet: Vec<bool> = programs.units.iter().map(|unit| is_quiet(program, unit)).collect();
    let switches = words(program, &program.blocks).any(|(_, word)| matches!(word, Said::Machine(59 | 55)));
    let mut sites = sites.iter().peekable();
    for (at, unit) in programs.units.iter().enumerate() {
        let called = calls.iter().flatten().any(|other| *other == at);
        let mut place = if called { Active::elsewhere() } else { Active::default() };
        place.whole = is_whole(program, unit);
        let mut one = Unitary { program, programs, quiet: &quiet, switches, found };
        for line in unit.blocks.clone() {
            let Some(block) = program.blocks.get(line) else { break };
            one.block(&mut place, block);
            while let Some(site) = sites.next_if(|site| site.line as usize <= line) {
                one.call(&mut place, site);
            }
        }
        one.end(&place, unit, called);
    }
}

/// What is active, as far as the text tells.
#[derive(Default)]
struct Active {
    /// M19, M59 (true); the spindle was started since (false).
    oriented: Mode<bool>,
    /// M59, or M55.
    stylus: Mode<bool>,
    /// Place of the M59.
    switched: Option<Span>,
    /// The text is more than a piece of a program: what it does not say is not done.
    whole: bool,
}

impl Active {
    fn elsewhere() -> Active {
        Active { oriented: Mode::Open, stylus: Mode::Open, ..Active::default() }
    }
}

/// What a word says.
enum Said {
    Machine(i64),
    Tool,
    /// Calls a program: M98, G65.
    Calls,
    /// Goes somewhere else.
    Leaves,
}

/// The words of blocks that say something, with their places.
fn words<'a>(program: &'a Program, blocks: &'a [Block]) -> impl Iterator<Item = (Span, Said)> + 'a {
    blocks.iter().flat_map(|block| program.words_of(block)).filter_map(|word| {
        let said = if let Some(number) = program.machine_function(word) {
            if number == 98.0 { Said::Calls } else { Said::Machine(number as i64) }
        } else if calls_macro(program, word) {
            Said::Calls
        } else if program.is_keyword(word, &["GOTO"]) {
            Said::Leaves
        } else if program.address(word, "T").is_some() || program.address(word, "H").is_some() {
            Said::Tool
        } else {
            return None;
        };
        Some((word.span, said))
    })
}

/// Whether a word calls the program at P with arguments: G65, or G66 after each motion.
pub(super) fn calls_macro(program: &Program, word: &Word) -> bool {
    matches!(program.literal(word, "G"), Some(65.0 | 66.0))
}

/// Whether a program is one from its beginning on: it has a number, or the end of a main program. One that ends as a
/// subprogram may be called from another file, and a text that calls a tool is taken for a whole program there.
fn is_whole(program: &Program, unit: &Unit) -> bool {
    let ends = |wanted: &[i64]| {
        let mut all = words(program, program.blocks_of(unit));
        all.any(|(_, said)| matches!(said, Said::Machine(number) if wanted.contains(&number)))
    };
    ends(&[2, 30]) || unit.file.is_some() && !ends(&[99])
}

/// Whether a program neither switches nor turns anything, nor calls another one.
fn is_quiet(program: &Program, unit: &Unit) -> bool {
    let blocks = program.blocks.get(unit.blocks.clone()).unwrap_or_default();
    !words(program, blocks).any(|(_, said)| matches!(said, Said::Machine(3 | 4 | 19 | 55 | 59) | Said::Calls))
}

/// One program of the text, in the order of its lines: one way through it.
struct Unitary<'a> {
    program: &'a Program,
    programs: &'a Programs,
    /// Which programs of the text change nothing that counts here.
    quiet: &'a [bool],
    /// Whether the text switches the stylus anywhere.
    switches: bool,
    found: &'a mut Vec<Diagnostic>,
}

impl Unitary<'_> {
    fn block(&mut self, place: &mut Active, block: &Block) {
        let elsewhere = |place: &Active| Active { whole: place.whole, ..Active::elsewhere() };
        for (span, said) in words(self.program, std::slice::from_ref(block)) {
            match said {
                Said::Machine(19) => place.oriented = Mode::Is(true),
                Said::Machine(59) => {
                    (place.oriented, place.stylus) = (Mode::Is(true), Mode::Is(true));
                    place.switched = Some(span);
                }
                Said::Machine(55) => place.stylus = Mode::Is(false),
                Said::Machine(3 | 4) => self.started(place, span),
                Said::Tool => place.whole = true,
                Said::Calls if self.may_change(block) => *place = elsewhere(place),
                // behind a jump the text goes on from somewhere else, unless it has a condition
                Said::Leaves if !self.is_conditional(block) => *place = elsewhere(place),
                Said::Machine(_) | Said::Calls | Said::Leaves => {}
            }
        }
    }

    /// Whether what a block calls may switch or turn something: no macro, and no program of the text that is quiet.
    fn may_change(&self, block: &Block) -> bool {
        let called = called_here(self.program, self.programs, block);
        let quiet = called.and_then(|unit| self.quiet.get(unit)).copied().unwrap_or(false);
        !quiet && !measuring_program(self.program, block)
    }

    fn is_conditional(&self, block: &Block) -> bool {
        self.program.words_of(block).iter().any(|word| self.program.is_keyword(word, &["IF"]))
    }

    /// M3, M4: the stylus has to be off.
    fn started(&mut self, place: &mut Active, span: Span) {
        place.oriented = Mode::Is(false);
        if place.stylus == Mode::Is(true) {
            let line = self.program.line_of(span.start);
            self.say(own::NCT_STYLUS_ON, span, line, "M55");
            place.stylus = Mode::Open;
        }
    }

    fn call(&mut self, place: &mut Active, site: &CallSite) {
        if site.cycle.purpose.probe != ProbeUse::Workpiece {
            return;
        }
        if place.oriented == Mode::Is(false) || place.whole && place.oriented.unset() {
            self.say(own::NCT_ORIENTED, site.span, site.line, "M19");
            place.oriented = Mode::Open;
        }
        let off = place.stylus == Mode::Is(false) || place.whole && self.switches && place.stylus.unset();
        if off {
            self.say(own::NCT_STYLUS_OFF, site.span, site.line, "M59");
            place.stylus = Mode::Open;
        }
    }

    /// The main program ends with the stylus on.
    fn end(&mut self, place: &Active, unit: &Unit, called: bool) {
        if called || place.stylus != Mode::Is(true) {
            return;
        }
        let blocks = self.program.blocks.get(unit.blocks.clone()).unwrap_or_default();
        let ends = words(self.program, blocks).filter(|(_, said)| matches!(said, Said::Machine(2 | 30)));
        if let Some((span, _)) = ends.last() {
            self.say(own::NCT_STYLUS_LEFT, span, self.program.line_of(span.start), "M55");
        }
    }

    /// A finding with the line that helps.
    fn say(&mut self, sentence: Own, span: Span, line: u32, text: &str) {
        let edit = line_at_begin(self.program, line, text);
        let label = Message::new("advice-insert").text("text", text);
        self.found.push(sentence.finding().on(span).cured(label, edit.into_iter().collect()));
    }
}

/// The macro that a block calls by its program number.
fn measuring_program(program: &Program, block: &Block) -> bool {
    let called = program.words_of(block).iter().find_map(|word| program.literal(word, "P"));
    let by_macro = program.words_of(block).iter().any(|word| calls_macro(program, word));
    by_macro && called.is_some_and(|number| by_program(number).is_some())
}

/// The program of the text that a block calls with M98 or G65.
pub(super) fn called_here(program: &Program, programs: &Programs, block: &Block) -> Option<usize> {
    let calls = words(program, std::slice::from_ref(block)).any(|(_, said)| matches!(said, Said::Calls));
    let number = program.words_of(block).iter().find_map(|word| program.literal(word, "P"));
    programs.place(&numbered(number.filter(|_| calls)?)?)
}

/// The programs of the text that each of them calls.
fn callers(program: &Program, programs: &Programs) -> Vec<Vec<usize>> {
    let called = |block: &Block| called_here(program, programs, block);
    programs.units.iter().map(|unit| program.blocks_of(unit).iter().filter_map(called).collect()).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use crate::dialect::Dialect;
    use crate::program::findings::findings;
    use crate::syntax::read;

    /// Keys of these findings, with the line from 1.
    fn told(text: &str) -> Vec<(String, u32)> {
        let program = read(Dialect::Nct, text.as_bytes());
        let found = findings(&program).into_iter();
        let ours = found.filter(|one| one.message.key.starts_with("nct-") && one.message.key != "nct-levels");
        ours.map(|one| (one.message.key.to_string(), program.line_of(one.span.unwrap().start) + 1)).collect()
    }

    fn one(key: &str, line: u32) -> Vec<(String, u32)> {
        vec![(key.to_owned(), line)]
    }

    const POSITIONED: &str = "G43 Z100 H98\nG101 Z-10\nG110 D50 S1\n";

    #[test]
    fn an_oriented_spindle_is_asked_for() {
        // oracle: manual C:68-72 (no cycle without orientation), C:234 (M19 before the stylus in every example)
        let text = |m: &str| format!("O0110\n{m}\nT98\n{POSITIONED}M30\n");
        assert_eq!(told(&text("")), one("nct-oriented", 5));
        assert_eq!(told(&text("M19")), []);
        assert_eq!(told(&text("M19\nS500 M3")), one("nct-oriented", 6));
        // M59 orients too (C:64), and has to be undone before the end
        assert_eq!(told(&text("M59")), one("nct-stylus-left", 7));
    }

    #[test]
    fn the_stylus_is_switched_on_before_and_off_behind() {
        // oracle: manual C:62-64 (M59 on, M55 off)
        let whole = format!("O0110\nT98\nM59\n{POSITIONED}M55\nM3\nM30\n");
        assert_eq!(told(&whole), []);
        assert_eq!(told(&whole.replace("M55\n", "")), one("nct-stylus-on", 7));
        assert_eq!(told(&whole.replace("M59", "M19")), one("nct-stylus-off", 5));
        // a text without either is of a machine without them
        assert_eq!(told(&whole.replace("M59", "M19").replace("M55\n", "")), []);
    }

    #[test]
    fn a_program_without_a_tool_is_asked_too() {
        // oracle: manual C:62-72 (no macro without orientation; M55 switches the stylus off)
        assert_eq!(told("O1000\nG110 D40 Z-10\nM30\n"), one("nct-oriented", 2));
        assert_eq!(told("G110 D40 Z-10\nM30\n"), one("nct-oriented", 1));
        assert_eq!(told("O1000\nG110 D40 Z-10\n"), one("nct-oriented", 2));
        // what the text itself undoes is told of a piece too
        assert_eq!(told("M59\nG102 D50\nG110 D40 S1\nM55\nG105 X5\n"), one("nct-stylus-off", 5));
        assert_eq!(told("M19\nS500 M3\nG110 D40 S1\n"), one("nct-oriented", 3));
    }

    #[test]
    fn what_another_program_does_is_not_known() {
        // oracle: hand
        assert_eq!(told(&format!("O0110\nT98\nM98 P200\n{POSITIONED}M30\nO0200\nM19\nM99\n")), []);
        assert_eq!(told(&format!("O0110\nT98\nM98 P200\nM30\nO0200\n{POSITIONED}M99\n")), []);
        assert_eq!(told("G110 D50 S1\n"), []); // a piece
        assert_eq!(told("O0200\nG110 D50 S1\nM99\n"), []); // another file may call it
        let quiet = format!("O0110\nT98\nM98 P200\n{POSITIONED}M30\nO0200\n#1=2\nM99\n");
        assert_eq!(told(&quiet), one("nct-oriented", 5));
        assert_eq!(told(&format!("O0110\nT98\nIF[#1EQ1]GOTO9\n{POSITIONED}N9 M30\n")), one("nct-oriented", 5));
        assert_eq!(told(&format!("O0110\nT98\nGOTO9\nN8 {POSITIONED}M30\nN9 M19\nGOTO8\n")), []);
    }
}
