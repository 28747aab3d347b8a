//! What `Session` shows of the mathematics: Möbius inversion, circles, curvature lines.

use super::fault::object;
use super::session::{Session, field, floats, from_js, indices, refusal, to_js};
use crate::app::{AppError, Look, SelfIntersections};
use js_sys::Uint8Array;
use wasm_bindgen::prelude::*;

fn point(centre: &[f64]) -> Result<[f64; 3], JsValue> {
    <[f64; 3]>::try_from(centre).map_err(|_| {
        let coordinates = centre.len();
        refusal(AppError::BadPoint { coordinates })
    })
}

fn look(l: &Look) -> JsValue {
    let kinds: Vec<u8> = l.kinds.iter().map(|&kind| kind as u8).collect();
    object(&[
        ("probe", to_js(&l.probe)),
        ("ends", floats(&l.ends)),
        ("kinds", Uint8Array::from(kinds.as_slice()).into()),
        ("circles", to_js(&l.circles)),
        ("directions", to_js(&l.directions)),
        ("alignment", to_js(&l.alignment)),
    ])
}

fn self_intersections(found: &SelfIntersections) -> JsValue {
    object(&[
        ("pairs", indices(found.pairs.as_flattened())),
        ("triangles", indices(&found.triangles)),
    ])
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
        let found = self.0.self_intersections()?;
        Ok(found.as_ref().map_or(JsValue::NULL, self_intersections))
    }

    /// Looks closer at the surface as it is now: `Look`. `wanted` is `{ probe?: number,
    /// circles?: boolean, directions?: boolean }`.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn look(&self, wanted: JsValue) -> Result<JsValue, JsValue> {
        Ok(look(&self.0.look(from_js(wanted)?)?))
    }

    /// The surface inverted, without changing it: `Inverted`. The centre is given from the
    /// middle of the surface's bounding box in diagonals of it.
    ///
    /// # Errors
    /// Centres on the surface or far away, unknown fields.
    #[wasm_bindgen(js_name = previewInversion)]
    pub fn preview_inversion(
        &self,
        centre: &[f64],
        colour: &str,
        wanted: JsValue,
    ) -> Result<JsValue, JsValue> {
        let inverted = self
            .0
            .preview_inversion(point(centre)?, colour, from_js(wanted)?)?;
        let colours = inverted.field.as_ref().map_or(JsValue::NULL, field);
        Ok(object(&[
            ("report", to_js(&inverted.report)),
            ("positions", floats(&inverted.positions)),
            ("field", colours),
            ("look", look(&inverted.look)),
        ]))
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
