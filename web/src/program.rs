//! What programs need.

use crate::scene::Scene;
use crate::steps::Steps;
use probewright_core::scene::Source;
use probewright_core::{app, encoding, json};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsError, JsValue};

/// `AlarmInfo[]`: all alarms and messages.
#[wasm_bindgen]
#[must_use]
pub fn alarms() -> String {
    json::text(&app::alarms())
}

/// `Elsewhere[]`: what only newer controls and those of other makers have.
#[wasm_bindgen]
#[must_use]
pub fn elsewhere() -> String {
    json::text(&app::elsewhere())
}

/// `HelpRequest` → `HelpView`.
///
/// # Errors
/// A request of the wrong shape or an unknown cycle.
#[wasm_bindgen]
pub fn help(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::help)?)
}

/// `CommissioningView`.
#[wasm_bindgen]
#[must_use]
pub fn commissioning() -> String {
    json::text(&app::commissioning())
}

/// `CompatibilityRequest` → `CompatibilityView`.
///
/// # Errors
/// A request of the wrong shape, or a machine that cannot be.
#[wasm_bindgen]
pub fn compatibility(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::compatibility)?)
}

/// `TermsView`.
#[wasm_bindgen]
#[must_use]
pub fn terms() -> String {
    json::text(&app::terms())
}

/// `ConceptRequest` → `ConceptPicture`.
///
/// # Errors
/// A request of the wrong shape, or a concept without a picture.
#[wasm_bindgen]
pub fn concept_picture(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::concept_picture)?)
}

#[wasm_bindgen(inline_js = "
export function tell(share) {
  globalThis.dispatchEvent?.(new CustomEvent('probewright-progress', { detail: share }));
}")]
extern "C" {
    fn tell(share: f64);
}

/// `ReadRequest` → `ReadView`. A long program says on the way how far it is, as an event `probewright-progress` with
/// the share that is done.
///
/// # Errors
/// A request of the wrong shape.
#[wasm_bindgen]
pub fn read(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, |asked| app::read(asked, &mut |share| tell(share)))?)
}

/// `PointedRequest` → `PointedView | null`.
///
/// # Errors
/// A request of the wrong shape.
#[wasm_bindgen]
pub fn pointed(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, |asked| Ok(app::pointed(&asked)))?)
}

/// `ChangeRequest` → `Changed`.
///
/// # Errors
/// A request of the wrong shape or a call that is not there.
#[wasm_bindgen]
pub fn change(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::change)?)
}

/// `ConvertRequest` → `Converted`.
///
/// # Errors
/// A request of the wrong shape.
#[wasm_bindgen]
pub fn convert(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::convert)?)
}

/// `UnfitRequest` → `Unfit[]`.
///
/// # Errors
/// A request of the wrong shape, or an unknown cycle.
#[wasm_bindgen]
pub fn unfit(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::unfit)?)
}

/// `AroundRequest` → `AroundView`.
///
/// # Errors
/// A request of the wrong shape, an unknown cycle or a call that is not there.
#[wasm_bindgen]
pub fn around(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::around)?)
}

/// `CureRequest` → `CuredAll`.
///
/// # Errors
/// A request of the wrong shape.
#[wasm_bindgen]
pub fn cure(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::cure)?)
}

/// `CertaintyRequest` → `CertaintyView`: measures a thousand times, so it is asked on a thread of its own.
///
/// # Errors
/// A request of the wrong shape.
#[wasm_bindgen]
pub fn certainty(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::certainty)?)
}

/// `SeriesRequest` → `SeriesView`: runs a program many times, and says on the way how far it is, as `read` does.
///
/// # Errors
/// A request of the wrong shape, or a series that cannot be.
#[wasm_bindgen]
pub fn series(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, |asked| app::series_of(asked, &mut |share| tell(share)))?)
}

/// `WholeCertaintyRequest` → `WholeCertainty`: how certain each measurement of a program is; it says on the way how far
/// it is, as `read` does.
///
/// # Errors
/// A request of the wrong shape, or a machine that cannot be.
#[wasm_bindgen]
pub fn whole_certainty(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, |asked| app::certainty_of(asked, &mut |share| tell(share)))?)
}

