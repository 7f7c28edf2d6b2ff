//! A program that shows mean value and weight at work, as the manual's table 1-2 does.

/// A hole of 50 mm with the differences of the table, measured with weight 3 for one tool and with 1 for another:
/// `_TZL` is that of the table (B:1265), the wider limits let all its differences go into the mean value.
pub const PROGRAM: &str = "\
G17 G54 G90 T9 D1 M6
G0 X0 Y0
Z-10
_CHBIT[4]=1 _PRNUM=1 _FA=2 _TSA=1 _VMS=0 _NMSP=1
_TUL=0.1 _TLL=-0.1 _TDIF=0.3 _TMV=0.08 _TZL=0.04
_MVAR=1 _SETVAL=50 _KNUM=2001
_K=3 _EVNUM=1 _TNUM=20
CYCLE977
_K=1 _EVNUM=2 _TNUM=21
CYCLE977
M30
";
