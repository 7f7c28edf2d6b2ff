//! Variables of a program: user data, tool and frame data, R parameters, local ones, and what the control tells.

use super::{
    Datum, Home, Interpreter, Keeper, Type, action::machine_function, defined, evaluate, expression::element, indices,
    locals, macro_variables, of_machine, own_parameters, setting, stem, system, tool_memory, unread,
};
use crate::catalogue::CYCLES;
use crate::control::{Control, Frame, Value, arrays, gud, gud::Kind, machine_data, rotary::is_angle};
use crate::diagnostic::Span;
use crate::problem::Problem;
use crate::syntax::tree::{Expr, ExprId, WordKind};
use std::collections::BTreeMap;

/// Words that stand for themselves: axes, and the parts of a frame.
const WORDS: [&str; 11] = ["X", "Y", "Z", "A", "B", "C", "TR", "FI", "RT", "SC", "MI"];

/// Outputs of the control to the machine.
const OUTPUTS: [&str; 6] = ["$A_OUT", "$A_OUTA", "$A_DBB", "$A_DBW", "$A_DBD", "$A_DBR"];

/// Functions of frames that without arguments are a frame that changes nothing.
const NO_FRAME: [&str; 5] = ["CTRANS", "CROT", "CFINE", "CSCALE", "CMIRROR"];

/// Name with its index, as data are kept: `_WP[0,1]`, `R10`, `#500`, `$P_UIFR[1,X,TR]`.
pub fn key(run: &Interpreter, place: Span, index: &[ExprId]) -> Result<String, Problem> {
    let name = run.program.name(place);
    if index.is_empty() {
        return Ok(name);
    }
    let mut parts = Vec::new();
    for id in index {
        if let Some(axis) = axis_of_machine(run, &name, *id) {
            parts.push(axis);
            continue;
        }
        match element(run, *id, place)? {
            Datum::Number(value) if value.is_finite() => parts.push(format!("{}", value.trunc() as i64)),
            Datum::Word(word) => parts.push(word),
            _ => return Err(Problem::new("run-index", place, name)),
        }
    }
    let joined = parts.join(",");
    Ok(if name == "R" || name == "#" { format!("{name}{joined}") } else { format!("{name}[{joined}]") })
}

/// The axis in `$AA_IM[V]`, which only this machine has; none: the index is something that is known here.
fn axis_of_machine(run: &Interpreter, name: &str, index: ExprId) -> Option<String> {
    let Expr::Name { name: axis, index } = run.program.expr(index)? else { return None };
    let axis = run.program.name(*axis);
    let other = index.is_empty() && !locals::declared(run, &axis) && constant(&axis).is_none();
    let named = known(&axis, Span::default()).is_err() && !axis.starts_with('$');
    let of_axes = machine_data::of_axes(name) || name == "$P_EP";
    (other && named && !run.limits.strict && of_axes).then_some(axis)
}

pub fn read(run: &Interpreter, key: &str, place: Span) -> Result<Datum, Problem> {
    unread::known(run, key, place)?;
    if macro_variables::is(key) {
        return macro_variables::read(run, key, place);
    }
    let home = locals::home(run, key);
    if let Some(value) = locals::read(run, &home, place) {
        return value;
    }
    let key = home.key.as_str();
    if let Some(value) = constant(key) {
        return Ok(value);
    }
    if let Some(value) = setting::read(run, key, place) {
        return value;
    }
    if key.starts_with('$') {
        return system::read(run, key, place);
    }
    if let Some(value) = defined::read(run, key, place) {
        return value;
    }
    if let Some(value) = run.sim.control.data.get(key) {
        return Ok(Datum::from(value));
    }
    match known(key, place) {
        Err(problem) => parameter(run, key, place).unwrap_or(Err(problem)),
        Ok(()) if holds_text(key) => Ok(Datum::Text(String::new())),
        Ok(()) => Ok(Datum::Number(delivered(run, key))),
    }
}

/// A parameter of the program itself that is run as main program: its default, as nothing calls it with a value.
fn parameter(run: &Interpreter, key: &str, place: Span) -> Option<Result<Datum, Problem>> {
    let main = run.main().filter(|_| run.levels.len() == 1)?;
    let mut declared = run.program.signature(main).iter().filter_map(|word| match &word.kind {
        WordKind::Declare { name, value, .. } => Some((*name, *value)),
        _ => None,
    });
    let (program, _) = declared.next()?;
    let (_, default) = declared.find(|(name, _)| run.program.is(*name, stem(key)))?;
    Some(match default {
        Some(default) => evaluate(run, default),
        None => Err(Problem::new("run-parameter", place, key).text("program", run.program.name(program))),
    })
}

