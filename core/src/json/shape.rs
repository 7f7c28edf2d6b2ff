//! Reads a parsed document into a type of ours. What does not fit is told with a key and the member, which serde_json
//! can only say in English.

use crate::message::Arg;
use crate::refused::{Path, Refused, Step};
use serde::de::value::MapAccessDeserializer;
use serde::de::{
    DeserializeOwned, DeserializeSeed, Deserializer, Error, Expected, IntoDeserializer, MapAccess, SeqAccess,
    Unexpected, Visitor,
};
use serde_json::Value;
use serde_json::map::{IntoIter as Members, Map};
use std::borrow::Cow;
use std::fmt::Display;
use std::vec::IntoIter as Elements;

/// Why a document does not fit; in a box, since every member that is read may say so.
type Wrong = Box<Refused>;

/// Names of members or choices.
type Names = &'static [&'static str];

/// The document as a `T`.
pub(super) fn read<T: DeserializeOwned>(document: Value) -> Result<T, Refused> {
    T::deserialize(Node(document)).map_err(|wrong| *wrong)
}

fn wrong(key: impl Into<Cow<'static, str>>) -> Refused {
    Refused::new(key, Path::default())
}

/// Something of another sort stands there than is wanted; both are keys.
fn other_sort(found: &'static str, wanted: &str) -> Wrong {
    wrong("document-sort").text("found", found).text("wanted", wanted).into()
}

/// Lists the known names; they are our own, so that none is cut off.
fn listing(mut refused: Refused, known: Names) -> Wrong {
    refused.message.args.push(("known", Arg::Text(known.join(", "))));
    refused.into()
}

impl Error for Wrong {
    /// Types of ours that read themselves give a key.
    fn custom<T: Display>(key: T) -> Wrong {
        wrong(key.to_string()).into()
    }

    /// What a type of ours expects is a key; of others it is known what they were asked for.
    fn invalid_type(found: Unexpected<'_>, expected: &dyn Expected) -> Wrong {
        let wanted = expected.to_string();
        other_sort(sort(&found), if wanted.starts_with("document-") { &wanted } else { "document-something-else" })
    }

    fn invalid_value(found: Unexpected<'_>, _: &dyn Expected) -> Wrong {
        let wrong = wrong("document-value");
        let wrong = match found {
            Unexpected::Unsigned(number) => wrong.number("value", number as f64),
            Unexpected::Signed(number) => wrong.number("value", number as f64),
            Unexpected::Float(number) => wrong.number("value", number),
            Unexpected::Str(text) => wrong.text("value", text),
            other => wrong.text("value", sort(&other)),
        };
        wrong.into()
    }

    fn invalid_length(count: usize, _: &dyn Expected) -> Wrong {
        wrong("document-count").number("count", count as f64).into()
    }

    fn unknown_variant(variant: &str, known: Names) -> Wrong {
        listing(wrong("document-choice").text("value", variant), known)
    }

    fn unknown_field(field: &str, known: Names) -> Wrong {
        listing(wrong("document-unknown").within(Step::Member(field.to_owned())), known)
    }

    fn missing_field(field: &'static str) -> Wrong {
        wrong("document-missing").within(Step::Member(field.to_owned())).into()
    }

    fn duplicate_field(field: &'static str) -> Wrong {
        wrong("document-twice").within(Step::Member(field.to_owned())).into()
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
        let Value::Number(number) = &self.0 else { return Err(other_sort(sort_of(&self.0), wanted)) };
        match (number.as_u64(), number.as_i64(), number.as_f64()) {
            (Some(number), ..) => visitor.visit_u64(number),
            (_, Some(number), _) => visitor.visit_i64(number),
            (.., Some(number)) => visitor.visit_f64(number),
            _ => Err(other_sort("document-number", wanted)),
        }
    }

    /// A whole number from here to there.
    fn whole<'de, V: Visitor<'de>>(self, visitor: V, [min, max]: [i128; 2]) -> Result<V::Value, Wrong> {
        let Value::Number(number) = &self.0 else { return self.number("document-integer", visitor) };
        let whole = number.as_i128();
        if whole.is_some_and(|number| (min..=max).contains(&number)) {
            return self.number("document-integer", visitor);
        }
        match number.as_f64() {
            Some(value) if whole.is_none() && value.abs() < LARGE => {
                Err(other_sort("document-fraction", "document-integer"))
            }
            _ => {
                let told = wrong("document-whole-range").text("value", number.to_string());
                Err(told.text("min", min.to_string()).text("max", max.to_string()).into())
            }
        }
    }
}

