//! What measuring needs of machine data: a row a condition, with the limits as they are printed. Where the manual
//! prints two figures for one datum, both are limits, each with its place: the smaller makes an error, the larger a
//! warning.

use crate::diagnostic::Severity;
use Severity::{Error, Note, Warning};
use serde::{Deserialize, Serialize};

/// What a machine measures with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Use {
    /// Measuring cycles in programs: always.
    Cycles,
    /// Measuring in JOG.
    Jog,
    /// Logging.
    Log,
    /// A tool probe.
    ToolProbe,
}

/// How a value is compared with a limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Test {
    /// As large as the limit, or larger.
    AtLeast,
    /// Exactly the limit.
    Equal,
    /// As large as the limit, or smaller.
    AtMost,
    /// From 1 to the limit.
    UpTo,
    /// All bits of the limit are set.
    Set,
    /// No bit of the limit is set.
    Clear,
}

/// When a condition counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum When {
    /// Always.
    Always,
    /// If this datum is known and this bit of it is set.
    Bit(&'static str, u32),
}

/// A value that the manual prints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// How bad it is to miss it.
    pub severity: Severity,
    /// Who needs it.
    pub of: Use,
    /// The value, or a mask.
    pub value: f64,
    /// The same on an NCU 3, where it differs.
    pub large: f64,
    /// Place in the manual.
    pub source: &'static str,
}

/// A condition on a machine datum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Need {
    /// Number of the datum.
    pub number: &'static str,
    /// How its value, or each of its elements, is compared.
    pub test: Test,
    /// With what.
    pub limits: &'static [Limit],
    /// When.
    pub when: When,
    /// Alarm that follows; 0: none is printed.
    pub alarm: u32,
    /// What follows: key of a message behind `machine-need-`.
    pub effect: &'static str,
    /// Whether a line that changes it is proposed: not where it depends on the probe or on what programs use.
    pub changed: bool,
    /// Whether each of its elements is another: what is proposed is the place of the element, from 1.
    pub by_place: bool,
}

const fn limit(severity: Severity, of: Use, value: f64, source: &'static str) -> Limit {
    Limit { severity, of, value, large: value, source }
}

const fn cycles(severity: Severity, value: f64, source: &'static str) -> Limit {
    limit(severity, Use::Cycles, value, source)
}

const fn jog(value: f64, source: &'static str) -> Limit {
    limit(Error, Use::Jog, value, source)
}

impl Limit {
    const fn large(self, large: f64) -> Limit {
        Limit { large, ..self }
    }
}

const fn need(number: &'static str, test: Test, effect: &'static str, limits: &'static [Limit]) -> Need {
    Need { number, test, limits, when: When::Always, alarm: 0, effect, changed: true, by_place: false }
}

impl Need {
    const fn alarm(self, alarm: u32) -> Need {
        Need { alarm, ..self }
    }

    const fn only_told(self) -> Need {
        Need { changed: false, ..self }
    }

    const fn by_place(self) -> Need {
        Need { by_place: true, ..self }
    }

    const fn when(self, number: &'static str, bit: u32) -> Need {
        Need { when: When::Bit(number, bit), ..self }
    }
}

/// Memory for the values of user data, MD18150, KB: what the control needs, each channel, and each channel with
/// measuring in JOG (B:12971-12973, A:14231-14233).
pub const GUD_MEMORY: [f64; 3] = [7.0, 4.0, 0.5];
/// Where [`GUD_MEMORY`] is printed.
pub const GUD_MEMORY_SOURCE: &str = "B:12959-12974;A:14222-14234";
/// The datum with [`GUD_MEMORY`].
pub const GUD_VALUES: &str = "MD18150";

