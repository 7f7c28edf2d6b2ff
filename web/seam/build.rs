//! Asks the core as it runs natively, and keeps what it says for the tests in the browser.
#![allow(clippy::unwrap_used)] // a build that cannot write its output ends

#[path = "src/ask.rs"]
mod ask;

use ask::{Answers, Scanned, Seam, Seen, beside, cycles, numbers, of_cycle};
use probewright_core::scene::Scene;
use probewright_core::{app, encoding, json};
use std::path::Path;

macro_rules! answered {
    ($ask:expr) => {
        |question| json::answer(question, $ask).map_err(|error| error.to_string())
    };
}

const CORE: Seam = Seam {
    catalogue: || json::text(&app::catalogue()),
    alarms: || json::text(&app::alarms()),
    form: answered!(app::form),
    help: answered!(app::help),
    machine: answered!(app::machine),
    equip: answered!(app::equip),
    story: answered!(app::story),
    read: answered!(|asked| app::read(asked, &mut |_| {})),
    change: answered!(app::change),
    convert: answered!(app::convert),
    cure: answered!(app::cure),
    run: |question| {
        let mut run = json::question(question).and_then(app::Run::new).map_err(|error| error.to_string())?;
        while !run.advance(500) {}
        Ok(json::text(&run.view()))
    },
    note: answered!(app::noted),
    pointed: answered!(|asked| Ok(app::pointed(&asked))),
    scenario: |text| {
        let scenario = json::file(text).map_err(|error| error.to_string())?;
        let view = app::scenario(app::ScenarioRequest { scenario, beside: None });
        Ok(json::text(&view.map_err(|error| json::positioned(error, text).to_string())?))
    },
    setup: |text| {
        let setup = json::setup_from_json(text).map_err(|error| error.to_string())?;
        Ok(json::text(&setup))
    },
    recognise: |bytes| {
        let mut recogniser = encoding::Recogniser::default();
        recogniser.take(bytes);
        json::text(&app::Recognised::of(recogniser.finish(), app::FileHead::of(bytes)))
    },
    seen: |question| {
        let view = json::question(question).and_then(app::form).map_err(|error| error.to_string())?;
        let Some(scene) = view.outcome.map(|outcome| Scene::of(&outcome.trace)) else {
            return Ok(Seen::default());
        };
        let arrays = vec![
            ("vertices", numbers(&scene.vertices)),
            ("corners", numbers(&scene.corners)),
            ("lines", numbers(&scene.lines)),
            ("ways", numbers(&scene.ways)),
            ("wayEntries", numbers(&scene.way_entries)),
            ("wayKinds", numbers(&scene.way_kinds)),
            ("touches", numbers(&scene.touches)),
            ("touchEntries", numbers(&scene.touch_entries)),
            ("touchSorts", numbers(&scene.touch_sorts)),
            ("stands", numbers(&scene.stands)),
            ("begins", numbers(&scene.begins)),
        ];
        Ok(Seen { view: json::text(&scene.view), arrays })
    },
    scan: |question, file| {
        let mut scan = json::question(question)
            .and_then(|asked| app::Scan::new(asked, file))
            .map_err(|error| error.to_string())?;
        while !scan.advance(500) {}
        let points = scan.turns().len();
        Ok(Scanned {
            view: json::text(&scan.view()),
            cloud: scan.cloud(false, 0..points),
            turns: scan.turns(),
            program: scan.text("program", 0, points).map_err(|error| error.to_string())?,
        })
    },
};

fn main() {
    println!("cargo::rerun-if-changed=src/ask.rs");
    let mut told = Answers::new();
    beside(&CORE, &mut told);
    cycles(&CORE).iter().for_each(|cycle| of_cycle(&CORE, cycle, &mut told));
    let told = serde_json::Value::Object(told);
    let out = std::env::var("OUT_DIR").unwrap();
    std::fs::write(Path::new(&out).join("native.json"), told.to_string()).unwrap();
}
