//! CYCLE982 finds the length of a drill that lies along the applicate.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::machine::{PROBE, Real, digit, inputs, machine, mount, place};
use crate::catalogue::cycle982::CYCLE982;
use crate::catalogue::sinumerik::testing::{called, random_parts};
use crate::control::{Plane, TOOL_LENGTH_TYPE, Units};
use proptest::prelude::*;

/// Variants that measure one length of a drill without reversal, in both systems of reference (B:10112-10120).
fn variants() -> Vec<i64> {
    let all = CYCLE982.variants.iter().map(|variant| variant.number);
    let one_length = |variant: &i64| digit(*variant, 1) == 1 && [3, 4].iter().all(|place| digit(*variant, *place) == 0);
    all.filter(one_length).collect()
}

proptest! {
    #![proptest_config(random_parts(20))]

    // oracle: hand (the drill as it was made); manual B:10096-10122: L1 lies along Z in G17 and along X in G19
    #[test]
    fn the_length_along_the_applicate_is_found(
        plane in prop::sample::select(vec![Plane::G17, Plane::G19]),
        variant in prop::sample::select(variants()),
        length in 40.0..120.0_f64,
        wrong in -2.0..2.0_f64,
        beside in -40.0..40.0_f64,
        inch in any::<bool>(),
        remeasure in any::<bool>(),
    ) {
        let units = if inch { Units::Inch } else { Units::Metric };
        let mut setup = machine(units);
        setup.control.plane = plane;
        setup.control.set(TOOL_LENGTH_TYPE, 0.0);
        setup.control.set("_CHBIT[3]", f64::from(u8::from(remeasure)));
        let real = Real { length: [length, 0.0], radius: 4.0 };
        mount(&mut setup, real.believed(200, 0, [wrong, 0.0, 0.0]), real.cutter(2, 0.0));
        // abscissa and ordinate of G18, in which the probe is described: Z and X
        let lies = usize::from(plane == Plane::G19);
        let incremental = digit(variant, 6) == 1;
        let mut start = PROBE.map(|[minus, plus]| (minus + plus) / 2.0);
        start[lies] = PROBE[lies][0] + if incremental { 6.0 } else { 25.0 };
        if !incremental {
            start[1 - lies] += beside;
        }
        place(&mut setup, start);
        let call = inputs(&setup, variant, &[("_MA", 1.0), ("_MD", 1.0)]);
        let (sim, outcome) = called(&setup, &call);
        prop_assert_eq!(outcome, Ok(()), "{}", variant);
        let edge = sim.control.active_edge().unwrap();
        prop_assert!((edge.total_length(0) - length).abs() < 1e-9, "{} is {}", variant, edge.total_length(0));
        let shown = sim.control.number("_OVR[8]") * sim.control.active_factor();
        prop_assert!((shown - length).abs() < 1e-9);
        let before = setup.control.active_edge().unwrap();
        if remeasure && !incremental {
            prop_assert_eq!(edge.length[0], before.length[0]);
        } else {
            prop_assert_eq!(edge.length_wear[0], 0.0);
        }
    }
}
