//! Repairs that change a file's faces, on request: what people bring as a surface becomes one.
//!
//! In turn: quadrilaterals whose sides cross get their corners in order; sheets and bodies that lie on
//! another are dropped; boundary vertices at the same place
//! are welded where that stitches two edges, so that boundary chains that coincide close; faces
//! without area go; a vertex in the middle of a neighbour's edge is inserted there; sheets that hang
//! on an edge of two other faces are dropped where they are walls between two others or small, else
//! cut loose. Every change is listed with its count and its vertices.
//! Nothing is welded where the surface is whole already: two closed bodies that touch stay two,
//! and so do two holes that share a corner.

mod collapse;
mod crossed;
mod double;
mod faces;
mod flat;
mod grid;
mod hash;
mod junction;
mod sheet;
mod suspect;
mod weld;

pub use suspect::{gap, is_suspect};

use crate::mesh::{self, Repair};
use crate::message::{Message, Say, messages};
use crate::soup::PolygonSoup;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// How near boundary vertices are welded: a word, or a length.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum Weld {
    /// Within 1e-6 of the diagonal of the bounding box or, of coordinates that were rounded to single
    /// precision, some units in the last place of the largest; no farther than a hundredth of the median
    /// edge.
    #[default]
    Auto,
    /// Not at all.
    Off,
    /// Within a length, in the units of the mesh.
    #[serde(untagged)]
    Within(f64),
}

messages! {
    /// What a repair has changed.
    #[derive(Clone, Debug, PartialEq)]
    pub enum RepairChange as "repaired" {
        /// Corners of quadrilaterals whose sides crossed were put in order.
        Uncrossed {
            /// How many.
            count: usize,
        },
        /// Faces of sheets that lie exactly on an earlier one were dropped.
        DoubledFaces {
            /// How many.
            count: usize,
        },
        /// Boundary vertices were made one with others at the same place.
        Welded {
            /// How many are gone.
            count: usize,
        },
        /// Edges without length were collapsed, with the faces at them.
        CollapsedEdges {
            /// How many.
            count: usize,
        },
        /// Faces without area were dropped.
        FlatFaces {
            /// How many.
            count: usize,
        },
        /// Vertices in the middle of a neighbour's edge were inserted there.
        Inserted {
            /// How many times.
            count: usize,
        },
        /// Faces of small sheets that hang on an edge of two other faces were dropped.
        Fins {
            /// How many faces.
            count: usize,
        },
        /// Edges of more than two faces were cut, so that each sheet has its own.
        CutEdges {
            /// How many.
            count: usize,
        },
        /// Edges of more than two faces whose ends hang together elsewhere were doubled: by a vertex
        /// in the middle that all but two of the faces have.
        DoubledEdges {
            /// How many.
            count: usize,
        },
        /// Faces of walls inside a body were dropped.
        Walls {
            /// How many faces.
            count: usize,
        },
    }
}

/// A kind of change, how often it was made, and where.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// Noun of what was done.
    pub kind: &'static str,
    /// How often.
    pub count: usize,
    /// The same to be said.
    pub message: Message,
    /// Vertices at which it was made, in the order given to [`repair`], each once.
    pub vertices: Vec<u32>,
}

impl Change {
    /// Of something said, whose value `count` is the count; without one it is of all `faces`.
    pub fn of(said: &impl Say, faces: usize, vertices: impl IntoIterator<Item = u32>) -> Self {
        let message = said.message();
        let mut vertices: Vec<u32> = vertices.into_iter().collect();
        vertices.sort_unstable();
        vertices.dedup();
        Self {
            kind: said.kind(),
            count: message.number("count").map_or(faces, |n| n as usize),
            message,
            vertices,
        }
    }

    /// What [`build`](crate::mesh::build()) changed, of a soup with so many faces; `None` where it
    /// only noted something.
    pub fn built(repair: &Repair, faces: usize) -> Option<Self> {
        let vertices = match repair {
            Repair::OneSided { .. } => return None,
            Repair::SplitVertices {
                vertices, first, ..
            } => vertices.iter().map(|v| v - first).collect(),
            _ => Vec::new(),
        };
        Some(Self::of(repair, faces, vertices))
    }
}

