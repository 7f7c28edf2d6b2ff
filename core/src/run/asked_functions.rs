//! Functions that ask the control: for variables, files, axes, tools. Those that only the machine can answer are data
//! of it: what is assumed for them is told.

use super::{Datum, Interpreter, files, locals, names, of_machine, other_axes, sprint, stem};
use crate::control::machine_data;
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
    if name.is_empty() || name.parse::<f64>().is_ok() {
        return false;
    }
    let name = match name.strip_prefix("R[").and_then(|index| index.strip_suffix(']')) {
        Some(number) => format!("R{number}"),
        None => name,
    };
    let name = numbered(name);
    let declared = locals::declared(run, stem(&name)) && !name.contains('[');
    declared || machine_data::of_machine(&name) || names::read(run, &name, Span::default()).is_ok()
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
