//! Words of the language and cycles of the control that leave alone what is followed: plane, compensation, zero offset,
//! diameters, spindle, tool. Any other name that stands alone or takes arguments may be a program of the user.

use super::keyword;

/// In the order of the alphabet.
const WORDS: [&str; 348] = [
    "ACCLIMA", "ACTBLOCNO", "ADDFRAME", "ADISPOSA", "AROTS", "ASPLINE", "AUXFUDEL", "AUXFUDELG", "AUXFUMSEQ",
    "AUXFUSYNC", "AXTOCHAN", "BLOCK", "BLSYNC", "CADAPTOF", "CADAPTON", "CALCDAT", "CALCPOSI", "CALLPATH", "CANCEL",
    "CANCELSUB", "CDOF", "CDOF2", "CDON", "CHANDATA", "CHKDM", "CLEARM", "CLGOF", "CLGON", "CLRINT", "COARSEA",
    "COLLPAIR", "COMPCAD", "COMPCURV", "COMPON", "COMPPATH", "COMPSURF", "CONTDCON", "CONTPRON", "CORRTC", "CORRTRAFO",
    "COUPDEF", "COUPDEL", "COUPOF", "COUPOFS", "COUPON", "COUPONC", "COUPRES", "CP", "CPROT", "CPROTDEF", "CROTS",
    "CTABDEF", "CTABDEL", "CTABEND", "CTABLOCK", "CTABUNLOCK", "CUT2D", "CUT2DD", "CUT2DF", "CUT2DFD", "CUT3DC",
    "CUT3DCC", "CUT3DCCD", "CUT3DCD", "CUT3DF", "CUT3DFD", "CUT3DFF", "CUT3DFS", "CUTCONOF", "CUTCONON", "CUTMOD",
    "CUTMODK", "DELAYFSTOF", "DELAYFSTON", "DELDL", "DELETE", "DELMLOWNER", "DELMLRES", "DELMT", "DELOBJ", "DELT",
    "DELTC", "DELTOOLENV", "DISABLE", "DRFOF", "DYNFINISH", "DYNNORM", "DYNPOS", "DYNPREC", "DYNROUGH", "DYNSEMIFIN",
    "DZERO", "EGDEF", "EGDEL", "EGOFC", "EGOFS", "EGON", "EGONSYN", "EGONSYNE", "ENABLE", "EXECSTRING", "EXECTAB",
    "EXECUTE", "EXTCLOSE", "EXTOPEN", "EXTWRITE", "FCUB", "FENDNORM", "FGREF", "FGROUP", "FILEDATE", "FILEINFO",
    "FILESIZE", "FILESTAT", "FILETIME", "FINEA", "FLIM", "FLIN", "FOC", "FOCOF", "FOCON", "FPR", "FPRAOF", "FPRAON",
    "FTOCOF", "FTOCON", "FXS", "FXST", "FXSW", "GEOAX", "GET", "GETD", "GETEXET", "GETFREELOC", "GETSELT", "GETTCOR",
    "GETTENV", "GROUP_BEGIN", "GROUP_END", "GWPSOF", "GWPSON", "HOLES1", "HOLES2", "ICYCOF", "ICYCON", "INIT",
    "INTERSEC", "INVCCW", "INVCW", "IPOBRKA", "IPOENDA", "IPTRLOCK", "IPTRUNLOCK", "ISOCALL", "JERKLIM", "LEADOF",
    "LEADON", "LENTOAX", "LFOF", "LFON", "LFPOS", "LFTXT", "LFWP", "LIFTFAST", "LOCK", "LONGHOLE", "MASLDEF",
    "MASLDEL", "MASLOF", "MASLOFS", "MASLON", "MEAFRAME", "MMC", "MODAXVAL", "MOVT", "MVTOOL", "NEWCONF", "NPROT",
    "NPROTDEF", "ORIAXES", "ORIAXPOS", "ORIC", "ORICONCCW", "ORICONCW", "ORICONIO", "ORICONTO", "ORICURVE", "ORID",
    "ORIEULER", "ORIMKS", "ORIPATH", "ORIPATHS", "ORIPLANE", "ORIRESET", "ORIROTA", "ORIROTC", "ORIROTR", "ORIROTT",
    "ORIRPY", "ORIRPY2", "ORIS", "ORISOF", "ORISOLH", "ORISON", "ORIVECT", "ORIVIRT1", "ORIVIRT2", "ORIWKS", "OSC",
    "OSD", "OSOF", "OSS", "OSSE", "OST", "OVRA", "PAROT", "PAROTOF", "PDELAYOF", "PDELAYON", "POCKET1", "POCKET2",
    "POCKET3", "POCKET4", "POLF", "POLFA", "POLFMASK", "POLFMLIN", "POLY", "PON", "PONS", "POSM", "POSMT", "PREPRO",
    "PRESETON", "PROTA", "PROTD", "PROTS", "PTP", "PTPG0", "PTPWOC", "PUTFTOC", "PUTFTOCF", "RDISABLE", "READ",
    "RELEASE", "REPOSA", "REPOSH", "REPOSHA", "REPOSL", "REPOSQ", "REPOSQA", "RESET", "RESETMON", "RMB", "RMBBL",
    "RME", "RMEBL", "RMI", "RMIBL", "RMN", "RMNBL", "ROTS", "SETINT", "SETM", "SETMS", "SETMTH", "SETPIECE", "SETTA",
    "SETTCOR", "SETTIA", "SIRELAY", "SLOT1", "SLOT2", "SON", "SONS", "SPCOF", "SPCON", "SPIF1", "SPIF2", "SPLINEPATH",
    "SPOF", "START", "STOPREOF", "SYNCT", "SYNFCT", "TANG", "TANGDEL", "TANGOF", "TANGON", "TCA", "TCI", "TCOABS",
    "TCOFR", "TCOFRX", "TCOFRY", "TCOFRZ", "TMMON", "TMOF", "TMON", "TOFFOF", "TOFFON", "TOFRAME", "TOFRAMEX",
    "TOFRAMEY", "TOFRAMEZ", "TOROT", "TOROTOF", "TOROTX", "TOROTY", "TOROTZ", "TOWBCS", "TOWKCS", "TOWMCS", "TOWSTD",
    "TOWTCS", "TOWWCS", "TRAANG", "TRACON", "TRACYL", "TRAFOOF", "TRAFOON", "TRAILOF", "TRAILON", "TRANSMIT", "TRAORI",
    "UNLOCK", "VELOLIMA", "WAITC", "WAITE", "WAITENC", "WAITM", "WAITMC", "WAITP", "WAITS", "WALCS0", "WALCS1",
    "WALCS10", "WALCS2", "WALCS3", "WALCS4", "WALCS5", "WALCS6", "WALCS7", "WALCS8", "WALCS9", "WORKPIECE", "WRITE",
    "WRTPR",
];