/// Value that a parameter has when nobody wrote it: the default of the catalogue (B:1769-1785).
fn delivered(run: &Interpreter, key: &str) -> f64 {
    let cycles = CYCLES.iter().filter(|cycle| cycle.dialect == run.program.dialect);
    let mut params = cycles.flat_map(|cycle| cycle.params).filter(|param| param.name == key);
    params.find_map(|param| param.fallback(&run.sim.control)).unwrap_or(0.0)
}

/// Writes a variable; what changed is recorded.
pub fn write(run: &mut Interpreter, key: &str, value: &Datum, place: Span) -> Result<(), Problem> {
    match value {
        Datum::List(items) => {
            let elements = elements(run, key, place)?;
            run.work += (elements.len() / 10) as u64; // all of them were named
            if items.len() > elements.len() {
                return Err(Problem::new("run-index", place, key));
            }
            let mut written = elements.iter().zip(items).filter_map(|(element, item)| Some((element, item.as_ref()?)));
            written.try_for_each(|(element, item)| write(run, element, item, place))
        }
        Datum::Repeat(value, count) => {
            let home = locals::home(run, key);
            let filled = match (home.keeper, arrays::repeated(&run.sim.control, &home.key)) {
                (Keeper::Control, Some(elements)) => elements,
                _ => elements(run, key, place)?,
            };
            if count.is_some_and(|count| count > filled.len()) {
                return Err(Problem::new("run-index", place, key));
            }
            filled.iter().take(count.unwrap_or(usize::MAX)).try_for_each(|element| write(run, element, value, place))
        }
        Datum::Frame(frame) => match locals::home(run, key) {
            Home { keeper: Keeper::Control, key } if defined::find(run, &key).is_none() => {
                write_frame(run, &key, frame, place)
            }
            _ => write_one(run, key, value, place),
        },
        _ => write_one(run, key, value, place),
    }
}

/// Longest text of a variable, characters; a text that joins itself would grow without end.
const TEXT: usize = 400;

fn write_one(run: &mut Interpreter, key: &str, value: &Datum, place: Span) -> Result<(), Problem> {
    run.work += 1;
    run.unread.remove(key);
    if macro_variables::is(key) {
        return macro_variables::write(run, key, value, place);
    }
    let home = locals::home(run, key);
    if locals::write(run, &home, value, place)? {
        return Ok(());
    }
    let key = home.key.as_str();
    if defined::write(run, key, value, place)? {
        return Ok(());
    }
    if !key.starts_with('$') && known(key, place).is_err() && own_parameters::make(run, stem(key))? {
        return write_one(run, key, value, place);
    }
    let held = match held_as(key).filter(|_| value.number().is_some()) {
        Some(kind) => Some(kind.converted(value).ok_or_else(|| Problem::new("run-range", place, key))?),
        None => None,
    };
    let value = held.as_ref().unwrap_or(value);
    let Some(stored) = value.value() else { return Err(Problem::new("run-not-a-number", place, key)) };
    if matches!(value, Datum::Text(text) if text.chars().count() > TEXT) {
        return Err(Problem::new("run-text-long", place, key).number("limit", TEXT as f64));
    }
    if let Some(written) = setting::write(run, key, value, place) {
        return written;
    }
    if key.starts_with('$') && !system::MASKS.contains(&key) && !system::FREE.contains(&stem(key)) {
        return write_variable(run, key, value, place);
    }
    let before = read(run, key, place)?.number().unwrap_or(0.0);
    if holds_text(key) != matches!(stored, Value::Text(_)) {
        return Err(Problem::new("run-type", place, key));
    }
    run.sim.control.data.insert(key.to_owned(), stored);
    if let Some(after) = value.number() {
        run.note_set(key, before, after);
    }
    Ok(())
}

/// Tool and frame data, and setting data; recorded in mm like those that a cycle writes.
fn write_variable(run: &mut Interpreter, key: &str, value: &Datum, place: Span) -> Result<(), Problem> {
    if OUTPUTS.contains(&stem(key)) {
        machine_function(run, place, key);
    }
    if tool_memory::write(run, key, value) {
        return Ok(());
    }
    let kept = key.starts_with("$TC_") || system::simulated(run, key).is_some();
    if !kept && of_machine::write(run, key, value) {
        return Ok(());
    }
    let number = value.number().ok_or_else(|| Problem::new("run-not-a-number", place, key))?;
    if let Some(setting) = machine_data::setting(key) {
        let before = run.sim.control.number(setting);
        run.sim.with_length(|control| control.set(setting, number));
        run.note_set(setting, before, number);
        return Ok(());
    }
    if number == 0.0 && key.ends_with(",SC]") {
        return Err(Problem::new("run-range", place, key));
    }
    let after = number * variable_factor(run, key);
    let before = run.sim.control.variable(key).unwrap_or(0.0);
    if !run.sim.with_length(|control| control.set_variable(key, after)) {
        read(run, key, place)?;
        return Err(Problem::new("run-read-only", place, key));
    }
    run.note_set(key, before, after);
    Ok(())
}

