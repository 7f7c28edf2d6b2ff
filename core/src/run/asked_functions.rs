//! Functions that ask the control: for variables, files, axes, tools. Those that only the machine can answer are data
//! of it: what is assumed for them is told.

use super::{Datum, Interpreter, files, locals, names, of_machine, other_axes, sprint, stem};
use crate::control::{arrays, machine_data};
use crate::diagnostic::Span;
use crate::name::numbered;

/// Functions whose value only the machine has: search of tools and places, tables, contours, axes of spindles.
const OF_MACHINE: [&str; 34] = [
    "ADDFRAME", "CALCDAT", "CALCPOSI", "CHKDNO", "CORRTC", "CORRTRAFO", "CTAB", "CTABEXISTS", "CTABFNO", "CTABINV",
    "CTABISLOCK", "CTABMEMTYP", "CTABNO", "CTABPERIOD", "GETACTT", "GETACTTD", "GETDNO", "GETPROT", "GETTCOR",
    "GETTENV", "GETVARAP", "GETVARDFT", "GETVARDIM", "GETVARLIM", "GETVARPHU", "GETVARTYP", "HASPROT", "INTERSEC",
    "LENTOAX", "MODAXVAL", "NAMETOINT", "SETDNO", "SETTCOR", "STRINGIS",
];

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
        ("MEAFRAME", _) => {
            of_machine::assume(run, format!("{name}()"), place)?;
            Datum::Frame(Box::default())
        }
        _ if OF_MACHINE.contains(&name) => of_machine::assume(run, format!("{name}()"), place)?,
        _ => return None,
    })
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
