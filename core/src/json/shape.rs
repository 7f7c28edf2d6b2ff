//! Reads a parsed document into a type of ours. What does not fit is told with a key and the member, which serde_json
//! can only say in English.

use crate::refused::{Path, Refused, Step};
use serde::de::value::MapAccessDeserializer;
use serde::de::{
    DeserializeOwned, DeserializeSeed, Deserializer, Error, Expected, IntoDeserializer, MapAccess, SeqAccess,
    Unexpected, Visitor,
};
use serde_json::Value;
use serde_json::map::IntoIter as Members;
use std::fmt::Display;
use std::vec::IntoIter as Elements;

/// The document as a `T`.
pub(super) fn read<T: DeserializeOwned>(document: Value) -> Result<T, Refused> {
    T::deserialize(Node(document)).map_err(|wrong| *wrong.0)
}

#[derive(Debug)]
pub(super) struct Wrong(Box<Refused>);

impl Wrong {
    fn new(key: &'static str) -> Wrong {
        Wrong(Box::new(Refused::new(key, Path::default())))
    }

    fn with(mut self, change: impl FnOnce(Refused) -> Refused) -> Wrong {
        *self.0 = change(*self.0);
        self
    }

    fn text(self, name: &'static str, value: impl Into<String>) -> Wrong {
        self.with(|refused| refused.text(name, value))
    }

    fn within(self, step: Step) -> Wrong {
        self.with(|refused| refused.within(step))
    }

    /// Something of another sort stands there than is wanted; both are keys.
    fn sort(found: &'static str, wanted: &str) -> Wrong {
        Wrong::new("document-sort").text("found", found).text("wanted", wanted)
    }
}

impl Display for Wrong {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.message.key.fmt(f)
    }
}

impl std::error::Error for Wrong {}

/// Names as they are listed in a message; they are our own, so that none is cut off.
fn listed(names: &[&str]) -> crate::message::Arg {
    crate::message::Arg::Text(names.join(", "))
}

impl Error for Wrong {
    /// Types of ours that read themselves give a key.
    fn custom<T: Display>(key: T) -> Wrong {
        Wrong(Box::new(Refused::new(key.to_string(), Path::default())))
    }

    /// What a type of ours expects is a key; of others it is known what they were asked for.
    fn invalid_type(found: Unexpected<'_>, expected: &dyn Expected) -> Wrong {
        let wanted = expected.to_string();
        let wanted = if wanted.starts_with("document-") { wanted.as_str() } else { "document-something-else" };
        Wrong::sort(sort(&found), wanted)
    }

    fn invalid_value(found: Unexpected<'_>, _: &dyn Expected) -> Wrong {
        let wrong = Wrong::new("document-value");
        match found {
            Unexpected::Unsigned(number) => wrong.with(|refused| refused.number("value", number as f64)),
            Unexpected::Signed(number) => wrong.with(|refused| refused.number("value", number as f64)),
            Unexpected::Float(number) => wrong.with(|refused| refused.number("value", number)),
            Unexpected::Str(text) => wrong.text("value", text),
            other => wrong.text("value", sort(&other)),
        }
    }

    fn invalid_length(count: usize, _: &dyn Expected) -> Wrong {
        Wrong::new("document-count").with(|refused| refused.number("count", count as f64))
    }

    fn unknown_variant(variant: &str, known: &'static [&'static str]) -> Wrong {
        let mut wrong = Wrong::new("document-choice").text("value", variant);
        wrong.0.message.args.push(("known", listed(known)));
        wrong
    }

    fn unknown_field(field: &str, known: &'static [&'static str]) -> Wrong {
        let mut wrong = Wrong::new("document-unknown").within(Step::Member(field.to_owned()));
        wrong.0.message.args.push(("known", listed(known)));
        wrong
    }

    fn missing_field(field: &'static str) -> Wrong {
        Wrong::new("document-missing").within(Step::Member(field.to_owned()))
    }

    fn duplicate_field(field: &'static str) -> Wrong {
        Wrong::new("document-twice").within(Step::Member(field.to_owned()))
    }
}

/// Key of a sort of value.
fn sort(found: &Unexpected<'_>) -> &'static str {
    match found {
        Unexpected::Bool(_) => "document-switch",
        Unexpected::Unsigned(_) | Unexpected::Signed(_) | Unexpected::Float(_) => "document-number",
        Unexpected::Char(_) | Unexpected::Str(_) | Unexpected::Bytes(_) | Unexpected::UnitVariant => "document-text",
        Unexpected::Seq | Unexpected::TupleVariant => "document-list",
        Unexpected::Unit | Unexpected::Option => "document-null",
        _ => "document-object",
    }
}

fn sort_of(value: &Value) -> &'static str {
    match value {
        Value::Null => "document-null",
        Value::Bool(_) => "document-switch",
        Value::Number(_) => "document-number",
        Value::String(_) => "document-text",
        Value::Array(_) => "document-list",
        Value::Object(_) => "document-object",
    }
}

struct Node(Value);

impl Node {
    fn number<'de, V: Visitor<'de>>(self, wanted: &str, visitor: V) -> Result<V::Value, Wrong> {
        let Value::Number(number) = &self.0 else { return Err(Wrong::sort(sort_of(&self.0), wanted)) };
        match (number.as_u64(), number.as_i64(), number.as_f64()) {
            (Some(number), ..) => visitor.visit_u64(number),
            (_, Some(number), _) => visitor.visit_i64(number),
            (.., Some(number)) => visitor.visit_f64(number),
            _ => Err(Wrong::sort("document-number", wanted)),
        }
    }

