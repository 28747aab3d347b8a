//! JavaScript class `Session`, the solver's seam; types in `www/protocol.js`.
//!
//! Typed arrays given out are copies owned by JavaScript, safe to transfer.

use super::fault::object;
use crate::app::{AppError, Fault, Field, Loaded, RegulariseOptions, Session as Inner};
use crate::energy::circle::Boundary;
use crate::flow::options::FlowOptions;
use crate::io::Format;
use crate::mesh::shape;
use js_sys::{Float32Array, Function, Uint8Array, Uint32Array};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::collections::BTreeMap;
use std::rc::Rc;
use wasm_bindgen::prelude::*;

impl From<Fault> for JsValue {
    fn from(fault: Fault) -> Self {
        to_js(&fault)
    }
}

pub(super) fn refusal(error: AppError) -> JsValue {
    Fault::from(error).into()
}

/// A plain object; maps become objects, `None` becomes null.
pub(super) fn to_js<T: Serialize>(value: &T) -> JsValue {
    let serializer = serde_wasm_bindgen::Serializer::new()
        .serialize_maps_as_objects(true)
        .serialize_missing_as_null(true);
    // Fails only for values that no report holds, such as maps with object keys.
    value.serialize(&serializer).unwrap_or(JsValue::NULL)
}

pub(super) fn from_js<T: DeserializeOwned + Default>(value: JsValue) -> Result<T, JsValue> {
    if value.is_undefined() || value.is_null() {
        return Ok(T::default());
    }
    serde_wasm_bindgen::from_value(value).map_err(|error| {
        let reason = error.to_string();
        refusal(AppError::BadOptions { reason })
    })
}

pub(super) fn floats(values: &[f32]) -> JsValue {
    Float32Array::from(values).into()
}

pub(super) fn indices(values: &[u32]) -> JsValue {
    Uint32Array::from(values).into()
}

fn list(values: Option<&Vec<u32>>) -> JsValue {
    values.map_or(JsValue::NULL, |values| indices(values))
}

pub(super) fn loaded(l: &Loaded) -> JsValue {
    object(&[
        ("name", l.name.as_str().into()),
        ("info", to_js(&l.info)),
        ("positions", floats(&l.positions)),
        ("triangles", indices(&l.triangles)),
        ("wireEdges", indices(&l.wire_edges)),
        ("boundaryEdges", indices(&l.boundary_edges)),
        ("trianglesOnly", l.triangles_only.into()),
        ("fixed", list(l.fixed.as_ref())),
        ("free", list(l.free.as_ref())),
    ])
}

pub(super) fn field(f: &Field) -> JsValue {
    object(&[
        ("name", to_js(&f.name)),
        ("values", floats(&f.values)),
        ("low", f.low.into()),
        ("high", f.high.into()),
        ("signed", f.signed.into()),
    ])
}

/// What `energy` may be told: `{ p?: number[], boundary? }`.
#[derive(Default, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
struct EnergyOptions {
    p: Vec<f64>,
    boundary: Boundary,
}

/// One mesh, one flow, its history. Every method that refuses throws a `Fault` and
/// changes nothing.
#[wasm_bindgen]
#[derive(Default)]
pub struct Session(pub(super) Inner);

#[wasm_bindgen]
impl Session {
    /// A session without a mesh.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Version of the crate.
    pub fn version() -> String {
        env!("CARGO_PKG_VERSION").into()
    }

    /// Whether the dense kernels of the factorisation use SIMD.
    #[wasm_bindgen(js_name = simdEnabled)]
    pub fn simd_enabled() -> bool {
        crate::linalg::simd_enabled()
    }

    /// Sample shapes: `[{ name, label, parameters: [{ name, label, default, low, high,
    /// integer }] }]`.
    pub fn shapes(&self) -> JsValue {
        let shapes = js_sys::Array::new();
        for s in shape::all() {
            let parameters = js_sys::Array::new();
            for p in s.parameters {
                parameters.push(&object(&[
                    ("name", p.name.into()),
                    ("label", p.label.into()),
                    ("default", p.default.into()),
                    ("low", p.low.into()),
                    ("high", p.high.into()),
                    ("integer", p.integer.into()),
                ]));
            }
            shapes.push(&object(&[
                ("name", s.name.into()),
                ("label", s.label.into()),
                ("parameters", parameters.into()),
            ]));
        }
        shapes.into()
    }

    /// Runs a few steps on a small sphere, so that the first real step does not meet
    /// code that is still in the engine's slow tier.
    #[wasm_bindgen(js_name = warmUp)]
    pub fn warm_up() {
        let mut session = Inner::new();
        if session
            .sample("icosahedron", &[("level".into(), 4.0)])
            .is_ok()
        {
            // Nothing depends on how it goes.
            let _ = session.run(3);
        }
    }

    /// Calls `callback(stage, share)` within long steps; anything else clears it.
    #[wasm_bindgen(js_name = onProgress)]
    pub fn on_progress(&mut self, callback: JsValue) {
        self.0
            .set_progress(callback.dyn_into::<Function>().ok().map(|callback| {
                let call = move |stage: &str, share: f64| {
                    // An exception in a progress bar must not end the step.
                    let _ = callback.call2(&JsValue::NULL, &stage.into(), &share.into());
                };
                Rc::new(call) as Rc<dyn Fn(&str, f64)>
            }));
    }

    /// Loads a mesh file: `Loaded`.
    ///
    /// # Errors
    /// What is wrong with the file, and where.
    pub fn load(&mut self, bytes: &[u8], name: &str) -> Result<JsValue, JsValue> {
        Ok(loaded(&self.0.load(bytes, name)?))
    }

