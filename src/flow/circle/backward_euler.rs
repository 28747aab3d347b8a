//! Backward Euler: the minimiser y of E(y) + |y − x|²_M / 2dt, by Newton's method.
//!
//! The paper tried it and found the effort not justified; it is here to be compared.
//! The system is 3n × 3n with the full Hessian; where that is indefinite, one iteration
//! uses the semi-implicit matrix instead, which always descends.

use super::{CircleFlow, Problem};
use crate::energy::circle::Evaluation;
use crate::energy::circle::angle::Smoothing;
use crate::flow::options::Scheme;
use crate::flow::step_size::sufficient_decrease;
use crate::flow::{Cause, Cost, FlowError, Move, Proposal, Refusal, Search, Warning};
use crate::interrupt;
use crate::linalg::{Method, Pattern, Solver};
use glam::DVec3;

/// Newton iterations for one step.
const MAX_NEWTON: usize = 25;
/// Halvings along a Newton direction.
const MAX_HALVINGS: usize = 30;
/// The proximal gradient must fall to this share of the first.
const TOLERANCE: f64 = 1e-6;

/// The 3n × 3n system, built when first needed.
pub(super) struct NewtonSystem {
    pattern: Pattern,
    solver: Solver,
    values: Vec<f64>,
}

impl NewtonSystem {
    fn new(problem: &Problem, x: &[DVec3]) -> Result<Self, FlowError> {
        let scalar = problem.matrix.pattern();
        let cliques = (0..scalar.n()).flat_map(|j| {
            scalar.rows()[scalar.column(j)].iter().map(move |&i| {
                let (i, j) = (3 * i, 3 * j as u32);
                [i, i + 1, i + 2, j, j + 1, j + 2]
            })
        });
        let pattern = Pattern::from_cliques(3 * scalar.n(), cliques);
        let points: Vec<DVec3> = problem
            .vertex_of_row
            .iter()
            .flat_map(|&v| [x[v as usize]; 3])
            .collect();
        let solver = Solver::new(pattern.clone(), Some(&points));
        Ok(Self {
            values: vec![0.0; pattern.nnz()],
            pattern,
            solver,
        })
    }

    /// (Hess E(y) + M/dt) d = −rhs; `None` where the matrix is indefinite.
    fn solve(
        &mut self,
        problem: &Problem,
        y: &[DVec3],
        smoothing: Smoothing,
        (mass, dt): (&[f64], f64),
        rhs: &[DVec3],
        cost: &mut Cost,
    ) -> Result<Option<Vec<DVec3>>, FlowError> {
        self.values.fill(0.0);
        let row = problem.matrix.row_of_vertex();
        let (pattern, values) = (&self.pattern, &mut self.values);
        problem.energy.hessian_blocks(y, smoothing, |p, q, block| {
            let [p, q] = [row[p as usize], row[q as usize]];
            if p == u32::MAX || q == u32::MAX || p < q {
                return;
            }
            for a in 0..3 {
                for b in 0..if p == q { a + 1 } else { 3 } {
                    values[pattern.slot(3 * p + a as u32, 3 * q + b as u32)] += block.col(b)[a];
                }
            }
        });
        for (r, m) in mass.iter().enumerate() {
            for slot in &pattern.diagonal_slots()[3 * r..3 * r + 3] {
                values[*slot as usize] += m / dt;
            }
        }
        // Three scalars a vertex as the first column of a field of 3n vectors.
        let field: Vec<DVec3> = rhs
            .iter()
            .flat_map(|r| r.to_array())
            .map(|c| DVec3::new(-c, 0.0, 0.0))
            .collect();
        let mut d = vec![DVec3::ZERO; field.len()];
        let info = self
            .solver
            .solve(&self.values, &field, &mut d, 1e-10, Method::Direct)?;
        cost.add(&info);
        let vector = |c: &[DVec3]| DVec3::new(c[0].x, c[1].x, c[2].x);
        Ok((info.negative_pivots == 0).then(|| d.chunks_exact(3).map(vector).collect()))
    }
}

