//! The driver's judgement: warnings that hold for every flow, and how a run ends.

use super::driver::Driver;
use super::rules::Ceiling;
use super::signs::{NARROW, SHARPENED, SLIVER, UNDER_RESOLVED, WORN};
use super::termination::{self, Clock, Ending};
use super::{
    Advice, Cause, Cost, Decision, FlowError, Functional, Monitored, Occasion, Phase, Reason,
    Refusal, Status, StepReport, Warning,
};
use crate::geometry::bend::{Sharpest, sharpest};
use crate::geometry::measure;
use crate::geometry::parts::shrunken_part;
use crate::geometry::quality::{flat_triangles, largest_face};
use crate::mesh::Face;
use glam::DVec3;

/// Share of the start's area at which a surface that nothing holds has shrunk to a point; and
/// at which it is about to, where no step is accepted any more.
const VANISHED: f64 = 1e-3;
const VANISHING: f64 = 0.1;
/// Times the start's area at which a surface that grows without end has shown that.
const GROWN: f64 = 100.0;
/// Times its least at which a functional that nothing holds down has risen, so many steps after that.
const RISEN: f64 = 2.0;
const RISING: usize = 100;
/// What vanishes and is still as long as this share of what it was has become no point.
const STILL_LONG: f64 = 0.3;
/// With faces of so many times the mean, and four times what there was at the start, the
/// surface's curvature sits in a few tiny faces and the rest is not resolved; with so many
/// more there is no sense in going on.
const LARGE_FACE: f64 = 40.0;
const HOPELESS_FACE: f64 = 200.0;
const FACE_GROWTH: f64 = 4.0;

/// Something closes between the vertices.
const COLLAPSED: Decision = Decision::Stop(Status::Collapsed, Reason::BelowBound);

impl Driver {
    /// The budget of steps, or else of time: whoever asks for a number of steps gets them.
    pub fn out_of_budget(&self) -> Option<Decision> {
        let steps = self.run.step - self.run.first_step;
        let rules = self.flow.rules();
        if !rules.ends_at_rest && steps >= self.options.smooth_steps {
            let why = Reason::Smoothed { steps };
            return Some(Decision::Stop(Status::StepLimit, why));
        }
        if let Some(most) = self.options.max_steps {
            let why = Reason::StepLimit { steps };
            return (steps >= most).then_some(Decision::Stop(Status::StepLimit, why));
        }
        let most = self.options.max_seconds.filter(|_| rules.ends_at_rest)?;
        let why = Reason::TimeLimit { seconds: most };
        (self.run.seconds >= most).then_some(Decision::Stop(Status::StepLimit, why))
    }

    /// A phase that puts something better in place of what a run is about to end with.
    pub(super) fn better(
        &mut self,
        x: &[DVec3],
        status: Status,
        cost: &mut Cost,
    ) -> Result<Option<Phase>, FlowError> {
        let is_at_rest = status == Status::Converged;
        let occasion = Occasion::Ending { is_at_rest };
        self.flow.next_phase(x, &occasion, cost)
    }

    /// How a run has ended once something better was put in place: not at rest, and not where it
    /// became singular.
    pub(super) fn replaced(&self, ending: Decision) -> Decision {
        let (Decision::Stop(Status::Converged | Status::Singular, _)
        | Decision::Stop(_, Reason::SharpTip { .. })) = ending
        else {
            return ending;
        };
        let advice = self.flow.advice();
        Decision::Stop(Status::Stalled, Reason::WorseRest { advice })
    }

    /// The end of a run at rest, unless the next step puts something better in place.
    fn rested(&mut self, x: &[DVec3], why: Reason, cost: &mut Cost) -> Result<Decision, FlowError> {
        if self.better(x, Status::Converged, cost)?.is_some() {
            self.run.is_exhausted = true;
            return Ok(Decision::GoOn);
        }
        Ok(Decision::Stop(Status::Converged, why))
    }

    /// A functional that is zero up to roundoff cannot fall.
    pub(super) fn is_zero(&self, value: f64) -> Option<Decision> {
        let rules = self.flow.rules();
        (rules.ends_at_rest && value <= rules.zero)
            .then_some(Decision::Stop(Status::Converged, Reason::ZeroEnergy))
    }

