//! The correction target `_KNUM` (B:1894-2029).

use crate::control::{Control, Store};

/// Which quantity of the tool is corrected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The length that works in the measuring axis.
    MeasuringAxis,
    /// The radius.
    Radius,
    /// L1, L2 or L3 (1..3).
    Length(u8),
}

/// `_KNUM` of a tool offset, taken apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ToolCode {
    /// D number; 0 with `environment`: the D of the environment.
    pub edge: i64,
    /// What is corrected.
    pub quantity: Quantity,
    /// The sign of the correction is turned round.
    pub inverted: bool,
    /// The setup or additive offset `_DLNUM` instead of the tool's own length and radius.
    pub location: bool,
    /// The tool environment `_TENV` decides the tool.
    pub environment: bool,
}

/// Whether D numbers take five digits and all others move by two (B:2009-2029).
pub fn five_digit_edges(control: &Control) -> bool {
    match control.number("MD18102") {
        1.0 => true,
        _ => control.number("MD18105") >= 1000.0,
    }
}

/// What one more counts in the digit behind the D number: digit 4, with five-digit D numbers digit 6.
const fn behind_edge(five_digit_edges: bool) -> i64 {
    if five_digit_edges { 100_000 } else { 1000 }
}

/// Cuts a tool offset code into digits, counted from the right (of five-digit D numbers two more): 1 to 3 D number;
/// 4 kind, 0 and 1 length, 2 radius; 5 sign, 1 inverts; 6 quantity, 0 by digit 4, 1 to 3 lengths, 4 radius; 7 and all
/// above it mode.
pub fn digits(code: i64, five_digit_edges: bool) -> [i64; 5] {
    let (edge, rest) = (code % behind_edge(five_digit_edges), code / behind_edge(five_digit_edges));
    [edge, rest % 10, rest / 10 % 10, rest / 100 % 10, rest / 1000]
}

/// Reads a tool offset code. None: 0, nothing is corrected.
///
/// # Errors
/// The number of the alarm: 61322 digit 4, 61323 digit 5, 61324 digit 6, 61407 digit 7 and above, 61328 D number 0.
pub fn tool(code: i64, five_digit_edges: bool) -> Result<Option<ToolCode>, u32> {
    if code == 0 {
        return Ok(None);
    }
    if code < 0 {
        return Err(61407);
    }
    let [edge, kind, inverted, quantity, mode] = digits(code, five_digit_edges);
    let by_kind = match kind {
        0 | 1 => Quantity::MeasuringAxis,
        2 => Quantity::Radius,
        _ => return Err(61322),
    };
    if inverted > 1 {
        return Err(61323);
    }
    let quantity = match quantity {
        0 => by_kind,
        number @ 1..=3 => Quantity::Length(number as u8),
        4 => Quantity::Radius,
        _ => return Err(61324),
    };
    if mode > 3 {
        return Err(61407);
    }
    let environment = mode >= 2;
    if edge == 0 && !environment {
        return Err(61328);
    }
    Ok(Some(ToolCode { edge, quantity, inverted: inverted == 1, location: mode % 2 == 1, environment }))
}

/// The shortest code of a tool offset.
pub fn tool_code(code: &ToolCode, five_digit_edges: bool) -> i64 {
    let (kind, quantity) = match code.quantity {
        Quantity::MeasuringAxis => (0, 0),
        Quantity::Radius => (2, 0),
        Quantity::Length(number) => (0, i64::from(number)),
    };
    let mode = i64::from(code.location) + 2 * i64::from(code.environment);
    let rest = kind + 10 * i64::from(code.inverted) + 100 * quantity + 1000 * mode;
    code.edge + rest * behind_edge(five_digit_edges)
}

/// `_KNUM` of a zero offset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ZeroCode {
    /// 1 to 99: G54 to G57, G505 to G599; 1011 to 1026: `$P_CHBFR[0..15]`; 1051 to 1066: `$P_NCBFR[0..15]`, which have
    /// no rotation; 2000: `$P_SETFR`.
    Stored(Store),
    /// 1000: the last active channel basic frame, calculated with G500.
    LastBasic,
    /// 9999: the active frame, and active at once.
    Active,
}

