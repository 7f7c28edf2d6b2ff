//! Texts made from the catalogue and from results.

pub mod alarms;
pub mod around;
pub mod commissioning;
#[cfg(test)]
mod drawing;
pub mod explain;
pub mod findings;
pub mod foreign;
pub mod generations;
pub mod guides;
mod help;
pub mod jog;
pub mod machine;
mod markdown;
#[cfg(test)]
mod readme_tests;
pub mod reference;
pub mod terms;

use crate::message::{Arg, Message};
use crate::words::Words;
#[cfg(test)]
pub(crate) use tests::{docs, held};

/// A message with arguments as they are, however long.
fn said(words: &Words, key: impl Into<std::borrow::Cow<'static, str>>, args: &[(&'static str, String)]) -> String {
    let mut message = Message::new(key);
    message.args.extend(args.iter().map(|(name, text)| (*name, Arg::Text(text.clone()))));
    words.text(&message)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use crate::words::{LANGUAGES, Words};
    use std::path::{Path, PathBuf};

    /// Folder of the generated pages in a language: English at the top, the others by their code.
    pub fn docs(language: &str) -> PathBuf {
        let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs");
        if language == "en" { docs } else { docs.join(language) }
    }

    /// Holds a page of `docs/` against what is generated, in each language; with PROBEWRIGHT_UPDATE=1 it is written
    /// instead.
    pub fn held(name: &str, page: impl Fn(&Words) -> String) {
        for language in LANGUAGES {
            let page = page(&Words::of(language.code).unwrap());
            let file = docs(language.code).join(name);
            if std::env::var_os("PROBEWRIGHT_UPDATE").is_some() {
                std::fs::create_dir_all(file.parent().unwrap()).unwrap();
                std::fs::write(&file, &page).unwrap();
            }
            assert_eq!(std::fs::read_to_string(&file).unwrap(), page, "{}", file.display());
        }
    }
}
