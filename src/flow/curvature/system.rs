//! The linear system of a step, with one unknown a vertex.
//!
//! In the paper's system of 3n unknowns each row has the factor n_i: every vertex moves along
//! its normal, r' = r + φn. With that H' = H + Bφ and K' = K + Gφ,
//!
//! ```math
//! B_{ij} = -\tfrac12 \Delta_{ij} \langle n_i, n_j \rangle, \qquad G_{ij} = k_{ij} \langle n_i, n_j \rangle,
//! ```
//!
//! and a velocity V_i = Σ q_ij H_j + k_i K_i gives (1/dt − QB − diag(k) G) φ = V: the same
//! solution from a third of the unknowns and a ninth of the entries.

use super::curvatures::Curvatures;
use super::law::Law;
use super::region::Region;
use super::solver::{Equations, LinearSolver, Quality, Reference};
use super::velocity::Velocity;
use crate::flow::FlowError;
use crate::interrupt::{self, paced};
use crate::linalg::{Pattern, Unsymmetric};
use crate::mesh::HalfedgeMesh;
use crate::operator::FittedOperators;
use glam::DVec3;
use std::rc::Rc;

const NONE: u32 = u32::MAX;

/// Where the matrix may be non-zero.
pub(super) struct Structure {
    pub(super) pattern: Pattern,
    /// Rows as they come from the stencils, which need not be symmetric.
    starts: Vec<u32>,
    columns: Vec<u32>,
    slots: Vec<u32>,
    /// Operators whose stencils these are.
    stencils: FittedOperators,
}

/// What stays the same in a run.
pub(super) struct Setting<'a> {
    pub(super) mesh: &'a HalfedgeMesh,
    pub(super) region: &'a Region,
    /// Positions at the start: the order of elimination goes by them, so that it does not depend on
    /// when it was found.
    pub(super) start: &'a [DVec3],
}

/// The system of one law; what depends on the stencils alone is kept from step to step, and a factor
/// as long as it serves.
pub(super) struct CurvatureSystem {
    law: Law,
    row_of_vertex: Vec<u32>,
    structure: Option<(Structure, LinearSolver)>,
    /// The matrix whose factor serves, be it made already or not.
    reference: Option<Rc<Reference>>,
    matrix: Unsymmetric,
    velocity: Velocity,
}

impl CurvatureSystem {
    pub(super) fn new(law: Law, region: &Region) -> Self {
        let mut row_of_vertex = vec![NONE; region.is_free.len()];
        for (row, &v) in region.free.iter().enumerate() {
            row_of_vertex[v as usize] = row as u32;
        }
        Self {
            law,
            velocity: Velocity::new(row_of_vertex.len()),
            row_of_vertex,
            structure: None,
            reference: None,
            matrix: Unsymmetric::default(),
        }
    }

    /// Lets go of the factor and what it takes to make it.
    pub(super) fn release(&mut self) {
        self.structure = None;
        self.matrix = Unsymmetric::default();
    }

    pub(super) fn law(&self) -> Law {
        self.law
    }

    pub(super) fn reference(&self) -> Option<Rc<Reference>> {
        self.reference.clone()
    }

    /// Goes on with the factor of that matrix, which is made again where it is another.
    pub(super) fn refer_to(&mut self, reference: Option<Rc<Reference>>) {
        self.reference = reference;
    }

    /// V at the free vertices; at some where the work is given up.
    pub(super) fn velocities(
        &mut self,
        at: &Curvatures,
        region: &Region,
    ) -> Result<Vec<f64>, FlowError> {
        let mut values = Vec::with_capacity(region.free.len());
        for &i in paced(&region.free) {
            self.law.linearise(at, i as usize, &mut self.velocity)?;
            values.push(self.velocity.value(at, i as usize));
        }
        Ok(values)
    }

