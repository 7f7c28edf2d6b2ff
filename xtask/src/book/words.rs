//! The words around the pages: messages of `www/messages`, as all words are.

use anyhow::{Context, Result, anyhow, bail};
use fluent_bundle::{FluentBundle, FluentResource};
use std::fs;
use std::path::Path;

/// Those of the handbook, and those that it shares with the page and with the pages of `docs/`.
const FILES: [&str; 3] = ["www/messages/{}/book.ftl", "www/messages/{}/page.ftl", "core/messages/{}/report.ftl"];

/// The messages of a language.
pub struct Words(FluentBundle<FluentResource>);

impl Words {
    /// Reads them below the root of the repository.
    pub fn read(root: &Path, language: &str) -> Result<Words> {
        let mut bundle = FluentBundle::default(); // messages without arguments say the same in every locale
        for file in FILES {
            let path = root.join(file.replace("{}", language));
            let text = fs::read_to_string(&path).with_context(|| path.display().to_string())?;
            let read = FluentResource::try_new(text).map_err(|(_, all)| anyhow!("{}: {all:?}", path.display()))?;
            bundle.add_resource(read).map_err(|all| anyhow!("{}: {all:?}", path.display()))?;
        }
        Ok(Words(bundle))
    }

    /// A message without arguments.
    pub fn text(&self, key: &str) -> Result<String> {
        let pattern = self.0.get_message(key).and_then(|message| message.value());
        let pattern = pattern.with_context(|| format!("no message {key}"))?;
        let mut problems = Vec::new();
        let text = self.0.format_pattern(pattern, None, &mut problems).into_owned();
        if !problems.is_empty() {
            bail!("{key}: {problems:?}");
        }
        Ok(text)
    }
}
