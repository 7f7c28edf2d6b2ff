//! Any bytes as a program: reading, finding the calls and changing each of their values must not panic,
//! and the source must stay as it is.
#![no_main]

use libfuzzer_sys::fuzz_target;
use probewright_core::catalogue::Dialect;
use probewright_core::program::{calls::calls, change, read};

fuzz_target!(|bytes: &[u8]| {
    for dialect in [Dialect::Sinumerik, Dialect::Nct] {
        let program = read(dialect, bytes);
        assert_eq!(program.source, bytes);
        for site in calls(&program) {
            for param in site.cycle.params {
                let edits = change::change(&program, &site, param.name, "1");
                change::apply(bytes, &edits);
            }
        }
    }
});
