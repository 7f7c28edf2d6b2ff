//! Files that a program writes and reads (Job planning, file handling): those of the run alone, with the logs of the
//! measuring cycles; nothing is on a disk. A path is its last part, as for the call of a program.

use super::{Call, Datum, Interpreter, names, noted};
use crate::machine::Machine;
use crate::problem::Problem;

/// Most lines that a run writes.
const LINES: u64 = 20_000;
/// Longest line that is written, characters.
const LONGEST: usize = 200;

/// What the control hands back in the first argument: the file is not there, the memory is full, the program is
/// running, the line is not there, the array is too small.
const NOT_THERE: f64 = 3.0;
const FULL: f64 = 10.0;
const IN_USE: f64 = 11.0;
const NO_LINE: f64 = 21.0;
const SMALL: f64 = 22.0;

/// Types of files, as the control has them behind the name.
const TYPES: [&str; 6] = ["MPF", "SPF", "DEF", "INI", "TXT", "LOG"];

/// `/_N_MPF_DIR/_N_LOG_MPF`, `LOG`, `EXT:LOG.TXT`: `LOG.MPF`, `LOG.MPF`, `LOG.TXT`. What is no letter, digit or point
/// is an underscore.
fn name(path: &str) -> String {
    let plain = |one: char| if one.is_ascii_alphanumeric() || one == '.' { one.to_ascii_uppercase() } else { '_' };
    let last = path.trim().rsplit(['/', '\\', ':']).next().unwrap_or(path).trim_start_matches('.');
    let last: String = last.chars().map(plain).collect();
    let last = last.strip_prefix("_N_").unwrap_or(&last);
    match last.rsplit_once('_') {
        _ if last.contains('.') => last.to_owned(),
        Some((name, kind)) if TYPES.contains(&kind) => format!("{name}.{kind}"),
        _ => format!("{last}.MPF"),
    }
}

/// Whether a file was written.
fn exists(run: &Interpreter, path: &str) -> bool {
    run.sim.files.lines(&name(path)).is_some()
}

/// `ISFILE("LOG")`: whether a file is there: one that was written, or a program of the text.
pub fn is_there(run: &Interpreter, path: &str) -> bool {
    exists(run, path) || run.programs.named(&path.to_ascii_uppercase()).is_some()
}

/// Carries out a call that writes, reads or asks for a file; false: it is none.
pub fn call(run: &mut Interpreter, call: &Call) -> Result<bool, Problem> {
    let status = match call.name.as_str() {
        "WRITE" | "EXTWRITE" => write(run, call)?,
        "DELETE" => delete(run, call)?,
        "READ" => read(run, call)?,
        "FILESIZE" => size(run, call)?,
        "EXTOPEN" | "EXTCLOSE" => 0.0,
        "FILEDATE" | "FILETIME" | "FILESTAT" | "FILEINFO" => {
            noted::without(run, "run-passed", call.span, &call.name);
            if exists(run, &text(call, 1)?) { 0.0 } else { NOT_THERE }
        }
        _ => return Ok(false),
    };
    hand_back(run, call, 0, Datum::Number(status)).map(|()| true)
}

/// Writes a variable that a call names; one that names none wants nothing back.
pub fn hand_back(run: &mut Interpreter, call: &Call, index: usize, value: Datum) -> Result<(), Problem> {
    match call.places.get(index).cloned().flatten() {
        Some(place) => names::write(run, &place, &value, call.span),
        None => Ok(()),
    }
}

fn text(call: &Call, index: usize) -> Result<String, Problem> {
    match call.arg(index) {
        Some(Datum::Text(text)) => Ok(text.clone()),
        Some(value @ (Datum::Char(_) | Datum::Number(_))) => Ok(value.shown()),
        _ => Err(Problem::new("run-function", call.span, &*call.name)),
    }
}

/// `WRITE(ERROR,"FILE","line")`: a line behind the others; the program that is running is not written.
fn write(run: &mut Interpreter, call: &Call) -> Result<f64, Problem> {
    let (path, line) = (text(call, 1)?, text(call, 2)?);
    let name = name(&path);
    if run.sim.files.in_use(&name) {
        return Ok(IN_USE);
    }
    if run.sim.files.changes() >= LINES {
        return Ok(FULL);
    }
    run.sim.write_file(&name, line.chars().take(LONGEST).collect());
    Ok(0.0)
}

/// `DELETE(ERROR,"FILE")`.
fn delete(run: &mut Interpreter, call: &Call) -> Result<f64, Problem> {
    let there = run.sim.files.delete(&name(&text(call, 1)?));
    Ok(if there { 0.0 } else { NOT_THERE })
}

/// `READ(ERROR,"FILE",line,count,RESULT)`: lines into an array of texts; line 0 asks for the last ones.
fn read(run: &mut Interpreter, call: &Call) -> Result<f64, Problem> {
    let name = name(&text(call, 1)?);
    let Some(lines) = run.sim.files.lines(&name) else { return Ok(NOT_THERE) };
    let whole = |index: usize| call.number(index).filter(|number| *number >= 0.0).map(|number| number as usize);
    let wrong = || Problem::new("run-function", call.span, &*call.name);
    let (from, count) = (whole(2).ok_or_else(wrong)?, whole(3).ok_or_else(wrong)?);
    let room = match call.arg(4) {
        Some(Datum::List(items)) => Some(items.len()),
        _ => None,
    };
    if count > room.unwrap_or(1) {
        return Ok(SMALL);
    }
    let from = if from == 0 { lines.len().saturating_sub(count) } else { from - 1 };
    let Some(found) = lines.get(from..from.saturating_add(count)).map(<[String]>::to_vec) else { return Ok(NO_LINE) };
    let place = call.places.get(4).cloned().flatten().ok_or_else(wrong)?;
    for (index, line) in found.into_iter().enumerate() {
        let element = if room.is_some() { format!("{place}[{index}]") } else { place.clone() };
        names::write(run, &element, &Datum::Text(line), call.span)?;
    }
    Ok(0.0)
}

/// `FILESIZE(ERROR,"FILE",SIZE)`: bytes.
fn size(run: &mut Interpreter, call: &Call) -> Result<f64, Problem> {
    let path = text(call, 1)?;
    if !exists(run, &path) {
        return Ok(NOT_THERE);
    }
    let bytes = run.sim.files.size(&name(&path));
    hand_back(run, call, 2, Datum::Number(bytes as f64)).map(|()| 0.0)
}

#[cfg(test)]
mod tests {
    use super::name;

    // oracle: hand (the control names files `_N_NAME_TYPE`, a PC `NAME.TYPE`; without a type a file is a main program)
    #[test]
    fn a_file_has_one_name_however_it_is_written() {
        for path in ["/_N_MPF_DIR/_N_LOG_MPF", "LOG", "log_mpf", "_N_LOG_MPF", "C:\\DATA\\LOG.MPF"] {
            assert_eq!(name(path), "LOG.MPF", "{path}");
        }
        assert_eq!([name("EXT:RESULT.TXT"), name("TOOL_LIST")], ["RESULT.TXT", "TOOL_LIST.MPF"]);
    }
}
