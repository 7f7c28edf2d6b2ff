//! What can be written at a place: cycles, parameters of the call that it reaches, values of a parameter.

use super::foreign;
use super::known::{Document, Known};
use lsp_types::{CompletionItem, CompletionItemKind, CompletionTextEdit, Position, Range, TextEdit};
use probewright_core::catalogue::CYCLES;
use probewright_core::control::delivery;
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Arg, ArgumentList, Cycle, Style};
use probewright_core::form::{self, Choice, Entry, Field, Group};
use probewright_core::message::Message;
use probewright_core::name::Name;
use probewright_core::program::calls::CallSite;
use probewright_core::program::lists::without_form;
use probewright_core::words::Words;

/// What is being written, up to the place.
enum Begun<'a> {
    /// A value of a parameter: its name, and what of the value is there.
    Value(&'a str, &'a str),
    /// An argument in brackets: what is called, what stands in them before it, what of it is there.
    Argument(&'a str, &'a str, &'a str),
    /// A name.
    Name(&'a str),
}

/// What can be written at a position.
pub fn at(document: &Document, known: &Known, at: Position, words: &Words) -> Vec<CompletionItem> {
    if let Some(items) = foreign::at(document, known, at, words) {
        return items;
    }
    let (before, byte) = document.text.before(at);
    let by_address = known.program.dialect == Dialect::Nct;
    if in_comment(before, by_address) {
        return Vec::new();
    }
    let begun = begun(before);
    let (Begun::Value(_, typed) | Begun::Argument(.., typed) | Begun::Name(typed)) = begun;
    let start = document.text.position(byte - typed.len());
    let make = Make { range: Range::new(start, at), words };
    let next = known.next(byte as u32);
    let mut items = match begun {
        Begun::Value(name, _) => values(known, next, name, &make),
        Begun::Argument(called, inside, _) => argument(known, byte as u32, called, inside, &make),
        Begun::Name(_) => names(known, next, byte as u32, &make),
    };
    for (at, item) in items.iter_mut().enumerate() {
        item.sort_text = Some(format!("{at:05}"));
    }
    items
}

fn in_comment(before: &str, by_address: bool) -> bool {
    let (mut text, mut comment) = (false, false);
    for one in before.chars() {
        match one {
            '"' if !comment && !by_address => text = !text,
            ';' if !text && !by_address => comment = true,
            '(' if by_address => comment = true,
            ')' if by_address => comment = false,
            _ => {}
        }
    }
    comment || text
}

fn begun(before: &str) -> Begun<'_> {
    let of_name = |one: char| one.is_alphanumeric() || "_$#[],.".contains(one);
    if let Some((called, inside)) = open_call(before) {
        let typed = inside.rsplit(',').next().unwrap_or_default().trim_start();
        return Begun::Argument(called, inside, typed);
    }
    let typed = last(before, |one| of_name(one) || "-+".contains(one));
    let rest = before.get(..before.len() - typed.len()).unwrap_or_default();
    match rest.trim_end().strip_suffix('=') {
        Some(left) => Begun::Value(last(left.trim_end(), of_name), typed),
        None => Begun::Name(last(before, of_name)),
    }
}

/// The end of a text that is made of these characters.
fn last(text: &str, of: impl Fn(char) -> bool) -> &str {
    let length: usize = text.chars().rev().take_while(|one| of(*one)).map(char::len_utf8).sum();
    text.get(text.len() - length..).unwrap_or_default()
}

/// The call whose brackets are open, and what stands in them.
fn open_call(before: &str) -> Option<(&str, &str)> {
    let mut depth = 0;
    let open = before.char_indices().rev().find(|(_, one)| {
        depth += i32::from(*one == ')') - i32::from(*one == '(');
        depth < 0
    });
    let (head, inside) = before.split_at_checked(open?.0)?;
    Some((last(head, |one| one.is_alphanumeric() || one == '_'), inside.get(1..)?))
}

/// Makes items.
pub struct Make<'a> {
    pub range: Range,
    pub words: &'a Words,
}

