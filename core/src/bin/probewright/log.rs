//! Files that a run leaves on the control, written into a folder.

use crate::file;
use crate::file::Problem;
use probewright_core::machine::Files;
use probewright_core::message::Message;
use probewright_core::words::Words;
use std::fs::OpenOptions;
use std::io::{BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Writes each file into the folder, which is made where it is not there, and says so; without a folder it says which
/// there are. A file that is there already stays as it is: that is said, and false comes back.
pub fn write(files: &Files, folder: Option<&Path>, words: &Words, out: &mut dyn Write) -> Result<bool, Problem> {
    let mut all = true;
    if let Some(folder) = folder.filter(|_| files.iter().next().is_some()) {
        file::make_folder(folder)?;
    }
    for (name, lines) in files.iter() {
        let told = |key| Message::new(key).text("name", name).number("lines", lines.len() as f64);
        let Some(folder) = folder else {
            writeln!(out, "{}", words.text(&told("terminal-log-left")))?;
            continue;
        };
        let path = within(folder, name);
        let said = |key| words.text(&told(key).text("path", path.display().to_string()));
        match create(&path, lines) {
            Ok(()) => writeln!(out, "{}", said("terminal-log-written"))?,
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {
                all = false;
                file::complain(&said("terminal-log-exists"));
            }
            Err(error) => return Err(file::unwritable(&path, &error)),
        }
    }
    Ok(all)
}

/// The place of a file in the folder. Names of the control are letters, digits, underscores and a point; whatever else
/// came through would not leave the folder.
fn within(folder: &Path, name: &str) -> PathBuf {
    let safe = |c: char| if c.is_ascii_alphanumeric() || c == '_' || c == '.' { c } else { '_' };
    let name: String = name.chars().map(safe).collect();
    folder.join(name.trim_start_matches('.'))
}

/// Makes a file that is not there yet; a link in its place is there too.
fn create(path: &Path, lines: &[String]) -> std::io::Result<()> {
    let file = OpenOptions::new().write(true).create_new(true).open(path)?;
    let mut file = BufWriter::new(file);
    for line in lines {
        writeln!(file, "{line}")?;
    }
    file.flush()
}
