//! The questions: JSON text in, JSON text out.

use serde_json::{Map, Value, json};

/// The answer to a question: JSON text, or the sentence of an error.
pub type Told = Result<String, String>;

/// A function that takes a question.
pub type Question = fn(&str) -> Told;

/// One who answers: the core itself, or its bindings.
pub struct Seam {
    /// `Catalogue`.
    pub catalogue: fn() -> String,
    /// `AlarmInfo[]`.
    pub alarms: fn() -> String,
    /// `FormRequest` → `FormView`.
    pub form: Question,
    /// `HelpRequest` → `HelpView`.
    pub help: Question,
    /// `MachineRequest` → `MachineView`.
    pub machine: Question,
    /// `EquipRequest` → `EquipView`.
    pub equip: Question,
    /// `FormRequest` → `Story`.
    pub story: Question,
    /// `ReadRequest` → `ReadView`.
    pub read: Question,
    /// `ChangeRequest` → `Changed`.
    pub change: Question,
    /// `ConvertRequest` → `Converted`.
    pub convert: Question,
    /// `CureRequest` → `CuredAll`.
    pub cure: Question,
    /// `RunRequest` → `RunView`.
    pub run: Question,
    /// `NoteRequest` → `Scenario`.
    pub note: Question,
    /// `PointedRequest` → `PointedView`, or null.
    pub pointed: Question,
    /// Text of a scenario file → `ScenarioView`.
    pub scenario: Question,
    /// Text of a setup file → `Setup`.
    pub setup: Question,
    /// Bytes of a file → `Recognised`.
    pub recognise: fn(&[u8]) -> String,
    /// `FormRequest` → what is to be seen of the call.
    pub seen: fn(&str) -> Result<Seen, String>,
    /// `ScanRequest` and the bytes of a file → `ScanView`, the points sent, their turns, and the program.
    pub scan: fn(&str, &[u8]) -> Result<Scanned, String>,
}

