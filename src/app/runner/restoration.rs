//! Surfaces from outside: what a page has kept of a session that is no more.

use super::Runner;
use crate::app::Session;
use crate::app::fault::Fault;
use crate::app::message::AppError;
use crate::app::readings::State;
use crate::app::segment::{Remade, Segment};
use crate::mesh::{self, HalfedgeMesh};
use crate::soup::PolygonSoup;
use glam::DVec3;
use std::rc::Rc;

impl Session {
    /// Puts a surface from outside in place, as after a crash; the history starts anew. The
    /// triangles are those of a [`Frame`](crate::app::Frame) that has some; edge flips are made
    /// again instead, as many as `step`.
    ///
    /// # Errors
    /// If there are not three finite coordinates a vertex, or the triangles are no surface of
    /// these vertices; nothing has changed then.
    pub fn restore(
        &mut self,
        exact: &[f64],
        triangles: Option<&[u32]>,
        step: usize,
        time: f64,
    ) -> Result<State, Fault> {
        let runner = self.ensure_configured()?;
        let state = runner.restore(exact, triangles, step, time)?;
        self.settle_panes();
        Ok(state)
    }
}

impl Runner {
    /// Triangles of its own that the surface has, where they are not those that were loaded.
    pub(in crate::app) fn own_triangles(&self) -> Option<&HalfedgeMesh> {
        let flips = self.engine.as_ref().and_then(|flow| flow.flips());
        let is_own = flips.is_some() || self.segment.remade.is_some();
        is_own.then(|| self.triangles())
    }

    fn restore(
        &mut self,
        exact: &[f64],
        triangles: Option<&[u32]>,
        step: usize,
        time: f64,
    ) -> Result<State, Fault> {
        let is_flips = self.engine.as_ref().is_some_and(|e| e.flips().is_some());
        let own = triangles.filter(|_| !is_flips);
        let vertices = match own {
            Some(_) => exact.len() / 3,
            None => self.document.start.len(),
        };
        if exact.len() != 3 * vertices || exact.iter().any(|c| !c.is_finite()) {
            let coordinates = exact.len();
            return Err(AppError::BadPositions {
                coordinates,
                vertices,
            }
            .into());
        }
        let x: Vec<DVec3> = exact.chunks_exact(3).map(DVec3::from_slice).collect();
        let mesh = own.map(|own| connected(&x, own)).transpose()?;
        if mesh.is_some() || self.segment.remade.is_some() {
            self.stand_on(mesh, &x, step)?;
        }
        self.x = x;
        self.begin_history();
        self.is_restored = true;
        if let Some(flow) = &mut self.engine {
            flow.set_clock(step, time);
        }
        self.state = State {
            step,
            time,
            ..State::default()
        };
        self.read_state();
        // As the run stood at its limit, so that going on is to go beyond.
        if let Some(end) = self.engine.as_ref().and_then(|flow| flow.out_of_budget()) {
            self.end(end);
        }
        Ok(self.state.clone())
    }

    /// Starts the flow on a mesh that a pass made, or on the document's own again.
    fn stand_on(
        &mut self,
        mesh: Option<HalfedgeMesh>,
        x: &[DVec3],
        step: usize,
    ) -> Result<(), Fault> {
        let segment = Segment {
            options: self.options().clone(),
            number: self.next_number(),
            from: step,
            start: Some(x.to_vec()),
            is_pass: mesh.is_some(),
            remade: mesh.map(|mesh| Remade {
                // Passes before this one may have aimed at more than the document has.
                budget: mesh.n_vertices().max(self.document.triangles.n_vertices()),
                mesh: Rc::new(mesh),
                colours: self.document.colours.dropped(),
                lineage: Rc::default(),
            }),
        };
        let old = std::mem::replace(&mut self.segment, Rc::new(segment));
        match self.started() {
            Ok(engine) => self.engine = Some(engine),
            Err(error) => {
                self.segment = old;
                return Err(error.into());
            }
        }
        self.engine_segment = Rc::clone(&self.segment);
        Ok(())
    }
}

/// The mesh of these triangles, which has all the vertices in their order.
fn connected(x: &[DVec3], triangles: &[u32]) -> Result<HalfedgeMesh, Fault> {
    let faces: Vec<&[u32]> = triangles.chunks_exact(3).collect();
    let built = mesh::build_as_given(&PolygonSoup::from_faces(x.to_vec(), &faces))?;
    if built.repairs.is_empty() {
        return Ok(built.mesh);
    }
    Err(AppError::BadPositions {
        coordinates: 3 * x.len(),
        vertices: built.mesh.n_vertices(),
    }
    .into())
}