/// A soup that was repaired.
#[derive(Clone, Debug, PartialEq)]
pub struct Repaired {
    /// Vertices that lost their last face are left out.
    pub soup: PolygonSoup,
    /// For each vertex the one given that it is, or is a copy of.
    pub origin: Vec<u32>,
    /// What was done, in turn; where there was nothing to do it is empty, and the soup is as given.
    pub changes: Vec<Change>,
}

/// Rounds of welds, flat faces and junctions: each may make way for another.
const ROUNDS: usize = 16;

/// What the rounds did: a number and its vertices.
#[derive(Default)]
struct Tally {
    count: usize,
    vertices: Vec<u32>,
}

impl Tally {
    fn add(&mut self, (count, vertices): (usize, Vec<u32>)) -> bool {
        self.count += count;
        self.vertices.extend(vertices);
        count > 0
    }

    fn change(self, said: impl FnOnce(usize) -> RepairChange) -> Option<Change> {
        let Self { count, vertices } = self;
        (count > 0).then(|| Change::of(&said(count), 0, vertices))
    }
}

/// Repairs a soup. One that [`build`](crate::mesh::build()) refuses for its indices or coordinates
/// stays as it is.
pub fn repair(given: &PolygonSoup, weld: Weld) -> Repaired {
    let n = given.positions.len();
    let is_sound = given.positions.iter().all(|p| p.is_finite())
        && given.corners.iter().all(|&v| (v as usize) < n);
    let mut origin: Vec<u32> = (0..n as u32).collect();
    let (mut soup, mut changes) = (given.clone(), Vec::new());
    if is_sound {
        changes = changed(&mut soup, &mut origin, weld);
    }
    if changes.is_empty() {
        let soup = given.clone();
        let origin = (0..n as u32).collect();
        return Repaired {
            soup,
            origin,
            changes,
        };
    }
    drop_orphans(given, &mut soup, &mut origin);
    Repaired {
        soup,
        origin,
        changes,
    }
}

fn changed(soup: &mut PolygonSoup, origin: &mut Vec<u32>, weld: Weld) -> Vec<Change> {
    let mut repairs = Vec::new();
    *soup = mesh::clean_faces(soup, &mut repairs);
    let cleaned = repairs.iter().filter_map(|r| Change::built(r, 0));
    let mut changes: Vec<Change> = cleaned.collect();

    let [mut crossed, mut doubled] = [(); 2].map(|()| Tally::default());
    crossed.add(crossed::uncross(soup));
    changes.extend(crossed.change(|count| RepairChange::Uncrossed { count }));
    doubled.add(double::drop_doubles(soup));
    changes.extend(doubled.change(|count| RepairChange::DoubledFaces { count }));
    let near = distance(soup, weld);
    let short = distance(soup, Weld::Auto)
        .unwrap_or(0.0)
        .min(near.unwrap_or(0.0));
    let [mut welded, mut collapsed, mut flat, mut inserted] = [(); 4].map(|()| Tally::default());
    for _ in 0..ROUNDS {
        let mut again = false;
        if let Some(near) = near {
            // What coincides first: then it is no boundary, and nothing a little farther off
            // can come between.
            again |= welded.add(weld::weld(soup, 0.0));
            again |= welded.add(weld::weld(soup, near));
        }
        let dropped = flat::drop_flat(soup, short);
        again |= collapsed.add(dropped.collapsed);
        again |= flat.add(dropped.flat);
        again |= inserted.add(junction::insert(soup, near.unwrap_or(0.0)));
        if !again {
            break;
        }
    }
    use RepairChange as R;
    changes.extend(welded.change(|count| R::Welded { count }));
    changes.extend(collapsed.change(|count| R::CollapsedEdges { count }));
    changes.extend(flat.change(|count| R::FlatFaces { count }));
    changes.extend(inserted.change(|count| R::Inserted { count }));
    if sheet::has_crowded_edge(soup) {
        changes.extend(sheet::drop_walls(soup));
        changes.extend(sheet::drop_fins(soup));
        changes.extend(sheet::cut(soup, origin));
    }
    changes
}

