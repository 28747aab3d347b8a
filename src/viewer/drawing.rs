//! The surface as drawn: what of a mesh the GPU needs, kept on the CPU.
//!
//! Arrays are made once by [`Drawing::new`]; a frame of a flow only overwrites them, so
//! that running a flow allocates nothing here.

use glam::{DVec3, Vec3};

use super::camera::Sphere;
use super::error::ViewerError;
use super::normals::vertex_normals;
use super::seams::split_seams;

/// Vertices in a row of the texture that carries them. A power of two, so that shaders
/// find a vertex by shift and mask, and within what every device allows.
pub const ROW: usize = 2048;

/// Vertices, triangles and marks of one mesh, ready for upload.
#[derive(Debug)]
pub struct Drawing {
    n_vertices: usize,
    /// Source of each vertex beyond the first `n_vertices`; see [`super::seams`].
    copies: Vec<u32>,
    /// Position and field value of each vertex, padded to whole rows.
    vertices: Vec<[f32; 4]>,
    normals: Vec<[f32; 3]>,
    /// Held (255 or 0), field value missing (255 or 0), unused, unused.
    flags: Vec<[u8; 4]>,
    triangles: Vec<u32>,
    marked: Vec<u32>,
    is_closed: bool,
}

impl Default for Drawing {
    fn default() -> Self {
        Self {
            n_vertices: 0,
            copies: Vec::new(),
            vertices: vec![[0.0; 4]; ROW],
            normals: Vec::new(),
            flags: Vec::new(),
            triangles: Vec::new(),
            marked: Vec::new(),
            is_closed: false,
        }
    }
}

impl Drawing {
    /// Takes over a mesh: three coordinates a vertex, three vertices a triangle; closed
    /// when it has no boundary. Of a closed surface the outside is drawn as its front,
    /// whichever way the triangles wind.
    ///
    /// # Errors
    /// `WrongLength` when an array is not made of triples, `OutOfRange` for a vertex that
    /// does not exist.
    pub fn new(positions: &[f32], triangles: &[u32], is_closed: bool) -> Result<Self, ViewerError> {
        let n_vertices = positions.len() / 3;
        expect_length("positions", positions.len(), 3 * n_vertices)?;
        expect_length("triangles", triangles.len(), triangles.len() / 3 * 3)?;
        expect_range("triangles", triangles, n_vertices)?;
        let mut triangles = triangles.to_vec();
        let copies = split_seams(n_vertices, &mut triangles);
        let n_drawn = n_vertices + copies.len();
        let mut drawing = Self {
            n_vertices,
            copies,
            vertices: vec![[0.0; 4]; n_drawn.next_multiple_of(ROW).max(ROW)],
            normals: vec![[0.0; 3]; n_drawn],
            flags: vec![[0; 4]; n_drawn],
            triangles,
            marked: Vec::new(),
            is_closed,
        };
        drawing.set_positions(positions)?;
        if is_closed && drawing.volume() < 0.0 {
            drawing
                .triangles
                .chunks_exact_mut(3)
                .for_each(|triangle| triangle.swap(1, 2));
        }
        Ok(drawing)
    }

    /// Moves the vertices. One that is not finite stays where it was.
    ///
    /// # Errors
    /// `WrongLength`.
    pub fn set_positions(&mut self, positions: &[f32]) -> Result<(), ViewerError> {
        expect_length("positions", positions.len(), 3 * self.n_vertices)?;
        for (vertex, position) in self.vertices.iter_mut().zip(positions.chunks_exact(3)) {
            if position.iter().all(|coordinate| coordinate.is_finite()) {
                vertex[..3].copy_from_slice(position);
            }
        }
        for (i, &source) in self.copies.iter().enumerate() {
            let [x, y, z, _] = self.vertices[source as usize];
            self.vertices[self.n_vertices + i][..3].copy_from_slice(&[x, y, z]);
        }
        Ok(())
    }

    /// Gives each vertex a value to be coloured by; one that is not finite is drawn in
    /// the plain colour of the surface.
    ///
    /// # Errors
    /// `WrongLength`.
    pub fn set_field(&mut self, values: &[f32]) -> Result<(), ViewerError> {
        expect_length("values", values.len(), self.n_vertices)?;
        for drawn in 0..self.flags.len() {
            let value = values[self.source(drawn)];
            let known = value.is_finite();
            self.vertices[drawn][3] = if known { value } else { 0.0 };
            self.flags[drawn][1] = if known { 0 } else { 255 };
        }
        Ok(())
    }

