//! What nearly every file of a cycle names: the parts of an entry, what is read and said of a call, what a cycle moves,
//! touches and draws.

pub use super::common::{ALWAYS_REQUIRED, PARAM, alarms, integer, optional, param, required};
pub use super::sinumerik::measuring_block::{Block, Point};
pub use super::sinumerik::{Next, alarm, axis, carry_out, direction, results, until_done};
pub(crate) use super::{common, place, shared_checks};
pub use crate::check::{error, refused};
pub use crate::control::{Control, Edge, MachineSort, Plane};
pub use crate::diagnostic::{Code, Diagnostic};
pub use crate::entry::stage::{Fields, Look, Seen, Staging, add};
pub use crate::entry::*;
pub use crate::geometry::{Degrees, Dir, V3, Wcs};
pub use crate::machine::{Machine, Step, Stop};
pub use crate::message::Message;
pub use crate::name::Name;
pub use crate::own;
pub use crate::picture::figures::{circle, dimension, line, rectangle};
pub use crate::picture::{Picture, PictureShape, ShapeKind, View};
pub use crate::range::Range;
pub use crate::workpiece::{Shape, Solid};