    fn whole<'de, V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        match &self.0 {
            Value::Number(number) if number.is_f64() => Err(Wrong::sort("document-fraction", "document-integer")),
            _ => self.number("document-integer", visitor),
        }
    }

    fn list<'de, V: Visitor<'de>>(self, count: Option<usize>, visitor: V) -> Result<V::Value, Wrong> {
        let Value::Array(list) = self.0 else { return Err(Wrong::sort(sort_of(&self.0), "document-list")) };
        if let Some(wanted) = count.filter(|wanted| *wanted != list.len()) {
            let wrong = Wrong::new("document-length");
            return Err(
                wrong.with(|refused| refused.number("count", list.len() as f64).number("wanted", wanted as f64))
            );
        }
        visitor.visit_seq(List { elements: list.into_iter(), index: 0 })
    }

    fn object<'de, V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        match self.0 {
            Value::Object(members) => visitor.visit_map(Object { members: members.into_iter(), next: None }),
            other => Err(Wrong::sort(sort_of(&other), "document-object")),
        }
    }
}

/// Methods that read alike.
macro_rules! alike {
    ($($how:ident: $($method:ident)*;)*) => {
        $($(fn $method<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
            self.$how(visitor)
        })*)*
    };
}

impl<'de> Deserializer<'de> for Node {
    type Error = Wrong;

    alike! {
        whole: deserialize_i8 deserialize_i16 deserialize_i32 deserialize_i64 deserialize_u8 deserialize_u16
            deserialize_u32 deserialize_u64;
        object: deserialize_map;
        deserialize_str: deserialize_string deserialize_identifier;
    }

    serde::forward_to_deserialize_any! {
        i128 u128 f32 char bytes byte_buf unit unit_struct tuple_struct ignored_any
    }

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        match self.0 {
            Value::Null => visitor.visit_unit(),
            Value::Bool(value) => visitor.visit_bool(value),
            Value::String(text) => visitor.visit_string(text),
            Value::Number(_) => self.number("document-number", visitor),
            Value::Array(_) => self.list(None, visitor),
            Value::Object(_) => self.object(visitor),
        }
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        match self.0 {
            Value::Bool(value) => visitor.visit_bool(value),
            other => Err(Wrong::sort(sort_of(&other), "document-switch")),
        }
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        self.number("document-number", visitor)
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        match self.0 {
            Value::String(text) => visitor.visit_string(text),
            other => Err(Wrong::sort(sort_of(&other), "document-text")),
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        match self.0 {
            Value::Null => visitor.visit_none(),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        self.list(None, visitor)
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, count: usize, visitor: V) -> Result<V::Value, Wrong> {
        self.list(Some(count), visitor)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(self, _: &'static str, visitor: V) -> Result<V::Value, Wrong> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Wrong> {
        self.object(visitor)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Wrong> {
        match self.0 {
            Value::String(name) => visitor.visit_enum(IntoDeserializer::<Wrong>::into_deserializer(name)),
            Value::Object(members) if members.len() == 1 => {
                visitor.visit_enum(MapAccessDeserializer::new(Object { members: members.into_iter(), next: None }))
            }
            other => Err(Wrong::sort(sort_of(&other), "document-one-choice")),
        }
    }
}

struct List {
    elements: Elements<Value>,
    index: usize,
}

impl<'de> SeqAccess<'de> for List {
    type Error = Wrong;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Wrong> {
        let Some(element) = self.elements.next() else { return Ok(None) };
        let step = Step::Element(self.index);
        self.index += 1;
        seed.deserialize(Node(element)).map(Some).map_err(|wrong| wrong.within(step))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.elements.len())
    }
}

struct Object {
    members: Members,
    next: Option<(String, Value)>,
}

impl<'de> MapAccess<'de> for Object {
    type Error = Wrong;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Wrong> {
        self.next = self.members.next();
        self.next.as_ref().map(|(name, _)| seed.deserialize(Name(name))).transpose()
    }

    fn next_value_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<T::Value, Wrong> {
        let (name, value) = self.next.take().ok_or_else(|| Wrong::new("document-missing"))?;
        seed.deserialize(Node(value)).map_err(|wrong| wrong.within(Step::Member(name)))
    }
}

/// The name of a member: a text, or a number where members are numbered.
struct Name<'a>(&'a str);

impl<'de> Deserializer<'de> for Name<'_> {
    type Error = Wrong;

    alike! {
        whole: deserialize_i8 deserialize_i16 deserialize_i32 deserialize_i64 deserialize_u8 deserialize_u16
            deserialize_u32 deserialize_u64;
    }

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        visitor.visit_str(self.0)
    }

    serde::forward_to_deserialize_any! {
        bool i128 u128 f32 f64 char str string bytes byte_buf option unit unit_struct newtype_struct seq tuple
        tuple_struct map struct enum identifier ignored_any
    }
}

impl Name<'_> {
    fn whole<'de, V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        match self.0.parse() {
            Ok(number) => visitor.visit_i64(number),
            Err(_) => Err(Wrong::new("document-number-name").within(Step::Member(self.0.to_owned()))),
        }
    }
}
