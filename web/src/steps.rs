//! The steps of a run, as arrays on the module's memory.

use crate::scene::view;
use js_sys::{Float64Array, Uint8Array, Uint32Array};
use probewright_core::scene::Source;
use probewright_core::{app, json};
use wasm_bindgen::prelude::wasm_bindgen;

/// The steps of a run in columns, which owns them; each is handed out as a view on the memory of the module.
#[wasm_bindgen]
pub struct Steps {
    columns: app::Columns,
    others: String,
    /// Where each of the others begins, and the last one ends.
    starts: Vec<u32>,
}

#[wasm_bindgen]
impl Steps {
    /// What each is: 0 rapid, 1 positioning, 2 measuring, 3 retract, 4 a touch of what measures, 5 another one, 6 a
    /// crash, 7 the begin of a call, 8 its end, 9 anything else.
    #[must_use]
    pub fn sorts(&self) -> Uint8Array {
        view!(Uint8Array, self.columns.sorts)
    }

    /// The line of the program of each, from 1; 0: none.
    #[must_use]
    pub fn lines(&self) -> Uint32Array {
        view!(Uint32Array, self.columns.lines)
    }

    /// Of a motion mm/min, 0 rapid traverse.
    #[must_use]
    pub fn feeds(&self) -> Float64Array {
        view!(Float64Array, self.columns.feeds)
    }

    /// Three numbers a step: of a motion its real end, machine, mm.
    #[must_use]
    pub fn ends(&self) -> Float64Array {
        view!(Float64Array, self.columns.ends)
    }

    /// The steps that are no motions, one behind the other, as JSON in UTF-8.
    #[must_use]
    pub fn others(&self) -> Uint8Array {
        view!(Uint8Array, self.others)
    }

    /// Where each of them begins, and the last one ends.
    #[must_use]
    pub fn starts(&self) -> Uint32Array {
        view!(Uint32Array, self.starts)
    }
}

impl Steps {
    /// Those of a run.
    pub(crate) fn of(seen: &Source) -> Steps {
        let (mut others, mut starts) = (String::new(), vec![0]);
        for step in app::others(seen) {
            others += &json::text(&step);
            starts.push(others.len() as u32);
        }
        Steps { columns: app::columns(seen), others, starts }
    }
}