    /// Loads a sample shape: `Loaded`. `parameters` is an object of numbers.
    ///
    /// # Errors
    /// Unknown names, values out of range.
    pub fn sample(&mut self, name: &str, parameters: JsValue) -> Result<JsValue, JsValue> {
        let parameters: BTreeMap<String, f64> = from_js(parameters)?;
        let values: Vec<(String, f64)> = parameters.into_iter().collect();
        Ok(loaded(&self.0.sample(name, &values)?))
    }

    /// Chooses flow and parameters, goes back to the start: `Configured`.
    ///
    /// # Errors
    /// Options that cannot be, meshes the flow cannot take.
    pub fn configure(&mut self, options: JsValue) -> Result<JsValue, JsValue> {
        let options: FlowOptions = from_js(options)?;
        Ok(to_js(&self.0.configure(options)?))
    }

    /// Goes on from the surface as it is with other options: `Configured`. Step, time and
    /// history go on too; what was stored to come becomes a branch.
    ///
    /// # Errors
    /// As `configure`, and where edge flips or flows beside each other go from the mesh itself.
    #[wasm_bindgen(js_name = continueWith)]
    pub fn continue_with(&mut self, options: JsValue) -> Result<JsValue, JsValue> {
        let options: FlowOptions = from_js(options)?;
        Ok(to_js(&self.0.continue_with(options)?))
    }

    /// Which of the flows chosen for this mesh stood where the session stands.
    ///
    /// # Errors
    /// Without a mesh.
    #[wasm_bindgen(js_name = flowNumber)]
    pub fn flow_number(&self) -> Result<u32, JsValue> {
        Ok(self.0.flow_number()?)
    }

    /// `FlowOptions` in force where the session stands; null before `configure`.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn options(&self) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.0.options()?))
    }

    /// `Configured` by those; null before `configure`.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn configured(&self) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.0.configured()?))
    }

    /// Takes a step: `StepReport`, or null if there was none to take (see `state`).
    ///
    /// # Errors
    /// Numerical failures; positions stay those before the step.
    pub fn step(&mut self) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.0.step()?))
    }

    /// Conformal regularisation of the surface as it is now: `Regularised`. `options` is
    /// `{ mode?, epsilon?, iterations?, features? }`.
    ///
    /// # Errors
    /// Open and one-sided surfaces.
    pub fn regularise(&mut self, options: JsValue) -> Result<JsValue, JsValue> {
        let options: RegulariseOptions = from_js(options)?;
        Ok(to_js(&self.0.regularise(&options)?))
    }

    /// One step back: `State`.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn back(&mut self) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.0.back()?))
    }

    /// Back to the start: `State`.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn reset(&mut self) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.0.reset()?))
    }

    /// `State`.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn state(&self) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.0.state()?))
    }

    /// Positions for drawing.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn positions(&self) -> Result<Float32Array, JsValue> {
        Ok(Float32Array::from(self.0.positions()?.as_slice()))
    }

    /// Triangles that folded over in the last step.
    ///
    /// # Errors
    /// Without a mesh.
    #[wasm_bindgen(js_name = flippedTriangles)]
    pub fn flipped_triangles(&self) -> Result<Uint32Array, JsValue> {
        Ok(Uint32Array::from(self.0.flipped_triangles()?.as_slice()))
    }

    /// 1 for each vertex that is held, 0 for each that moves; empty before `configure`.
    ///
    /// # Errors
    /// Without a mesh.
    #[wasm_bindgen(js_name = heldVertices)]
    pub fn held_vertices(&self) -> Result<Uint8Array, JsValue> {
        Ok(Uint8Array::from(self.0.held_vertices()?.as_slice()))
    }

    /// `{ absolute, relative, vertices }`: the jump of H across the boundary of what moves;
    /// null where nothing is held next to it.
    ///
    /// # Errors
    /// Without a mesh.
    #[wasm_bindgen(js_name = curvatureJump)]
    pub fn curvature_jump(&self) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.0.curvature_jump()?))
    }

    /// `Field`, or null for `none`.
    ///
    /// # Errors
    /// Unknown names.
    pub fn field(&self, name: &str) -> Result<JsValue, JsValue> {
        Ok(self.0.field(name)?.as_ref().map_or(JsValue::NULL, field))
    }

    /// `Info` of the surface as it is now.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn info(&self) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.0.info()?))
    }

    /// All energies; `options` is `{ p?: number[], boundary? }`.
    ///
    /// # Errors
    /// Unknown options.
    pub fn energy(&self, options: JsValue) -> Result<JsValue, JsValue> {
        let options: EnergyOptions = from_js(options)?;
        Ok(to_js(&self.0.energy(options.boundary, &options.p)?))
    }

    /// The surface as a file.
    ///
    /// # Errors
    /// Unknown formats.
    pub fn export(&self, format: &str) -> Result<Uint8Array, JsValue> {
        let Some(format) = Format::from_name(format) else {
            return Err(refusal(AppError::UnknownFormat {
                name: format.into(),
                known: Format::ALL.map(Format::name).to_vec(),
            }));
        };
        Ok(Uint8Array::from(self.0.export(format)?.as_slice()))
    }

    /// The history as CSV.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn history(&self) -> Result<String, JsValue> {
        Ok(self.0.history_csv()?)
    }

    /// Puts positions from outside in place: `State`.
    ///
    /// # Errors
    /// If they do not fit the mesh.
    pub fn restore(
        &mut self,
        positions: &[f32],
        step: usize,
        time: f64,
    ) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.0.restore(positions, step, time)?))
    }
}
