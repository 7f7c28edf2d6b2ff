//! Files of each sort in each encoding, and those that cannot be read.

use super::{HOLE, err, example_setup, file, out, probewright};

/// An encoding: its name, and the bytes of a text in it.
type Encoding = (&'static str, fn(&str) -> Vec<u8>);

/// Encodings of a text whose characters are Western European, written without a table.
const ENCODINGS: [Encoding; 5] = [
    ("utf8", |text| text.as_bytes().to_vec()),
    ("utf8marked", |text| [b"\xef\xbb\xbf", text.as_bytes()].concat()),
    ("utf16le", |text| {
        text.encode_utf16().fold(vec![0xff, 0xfe], |all, unit| [all, unit.to_le_bytes().into()].concat())
    }),
    ("utf16be", |text| {
        text.encode_utf16().fold(vec![0xfe, 0xff], |all, unit| [all, unit.to_be_bytes().into()].concat())
    }),
    ("latin1", |text| text.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect()),
];

/// What the program tells of a text in each encoding, without the name of its file.
fn told(name: &str, text: &str, arguments: &[&str]) -> Vec<String> {
    let tell = |(encoding, encode): &Encoding| {
        let path = file(&format!("{encoding}.{name}"), &encode(text));
        let arguments: Vec<&str> = arguments.iter().map(|one| if *one == "FILE" { &path } else { *one }).collect();
        let output = probewright(&arguments);
        format!("{:?} {}{}", output.status.code(), out(&output), err(&output)).replace(&path, "FILE")
    };
    ENCODINGS.iter().map(tell).collect()
}

// oracle: hand: the same text in another encoding is the same file
#[test]
fn every_file_says_the_same_in_every_encoding() {
    let setup = example_setup();
    let machine = std::fs::read_to_string(&setup).unwrap();
    let machine = machine.replace("BORING", "Größe 1 für später");
    let wrong = machine.replace("\"plane\"", "\"Fräsmaschine\"");
    let program = file("encoded.mpf", HOLE.as_bytes());
    let scenario = std::fs::read_to_string(format!("{}/../docs/hole.scenario.json", env!("CARGO_MANIFEST_DIR")));
    let scenario = scenario.unwrap().replace("0.03 mm too big", "Größe überprüft");
    let script = "; für die Übung\nmask set_edge\naxis = Z\ndirection = -\nmüde = 1\n";
    let exported = "; Größe\nN11420 $MN_LEN_PROTOCOL_FILE=1\nN1 $MN_GEÄNDERT=1\n";
    for (name, text, arguments, part) in [
        ("json", &machine[..], &["run", &program, "--setup", "FILE"][..], "132.03"),
        ("json", &wrong, &["run", &program, "--setup", "FILE"], "Fräsmaschine"),
        ("json", &machine, &["definitions", "--setup", "FILE"], "Some(0)"),
        ("series.json", &machine, &["series", &program, "--setup", "FILE", "--runs", "3"], "132.03"),
        ("scenario.json", &scenario, &["test", "FILE"], "Größe überprüft"),
        (
            "txt",
            "Größe, 132, 132.12, 0.12\nüber alles\n",
            &["run", &program, "--setup", &setup, "--measured", "FILE"],
            "über",
        ),
        ("jog", script, &["jog", "FILE", "--setup", &setup], "müde"),
        ("ini", exported, &["machine", "FILE"], "FILE:2"),
        ("mpf", &format!("; Größe\n{HOLE}"), &["run", "FILE", "--setup", &setup], "132.03"),
    ] {
        let all = told(name, text, arguments);
        assert!(all[0].contains(part), "{name}: {}", all[0]);
        for (one, (encoding, _)) in all.iter().zip(ENCODINGS) {
            assert_eq!(*one, all[0], "{name} {encoding}");
        }
    }
}

// oracle: hand: file, what is wrong, what helps, in the language asked, and no word of the system's own
#[test]
fn what_cannot_be_read_is_told_with_its_cure() {
    let folder = std::env::temp_dir().to_str().unwrap().to_owned();
    let (setup, program) = (example_setup(), file("there.mpf", HOLE.as_bytes()));
    let picture = file("there.png", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR");
    let below = format!("{program}/there.json");
    for (language, missing, no_file, no_text) in [
        ("en", "there is no such file or folder; check name and folder", "this is a folder;", "it is a picture;"),
        ("de", "Datei oder Ordner nicht vorhanden; Namen und Ordner prüfen", "Das ist ein Ordner;", "Es ist ein Bild;"),
        ("zh", "没有该文件或文件夹；请检查名称和文件夹", "这是文件夹；", "它是图片；"),
    ] {
        for (path, told) in [("/no/such/file", missing), (&below, missing), (&folder, no_file), (&picture, no_text)] {
            for arguments in [
                &["run", path, "--setup", &setup][..],
                &["run", &program, "--setup", path],
                &["run", &program, "--setup", &setup, "--measured", path],
                &["series", &program, "--setup", path],
                &["series", path, "--setup", &setup],
                &["jog", path, "--setup", &setup],
                &["definitions", "--setup", path],
            ] {
                let output = probewright(&[&["--lang", language], arguments].concat());
                let line = err(&output);
                assert_eq!((output.status.code(), line.lines().count()), (Some(2), 1), "{arguments:?} {line}");
                assert!(line.contains(&format!("{path}: {told}")), "{arguments:?} {line}");
            }
            if path != folder {
                let output = probewright(&["--lang", language, "test", path]);
                let line = out(&output);
                assert!(line.contains(&format!("  {path}: {told}")) && line.lines().count() == 2, "{line}");
            }
        }
        let written =
            probewright(&["--lang", language, "series", &program, "--setup", &setup, "--runs", "1", "--csv", &folder]);
        assert!(err(&written).contains(&format!("{folder}: {no_file}")), "{}", err(&written));
    }
}

// oracle: hand: a cure “at this place” stands only behind a place
#[test]
fn a_place_has_its_cure_and_no_place_has_none() {
    let program = file("placed.mpf", b"M30\n");
    let setup = file("placed.json", b"{\n\"control\": 1 }");
    let told = err(&probewright(&["run", &program, "--setup", &setup]));
    assert!(told.contains(":2:12: ") && told.ends_with(" Correct the file at this place.\n"), "{told}");
    let wrong = file("placed.scenario.json", b"{\n \"program\": 1 }");
    let told = out(&probewright(&["test", &wrong]));
    assert!(told.contains(":2:13: ") && told.contains("    Correct the file at this place"), "{told}");
    let told = out(&probewright(&["test", "/no/such/file"]));
    assert!(!told.contains("at this place"), "{told}");
}
