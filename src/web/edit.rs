//! What `Session` can do with connectivity: edge flips, pictures side by side, the
//! conjecture, fills, edits and their undoing.

use super::fault::object;
use super::session::{Session, field, floats, from_js, indices, loaded, refusal, to_js};
use crate::app::{
    AppError, Arrangement, ConjectureReport, FillOptions, FlipOptions, Pane, SubdivideOptions,
};
use js_sys::{Float64Array, Function};
use std::ops::ControlFlow;
use wasm_bindgen::prelude::*;

fn pane(p: &Pane) -> JsValue {
    object(&[
        ("name", p.name.into()),
        ("standing", to_js(&p.standing)),
        ("positions", floats(&p.positions)),
        ("triangles", indices(&p.triangles)),
        ("wireEdges", indices(&p.wire_edges)),
        ("boundaryEdges", indices(&p.boundary_edges)),
        ("highlight", indices(&p.highlight)),
        ("field", p.field.as_ref().map_or(JsValue::NULL, field)),
    ])
}

fn conjecture(r: &ConjectureReport) -> JsValue {
    let count = |n: usize| JsValue::from(n as f64);
    object(&[
        ("both", count(r.counts.both)),
        ("neither", count(r.counts.neither)),
        ("areaOnly", count(r.counts.area_only)),
        ("localisedOnly", count(r.counts.localised_only)),
        ("counterexamples", count(r.n_counterexamples)),
        ("corners", indices(&r.corners)),
        ("area", floats(&r.area)),
        ("localised", floats(&r.localised)),
    ])
}

#[wasm_bindgen]
impl Session {
    /// Edge-flip optimisation to the end: `Flipped`. `options` is `{ criterion?, max?,
    /// guardFolds?, history? }`. The mesh that comes of it becomes the start; `undoEdit` brings
    /// back the one before.
    ///
    /// # Errors
    /// Meshes with faces other than triangles.
    pub fn flip(&mut self, options: JsValue) -> Result<JsValue, JsValue> {
        let options: FlipOptions = from_js(options)?;
        Ok(to_js(&self.0.flip(&options)?))
    }

    /// How edge flips are shown and how many a step makes: `{ compare?: 'none' | 'start' |
    /// 'criteria' | 'flows', subdivide?: number, flipsPerStep?: number | null }`.
    ///
    /// # Errors
    /// Unknown options.
    pub fn arrange(&mut self, arrangement: JsValue) -> Result<(), JsValue> {
        let arrangement: Arrangement = from_js(arrangement)?;
        Ok(self.0.arrange(arrangement)?)
    }

    /// The pictures of edge flips or of flows beside each other: `Pane[]`, empty of a single
    /// flow.
    ///
    /// # Errors
    /// Unknown fields.
    pub fn panes(&self, field: &str) -> Result<JsValue, JsValue> {
        let panes = self.0.panes(field)?;
        Ok(panes.iter().map(pane).collect::<js_sys::Array>().into())
    }

    /// Area and W against the number of flips: `Curves`.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn curves(&self) -> Result<JsValue, JsValue> {
        let curves = self.0.curves()?;
        let numbers = |values: &[f64]| Float64Array::from(values).into();
        let runs = js_sys::Array::new();
        for (criterion, area, circle) in &curves.runs {
            runs.push(&object(&[
                ("criterion", (*criterion).into()),
                ("area", numbers(area)),
                ("circle", numbers(circle)),
            ]));
        }
        Ok(object(&[
            ("flips", numbers(&curves.flips)),
            ("runs", runs.into()),
        ]))
    }

    /// f_a against f_l on the surface as it is now: `Conjecture`.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn conjecture(&self) -> Result<JsValue, JsValue> {
        Ok(conjecture(&self.0.conjecture()?))
    }

    /// The numbers of the quadrilateral of vertices i, j, k, l: `Quadrilateral`.
    ///
    /// # Errors
    /// If there is no such vertex.
    pub fn quadrilateral(&self, corners: &[u32]) -> Result<JsValue, JsValue> {
        let Ok(corners) = <[u32; 4]>::try_from(corners) else {
            let corners = corners.len();
            return Err(refusal(AppError::BadQuadrilateral { corners }));
        };
        Ok(to_js(&self.0.quadrilateral(corners)?))
    }

    /// Draws more random quadrilaterals and tells of all: `Lab`; 0 begins anew.
    pub fn lab(&mut self, pairs: usize) -> JsValue {
        to_js(&self.0.lab(pairs))
    }

    /// Makes the surface as it is now the start of what comes: `Loaded`.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn adopt(&mut self) -> Result<JsValue, JsValue> {
        Ok(loaded(&self.0.adopt()?))
    }

    /// Divides each triangle into four: `Loaded`. `options` is `{ scheme?: 'linear' | 'loop' }`.
    ///
    /// # Errors
    /// Meshes with faces other than triangles, or that would become too large.
    pub fn subdivide(&mut self, options: JsValue) -> Result<JsValue, JsValue> {
        let options: SubdivideOptions = from_js(options)?;
        Ok(loaded(&self.0.subdivide(options)?))
    }

    /// Boundary loops of the surface as it is now: `[{ edges, length, vertices }]`.
    ///
    /// # Errors
    /// Without a mesh.
    #[wasm_bindgen(js_name = boundaryLoops)]
    pub fn boundary_loops(&self) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.0.boundary_loops()?))
    }

    /// Fills holes or connects loops: `Filled`. `options` is `{ loops?: 'all' | number[],
    /// connect?, maxVertices? }`. `callback(stage, share)` is told how far it is; answering
    /// `false` cancels. What it amounts to is told by `loaded`.
    ///
    /// # Errors
    /// Closed and one-sided surfaces, loops that touch themselves or cannot be connected.
    pub fn fill(&mut self, options: JsValue, callback: JsValue) -> Result<JsValue, JsValue> {
        let options: FillOptions = from_js(options)?;
        let callback = callback.dyn_into::<Function>().ok();
        let mut progress = |stage: &str, share: f64| {
            let answer = callback
                .as_ref()
                .and_then(|f| f.call2(&JsValue::NULL, &stage.into(), &share.into()).ok());
            match answer.and_then(|answer| answer.as_bool()) {
                Some(false) => ControlFlow::Break(()),
                _ => ControlFlow::Continue(()),
            }
        };
        Ok(to_js(&self.0.fill(&options, &mut progress)?))
    }

    /// The mesh as it is now: `Loaded`.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn loaded(&self) -> Result<JsValue, JsValue> {
        Ok(loaded(&self.0.loaded()?))
    }

    /// Undoes the last edit: `Loaded`.
    ///
    /// # Errors
    /// If there is nothing to undo.
    #[wasm_bindgen(js_name = undoEdit)]
    pub fn undo_edit(&mut self) -> Result<JsValue, JsValue> {
        Ok(loaded(&self.0.undo_edit()?))
    }
}