/// Reads a zero offset code. None: 0, nothing is corrected. Error: alarm 61321.
///
/// # Errors
/// The number of the alarm.
pub fn zero(code: i64) -> Result<Option<ZeroCode>, u32> {
    let index = |from: i64| usize::try_from(code - from).map_err(|_| 61321_u32);
    Ok(Some(match code {
        0 => return Ok(None),
        1..=99 => ZeroCode::Stored(Store::Settable(index(0)?)),
        1000 => ZeroCode::LastBasic,
        1011..=1026 => ZeroCode::Stored(Store::ChannelBasic(index(1011)?)),
        1051..=1066 => ZeroCode::Stored(Store::GlobalBasic(index(1051)?)),
        2000 => ZeroCode::Stored(Store::System),
        9999 => ZeroCode::Active,
        _ => return Err(61321),
    }))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn the_manuals_codes() {
        // oracle: manual B:1928, B:2104-2158
        let read = |code| tool(code, false).unwrap().unwrap();
        let plain = ToolCode {
            edge: 3,
            quantity: Quantity::MeasuringAxis,
            inverted: false,
            location: false,
            environment: false,
        };
        assert_eq!(read(12_003), ToolCode { quantity: Quantity::Radius, inverted: true, ..plain });
        assert_eq!(read(100_002), ToolCode { edge: 2, quantity: Quantity::Length(1), ..plain });
        assert_eq!(read(3), plain);
        assert_eq!(read(1_001_002), ToolCode { edge: 2, location: true, ..plain });
        assert_eq!(read(1_000_002), read(1_001_002));
        let environment = ToolCode { edge: 0, environment: true, ..plain };
        assert_eq!(read(2_100_000), ToolCode { quantity: Quantity::Length(1), ..environment });
        assert_eq!(read(2_001_002), ToolCode { edge: 2, ..environment });
        assert_eq!(read(3_001_002), ToolCode { edge: 2, location: true, ..environment });
        assert_eq!(read(2001), ToolCode { edge: 1, quantity: Quantity::Radius, ..plain });
        assert_eq!(tool(0, false), Ok(None));
    }

    #[test]
    fn five_digit_edges_move_the_others_by_two() {
        // oracle: manual B:2009-2029
        let code = tool(1_200_003, true).unwrap().unwrap();
        assert_eq!((code.edge, code.quantity, code.inverted), (3, Quantity::Radius, true));
        assert!(tool(100_100_002, true).unwrap().unwrap().location);
        assert_eq!(tool(10_000_002, true).unwrap().unwrap().quantity, Quantity::Length(1));
    }

    #[test]
    fn every_digit_has_its_alarm() {
        // oracle: manual A:15863-15871, A:15926
        assert_eq!(tool(3001, false), Err(61322));
        assert_eq!(tool(20_001, false), Err(61323));
        assert_eq!(tool(500_001, false), Err(61324));
        assert_eq!(tool(4_000_001, false), Err(61407));
        assert_eq!(tool(10_000_001, false), Err(61407));
        assert_eq!(tool(2000, false), Err(61328));
    }

    #[test]
    fn what_is_written_is_read() {
        // oracle: self
        for five in [false, true] {
            for code in [1, 2001, 12_003, 100_002, 300_009, 1_000_002, 2_100_001, 3_012_004] {
                if let Ok(Some(read)) = tool(code, five) {
                    assert_eq!(tool(tool_code(&read, five), five), Ok(Some(read)));
                }
            }
        }
    }

    #[test]
    fn zero_offset_numbers() {
        // oracle: manual B:1930-1965, A:15862
        assert_eq!(zero(0), Ok(None));
        assert_eq!(zero(5), Ok(Some(ZeroCode::Stored(Store::Settable(5)))));
        assert_eq!(zero(1026), Ok(Some(ZeroCode::Stored(Store::ChannelBasic(15)))));
        assert_eq!(zero(1066), Ok(Some(ZeroCode::Stored(Store::GlobalBasic(15)))));
        for wrong in [-1, 100, 1001, 1027, 1050, 1067, 2001, 99_999] {
            assert_eq!(zero(wrong), Err(61321));
        }
    }
}
