//! The surface as drawn: what of a mesh the GPU needs, kept on the CPU.
//!
//! Arrays are made once by [`Drawing::new`], and once more for each further step that is
//! held; a frame of a flow only overwrites them, so that running a flow allocates nothing
//! here.

use glam::{Vec3, Vec4};

use super::camera::Sphere;
use super::error::ViewerError;
use super::motion::{Motion, SLOTS};
use super::normals::vertex_normals;
use super::seams::split_seams;

/// Vertices in a row of the textures that carry them. A power of two, so that shaders
/// find a vertex by shift and mask, and within what every device allows.
pub const ROW: usize = 2048;

/// Vertices, triangles and marks of one mesh, ready for upload.
#[derive(Debug)]
pub struct Drawing {
    n_vertices: usize,
    /// Source of each vertex beyond the first `n_vertices`; see [`super::seams`].
    copies: Vec<u32>,
    /// The steps between which the surface is drawn, by slot.
    steps: Vec<Step>,
    motion: Motion,
    /// Held (255 or 0), field value missing (255 or 0), unused, unused; whole rows.
    flags: Vec<[u8; 4]>,
    triangles: Vec<u32>,
    marked: Vec<u32>,
    is_closed: bool,
}

/// The surface at one step. Arrays are padded to whole rows of [`ROW`].
#[derive(Clone, Debug)]
pub struct Step {
    /// Position and field value of each vertex.
    vertices: Vec<[f32; 4]>,
    /// Normal of each vertex, and mean length of the sides that meet there.
    normals: Vec<[f32; 4]>,
    has_normals: bool,
    bounds: Sphere,
}

impl Step {
    fn new(n_drawn: usize) -> Self {
        let length = n_drawn.next_multiple_of(ROW).max(ROW);
        Self {
            vertices: vec![[0.0; 4]; length],
            normals: vec![[0.0; 4]; length],
            has_normals: false,
            bounds: Sphere::around([].into_iter()),
        }
    }

    /// Position and field value of each vertex.
    pub fn vertices(&self) -> &[[f32; 4]] {
        &self.vertices
    }

    /// Normal of each vertex, and mean length of the sides that meet there, as of the last
    /// [`Drawing::update_normals`].
    pub fn normals(&self) -> &[[f32; 4]] {
        &self.normals
    }

    /// Least coordinate along an axis among the first `n` vertices.
    fn lowest(&self, n: usize, up: Vec3) -> f32 {
        let height = |v: &[f32; 4]| Vec4::from(*v).truncate().dot(up);
        let heights = self.vertices[..n].iter().map(height);
        heights.reduce(f32::min).unwrap_or(0.0)
    }
}

impl Default for Drawing {
    fn default() -> Self {
        Self {
            n_vertices: 0,
            copies: Vec::new(),
            steps: vec![Step::new(0)],
            motion: Motion::still(),
            flags: vec![[0; 4]; ROW],
            triangles: Vec::new(),
            marked: Vec::new(),
            is_closed: false,
        }
    }
}

/// Σ |w| from which the ball around each step tells too little of that around the sum: after a
/// very short step the weights are large and of opposite signs.
const LOOSE: f32 = 1.2;

