//! What nearly every file of a cycle names: the parts of an entry, what is read and said of a call, what a cycle moves.

pub use super::common::{PARAM, optional, param, required};
pub use super::sinumerik::{Next, alarm, results, until_done};
pub(crate) use super::{common, place, shared_checks};
pub use crate::check::refused;
pub use crate::control::Control;
pub use crate::diagnostic::{Code, Diagnostic};
pub use crate::entry::*;
pub use crate::geometry::Wcs;
pub use crate::machine::{Machine, Stop};
pub use crate::message::Message;
pub use crate::name::Name;
pub use crate::own;
pub use crate::picture::{PictureShape, ShapeKind};
pub use crate::range::Range;
