//! What `Session` can do with the steps it has stored: looking around, branches.

use super::session::{Session, to_js};
use js_sys::Float64Array;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Session {
    /// Shows a stored step as it was, the nearest at or before `step`: `State`.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn seek(&mut self, step: usize) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.0.seek(step)?))
    }

    /// The steps that can be shown, and the branches: `Timeline`.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn timeline(&self) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.0.timeline()?))
    }

    /// Goes to the end of a branch: `State`.
    ///
    /// # Errors
    /// If it was forgotten.
    pub fn branch(&mut self, id: u32) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.0.branch(id)?))
    }

    /// Step, time, step size, energy and monitored functional of each step after `step` up to
    /// the one shown, end to end.
    ///
    /// # Errors
    /// Without a mesh.
    #[wasm_bindgen(js_name = samplesAfter)]
    pub fn samples_after(&self, step: usize) -> Result<Float64Array, JsValue> {
        let samples = self.0.samples_after(step)?;
        Ok(Float64Array::from(samples.as_flattened()))
    }
}
