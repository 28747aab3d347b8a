//! What comes with the program: surfaces to begin with, and the figures of the papers with the
//! rules that judge a run of them; a paper without figures has its theorem here.
//!
//! Tables only, and the little that runs them. Words are no part of it: a sample is called
//! `sample-<id>` in the locale files, a figure `figure-<id>`.

mod circle;
mod curvature;
mod eversion;
mod figure;
mod flips;
mod knots;
mod lawson;
pub mod measure;
mod measured;
mod p_willmore;
mod run;
mod sample;
mod volume_preserving;

pub use figure::{Figure, Finding, Parameters, Steps};
pub use run::FigureRun;
pub use sample::{Group, Holes, SAMPLES, Sample, Shape};

/// Every figure of the papers that shows a result, in the order of the gallery.
pub fn figures() -> impl Iterator<Item = &'static Figure> {
    let papers: [&'static [Figure]; 8] = [
        circle::FIGURES,
        p_willmore::FIGURES,
        flips::FIGURES,
        curvature::FIGURES,
        volume_preserving::FIGURES,
        eversion::FIGURES,
        lawson::FIGURES,
        knots::FIGURES,
    ];
    papers.into_iter().flatten()
}

/// The figure of that id.
pub fn figure(id: &str) -> Option<&'static Figure> {
    figures().find(|figure| figure.id == id)
}

/// The sample of that id.
pub fn sample(id: &str) -> Option<&'static Sample> {
    SAMPLES.iter().find(|sample| sample.id == id)
}