    /// Whether there is a next step after an accepted one.
    pub(super) fn decision(
        &mut self,
        x: &[DVec3],
        ending: &Ending,
        report: &mut StepReport,
        cost: &mut Cost,
    ) -> Result<Decision, FlowError> {
        if let Some(decision) = self.is_zero(ending.after.value) {
            return Ok(decision);
        }
        let rules = self.flow.rules();
        if rules.can_vanish && report.area < VANISHED * self.run.first_area {
            return Ok(vanished(self, x));
        }
        let times = report.area / self.run.first_area;
        if rules.grows && times > GROWN {
            return Ok(Decision::Stop(Status::Stalled, Reason::GrowsOn { times }));
        }
        let (face, largest) = largest_face(&self.mesh, x);
        let is_recommended = rules.ceiling != Ceiling::None;
        if is_recommended && largest > HOPELESS_FACE.max(FACE_GROWTH * self.start.largest_face) {
            let why = Reason::LargeFace {
                face,
                times: largest,
            };
            return Ok(Decision::Stop(Status::Stalled, why));
        }
        if let Some(rise) = self.rise(ending.after.value) {
            return Ok(rise);
        }
        if ending.rests {
            return self.rested(x, Reason::Still, cost);
        }
        let occasion = Occasion::Accepted {
            before: ending.before.scale,
            after: ending.after.scale,
        };
        if let Some(phase) = self.flow.next_phase(x, &occasion, cost)? {
            self.begin(phase, &mut report.warnings);
        } else if ending.is_leading {
            // A window that spans the lead would see a fall that is none.
            self.run.window = Default::default();
        } else if self.run.window.is_idle(ending.gain)
            && let Some(decision) = self.idle(x, report, cost)?
        {
            return Ok(decision);
        }
        Ok(self.out_of_budget().unwrap_or(Decision::GoOn))
    }

    /// A functional that nothing holds down, and that has risen for long: what comes of it is no
    /// result of the flow.
    fn rise(&mut self, value: f64) -> Option<Decision> {
        let (least, then) = &mut self.run.least;
        if value <= *least {
            (*least, *then) = (value, self.run.step);
        }
        let times = value / *least;
        let is_long = self.run.step - *then >= RISING;
        let is_free = self.flow.rules().ceiling == Ceiling::None;
        let why = if self.run.step_size.is_given {
            Reason::Rises { times }
        } else {
            let advice = self.flow.advice();
            Reason::RisesOn { times, advice }
        };
        (is_free && is_long && *least > 0.0 && times > RISEN)
            .then_some(Decision::Stop(Status::Stalled, why))
    }

    /// The functional has stopped falling.
    fn idle(
        &mut self,
        x: &[DVec3],
        report: &mut StepReport,
        cost: &mut Cost,
    ) -> Result<Option<Decision>, FlowError> {
        let occasion = Occasion::Idle {
            dt: self.dt(),
            is_guarded: self.run.window.is_guarded(),
        };
        if let Some(phase) = self.flow.next_phase(x, &occasion, cost)? {
            self.begin(phase, &mut report.warnings);
            return Ok(None);
        }
        if self.flow.stationarity(x, cost)? <= 1.0 {
            return Ok(Some(self.rested(x, Reason::AtRest, cost)?));
        }
        if self.run.window.met_bound() {
            return Ok(Some(COLLAPSED));
        }
        if !self.run.step_size.is_given && self.run.window.is_stuck(report.dt) {
            // The next step says so, or puts something better in place.
            self.run.is_exhausted = true;
        }
        self.run.window.next_window();
        Ok(None)
    }

    /// No step was accepted, and there is no other phase.
    pub(super) fn stuck(
        &mut self,
        x: &[DVec3],
        before: Functional,
        cost: &mut Cost,
    ) -> Result<Decision, FlowError> {
        if let Some(flat) = self.flat_at_first(x) {
            return Ok(flat);
        }
        let rules = self.flow.rules();
        if self.run.window.met_bound() || self.is_collapsing(before.value) {
            return Ok(match self.run.step == self.run.first_step {
                true => Decision::Stop(Status::Collapsed, Reason::Unresolved),
                false => COLLAPSED,
            });
        }
        let area = measure::area(&self.mesh, x);
        if rules.can_vanish && area < VANISHING * self.run.first_area {
            return Ok(vanished(self, x));
        }
        let is_at_rest = rules.ceiling != Ceiling::None && self.flow.stationarity(x, cost)? <= 1.0;
        // A run that ended at rest is asked again where something better is put in place.
        if !(is_at_rest && self.run.is_exhausted)
            && let Some(neck) = self.singular(x)
        {
            return Ok(neck);
        }
        if is_at_rest {
            return Ok(Decision::Stop(Status::Converged, Reason::AtRest));
        }
        let advice = self.flow.advice();
        let why = match self.refusal {
            Some(Refusal { cause, .. }) => Reason::Refused { cause, advice },
            None => Reason::Creeping { advice },
        };
        Ok(Decision::Stop(Status::Stalled, why))
    }

    /// No first step leads on from faces that have no area, whatever is read there.
    pub(super) fn flat_at_first(&self, x: &[DVec3]) -> Option<Decision> {
        let is_first = self.run.step == self.run.first_step && self.mesh.is_triangular();
        let is_asked = is_first && x.iter().all(|p| p.is_finite());
        let flat = is_asked.then(|| flat_triangles(&self.mesh, x))?;
        let &Face(face) = flat.first()?;
        let count = flat.len();
        let why = Reason::FlatFace { count, face };
        Some(Decision::Stop(Status::Stalled, why))
    }