    /// φ at the free vertices of positions `x`, where the curvatures are `at`.
    pub(super) fn solve(
        &mut self,
        setting: &Setting<'_>,
        x: &[DVec3],
        at: &Curvatures,
        dt: f64,
    ) -> Result<(Vec<f64>, Quality), FlowError> {
        let watch = web_time::Instant::now();
        let mut quality = Quality::default();
        interrupt::tell("assemble", 0.1);
        self.analyse(setting, at)?;
        self.factor_again(setting, dt, &mut quality)?;
        let region = setting.region;
        let rhs = self.assemble(at, region, dt)?;
        interrupt::check()?;
        quality.assemble = watch.elapsed().as_secs_f64() - quality.factor;
        interrupt::tell("factor", 0.3);
        let Some((structure, solver)) = &mut self.structure else {
            return Ok((Vec::new(), quality));
        };
        let make_laplacian = || laplacian(at, region, &self.row_of_vertex);
        let system = Equations {
            pattern: &structure.pattern,
            matrix: &self.matrix,
            laplacian: &make_laplacian,
            power: self.law.order() / 2,
            dt,
        };
        let here = Reference { x: x.to_vec(), dt };
        let phi = solver.solve(&system, here, &mut self.reference, &rhs, &mut quality)?;
        Ok((phi, quality))
    }

    /// Finds the structure of the matrix, where the stencils are others than before.
    fn analyse(&mut self, setting: &Setting<'_>, at: &Curvatures) -> Result<(), FlowError> {
        let is_current =
            |(s, _): &(Structure, LinearSolver)| s.stencils.has_stencils_of(&at.operators);
        if self.structure.as_ref().is_some_and(is_current) {
            return Ok(());
        }
        // The old factor goes first: wasm memory never shrinks.
        self.structure = None;
        let Setting { region, start, .. } = setting;
        let structure =
            Structure::new(&self.row_of_vertex, region, &at.operators, self.law.depth())?;
        let points: Vec<DVec3> = region.free.iter().map(|&v| start[v as usize]).collect();
        interrupt::check()?;
        let solver = LinearSolver::new(&structure.pattern, &points)?;
        interrupt::check()?;
        self.matrix = Unsymmetric::zeros(&structure.pattern);
        self.structure = Some((structure, solver));
        Ok(())
    }

    /// Makes the factor of the reference, where the one at hand is another: after a step back, or
    /// what else let go of it. There is no reference any more that has another step size or other
    /// stencils.
    fn factor_again(
        &mut self,
        setting: &Setting<'_>,
        dt: f64,
        quality: &mut Quality,
    ) -> Result<(), FlowError> {
        let kept = self.reference.take().filter(|kept| kept.dt == dt);
        let (Some(reference), Some((structure, solver))) = (kept, &self.structure) else {
            return Ok(());
        };
        if !solver.has_factor_of(&reference) {
            let there = Curvatures::of(setting.mesh, &reference.x, setting.region);
            interrupt::check()?;
            if !structure.stencils.has_stencils_of(&there.operators) {
                return Ok(());
            }
            self.assemble(&there, setting.region, dt)?;
            interrupt::check()?;
            let watch = web_time::Instant::now();
            if let Some((_, solver)) = &mut self.structure {
                solver.factor(&self.matrix, &reference)?;
            }
            quality.factor = watch.elapsed().as_secs_f64();
        }
        self.reference = Some(reference);
        Ok(())
    }

    /// Writes the matrix; answers the right-hand side, V.
    fn assemble(
        &mut self,
        at: &Curvatures,
        region: &Region,
        dt: f64,
    ) -> Result<Vec<f64>, FlowError> {
        let mut rhs = Vec::with_capacity(region.free.len());
        let Some((structure, _)) = &self.structure else {
            return Ok(rhs);
        };
        let mut work = vec![0.0; region.free.len()];
        for (row, &i) in region.free.iter().enumerate() {
            if row.is_multiple_of(1024) {
                interrupt::check()?;
            }
            self.law.linearise(at, i as usize, &mut self.velocity)?;
            rhs.push(self.velocity.value(at, i as usize));
            add_row(
                at,
                i as usize,
                &self.velocity,
                &self.row_of_vertex,
                &mut work,
            )?;
            let range = structure.starts[row] as usize..structure.starts[row + 1] as usize;
            for k in range {
                let column = structure.columns[k] as usize;
                let value = std::mem::take(&mut work[column]);
                let slot = structure.slots[k] as usize;
                if row > column {
                    self.matrix.lower[slot] = -value;
                } else if row < column {
                    self.matrix.upper[slot] = -value;
                } else {
                    self.matrix.lower[slot] = 1.0 / dt - value;
                }
            }
        }
        Ok(rhs)
    }
}

