//! Negative eigenvalues of the stars of a circle flow's matrix removed: by our projection, and
//! by the eigenvectors that faer finds.

use super::timing::{least, least_of_two};
use faer::diag::DiagMut;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, self_adjoint_evd, self_adjoint_evd_scratch};
use faer::{Mat, Par, Spec};
use umbilic::energy::circle::angle::{DIAMOND_PAIRS, Smoothing};
use umbilic::energy::circle::star::StarMatrix;
use umbilic::energy::circle::{Boundary, CircleEnergy, Evaluation};
use umbilic::linalg::eigen::SpringMatrix;
use umbilic::mesh::{Built, build, shape};

/// As in the projection itself.
const ROUNDOFF: f64 = 1e-11;

/// The projection by an eigen-decomposition of faer.
struct Decomposition {
    matrix: Mat<f64>,
    vectors: Mat<f64>,
    values: Vec<f64>,
    memory: MemBuffer,
}

impl Decomposition {
    fn new() -> Self {
        let most = SpringMatrix::MAX_SIZE;
        let scratch = self_adjoint_evd_scratch::<f64>(
            most,
            ComputeEigenvectors::Yes,
            Par::Seq,
            Spec::default(),
        );
        Self {
            matrix: Mat::zeros(most, most),
            vectors: Mat::zeros(most, most),
            values: vec![0.0; most],
            memory: MemBuffer::new(scratch),
        }
    }

    fn project(&mut self, n: usize, springs: &mut [f64]) -> bool {
        let scale = 2.0 * springs.iter().map(|w| w.abs()).sum::<f64>();
        if !(scale > 0.0 && scale.is_finite()) {
            return false;
        }
        let mut matrix = self.matrix.as_mut().submatrix_mut(0, 0, n, n);
        matrix.fill(0.0);
        let pairs = (1..n).flat_map(|p| (0..p).map(move |q| (p, q)));
        for ((p, q), w) in pairs.clone().zip(&*springs) {
            matrix[(p, q)] -= w;
            matrix[(p, p)] += w;
            matrix[(q, q)] += w;
        }
        let mut vectors = self.vectors.as_mut().submatrix_mut(0, 0, n, n);
        let values = &mut self.values[..n];
        self_adjoint_evd(
            matrix.as_ref(),
            DiagMut::from_slice_mut(values),
            Some(vectors.as_mut()),
            Par::Seq,
            MemStack::new(&mut self.memory),
            Spec::default(),
        )
        .unwrap();
        let mut projected = false;
        for (k, value) in values.iter().enumerate() {
            if *value < -ROUNDOFF * scale {
                projected = true;
                for ((p, q), w) in pairs.clone().zip(&mut *springs) {
                    *w += value * vectors[(p, k)] * vectors[(q, k)];
                }
            }
        }
        projected
    }
}

/// The energy of a bumpy sphere with its values there.
fn surface(level: usize) -> (CircleEnergy, Evaluation, usize) {
    let sample = shape::make("bumpy-sphere", &[("level".into(), level as f64)]).unwrap();
    let Built {
        mesh, positions, ..
    } = build(&sample.soup).unwrap();
    let energy = CircleEnergy::new(&mesh, Boundary::Clamped);
    let mut evaluation = Evaluation::default();
    energy.evaluate(&positions, Smoothing { epsilon: 0.1 }, &mut evaluation);
    (energy, evaluation, positions.len())
}

/// The springs of every star.
fn stars(energy: &CircleEnergy, evaluation: &Evaluation, n: usize) -> Vec<SpringMatrix> {
    let mut members: Vec<Vec<u32>> = (0..n as u32).map(|v| vec![v]).collect();
    for diamond in energy.diamonds() {
        for centre in [diamond.v[1], diamond.v[3]] {
            let members = &mut members[centre as usize];
            for v in diamond.v {
                if !members.contains(&v) {
                    members.push(v);
                }
            }
        }
    }
    let star = |members: &Vec<u32>| {
        let mut star = SpringMatrix::default();
        star.reset(members.len());
        star
    };
    let mut stars: Vec<SpringMatrix> = members.iter().map(star).collect();
    for (diamond, weights) in energy.diamonds().iter().zip(&evaluation.weights.diamonds) {
        for centre in [diamond.v[1], diamond.v[3]].map(|v| v as usize) {
            let place = |v: u32| members[centre].iter().position(|m| *m == v).unwrap();
            for ((p, q), w) in DIAMOND_PAIRS.iter().zip(weights) {
                let pair = SpringMatrix::pair(place(diamond.v[*p]), place(diamond.v[*q]));
                stars[centre].add(pair, *w);
            }
        }
    }
    stars
}

/// Prints the times to project all stars of a mesh, that of an assembly with our projection,
/// and how many times as long either takes with faer's.
pub(super) fn compare(print: &mut dyn FnMut(String)) {
    print(format!(
        "{:>7} {:>9} {:>9} {:>9} {:>6} {:>9} {:>6}  negative eigenvalues of stars removed, and \
         the assembly that does it: milliseconds",
        "stars", "projected", "ours", "faer", "ratio", "assembly", "ratio"
    ));
    for level in [4, 5, 6] {
        let (energy, evaluation, n) = surface(level);
        let stars = stars(&energy, &evaluation, n);
        let mut faer = Decomposition::new();
        let (mut count, mut largest) = (0, 0.0_f64);
        for star in &stars {
            let (mut ours, mut theirs) = (star.clone(), star.clone());
            let n = (1..)
                .find(|n| n * (n - 1) / 2 == star.springs().len())
                .unwrap();
            let projected = ours.project_semidefinite();
            assert_eq!(projected, faer.project(n, theirs.springs_mut()));
            count += usize::from(projected);
            let size = star.springs().iter().fold(0.0, |a: f64, w| a.max(w.abs()));
            for (a, b) in ours.springs().iter().zip(theirs.springs()) {
                largest = largest.max((a - b).abs() / size);
            }
        }
        assert!(largest < 1e-9, "the two differ by {largest:.1e}");
        let mut work = [SpringMatrix::default(), SpringMatrix::default()];
        let [work_of_ours, work_of_theirs] = &mut work;
        let sizes: Vec<usize> = stars
            .iter()
            .map(|star| {
                (1..)
                    .find(|n| n * (n - 1) / 2 == star.springs().len())
                    .unwrap()
            })
            .collect();
        let [ours, theirs] = least_of_two(
            5,
            || {
                for (star, &n) in stars.iter().zip(&sizes) {
                    work_of_ours.reset(n);
                    work_of_ours.springs_mut().copy_from_slice(star.springs());
                    work_of_ours.project_semidefinite();
                }
            },
            || {
                for (star, &n) in stars.iter().zip(&sizes) {
                    work_of_theirs.reset(n);
                    work_of_theirs.springs_mut().copy_from_slice(star.springs());
                    faer.project(n, work_of_theirs.springs_mut());
                }
            },
        );
        let mut matrix = StarMatrix::new(&energy, &vec![true; n]);
        let mut values = Vec::new();
        let assembly = least(5, || {
            matrix.assemble(&evaluation.weights, true, &mut values);
        });
        print(format!(
            "{n:>7} {count:>9} {ours:>9.2} {theirs:>9.2} {:>6.2} {assembly:>9.2} {:>6.2}",
            theirs / ours,
            1.0 + (theirs - ours) / assembly,
        ));
    }
}
