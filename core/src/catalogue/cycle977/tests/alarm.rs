//! What CYCLE977 refuses, gives up, repeats and tells.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::super::tests::{CENTRE, SIZE, hole, inputs, part, ready};
use crate::catalogue::sinumerik::testing::{alarms, called, close, motions, put, stopped};
use crate::control::Plane;
use crate::entry::{Inputs, names};
use crate::machine::{MotionKind, Setup, Step};

#[test]
fn alarms_before_the_first_motion() {
    // oracle: manual A:15847-15931
    let alarm = |errors: &dyn Fn(&mut Setup, &mut Inputs)| {
        let (sim, outcome) = hole(errors);
        let moved = sim.trace.entries.iter().any(|entry| matches!(entry.step, Step::Motion { .. }));
        assert!(!moved);
        let number = stopped(outcome);
        assert_eq!(sim.control.number("_OVI[9]"), f64::from(number));
        number
    };
    let value = |name: &'static str, value: f64| {
        alarm(&move |_, inputs| {
            put(inputs, name, value);
        })
    };
    let datum = |name: &'static str, value: f64| alarm(&move |setup, _| setup.control.set(name, value));
    assert_eq!(value("_FA", 0.0), 61308);
    assert_eq!(value("_PRNUM", 4.0), 61313);
    assert_eq!(value("_PRNUM", 0.0), 61313);
    assert_eq!(value("_K", 0.0), 61318);
    assert_eq!(value("_KNUM", 3001.0), 61322);
    assert_eq!(value("_KNUM", 1.0), 61322);
    assert_eq!(value("_KNUM", 20_001.0), 61323);
    assert_eq!(value("_KNUM", 500_001.0), 61324);
    assert_eq!(value("_KNUM", 9_000_001.0), 61407);
    assert_eq!(value("_KNUM", 2000.0), 61328);
    assert_eq!(value("_KNUM", 2012.0), 61345);
    assert_eq!(value("_KNUM", 2002.0), 61410);
    assert_eq!(value("_KNUM", 1_002_001.0), 61406);
    assert_eq!(value("_KNUM", 2_002_001.0), 61405);
    assert_eq!(datum("_SPEED[0]", -1.0), 61339);
    assert_eq!(datum("_SPEED[1]", 0.0), 61338);
    assert_eq!(alarm(&|setup, _| (0..7).for_each(|i| setup.control.set(format!("_WP[0,{i}]"), 0.0))), 61341);
    assert_eq!(alarm(&|setup, _| setup.control.edge = 0), 61311);
    assert_eq!(alarm(&|setup, _| assert!(setup.control.set_variable("$TC_DP1[9,1]", 500.0))), 61309);
    let tool = |number: f64, name: &'static str| {
        alarm(&move |_, inputs| {
            inputs.numbers.extend([(names::KNUM, 2001.0), (names::TNUM, number)]);
            inputs.texts.insert(names::TNAME, name.to_string());
        })
    };
    assert_eq!(tool(0.0, ""), 61320);
    assert_eq!(tool(0.0, "NOBODY"), 61343);
    let zero = |number: f64| {
        alarm(&move |_, inputs| {
            inputs.variant = 101;
            inputs.numbers.insert(names::KNUM, number);
        })
    };
    assert_eq!(zero(100.0), 61321);
    assert_eq!(zero(1000.0), 61412);
    let zone = |size: f64| {
        alarm(&move |_, inputs| {
            inputs.variant = 1001;
            inputs.numbers.insert(names::SZA, size);
        })
    };
    assert_eq!(zone(50.0), 61334);
}

#[test]
fn no_signal_is_tried_five_times_or_once() {
    // oracle: manual B:13999-14001
    for (bit, attempts) in [(0.0, 5), (1.0, 1)] {
        let (sim, outcome) = hole(|setup, _| {
            setup.workpiece.solids.clear();
            setup.control.set("_CHBIT[15]", bit);
        });
        assert_eq!(stopped(outcome), 61301);
        let all = motions(&sim, Plane::G17, [0.0; 3]).into_iter();
        let probings = all.filter(|(kind, ..)| *kind == MotionKind::Measuring);
        assert_eq!(probings.count(), attempts);
    }
}

#[test]
fn a_probe_that_touches_on_its_way_alarms() {
    // oracle: manual B:13743-13763 (the hole is 12 mm smaller than _FA allows)
    let (sim, outcome) = hole(|_, inputs| {
        inputs.numbers.insert(names::SETVAL, 80.0);
    });
    assert_eq!(stopped(outcome), 61302);
    assert_eq!(sim.control.number("_OVI[9]"), 61302.0);
}

#[test]
fn a_limit_switch_shortens_the_way_to_an_outer_element() {
    // oracle: manual A:15920-15921, with a shaft of 60 mm at X40: the ball touches it at X73, the block begins at X78
    let case = |limit: f64| {
        let mut setup = ready(Plane::G17, 2);
        setup.workpiece.solids.push(part(Plane::G17, 2, false));
        setup.control.limits.plus[0] = Some(limit);
        called(&setup, &inputs(2, 1.0))
    };
    assert_eq!(stopped(case(71.0).1), 61402);
    // oracle: hand: from X75 the way down is free, and the block measures what it would from X78
    let (sim, outcome) = case(75.0);
    assert_eq!(outcome, Ok(()));
    close(&sim, "_OVR[4]", SIZE[0]);
    close(&sim, "_OVR[5]", CENTRE[0]);
}

#[test]
fn a_limit_switch_before_the_wall_is_told() {
    // oracle: manual A:15920: the hole's wall is touched at X67
    let case = |limit: f64| {
        let (_, outcome) = hole(|setup, _| setup.control.limits.plus[0] = Some(limit));
        outcome
    };
    assert_eq!(stopped(case(66.9)), 61401);
    assert_eq!(case(67.0), Ok(()));
    assert_eq!(stopped(case(50.0)), 61401);
}

#[test]
fn limits_are_told_and_repeated() {
    // oracle: manual B:6123-6137, B:13572-13580
    let case = |grown: f64, bits: &'static [&'static str]| {
        let (sim, outcome) = hole(move |setup, inputs| {
            setup.workpiece.solids[0].errors.size = grown;
            bits.iter().for_each(|bit| setup.control.set(*bit, 1.0));
            inputs.numbers.extend([(names::TUL, 0.5), (names::TLL, -0.5), (names::TDIF, 1.0)]);
        });
        (alarms(&sim), outcome, sim)
    };
    assert_eq!(case(0.7, &[]).0, [62304]);
    assert_eq!(case(-0.7, &[]).0, [62305]);
    let (alarms, outcome, sim) = case(1.5, &[]);
    assert_eq!((alarms, outcome), (vec![62306], Ok(())));
    assert_eq!(sim.control.number("_OVI[9]"), 62306.0);
    let (alarms, outcome, _) = case(3.5, &[]);
    assert_eq!((alarms, stopped(outcome)), (vec![], 61303));
    let (alarms, outcome, _) = case(1.5, &["_CBIT[0]", "_CBIT[1]"]);
    assert_eq!((alarms, outcome), (vec![62306; 5], Ok(())));
    let (alarms, outcome, sim) = case(3.5, &["_CBIT[0]", "_CBIT[1]"]);
    assert_eq!((alarms, stopped(outcome)), (vec![62303; 4], 61303));
    let touches = sim.trace.entries.iter().filter(|entry| matches!(entry.step, Step::Touch { .. }));
    assert_eq!(touches.count(), 20);
}
