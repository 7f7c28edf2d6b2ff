//! The language server as an editor talks to it: the real process, over its standard input and output.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod asking;
mod client;
mod edits;
mod hostile;
mod settings;

/// The measured hole of the readme, with a variable, a label, a subprogram and comments.
const HOLE: &str = "N10 G54 G17 G90 T9 D1\nN20 M6\nN30 G0 X180 Y130\nR2=130\nSTART: N40 Z20\n\
    N50 _CHBIT[4]=1 ; Maß ü, see 61303 and PW135\n\
    N60 _TUL=0.1 _TLL=-0.1 _TZL=0.001 _TMV=0.02 _TDIF=0.2 _TSA=1 _FA=2\n\
    N61 _MVAR=1 _SETVAL=R2+2 _TNUM=20 _KNUM=2001\nN70 CYCLE977\nN75 L10\nN80 GOTOF START\nN90 M2\n\
    %_N_L10_SPF\n_MVAR=101 _SETVAL=5 _KNUM=1\nCYCLE977\nM17\n";

/// A hole without a tool to correct, and a word that nothing knows: findings with and without a cure.
const WRONG: &str = "N10 G54 G17 T9 D1\nN20 _MVAR=1 _SETVAL=132 _KNUM=2001\nN30 CYCLE977\nN40 _MVAR=1,5\nN50 M2\n";
