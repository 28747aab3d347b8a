//! What `Session` says of itself: why it stands as it does, and what energies tend to.

use super::fault::object;
use super::session::{Session, from_js, indices, to_js};
use crate::app::{Diagnosis, StudyOptions};
use wasm_bindgen::prelude::*;

fn diagnosis(d: &Diagnosis) -> JsValue {
    object(&[
        ("kind", to_js(&d.kind)),
        ("message", to_js(&d.message)),
        ("vertices", indices(&d.vertices)),
        ("faces", indices(&d.faces)),
        ("edges", indices(&d.edges)),
        ("remedies", to_js(&d.remedies)),
    ])
}

#[wasm_bindgen]
impl Session {
    /// Why the flow stands as it does: `Diagnosis | null`.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn why(&self) -> Result<JsValue, JsValue> {
        Ok(self.0.why()?.as_ref().map_or(JsValue::NULL, diagnosis))
    }

    /// One more resolution of a refinement study: `Study`. With `options`, `{ shape?,
    /// parameters?, p? }`, it begins anew; without a shape it is of the surface as it is now.
    ///
    /// # Errors
    /// Unknown shapes, surfaces that cannot be refined, and going on with what has not begun.
    pub fn study(&mut self, options: JsValue) -> Result<JsValue, JsValue> {
        let given = !(options.is_undefined() || options.is_null());
        let options: StudyOptions = from_js(options)?;
        Ok(to_js(&self.0.study(given.then_some(&options))?))
    }
}
