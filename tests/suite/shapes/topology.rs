//! What a triangle soup is as a surface, found by brute force.

use std::collections::BTreeMap;

use umbilic::soup::PolygonSoup;

#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Topology {
    pub(crate) euler: i64,
    pub(crate) loops: usize,
    pub(crate) components: usize,
    /// Whether the faces could be turned to agree.
    pub(crate) orientable: bool,
    /// Whether they do agree.
    pub(crate) oriented: bool,
}

impl Topology {
    /// Refuses, with a sentence, what is not a manifold with boundary or has unused vertices.
    pub(crate) fn of(soup: &PolygonSoup) -> Result<Self, String> {
        let mut edges: BTreeMap<(u32, u32), Vec<(usize, bool)>> = BTreeMap::new();
        let mut links: Vec<Vec<(u32, u32)>> = vec![Vec::new(); soup.positions.len()];
        for (f, face) in soup.faces().enumerate() {
            let &[a, b, c] = face else {
                return Err(format!("face {f} is not a triangle"));
            };
            for (i, j, k) in [(a, b, c), (b, c, a), (c, a, b)] {
                if i == j {
                    return Err(format!("face {f} is degenerate"));
                }
                edges
                    .entry((i.min(j), i.max(j)))
                    .or_default()
                    .push((f, i < j));
                links[i as usize].push((j, k));
            }
        }
        for (v, link) in links.iter().enumerate() {
            if !is_path_or_cycle(link) {
                return Err(format!("the faces around vertex {v} are not one fan"));
            }
        }
        if let Some((edge, _)) = edges.iter().find(|(_, faces)| faces.len() > 2) {
            return Err(format!("edge {edge:?} has more than two faces"));
        }
        let boundary: Vec<(u32, u32)> = edges
            .iter()
            .filter(|(_, f)| f.len() == 1)
            .map(|(&e, _)| e)
            .collect();
        let interior = || edges.values().filter(|f| f.len() == 2);
        let (components, orientable) = turn_faces(soup.n_faces(), interior());
        Ok(Self {
            euler: soup.positions.len() as i64 - edges.len() as i64 + soup.n_faces() as i64,
            loops: count_components(&boundary),
            components,
            orientable,
            oriented: interior().all(|f| f[0].1 != f[1].1),
        })
    }
}

/// Whether the edges opposite to a vertex make one open or closed polygon.
fn is_path_or_cycle(link: &[(u32, u32)]) -> bool {
    let mut degree: BTreeMap<u32, usize> = BTreeMap::new();
    for &(a, b) in link {
        *degree.entry(a).or_default() += 1;
        *degree.entry(b).or_default() += 1;
    }
    degree.values().all(|&d| d <= 2) && count_components(link) == 1
}

/// Connected components of a graph given by its edges.
fn count_components(edges: &[(u32, u32)]) -> usize {
    let mut neighbours: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for &(a, b) in edges {
        neighbours.entry(a).or_default().push(b);
        neighbours.entry(b).or_default().push(a);
    }
    let mut components = 0;
    while let Some((_, mut open)) = neighbours.pop_first() {
        components += 1;
        while let Some(v) = open.pop() {
            open.extend(neighbours.remove(&v).unwrap_or_default());
        }
    }
    components
}

/// Components of the faces, and whether turning some makes all agree across all edges.
fn turn_faces<'a>(
    n_faces: usize,
    interior: impl Iterator<Item = &'a Vec<(usize, bool)>>,
) -> (usize, bool) {
    let mut neighbours = vec![Vec::new(); n_faces];
    for pair in interior {
        let agree = pair[0].1 != pair[1].1;
        neighbours[pair[0].0].push((pair[1].0, agree));
        neighbours[pair[1].0].push((pair[0].0, agree));
    }
    let mut turned: Vec<Option<bool>> = vec![None; n_faces];
    let (mut components, mut orientable) = (0, true);
    for first in 0..n_faces {
        if turned[first].is_some() {
            continue;
        }
        components += 1;
        turned[first] = Some(false);
        let mut open = vec![first];
        while let Some(f) = open.pop() {
            for &(g, agree) in &neighbours[f] {
                let wanted = turned[f].map(|t| t == agree);
                if turned[g].is_none() {
                    turned[g] = wanted;
                    open.push(g);
                }
                orientable &= turned[g] == wanted;
            }
        }
    }
    (components, orientable)
}
