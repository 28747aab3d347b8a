//! Passes of remeshing between the steps of a flow.
//!
//! A pass begins a segment of the run, with a mesh of its own, as a change of the flow does:
//! going back, branches and what is stored need to know nothing else of it. When one is due
//! follows from the surface and the number of steps since the last; so a run that is done again
//! makes the same passes at the same steps, and no recipe has to list them.
//!
//! Energies are hardly compared across a pass. That of a worn mesh is too low as often as too high,
//! so a pass may raise it; refusing those that do would keep exactly the meshes that need one. But one
//! that makes a multiple of it has crumpled the surface, as about a spike: then edges are made of one
//! length; or, as of a rough scan or a part of a machine with long thin triangles, all is meshed anew;
//! or there is no pass.

use super::Runner;
use crate::app::colours::Colours;
use crate::app::document::Document;
use crate::app::engine::Checkpoint;
use crate::app::fault::Fault;
use crate::app::history::{Event, Snapshot};
use crate::app::lineage::Lineage;
use crate::app::readings::State;
use crate::app::segment::{Remade, Segment};
use crate::energy::p_willmore::integrated_power;
use crate::flow::constraint::Kept;
use crate::flow::options::{FlowOptions, Remeshing};
use crate::flow::{Decision, FlowError, Pass, Status, StepReport};
use crate::geometry::measure;
use crate::interrupt;
use crate::remesh::Mode;
use crate::remesh::adaptive::{self, Counts, Kind, RemeshError, Soundness, Targets};
use crate::soup::PolygonSoup;
use glam::DVec3;
use std::rc::Rc;
use web_time::Instant;

/// Steps between two looks at the mesh.
const EVERY: usize = 10;
/// Degrees that a pass is to add to the smallest angle where it does little else.
const GAIN: f64 = 3.0;
/// Times its ∫H² to which a pass may raise that of a worn mesh, where it began with less.
const RISEN: f64 = 1.3;
/// Vertices with which most shapes can be meshed well.
const ENOUGH: usize = 1500;
/// Steps after a pass before there can be another.
const REST: usize = 3;

/// What a pass makes.
struct Made {
    remade: Remade,
    positions: Vec<DVec3>,
    counts: Counts,
    is_settled: bool,
}

/// A way to another mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Way {
    Pass(Kind),
    /// Until the mesh is as good as it gets, with vertices enough for that.
    Renewal,
}

deferred! {
    fn made(runner: &Runner, way: Way, targets: Targets) -> Result<Made, RemeshError> {
        let (mesh, x) = (runner.triangles(), &runner.x);
        let (made, budget) = match way {
            Way::Pass(kind) => {
                let budget = runner.budget();
                (adaptive::pass(mesh, x, kind, budget, targets)?, budget)
            }
            Way::Renewal => {
                let budget = runner.budget().max(ENOUGH);
                (adaptive::renewal(mesh, x, Kind::Isotropic, budget, targets)?, budget)
            }
        };
        let origins = &made.origins;
        Ok(Made {
            is_settled: made.is_settled(),
            counts: made.counts,
            remade: Remade {
                colours: runner.colours().interpolated(origins),
                lineage: Lineage::after(runner.lineage(), origins, mesh),
                mesh: Rc::new(made.mesh),
                budget,
            },
            positions: made.positions,
        })
    }
}

impl Runner {
    /// What kind of passes there are under the options in force, on this surface.
    pub(in crate::app) fn passes(&self) -> Option<Kind> {
        self.passes_under(self.options())
    }

    fn passes_under(&self, options: &FlowOptions) -> Option<Kind> {
        let mesh = &self.document.polygons;
        let is_fit = mesh.is_triangular() && mesh.is_closed() && mesh.is_oriented();
        let kind = match options.remeshing() {
            Remeshing::Off => return None,
            Remeshing::Adaptive => Kind::Adaptive,
            Remeshing::Isotropic => Kind::Isotropic,
        };
        is_fit.then_some(kind)
    }

    /// The options that the flow itself is started with. Passes do what regularisation does, at a
    /// quarter of the price; and a start is perturbed once.
    pub(super) fn effective(&self, options: &FlowOptions, after_pass: bool) -> FlowOptions {
        let mut options = options.clone();
        if self.passes_under(&options).is_some() {
            options.regularise = Mode::Off;
        }
        if after_pass {
            options.perturbation = 0.0;
        }
        options
    }