/// `SeriesRequest` → `SeriesStart`: what its fields hold at first.
///
/// # Errors
/// A request of the wrong shape, or a machine that cannot be.
#[wasm_bindgen]
pub fn series_start(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::series_start)?)
}

/// An answer, and what is to be seen of it.
#[wasm_bindgen]
pub struct Answer {
    view: String,
    seen: Option<Source>,
}

#[wasm_bindgen]
impl Answer {
    /// The answer as JSON; asked for once.
    #[must_use]
    pub fn view(&mut self) -> String {
        std::mem::take(&mut self.view)
    }

    /// The steps of a run; none of any other answer, which has them in its view.
    #[must_use]
    pub fn steps(&self) -> Option<Steps> {
        self.seen.as_ref().filter(|seen| seen.apart).map(Steps::of)
    }

    /// What is to be seen, where something was carried out, with the errors of the part so many times as large.
    #[must_use]
    pub fn scene(&self, times: f64) -> Option<Scene> {
        self.seen.as_ref().map(|seen| probewright_core::scene::Scene::exaggerated(seen, times).into())
    }
}

/// `FormRequest` → `FormView`, and what is to be seen of the call.
///
/// # Errors
/// A request of the wrong shape or an unknown cycle.
#[wasm_bindgen]
pub fn form_seen(request: &str) -> Result<Answer, JsError> {
    let view = app::form(json::question(request)?)?;
    Ok(Answer { view: json::text(&view), seen: view.outcome.map(|outcome| outcome.trace) })
}

/// A `RunRequest` that is answered in pieces with a `RunView`, so that a worker can hear between them that it should
/// wait.
#[wasm_bindgen]
pub struct Run(app::Run);

#[wasm_bindgen]
impl Run {
    /// A run before its first block.
    ///
    /// # Errors
    /// A request or a setup of the wrong shape.
    #[wasm_bindgen(constructor)]
    pub fn new(request: &str) -> Result<Run, JsError> {
        Ok(Run(app::Run::new(json::question(request)?)?))
    }

    /// Carries out about so many blocks; true: the run is over.
    pub fn advance(&mut self, blocks: u32) -> bool {
        self.0.advance(blocks as usize)
    }

    /// How much of the main program is done, 0 to 1.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.0.share()
    }

    /// Its motions so far, to be seen while it goes on: a scene of nothing else.
    #[must_use]
    pub fn motions(&self) -> Scene {
        self.0.motions().into()
    }

    /// What it did, as a `RunView`. The run is gone afterwards.
    #[must_use]
    pub fn view(self) -> String {
        json::text(&self.0.view())
    }

    /// The same without its steps, these apart, and what is to be seen of it.
    #[must_use]
    pub fn finish(self) -> Answer {
        let mut view = self.0.view();
        view.trace.apart = true;
        Answer { view: json::text(&view), seen: Some(view.trace) }
    }
}

/// A program that lies in the module: questions about it come without its text, so that a long one comes once, in
/// pieces, and after that what is edited.
#[wasm_bindgen]
pub struct Held(app::ProgramText);

