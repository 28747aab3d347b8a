//! JavaScript class `Session`, the solver's seam; its types are in `www/generated/types.d.ts`.
//!
//! Typed arrays given out are copies owned by JavaScript, safe to transfer.

use crate::app::{AppError, Fault, Progress, RunCommand, Session as Inner, ToolCommand};
use crate::deferred;
use crate::mesh::shape;
use js_sys::{Function, Object};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::cell::Cell;
use std::ops::ControlFlow;
use std::rc::Rc;
use std::time::Duration;
use wasm_bindgen::prelude::*;
use web_time::Instant;

/// Least time between two calls of a callback for progress.
const BETWEEN: Duration = Duration::from_millis(5);

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

pub(super) fn from_js<T: DeserializeOwned>(value: JsValue) -> Result<T, JsValue> {
    serde_wasm_bindgen::from_value(value).map_err(|error| {
        let reason = error.to_string();
        refusal(AppError::BadOptions { reason })
    })
}

/// To be called before anything of the deferred part is.
pub(super) fn load_deferred() -> Result<(), JsValue> {
    let is_there = deferred::load();
    is_there
        .then_some(())
        .ok_or_else(|| refusal(AppError::NotFetched))
}

deferred! {
    fn shapes() -> JsValue {
        to_js(&shape::all())
    }
}

deferred! {
    fn perform_tool(session: &mut Inner, command: JsValue) -> Result<JsValue, JsValue> {
        let command: ToolCommand = from_js(command)?;
        Ok(to_js(&session.perform_tool(command)?))
    }
}

/// One mesh, one flow, its history.
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

    /// Sample shapes: `Shape[]`.
    pub fn shapes() -> JsValue {
        shapes()
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

    /// Calls `callback(stage, share)` every few milliseconds within long work; where it returns true
    /// a step or an edit is given up. Anything but a function clears it.
    #[wasm_bindgen(js_name = onProgress)]
    pub fn on_progress(&mut self, callback: JsValue) {
        self.0
            .set_progress(callback.dyn_into::<Function>().ok().map(|callback| {
                let next = Cell::new(Instant::now());
                let call = move |stage: &str, share: f64| {
                    let now = Instant::now();
                    if now < next.get() {
                        return ControlFlow::Continue(());
                    }
                    next.set(now + BETWEEN);
                    // An exception in a progress bar must not end the step.
                    match callback.call2(&JsValue::NULL, &stage.into(), &share.into()) {
                        Ok(stops) if stops.is_truthy() => ControlFlow::Break(()),
                        _ => ControlFlow::Continue(()),
                    }
                };
                Rc::new(call) as Progress
            }));
    }

    /// Does what a `RunCommand` or a `ToolCommand` asks for: `RunAnswer`, `ToolAnswer`.
    ///
    /// # Errors
    /// What cannot be done, and why; nothing has changed then.
    pub fn perform(&mut self, command: JsValue) -> Result<JsValue, JsValue> {
        let name = Object::try_from(&command).and_then(|it| Object::keys(it).get(0).as_string());
        if !name.is_some_and(|name| RunCommand::NAMES.contains(&name.as_str())) {
            load_deferred()?;
            return perform_tool(&mut self.0, command);
        }
        let command: RunCommand = from_js(command)?;
        if command.asks_for_more() {
            load_deferred()?;
        }
        Ok(to_js(&self.0.perform(command)?))
    }

    /// Everything to be shown now: `Frame`.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn frame(&mut self) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.0.frame()?))
    }
}
