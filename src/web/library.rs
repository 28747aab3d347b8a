//! Figures of the papers, run and judged: the class `FigureRun`, and what `Session` says of one.

use super::session::{Session, load_deferred, refusal, to_js};
use crate::app::library::{self, Figure};
use crate::app::{AppError, Session as Inner};
use wasm_bindgen::prelude::*;

fn figure(id: &str) -> Result<&'static Figure, JsValue> {
    library::figure(id).ok_or_else(|| refusal(AppError::UnknownFigure { name: id.into() }))
}

deferred! {
    fn figure_run(id: &str) -> Result<FigureRun, JsValue> {
        Ok(FigureRun(library::FigureRun::new(figure(id)?)))
    }
}

deferred! {
    fn advance(run: &mut library::FigureRun) -> Result<JsValue, JsValue> {
        Ok(to_js(&run.advance()?))
    }
}

deferred! {
    fn judged(session: &Inner, id: &str) -> Result<JsValue, JsValue> {
        Ok(to_js(&figure(id)?.judged(session)?))
    }
}

/// A figure under way, on surfaces of its own.
#[wasm_bindgen]
pub struct FigureRun(library::FigureRun);

#[wasm_bindgen]
impl FigureRun {
    /// Makes a surface or takes one step: null, and `Finding` with the last of it.
    ///
    /// # Errors
    /// Whatever refuses; the run cannot go on then.
    pub fn advance(&mut self) -> Result<JsValue, JsValue> {
        advance(&mut self.0)
    }

    /// Steps so far, those on coarser meshes left out.
    #[wasm_bindgen(getter)]
    pub fn steps(&self) -> usize {
        self.0.steps()
    }
}

#[wasm_bindgen]
impl Session {
    /// A run of a figure, which leaves this session as it is.
    ///
    /// # Errors
    /// Unknown ids.
    #[wasm_bindgen(js_name = figureRun)]
    pub fn figure_run(&self, id: &str) -> Result<FigureRun, JsValue> {
        load_deferred()?;
        figure_run(id)
    }

    /// What this session has come to that shows a figure: `Finding`; null where other runs
    /// belong to it, or positions came from outside.
    ///
    /// # Errors
    /// Unknown ids, no mesh.
    pub fn judge(&self, id: &str) -> Result<JsValue, JsValue> {
        load_deferred()?;
        judged(&self.0, id)
    }
}
