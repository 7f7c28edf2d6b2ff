//! The rows of each table: which there are, what they hold, and how they come and go.

use super::slot::{Held, Slot};
use super::{Table, own, part};
use crate::control::{Control, Edge, Frame};
use crate::form::machine::Refusal;
use crate::machine::Setup;
use crate::message::Message;
use crate::range::Range;
use crate::workpiece::{Probe, Solid, ToolProbe};

/// Types of tools by `$TC_DP1` (B:974-985, B:4147).
const KINDS: &[i64] = &[120, 110, 140, 200, 240, 500, 510, 520, 540, 580, 710];
/// The channel basic frame that is always shown.
const BASIC: &str = "$P_CHBFR[0]";
/// The highest T and D numbers that can be typed.
const NUMBERS: Range = Range::closed(1.0, 32_000.0);

/// What a row holds, apart from the setup.
pub(super) enum Content {
    Machine(Box<own::Machine>),
    Tool(Box<ToolRow>),
    Offset(Box<Frame>),
    Probe(Box<Probe>),
    ToolProbe(Box<ToolProbe>),
    Solid(Box<Solid>),
}

/// An edge of a tool.
pub(super) struct ToolRow {
    tool: i64,
    name: String,
    edge: i64,
    data: Edge,
}

/// T and D number out of the name of a row: `9/1`.
fn place(id: &str) -> Option<(i64, i64)> {
    let (tool, edge) = id.split_once('/')?;
    Some((tool.parse().ok()?, edge.parse().ok()?))
}

/// The rows that a table has.
pub(super) fn ids(table: Table, setup: &Setup) -> Vec<String> {
    let control = &setup.control;
    match table {
        Table::Machine | Table::Probe => vec!["1".to_owned()],
        Table::Tools => {
            let edges = |(tool, data): (&i64, &crate::control::Tool)| -> Vec<String> {
                data.edges.keys().map(|edge| format!("{tool}/{edge}")).collect()
            };
            control.tools.iter().flat_map(edges).collect()
        }
        Table::Offsets => offsets(control),
        Table::ToolProbes => (0..setup.tool_probes.len()).map(|index| index.to_string()).collect(),
        Table::Part => (0..setup.workpiece.solids.len()).map(|index| index.to_string()).collect(),
    }
}

/// The basic frame, the settable frames of the first row, and all that are there.
fn offsets(control: &Control) -> Vec<String> {
    let make = control.make();
    let first = if make.registers { 1..=6 } else { 1..=4 };
    let mut numbers: Vec<usize> = first.chain(control.frames.keys().copied()).chain([control.settable]).collect();
    numbers.sort_unstable();
    numbers.dedup();
    let basic = (!make.registers).then(|| BASIC.to_owned());
    basic.into_iter().chain(numbers.into_iter().map(|number| make.settable_name(number))).collect()
}

fn frame(control: &Control, id: &str) -> Option<Frame> {
    if id == BASIC {
        return Some(control.stored.channel.get(&0).copied().unwrap_or_default());
    }
    let number = control.make().settable_named(id)?;
    Some(control.frames.get(&number).copied().unwrap_or_default())
}

impl Content {
    pub fn of(table: Table, id: &str, setup: &Setup) -> Option<Content> {
        Some(match table {
            Table::Machine => Content::Machine(Box::new(own::Machine::of(setup))),
            Table::Probe => Content::Probe(Box::new(setup.probe)),
            Table::Offsets => Content::Offset(Box::new(frame(&setup.control, id)?)),
            Table::ToolProbes => {
                Content::ToolProbe(Box::new(setup.tool_probes.get(id.parse::<usize>().ok()?)?.clone()))
            }
            Table::Part => Content::Solid(Box::new(setup.workpiece.solids.get(id.parse::<usize>().ok()?)?.clone())),
            Table::Tools => {
                let (tool, edge) = place(id)?;
                let data = setup.control.edge_of(tool, edge)?.clone();
                let name = setup.control.tools.get(&tool)?.name.clone();
                Content::Tool(Box::new(ToolRow { tool, name, edge, data }))
            }
        })
    }

