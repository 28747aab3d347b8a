//! The part every reader shares: a soup that grows, and the checks on what it takes in.

use glam::DVec3;

use super::{Format, Oddity, Place, Read, ReadError};
use crate::soup::{Colour, PolygonSoup};

/// A part of a colour that a file does not give.
pub(super) const NO_PART: f64 = f64::NAN;

/// Colours beyond are counted to 255, as many programs write them in text.
const BRIGHTEST: f32 = 2.0;

/// A soup being read.
pub(super) struct Assembly {
    soup: PolygonSoup,
    /// Vertices and corners are counted in 32 bits.
    limit: usize,
    dropped: Tally,
    /// Vertices whose position is not finite, which no face may use, and where they stand.
    unplaced: Vec<(u32, Place)>,
}

impl Assembly {
    pub(super) fn new() -> Self {
        Self {
            soup: PolygonSoup::default(),
            limit: u32::MAX as usize,
            dropped: Tally::default(),
            unplaced: Vec::new(),
        }
    }

    /// Makes room; callers ask only for what the file's bytes can hold.
    pub(super) fn reserve(&mut self, vertices: usize, faces: usize) {
        self.soup.positions.reserve_exact(vertices);
        self.soup.face_starts.reserve_exact(faces);
    }

    pub(super) fn n_vertices(&self) -> usize {
        self.soup.positions.len()
    }

    pub(super) fn n_faces(&self) -> usize {
        self.soup.n_faces()
    }

    pub(super) fn positions(&self) -> &[DVec3] {
        &self.soup.positions
    }

    /// Appends a vertex. Of one without a finite position it is seen at the end whether a face
    /// uses it.
    ///
    /// # Errors
    /// [`ReadError::CountTooLarge`] past 2³² vertices.
    pub(super) fn vertex(&mut self, position: DVec3, place: Place) -> Result<(), ReadError> {
        let vertex = self.n_vertices();
        self.check_limit("vertices", vertex + 1, place)?;
        if !position.is_finite() {
            self.unplaced.push((vertex as u32, place));
        }
        self.soup.positions.push(position);
        Ok(())
    }

    /// Gives a vertex its colour: the first that it is given counts.
    pub(super) fn colour(&mut self, vertex: usize, parts: [f64; 4]) {
        let colours = &mut self.soup.colours;
        if vertex >= colours.len() {
            colours.resize(vertex, [NO_PART as f32; 4]);
            colours.push(parts.map(|part| part as f32));
        }
    }

    pub(super) fn has_colours(&self) -> bool {
        !self.soup.colours.is_empty()
    }

    /// Appends a face whose indices the reader has checked, unless it has too few corners.
    ///
    /// # Errors
    /// [`ReadError::CountTooLarge`] past 2³² corners.
    pub(super) fn face(&mut self, corners: &[u32], place: Place) -> Result<(), ReadError> {
        if corners.len() < 3 {
            self.dropped.count(place);
            return Ok(());
        }
        self.check_corners(self.soup.corners.len() + corners.len(), place)?;
        self.soup.push_face(corners);
        Ok(())
    }

    /// Appends the triangle that a strip ends with, so far.
    ///
    /// # Errors
    /// As for [`face`](Self::face).
    pub(super) fn strip(&mut self, so_far: &[u32], place: Place) -> Result<(), ReadError> {
        strip_triangle(so_far).map_or(Ok(()), |triangle| self.face(&triangle, place))
    }

    /// The vertex that a face names, counted from 0.
    ///
    /// # Errors
    /// [`ReadError::IndexOutOfRange`] of those read so far.
    pub(super) fn index(&self, index: f64, format: Format, place: Place) -> Result<u32, ReadError> {
        let vertices = self.n_vertices();
        if index >= 0.0 && index < vertices as f64 {
            return Ok(index as u32);
        }
        Err(ReadError::IndexOutOfRange {
            format,
            place,
            index: index as i64,
            vertices,
        })
    }

    /// # Errors
    /// [`ReadError::CountTooLarge`] past 2³² corners.
    pub(super) fn check_corners(&self, n: usize, place: Place) -> Result<(), ReadError> {
        self.check_limit("corners", n, place)
    }

    fn check_limit(&self, what: &'static str, n: usize, place: Place) -> Result<(), ReadError> {
        if n <= self.limit {
            return Ok(());
        }
        Err(ReadError::CountTooLarge {
            place,
            what,
            count: n as u64,
            at_most: self.limit as u64,
        })
    }

