//! Tool change and edges: `T9 D1`, `M6`; NCT `G43 H98`. The spindle nose stays; a trace step tells the change.

use super::{Address, Datum, Halt, Interpreter, Words, addresses, contour};
use crate::control::{Edge, Value};
use crate::diagnostic::Span;
use crate::machine::Step;
use crate::problem::Problem;

/// Applies T, D, M6 (NCT: T, H, D) of a block.
pub fn apply(run: &mut Interpreter, found: &Words) -> Result<(), Halt> {
    if changes(run, found) {
        contour::finish(run)?;
    }
    let before = (run.sim.control.tool, run.sim.control.edge);
    (run.rules().tool)(run, found)?;
    let after = (run.sim.control.tool, run.sim.control.edge);
    if before != after {
        run.sim.note(Step::Tool { tool: after.0, edge: after.1 });
    }
    Ok(())
}

/// Whether the block may bring another tool: by M6, in a turret by T.
fn changes(run: &Interpreter, found: &Words) -> bool {
    found.function("M", 6.0).is_some() || run.sim.control.turns() && found.of("T").next().is_some()
}

/// The last address with this letter that is for the main spindle: `T5`, `T1=5`.
fn last<'a>(found: &'a Words, letter: &'a str) -> Option<&'a Address> {
    found.of(letter).rfind(|address| address.extension.is_none_or(|spindle| spindle <= 1))
}

/// T, D and M6 of SINUMERIK.
pub fn sinumerik(run: &mut Interpreter, found: &Words) -> Result<(), Problem> {
    if let Some(address) = last(found, "T") {
        let tool = number(run, address)?;
        run.make_tool(tool, 1);
        run.modal.prepared = Some(tool);
        run.modal.waiting_edge = None;
    }
    if let Some(address) = last(found, "D") {
        let edge = address.value.number().ok_or_else(|| Problem::new("run-not-a-number", address.span, "D"))? as i64;
        // in a block of its own D acts on the tool in use, whatever is preselected (function manual W1 11/2006, 2.1.1)
        let of_next = last(found, "T").is_some() || found.function("M", 6.0).is_some();
        match run.modal.prepared {
            Some(tool) if of_next && tool != run.sim.control.tool => run.modal.waiting_edge = Some(edge),
            _ => select(run, run.sim.control.tool, edge, address)?,
        }
    }
    if let Some(address) = last(found, "DL") {
        location(run, address)?;
    }
    if let Some(address) = found.function("M", 6.0).or_else(|| turret(run, found))
        && let Some(tool) = run.modal.prepared.take()
    {
        let edge = if tool == run.sim.control.tool { run.sim.control.edge } else { behind_change(run) };
        let edge = run.modal.waiting_edge.take().unwrap_or(edge);
        select(run, tool, edge, address)?;
    }
    Ok(())
}

/// The edge after a change where no D was programmed with it: the number in MD 20270 ($MC_CUTTING_EDGE_DEFAULT), with
/// -1 that of the tool before (function manual W1 11/2006, 2.1.1); D1 where the machine does not say.
fn behind_change(run: &Interpreter) -> i64 {
    match run.sim.control.data.get("MD20270") {
        Some(Value::Number(number)) if *number == -1.0 => run.sim.control.edge,
        Some(Value::Number(number)) => *number as i64,
        _ => 1,
    }
}

/// The T with which a turret turns at once, without M6: that of a turning tool, and any of a turning machine.
fn turret<'a>(run: &Interpreter, found: &'a Words) -> Option<&'a Address> {
    let turning = run.sim.control.tools.get(&run.modal.prepared?)?.edges.values().any(Edge::is_turning);
    last(found, "T").filter(|_| turning || run.sim.control.turns())
}

/// `DL=2`: offsets of a location are used from now on, until the next T or D.
fn location(run: &mut Interpreter, address: &Address) -> Result<(), Problem> {
    let number = addresses::number(address)? as i64;
    if !(0..=6).contains(&number) {
        return Err(Problem::new("run-range", address.span, "DL"));
    }
    run.sim.with_length(|control| control.location = number);
    Ok(())
}

fn number(run: &mut Interpreter, address: &Address) -> Result<i64, Problem> {
    match &address.value {
        Datum::Number(number) => Ok(*number as i64),
        other => {
            let name = other.shown();
            run.tool_named(&name).ok_or_else(|| Problem::new("run-no-tool", address.span, name))
        }
    }
}

/// A tool has no such cutting edge.
pub fn no_edge(tool: i64, edge: i64, place: Span) -> Problem {
    Problem::new("run-no-edge", place, tool.to_string()).number("edge", edge as f64)
}

fn select(run: &mut Interpreter, tool: i64, edge: i64, address: &Address) -> Result<(), Problem> {
    run.make_tool(tool, edge);
    if tool != 0 && !run.sim.control.tools.contains_key(&tool) {
        return Err(Problem::new("run-no-tool", address.span, tool.to_string()));
    }
    if tool != 0 && edge != 0 && run.sim.control.edge_of(tool, edge).is_none() {
        return Err(no_edge(tool, edge, address.span));
    }
    let edge = if tool == 0 { 0 } else { edge };
    run.sim.with_length(|control| (control.tool, control.edge, control.location) = (tool, edge, 0));
    Ok(())
}

/// T, H and D of NCT.
pub fn nct(run: &mut Interpreter, found: &Words) -> Result<(), Problem> {
    if let Some(address) = last(found, "T") {
        run.sim.control.tool = number(run, address)?;
    }
    if let Some(address) = last(found, "H") {
        let edge = addresses::number(address)? as i64;
        run.sim.with_length(|control| control.edge = edge);
    }
    if let Some(address) = last(found, "D") {
        run.modal.radius = addresses::number(address)? as i64;
    }
    Ok(())
}