/// All of them, in the order of the manual.
pub const NEEDS: &[Need] = &[
    need("MD18118", Test::AtLeast, "gud", &[cycles(Error, 7.0, "B:12920-12927;A:14192-14196;B:16182")]),
    need("MD18118", Test::AtMost, "gud", &[cycles(Error, 9.0, "B:12920-12927;A:14192-14196")]),
    need(
        "MD18120",
        Test::AtLeast,
        "gud",
        &[
            cycles(Error, 20.0, "B:12971;A:14231"),
            cycles(Warning, 30.0, "A:14198-14202;B:16183;A:16983"), // lost at B:12931
        ],
    ),
    need(
        "MD18130",
        Test::AtLeast,
        "gud",
        &[
            cycles(Error, 60.0, "B:12972;A:14232"),
            cycles(Warning, 100.0, "B:12940-12946;A:14204-14208"),
            jog(90.0, "B:12973;A:14233"),
            limit(Warning, Use::Jog, 130.0, "A:14205;B:16184;A:16984"),
        ],
    ),
    // beside it what `GUD_MEMORY` comes to
    need(
        GUD_VALUES,
        Test::AtLeast,
        "gud",
        &[cycles(Warning, 28.0, "B:12948-12955;A:14212-14218;B:16185;A:16985").large(32.0)],
    ),
    need(
        "MD18170",
        Test::AtLeast,
        "functions",
        &[cycles(Error, 70.0, "B:16186;A:16986"), cycles(Warning, 80.0, "A:14244-14248;B:12997-13003")],
    ),
    need(
        "MD18180",
        Test::AtLeast,
        "functions",
        &[cycles(Error, 600.0, "B:16187;A:16987"), cycles(Warning, 800.0, "A:14250-14254;B:13005-13011")],
    ),
    need("MD28020", Test::AtLeast, "lud", &[cycles(Error, 200.0, "B:13015-13022;A:14256-14260")]),
    need(
        "MD28040",
        Test::AtLeast,
        "lud",
        &[
            cycles(Error, 14.0, "B:16189;A:16989").large(27.0),
            cycles(Warning, 16.0, "B:13023-13030;A:14262-14268").large(29.0),
        ],
    ),
    need("MD28082", Test::Set, "system-frame", &[cycles(Error, 32.0, "B:12976-12983;A:14236-14240")]).alarm(61016),
    need("MD28082", Test::Set, "basic-frame", &[cycles(Warning, 1.0, "B:1977-1986;A:2075;B:12976-12983")]),
    need("MD28083", Test::Set, "system-frame", &[cycles(Error, 32.0, "B:12987-12993")]).alarm(61016),
    need("MD28083", Test::Set, "basic-frame", &[cycles(Warning, 1.0, "B:12987-12993")]),
    need("MD28081", Test::AtLeast, "channel-frame", &[cycles(Warning, 1.0, "B:1942;A:15931;B:8590")])
        .alarm(61412)
        .only_told(),
    need("MD18600", Test::Equal, "fine", &[cycles(Note, 1.0, "B:1990-1992;B:14037;A:2081-2083")]).only_told(),
    need("MD13200", Test::Equal, "level", &[cycles(Warning, 0.0, "B:13034-13050;A:14276-14282")]).only_told(),
    need("MD13210", Test::Equal, "central", &[cycles(Error, 0.0, "B:12732")]),
    need("MD10132", Test::AtLeast, "hmi-time", &[cycles(Warning, 3.0, "B:13052-13060;A:14284-14290")]),
    need(
        "MD11420",
        Test::AtLeast,
        "log-file",
        &[
            limit(Error, Use::Log, 1.0, "B:13062-13070;A:14292-14298"),
            limit(Warning, Use::Log, 5.0, "B:13062-13070;A:14292-14298"),
        ],
    ),
    need("MD10610", Test::Equal, "mirror", &[cycles(Warning, 0.0, "B:4154;B:8709;A:4787;A:9620")]).only_told(),
    need("MD18080", Test::Set, "additive", &[cycles(Warning, 256.0, "A:15927")]).alarm(61408).only_told(),
    need("MD18112", Test::Set, "setup-offset", &[cycles(Warning, 16.0, "A:15928")]).alarm(61409).only_told(),
    need("MD18116", Test::AtLeast, "environment", &[cycles(Note, 1.0, "B:2084-2086;A:2203;A:15924")])
        .alarm(61405)
        .only_told(),
    need("MD11602", Test::Set, "jog-start", &[jog(1.0, "B:14067-14073;A:15227-15231")]),
    need("MD11604", Test::UpTo, "jog-start", &[jog(100.0, "B:14075-14082;A:15232-15236")]),
    need("MD20050", Test::AtLeast, "geometry", &[jog(1.0, "B:14084-14093;A:15237-15241")]).by_place(),
    need("MD20110", Test::Set, "reset-length", &[jog(16453.0, "B:14099-14110;A:15242-15246")]),
    need("MD20112", Test::Clear, "start-length", &[jog(64.0, "B:14112-14119;A:15247-15251")]),
    need("MD20310", Test::Set, "tool-change", &[jog(16384.0, "B:14121-14127;A:15252-15257")]).when("MD20310", 0),
    need("MD24006", Test::Set, "basic-reset", &[jog(1.0, "B:14133-14141;A:15258-15262")]).when("MD28082", 0),
    need("MD24007", Test::Clear, "basic-reset", &[jog(1.0, "B:14143-14151;A:15263-15267")]),
    need("SD42950", Test::Equal, "length-type", &[cycles(Note, 2.0, "B:828;B:4151;B:9192;A:742;A:10375-10377")])
        .only_told(),
];

impl Need {
    /// Whether its value is a mask of bits.
    pub const fn mask(&self) -> bool {
        matches!(self.test, Test::Set | Test::Clear)
    }
}

impl Test {
    /// Whether a value meets a limit. What has no bits, a fraction or a negative number, meets no mask.
    pub fn holds(self, value: f64, limit: f64) -> bool {
        let (bits, limited) = (mask(value), limit as u32);
        match self {
            Test::AtLeast => value >= limit,
            Test::AtMost => value <= limit,
            Test::Equal => value == limit,
            Test::UpTo => (1.0..=limit).contains(&value),
            Test::Set => bits.is_some_and(|bits| bits & limited == limited),
            Test::Clear => bits.is_some_and(|bits| bits & limited == 0),
        }
    }

    /// The value nearest to this one that meets a limit.
    pub fn mended(self, value: f64, limit: f64) -> f64 {
        let bits = mask(value).unwrap_or(0);
        match self {
            _ if self.holds(value, limit) => value,
            Test::AtLeast | Test::AtMost | Test::Equal | Test::UpTo => limit,
            Test::Set => f64::from(bits | limit as u32),
            Test::Clear => f64::from(bits & !(limit as u32)),
        }
    }
}

/// The bits of a value; none: it has none.
pub fn mask(value: f64) -> Option<u32> {
    let bits = value as u32;
    (f64::from(bits) == value).then_some(bits)
}