/// From here on a document may have whole numbers that no 64 bits hold.
const LARGE: f64 = 9e18;

/// Methods that read alike.
macro_rules! alike {
    ($($how:ident: $($method:ident)*;)*) => {
        $($(fn $method<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
            self.$how(visitor)
        })*)*
    };
}

/// Methods that read whole numbers, each with its type.
macro_rules! whole {
    ($($method:ident $sort:ty,)*) => {
        $(fn $method<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
            self.whole(visitor, [i128::from(<$sort>::MIN), i128::from(<$sort>::MAX)])
        })*
    };
}

impl<'de> Deserializer<'de> for Node {
    type Error = Wrong;

    whole! {
        deserialize_i8 i8, deserialize_i16 i16, deserialize_i32 i32, deserialize_i64 i64,
        deserialize_u8 u8, deserialize_u16 u16, deserialize_u32 u32, deserialize_u64 u64,
    }

    alike! {
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
            Value::Array(_) => self.deserialize_seq(visitor),
            Value::Object(_) => self.deserialize_map(visitor),
        }
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        match self.0 {
            Value::Bool(value) => visitor.visit_bool(value),
            other => Err(other_sort(sort_of(&other), "document-switch")),
        }
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        self.number("document-number", visitor)
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        match self.0 {
            Value::String(text) => visitor.visit_string(text),
            other => Err(other_sort(sort_of(&other), "document-text")),
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        match self.0 {
            Value::Null => visitor.visit_none(),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        match self.0 {
            Value::Array(list) => visitor.visit_seq(List { elements: list.into_iter(), index: 0 }),
            other => Err(other_sort(sort_of(&other), "document-list")),
        }
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, wanted: usize, visitor: V) -> Result<V::Value, Wrong> {
        let count = self.0.as_array().map_or(wanted, Vec::len);
        if count != wanted {
            return Err(wrong("document-length").number("count", count as f64).number("wanted", wanted as f64).into());
        }
        self.deserialize_seq(visitor)
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        match self.0 {
            Value::Object(members) => visitor.visit_map(Object::of(members)),
            other => Err(other_sort(sort_of(&other), "document-object")),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(self, _: &'static str, visitor: V) -> Result<V::Value, Wrong> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_struct<V: Visitor<'de>>(self, _: &str, _: Names, visitor: V) -> Result<V::Value, Wrong> {
        self.deserialize_map(visitor)
    }

    fn deserialize_enum<V: Visitor<'de>>(self, _: &str, _: Names, visitor: V) -> Result<V::Value, Wrong> {
        match self.0 {
            Value::String(name) => visitor.visit_enum(IntoDeserializer::<Wrong>::into_deserializer(name)),
            Value::Object(members) if members.len() == 1 => {
                visitor.visit_enum(MapAccessDeserializer::new(Object::of(members)))
            }
            other => Err(other_sort(sort_of(&other), "document-one-choice")),
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
        seed.deserialize(Node(element)).map(Some).map_err(|wrong| wrong.within(step).into())
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.elements.len())
    }
}

struct Object {
    members: Members,
    next: Option<(String, Value)>,
}

impl Object {
    fn of(members: Map<String, Value>) -> Object {
        Object { members: members.into_iter(), next: None }
    }
}

impl<'de> MapAccess<'de> for Object {
    type Error = Wrong;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Wrong> {
        self.next = self.members.next();
        self.next.as_ref().map(|(name, _)| seed.deserialize(Name(name))).transpose()
    }

    fn next_value_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<T::Value, Wrong> {
        let (name, value) = self.next.take().ok_or_else(|| wrong("document-missing"))?;
        seed.deserialize(Node(value)).map_err(|wrong| wrong.within(Step::Member(name)).into())
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
            Err(_) => Err(wrong("document-number-name").within(Step::Member(self.0.to_owned())).into()),
        }
    }
}