impl Drawing {
    /// Takes over a mesh: three coordinates a vertex, three vertices a triangle; closed
    /// when it has no boundary. Triangles are seen from their front where they wind
    /// counterclockwise: which side of a closed surface is outside the solver has settled, and
    /// on the way through itself a surface may come to show the other one.
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
        let first = Step::new(n_vertices + copies.len());
        let mut drawing = Self {
            n_vertices,
            copies,
            flags: vec![[0; 4]; first.vertices.len()],
            steps: vec![first],
            motion: Motion::still(),
            triangles,
            marked: Vec::new(),
            is_closed,
        };
        drawing.set_positions(positions)?;
        Ok(drawing)
    }

    /// Shows one step alone. A vertex that is not finite stays where it was.
    ///
    /// # Errors
    /// `WrongLength`.
    pub fn set_positions(&mut self, positions: &[f32]) -> Result<(), ViewerError> {
        expect_length("positions", positions.len(), 3 * self.n_vertices)?;
        let newest = self.motion.newest();
        self.motion = Motion::still();
        self.steps.swap(0, newest);
        self.put(0, positions);
        Ok(())
    }

    /// Adds the step that follows, to be shown at a time after the last; see [`Motion`].
    /// A vertex that is not finite stays where it was, and each keeps its field value.
    ///
    /// # Errors
    /// `WrongLength`, `WrongTime`.
    pub fn add_step(
        &mut self,
        positions: &[f32],
        time: f32,
        is_straight: bool,
    ) -> Result<(), ViewerError> {
        expect_length("positions", positions.len(), 3 * self.n_vertices)?;
        let before = self.motion.newest();
        let Some(slot) = self.motion.add(time, is_straight) else {
            return Err(ViewerError::WrongTime);
        };
        if slot == self.steps.len() {
            self.steps.push(self.steps[before].clone());
        } else if let Ok([last, next]) = self.steps.get_disjoint_mut([before, slot]) {
            next.vertices.copy_from_slice(&last.vertices);
        }
        self.put(slot, positions);
        Ok(())
    }

    /// Shows the surface at a time between the steps that are held.
    pub fn set_time(&mut self, time: f32) {
        self.motion.set_time(time);
    }

    /// Overwrites a step that has the positions before.
    fn put(&mut self, slot: usize, positions: &[f32]) {
        let step = &mut self.steps[slot];
        for (vertex, position) in step.vertices.iter_mut().zip(positions.chunks_exact(3)) {
            if position.iter().all(|coordinate| coordinate.is_finite()) {
                vertex[..3].copy_from_slice(position);
            }
        }
        for (i, &source) in self.copies.iter().enumerate() {
            let [x, y, z, _] = step.vertices[source as usize];
            step.vertices[self.n_vertices + i][..3].copy_from_slice(&[x, y, z]);
        }
        let points = step.vertices[..self.n_vertices].iter();
        step.bounds = Sphere::around(points.map(|v| Vec4::from(*v).truncate()));
        step.has_normals = false;
    }

    /// Gives each vertex of the step added last a value to be coloured by; one that is not
    /// finite is drawn in the plain colour of the surface, at any step.
    ///
    /// # Errors
    /// `WrongLength`.
    pub fn set_field(&mut self, values: &[f32]) -> Result<(), ViewerError> {
        expect_length("values", values.len(), self.n_vertices)?;
        let newest = self.motion.newest();
        for drawn in 0..self.n_drawn() {
            let value = values[self.source(drawn)];
            let known = value.is_finite();
            self.steps[newest].vertices[drawn][3] = if known { value } else { 0.0 };
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
        for drawn in 0..self.n_drawn() {
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

    /// Computes the vertex normals of the steps that lack them; says of which.
    pub fn update_normals(&mut self) -> [bool; SLOTS] {
        let n_drawn = self.n_drawn();
        let mut updated = [false; SLOTS];
        for (step, updated) in self.steps.iter_mut().zip(&mut updated) {
            if std::mem::replace(&mut step.has_normals, true) {
                continue;
            }
            *updated = true;
            let normals = &mut step.normals[..n_drawn];
            vertex_normals(&step.vertices, &self.triangles, &self.copies, normals);
        }
        updated
    }

    /// Where vertices are drawn.
    pub fn positions(&self) -> impl Fn(u32) -> Vec3 {
        let steps: Vec<_> = self.weighted().collect();
        move |vertex| {
            let at = |step: &Step| Vec4::from(step.vertices[vertex as usize]).truncate();
            steps.iter().map(|(weight, step)| *weight * at(step)).sum()
        }
    }

    /// Ball around what is drawn. At the time of a step, the ball around that step.
    pub fn bounds(&self) -> Sphere {
        // A vertex is no farther from Σ w c than Σ |w| r, as the weights add up to 1.
        let ball = |(weight, step): (f32, &Step)| {
            (
                weight * step.bounds.center,
                weight.abs() * step.bounds.radius,
            )
        };
        let zero = (Vec3::ZERO, 0.0);
        let add = |a: (Vec3, f32), b: (Vec3, f32)| (a.0 + b.0, a.1 + b.1);
        let (center, radius) = self.weighted().map(ball).fold(zero, add);
        let sum: f32 = self.weighted().map(|(weight, _)| weight.abs()).sum();
        if sum <= LOOSE {
            return Sphere { center, radius };
        }
        let at = self.positions();
        let distances = (0..self.n_vertices as u32).map(|v| at(v).distance(center));
        let radius = distances.fold(0.0, f32::max);
        Sphere { center, radius }
    }

    /// Least coordinate along an axis: exact at a step, between steps as they are blended.
    pub fn lowest(&self, up: Vec3) -> f32 {
        let lowest = |(weight, step): (f32, &Step)| weight * step.lowest(self.n_vertices, up);
        self.weighted().map(lowest).sum()
    }

    /// The steps of which the drawn surface is the sum, with their weights.
    fn weighted(&self) -> impl Iterator<Item = (f32, &Step)> {
        let weights = self.motion.weights().into_iter();
        weights
            .zip(&self.steps)
            .filter(|(weight, _)| *weight != 0.0)
    }

    /// Weights of the steps, by slot.
    pub fn weights(&self) -> [f32; SLOTS] {
        self.motion.weights()
    }

    /// Steps that have weights; their slots come first.
    pub fn n_steps(&self) -> usize {
        self.motion.n_steps()
    }

    /// The steps that are held, by slot.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// Slot of the step set or added last.
    pub fn newest(&self) -> usize {
        self.motion.newest()
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

    /// Vertices that are drawn, with copies.
    fn n_drawn(&self) -> usize {
        self.n_vertices + self.copies.len()
    }

    /// Marks of each vertex: held, value missing, 0, 0; in whole rows of [`ROW`].
    pub fn flags(&self) -> &[[u8; 4]] {
        &self.flags
    }

    /// Corners of the triangles.
    pub fn triangles(&self) -> &[u32] {
        &self.triangles
    }

    /// The vector area of some triangles: their mean normal, of twice the length of their area.
    /// Those that there are not count nothing.
    pub fn vector_area(&self, triangles: &[u32]) -> Vec3 {
        let at = self.positions();
        let areas = triangles.iter().filter_map(|t| {
            let [a, b, c] = *self.triangles.get(3 * *t as usize..)?.first_chunk()?;
            let [a, b, c] = [at(a), at(b), at(c)];
            Some((b - a).cross(c - a))
        });
        areas.sum()
    }

    /// Corners of the highlighted triangles.
    pub fn marked(&self) -> &[u32] {
        &self.marked
    }

    /// The mesh's vertex that a drawn one stands for.
    pub fn source(&self, drawn: usize) -> usize {
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
            drawing.steps()[0].vertices()[1],
            [1.0, 0.0, 0.0, 0.0],
            "a refusal changes nothing"
        );
    }

    #[test]
    fn empty_mesh_can_be_drawn() {
        let drawing = Drawing::new(&[], &[], true).expect("an empty mesh");
        assert_eq!(drawing.steps()[0].vertices().len(), ROW);
        assert_eq!(drawing.bounds().radius, 1.0);
    }

    #[test]
    fn vertices_that_are_not_finite_stay() {
        let mut drawing = square();
        let mut moved = SQUARE.map(|coordinate| coordinate + 1.0);
        moved[4] = f32::NAN;
        drawing.set_positions(&moved).expect("same length");
        assert_eq!(drawing.steps()[0].vertices()[0][..3], [1.0; 3]);
        assert_eq!(drawing.steps()[0].vertices()[1][..3], [1.0, 0.0, 0.0]);
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
        assert_eq!(drawing.steps()[0].vertices()[2], [2.0, 2.0, 0.0, 3.0]);
        assert_eq!(drawing.flags()[..3], [[0; 4], [255, 255, 0, 0], [0; 4]]);
        drawing.set_marked_vertices(&[]).expect("empty is allowed");
        assert_eq!(drawing.flags()[1], [0, 255, 0, 0]);
    }

    #[test]
    fn a_surface_that_is_inside_out_shows_its_inside() {
        let tetrahedron = [0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.];
        let inward = [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2];
        for is_closed in [true, false] {
            let drawing = Drawing::new(&tetrahedron, &inward, is_closed).expect("a valid mesh");
            assert_eq!(drawing.triangles(), inward);
        }
    }

    #[test]
    fn marks_name_the_corners_of_their_triangles() {
        let mut drawing = square();
        drawing.set_marked_triangles(&[1]).expect("exists");
        assert_eq!(drawing.marked(), [0, 2, 3]);
    }

    #[test]
    fn a_vector_area_is_that_of_the_triangles_as_they_are_seen() {
        let positions = [0., 0., 0., 2., 0., 0., 0., 3., 0., 0., 0., 4.];
        let drawing = Drawing::new(&positions, &[0, 1, 2, 0, 2, 3], false).expect("a valid mesh");
        assert_eq!(drawing.vector_area(&[0]), Vec3::new(0., 0., 6.));
        assert_eq!(drawing.vector_area(&[0, 1, 9]), Vec3::new(12., 0., 6.));
        assert_eq!(drawing.vector_area(&[]), Vec3::ZERO);
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
        for copy in positions.len()..drawing.n_drawn() {
            let vertex = drawing.steps()[0].vertices()[copy][3] as usize;
            assert_eq!(
                drawing.steps()[0].vertices()[copy],
                drawing.steps()[0].vertices()[vertex]
            );
        }
    }

    /// A unit square that grows to twice its size and moves on.
    fn moving() -> Drawing {
        let mut drawing = square();
        drawing.set_field(&[0.0; 4]).expect("same length");
        let add = |drawing: &mut Drawing, scale: f32, shift: f32, time: f32| {
            let next = SQUARE.map(|c| scale * c + shift);
            drawing.add_step(&next, time, false).expect("later");
            drawing.set_field(&[time; 4]).expect("same length");
        };
        add(&mut drawing, 2.0, 0.0, 1.0);
        add(&mut drawing, 2.0, 3.0, 3.0);
        drawing
    }

    #[test]
    fn between_steps_the_surface_is_where_the_weights_put_it() {
        let mut drawing = moving();
        assert_eq!(drawing.positions()(2), Vec3::new(1.0, 1.0, 0.0));
        for (time, at) in [(1.0, Vec3::new(2., 2., 0.)), (3.0, Vec3::new(5., 5., 3.))] {
            drawing.set_time(time);
            assert_eq!(drawing.positions()(2), at);
        }
        for i in 0..=30 {
            drawing.set_time(0.1 * i as f32);
            let bounds = drawing.bounds();
            for vertex in 0..4 {
                let apart = drawing.positions()(vertex).distance(bounds.center);
                assert!(apart <= 1.00001 * bounds.radius, "{apart} in {bounds:?}");
            }
        }
    }

    #[test]
    fn after_a_very_short_step_the_ball_is_still_that_of_the_surface() {
        let mut drawing = square();
        let radius = drawing.bounds().radius;
        for time in [1.0, 1.001, 2.0] {
            drawing.add_step(&SQUARE, time, false).expect("later");
        }
        for i in 0..=20 {
            drawing.set_time(0.1 * i as f32);
            let ratio = drawing.bounds().radius / radius;
            assert!((0.999..1.25).contains(&ratio), "{ratio}");
        }
    }

    #[test]
    fn at_the_time_of_a_step_all_is_as_of_that_step_alone() {
        let mut drawing = moving();
        for (time, shift) in [(1.0, 0.0), (3.0, 3.0)] {
            drawing.set_time(time);
            let mut alone = square();
            let own = SQUARE.map(|c| 2.0 * c + shift);
            alone.set_positions(&own).expect("same length");
            assert_eq!(drawing.bounds(), alone.bounds());
            assert_eq!(drawing.lowest(Vec3::Y), alone.lowest(Vec3::Y));
        }
        // A step alone again, with what the last had.
        drawing.set_positions(&SQUARE).expect("same length");
        assert_eq!(drawing.weights(), [1.0, 0.0, 0.0, 0.0]);
        assert_eq!(drawing.steps()[0].vertices()[2], [1.0, 1.0, 0.0, 3.0]);
    }

    #[test]
    fn a_step_that_is_refused_changes_nothing() {
        let mut drawing = moving();
        let before = format!("{drawing:?}");
        let kind = |result: Result<(), ViewerError>| result.expect_err("refused").kind();
        assert_eq!(kind(drawing.add_step(&SQUARE, 3.0, false)), "WrongTime");
        assert_eq!(
            kind(drawing.add_step(&SQUARE[3..], 9.0, false)),
            "WrongLength"
        );
        assert_eq!(format!("{drawing:?}"), before);
    }

    #[test]
    fn normals_are_computed_once_for_each_step() {
        let mut drawing = moving();
        assert_eq!(drawing.update_normals(), [true, true, true, false]);
        assert_eq!(drawing.update_normals(), [false; SLOTS]);
        drawing.add_step(&SQUARE, 4.0, false).expect("later");
        assert_eq!(drawing.update_normals(), [false, false, false, true]);
        drawing.add_step(&SQUARE, 5.0, false).expect("later");
        assert_eq!(drawing.update_normals(), [true, false, false, false]);
        assert_eq!(drawing.steps()[0].normals()[0][..3], [0.0, 0.0, 1.0]);
    }
}
