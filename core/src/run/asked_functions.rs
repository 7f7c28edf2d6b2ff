//! Functions that ask the control: for variables, files, axes, tools. Those that only the machine can answer are data
//! of it: what is assumed for them is told. What one computes that is not simulated is not assumed: see `uncomputed`.

use super::{Datum, Interpreter, files, locals, names, of_machine, other_axes, sprint, stem, uncomputed};
use crate::control::{ROTARY, arrays, machine_data};
use crate::diagnostic::Span;
use crate::name::numbered;
use crate::syntax::language::is_function;

/// Functions whose value only the machine has: search of tools and places, of tables and data.
const OF_MACHINE: [&str; 21] = [
    "CHKDNO", "CTABEXISTS", "CTABFNO", "CTABISLOCK", "CTABMEMTYP", "CTABNO", "CTABPERIOD", "GETACTT", "GETACTTD",
    "GETDNO", "GETPROT", "GETVARAP", "GETVARDFT", "GETVARDIM", "GETVARLIM", "GETVARPHU", "GETVARTYP", "HASPROT",
    "NAMETOINT", "SETDNO", "STRINGIS",
];

/// Others of this place.
const OTHERS: [&str; 4] = ["ISFILE", "MODAXVAL", "SPI", "TOOLENV"];

/// Whether there is a function of this name, whatever its values.
pub fn is_known(name: &str) -> bool {
    is_function(name) || OTHERS.contains(&name) || OF_MACHINE.contains(&name) || uncomputed::find(name).is_some()
}

/// Value of such a function; none: another one, or no values for it.
pub fn call(run: &Interpreter, name: &str, values: &[Datum], place: Span) -> Option<Datum> {
    Some(match (name, values) {
        ("ISVAR", [Datum::Text(text)]) => Datum::from(is_variable(run, text)),
        ("ISFILE", [Datum::Text(path)]) => Datum::from(files::is_there(run, path)),
        ("ISAXIS", [number]) => Datum::from((1.0..=3.0).contains(&number.number()?)),
        ("SPI", [number]) => Datum::Word(format!("S{}", number.number()?)),
        ("AXNAME", [Datum::Text(text)]) => {
            let name = text.to_ascii_uppercase();
            other_axes::is_name(&name).then_some(Datum::Word(name))?
        }
        ("SPRINT", [Datum::Text(pattern), rest @ ..]) => Datum::Text(sprint::filled(pattern, rest)?),
        ("MODAXVAL", [Datum::Word(axis), position]) if ROTARY.contains(&axis.as_str()) => {
            Datum::Number(in_modulo_range(run, axis, position.number()?))
        }
        _ if OF_MACHINE.contains(&name) => of_machine::assume(run, format!("{name}()"), place)?,
        _ => return None,
    })
}

/// A position of a rotary axis within its modulo range: MD 30330 and from MD 30340 on, 360° from 0 as delivered.
fn in_modulo_range(run: &Interpreter, axis: &str, position: f64) -> f64 {
    let data = &run.sim.control.data;
    let of_axis = |name: &str| data.get(&format!("{name}[{axis}]")).and_then(|value| Datum::from(value).number());
    let range = of_axis("$MA_MODULO_RANGE").filter(|range| *range > 0.0).unwrap_or(360.0);
    let start = of_axis("$MA_MODULO_RANGE_START").unwrap_or(0.0);
    start + (position - start).rem_euclid(range)
}

/// Whether a program of this place can read the variable that a text names: `R1`, `_OVR[0]`, `$MC_…`.
fn is_variable(run: &Interpreter, text: &str) -> bool {
    let name: String = text.chars().filter(|one| !one.is_whitespace()).collect::<String>().to_ascii_uppercase();
    let closed = name.contains('[') == name.ends_with(']');
    if name.is_empty() || !closed || name.parse::<f64>().is_ok() {
        return false;
    }
    if let Some(sizes) = sizes(run, stem(&name))
        && let Some(fits) = is_open(&name, &sizes)
    {
        return fits;
    }
    let name = match name.strip_prefix("R[").and_then(|index| index.strip_suffix(']')) {
        Some(number) => format!("R{number}"),
        None => name,
    };
    let name = numbered(name);
    let declared = locals::declared(run, stem(&name)) && !name.contains('[');
    declared || machine_data::of_machine(&name) || names::read(run, &name, Span::default()).is_ok()
}

/// Sizes of an array of the program or of the control.
fn sizes(run: &Interpreter, name: &str) -> Option<Vec<usize>> {
    let home = locals::home(run, name);
    let own = locals::sizes(run, &home).or_else(|| arrays::sizes(&home.key).map(<[usize]>::to_vec));
    own.filter(|sizes| !sizes.is_empty())
}

/// Whether the index of an array that is left out, `A`, or in part, `A[,2]`, fits its sizes; none: nothing is left out.
fn is_open(name: &str, sizes: &[usize]) -> Option<bool> {
    let Some((_, inside)) = name.split_once('[') else { return Some(true) };
    let index: Vec<&str> = inside.trim_end_matches(']').split(',').collect();
    let inside = |(index, size): (&&str, &usize)| index.is_empty() || index.parse::<usize>().is_ok_and(|at| at < *size);
    let fits = || index.len() == sizes.len() && index.iter().zip(sizes).all(inside);
    index.contains(&"").then(fits)
}

#[cfg(test)]
mod tests {
    use super::OF_MACHINE;

    // oracle: self (a list that is read by people)
    #[test]
    fn functions_are_sorted() {
        assert!(OF_MACHINE.is_sorted());
    }
}
