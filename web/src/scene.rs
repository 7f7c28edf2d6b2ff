//! What is to be seen, as arrays on the module's memory.

use js_sys::{Float32Array, Float64Array, Uint8Array, Uint32Array};
use probewright_core::json;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

/// A scene, which owns its arrays. Each is handed out as a view on the memory of the module: good until the next call
/// into the module, which may move that memory.
#[wasm_bindgen]
pub struct Scene(probewright_core::scene::Scene);

impl From<probewright_core::scene::Scene> for Scene {
    fn from(scene: probewright_core::scene::Scene) -> Scene {
        Scene(scene)
    }
}

/// A view of that sort on so many numbers that begin there.
macro_rules! view {
    ($sort:ident, $numbers:expr) => {
        $sort::new_with_byte_offset_and_length(
            &$crate::scene::memory(),
            $numbers.as_ptr() as usize as u32,
            $numbers.len() as u32,
        )
    };
}
pub(crate) use view;

/// The memory of the module.
pub fn memory() -> JsValue {
    wasm_bindgen::memory().unchecked_into::<js_sys::WebAssembly::Memory>().buffer()
}

#[wasm_bindgen]
impl Scene {
    /// What the arrays hold, as a `SceneView`.
    #[must_use]
    pub fn view(&self) -> String {
        json::text(&self.0.view)
    }

    /// Six numbers a vertex: place in the frame of its piece, mm, and outward unit normal.
    #[must_use]
    pub fn vertices(&self) -> Float32Array {
        view!(Float32Array, self.0.vertices)
    }

    /// Three vertices a triangle, counter-clockwise seen from outside.
    #[must_use]
    pub fn corners(&self) -> Uint32Array {
        view!(Uint32Array, self.0.corners)
    }

    /// Six numbers a line, mm: from and to, in the frame of its group.
    #[must_use]
    pub fn lines(&self) -> Float64Array {
        view!(Float64Array, self.0.lines)
    }

    /// Eight numbers a straight piece of a motion: from, to, mm, and between which parts of the motion.
    #[must_use]
    pub fn ways(&self) -> Float64Array {
        view!(Float64Array, self.0.ways)
    }

    /// The entry of the trace of each.
    #[must_use]
    pub fn way_entries(&self) -> Uint32Array {
        view!(Uint32Array, self.0.way_entries)
    }

    /// The kind of each: 0 rapid, 1 positioning, 2 measuring, 3 retract.
    #[must_use]
    pub fn way_kinds(&self) -> Uint8Array {
        view!(Uint8Array, self.0.way_kinds)
    }

    /// Six numbers a touch: point, mm, and outward unit normal.
    #[must_use]
    pub fn touches(&self) -> Float64Array {
        view!(Float64Array, self.0.touches)
    }

    /// The entry of the trace of each.
    #[must_use]
    pub fn touch_entries(&self) -> Uint32Array {
        view!(Uint32Array, self.0.touch_entries)
    }

    /// The sort of each: 0 of the ball, 1 of stylus or body, 2 a crash.
    #[must_use]
    pub fn touch_sorts(&self) -> Uint8Array {
        view!(Uint8Array, self.0.touch_sorts)
    }

    /// Three numbers an entry of the trace: where the centre of the ball is when it is done, mm. None where nothing
    /// moves.
    #[must_use]
    pub fn stands(&self) -> Float64Array {
        view!(Float64Array, self.0.stands)
    }

    /// When each entry of the trace begins, and the last one ends, s.
    #[must_use]
    pub fn begins(&self) -> Float64Array {
        view!(Float64Array, self.0.begins)
    }
}
