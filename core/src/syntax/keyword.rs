//! Reserved words of the SINUMERIK language, found without allocation.

/// Kinds of reserved words, by what may follow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Keyword {
    /// Stands alone: `ELSE`, `ENDIF`, `LOOP`, …
    Alone,
    /// A condition or an end value follows: `IF`, `WHILE`, `UNTIL`, `TO`, `CASE`, `WHEN`, …
    Value,
    /// A target follows: `GOTOF`, …
    Target,
    /// A target may follow: `REPEAT`, `REPEATB`.
    Repeat,
    /// A list may follow: `RET`.
    Return,
    For,
    Of,
    /// `DEF`, `REDEF`.
    Definition,
    /// `PROC`, `EXTERN`.
    Procedure,
    /// An operator with letters: `AND`, `DIV`, …; begins no word and no operand.
    Operator,
}

const LONGEST: usize = 8;

/// The reserved word that this name is, without regard to case.
pub(super) fn find(name: &[u8]) -> Option<Keyword> {
    if matches!(name, [b'_' | b'$', ..]) {
        return None; // as most data of the cycles begin, and no reserved word
    }
    let mut upper = [0; LONGEST];
    let upper = upper.get_mut(..name.len())?;
    upper.copy_from_slice(name);
    upper.make_ascii_uppercase();
    Some(match &*upper {
        b"ELSE" | b"ENDIF" | b"ENDWHILE" | b"ENDFOR" | b"LOOP" | b"ENDLOOP" | b"DEFAULT" | b"ENDPROC" | b"DO"
        | b"ENDLABEL" => Keyword::Alone,
        b"IF" | b"WHILE" | b"UNTIL" | b"TO" | b"CASE" | b"WHEN" | b"WHENEVER" | b"EVERY" | b"FROM" => Keyword::Value,
        b"GOTO" | b"GOTOF" | b"GOTOB" | b"GOTOC" => Keyword::Target,
        b"REPEAT" | b"REPEATB" => Keyword::Repeat,
        b"RET" => Keyword::Return,
        b"FOR" => Keyword::For,
        b"OF" => Keyword::Of,
        b"DEF" | b"REDEF" => Keyword::Definition,
        b"PROC" | b"EXTERN" => Keyword::Procedure,
        b"AND" | b"OR" | b"XOR" | b"NOT" | b"DIV" | b"MOD" | b"B_AND" | b"B_OR" | b"B_XOR" | b"B_NOT" => {
            Keyword::Operator
        }
        _ => return None,
    })
}

/// Types and attributes of a declaration.
pub(super) const TYPES: &[&[u8]] = &[
    b"REAL", b"INT", b"BOOL", b"STRING", b"FRAME", b"AXIS", b"CHAR", b"NCK", b"CHAN", b"VAR", b"SYNR", b"SYNW",
    b"SYNRW", b"PRLOC", b"INIPO", b"INIRE", b"INICF", b"DCM", b"DCI", b"DCU",
];
/// Attributes of a declaration with a number behind them (Job planning, user data): physical unit, limits, protection
/// levels of reading and writing.
pub(super) const MEASURED: &[&[u8]] =
    &[b"PHU", b"LLI", b"ULI", b"APR", b"APW", b"APRP", b"APWP", b"APRB", b"APWB", b"APX"];
/// Addresses of several letters; any other name before `=` is a variable.
pub(super) const ADDRESSES: &[&[u8]] = &[
    b"AP", b"RP", b"AR", b"CR", b"IR", b"JR", b"KR", b"SPOS", b"SPOSA", b"CHF", b"CHR", b"RND", b"RNDM", b"PW", b"SD",
    b"PL", b"ANG", b"TURN", b"DL", b"FRC", b"FRCM", b"FAD", b"FB", b"FD", b"SF", b"DISR", b"DISCL", b"CT",
];
/// Words that stand with the name of an axis and nothing else: `FINEA[X]`, how a motion ends; `DIAMONA[X]`, how its
/// positions are written (840D sl, Fundamentals, "Axis-specific diameter/radius programming").
pub(super) const OF_AXIS: &[&[u8]] = &[
    b"FINEA", b"COARSEA", b"IPOENDA", b"DRIVEA", b"IPOBRKA", b"ADISPOSA", b"DIAMONA", b"DIAM90A", b"DIAMOFA",
    b"DIAMCHANA",
];
/// Kinds of dimension that stand around a value: `X=IC(5)`.
pub(super) const MODES: &[&[u8]] =
    &[b"AC", b"IC", b"DC", b"ACP", b"ACN", b"CAC", b"CIC", b"CDC", b"CACP", b"CACN", b"DAC", b"DIC", b"RAC", b"RIC"];

/// Whether a name is one of these, without regard to case.
pub(super) fn is_one_of(name: &[u8], list: &[&[u8]]) -> bool {
    list.iter().any(|known| name.eq_ignore_ascii_case(known))
}
