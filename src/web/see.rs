//! What `Session` shows of the mathematics: Möbius inversion, circles, curvature lines.

use super::fault::fault;
use super::session::{Session, from_js, to_js};
use wasm_bindgen::prelude::*;

fn point(centre: &[f64]) -> Result<[f64; 3], JsValue> {
    <[f64; 3]>::try_from(centre).map_err(|_| {
        let message = format!("{} coordinates are given", centre.len());
        fault("BadOption", &message, "A centre has three.")
    })
}

#[wasm_bindgen]
impl Session {
    /// Where the surface as it is now passes through itself: `SelfIntersections`, or null where
    /// that would take too long.
    ///
    /// # Errors
    /// Without a mesh.
    #[wasm_bindgen(js_name = selfIntersections)]
    pub fn self_intersections(&self) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.0.self_intersections()?))
    }

    /// Looks closer at the surface as it is now: `Look`. `wanted` is `{ probe?: number,
    /// circles?: boolean, directions?: boolean }`.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn look(&self, wanted: JsValue) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.0.look(from_js(wanted)?)?))
    }

    /// Makes the surface inverted the start of what comes: `InversionReport`; `loaded` tells
    /// it, `undoEdit` brings back the one before.
    ///
    /// # Errors
    /// Centres on the surface or far away.
    pub fn invert(&mut self, centre: &[f64]) -> Result<JsValue, JsValue> {
        let (_, report) = self.0.invert(point(centre)?)?;
        Ok(to_js(&report))
    }
}
