//! Runs in headless Chromium: what the module answers there is what the core answers natively.
#![cfg(target_arch = "wasm32")]
#![allow(clippy::unwrap_used)]

use probewright_seam::ask::{Answers, Scanned, Seam, Seen, Told, beside, cycles, numbers, of_cycle};
use probewright_seam::same::{SAME, SINGLE, difference};
use probewright_web as web;
use serde_json::Value;
use wasm_bindgen::{JsCast, JsError, JsValue};
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

/// The sentence of an exception.
fn sentence(error: JsError) -> String {
    js_sys::Error::from(JsValue::from(error)).message().into()
}

macro_rules! answered {
    ($function:path) => {
        |question| -> Told { $function(question).map_err(sentence) }
    };
}

/// The numbers of a view on the memory of the module, as the page takes them: out of it first, as it may move.
macro_rules! copied {
    ($view:expr) => {
        numbers(&$view.slice(0, u32::MAX).to_vec())
    };
}

const BROWSER: Seam = Seam {
    catalogue: web::catalogue,
    alarms: web::alarms,
    form: answered!(web::form),
    help: answered!(web::help),
    machine: answered!(web::machine),
    equip: answered!(web::equip),
    story: answered!(web::story),
    read: answered!(web::read),
    change: answered!(web::change),
    convert: answered!(web::convert),
    cure: answered!(web::cure),
    run: |question| {
        let mut run = web::Run::new(question).map_err(sentence)?;
        while !run.advance(500) {}
        Ok(run.view())
    },
    note: answered!(web::note),
    pointed: answered!(web::pointed),
    scenario: |text| web::scenario(text, "[]").map_err(sentence),
    setup: answered!(web::setup),
    recognise: |bytes| {
        let mut recogniser = web::Recogniser::new();
        recogniser.take(bytes);
        recogniser.finish()
    },
    seen: |question| {
        let Some(scene) = web::form_seen(question).map_err(sentence)?.scene(1.0) else {
            return Ok(Seen::default());
        };
        let arrays = vec![
            ("vertices", copied!(scene.vertices())),
            ("corners", copied!(scene.corners())),
            ("lines", copied!(scene.lines())),
            ("ways", copied!(scene.ways())),
            ("wayEntries", copied!(scene.way_entries())),
            ("wayKinds", copied!(scene.way_kinds())),
            ("touches", copied!(scene.touches())),
            ("touchEntries", copied!(scene.touch_entries())),
            ("touchSorts", copied!(scene.touch_sorts())),
            ("stands", copied!(scene.stands())),
            ("begins", copied!(scene.begins())),
        ];
        Ok(Seen { view: scene.view(), arrays })
    },
    scan: |question, file| {
        let mut scan = web::Scan::new(question, file).map_err(sentence)?;
        while !scan.advance(500) {}
        let turns = scan.turns();
        let points = turns.len() as u32;
        let program = scan.text("program", 0, points).map_err(sentence)?;
        Ok(Scanned { view: scan.view(), cloud: scan.cloud(false, 0, points), turns, program })
    },
};

// oracle: self (Cargo.toml)
#[wasm_bindgen_test]
fn version_is_that_of_the_workspace() {
    assert_eq!(web::version(), env!("CARGO_PKG_VERSION"));
}

/// Everything that is asked, with turns for the browser in between.
async fn asked() -> Answers {
    let mut told = Answers::new();
    beside(&BROWSER, &mut told);
    for cycle in cycles(&BROWSER) {
        let turn = js_sys::Promise::new(&mut |resolve, _| {
            let scope = js_sys::global().unchecked_into::<web_sys::Window>();
            scope.set_timeout_with_callback(&resolve).unwrap();
        });
        wasm_bindgen_futures::JsFuture::from(turn).await.unwrap();
        of_cycle(&BROWSER, &cycle, &mut told);
    }
    told
}

// oracle: peer (the same questions to the core as it runs natively, asked when this test was built)
#[wasm_bindgen_test]
async fn the_browser_is_told_what_the_core_says() {
    let native: Value = serde_json::from_str(include_str!(concat!(env!("OUT_DIR"), "/native.json"))).unwrap();
    let native = native.as_object().unwrap();
    let told = asked().await;
    assert_eq!(native.keys().collect::<Vec<_>>(), told.keys().collect::<Vec<_>>());
    let near = |name: &str| if name.ends_with(" seen") { SINGLE } else { SAME };
    let differs = |(name, answer): (&String, &Value)| difference(answer, &told[name], name, near(name));
    let differences: Vec<String> = native.iter().filter_map(differs).take(5).collect();
    assert!(differences.is_empty(), "{differences:#?}");
    calls_come_back(&told);
    wrong_questions_are_refused(&told);
}

/// A snippet is a call of its cycle, which can be changed and runs; a scan hands over its points.
fn calls_come_back(told: &Answers) {
    let named = |end: &'static str| told.iter().filter(move |(name, _)| name.ends_with(end));
    assert!(named(" run").count() > 100, "{} variants", named(" run").count());
    for (name, read) in named(" read") {
        let calls = read["calls"].as_array().unwrap().iter();
        let called: Vec<&str> = calls.filter_map(|call| call["cycle"].as_str()).collect();
        assert!(matches!(called[..], [cycle] if name.starts_with(&format!("{cycle} "))), "{name}: {called:?}");
    }
    for (name, change) in named(" change") {
        assert!(change["steps"].is_array(), "{name}: {change}");
    }
    for (name, run) in named(" run") {
        assert!(run["trace"].is_object(), "{name}: {run}");
    }
    let seen = |(_, seen): &(&String, &Value)| seen["arrays"]["vertices"]["length"].as_u64() > Some(0);
    assert!(named(" seen").filter(seen).count() > 100, "{} scenes", named(" seen").filter(seen).count());
    for (name, scan) in named(" scan") {
        let (points, cloud) = (scan["turns"].as_array().unwrap(), scan["cloud"].as_array().unwrap());
        assert_eq!(cloud.len(), 4 * points.len(), "{name}");
        assert!(points.len() > 20, "{name}: {} points", points.len());
    }
}

fn wrong_questions_are_refused(told: &Answers) {
    let refused =
        told.iter().filter(|(name, _)| name.ends_with("wrong question 1") || name.ends_with("a wrong question"));
    for (name, answer) in refused {
        assert!(answer["error"].as_str().is_some_and(|sentence| sentence.len() > 8), "{name}: {answer}");
    }
}
