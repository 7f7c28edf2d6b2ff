//! What the client says about the machine: setting `probewright` with setup file, joined files and control.

use super::paths;
use crate::file::{self, Control};
use probewright_core::app;
use probewright_core::dialect::Dialect;
use probewright_core::json;
use probewright_core::machine::setup::Setup;
use probewright_core::message::Message;
use probewright_core::words::Words;
use serde::Deserialize;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// The setting as the client sends it.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Setting {
    /// Setup file of the machine; empty: none.
    setup: Option<PathBuf>,
    /// Definition files, subprograms, or folders of them.
    with: Vec<PathBuf>,
    /// Control of every program; absent: each is recognised.
    control: Option<Dialect>,
}

/// A machine that a setup file describes, for what is checked and for what is asked of the application.
pub struct Described {
    pub setup: Setup,
    pub machine: app::Machine,
}

/// What is known beside a program.
#[derive(Default)]
pub struct Settings {
    setting: Setting,
    /// The machine of the setup file.
    pub described: Option<Described>,
}

impl Settings {
    /// Of the setting, with why it does not count where it does not. Relative paths begin in `root`. What clients send
    /// instead of a setting that nobody made is none.
    pub fn of(value: &Value, root: Option<&Path>, words: &Words) -> (Settings, Option<String>) {
        let own = value.get("probewright").unwrap_or(value);
        let told = |text: String| Some(words.text(&Message::new("server-setting").text("text", text)));
        if own.is_null() {
            return (Settings::default(), None);
        }
        let mut setting: Setting = match json::question(&own.to_string()) {
            Ok(setting) => setting,
            Err(refused) => return (Settings::default(), told(words.text(&refused.message))),
        };
        let whole = |path: PathBuf| root.map_or_else(|| path.clone(), |root| root.join(&path));
        setting.with = setting.with.into_iter().map(whole).collect();
        setting.setup = setting.setup.filter(|path| !path.as_os_str().is_empty()).map(whole);
        let described = setting.setup.as_deref().map(|path| described(path, words));
        let (described, wrong) = match described.transpose() {
            Ok(described) => (described, None),
            Err(why) => (None, told(why)),
        };
        (Settings { setting, described }, wrong)
    }

    /// The same with the setup file read anew.
    pub fn again(&mut self, words: &Words) {
        if let Some(path) = &self.setting.setup {
            self.described = described(path, words).ok();
        }
    }

    /// The files beside the programs.
    pub fn with(&self) -> &[PathBuf] {
        &self.setting.with
    }

    /// The control that was asked for.
    pub fn control(&self) -> Option<Control> {
        self.setting.control.map(|dialect| match dialect {
            Dialect::Sinumerik => Control::Sinumerik,
            Dialect::Nct => Control::Nct,
        })
    }

    /// Whether a file is the setup file, or one beside the programs.
    pub fn counts(&self, path: &Path) -> bool {
        let of = |one: &PathBuf| path.starts_with(one) || paths::same(path, one);
        self.setting.setup.iter().chain(&self.setting.with).any(of)
    }
}

/// The machine of a file, or why there is none.
fn described(path: &Path, words: &Words) -> Result<Described, String> {
    let text = file::text(path).map_err(|problem| file::told(&problem, words))?;
    let refused = |refused: json::Error| file::refusal(path, &refused, words);
    let setup = json::setup_from_json(&text).map_err(refused)?;
    let machine = json::file(&text).map_err(refused)?;
    Ok(Described { setup, machine })
}
