//! Creases of a surface: what a regularisation must not move.

use super::surroundings::{inverted, smoothed};
use crate::geometry::measure;
use crate::mesh::{Edge, Face, HalfedgeMesh, Vertex};
use crate::remesh::conformal::Regulariser;
use glam::DVec3;

/// Edges whose faces meet at a larger angle than this are creases: more than a twelfth of a
/// circle, as of a chamfer or a coarse cylinder, and less than an eighth.
const CREASE_DEGREES: f64 = 40.0;

/// How many edges of a crease with a loose end do not count.
const LOOSE: usize = 3;

/// Where no more than one in so many edges is left after that, the surface is rough.
const ROUGH: usize = 4;

/// On rough and on folded surfaces creases of fewer edges than this do not count: a prism over
/// a triangle has as many.
const CONNECTED: usize = 9;

/// Where there are fewer edges of creases for each folded face than this, they belong to the
/// folds, as on a smooth surface whose vertices were pushed along it; a part whose mesh has
/// gone wrong here and there has many more.
const FOR_EACH_FOLD: usize = 8;

/// A face lower than this share of its longest side has lost its normal to the rounding of
/// coordinates, which files hold in single precision.
const FLAT: f64 = 1e-6;

/// Where a surface is creased, and where a mesh is folded.
pub(super) struct Creases {
    /// Whether each vertex lies on a crease.
    pub(super) on: Vec<bool>,
    /// Faces that oppose both the surface around them and the sum of their neighbours: on
    /// its own either is met by a few faces of thin or pointed parts.
    pub(super) folded: Vec<Face>,
}

impl Creases {
    /// Creases of the surface at `x`: edges with a dihedral angle over 40°, the angle between
    /// the normals of their faces, 0 where they are in one plane.
    ///
    /// Faces without a normal make no creases. Those of a part close up or are long: what is
    /// gone once its loose ends have been taken away, [`LOOSE`] times over, is roughness, and
    /// where that is most of them so is what is left in pieces of fewer than [`CONNECTED`]
    /// edges. A mesh with folded faces has many such pieces around them and around its
    /// slivers, which are what is to be mended: there, they are no creases, nor is what touches
    /// a folded face, nor anything if there are fewer than [`FOR_EACH_FOLD`] edges for each of
    /// the folded faces.
    pub(super) fn of(regulariser: &Regulariser, mesh: &HalfedgeMesh, x: &[DVec3]) -> Self {
        let normals = face_normals(mesh, x);
        let around = smoothed(regulariser, x, &vec![false; x.len()]);
        let folded: Vec<Face> = inverted(regulariser, x, &around)
            .filter(|&f| opposes_neighbours(mesh, &normals, f))
            .collect();
        let mut is_doubtful = vec![false; x.len()];
        for &f in &folded {
            mesh.face_vertices(f)
                .for_each(|v| is_doubtful[v.index()] = true);
        }
        let least = CREASE_DEGREES.to_radians().cos();
        let mut creases: Vec<[Vertex; 2]> = mesh
            .edges()
            .filter(|&e| {
                let [a, b] = sides(mesh, &normals, e);
                a != DVec3::ZERO && b != DVec3::ZERO && a.dot(b) < least
            })
            .map(|e| mesh.ends(e))
            .filter(|ends| !ends.iter().any(|v| is_doubtful[v.index()]))
            .collect();
        let all = creases.len();
        without_loose_ends(&mut creases, x.len());
        if !folded.is_empty() || creases.len() < all / ROUGH {
            without_islands(&mut creases, x.len());
        }
        if creases.len() < FOR_EACH_FOLD * folded.len() {
            creases.clear();
        }
        let mut on = vec![false; x.len()];
        for v in creases.iter().flatten() {
            on[v.index()] = true;
        }
        Self { on, folded }
    }

    /// The same where creases may slide: none is told.
    pub(super) fn none(regulariser: &Regulariser, mesh: &HalfedgeMesh, x: &[DVec3]) -> Self {
        let mut creases = Self::of(regulariser, mesh, x);
        creases.on.fill(false);
        creases
    }

    /// How many vertices lie on creases.
    pub(super) fn count(&self) -> usize {
        self.on.iter().filter(|on| **on).count()
    }
}

/// Unit normals of the faces; zero where there is none to be told.
fn face_normals(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<DVec3> {
    mesh.faces()
        .map(|f| {
            let vector = measure::face_vector_area(mesh, x, f);
            let sides = mesh.cycle(mesh.halfedge_of_face(f));
            let lengths =
                sides.map(|h| x[mesh.tail(h).index()].distance_squared(x[mesh.tip(h).index()]));
            let longest = lengths.fold(0.0, f64::max);
            if 2.0 * vector.length() > FLAT * longest {
                vector.normalize_or_zero()
            } else {
                DVec3::ZERO
            }
        })
        .collect()
}

/// Takes edges away that end where no other begins, a few times over.
fn without_loose_ends(creases: &mut Vec<[Vertex; 2]>, n_vertices: usize) {
    for _ in 0..LOOSE {
        let mut degree = vec![0usize; n_vertices];
        for v in creases.iter().flatten() {
            degree[v.index()] += 1;
        }
        creases.retain(|ends| ends.iter().all(|v| degree[v.index()] > 1));
    }
}

/// Takes edges away that hang together with few others.
fn without_islands(creases: &mut Vec<[Vertex; 2]>, n_vertices: usize) {
    let mut parent: Vec<usize> = (0..n_vertices).collect();
    let root = |parent: &mut Vec<usize>, mut v: usize| {
        while parent[v] != v {
            parent[v] = parent[parent[v]];
            v = parent[v];
        }
        v
    };
    for [a, b] in creases.iter() {
        let (a, b) = (root(&mut parent, a.index()), root(&mut parent, b.index()));
        parent[a] = b;
    }
    let mut edges = vec![0usize; n_vertices];
    for [a, _] in creases.iter() {
        edges[root(&mut parent, a.index())] += 1;
    }
    // Of a mesh of a few vertices few edges are much.
    let least = CONNECTED.min(n_vertices / 2);
    creases.retain(|[a, _]| edges[root(&mut parent, a.index())] >= least);
}

/// Whether the normal of a face opposes the sum of its neighbours'.
fn opposes_neighbours(mesh: &HalfedgeMesh, normals: &[DVec3], f: Face) -> bool {
    let around = mesh.cycle(mesh.halfedge_of_face(f));
    let sum: DVec3 = around
        .map(|h| mesh.face(h.twin()))
        .filter(|g| g.is_some())
        .map(|g| normals[g.index()])
        .sum();
    sum.dot(normals[f.index()]) < 0.0
}

/// Normals on both sides of an edge; zero beyond a boundary.
fn sides(mesh: &HalfedgeMesh, normals: &[DVec3], e: Edge) -> [DVec3; 2] {
    let h = e.halfedge();
    [h, h.twin()].map(|h| match mesh.face(h) {
        f if f.is_some() => normals[f.index()],
        _ => DVec3::ZERO,
    })
}