    /// Puts vertices without a finite position that no face uses where the first vertex is that
    /// has one: a grid that a scanner fills in part marks its gaps so.
    fn settle_unplaced(&mut self) -> Result<Option<Oddity>, ReadError> {
        let Some(&(_, first)) = self.unplaced.first() else {
            return Ok(None);
        };
        let mut is_used = vec![false; self.n_vertices()];
        for &corner in &self.soup.corners {
            is_used[corner as usize] = true;
        }
        if let Some(&(v, place)) = self.unplaced.iter().find(|(v, _)| is_used[*v as usize]) {
            let number = v as usize + 1;
            return Err(ReadError::NonFiniteVertex { number, place });
        }
        let positions = &mut self.soup.positions;
        let somewhere = positions.iter().find(|position| position.is_finite());
        let somewhere = somewhere.copied().unwrap_or_default();
        for &(vertex, _) in &self.unplaced {
            positions[vertex as usize] = somewhere;
        }
        let count = self.unplaced.len();
        Ok(Some(Oddity::UnplacedVertices { count, first }))
    }

    /// The finished soup.
    ///
    /// # Errors
    /// [`ReadError::NoFaces`] and [`ReadError::NonFiniteVertex`] of one that a face uses.
    pub(super) fn finish(mut self, format: Format) -> Result<Read, ReadError> {
        if self.soup.n_faces() == 0 {
            return Err(ReadError::NoFaces {
                vertices: self.soup.positions.len(),
            });
        }
        let unplaced = self.settle_unplaced()?;
        if self.has_colours() {
            let vertices = self.n_vertices();
            settle(&mut self.soup.colours, vertices);
        }
        let short = |(count, first)| Oddity::ShortFaces { count, first };
        Ok(Read {
            soup: self.soup,
            format,
            warnings: self
                .dropped
                .met()
                .map(short)
                .into_iter()
                .chain(unplaced)
                .collect(),
        })
    }
}

/// Makes colours of what a file gives: a part that is missing is 1, so that a vertex without a
/// colour is white.
fn settle(colours: &mut Vec<Colour>, vertices: usize) {
    colours.resize(vertices, [NO_PART as f32; 4]);
    let is_bytes = colours.iter().flatten().any(|part| *part > BRIGHTEST);
    let largest = if is_bytes { 255.0 } else { 1.0 };
    for part in colours.iter_mut().flatten() {
        *part = match part.is_finite() {
            true => ((f64::from(*part) / largest) as f32).clamp(0.0, 1.0),
            false => 1.0,
        };
    }
}

/// The triangle that the last corner of a strip makes with the two before it, every other turned
/// round. A corner that repeats joins two parts of a strip and makes none.
pub(super) fn strip_triangle(so_far: &[u32]) -> Option<[u32; 3]> {
    match *so_far {
        [.., a, b, c] if a != b && b != c && c != a => {
            let is_turned = so_far.len().is_multiple_of(2);
            Some(if is_turned { [b, a, c] } else { [a, b, c] })
        }
        _ => None,
    }
}

/// How often something was met, and where first.
#[derive(Default)]
pub(super) struct Tally {
    count: usize,
    first: Option<Place>,
}

impl Tally {
    pub(super) fn count(&mut self, place: Place) {
        self.count += 1;
        self.first.get_or_insert(place);
    }

    /// Counts in what another has met.
    pub(super) fn add(&mut self, other: &Self) {
        self.count += other.count;
        self.first = self.first.into_iter().chain(other.first).min();
    }

    /// How often, and where first; `None` if never.
    pub(super) fn met(&self) -> Option<(usize, Place)> {
        Some((self.count, self.first?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_than_indices_can_count_is_refused() {
        let place = Place::Line { line: 9 };
        let too_large = |what| {
            Err(ReadError::CountTooLarge {
                place,
                what,
                count: 4,
                at_most: 3,
            })
        };
        let mut assembly = Assembly {
            limit: 3,
            ..Assembly::new()
        };
        for _ in 0..3 {
            assert_eq!(assembly.vertex(DVec3::ZERO, place), Ok(()));
        }
        assert_eq!(assembly.vertex(DVec3::ZERO, place), too_large("vertices"));
        assert_eq!(assembly.face(&[0, 1, 2, 0], place), too_large("corners"));
        assert_eq!(assembly.face(&[0, 1, 2], place), Ok(()));
    }

    #[test]
    fn short_faces_are_counted_once() {
        let mut assembly = Assembly::new();
        for line in 1..4 {
            assembly.vertex(DVec3::ZERO, Place::Line { line }).unwrap();
        }
        assembly.face(&[0, 1], Place::Line { line: 5 }).unwrap();
        assembly.face(&[0, 1, 2], Place::Line { line: 6 }).unwrap();
        assembly.face(&[], Place::Line { line: 7 }).unwrap();
        let read = assembly.finish(Format::Off).unwrap();
        assert_eq!(read.soup.n_faces(), 1);
        assert_eq!(
            read.warnings,
            [Oddity::ShortFaces {
                count: 2,
                first: Place::Line { line: 5 }
            }]
        );
    }
}