/// System variables of type INT that a program writes.
const WHOLE: [&str; 2] = ["$AC_MARKER", "$AN_MARKER"];

/// As what a datum that is no REAL holds numbers: INT rounds, BOOL has 0 and 1.
fn held_as(key: &str) -> Option<Type> {
    match gud::find(stem(key)).map(|gud| gud.kind) {
        Some(Kind::Integer) => Some(Type::Int),
        Some(Kind::Bool) => Some(Type::Bool),
        _ => WHOLE.contains(&stem(key)).then_some(Type::Int),
    }
}

fn holds_text(key: &str) -> bool {
    gud::find(stem(key)).is_some_and(gud::Gud::text)
}

/// Whether a name without `$` exists, with such an index.
fn known(key: &str, place: Span) -> Result<(), Problem> {
    let unknown = || Problem::new("run-unknown-variable", place, key);
    let number = |digits: &str| digits.parse::<u32>().ok();
    if let Some(digits) = key.strip_prefix('R').and_then(number) {
        return (digits < 1000).then_some(()).ok_or_else(unknown);
    }
    let gud = gud::find(stem(key)).ok_or_else(unknown)?;
    let index = indices(key);
    let inside = index.iter().zip(gud.sizes).all(|(i, size)| i.parse::<usize>().is_ok_and(|i| i < *size));
    let fits = index.len() == gud.sizes.len() && inside;
    fits.then_some(()).ok_or_else(|| Problem::new("run-index", place, key))
}

fn constant(key: &str) -> Option<Datum> {
    match key {
        "TRUE" => Some(Datum::Number(1.0)),
        "FALSE" => Some(Datum::Number(0.0)),
        "$P_AXN1" => Some(Datum::Word("X".into())),
        "$P_AXN2" => Some(Datum::Word("Y".into())),
        "$P_AXN3" => Some(Datum::Word("Z".into())),
        "$PI" => Some(Datum::Number(std::f64::consts::PI)),
        _ if NO_FRAME.contains(&key) => Some(Datum::Frame(Box::default())),
        _ => WORDS.contains(&key).then(|| Datum::Word(key.to_owned())),
    }
}

fn write_frame(run: &mut Interpreter, key: &str, frame: &Frame, place: Span) -> Result<(), Problem> {
    let frames = |control: &Control| control.variables().filter(|(name, _)| name.starts_with("$P_")).collect();
    let before: BTreeMap<String, f64> = frames(&run.sim.control);
    run.work += (before.len() / 10) as u64;
    if !run.sim.control.set_frame(key, *frame) {
        return Err(Problem::new("run-read-only", place, key));
    }
    for (name, after) in frames(&run.sim.control) {
        let old = before.get(&name).copied().unwrap_or(0.0);
        if old != after {
            run.note_set(&name, old, after);
        }
    }
    Ok(())
}

/// mm in one unit of a tool or frame variable; types, cutting edge positions, angles and factors have none.
pub fn variable_factor(run: &Interpreter, key: &str) -> f64 {
    let number = ["$TC_DP1", "$TC_DP2"].contains(&stem(key));
    let plain = number || is_angle(key) || key.ends_with(",SC]") || key.ends_with(",MI]");
    if plain { 1.0 } else { run.sim.control.data_factor() }
}

/// All elements from this one to the end of its array, of the program or of the control.
fn elements(run: &Interpreter, first: &str, place: Span) -> Result<Vec<String>, Problem> {
    let home = locals::home(run, first);
    let own = locals::sizes(run, &home).filter(|sizes| !sizes.is_empty());
    let elements = match home.keeper {
        Keeper::Control if own.is_none() => {
            arrays::sizes(&home.key).map(|sizes| arrays::elements_from(&home.key, sizes))
        }
        _ => own.map(|sizes| arrays::elements_from(first, &sizes)),
    };
    elements.ok_or_else(|| Problem::new("run-index", place, first))
}