    /// What a row is called.
    pub fn title(&self, id: &str) -> Message {
        let text = |key: &'static str, name: &str| Message::new(key).text("name", name);
        match self {
            Content::Machine(_) => Message::new("equip-machine"),
            Content::Probe(_) => Message::new("equip-probe"),
            Content::Offset(_) => text("equip-row", id),
            Content::Tool(row) if row.tool == 0 => text("equip-row", &format!("H{}", row.edge)),
            Content::Tool(row) => text("equip-row", format!("T{} D{} {}", row.tool, row.edge, row.name).trim_end()),
            Content::ToolProbe(probe) => numbered(part::named(part::CAPS, &probe.solid.shape), id),
            Content::Solid(solid) => numbered(part::named(part::SHAPES, &solid.shape), id),
        }
    }

    /// Its fields.
    pub fn slots(&mut self, control: &Control) -> Vec<Slot<'_>> {
        match self {
            Content::Machine(machine) => machine.slots(control),
            Content::Probe(probe) => own::probe(probe),
            Content::Offset(frame) => offset(frame),
            Content::ToolProbe(probe) => part::tool_probe(probe),
            Content::Solid(solid) => part::slots(solid),
            Content::Tool(row) => tool(row, control.make().registers),
        }
    }

    /// Puts it back into the setup; gives the row as it is called now.
    pub fn put(self, setup: &mut Setup, id: &str) -> Result<String, Refusal> {
        match self {
            Content::Machine(machine) => machine.put(setup),
            Content::Probe(probe) => setup.probe = *probe,
            Content::Offset(frame) => put_frame(&mut setup.control, id, *frame),
            Content::ToolProbe(probe) => put_at(&mut setup.tool_probes, id, *probe),
            Content::Solid(solid) => put_at(&mut setup.workpiece.solids, id, *solid),
            Content::Tool(row) => return put_tool(setup, id, *row),
        }
        Ok(id.to_owned())
    }
}

/// The name of a solid with its number, from 1.
fn numbered(name: &str, id: &str) -> Message {
    let number = id.parse::<f64>().unwrap_or(0.0) + 1.0;
    Message::new("equip-solid").text("name", name).number("number", number)
}

fn put_at<T>(all: &mut [T], id: &str, one: T) {
    if let Some(place) = id.parse::<usize>().ok().and_then(|at| all.get_mut(at)) {
        *place = one;
    }
}

/// The one at this place once more, behind it; gives its place.
fn copy_at<T: Clone>(all: &mut Vec<T>, id: &str) -> Option<String> {
    let at: usize = id.parse().ok()?;
    let one = all.get(at)?.clone();
    all.insert(at + 1, one);
    Some((at + 1).to_string())
}

fn drop_at<T>(all: &mut Vec<T>, id: &str) {
    if let Some(at) = id.parse::<usize>().ok().filter(|at| *at < all.len()) {
        all.remove(at);
    }
}

fn put_frame(control: &mut Control, id: &str, frame: Frame) {
    if id == BASIC {
        control.stored.channel.insert(0, frame);
    } else if let Some(number) = control.make().settable_named(id) {
        control.frames.insert(number, frame);
    }
    control.activate(control.settable);
}

/// Under its numbers, which are free, or those that it had.
fn put_tool(setup: &mut Setup, id: &str, row: ToolRow) -> Result<String, Refusal> {
    let Some(before) = place(id) else { return Ok(id.to_owned()) };
    let now = (row.tool, row.edge);
    let control = &mut setup.control;
    if now != before && control.edge_of(now.0, now.1).is_some() {
        let name = if control.make().registers { format!("H{}", now.1) } else { format!("T{} D{}", now.0, now.1) };
        let message = Message::new("equip-taken").text("name", name);
        return Err(Refusal { message, hint: Message::new("equip-taken-hint") });
    }
    if now != before {
        remove_edge(setup, before);
        if (setup.control.tool, setup.control.edge) == before || setup.control.active_place() == before {
            (setup.control.tool, setup.control.edge) = now;
        }
        if let Some(real) = setup.real_tools.remove(&before) {
            setup.real_tools.insert(now, real);
        }
    }
    let tool = setup.control.tools.entry(row.tool).or_default();
    if row.tool == before.0 || tool.edges.is_empty() {
        tool.name = row.name;
    }
    tool.edges.insert(row.edge, row.data);
    Ok(format!("{}/{}", row.tool, row.edge))
}