    fn steps_since_pass(&self) -> usize {
        self.state.step - self.segment.from
    }

    /// Vertices that a pass aims at: those of the start, or of what took its place.
    fn budget(&self) -> usize {
        let remade = self.segment.remade.as_ref();
        remade.map_or(self.document.triangles.n_vertices(), |remade| remade.budget)
    }

    /// Whether the next step is to begin with a pass.
    pub(super) fn is_pass_due(&self) -> Option<Kind> {
        let kind = self.passes()?;
        let steps = self.steps_since_pass();
        let mesh = self.triangles();
        let is_due = steps >= REST && adaptive::is_urgent(mesh, &self.x)
            || self.is_unfit()
            || steps > 0
                && steps.is_multiple_of(EVERY)
                && adaptive::is_due(mesh, &self.x, kind, self.budget());
        is_due.then_some(kind)
    }

    /// Whether the mesh as it was given is one that no step does good to.
    fn is_unfit(&self) -> bool {
        self.steps_since_pass() == 0
            && self.segment.remade.is_none()
            && adaptive::is_unfit(self.triangles(), &self.x)
    }

    /// Whether a pass may help where the flow has come to an end of its own.
    pub(super) fn can_pass_at(&self, decision: &Decision) -> Option<Kind> {
        let kind = self.passes()?;
        let Decision::Stop(status, why) = decision else {
            return None;
        };
        let helps = match status {
            // What has vanished is gone on any mesh.
            Status::Singular => !why.is_of_vanishing(),
            Status::Stalled | Status::Collapsed => true,
            // At rest on a worn mesh is no rest.
            Status::Converged => adaptive::is_due(self.triangles(), &self.x, kind, self.budget()),
            Status::Ready | Status::StepLimit | Status::Failed => false,
        };
        (helps && self.steps_since_pass() >= REST).then_some(kind)
    }

    /// ∫H² after a pass over what it may be: that before, or what the run began with.
    fn rises(&self, made: &Made) -> f64 {
        let Document {
            triangles, start, ..
        } = &self.document;
        let first = integrated_power(triangles, start, 2.0);
        let before = integrated_power(self.triangles(), &self.x, 2.0);
        integrated_power(&made.remade.mesh, &made.positions, 2.0) / first.max(RISEN * before)
    }

    /// Whether a mesh is one of the same surface, and good enough to begin with. The sharp edges of a
    /// file's own mesh have the more ∫H² the finer they are.
    fn is_good(&self, way: Way, made: &Made) -> bool {
        let (mesh, x) = (&made.remade.mesh, &made.positions);
        let is_even = || adaptive::alignment(mesh, x) > 0.0 && !adaptive::is_urgent(mesh, x);
        let is_first = self.segment.remade.is_none();
        self.rises(made) <= 1.0 || way == Way::Renewal && is_first && is_even()
    }

    /// Makes a pass, and tells its milliseconds; `None` where the surface would not have stayed the
    /// same, or the mesh would.
    ///
    /// # Errors
    /// As [`Driver::start`](crate::flow::Driver::start), if memory is short; nothing has changed.
    pub(super) fn pass(
        &mut self,
        kind: Kind,
        snapshot: Option<Snapshot>,
    ) -> Result<Option<(Pass, f64)>, Fault> {
        let watch = Instant::now();
        let pass = self.attempt(kind, snapshot)?;
        let seconds = watch.elapsed().as_secs_f64();
        // A step's own time is counted by the flow.
        if let Some(engine) = &mut self.engine {
            engine.spend(seconds);
        }
        Ok(pass.map(|pass| (pass, 1e3 * seconds)))
    }

    /// The first good mesh, of the ways in their order.
    fn best_made(&self, kind: Kind, targets: Targets) -> Result<Option<Made>, Fault> {
        let passes = match kind {
            _ if self.is_unfit() => &[][..],
            Kind::Adaptive => &[Way::Pass(Kind::Adaptive), Way::Pass(Kind::Isotropic)],
            Kind::Isotropic => &[Way::Pass(Kind::Isotropic)],
        };
        for &way in passes.iter().chain(&[Way::Renewal]) {
            // It takes longer, and is not tried before every step.
            let steps = self.steps_since_pass();
            if way == Way::Renewal && steps > REST && !steps.is_multiple_of(EVERY) {
                continue;
            }
            let made = made(self, way, targets);
            interrupt::check().map_err(FlowError::from)?;
            let made = made.ok().filter(|made| self.is_good(way, made));
            if made.is_some() {
                return Ok(made);
            }
        }
        Ok(None)
    }

