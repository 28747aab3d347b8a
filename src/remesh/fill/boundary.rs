//! Boundary loops, and what the surface around them forbids.

use super::error::FillError;
use super::notice::total_curvature;
use crate::geometry::measure;
use crate::mesh::{HalfedgeMesh, Vertex};
use crate::order;
use glam::DVec3;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::f64::consts::TAU;

/// Vertices of a loop closer than this share of its mean edge lie in the same place.
const SAME_PLACE: f64 = 1e-9;

/// Vertices of a loop closer to a line than this share of its length lie on it, as far as numbers
/// of single precision can tell.
const ON_A_LINE: f64 = 1e-6;

/// A loop is small where it is no longer than so many times the diagonal of its component's
/// bounding box: a circle of a third of it. The outer rim of a sheet is twice and more as long.
const SMALL: f64 = 1.0;

/// What continues a surface over the end of a tube is a hemisphere, ∫K = 2π; over a hole it bends
/// as the surface around does. A loop that asks for more than this, half of that, is the mouth of
/// something, and no hole, where it is not tiny.
const MOUTH: f64 = std::f64::consts::PI;

/// A mouth whose length squared is below this share of the area of its component is taken for a
/// hole nevertheless: a tip that is missing, of a finger and not of a tube.
const TIP: f64 = 1.0 / 64.0;

/// A boundary loop; it has as many edges as vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct BoundaryLoop {
    /// Its vertices in the order in which a face that fills it would list them.
    pub vertices: Vec<u32>,
    /// Sum of its edge lengths.
    pub length: f64,
    /// Copies of one vertex, made because surface meets there in a point, that are one again as
    /// soon as the loop is filled: those where an edge of it ends and where the next begins.
    pub copies: Vec<[u32; 2]>,
}

/// A vertex of a loop by the copy at which an edge ends and that at which the next begins.
type Passed = [u32; 2];

/// Bits of a place; of −0 and 0 the same.
fn key(x: &[DVec3], v: u32) -> [u64; 3] {
    (x[v as usize] + 0.0).to_array().map(f64::to_bits)
}