    /// Whether no step was accepted as it would go below a theorem's bound; or as triangles
    /// would degenerate on a surface whose energy is below the bound already.
    fn is_collapsing(&self, value: f64) -> bool {
        let is_below = self.flow.rules().bound.is_some_and(|bound| value < bound);
        self.refusal.is_some_and(|refusal| match refusal.cause {
            Cause::Bound => true,
            Cause::Sliver | Cause::Fold | Cause::Turn => is_below,
            _ => false,
        })
    }

    /// What has become singular, where that is why no step was accepted.
    fn singular(&self, x: &[DVec3]) -> Option<Decision> {
        // A flow that lowers the area is the fastest way to less of it, each in its own metric:
        // where no step however small leads to less, the mesh no longer shows the surface.
        let is_geometric = self.run.is_exhausted
            || termination::is_geometric(self.refusal)
            || self.flow.monitored() == Monitored::Area;
        if !self.mesh.is_triangular() || !is_geometric {
            return None;
        }
        singularity(self, x)
    }

    /// What holds for every flow; then what the flow itself has to say.
    pub(super) fn warn(&mut self, x: &[DVec3], report: &mut StepReport) {
        let warnings = &mut report.warnings;
        if report.flipped_faces > 0 {
            let count = report.flipped_faces;
            warnings.push(Warning::FoldedFaces { count });
        }
        let given = &mut self.run.given;
        let (_, times) = largest_face(&self.mesh, x);
        if times > LARGE_FACE.max(FACE_GROWTH * self.start.largest_face) {
            given.give_once(Warning::LargeFace { times }, warnings);
        }
        let (degrees, before) = (report.min_angle_degrees, self.start.angle);
        if degrees < SLIVER && degrees < WORN * before {
            let advice = self.flow.advice();
            let slivers = Warning::Slivers {
                degrees,
                before,
                advice,
            };
            given.give_once(slivers, warnings);
        }
        self.flow.warn(x, report, given);
    }
}

deferred! {
    /// The end of a surface all of which has shrunk to a point or a curve.
    fn vanished(driver: &Driver, x: &[DVec3]) -> Decision {
        let (time, clock) = (driver.run.time, driver.flow.clock());
        let size = measure::bounding_diagonal(x);
        let is_long = size > STILL_LONG * driver.run.first_size;
        // Of several parts those that were smaller may be gone long before.
        let part = is_long.then(|| shrunken_part(&driver.mesh, &driver.start.x, x, VANISHED));
        let why = if let Some(place) = part.flatten() {
            let place = place.to_array();
            Reason::PartVanishes { time, clock, place }
        } else if is_long {
            Reason::VanishesToCurve { time, clock }
        } else {
            let place = (x.iter().sum::<DVec3>() / x.len() as f64).to_array();
            Reason::Vanishes { time, clock, place }
        };
        Decision::Stop(Status::Singular, why)
    }
}

deferred! {
    /// What has become singular of a surface the rest of which is there, one of several parts that has
    /// shrunk to a point or a neck thinner than the mesh can show; or a tip of which that cannot be told.
    fn singularity(driver: &Driver, x: &[DVec3]) -> Option<Decision> {
        let (time, clock) = (driver.run.time, driver.flow.clock());
        if let Some(place) = shrunken_part(&driver.mesh, &driver.start.x, x, VANISHED) {
            let why = Reason::PartVanishes {
                time,
                clock,
                place: place.to_array(),
            };
            return Some(Decision::Stop(Status::Singular, why));
        }
        let Sharpest {
            vertex,
            bend,
            is_neck,
            ring,
            ..
        } = sharpest(&driver.mesh, x)?;
        let then = sharpest(&driver.mesh, &driver.start.x).map_or(0.0, |found| found.bend);
        // What shrinks by its area is drawn straight: it is the mesh that bends so.
        let is_low = is_neck || driver.flow.rules().can_vanish;
        let least = if is_low { NARROW } else { UNDER_RESOLVED };
        if bend < least || bend < SHARPENED * then || !driver.flow.is_free(vertex as usize) {
            return None;
        }
        // All around, as the sharpest vertex itself may lie on any side of it.
        let middle = ring.iter().map(|v| x[*v as usize]).sum::<DVec3>() / ring.len() as f64;
        let place = middle.to_array();
        if !is_neck {
            // Of a tip a mesh does not tell whether the flow draws it to a point.
            let advice = driver.flow.advice();
            let why = Reason::SharpTip {
                vertex,
                place,
                advice,
            };
            return Some(Decision::Stop(Status::Stalled, why));
        }
        let advice = match clock {
            Clock::Own => driver.flow.advice(),
            _ => Advice::KeepVolume,
        };
        let why = Reason::PinchedNeck {
            time,
            clock,
            vertex,
            place,
            advice,
        };
        Some(Decision::Stop(Status::Singular, why))
    }
}
