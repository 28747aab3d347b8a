//! Random quadrilaterals, and how often the conjecture fails on them by the angle between
//! their faces.

use super::conjecture::{Quadrants, Reductions};
use super::reduction::Quad;
use crate::mesh::noise::SplitMix64;
use glam::DVec3;

/// Upper ends of the classes, in degrees.
pub const CLASSES: [f64; 10] = [0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 180.0];

/// The flattest quadrilaterals are this much as thick as they are wide.
const FLATTEST: f64 = 1e-3;

/// A count that grows as long as it is asked to.
///
/// Every second quadrilateral is of four normally distributed points, a random tetrahedron;
/// the others are flattened in one direction by a random factor, evenly on a logarithmic
/// scale from 1 to 1/1000, so that small angles occur.
pub struct Lab {
    random: SplitMix64,
    /// Of the tetrahedra alone.
    pub tetrahedra: Quadrants,
    /// All of them, by the larger of the angles between the faces before and after the flip.
    pub classes: [Quadrants; CLASSES.len()],
    /// The counterexample with the largest of min(|f_a| over area, |f_l|).
    pub strongest: Option<(Quad, Reductions)>,
}

impl Lab {
    /// With another seed other quadrilaterals.
    pub fn new(seed: u64) -> Self {
        Self {
            random: SplitMix64::new(seed),
            tetrahedra: Quadrants::default(),
            classes: [Quadrants::default(); CLASSES.len()],
            strongest: None,
        }
    }

    /// Draws and counts so many pairs: a tetrahedron, and a flattened one.
    pub fn run(&mut self, pairs: usize) {
        for _ in 0..pairs {
            let reductions = self.count(1.0);
            self.tetrahedra.add(&reductions);
            let thickness = FLATTEST.powf(self.random.uniform());
            self.count(thickness);
        }
    }

    fn count(&mut self, thickness: f64) -> Reductions {
        let random = &mut self.random;
        let mut point = || {
            DVec3::new(
                random.gaussian(),
                random.gaussian(),
                thickness * random.gaussian(),
            )
        };
        let quad = Quad {
            i: point(),
            j: point(),
            k: point(),
            l: point(),
        };
        let reductions = Reductions::of(&quad);
        let angle = quad.fold_degrees().max(quad.flipped().fold_degrees());
        let class = CLASSES.iter().position(|&high| angle < high);
        self.classes[class.unwrap_or(CLASSES.len() - 1)].add(&reductions);
        if !reductions.agree() {
            let strength = |r: &Reductions| r.area.abs().min(r.localised.abs());
            let best = self.strongest.as_ref().map_or(0.0, |(_, r)| strength(r));
            if strength(&reductions) > best {
                self.strongest = Some((quad, reductions));
            }
        }
        reductions
    }
}