/// Whether a name is such a word.
pub fn is_word(name: &str) -> bool {
    WORDS.binary_search(&name).is_ok()
}

// oracle: self (it is searched as a sorted list)
#[test]
fn words_are_sorted() {
    assert!(WORDS.is_sorted());
    assert!(is_word("CUT2D") && !is_word("MEASURE"));
}

/// Functions and constants of expressions.
const IN_EXPRESSIONS: [&str; 46] = [
    "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "ATAN2", "SQRT", "ABS", "POT", "TRUNC", "ROUND", "ROUNDUP", "LN",
    "EXP", "MINVAL", "MAXVAL", "BOUND", "PI", "TRUE", "FALSE", "SET", "REP", "STRLEN", "SUBSTR", "INDEX", "RINDEX",
    "MINDEX", "MATCH", "TOUPPER", "TOLOWER", "NUMBER", "ISNUMBER", "AXNAME", "AXSTRING", "SPRINT", "ISVAR", "ISAXIS",
    "GETT", "CTRANS", "CFINE", "CROT", "CSCALE", "CMIRROR", "CRPL", "INVFRAME",
];

/// Whether an expression may call it, or it is a constant of one.
pub fn is_function(name: &str) -> bool {
    IN_EXPRESSIONS.contains(&name)
}

/// Whether a name is reserved: no label and no program can have it. In upper case.
pub fn is_reserved(name: &str) -> bool {
    let bytes = name.as_bytes();
    let lists = [keyword::TYPES, keyword::MEASURED, keyword::ADDRESSES, keyword::OF_AXIS, keyword::MODES];
    keyword::find(bytes).is_some()
        || lists.iter().any(|list| keyword::is_one_of(bytes, list))
        || is_function(name)
        || MANNERS.contains(&name)
        || is_word(name)
}

// oracle: self (what an expression calculates has a reserved name; FIX and FUP are of the other language)
#[test]
fn functions_are_reserved() {
    for name in ["SIN", "ATAN2", "MAXVAL", "BOUND", "POT"] {
        let some = (1..4).any(|count| super::arithmetic::function(name, &vec![0.5; count]).is_some());
        assert!(some && is_reserved(name), "{name}");
    }
    assert!(!is_reserved("MEASURE") && !is_reserved("SINGLE"));
}

/// `CALL "NAME"`: calls the program that a text names.
pub const CALL: &str = "CALL";
/// `MCALL NAME(…)`: from now on after each block of this program that moves; alone: no longer.
pub const MODAL: &str = "MCALL";
/// `PCALL NAME`: as by its name; reading steps over the folders of a path.
pub const BY_PATH: &str = "PCALL";
/// `EXTCALL("NAME")`: from another memory, where that text has it.
pub const FROM_OUTSIDE: &str = "EXTCALL";
/// What is followed by a text that names the program.
pub const BY_TEXT: [&str; 2] = [CALL, FROM_OUTSIDE];
/// Words before the name of a program that say how it is called.
pub const MANNERS: [&str; 4] = [CALL, BY_PATH, MODAL, FROM_OUTSIDE];