impl Structure {
    fn new(
        row_of_vertex: &[u32],
        region: &Region,
        operators: &FittedOperators,
        depth: usize,
    ) -> Result<Self, FlowError> {
        let mut starts = vec![0];
        let mut columns: Vec<u32> = Vec::new();
        let mut is_seen = vec![NONE; row_of_vertex.len()];
        let mut reached: Vec<u32> = Vec::new();
        for &i in &region.free {
            if i.is_multiple_of(1024) {
                interrupt::check()?;
            }
            reached.clear();
            reached.push(i);
            is_seen[i as usize] = i;
            let mut begin = 0;
            for _ in 0..=depth {
                let end = reached.len();
                for k in begin..end {
                    let vertex = reached[k];
                    let row = operators
                        .row(vertex as usize)
                        .ok_or(FlowError::Unfit { vertex })?;
                    for &j in operators.members(row) {
                        if is_seen[j as usize] != i {
                            is_seen[j as usize] = i;
                            reached.push(j);
                        }
                    }
                }
                begin = end;
            }
            let rows = reached.iter().map(|&j| row_of_vertex[j as usize]);
            columns.extend(rows.filter(|&row| row != NONE));
            starts.push(columns.len() as u32);
        }
        interrupt::check()?;
        let n = region.free.len();
        let pairs = (0..n).flat_map(|i| {
            let range = starts[i] as usize..starts[i + 1] as usize;
            columns[range].iter().map(move |&j| [i as u32, j])
        });
        let pattern = Pattern::from_cliques(n, pairs.clone());
        let mut slots = Vec::with_capacity(columns.len());
        for (k, [i, j]) in pairs.enumerate() {
            if k.is_multiple_of(1 << 16) {
                interrupt::check()?;
            }
            slots.push(pattern.slot(i, j) as u32);
        }
        Ok(Self {
            pattern,
            slots,
            starts,
            columns,
            stencils: operators.clone(),
        })
    }
}

/// Row of QB + diag(k) G, by columns of free vertices.
fn add_row(
    at: &Curvatures,
    i: usize,
    velocity: &Velocity,
    row_of_vertex: &[u32],
    work: &mut [f64],
) -> Result<(), FlowError> {
    let operators = &at.operators;
    let normal = |v: u32| at.row(v as usize).map(|row| operators.normal(row));
    for (j, q) in velocity.on_curvature() {
        let row = at.row(j)?;
        let n = operators.normal(row);
        for (&l, weight) in operators.members(row).iter().zip(operators.laplacian(row)) {
            let column = row_of_vertex[l as usize];
            if column != NONE {
                work[column as usize] -= 0.5 * q * weight * n.dot(normal(l)?);
            }
        }
    }
    if velocity.on_gauss != 0.0 {
        let row = at.row(i)?;
        let n = operators.normal(row);
        for (&l, weight) in operators.members(row).iter().zip(operators.gauss(row)) {
            let column = row_of_vertex[l as usize];
            if column != NONE {
                work[column as usize] += velocity.on_gauss * weight * n.dot(normal(l)?);
            }
        }
    }
    Ok(())
}

/// Δ among the free vertices.
fn laplacian(at: &Curvatures, region: &Region, row_of_vertex: &[u32]) -> (Pattern, Unsymmetric) {
    let row_members = |i: u32| {
        let row = at.operators.row(i as usize);
        let members = row.map(|row| at.operators.members(row)).unwrap_or_default();
        let weights = row
            .map(|row| at.operators.laplacian(row))
            .unwrap_or_default();
        members.iter().zip(weights)
    };
    let pairs = region.free.iter().flat_map(|&i| {
        row_members(i).filter_map(move |(&j, _)| {
            let (row, column) = (row_of_vertex[i as usize], row_of_vertex[j as usize]);
            (column != NONE).then_some([row, column])
        })
    });
    let pattern = Pattern::from_cliques(region.free.len(), pairs);
    let mut values = Unsymmetric::zeros(&pattern);
    for (row, &i) in region.free.iter().enumerate() {
        for (&j, weight) in row_members(i) {
            let column = row_of_vertex[j as usize];
            if column == NONE {
                continue;
            }
            let slot = pattern.slot(row as u32, column);
            let triangle = if row >= column as usize {
                &mut values.lower
            } else {
                &mut values.upper
            };
            triangle[slot] = *weight;
        }
    }
    (pattern, values)
}