    /// Says which vertices are held (not 0); an empty array means none.
    ///
    /// # Errors
    /// `WrongLength`.
    pub fn set_marked_vertices(&mut self, held: &[u8]) -> Result<(), ViewerError> {
        if !held.is_empty() {
            expect_length("held-vertices", held.len(), self.n_vertices)?;
        }
        for drawn in 0..self.flags.len() {
            let is_held = held.get(self.source(drawn)).is_some_and(|&mark| mark != 0);
            self.flags[drawn][0] = if is_held { 255 } else { 0 };
        }
        Ok(())
    }

    /// Says which triangles to highlight.
    ///
    /// # Errors
    /// `OutOfRange`.
    pub fn set_marked_triangles(&mut self, marked: &[u32]) -> Result<(), ViewerError> {
        expect_range("marked-triangles", marked, self.triangles.len() / 3)?;
        let corners = |&t: &u32| &self.triangles[3 * t as usize..3 * t as usize + 3];
        self.marked.clear();
        self.marked.extend(marked.iter().flat_map(corners));
        Ok(())
    }

    /// Computes the vertex normals of the present positions.
    pub fn update_normals(&mut self) {
        vertex_normals(
            &self.vertices,
            &self.triangles,
            &self.copies,
            &mut self.normals,
        );
    }

    /// Signed volume, in double precision about the first vertex: far from the origin the
    /// sum would else drown in rounding.
    fn volume(&self) -> f64 {
        let position = |vertex: u32| {
            let [x, y, z, _] = self.vertices[vertex as usize];
            DVec3::new(x.into(), y.into(), z.into())
                - Vec3::from_slice(&self.vertices[0]).as_dvec3()
        };
        let tetrahedron =
            |t: &[u32]| position(t[0]).dot(position(t[1]).cross(position(t[2]))) / 6.0;
        self.triangles.chunks_exact(3).map(tetrahedron).sum()
    }

    /// Ball around the present positions.
    pub fn bounds(&self) -> Sphere {
        let position = |&[x, y, z, _]: &[f32; 4]| Vec3::new(x, y, z);
        Sphere::around(self.vertices[..self.n_vertices].iter().map(position))
    }

    /// Whether the triangles are wound consistently, so that inside and outside can be
    /// told apart by colour.
    pub fn has_two_sides(&self) -> bool {
        self.copies.is_empty()
    }

    /// Whether the surface has no boundary.
    pub fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// Vertices of the mesh itself, without copies.
    pub fn n_vertices(&self) -> usize {
        self.n_vertices
    }

    /// Position and field value of each vertex, in whole rows of [`ROW`].
    pub fn vertices(&self) -> &[[f32; 4]] {
        &self.vertices
    }

    /// Normal of each vertex as of the last [`Drawing::update_normals`].
    pub fn normals(&self) -> &[[f32; 3]] {
        &self.normals
    }

    /// Marks of each vertex: held, value missing, 0, 0.
    pub fn flags(&self) -> &[[u8; 4]] {
        &self.flags
    }

    /// Corners of the triangles.
    pub fn triangles(&self) -> &[u32] {
        &self.triangles
    }

    /// Corners of the highlighted triangles.
    pub fn marked(&self) -> &[u32] {
        &self.marked
    }

    /// The mesh's vertex that a drawn one stands for.
    fn source(&self, drawn: usize) -> usize {
        drawn
            .checked_sub(self.n_vertices)
            .map_or(drawn, |copy| self.copies[copy] as usize)
    }
}

fn expect_length(array: &'static str, found: usize, expected: usize) -> Result<(), ViewerError> {
    if found == expected {
        Ok(())
    } else {
        Err(ViewerError::WrongLength {
            array,
            expected,
            found,
        })
    }
}

