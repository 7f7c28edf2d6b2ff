//! Settings of cycles, of the screens that support them, and of the simulation.

use super::{FEED, Gud, Integer, LENGTH, Real, SPEED, Unit, element, gud5, gud6};

/// Feeds between measurements (B:13726-13734).
pub(super) const SPEEDS: &[Gud] = &[
    // Appendix A.1 delivers 100 % (B:16387).
    gud6("_SPEED", Real, &[4]).channel().elements(&[
        element("0", "B:13726-13731").initial(50.0).unit(Unit::Percent).between(0.0, 100.0),
        element("1", "B:13732").initial(1000.0).unit(FEED).positive(),
        element("2", "B:13733").initial(1000.0).unit(FEED).positive(),
        element("3", "B:13734").initial(900.0).unit(FEED).positive(),
    ]),
];

/// CYCLE971: monitoring of a turning tool, or feeds and speeds of the user (B:13498-13520).
pub(super) const TOOL_MEASURING: &[Gud] = &[
    gud6("_CM", Real, &[8]).elements(&[
        element("0", "B:13498").initial(100.0).unit(SPEED).positive(),
        element("1", "B:13499").initial(1000.0).unit(Unit::Rpm).positive(),
        element("2", "B:13500").initial(1.0).unit(FEED).not_negative(),
        element("3", "B:13501").initial(0.005).unit(LENGTH).positive(),
        element("4", "B:13502").initial(20.0).unit(FEED).positive(),
        element("5", "B:13503").initial(4.0).choices(&[3, 4]),
        element("6", "B:13504").initial(10.0).not_negative(),
        element("7", "B:13505").not_negative(),
    ]),
    gud6("_MFS", Real, &[6]).elements(&[
        element("0", "B:13515").unit(Unit::Rpm).not_negative(),
        element("1", "B:13516").unit(FEED).not_negative(),
        element("2", "B:13517").unit(Unit::Rpm).not_negative(),
        element("3", "B:13518").unit(FEED).not_negative(),
        element("4", "B:13519").unit(Unit::Rpm).not_negative(),
        element("5", "B:13520").unit(FEED).not_negative(),
    ]),
];

/// Empirical and mean values, and how many there are (B:13097-13098, B:13693-13718).
pub(super) const MEMORIES: &[Gud] = &[
    gud6("_EVMVNUM", Integer, &[2]).channel().elements(&[
        element("0", "B:13717").initial(20.0).between(0.0, 9999.0),
        element("1", "B:13718").initial(20.0).between(0.0, 9999.0),
    ]),
    // `_EVNUM` allows 1 to 9999 (B:2325).
    gud5("_EV", Real, &[9999]).counted("_EVMVNUM[0]").elements(&[element("k", "B:13097").unit(LENGTH)]),
    gud5("_MV", Real, &[9999]).counted("_EVMVNUM[1]").elements(&[element("k", "B:13098").unit(LENGTH)]),
];

/// What the screens of the measuring cycle support show and write, `_MZ_MASK` (B:12501-12539).
pub(super) const MASKS: &[Gud] = &[gud6("_MZ_MASK", Integer, &[20]).elements(&[
    element("0", "B:12501-12502").initial(1.0).switch(),
    element("1", "B:12503-12504").switch(),
    element("2", "B:12505-12506").switch(),
    element("3", "B:12507").switch(),
    element("4", "B:12518-12532").switch(),
    element("5", "B:12533-12535").switch(),
    element("6", "B:12536").internal(),
    element("7", "B:12537-12539").switch(),
    element("8..19", "B:13175").internal(),
])];

/// How cycles behave in the control's own simulation (B:13245-13247).
pub(super) const SIMULATION: &[Gud] = &[
    gud6("_MC_SIMSIM", Integer, &[]).channel().elements(&[element("", "B:13245").initial(1.0).switch()]),
    gud6("_MC_SIMDIFF", Real, &[]).channel().elements(&[element("", "B:13247").unit(LENGTH)]),
];