/// The boundary loops of a mesh, in the order of [`HalfedgeMesh::boundary_loops`]; one that passes
/// a point more than once is several, in the order in which they close, and so are those about an
/// island that meets the rim around it in its corners.
pub fn boundary_loops(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<BoundaryLoop> {
    let loops: Vec<Vec<u32>> = mesh
        .boundary_loops()
        .map(|halfedges| halfedges.map(|h| mesh.tail(h).0).collect())
        .collect();
    if loops.is_empty() {
        return Vec::new();
    }
    taken_apart(&loops, x)
}

deferred! {
    /// The loops as they are filled, see [`boundary_loops`].
    fn taken_apart(loops: &[Vec<u32>], x: &[DVec3]) -> Vec<BoundaryLoop> {
        let mut is_done = vec![false; loops.len()];
        let mut all = Vec::new();
        for (name, group) in touching(loops, x).into_iter().enumerate() {
            if is_done[name] {
                continue;
            }
            // Of the ways to go around them that which makes the most loops: none is around another.
            let ways = if group.len() > 1 { &[false, true][..] } else { &[] };
            let together = |late: &bool| parts(&spliced(loops, &group, x, *late)?, x);
            let found = ways.iter().filter_map(together).max_by_key(Vec::len);
            let found = match found {
                Some(found) => {
                    group.iter().for_each(|&other| is_done[other] = true);
                    found
                }
                None => {
                    let whole: Vec<Passed> = loops[name].iter().map(|&v| [v, v]).collect();
                    parts(&whole, x).unwrap_or_else(|| vec![whole])
                }
            };
            all.extend(found.iter().map(|part| of_part(part, x)));
        }
        all
    }
}

/// For each loop those that hang together with it, it among them: two that meet in more than one
/// point, as an island and the rim around it.
fn touching(loops: &[Vec<u32>], x: &[DVec3]) -> Vec<Vec<usize>> {
    let mut at: HashMap<[u64; 3], Vec<usize>> = HashMap::new();
    let mut meetings: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    for (name, vertices) in loops.iter().enumerate() {
        for &v in vertices {
            let others = at.entry(key(x, v)).or_default();
            for &other in others.iter().filter(|other| **other != name) {
                *meetings.entry((other, name)).or_default() += 1;
            }
            others.push(name);
        }
    }
    let mut groups: Vec<Vec<usize>> = (0..loops.len()).map(|name| vec![name]).collect();
    for ((a, b), _) in meetings.into_iter().filter(|(_, count)| *count > 1) {
        if groups[a].contains(&b) {
            continue;
        }
        let union = [groups[a].clone(), groups[b].clone()].concat();
        for &name in &union {
            groups[name].clone_from(&union);
        }
    }
    groups.iter_mut().for_each(|group| group.sort_unstable());
    groups
}

/// One path along loops that meet: around the longest, from where nothing else meets it, and where it
/// comes to another for the first time, or the last, around that one. `None` where there is no such
/// start.
fn spliced(loops: &[Vec<u32>], group: &[usize], x: &[DVec3], late: bool) -> Option<Vec<Passed>> {
    let mut times: HashMap<[u64; 3], usize> = HashMap::new();
    for &v in group.iter().flat_map(|&name| &loops[name]) {
        *times.entry(key(x, v)).or_default() += 1;
    }
    let longest = *group.iter().max_by_key(|name| loops[**name].len())?;
    let mut path: Vec<Passed> = loops[longest].iter().map(|&v| [v, v]).collect();
    let start = path.iter().position(|[v, _]| times[&key(x, *v)] == 1)?;
    path.rotate_left(start);
    let mut left: Vec<usize> = group
        .iter()
        .copied()
        .filter(|name| *name != longest)
        .collect();
    while !left.is_empty() {
        // Of a place that is passed twice the last.
        let place_of: HashMap<_, usize> = (path.iter().enumerate())
            .map(|(at, [v, _])| (key(x, *v), at))
            .collect();
        let meeting = left.iter().enumerate().find_map(|(n, &name)| {
            let found = loops[name].iter().enumerate();
            let found = found.filter_map(|(i, &v)| Some((*place_of.get(&key(x, v))?, i)));
            let found = if late { found.max() } else { found.min() };
            found.map(|(at, i)| (n, i, at))
        });
        let (n, i, at) = meeting?;
        let other = &loops[left.remove(n)];
        let [before, after] = path[at];
        let around = (1..other.len()).map(|k| other[(i + k) % other.len()]);
        let around = around.map(|v| [v, v]);
        let back = std::iter::once([other[i], after]);
        let detour: Vec<Passed> = around.chain(back).collect();
        path[at] = [before, other[i]];
        path.splice(at + 1..at + 1, detour);
    }
    Some(path)
}

/// The parts of a path between passing a point and passing it again; `None` where a part has no
/// inside, as along a slit.
fn parts(passed: &[Passed], x: &[DVec3]) -> Option<Vec<Vec<Passed>>> {
    let mut found = Vec::new();
    let mut path: Vec<Passed> = Vec::new();
    let mut place_of: HashMap<[u64; 3], usize> = HashMap::new();
    for &[ends, begins] in passed {
        let Some(&place) = place_of.get(&key(x, ends)) else {
            place_of.insert(key(x, ends), path.len());
            path.push([ends, begins]);
            continue;
        };
        let mut part = path.split_off(place);
        if part.len() < 3 {
            return None;
        }
        for [w, _] in &part[1..] {
            place_of.remove(&key(x, *w));
        }
        // The part ends at this copy, and the path goes on from it.
        let [before, after] = part[0];
        part[0] = [ends, after];
        path.push([before, begins]);
        found.push(part);
    }
    if path.len() < 3 {
        return None;
    }
    found.push(path);
    Some(found)
}

fn of_part(part: &[[u32; 2]], x: &[DVec3]) -> BoundaryLoop {
    let next = part.iter().cycle().skip(1);
    let edges = part.iter().zip(next);
    let lengths = edges.map(|([_, a], [b, _])| x[*a as usize].distance(x[*b as usize]));
    BoundaryLoop {
        length: lengths.sum(),
        vertices: part.iter().map(|[_, v]| *v).collect(),
        copies: part.iter().copied().filter(|[a, b]| a != b).collect(),
    }
}

/// The loops that are holes, and no outer rims or mouths of tubes.
pub fn small_loops(mesh: &HalfedgeMesh, x: &[DVec3], all: &[BoundaryLoop]) -> Vec<usize> {
    let (component, count) = mesh.components();
    let mut boxes = vec![(DVec3::INFINITY, DVec3::NEG_INFINITY); count];
    for (p, c) in x.iter().zip(&component) {
        let (low, high) = &mut boxes[*c as usize];
        (*low, *high) = (low.min(*p), high.max(*p));
    }
    let size = |c: &usize| boxes[*c].0.distance(boxes[*c].1);
    // About an island the surface is what the island belongs to.
    let component_of = |index: usize| {
        let all = all[index].vertices.iter();
        let all = all.map(|v| component[*v as usize] as usize);
        all.reduce(|a, b| if size(&b) > size(&a) { b } else { a })
            .unwrap_or(0)
    };
    let is_short = |index: &usize| {
        let (low, high) = boxes[component_of(*index)];
        all[*index].length <= SMALL * low.distance(high)
    };
    let mut small: Vec<usize> = (0..all.len()).filter(is_short).collect();
    let mut areas = vec![0.0; if small.is_empty() { 0 } else { count }];
    if !small.is_empty() {
        for f in mesh.faces() {
            let of = mesh.face_vertices(f).next();
            let of = of.map_or(0, |v| component[v.index()] as usize);
            areas[of] += measure::face_vector_area(mesh, x, f).length();
        }
    }
    small.retain(|&index| {
        all[index].length.powi(2) <= TIP * areas[component_of(index)]
            || total_curvature(&Rim::new(mesh, all, vec![index]).angles(mesh, x)) <= MOUTH
    });
    small
}

/// Refuses a loop that has no inside: all of it on a line, or two vertices that are not neighbours
/// in the same place.
pub(super) fn check_simple(
    index: usize,
    boundary: &BoundaryLoop,
    x: &[DVec3],
) -> Result<(), FillError> {
    if is_straight(boundary, x) {
        return Err(FillError::StraightLoop { index });
    }
    let m = boundary.vertices.len();
    let same = SAME_PLACE * boundary.length / m as f64;
    // Along a direction that few meshes have a plane across.
    let direction = DVec3::new(0.5377, 0.6411, 0.5471);
    let place = |i: usize| x[boundary.vertices[i] as usize];
    let mut order: Vec<usize> = (0..m).collect();
    order::sort_by(&mut order, |&i, &j| {
        place(i).dot(direction).total_cmp(&place(j).dot(direction))
    });
    for (at, &i) in order.iter().enumerate() {
        let near = |j: &&usize| (place(**j) - place(i)).dot(direction) <= same;
        for &j in order[at + 1..].iter().take_while(near) {
            let apart = i.abs_diff(j).min(m - i.abs_diff(j));
            if apart > 1 && place(i).distance(place(j)) <= same {
                let (a, b) = (boundary.vertices[i.min(j)], boundary.vertices[i.max(j)]);
                return Err(FillError::TouchingLoop { index, a, b });
            }
        }
    }
    Ok(())
}

/// Whether all vertices lie on the line from the first to the one farthest from it.
fn is_straight(boundary: &BoundaryLoop, x: &[DVec3]) -> bool {
    let first = x[boundary.vertices[0] as usize];
    let arms = || boundary.vertices.iter().map(|&v| x[v as usize] - first);
    let farthest = arms().max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
    let line = farthest.unwrap_or_default().normalize_or_zero();
    arms().all(|arm| arm.reject_from_normalized(line).length() <= ON_A_LINE * boundary.length)
}

/// The held vertices of a patch, numbered loop after loop.
pub(super) struct Rim {
    /// The loops, by their numbers.
    pub(super) loops: Vec<usize>,
    /// Number in the mesh of each vertex.
    pub(super) vertices: Vec<u32>,
    /// Where each loop begins; one entry more than there are loops.
    pub(super) starts: Vec<usize>,
    /// Number of edges at each vertex.
    pub(super) valences: Vec<usize>,
    /// Pairs that share a face, smaller first: they are joined by an edge, or by one as
    /// soon as the face is cut into triangles.
    pub(super) joined: HashSet<(u32, u32)>,
    /// Mean length of the loops' edges.
    pub(super) mean_edge: f64,
    /// Of each vertex the copies of it, where it has others.
    copies: HashMap<u32, Vec<u32>>,
}

impl Rim {
    pub(super) fn new(mesh: &HalfedgeMesh, all: &[BoundaryLoop], loops: Vec<usize>) -> Self {
        let mut vertices = Vec::new();
        let mut starts = vec![0];
        for &index in &loops {
            vertices.extend_from_slice(&all[index].vertices);
            starts.push(vertices.len());
        }
        let mut local: HashMap<u32, u32> = vertices.iter().copied().zip(0..).collect();
        let mut copies: HashMap<u32, Vec<u32>> = HashMap::new();
        for &[other, v] in loops.iter().flat_map(|&index| &all[index].copies) {
            copies.entry(v).or_default().push(other);
            if let Some(&i) = local.get(&v) {
                local.insert(other, i);
            }
        }
        let mut joined = HashSet::new();
        let of = |v: u32| std::iter::once(v).chain(copies.get(&v).into_iter().flatten().copied());
        for (&v, i) in vertices.iter().zip(0..) {
            let spokes = of(v).flat_map(|copy| mesh.star(Vertex(copy)));
            for spoke in spokes.filter(|s| s.face.is_some()) {
                for w in mesh.face_vertices(spoke.face) {
                    if let Some(&j) = local.get(&w.0).filter(|j| **j > i) {
                        joined.insert((i, j));
                    }
                }
            }
        }
        let length: f64 = loops.iter().map(|&index| all[index].length).sum();
        let valence = |v: &u32| of(*v).map(|copy| mesh.valence(Vertex(copy))).sum();
        Self {
            valences: vertices.iter().map(valence).collect(),
            mean_edge: length / vertices.len() as f64,
            loops,
            vertices,
            starts,
            joined,
            copies,
        }
    }

    /// Whether two of the vertices share a face.
    pub(super) fn is_joined(&self, i: u32, j: u32) -> bool {
        self.joined.contains(&(i.min(j), i.max(j)))
    }

    /// The sides of the loops, in the direction of a face that fills them.
    pub(super) fn sides(&self) -> impl Iterator<Item = (u32, u32)> + '_ {
        self.starts.windows(2).flat_map(|range| {
            let (from, to) = (range[0] as u32, range[1] as u32);
            (from..to).map(move |i| (i, if i + 1 == to { from } else { i + 1 }))
        })
    }

    /// Which of the loops a vertex belongs to.
    pub(super) fn loop_of(&self, i: u32) -> usize {
        self.starts.partition_point(|&start| start <= i as usize) - 1
    }

    /// Whether the three vertices of a rim of three have a face already.
    pub(super) fn is_face(&self, mesh: &HalfedgeMesh) -> bool {
        let is_rim = |w: Vertex| self.vertices.contains(&w.0);
        let has_rim = |s: &crate::mesh::walk::Spoke| {
            s.face.is_some() && mesh.face_vertices(s.face).filter(|&w| is_rim(w)).count() == 3
        };
        self.vertices.len() == 3 && mesh.star(Vertex(self.vertices[0])).any(|s| has_rim(&s))
    }

    /// Interior angle at each vertex as the surface around sees it: 2π less its angles. Where other
    /// holes touch the vertex, the angle between the two sides.
    pub(super) fn angles(&self, mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<f64> {
        let between = |v: u32, p: u32, q: u32| {
            let [a, b] = [p, q].map(|w| x[w as usize] - x[v as usize]);
            a.cross(b).length().atan2(a.dot(b))
        };
        let around = |v: u32| {
            let spokes: Vec<_> = mesh.star(Vertex(v)).collect();
            let corners = spokes.windows(2);
            TAU - corners
                .map(|pair| between(v, pair[0].neighbour.0, pair[1].neighbour.0))
                .sum::<f64>()
        };
        let mut angles: Vec<f64> = self.vertices.iter().map(|v| around(*v)).collect();
        let sides: Vec<(u32, u32)> = self.sides().collect();
        for &(from, to) in &sides {
            let v = self.vertices[to as usize];
            if !self.copies.contains_key(&v) {
                continue;
            }
            if let Some((_, next)) = sides.iter().find(|(a, _)| *a == to) {
                let [p, q] = [from, *next].map(|i| self.vertices[i as usize]);
                angles[to as usize] = between(v, p, q);
            }
        }
        angles
    }
}
