//! A surface scanned with a million points: the time of the scan, of the comparison with the true surface, and of the
//! texts. Printed once; a mean of several would say no more.

use probewright_core::catalogue::example::worked;
use probewright_core::catalogue::p9969::P9969;
use probewright_core::{app, json};
use serde_json::{Value, json as object};
use std::time::Instant;

/// Goal for everything, s.
const GOAL: f64 = 20.0;
/// Points a piece, as the page asks for them.
const PIECE: usize = 1000;

fn main() {
    let mut values: Value = worked(&P9969).into_iter().collect();
    values["Q"] = "1".into();
    values["R"] = "0.06".into();
    values["J"] = "0.04".into();
    let form = object!({ "control": "nct", "cycle": P9969.name,
        "values": worked(&P9969).into_iter().collect::<Value>(), "predict": true });
    let Ok(view) = json::answer(&form.to_string(), app::form) else {
        return;
    };
    let view: Value = serde_json::from_str(&view).unwrap_or_default();
    let request = object!({ "control": "nct", "cycle": P9969.name, "values": values, "setup": view["setup"] });
    let begun = Instant::now();
    let Ok(asked) = json::question(&request.to_string()) else {
        return;
    };
    let Ok(mut scan) = app::Scan::new(asked, &[]) else {
        return;
    };
    while !scan.advance(PIECE) {}
    let scanned = begun.elapsed().as_secs_f64();
    let points = scan.view().points;
    let texts = ["program", "points", "surface"].map(|form| scan.text(form, 0, points).map_or(0, |text| text.len()));
    let all = begun.elapsed().as_secs_f64();
    println!(
        "{points} points: scanned and compared in {scanned:.2} s; \
         with three texts of {texts:?} bytes {all:.2} s; goal {GOAL} s"
    );
}