/// What is to be seen, with its typed arrays by name; of a call that is not carried out nothing.
#[derive(Default)]
pub struct Seen {
    /// `SceneView`.
    pub view: String,
    /// Numbers of each array.
    pub arrays: Vec<(&'static str, Vec<f64>)>,
}

/// The numbers of an array.
pub fn numbers<T: Copy + Into<f64>>(array: &[T]) -> Vec<f64> {
    array.iter().map(|number| (*number).into()).collect()
}

/// What a scan hands over, the points as typed arrays.
pub struct Scanned {
    /// `ScanView`.
    pub view: String,
    /// Four numbers a point.
    pub cloud: Vec<f32>,
    /// The turn of each point.
    pub turns: Vec<u32>,
    /// The program that is sent.
    pub program: String,
}

/// What came back, by name of the question.
pub type Answers = Map<String, Value>;

/// The cycles of the catalogue.
pub fn cycles(seam: &Seam) -> Vec<Value> {
    let catalogue = read_value(Ok((seam.catalogue)()));
    catalogue["cycles"].as_array().cloned().unwrap_or_default()
}

/// What is told at each place of an argument of a list, of a parameter of a control that is read and not run, and where
/// there is nothing to tell.
fn pointed(seam: &Seam, control: &str) -> Value {
    let all = cycles(seam);
    let names = all.iter().filter(|one| one["control"] == control).filter_map(|one| one["cycle"].as_str());
    let lists = names.map(|name| format!("N10 MSG(\"ü𝄞\") {name}(101,,,1,50)"));
    let lines = lists.chain(["  Q262=+12 ;NOMINAL DIAMETER ~", "G1 X5"].map(str::to_owned));
    let of_line = |line: String| {
        let places = 0..=line.encode_utf16().count();
        let asked = places.map(|at| json!({ "control": control, "line": line, "at": at }).to_string());
        Value::Array(asked.map(|asked| read_value((seam.pointed)(&asked))).collect())
    };
    Value::Array(lines.map(of_line).collect())
}

/// What is asked about no cycle.
pub fn beside(seam: &Seam, told: &mut Answers) {
    told.insert("catalogue".into(), read_value(Ok((seam.catalogue)())));
    told.insert("alarms".into(), read_value(Ok((seam.alarms)())));
    for control in ["sinumerik", "nct"] {
        let add = json!({ "control": control, "change": { "add": { "table": "tools", "row": "" } } });
        told.insert(format!("equip {control}"), read_value((seam.equip)(&add.to_string())));
        told.insert(format!("pointed {control}"), pointed(seam, control));
        let run = json!({ "control": control, "text": "G0 X10\nG1 X20 F100\nM30\n" });
        let noted = (seam.note)(&json!({ "run": run, "name": "part.mpf", "case": "first" }).to_string());
        let carried_out = noted.clone().and_then(|text| (seam.scenario)(&text));
        told.insert(format!("note {control}"), read_value(noted));
        told.insert(format!("scenario {control}"), read_value(carried_out));
    }
    wrong(seam, told);
    bytes(seam, told);
}

/// Of each variant the form and its help, then the way of a call: read back, written otherwise, changed, run.
pub fn of_cycle(seam: &Seam, cycle: &Value, told: &mut Answers) {
    let (control, name) = (&cycle["control"], cycle["cycle"].as_str().unwrap_or_default());
    for variant in cycle["variants"].as_array().into_iter().flatten() {
        let mut values = variant["values"].as_object().cloned().unwrap_or_default();
        values.extend(variant["example"].as_object().cloned().unwrap_or_default());
        let mvar = &variant["mvar"];
        let mut keep = |what: &str, answer: Value| {
            told.insert(format!("{name} {mvar} {what}"), answer);
        };
        let plane = cycle["purpose"]["plane"].as_str().filter(|_| control == "sinumerik").unwrap_or("G17");
        let form = json!({ "control": control, "cycle": name, "values": values, "plane": plane, "predict": true,
            "twin": true });
        keep("seen", seen(seam, &form));
        keep("story", read_value((seam.story)(&form.to_string())));
        let form = read_value((seam.form)(&form.to_string()));
        keep("help", read_value((seam.help)(&json!({ "control": control, "cycle": name, "mvar": mvar }).to_string())));
        let end = if control == "nct" { "M30\n%\n" } else { "M30\n" };
        let begin = if control == "nct" { "%\n" } else { "" };
        let text = format!("{begin}{plane}\n{}{end}", form["snippet"].as_str().unwrap_or_default());
        let setup = form["setup"].clone();
        keep("form", form);
        if cycle["surfaces"].as_array().is_some_and(|surfaces| !surfaces.is_empty()) {
            let question = json!({ "control": control, "cycle": name, "values": values, "setup": setup });
            keep("scan", scanned(seam, &question));
        }
        for (what, answer) in of_program(seam, control, text, setup) {
            keep(what, answer);
        }
    }
}

/// A program with one call: what is read in it, what it is in another call style, how its first number is changed,
/// and what it does then.
fn of_program(seam: &Seam, control: &Value, text: String, setup: Value) -> Vec<(&'static str, Value)> {
    let question = |more: Value| {
        let mut question = json!({ "control": control, "text": text, "setup": setup });
        if let (Some(all), Value::Object(more)) = (question.as_object_mut(), more) {
            all.extend(more);
        }
        question.to_string()
    };
    let read = read_value((seam.read)(&question(json!({}))));
    let convert = read_value((seam.convert)(&question(json!({ "call": 0, "style": "direct" }))));
    let all = read_value((seam.convert)(&question(json!({ "style": "operate" }))));
    let found = &read["diagnostics"][0];
    let cure = read_value((seam.cure)(&question(json!({ "code": found["code"], "key": found["message"]["key"] }))));
    let values = read["calls"][0]["values"].as_object();
    let number = values.into_iter().flatten().find_map(|(name, value)| {
        let number: f64 = value.as_str()?.parse().ok().filter(|number: &f64| number.fract() != 0.0)?;
        Some((name, number))
    });
    let (name, value) = number.map_or(("?", "4".to_owned()), |(name, number)| (name, format!("{}", number + 0.125)));
    let change = read_value((seam.change)(&question(json!({ "call": 0, "name": name, "value": value }))));
    let changed = changed(&text, &change);
    let run = json!({ "control": control, "text": changed, "setup": setup });
    let run = read_value((seam.run)(&run.to_string()));
    let text = changed.into();
    let converted = [("convert", convert), ("all", all), ("cure", cure)];
    [("read", read), ("change", change), ("text", text), ("run", run)].into_iter().chain(converted).collect()
}

/// The text behind the steps of a change. All of it is ASCII here, so that units of UTF-16 are bytes.
fn changed(text: &str, change: &Value) -> String {
    let mut text = text.to_owned();
    for step in change["steps"].as_array().into_iter().flatten() {
        let mut edits: Vec<&Value> = step.as_array().into_iter().flatten().collect();
        // what is inserted where another edit begins stands before it
        edits.sort_by_key(|edit| (edit["from"].as_u64(), edit["to"].as_u64()));
        for edit in edits.into_iter().rev() {
            let place = |name: &str| edit[name].as_u64().map_or(0, |at| at as usize).min(text.len());
            text.replace_range(place("from")..place("to"), edit["insert"].as_str().unwrap_or_default());
        }
    }
    text
}

/// Questions of the wrong shape, about what is not there, and with numbers that are none: each answer is a sentence or
/// a document, never a broken module.
fn wrong(seam: &Seam, told: &mut Answers) {
    let asked: [(&str, Question); 14] = [
        ("form", seam.form),
        ("help", seam.help),
        ("machine", seam.machine),
        ("equip", seam.equip),
        ("story", seam.story),
        ("read", seam.read),
        ("change", seam.change),
        ("convert", seam.convert),
        ("cure", seam.cure),
        ("run", seam.run),
        ("note", seam.note),
        ("pointed", seam.pointed),
        ("scenario", seam.scenario),
        ("setup", seam.setup),
    ];
    let questions = [
        String::new(),
        "{".to_owned(),
        "[]".to_owned(),
        "{}".to_owned(),
        "\u{0}\u{fffd}".to_owned(),
        json!({ "control": "fanuc", "cycle": "?", "values": {}, "text": "", "mvar": 1, "call": 0 }).to_string(),
        json!({ "control": "sinumerik", "cycle": "?", "values": {}, "text": "\u{7}", "mvar": -1, "call": 9, "name": "?",
            "value": "", "style": "?" })
        .to_string(),
        odd(seam, "sinumerik", "1e999"),
        odd(seam, "nct", "="),
    ];
    for (name, function) in asked {
        for (index, question) in questions.iter().enumerate() {
            told.insert(format!("{name} of wrong question {index}"), read_value(function(question)));
        }
    }
}

/// A question about the first cycle of a control with this text at each of its parameters, in the form and in a
/// program, on a machine whose probe is none.
fn odd(seam: &Seam, control: &str, value: &str) -> String {
    let cycles = cycles(seam);
    let cycle = cycles.iter().find(|cycle| cycle["control"] == control).unwrap_or(&Value::Null);
    let params = cycle["parameters"].as_array().into_iter().flatten();
    let names: Vec<&str> = params.filter_map(|param| param["name"].as_str()).collect();
    let values: Map<String, Value> = names.iter().map(|name| ((*name).to_owned(), value.into())).collect();
    let words: Vec<String> = names.iter().map(|name| format!("{name}={value}")).collect();
    let text = format!("{} {}", words.join(" "), cycle["cycle"].as_str().unwrap_or_default());
    json!({ "control": control, "cycle": cycle["cycle"], "values": values, "text": text, "mvar": 1, "call": 0,
        "name": names.first(), "value": value, "style": "direct", "predict": true,
        "setup": { "control": control, "probe": 1 } })
    .to_string()
}

/// What goes in as bytes or comes back as numbers.
fn bytes(seam: &Seam, told: &mut Answers) {
    let files: [&[u8]; 5] = [
        b"", b"%_N_A_MPF\nG0 X1\n", b"\xef\xbb\xbfG0 ; \xc3\xa4\n", b"; Gr\xf6\xdfe\nG0 X1\n",
        b"PK\x03\x04\x00\x00\xff",
    ];
    for (index, file) in files.into_iter().enumerate() {
        told.insert(format!("recognised {index}"), read_value(Ok((seam.recognise)(file))));
    }
    let file = r#"{ "control": "nct", "probe": { "radius": 3, "length": 50 } }"#;
    told.insert("setup".into(), read_value((seam.setup)(file)));
    let refused = (seam.scan)("{", b"solid").map(|scanned| scanned.view);
    told.insert("scan of a wrong question".into(), read_value(refused));
}

/// Into how many pieces a typed array is taken; of each the mean is compared. A short one is compared number by number.
const PIECES: usize = 256;

/// What is to be seen of a call: what the arrays are, how long each is, and the mean of each piece of it.
fn seen(seam: &Seam, question: &Value) -> Value {
    let seen = (seam.seen)(&question.to_string()).map(|Seen { view, arrays }| {
        let view = if view.is_empty() { Value::Null } else { read_value(Ok(view)) };
        let array = |(name, numbers): (&str, Vec<f64>)| {
            let pieces = numbers.chunks(numbers.len().div_ceil(PIECES).max(1));
            let means: Vec<f64> = pieces.map(|piece| piece.iter().sum::<f64>() / piece.len() as f64).collect();
            (name.to_owned(), json!({ "length": numbers.len(), "means": means }))
        };
        json!({ "view": view, "arrays": arrays.into_iter().map(array).collect::<Map<_, _>>() }).to_string()
    });
    read_value(seen)
}

/// What a scan hands over: its view, and the points as typed arrays.
fn scanned(seam: &Seam, question: &Value) -> Value {
    let scanned = (seam.scan)(&question.to_string(), b"").map(|scanned| {
        let view = read_value(Ok(scanned.view));
        json!({ "view": view, "cloud": scanned.cloud, "turns": scanned.turns, "program": scanned.program }).to_string()
    });
    read_value(scanned)
}

/// An answer as a document; an error as `{ "error": sentence }`.
fn read_value(told: Told) -> Value {
    match told {
        Ok(text) => serde_json::from_str(&text).unwrap_or_else(|error| json!({ "no JSON": error.to_string() })),
        Err(error) => json!({ "error": error }),
    }
}