impl Make<'_> {
    pub fn item(&self, label: &str, insert: &str, kind: CompletionItemKind, detail: String) -> CompletionItem {
        let edit = TextEdit { range: self.range, new_text: insert.to_owned() };
        CompletionItem {
            label: label.to_owned(),
            kind: Some(kind),
            detail: Some(detail),
            filter_text: Some(insert.to_owned()),
            text_edit: Some(CompletionTextEdit::Edit(edit)),
            ..CompletionItem::default()
        }
    }

    fn choice(&self, value: i64, detail: String) -> CompletionItem {
        let text = value.to_string();
        self.item(&text, &text, CompletionItemKind::ENUM_MEMBER, detail)
    }

    fn choices(&self, choices: &[Choice]) -> Vec<CompletionItem> {
        choices.iter().map(|one| self.choice(one.value, self.words.text(&one.label))).collect()
    }

    /// The number with each choice of each of its groups of digits.
    fn digits(&self, number: i64, groups: &[Group]) -> Vec<CompletionItem> {
        let mut items: Vec<CompletionItem> = Vec::new();
        for group in groups {
            let label = self.words.text(&group.label);
            for (at, choice) in group.choices.iter().enumerate() {
                let led = group.leads.get(at).copied();
                let value = led.unwrap_or_else(|| number + (choice.value - group.value).saturating_mul(group.place));
                let text = self.words.text(&choice.label);
                if !items.iter().any(|item| item.label == value.to_string()) {
                    items.push(self.choice(value, format!("{label}: {text}")));
                }
            }
        }
        items
    }

    /// A cycle by its name.
    fn cycle(&self, cycle: &Cycle) -> CompletionItem {
        let title = self.words.key(format!("{}-title", cycle.key));
        self.item(cycle.name, cycle.name, CompletionItemKind::FUNCTION, title)
    }
}

/// The values that a parameter of a call can have; before any call, the variants of every cycle.
fn values(known: &Known, next: Option<&CallSite>, name: &str, make: &Make) -> Vec<CompletionItem> {
    let Some(site) = next else { return variants(known, name, make) };
    let fields = known.fields(site);
    let field = fields.iter().find(|field| field.name.eq_ignore_ascii_case(name));
    let variants = || (site.cycle.variant_param()?.eq_ignore_ascii_case(name)).then(|| of_cycle(site.cycle, make));
    variants().unwrap_or_else(|| field.map_or_else(Vec::new, |field| of_field(field, site, make)))
}

fn of_field(field: &Field, site: &CallSite, make: &Make) -> Vec<CompletionItem> {
    let number = site.values.get(&*field.name).and_then(|text| text.trim().parse::<f64>().ok());
    match &field.entry {
        Entry::Choice { choices } => make.choices(choices),
        Entry::Digits { digits } => make.digits(number.unwrap_or(0.0) as i64, digits),
        _ => Vec::new(),
    }
}

fn of_cycle(cycle: &Cycle, make: &Make) -> Vec<CompletionItem> {
    cycle.variants.iter().map(|one| make.choice(one.number, make.words.key(one.key))).collect()
}

fn variants(known: &Known, name: &str, make: &Make) -> Vec<CompletionItem> {
    let numbered = |cycle: &&&Cycle| {
        let variant = cycle.variant_param().is_some_and(|param| param.eq_ignore_ascii_case(name));
        cycle.dialect == known.program.dialect && variant
    };
    let mut items = Vec::new();
    for cycle in CYCLES.iter().filter(numbered) {
        items.extend(of_cycle(cycle, make).into_iter().map(|item| {
            let detail = item.detail.map(|detail| format!("{}: {detail}", cycle.name));
            CompletionItem { detail, ..item }
        }));
    }
    items
}