/// Leaves out the vertices that had a face and have none any more.
fn drop_orphans(given: &PolygonSoup, soup: &mut PolygonSoup, origin: &mut Vec<u32>) {
    let mut is_kept = vec![true; soup.positions.len()];
    for &v in &given.corners {
        is_kept[v as usize] = false;
    }
    for &v in &soup.corners {
        is_kept[v as usize] = true;
    }
    let mut name = vec![u32::MAX; is_kept.len()];
    let mut kept = Vec::new();
    for v in (0..is_kept.len()).filter(|&v| is_kept[v]) {
        name[v] = kept.len() as u32;
        kept.push(v);
    }
    for v in &mut soup.corners {
        *v = name[*v as usize];
    }
    soup.positions = kept.iter().map(|&v| soup.positions[v]).collect();
    *origin = kept.iter().map(|&v| origin[v]).collect();
}

/// Within which vertices are one.
fn distance(soup: &PolygonSoup, weld: Weld) -> Option<f64> {
    match weld {
        Weld::Off => None,
        Weld::Within(length) => Some(length.max(0.0)),
        Weld::Auto => {
            let x = &soup.positions;
            let lengths = edges(soup).map(|(a, b)| x[a as usize].distance(x[b as usize]));
            automatic(x, lengths.collect())
        }
    }
}

/// Within which vertices are one unless told otherwise.
fn automatic(x: &[DVec3], mut lengths: Vec<f64>) -> Option<f64> {
    lengths.retain(|length| *length > 0.0);
    if lengths.is_empty() {
        return None;
    }
    let (low, high) = bounds(x);
    let middle = lengths.len() / 2;
    let (_, median, _) = lengths.select_nth_unstable_by(middle, f64::total_cmp);
    // A corner that each face rounds on its own is off by half a unit in each coordinate. Moved near the
    // origin, coordinates in single precision keep the units they had far from it.
    let is_single = |c: f64| f64::from(c as f32) == c;
    let own = if x.iter().all(|p| p.to_array().into_iter().all(is_single)) {
        4.0 * f64::from(f32::EPSILON) * low.abs().max(high.abs()).max_element()
    } else {
        0.0
    };
    let rounded = (0..3)
        .map(|axis| 8.0 * unit_of(x, axis))
        .fold(own, f64::max);
    let near = (1e-6 * low.distance(high)).max(rounded);
    Some(near.min(1e-2 * *median))
}

/// Units across a surface from which on they come of rounding, and not of a design.
const ROUNDED: f64 = 1000.0;

/// The power of two that all coordinates along an axis are multiples of; 0 where few go across.
fn unit_of(x: &[DVec3], axis: usize) -> f64 {
    // The lowest bit of a number that is set.
    let lowest = |c: f64| {
        let (bits, exponent) = (c.to_bits(), (c.to_bits() >> 52 & 0x7ff) as i32);
        let zeros = (bits & ((1 << 52) - 1) | 1 << 52).trailing_zeros() as i32;
        exponent + zeros - 1075
    };
    let (mut unit, mut low, mut high) = (i32::MAX, f64::INFINITY, f64::NEG_INFINITY);
    for c in x.iter().map(|p| p[axis]) {
        (low, high) = (low.min(c), high.max(c));
        if c != 0.0 {
            unit = unit.min(lowest(c));
        }
    }
    let unit = if unit == i32::MAX {
        0.0
    } else {
        2f64.powi(unit)
    };
    if ROUNDED * unit < high - low {
        unit
    } else {
        0.0
    }
}

/// Corners of the bounding box.
fn bounds(x: &[DVec3]) -> (DVec3, DVec3) {
    let empty = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    x.iter()
        .fold(empty, |(low, high), p| (low.min(*p), high.max(*p)))
}

/// The sides of all faces.
fn edges(soup: &PolygonSoup) -> impl Iterator<Item = (u32, u32)> + Clone + '_ {
    soup.faces().flat_map(faces::sides)
}

/// Ends of an edge in order.
fn key(a: u32, b: u32) -> (u32, u32) {
    (a.min(b), a.max(b))
}

#[cfg(test)]
mod tests;