/// A tool without edges goes with its last one.
fn remove_edge(setup: &mut Setup, (tool, edge): (i64, i64)) {
    let tools = &mut setup.control.tools;
    let Some(data) = tools.get_mut(&tool) else { return };
    data.edges.remove(&edge);
    if data.edges.is_empty() {
        tools.remove(&tool);
    }
}

const X: [&str; 3] = ["equip-x", "equip-y", "equip-z"];
const FINE: [&str; 3] = ["equip-x-fine", "equip-y-fine", "equip-z-fine"];
const ABOUT: [&str; 3] = ["equip-about-x", "equip-about-y", "equip-about-z"];

fn offset(frame: &mut Frame) -> Vec<Slot<'_>> {
    let angles = ABOUT.into_iter().zip(&mut frame.rotation.0);
    let angles = angles.map(|(key, angle)| Slot::new(key, Held::Degree(angle)));
    own::lengths(X, &mut frame.coarse).chain(own::lengths(FINE, &mut frame.fine)).chain(angles).collect()
}

const LENGTHS: [&str; 3] = ["equip-l1", "equip-l2", "equip-l3"];
const WEAR: [&str; 3] = ["equip-l1-wear", "equip-l2-wear", "equip-l3-wear"];

/// Of an NCT control a register: one length, one radius.
fn tool(row: &mut ToolRow, registers: bool) -> Vec<Slot<'_>> {
    let lengths = if registers { 1 } else { 3 };
    let Edge { kind, tip, length, radius, length_wear, radius_wear, .. } = &mut row.data;
    let mut all = Vec::new();
    if registers {
        all.push(Slot::new("equip-h", Held::Whole(&mut row.edge)).within(NUMBERS));
    } else {
        all.push(Slot::new("equip-t", Held::Whole(&mut row.tool)).within(NUMBERS));
        all.push(Slot::new("equip-tool-name", Held::Text(&mut row.name)));
        all.push(Slot::new("equip-d", Held::Whole(&mut row.edge)).within(NUMBERS));
        all.push(Slot::new("equip-type", Held::Choice(kind, KINDS)).cited("B:974-985"));
        all.push(Slot::new("equip-tip", Held::Whole(tip)).within(Range::closed(0.0, 9.0)));
    }
    all.extend(own::lengths(LENGTHS, length).take(lengths));
    all.push(Slot::new("equip-radius", Held::Length(radius)));
    all.extend(own::lengths(WEAR, length_wear).take(lengths));
    all.push(Slot::new("equip-radius-wear", Held::Length(radius_wear)));
    all
}

/// Whether a row is in use at the start; none: of this table none ever is.
pub(super) fn active(table: Table, id: &str, setup: &Setup) -> Option<bool> {
    let control = &setup.control;
    match table {
        Table::Tools => Some(place(id) == Some(control.active_place())),
        Table::Offsets if id == BASIC => None,
        Table::Offsets => Some(control.make().settable_name(control.settable) == id),
        _ => None,
    }
}

/// Whether a row can be taken away.
pub(super) fn removable(table: Table, id: &str, setup: &Setup) -> bool {
    match table {
        Table::Machine | Table::Probe => false,
        Table::Tools | Table::ToolProbes | Table::Part => true,
        Table::Offsets => {
            let control = &setup.control;
            let number = control.make().settable_named(id);
            number.is_some_and(|number| control.frames.contains_key(&number) && number != control.settable)
        }
    }
}

/// Puts a row into use.
pub fn put_on(setup: &mut Setup, table: Table, id: &str) {
    match table {
        Table::Tools => {
            let Some((tool, edge)) = place(id) else { return };
            let tool = if setup.control.make().registers { setup.control.tool } else { tool };
            (setup.control.tool, setup.control.edge) = (tool, edge);
        }
        Table::Offsets => {
            if let Some(number) = setup.control.make().settable_named(id) {
                setup.control.settable = number;
                setup.control.activate(number);
            }
        }
        _ => {}
    }
}