#[cfg(test)]
mod tests {
    use super::super::solver::MAX_KEPT;
    use super::*;
    use crate::mesh::{build, shape};

    const LAWS: [Law; 4] = [
        Law::MeanCurvature,
        Law::SurfaceDiffusion,
        Law::Willmore,
        Law::CurvatureVariation,
    ];

    /// The patch of figure 5.6, and what it takes to ask for a law's update.
    struct Patch {
        mesh: HalfedgeMesh,
        region: Region,
        x: Vec<DVec3>,
    }

    impl Patch {
        fn new(law: Law) -> Self {
            let sample = shape::make("four-bumps", &[]).expect("a shape");
            let built = build(&sample.soup).expect("a surface");
            let (mesh, x) = (built.mesh, built.positions);
            let mut is_free = vec![false; x.len()];
            for v in sample.free.expect("a patch") {
                is_free[v as usize] = true;
            }
            let region = Region::new(&mesh, &x, is_free, law.depth());
            Self { mesh, region, x }
        }

        fn solve(&self, system: &mut CurvatureSystem, x: &[DVec3], dt: f64) -> (Vec<f64>, Quality) {
            let Self { mesh, region, .. } = self;
            let at = Curvatures::of(mesh, x, region);
            let setting = Setting {
                mesh,
                region,
                start: &self.x,
            };
            system.solve(&setting, x, &at, dt).expect("a solution")
        }
    }

    fn difference(a: &[f64], b: &[f64]) -> f64 {
        let size = a.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let pairs = a.iter().zip(b);
        pairs.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) / size
    }

    #[test]
    fn iteration_and_elimination_give_the_same_update() {
        for law in LAWS {
            let patch = Patch::new(law);
            let (region, x) = (&patch.region, &patch.x);
            for tau in [1e-4, 1.0] {
                let dt = tau * region.length.powi(law.order());
                let mut system = CurvatureSystem::new(law, region);
                let (direct, quality) = patch.solve(&mut system, x, dt);
                assert!(quality.residual < 1e-9 && !quality.is_iterative);
                let points: Vec<DVec3> = region.free.iter().map(|&v| x[v as usize]).collect();
                if let Some((_, solver)) = &mut system.structure {
                    *solver = LinearSolver::Iterative(points);
                }
                let (iterated, quality) = patch.solve(&mut system, x, dt);
                assert!(quality.is_iterative && quality.residual < 1e-5);
                assert!(quality.iterations < 80, "{law:?}: {}", quality.iterations);
                let found = difference(&direct, &iterated);
                assert!(found < 1e-4, "{law:?}, τ {tau}: {found}");
            }
        }
    }

    #[test]
    fn a_kept_factor_gives_the_same_update_and_is_made_again_as_it_was() {
        for law in LAWS {
            let patch = Patch::new(law);
            let (region, x) = (&patch.region, &patch.x);
            let dt = region.length.powi(law.order());
            let mut system = CurvatureSystem::new(law, region);
            let (phi, quality) = patch.solve(&mut system, x, dt);
            assert!(quality.factor > 0.0);
            // A little further on, as after a step near a rest.
            let mut y = x.clone();
            for (k, &v) in region.free.iter().enumerate() {
                y[v as usize].z += 1e-3 * region.h * (0.1 * k as f64).sin();
            }
            let reference = system.reference();
            let (kept, quality) = patch.solve(&mut system, &y, dt);
            assert!(
                quality.factor == 0.0 && quality.iterations <= MAX_KEPT,
                "{law:?}"
            );
            let (own, _) = patch.solve(&mut CurvatureSystem::new(law, region), &y, dt);
            let found = difference(&own, &kept);
            assert!(found < 1e-7, "{law:?}: {found}");
            // Another factor in between, or none, changes no bit.
            patch.solve(&mut system, &y, 0.5 * dt);
            for is_released in [false, true] {
                if is_released {
                    system.release();
                }
                system.refer_to(reference.clone());
                let (again, quality) = patch.solve(&mut system, &y, dt);
                assert!(again == kept && quality.factor > 0.0, "{law:?}");
            }
            // Another step size has a matrix of its own.
            let (_, quality) = patch.solve(&mut system, &y, 0.5 * dt);
            assert!(quality.factor > 0.0 && phi.len() == kept.len());
        }
    }
}
