//! Files that a run leaves in the part program memory of the control: the log of measurements, what a program writes.
//! Each is known by the name that the control shows, `LOG_1.MPF`.

use std::collections::BTreeMap;

/// Why the control refuses a file. The numbers are those that its commands for files hand back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The name, or the path before it, is not permitted.
    Path = 1,
    /// No name is given.
    NoName = 3,
    /// The file is of another type.
    Type = 4,
    /// It is a program that is being carried out.
    InUse = 11,
}

/// Types of files that the control writes.
const TYPES: [&str; 2] = ["MPF", "SPF"];

/// The files of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Files {
    all: BTreeMap<String, File>,
    /// The programs that are being carried out, the main program first: none of them can be written. None: one without
    /// a file.
    running: Vec<Option<String>>,
    /// How often something changed: what decides over the future of a run compares this instead of the lines.
    changes: u64,
}

/// A file: its lines, and how many characters they are, so that a long one is not counted again for each line.
#[derive(Clone, Debug, Default, PartialEq)]
struct File {
    lines: Vec<String>,
    size: usize,
}

impl Files {
    /// With a main program that is carried out, in the file of this name.
    pub fn beside(program: Option<&str>) -> Files {
        let mut files = Files::default();
        files.begin(program);
        files
    }

    /// A program begins, in the file of this name.
    pub fn begin(&mut self, program: Option<&str>) {
        self.running.push(program.and_then(|name| named(name).ok()));
    }

    /// The program that began last has come to its end.
    pub fn end(&mut self) {
        self.running.pop();
    }

    /// The main program is in a file that its own text does not name.
    pub fn name_main(&mut self, file: &str) {
        if let Some(main @ None) = self.running.first_mut() {
            *main = on_control(file);
        }
    }

    /// Whether a program that is being carried out has this name: its file is open, and cannot be written (A:15898).
    pub fn in_use(&self, name: &str) -> bool {
        self.running.iter().any(|running| running.as_deref() == Some(name))
    }

    /// Makes an empty file; one of this name is deleted.
    pub fn create(&mut self, name: &str) {
        self.changes += 1;
        self.all.insert(name.to_owned(), File::default());
    }

    /// Adds a line; a file that is not there is made.
    pub fn write(&mut self, name: &str, line: String) {
        self.changes += 1;
        let file = self.all.entry(name.to_owned()).or_default();
        file.size += length(&line);
        file.lines.push(line);
    }

    /// Deletes a file; false: it is not there.
    pub fn delete(&mut self, name: &str) -> bool {
        let there = self.all.remove(name).is_some();
        self.changes += u64::from(there);
        there
    }

    /// The lines of a file; none: it is not there.
    pub fn lines(&self, name: &str) -> Option<&[String]> {
        self.all.get(name).map(|file| file.lines.as_slice())
    }

    /// Characters of a file, each line with its end.
    pub fn size(&self, name: &str) -> usize {
        self.all.get(name).map_or(0, |file| file.size)
    }

    /// All of them by name.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &[String])> {
        self.all.iter().map(|(name, file)| (name.as_str(), file.lines.as_slice()))
    }

    /// How often something changed.
    pub fn changes(&self) -> u64 {
        self.changes
    }
}

/// The name on the control of a file of a computer, `part.mpf` or `part.nc`; none: it can have none there.
fn on_control(file: &str) -> Option<String> {
    let upper = file.trim().to_ascii_uppercase();
    let (stem, ending) = upper.rsplit_once('.').unwrap_or((&upper, ""));
    let kind = TYPES.into_iter().find(|kind| *kind == ending).unwrap_or("MPF");
    named(stem).ok().map(|name| name.strip_suffix(".MPF").map_or(name.clone(), |name| format!("{name}.{kind}")))
}

/// Characters of a line with its end; the control writes one byte for each.
pub fn length(line: &str) -> usize {
    line.chars().count() + 1
}

/// The name that the control shows for one as a program writes it: `LOG_1`, `LOG_1_MPF` and `_N_LOG_1_MPF` are
/// `LOG_1.MPF`. Letters, digits and underscores; two letters first, or a letter and an underscore (B:11192).
///
/// # Errors
/// It names no file.
pub fn named(text: &str) -> Result<String, Fault> {
    let upper = text.trim().to_ascii_uppercase();
    if upper.is_empty() {
        return Err(Fault::NoName);
    }
    let whole = upper.strip_prefix("_N_").unwrap_or(&upper);
    let typed = TYPES.iter().find_map(|kind| Some((whole.strip_suffix(kind)?.strip_suffix('_')?, *kind)));
    let (name, kind) = typed.unwrap_or((whole, "MPF"));
    if name.contains('.') && !name.contains(['/', '\\']) {
        return Err(Fault::Type);
    }
    let starts = match name.as_bytes() {
        [first, second, ..] => first.is_ascii_alphabetic() && (second.is_ascii_alphabetic() || *second == b'_'),
        _ => false,
    };
    let right = starts && name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    if right { Ok(format!("{name}.{kind}")) } else { Err(Fault::Path) }
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: manual B:11192 (name and extension)
    #[test]
    fn a_name_is_that_of_a_program() {
        for right in ["LOG_1", "log_1", "LOG_1_MPF", "_N_LOG_1_MPF", " LOG_1 "] {
            assert_eq!(named(right).as_deref(), Ok("LOG_1.MPF"), "{right}");
        }
        assert_eq!(named("L_1_SPF").as_deref(), Ok("L_1.SPF"));
        for wrong in ["1LOG", "L", "L1", "MY-LOG", "/_N_MPF_DIR/LOG", "..\\LOG", "../LOG", "_MPF", "LÖG"] {
            assert_eq!(named(wrong), Err(Fault::Path), "{wrong}");
        }
        assert_eq!(
            [named(""), named("LOG.TXT"), named("LOG.MPF")],
            [Err(Fault::NoName), Err(Fault::Type), Err(Fault::Type)]
        );
    }

    // oracle: hand
    #[test]
    fn lines_are_kept_in_their_order() {
        let mut files = Files::beside(Some("MEASPROGRAM_1"));
        assert!(files.in_use("MEASPROGRAM_1.MPF") && !files.in_use("LOG.MPF"));
        files.name_main("log.mpf"); // its text names it already
        files.begin(Some("_N_LOG_MPF"));
        assert!(files.in_use("MEASPROGRAM_1.MPF") && files.in_use("LOG.MPF"));
        files.end();
        assert!(files.in_use("MEASPROGRAM_1.MPF") && !files.in_use("LOG.MPF"));
        for (file, name) in [("part.nc", "PART.MPF"), ("_N_PART_MPF", "PART.MPF"), ("part.spf", "PART.SPF")] {
            let mut files = Files::beside(None);
            files.name_main(file);
            assert!(files.in_use(name), "{file}");
        }
        files.write("LOG.MPF", "Müller".into());
        files.write("LOG.MPF", String::new());
        assert_eq!((files.size("LOG.MPF"), files.changes()), (8, 2));
        files.create("LOG.MPF");
        assert_eq!(files.iter().collect::<Vec<_>>(), [("LOG.MPF", &[][..])]);
    }
}