#[wasm_bindgen]
impl Held {
    /// An empty text with room for so many bytes.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new(bytes: u32) -> Held {
        Held(app::ProgramText::with_room(bytes as usize))
    }

    /// Puts a piece behind it, in UTF-8.
    pub fn push(&mut self, piece: &[u8]) {
        self.0.push(piece);
    }

    /// Puts a text in the place of these UTF-16 units.
    pub fn replace(&mut self, from: u32, to: u32, text: &str) {
        self.0.replace(from as usize, to as usize, text);
    }

    /// The same text once more, which takes no room until one of them is edited.
    #[must_use]
    pub fn copy(&self) -> Held {
        Held(self.0.clone())
    }

    /// What the function of this name says of this text: `read`, `change`, `convert`, `cure`, `equip`, `series` or
    /// `whole_certainty`.
    ///
    /// # Errors
    /// Another name, a request of the wrong shape, or what the function itself refuses.
    pub fn ask(&self, what: &str, request: &str) -> Result<String, JsError> {
        let text = self.0.clone();
        let answer = match what {
            "read" => {
                json::answer(request, |asked| app::read(app::ReadRequest { text, ..asked }, &mut |done| tell(done)))
            }
            "change" => json::answer(request, |asked| app::change(app::ChangeRequest { text, ..asked })),
            "convert" => json::answer(request, |asked| app::convert(app::ConvertRequest { text, ..asked })),
            "cure" => json::answer(request, |asked| app::cure(app::CureRequest { text, ..asked })),
            "equip" => json::answer(request, |asked| app::equip(app::EquipRequest { text, ..asked })),
            "series" => json::answer(request, |asked| {
                app::series_of(app::SeriesRequest { text, ..asked }, &mut |share| tell(share))
            }),
            "whole_certainty" => json::answer(request, |asked| {
                app::certainty_of(app::WholeCertaintyRequest { text, ..asked }, &mut |share| tell(share))
            }),
            _ => return Err(JsError::new(what)),
        };
        Ok(answer?)
    }

    /// A run of this text before its first block.
    ///
    /// # Errors
    /// A request or a setup of the wrong shape.
    pub fn run(&self, request: &str) -> Result<Run, JsError> {
        let asked: app::RunRequest = json::question(request)?;
        Ok(Run(app::Run::new(app::RunRequest { text: self.0.clone(), ..asked })?))
    }
}

/// Text of a setup file → `Setup` with everything in it that the file leaves to its default.
///
/// # Errors
/// The text is no setup: why, with the place.
#[wasm_bindgen]
pub fn setup(text: &str) -> Result<String, JsError> {
    let setup = json::setup_from_json(text)?;
    Ok(json::text(&setup))
}

/// `MachineRequest` → `MachineView`.
///
/// # Errors
/// A request or a setup of the wrong shape.
#[wasm_bindgen]
pub fn machine(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::machine)?)
}

/// `BrakingRequest` → `BrakingView`.
///
/// # Errors
/// A request of the wrong shape, or an axis that cannot be.
#[wasm_bindgen]
pub fn braking(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::braking)?)
}

/// `DefinitionsRequest` → `DefinitionsView`.
///
/// # Errors
/// A request of the wrong shape, or more channels than a control has.
#[wasm_bindgen]
pub fn definitions(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::definitions)?)
}

/// `ReadBackRequest` → `ReadBack`.
///
/// # Errors
/// A request of the wrong shape, or files without a datum of the machine.
#[wasm_bindgen]
pub fn read_back(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::read_back)?)
}

/// `RepeatRequest` → `RepeatView`.
///
/// # Errors
/// A request of the wrong shape, a test that cannot be, or one that ends without values.
#[wasm_bindgen]
pub fn repeat(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::repeat)?)
}

/// `UserProgramsRequest` → `UserProgramsView`.
///
/// # Errors
/// A request of the wrong shape, or a line that cannot stand there.
#[wasm_bindgen]
pub fn user_programs(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::user_programs)?)
}

/// `MachineCheckRequest` → `MachineCheckView`.
///
/// # Errors
/// A request of the wrong shape, or files without a datum that measuring needs.
#[wasm_bindgen]
pub fn machine_check(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::machine_check)?)
}

/// `EquipRequest` → `EquipView`.
///
/// # Errors
/// A request or a setup of the wrong shape, or a machine that cannot be.
#[wasm_bindgen]
pub fn equip(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::equip)?)
}

/// `FormRequest` → `Story`.
///
/// # Errors
/// A request of the wrong shape, an unknown cycle or a machine that cannot be.
#[wasm_bindgen]
pub fn story(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::story)?)
}

/// `PracticeRequest` → `PracticeProgram`: what the mask that is open means as a program.
///
/// # Errors
/// A request of the wrong shape, or a machine that cannot be.
#[wasm_bindgen]
pub fn as_program(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::as_program)?)
}

/// `PracticeCallRequest` → `PracticeCall`, or null: the mask that does what a call does.
///
/// # Errors
/// A request of the wrong shape or an unknown cycle.
#[wasm_bindgen]
pub fn as_mask(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::as_mask)?)
}

