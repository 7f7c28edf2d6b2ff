//! A program as the manuals print programs: a head, numbered blocks (a number may come twice), comments in a column
//! behind them, leading zeros, one assignment a block, other ends. It says the same.

use probewright_core::dialect::Dialect;

/// The text in that manner.
pub fn printed(dialect: Dialect, name: &str, source: &str) -> String {
    match dialect {
        Dialect::Sinumerik => sinumerik(name, source),
        Dialect::Nct => nct(source),
    }
}

fn sinumerik(name: &str, source: &str) -> String {
    let blocks = source.lines().flat_map(|line| match line.split_once(';') {
        Some(("", _)) => vec![line.to_owned()],
        Some((block, comment)) => vec![format!("{block} ;{comment}")],
        None => assignments(line),
    });
    let numbered = blocks.enumerate().map(|(index, block)| {
        if block.starts_with(';') {
            return block;
        }
        let number = 5 + index % 30 * 5; // after thirty blocks the numbers begin again
        let block = block.replace("=SET(", "=(").replace("_MVAR=", "_MVAR=0").replace("M30", "M2");
        format!("N{number:02} {block:<30} ;block {index}")
    });
    let head = format!("%_N_{}_MPF\n;$PATH=/_N_MPF_DIR\n;----- {name} -----\n", name.to_uppercase());
    head + &numbered.collect::<Vec<_>>().join("\n") + "\n"
}

/// A block of assignments to user data: one in the first, the others in the next. Other blocks stay as they are.
fn assignments(line: &str) -> Vec<String> {
    let words: Vec<&str> = line.split(' ').collect();
    match &words[..] {
        [first, rest @ ..]
            if !rest.is_empty() && words.iter().all(|word| word.starts_with('_') && word.contains('=')) =>
        {
            vec![(*first).to_owned(), rest.join(" ")]
        }
        _ => vec![line.to_owned()],
    }
}

fn nct(source: &str) -> String {
    let lines = source.lines().enumerate().map(|(index, line)| match line {
        "%" => line.to_owned(),
        _ if line.starts_with('%') => format!("{line}\n(PROGRAM BLOCKS)"),
        _ => format!("{line} (BLOCK {index} OF THE PROGRAM)"),
    });
    lines.collect::<Vec<_>>().join("\n") + "\n"
}

// oracle: hand
#[test]
fn a_program_is_written_in_that_manner() {
    let written = printed(Dialect::Sinumerik, "bore", "; Bore\nG0 X1\n_MVAR=1 _FA=_ID/2\nDEF REAL A[2]=SET(1)\nM30\n");
    let lines: Vec<&str> = written.lines().map(str::trim_end).collect();
    assert_eq!(lines[..4], ["%_N_BORE_MPF", ";$PATH=/_N_MPF_DIR", ";----- bore -----", "; Bore"]);
    assert_eq!(lines[5], "N15 _MVAR=01                       ;block 2");
    assert_eq!(lines[6], "N20 _FA=_ID/2                      ;block 3");
    assert_eq!(lines[7], "N25 DEF REAL A[2]=(1)              ;block 4");
    assert_eq!(lines[8], "N30 M2                             ;block 5");
    let written = printed(Dialect::Nct, "bore", "%O1 (BORE)\nG0 X1\n%\n");
    assert_eq!(written, "%O1 (BORE)\n(PROGRAM BLOCKS)\nG0 X1 (BLOCK 1 OF THE PROGRAM)\n%\n");
}
