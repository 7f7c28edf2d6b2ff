//! Data of tools and magazines beside the cutting edges (`$TC_TP…`, `$TC_MOP…`, `$TC_MPP…`): what the setup gives or
//! the program wrote, else assumed as for the machine; and calls of the tool management that hand back what is known.

use super::{Call, Datum, Interpreter, evaluate, files, indices, of_machine, stem, tool};
use crate::control::{Tool, machine_data};
use crate::diagnostic::Span;
use crate::problem::Problem;
use crate::syntax::tree::{Expr, ExprId};
use std::collections::BTreeMap;
use std::rc::Rc;

/// Beginnings of the names of data that belong to a tool; those of its edges, too.
const OF_TOOL: [&str; 4] = ["$TC_TP", "$TC_TPC", "$TC_TPP", "$TC_TPG"];
const OF_EDGE: [&str; 5] = ["$TC_DP", "$TC_SCP", "$TC_ECP", "$TC_MOP", "$TC_MOPC"];
/// Name of a tool.
const NAME: &str = "$TC_TP2";

/// Whether a name is one of these with a number behind it: `$TC_TP8`, not `$TC_TPX`.
fn numbered(stem: &str, begins: &[&str]) -> bool {
    begins.iter().any(|begin| {
        let rest = stem.strip_prefix(begin);
        rest.is_some_and(|rest| !rest.is_empty() && rest.bytes().all(|one| one.is_ascii_digit()))
    })
}

fn numbers(key: &str) -> Vec<i64> {
    indices(key).iter().filter_map(|one| one.parse().ok()).collect()
}

/// Data of a tool, or of an edge, that is not there: `$TC_DP6[5,1]`, `$TC_TP2[5]`. A machine that was made for the
/// program has every tool.
pub fn absent(run: &Interpreter, key: &str, place: Span) -> Option<Problem> {
    let of_edge = numbered(stem(key), &OF_EDGE);
    if run.assumed.is_some() || !of_edge && !numbered(stem(key), &OF_TOOL) {
        return None;
    }
    let index = numbers(key);
    let (number, edge) = (*index.first()?, index.get(1).filter(|_| of_edge));
    let Some(there) = run.sim.control.tools.get(&number) else {
        return Some(Problem::new("run-no-tool", place, number.to_string()));
    };
    let edge = edge.filter(|edge| !there.edges.contains_key(edge))?;
    Some(tool::no_edge(number, *edge, place))
}

/// Writes such a datum; false: it is another one, or the control itself keeps it.
pub fn write(run: &mut Interpreter, key: &str, value: &Datum) -> bool {
    let name = stem(key);
    if !name.starts_with("$TC_") || machine_data::of_edge(name) {
        return false;
    }
    if numbered(name, &OF_TOOL)
        && let Some(number) = numbers(key).first()
    {
        let there = run.sim.control.tools.entry(*number).or_default();
        if let (NAME, Datum::Text(text)) = (name, value) {
            there.name.clone_from(text);
            return true;
        }
    }
    of_machine::write(run, key, value)
}

/// `NEWT("NAME",1)` as the right side of an assignment: a new tool; where tools are made for the program, `GETT` makes
/// one too. None: it is something else, or what is there answers.
pub fn assigned(run: &mut Interpreter, value: ExprId) -> Result<Option<Datum>, Problem> {
    let program = Rc::clone(&run.program);
    let Some(Expr::Call(name, args)) = program.expr(value) else { return Ok(None) };
    let makes = program.is(*name, "NEWT");
    let finds_or_makes = program.is(*name, "GETT") && run.assumed.is_some();
    if !(makes || finds_or_makes) {
        return Ok(None);
    }
    let Some(Datum::Text(text)) = args.first().map(|arg| evaluate(run, *arg)).transpose()? else {
        return Ok(None);
    };
    let number = if makes { new(run, &text) } else { run.tool_named(&text).unwrap_or(-1) };
    run.make_tool(number, 1);
    Ok(Some(Datum::Number(number as f64)))
}

fn new(run: &mut Interpreter, name: &str) -> i64 {
    let number = run.sim.control.free_tool();
    run.sim.control.tools.insert(number, Tool { name: name.to_owned(), edges: BTreeMap::new() });
    number
}

/// Carries out a call of the tool management; false: it is none of these.
pub fn call(run: &mut Interpreter, call: &Call) -> Result<bool, Problem> {
    let control = &run.sim.control;
    match call.name.as_str() {
        "GETSELT" => {
            let number = run.modal.prepared.unwrap_or(control.tool);
            files::hand_back(run, call, 0, Datum::Number(number as f64))?;
        }
        "GETEXET" => {
            let number = control.tool;
            files::hand_back(run, call, 0, Datum::Number(number as f64))?;
        }
        "DELT" => {
            let Some(Datum::Text(name)) = call.arg(0) else { return Ok(true) };
            let gone = control.tool_named(name).filter(|number| *number != control.tool);
            gone.and_then(|number| run.sim.control.tools.remove(&number));
        }
        "TCA" => {
            let name = call.arg(0).map(Datum::shown).unwrap_or_default();
            let missing = || Problem::new("run-no-tool", call.span, &*name);
            let number = run.tool_named(&name).ok_or_else(missing)?;
            run.make_tool(number, 1);
            run.modal.prepared = Some(number);
        }
        _ => return Ok(false),
    }
    Ok(true)
}