/// Measuring in JOG: a session that goes on.
#[wasm_bindgen]
#[derive(Default)]
pub struct Practice(app::Practice);

#[wasm_bindgen]
impl Practice {
    /// A session of which nothing is known yet.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new() -> Practice {
        Practice::default()
    }

    /// `PracticeRequest` → `PracticeView`, and what is to be seen since the mask was opened. The answer is that of a
    /// new session; lines that begin with those of the last request are carried out from there.
    ///
    /// # Errors
    /// A request or a setup of the wrong shape, or a control that does not measure in JOG.
    pub fn practise(&mut self, request: &str) -> Result<Answer, JsError> {
        let (view, seen) = self.0.practise(json::question(request)?)?;
        Ok(Answer { view: json::text(&view), seen: Some(seen) })
    }
}

/// `PracticeRequest` → `RunRecord`: what the session measured; its script is in the file of this name.
///
/// # Errors
/// As of a session.
#[wasm_bindgen]
pub fn practice_record(request: &str, script: &str) -> Result<String, JsError> {
    Ok(json::answer(request, |asked| app::practice_record(asked, script))?)
}

/// `PracticeRequest` → the setup file of the machine on which is practised, with the part as it lies.
///
/// # Errors
/// As of a session.
#[wasm_bindgen]
pub fn practice_setup(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::practice_setup)?)
}

/// Carries out a scenario file, with the files that it names (`Beside[]`) → `ScenarioView`.
///
/// # Errors
/// It is no scenario, or what it describes cannot be: why, with the place.
#[wasm_bindgen]
pub fn scenario(text: &str, beside: &str) -> Result<String, JsError> {
    let (scenario, beside) = (json::file(text)?, Some(json::question(beside)?));
    let view = app::scenario(app::ScenarioRequest { scenario, beside });
    Ok(json::text(&view.map_err(|refused| json::positioned(refused, text))?))
}

/// `NoteRequest` → `Scenario`.
///
/// # Errors
/// A request or a setup of the wrong shape.
#[wasm_bindgen]
pub fn note(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::noted)?)
}

/// `ProtocolRequest` → `ProtocolView`.
///
/// # Errors
/// A request or a setup of the wrong shape, or a protocol with nothing to read: why.
#[wasm_bindgen]
pub fn protocol(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::protocol)?)
}

/// `PracticeFace` → `PracticeApproach`.
///
/// # Errors
/// As of [`Practice::practise`].
#[wasm_bindgen]
pub fn approach(request: &str) -> Result<String, JsError> {
    Ok(json::answer(request, app::approach)?)
}

/// `TableRequest` → lines of the table of a record; the first piece has its headings. `say`: the words of a key.
///
/// # Errors
/// A request of the wrong shape.
#[wasm_bindgen]
pub fn record_table(request: &str, say: &js_sys::Function) -> Result<String, JsError> {
    let words = |key: &str| say.call1(&JsValue::NULL, &key.into()).ok().and_then(|said| said.as_string());
    let say = |key: &str| words(key).unwrap_or_else(|| key.to_owned());
    Ok(app::record_table(&json::question(request)?, &say))
}

/// Tells by its bytes, which come in pieces, whether a file is a part program and how it is encoded.
#[wasm_bindgen]
#[derive(Default)]
pub struct Recogniser {
    bytes: encoding::Recogniser,
    /// What the first piece tells; none: nothing was taken yet.
    told: Option<app::FileHead>,
}

#[wasm_bindgen]
impl Recogniser {
    /// Before the first byte.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new() -> Recogniser {
        Recogniser::default()
    }

    /// The next bytes of the file.
    pub fn take(&mut self, bytes: &[u8]) {
        self.told.get_or_insert_with(|| app::FileHead::of(bytes));
        self.bytes.take(bytes);
    }

    /// What all of them are, as a `Recognised`.
    #[must_use]
    pub fn finish(self) -> String {
        json::text(&app::Recognised::of(self.bytes.finish(), self.told.unwrap_or_default()))
    }
}
