//! What a file is, by its bytes.

use super::{message, object};
use crate::encoding::{Encoding, NoProgram};
use serde_json::Value;

/// A `Recognised`: the encoding of a program, or why the file is none.
pub fn recognised(found: Result<Encoding, NoProgram>) -> Value {
    match found {
        Ok(encoding) => object([("encoding", encoding.name().into())]),
        Err(what) => object([("why", message(&what.message()))]),
    }
}