/// Refuses an index that is not below `count`.
pub(super) fn expect_range(
    array: &'static str,
    indices: &[u32],
    count: usize,
) -> Result<(), ViewerError> {
    match indices.iter().find(|&&index| index as usize >= count) {
        None => Ok(()),
        Some(&index) => Err(ViewerError::OutOfRange {
            array,
            index,
            count,
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::super::seams::tests::mobius_strip;
    use super::*;
    use crate::message::Say;

    const SQUARE: [f32; 12] = [0., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 0.];

    fn square() -> Drawing {
        Drawing::new(&SQUARE, &[0, 1, 2, 0, 2, 3], false).expect("a valid mesh")
    }

    #[test]
    fn arrays_that_do_not_fit_are_refused_by_name() {
        let kind = |result: Result<Drawing, ViewerError>| result.expect_err("refused").kind();
        assert_eq!(kind(Drawing::new(&SQUARE[..11], &[], false)), "WrongLength");
        assert_eq!(kind(Drawing::new(&SQUARE, &[0, 1], false)), "WrongLength");
        assert_eq!(kind(Drawing::new(&SQUARE, &[0, 1, 4], false)), "OutOfRange");
        let mut drawing = square();
        assert!(drawing.set_positions(&SQUARE[3..]).is_err());
        assert!(drawing.set_field(&[0.0; 3]).is_err());
        assert!(drawing.set_marked_vertices(&[1]).is_err());
        assert!(drawing.set_marked_triangles(&[2]).is_err());
        assert_eq!(
            drawing.vertices()[1],
            [1.0, 0.0, 0.0, 0.0],
            "a refusal changes nothing"
        );
    }

    #[test]
    fn empty_mesh_can_be_drawn() {
        let drawing = Drawing::new(&[], &[], true).expect("an empty mesh");
        assert_eq!(drawing.vertices().len(), ROW);
        assert_eq!(drawing.bounds().radius, 1.0);
    }

    #[test]
    fn vertices_that_are_not_finite_stay() {
        let mut drawing = square();
        let mut moved = SQUARE.map(|coordinate| coordinate + 1.0);
        moved[4] = f32::NAN;
        drawing.set_positions(&moved).expect("same length");
        assert_eq!(drawing.vertices()[0][..3], [1.0; 3]);
        assert_eq!(drawing.vertices()[1][..3], [1.0, 0.0, 0.0]);
    }

    #[test]
    fn positions_and_field_do_not_disturb_each_other() {
        let mut drawing = square();
        drawing
            .set_field(&[1.0, f32::NAN, 3.0, 4.0])
            .expect("same length");
        drawing
            .set_marked_vertices(&[0, 1, 0, 0])
            .expect("same length");
        drawing
            .set_positions(&SQUARE.map(|c| 2.0 * c))
            .expect("same length");
        assert_eq!(drawing.vertices()[2], [2.0, 2.0, 0.0, 3.0]);
        assert_eq!(drawing.flags()[..3], [[0; 4], [255, 255, 0, 0], [0; 4]]);
        drawing.set_marked_vertices(&[]).expect("empty is allowed");
        assert_eq!(drawing.flags()[1], [0, 255, 0, 0]);
    }

    #[test]
    fn closed_surface_shows_its_outside_however_it_winds() {
        let far = 1000.0;
        let tetrahedron = [0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.].map(|c: f32| c + far);
        let outward = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
        let inward = [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2];
        for winding in [outward, inward] {
            let drawing = Drawing::new(&tetrahedron, &winding, true).expect("a valid mesh");
            assert!((drawing.volume() - 1.0 / 6.0).abs() < 1e-9);
        }
        let open = Drawing::new(&tetrahedron, &inward, false).expect("a valid mesh");
        assert_eq!(open.triangles(), inward);
    }

    #[test]
    fn marks_name_the_corners_of_their_triangles() {
        let mut drawing = square();
        drawing.set_marked_triangles(&[1]).expect("exists");
        assert_eq!(drawing.marked(), [0, 2, 3]);
    }

    #[test]
    fn copies_follow_their_vertices() {
        let (positions, triangles) = mobius_strip(12);
        let mut flat: Vec<f32> = positions.iter().flat_map(|p| p.to_array()).collect();
        let mut drawing = Drawing::new(&flat, &triangles, false).expect("a valid mesh");
        assert!(!drawing.has_two_sides() && square().has_two_sides());
        flat[1] = 7.0;
        let values: Vec<f32> = (0..positions.len()).map(|v| v as f32).collect();
        drawing.set_positions(&flat).expect("same length");
        drawing.set_field(&values).expect("same length");
        for copy in positions.len()..drawing.flags().len() {
            let vertex = drawing.vertices()[copy][3] as usize;
            assert_eq!(drawing.vertices()[copy], drawing.vertices()[vertex]);
        }
    }
}
