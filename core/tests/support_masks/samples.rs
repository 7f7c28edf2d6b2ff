//! The samples that the manual prints.

use super::{DELIVERED, code, has, machine, typed, values, words};

/// The manual's sample, repaired as in the tables: B:12414-12423, A:13686-13701.
const SAMPLE: &str = "_MVAR=1001 _SETVAL=100.000 _PRNUM=101
    _KNUM=2002 _FA=2 _TSA=0.23
    _VMS=0 _NMSP=1 _ID=-20.000 _SZA=50.000
    _CORA=0.03 _TZL=0.01 _TDIF=0.2 _TUL=0.065
    _TLL=-0.065 _CHBIT[4]=0 _K=1 _EVNUM=2 _TNUM=1
    CYCLE977";

/// A word with its number as it is worth.
fn plain(word: &str) -> String {
    match word.split_once('=') {
        Some((name, value)) => format!("{name}={}", value.parse::<f64>().unwrap()),
        None => word.to_owned(),
    }
}

// oracle: manual B:12414-12423. The sample lacks _TMV, which B:12523 wants; the screens show where it stands (B:12160).
#[test]
fn the_manuals_sample_is_written() {
    let mut mask = DELIVERED;
    for entry in [1, 3, 5] {
        mask[entry] = 1; // _KNUM, _EVNUM=2, _PRNUM=101 with _CORA
    }
    let control = machine(mask);
    let sample: Vec<String> = SAMPLE.split_whitespace().map(plain).collect();
    let (_, assignments) = sample.split_last().unwrap();
    let mut typed = typed(&assignments.join(" "));
    typed.retain(|name, _| !["_VMS", "_NMSP", "_CHBIT[4]", "_K"].contains(&&**name));
    let text = code("CYCLE977", &typed, &control);
    let mut ours = words(&text);
    let limit = ours.iter().position(|word| word.starts_with("_TMV=")).unwrap();
    assert_eq!(ours.remove(limit), "_TMV=0.043333"); // hand: 0.13 / 3
    assert_eq!(ours, sample);
    assert_eq!(ours[limit - 1], "_CHBIT[4]=0", "position as on the screens");
}

// oracle: manual B:12154-12163: block ends and all words of the screens, the cut-off _TMV completed (0.5 / 3)
#[test]
fn the_block_of_the_screens_is_written() {
    let values = typed(
        "_MVAR=1 _SETVAL=100 _PRNUM=1 _KNUM=2002 _FA=2 _TSA=0.23 _TZL=0.1 _TDIF=0.02 _TUL=0.25 _TLL=-0.25 _TNUM=1",
    );
    let text = code("CYCLE977", &values, &machine(DELIVERED));
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(
        lines,
        [
            "; _MZ_MASK=1,0,0,0,0,0,0,0 MD18102=0 MD18080=256",
            // _KNUM=2 there; the radius, which is all that is offered, is 2002 (B:12503, B:1911)
            "_MVAR=1 _SETVAL=100 _PRNUM=1 _KNUM=2002 _FA=2 _TSA=0.23 _VMS=0 _NMSP=1",
            "_TZL=0.1 _TDIF=0.02 _TUL=0.25 _TLL=-0.25 _CHBIT[4]=0 _TMV=0.166667 _K=1 _EVNUM=0 _TNUM=1",
            "CYCLE977",
        ]
    );
}

// oracle: manual B:12523 (the formula, where the limits are known at run time only)
#[test]
fn limits_of_the_program_make_a_formula() {
    let mut values = values("CYCLE977", 1);
    values.insert("_TUL".into(), "R1".into());
    let text = code("CYCLE977", &values, &machine(DELIVERED));
    assert!(has(&text, "_TMV=ABS(_TUL-_TLL)/3"), "{text}");
}