/// A row more: a tool of this type, a zero offset, a solid of this shape; gives the row.
pub fn add(setup: &mut Setup, table: Table, kind: &str) -> Option<String> {
    match table {
        Table::Tools => {
            let data = setup.new_edge(kind.parse().unwrap_or(KINDS[0]));
            let (tool, edge) = free(&setup.control);
            *setup.control.edge_made(tool, edge) = data;
            Some(format!("{tool}/{edge}"))
        }
        Table::Offsets => {
            let (make, shown) = (setup.control.make(), offsets(&setup.control));
            let named = |number: &usize| {
                let name = make.settable_name(*number);
                make.settable_named(&name) == Some(*number) && !shown.contains(&name)
            };
            let free = (1..100).find(named)?;
            setup.control.frames.insert(free, Frame::default());
            Some(make.settable_name(free))
        }
        Table::ToolProbes => {
            setup.tool_probes.push(ToolProbe::ideal(part::new(part::CAPS, kind)?));
            Some((setup.tool_probes.len() - 1).to_string())
        }
        Table::Part => {
            setup.workpiece.solids.push(part::new(part::SHAPES, kind)?);
            Some((setup.workpiece.solids.len() - 1).to_string())
        }
        Table::Machine | Table::Probe => None,
    }
}

/// The next free T number with D1; of an NCT control the next free register.
fn free(control: &Control) -> (i64, i64) {
    match control.make().registers {
        true => (0, (1..).find(|edge| control.edge_of(0, *edge).is_none()).unwrap_or(1)),
        false => (control.free_tool(), 1),
    }
}

/// A row like another one: the next edge of the tool, a zero offset with the same values, the same solid once more.
pub fn copy(setup: &mut Setup, table: Table, id: &str) -> Option<String> {
    match table {
        Table::Tools => {
            let (tool, edge) = place(id)?;
            let data = setup.control.edge_of(tool, edge)?.clone();
            let next = (edge..).find(|next| setup.control.edge_of(tool, *next).is_none())?;
            *setup.control.edge_made(tool, next) = data;
            Some(format!("{tool}/{next}"))
        }
        Table::Offsets => {
            let values = frame(&setup.control, id)?;
            let new = add(setup, table, "")?;
            put_frame(&mut setup.control, &new, values);
            Some(new)
        }
        Table::ToolProbes => copy_at(&mut setup.tool_probes, id),
        Table::Part => copy_at(&mut setup.workpiece.solids, id),
        Table::Machine | Table::Probe => None,
    }
}

/// Takes a row away; what was in use is not any more.
pub fn drop_row(setup: &mut Setup, table: Table, id: &str) {
    match table {
        Table::Tools => {
            let Some(at) = place(id) else { return };
            let used = setup.control.active_place() == at;
            remove_edge(setup, at);
            setup.real_tools.remove(&at);
            if used {
                setup.control.edge = 0;
            }
            if !setup.control.make().registers && !setup.control.tools.contains_key(&setup.control.tool) {
                (setup.control.tool, setup.control.edge) = (0, 0);
            }
        }
        Table::Offsets => {
            if let Some(number) = setup.control.make().settable_named(id) {
                setup.control.frames.remove(&number);
                setup.control.activate(setup.control.settable);
            }
        }
        Table::ToolProbes => drop_at(&mut setup.tool_probes, id),
        Table::Part => drop_at(&mut setup.workpiece.solids, id),
        Table::Machine | Table::Probe => {}
    }
}

/// Moves a solid of the part by so many places; gives where it is now.
pub fn shift(setup: &mut Setup, id: &str, by: i32) -> Option<String> {
    let solids = &mut setup.workpiece.solids;
    let at: usize = id.parse().ok()?;
    let to = at.checked_add_signed(by as isize).filter(|to| *to < solids.len() && at < solids.len())?;
    solids.swap(at, to);
    Some(to.to_string())
}
