//! Findings of ours, `PW135`, as a person reads them who saw the number: every sentence that comes under it, from the same
//! words as the finding itself.

use crate::message::Message;
use crate::run::problem::KEYS;
use crate::words::Words;

/// What may be said, and what helps; empty where the sentence says it.
type Said = (&'static str, &'static str);

/// Number and sentences of each finding; those of a run are `run::problem::KEYS`.
const FINDINGS: &[(u16, &[Said])] = &[
    (
        1,
        &[
            ("check-missing", ""),
            ("check-offset-missing", "check-offset-missing-hint"),
        ],
    ),
    (2, &[("check-not-a-number", "check-not-a-number-hint")]),
    (3, &[("check-expression", "")]),
    (4, &[("check-not-whole", "check-not-whole-hint")]),
    (
        5,
        &[
            ("check-range", "check-range-both-hint"),
            ("check-too-large", "check-too-large-hint"),
        ],
    ),
    (
        6,
        &[
            ("check-text-long", "check-text-long-hint"),
            ("check-text-characters", "check-text-characters-hint"),
        ],
    ),
    (7, &[("check-unusual", "check-unusual-hint")]),
    (8, &[("check-delivered", "")]),
    (20, &[("check-cora-off", "check-cora-off-hint")]),
    (
        21,
        &[
            ("check-empirical-memory", "check-memory-hint"),
            ("check-mean-memory", "check-memory-hint"),
        ],
    ),
    (
        22,
        &[("check-tolerance-order", "check-tolerance-order-hint")],
    ),
    (23, &[("check-band-difference", "check-bands-hint")]),
    (24, &[("check-zero-mean", "check-bands-hint")]),
    (25, &[("check-difference-safe", "check-bands-hint")]),
    (26, &[("check-reach", "check-reach-hint")]),
    (27, &[("check-infeed", "check-infeed-hint")]),
    (28, &[("check-mean-off", "check-mean-off-hint")]),
    (30, &[("check-ball", "check-ball-hint")]),
    (31, &[("check-zone-shortens", "check-zone-shortens-hint")]),
    (
        40,
        &[("check-calibration-band", "check-calibration-band-hint")],
    ),
    (41, &[("check-skew-lost", "check-skew-lost-hint")]),
    (42, &[("check-applicate-plus", "check-applicate-plus-hint")]),
    (43, &[("check-groove-empty", "check-groove-empty-hint")]),
    (44, &[("check-groove-edges", "check-groove-edges-hint")]),
    (45, &[("check-shank", "check-shank-hint")]),
    (46, &[("check-two-setpoint", "check-two-setpoint-hint")]),
    (47, &[("check-two-ball", "check-two-ball-hint")]),
    (48, &[("check-two-no-zone", "check-two-no-zone-hint")]),
    (49, &[("check-two-half-zone", "check-two-half-zone-hint")]),
    (50, &[("check-points-unused", "check-points-unused-hint")]),
    (51, &[("check-ball-unknown", "check-ball-unknown-hint")]),
    (52, &[("check-angles-sum", "check-angles-sum-hint")]),
    (53, &[("check-angles-wide", "check-angles-wide-hint")]),
    (54, &[("check-path-centre", "check-path-centre-hint")]),
    (55, &[("check-lift", "check-lift-hint")]),
    (56, &[("check-lift-ball", "check-lift-ball-hint")]),
    (59, &[("check-empirical-memory", "check-memory-hint")]),
    (60, &[("check-tool-limits", "check-tool-limits-hint")]),
    (
        61,
        &[("check-tool-probe-empty", "check-tool-probe-empty-hint")],
    ),
    (
        62,
        &[("check-tool-probe-sides", "check-tool-probe-sides-hint")],
    ),
    (
        63,
        &[("check-tool-probe-depth", "check-tool-probe-depth-hint")],
    ),
    (64, &[("check-offset-large", "check-offset-large-hint")]),
    (
        65,
        &[("check-offset-abscissa", "check-offset-abscissa-hint")],
    ),
    (66, &[("check-mfs-third", "check-mfs-third-hint")]),
    (67, &[("check-cm-zero", "check-cm-zero-hint")]),
    (68, &[("check-cm-factor", "check-cm-factor-hint")]),
    (69, &[("check-cm-order", "check-cm-order-hint")]),
    (
        70,
        &[("check-compensation-make", "check-compensation-make-hint")],
    ),
    (
        71,
        &[("check-compensation-table", "check-compensation-table-hint")],
    ),
    (72, &[("check-tool-reference", "check-tool-reference-hint")]),
    (73, &[("check-turning-digits", "check-turning-digits-hint")]),
    (74, &[("check-tip-direction", "check-tip-direction-hint")]),
    (
        75,
        &[("check-length-assignment", "check-length-assignment-hint")],
    ),
    (76, &[("check-radius-length", "check-radius-length-hint")]),
    (80, &[("check-angle-steep", "check-angle-steep-hint")]),
    (81, &[("check-angle-reach", "check-angle-reach-hint")]),
    (82, &[("check-angle-reach-worst", "check-angle-reach-hint")]),
    (83, &[("check-angle-paraxial", "check-angle-paraxial-hint")]),
    (85, &[("check-lathe-length", "check-lathe-length-hint")]),
    (
        90,
        &[("check-corner-rectangle", "check-corner-rectangle-hint")],
    ),
    (91, &[("check-corner-lift", "check-corner-lift-hint")]),
    (92, &[("check-corner-turned", "check-corner-turned-hint")]),
    (93, &[("check-sphere-small", "check-sphere-small-hint")]),
    (94, &[("check-spheres-line", "check-spheres-line-hint")]),
    (95, &[("check-spheres-close", "check-spheres-close-hint")]),
    (
        100,
        &[
            ("syntax-unknown", ""),
            ("syntax-value", ""),
            ("syntax-operand", ""),
            ("syntax-operator", ""),
            ("syntax-equals", ""),
            ("syntax-bracket", ""),
            ("syntax-index", ""),
            ("syntax-text", ""),
            ("syntax-number", ""),
            ("syntax-comma", ""),
            ("syntax-depth", ""),
            ("syntax-comment", ""),
            ("syntax-too-large", ""),
            ("syntax-exponent", ""),
        ],
    ),
    (101, &[("block-twice", "block-twice-hint")]),
    (102, &[("block-axis-name", "block-axis-name-hint")]),
    (110, &[("g101-no-target", "g101-no-target-hint")]),
    (112, &[("nct-limits", "nct-limits-hint")]),
    (113, &[("nct-same-register", "nct-same-register-hint")]),
    (115, &[("check-log-file", "check-log-file-hint")]),
    (116, &[("p9920-no-diameter", "p9920-no-diameter-hint")]),
    (
        117,
        &[("p9920-turning-length", "p9920-turning-length-hint")],
    ),
    (118, &[("p9920-no-clearance", "p9920-no-clearance-hint")]),
    (
        120,
        &[
            ("write-no-list", "write-no-list-hint"),
            ("write-no-list-variant", "write-no-list-hint"),
        ],
    ),
    (121, &[("write-zero", ""), ("write-beside", "")]),
    (122, &[("write-lost", "write-lost-hint")]),
    (123, &[("convert-others", "convert-others-hint")]),
    (124, &[("convert-same", "")]),
    (
        130,
        &[
            ("advice-compensation", "advice-compensation-hint"),
            ("advice-compensation-pass", "advice-compensation-hint"),
        ],
    ),
    (131, &[("advice-plane", "advice-plane-hint")]),
    (132, &[("advice-diameter", "advice-diameter-hint")]),
    (133, &[("advice-edge-open", "advice-edge-hint")]),
    (134, &[("advice-spindle", "advice-spindle-hint")]),
    (135, &[("advice-calibration", "advice-calibration-hint")]),
    (
        136,
        &[
            ("advice-inherited", "advice-inherited-hint"),
            ("advice-inherited-meaning", "advice-inherited-hint"),
        ],
    ),
    (
        137,
        &[
            ("advice-frame", "advice-frame-hint"),
            ("advice-frame-other", "advice-frame-other-hint"),
            ("advice-frame-basic", "advice-frame-hint"),
        ],
    ),
    (138, &[("advice-level", "advice-level-hint")]),
    (140, &[("advice-read-back", "advice-read-back-hint")]),
    (141, &[("advice-mask", "advice-mask-hint")]),
    (
        142,
        &[("advice-tool-programming", "advice-tool-programming-hint")],
    ),
    (
        143,
        &[("check-target-not-offered", "check-target-not-offered-hint")],
    ),
    (
        144,
        &[("check-calibration-mirror", "check-calibration-mirror-hint")],
    ),
    (145, &[("advice-open", "advice-open-hint")]),
    (
        146,
        &[("advice-compensation-open", "advice-compensation-hint")],
    ),
    (147, &[("advice-tool-none", "advice-tool-none-hint")]),
    (148, &[("advice-radius", "advice-radius-hint")]),
    (
        149,
        &[(
            "check-compensation-inside",
            "check-compensation-inside-hint",
        )],
    ),
    (150, &[("advice-overwritten", "advice-overwritten-hint")]),
    (
        151,
        &[
            ("arrives", "arrives-hint"),
            ("arrives", "arrives-shared-hint"),
            ("arrives", "arrives-many-hint"),
            ("arrives-differing", "arrives-differing-hint"),
        ],
    ),
    (152, &[("advice-outside", "advice-outside-hint")]),
    (153, &[("write-variant-open", "write-no-list-hint")]),
];

