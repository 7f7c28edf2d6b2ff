#![allow(clippy::unwrap_used)]

use super::{Encoding, Recogniser, recognise};
use std::path::PathBuf;

fn folder() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/encodings"))
}

/// Language, encoding and bytes of every file there.
fn files() -> Vec<(String, String, Vec<u8>)> {
    let found = std::fs::read_dir(folder()).unwrap().map(|entry| {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        let mut parts = name.split('.');
        let mut part = || parts.next().unwrap().to_owned();
        (part(), part(), std::fs::read(&path).unwrap())
    });
    found.collect()
}

fn of(language: &str, encoding: &str) -> Vec<u8> {
    std::fs::read(folder().join(format!("{language}.{encoding}.mpf"))).unwrap()
}

// oracle: peer (the files were written by the codecs of Python, which their names tell)
#[test]
fn each_encoding_is_recognised() {
    let files = files();
    assert!(files.len() >= 20);
    for (language, encoding, bytes) in files {
        let found = recognise(&bytes).map(|found| found.to_string());
        assert_eq!(found, Ok(encoding), "{language}");
    }
}

// oracle: self (the whole file at once)
#[test]
fn pieces_are_told_as_the_whole() {
    for (language, encoding, bytes) in files() {
        let mut recogniser = Recogniser::default();
        bytes.iter().for_each(|byte| recogniser.take(&[*byte]));
        let found = recogniser.finish().map(|found| found.to_string());
        assert_eq!(found, Ok(encoding), "{language}");
    }
}

// oracle: hand (one byte of a file is destroyed, or the file is cut in a character: the rest is as before)
#[test]
fn one_wrong_byte_changes_nothing_else() {
    for (language, encoding) in [("zh", "utf-8"), ("zh", "gbk"), ("ja", "shift_jis")] {
        let bytes = of(language, encoding);
        let middle = bytes.iter().rposition(|byte| *byte >= 0x80).unwrap();
        let broken = [&bytes[..middle], b"\xff", &bytes[middle..]].concat();
        let first = bytes.iter().position(|byte| *byte >= 0x80).unwrap();
        let cut = &bytes[..first + 13];
        for one in [&broken, cut] {
            assert_eq!(recognise(one).map(|found| found.to_string()).as_deref(), Ok(encoding));
        }
    }
}

// oracle: hand (German words whose umlauts stand beside each other or before letters that could be the second byte of a
// pair)
#[test]
fn western_words_are_no_pairs() {
    for word in [
        "gr\u{f6}\u{df}er", "f\u{fc}r", "\u{d8}20", "90\u{b0}", "\u{b1}0.02", "45\u{b0}C", "\u{e9}t\u{e9}",
        "probe\u{92}s",
    ] {
        let bytes: Vec<u8> = word.chars().map(|c| c as u32 as u8).collect();
        assert_eq!(recognise(&bytes), Ok(Encoding::Windows1252), "{word}");
    }
}

// oracle: hand (the beginnings that the formats prescribe)
#[test]
fn what_is_no_program_is_refused() {
    let noise: Vec<u8> = (0..4096u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 13) as u8).collect();
    let stl = [&[b' '; 80][..], &12u32.to_le_bytes(), &[0, 0, 0x80, 0x3F].repeat(150)].concat();
    for (bytes, what) in [
        (&b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR"[..], "file-picture"),
        (b"\xff\xd8\xff\xe0\0\x10JFIF", "file-picture"),
        (b"PK\x03\x04\x14\0", "file-archive"),
        (b"%PDF-1.7\n", "file-pdf"),
        (b"{\\rtf1\\ansi N10 G0 X0}", "file-document"),
        (b"\x7fELF\x02\x01", "file-binary"),
        (b"MZ\x90\0\x03\0\0\0\x04\0\0\0\xff\xff\0\0", "file-binary"),
        (b"\0\0\0\0", "file-binary"),
        (&noise, "file-binary"),
        (&stl, "file-binary"),
    ] {
        assert_eq!(recognise(bytes), Err(what));
    }
}

// oracle: hand (a punched tape begins and ends with NULs; DC1 to DC4 switch its reader; a program may be named PDF;
// nothing at all is an empty program)
#[test]
fn what_a_line_leaves_in_a_program_refuses_nothing() {
    let program = b"%_N_PDF_MPF\r\nN10 G0 X0 Y0\r\nN20 M30\r\n";
    let tape = [&[0; 300][..], program, &[0; 300]].concat();
    let switched = [&b"\x11"[..], program, b"\x13\x1a"].concat();
    for bytes in [&tape[..], &switched, program, b"", b"\r\n"] {
        assert_eq!(recognise(bytes), Ok(Encoding::Utf8));
    }
}