    fn attempt(&mut self, kind: Kind, snapshot: Option<Snapshot>) -> Result<Option<Pass>, Fault> {
        let keeps_volume = self.options().keep.contains(&Kept::Volume);
        let targets = Targets {
            area: self.state.area,
            volume: self.state.volume.filter(|_| keeps_volume),
        };
        let before = measure::min_angle_degrees(self.triangles(), &self.x);
        let Some(made) = self.best_made(kind, targets)? else {
            return Ok(None);
        };
        // A mesh that is as good as it gets would be flipped to and fro, and the flow never rest.
        let after = measure::min_angle_degrees(&made.remade.mesh, &made.positions);
        if made.is_settled && after < before + GAIN {
            return Ok(None);
        }
        let Some(Checkpoint::Flow(checkpoint)) = self.checkpoint() else {
            return Ok(None);
        };
        let segment = Segment {
            options: self.options().clone(),
            number: self.next_number(),
            from: self.state.step,
            start: Some(made.positions.clone()),
            remade: Some(made.remade),
            is_pass: true,
        };
        let old = std::mem::replace(&mut self.segment, Rc::new(segment));
        let mut engine = match self.started() {
            Ok(engine) => engine,
            Err(error) => {
                self.segment = old;
                return Err(error.into());
            }
        };
        engine.go_on_after_pass(checkpoint);
        if let Some(mut before) = self.engine.replace(engine) {
            // Not for what it weighs: the flow may have to go back there.
            before.release();
            self.aside = Some(before);
        }
        self.engine_segment = Rc::clone(&self.segment);
        self.x = made.positions;
        let energy = self.state.objective;
        self.state = State {
            step: self.state.step,
            time: self.state.time,
            ..State::default()
        };
        self.follow(snapshot, Event::Pass, None);
        self.read_state();
        self.state.soundness = self.soundness();
        let pass = Pass {
            after_step: self.state.step,
            vertices: self.x.len(),
            splits: made.counts.splits,
            collapses: made.counts.collapses,
            flips: made.counts.flips,
            angles: [before, self.state.min_angle_degrees],
            objective: [energy, self.state.objective],
        };
        Ok(Some(pass))
    }

    /// Whether readings of the surface as it is now can be believed; `None` of open and one-sided
    /// ones.
    pub(in crate::app) fn soundness(&self) -> Option<Soundness> {
        let (mesh, x) = (self.triangles(), &self.x);
        let is_closed = mesh.is_closed() && mesh.is_oriented();
        is_closed.then(|| Soundness::of(mesh, x, integrated_power(mesh, x, 2.0)))
    }

    /// A step on the mesh that a pass has made, which is taken back where there is none to take.
    pub(super) fn step_after(
        &mut self,
        pass: (Pass, f64),
        extends: bool,
    ) -> Result<Option<StepReport>, Fault> {
        let (report, decision) = self.flow_step(self.copied(), Some(pass), extends)?;
        if report.is_none() {
            self.take_pass_back();
        }
        self.end(decision);
        Ok(report)
    }

    /// Takes back a pass that no step followed.
    fn take_pass_back(&mut self) {
        self.back();
        self.history.drop_future();
    }
}

impl Runner {
    /// Faces as they are now, in the file's coordinates and colours.
    pub(in crate::app) fn soup(&self) -> PolygonSoup {
        let x = self.document.frame.leave(&self.x);
        PolygonSoup {
            colours: self.colours().list().to_vec(),
            ..self.polygons().to_soup(&x)
        }
    }

    /// What the file gave the vertices that there are now.
    pub(in crate::app) fn colours(&self) -> &Colours {
        let remade = self.segment.remade.as_ref();
        remade.map_or(&self.document.colours, |remade| &remade.colours)
    }

    /// Which meshes the one that there is now came of.
    pub(in crate::app) fn lineage(&self) -> &Rc<Lineage> {
        let remade = self.segment.remade.as_ref();
        remade.map_or(&self.document.lineage, |remade| &remade.lineage)
    }
}
