//! Edge-flip optimisation of the loaded mesh.

use super::options::FlipOptions;
use crate::app::document::Document;
use crate::app::fault::Fault;
use crate::app::message::Notice;
use crate::app::runner::Runner;
use crate::energy::circle::angle::Smoothing;
use crate::energy::circle::{Boundary, CircleEnergy};
use crate::geometry::measure;
use crate::interrupt;
use crate::mesh::HalfedgeMesh;
use crate::message::Message;
use crate::remesh::flips::{Flip, FlipOptimiser};
use serde::Serialize;
use std::fmt::Write as _;
use std::rc::Rc;

/// Share of the volume from which flips are said to have cut the shape.
const CUT: f64 = 0.005;

/// Costs before or after.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Costs {
    /// Total area.
    pub area: f64,
    /// W, with a free boundary where there is one.
    pub circle: f64,
}

/// What the flips did.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct FlipOutcome {
    /// Flips made.
    pub flips: usize,
    /// Flips that would have gained and were refused.
    pub rejected: usize,
    /// Before the first.
    pub before: Costs,
    /// After the last.
    pub after: Costs,
    /// What is to be known of it.
    pub warnings: Vec<Message>,
    /// A row a flip with a header, as comma-separated values, if asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub history: Option<String>,
}

impl Runner {
    /// A document with its connectivity, cut into triangles, optimised, which starts at the positions as they are.
    pub(in crate::app) fn flipped(
        &self,
        options: &FlipOptions,
    ) -> Result<(Document, FlipOutcome), Fault> {
        let present = self.present();
        let copy = HalfedgeMesh::clone(&present.triangles);
        let x = Rc::new(self.x.clone());
        let mut optimiser =
            FlipOptimiser::new(copy, Rc::clone(&x), options.criterion, options.guard_folds);
        let costs = |optimiser: &FlipOptimiser| Costs {
            area: optimiser.area(),
            circle: CircleEnergy::new(optimiser.mesh(), Boundary::Free).value(&x, Smoothing::EXACT),
        };
        let before = costs(&optimiser);
        let most = options.max.unwrap_or(usize::MAX);
        while optimiser.flips() < most && interrupt::check().is_ok() && optimiser.step().is_some() {
        }
        let mut outcome = FlipOutcome {
            flips: optimiser.flips(),
            rejected: optimiser.rejected(),
            before,
            after: costs(&optimiser),
            warnings: Vec::new(),
            history: options.history.then(|| history(optimiser.made())),
        };
        let mesh = Rc::new(optimiser.into_mesh());
        let volumes = [&present.triangles, &mesh].map(|mesh| measure::volume(mesh, &x));
        if let [Some(before), Some(after)] = volumes
            && (after - before).abs() > CUT * before.abs()
        {
            let notice = Notice::FlippedVolume { before, after };
            outcome.warnings.push(notice.into());
        }
        let document = Document {
            polygons: Rc::clone(&mesh),
            triangles: mesh,
            ..present
        };
        Ok((document, outcome))
    }
}

fn history(made: &[Flip]) -> String {
    let mut text = String::from("flip,fromA,fromB,toA,toB,reduction,area,circle\n");
    for (number, flip) in (1..).zip(made) {
        let ([a, b], [c, d]) = (flip.before, flip.after);
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{number},{},{},{},{},{},{},{}",
            a.0, b.0, c.0, d.0, flip.reduction, flip.area, flip.willmore
        );
    }
    text
}