impl CircleFlow {
    /// One backward Euler step. The paper's scheme takes it even where Newton's method has not
    /// converged; the recommended one asks for a smaller dt then.
    pub(super) fn backward_euler(
        &mut self,
        x: &[DVec3],
        dt: f64,
        cost: &mut Cost,
    ) -> Result<Proposal, FlowError> {
        let mass = self.mass(x);
        let mut system = match self.newton.take() {
            Some(system) => system,
            None => NewtonSystem::new(&self.problem, x)?,
        };
        let smoothing = self.schedule.smoothing();
        let found = self.newton(&mut system, x, smoothing, (&mass, dt), cost);
        self.newton = Some(system);
        let (y, converged) = found?;
        let is_paper = self.options.scheme == Scheme::Paper;
        if !converged && !is_paper {
            return Ok(Proposal::Refused(Refusal::of(Cause::Newton)));
        }
        if !converged {
            cost.warnings.push(Warning::NewtonFailed);
        }
        let d: Vec<DVec3> = y.iter().zip(x).map(|(y, x)| *y - *x).collect();
        // Of an implicit step the slope at its start says nothing: it has to descend.
        let search = if is_paper {
            Search::Unseen
        } else {
            Search::Solve
        };
        Ok(Proposal::Move(Box::new(Move::new(d, 0.0, dt, search))))
    }

    /// Newton's method from x; answers the point, and whether it converged.
    fn newton(
        &mut self,
        system: &mut NewtonSystem,
        x: &[DVec3],
        smoothing: Smoothing,
        (mass, dt): (&[f64], f64),
        cost: &mut Cost,
    ) -> Result<(Vec<DVec3>, bool), FlowError> {
        let start: Vec<DVec3> = self.problem.rows(x).collect();
        let mut y = x.to_vec();
        let mut at = Evaluation::default();
        let mut first = None;
        let proximal = |problem: &Problem, y: &[DVec3], energy: f64| {
            let distance: f64 = problem
                .rows(y)
                .zip(&start)
                .zip(mass)
                .map(|((y, x), m)| m * y.distance_squared(*x))
                .sum();
            energy + distance / (2.0 * dt)
        };
        for _ in 0..MAX_NEWTON {
            self.problem.energy.evaluate(&y, smoothing, &mut at);
            let residual: Vec<DVec3> = self
                .problem
                .rows(&at.gradient)
                .zip(self.problem.rows(&y).zip(&start).zip(mass))
                .map(|(g, ((y, x), m))| g + (y - *x) * (*m / dt))
                .collect();
            let norm = residual
                .iter()
                .map(|r| r.length_squared())
                .sum::<f64>()
                .sqrt();
            if norm <= TOLERANCE * *first.get_or_insert(norm) {
                return Ok((y, true));
            }
            cost.iterations += 1;
            interrupt::tell("newton", cost.iterations as f64 / MAX_NEWTON as f64);
            let problem = &mut self.problem;
            let newton = system.solve(problem, &y, smoothing, (mass, dt), &residual, cost)?;
            let d = match newton {
                Some(d) => d,
                None => {
                    problem.assemble(&at, true, cost);
                    let mut field = vec![DVec3::ZERO; x.len()];
                    for (&v, r) in problem.vertex_of_row.iter().zip(&residual) {
                        field[v as usize] = *r;
                    }
                    problem.solve(&field, mass, dt, Method::Direct, cost)?
                }
            };
            let slope = residual.iter().zip(&d).map(|(r, d)| r.dot(*d)).sum::<f64>();
            let before = proximal(problem, &y, at.value);
            let step = (0..MAX_HALVINGS)
                .map(|k| 0.5f64.powi(k as i32))
                .find_map(|s| {
                    let z = problem.moved(&y, &d, s);
                    let energy = problem.energy.value(&z, smoothing);
                    sufficient_decrease(before, proximal(problem, &z, energy), s * slope)
                        .then_some(z)
                });
            match step {
                Some(z) => y = z,
                None => return Ok((y, false)),
            }
        }
        Ok((y, false))
    }
}