/// First number of what is told while a program runs.
const OF_RUN: u16 = 300;

/// What a finding means and what helps, for each sentence that it may say. Empty: there is none of this name.
pub fn finding(asked: &str, words: &Words) -> String {
    let number = asked.get(2..).filter(|_| is_own(asked));
    let Some(number) = number.and_then(|digits| digits.parse().ok()) else {
        return String::new();
    };
    let told = said(number).into_iter().map(|(cause, cure)| {
        let cure = match cure {
            "" => String::new(),
            key => format!("  {}\n", sentence(key, words)),
        };
        format!("PW{number:03}: {}\n{cure}", sentence(cause, words))
    });
    told.collect()
}

fn is_own(asked: &str) -> bool {
    asked
        .get(..2)
        .is_some_and(|begin| begin.eq_ignore_ascii_case("pw"))
}

fn said(number: u16) -> Vec<Said> {
    let of_run = number
        .checked_sub(OF_RUN)
        .and_then(|at| KEYS.get(usize::from(at)));
    match FINDINGS.iter().find(|(known, _)| *known == number) {
        Some((_, said)) => said.to_vec(),
        None => of_run.map(|key| (*key, "")).into_iter().collect(),
    }
}

/// A sentence with `…` where it names what it found.
fn sentence(key: &'static str, words: &Words) -> String {
    let text = words.text(&Message::new(key));
    let mut parts = text.split("{$");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |told, part| {
        let rest = part.split_once('}').map_or("", |(_, rest)| rest);
        told + "…" + rest
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::words::LANGUAGES;
    use std::collections::BTreeSet;
    use std::path::Path;

    /// The sources without this file and without tests.
    fn sources(folder: &Path, text: &mut String) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            if name.contains("test") || path.ends_with("report/findings.rs") {
                continue;
            } else if path.is_dir() {
                sources(&path, text);
            } else if name.ends_with(".rs") {
                let file = std::fs::read_to_string(&path).unwrap();
                text.push_str(file.split("#[cfg(test)]").next().unwrap());
            }
        }
    }

    // oracle: self (the sources: which numbers there are, and which keys)
    #[test]
    fn every_finding_is_explained_in_every_language() {
        let mut text = String::new();
        sources(
            &Path::new(env!("CARGO_MANIFEST_DIR")).join("src"),
            &mut text,
        );
        let numbers = text.split("Code::Own(").skip(1);
        let numbers: BTreeSet<u16> = numbers
            .filter_map(|rest| rest.split(')').next()?.parse().ok())
            .collect();
        assert!(numbers.len() > 90, "{numbers:?}");
        for number in numbers.iter().chain(&[70, 71, 149]) {
            assert!(!said(*number).is_empty(), "PW{number:03} is not explained");
        }
        for (number, said) in FINDINGS {
            for key in said
                .iter()
                .flat_map(|(cause, cure)| [*cause, *cure])
                .filter(|key| !key.is_empty())
            {
                let literal = |key: &str| text.contains(&format!("\"{key}\""));
                let made =
                    || key.strip_suffix("-hint").is_some_and(literal) || key.starts_with("syntax-");
                assert!(literal(key) || made(), "PW{number:03}: nothing says {key}");
                for language in LANGUAGES {
                    let words = Words::of(language.code).unwrap();
                    assert!(
                        words.find(&Message::new(key)).is_some(),
                        "{}: {key}",
                        language.code
                    );
                }
            }
        }
    }
}
