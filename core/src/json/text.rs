//! The text of a document: read, and where in it a member stands.

use crate::refused::{Path, Refused, Step};
use crate::syntax::position::Positions;
use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde_json::error::Category;
use serde_json::value::RawValue;
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::fmt;

/// The document in a text. No member may be in it twice: which one would apply?
pub(super) fn parse(text: &str) -> Result<Value, Refused> {
    serde_json::from_str(text).map(|Document(value)| value).map_err(|error| {
        let said = error.to_string();
        let name = said.rsplit_once(" at line ").map_or(said.as_str(), |(name, _)| name);
        let (key, path) = match error.classify() {
            Category::Data => ("document-twice", Path::of(&[name])),
            Category::Eof => ("document-ends", Path::default()),
            Category::Syntax | Category::Io => ("document-syntax", Path::default()),
        };
        Refused { position: Some((error.line(), column(text, &error))), ..Refused::new(key, path) }
    })
}

/// The column in characters from 1; of serde_json it is that of a byte.
fn column(text: &str, error: &serde_json::Error) -> usize {
    let line = text.split('\n').nth(error.line().saturating_sub(1)).unwrap_or_default();
    line.bytes().take(error.column()).filter(|byte| byte & 0xc0 != 0x80).count().max(1)
}

/// With the line and the column of its member in this text.
pub fn positioned(refused: Refused, text: &str) -> Refused {
    let position = place(text, &refused.path);
    Refused { position: refused.position.or(position), ..refused }
}

/// Where the member stands, or the last one on the way to it that there is.
fn place(text: &str, path: &Path) -> Option<(usize, usize)> {
    let mut found: &RawValue = serde_json::from_str(text).ok()?;
    for step in &path.0 {
        let inner = match step {
            Step::Member(name) => serde_json::from_str::<BTreeMap<String, &RawValue>>(found.get()).ok()?.remove(name),
            Step::Element(index) => serde_json::from_str::<Vec<&RawValue>>(found.get()).ok()?.get(*index).copied(),
        };
        let Some(inner) = inner else { break };
        found = inner;
    }
    let start = found.get().as_ptr().addr() - text.as_ptr().addr();
    let (line, column) = Positions::new(text.as_bytes()).line_column(start as u32);
    Some((line as usize, column as usize))
}

/// A document without members of the same name.
struct Document(Value);

impl<'de> Deserialize<'de> for Document {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Document, D::Error> {
        deserializer.deserialize_any(Reader).map(Document)
    }
}

struct Reader;

impl<'de> Visitor<'de> for Reader {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("JSON")
    }

    fn visit_unit<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_bool<E>(self, value: bool) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_u64<E>(self, value: u64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_i64<E>(self, value: i64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_f64<E>(self, value: f64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_str<E>(self, text: &str) -> Result<Value, E> {
        Ok(text.into())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Value, A::Error> {
        let mut elements = Vec::new();
        while let Some(Document(element)) = list.next_element()? {
            elements.push(element);
        }
        Ok(elements.into())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut object: A) -> Result<Value, A::Error> {
        let mut members = Map::new();
        while let Some(name) = object.next_key::<String>()? {
            if members.contains_key(&name) {
                return Err(A::Error::custom(name));
            }
            let Document(value) = object.next_value()?;
            members.insert(name, value);
        }
        Ok(members.into())
    }
}