/// What an argument in brackets can be, by the lists of the cycles.
fn argument(known: &Known, at: u32, called: &str, inside: &str, make: &Make) -> Vec<CompletionItem> {
    let place = inside.matches(',').count();
    let site = known.call(at).or_else(|| known.next(at));
    let of_dialect = CYCLES.iter().copied().filter(|cycle| cycle.dialect == known.program.dialect);
    let lists = of_dialect.flat_map(|cycle| cycle.lists.iter().map(move |list| (cycle, list)));
    let lists: Vec<_> = lists.filter(|(_, list)| list.name.eq_ignore_ascii_case(called)).collect();
    // the call that the bracket begins; behind an open one the next call may be another
    let reached = lists.iter().find(|(cycle, _)| site.is_some_and(|site| site.cycle.name == cycle.name));
    let site = site.filter(|_| reached.is_some());
    let found = reached.or(lists.first()).copied();
    let values = |name: &Name| match found {
        Some((cycle, _)) if cycle.variant_param() == Some(*name) => of_cycle(cycle, make),
        _ => match site {
            Some(site) => values(known, Some(site), name, make),
            None => found.map_or_else(Vec::new, |(cycle, list)| in_open(cycle, list, inside, *name, make)),
        },
    };
    match found.and_then(|(_, list)| list.args.get(place)) {
        Some(Arg::Newer(_, Some(name))) => match found {
            // of the variants those whose numbers are known in the list
            Some((cycle, list)) if cycle.variant_param() == Some(*name) => {
                make.choices(&form::known_variants(cycle, list))
            }
            _ => values(name),
        },
        Some(Arg::Select(choices)) => choices.iter().map(|(number, _)| make.choice(*number, String::new())).collect(),
        Some(Arg::Is(number)) => vec![make.choice(*number, called.to_owned())],
        Some(Arg::Newer(name, None)) => own_value(name, make),
        other => other.and_then(Arg::param).map_or_else(Vec::new, |name| values(&name)),
    }
}

/// The values of an argument of a call whose brackets are open, by what stands before it.
fn in_open(
    cycle: &'static Cycle,
    list: &'static ArgumentList,
    inside: &str,
    name: Name,
    make: &Make,
) -> Vec<CompletionItem> {
    if list.style != Style::Operate {
        return Vec::new();
    }
    let said = list.args.iter().zip(inside.split(','));
    let said = said.filter_map(|(arg, text)| Some((arg.param()?.to_string(), text.trim().to_owned())));
    let fields = form::fields_of_call(cycle, list, &said.collect(), &delivery(cycle.dialect));
    let field = fields.into_iter().find(|field| field.name == name).map(|field| field.entry);
    match field {
        Some(Entry::Choice { choices }) => make.choices(&choices),
        _ => Vec::new(),
    }
}

/// The values of an argument that only newer controls have.
fn own_value(name: &str, make: &Make) -> Vec<CompletionItem> {
    match form::argument_entry(name) {
        Entry::Choice { choices } => make.choices(&choices),
        _ => Vec::new(),
    }
}

/// The parameters of the call that the place reaches, those first that it requires and does not have yet; the cycles.
fn names(known: &Known, next: Option<&CallSite>, at: u32, make: &Make) -> Vec<CompletionItem> {
    let by_address = known.program.dialect == Dialect::Nct;
    let cycles = CYCLES.iter().filter(|cycle| cycle.dialect == known.program.dialect);
    let newer = without_form()
        .map(|(name, title)| make.item(name, name, CompletionItemKind::FUNCTION, make.words.text(&title)));
    let cycles = cycles.map(|cycle| make.cycle(cycle)).chain(newer.filter(|_| !by_address));
    let near = next.filter(|site| !by_address || known.program.line_of(at) == site.line);
    let mut items = Vec::new();
    if let Some(site) = near {
        let mut fields = known.fields(site);
        let given = |field: &Field| site.values.contains_key(&*field.name);
        fields.retain(|field| !by_address || !given(field));
        fields.sort_by_key(|field| (given(field), !field.required));
        items.extend(fields.iter().map(|field| parameter(field, by_address, make)));
    }
    items.extend(cycles);
    items
}

fn parameter(field: &Field, by_address: bool, make: &Make) -> CompletionItem {
    let insert = format!("{}{}", field.name, if by_address { "" } else { "=" });
    let unit = if field.unit.is_empty() { String::new() } else { format!(" ({})", field.unit) };
    let label = make.words.text(&field.label);
    let item = make.item(&field.name, &insert, CompletionItemKind::FIELD, label + &unit);
    let help = [Message::clone(&field.help), Message::clone(&field.reason)];
    let told: Vec<String> = help.iter().filter_map(|one| make.words.find(one)).collect();
    CompletionItem { documentation: Some(lsp_types::Documentation::String(told.join("\n"))), ..item }
}
