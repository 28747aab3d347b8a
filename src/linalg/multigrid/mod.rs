//! Geometric multigrid in single precision: a preconditioner for bending matrices M/dt + K.
//!
//! The hierarchy is made once for a connectivity. Coarse levels are independent sets of the
//! mesh's vertices, values between them come from [planes](prolongation), and matrices are the
//! Galerkin products PᵀAP. An application is a V-cycle with sweeps of Gauss and Seidel, forwards
//! before the coarser levels and backwards after, and so symmetric and positive definite where A
//! is. Numbers of iterations hardly grow with that of rows; work and memory grow linearly.
//!
//! Single precision halves what the sweeps read, and takes the three columns of a field in one
//! vector register. It limits nothing: the residual is that of conjugate gradients in double
//! precision.

mod coarsening;
mod coarsest;
mod galerkin;
mod level;
mod prolongation;
mod rows;

use super::error::LinalgError;
use super::ordering::Graph;
use super::pattern::Pattern;
use coarsest::Coarsest;
use glam::{DVec3, Vec3A};
use level::{Level, SWEEPS};
use rows::Rows;

/// Rows at most of a level that is solved directly …
const DIRECT: usize = 1000;
/// … if coarsening does not end before, for it leaves more than this share of the rows: where
/// most have no neighbour.
const LEAST_COARSENING: f64 = 0.7;

/// A hierarchy, and the matrix it was last given.
pub struct Multigrid {
    pattern: Pattern,
    levels: Vec<Level>,
    coarsest: Coarsest,
}

impl Multigrid {
    /// The hierarchy for matrices of a pattern, whose rows are vertices at `points` with these
    /// `edges` between them.
    ///
    /// # Errors
    /// [`LinalgError::OutOfMemory`], [`LinalgError::IndexOverflow`].
    ///
    /// # Panics
    /// If there is not one point a row, or the edges are of another number of rows.
    pub fn new(pattern: &Pattern, edges: &Pattern, points: &[DVec3]) -> Result<Self, LinalgError> {
        let n = pattern.n();
        assert!(n == edges.n() && n == points.len(), "one vertex a row");
        let mut graph = Graph::new(edges);
        let mut points = points.to_vec();
        let mut a = Rows::of_pattern(pattern);
        let mut levels = Vec::new();
        while a.n() > DIRECT {
            let set = coarsening::independent_set(&graph);
            if set.len() as f64 > LEAST_COARSENING * a.n() as f64 {
                break;
            }
            let numbers = coarsening::numbers(&set, a.n());
            let p = prolongation::prolongation(&graph, &points, &numbers, set.len());
            graph = coarsening::coarse_graph(&graph, &p);
            points = set.iter().map(|&i| points[i as usize]).collect();
            let level;
            (level, a) = Level::new(a, p);
            levels.push(level);
        }
        Ok(Self {
            pattern: pattern.clone(),
            levels,
            coarsest: Coarsest::new(a, &points)?,
        })
    }

    /// Rows of each level, the finest first.
    pub fn sizes(&self) -> Vec<usize> {
        let levels = self.levels.iter().map(|level| level.a.n());
        levels.chain([self.coarsest.a.n()]).collect()
    }

    /// Multiplications of an update, each by a single number.
    pub fn update_operations(&self) -> usize {
        let levels = self.levels.iter();
        levels.map(|l| l.galerkin.operations(&l.a, &l.p)).sum()
    }

    /// Multiplications of an application, each of an entry with a vector of three.
    pub fn cycle_operations(&self) -> usize {
        let levels = self.levels.iter();
        let of_levels: usize = levels
            .map(|l| (2 * SWEEPS + 1) * l.a.len() + 2 * l.p.len())
            .sum();
        of_levels + 2 * self.coarsest.factor_len()
    }

    /// Takes a matrix, one value a slot of the pattern; answers whether the coarsest one is
    /// positive definite, as all are where the matrix is.
    ///
    /// # Errors
    /// [`LinalgError::ZeroPivot`], [`LinalgError::NonFiniteEntry`], in the numbering of the
    /// coarsest level.
    pub fn update(&mut self, values: &[f64]) -> Result<bool, LinalgError> {
        let diagonal = self.pattern.diagonal_slots().iter();
        let largest = diagonal
            .map(|&slot| values[slot as usize].abs())
            .fold(f64::MIN_POSITIVE, larger);
        // The unit of the matrix must not leave the range of single precision. The factor it
        // leaves in the preconditioner is none to conjugate gradients.
        let finest = match self.levels.first_mut() {
            Some(level) => &mut level.a,
            None => &mut self.coarsest.a,
        };
        finest.take(&self.pattern, values, largest.recip());
        for k in 0..self.levels.len() {
            let (finer, coarser) = self.levels.split_at_mut(k + 1);
            let coarse = match coarser.first_mut() {
                Some(level) => &mut level.a,
                None => &mut self.coarsest.a,
            };
            finer[k].update(coarse);
        }
        self.coarsest.update()
    }

    /// Replaces one field by an approximation of s A⁻¹ times it, for a fixed s > 0.
    ///
    /// # Panics
    /// If the field has not one vector a row, or no matrix was taken.
    pub fn apply(&mut self, field: &mut [DVec3]) {
        assert_eq!(field.len(), self.pattern.n(), "one vector a row");
        let size = field
            .iter()
            .flat_map(|v| v.to_array())
            .fold(0.0, |m: f64, c| larger(m, c.abs()));
        if size == 0.0 {
            return;
        }
        let unit = size.max(f64::MIN_POSITIVE).recip();
        let b = match self.levels.first_mut() {
            Some(level) => &mut level.b,
            None => &mut self.coarsest.field,
        };
        for (b, v) in b.iter_mut().zip(&*field) {
            *b = (*v * unit).as_vec3a();
        }
        let x = cycle(&mut self.levels, &mut self.coarsest);
        for (v, x) in field.iter_mut().zip(x) {
            *v = x.as_dvec3() * size;
        }
    }
}

/// As `f64::max` of numbers, which in wasm is the call of a function.
fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// A V-cycle from the first of the levels, whose right-hand side is there; answers the solution.
fn cycle<'a>(levels: &'a mut [Level], coarsest: &'a mut Coarsest) -> &'a [Vec3A] {
    let Some((level, coarser)) = levels.split_first_mut() else {
        coarsest.solve();
        return &coarsest.field;
    };
    level.smooth_from_zero();
    level.restrict(match coarser.first_mut() {
        Some(next) => &mut next.b,
        None => &mut coarsest.field,
    });
    level.correct(cycle(coarser, coarsest));
    level.smooth_backwards();
    &level.x
}
