//! Repairs that change a file's faces, on request: what people bring as a surface becomes one.
//!
//! In turn: boundary vertices at the same place are welded, which also stitches boundary chains
//! that coincide; faces without area go; a vertex in the middle of a neighbour's edge is inserted
//! there; sheets that hang on an edge of two other faces are dropped where they are small, else
//! cut loose. Every change is told with its count and its vertices. Nothing is welded where the
//! surface is whole already: two closed bodies that touch stay two.

mod faces;
mod flat;
mod grid;
mod junction;
mod sheet;
mod weld;

use crate::message::messages;
use crate::soup::PolygonSoup;
use glam::DVec3;

/// How near boundary vertices are welded.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Weld {
    /// Within 1e-6 of the diagonal of the bounding box, and a hundredth of the median edge.
    #[default]
    Auto,
    /// Not at all.
    Off,
    /// Within a length, in the units of the mesh.
    Within(f64),
}

messages! {
    /// What a repair has changed. Vertices are counted from 0, in the order given.
    #[derive(Clone, Debug, PartialEq)]
    pub enum RepairChange as "repaired" {
        /// Boundary vertices were made one with others at the same place.
        Welded {
            /// How many are gone.
            count: usize,
            /// Those they became.
            vertices: Vec<u32>,
        },
        /// Faces without area were dropped.
        FlatFaces {
            /// How many.
            count: usize,
            /// Their corners.
            vertices: Vec<u32>,
        },
        /// Vertices in the middle of a neighbour's edge were inserted there.
        Inserted {
            /// How many times.
            count: usize,
            /// The vertices.
            vertices: Vec<u32>,
        },
        /// Faces of small sheets that hang on an edge of two other faces were dropped.
        Fins {
            /// How many faces.
            count: usize,
            /// Their corners.
            vertices: Vec<u32>,
        },
        /// Edges of more than two faces were cut, so that each sheet has its own.
        CutEdges {
            /// How many.
            count: usize,
            /// Their ends.
            vertices: Vec<u32>,
        },
    }
}

/// A soup that was repaired.
#[derive(Clone, Debug, PartialEq)]
pub struct Repaired {
    /// With unused vertices left in; the mesh builder drops them.
    pub soup: PolygonSoup,
    /// What was done, in turn; empty where there was nothing to do.
    pub changes: Vec<RepairChange>,
}

/// Repairs a soup.
pub fn repair(soup: &PolygonSoup, weld: Weld) -> Repaired {
    let mut soup = soup.clone();
    let mut changes = Vec::new();
    let near = distance(&soup, weld);
    if let Some(near) = near {
        changes.extend(weld::weld(&mut soup, near));
    }
    // A face without area may keep others from meeting, and an inserted vertex may lay one bare.
    let mut flat = Vec::new();
    let mut inserted = Vec::new();
    for _ in 0..ROUNDS {
        let dropped = flat::drop_flat(&mut soup);
        let joined = junction::insert(&mut soup, near.unwrap_or(0.0));
        if dropped.is_empty() && joined.is_empty() {
            break;
        }
        flat.extend(dropped);
        inserted.extend(joined);
    }
    if !flat.is_empty() {
        changes.push(RepairChange::FlatFaces {
            count: flat.len(),
            vertices: named(flat.into_iter().flatten()),
        });
    }
    if !inserted.is_empty() {
        changes.push(RepairChange::Inserted {
            count: inserted.len(),
            vertices: named(inserted),
        });
    }
    changes.extend(sheet::drop_fins(&mut soup));
    changes.extend(sheet::cut(&mut soup));
    Repaired { soup, changes }
}

/// Rounds of flat faces and junctions.
const ROUNDS: usize = 4;

fn named(vertices: impl IntoIterator<Item = u32>) -> Vec<u32> {
    let mut all: Vec<u32> = vertices.into_iter().collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// Within which vertices are one.
fn distance(soup: &PolygonSoup, weld: Weld) -> Option<f64> {
    match weld {
        Weld::Off => None,
        Weld::Within(length) => Some(length),
        Weld::Auto => {
            let low = soup
                .positions
                .iter()
                .copied()
                .fold(DVec3::INFINITY, DVec3::min);
            let high = soup
                .positions
                .iter()
                .copied()
                .fold(-DVec3::INFINITY, DVec3::max);
            let mut lengths: Vec<f64> = edges(soup)
                .map(|(a, b)| soup.positions[a as usize].distance(soup.positions[b as usize]))
                .filter(|length| *length > 0.0)
                .collect();
            if lengths.is_empty() {
                return None;
            }
            let middle = lengths.len() / 2;
            let (_, median, _) = lengths.select_nth_unstable_by(middle, f64::total_cmp);
            Some((1e-6 * low.distance(high)).min(1e-2 * *median))
        }
    }
}

/// The sides of all faces.
fn edges(soup: &PolygonSoup) -> impl Iterator<Item = (u32, u32)> + '_ {
    soup.faces().flat_map(|face| {
        let next = face.iter().cycle().skip(1);
        face.iter().copied().zip(next.copied())
    })
}

/// Ends of an edge in order.
fn key(a: u32, b: u32) -> (u32, u32) {
    (a.min(b), a.max(b))
}

#[cfg(test)]
mod tests;
