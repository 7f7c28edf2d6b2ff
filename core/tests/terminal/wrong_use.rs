//! What is no program, no option, or nobody reads any more.

use super::{err, example_setup, file, out, probewright};
use std::process::Command;

// oracle: hand
#[test]
fn wrong_use_is_told_in_a_line() {
    for arguments in [
        &["write", "CYCLE1234"][..],
        &["write", "CYCLE977", "_NOTHING=1"],
        &["write", "CYCLE977", "_MVAR"],
        &["write", "CYCLE977", "_MVAR=1", "_mvar=2"],
        &["read", "/no/such/file"],
        &["run", "/no/such/file", "--setup", "/no/such/setup"],
    ] {
        let output = probewright(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert_eq!(err(&output).trim_end().lines().count(), 1, "{}", err(&output));
    }
}

// oracle: hand
#[test]
fn wrong_use_is_told_in_the_language_asked() {
    for (language, told) in [
        ("en", "error: there is no cycle CYCLE1; “probewright cycles” lists them\n"),
        ("de", "Fehler: Es gibt keinen Zyklus CYCLE1; „probewright cycles“ listet alle auf\n"),
        ("zh", "错误: 没有循环 CYCLE1；用“probewright cycles”列出全部循环\n"),
    ] {
        assert_eq!(err(&probewright(&["--lang", language, "write", "CYCLE1"])), told);
    }
    assert_eq!(
        err(&probewright(&["--lang", "xx", "cycles"])),
        "error: there is no language xx; available: de, en, zh\n"
    );
}

// oracle: hand: each is told by the name of its argument, with what is permitted
#[test]
fn numbers_and_columns_of_the_terminal_are_told_in_its_words() {
    let program = file("wrong-numbers.mpf", b"M30\n");
    let machine = std::fs::read_to_string(example_setup()).unwrap();
    let with = |name: &str, series: &str| {
        let text = machine.replacen('{', &format!(r#"{{ "series": {{ {series} }},"#), 1);
        file(name, text.as_bytes())
    };
    let large = with("large.json", r#""runs": 1000000000000"#);
    let seed = with("seed.json", r#""seed": 18446744073709551616"#);
    let half = with("half.json", r#""vary": [{ "what": "probe.radius", "half": 0.1 }]"#);
    let setup = example_setup();
    let series = |more: &[&str]| err(&probewright(&[&["series", &program, "--setup", &setup], more].concat()));
    let runs = "for --runs: enter a whole number from 1 to 1000000";
    for (arguments, told) in [
        (&["--runs", "0"][..], runs),
        (&["--runs", "1000001"], runs),
        (&["--runs", "99999999999999999999"], runs),
        (&["--runs", "-5"], runs),
        (&["--runs", "1", "--certainty"], "for --runs: enter a whole number from 2 to"),
        (&["--seed", "1.5"], "for --seed: enter a whole number from 0 to 18446744073709551615"),
        (&["--seed", "-1"], "for --seed: enter a whole number from 0"),
        (&["--runs", "10", "--runs", "20"], "is given twice"),
        (&["--program", "NIX"], "There is no program “NIX” in this text."),
    ] {
        assert!(series(arguments).contains(told), "{arguments:?}: {}", series(arguments));
    }
    for (setup, told) in [
        (&large, "series.runs is 1000000000000; permitted: whole numbers from 0 to 4294967295"),
        (&seed, "permitted: whole numbers from 0 to 18446744073709551615"),
        (&half, "series.vary[0].half means nothing for this distribution. Enter sigma"),
    ] {
        let output = probewright(&["series", &program, "--setup", setup]);
        assert!(output.status.code() == Some(2) && err(&output).contains(told), "{}", err(&output));
    }
    let nothing = probewright(&["series", &program, "--setup", &setup, "--runs", "5"]);
    assert!(out(&nothing).contains("Nothing was measured."), "{}{}", out(&nothing), err(&nothing));
    let unknown = out(&probewright(&["run", &program, "--program", "NIX"]));
    assert!(unknown.contains("did not start") && !unknown.contains("line 0"), "{unknown}");
    let columns = ["--columns", "actual=Ist", "actual=Soll"];
    let twice = probewright(&[&["run", &program, "--measured", &program][..], &columns].concat());
    assert!(err(&twice).contains("two columns for actual"), "{}", err(&twice));
    let log = file("LOG_9.MPF", b"Date: 98/11/15   Time: 10:05:30   Page: 1\n\nProgram: P\nCYCLE978, _MVAR, 100\n");
    let read = probewright(&["read", &log]);
    assert!(err(&read).contains("--measured") && out(&read).is_empty(), "{}{}", out(&read), err(&read));
    let shown = file("shown.mpf", b"_TSA=1 _FA=2 _MVAR=101 _SETVAL=50\nCYCLE977\nCYCLE102\nM30\n");
    let shown = out(&probewright(&["run", &shown]));
    assert!(shown.contains("shown.mpf:3: "), "{shown}");
}

// oracle: hand. Each unreadable thing is named, the other files are checked all the same.
#[test]
fn what_is_no_program_is_told_and_the_rest_is_checked() {
    let wrong = file("wrong2.mpf", b"\n  _MVAR=7\nCYCLE977\n");
    let folder = std::env::temp_dir().to_str().unwrap().to_owned();
    let output = probewright(&["check", &folder, "/no/such/file", &wrong]);
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(err(&output).lines().count(), 2, "{}", err(&output));
    assert!(err(&output).contains(&folder) && err(&output).contains("/no/such/file"));
    assert!(out(&output).contains(":2:9: error[61307]: _MVAR"), "{}", out(&output));
    let endless = probewright(&["read", "/dev/zero"]);
    assert_eq!(endless.status.code(), Some(2));
    assert!(err(&endless).contains("/dev/zero: larger than"), "{}", err(&endless));
}

// oracle: hand
#[test]
fn binary_and_huge_lines_give_short_clean_messages() {
    let path = file("binary.mpf", &[b"R1=(\x00\x1b[2J\xff\xfe", &b"x"[..], &vec![b'('; 200_000]].concat());
    for arguments in [&["check", &path][..], &["run", &path, "--setup", &example_setup()]] {
        let output = probewright(arguments);
        assert_eq!(output.status.code(), Some(1), "{}", out(&output));
        assert!(out(&output).lines().all(|line| line.chars().count() < 400));
        assert!(!out(&output).chars().any(|c| c.is_control() && c != '\n'));
    }
    let noise: Vec<u8> = (0..100_000u32)
        .map(|i| b' ' + ((i.wrapping_mul(2_654_435_761) >> 13) % 95) as u8)
        .flat_map(|byte| if byte == b';' { *b"\n" } else { [byte] })
        .collect();
    let path = file("noise.mpf", &noise);
    let output = probewright(&["check", &path]);
    assert_eq!(output.status.code(), Some(1));
    assert!(out(&output).lines().count() <= 201 && out(&output).contains("More findings"));
}

// oracle: hand (the beginnings that the formats prescribe)
#[test]
fn what_is_no_program_is_refused() {
    let picture = file("part.png", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR");
    let noise: Vec<u8> = (0..100_000u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 13) as u8).collect();
    let noise = file("noise.bin", &noise);
    for (path, why) in [(&picture, "it is a picture"), (&noise, "it contains no text")] {
        for arguments in [&["check", path][..], &["read", path], &["run", path, "--setup", &example_setup()]] {
            let output = probewright(arguments);
            assert_eq!(output.status.code(), Some(2), "{arguments:?}");
            assert!(err(&output).contains(why), "{}", err(&output));
            assert_eq!(out(&output), "");
        }
    }
    let chinese = probewright(&["--lang", "zh", "check", &picture]);
    assert!(err(&chinese).contains("它是图片"), "{}", err(&chinese));
}

// oracle: hand
#[test]
fn a_closed_pipe_ends_the_output_quietly() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_probewright"))
        .env("LC_ALL", "C")
        .args(["cycles", "--json"])
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), err(&output)), (Some(0), String::new()));
}

// oracle: hand
#[test]
fn a_wrong_setup_is_told_with_its_place_in_the_language_asked() {
    let program = file("for_wrong_setup.mpf", b"M30\n");
    let setup = file("wrong.json", b"{\n\"control\": \"nct\",\n\"probe\": {\"radius\": 0, \"length\": 50}\n}");
    for (language, told) in [
        ("en", ":3:21: probe.radius is 0; permitted: more than 0, at most 1000000."),
        ("zh", ":3:21: probe.radius 为 0；允许：大于 0，不超过 1000000。"),
    ] {
        let output = probewright(&["--lang", language, "run", &program, "--setup", &setup]);
        assert_eq!(output.status.code(), Some(2));
        assert!(err(&output).contains(&format!("{setup}{told}")), "{}", err(&output));
    }
}
