//! Reading a program of 10 MB (goal: 40 MB/s native), and finding its measuring calls.

use divan::Bencher;
use divan::counter::BytesCount;
use probewright_core::dialect::Dialect;
use probewright_core::program::calls;
use probewright_core::syntax::read;

fn main() {
    divan::main();
}

const SIZE: usize = 10_000_000;

/// Motion blocks with a measuring call now and then, as a CAM system with a measuring post writes them.
fn program(block: &str) -> Vec<u8> {
    let mut text = String::with_capacity(SIZE + 400);
    let mut number = 0;
    while text.len() < SIZE {
        for _ in 0..500 {
            number += 10;
            let place = f64::from(number % 9973) / 7.0;
            text.push_str(&format!("N{number} {block}X{place:.3} Y-{:.3} Z{:.4}\r\n", place / 3.0, place / 11.0));
        }
        text.push_str("; hole\n_TUL=0.03 _TLL=-0.03 _TZL=0.01 _TSA=1 _PRNUM=1 _VMS=0 _NMSP=1 _FA=1\n");
        text.push_str("_MVAR=1 _SETVAL=132 _TNUM=20 _KNUM=2001\nCYCLE977\nIF _OVR[16] > 0.05 GOTOF BAD_PART\n");
    }
    text.into_bytes()
}

#[divan::bench]
fn read_motions(bencher: Bencher) {
    let text = program("G1 F1200 ");
    bencher.counter(BytesCount::new(text.len())).bench(|| read(Dialect::Sinumerik, &text));
}

#[divan::bench]
fn read_assignments(bencher: Bencher) {
    let text = program("R1=R2*SIN(30) _TUL=0.03 _SETV[0]=5 ");
    bencher.counter(BytesCount::new(text.len())).bench(|| read(Dialect::Sinumerik, &text));
}

#[divan::bench]
fn read_nct(bencher: Bencher) {
    let text = program("G1 F1200 ");
    bencher.counter(BytesCount::new(text.len())).bench(|| read(Dialect::Nct, &text));
}

#[divan::bench]
fn find_calls(bencher: Bencher) {
    let tree = read(Dialect::Sinumerik, &program("G1 F1200 "));
    bencher.counter(BytesCount::new(tree.source.len())).bench(|| calls::calls(&tree));
}
